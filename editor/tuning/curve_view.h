// A chart of a few curves with axes, grid and legend, painted in the studio's colours; the values come as a
// signals::Chart. A value below the mouse is shown as its tip. GUI thread.
#pragma once
#include "projects/signals/chart.h"

#include <QWidget>

namespace plc::editor {

class CurveView : public QWidget {
    Q_OBJECT
public:
    explicit CurveView(QWidget* parent = nullptr);
    void setChart(signals::Chart chart);
    [[nodiscard]] const signals::Chart& chart() const { return m_chart; }
    [[nodiscard]] QSize sizeHint() const override { return {320, 220}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 120}; }

protected:
    void paintEvent(QPaintEvent*) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    struct Frame;
    [[nodiscard]] Frame frame() const;
    void paintAxes(QPainter& painter, const Frame& frame) const;
    void paintCurves(QPainter& painter, const Frame& frame) const;
    void paintLegend(QPainter& painter, const Frame& frame) const;

    signals::Chart m_chart;
};

} // namespace plc::editor
