// Comparisons: which operands can be compared, and in which type. A function for each family of operands; each returns
// nothing when the operands are not of its family.
#include "runtime/compiler/sema/operators/operation.h"
#include "runtime/compiler/sema/operators/operators.h"

#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

using library::BinaryOp;
using types::Family;

namespace {

Operand refuse(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    return mismatch(context, o, settled(context, a), settled(context, b));
}

bool isAddress(TypeKind kind) {
    return kind == TypeKind::Pointer || kind == TypeKind::Reference || kind == TypeKind::Interface ||
           kind == TypeKind::Null;
}

// Compared as 64 bits. A watch has no type for the pointer to a block and needs none.
Operand addressBits(Context& context, Operand o) {
    const TypeId lword = context.elementary(TypeKind::Lword);
    if (context.isKind(o.type(), TypeKind::Block))
        o = addressOf(context, o.expr->place, context.isExpression ? lword : context.types.pointer(o.type()),
                      o.expr->range);
    return isNumeric(context, o.type()) ? convertNode(context, settled(context, o), lword)
                                        : sameBits(context, o, lword);
}

///   ok:    p = 0; p <> q; interface = block
std::optional<Operand> compareAddresses(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    const TypeKind x = context.types.kind(a.type()), y = context.types.kind(b.type());
    if (!isAddress(x) && !isAddress(y)) return std::nullopt;
    const bool isEquality = o.op == BinaryOp::Equal || o.op == BinaryOp::NotEqual;
    // p = 0 asks whether p points anywhere; the code for that knows references and interfaces as well.
    if (isEquality && (isConstantZero(a) || isConstantZero(b))) {
        const Operand& asked = isConstantZero(a) ? b : a;
        if (!isAddress(context.types.kind(asked.type()))) return std::nullopt; // r = NULL: r has no address
        const Operand null = isNull(context, asked, o.range);
        return o.op == BinaryOp::Equal ? null : inverted(context, null, o.range);
    }
    const bool good = (isAddress(x) && isAddress(y)) || (x == TypeKind::Pointer && isNumeric(context, b.type())) ||
                      (y == TypeKind::Pointer && isNumeric(context, a.type())) ||
                      (x == TypeKind::Interface && y == TypeKind::Block) ||
                      (y == TypeKind::Interface && x == TypeKind::Block);
    // Not refused here: the following families may know the pair, and the last one gives the message.
    if (!good) return std::nullopt;
    return makeBinary(context, o.op, context.elementary(TypeKind::Lword), addressBits(context, a),
                      addressBits(context, b), o.range);
}

// Only a frame for the comparison: texts of different capacities are equal when their characters are.
TypeId longerText(const Context& context, const Operand& a, const Operand& b) {
    return context.types[a.type()].capacity >= context.types[b.type()].capacity ? a.type() : b.type();
}

/// A STRING beside a WSTRING becomes one.
Operand compareTwoTexts(Context& context, const Operation& o, Operand a, Operand b) {
    if (context.types.kind(a.type()) != context.types.kind(b.type())) {
        const bool isLeftNarrow = context.isKind(a.type(), TypeKind::String);
        const TypeId wide = isLeftNarrow ? b.type() : a.type();
        Operand& narrow = isLeftNarrow ? a : b;
        narrow = convertedText(context, narrow, wide);
        if (a.isUnknown() || b.isUnknown()) return unknown(context, o.range);
    }
    return makeBinary(context, o.op, longerText(context, a, b), a, b, o.range);
}

// 'a' is a STRING literal of length 1; beside a CHAR it is meant as one.
bool isOneCharacter(const Operand& text) {
    const auto* narrow = std::get_if<std::string>(&text.expr->value.data);
    const auto* wide = std::get_if<std::u16string>(&text.expr->value.data);
    return text.isConstant() && ((narrow && narrow->size() == 1) || (wide && wide->size() == 1));
}

///   ok:    s = 'a'; c = 'a'  with c : CHAR      wrong: s = i  (P2007)
std::optional<Operand> compareTexts(Context& context, const Operation& o, Operand a, Operand b) {
    const bool isTextA = context.types.isText(a.type()), isTextB = context.types.isText(b.type());
    if (!isTextA && !isTextB) return std::nullopt;
    if (isTextA && isTextB) return compareTwoTexts(context, o, a, b);
    Operand& text = isTextA ? a : b;
    Operand& other = isTextA ? b : a;
    if (context.types.family(other.type()) == Family::Character) {
        TypeId type = text.type();
        if (isOneCharacter(text)) {
            type = other.type();
            text = converted(context, text, type);
            if (text.isUnknown()) return unknown(context, o.range);
        } else {
            other = convertNode(context, other, type);
        }
        return makeBinary(context, o.op, type, a, b, o.range);
    }
    // A BYTE beside 'a': code that reads texts byte by byte compares so.
    if (!text.isConstant() || !types::isInteger(context.types.family(other.type()))) return refuse(context, o, a, b);
    const TypeId type = context.types.storage(other.type()); // s[i] was stored in a BYTE
    text = converted(context, text, type);
    return text.isUnknown() ? unknown(context, o.range) : makeBinary(context, o.op, type, a, b, o.range);
}

///   ok:    b = TRUE; b = 1; w = TRUE      wrong: b = i  (P2007)
std::optional<Operand> compareTruths(Context& context, const Operation& o, Operand a, Operand b) {
    const Family f = context.types.family(a.type()), g = context.types.family(b.type());
    if (f != Family::Bool && g != Family::Bool) return std::nullopt;
    const TypeId boolean = context.elementary(TypeKind::Bool);
    if (f == g) return makeBinary(context, o.op, boolean, a, b, o.range);
    Operand& truth = f == Family::Bool ? a : b;
    Operand& other = f == Family::Bool ? b : a;
    if (other.isFlexible && std::holds_alternative<int64_t>(other.expr->value.data)) {
        other = converted(context, other, boolean);
        return other.isUnknown() ? unknown(context, o.range) : makeBinary(context, o.op, boolean, a, b, o.range);
    }
    // w = TRUE, written by generators of code, compares with 1.
    if (!truth.isConstant() || !isNumeric(context, other.type())) return refuse(context, o, a, b);
    const TypeId type = context.types.storage(other.type());
    truth = convertNode(context, truth, type);
    return makeBinary(context, o.op, type, a, b, o.range);
}

std::optional<Operand> compareTimes(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    const Family family = context.types.family(a.type());
    if (!isTimeFamily(family) || family != context.types.family(b.type())) return std::nullopt;
    // TIME beside LTIME: both are counted in nanoseconds, the name of the type is that of the wider one.
    const bool isWiderRight =
        types::implicitConversion(context.types, b.type(), a.type()) == types::Implicit::Narrowing;
    const TypeId type = context.types.storage(isWiderRight ? b.type() : a.type());
    return makeBinary(context, o.op, type, sameBits(context, a, type), sameBits(context, b, type), o.range);
}

std::optional<Operand> compareCharacters(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    if (context.types.family(a.type()) != Family::Character || context.types.family(b.type()) != Family::Character)
        return std::nullopt;
    const bool isWide = context.types.storageKind(a.type()) == TypeKind::Wchar;
    const TypeId type = context.elementary(isWide ? TypeKind::Wchar : context.types.storageKind(b.type()));
    return makeBinary(context, o.op, type, convertNode(context, a, type), convertNode(context, b, type), o.range);
}

///   wrong: a = b  with arrays (P2040)
Operand notComparable(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    // Comparing bytes would compare what lies between fields as well; member by member is what is meant.
    if (context.types.isAggregate(a.type()) && context.types.isAggregate(b.type())) {
        context.emit(o.operatorRange, findings::CompareWhole(o.spelling, context.nameOf(a.type())));
        return unknown(context, o.range);
    }
    if (a.type() != b.type()) return refuse(context, o, a, b);
    context.emit(o.operatorRange, findings::OperatorNotForType(o.spelling, context.nameOf(a.type())));
    return unknown(context, o.range);
}

/// Of a signed and an unsigned integer: the narrower constant joins the other, else the type that holds both, which is
/// the next wider signed one. Beyond 64 bits there is none, and a negative number would count as a large one.
///   advice: l < u  with LINT and ULINT (P2031)
TypeId typeOfMixedSigns(Context& context, const Operation& o, const Operand& a, const Operand& b) {
    // C's rule (both become unsigned) makes -1 > 1u; a controller must not switch on because of that.
    const bool isSignedLeft = context.types.family(a.type()) == Family::Signed;
    const Operand& withSign = isSignedLeft ? a : b;
    const Operand& withoutSign = isSignedLeft ? b : a;
    const TypeId isSigned = context.types.storage(withSign.type());
    const TypeId isUnsigned = context.types.storage(withoutSign.type());
    if (withSign.isConstant() && withSign.expr->value.integer() >= 0 && fits(context, withSign.expr->value, isUnsigned))
        return isUnsigned;
    if (withoutSign.isConstant() && fits(context, withoutSign.expr->value, isSigned)) return isSigned;
    const unsigned width = types::bitsOf(context.types.storageKind(isUnsigned));
    // Every value of the unsigned type is one of the wider signed type.
    if (width < types::bitsOf(context.types.storageKind(isSigned))) return isSigned;
    if (width < 64)
        return context.elementary(width == 32 ? TypeKind::Lint : width == 16 ? TypeKind::Dint : TypeKind::Int);
    context.emit(o.operatorRange, findings::SignedUnsignedMix(context.nameOf(a.type()), context.nameOf(b.type()),
                                                              context.nameOf(isUnsigned)));
    return isUnsigned;
}

Operand compareNumbers(Context& context, const Operation& o, Operand a, Operand b) {
    if (!isNumeric(context, a.type()) || !isNumeric(context, b.type())) return notComparable(context, o, a, b);
    TypeId type = commonType(context, a, b);
    const Family f = context.types.family(a.type()), g = context.types.family(b.type());
    if (!a.isFlexible && !b.isFlexible && types::isInteger(f) && types::isInteger(g) &&
        (f == Family::Signed) != (g == Family::Signed))
        type = typeOfMixedSigns(context, o, a, b);
    for (Operand* each : {&a, &b})
        *each = each->isFlexible ? converted(context, *each, type) : convertNode(context, *each, type);
    if (a.isUnknown() || b.isUnknown()) return unknown(context, o.range);
    return makeBinary(context, o.op, type, a, b, o.range);
}

} // namespace

