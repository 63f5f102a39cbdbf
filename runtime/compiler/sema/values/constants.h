// Constants: folded when first asked for, in any order, across units.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

const types::Value* constantOf(WorldBuilder& world, Variable& variable);
/// Null, where it has none or it was reported.
[[nodiscard]] const types::Value* constantOf(const Check& check, Variable& variable);
void checkConstants(WorldBuilder& world);

} // namespace plc::sema
