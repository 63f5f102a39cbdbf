// What the studio's style is painted with: rounded grounds, strokes, arrows, and the primitives drawn flat. Pure
// functions with the theme's colours at the moment of painting; GUI thread.
#pragma once
#include <QColor>
#include <QPolygonF>
#include <QStyle>

class QPainter;
class QStyleOption;

namespace plc::kit {

/// A ground with an outline of one pixel if `line` is valid; an invalid `fill` leaves the ground as it is.
void fillRound(QPainter* painter, const QRectF& rect, const QColor& fill, const QColor& line = QColor(),
               qreal radius = 4);
void strokePath(QPainter* painter, const QPolygonF& line, const QColor& color, qreal width);
/// Points down at 0 degrees, to the left at 90.
void drawArrow(QPainter* painter, const QRect& rect, int degrees, const QColor& color);
/// Grounds, frames and indicators; false for what Fusion draws.
bool drawFlat(QStyle::PrimitiveElement element, const QStyleOption* option, QPainter* painter, const QWidget* widget);

} // namespace plc::kit
