// Expressions: values of names, constants, conditions.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Operand unknown(Context& context, SourceRange range);
Operand constant(Context& context, types::Value value, SourceRange range, bool isFlexible = false);
/// Runs its statements, then is its value `a`.
tree::Expr* newSequence(Context& context, TypeId type, SourceRange range);
Operand load(Context& context, tree::Place* place, SourceRange range);
[[nodiscard]] bool isNumeric(const Context& context, TypeId type);
void refer(Context& context, SourceRange range, SymbolId symbol, Access access);
[[nodiscard]] TypeId textType(Context& context, size_t length, bool isWide);
/// a flexible value gets its own type
Operand settled(Context& context, Operand operand, TypeId hint = {});
Operand value(Context& context, Denoted denoted, const syntax::Expr& e, TypeId hint);
Operand expression(Context& context, const syntax::Expr& e, TypeId hint = {});
bool fitsIntoCode(Context& context, TypeId type, SourceRange range);
Operand aggregate(Context& context, const syntax::Expr& e, TypeId hint);
tree::Expr* condition(Context& context, const syntax::Expr& e);

} // namespace plc::sema
