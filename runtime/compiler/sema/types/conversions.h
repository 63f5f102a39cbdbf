// Implicit and written conversions, and the common type of two operands (D11).
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

[[nodiscard]] bool fits(const Context& context, const types::Value& value, TypeId type);
[[nodiscard]] TypeId smallestType(const Context& context, const Operand& flexible);
/// none: they do not combine
[[nodiscard]] TypeId commonType(const Context& context, const Operand& a, const Operand& b);
void mismatch(Context& context, SourceRange range, TypeId from, TypeId to);
/// reports a calculation with a strict enumeration
bool isStrict(Context& context, const Operand& operand);
/// written conversion, no questions
Operand convertNode(Context& context, Operand operand, TypeId to);
Operand sameBits(Context& context, Operand operand, TypeId to);
Operand convertedText(Context& context, Operand operand, TypeId to);
/// Implicit conversion with its diagnostics, at the operand's own range.
Operand converted(Context& context, Operand operand, TypeId to);

} // namespace plc::sema
