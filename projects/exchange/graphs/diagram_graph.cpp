#include "projects/exchange/graphs/diagram_graph.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <tuple>

namespace plc::exchange {

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return equalsIgnoringCase(w, word); });
}

DiagramGraph::DiagramGraph(pugi::xml_node diagram) : body(diagram) {
    for (const pugi::xml_node node : body.children()) {
        if (const std::string id = idOf(node); !id.empty()) m_nodes.emplace(id, node);
        if (is(node, "connector")) m_connectors.emplace(attribute(node, "name"), node);
    }
    for (const pugi::xml_node node : body.children()) countUses(node);
}

void DiagramGraph::countUses(pugi::xml_node node) {
    for (const pugi::xml_node child : node.children()) {
        if (is(child, "connection"))
            ++m_uses[attribute(child, "refLocalId") + ":" + attribute(child, "formalParameter")];
        countUses(child);
    }
}

pugi::xml_node DiagramGraph::find(const std::string& id) const {
    const auto it = m_nodes.find(id);
    return it == m_nodes.end() ? pugi::xml_node() : it->second;
}

pugi::xml_node DiagramGraph::connectorNamed(const std::string& name) const {
    const auto it = m_connectors.find(name);
    return it == m_connectors.end() ? pugi::xml_node() : it->second;
}

pugi::xml_node DiagramGraph::pin(pugi::xml_node block, const char* list, std::string_view name) {
    for (const pugi::xml_node variable : childOf(block, list).children())
        if (equalsIgnoringCase(attribute(variable, "formalParameter"), name)) return variable;
    return {};
}

bool DiagramGraph::isConnected(pugi::xml_node holder) {
    return static_cast<bool>(childOf(childOf(holder, "connectionPointIn"), "connection"));
}

bool DiagramGraph::isUsedTwice(pugi::xml_node block, const std::string& pinName) const {
    const auto it = m_uses.find(idOf(block) + ":" + pinName);
    return it != m_uses.end() && it->second > 1;
}

bool DiagramGraph::hasUsedOutput(pugi::xml_node block) const {
    const std::string prefix = idOf(block) + ":";
    const auto it = m_uses.lower_bound(prefix);
    for (auto each = it; each != m_uses.end() && each->first.starts_with(prefix); ++each)
        if (!equalsIgnoringCase(each->first.substr(prefix.size()), "ENO")) return true;
    return false;
}

std::vector<pugi::xml_node> DiagramGraph::inOrder() const {
    struct Row {
        pugi::xml_node node;
        int order, y, x;
    };
    std::vector<Row> rows;
    for (const pugi::xml_node node : body.children()) {
        const std::string_view kind = localName(node);
        if (!isOneOf(kind, {"block", "outVariable", "inOutVariable", "coil", "label", "comment", "jump", "return"}))
            continue;
        const pugi::xml_node position = childOf(node, "position");
        const int order = std::atoi(attribute(node, "executionOrderId").c_str());
        rows.push_back({node, order > 0 ? order : INT32_MAX, position.attribute("y").as_int() / 10,
                        position.attribute("x").as_int()});
    }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return std::tie(a.order, a.y, a.x) < std::tie(b.order, b.y, b.x);
    });
    std::vector<pugi::xml_node> out;
    for (const Row& row : rows) out.push_back(row.node);
    return out;
}

} // namespace plc::exchange
