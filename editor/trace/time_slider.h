// The time slider over all windows: the recording as a bar, events and branches on it, the scan that is shown, buttons
// to go by scan or by change of a variable, back to live, and to resume from there. It says which position is wanted;
// the owner tells the other windows. GUI thread.
#pragma once

#include "editor/kit/inputs/expression_edit.h"
#include "editor/trace/recording/recording.h"

#include <QTimer>
#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace plc::trace {

/// The bar itself.
class TimeBar : public QWidget {
    Q_OBJECT
public:
    explicit TimeBar(QWidget* parent = nullptr);

    struct Event {
        int64_t time = 0;
        QColor color;
        QString text;
    };
    void setRange(int64_t recordedFrom, int64_t to); // images are there from recordedFrom; the bar begins at 0
    void setEvents(std::vector<Event> events);
    void setBranches(std::vector<int64_t> branches);
    void setTime(std::optional<int64_t> time); // nothing: live
    double xOf(int64_t time) const;
    int64_t timeAt(double x) const;

signals:
    void timeWanted(qint64 time);
    void liveWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;
    QSize sizeHint() const override { return {400, 30}; }
    QSize minimumSizeHint() const override { return {120, 30}; }

private:
    void wantAt(double x);
    int64_t m_from = 0, m_to = 0;
    std::optional<int64_t> m_time;
    std::vector<Event> m_events;
    std::vector<int64_t> m_branches;
};

class TimeSlider : public QWidget {
    Q_OBJECT
public:
    explicit TimeSlider(QWidget* parent = nullptr);

    void setRecording(const Recording* recording);
    void setCompletionSource(kit::CompletionSource source) { m_variable->setCompletionSource(std::move(source)); }
    /// Where the windows are; nothing: live.
    std::optional<Position> position() const { return m_position; }
    bool isLive() const { return !m_position; }
    void setPosition(std::optional<Position> position);
    void goLive() { setPosition(std::nullopt); }
    void stepScans(int scans);
    /// To the previous (-1) or next (+1) change of the chosen variable.
    bool stepChange(int direction);
    kit::ExpressionEdit* variable() const { return m_variable; }
    TimeBar* bar() const { return m_bar; }
    QString positionText() const;
    /// Looks at the recording; the timer does this.
    void refresh();

signals:
    /// quint64 in the variant, or invalid when live.
    void positionChanged(std::optional<plc::trace::Position> position);
    void resumeRequested(quint64 position);
    void message(const QString& text);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QToolButton* makeButton(kit::Icon icon, const QString& tip, std::function<void()> run);
    void showState();
    std::vector<PositionRange> chain() const;

    const Recording* m_recording = nullptr;
    std::optional<Position> m_position;
    TimeBar* m_bar;
    QLabel* m_label;
    kit::ExpressionEdit* m_variable;
    QToolButton* m_live;
    QToolButton* m_resume;
    std::vector<QToolButton*> m_steps;
    QTimer m_timer;
};

} // namespace plc::trace
