// Names of libraries that are projects of the same import: their units become part of the one project. Functions, any
// thread.
#pragma once
#include "projects/exchange/base/imported.h"

namespace plc::exchange {

/// Library.Unit becomes Unit where the library is one of the imported projects; each such library has its line.
void dropOwnNamespaces(Imported& imported);

} // namespace plc::exchange
