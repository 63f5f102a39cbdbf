// Arithmetic and bit operators between two operands: what types go together, and in which type they are computed
// (edition 3, table 71). A function for each family of operands.
#include "runtime/compiler/sema/operators/operation.h"
#include "runtime/compiler/sema/operators/operators.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

using library::BinaryOp;
using types::Family;

// A CHAR in a calculation is its code: 'A' + 1. Comparisons of two characters do not come here.
Operand characterCode(Context& context, Operand operand) {
    if (context.types.family(operand.type()) != Family::Character) return operand;
    const bool isNarrow = context.types.storageKind(operand.type()) == TypeKind::Char;
    return convertNode(context, operand, context.elementary(isNarrow ? TypeKind::Byte : TypeKind::Word));
}

namespace {

// Literals are folded in LREAL and take their type later: 0.1 + 0.2 in a REAL assignment is rounded once, not twice.
Operand foldReals(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    const TypeId lreal = context.elementary(TypeKind::Lreal);
    const auto number = [&](const types::Value& v) {
        return types::Value{lreal,
                            std::holds_alternative<double>(v.data) ? v.real() : static_cast<double>(v.integer())};
    };
    const types::Value left = number(a.expr->value), right = number(b.expr->value);
    if (o.op == BinaryOp::Modulo) {
        context.emit(o.range, findings::OperatorNotForType(Verbatim("MOD"), Verbatim("REAL")));
        return unknown(context, o.range);
    }
    // A variable that is 0 gives infinity when it runs; 0 that is written is a mistake.
    if (o.op == BinaryOp::Divide && right.real() == 0) {
        context.emit(b.expr->range, findings::DivisionByConstantZero());
        return unknown(context, o.range);
    }
    const library::Evaluated folded = library::evaluateBinary(context.types, o.op, lreal, left, right);
    if (!folded.value.hasValue()) return unknown(context, o.range);
    // A comparison's result is BOOL and no literal any more.
    return constant(context, folded.value, o.range, !isCompare(o.op));
}

// In 128 bits, so that 16#FFFF_FFFF_FFFF_FFFF - 1 and -9223372036854775808 both come out right; only the result has to
// fit into 64.
Operand foldIntegers(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    const auto wide = [&](const types::Value& v) -> library::WideInteger {
        return context.types.storageKind(v.type) == TypeKind::Ulint
                   ? static_cast<library::WideInteger>(static_cast<uint64_t>(v.integer()))
                   : v.integer();
    };
    const library::WideInteger left = wide(a.expr->value), right = wide(b.expr->value);
    const std::optional<library::WideInteger> result = library::evaluateWide(o.op, left, right);
    if (!result) {
        context.emit(b.expr->range, findings::DivisionByConstantZero());
        return unknown(context, o.range);
    }
    if (isCompare(o.op))
        return constant(context, {context.elementary(TypeKind::Bool), static_cast<int64_t>(*result)}, o.range);
    if (*result > static_cast<library::WideInteger>(UINT64_MAX) ||
        *result < static_cast<library::WideInteger>(INT64_MIN)) {
        context.emit(o.range, findings::ConstantOutOfRange(context.textOf(o.range), Verbatim("LINT")));
        return unknown(context, o.range);
    }
    Operand out = constant(context,
                           {context.elementary(*result > INT64_MAX ? TypeKind::Ulint : TypeKind::Lint),
                            static_cast<int64_t>(static_cast<uint64_t>(*result))},
                           o.range, true);
    // r := 1 / 2 is 0. The literal remembers that digits were lost, until it is known whether a REAL was wanted
    // (P2029).
    out.isDivided = (o.op == BinaryOp::Divide && left % right != 0) || a.isDivided || b.isDivided;
    return out;
}

/// Literals settle with the other operand's type; everything else is converted to it.
bool bringTo(Context& context, TypeId type, Operand& a, Operand& b) {
    for (Operand* each : {&a, &b})
        *each = each->isFlexible ? converted(context, *each, type) : convertNode(context, *each, type);
    return !a.isUnknown() && !b.isUnknown();
}

/// The type in which AND, OR and XOR work; invalid when the operands do not go together.
TypeId typeOfBits(Context& context, const Operand& a, const Operand& b) {
    const bool aBool = context.types.family(a.type()) == Family::Bool;
    const bool bBool = context.types.family(b.type()) == Family::Bool;
    if (aBool && bBool) return context.elementary(TypeKind::Bool);
    if (aBool || bBool) {
        const Operand& other = aBool ? b : a;
        // b AND 1: the literal can only be meant as a truth value.
        if (other.isFlexible) return context.elementary(TypeKind::Bool);
        return context.types.family(other.type()) == Family::Bits ? context.types.storage(other.type()) : TypeId();
    }
    // As numbers at first, since integers are taken as well; the loop below corrects the kind, not the width.
    TypeId type = commonType(context, a, b);
    // bit strings stay bit strings beside integers of their width
    for (const Operand& o : {a, b})
        if (!o.isFlexible && context.types.family(o.type()) == Family::Bits &&
            types::bitsOf(context.types.storageKind(o.type())) == types::bitsOf(context.types.storageKind(type)))
            type = context.types.storage(o.type());
    return type;
}

///   ok:    b OR c; w AND 16#FF      wrong: r OR 1  with r : REAL (P2006)   b OR i  with i : INT (P2007)
Operand combineBits(Context& context, const Operation& o, Operand a, Operand b, TypeId hint) {
    for (const Operand& each : {a, b}) {
        const Family family = context.types.family(each.type());
        if (family == Family::Bool || types::isInteger(family)) continue;
        context.emit(each.expr->range, findings::OperatorNotForType(o.spelling, context.nameOf(each.type())));
        return unknown(context, o.range);
    }
    if (a.isFlexible && b.isFlexible) {
        // 1 OR 0 is a number, unless a BOOL is wanted.
        if (!hint.isValid() || context.types.family(hint) != Family::Bool) return foldFlexible(context, o, a, b);
        const TypeId boolean = context.elementary(TypeKind::Bool);
        a = converted(context, a, boolean);
        b = converted(context, b, boolean);
        return a.isUnknown() || b.isUnknown() ? unknown(context, o.range)
                                              : makeBinary(context, o.op, boolean, a, b, o.range);
    }
    const TypeId type = typeOfBits(context, a, b);
    if (!type.isValid()) return mismatch(context, o, a, b);
    return bringTo(context, type, a, b) ? makeBinary(context, o.op, type, a, b, o.range) : unknown(context, o.range);
}

/// p + 4, p - q: in the bits of an address. Nothing: no operation on pointers.
std::optional<Operand> combinePointers(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    const bool pointerLeft = context.isKind(a.type(), TypeKind::Pointer);
    const bool pointerRight = context.isKind(b.type(), TypeKind::Pointer);
    if (!pointerLeft && !pointerRight) return std::nullopt;
    if (o.op != BinaryOp::Add && o.op != BinaryOp::Subtract) return std::nullopt;
    if (!(pointerLeft || isNumeric(context, a.type())) || !(pointerRight || isNumeric(context, b.type())))
        return std::nullopt;
    // As in CODESYS, + counts bytes, not elements: p + SIZEOF(x) is how programs there are written.
    const TypeId lword = context.elementary(TypeKind::Lword);
    const auto bits = [&](Operand each) {
        return context.isKind(each.type(), TypeKind::Pointer) ? sameBits(context, each, lword)
                                                              : convertNode(context, settled(context, each), lword);
    };
    const Operand sum = makeBinary(context, o.op, lword, bits(a), bits(b), o.range);
    // The distance of two pointers is a number, a pointer and a number a pointer.
    return pointerLeft && pointerRight ? sum : sameBits(context, sum, pointerLeft ? a.type() : b.type());
}

// The smallest wrong thing: the operand that does not fit, or the operator when both are of the same unfit type.
Operand notNumeric(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    const Operand& wrong = isNumeric(context, a.type()) ? b : a;
    const bool both = !isNumeric(context, a.type()) && !isNumeric(context, b.type());
    if (both && a.type() != b.type()) return mismatch(context, o, a, b);
    context.emit(both ? o.operatorRange : wrong.expr->range,
                 findings::OperatorNotForType(o.spelling, context.nameOf(wrong.type())));
    return unknown(context, o.range);
}

///   ok:    i MOD 2      wrong: r MOD 2.0  (P2006)      advice: r := 1 / 2;  (P2029)
Operand combineNumbers(Context& context, const Operation& o, Operand a, Operand b, TypeId hint) {
    if (!isNumeric(context, a.type()) || !isNumeric(context, b.type())) return notNumeric(context, o, a, b);
    if (a.isFlexible && b.isFlexible) return foldFlexible(context, o, a, b);
    TypeId type = commonType(context, a, b);
    if ((a.isFlexible || b.isFlexible) && context.types.family(type) == Family::Real && hint.isValid() &&
        context.types.family(hint) == Family::Real) {
        // an integer beside a real literal is computed in the real type that is wanted
        const Operand& other = a.isFlexible ? b : a;
        // i * 0.5 for a REAL would else be LREAL and be reported as lossy.
        if (context.types.family(other.type()) != Family::Real) type = context.types.storage(hint);
    }
    if (o.op == BinaryOp::Modulo && context.types.family(type) == Family::Real) {
        context.emit(o.operatorRange, findings::OperatorNotForType(Verbatim("MOD"), context.nameOf(type)));
        return unknown(context, o.range);
    }
    for (Operand* each : {&a, &b}) {
        const tree::Expr& e = *each->expr;
        // (i / 2) * 1.5: the integer division is a part of a real calculation, its digits are gone by now.
        if (!each->isFlexible && context.types.family(type) == Family::Real && e.kind == tree::ExprKind::Binary &&
            e.binary == BinaryOp::Divide && types::isInteger(context.types.family(each->type())))
            context.emit(e.range, findings::IntegerDivisionToReal(context.nameOf(type)));
        *each = each->isFlexible ? converted(context, *each, type) : convertNode(context, *each, type);
    }
    if (a.isUnknown() || b.isUnknown()) return unknown(context, o.range);
    return makeBinary(context, o.op, type, a, b, o.range);
}

bool isLongTime(const Context& context, const Operand& o) {
    const TypeKind kind = context.types.storageKind(o.type());
    return kind == TypeKind::Ltime || kind == TypeKind::Ldate || kind == TypeKind::Ltod || kind == TypeKind::Ldt;
}

/// A duration times or through a number. Nothing: neither.
std::optional<Operand> scaleDuration(Context& context, const Operation& o, Operand a, Operand b) {
    const Family f = context.types.family(a.type()), g = context.types.family(b.type());
    if (f == Family::Duration && isNumeric(context, b.type()) &&
        (o.op == BinaryOp::Multiply || o.op == BinaryOp::Divide)) {
        b = settled(context, b);
        // With any other zero the duration is divided when it runs, and faults as integers do.
        if (o.op == BinaryOp::Divide && isConstantZero(b)) {
            context.emit(b.expr->range, findings::DivisionByConstantZero());
            return unknown(context, o.range);
        }
        return intrinsic(context,
                         o.op == BinaryOp::Multiply ? library::Intrinsic::MulDuration : library::Intrinsic::DivDuration,
                         context.types.storage(a.type()), {a, b}, o.range);
    }
    if (g == Family::Duration && isNumeric(context, a.type()) && o.op == BinaryOp::Multiply)
        return intrinsic(context, library::Intrinsic::MulDuration, context.types.storage(b.type()),
                         {b, settled(context, a)}, o.range);
    return std::nullopt;
}

///   ok:    d + t  with d : DT, t : TIME      wrong: t + d  with t : TIME, d : DATE (P2007)
Operand combineTimes(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    const Family f = context.types.family(a.type()), g = context.types.family(b.type());
    const bool adds = o.op == BinaryOp::Add, subtracts = o.op == BinaryOp::Subtract;
    // Times are 64-bit counts of nanoseconds in every family, so adding is adding bits.
    const auto in = [&](TypeId type, const Operand& left, const Operand& right) {
        return makeBinary(context, o.op, type, sameBits(context, left, type), sameBits(context, right, type), o.range);
    };
    const TypeId duration =
        context.elementary(isLongTime(context, a) || isLongTime(context, b) ? TypeKind::Ltime : TypeKind::Time);
    const bool areDurations = f == Family::Duration && g == Family::Duration;
    if (areDurations && (adds || subtracts || o.op == BinaryOp::Modulo)) return in(duration, a, b);
    // How often one duration is in another: a number.
    if (areDurations && o.op == BinaryOp::Divide) return in(context.elementary(TypeKind::Lint), a, b);
    if ((f == Family::TimeOfDay || f == Family::DateTime) && g == Family::Duration && (adds || subtracts))
        return in(context.types.storage(a.type()), a, b);
    // t + d is accepted for TOD and DT (D11), not for DATE, which has no part of a day to add to.
    if (f == Family::Duration && (g == Family::TimeOfDay || g == Family::DateTime) && adds)
        return in(context.types.storage(b.type()), b, a);
    if (isTimeFamily(f) && f == g && f != Family::Duration && subtracts) return in(duration, a, b);
    if (const std::optional<Operand> scaled = scaleDuration(context, o, a, b)) return *scaled;
    return mismatch(context, o, settled(context, a), settled(context, b));
}

} // namespace

