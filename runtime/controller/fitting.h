// Brings a value from outside (watch, panel, command line, retain file) to the type of the variable it is written to,
// or says why it does not fit. Pure functions, any thread.
#pragma once
#include "runtime/types/value.h"

namespace plc::controller {

/// A value of exactly `type`. Numbers must be in range, a REAL for an integer must be whole, text must fit the
/// capacity.
[[nodiscard]] Result<types::Value> fitted(const types::TypeTable& types, const types::Value& value, types::TypeId type);

} // namespace plc::controller
