// Which libraries of other tools ours stand in for. Functions, any thread.
#pragma once
#include "projects/exchange/base/imported.h"

namespace plc::exchange {

/// Names the library in the project where we have it, else says so; those of the system need nothing.
void useLibrary(Imported& imported, const std::string& name, bool isSystem, const std::string& place);

} // namespace plc::exchange
