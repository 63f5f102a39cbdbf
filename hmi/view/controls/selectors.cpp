#include "hmi/view/controls/selectors.h"

#include "hmi/view/controls/buttons.h"
#include "hmi/view/scene/panel_scene.h"

#include <cmath>
#include <numbers>

namespace plc::hmi {

void OptionsView::setUp() {
    m_target = bindProperty("target");
    m_options.clear();
    m_fromFacts = false;
    const Json& rows = element().at("options");
    if (rows.is_array())
        for (const Json& row : rows) {
            if (!row.is_object()) continue;
            const Properties option(descriptorOf(ElementKind::Unknown), row);
            m_options.push_back({{}, bindExpression(option.text("value")), option.text("text"), option.text("value")});
        }
    const ValueFacts known = facts(m_target);
    if (m_options.empty()) {
        m_fromFacts = true;
        for (const auto& one : known.enumValues) m_options.push_back({Value::ofInteger(one.number), {}, {}, one.name});
    }
    if (m_options.empty() && !text("list").isEmpty()) {
        const int length = scene().texts().table().listLength(text("list"));
        for (int i = 0; i < length; ++i) m_options.push_back({Value::ofInteger(i), {}, {}, {}});
    }
    if (m_options.empty())
        for (int i = 0; i < 3; ++i) m_options.push_back({Value::ofInteger(i), {}, {}, QString::number(i)});
}

Value OptionsView::optionValue(size_t index) const {
    const Option& option = m_options[index];
    return option.slot.isBound() ? value(option.slot) : option.value;
}

bool OptionsView::update() {
    const Value now = echoed(m_target);
    int selected = -1;
    for (size_t i = 0; i < m_options.size() && !now.isNone(); ++i) {
        const Value other = optionValue(i);
        const bool same = now.kind() == ValueKind::Text ? now.text() == other.text()
                                                        : !other.isNone() && now.toNumber() == other.toNumber();
        if (same) selected = static_cast<int>(i);
    }
    if (now.isNone() && isDesigning()) selected = 0;
    return std::exchange(m_selected, selected) != selected;
}

QString OptionsView::optionText(size_t index, const QString& forTag) const {
    const Option& option = m_options[index];
    if (!option.text.isEmpty()) return shown(option.text, forTag);
    const QString fromList = scene().texts().listText(
        text("list"), optionValue(index).isNone() ? static_cast<qint64>(index) : optionValue(index).toInteger(),
        forTag);
    return fromList.isEmpty() ? option.name : fromList;
}

QByteArray OptionsView::optionPlace(size_t index) const {
    return m_options[index].text.isEmpty() ? QByteArray("list")
                                           : "options[" + QByteArray::number(static_cast<int>(index)) + "].text";
}

void OptionsView::choose(size_t index) {
    if (index >= m_options.size() || !m_target.isBound()) return;
    const Value chosen = optionValue(index);
    write(expression(m_target), chosen);
    echo(chosen);
}

// ---- rotary selector

QPointF RotarySelectorView::center() const { return {width() / 2, height() * 0.58}; }

double RotarySelectorView::radius() const { return std::min(width() * 0.26, height() * 0.3); }

double RotarySelectorView::angleOf(size_t index) const {
    const size_t count = m_options.size();
    if (count < 2) return 0;
    const double span = std::min(270.0, 60.0 * static_cast<double>(count - 1));
    return -span / 2 + span * static_cast<double>(index) / static_cast<double>(count - 1);
}

TextBox RotarySelectorView::label(size_t index, const QString& forTag) const {
    const double angle = angleOf(index) * std::numbers::pi / 180;
    const double size = num("fontSize");
    const QPointF tip = center() + QPointF(std::sin(angle), -std::cos(angle)) * (radius() + 9);
    const bool isLeft = angle<-0.26, isRight = angle> 0.26;
    const double half = size * 0.75;
    QRectF area(0, tip.y() - half, width(), 2 * half);
    if (isLeft)
        area.setRight(tip.x());
    else if (isRight)
        area.setLeft(tip.x());
    else
        area.moveBottom(tip.y() + 2);
    TextBox out = textBox(optionText(index, forTag), area, size,
                          isLeft    ? TextAlign::End
                          : isRight ? TextAlign::Start
                                    : TextAlign::Center,
                          optionPlace(index).constData(), false, forTag);
    out.rightToLeft = false; // the side of the knob decides, not the script
    return out;
}

void RotarySelectorView::release(QPointF at, bool inside) {
    if (!inside || m_options.empty()) return;
    const QPointF from = at - center();
    if (std::hypot(from.x(), from.y()) < radius() * 0.5)
        return choose((static_cast<size_t>(std::max(0, m_selected)) + 1) % m_options.size());
    const double angle = std::atan2(from.x(), -from.y()) * 180 / std::numbers::pi;
    size_t best = 0;
    for (size_t i = 0; i < m_options.size(); ++i)
        if (std::abs(angleOf(i) - angle) < std::abs(angleOf(best) - angle)) best = i;
    choose(best);
}

void RotarySelectorView::draw(QPainter& painter) {
    const QPointF c = center();
    const double r = radius();
    for (size_t i = 0; i < m_options.size(); ++i) {
        const double angle = angleOf(i) * std::numbers::pi / 180;
        const QPointF out(std::sin(angle), -std::cos(angle));
        const bool isChosen = static_cast<int>(i) == m_selected;
        painter.setPen(
            QPen(isChosen ? stateColor(theme().color("accent")) : theme().color("line"), isChosen ? 3 : 1.5));
        painter.drawLine(c + out * (r + 2), c + out * (r + 7));
        painter.setPen(isChosen ? inkColor(theme().color("text")) : theme().color("muted"));
        TextBox words = label(i, tag());
        if (isChosen) words.font.setBold(true);
        drawText(painter, words);
    }
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1.2));
    painter.setBrush(theme().color("raised"));
    painter.drawEllipse(c, r, r);
    painter.setBrush(theme().color("button"));
    painter.drawEllipse(c, r * 0.86, r * 0.86);
    painter.save();
    painter.translate(c);
    painter.rotate(m_selected >= 0 ? angleOf(static_cast<size_t>(m_selected)) : 0);
    const double w = r * 0.36;
    const QColor handle = theme().isDark() ? theme().color("off").darker(115) : theme().color("line");
    painter.setPen(QPen(theme().color("line"), 1.2));
    painter.setBrush(isPressed() ? handle.darker(115) : handle);
    painter.drawRoundedRect(QRectF(-w / 2, -r * 0.94, w, r * 1.88), w / 2, w / 2);
    painter.setPen(QPen(m_selected >= 0 ? QColor(Qt::white) : theme().color("low"), 3, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(0, -r * 0.8), QPointF(0, -r * 0.45));
    painter.restore();
}

