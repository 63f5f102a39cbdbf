// Calls of standard functions and conversions: the overload is chosen by the rule of the signature
// (runtime/library/signatures.h).
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Operand standardCall(Context& context, std::string_view name, const syntax::Expr& e, TypeId hint);
/// The text of an expression calls something. Bounded by its height, which the parser limits.
[[nodiscard]] bool containsCall(const syntax::Expr& e);
StandardArguments standardArguments(Context& context, const library::Signature& signature, const syntax::Expr& e);

} // namespace plc::sema
