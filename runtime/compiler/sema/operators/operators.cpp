// Operators: operand types are made equal, constants are folded with the library's reference semantics.
#include "runtime/compiler/sema/operators/operators.h"

#include "runtime/compiler/sema/operators/operation.h"

#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

using lex::TokenKind;
using library::BinaryOp;
using types::Family;

static Operand logical(Context& context, const syntax::Expr& e, TypeId hint);

namespace {

std::optional<BinaryOp> operatorOf(TokenKind kind) {
    switch (kind) {
    case TokenKind::Plus:
        return BinaryOp::Add;
    case TokenKind::Minus:
        return BinaryOp::Subtract;
    case TokenKind::Star:
        return BinaryOp::Multiply;
    case TokenKind::Slash:
        return BinaryOp::Divide;
    case TokenKind::Mod:
        return BinaryOp::Modulo;
    case TokenKind::And:
    case TokenKind::Ampersand:
        return BinaryOp::And;
    case TokenKind::Or:
        return BinaryOp::Or;
    case TokenKind::Xor:
        return BinaryOp::Xor;
    case TokenKind::Equal:
        return BinaryOp::Equal;
    case TokenKind::NotEqual:
        return BinaryOp::NotEqual;
    case TokenKind::Less:
        return BinaryOp::Less;
    case TokenKind::LessEqual:
        return BinaryOp::LessEqual;
    case TokenKind::Greater:
        return BinaryOp::Greater;
    case TokenKind::GreaterEqual:
        return BinaryOp::GreaterEqual;
    default:
        return std::nullopt;
    }
}

/// Folded when the operand is constant.
Operand makeUnary(Context& context, library::UnaryOp op, Operand operand, SourceRange range) {
    // A subrange is left as soon as it is computed with.
    const TypeId type = context.types.storage(operand.type());
    if (operand.type() != type) operand = convertNode(context, operand, type);
    if (operand.isConstant()) {
        const library::Evaluated folded = library::evaluateUnary(context.types, op, type, operand.expr->value);
        if (folded.value.hasValue()) return constant(context, {type, folded.value.data}, range);
    }
    tree::Expr* out = context.arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Unary;
    out->unary = op;
    out->type = type;
    out->range = range;
    out->a = operand.expr;
    return {out, &context.types};
}

/// -literal: still without a type.
// The lexer knows no signs: -32768 is a literal with an operator, and has to be one number again before its type is
// chosen.
Operand negatedLiteral(Context& context, const types::Value& value, SourceRange range) {
    if (std::holds_alternative<double>(value.data)) return constant(context, {value.type, -value.real()}, range, true);
    // 9223372036854775808 does not fit into LINT, but its negative does.
    if (context.types.storageKind(value.type) == TypeKind::Ulint && value.integer() != INT64_MIN) {
        context.emit(range, findings::ConstantOutOfRange(context.textOf(range), Verbatim("LINT")));
        return unknown(context, range);
    }
    const auto negative = static_cast<int64_t>(0 - static_cast<uint64_t>(value.integer()));
    return constant(context, {context.elementary(TypeKind::Lint), negative}, range, true);
}

} // namespace

///   wrong: x := x / 0; x := x MOD (1 - 1);  (P2017)
Operand makeBinary(Context& context, BinaryOp op, TypeId operandType, Operand a, Operand b, SourceRange range) {
    const TypeId result = isCompare(op) ? context.elementary(TypeKind::Bool) : operandType;
    // Found when it is compiled as far as the divisor is constant; otherwise it is a fault when it runs.
    const bool divides = op == BinaryOp::Divide || op == BinaryOp::Modulo;
    const Family family = context.types.family(operandType);
    if (divides && b.isConstant() && std::holds_alternative<int64_t>(b.expr->value.data) &&
        b.expr->value.integer() == 0 && family != Family::Real) {
        context.emit(b.expr->range, findings::DivisionByConstantZero());
        return unknown(context, range);
    }
    if (a.isConstant() && b.isConstant()) {
        const library::Evaluated folded =
            library::evaluateBinary(context.types, op, operandType, a.expr->value, b.expr->value);
        if (folded.error == library::EvaluationError::None && folded.value.hasValue()) {
            types::Value value = folded.value;
            // A text keeps the type with its own length.
            if (!context.types.isText(result)) value.type = result;
            return constant(context, std::move(value), range);
        }
    }
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Binary;
    e->binary = op;
    e->type = result;
    // A comparison's type is BOOL: the code generator needs to know in which type it is made.
    e->operandType = operandType;
    e->range = range;
    e->a = a.expr;
    e->b = b.expr;
    return {e, &context.types};
}

