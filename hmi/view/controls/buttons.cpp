#include "hmi/view/controls/buttons.h"

#include "hmi/view/scene/panel_scene.h"

#include <QPainterPath>

namespace plc::hmi {

void drawKey(QPainter& painter, const QRectF& rect, double radius, const QColor& ground, bool isDown,
             const PanelTheme& theme) {
    const double r = std::min(radius, std::min(rect.width(), rect.height()) / 2);
    const QRectF inner = rect.adjusted(0.75, 0.75, -0.75, -0.75);
    if (theme.kind() == PanelThemeKind::Contrast) {
        painter.setPen(QPen(theme.color("line"), isDown ? 4 : 2));
        painter.setBrush(ground);
        painter.drawRoundedRect(inner, r, r);
        return;
    }
    QPainterPath key;
    key.addRoundedRect(inner, r, r);
    painter.fillPath(key, isDown ? ground.darker(theme.isDark() ? 122 : 110) : ground);
    if (!isDown && inner.height() > 16) {
        // The lower edge in shade makes it a thing that can be pressed.
        QPainterPath body;
        body.addRoundedRect(inner.adjusted(0, 0, 0, -2.5), r, r);
        painter.fillPath(key.subtracted(body), ground.darker(theme.isDark() ? 150 : 122));
    }
    painter.setPen(QPen(theme.isDark() ? theme.color("line").darker(150) : theme.color("line").lighter(125), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(inner, r, r);
}

namespace {

template <class Enum> Enum choiceOf(const Element& element, std::string_view property) {
    const std::vector<std::string_view> choices = element.descriptor().property(property)->choices();
    const std::string value = toUtf8(element.text(property));
    for (size_t i = 0; i < choices.size(); ++i)
        if (choices[i] == value) return static_cast<Enum>(i);
    return static_cast<Enum>(0);
}

void drawIcon(QPainter& painter, ButtonIcon icon, const QRectF& r, const QColor& ink) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    const auto at = [&](double x, double y) { return QPointF(r.left() + x * r.width(), r.top() + y * r.height()); };
    const auto poly = [&](std::initializer_list<std::pair<double, double>> points) {
        QPolygonF shape;
        for (const auto& [x, y] : points) shape << at(x, y);
        painter.drawPolygon(shape);
    };
    const auto bar = [&](double x, double y, double w, double h) {
        painter.drawRect(QRectF(at(x, y), QSizeF(w * r.width(), h * r.height())));
    };
    switch (icon) {
    case ButtonIcon::None:
        return;
    case ButtonIcon::Play:
        return poly({{0.2, 0.1}, {0.9, 0.5}, {0.2, 0.9}});
    case ButtonIcon::Stop:
        return bar(0.15, 0.15, 0.7, 0.7);
    case ButtonIcon::Pause:
        bar(0.18, 0.12, 0.24, 0.76);
        return bar(0.58, 0.12, 0.24, 0.76);
    case ButtonIcon::Up:
        return poly({{0.5, 0.15}, {0.95, 0.8}, {0.05, 0.8}});
    case ButtonIcon::Down:
        return poly({{0.5, 0.85}, {0.95, 0.2}, {0.05, 0.2}});
    case ButtonIcon::Left:
        return poly({{0.15, 0.5}, {0.8, 0.05}, {0.8, 0.95}});
    case ButtonIcon::Right:
        return poly({{0.85, 0.5}, {0.2, 0.05}, {0.2, 0.95}});
    case ButtonIcon::Plus:
        bar(0.42, 0.1, 0.16, 0.8);
        return bar(0.1, 0.42, 0.8, 0.16);
    case ButtonIcon::Minus:
        return bar(0.1, 0.42, 0.8, 0.16);
    case ButtonIcon::Home:
        poly({{0.5, 0.08}, {0.98, 0.52}, {0.02, 0.52}});
        return bar(0.18, 0.5, 0.64, 0.4);
    case ButtonIcon::Reset: {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(ink, r.width() * 0.14, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(r.adjusted(r.width() * 0.12, r.height() * 0.12, -r.width() * 0.12, -r.height() * 0.12), 40 * 16,
                        280 * 16);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        poly({{0.98, 0.1}, {0.98, 0.52}, {0.6, 0.36}});
        return;
    }
    }
}

} // namespace

void ButtonView::setUp() {
    m_action = choiceOf<ButtonAction>(element(), "action");
    m_icon = choiceOf<ButtonIcon>(element(), "icon");
    const bool writes = m_action <= ButtonAction::Write;
    m_target = writes ? bindProperty("target") : Slot{};
    m_write = m_action == ButtonAction::Write ? bindProperty("write") : Slot{};
    m_lit = bindProperty("lit");
}

bool ButtonView::update() {
    const bool byState = m_action == ButtonAction::Toggle && !m_lit.isBound();
    const bool lit = byState ? echoed(m_target).toBool() : isTrue(m_lit);
    const QString now = shown(text("text"));
    const bool changed = lit != m_isLit || now != m_shown;
    m_isLit = lit;
    m_shown = now;
    return changed;
}

void ButtonView::press(QPointF) {
    m_isDown = true;
    if (m_action != ButtonAction::Momentary || !m_target.isBound() || !text("confirm").isEmpty()) return;
    scene().request(
        WriteRequest{element().id(), expression(m_target), WriteKind::Press, Value::ofBool(true), Value::ofBool(false)},
        {});
}

void ButtonView::release(QPointF, bool inside) {
    if (!std::exchange(m_isDown, false)) return;
    if (m_action == ButtonAction::Momentary && text("confirm").isEmpty()) {
        if (m_target.isBound())
            scene().request(WriteRequest{element().id(), expression(m_target), WriteKind::Release, Value::ofBool(false),
                                         Value::ofBool(false)},
                            {});
        return;
    }
    if (inside) perform();
}

void ButtonView::perform() {
    const QString confirm = text("confirm");
    const auto put = [&](const Value& value) { write(expression(m_target), value, confirm); };
    switch (m_action) {
    case ButtonAction::Momentary:
        // With a question there is nobody who holds it down: one press of a scan.
        scene().request(WriteRequest{element().id(), expression(m_target), WriteKind::Press, Value::ofBool(true),
                                     Value::ofBool(false)},
                        shown(confirm));
        return;
    case ButtonAction::Toggle: {
        const Value next = Value::ofBool(!echoed(m_target).toBool());
        put(next);
        if (confirm.isEmpty()) echo(next);
        return;
    }
    case ButtonAction::Set:
        return put(Value::ofBool(true));
    case ButtonAction::Reset:
        return put(Value::ofBool(false));
    case ButtonAction::Write:
        return put(value(m_write));
    case ButtonAction::Panel:
        if (const Arguments arguments = argumentsOf(element().at("arguments")); !arguments.isEmpty())
            return scene().request(NavigationRequest{NavigationKind::Open, text("panel"), arguments});
        return scene().requestPanel(text("panel"));
    case ButtonAction::Language:
        return scene().requestLanguage(text("tag"));
    case ButtonAction::Theme:
        return scene().requestTheme(text("theme"));
    case ButtonAction::Acknowledge:
        return scene().request(AcknowledgeRequest{});
    case ButtonAction::PopUp:
        return scene().request(
            NavigationRequest{NavigationKind::PopUp, text("panel"), argumentsOf(element().at("arguments"))});
    case ButtonAction::Close:
        return scene().request(NavigationRequest{NavigationKind::Close, {}, {}});
    case ButtonAction::Back:
        return scene().request(NavigationRequest{NavigationKind::Back, {}, {}});
    case ButtonAction::Home:
        return scene().request(NavigationRequest{NavigationKind::Home, {}, {}});
    case ButtonAction::LogOut:
        return scene().request(AccessRequest{element().id(), {}, true});
    }
}

double ButtonView::iconSide() const {
    return m_icon == ButtonIcon::None ? 0 : std::min({num("fontSize") * 1.1, height() * 0.6, width() * 0.6});
}

TextBox ButtonView::label(const QString& forTag) const {
    const double icon = iconSide();
    const QString words = shown(text("text"), forTag);
    QRectF area = box().adjusted(8, 4, -8, -5);
    if (icon > 0 && !words.isEmpty()) {
        if (isRightToLeft(forTag))
            area.setRight(area.right() - icon - 6);
        else
            area.setLeft(area.left() + icon + 6);
    }
    TextBox out = textBox(words, area, num("fontSize"), textAlign(text("align")), "text", flag("bold"), forTag);
    out.wraps = true;
    return out;
}

void ButtonView::draw(QPainter& painter) {
    const QColor ground = stateColor(m_isLit ? color("litColor") : color("color"));
    const QColor face = ground.isValid() ? ground : theme().color("button");
    drawKey(painter, box(), num("radius"), face, isPressed() || m_isDown, theme());
    const bool ownInk = text("textColor") == QStringLiteral("text") && !appearance().textColor.isValid();
    const QColor ink = ownInk ? PanelTheme::inkOn(face) : inkColor(color("textColor"));
    if (isPressed()) painter.translate(0, 1);
    const double icon = iconSide();
    TextBox words = label(tag());
    if (icon > 0) {
        QRectF place((width() - icon) / 2, (height() - icon) / 2, icon, icon);
        if (!words.text.isEmpty()) {
            // Icon and text are centred together.
            const double textWidth = std::min(neededSize(words).width(), words.rect.width());
            const double left = std::max(8.0, (width() - textWidth - icon - 6) / 2);
            place.moveLeft(words.rightToLeft ? width() - left - icon : left);
            words.rect =
                words.rightToLeft
                    ? QRectF(place.left() - 6 - textWidth - 1, words.rect.top(), textWidth + 1, words.rect.height())
                    : QRectF(place.right() + 6, words.rect.top(), textWidth + 1, words.rect.height());
            words.align = TextAlign::Start;
        }
        drawIcon(painter, m_icon, place, ink);
    }
    painter.setPen(ink);
    drawText(painter, words);
}

void ButtonView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("text").isEmpty()) out.push_back(label(forTag));
}

void SwitchView::setUp() { m_target = bindProperty("target"); }

bool SwitchView::update() {
    const bool on = echoed(m_target).toBool();
    return std::exchange(m_on, on) != on;
}

void SwitchView::release(QPointF, bool inside) {
    if (!inside) return;
    const Value next = Value::ofBool(!m_on);
    write(expression(m_target), next, text("confirm"));
    if (text("confirm").isEmpty() && m_target.isBound()) echo(next);
}

bool SwitchView::hasLabel() const { return !text("onText").isEmpty() || !text("offText").isEmpty(); }

QRectF SwitchView::track() const {
    const double h = std::min(height() - 4, 34.0), w = std::min(width() - 4, h * 1.9);
    const double left = hasLabel() ? (isRightToLeft(tag()) ? width() - w - 2 : 2) : (width() - w) / 2;
    return {left, (height() - h) / 2, w, h};
}

TextBox SwitchView::label(bool on, const QString& forTag) const {
    const QRectF area = track();
    const bool rtl = isRightToLeft(forTag);
    const QRectF rest = rtl ? QRectF(0, 0, area.width() > 0 ? width() - area.width() - 12 : 0, height())
                            : QRectF(area.width() + 12, 0, width() - area.width() - 12, height());
    return textBox(shown(on ? text("onText") : text("offText"), forTag), rest, num("fontSize"), TextAlign::Start,
                   on ? "onText" : "offText", false, forTag);
}

void SwitchView::draw(QPainter& painter) {
    const QRectF area = track();
    const double r = area.height() / 2;
    const QColor ground = m_on ? stateColor(color("onColor")) : theme().color("off");
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(area, r, r);
    // The mark tells on from off without colour.
    painter.setPen(QPen(PanelTheme::inkOn(ground), 2));
    if (m_on)
        painter.drawLine(QPointF(area.left() + r, area.center().y() - r * 0.35),
                         QPointF(area.left() + r, area.center().y() + r * 0.35));
    else {
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(area.right() - r, area.center().y()), r * 0.3, r * 0.3);
    }
    const double knob = r - 3;
    painter.setPen(QPen(theme().color("line"), 1));
    painter.setBrush(isPressed() ? theme().color("raised").darker(108) : QColor(Qt::white));
    painter.drawEllipse(QPointF(m_on ? area.right() - r : area.left() + r, area.center().y()), knob, knob);
    painter.setPen(inkColor(theme().color("text")));
    if (hasLabel()) drawText(painter, label(m_on, tag()));
}

