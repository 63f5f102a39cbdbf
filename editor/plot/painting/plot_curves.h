// From samples to ink: what a curve looks like in the part of time in view, and drawing it as a line, as held values or
// as a lane. One shape serves screen, PNG, SVG and PDF; where samples outnumber pixels it is two points a pixel column.
// GUI thread.
#pragma once

#include "editor/plot/model/plot_model.h"

#include <QFont>
#include <QRect>
#include <QRectF>

class QPainter;
class QImage;

namespace plc::plot {

/// Samples of one source prepared for `columns` pixel columns of [from, to).
struct CurveShape {
    int64_t from = 0, to = 1;
    int columns = 0;
    bool isExact = true;
    std::vector<SignalSample> samples;  // exact: also the one before and the one after the view
    std::vector<SignalBucket> buckets;  // else one a column
    std::optional<SignalSample> before; // the last one before the view
    std::optional<SignalSample> after;  // buckets only: the first one after the view
    std::vector<SignalGap> gaps;

    /// Least and greatest raw value in view.
    [[nodiscard]] std::optional<PlotRange> extent() const;
};

CurveShape shapeOf(const SampleSource& source, int64_t from, int64_t to, int columns, int64_t shift = 0);

/// Where values and times lie on the paper.
struct PlotMapping {
    QRectF area;
    int64_t from = 0, to = 1;
    PlotRange y;
    double ratio = 0; // device pixels per unit, for level lines on whole pixels; 0: paper without pixels

    [[nodiscard]] double xOf(int64_t time) const {
        return area.left() + static_cast<double>(time - from) / static_cast<double>(to - from) * area.width();
    }
    [[nodiscard]] double yOf(double value) const {
        return area.bottom() - (value - y.low) / (y.high - y.low) * area.height();
    }
    [[nodiscard]] int64_t timeAt(double x) const {
        return from + static_cast<int64_t>((x - area.left()) / area.width() * static_cast<double>(to - from));
    }
    [[nodiscard]] double valueAt(double py) const {
        return y.low + (area.bottom() - py) / area.height() * (y.high - y.low);
    }
};

/// Pixels of the plot area that curves may be written to directly; no image when the paper has none (SVG, PDF).
struct PlotPixels {
    QImage* image = nullptr;
    QRect area;
    size_t finely = 600; // up to so many samples the painter draws a curve, which is finer and slower
};

/// Whether the painter draws the shape; else it goes into the pixels.
[[nodiscard]] bool isDrawnByPainter(const CurveShape& shape, const PlotPixels& pixels);

/// Draws a Line or Hold curve.
void drawCurve(QPainter& painter, const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping,
               const QColor& color, const PlotPixels& pixels);

/// Draws a lane into mapping.area: two levels for BOOL, boxes with the value for others.
void drawLane(QPainter& painter, const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping,
              const QColor& color, const QFont& font);

/// Shades where nothing is known.
void drawGaps(QPainter& painter, const std::vector<SignalGap>& gaps, const PlotMapping& mapping, const QFont& font);

} // namespace plc::plot
