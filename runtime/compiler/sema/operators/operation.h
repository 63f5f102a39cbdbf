// What the rules of one operator between two operands share. For the files of this folder; values of one check.
#pragma once
#include "runtime/compiler/sema/context.h"

#include "runtime/compiler/sema/values/expressions.h"

namespace plc::sema {

/// `spelling` and `operatorRange` are for messages: "=" and where it is written.
struct Operation {
    library::BinaryOp op;
    std::string_view spelling;
    SourceRange range, operatorRange;
};

[[nodiscard]] inline bool isCompare(library::BinaryOp op) { return op >= library::BinaryOp::Equal; }
[[nodiscard]] inline bool isTimeFamily(types::Family family) {
    using types::Family;
    return family == Family::Duration || family == Family::Date || family == Family::TimeOfDay ||
           family == Family::DateTime;
}
[[nodiscard]] inline bool isConstantZero(const Operand& o) {
    return o.isConstant() && std::holds_alternative<int64_t>(o.expr->value.data) && o.expr->value.integer() == 0;
}

/// The types have no operation in common (P2007).
inline Operand mismatch(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    context.emit(o.operatorRange,
                 findings::OperandsDoNotMatch(o.spelling, context.nameOf(a.type()), context.nameOf(b.type())));
    return unknown(context, o.range);
}

/// A character of a text counts as its code.
Operand characterCode(Context& context, Operand operand);
/// Both are literals without a type: computed with all bits there are, and still flexible.
Operand foldFlexible(Context& context, const Operation& o, const Operand& a, const Operand& b);

} // namespace plc::sema
