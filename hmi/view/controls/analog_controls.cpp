#include "hmi/view/controls/analog_controls.h"

#include <cmath>
#include <numbers>

namespace plc::hmi {

void DraggedNumberView::setUp() { m_target = bindProperty("target"); }

bool DraggedNumberView::update() {
    const Value now = echoed(m_target);
    m_isKnown = !now.isNone();
    const std::optional<double> value =
        now.isNone() ? (isDesigning() ? std::optional(num("min") + (num("max") - num("min")) * 0.4) : std::nullopt)
                     : std::optional(now.toNumber());
    return std::exchange(m_value, value) != value;
}

double DraggedNumberView::shownNumber() const { return m_dragged.value_or(m_value.value_or(num("min"))); }

double DraggedNumberView::share() const {
    const double span = num("max") - num("min");
    return span == 0 ? 0 : std::clamp((shownNumber() - num("min")) / span, 0.0, 1.0);
}

void DraggedNumberView::drag(double share) {
    if (!m_target.isBound()) return;
    const double step = num("step"), low = num("min"), high = num("max");
    double raw = low + std::clamp(share, 0.0, 1.0) * (high - low);
    if (step > 0)
        raw = std::clamp(low + std::round((raw - low) / step) * step, std::min(low, high), std::max(low, high));
    if (m_dragged == raw) return;
    m_dragged = raw;
    repaint();
    if (m_sinceWrite.isValid() && m_sinceWrite.elapsed() < 100) return;
    m_sinceWrite.start();
    write(expression(m_target), typed(m_target, raw));
}

void DraggedNumberView::finish() {
    if (!m_dragged) return;
    const Value last = typed(m_target, *m_dragged);
    m_dragged.reset();
    m_sinceWrite.invalidate();
    write(expression(m_target), last);
    echo(last);
}

void DraggedNumberView::wheel(double steps) {
    if (!m_target.isBound() || !m_value) return;
    const double step = num("step") > 0 ? num("step") : (num("max") - num("min")) / 100;
    const double raw =
        std::clamp(*m_value + steps * step, std::min(num("min"), num("max")), std::max(num("min"), num("max")));
    write(expression(m_target), typed(m_target, raw));
    echo(typed(m_target, raw));
}

// ---- slider

bool SliderView::isVertical() const { return text("orientation") == QStringLiteral("vertical"); }

QRectF SliderView::track() const {
    const double room = flag("showValue") ? num("fontSize") * 1.5 : 0;
    if (isVertical()) return {(width() - 8) / 2, 16, 8, height() - 32 - room};
    const double y = (height() - room) / 2 + (room > 0 ? room : 0);
    return {16, y - 4, width() - 32, 8};
}

double SliderView::shareAt(QPointF at) const {
    const QRectF line = track();
    return isVertical() ? 1 - (at.y() - line.top()) / std::max(1.0, line.height())
                        : (at.x() - line.left()) / std::max(1.0, line.width());
}

TextBox SliderView::label(double raw, const QString& forTag) const {
    const double line = num("fontSize") * 1.5;
    return textBox(valueText(raw, forTag),
                   isVertical() ? QRectF(0, height() - line, width(), line) : QRectF(0, 0, width(), line),
                   num("fontSize"), TextAlign::Center, "format", false, forTag);
}

void SliderView::draw(QPainter& painter) {
    const QRectF line = track();
    const bool vertical = isVertical();
    const double at = share();
    const QColor fill = stateColor(color("color"));
    painter.setPen(QPen(theme().color("line"), 1));
    painter.setBrush(theme().color("inset"));
    painter.drawRoundedRect(line, 4, 4);
    const QPointF knob = vertical ? QPointF(line.center().x(), line.bottom() - at * line.height())
                                  : QPointF(line.left() + at * line.width(), line.center().y());
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(vertical ? QRectF(line.left(), knob.y(), line.width(), line.bottom() - knob.y())
                                     : QRectF(line.left(), line.top(), knob.x() - line.left(), line.height()),
                            4, 4);
    if (m_value || m_dragged) {
        const bool down = isPressed();
        painter.setPen(QPen(theme().color("line"), 1.2));
        painter.setBrush(down ? fill : QColor(Qt::white));
        painter.drawEllipse(knob, 13, 13);
        painter.setPen(Qt::NoPen);
        painter.setBrush(down ? QColor(Qt::white) : fill);
        painter.drawEllipse(knob, 4.5, 4.5);
    }
    if (!flag("showValue")) return;
    painter.setPen(inkColor(theme().color("text")));
    TextBox words = label(shownNumber(), tag());
    if (!m_value && !m_dragged) words.text = QStringLiteral("– –");
    drawText(painter, words);
}

void SliderView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (flag("showValue")) out.push_back(label(num("max"), forTag));
}

// ---- knob

double KnobView::radius() const { return std::min(width() / 2, height() * 0.46) - 10; }

double KnobView::shareAt(QPointF at) const {
    const QPointF from = at - center();
    const double angle = std::atan2(from.x(), -from.y()) * 180 / std::numbers::pi; // 0 is up
    return (angle + 135) / 270;
}

void KnobView::press(QPointF at) {
    m_lastAngle = shareAt(at);
    if (std::hypot(at.x() - center().x(), at.y() - center().y()) > radius() * 0.35) drag(shareAt(at));
}

void KnobView::move(QPointF at) {
    const double now = shareAt(at);
    // Through the gap at the bottom the knob does not jump from one end to the other.
    if (std::abs(now - m_lastAngle) > 0.6) return;
    m_lastAngle = now;
    drag(now);
}

TextBox KnobView::label(double raw, const QString& forTag) const {
    const double line = num("fontSize") * 1.5;
    return textBox(valueText(raw, forTag), QRectF(0, height() - line, width(), line), num("fontSize"),
                   TextAlign::Center, "format", true, forTag);
}

void KnobView::draw(QPainter& painter) {
    const QPointF c = center();
    const double r = radius(), at = share();
    const QColor fill = stateColor(color("color"));
    const QRectF ring(c - QPointF(r + 4, r + 4), QSizeF(2 * r + 8, 2 * r + 8));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().color("faint"), 6, Qt::SolidLine, Qt::RoundCap));
    painter.drawArc(ring, 225 * 16, -270 * 16);
    if (m_value || m_dragged) {
        painter.setPen(QPen(fill, 6, Qt::SolidLine, Qt::RoundCap));
        painter.drawArc(ring, 225 * 16, static_cast<int>(-270 * 16 * at));
    }
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1.2));
    painter.setBrush(theme().color("raised"));
    painter.drawEllipse(c, r - 4, r - 4);
    painter.setBrush(isPressed() ? theme().color("button").darker(108) : theme().color("button"));
    painter.drawEllipse(c, r * 0.78, r * 0.78);
    const double angle = (-135 + 270 * at) * std::numbers::pi / 180;
    const QPointF out(std::sin(angle), -std::cos(angle));
    painter.setPen(QPen(fill, 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(c + out * r * 0.45, c + out * r * 0.7);
    painter.setPen(inkColor(theme().color("text")));
    TextBox words = label(shownNumber(), tag());
    if (!m_value && !m_dragged) words.text = QStringLiteral("– –");
    drawText(painter, words);
}

void KnobView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    out.push_back(label(num("max"), forTag));
}

} // namespace plc::hmi