Operand foldFlexible(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    const bool isReal =
        std::holds_alternative<double>(a.expr->value.data) || std::holds_alternative<double>(b.expr->value.data);
    return isReal ? foldReals(context, o, a, b) : foldIntegers(context, o, a, b);
}

/// An operator between two operands (edition 3, table 71).
///   ok:    b OR c; i MOD 2; d + t  with d : DT, t : TIME
///   wrong: b + c  with BOOL (P2006)   t + d  with t : TIME, d : DATE (P2007)
Operand combine(Context& context, BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                SourceRange operatorRange, TypeId hint) {
    // Unknown in, unknown out: what was reported below is not reported again on the way up.
    if (a.isUnknown() || b.isUnknown() || isStrict(context, a) || isStrict(context, b)) return unknown(context, range);
    const Operation o{op, spelling, range, operatorRange};
    // Families are asked from the most special to the most general; numbers come last because they accept the most.
    if (op == BinaryOp::And || op == BinaryOp::Or || op == BinaryOp::Xor) return combineBits(context, o, a, b, hint);
    a = characterCode(context, a);
    b = characterCode(context, b);
    if (isTimeFamily(context.types.family(a.type())) || isTimeFamily(context.types.family(b.type())))
        return combineTimes(context, o, a, b);
    if (const std::optional<Operand> address = combinePointers(context, o, a, b)) return *address;
    return combineNumbers(context, o, a, b, hint);
}

} // namespace plc::sema
