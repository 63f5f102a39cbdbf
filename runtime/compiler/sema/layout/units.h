// Program units get their shape: bases, parameters, where each variable lies (instance field, local, static, constant).
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void collectParameters(WorldBuilder& world, Unit& unit);
void completeUnit(WorldBuilder& world, Unit& unit, SourceRange usedAt);
void completeUnit(const Check& check, Unit& unit, SourceRange usedAt);
void markHeaders(WorldBuilder& world);

} // namespace plc::sema