/// An operand; what a call or a property refers to is read, as a variable's is.
static Operand readOperand(Context& context, const syntax::Expr& e, TypeId hint) {
    const Operand operand = expression(context, e, hint);
    if (operand.isUnknown() || !context.isKind(operand.type(), TypeKind::Reference)) return operand;
    return load(context, referredBy(context, operand, e.range), e.range);
}

Operand unary(Context& context, const syntax::Expr& e, TypeId hint) {
    Operand operand = readOperand(context, *e.base, hint);
    if (operand.isUnknown()) return unknown(context, e.range);
    // +x is x.
    if (e.op == TokenKind::Plus) {
        if (!isNumeric(context, operand.type()) && context.types.family(operand.type()) != Family::Duration) {
            context.emit(e.range, findings::OperatorNotForType(Verbatim("+"), context.nameOf(operand.type())));
            return unknown(context, e.range);
        }
        return operand;
    }
    if (e.op == TokenKind::Not) {
        // NOT 0 for a BOOL is TRUE, for a WORD 16#FFFF: a literal has no width that could be inverted.
        if (operand.isFlexible && hint.isValid() && context.types.storageKind(hint) == TypeKind::Bool)
            operand = converted(context, operand, context.elementary(TypeKind::Bool));
        else if (operand.isFlexible && hint.isValid() && types::isInteger(context.types.family(hint)))
            operand = converted(context, operand, hint);
        return inverted(context, operand, e.range);
    }
    return negated(context, operand, e.range);
}

///   ok:    -i      wrong: -s  with s : STRING (P2006)
Operand negated(Context& context, Operand operand, SourceRange range) {
    if (operand.isUnknown()) return operand;
    if (isStrict(context, operand)) return unknown(context, range);
    const Family family = context.types.family(operand.type());
    if (operand.isFlexible) return negatedLiteral(context, operand.expr->value, range);
    if (!isNumeric(context, operand.type()) && family != Family::Duration) {
        context.emit(range, findings::OperatorNotForType(Verbatim("-"), context.nameOf(operand.type())));
        return unknown(context, range);
    }
    return makeUnary(context, library::UnaryOp::Negate, operand, range);
}

///   ok:    NOT w      wrong: NOT r  with r : REAL (P2006)
Operand inverted(Context& context, Operand operand, SourceRange range) {
    if (operand.isUnknown()) return operand;
    operand = settled(context, operand);
    if (isStrict(context, operand)) return unknown(context, range);
    const Family family = context.types.family(operand.type());
    if (family != Family::Bool && !types::isInteger(family)) {
        context.emit(range, findings::OperatorNotForType(Verbatim("NOT"), context.nameOf(operand.type())));
        return unknown(context, range);
    }
    return makeUnary(context, library::UnaryOp::Not, operand, range);
}

