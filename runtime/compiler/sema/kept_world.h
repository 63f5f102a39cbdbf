// What an Analysis keeps of the World it was made in (Analysis::scopes), for watch expressions. Nothing is added to the
// World any more: a Context with `isExpression` only looks things up, so that several threads may have one each.
#pragma once
#include "runtime/compiler/sema/world.h"

#include <memory>

namespace plc::sema {

struct KeptWorld {
    std::shared_ptr<World> world;
};

} // namespace plc::sema
