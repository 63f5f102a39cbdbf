// Operators: operand types are made equal, constants are folded with the library's reference semantics.
#include "runtime/compiler/sema/checker.h"

#include "runtime/types/conversion.h"

#include <cmath>

namespace plc::sema {

using lex::TokenKind;
using library::BinaryOp;
using types::Family;

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
Operand Checker::makeBinary(BinaryOp op, TypeId operandType, Operand a, Operand b, SourceRange range) {
    const TypeId result = isCompare(op) ? elementary(TypeKind::Bool) : operandType;
    const bool divides = op == BinaryOp::Divide || op == BinaryOp::Modulo;
    const Family family = types.family(operandType);
    if (divides && b.isConstant() && std::holds_alternative<int64_t>(b.expr->value.data) &&
        b.expr->value.integer() == 0 && family != Family::Real) {
        emit(b.expr->range, findings::DivisionByConstantZero());
        return unknown(range);
    }
    if (a.isConstant() && b.isConstant()) {
        const library::Evaluated folded = library::evaluateBinary(types, op, operandType, a.expr->value, b.expr->value);
        if (folded.error == library::EvaluationError::None && folded.value.hasValue()) {
            types::Value value = folded.value;
            if (!types.isText(result)) value.type = result;
            return constant(std::move(value), range);
        }
    }
    tree::Expr* e = arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Binary;
    e->binary = op;
    e->type = result;
    e->operandType = operandType;
    e->range = range;
    e->a = a.expr;
    e->b = b.expr;
    return {e, &types};
}

/// Both operands are literals without a type: computed with all bits there are, and still flexible.
Operand Checker::foldFlexible(BinaryOp op, Operand a, Operand b, SourceRange range) {
    const types::Value &x = a.expr->value, &y = b.expr->value;
    if (std::holds_alternative<double>(x.data) || std::holds_alternative<double>(y.data)) {
        const auto number = [](const types::Value& v) {
            return std::holds_alternative<double>(v.data) ? v.real() : static_cast<double>(v.integer());
        };
        types::Value left{elementary(TypeKind::Lreal), number(x)}, right{elementary(TypeKind::Lreal), number(y)};
        if (op == BinaryOp::Modulo) {
            emit(range, findings::OperatorNotForType(Verbatim("MOD"), Verbatim("REAL")));
            return unknown(range);
        }
        if (op == BinaryOp::Divide && right.real() == 0) {
            emit(b.expr->range, findings::DivisionByConstantZero());
            return unknown(range);
        }
        const library::Evaluated folded = library::evaluateBinary(types, op, elementary(TypeKind::Lreal), left, right);
        if (!folded.value.hasValue()) return unknown(range);
        return constant(folded.value, range, !isCompare(op));
    }
    const auto wide = [&](const types::Value& v) -> __int128 {
        return types.storageKind(v.type) == TypeKind::Ulint ? static_cast<__int128>(static_cast<uint64_t>(v.integer()))
                                                            : v.integer();
    };
    const __int128 left = wide(x), right = wide(y);
    __int128 result = 0;
    const auto truth = [&](bool value) { return constant({elementary(TypeKind::Bool), int64_t(value)}, range); };
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
            emit(b.expr->range, findings::DivisionByConstantZero());
            return unknown(range);
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
        emit(range, findings::ConstantOutOfRange(textOf(range), Verbatim("LINT")));
        return unknown(range);
    }
    Operand out = constant({elementary(result > INT64_MAX ? TypeKind::Ulint : TypeKind::Lint),
                            static_cast<int64_t>(static_cast<uint64_t>(result))},
                           range, true);
    out.isDivided = (op == BinaryOp::Divide && left % right != 0) || a.isDivided || b.isDivided;
    return out;
}

