// Extensions of a Beremiz project, code in C or Python with variables that the program sees: the variables are
// declared, the code is not read. Functions, any thread.
#pragma once
#include "projects/exchange/base/imported.h"
#include "projects/exchange/base/xml.h"

namespace plc::exchange {

[[nodiscard]] bool isBeremizExtension(const XmlFile& file);
void readBeremizExtension(const XmlFile& file, Imported& imported);

} // namespace plc::exchange
