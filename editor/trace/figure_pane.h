// The figure beside the charts of a trace: which kind, over which channel, and its view. It computes on a thread of its
// own, one figure at a time; the newest wish follows. Owned by the trace view; GUI thread.
#pragma once

#include "editor/plot/figure_view.h"
#include "editor/trace/curves/trace_figure.h"

#include <functional>
#include <thread>

class QCheckBox;
class QComboBox;
class QLabel;

namespace plc::trace {

class FigurePane : public QWidget {
    Q_OBJECT
public:
    explicit FigurePane(QWidget* parent = nullptr);
    ~FigurePane() override;
    /// What the set-up says: the kind, the choices, visible or not.
    void showSetup(const TraceSetup& setup);
    /// Draws this; while another is being computed, it waits for that one.
    void draw(FigureJob job);
    [[nodiscard]] bool isBusy() const { return m_isBusy; }
    [[nodiscard]] plot::FigureView* view() const { return m_view; }
    [[nodiscard]] QString text() const;
    void copyPicture();

signals:
    void changeRequested(const QString& what, const std::function<void(TraceSetup&)>& change);
    void failed(const QString& message);
    void drawn();

private:
    void start(FigureJob job);
    void take(FigureAnswer answer);
    void menu(const QPoint& global);
    void save(const QString& suffix);

    QLabel *m_title, *m_text;
    QLabel* m_xLabel;
    QComboBox *m_x, *m_window;
    QCheckBox* m_logarithmic;
    plot::FigureView* m_view;
    std::thread m_worker;
    bool m_isBusy = false, m_isFilling = false;
    std::optional<FigureJob> m_next;
};

} // namespace plc::trace
