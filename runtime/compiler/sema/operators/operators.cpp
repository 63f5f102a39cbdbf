// Operators: operand types are made equal, constants are folded with the library's reference semantics.
#include "runtime/compiler/sema/operators/operators.h"

#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/types/conversion.h"

#include <cmath>

namespace plc::sema {

using lex::TokenKind;
using library::BinaryOp;
using types::Family;

static Operand foldFlexible(Context& context, library::BinaryOp op, Operand a, Operand b, SourceRange range);
static Operand arithmeticOnTimes(Context& context, library::BinaryOp op, std::string_view spelling, Operand a,
                                 Operand b, SourceRange range, SourceRange operatorRange);
static Operand logical(Context& context, const syntax::Expr& e, TypeId hint);

namespace {

bool isCompare(BinaryOp op) { return op >= BinaryOp::Equal; }

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

bool isTimeFamily(Family family) {
    return family == Family::Duration || family == Family::Date || family == Family::TimeOfDay ||
           family == Family::DateTime;
}

} // namespace

///   wrong: x := x / 0; x := x MOD (1 - 1);  (P2017)
Operand makeBinary(Context& context, BinaryOp op, TypeId operandType, Operand a, Operand b, SourceRange range) {
    const TypeId result = isCompare(op) ? context.elementary(TypeKind::Bool) : operandType;
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
            if (!context.types.isText(result)) value.type = result;
            return constant(context, std::move(value), range);
        }
    }
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Binary;
    e->binary = op;
    e->type = result;
    e->operandType = operandType;
    e->range = range;
    e->a = a.expr;
    e->b = b.expr;
    return {e, &context.types};
}

/// Both operands are literals without a type: computed with all bits there are, and still flexible.
Operand foldFlexible(Context& context, BinaryOp op, Operand a, Operand b, SourceRange range) {
    const types::Value &x = a.expr->value, &y = b.expr->value;
    if (std::holds_alternative<double>(x.data) || std::holds_alternative<double>(y.data)) {
        const auto number = [](const types::Value& v) {
            return std::holds_alternative<double>(v.data) ? v.real() : static_cast<double>(v.integer());
        };
        types::Value left{context.elementary(TypeKind::Lreal), number(x)},
            right{context.elementary(TypeKind::Lreal), number(y)};
        if (op == BinaryOp::Modulo) {
            context.emit(range, findings::OperatorNotForType(Verbatim("MOD"), Verbatim("REAL")));
            return unknown(context, range);
        }
        if (op == BinaryOp::Divide && right.real() == 0) {
            context.emit(b.expr->range, findings::DivisionByConstantZero());
            return unknown(context, range);
        }
        const library::Evaluated folded =
            library::evaluateBinary(context.types, op, context.elementary(TypeKind::Lreal), left, right);
        if (!folded.value.hasValue()) return unknown(context, range);
        return constant(context, folded.value, range, !isCompare(op));
    }
    const auto wide = [&](const types::Value& v) -> __int128 {
        return context.types.storageKind(v.type) == TypeKind::Ulint
                   ? static_cast<__int128>(static_cast<uint64_t>(v.integer()))
                   : v.integer();
    };
    const __int128 left = wide(x), right = wide(y);
    __int128 result = 0;
    const auto truth = [&](bool value) {
        return constant(context, {context.elementary(TypeKind::Bool), int64_t(value)}, range);
    };
    switch (op) {
    case BinaryOp::Add:
        result = left + right;
        break;
    case BinaryOp::Subtract:
        result = left - right;
        break;
    case BinaryOp::Multiply:
        result = (left > (__int128(1) << 64) || right > (__int128(1) << 64)) ? __int128(1) << 100 : left * right;
        break;
    case BinaryOp::Divide:
    case BinaryOp::Modulo:
        if (right == 0) {
            context.emit(b.expr->range, findings::DivisionByConstantZero());
            return unknown(context, range);
        }
        result = op == BinaryOp::Divide ? left / right : left % right;
        break;
    case BinaryOp::And:
        result = left & right;
        break;
    case BinaryOp::Or:
        result = left | right;
        break;
    case BinaryOp::Xor:
        result = left ^ right;
        break;
    case BinaryOp::Equal:
        return truth(left == right);
    case BinaryOp::NotEqual:
        return truth(left != right);
    case BinaryOp::Less:
        return truth(left < right);
    case BinaryOp::LessEqual:
        return truth(left <= right);
    case BinaryOp::Greater:
        return truth(left > right);
    case BinaryOp::GreaterEqual:
        return truth(left >= right);
    }
    if (result > static_cast<__int128>(UINT64_MAX) || result < static_cast<__int128>(INT64_MIN)) {
        context.emit(range, findings::ConstantOutOfRange(context.textOf(range), Verbatim("LINT")));
        return unknown(context, range);
    }
    Operand out = constant(context,
                           {context.elementary(result > INT64_MAX ? TypeKind::Ulint : TypeKind::Lint),
                            static_cast<int64_t>(static_cast<uint64_t>(result))},
                           range, true);
    out.isDivided = (op == BinaryOp::Divide && left % right != 0) || a.isDivided || b.isDivided;
    return out;
}

