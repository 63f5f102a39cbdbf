#include "hmi/view/controls/entries.h"

#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

void EntryView::setUp() { m_target = bindProperty("target"); }

bool EntryView::update() {
    const Value now = echoed(m_target);
    const QString words = now.isNone() ? (isDesigning() ? sample() : QStringLiteral("– –")) : contents(now, tag());
    return std::exchange(m_shown, words) != words;
}

TextBox EntryView::label(const QString& words, const QString& forTag) const {
    return textBox(words, box().adjusted(10, 2, -10, -2), num("fontSize"), textAlign(text("align")), "format",
                   flag("bold"), forTag);
}

void EntryView::draw(QPainter& painter) {
    const bool contrast = theme().kind() == PanelThemeKind::Contrast;
    painter.setPen(
        QPen(isPressed() ? theme().color("accent") : theme().color("line"), isPressed() || contrast ? 2 : 1));
    painter.setBrush(stateColor(theme().color("inset")));
    painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    // The line below says: this can be changed.
    painter.setPen(QPen(theme().color("accent"), 2.5));
    painter.drawLine(QPointF(5, height() - 2), QPointF(width() - 5, height() - 2));
    painter.setPen(inkColor(color("textColor")));
    drawText(painter, label(m_shown, tag()));
}

void EntryView::release(QPointF, bool inside) {
    if (!inside || !m_target.isBound()) return;
    EntryRequest entry;
    entry.element = element().id();
    entry.target = expression(m_target);
    entry.title = shown(text("title"));
    entry.present = value(m_target);
    entry.valueKind = facts(m_target).kind;
    if (entry.valueKind == ValueKind::None) entry.valueKind = entry.present.kind();
    entry.place = rect();
    fill(entry);
    scene().request(entry);
}

void EntryView::collectTexts(const QString&, std::vector<TextBox>&) const {}

void NumericEntryView::setUp() {
    EntryView::setUp();
    m_minimum = bindProperty("minimum");
    m_maximum = bindProperty("maximum");
}

QString NumericEntryView::contents(const Value& value, const QString& forTag) const {
    if (!value.isNumber() && value.kind() != ValueKind::Bool)
        return formatValue(value, text("format"), localeOf(forTag));
    const UnitView shownUnit = unit("unit", forTag);
    return formatted(value.toNumber(), "format", shownUnit, forTag);
}

void NumericEntryView::fill(EntryRequest& entry) const {
    const UnitView shownUnit = unit();
    entry.kind = EntryKind::Number;
    entry.unit = shownUnit.unit;
    entry.format = text("format");
    entry.factor = shownUnit.factor;
    entry.offset = shownUnit.offset;
    const ValueFacts known = facts(m_target);
    // The element's own limits first, then those of the type.
    std::optional<double> low = known.minimum, high = known.maximum;
    if (m_minimum.isBound() && !value(m_minimum).isNone()) low = value(m_minimum).toNumber();
    if (m_maximum.isBound() && !value(m_maximum).isNone()) high = value(m_maximum).toNumber();
    if (low) entry.minimum = shownUnit.shown(*low);
    if (high) entry.maximum = shownUnit.shown(*high);
}

QString TextEntryView::contents(const Value& value, const QString& forTag) const {
    return value.kind() == ValueKind::Text ? value.text() : formatValue(value, {}, localeOf(forTag));
}

void TextEntryView::fill(EntryRequest& entry) const {
    entry.kind = EntryKind::Text;
    const int capacity = facts(m_target).textCapacity, own = element().integer("maxLength");
    entry.maxLength = own > 0 && capacity > 0 ? std::min(own, capacity) : std::max(own, capacity);
}

QString MaskedEntryView::contents(const Value& value, const QString& forTag) const {
    const QString words =
        value.kind() == ValueKind::Text ? value.text() : formatValue(value, QStringLiteral("%d"), localeOf(forTag));
    return flag("hidden") ? QString(words.size(), QChar(0x2022)) : words;
}

void MaskedEntryView::fill(EntryRequest& entry) const {
    entry.kind = EntryKind::Masked;
    entry.mask = text("mask");
    entry.isHidden = flag("hidden");
    if (entry.isHidden) entry.present = Value();
}

QString MaskedEntryView::sample() const {
    return flag("hidden") ? QString(text("mask").size(), QChar(0x2022)) : text("mask");
}

} // namespace plc::hmi
