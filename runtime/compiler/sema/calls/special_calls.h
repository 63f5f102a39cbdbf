// Standard functions with rules of their own: bounds, sizes, addresses, powers, queries of interfaces.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Operand addressOf(Context& context, tree::Place* place, TypeId pointer, SourceRange range);
Operand isNull(Context& context, Operand pointer, SourceRange range);
Operand exptCall(Context& context, Operand base, Operand exponent, SourceRange range, SourceRange operatorRange,
                 TypeId hint);
Operand specialCall(Context& context, const library::Signature& signature, const syntax::Expr& e, TypeId hint);

} // namespace plc::sema
