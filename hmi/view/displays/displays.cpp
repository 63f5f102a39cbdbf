#include "hmi/view/displays/displays.h"

#include "hmi/view/scene/panel_scene.h"

#include <QPainterPath>
#include <QRadialGradient>
#include <cmath>

namespace plc::hmi {

// ---- number

void NumericDisplayView::setUp() { m_value = bindProperty("value"); }

bool NumericDisplayView::update() {
    const Value& now = value(m_value);
    QString words;
    int priority = 0;
    const QString list = text("list");
    if (now.isNone()) {
        words = isDesigning() ? formatted(12.3, "format", unit()) : QStringLiteral("– –");
    } else if (!list.isEmpty() && !scene().texts().listText(list, now.toInteger(), tag()).isEmpty()) {
        words = scene().texts().listText(list, now.toInteger(), tag());
    } else if (now.isNumber()) {
        const ValueFacts known = facts(m_value);
        for (const auto& one : known.enumValues)
            if (one.number == now.toInteger()) words = one.name;
        if (words.isEmpty()) words = formatted(now.toNumber(), "format", unit());
        Limits limits;
        limits.low = element().optionalNumber("low");
        limits.high = element().optionalNumber("high");
        priority = limits.priorityAt(now.toNumber());
    } else {
        words = formatValue(now, text("format"), locale());
        if (!unit().unit.isEmpty() && now.kind() != ValueKind::Text)
            words = leftToRight(words + QChar(0x00A0) + unit().unit);
    }
    const QString caption = shown(text("label"));
    const bool changed = words != m_shown || priority != m_priority || caption != m_caption;
    m_shown = words;
    m_priority = priority;
    m_caption = caption;
    return changed;
}

TextBox NumericDisplayView::caption(const QString& forTag) const {
    return textBox(shown(text("label"), forTag),
                   QRectF(isRightToLeft(forTag) ? width() * 0.5 : 8, 0, width() * 0.5 - 8, height()),
                   num("fontSize") * 0.8, TextAlign::Start, "label", false, forTag);
}

TextBox NumericDisplayView::number(const QString& words, const QString& forTag) const {
    QRectF area = box().adjusted(8, 2, -8, -2);
    if (!text("label").isEmpty()) {
        if (isRightToLeft(forTag))
            area.setRight(width() * 0.5);
        else
            area.setLeft(width() * 0.5);
    }
    TextBox out = textBox(words, area, num("fontSize"), textAlign(text("align")), "format", flag("bold"), forTag);
    return out;
}

void NumericDisplayView::draw(QPainter& painter) {
    const QColor mark = m_priority ? theme().priority(m_priority) : QColor();
    if (flag("frame")) {
        const QColor ground = stateColor(theme().color("surface"));
        painter.setPen(QPen(mark.isValid() ? mark : theme().color("faint"), mark.isValid() ? 3 : 1));
        painter.setBrush(ground);
        painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    } else if (mark.isValid()) {
        painter.setPen(QPen(mark, 3));
        painter.drawLine(QPointF(0, height() - 1), QPointF(width(), height() - 1));
    }
    if (!m_caption.isEmpty()) {
        painter.setPen(theme().color("muted"));
        drawText(painter, caption(tag()));
    }
    painter.setPen(inkColor(color("textColor")));
    drawText(painter, number(m_shown, tag()));
}

void NumericDisplayView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("label").isEmpty()) out.push_back(caption(forTag));
    const QString list = text("list");
    for (int i = 0; !list.isEmpty() && i < scene().texts().table().listLength(list); ++i) {
        out.push_back(number(scene().texts().listText(list, i, forTag), forTag));
        out.back().property = QStringLiteral("list");
    }
}

// ---- date and time

void DateTimeView::setUp() { m_value = bindProperty("value"); }

QString DateTimeView::words(qint64 ns, ValueKind kind, const QString& forTag) const {
    const QLocale where = localeOf(forTag);
    const QString shows = text("shows");
    const bool seconds = flag("seconds");
    if (kind == ValueKind::Time) return formatDuration(ns, where);
    if (kind == ValueKind::TimeOfDay || shows == QStringLiteral("time")) return formatTime(ns, where, seconds);
    if (kind == ValueKind::Date || shows == QStringLiteral("date")) return formatDate(ns, where);
    if (shows == QStringLiteral("week")) return formatWeek(ns, where);
    return formatDate(ns, where) + QStringLiteral("  ") + formatTime(ns, where, seconds);
}

