#include "hmi/view/displays/meters.h"

#include <cmath>
#include <numbers>

namespace plc::hmi {

void MeterView::setUp() {
    m_value = bindProperty("value");
    m_limits = Limits::of(element());
}

bool MeterView::update() {
    const double low = num("min"), high = num("max");
    const std::optional<double> now = number(m_value, low + (high - low) * 0.6);
    const int priority = now ? m_limits.priorityAt(*now) : 0;
    const QString words = now ? valueText(*now, tag()) : QStringLiteral("– –");
    const bool moved =
        now.has_value() != m_now.has_value() || (now && std::abs(shareOf(*now) - shareOf(*m_now)) * travel() >= 0.3);
    if (!moved && priority == m_priority && words == m_words) return false;
    m_now = now;
    m_priority = priority;
    m_words = words;
    return true;
}

double MeterView::shareOf(double raw) const {
    const double span = num("max") - num("min");
    return span == 0 || std::isnan(raw) ? 0 : std::clamp((raw - num("min")) / span, 0.0, 1.0);
}

QColor MeterView::valueColor(const QColor& normal) const {
    return m_priority ? theme().priority(m_priority) : stateColor(normal);
}

std::vector<double> MeterView::steps(int count) const {
    const UnitView view = unit();
    const double from = view.shown(num("min")), to = view.shown(num("max")), span = to - from;
    std::vector<double> out;
    if (!(span > 0) || !std::isfinite(span) || count < 1) return out;
    const double rough = span / count, size = std::pow(10, std::floor(std::log10(rough)));
    double step = size;
    for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0})
        if (size * factor >= rough * 0.99) {
            step = size * factor;
            break;
        }
    constexpr size_t Most = 100; // also where a step is too small to change the number it is added to
    for (double at = std::ceil(from / step - 1e-9) * step; at <= to + span * 1e-9 && out.size() < Most; at += step)
        out.push_back(std::abs(at) < step * 1e-9 ? 0 : at);
    return out;
}

void MeterView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!element().descriptor().property("showValue") || flag("showValue")) {
        out.push_back(valueBox(valueText(num("max"), forTag), forTag));
        out.back().property = QStringLiteral("format");
    }
}

// ---- bar

void BarView::setUp() {
    MeterView::setUp();
    m_setPoint = bindProperty("setPoint");
}

bool BarView::update() {
    const std::optional<double> aim = m_setPoint.isBound() ? number(m_setPoint, 0) : std::nullopt;
    const bool moved = std::exchange(m_aim, aim) != aim;
    return MeterView::update() || moved;
}

QRectF BarView::track() const {
    const double size = num("fontSize"), room = flag("showValue") ? size * 1.7 : 0;
    if (isVertical()) {
        const double thick = std::clamp(width() * 0.36, 8.0, 44.0);
        return {width() - thick - 6, 8, thick, height() - 16 - room};
    }
    const double thick = std::clamp(height() * 0.36, 8.0, 44.0);
    return {8, 4 + (flag("showValue") ? room : 0), width() - 16, std::min(thick, height() - room - size - 8)};
}

QPointF BarView::at(double share, double across) const {
    const QRectF line = track();
    return isVertical() ? QPointF(line.left() + across, line.bottom() - share * line.height())
                        : QPointF(line.left() + share * line.width(), line.bottom() - across);
}

TextBox BarView::valueBox(const QString& words, const QString& forTag) const {
    const double line = num("fontSize") * 1.5;
    const QRectF area = isVertical() ? QRectF(0, height() - line, width(), line) : QRectF(0, 0, width(), line);
    return textBox(words, area, num("fontSize"), TextAlign::Center, "format", true, forTag);
}

