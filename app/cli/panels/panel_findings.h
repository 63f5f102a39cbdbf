// Findings about panels, texts and alarms as the command line prints them. Functions, main thread (fonts are measured).
#pragma once
#include "hmi/player/panel_commands.h"
#include "projects/model/project.h"

#include <iosfwd>

namespace plc::cli {

[[nodiscard]] bool hasPanels(const projects::Project& project);
/// A line each, errors first.
void printFindings(const std::vector<hmi::Finding>& findings, std::ostream& out);
/// One object with file, line, element, property, language, code, severity, message, why, fixable.
[[nodiscard]] std::string renderJson(const hmi::Finding& finding);

} // namespace plc::cli
