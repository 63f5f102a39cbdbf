// Macro steps of an SFC graph: a step that stands for a chart of its own becomes the steps of that chart, in place.
// Function, any thread.
#pragma once
#include "projects/exchange/base/report.h"
#include "projects/exchange/base/xml.h"

namespace plc::exchange {

/// Changes `sfc`; each macro step has its line in the report. One without a chart stays.
void expandMacroSteps(pugi::xml_node sfc, const XmlFile& file, const std::string& unit, Report& report);

} // namespace plc::exchange
