// Between the PLC's values and those of the panel. Pure functions, any thread.
#pragma once
#include "hmi/model/value.h"
#include "runtime/types/value.h"

namespace plc::hmi {

Value toPanel(const types::TypeTable& types, const types::Value& value);
ValueFacts factsOf(const types::TypeTable& types, types::TypeId type, bool isWritable);
/// The value in the PLC's type; an error where it does not fit (range, length, kind).
Result<types::Value> toPlc(const types::TypeTable& types, types::TypeId type, const Value& value);

} // namespace plc::hmi
