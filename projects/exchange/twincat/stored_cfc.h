// CFC as TwinCAT and CODESYS V3 store it, boxes, variables and lines in an archive of objects, as the body of a
// PLCopen diagram with the order of execution. Function, any thread.
#pragma once
#include "projects/exchange/twincat/archive.h"

namespace plc::exchange {

/// `archive` holds the diagram somewhere below it: a <CFC> of TwinCAT. The body is a <CFC>. Variables that it needs are
/// named after `unit`.
[[nodiscard]] ArchiveBody readStoredCfc(pugi::xml_node archive, std::string_view unit);

} // namespace plc::exchange
