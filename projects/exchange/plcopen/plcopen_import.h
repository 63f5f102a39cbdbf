// PLCopen XML (TC6 0200 and 0201, with what CODESYS and TwinCAT add) into the texts of a project. Function, any thread.
#pragma once
#include "projects/exchange/base/imported.h"
#include "projects/exchange/base/xml.h"

namespace plc::exchange {

[[nodiscard]] bool isPlcopen(const XmlFile& file);
/// Adds what the file holds to `imported`.
void importPlcopen(const XmlFile& file, Imported& imported);

} // namespace plc::exchange
