// __NEW and __DELETE of CODESYS and TwinCAT, on the memory that the project sets aside. One thread checks.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

[[nodiscard]] Operand newCall(Context& context, const syntax::Expr& e);
[[nodiscard]] Operand deleteCall(Context& context, const syntax::Expr& e);

} // namespace plc::sema
