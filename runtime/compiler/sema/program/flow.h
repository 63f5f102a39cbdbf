// Whole-program checks after the bodies: variables nobody uses, calls that come back to themselves.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void checkUsage(WorldBuilder& world);
void checkRecursion(WorldBuilder& world);

} // namespace plc::sema
