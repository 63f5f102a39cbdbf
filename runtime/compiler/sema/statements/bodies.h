// The bodies of all units: prologue (initial values of locals, edges of inputs), statements, end-of-body checks. All of
// them, or those that are not as they were in the last check; the others give what they gave then.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// Both return how many bodies were checked.
size_t checkBodies(World& world);
/// `last`: null at first. Leaves the World's `check` for the next time.
size_t checkChangedBodies(World& world, const std::vector<std::shared_ptr<const syntax::SyntaxFile>>& files,
                          const LastCheck* last);
/// Whether a unit has code of its own; what its function is, whatever the code.
[[nodiscard]] bool beginBody(World& world, Unit& unit);
/// The tree goes into `arena`.
void checkBody(World& world, Unit& unit, Arena& arena);

} // namespace plc::sema
