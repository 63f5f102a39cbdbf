// __VARINFO of CODESYS: name, type, size and place of a variable as an __SYSTEM.VAR_INFO. One thread checks.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

[[nodiscard]] Operand variableInfo(Context& context, const syntax::Expr& e);

} // namespace plc::sema
