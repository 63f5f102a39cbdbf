// The bodies of all units: prologue (initial values of locals, edges of inputs), statements, end-of-body checks.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void checkBodies(World& world);

} // namespace plc::sema