void RotarySelectorView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    for (size_t i = 0; i < m_options.size(); ++i) out.push_back(label(i, forTag));
}

// ---- radio group

QRectF RadioGroupView::cell(size_t index) const {
    const size_t columns = static_cast<size_t>(std::max(1, element().integer("columns")));
    const size_t rows = std::max<size_t>(1, (m_options.size() + columns - 1) / columns);
    const double w = width() / static_cast<double>(columns), h = height() / static_cast<double>(rows);
    size_t column = index % columns;
    if (isRightToLeft(tag())) column = columns - 1 - column;
    return {static_cast<double>(column) * w, static_cast<double>(index / columns) * h, w, h};
}

TextBox RadioGroupView::label(size_t index, const QString& forTag) const {
    const QRectF area = cell(index);
    const double used = std::min(area.height() - 4, num("fontSize") * 1.5) + 10;
    const QRectF rest = isRightToLeft(forTag) ? area.adjusted(0, 0, -used, 0) : area.adjusted(used, 0, 0, 0);
    return textBox(optionText(index, forTag), rest, num("fontSize"), TextAlign::Start, optionPlace(index).constData(),
                   false, forTag);
}

void RadioGroupView::release(QPointF at, bool inside) {
    if (!inside) return;
    for (size_t i = 0; i < m_options.size(); ++i)
        if (cell(i).contains(at)) return choose(i);
}

void RadioGroupView::draw(QPainter& painter) {
    for (size_t i = 0; i < m_options.size(); ++i) {
        const QRectF area = cell(i);
        const double d = std::min(area.height() - 4, num("fontSize") * 1.5);
        const QPointF c(isRightToLeft(tag()) ? area.right() - d / 2 - 2 : area.left() + d / 2 + 2, area.center().y());
        const bool isChosen = static_cast<int>(i) == m_selected;
        painter.setPen(
            QPen(isChosen ? stateColor(theme().color("accent")) : theme().color("line"), isChosen ? 2.5 : 1.5));
        painter.setBrush(theme().color("inset"));
        painter.drawEllipse(c, d / 2 - 1, d / 2 - 1);
        if (isChosen) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(stateColor(theme().color("accent")));
            painter.drawEllipse(c, d * 0.26, d * 0.26);
        }
        painter.setPen(inkColor(theme().color("text")));
        drawText(painter, label(i, tag()));
    }
}

void RadioGroupView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    for (size_t i = 0; i < m_options.size(); ++i) out.push_back(label(i, forTag));
}

// ---- combo box

TextBox ComboBoxView::label(const QString& words, const QByteArray& place, const QString& forTag) const {
    const QRectF area = isRightToLeft(forTag) ? box().adjusted(34, 2, -10, -2) : box().adjusted(10, 2, -34, -2);
    return textBox(words, area, num("fontSize"), TextAlign::Start, place.constData(), false, forTag);
}

void ComboBoxView::release(QPointF, bool inside) {
    if (!inside || !m_target.isBound()) return;
    ChoiceRequest choice;
    choice.element = element().id();
    choice.target = expression(m_target);
    for (size_t i = 0; i < m_options.size(); ++i) {
        choice.texts += optionText(i, tag());
        choice.values.push_back(optionValue(i));
    }
    choice.present = m_selected;
    choice.place = rect();
    scene().request(choice);
}