bool DateTimeView::update() {
    const Value& now = value(m_value);
    QString text;
    if (m_value.isBound()) {
        const bool isDate = now.kind() == ValueKind::DateTime || now.kind() == ValueKind::Date ||
                            now.kind() == ValueKind::TimeOfDay || now.kind() == ValueKind::Time;
        text = isDate                           ? words(now.toInteger(), now.kind(), tag())
               : now.isNone() && !isDesigning() ? QStringLiteral("– –")
                                                : words(1704111845000000000, ValueKind::DateTime, tag());
    } else {
        text = words(scene().values() && !isDesigning() ? scene().values()->clock() : 1704111845000000000,
                     ValueKind::DateTime, tag());
    }
    return std::exchange(m_shown, text) != text;
}

bool DateTimeView::advance(qint64) { return !m_value.isBound() && update(); }

TextBox DateTimeView::label(const QString& words, const QString& forTag) const {
    return textBox(words, box().adjusted(4, 0, -4, 0), num("fontSize"), textAlign(text("align")), "shows", flag("bold"),
                   forTag);
}

void DateTimeView::draw(QPainter& painter) {
    painter.setPen(inkColor(color("textColor")));
    drawText(painter, label(m_shown, tag()));
}

void DateTimeView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    out.push_back(label(words(1735646399000000000, ValueKind::DateTime, forTag), forTag));
}

// ---- lamp

void LampView::setUp() { m_value = bindProperty("value"); }

bool LampView::update() {
    const bool on = isTrue(m_value, true), known = !m_value.isBound() || !value(m_value).isNone();
    const QString now = shown(text("label"));
    const bool changed = on != m_on || known != m_isKnown || now != m_shown;
    m_on = on;
    m_isKnown = known;
    m_shown = now;
    return changed;
}

QRectF LampView::lens() const {
    const double room = text("label").isEmpty() ? 0 : num("fontSize") * 1.5;
    const QRectF area(1, 1, width() - 2, height() - room - 2);
    if (text("shape") == QStringLiteral("pill")) return area;
    const double side = std::min(area.width(), area.height());
    return {area.center().x() - side / 2, area.center().y() - side / 2, side, side};
}

TextBox LampView::label(const QString& forTag) const {
    const double line = num("fontSize") * 1.5;
    return textBox(shown(text("label"), forTag), QRectF(0, height() - line, width(), line), num("fontSize"),
                   TextAlign::Center, "label", false, forTag);
}

void LampView::draw(QPainter& painter) {
    const bool blinks = m_on && flag("blink");
    m_blinking = m_blinking || blinks;
    const bool glows = m_on && (!blinks || isLit());
    const QColor own = stateColor(glows ? color("onColor") : color("offColor"));
    const QColor lensColor = own.isValid() ? own : theme().color("off");
    const QRectF area = lens();
    const QString shape = text("shape");
    const double radius = shape == QStringLiteral("round")  ? area.height() / 2
                          : shape == QStringLiteral("pill") ? area.height() / 2
                                                            : 5;
    const double rim = std::clamp(area.height() * 0.07, 1.5, 4.0);
    const QRectF inner = area.adjusted(rim * 1.4, rim * 1.4, -rim * 1.4, -rim * 1.4);
    const double innerRadius = std::max(1.0, radius - rim * 1.4);
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(theme().color("raised"));
    painter.drawRoundedRect(area, radius, radius);
    painter.setPen(QPen(lensColor.darker(135), 1));
    if (theme().kind() == PanelThemeKind::Contrast || !glows) {
        painter.setBrush(lensColor);
    } else {
        QRadialGradient light(inner.center() - QPointF(inner.width() * 0.15, inner.height() * 0.2),
                              std::max(inner.width(), inner.height()) * 0.75);
        light.setColorAt(0, lensColor.lighter(150));
        light.setColorAt(0.55, lensColor);
        light.setColorAt(1, lensColor.darker(115));
        painter.setBrush(light);
    }
    painter.drawRoundedRect(inner, innerRadius, innerRadius);
    if (!glows && theme().kind() == PanelThemeKind::Contrast) { // off has another shape, too
        painter.setPen(QPen(theme().color("line"), 2));
        painter.drawLine(inner.center() - QPointF(inner.height() * 0.2, 0),
                         inner.center() + QPointF(inner.height() * 0.2, 0));
    }
    if (m_shown.isEmpty()) return;
    painter.setPen(inkColor(theme().color("text")));
    drawText(painter, label(tag()));
}

void LampView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("label").isEmpty()) out.push_back(label(forTag));
}

// ---- multi-state

void MultiStateView::setUp() {
    m_value = bindProperty("value");
    m_states = bindStates();
}

