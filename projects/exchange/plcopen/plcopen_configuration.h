// <configuration> of PLCopen XML as CONFIGURATION … END_CONFIGURATION: resources, tasks with the settings of CODESYS,
// instances, globals. Functions, any thread.
#pragma once
#include "projects/exchange/base/report.h"
#include "projects/exchange/base/xml.h"

#include <vector>

namespace plc::exchange {

struct ConfigurationText {
    std::string text;
    bool isEmpty = true;               // neither tasks nor instances nor globals
    std::vector<pugi::xml_node> lists; // <globalVars> with a name of their own: lists beside the configuration
};
[[nodiscard]] ConfigurationText configurationText(pugi::xml_node configuration, const XmlFile& file, Report& report);

} // namespace plc::exchange
