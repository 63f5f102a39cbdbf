// Textual SFC as the graph of PLCopen XML: steps, transitions, divergences, and a jump for every further way into a
// step. Function, any thread.
#pragma once
#include "projects/exchange/plcopen/xml_writer.h"

#include <nlohmann/json.hpp>

namespace plc::exchange {

/// `positions`: step → [x, y] of an earlier import; others are laid out below each other.
void writeChart(pugi::xml_node sfc, const syntax::SfcBody& body, const nlohmann::ordered_json& positions,
                const XmlWriter& writer);

} // namespace plc::exchange
