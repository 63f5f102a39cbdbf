// Calls of conversions: INT_TO_REAL, TO_STRING, TRUNC_INT, BCD_TO_INT …
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Operand conversionCall(Context& context, const library::Conversion& conversion, std::string_view name,
                       const syntax::Expr& e, TypeId hint);

} // namespace plc::sema