void BarView::draw(QPainter& painter) {
    const QRectF line = track();
    const double size = num("fontSize") * 0.85;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color("inset"));
    painter.drawRect(line);
    // The bands beyond the limits, pale: where the value must not be.
    const auto band = [&](double from, double to, int priority) {
        QColor tint = theme().priority(priority);
        tint.setAlphaF(theme().isDark() ? 0.45f : 0.35f);
        const double a = shareOf(from), b = shareOf(to);
        painter.fillRect(QRectF(at(a, 0), at(b, isVertical() ? line.width() : line.height())).normalized(), tint);
    };
    const double lowest = num("min"), highest = num("max");
    if (m_limits.lowLow) band(lowest, *m_limits.lowLow, 1);
    if (m_limits.low) band(m_limits.lowLow.value_or(lowest), *m_limits.low, 3);
    if (m_limits.highHigh) band(*m_limits.highHigh, highest, 1);
    if (m_limits.high) band(*m_limits.high, m_limits.highHigh.value_or(highest), 3);
    if (m_now) {
        const double origin = shareOf(std::clamp(0.0, std::min(lowest, highest), std::max(lowest, highest)));
        const double inset = (isVertical() ? line.width() : line.height()) * 0.2,
                     far = (isVertical() ? line.width() : line.height()) * 0.8;
        painter.fillRect(QRectF(at(origin, inset), at(shareOf(*m_now), far)).normalized(), valueColor(color("color")));
    }
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(line);
    const UnitView view = unit();
    const double length = isVertical() ? line.height() : line.width();
    for (const double step : steps(std::max(1, static_cast<int>(length / (isVertical() ? size * 2.6 : size * 4.5))))) {
        const double share = shareOf(view.raw(step));
        painter.setPen(QPen(theme().color("line"), 1));
        painter.drawLine(at(share, -2), at(share, -6));
        painter.setPen(theme().color("muted"));
        const QString words = formatValue(Value::ofReal(step), text("format"), locale());
        const QPointF tick = at(share, -8);
        TextBox number =
            isVertical() ? textBox(words, QRectF(0, tick.y() - size, tick.x(), 2 * size), size, TextAlign::End, "")
                         : textBox(words, QRectF(tick.x() - 40, tick.y(), 80, size * 1.4), size, TextAlign::Center, "");
        number.rightToLeft = false;
        drawText(painter, number);
    }
    if (m_aim) {
        const double share = shareOf(*m_aim), thick = isVertical() ? line.width() : line.height();
        const QPointF tip = at(share, thick * 0.72), back = at(share, thick + 5),
                      across = isVertical() ? QPointF(0, 6) : QPointF(6, 0);
        painter.setPen(QPen(theme().color("background"), 1));
        painter.setBrush(theme().color("text"));
        painter.drawPolygon(QPolygonF{tip, back + across, back - across});
    }
    if (!flag("showValue")) return;
    painter.setPen(m_priority ? theme().color("text") : inkColor(theme().color("text")));
    drawText(painter, valueBox(shownValue(), tag()));
}

// ---- tank level

QPainterPath TankLevelView::vessel() const {
    const QString shape = text("shape");
    const QRectF r = box().adjusted(1.5, 1.5, -1.5, -1.5);
    const double cap = std::min(r.height() * 0.14, r.width() * 0.25);
    QPainterPath path;
    if (shape == QStringLiteral("dished")) {
        path.moveTo(r.left(), r.top() + cap);
        path.cubicTo(r.left(), r.top(), r.right(), r.top(), r.right(), r.top() + cap);
        path.lineTo(r.right(), r.bottom() - cap);
        path.cubicTo(r.right(), r.bottom(), r.left(), r.bottom(), r.left(), r.bottom() - cap);
    } else if (shape == QStringLiteral("hopper")) {
        const double cone = std::min(r.height() * 0.35, r.width() * 0.6), mouth = r.width() * 0.12;
        path.moveTo(r.topLeft());
        path.lineTo(r.topRight());
        path.lineTo(r.right(), r.bottom() - cone);
        path.lineTo(r.center().x() + mouth, r.bottom());
        path.lineTo(r.center().x() - mouth, r.bottom());
        path.lineTo(r.left(), r.bottom() - cone);
    } else {
        path.addRoundedRect(r, 4, 4);
    }
    path.closeSubpath();
    return path;
}

TextBox TankLevelView::valueBox(const QString& words, const QString& forTag) const {
    const double line = num("fontSize") * 1.6;
    return textBox(words, QRectF(6, height() / 2 - line / 2, width() - 12, line), num("fontSize"), TextAlign::Center,
                   "format", true, forTag);
}