Operand Checker::unary(const syntax::Expr& e, TypeId hint) {
    Operand operand = expression(*e.base, hint);
    if (operand.isUnknown()) return unknown(e.range);
    if (e.op == TokenKind::Plus) {
        if (!isNumeric(operand.type()) && types.family(operand.type()) != Family::Duration) {
            emit(e.range, findings::OperatorNotForType(Verbatim("+"), nameOf(operand.type())));
            return unknown(e.range);
        }
        return operand;
    }
    if (e.op == TokenKind::Not) {
        if (operand.isFlexible && hint.isValid() && types.storageKind(hint) == TypeKind::Bool)
            operand = converted(operand, elementary(TypeKind::Bool));
        else if (operand.isFlexible && hint.isValid() && types::isInteger(types.family(hint)))
            operand = converted(operand, hint);
        return inverted(operand, e.range);
    }
    return negated(operand, e.range);
}

///   ok:    -i      wrong: -s  with s : STRING (P2006)
Operand Checker::negated(Operand operand, SourceRange range) {
    if (operand.isUnknown()) return operand;
    if (isStrict(operand)) return unknown(range);
    const Family family = types.family(operand.type());
    if (operand.isFlexible) {
        const types::Value& value = operand.expr->value;
        if (std::holds_alternative<double>(value.data)) return constant({value.type, -value.real()}, range, true);
        if (types.storageKind(value.type) == TypeKind::Ulint && value.integer() != INT64_MIN) {
            emit(range, findings::ConstantOutOfRange(textOf(range), Verbatim("LINT")));
            return unknown(range);
        }
        return constant({elementary(TypeKind::Lint), static_cast<int64_t>(0 - static_cast<uint64_t>(value.integer()))},
                        range, true);
    }
    if (!isNumeric(operand.type()) && family != Family::Duration) {
        emit(range, findings::OperatorNotForType(Verbatim("-"), nameOf(operand.type())));
        return unknown(range);
    }
    const TypeId type = types.storage(operand.type());
    if (operand.type() != type) operand = convertNode(operand, type);
    if (operand.isConstant()) {
        const library::Evaluated folded =
            library::evaluateUnary(types, library::UnaryOp::Negate, type, operand.expr->value);
        if (folded.value.hasValue()) return constant({type, folded.value.data}, range);
    }
    tree::Expr* out = arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Unary;
    out->unary = library::UnaryOp::Negate;
    out->type = type;
    out->range = range;
    out->a = operand.expr;
    return {out, &types};
}

///   ok:    NOT w      wrong: NOT r  with r : REAL (P2006)
Operand Checker::inverted(Operand operand, SourceRange range) {
    if (operand.isUnknown()) return operand;
    operand = settled(operand);
    if (isStrict(operand)) return unknown(range);
    const Family family = types.family(operand.type());
    if (family != Family::Bool && !types::isInteger(family)) {
        emit(range, findings::OperatorNotForType(Verbatim("NOT"), nameOf(operand.type())));
        return unknown(range);
    }
    const TypeId type = types.storage(operand.type());
    if (operand.type() != type) operand = convertNode(operand, type);
    if (operand.isConstant()) {
        const library::Evaluated folded =
            library::evaluateUnary(types, library::UnaryOp::Not, type, operand.expr->value);
        if (folded.value.hasValue()) return constant({type, folded.value.data}, range);
    }
    tree::Expr* out = arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Unary;
    out->unary = library::UnaryOp::Not;
    out->type = type;
    out->range = range;
    out->a = operand.expr;
    return {out, &types};
}

Operand Checker::binary(const syntax::Expr& e, TypeId hint) {
    const TokenKind kind = e.op;
    if (kind == TokenKind::And || kind == TokenKind::Ampersand || kind == TokenKind::Or || kind == TokenKind::Xor ||
        kind == TokenKind::AndThen || kind == TokenKind::OrElse)
        return logical(e, hint);
    const std::optional<BinaryOp> op = operatorOf(kind);
    const bool compares = op && isCompare(*op);
    const TypeId inner =
        compares || !hint.isValid() || !(isNumeric(hint) || isTimeFamily(types.family(hint))) ? TypeId() : hint;
    Operand a = expression(*e.base, inner);
    const bool adapts = compares && !a.isUnknown() && !a.isFlexible;
    Operand b = expression(*e.right, adapts ? a.type() : inner);
    if (a.isUnknown() || b.isUnknown()) return unknown(e.range);
    if (kind == TokenKind::Power) return exptCall(a, b, e.range, e.operatorRange, hint);
    if (!op) return unknown(e.range);
    const std::string_view spelling = lex::spelling(kind);
    return compares ? compare(*op, spelling, a, b, e.range, e.operatorRange)
                    : combine(*op, spelling, a, b, e.range, e.operatorRange, hint);
}

