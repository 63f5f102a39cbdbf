// What is shown and written: bindings that are missing, writes without limits, critical ones without a question.
#include "hmi/check/standard_parts.h"

#include "hmi/model/errors.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>

namespace plc::hmi {

namespace {

bool isAnyOf(const QString& text, std::initializer_list<const char*> choices) {
    return std::any_of(choices.begin(), choices.end(), [&](const char* one) { return text == QLatin1String(one); });
}

bool writesVariable(const Element& button) {
    return isAnyOf(button.text("action"), {"momentary", "toggle", "set", "reset", "write"});
}

bool isEmptyList(const Element& element, std::string_view key, const char* field) {
    const Json& rows = element.at(key);
    if (!rows.is_array()) return true;
    return std::none_of(rows.begin(), rows.end(), [&](const Json& row) {
        return row.is_object() && row.contains(field) && !toQString(row[field]).isEmpty();
    });
}

/// The property of a button that its action needs and that is empty; none: nothing is missing.
const char* missingOf(const Element& button) {
    const QString action = button.text("action");
    if (writesVariable(button) && button.text("target").isEmpty()) return "target";
    if (action == QStringLiteral("write") && button.text("write").isEmpty()) return "write";
    if (isAnyOf(action, {"panel", "popup"}) && button.text("panel").isEmpty()) return "panel";
    if (action == QStringLiteral("language") && button.text("tag").isEmpty()) return "tag";
    if (action == QStringLiteral("theme") && button.text("theme").isEmpty()) return "theme";
    return nullptr;
}

/// The property without which the element is only a picture of itself; null: it has it.
const char* unboundOf(const Element& element) {
    switch (element.kind()) {
    case ElementKind::Button:
        return missingOf(element);
    case ElementKind::TrendChart:
        return isEmptyList(element, "series", "value") ? "series" : nullptr;
    case ElementKind::LightTower:
        return isEmptyList(element, "lights", "value") ? "lights" : nullptr;
    case ElementKind::ArrayTable:
        return isEmptyList(element, "columns", "value") ? "columns" : nullptr;
    case ElementKind::NavigationBar:
        return isEmptyList(element, "entries", "panel") ? "entries" : nullptr;
    case ElementKind::RecipeTable:
        return element.text("recipe").isEmpty() ? "recipe" : nullptr;
    case ElementKind::XyChart:
        return element.text("y").isEmpty() && element.text("pointY").isEmpty() ? "y" : nullptr;
    case ElementKind::DateTime:
        return nullptr; // the controller's clock
    default:            // by what they show or write
        break;
    }
    if (isDisplay(element)) return element.text("value").isEmpty() ? "value" : nullptr;
    const bool writes = isOperated(element) && element.descriptor().property("target") != nullptr;
    return writes && element.text("target").isEmpty() ? "target" : nullptr;
}

/// Its title as words of a message; forms are pointed to, so they stay.
messages::Phrase titleOf(const Element& element, const char* property) {
    static std::mutex guard;
    static std::map<const char*, messages::Form> forms;
    const char* title = element.descriptor().property(property)->title;
    const std::lock_guard lock(guard);
    return messages::Phrase(forms.try_emplace(title, messages::Form{"Hmi", title, title, nullptr, 0}).first->second);
}

bool isConfirmed(const Element& element) {
    return element.isSet("critical") || !element.text("confirm").trimmed().isEmpty();
}

/// A condition that takes alarms away names the variable.
bool suppressesAlarms(const CheckInput& input, const QString& variable) {
    const QRegularExpression whole(QStringLiteral("(?<![\\w.])%1(?!\\w)").arg(QRegularExpression::escape(variable)),
                                   QRegularExpression::CaseInsensitiveOption);
    return std::any_of(input.alarms.rows().begin(), input.alarms.rows().end(),
                       [&](const Properties& alarm) { return alarm.text("inhibit").contains(whole); });
}

void checkConfirmation(StandardFindings& out, const Element& element) {
    const QString variable = writtenBy(element);
    if (variable.isEmpty() || isConfirmed(element)) return;
    const Edit fix = setProperty(out.panel(), element.id(), "critical", true);
    const QString property = QStringLiteral("critical");
    if (out.input().standard.isCritical(variable))
        out.add(StandardRule::CriticalWithoutConfirmation, element.id(), property,
                errors::CriticalNotConfirmed(toUtf8(variable)), fix);
    else if (!element.text("access").isEmpty())
        out.add(StandardRule::CriticalWithoutConfirmation, element.id(), property,
                errors::RestrictedNotConfirmed(toUtf8(variable), toUtf8(element.text("access"))), fix);
    else if (suppressesAlarms(out.input(), variable))
        out.add(StandardRule::CriticalWithoutConfirmation, element.id(), property,
                errors::SuppressionNotConfirmed(toUtf8(variable)), fix);
}

} // namespace

bool isOperated(const Element& element) {
    static constexpr std::array kinds = {
        ElementKind::Button,        ElementKind::Switch,           ElementKind::RotarySelector, ElementKind::CheckBox,
        ElementKind::RadioGroup,    ElementKind::ComboBox,         ElementKind::Slider,         ElementKind::Knob,
        ElementKind::NumericEntry,  ElementKind::TextEntry,        ElementKind::MaskedEntry,    ElementKind::UserField,
        ElementKind::NavigationBar, ElementKind::LanguageSelector,
    };
    if (element.kind() == ElementKind::CellGrid) return element.text("action") != QStringLiteral("none");
    return std::find(kinds.begin(), kinds.end(), element.kind()) != kinds.end();
}

bool isDisplay(const Element& element) {
    static constexpr std::array kinds = {
        ElementKind::NumericDisplay, ElementKind::Lamp,     ElementKind::MultiState,   ElementKind::Bar,
        ElementKind::TankLevel,      ElementKind::Gauge,    ElementKind::SevenSegment, ElementKind::Progress,
        ElementKind::FloatSwitch,    ElementKind::CellGrid, ElementKind::BarChart,
    };
    return std::find(kinds.begin(), kinds.end(), element.kind()) != kinds.end();
}

QString writtenBy(const Element& element) {
    if (!isOperated(element) || !element.descriptor().property("target")) return {};
    return element.kind() == ElementKind::Button && !writesVariable(element) ? QString() : element.text("target");
}

void checkOperation(StandardFindings& out) {
    for (const Element& element : out.panel().elements()) {
        if (const char* property = unboundOf(element))
            out.add(StandardRule::NothingBound, element.id(), QString::fromLatin1(property),
                    errors::ElementNotBound(titleOf(element, property)));
        if (element.kind() == ElementKind::NumericEntry && !element.text("target").isEmpty())
            for (const char* limit : {"minimum", "maximum"})
                if (element.text(limit).isEmpty())
                    out.add(StandardRule::WriteWithoutLimits, element.id(), QString::fromLatin1(limit),
                            errors::EntryWithoutLimit(toUtf8(element.text("target")), titleOf(element, limit)));
        checkConfirmation(out, element);
    }
}

} // namespace plc::hmi
