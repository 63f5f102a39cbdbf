#include "hmi/view/scene/element_view.h"

#include "hmi/model/walk.h"
#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

namespace {
constexpr qint64 kEchoMilliseconds = 500;
}

ElementView::ElementView(const Element& element, PanelScene& scene)
    : m_element(element), m_scene(scene), m_rect(element.rect()) {}

ElementView::~ElementView() = default;

void ElementView::prepare() {
    m_bound.clear();
    m_rules.clear();
    m_textValues.clear();
    m_fresh = true;
    m_blinking = false;
    m_visible = bindProperty("visible");
    m_enabled = bindProperty("enabled");
    m_moveX = bindProperty("moveX");
    m_moveY = bindProperty("moveY");
    m_rotate = bindProperty("rotate");
    const Json& when = m_element.at("when");
    if (when.is_array())
        for (const Json& row : when) {
            if (!row.is_object()) continue;
            const Properties rule(descriptorOf(ElementKind::Unknown), row);
            const auto flag = [&](const char* key, bool fallback) {
                return rule.has(key) && rule.at(key).is_boolean() ? rule.at(key).get<bool>() : fallback;
            };
            m_rules.push_back({bindExpression(rule.text("if")), theme().color(rule.text("color")),
                               theme().color(rule.text("textColor")), flag("blink", false), flag("visible", true),
                               flag("enabled", true)});
        }
    const Json& values = m_element.at("values");
    if (values.is_object())
        for (const auto& [name, expression] : values.items())
            m_textValues.emplace_back(QString::fromStdString(name), bindExpression(toQString(expression)));
    setUp();
}

ElementView::Slot ElementView::bindProperty(PropertyKey<PropertyUse::Text> property) {
    return bindExpression(m_element.text(property));
}

ElementView::Slot ElementView::bindExpression(const QString& expression) {
    if (expression.trimmed().isEmpty()) return {};
    const BindingId id = m_scene.values() ? m_scene.values()->bind(expression) : BindingId{};
    m_bound.push_back({id, expression, {}});
    return {static_cast<int>(m_bound.size()) - 1};
}

std::vector<ElementView::BoundState> ElementView::bindStates() {
    std::vector<BoundState> out;
    const Json& rows = m_element.at("states");
    if (!rows.is_array()) return out;
    for (const Json& row : rows) {
        if (!row.is_object()) continue;
        const Properties state(descriptorOf(ElementKind::Unknown), row);
        out.push_back({bindExpression(state.text("value")), state.text("text"), theme().color(state.text("color")),
                       theme().color(state.text("textColor")), state.has("blink") && state.isSet("blink")});
    }
    return out;
}

const Value& ElementView::value(Slot slot) const {
    static const Value none;
    return slot.isBound() ? m_bound[static_cast<size_t>(slot.index)].last : none;
}

ValueFacts ElementView::facts(Slot slot) const {
    if (!slot.isBound() || !m_scene.values()) return {};
    return m_scene.values()->facts(m_bound[static_cast<size_t>(slot.index)].id);
}

BindingId ElementView::binding(Slot slot) const {
    return slot.isBound() ? m_bound[static_cast<size_t>(slot.index)].id : BindingId{};
}

QString ElementView::expression(Slot slot) const {
    return slot.isBound() ? m_bound[static_cast<size_t>(slot.index)].expression : QString();
}

std::optional<double> ElementView::number(Slot slot, double sample) const {
    if (!slot.isBound()) {
        if (isDesigning()) return sample;
        return {};
    }
    const Value& held = value(slot);
    if (held.isNone()) {
        if (isDesigning()) return sample;
        return {};
    }
    return held.toNumber();
}

bool ElementView::isTrue(Slot slot, bool sample) const {
    if (!slot.isBound() || value(slot).isNone()) return isDesigning() && sample;
    return value(slot).toBool();
}

bool ElementView::refresh() {
    bool changed = m_fresh;
    m_hasProblem = false;
    if (m_scene.values())
        for (Bound& bound : m_bound) {
            const Value& now = m_scene.values()->value(bound.id);
            if (now.isNone() && !m_scene.isDesigning()) m_hasProblem = true;
            if (now == bound.last) continue;
            bound.last = now;
            changed = true;
        }
    if (!changed) return false;
    const Appearance before = m_appearance;
    evaluateAppearance();
    const bool looksOther = update();
    const bool first = std::exchange(m_fresh, false);
    if (m_echo) m_echo.reset(); // the PLC has answered
    return first || looksOther || before != m_appearance;
}

