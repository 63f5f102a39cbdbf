// EXTENDS, IMPLEMENTS, overriding, access, and the slots of dispatched methods (one per method name, program-wide).
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void resolveBases(WorldBuilder& world, Unit& unit);
[[nodiscard]] bool isAccessible(syntax::Access access, const Unit* owner, const Scope& from);
void checkInheritance(WorldBuilder& world, Unit& unit);
void assignSlots(WorldBuilder& world);
void buildDispatch(WorldBuilder& world);

} // namespace plc::sema
