#include "hmi/view/displays/shapes.h"

#include "hmi/view/scene/panel_scene.h"

#include <cmath>
#include <numbers>

namespace plc::hmi {

void ShapeView::setUp() {
    m_lineWidth = num("lineWidth");
    m_line = color("line");
    m_fill = color("fill");
    m_level = element().descriptor().property("level") ? bindProperty("level") : Slot{};
}

bool ShapeView::update() {
    const std::optional<double> level = m_level.isBound() ? number(m_level, 0) : std::nullopt;
    const double full = num("levelMax");
    std::optional<double> share;
    if (level && full != 0) share = std::clamp(*level / full, 0.0, 1.0);
    // Less than a third of a pixel is not seen.
    if (share && m_shownLevel && std::abs(*share - *m_shownLevel) * height() < 0.3) return false;
    const bool changed = share != m_shownLevel;
    m_shownLevel = share;
    return changed;
}

QPen ShapeView::pen() const {
    const QString style = text("lineStyle");
    if (m_lineWidth <= 0 || style == QStringLiteral("none") || !m_line.isValid()) return Qt::NoPen;
    // Shapes with a fill take a condition's colour there, lines in their pen.
    const bool hasFill = element().descriptor().property("fill") != nullptr;
    QPen pen(hasFill ? m_line : stateColor(m_line), m_lineWidth);
    pen.setJoinStyle(Qt::RoundJoin);
    pen.setCapStyle(Qt::RoundCap);
    if (style == QStringLiteral("dash")) pen.setDashPattern({4, 3});
    if (style == QStringLiteral("dot")) pen.setDashPattern({0.1, 2.2});
    return pen;
}

QList<QPointF> ShapeView::corners() const {
    QList<QPointF> out;
    for (const QPointF& point : element().points("points")) out += QPointF(point.x() * width(), point.y() * height());
    return out;
}

void ShapeView::drawFilled(QPainter& painter, const QPainterPath& path) {
    const QColor fill = stateColor(m_fill);
    if (fill.isValid()) painter.fillPath(path, fill);
    if (m_shownLevel) {
        painter.save();
        painter.setClipPath(path, Qt::IntersectClip);
        painter.fillRect(QRectF(0, height() * (1 - *m_shownLevel), width(), height() * *m_shownLevel),
                         color("levelColor"));
        painter.restore();
    }
    painter.setPen(pen());
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

void ShapeView::drawEnds(QPainter& painter, const QList<QPointF>& points) {
    if (points.size() < 2) return;
    const auto end = [&](const QString& kind, QPointF tip, QPointF from) {
        if (kind == QStringLiteral("none")) return;
        const double size = std::max(4.0, m_lineWidth * 2.4);
        painter.setPen(Qt::NoPen);
        painter.setBrush(stateColor(m_line));
        if (kind == QStringLiteral("dot")) {
            painter.drawEllipse(tip, size * 0.7, size * 0.7);
            return;
        }
        const QPointF along = tip - from;
        const double length = std::hypot(along.x(), along.y());
        if (length < 1e-6) return;
        const QPointF unit = along / length, across(-unit.y(), unit.x());
        const QPointF front = tip + unit * (size * 0.6);
        painter.drawPolygon(QPolygonF{front, front - unit * size * 1.7 + across * size * 0.75,
                                      front - unit * size * 1.7 - across * size * 0.75});
    };
    end(text("startEnd"), points.front(), points[1]);
    end(text("finishEnd"), points.back(), points[points.size() - 2]);
}

void LineView::draw(QPainter& painter) {
    const QList<QPointF> points = corners();
    painter.setPen(pen());
    painter.drawPolyline(QPolygonF(points));
    drawEnds(painter, points);
}

void PolylineView::draw(QPainter& painter) {
    const QList<QPointF> points = corners();
    painter.setPen(pen());
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF(points));
    drawEnds(painter, points);
}

void RectangleView::draw(QPainter& painter) {
    QPainterPath path;
    path.addRect(box());
    drawFilled(painter, path);
}

void RoundedView::draw(QPainter& painter) {
    const double radius = std::min(num("radius"), std::min(width(), height()) / 2);
    QPainterPath path;
    path.addRoundedRect(box(), radius, radius);
    drawFilled(painter, path);
}

void EllipseView::draw(QPainter& painter) {
    QPainterPath path;
    path.addEllipse(box());
    drawFilled(painter, path);
}

void PolygonView::draw(QPainter& painter) {
    QPainterPath path;
    path.addPolygon(QPolygonF(corners()));
    path.closeSubpath();
    drawFilled(painter, path);
}

void ArcView::draw(QPainter& painter) {
    const double start = num("start"), span = num("span");
    const QString shape = text("shape");
    QPainterPath path;
    if (shape == QStringLiteral("pie"))
        path.moveTo(box().center());
    else
        path.arcMoveTo(box(), start);
    path.arcTo(box(), start, span);
    if (shape != QStringLiteral("arc")) path.closeSubpath();
    if (shape != QStringLiteral("arc") && stateColor(m_fill).isValid()) painter.fillPath(path, stateColor(m_fill));
    QPen line = pen();
    if (shape == QStringLiteral("arc")) line.setColor(stateColor(m_line));
    painter.setPen(line);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

QPainterPath roundedPath(const QList<QPointF>& points, double radius) {
    QPainterPath path;
    if (points.isEmpty()) return path;
    path.moveTo(points.front());
    for (qsizetype i = 1; i + 1 < points.size(); ++i) {
        const QPointF before = points[i - 1] - points[i], after = points[i + 1] - points[i];
        const double lengthBefore = std::hypot(before.x(), before.y()), lengthAfter = std::hypot(after.x(), after.y());
        if (lengthBefore < 1e-6 || lengthAfter < 1e-6) continue;
        const double r = std::min({radius, lengthBefore / 2, lengthAfter / 2});
        path.lineTo(points[i] + before / lengthBefore * r);
        path.quadTo(points[i], points[i] + after / lengthAfter * r);
    }
    path.lineTo(points.back());
    return path;
}

void PipeView::setUp() { m_flow = bindProperty("flow"); }

bool PipeView::update() {
    const Value& flow = value(m_flow);
    const double amount = flow.toNumber();
    const int direction = flow.kind() == ValueKind::Bool ? flow.toBool() : (amount > 0) - (amount < 0);
    const bool changed = direction != m_direction;
    m_direction = direction;
    return changed;
}

bool PipeView::advance(qint64 milliseconds) {
    if (m_direction == 0 || scene().isMotionReduced()) return false;
    const double phase = static_cast<double>(milliseconds / 66 % 1000000) * 0.18 * m_direction;
    if (phase == m_phase) return false;
    m_phase = phase;
    return true;
}

/// The way of the flow without movement.
void PipeView::drawArrows(QPainter& painter, const QPainterPath& path, double thickness) const {
    const double length = path.length(), step = std::max(24.0, thickness * 3), half = thickness * 0.28;
    painter.setPen(QPen(PanelTheme::inkOn(color("flowColor")), std::max(1.2, thickness * 0.16), Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
    const int count = std::clamp(static_cast<int>(length / step), 1, 500);
    for (int i = 0; i < count; ++i) {
        const double at = path.percentAtLength(length * (i + 0.5) / count);
        const QPointF middle = path.pointAtPercent(at);
        const double angle = path.angleAtPercent(at) * std::numbers::pi / 180;
        const QPointF along = QPointF(std::cos(angle), -std::sin(angle)) * half * m_direction,
                      side(-along.y(), along.x());
        painter.drawPolyline(QPolygonF{middle - along + side, middle + along, middle - along - side});
    }
}

void PipeView::draw(QPainter& painter) {
    QList<QPointF> points;
    for (const QPointF& point : element().points("points"))
        points += QPointF(point.x() * width(), point.y() * height());
    const double thickness = num("thickness");
    const QPainterPath path = roundedPath(points, thickness * 1.1);
    const QColor body = stateColor(color("color"));
    painter.setBrush(Qt::NoBrush);
    painter.strokePath(path, QPen(theme().color("line"), thickness, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(m_direction ? color("flowColor") : body, std::max(1.0, thickness - 2.4),
                                  Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    if (m_direction == 0) {
        QColor shine = body.lighter(theme().isDark() ? 125 : 112);
        painter.strokePath(path, QPen(shine, thickness * 0.3, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        return;
    }
    if (scene().isMotionReduced()) return drawArrows(painter, path, thickness);
    QPen dashes(PanelTheme::inkOn(color("flowColor")), std::max(1.5, thickness * 0.22), Qt::CustomDashLine,
                Qt::RoundCap, Qt::RoundJoin);
    dashes.setDashPattern({3.2, 3.2});
    dashes.setDashOffset(-m_phase * 3);
    QColor ink = dashes.color();
    ink.setAlphaF(0.75f);
    dashes.setColor(ink);
    painter.strokePath(path, dashes);
}

} // namespace plc::hmi