void ElementView::evaluateAppearance() {
    Appearance now;
    now.visible = !m_visible.isBound() || value(m_visible).isNone() || value(m_visible).toBool();
    now.enabled = !m_enabled.isBound() || value(m_enabled).isNone() || value(m_enabled).toBool();
    now.moveX = value(m_moveX).toNumber();
    now.moveY = value(m_moveY).toNumber();
    now.rotation = value(m_rotate).toNumber();
    for (const Rule& rule : m_rules) {
        if (!value(rule.condition).toBool()) continue;
        now.color = rule.color;
        now.textColor = rule.textColor;
        now.blinks = rule.blink;
        now.visible = now.visible && rule.visible;
        now.enabled = now.enabled && rule.enabled;
        break; // the first true condition decides
    }
    m_appearance = now;
}

bool ElementView::tick(qint64 milliseconds) {
    bool changed = advance(milliseconds);
    if (m_echo) {
        if (m_echoUntil < 0) m_echoUntil = milliseconds + kEchoMilliseconds;
        if (milliseconds >= m_echoUntil) {
            m_echo.reset();
            update();
            changed = true;
        }
    }
    return changed;
}

void ElementView::echo(const Value& value) {
    m_echo = value;
    m_echoUntil = -1;
    update();
    repaint();
}

void ElementView::paint(QPainter& painter) {
    m_blinking = m_appearance.blinks;
    if (!m_appearance.visible && !isDesigning()) return;
    const bool isLocked = isInteractive() && !m_scene.isAllowed(*this);
    double opacity = 1;
    if (!m_appearance.visible)
        opacity = 0.25;
    else if (!m_appearance.enabled || isLocked)
        opacity = 0.45;
    if (m_appearance.blinks && !isLit()) opacity *= 0.35;
    if (opacity < 1) painter.setOpacity(painter.opacity() * opacity);
    draw(painter);
    if (isLocked) {
        painter.setOpacity(1);
        paintLock(painter);
    }
    if (!m_hasProblem) return;
    // A value that is missing is never shown as if it were there: a mark in the corner says so.
    painter.setOpacity(1);
    const double side = std::clamp(std::min(width(), height()) * 0.3, 8.0, 16.0);
    const QPolygonF corner{QPointF(width() - side, 0), QPointF(width(), 0), QPointF(width(), side)};
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color("low"));
    painter.drawPolygon(corner);
}

/// Kept for others: said by a shape, not by paleness alone.
void ElementView::paintLock(QPainter& painter) const {
    const double side = std::clamp(std::min(width(), height()) * 0.4, 10.0, 18.0);
    const QRectF body(width() - side - 2, height() - side * 0.62 - 2, side, side * 0.62);
    painter.setPen(QPen(theme().color("text"), side * 0.13));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(QRectF(body.left() + side * 0.2, body.top() - side * 0.36, side * 0.6, side * 0.72), 0, 180 * 16);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color("text"));
    painter.drawRoundedRect(body, 2, 2);
}

QRectF ElementView::touchArea() const {
    const double dx = std::max(0.0, (44 - width()) / 2), dy = std::max(0.0, (44 - height()) / 2);
    return box().adjusted(-dx, -dy, dx, dy);
}

void ElementView::setPressed(bool pressed) {
    if (m_pressed == pressed) return;
    m_pressed = pressed;
    repaint();
}

void ElementView::collectTexts(const QString&, std::vector<TextBox>&) const {}

QStringList ElementView::problems() const {
    QStringList out;
    for (const Bound& bound : m_bound)
        if (bound.last.isNone()) out += QStringLiteral("%1: %2").arg(bound.expression, bound.last.text());
    return out;
}

QStringList ElementView::boundExpressions() const {
    QStringList out;
    for (const Bound& bound : m_bound) out += bound.expression;
    return out;
}

QColor ElementView::color(PropertyKey<PropertyUse::Color> property) const {
    return theme().color(m_element.text(property));
}

QColor ElementView::colorOr(const QString& name, const QColor& fallback) const {
    const QColor found = theme().color(name);
    return found.isValid() ? found : fallback;
}

const PanelTheme& ElementView::theme() const { return m_scene.theme(); }

