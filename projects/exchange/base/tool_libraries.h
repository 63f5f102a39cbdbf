// Names of libraries that reach out of a controller, or into a device it does not have here: which library each is of,
// so that the report can say what a program misses. Function, any thread.
#pragma once
#include "projects/exchange/base/imported.h"

namespace plc::exchange {

/// One line for each such library: its names that the program uses. `used`: folded name → as it is written, of types
/// and of what is called; `declared`: folded names of the project.
void reportLibrariesUsed(Imported& imported, const std::map<std::string, std::string>& used,
                         const std::set<std::string>& declared);

} // namespace plc::exchange
