// How a ruler looks, on a plot over time and on a figure: a line from point to point, its legs, the text beside its
// end. A function; GUI thread.
#pragma once

class QFont;
class QPainter;
class QPointF;
class QRectF;
class QSizeF;
class QString;

namespace plc::plot {

/// Beside its anchor, above it where there is room, and inside the area.
[[nodiscard]] QRectF tagRect(const QPointF& anchor, const QSizeF& size, const QRectF& area);
void paintRulerMark(QPainter& painter, const QPointF& from, const QPointF& to, const QString& text, const QRectF& area,
                    const QFont& font);

} // namespace plc::plot
