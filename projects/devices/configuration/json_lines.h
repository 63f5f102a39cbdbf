// On which line of a JSON text each value is, by its path ("/devices/0/name"). The text has been read before and is
// good JSON. Function, any thread.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace plc::devices {

[[nodiscard]] std::map<std::string, int> linesOfJson(std::string_view text);

} // namespace plc::devices
