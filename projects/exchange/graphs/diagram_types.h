// The types of a diagram's wires as far as they can be known without the checker, and the functions that are operators
// in ST. A view of a graph; one use per body.
#pragma once
#include "projects/exchange/graphs/diagram_graph.h"

#include <map>
#include <string>

namespace plc::exchange {

struct Operator {
    std::string_view function, word;
    int level; // of Flow
};
/// Null: a call.
[[nodiscard]] const Operator* operatorOf(std::string_view function);
[[nodiscard]] std::string functionOf(const Operator& op); // "EQ" of =
[[nodiscard]] bool isComparison(const Operator& op);

class DiagramTypes {
public:
    using Names = std::map<std::string, std::string>; // folded → type as written

    DiagramTypes(const DiagramGraph& graph, const Names& variables, const Names& results)
        : m_graph(graph), m_variables(variables), m_results(results) {}

    /// Of an output; "" when it cannot be known.
    [[nodiscard]] std::string of(pugi::xml_node node, const std::string& pinName, int depth = 0) const;

private:
    [[nodiscard]] std::string atPoint(pugi::xml_node point, int depth) const;
    [[nodiscard]] std::string ofBlock(pugi::xml_node node, const std::string& pinName, int depth) const;
    [[nodiscard]] std::string ofFunction(pugi::xml_node block, int depth) const;
    [[nodiscard]] std::string ofText(const std::string& text) const;

    const DiagramGraph& m_graph;
    const Names &m_variables, &m_results;
    mutable std::map<std::string, std::string> m_known; // of blocks, by id and pin
};

} // namespace plc::exchange
