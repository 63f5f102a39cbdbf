// LD and FBD of PLCopen XML as statements of ST, by the table of docs/ladder.md: series is AND, parallel is OR, a box
// with EN an IF, a block its call before the statement that reads its outputs. One use per body, any thread.
#pragma once
#include "projects/exchange/base/report.h"
#include "projects/exchange/base/xml.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace plc::exchange {

/// What the converter must know of the names that a diagram uses.
struct DiagramNames {
    std::map<std::string, std::string> variableTypes; // folded name → type as written; of the unit
    std::map<std::string, std::string> resultTypes;   // folded name of a function of the project → its type
    bool isFunction = false;                          // no state between calls
};

struct DiagramText {
    std::string statements;
    std::vector<std::pair<std::string, std::string>> variables; // name, type: to be declared beside the unit's own
};

class Diagram {
public:
    Diagram(pugi::xml_node body, const XmlFile& file, std::string unit, const DiagramNames& names, Report& report);
    ~Diagram();
    Diagram(const Diagram&) = delete;
    /// All networks, in their order of execution.
    [[nodiscard]] DiagramText statements();
    /// What arrives at a <connectionPointIn>: the condition of a transition drawn as a diagram.
    [[nodiscard]] std::string expressionAt(pugi::xml_node connectionPointIn);
    /// Statements that the expressions so far need: calls of blocks, edges. Empty: none.
    [[nodiscard]] std::string pendingStatements() const;
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> variables() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace plc::exchange
