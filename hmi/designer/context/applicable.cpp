#include "hmi/designer/context/applicable.h"

#include <algorithm>

namespace plc::hmi {

namespace {

/// `property` of a kind has an effect only while `by` is one of the values.
struct Rule {
    ElementKind kind;
    std::string_view property, by;
    std::vector<std::string_view> values;
};

const std::vector<Rule>& rules() {
    static const std::vector<std::string_view> writing{"momentary", "toggle", "set", "reset", "write"};
    static const std::vector<Rule> all{
        {ElementKind::Button, "target", "action", writing},
        {ElementKind::Button, "confirm", "action", writing},
        {ElementKind::Button, "write", "action", {"write"}},
        {ElementKind::Button, "panel", "action", {"panel", "popup"}},
        {ElementKind::Button, "arguments", "action", {"panel", "popup"}},
        {ElementKind::Button, "tag", "action", {"language"}},
        {ElementKind::Button, "theme", "action", {"theme"}},
        {ElementKind::CellGrid, "target", "action", {"toggle", "select"}},
        {ElementKind::Group, "columns", "layout", {"grid"}},
        {ElementKind::Group, "cellWidth", "layout", {"grid"}},
        {ElementKind::Group, "gap", "layout", {"row", "column", "either", "grid"}},
        {ElementKind::Group, "padding", "layout", {"row", "column", "either", "grid"}},
        {ElementKind::Group, "across", "layout", {"row", "column", "either"}},
        {ElementKind::DateTime, "seconds", "shows", {"dateTime", "time"}},
    };
    return all;
}

} // namespace

bool isApplicable(const Element& element, std::string_view property) {
    for (const Rule& rule : rules())
        if (rule.kind == element.kind() && rule.property == property) {
            const std::string now = toUtf8(element.text(rule.by));
            return std::find(rule.values.begin(), rule.values.end(), now) != rule.values.end();
        }
    return true;
}

std::vector<const PropertyDescriptor*> mainBindings(const Element& element) {
    std::vector<const PropertyDescriptor*> out;
    const bool isGround =
        element.descriptor().category == ElementCategory::Shapes && element.kind() != ElementKind::Pipe;
    if (isGround || element.isContainer()) return out;
    for (const std::string_view key : {"target", "value", "state", "flow", "level", "y", "pointY"})
        if (const PropertyDescriptor* found = element.descriptor().property(key); found && isApplicable(element, key))
            if (found->type == PropertyType::Target || found->type == PropertyType::Expression) out.push_back(found);
    return out;
}

} // namespace plc::hmi