/// An operator between two operands (edition 3, table 71).
///   ok:    b OR c; i MOD 2; d + t  with d : DT, t : TIME
///   wrong: b + c  with BOOL (P2006)   r MOD 2.0  (P2006)   t + d  with t : TIME, d : DATE (P2007)
///   advice: r := 1 / 2;  (P2029)
Operand Checker::combine(BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                         SourceRange operatorRange, TypeId hint) {
    if (a.isUnknown() || b.isUnknown() || isStrict(a) || isStrict(b)) return unknown(range);
    if (op == BinaryOp::And || op == BinaryOp::Or || op == BinaryOp::Xor) {
        const auto good = [&](const Operand& o) {
            return types.family(o.type()) == Family::Bool || types::isInteger(types.family(o.type()));
        };
        for (const Operand& o : {a, b}) {
            if (good(o)) continue;
            emit(o.expr->range, findings::OperatorNotForType(spelling, nameOf(o.type())));
            return unknown(range);
        }
        if (a.isFlexible && b.isFlexible) {
            if (hint.isValid() && types.family(hint) == Family::Bool) {
                a = converted(a, elementary(TypeKind::Bool));
                b = converted(b, elementary(TypeKind::Bool));
                if (a.isUnknown() || b.isUnknown()) return unknown(range);
                return makeBinary(op, elementary(TypeKind::Bool), a, b, range);
            }
            return foldFlexible(op, a, b, range);
        }
        const bool aBool = types.family(a.type()) == Family::Bool, bBool = types.family(b.type()) == Family::Bool;
        TypeId type;
        if (aBool && bBool)
            type = elementary(TypeKind::Bool);
        else if (aBool || bBool) {
            const Operand& other = aBool ? b : a;
            type = other.isFlexible ? elementary(TypeKind::Bool) : types.storage(other.type());
            if (!other.isFlexible && types.family(other.type()) != Family::Bits) {
                emit(operatorRange, findings::OperandsDoNotMatch(spelling, nameOf(a.type()), nameOf(b.type())));
                return unknown(range);
            }
        } else {
            type = commonType(a, b);
            // bit strings stay bit strings beside integers of their width
            for (const Operand& o : {a, b})
                if (!o.isFlexible && types.family(o.type()) == Family::Bits &&
                    types::bitsOf(types.storageKind(o.type())) == types::bitsOf(types.storageKind(type)))
                    type = types.storage(o.type());
        }
        a = a.isFlexible ? converted(a, type) : convertNode(a, type);
        b = b.isFlexible ? converted(b, type) : convertNode(b, type);
        if (a.isUnknown() || b.isUnknown()) return unknown(range);
        return makeBinary(op, type, a, b, range);
    }
    // a character of a text counts as its code
    for (Operand* o : {&a, &b})
        if (types.family(o->type()) == Family::Character)
            *o = convertNode(
                *o, elementary(types.storageKind(o->type()) == TypeKind::Char ? TypeKind::Byte : TypeKind::Word));
    if (isTimeFamily(types.family(a.type())) || isTimeFamily(types.family(b.type())))
        return arithmeticOnTimes(op, spelling, a, b, range, operatorRange);
    const bool pointerLeft = isKind(a.type(), TypeKind::Pointer), pointerRight = isKind(b.type(), TypeKind::Pointer);
    if ((pointerLeft || pointerRight) && (op == BinaryOp::Add || op == BinaryOp::Subtract)) {
        const TypeId lword = elementary(TypeKind::Lword);
        const auto bits = [&](Operand o) {
            return isKind(o.type(), TypeKind::Pointer) ? sameBits(o, lword) : convertNode(settled(o), lword);
        };
        if ((pointerLeft || isNumeric(a.type())) && (pointerRight || isNumeric(b.type()))) {
            const Operand sum = makeBinary(op, lword, bits(a), bits(b), range);
            return pointerLeft && pointerRight ? sum : sameBits(sum, pointerLeft ? a.type() : b.type());
        }
    }
    if (!isNumeric(a.type()) || !isNumeric(b.type())) {
        const Operand& wrong = isNumeric(a.type()) ? b : a;
        const bool both = !isNumeric(a.type()) && !isNumeric(b.type());
        if (both && a.type() != b.type())
            emit(operatorRange, findings::OperandsDoNotMatch(spelling, nameOf(a.type()), nameOf(b.type())));
        else
            emit(both ? operatorRange : wrong.expr->range,
                 findings::OperatorNotForType(spelling, nameOf(wrong.type())));
        return unknown(range);
    }
    if (a.isFlexible && b.isFlexible) return foldFlexible(op, a, b, range);
    TypeId type = commonType(a, b);
    if ((a.isFlexible || b.isFlexible) && types.family(type) == Family::Real && hint.isValid() &&
        types.family(hint) == Family::Real) {
        // an integer beside a real literal is computed in the real type that is wanted
        const Operand& other = a.isFlexible ? b : a;
        if (types.family(other.type()) != Family::Real) type = types.storage(hint);
    }
    if (op == BinaryOp::Modulo && types.family(type) == Family::Real) {
        emit(operatorRange, findings::OperatorNotForType(Verbatim("MOD"), nameOf(type)));
        return unknown(range);
    }
    const auto promote = [&](Operand o) {
        if (o.isFlexible) return converted(o, type);
        const tree::Expr& e = *o.expr;
        if (types.family(type) == Family::Real && e.kind == tree::ExprKind::Binary && e.binary == BinaryOp::Divide &&
            types::isInteger(types.family(o.type())))
            emit(e.range, findings::IntegerDivisionToReal(nameOf(type)));
        return convertNode(o, type);
    };
    a = promote(a);
    b = promote(b);
    if (a.isUnknown() || b.isUnknown()) return unknown(range);
    return makeBinary(op, type, a, b, range);
}