Operand binary(Context& context, const syntax::Expr& e, TypeId hint) {
    const TokenKind kind = e.op;
    if (kind == TokenKind::And || kind == TokenKind::Ampersand || kind == TokenKind::Or || kind == TokenKind::Xor ||
        kind == TokenKind::AndThen || kind == TokenKind::OrElse)
        return logical(context, e, hint);
    const std::optional<BinaryOp> op = operatorOf(kind);
    const bool compares = op && isCompare(*op);
    const TypeId inner =
        compares || !hint.isValid() || !(isNumeric(context, hint) || isTimeFamily(context.types.family(hint)))
            ? TypeId()
            : hint;
    Operand a = readOperand(context, *e.base, inner);
    const bool adapts = compares && !a.isUnknown() && !a.isFlexible;
    Operand b = readOperand(context, *e.right, adapts ? a.type() : inner);
    if (a.isUnknown() || b.isUnknown()) return unknown(context, e.range);
    if (kind == TokenKind::Power) return exptCall(context, a, b, e.range, e.operatorRange, hint);
    if (!op) return unknown(context, e.range);
    const std::string_view spelling = lex::spelling(kind);
    return compares ? compare(context, *op, spelling, a, b, e.range, e.operatorRange)
                    : combine(context, *op, spelling, a, b, e.range, e.operatorRange, hint);
}

// Two blocks of code instead of one operation: the right side may be p^.x behind p <> 0.
/// AND_THEN, OR_ELSE: the right side is computed only when it decides.
static Operand shortCircuit(Context& context, const syntax::Expr& e) {
    const TypeId boolean = context.elementary(TypeKind::Bool);
    tree::Expr* a = condition(context, *e.base);
    tree::Expr* b = condition(context, *e.right);
    if (context.isKind(a->type, TypeKind::Unknown) || context.isKind(b->type, TypeKind::Unknown))
        return unknown(context, e.range);
    const bool isAnd = e.op == TokenKind::AndThen;
    if (a->kind == tree::ExprKind::Constant && b->kind == tree::ExprKind::Constant) {
        const bool left = a->value.isTrue(), right = b->value.isTrue();
        return constant(context, {boolean, int64_t(isAnd ? left && right : left || right)}, e.range);
    }
    tree::Expr* out = context.arena.make<tree::Expr>();
    out->kind = isAnd ? tree::ExprKind::AndThen : tree::ExprKind::OrElse;
    out->type = boolean;
    out->range = e.range;
    out->a = a;
    out->b = b;
    return {out, &context.types};
}

Operand logical(Context& context, const syntax::Expr& e, TypeId hint) {
    if (e.op == TokenKind::AndThen || e.op == TokenKind::OrElse) return shortCircuit(context, e);
    // 16#FF AND 16#0F for a BYTE: literals are read as bits of the type that is wanted.
    const bool wantsBits =
        hint.isValid() && (context.types.family(hint) == Family::Bool || types::isInteger(context.types.family(hint)));
    Operand a = readOperand(context, *e.base, wantsBits ? hint : TypeId());
    Operand b = readOperand(context, *e.right,
                            !a.isUnknown() && !a.isFlexible ? a.type()
                            : wantsBits                     ? hint
                                                            : TypeId());
    if (a.isUnknown() || b.isUnknown()) return unknown(context, e.range);
    return combine(context, *operatorOf(e.op), lex::spelling(e.op), a, b, e.range, e.operatorRange, hint);
}

Operand intrinsic(Context& context, library::Intrinsic code, TypeId result, std::vector<Operand> operands,
                  SourceRange range, int64_t selector) {
    // Folded with the library's own evaluator, which the code generator is compared with: a constant is what the code
    // would compute.
    bool allConstant = !operands.empty();
    for (const Operand& operand : operands) {
        if (operand.isUnknown()) return unknown(context, range);
        allConstant = allConstant && operand.isConstant();
    }
    if (allConstant) {
        std::vector<types::Value> values;
        for (const Operand& operand : operands) values.push_back(operand.expr->value);
        const library::Evaluated folded =
            library::evaluateIntrinsic(context.types, code, result, values, nullptr, selector);
        // What fails (a division, a position beyond a text) is left to the code: it then faults or clears ENO where it
        // runs.
        if (folded.error == library::EvaluationError::None && folded.ok && folded.value.hasValue()) {
            types::Value value = folded.value;
            value.type = result;
            return constant(context, std::move(value), range);
        }
    }
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Intrinsic;
    e->intrinsic = code;
    e->type = result;
    e->range = range;
    e->selector = selector;
    for (const Operand& operand : operands) e->operands.push_back(operand.expr);
    return {e, &context.types};
}

} // namespace plc::sema