void SwitchView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!hasLabel()) return;
    out.push_back(label(true, forTag));
    out.push_back(label(false, forTag));
}

void CheckBoxView::setUp() { m_target = bindProperty("target"); }

bool CheckBoxView::update() {
    const bool on = echoed(m_target).toBool();
    return std::exchange(m_on, on) != on;
}

void CheckBoxView::release(QPointF, bool inside) {
    if (!inside || !m_target.isBound()) return;
    const Value next = Value::ofBool(!m_on);
    write(expression(m_target), next);
    echo(next);
}

double CheckBoxView::side() const { return std::min(height() - 4, num("fontSize") * 1.6); }

TextBox CheckBoxView::label(const QString& forTag) const {
    const double used = side() + 12;
    const QRectF area =
        isRightToLeft(forTag) ? QRectF(0, 0, width() - used, height()) : QRectF(used, 0, width() - used, height());
    TextBox out = textBox(shown(text("text"), forTag), area, num("fontSize"), TextAlign::Start, "text", false, forTag);
    out.wraps = true;
    return out;
}

void CheckBoxView::draw(QPainter& painter) {
    const double s = side();
    const QRectF mark(isRightToLeft(tag()) ? width() - s - 2 : 2, (height() - s) / 2, s, s);
    const QColor ground = m_on ? stateColor(theme().color("accent")) : theme().color("inset");
    painter.setPen(QPen(m_on ? ground.darker(115) : theme().color("line"), isPressed() ? 2.5 : 1.5));
    painter.setBrush(ground);
    painter.drawRoundedRect(mark, 4, 4);
    if (m_on) {
        painter.setPen(QPen(PanelTheme::inkOn(ground), s * 0.13, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(QPolygonF{mark.topLeft() + QPointF(s * 0.24, s * 0.53),
                                       mark.topLeft() + QPointF(s * 0.43, s * 0.72),
                                       mark.topLeft() + QPointF(s * 0.77, s * 0.3)});
    }
    painter.setPen(inkColor(theme().color("text")));
    drawText(painter, label(tag()));
}

void CheckBoxView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("text").isEmpty()) out.push_back(label(forTag));
}

} // namespace plc::hmi