Operand Checker::arithmeticOnTimes(BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                                   SourceRange operatorRange) {
    const Family f = types.family(a.type()), g = types.family(b.type());
    const auto isLong = [&](const Operand& o) {
        const TypeKind kind = types.storageKind(o.type());
        return kind == TypeKind::Ltime || kind == TypeKind::Ldate || kind == TypeKind::Ltod || kind == TypeKind::Ldt;
    };
    const TypeId duration = elementary(isLong(a) || isLong(b) ? TypeKind::Ltime : TypeKind::Time);
    const bool adds = op == BinaryOp::Add, subtracts = op == BinaryOp::Subtract;
    const auto as = [&](Operand o, TypeId type) { return sameBits(o, type); };
    if (f == Family::Duration && g == Family::Duration && (adds || subtracts || op == BinaryOp::Modulo))
        return makeBinary(op, duration, as(a, duration), as(b, duration), range);
    if (f == Family::Duration && g == Family::Duration && op == BinaryOp::Divide) {
        const TypeId lint = elementary(TypeKind::Lint);
        return makeBinary(op, lint, as(a, lint), as(b, lint), range);
    }
    if ((f == Family::TimeOfDay || f == Family::DateTime) && g == Family::Duration && (adds || subtracts)) {
        const TypeId type = types.storage(a.type());
        return makeBinary(op, type, as(a, type), as(b, type), range);
    }
    if (f == Family::Duration && (g == Family::TimeOfDay || g == Family::DateTime) && adds) {
        const TypeId type = types.storage(b.type());
        return makeBinary(op, type, as(b, type), as(a, type), range);
    }
    if (isTimeFamily(f) && f == g && f != Family::Duration && subtracts)
        return makeBinary(op, duration, as(a, duration), as(b, duration), range);
    if (f == Family::Duration && isNumeric(b.type()) && (op == BinaryOp::Multiply || op == BinaryOp::Divide)) {
        b = settled(b);
        if (op == BinaryOp::Divide && b.isConstant() && std::holds_alternative<int64_t>(b.expr->value.data) &&
            b.expr->value.integer() == 0) {
            emit(b.expr->range, findings::DivisionByConstantZero());
            return unknown(range);
        }
        return intrinsic(op == BinaryOp::Multiply ? library::Intrinsic::MulDuration : library::Intrinsic::DivDuration,
                         types.storage(a.type()), {a, b}, range);
    }
    if (g == Family::Duration && isNumeric(a.type()) && op == BinaryOp::Multiply)
        return intrinsic(library::Intrinsic::MulDuration, types.storage(b.type()), {b, settled(a)}, range);
    emit(operatorRange, findings::OperandsDoNotMatch(spelling, nameOf(settled(a).type()), nameOf(settled(b).type())));
    return unknown(range);
}

