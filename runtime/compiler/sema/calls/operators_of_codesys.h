// Operators that CODESYS and TwinCAT have beside the standard's: names of units and places, TEST_AND_SET, names of
// enumeration values as texts. One thread checks.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// __POUNAME(), __POSITION()
[[nodiscard]] Operand placeText(Context& context, const syntax::Expr& e, bool isUnit);
[[nodiscard]] Operand testAndSet(Context& context, const syntax::Expr& e);
/// TO_STRING of a value of an enumeration with {attribute 'to_string'}: its name. Nothing: of no such enumeration.
[[nodiscard]] std::optional<Operand> nameOfValue(Context& context, const Operand& value, TypeId text,
                                                 SourceRange range);

} // namespace plc::sema
