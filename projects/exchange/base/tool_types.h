// Types that a tool has without a declaration: those that an imported project uses are declared in it. Functions, any
// thread.
#pragma once
#include "projects/exchange/base/imported.h"

namespace plc::exchange {

/// "Beremiz 1.3", "TwinCAT"; "" when the files do not say it.
[[nodiscard]] std::string toolOf(const Imported& imported);
/// Adds a file with the types in use, and a line to the report.
void addToolTypes(Imported& imported);

} // namespace plc::exchange