///   ok:    s = 'a'; i < u  with INT and UINT
///   wrong: s = i  (P2007)   a = b  with arrays (P2040)      advice: l < u  with LINT and ULINT (P2031)
Operand Checker::compare(BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                         SourceRange operatorRange) {
    if (a.isUnknown() || b.isUnknown()) return unknown(range);
    if (a.isFlexible && b.isFlexible) return foldFlexible(op, a, b, range);
    const bool isEquality = op == BinaryOp::Equal || op == BinaryOp::NotEqual;
    const TypeKind x = types.kind(a.type()), y = types.kind(b.type());
    const auto isAddress = [](TypeKind k) {
        return k == TypeKind::Pointer || k == TypeKind::Reference || k == TypeKind::Interface || k == TypeKind::Null;
    };
    const auto isZero = [](const Operand& o) {
        return o.isConstant() && std::holds_alternative<int64_t>(o.expr->value.data) && o.expr->value.integer() == 0;
    };
    if (isAddress(x) || isAddress(y)) {
        if (isEquality && (isZero(a) || isZero(b)) && (isAddress(x) || isAddress(y))) {
            Operand null = isNull(isZero(a) ? b : a, range);
            return op == BinaryOp::Equal ? null : inverted(null, range);
        }
        const TypeId lword = elementary(TypeKind::Lword);
        const bool good = (isAddress(x) && isAddress(y)) || (x == TypeKind::Pointer && isNumeric(b.type())) ||
                          (y == TypeKind::Pointer && isNumeric(a.type())) ||
                          (x == TypeKind::Interface && y == TypeKind::Block) ||
                          (y == TypeKind::Interface && x == TypeKind::Block);
        if (good) {
            const auto bits = [&](Operand o) -> Operand {
                if (isKind(o.type(), TypeKind::Block))
                    o = addressOf(o.expr->place, world.frozen ? lword : types.pointer(o.type()), o.expr->range);
                return isNumeric(o.type()) ? convertNode(settled(o), lword) : sameBits(o, lword);
            };
            return makeBinary(op, lword, bits(a), bits(b), range);
        }
    }
    const auto refuse = [&] {
        emit(operatorRange,
             findings::OperandsDoNotMatch(spelling, nameOf(settled(a).type()), nameOf(settled(b).type())));
        return unknown(range);
    };
    const Family f = types.family(a.type()), g = types.family(b.type());
    const bool textA = types.isText(a.type()), textB = types.isText(b.type());
    if (textA || textB) {
        const auto isChar = [](Family family) { return family == Family::Character; };
        if (textA && textB) {
            TypeId type = types[a.type()].capacity >= types[b.type()].capacity ? a.type() : b.type();
            if (types.kind(a.type()) != types.kind(b.type())) {
                type = isKind(a.type(), TypeKind::Wstring) ? a.type() : b.type();
                if (isKind(a.type(), TypeKind::String))
                    a = convertedText(a, type);
                else
                    b = convertedText(b, type);
                if (a.isUnknown() || b.isUnknown()) return unknown(range);
                type = types[a.type()].capacity >= types[b.type()].capacity ? a.type() : b.type();
            }
            return makeBinary(op, type, a, b, range);
        }
        Operand& text = textA ? a : b;
        Operand& other = textA ? b : a;
        if (isChar(types.family(other.type()))) {
            const auto* narrow = std::get_if<std::string>(&text.expr->value.data);
            const auto* wide = std::get_if<std::u16string>(&text.expr->value.data);
            const bool one = text.isConstant() && ((narrow && narrow->size() == 1) || (wide && wide->size() == 1));
            if (one) {
                text = converted(text, other.type());
                if (text.isUnknown()) return unknown(range);
                return makeBinary(op, other.type(), a, b, range);
            }
            other = convertNode(other, text.type());
            return makeBinary(op, text.type(), a, b, range);
        }
        if (text.isConstant() && types::isInteger(types.family(other.type()))) { // s[i] was stored in a BYTE
            const Operand code = converted(text, types.storage(other.type()));
            if (code.isUnknown()) return unknown(range);
            text = code;
            return makeBinary(op, types.storage(other.type()), textA ? code : a, textA ? b : code, range);
        }
        return refuse();
    }
    const auto reads = [&](Operand o, TypeId type) { return o.isFlexible ? converted(o, type) : convertNode(o, type); };
    if (f == Family::Bool || g == Family::Bool) {
        const TypeId boolean = elementary(TypeKind::Bool);
        if (f == g) return makeBinary(op, boolean, a, b, range);
        Operand& other = f == Family::Bool ? b : a;
        Operand& truth = f == Family::Bool ? a : b;
        if (other.isFlexible && std::holds_alternative<int64_t>(other.expr->value.data)) {
            other = converted(other, boolean);
            if (other.isUnknown()) return unknown(range);
            return makeBinary(op, boolean, a, b, range);
        }
        if (truth.isConstant() && isNumeric(other.type())) {
            truth = convertNode(truth, types.storage(other.type()));
            return makeBinary(op, types.storage(other.type()), a, b, range);
        }
        return refuse();
    }
    for (Operand* o : {&a, &b}) {
        const Operand& other = o == &a ? b : a;
        if (types.family(o->type()) == Family::Character && types.family(other.type()) != Family::Character)
            *o = convertNode(
                *o, elementary(types.storageKind(o->type()) == TypeKind::Char ? TypeKind::Byte : TypeKind::Word));
    }
    if (isTimeFamily(f) && f == g) {
        const TypeId type = types.storage(
            types::implicitConversion(types, b.type(), a.type()) == types::Implicit::Narrowing ? b.type() : a.type());
        return makeBinary(op, type, sameBits(a, type), sameBits(b, type), range);
    }
    if (isKind(a.type(), TypeKind::Enum) && isKind(b.type(), TypeKind::Enum) && !world.sameType(a.type(), b.type()))
        return refuse();
    if (types.family(a.type()) == Family::Character && types.family(b.type()) == Family::Character) {
        const TypeId type =
            elementary(types.storageKind(a.type()) == TypeKind::Wchar ? TypeKind::Wchar : types.storageKind(b.type()));
        return makeBinary(op, type, convertNode(a, type), convertNode(b, type), range);
    }
    if (!isNumeric(a.type()) || !isNumeric(b.type())) {
        if (types.isAggregate(a.type()) && types.isAggregate(b.type())) {
            emit(operatorRange, findings::CompareWhole(spelling, nameOf(a.type())));
            return unknown(range);
        }
        if (a.type() == b.type()) {
            emit(operatorRange, findings::OperatorNotForType(spelling, nameOf(a.type())));
            return unknown(range);
        }
        return refuse();
    }
    TypeId type = commonType(a, b);
    const Family p = types.family(a.type()), q = types.family(b.type());
    if (!a.isFlexible && !b.isFlexible && types::isInteger(p) && types::isInteger(q) &&
        (p == Family::Signed) != (q == Family::Signed)) {
        // the type that holds both: the next wider signed one
        Operand& isSigned = p == Family::Signed ? a : b;
        Operand& isUnsigned = p == Family::Signed ? b : a;
        const unsigned width = types::bitsOf(types.storageKind(isUnsigned.type()));
        const unsigned signedWidth = types::bitsOf(types.storageKind(isSigned.type()));
        if (isSigned.isConstant() && isSigned.expr->value.integer() >= 0 &&
            fits(isSigned.expr->value, types.storage(isUnsigned.type())))
            type = types.storage(isUnsigned.type());
        else if (isUnsigned.isConstant() && fits(isUnsigned.expr->value, types.storage(isSigned.type())))
            type = types.storage(isSigned.type());
        else if (width < signedWidth)
            type = types.storage(isSigned.type());
        else if (width < 64)
            type = elementary(width == 32 ? TypeKind::Lint : width == 16 ? TypeKind::Dint : TypeKind::Int);
        else {
            type = types.storage(isUnsigned.type());
            emit(operatorRange, findings::SignedUnsignedMix(nameOf(a.type()), nameOf(b.type()), nameOf(type)));
        }
    }
    a = reads(a, type);
    b = reads(b, type);
    if (a.isUnknown() || b.isUnknown()) return unknown(range);
    return makeBinary(op, type, a, b, range);
}

