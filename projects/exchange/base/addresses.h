// Direct addresses on their way to other tools, which count %MW1 in words: a project that counts bytes is rewritten for
// the export. Functions, any thread.
#pragma once
#include "projects/exchange/base/report.h"

#include <string>
#include <string_view>

namespace plc::exchange {

/// Whether a text has an address whose number depends on the way of counting: %MW1, %ID4, not %MB1 or %IX0.1.
[[nodiscard]] bool hasCountedAddress(std::string_view text);
/// %MW4, counted in bytes, as %MW2; one of an odd byte stays and has a line in the report.
[[nodiscard]] std::string addressesInWords(std::string_view text, const std::string& path, Report& report);

} // namespace plc::exchange
