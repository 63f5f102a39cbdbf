// The ladder that TwinCAT 3.1.4026 and CODESYS 3.5 SP18 store as JSON in their archive (`<LADDER>`), as the body of a
// PLCopen diagram. Function, any thread.
#pragma once
#include "projects/exchange/twincat/archive.h"

namespace plc::exchange {

/// `archive` holds the model somewhere below it. The body is an <LD>.
[[nodiscard]] ArchiveBody readStoredLadder(pugi::xml_node archive);

} // namespace plc::exchange
