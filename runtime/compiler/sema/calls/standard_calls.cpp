// Calls of standard functions and conversions: the overload is chosen by the rule of the signature
// (runtime/library/signatures.h).
#include "runtime/compiler/sema/calls/standard_calls.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/conversion_calls.h"
#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/calls/standard_results.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

#include <numeric>

namespace plc::sema {

using library::BinaryOp;
using library::Generic;
using library::Rule;
using library::Signature;
using syntax::ArgumentKind;
using types::Family;

static bool accepts(Context& context, const library::Parameter& parameter, const Operand& operand,
                    std::string_view function);
static Operand operatorCall(Context& context, const library::Signature& signature, std::vector<Operand> operands,
                            const syntax::Expr& e, TypeId hint);
static Operand signatureCall(Context& context, const library::Signature& signature, const syntax::Expr& e, TypeId hint);
static std::vector<tree::Stmt*> holdAsWritten(Context& context, std::vector<Operand>& operands,
                                              const std::vector<const syntax::Argument*>& inputs);

// Asked of the text, not of the tree: in the tree an intrinsic is no call any more.
bool containsCall(const syntax::Expr& e) {
    if (e.kind == syntax::ExprKind::Call) return true;
    const auto inArgument = [](const syntax::Argument& a) { return a.value && containsCall(*a.value); };
    return (e.base && containsCall(*e.base)) || (e.right && containsCall(*e.right)) ||
           std::any_of(e.arguments.begin(), e.arguments.end(), inArgument);
}

Operand standardCall(Context& context, std::string_view name, const syntax::Expr& e, TypeId hint) {
    // Signatures first: a function of the table may be named as a conversion would be.
    if (const Signature* signature = library::findSignature(name)) return signatureCall(context, *signature, e, hint);
    if (const auto conversion = library::findConversion(name))
        return conversionCall(context, *conversion, name, e, hint);
    return unknown(context, e.range);
}

/// The generic types of the standard (edition 3, 6.4.3).
///   ok:    ABS(i)      wrong: ABS(s)  with s : STRING (P2006)
bool accepts(Context& context, const library::Parameter& parameter, const Operand& operand,
             std::string_view functionName) {
    const TypeId type = operand.type();
    const Family family = context.types.family(type);
    const bool text = context.types.isText(type);
    const bool elementaryType = family != Family::Other || text;
    const bool isTime = family == Family::Duration;
    bool good = true;
    switch (parameter.generic) {
    case Generic::Fixed:
    case Generic::Any:
        good = !context.isKind(type, TypeKind::Void);
        break;
    case Generic::AnyElementary:
        good = elementaryType;
        break;
    // ANY_MAGNITUDE is numbers and durations; dates and pointers are taken as well, because MAX of two dates and MOVE
    // of a pointer are in every larger program.
    case Generic::AnyMagnitude:
        good = isNumeric(context, type) || isTime || family == Family::Date || family == Family::TimeOfDay ||
               family == Family::DateTime || context.isKind(type, TypeKind::Pointer) || family == Family::Character;
        break;
    case Generic::AnyNum:
    case Generic::AnyReal:
        good = isNumeric(context, type);
        break;
    case Generic::AnyInt:
        good = types::isInteger(family);
        break;
    // Whole numbers as well: the standard has only bit strings here (SHL of an INT), compilers in use take both.
    case Generic::AnyBit:
        good = types::isInteger(family) || family == Family::Bool;
        break;
    case Generic::AnyText:
        good = text || family == Family::Character;
        break;
    case Generic::AnyDate:
        good = family == Family::Date || family == Family::DateTime || family == Family::TimeOfDay;
        break;
    case Generic::AnyDuration:
        good = isTime;
        break;
    case Generic::AnyNumOrDuration:
        good = isNumeric(context, type) || isTime;
        break;
    }
    if (good) return true;
    // "gives no value" and "is not for this type" are different mistakes.
    if (context.isKind(type, TypeKind::Void))
        context.emit(operand.expr->range, findings::NoValue(context.textOf(operand.expr->range)));
    else
        context.emit(operand.expr->range,
                     findings::OperatorNotForType(
                         functionName, context.nameOf(operand.isFlexible ? smallestType(context, operand) : type)));
    return false;
}

Operand operatorCall(Context& context, const Signature& signature, std::vector<Operand> operands, const syntax::Expr& e,
                     TypeId hint) {
    const std::string_view name = signature.operatorName;
    const SourceRange at = e.base->range;
    if (operands.size() == 1) {
        // The second operand is part of the function: it adds or subtracts a fixed number.
        if (signature.selector >= 0) {
            const Operand one =
                constant(context, {context.elementary(TypeKind::Lint), signature.selector}, e.range, true);
            return combine(context, name == "+" ? BinaryOp::Add : BinaryOp::Subtract, signature.name,
                           settled(context, operands[0], hint), one, e.range, at, hint);
        }
        if (name == "NOT")
            return inverted(context, operands[0].isFlexible ? settled(context, operands[0], hint) : operands[0],
                            e.range);
        return negated(context, operands[0], e.range);
    }
    static constexpr std::pair<std::string_view, BinaryOp> kOperators[] = {
        {"+", BinaryOp::Add},       {"-", BinaryOp::Subtract},     {"*", BinaryOp::Multiply},
        {"/", BinaryOp::Divide},    {"MOD", BinaryOp::Modulo},     {"AND", BinaryOp::And},
        {"OR", BinaryOp::Or},       {"XOR", BinaryOp::Xor},        {"=", BinaryOp::Equal},
        {"<>", BinaryOp::NotEqual}, {"<", BinaryOp::Less},         {"<=", BinaryOp::LessEqual},
        {">", BinaryOp::Greater},   {">=", BinaryOp::GreaterEqual}};
    BinaryOp op = BinaryOp::Add;
    for (const auto& [spelling, code] : kOperators)
        if (spelling == name) op = code;
    // GT(a, b, c) is a > b AND b > c (table 28), each pair with the rules of the operator.
    if (signature.rule == Rule::Compare) {
        Operand all;
        for (size_t i = 0; i + 1 < operands.size(); ++i) {
            const Operand next = compare(context, op, signature.name, operands[i], operands[i + 1], e.range, at);
            if (next.isUnknown()) return unknown(context, e.range);
            all = i == 0 ? next
                         : makeBinary(context, BinaryOp::And, context.elementary(TypeKind::Bool), all, next, e.range);
        }
        return all;
    }
    // ADD(a, b, c) from left to right, as the operator would be.
    Operand result = operands[0];
    for (size_t i = 1; i < operands.size() && !result.isUnknown(); ++i)
        result = combine(context, op, signature.name, result, operands[i], e.range, at, hint);
    return result;
}

/// A function that is an operator by another name: ADD, GT, AND …
static Operand operatorResult(Context& context, const Signature& signature, std::vector<Operand> operands,
                              const syntax::Expr& e, TypeId hint) {
    Operand out = operatorCall(context, signature, std::move(operands), e, hint);
    if (!out.isUnknown() && signature.rule == Rule::FixedResult && signature.result != TypeKind::Unknown &&
        out.type() != context.elementary(signature.result))
        out = sameBits(context, out, context.elementary(signature.result));
    return out;
}

Operand signatureCall(Context& context, const Signature& signature, const syntax::Expr& e, TypeId hint) {
    if (signature.rule == Rule::Special) return specialCall(context, signature, e, hint);
    const StandardArguments arguments = standardArguments(context, signature, e);
    const bool compares = signature.rule == Rule::Compare;
    // A comparison's result is BOOL, which says nothing about what is compared; a fixed result says nothing about
    // operands.
    const bool passesHint = !compares && signature.rule != Rule::FixedResult && hint.isValid();
    std::vector<Operand> operands;
    bool good = arguments.isGood;
    for (size_t i = 0; i < arguments.inputs.size(); ++i) {
        if (!arguments.inputs[i] || !arguments.inputs[i]->value) continue;
        const library::Parameter& parameter = signature.parameters[std::min(i, signature.parameters.size() - 1)];
        const bool isFixed = parameter.generic == Generic::Fixed;
        TypeId wanted = isFixed && parameter.fixed != TypeKind::String && parameter.fixed != TypeKind::Wstring
                            ? context.elementary(parameter.fixed)
                            : TypeId();
        if (isFixed && parameter.fixed == TypeKind::Wstring) wanted = textType(context, 80, true);
        // The first operand's type is what a literal or an enumerator in the others is read as.
        if (!isFixed && compares && !operands.empty() && !operands[0].isUnknown() && !operands[0].isFlexible)
            wanted = operands[0].type();
        // Counts and positions (ANY_INT) have nothing to do with the type of the result.
        if (!isFixed && passesHint && parameter.generic != Generic::AnyInt) wanted = hint;
        Operand operand = expression(context, *arguments.inputs[i]->value, wanted);
        if (!operand.isUnknown() && arguments.inputs[i]->negated)
            operand = inverted(context, operand, operand.expr->range);
        if (!operand.isUnknown()) {
            if (isFixed)
                operand = converted(context, operand,
                                    parameter.fixed == TypeKind::String ? textType(context, 80, false) : wanted);
            else if (!accepts(context, parameter, operand, signature.name))
                operand = unknown(context, e.range);
            else if (parameter.generic == Generic::AnyText && context.types.family(operand.type()) == Family::Character)
                operand =
                    convertNode(context, operand,
                                textType(context, 1, context.types.storageKind(operand.type()) == TypeKind::Wchar));
        }
        good = good && !operand.isUnknown();
        operands.push_back(operand);
    }
    if (!good) return unknown(context, e.range);
    // Only now that all are good: held values go into locals, which a wrong call need not have.
    std::vector<tree::Stmt*> before = holdAsWritten(context, operands, arguments.inputs);
    Operand out = signature.operatorName.empty() ? signatureResult(context, signature, std::move(operands), e, hint)
                                                 : operatorResult(context, signature, std::move(operands), e, hint);
    if (!before.empty() && !out.isUnknown()) {
        tree::Expr* sequence = newSequence(context, out.type(), e.range);
        sequence->statements = std::move(before);
        sequence->a = out.expr;
        out = {sequence, &context.types};
    }
    return withEnable(context, out, arguments, e.range);
}

/// Arguments given by name in another order than the parameters' are evaluated as written where one of them is a call,
/// which may change what another one reads.
///   SEL(IN1 := Next(), IN0 := Next(), G := b): IN1 has the first number
std::vector<tree::Stmt*> holdAsWritten(Context& context, std::vector<Operand>& operands,
                                       const std::vector<const syntax::Argument*>& inputs) {
    if (!context.function || std::is_sorted(inputs.begin(), inputs.end())) return {};
    if (std::none_of(inputs.begin(), inputs.end(), [](const syntax::Argument* a) { return containsCall(*a->value); }))
        return {};
    std::vector<size_t> written(operands.size());
    std::iota(written.begin(), written.end(), size_t(0));
    std::sort(written.begin(), written.end(), [&](size_t a, size_t b) { return inputs[a] < inputs[b]; });
    std::vector<tree::Stmt*> before;
    for (const size_t i : written)
        // Literals have no moment at which they are evaluated.
        if (!operands[i].isFlexible) operands[i].expr = held(context, operands[i].expr, before);
    return before;
}

} // namespace plc::sema
