// Which values may leave the subrange of the variable they go to, and so are guarded when the program runs. Functions,
// any thread.
#pragma once
#include "runtime/compiler/tree/tree.h"

namespace plc::facts {

/// A variable of the same subrange and a constant are inside already.
[[nodiscard]] bool mayLeaveRange(const types::TypeTable& types, const tree::Expr& value, types::TypeId target);

} // namespace plc::facts
