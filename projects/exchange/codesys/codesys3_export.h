// The native export of CODESYS V3 (.export) into the texts of a project. Functions, any thread.
#pragma once
#include "projects/exchange/base/imported.h"
#include "projects/exchange/base/xml.h"

namespace plc::exchange {

[[nodiscard]] bool isCodesysExport(const XmlFile& file);
void importCodesysExport(const XmlFile& file, Imported& imported);

} // namespace plc::exchange
