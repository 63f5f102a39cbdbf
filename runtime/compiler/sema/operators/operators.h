// Operators: operand types are made equal, constants are folded with the library's reference semantics.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Operand makeBinary(Context& context, library::BinaryOp op, TypeId operandType, Operand a, Operand b, SourceRange range);
Operand unary(Context& context, const syntax::Expr& e, TypeId hint);
Operand negated(Context& context, Operand operand, SourceRange range);
Operand inverted(Context& context, Operand operand, SourceRange range);
Operand binary(Context& context, const syntax::Expr& e, TypeId hint);
Operand combine(Context& context, library::BinaryOp op, std::string_view spelling, Operand a, Operand b,
                SourceRange range, SourceRange operatorRange, TypeId hint);
Operand compare(Context& context, library::BinaryOp op, std::string_view spelling, Operand a, Operand b,
                SourceRange range, SourceRange operatorRange);
Operand intrinsic(Context& context, library::Intrinsic code, TypeId result, std::vector<Operand> operands,
                  SourceRange range, int64_t selector = -1);

} // namespace plc::sema