void TankLevelView::draw(QPainter& painter) {
    const QPainterPath path = vessel();
    const QRectF inner = path.boundingRect();
    painter.fillPath(path, theme().color("raised"));
    if (m_now) {
        painter.save();
        painter.setClipPath(path, Qt::IntersectClip);
        const double top = inner.bottom() - shareOf(*m_now) * inner.height();
        const QColor liquid = valueColor(color("color"));
        painter.fillRect(QRectF(inner.left(), top, inner.width(), inner.bottom() - top), liquid);
        painter.setPen(QPen(liquid.darker(130), 2));
        painter.drawLine(QPointF(inner.left(), top), QPointF(inner.right(), top));
        painter.restore();
    }
    const auto mark = [&](const std::optional<double>& limit, int priority) {
        if (!limit) return;
        const double y = inner.bottom() - shareOf(*limit) * inner.height();
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().priority(priority));
        painter.drawPolygon(
            QPolygonF{QPointF(width() - 2, y), QPointF(width() - 12, y - 6), QPointF(width() - 12, y + 6)}.translated(
                -1, 0));
    };
    mark(m_limits.lowLow, 1);
    mark(m_limits.low, 3);
    mark(m_limits.high, 3);
    mark(m_limits.highHigh, 1);
    painter.setPen(QPen(theme().color("line"), 2.5));
    painter.setBrush(Qt::NoBrush);
    if (text("shape") == QStringLiteral("open")) {
        painter.drawPolyline(QPolygonF{inner.topLeft(), inner.bottomLeft(), inner.bottomRight(), inner.topRight()});
    } else {
        painter.drawPath(path);
    }
    if (!flag("showValue")) return;
    TextBox words = valueBox(shownValue(), tag());
    const QSizeF size = neededSize(words);
    QRectF plate(0, 0, std::min(size.width() + 14, words.rect.width()), size.height() + 2);
    plate.moveCenter(words.rect.center());
    QColor ground = theme().color("surface");
    ground.setAlphaF(0.88f);
    painter.setPen(m_priority ? QPen(theme().priority(m_priority), 2) : QPen(Qt::NoPen));
    painter.setBrush(ground);
    painter.drawRoundedRect(plate, 3, 3);
    painter.setPen(inkColor(theme().color("text")));
    drawText(painter, words);
}

// ---- gauge

QPointF GaugeView::center() const { return {width() / 2, std::min(height(), width()) / 2}; }

double GaugeView::radius() const { return std::min(width(), height()) / 2 - 4; }

TextBox GaugeView::label(const QString& forTag) const {
    // As wide as the dial is where the label ends.
    const double r = radius(), size = std::min(num("fontSize"), r * 0.16), top = r * 0.62, bottom = top + size * 1.4;
    const double half = std::sqrt(std::max(0.0, r * r - bottom * bottom)) * 0.96;
    return textBox(shown(text("label"), forTag), QRectF(center().x() - half, center().y() + top, 2 * half, size * 1.4),
                   size, TextAlign::Center, "label", false, forTag);
}

TextBox GaugeView::valueBox(const QString& words, const QString& forTag) const {
    const double r = radius(), size = std::min(num("fontSize") * 1.35, r * 0.24);
    return textBox(words, QRectF(center().x() - r * 0.6, center().y() + r * 0.33, r * 1.2, size * 1.4), size,
                   TextAlign::Center, "format", true, forTag);
}

