// Blocks whose EXTENDS names something that is not there: what they inherit cannot be known.
#pragma once
#include "runtime/compiler/sema/scopes.h"

namespace plc::sema {

/// The missing base is reported once; what may come from it is not reported again at every use.
[[nodiscard]] bool hasUnknownBase(const Unit* unit);

} // namespace plc::sema
