// A curve as a line and nothing else: without dots at its samples, and never through pixels, so that every painter can
// take it. What panel trends draw, whose paper a browser may be. GUI thread.
#pragma once

#include "editor/plot/painting/plot_curves.h"

namespace plc::plot {

/// Clipped to the area of the mapping.
void drawLine(QPainter& painter, const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping,
              const QColor& color);

} // namespace plc::plot
