// Writes realistic programs of a wanted size: stations with timers, counters, a step machine, scaling functions,
// recipes and alarms, called from one main program. The same size gives the same text.
#pragma once
#include <cstddef>
#include <string>

namespace plc::bench {

/// About `lines` lines of ST, in one text.
[[nodiscard]] std::string generateProgram(size_t lines);

} // namespace plc::bench
