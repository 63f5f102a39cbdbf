// Program units get their shape: bases, parameters, where each variable lies (instance field, local, static, constant).
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void collectParameters(World& world, Unit& unit);
void completeUnit(World& world, Unit& unit, SourceRange usedAt);
void markHeaders(World& world);

} // namespace plc::sema