void ComboBoxView::draw(QPainter& painter) {
    drawKey(painter, box(), 5, theme().color("inset"), isPressed(), theme());
    const double x = isRightToLeft(tag()) ? 18 : width() - 18, y = height() / 2;
    painter.setPen(QPen(theme().color("text"), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF{QPointF(x - 5, y - 2.5), QPointF(x, y + 2.5), QPointF(x + 5, y - 2.5)});
    painter.setPen(inkColor(theme().color("text")));
    const QString words = m_selected >= 0             ? optionText(static_cast<size_t>(m_selected), tag())
                          : echoed(m_target).isNone() ? QStringLiteral("– –")
                                                      : formatValue(echoed(m_target), {}, locale());
    drawText(painter, label(words, {}, tag()));
}

void ComboBoxView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    for (size_t i = 0; i < m_options.size(); ++i) out.push_back(label(optionText(i, forTag), optionPlace(i), forTag));
}

// ---- language selector

QStringList LanguageSelectorView::tags() const { return scene().texts().settings().languages; }

QString LanguageSelectorView::nameOf(const QString& one) const {
    if (text("names") == QStringLiteral("tag") || (m_short && text("style") != QStringLiteral("menu"))) {
        // The region tells languages apart that share their first part.
        int alike = 0;
        for (const QString& other : tags())
            alike += other.section(u'-', 0, 0).compare(one.section(u'-', 0, 0), Qt::CaseInsensitive) == 0;
        return (alike > 1 ? one : one.section(u'-', 0, 0)).toUpper();
    }
    return nativeName(one);
}

void LanguageSelectorView::setUp() {
    // Where one of the names has no room, all are shown by their tags.
    m_short = false;
    if (text("style") == QStringLiteral("menu")) return;
    bool tooLong = false;
    for (qsizetype i = 0; i < tags().size(); ++i) tooLong |= !fits(label(i));
    m_short = tooLong;
}

QRectF LanguageSelectorView::cell(qsizetype index) const {
    if (text("style") == QStringLiteral("menu")) return box();
    const double w = width() / static_cast<double>(std::max<qsizetype>(1, tags().size()));
    if (isRightToLeft(tag())) index = tags().size() - 1 - index; // the first one stands where reading begins
    return QRectF(static_cast<double>(index) * w, 0, w, height())
        .adjusted(index ? 2 : 0, 0, index + 1 < tags().size() ? -2 : 0, 0);
}

TextBox LanguageSelectorView::label(qsizetype index) const {
    const bool menu = text("style") == QStringLiteral("menu");
    const QString one = tags().value(index);
    return textBox(nameOf(one), menu ? box().adjusted(34, 2, -28, -2) : cell(index).adjusted(3, 2, -3, -2),
                   num("fontSize"), menu ? TextAlign::Start : TextAlign::Center, "names", false, one);
}

void LanguageSelectorView::release(QPointF at, bool inside) {
    if (!inside) return;
    if (text("style") != QStringLiteral("menu")) {
        for (qsizetype i = 0; i < tags().size(); ++i)
            if (cell(i).contains(at)) return scene().requestLanguage(tags()[i]);
        return;
    }
    ChoiceRequest choice;
    choice.element = element().id();
    choice.isLanguage = true;
    for (const QString& one : tags()) {
        choice.texts += nameOf(one);
        choice.values.push_back(Value::ofText(one));
    }
    choice.present = static_cast<int>(tags().indexOf(scene().language()));
    choice.place = rect();
    scene().request(choice);
}

void LanguageSelectorView::draw(QPainter& painter) {
    const bool menu = text("style") == QStringLiteral("menu");
    for (qsizetype i = 0; i < tags().size(); ++i) {
        const bool isChosen = tags()[i].compare(scene().language(), Qt::CaseInsensitive) == 0;
        if (menu && !isChosen) continue;
        const QColor ground = !menu && isChosen ? stateColor(theme().color("accent")) : theme().color("button");
        drawKey(painter, cell(i), 5, ground, isPressed() && menu, theme());
        painter.setPen(PanelTheme::inkOn(ground));
        drawText(painter, label(i));
        if (!menu) continue;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(PanelTheme::inkOn(ground), 1.3));
        const QPointF c(19, height() / 2); // a globe says what the list is, in any language
        painter.drawEllipse(c, 9, 9);
        painter.drawEllipse(c, 4, 9);
        painter.drawLine(c - QPointF(9, 0), c + QPointF(9, 0));
        const double x = width() - 16, y = height() / 2;
        painter.drawPolyline(QPolygonF{QPointF(x - 4, y - 2), QPointF(x, y + 2), QPointF(x + 4, y - 2)});
    }
}

void LanguageSelectorView::collectTexts(const QString&, std::vector<TextBox>& out) const {
    for (qsizetype i = 0; i < tags().size(); ++i) out.push_back(label(i));
}

} // namespace plc::hmi
