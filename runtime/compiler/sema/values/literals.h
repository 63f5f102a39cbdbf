// Literals: numbers in every base, durations and dates, text with $ escapes, typed literals, values of enumerations.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Operand literal(Context& context, const syntax::Expr& e, TypeId hint);
Operand enumerator(Context& context, const EnumeratorRef& ref, SourceRange range);
Operand typedName(Context& context, const syntax::Expr& e);

} // namespace plc::sema
