// A short tour over the real window: one thing at a time is pointed at, the rest dimmed. Owned by the window it lies
// over; GUI thread.
#pragma once
#include <QPointer>
#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace plc::app {

struct TourStop {
    QString title, text;
    std::function<QWidget*()> target; // may give null: the text stands in the middle
    std::function<void()> prepare;    // shows a dock, opens a page
};

class Tour : public QWidget {
    Q_OBJECT
public:
    Tour(std::vector<TourStop> stops, QWidget* window);
    void begin();
    void next();
    void back();
    [[nodiscard]] int current() const { return m_current; }
    [[nodiscard]] int count() const { return static_cast<int>(m_stops.size()); }

signals:
    void finished();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showStop(int index);
    void place();
    std::vector<TourStop> m_stops;
    int m_current = 0;
    QPointer<QWidget> m_target;
    QWidget* m_card = nullptr;
    QLabel *m_title, *m_text, *m_count;
    QPushButton *m_next, *m_back;
};

} // namespace plc::app