///   ok:    s = 'a'; i < u  with INT and UINT
///   wrong: s = i  (P2007)   a = b  with arrays (P2040)      advice: l < u  with LINT and ULINT (P2031)
///   warning: light = gear  with two enumerations (P2032)
Operand compare(Context& context, BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                SourceRange operatorRange) {
    if (a.isUnknown() || b.isUnknown()) return unknown(context, range);
    const Operation o{op, spelling, range, operatorRange};
    if (a.isFlexible && b.isFlexible) return foldFlexible(context, o, a, b);
    if (const auto done = compareAddresses(context, o, a, b)) return *done;
    if (const auto done = compareTexts(context, o, a, b)) return *done;
    if (const auto done = compareTruths(context, o, a, b)) return *done;
    const bool areCharacters =
        context.types.family(a.type()) == Family::Character && context.types.family(b.type()) == Family::Character;
    if (!areCharacters) { // a character beside a number is its code
        a = characterCode(context, a);
        b = characterCode(context, b);
    }
    if (const auto done = compareTimes(context, o, a, b)) return *done;
    // Values of two enumerations have nothing to do with each other; TwinCAT and CODESYS compare their numbers.
    if (context.isKind(a.type(), TypeKind::Enum) && context.isKind(b.type(), TypeKind::Enum) &&
        !sameType(context.world, a.type(), b.type()))
        context.emit(operatorRange, findings::IntegerToEnum(context.nameOf(b.type()), context.nameOf(a.type())));
    if (const auto done = compareCharacters(context, o, a, b)) return *done;
    return compareNumbers(context, o, a, b);
}

} // namespace plc::sema