bool ElementView::isDesigning() const { return m_scene.isDesigning(); }

bool ElementView::isLit() const { return m_scene.isLit(); }

QString ElementView::tag() const {
    const QString fixed = m_element.text("language");
    return fixed.isEmpty() ? m_scene.language() : fixed;
}

QFont ElementView::font(double pixelSize, bool bold, const QString& forTag) const {
    QFont font;
    font.setFamilies(m_scene.texts().settings().fontFamilies(forTag.isEmpty() ? tag() : forTag));
    constexpr double Largest = 4096; // a panel file may say anything, also NaN
    font.setPixelSize(pixelSize > 1 ? static_cast<int>(std::min(pixelSize, Largest) + 0.5) : 1);
    font.setBold(bold);
    font.setHintingPreference(QFont::PreferNoHinting); // so that texts keep their width at every zoom
    return font;
}

QString ElementView::shown(const QString& reference, const QString& forTag) const {
    return m_scene.texts().fill(reference, forTag.isEmpty() ? tag() : forTag, [&](const QString& name) {
        for (const auto& [key, slot] : m_textValues)
            if (key == name && !value(slot).isNone()) return value(slot);
        if (m_scene.isMeasuring()) return Value::ofReal(888.8);
        if (isDesigning()) return Value::ofReal(0);
        return Value();
    });
}

TextBox ElementView::textBox(const QString& text, const QRectF& rect, double pixelSize, TextAlign align,
                             const char* property, bool bold, const QString& forTag) const {
    TextBox box;
    box.text = text;
    box.rect = rect;
    box.font = font(pixelSize, bold, forTag);
    box.align = align;
    box.rightToLeft = isRightToLeft(forTag.isEmpty() ? tag() : forTag);
    box.property = QString::fromLatin1(property);
    return box;
}

UnitView ElementView::unit(PropertyKey<PropertyUse::Text> property, const QString& forTag) const {
    return m_scene.texts().settings().unitFor(forTag.isEmpty() ? tag() : forTag, m_element.text(property));
}

QString ElementView::formatted(double raw, std::string_view format, const UnitView& unit, const QString& forTag) const {
    const QString number = formatValue(Value::ofReal(unit.shown(raw)), m_element.text(format),
                                       localeOf(forTag.isEmpty() ? tag() : forTag));
    if (unit.unit.isEmpty()) return number;
    const QString words = number + QChar(0x00A0) + unit.unit;
    return leftToRight(words, forTag);
}

QString ElementView::leftToRight(const QString& words, const QString& forTag) const {
    return isRightToLeft(forTag.isEmpty() ? tag() : forTag) ? QChar(0x2066) + words + QChar(0x2069) : words;
}

void ElementView::write(const QString& target, const Value& value, const QString& confirm) {
    if (target.trimmed().isEmpty()) return;
    m_scene.request(WriteRequest{m_element.id(), target, WriteKind::Write, value, {}},
                    confirm.isEmpty() ? confirm : shown(confirm));
}

Value ElementView::typed(Slot slot, double number) const {
    ValueKind kind = facts(slot).kind;
    if (kind == ValueKind::None) kind = value(slot).kind();
    switch (kind) {
    case ValueKind::Bool:
        return Value::ofBool(number != 0);
    case ValueKind::Integer:
    case ValueKind::Unsigned:
        return Value::ofInteger(Value::ofReal(number).toInteger());
    case ValueKind::Time:
        return Value::ofInstant(ValueKind::Time, Value::ofReal(number * 1e9).toInteger());
    case ValueKind::Text:
        return Value::ofText(QString::number(number));
    case ValueKind::None:
    case ValueKind::Real:
    case ValueKind::Date:
    case ValueKind::DateTime:
    case ValueKind::TimeOfDay:
    case ValueKind::Array:
        return Value::ofReal(number);
    }
    return Value::ofReal(number);
}

void ElementView::repaint() { m_scene.markDirty(*this); }

Limits Limits::of(const Element& element) {
    return {element.optionalNumber("lowLow"), element.optionalNumber("low"), element.optionalNumber("high"),
            element.optionalNumber("highHigh")};
}

int Limits::priorityAt(double value) const {
    if ((lowLow && value <= *lowLow) || (highHigh && value >= *highHigh)) return 1;
    if ((low && value <= *low) || (high && value >= *high)) return 3;
    return 0;
}

} // namespace plc::hmi
