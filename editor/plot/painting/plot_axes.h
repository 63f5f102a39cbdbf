// One chart of Qt Charts, used for its axes, grid and geometry: the only file that includes it. The curves are ours.
// Owned by the renderer; GUI thread.
#pragma once

#include "editor/plot/model/plot_scale.h"

#include <QColor>
#include <QFont>
#include <QMarginsF>
#include <QRectF>

#include <memory>
#include <vector>

class QPainter;

namespace plc::plot {

struct AxisSpec {
    double low = 0, high = 1;
    std::vector<PlotTick> ticks;
    QString title;
    QColor color; // of title and labels; invalid: the plain ink
    bool isOnRight = false;
    bool hasGrid = true;
    bool operator==(const AxisSpec&) const;
};

class PlotAxes {
public:
    PlotAxes();
    ~PlotAxes();

    void setFont(const QFont& font);
    /// The title of the time axis is not drawn here: Qt Charts cuts it off under its labels.
    void setTimeAxis(const AxisSpec& spec, bool hasLabels);
    void setValueAxes(const std::vector<AxisSpec>& specs);
    void setGridVisible(bool visible);
    /// Room that axes take on each side of the plot area.
    [[nodiscard]] QMarginsF margins();
    /// Lays the chart out so that its plot area is `area`.
    void place(const QRectF& area);
    [[nodiscard]] QRectF area() const;
    void paint(QPainter& painter);

private:
    struct Parts;
    std::unique_ptr<Parts> m;
};

} // namespace plc::plot