void GaugeView::draw(QPainter& painter) {
    const QPointF c = center();
    const double r = radius(), span = num("span"), first = -span / 2, size = std::min(num("fontSize") * 0.9, r * 0.17);
    const auto direction = [&](double share) {
        const double angle = (first + span * share) * std::numbers::pi / 180;
        return QPointF(std::sin(angle), -std::cos(angle));
    };
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2.5 : 1.5));
    painter.setBrush(theme().color("inset"));
    painter.drawEllipse(c, r, r);
    const double ringWidth = std::max(4.0, r * 0.09), ringRadius = r - ringWidth * 1.1;
    const QRectF ring(c - QPointF(ringRadius, ringRadius), QSizeF(2 * ringRadius, 2 * ringRadius));
    const auto arc = [&](double from, double to, const QColor& ink) {
        painter.setPen(QPen(ink, ringWidth, Qt::SolidLine, Qt::FlatCap));
        painter.setBrush(Qt::NoBrush);
        painter.drawArc(ring, static_cast<int>((90 - first - span * from) * 16),
                        static_cast<int>(-span * (to - from) * 16));
    };
    arc(0, 1, theme().color("faint"));
    const auto share = [&](double raw) { return shareOf(raw); };
    if (m_limits.low) arc(share(m_limits.lowLow.value_or(num("min"))), share(*m_limits.low), theme().priority(3));
    if (m_limits.lowLow) arc(0, share(*m_limits.lowLow), theme().priority(1));
    if (m_limits.high) arc(share(*m_limits.high), share(m_limits.highHigh.value_or(num("max"))), theme().priority(3));
    if (m_limits.highHigh) arc(share(*m_limits.highHigh), 1, theme().priority(1));
    const UnitView view = unit();
    for (const double step : steps(std::max(1, element().integer("ticks")))) {
        const QPointF out = direction(shareOf(view.raw(step)));
        painter.setPen(QPen(theme().color("text"), 1.5));
        painter.drawLine(c + out * (ringRadius - ringWidth * 0.5), c + out * (ringRadius - ringWidth * 1.4));
        const QPointF place = c + out * (ringRadius - ringWidth * 1.4 - size * 1.15);
        painter.setPen(theme().color("muted"));
        TextBox number = textBox(formatValue(Value::ofReal(step), text("format"), locale()),
                                 QRectF(place.x() - size * 2, place.y() - size * 0.7, size * 4, size * 1.4), size,
                                 TextAlign::Center, "");
        drawText(painter, number);
    }
    painter.setPen(inkColor(theme().color("text")));
    drawText(painter, valueBox(shownValue(), tag()));
    painter.setPen(theme().color("muted"));
    drawText(painter, label(tag()));
    if (m_now) {
        const QPointF out = direction(shareOf(*m_now)), across(-out.y(), out.x());
        const double tip = ringRadius - ringWidth * 0.6;
        painter.setPen(Qt::NoPen);
        painter.setBrush(valueColor(color("color")));
        painter.drawPolygon(
            QPolygonF{c + out * tip, c + across * r * 0.035, c - out * r * 0.14, c - across * r * 0.035});
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color("text"));
    painter.drawEllipse(c, r * 0.055, r * 0.055);
}

void GaugeView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    MeterView::collectTexts(forTag, out);
    if (!text("label").isEmpty()) out.push_back(label(forTag));
}

// ---- light tower

void LightTowerView::setUp() {
    m_lights.clear();
    const Json& rows = element().at("lights");
    if (rows.is_array())
        for (const Json& row : rows) {
            if (!row.is_object()) continue;
            const Properties light(descriptorOf(ElementKind::Unknown), row);
            m_lights.push_back({colorOr(light.text("color"), theme().color("green")),
                                bindExpression(light.text("value")), bindExpression(light.text("blink"))});
        }
    m_siren = bindProperty("siren");
}

bool LightTowerView::update() {
    bool changed = false;
    for (size_t i = 0; i < m_lights.size(); ++i) {
        Light& light = m_lights[i];
        const bool blinks = isTrue(light.blink), on = isTrue(light.value, i + 1 == m_lights.size()) || blinks;
        changed |= on != light.on || blinks != light.blinks;
        light.on = on;
        light.blinks = blinks;
    }
    const bool sounds = isTrue(m_siren);
    changed |= std::exchange(m_sounds, sounds) != sounds;
    return changed;
}