QString MultiStateView::stateText(int state, const QString& forTag) const {
    if (state >= 0) return shown(m_states[static_cast<size_t>(state)].text, forTag);
    const Value& now = value(m_value);
    const QString fromList = scene().texts().listText(text("list"), now.toInteger(), forTag);
    if (!now.isNone() && !fromList.isEmpty()) return fromList;
    for (const auto& one : facts(m_value).enumValues)
        if (!now.isNone() && one.number == now.toInteger()) return one.name;
    if (now.isNone() && isDesigning()) {
        const QString first = scene().texts().listText(text("list"), 0, forTag);
        return first.isEmpty() ? QStringLiteral("…") : first;
    }
    if (now.isNone()) return QStringLiteral("– –");
    return formatValue(now, {}, localeOf(forTag));
}

bool MultiStateView::update() {
    const Value& now = value(m_value);
    int present = -1;
    for (size_t i = 0; i < m_states.size() && !now.isNone() && present < 0; ++i) {
        const Value& other = value(m_states[i].value);
        // A state's value may be a value or a condition: `Main.level > 5` is true, 3 equals.
        const bool hit = other.kind() == ValueKind::Bool && now.kind() != ValueKind::Bool ? other.toBool()
                         : now.kind() == ValueKind::Text                                  ? now.text() == other.text()
                                                         : !other.isNone() && other.toNumber() == now.toNumber();
        if (hit) present = static_cast<int>(i);
    }
    if (now.isNone() && isDesigning() && !m_states.empty()) present = 0;
    const QString words = present >= 0 && m_states[static_cast<size_t>(present)].text.isEmpty()
                              ? stateText(-1, tag())
                              : stateText(present, tag());
    const bool changed = present != m_present || words != m_shown;
    m_present = present;
    m_shown = words;
    return changed;
}

TextBox MultiStateView::label(const QString& words, const QByteArray& place, const QString& forTag) const {
    TextBox out = textBox(words, box().adjusted(8, 2, -8, -2), num("fontSize"), textAlign(text("align")),
                          place.constData(), flag("bold"), forTag);
    out.wraps = true;
    return out;
}

void MultiStateView::draw(QPainter& painter) {
    QColor ground = theme().color("surface"), ink;
    if (m_present >= 0) {
        const BoundState& state = m_states[static_cast<size_t>(m_present)];
        if (state.color.isValid()) ground = state.color;
        ink = state.textColor;
        m_blinking = m_blinking || state.blinks;
        if (state.blinks && !isLit()) ground = theme().color("surface");
    }
    ground = stateColor(ground);
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    const bool ownInk = text("textColor") == QStringLiteral("text");
    painter.setPen(inkColor(ink.isValid() ? ink : ownInk ? PanelTheme::inkOn(ground) : color("textColor")));
    drawText(painter, label(m_shown, {}, tag()));
}

void MultiStateView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    for (size_t i = 0; i < m_states.size(); ++i)
        if (!m_states[i].text.isEmpty())
            out.push_back(label(shown(m_states[i].text, forTag),
                                "states[" + QByteArray::number(static_cast<int>(i)) + "].text", forTag));
    const QString list = text("list");
    for (int i = 0; !list.isEmpty() && i < scene().texts().table().listLength(list); ++i)
        out.push_back(label(scene().texts().listText(list, i, forTag), "list", forTag));
}

// ---- 7-segment display

void SevenSegmentView::setUp() { m_value = bindProperty("value"); }

bool SevenSegmentView::update() {
    const int digits = std::max(1, element().integer("digits")),
              decimals = std::clamp(element().integer("decimals"), 0, digits - 1);
    const std::optional<double> now = number(m_value, 1234 / std::pow(10, decimals));
    QString out;
    if (!now) {
        out = QString(digits, u'-');
    } else {
        out = QString::number(*now, 'f', decimals);
        const qsizetype room = digits + (decimals > 0 ? 1 : 0);
        if (out.size() > room)
            out = QString(digits, u'-');
        else
            out = out.rightJustified(room, flag("zeros") && *now >= 0 ? u'0' : u' ');
    }
    return std::exchange(m_digits, out) != out;
}

