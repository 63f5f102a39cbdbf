#include "hmi/check/property_fix.h"

#include <QRegularExpression>

#include <cmath>

namespace plc::hmi {

namespace {

/// "states[2].color".
struct Place {
    std::string field;
    std::optional<size_t> row;
    std::string key; // in the row
};

Place parsed(const QString& place) {
    static const QRegularExpression inRow(QStringLiteral(R"(^(\w+)\[(\d+)\]\.(\w+)$)"));
    const QRegularExpressionMatch match = inRow.match(place);
    if (!match.hasMatch()) return {toUtf8(place), std::nullopt, {}};
    return {toUtf8(match.captured(1)), match.captured(2).toUInt(), toUtf8(match.captured(3))};
}

const Properties* find(const Panel& panel, const ElementId& element) {
    if (element.isEmpty()) return &panel;
    return panel.find(element);
}

/// The list with one row changed.
template <class Change> Edit inRow(const Panel& panel, const ElementId& element, const Place& at, Change change) {
    const Properties* properties = find(panel, element);
    Json rows = properties ? properties->at(at.field) : Json();
    if (!rows.is_array() || *at.row >= rows.size() || !rows[*at.row].is_object()) return {};
    change(rows[*at.row]);
    return {SetField{element, at.field, std::move(rows), {}}};
}

/// As edits that are no lists themselves.
void flatten(const Edit& edit, std::vector<Edit>& out) {
    if (const auto* list = std::get_if<EditList>(&edit.what))
        for (const Edit& one : list->edits) flatten(one, out);
    else
        out.push_back(edit);
}

} // namespace

Edit valueAt(const Panel& panel, const ElementId& element, const QString& place, const Json& value) {
    const Place at = parsed(place);
    if (!at.row) return setProperty(panel, element, at.field, value);
    return inRow(panel, element, at, [&](Json& row) { row[at.key] = value; });
}

Edit nameAt(const Panel& panel, const ElementId& element, const QString& place, const std::string& name) {
    const Place at = parsed(place);
    if (at.row)
        return inRow(panel, element, at, [&](Json& row) {
            if (row.contains(name)) return;
            Json renamed = Json::object(); // at its place among the others
            for (const auto& [key, value] : row.items()) renamed[key == at.key ? name : key] = value;
            row = std::move(renamed);
        });
    const Properties* properties = find(panel, element);
    if (!properties || !properties->has(at.field) || properties->has(name)) return {};
    return {EditList{{{SetField{element, at.field, std::nullopt, {}}},
                      {SetField{element, name, properties->fields().at(at.field), {}}}}}};
}

std::optional<Json> asType(PropertyType type, const Json& value) {
    const QString text = toQString(value).trimmed();
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    switch (type) {
    case PropertyType::Bool:
        for (const bool one : {false, true})
            if (text.compare(QLatin1String(one ? "true" : "false"), Qt::CaseInsensitive) == 0) return one;
        return std::nullopt;
    case PropertyType::Integer:
        if (!value.is_string() || !isNumber || number != std::floor(number) || std::abs(number) > 1e9)
            return std::nullopt;
        return static_cast<int64_t>(number);
    case PropertyType::Number:
        return value.is_string() && isNumber && std::isfinite(number) ? std::optional<Json>(number) : std::nullopt;
    case PropertyType::Text:
    case PropertyType::String:
    case PropertyType::Expression:
        if (!value.is_number() && !value.is_boolean()) return std::nullopt;
        return Json(value.dump());
    default: // what is wrong there has more than one remedy
        return std::nullopt;
    }
}

Edit together(const Panel& panel, const std::vector<Edit>& fixes) {
    std::vector<Edit> all, flat;
    for (const Edit& one : fixes) flatten(one, flat);
    for (const Edit& one : flat) {
        const auto* field = std::get_if<SetField>(&one.what);
        const Properties* properties = field ? find(panel, field->element) : nullptr;
        const Json base = properties ? properties->at(field->key) : Json();
        const auto known = std::find_if(all.begin(), all.end(), [&](const Edit& other) {
            const auto* before = std::get_if<SetField>(&other.what);
            return before && field && before->element == field->element && before->key == field->key && before->value &&
                   field->value && base.is_array();
        });
        if (known == all.end()) {
            all.push_back(one);
            continue;
        }
        std::optional<Json>& value = std::get<SetField>(known->what).value;
        value = value->patch(Json::diff(base, *field->value));
    }
    return {EditList{std::move(all)}};
}

} // namespace plc::hmi