void LightTowerView::draw(QPainter& painter) {
    const double count = static_cast<double>(std::max<size_t>(1, m_lights.size()));
    const double w = std::min(width() * 0.62, height() * 0.3), x = (width() - w) / 2, foot = height() * 0.24,
                 cap = height() * 0.07;
    const double each = (height() - foot - cap) / count;
    painter.setPen(QPen(theme().color("line"), 1.2));
    painter.setBrush(theme().color("off"));
    painter.drawRoundedRect(QRectF(x, 0.75, w, cap), 3, 3);
    painter.drawRect(QRectF(width() / 2 - w * 0.13, height() - foot, w * 0.26, foot - height() * 0.045));
    painter.drawRoundedRect(QRectF(width() / 2 - w * 0.6, height() - height() * 0.05, w * 1.2, height() * 0.05 - 0.75),
                            2, 2);
    for (size_t i = 0; i < m_lights.size(); ++i) {
        const Light& light = m_lights[i];
        const bool glows = light.on && (!light.blinks || isLit());
        m_blinking = m_blinking || light.blinks;
        QColor glass = light.color;
        if (!glows) { // dull, but still telling which one it is
            const QColor dull = theme().color("off");
            glass = QColor::fromRgbF(static_cast<float>(glass.redF() * 0.28 + dull.redF() * 0.6),
                                     static_cast<float>(glass.greenF() * 0.28 + dull.greenF() * 0.6),
                                     static_cast<float>(glass.blueF() * 0.28 + dull.blueF() * 0.6));
        }
        const QRectF area(x, cap + each * static_cast<double>(i), w, each - 1.5);
        if (glows && theme().kind() != PanelThemeKind::Contrast) {
            QColor halo = light.color;
            halo.setAlphaF(0.28f);
            painter.setPen(Qt::NoPen);
            painter.setBrush(halo);
            painter.drawRoundedRect(area.adjusted(-6, 2, 6, -2), 7, 7);
        }
        painter.setPen(QPen(glows ? light.color.darker(140) : theme().color("line"), glows ? 2 : 1.2));
        painter.setBrush(glass);
        painter.drawRoundedRect(area, 3, 3);
        painter.setPen(QPen(glows ? glass.lighter(150) : glass.lighter(115), 2.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(area.left() + w * 0.2, area.top() + each * 0.22),
                         QPointF(area.left() + w * 0.2, area.bottom() - each * 0.22));
    }
    if (!m_sounds) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().color("alarm"), 2, Qt::SolidLine, Qt::RoundCap));
    for (const double r : {w * 0.75, w * 0.95}) {
        painter.drawArc(QRectF(width() / 2 - r, cap / 2 - r, 2 * r, 2 * r), -25 * 16, 50 * 16);
        painter.drawArc(QRectF(width() / 2 - r, cap / 2 - r, 2 * r, 2 * r), 155 * 16, 50 * 16);
    }
}

// ---- float switch

void FloatSwitchView::setUp() { m_value = bindProperty("value"); }

bool FloatSwitchView::update() {
    const bool raised = isTrue(m_value, true);
    const QString words = shown(text("label"));
    const bool changed = raised != m_raised || words != m_shown;
    m_raised = raised;
    m_shown = words;
    return changed;
}

TextBox FloatSwitchView::label(const QString& forTag) const {
    const double line = num("fontSize") * 1.4;
    return textBox(shown(text("label"), forTag), QRectF(0, height() - line, width(), line), num("fontSize"),
                   TextAlign::Center, "label", false, forTag);
}

void FloatSwitchView::draw(QPainter& painter) {
    const double room = text("label").isEmpty() ? 0 : num("fontSize") * 1.5, h = height() - room,
                 size = std::min(width() * 0.42, h * 0.34);
    const QPointF hook(width() / 2, 2);
    const QPointF joint(width() * 0.5, h * 0.36);
    const double angle = m_raised ? -22 : 62; // lifted by the water, or hanging
    painter.setPen(QPen(theme().color("line"), 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(hook - QPointF(8, 0), hook + QPointF(8, 0));
    QPainterPath cable(hook);
    cable.cubicTo(QPointF(hook.x(), h * 0.2), QPointF(joint.x() - 4, h * 0.3), joint);
    painter.drawPath(cable);
    painter.save();
    painter.translate(joint);
    painter.rotate(angle);
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2.5 : 1.8));
    painter.setBrush(stateColor(m_raised ? color("onColor") : color("offColor")));
    QPainterPath body;
    body.moveTo(-2, -size * 0.16);
    body.lineTo(size * 0.35, -size * 0.48);
    body.arcTo(QRectF(size * 0.1, -size * 0.48, size * 0.96, size * 0.96), 90, -180);
    body.lineTo(size * 0.35, size * 0.48);
    body.lineTo(-2, size * 0.16);
    body.closeSubpath();
    painter.drawPath(body);
    painter.restore();
    if (m_raised) { // the water line that lifts it
        painter.setPen(QPen(theme().color("liquid"), 2.5, Qt::SolidLine, Qt::RoundCap));
        const double y = h * 0.62;
        QPainterPath wave(QPointF(4, y));
        for (double x = 4; x + 14 <= width() - 2; x += 14) wave.cubicTo(x + 4, y - 5, x + 10, y + 5, x + 14, y);
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(wave);
    }
    painter.setPen(inkColor(theme().color("text")));
    drawText(painter, label(tag()));
}

void FloatSwitchView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("label").isEmpty()) out.push_back(label(forTag));
}

} // namespace plc::hmi
