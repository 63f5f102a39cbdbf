#include "projects/exchange/plcopen/standard_nodes.h"

namespace plc::exchange {

pugi::xml_node StandardNodes::add(pugi::xml_node parent, const char* name, pugi::xml_node source) {
    pugi::xml_node node = parent.append_child(name);
    m_to.setLine(node, m_from.lineOf(source));
    return node;
}

void StandardNodes::addText(pugi::xml_node parent, const char* name, pugi::xml_node source, const std::string& text) {
    add(parent, name, source).append_child(pugi::node_pcdata).set_value(text.c_str());
}

void StandardNodes::set(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

void StandardNodes::take(pugi::xml_node node, const char* name, pugi::xml_node source) {
    if (const pugi::xml_attribute found = source.attribute(name)) set(node, name, found.value());
}

void StandardNodes::addDocumentation(pugi::xml_node to, pugi::xml_node source) {
    if (const std::string text = trimmed(textOf(childOf(source, "Documentation"))); !text.empty())
        addText(to, "documentation", source, text);
}

void StandardNodes::leaveOut(pugi::xml_node source, const std::string& what) {
    if (m_leftOut.insert(what).second)
        m_report.add(m_from.place() + ":" + std::to_string(m_from.lineOf(source)), remarks::ElementNotRead(what));
}

std::string schemaType(pugi::xml_node node) {
    for (const pugi::xml_attribute each : node.attributes()) {
        const std::string_view name = each.name();
        if (name != "type" && !name.ends_with(":type")) continue;
        const std::string_view value = each.value();
        const size_t colon = value.rfind(':');
        return std::string(colon == std::string_view::npos ? value : value.substr(colon + 1));
    }
    return {};
}

} // namespace plc::exchange
