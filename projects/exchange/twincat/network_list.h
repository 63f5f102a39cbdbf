// LD and FBD as TwinCAT and CODESYS V3 store them, a list of networks in an archive of objects, as the body of a
// PLCopen diagram, which the reader of diagrams knows. Function, any thread.
#pragma once
#include "projects/exchange/twincat/archive.h"

namespace plc::exchange {

/// `archive` holds the list somewhere below it: an <NWL> of TwinCAT. The body is an <LD> or <FBD>.
[[nodiscard]] ArchiveBody readNetworkList(pugi::xml_node archive);

} // namespace plc::exchange
