// The bodies of all units: prologue (initial values of locals, edges of inputs), statements, end-of-body checks. All of
// them, or those that are not as they were in the last check; the others give what they gave then.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// Both return how many bodies were checked.
size_t checkBodies(WorldBuilder& world);
/// `last`: null at first. Leaves the World's `check` for the next time.
size_t checkChangedBodies(WorldBuilder& world, const std::vector<std::shared_ptr<const syntax::SyntaxFile>>& files,
                          const LastCheck* last);
/// Whether a unit has code of its own; what its function is, whatever the code.
[[nodiscard]] bool beginBody(Gathered& gathered, const Unit& unit);
/// The tree goes into `arena`.
void checkBody(const Check& check, Unit& unit, Arena& arena);
/// Before the first body.
void numberVariables(WorldBuilder& world);
/// What a body used counts for the variables.
void noteUses(WorldBuilder& world, const std::vector<VariableUse>& uses);

} // namespace plc::sema
