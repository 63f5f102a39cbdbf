// The elements of a diagram in PLCopen XML by their ids: what is connected with what, how often an output is used, in
// which order the boxes run. A view of the document; one use per body.
#pragma once
#include "projects/exchange/base/xml.h"

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace plc::exchange {

[[nodiscard]] bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words);

class DiagramGraph {
public:
    explicit DiagramGraph(pugi::xml_node body);

    [[nodiscard]] static std::string idOf(pugi::xml_node node) { return attribute(node, "localId"); }
    [[nodiscard]] static bool isBlockInstance(pugi::xml_node block) {
        return !attribute(block, "instanceName").empty();
    }
    [[nodiscard]] static pugi::xml_node pin(pugi::xml_node block, const char* list, std::string_view name);
    [[nodiscard]] static bool isConnected(pugi::xml_node holder);

    [[nodiscard]] pugi::xml_node find(const std::string& id) const;
    [[nodiscard]] pugi::xml_node connectorNamed(const std::string& name) const;
    [[nodiscard]] bool isUsedTwice(pugi::xml_node block, const std::string& pinName) const;
    /// Another one than ENO.
    [[nodiscard]] bool hasUsedOutput(pugi::xml_node block) const;
    /// The order of execution: by number where the file gives one, else from top to bottom and left to right; tools
    /// that store no positions store the networks in their order.
    [[nodiscard]] std::vector<pugi::xml_node> inOrder() const;

    const pugi::xml_node body;

private:
    void countUses(pugi::xml_node node);

    std::map<std::string, pugi::xml_node> m_nodes, m_connectors;
    std::map<std::string, int> m_uses; // of "id" and "id:pin"
};

} // namespace plc::exchange
