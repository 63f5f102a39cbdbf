// Lays a plot out and paints it: title, legends, axes, gaps, curves, lanes, markers, trigger, cursors, measuring table.
// The same code paints the widget, a picture file and the command line's charts. Owned by whoever paints; GUI thread.
#pragma once

#include "editor/plot/painting/plot_axes.h"
#include "editor/plot/painting/plot_curves.h"

#include <QFont>
#include <QPainter>

namespace plc::plot {

/// One plot area: the curves of a chart, or its lanes.
struct PlotPane {
    int chart = 0;
    bool isLanes = false;
    QRectF area;
    std::vector<int> curves;       // indices into the model
    std::vector<int> axes;         // shown axes of the chart
    std::vector<PlotRange> ranges; // theirs
};

struct LegendEntry {
    QRectF rect;
    int curve = 0; // -1: what is drawn beneath all of them
};

/// The name of a curve where it leaves the plot.
struct EndLabel {
    QRectF rect;
    double from = 0; // height of the curve's end
    int curve = 0;
};

class PlotRenderer {
public:
    PlotRenderer();
    ~PlotRenderer();

    void setFont(const QFont& font) { m_font = font; }
    /// Device pixels per unit; more columns for paper that is scaled.
    void setPixelRatio(double ratio) { m_ratio = ratio; }
    /// Samples in view, over all curves, up to which fine lines are drawn; beyond, quick ones. Files want fine ones.
    void setFineSamples(size_t samples) { m_fineSamples = samples; }
    /// Paints everything into `rect`.
    void paint(QPainter& painter, const PlotModel& model, const QRectF& rect);
    /// Only what follows the mouse, over a picture painted before.
    void paintOverlay(QPainter& painter, const PlotModel& model);
    void paintBase(QPainter& painter, const PlotModel& model, const QRectF& rect);

    // Where things lie, as painted last.
    [[nodiscard]] const std::vector<PlotPane>& panes() const { return m_panes; }
    [[nodiscard]] const PlotPane* paneAt(const QPointF& point) const;
    [[nodiscard]] PlotMapping mapping(const PlotModel& model, const PlotPane& pane, size_t axis = 0) const;
    [[nodiscard]] std::optional<int> legendAt(const QPointF& point) const;
    [[nodiscard]] std::optional<int> laneAt(const QPointF& point) const;
    [[nodiscard]] const std::vector<LegendEntry>& legend() const { return m_legend; }
    [[nodiscard]] const std::vector<EndLabel>& endLabels() const { return m_endLabels; }
    /// The axis of `chart` that `point` lies on, left or right of a pane.
    [[nodiscard]] std::optional<std::pair<int, int>> axisAt(const QPointF& point) const;
    [[nodiscard]] std::optional<int> markerAt(const PlotModel& model, const QPointF& point) const;
    /// The sample of a curve in that pane that is nearest on the paper, within `reach`; else the place itself.
    [[nodiscard]] PlotRuler rulerAt(const PlotModel& model, const QPointF& point, double reach) const;
    [[nodiscard]] std::optional<int> noteAt(const QPointF& point) const;
    [[nodiscard]] QRectF plotArea() const; // from the first pane's top to the last one's bottom

private:
    struct PaneParts;
    void layOut(const PlotModel& model, const QRectF& rect);
    void makePanes(const PlotModel& model);
    void makeShapes(const PlotModel& model, double width);
    void placeTimeAxis(const PlotModel& model, double width);
    std::vector<AxisSpec> valueAxes(const PlotModel& model, PlotPane& pane, double height);
    PlotRange rangeOf(const PlotModel& model, const PlotPane& pane, int axis) const;
    double legendHeight(const PlotModel& model, int chart, double left, double width, double top, bool place);
    void paintLegend(QPainter& painter, const PlotModel& model);
    void paintLegendBeneath(QPainter& painter, const PlotModel& model, const QRectF& rect);
    [[nodiscard]] double endLabelWidth(const PlotModel& model, double width) const;
    void placeEndLabels(const PlotModel& model, double width);
    void paintEndLabels(QPainter& painter, const PlotModel& model);
    void paintPane(QPainter& painter, const PlotModel& model, size_t index);
    void paintMarkers(QPainter& painter, const PlotModel& model);
    void paintCursors(QPainter& painter, const PlotModel& model);
    void paintCursorLine(QPainter& painter, const PlotModel& model, int64_t time, Qt::PenStyle style);
    void paintNotes(QPainter& painter, const PlotModel& model);
    void paintRuler(QPainter& painter, const PlotModel& model);
    void paintVertical(QPainter& painter, double x, const QPen& pen);

    QFont m_font;
    size_t m_fineSamples = 4000;
    double m_ratio = 1, m_left = 0, m_right = 0, m_width = 0;
    QRectF m_rect, m_titleRect, m_tableRect;
    bool m_isLow = false;  // no room for titles
    bool m_isTiny = false; // nor for a legend
    QString m_timeTitle;
    double m_timeLabel = 40; // width of the widest time label
    std::vector<PlotPane> m_panes;
    std::vector<std::unique_ptr<PaneParts>> m_parts;
    std::vector<LegendEntry> m_legend;
    std::vector<EndLabel> m_endLabels;
    std::vector<std::pair<int, QRectF>> m_chartTitles;
    std::vector<std::pair<int, QRectF>> m_noteRects; // index into the model's notes
};

/// The paper's own ratio, or that of fine print for SVG and PDF.
[[nodiscard]] bool isVectorPaper(const QPainter& painter);

} // namespace plc::plot
