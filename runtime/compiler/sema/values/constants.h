// Constants: folded when first asked for, in any order, across units.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

const types::Value* constantOf(World& world, Variable& variable);
void checkConstants(World& world);

} // namespace plc::sema