Operand Checker::logical(const syntax::Expr& e, TypeId hint) {
    const bool shortCircuit = e.op == TokenKind::AndThen || e.op == TokenKind::OrElse;
    const TypeId boolean = elementary(TypeKind::Bool);
    const bool wantsBits =
        hint.isValid() && (types.family(hint) == Family::Bool || types::isInteger(types.family(hint)));
    if (shortCircuit) {
        tree::Expr* a = condition(*e.base);
        tree::Expr* b = condition(*e.right);
        if (isKind(a->type, TypeKind::Unknown) || isKind(b->type, TypeKind::Unknown)) return unknown(e.range);
        const bool isAnd = e.op == TokenKind::AndThen;
        if (a->kind == tree::ExprKind::Constant && b->kind == tree::ExprKind::Constant)
            return constant({boolean, int64_t(isAnd ? a->value.isTrue() && b->value.isTrue()
                                                    : a->value.isTrue() || b->value.isTrue())},
                            e.range);
        tree::Expr* out = arena.make<tree::Expr>();
        out->kind = isAnd ? tree::ExprKind::AndThen : tree::ExprKind::OrElse;
        out->type = boolean;
        out->range = e.range;
        out->a = a;
        out->b = b;
        return {out, &types};
    }
    Operand a = expression(*e.base, wantsBits ? hint : TypeId());
    Operand b = expression(*e.right, !a.isUnknown() && !a.isFlexible ? a.type() : wantsBits ? hint : TypeId());
    if (a.isUnknown() || b.isUnknown()) return unknown(e.range);
    return combine(*operatorOf(e.op), lex::spelling(e.op), a, b, e.range, e.operatorRange, hint);
}

Operand Checker::intrinsic(library::Intrinsic code, TypeId result, std::vector<Operand> operands, SourceRange range,
                           int64_t selector) {
    bool allConstant = !operands.empty();
    for (const Operand& operand : operands) {
        if (operand.isUnknown()) return unknown(range);
        allConstant = allConstant && operand.isConstant();
    }
    if (allConstant) {
        std::vector<types::Value> values;
        for (const Operand& operand : operands) values.push_back(operand.expr->value);
        const library::Evaluated folded = library::evaluateIntrinsic(types, code, result, values, nullptr, selector);
        if (folded.error == library::EvaluationError::None && folded.ok && folded.value.hasValue()) {
            types::Value value = folded.value;
            value.type = result;
            return constant(std::move(value), range);
        }
    }
    tree::Expr* e = arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Intrinsic;
    e->intrinsic = code;
    e->type = result;
    e->range = range;
    e->selector = selector;
    for (const Operand& operand : operands) e->operands.push_back(operand.expr);
    return {e, &types};
}

} // namespace plc::sema
