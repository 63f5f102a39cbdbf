// Texts out of a project and back, for translators: which file is which, where each text is used, what came of it.
// Functions; main thread.
#pragma once
#include "hmi/station/panel_project.h"
#include "hmi/texts/xliff.h"

namespace plc::hmi {

/// By key, where panels and alarms show it: "main: button1.text"; lists by each of their keys.
QMap<QString, QStringList> placesOfTexts(const PanelProject& project);

/// One line for the whole, then the remarks: "12 texts taken, 3 as they were, 1 without a translation".
std::string reportText(const XliffReport& report);

} // namespace plc::hmi
