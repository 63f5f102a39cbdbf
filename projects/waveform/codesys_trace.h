// What CODESYS 3.5 and the tools built on it save of a trace: *.trace.csv (keys and values, then a block of samples for
// each variable) and *.trace (XML with the configuration and the samples). Functions, any thread.
#pragma once
#include "projects/waveform/table.h"

namespace plc::waveform {

[[nodiscard]] bool isCodesysTraceCsv(const std::string& text);
[[nodiscard]] Result<Table> parseCodesysTraceCsv(const std::string& text);
[[nodiscard]] bool isCodesysTraceXml(const std::string& text);
[[nodiscard]] Result<Table> parseCodesysTraceXml(const std::string& text);

} // namespace plc::waveform
