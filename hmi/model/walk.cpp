#include "hmi/model/walk.h"

namespace plc::hmi {

QString Found::place() const {
    QString out = QString::fromStdString(property);
    if (row >= 0) out += u'[' + QString::number(row) + u']';
    if (!field.empty()) out += u'.' + QString::fromStdString(field);
    return out;
}

namespace {

bool isTextKey(const Json& value) { return value.is_string() && value.get_ref<const std::string&>().starts_with("@"); }

void forEachOf(const Properties& properties, const std::function<bool(PropertyType)>& wanted,
               const std::function<void(const Found&)>& visit) {
    const auto give = [&](const PropertyDescriptor& property, const Found& place, const Json& value) {
        const QString text = toQString(value);
        if (text.isEmpty()) return;
        Found found = place;
        found.type = property.type;
        found.text = text;
        found.hint = property.hint;
        visit(found);
    };
    for (const PropertyDescriptor& property : properties.descriptor().properties) {
        const Json& value = properties.at(property.key);
        const Found place{property.type, std::string(property.key), -1, {}, {}, {}};
        const bool isNamed = property.type == PropertyType::Bindings || property.type == PropertyType::Arguments;
        if (wanted(property.type) && !isNamed) give(property, place, value);
        if (property.type == PropertyType::Bindings && wanted(property.type) && value.is_object()) {
            for (const auto& [name, expression] : value.items())
                give(property, {property.type, place.property, -1, name, {}, {}}, expression);
        }
        if (property.type == PropertyType::Arguments && value.is_object())
            for (const auto& [name, argument] : value.items()) {
                // The key of a text is one, whatever the parameter is.
                PropertyDescriptor one = property;
                if (isTextKey(argument)) one.type = PropertyType::Text;
                if (wanted(one.type)) give(one, {one.type, place.property, -1, name, {}, {}}, argument);
            }
        if (property.type != PropertyType::Records || !value.is_array()) continue;
        for (size_t row = 0; row < value.size(); ++row) {
            if (!value[row].is_object()) continue;
            for (const PropertyDescriptor& field : recordFields(property.hint)) {
                if (!wanted(field.type)) continue;
                const auto found = value[row].find(std::string(field.key));
                if (found != value[row].end())
                    give(field, {field.type, place.property, static_cast<int>(row), std::string(field.key), {}, {}},
                         *found);
            }
        }
    }
}

bool isBinding(PropertyType type) {
    return type == PropertyType::Expression || type == PropertyType::Target || type == PropertyType::Bindings ||
           type == PropertyType::Arguments;
}

} // namespace

void forEachBinding(const Properties& properties, const std::function<void(const Found&)>& visit) {
    forEachOf(properties, isBinding, visit);
}

void forEachText(const Properties& properties, const std::function<void(const Found&)>& visit) {
    forEachOf(
        properties, [](PropertyType type) { return type == PropertyType::Text; }, visit);
}

void forEachTextList(const Properties& properties, const std::function<void(const Found&)>& visit) {
    forEachOf(
        properties, [](PropertyType type) { return type == PropertyType::TextList; }, visit);
}

namespace {

void replaceAt(Json& value, const Found& found, const QString& text) {
    if (found.row >= 0)
        value[static_cast<size_t>(found.row)][found.field] = toUtf8(text);
    else if (!found.field.empty())
        value[found.field] = toUtf8(text);
    else
        value = toUtf8(text);
}

void rewriteOne(const Panel& panel, const ElementId& id, const Properties& properties,
                const std::function<std::optional<QString>(const ElementId&, const Found&)>& replace, EditList& out) {
    std::vector<std::pair<std::string, Json>> changed;
    const auto visit = [&](const Found& found) {
        const std::optional<QString> text = replace(id, found);
        if (!text || *text == found.text) return;
        if (changed.empty() || changed.back().first != found.property)
            changed.emplace_back(found.property, properties.at(found.property));
        replaceAt(changed.back().second, found, *text);
    };
    const auto all = [](PropertyType type) {
        return isBinding(type) || type == PropertyType::Text || type == PropertyType::TextList;
    };
    forEachOf(properties, all, visit);
    for (auto& [key, value] : changed) out.edits.push_back(setProperty(panel, id, key, value));
}

} // namespace

Edit rewrite(const Panel& panel, const std::function<std::optional<QString>(const ElementId&, const Found&)>& replace) {
    EditList out;
    rewriteOne(panel, {}, panel, replace, out);
    for (const Element& element : panel.elements()) rewriteOne(panel, element.id(), element, replace, out);
    return {out};
}

} // namespace plc::hmi