Operand unary(Context& context, const syntax::Expr& e, TypeId hint) {
    Operand operand = expression(context, *e.base, hint);
    if (operand.isUnknown()) return unknown(context, e.range);
    if (e.op == TokenKind::Plus) {
        if (!isNumeric(context, operand.type()) && context.types.family(operand.type()) != Family::Duration) {
            context.emit(e.range, findings::OperatorNotForType(Verbatim("+"), context.nameOf(operand.type())));
            return unknown(context, e.range);
        }
        return operand;
    }
    if (e.op == TokenKind::Not) {
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
    if (operand.isFlexible) {
        const types::Value& value = operand.expr->value;
        if (std::holds_alternative<double>(value.data))
            return constant(context, {value.type, -value.real()}, range, true);
        if (context.types.storageKind(value.type) == TypeKind::Ulint && value.integer() != INT64_MIN) {
            context.emit(range, findings::ConstantOutOfRange(context.textOf(range), Verbatim("LINT")));
            return unknown(context, range);
        }
        return constant(
            context,
            {context.elementary(TypeKind::Lint), static_cast<int64_t>(0 - static_cast<uint64_t>(value.integer()))},
            range, true);
    }
    if (!isNumeric(context, operand.type()) && family != Family::Duration) {
        context.emit(range, findings::OperatorNotForType(Verbatim("-"), context.nameOf(operand.type())));
        return unknown(context, range);
    }
    const TypeId type = context.types.storage(operand.type());
    if (operand.type() != type) operand = convertNode(context, operand, type);
    if (operand.isConstant()) {
        const library::Evaluated folded =
            library::evaluateUnary(context.types, library::UnaryOp::Negate, type, operand.expr->value);
        if (folded.value.hasValue()) return constant(context, {type, folded.value.data}, range);
    }
    tree::Expr* out = context.arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Unary;
    out->unary = library::UnaryOp::Negate;
    out->type = type;
    out->range = range;
    out->a = operand.expr;
    return {out, &context.types};
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
    const TypeId type = context.types.storage(operand.type());
    if (operand.type() != type) operand = convertNode(context, operand, type);
    if (operand.isConstant()) {
        const library::Evaluated folded =
            library::evaluateUnary(context.types, library::UnaryOp::Not, type, operand.expr->value);
        if (folded.value.hasValue()) return constant(context, {type, folded.value.data}, range);
    }
    tree::Expr* out = context.arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Unary;
    out->unary = library::UnaryOp::Not;
    out->type = type;
    out->range = range;
    out->a = operand.expr;
    return {out, &context.types};
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
    Operand a = expression(context, *e.base, inner);
    const bool adapts = compares && !a.isUnknown() && !a.isFlexible;
    Operand b = expression(context, *e.right, adapts ? a.type() : inner);
    if (a.isUnknown() || b.isUnknown()) return unknown(context, e.range);
    if (kind == TokenKind::Power) return exptCall(context, a, b, e.range, e.operatorRange, hint);
    if (!op) return unknown(context, e.range);
    const std::string_view spelling = lex::spelling(kind);
    return compares ? compare(context, *op, spelling, a, b, e.range, e.operatorRange)
                    : combine(context, *op, spelling, a, b, e.range, e.operatorRange, hint);
}

/// An operator between two operands (edition 3, table 71).
///   ok:    b OR c; i MOD 2; d + t  with d : DT, t : TIME
///   wrong: b + c  with BOOL (P2006)   r MOD 2.0  (P2006)   t + d  with t : TIME, d : DATE (P2007)
///   advice: r := 1 / 2;  (P2029)
Operand combine(Context& context, BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                SourceRange operatorRange, TypeId hint) {
    if (a.isUnknown() || b.isUnknown() || isStrict(context, a) || isStrict(context, b)) return unknown(context, range);
    if (op == BinaryOp::And || op == BinaryOp::Or || op == BinaryOp::Xor) {
        const auto good = [&](const Operand& o) {
            return context.types.family(o.type()) == Family::Bool || types::isInteger(context.types.family(o.type()));
        };
        for (const Operand& o : {a, b}) {
            if (good(o)) continue;
            context.emit(o.expr->range, findings::OperatorNotForType(spelling, context.nameOf(o.type())));
            return unknown(context, range);
        }
        if (a.isFlexible && b.isFlexible) {
            if (hint.isValid() && context.types.family(hint) == Family::Bool) {
                a = converted(context, a, context.elementary(TypeKind::Bool));
                b = converted(context, b, context.elementary(TypeKind::Bool));
                if (a.isUnknown() || b.isUnknown()) return unknown(context, range);
                return makeBinary(context, op, context.elementary(TypeKind::Bool), a, b, range);
            }
            return foldFlexible(context, op, a, b, range);
        }
        const bool aBool = context.types.family(a.type()) == Family::Bool,
                   bBool = context.types.family(b.type()) == Family::Bool;
        TypeId type;
        if (aBool && bBool)
            type = context.elementary(TypeKind::Bool);
        else if (aBool || bBool) {
            const Operand& other = aBool ? b : a;
            type = other.isFlexible ? context.elementary(TypeKind::Bool) : context.types.storage(other.type());
            if (!other.isFlexible && context.types.family(other.type()) != Family::Bits) {
                context.emit(operatorRange, findings::OperandsDoNotMatch(spelling, context.nameOf(a.type()),
                                                                         context.nameOf(b.type())));
                return unknown(context, range);
            }
        } else {
            type = commonType(context, a, b);
            // bit strings stay bit strings beside integers of their width
            for (const Operand& o : {a, b})
                if (!o.isFlexible && context.types.family(o.type()) == Family::Bits &&
                    types::bitsOf(context.types.storageKind(o.type())) ==
                        types::bitsOf(context.types.storageKind(type)))
                    type = context.types.storage(o.type());
        }
        a = a.isFlexible ? converted(context, a, type) : convertNode(context, a, type);
        b = b.isFlexible ? converted(context, b, type) : convertNode(context, b, type);
        if (a.isUnknown() || b.isUnknown()) return unknown(context, range);
        return makeBinary(context, op, type, a, b, range);
    }
    // a character of a text counts as its code
    for (Operand* o : {&a, &b})
        if (context.types.family(o->type()) == Family::Character)
            *o = convertNode(context, *o,
                             context.elementary(context.types.storageKind(o->type()) == TypeKind::Char
                                                    ? TypeKind::Byte
                                                    : TypeKind::Word));
    if (isTimeFamily(context.types.family(a.type())) || isTimeFamily(context.types.family(b.type())))
        return arithmeticOnTimes(context, op, spelling, a, b, range, operatorRange);
    const bool pointerLeft = context.isKind(a.type(), TypeKind::Pointer),
               pointerRight = context.isKind(b.type(), TypeKind::Pointer);
    if ((pointerLeft || pointerRight) && (op == BinaryOp::Add || op == BinaryOp::Subtract)) {
        const TypeId lword = context.elementary(TypeKind::Lword);
        const auto bits = [&](Operand o) {
            return context.isKind(o.type(), TypeKind::Pointer) ? sameBits(context, o, lword)
                                                               : convertNode(context, settled(context, o), lword);
        };
        if ((pointerLeft || isNumeric(context, a.type())) && (pointerRight || isNumeric(context, b.type()))) {
            const Operand sum = makeBinary(context, op, lword, bits(a), bits(b), range);
            return pointerLeft && pointerRight ? sum : sameBits(context, sum, pointerLeft ? a.type() : b.type());
        }
    }
    if (!isNumeric(context, a.type()) || !isNumeric(context, b.type())) {
        const Operand& wrong = isNumeric(context, a.type()) ? b : a;
        const bool both = !isNumeric(context, a.type()) && !isNumeric(context, b.type());
        if (both && a.type() != b.type())
            context.emit(operatorRange,
                         findings::OperandsDoNotMatch(spelling, context.nameOf(a.type()), context.nameOf(b.type())));
        else
            context.emit(both ? operatorRange : wrong.expr->range,
                         findings::OperatorNotForType(spelling, context.nameOf(wrong.type())));
        return unknown(context, range);
    }
    if (a.isFlexible && b.isFlexible) return foldFlexible(context, op, a, b, range);
    TypeId type = commonType(context, a, b);
    if ((a.isFlexible || b.isFlexible) && context.types.family(type) == Family::Real && hint.isValid() &&
        context.types.family(hint) == Family::Real) {
        // an integer beside a real literal is computed in the real type that is wanted
        const Operand& other = a.isFlexible ? b : a;
        if (context.types.family(other.type()) != Family::Real) type = context.types.storage(hint);
    }
    if (op == BinaryOp::Modulo && context.types.family(type) == Family::Real) {
        context.emit(operatorRange, findings::OperatorNotForType(Verbatim("MOD"), context.nameOf(type)));
        return unknown(context, range);
    }
    const auto promote = [&](Operand o) {
        if (o.isFlexible) return converted(context, o, type);
        const tree::Expr& e = *o.expr;
        if (context.types.family(type) == Family::Real && e.kind == tree::ExprKind::Binary &&
            e.binary == BinaryOp::Divide && types::isInteger(context.types.family(o.type())))
            context.emit(e.range, findings::IntegerDivisionToReal(context.nameOf(type)));
        return convertNode(context, o, type);
    };
    a = promote(a);
    b = promote(b);
    if (a.isUnknown() || b.isUnknown()) return unknown(context, range);
    return makeBinary(context, op, type, a, b, range);
}

Operand arithmeticOnTimes(Context& context, BinaryOp op, std::string_view spelling, Operand a, Operand b,
                          SourceRange range, SourceRange operatorRange) {
    const Family f = context.types.family(a.type()), g = context.types.family(b.type());
    const auto isLong = [&](const Operand& o) {
        const TypeKind kind = context.types.storageKind(o.type());
        return kind == TypeKind::Ltime || kind == TypeKind::Ldate || kind == TypeKind::Ltod || kind == TypeKind::Ldt;
    };
    const TypeId duration = context.elementary(isLong(a) || isLong(b) ? TypeKind::Ltime : TypeKind::Time);
    const bool adds = op == BinaryOp::Add, subtracts = op == BinaryOp::Subtract;
    const auto as = [&](Operand o, TypeId type) { return sameBits(context, o, type); };
    if (f == Family::Duration && g == Family::Duration && (adds || subtracts || op == BinaryOp::Modulo))
        return makeBinary(context, op, duration, as(a, duration), as(b, duration), range);
    if (f == Family::Duration && g == Family::Duration && op == BinaryOp::Divide) {
        const TypeId lint = context.elementary(TypeKind::Lint);
        return makeBinary(context, op, lint, as(a, lint), as(b, lint), range);
    }
    if ((f == Family::TimeOfDay || f == Family::DateTime) && g == Family::Duration && (adds || subtracts)) {
        const TypeId type = context.types.storage(a.type());
        return makeBinary(context, op, type, as(a, type), as(b, type), range);
    }
    if (f == Family::Duration && (g == Family::TimeOfDay || g == Family::DateTime) && adds) {
        const TypeId type = context.types.storage(b.type());
        return makeBinary(context, op, type, as(b, type), as(a, type), range);
    }
    if (isTimeFamily(f) && f == g && f != Family::Duration && subtracts)
        return makeBinary(context, op, duration, as(a, duration), as(b, duration), range);
    if (f == Family::Duration && isNumeric(context, b.type()) && (op == BinaryOp::Multiply || op == BinaryOp::Divide)) {
        b = settled(context, b);
        if (op == BinaryOp::Divide && b.isConstant() && std::holds_alternative<int64_t>(b.expr->value.data) &&
            b.expr->value.integer() == 0) {
            context.emit(b.expr->range, findings::DivisionByConstantZero());
            return unknown(context, range);
        }
        return intrinsic(context,
                         op == BinaryOp::Multiply ? library::Intrinsic::MulDuration : library::Intrinsic::DivDuration,
                         context.types.storage(a.type()), {a, b}, range);
    }
    if (g == Family::Duration && isNumeric(context, a.type()) && op == BinaryOp::Multiply)
        return intrinsic(context, library::Intrinsic::MulDuration, context.types.storage(b.type()),
                         {b, settled(context, a)}, range);
    context.emit(operatorRange, findings::OperandsDoNotMatch(spelling, context.nameOf(settled(context, a).type()),
                                                             context.nameOf(settled(context, b).type())));
    return unknown(context, range);
}

///   ok:    s = 'a'; i < u  with INT and UINT
///   wrong: s = i  (P2007)   a = b  with arrays (P2040)      advice: l < u  with LINT and ULINT (P2031)
Operand compare(Context& context, BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                SourceRange operatorRange) {
    if (a.isUnknown() || b.isUnknown()) return unknown(context, range);
    if (a.isFlexible && b.isFlexible) return foldFlexible(context, op, a, b, range);
    const bool isEquality = op == BinaryOp::Equal || op == BinaryOp::NotEqual;
    const TypeKind x = context.types.kind(a.type()), y = context.types.kind(b.type());
    const auto isAddress = [](TypeKind k) {
        return k == TypeKind::Pointer || k == TypeKind::Reference || k == TypeKind::Interface || k == TypeKind::Null;
    };
    const auto isZero = [](const Operand& o) {
        return o.isConstant() && std::holds_alternative<int64_t>(o.expr->value.data) && o.expr->value.integer() == 0;
    };
    if (isAddress(x) || isAddress(y)) {
        if (isEquality && (isZero(a) || isZero(b)) && (isAddress(x) || isAddress(y))) {
            Operand null = isNull(context, isZero(a) ? b : a, range);
            return op == BinaryOp::Equal ? null : inverted(context, null, range);
        }
        const TypeId lword = context.elementary(TypeKind::Lword);
        const bool good = (isAddress(x) && isAddress(y)) || (x == TypeKind::Pointer && isNumeric(context, b.type())) ||
                          (y == TypeKind::Pointer && isNumeric(context, a.type())) ||
                          (x == TypeKind::Interface && y == TypeKind::Block) ||
                          (y == TypeKind::Interface && x == TypeKind::Block);
        if (good) {
            const auto bits = [&](Operand o) -> Operand {
                if (context.isKind(o.type(), TypeKind::Block))
                    o = addressOf(context, o.expr->place,
                                  context.isExpression ? lword : context.types.pointer(o.type()), o.expr->range);
                return isNumeric(context, o.type()) ? convertNode(context, settled(context, o), lword)
                                                    : sameBits(context, o, lword);
            };
            return makeBinary(context, op, lword, bits(a), bits(b), range);
        }
    }
    const auto refuse = [&] {
        context.emit(operatorRange, findings::OperandsDoNotMatch(spelling, context.nameOf(settled(context, a).type()),
                                                                 context.nameOf(settled(context, b).type())));
        return unknown(context, range);
    };
    const Family f = context.types.family(a.type()), g = context.types.family(b.type());
    const bool textA = context.types.isText(a.type()), textB = context.types.isText(b.type());
    if (textA || textB) {
        const auto isChar = [](Family family) { return family == Family::Character; };
        if (textA && textB) {
            TypeId type = context.types[a.type()].capacity >= context.types[b.type()].capacity ? a.type() : b.type();
            if (context.types.kind(a.type()) != context.types.kind(b.type())) {
                type = context.isKind(a.type(), TypeKind::Wstring) ? a.type() : b.type();
                if (context.isKind(a.type(), TypeKind::String))
                    a = convertedText(context, a, type);
                else
                    b = convertedText(context, b, type);
                if (a.isUnknown() || b.isUnknown()) return unknown(context, range);
                type = context.types[a.type()].capacity >= context.types[b.type()].capacity ? a.type() : b.type();
            }
            return makeBinary(context, op, type, a, b, range);
        }
        Operand& text = textA ? a : b;
        Operand& other = textA ? b : a;
        if (isChar(context.types.family(other.type()))) {
            const auto* narrow = std::get_if<std::string>(&text.expr->value.data);
            const auto* wide = std::get_if<std::u16string>(&text.expr->value.data);
            const bool one = text.isConstant() && ((narrow && narrow->size() == 1) || (wide && wide->size() == 1));
            if (one) {
                text = converted(context, text, other.type());
                if (text.isUnknown()) return unknown(context, range);
                return makeBinary(context, op, other.type(), a, b, range);
            }
            other = convertNode(context, other, text.type());
            return makeBinary(context, op, text.type(), a, b, range);
        }
        if (text.isConstant() && types::isInteger(context.types.family(other.type()))) { // s[i] was stored in a BYTE
            const Operand code = converted(context, text, context.types.storage(other.type()));
            if (code.isUnknown()) return unknown(context, range);
            text = code;
            return makeBinary(context, op, context.types.storage(other.type()), textA ? code : a, textA ? b : code,
                              range);
        }
        return refuse();
    }
    const auto reads = [&](Operand o, TypeId type) {
        return o.isFlexible ? converted(context, o, type) : convertNode(context, o, type);
    };
    if (f == Family::Bool || g == Family::Bool) {
        const TypeId boolean = context.elementary(TypeKind::Bool);
        if (f == g) return makeBinary(context, op, boolean, a, b, range);
        Operand& other = f == Family::Bool ? b : a;
        Operand& truth = f == Family::Bool ? a : b;
        if (other.isFlexible && std::holds_alternative<int64_t>(other.expr->value.data)) {
            other = converted(context, other, boolean);
            if (other.isUnknown()) return unknown(context, range);
            return makeBinary(context, op, boolean, a, b, range);
        }
        if (truth.isConstant() && isNumeric(context, other.type())) {
            truth = convertNode(context, truth, context.types.storage(other.type()));
            return makeBinary(context, op, context.types.storage(other.type()), a, b, range);
        }
        return refuse();
    }
    for (Operand* o : {&a, &b}) {
        const Operand& other = o == &a ? b : a;
        if (context.types.family(o->type()) == Family::Character &&
            context.types.family(other.type()) != Family::Character)
            *o = convertNode(context, *o,
                             context.elementary(context.types.storageKind(o->type()) == TypeKind::Char
                                                    ? TypeKind::Byte
                                                    : TypeKind::Word));
    }
    if (isTimeFamily(f) && f == g) {
        const TypeId type = context.types.storage(
            types::implicitConversion(context.types, b.type(), a.type()) == types::Implicit::Narrowing ? b.type()
                                                                                                       : a.type());
        return makeBinary(context, op, type, sameBits(context, a, type), sameBits(context, b, type), range);
    }
    if (context.isKind(a.type(), TypeKind::Enum) && context.isKind(b.type(), TypeKind::Enum) &&
        !sameType(context.world, a.type(), b.type()))
        return refuse();
    if (context.types.family(a.type()) == Family::Character && context.types.family(b.type()) == Family::Character) {
        const TypeId type = context.elementary(context.types.storageKind(a.type()) == TypeKind::Wchar
                                                   ? TypeKind::Wchar
                                                   : context.types.storageKind(b.type()));
        return makeBinary(context, op, type, convertNode(context, a, type), convertNode(context, b, type), range);
    }
    if (!isNumeric(context, a.type()) || !isNumeric(context, b.type())) {
        if (context.types.isAggregate(a.type()) && context.types.isAggregate(b.type())) {
            context.emit(operatorRange, findings::CompareWhole(spelling, context.nameOf(a.type())));
            return unknown(context, range);
        }
        if (a.type() == b.type()) {
            context.emit(operatorRange, findings::OperatorNotForType(spelling, context.nameOf(a.type())));
            return unknown(context, range);
        }
        return refuse();
    }
    TypeId type = commonType(context, a, b);
    const Family p = context.types.family(a.type()), q = context.types.family(b.type());
    if (!a.isFlexible && !b.isFlexible && types::isInteger(p) && types::isInteger(q) &&
        (p == Family::Signed) != (q == Family::Signed)) {
        // the type that holds both: the next wider signed one
        Operand& isSigned = p == Family::Signed ? a : b;
        Operand& isUnsigned = p == Family::Signed ? b : a;
        const unsigned width = types::bitsOf(context.types.storageKind(isUnsigned.type()));
        const unsigned signedWidth = types::bitsOf(context.types.storageKind(isSigned.type()));
        if (isSigned.isConstant() && isSigned.expr->value.integer() >= 0 &&
            fits(context, isSigned.expr->value, context.types.storage(isUnsigned.type())))
            type = context.types.storage(isUnsigned.type());
        else if (isUnsigned.isConstant() &&
                 fits(context, isUnsigned.expr->value, context.types.storage(isSigned.type())))
            type = context.types.storage(isSigned.type());
        else if (width < signedWidth)
            type = context.types.storage(isSigned.type());
        else if (width < 64)
            type = context.elementary(width == 32 ? TypeKind::Lint : width == 16 ? TypeKind::Dint : TypeKind::Int);
        else {
            type = context.types.storage(isUnsigned.type());
            context.emit(operatorRange, findings::SignedUnsignedMix(context.nameOf(a.type()), context.nameOf(b.type()),
                                                                    context.nameOf(type)));
        }
    }
    a = reads(a, type);
    b = reads(b, type);
    if (a.isUnknown() || b.isUnknown()) return unknown(context, range);
    return makeBinary(context, op, type, a, b, range);
}

Operand logical(Context& context, const syntax::Expr& e, TypeId hint) {
    const bool shortCircuit = e.op == TokenKind::AndThen || e.op == TokenKind::OrElse;
    const TypeId boolean = context.elementary(TypeKind::Bool);
    const bool wantsBits =
        hint.isValid() && (context.types.family(hint) == Family::Bool || types::isInteger(context.types.family(hint)));
    if (shortCircuit) {
        tree::Expr* a = condition(context, *e.base);
        tree::Expr* b = condition(context, *e.right);
        if (context.isKind(a->type, TypeKind::Unknown) || context.isKind(b->type, TypeKind::Unknown))
            return unknown(context, e.range);
        const bool isAnd = e.op == TokenKind::AndThen;
        if (a->kind == tree::ExprKind::Constant && b->kind == tree::ExprKind::Constant)
            return constant(context,
                            {boolean, int64_t(isAnd ? a->value.isTrue() && b->value.isTrue()
                                                    : a->value.isTrue() || b->value.isTrue())},
                            e.range);
        tree::Expr* out = context.arena.make<tree::Expr>();
        out->kind = isAnd ? tree::ExprKind::AndThen : tree::ExprKind::OrElse;
        out->type = boolean;
        out->range = e.range;
        out->a = a;
        out->b = b;
        return {out, &context.types};
    }
    Operand a = expression(context, *e.base, wantsBits ? hint : TypeId());
    Operand b = expression(context, *e.right, !a.isUnknown() && !a.isFlexible ? a.type() : wantsBits ? hint : TypeId());
    if (a.isUnknown() || b.isUnknown()) return unknown(context, e.range);
    return combine(context, *operatorOf(e.op), lex::spelling(e.op), a, b, e.range, e.operatorRange, hint);
}

Operand intrinsic(Context& context, library::Intrinsic code, TypeId result, std::vector<Operand> operands,
                  SourceRange range, int64_t selector) {
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
