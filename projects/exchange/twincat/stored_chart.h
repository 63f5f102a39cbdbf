// SFC as TwinCAT and CODESYS V3 store it, segments of steps, transitions, branches and jumps in an archive of objects,
// as the body of a PLCopen chart, which the reader of charts knows. Function, any thread.
#pragma once
#include "projects/exchange/twincat/archive.h"

namespace plc::exchange {

/// `archive` holds the chart somewhere below it: an <SFC> of TwinCAT. The body is an <SFC>.
[[nodiscard]] ArchiveBody readStoredChart(pugi::xml_node archive);

} // namespace plc::exchange
