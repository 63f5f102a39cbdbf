#include "projects/exchange/twincat/archive.h"

#include "runtime/base/text.h"

#include <cstdlib>

namespace plc::exchange::archive {

pugi::xml_node memberOf(pugi::xml_node object, std::string_view name) {
    for (const pugi::xml_node child : object.children())
        if (name == child.attribute("n").value() && localName(child) != "n") return child;
    return {};
}

std::string valueOf(pugi::xml_node object, std::string_view name) {
    std::string text = trimmed(textOf(memberOf(object, name)));
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return text;
}

bool isTrueIn(pugi::xml_node object, std::string_view name) {
    return equalsIgnoringCase(valueOf(object, name), "true");
}

std::vector<Element> elementsOf(pugi::xml_node list) {
    std::vector<Element> out;
    const std::string common = attribute(list, "cet");
    for (const pugi::xml_node child : list.children()) {
        if (child.type() != pugi::node_element) continue;
        const std::string own = attribute(child, "t");
        out.push_back({localName(child) == "n" ? pugi::xml_node() : child, own.empty() ? common : own});
    }
    return out;
}

std::vector<Element> elementsIn(pugi::xml_node object, std::string_view name) {
    return elementsOf(memberOf(memberOf(object, name), "InnerList"));
}

pugi::xml_node objectOf(pugi::xml_node node, std::string_view type) {
    if (type == node.attribute("t").value()) return node;
    for (const pugi::xml_node child : node.children()) // the depth of the document is bounded
        if (const pugi::xml_node found = objectOf(child, type)) return found;
    return {};
}

long long numberOf(pugi::xml_node object, std::string_view name) {
    return std::strtoll(valueOf(object, name).c_str(), nullptr, 10);
}

} // namespace plc::exchange::archive