void SevenSegmentView::draw(QPainter& painter) {
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(theme().color("glass"));
    painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    const qsizetype cells = std::max<qsizetype>(1, m_digits.size() - m_digits.count(u'.'));
    const double pitch = (width() - 12) / static_cast<double>(cells), h = std::min(height() - 14, pitch * 1.75),
                 w = h * 0.5, t = h * 0.1;
    const QColor lit = stateColor(color("color"));
    QColor dark = lit;
    dark.setAlphaF(0.13f);
    painter.setPen(Qt::NoPen);
    // Bits: top, upper right, lower right, bottom, lower left, upper left, middle.
    static const QHash<QChar, int> shapes{{u'0', 0x3F}, {u'1', 0x06}, {u'2', 0x5B}, {u'3', 0x4F},
                                          {u'4', 0x66}, {u'5', 0x6D}, {u'6', 0x7D}, {u'7', 0x07},
                                          {u'8', 0x7F}, {u'9', 0x6F}, {u'-', 0x40}, {u' ', 0}};
    double x = 6 + (pitch - w) / 2;
    const double y = (height() - h) / 2;
    for (qsizetype i = 0; i < m_digits.size(); ++i) {
        if (m_digits[i] == u'.') continue;
        const int bits = shapes.value(m_digits[i], 0x40);
        const QPointF corners[6] = {{x, y}, {x + w, y}, {x + w, y + h / 2}, {x + w, y + h}, {x, y + h}, {x, y + h / 2}};
        const std::pair<int, int> ends[7] = {{0, 1}, {1, 2}, {2, 3}, {4, 3}, {5, 4}, {0, 5}, {5, 2}};
        for (int s = 0; s < 7; ++s) {
            const QPointF a = corners[ends[s].first], b = corners[ends[s].second],
                          along = (b - a) / std::hypot(b.x() - a.x(), b.y() - a.y());
            const QPointF across = QPointF(-along.y(), along.x()) * t * 0.5, from = a + along * t * 0.62,
                          to = b - along * t * 0.62, tip = along * t * 0.5;
            QPolygonF segment{from - tip + along * 0.1 * t, from + across, to + across,
                              to + tip - along * 0.1 * t,   to - across,   from - across};
            for (QPointF& point : segment)
                point.rx() += (y + h / 2 - point.y()) * 0.09; // a little slanted, as the real ones
            painter.setBrush(bits >> s & 1 ? lit : dark);
            painter.drawPolygon(segment);
        }
        const bool hasPoint = i + 1 < m_digits.size() && m_digits[i + 1] == u'.';
        if (hasPoint) {
            painter.setBrush(lit);
            painter.drawEllipse(QPointF(x + w + (pitch - w) * 0.42, y + h), t * 0.62, t * 0.62);
        }
        x += pitch;
    }
}

// ---- progress

void ProgressView::setUp() { m_value = bindProperty("value"); }

QString ProgressView::words(double share, const QString& forTag) const {
    const QString own = shown(text("text"), forTag);
    if (!flag("showValue")) return own;
    const QString percent = localeOf(forTag).toString(std::round(share * 100), 'f', 0) + QChar(0x00A0) + u'%';
    return own.isEmpty() ? percent : own + QStringLiteral("  ") + percent;
}

bool ProgressView::update() {
    const double low = num("min"), high = num("max");
    const std::optional<double> now = number(m_value, low + (high - low) * 0.65);
    const double share = now && high != low ? std::clamp((*now - low) / (high - low), 0.0, 1.0) : 0;
    const QString text = now ? words(share, tag()) : QStringLiteral("– –");
    const bool changed = std::abs(share - m_share) * width() >= 0.3 || text != m_shown || now.has_value() != m_isKnown;
    if (changed) m_share = share;
    m_isKnown = now.has_value();
    m_shown = text;
    return changed;
}

TextBox ProgressView::label(const QString& words, const QString& forTag) const {
    return textBox(words, box().adjusted(6, 0, -6, 0), num("fontSize"), TextAlign::Center, "text", false, forTag);
}

void ProgressView::draw(QPainter& painter) {
    const double r = std::min(6.0, height() / 2);
    QPainterPath shape;
    shape.addRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), r, r);
    painter.fillPath(shape, theme().color("inset"));
    const QColor fill = stateColor(color("color"));
    const bool rtl = isRightToLeft(tag());
    const QRectF done = rtl ? QRectF(width() * (1 - m_share), 0, width() * m_share, height())
                            : QRectF(0, 0, width() * m_share, height());
    painter.save();
    painter.setClipPath(shape, Qt::IntersectClip);
    painter.fillRect(done, fill);
    painter.restore();
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shape);
    // The text is readable on both grounds: each part is drawn in the ink of what lies under it.
    const TextBox box = label(m_shown, tag());
    painter.save();
    painter.setClipRect(done, Qt::IntersectClip);
    painter.setPen(PanelTheme::inkOn(fill));
    drawText(painter, box);
    painter.restore();
    painter.save();
    painter.setClipRect(rtl ? QRectF(0, 0, done.left(), height())
                            : QRectF(done.right(), 0, width() - done.right(), height()),
                        Qt::IntersectClip);
    painter.setPen(inkColor(theme().color("text")));
    drawText(painter, box);
    painter.restore();
}

void ProgressView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    out.push_back(label(words(1, forTag), forTag));
}

} // namespace plc::hmi
