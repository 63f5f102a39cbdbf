// An SFC graph of PLCopen XML as textual SFC: steps with their actions, transitions between steps whose divergences and
// jumps are resolved. One use per body, any thread.
#pragma once
#include "projects/exchange/graphs/diagram.h"

#include <nlohmann/json.hpp>

namespace plc::exchange {

struct ChartText {
    std::string text;
    std::vector<std::pair<std::string, std::string>> actions;   // name, statements: of actions written inside the chart
    std::vector<std::pair<std::string, std::string>> variables; // of conditions drawn as diagrams
    nlohmann::ordered_json positions = nlohmann::ordered_json::object(); // step → [x, y]
};

/// `transitions`: the unit's named transitions, folded name → condition.
[[nodiscard]] ChartText chartText(pugi::xml_node sfc, const XmlFile& file, const std::string& unit,
                                  const std::map<std::string, std::string>& transitions, const DiagramNames& names,
                                  Report& report);
/// "a AND b" of "Name := a AND b;".
[[nodiscard]] std::string conditionOf(const std::string& statements);

} // namespace plc::exchange
