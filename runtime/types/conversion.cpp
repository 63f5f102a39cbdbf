#include "runtime/types/conversion.h"

#include <cmath>

namespace plc::types {
namespace {

/// Edition 3, figure 12, and what CODESYS adds: bit strings count as unsigned numbers, a REAL takes any integer.
Implicit betweenNumbers(TypeKind from, TypeKind to) {
    const Family a = familyOf(from), b = familyOf(to);
    const unsigned fromBits = bitsOf(from), toBits = bitsOf(to);
    if (a == Family::Real) return b == Family::Real && toBits >= fromBits ? Implicit::Widening : Implicit::Narrowing;
    if (b == Family::Real)
        return fromBits <= toBits / 2 || (to == TypeKind::Lreal && fromBits <= 32) ? Implicit::Widening
                                                                                   : Implicit::Narrowing;
    const bool fromSigned = a == Family::Signed, toSigned = b == Family::Signed;
    if (fromSigned == toSigned) return toBits >= fromBits ? Implicit::Widening : Implicit::Narrowing;
    if (fromSigned) return Implicit::Narrowing;
    return toBits > fromBits ? Implicit::Widening : Implicit::Narrowing;
}

bool fitsAllEnumerators(const Type& enumeration, TypeKind to) {
    const auto [low, high] = TypeTable::integerRange(to);
    for (const Enumerator& enumerator : enumeration.enumerators) {
        if (enumerator.value < low) return false;
        if (enumerator.value >= 0 && static_cast<uint64_t>(enumerator.value) > high) return false;
    }
    return true;
}

bool isNumeric(Family family) { return isInteger(family) || family == Family::Real; }

Implicit fromEnum(const TypeTable& types, TypeId from, TypeId to) {
    if (types.kind(to) == TypeKind::Enum) return Implicit::Narrowing;
    const Family family = types.family(to);
    if (family == Family::Real) return Implicit::Widening;
    if (!isInteger(family)) return Implicit::Forbidden;
    return fitsAllEnumerators(types[from], types.storageKind(to)) ? Implicit::Widening : Implicit::Narrowing;
}

bool isAddress(TypeKind kind) { return kind == TypeKind::Pointer || kind == TypeKind::Reference; }

Implicit toAddress(const TypeTable& types, TypeId from, TypeId to) {
    const Type& source = types[from];
    if (source.kind == TypeKind::Null) return Implicit::Widening;
    if (isAddress(source.kind)) {
        if (source.element == types[to].element || types.isDerivedFrom(source.element, types[to].element))
            return Implicit::Widening;
        return Implicit::Narrowing;
    }
    const Family family = types.family(from);
    return isInteger(family) && bitsOf(types.storageKind(from)) >= 32 ? Implicit::Narrowing : Implicit::Forbidden;
}

Implicit betweenElementary(TypeKind from, TypeKind to) {
    const Family a = familyOf(from), b = familyOf(to);
    if (isNumeric(a) && isNumeric(b)) return betweenNumbers(from, to);
    if (a == Family::Bool && b == Family::Bits) return Implicit::Widening;
    if (a == Family::Character && b == Family::Character)
        return bitsOf(to) >= bitsOf(from) ? Implicit::Widening : Implicit::Narrowing;
    // A character of a string is also its code, as in CODESYS: s[1] = 48.
    if (a == Family::Character && isInteger(b))
        return bitsOf(to) >= bitsOf(from) && b != Family::Signed ? Implicit::Widening
               : bitsOf(to) > bitsOf(from)                       ? Implicit::Widening
                                                                 : Implicit::Narrowing;
    if (isInteger(a) && b == Family::Character)
        return a != Family::Signed && bitsOf(from) <= bitsOf(to) ? Implicit::Widening : Implicit::Narrowing;
    if (a == b) { // TIME → LTIME and the like
        const bool toLong =
            to == TypeKind::Ltime || to == TypeKind::Ldate || to == TypeKind::Ltod || to == TypeKind::Ldt;
        return toLong ? Implicit::Widening : Implicit::Narrowing;
    }
    return Implicit::Forbidden;
}

Implicit betweenTexts(const TypeTable& types, TypeId from, TypeId to) {
    const TypeKind source = types.storageKind(from), target = types.storageKind(to);
    if (source == TypeKind::String && target == TypeKind::String) return Implicit::Widening;
    if (source == TypeKind::Wstring && target == TypeKind::Wstring) return Implicit::Widening;
    if (target == TypeKind::Wstring) return Implicit::Widening;
    if (source == TypeKind::Wstring && target == TypeKind::String) return Implicit::Narrowing;
    return Implicit::Narrowing;
}

int64_t toInteger(TypeKind kind, double whole) {
    if (std::isnan(whole)) return 0;
    if (kind == TypeKind::Bool) return whole != 0;
    const auto [low, high] = TypeTable::integerRange(kind);
    if (whole <= static_cast<double>(low)) return low;
    if (whole >= static_cast<double>(high)) return static_cast<int64_t>(high);
    return whole < 0 ? static_cast<int64_t>(whole) : static_cast<int64_t>(static_cast<uint64_t>(whole));
}

} // namespace

Implicit implicitConversion(const TypeTable& types, TypeId from, TypeId to) {
    if (from == to) return Implicit::Same;
    const TypeKind source = types.kind(from), target = types.kind(to);
    if (source == TypeKind::Unknown || target == TypeKind::Unknown) return Implicit::Same;
    if (source == TypeKind::Void || target == TypeKind::Void) return Implicit::Forbidden;
    if (source == TypeKind::Enum) return fromEnum(types, from, to);
    if (target == TypeKind::Enum) return isInteger(types.family(from)) ? Implicit::Narrowing : Implicit::Forbidden;
    if (types.isText(from) && types.isText(to)) return betweenTexts(types, from, to);
    const TypeKind a = types.storageKind(from), b = types.storageKind(to);
    if (familyOf(a) == Family::Character && types.isText(to))
        return a == TypeKind::Wchar && b == TypeKind::String ? Implicit::Narrowing : Implicit::Widening;
    if (isElementary(a) && isElementary(b)) return a == b ? Implicit::Same : betweenElementary(a, b);
    if (isAddress(b)) return toAddress(types, from, to);
    if (isAddress(a))
        return isInteger(familyOf(b)) && bitsOf(b) >= 32 ? (bitsOf(b) == 64 ? Implicit::Widening : Implicit::Narrowing)
                                                         : Implicit::Forbidden;
    if (b == TypeKind::Interface) {
        if (a == TypeKind::Null) return Implicit::Widening;
        return (a == TypeKind::Block || a == TypeKind::Interface) && types.isDerivedFrom(from, to)
                   ? Implicit::Widening
                   : Implicit::Forbidden;
    }
    if (a == TypeKind::Array && b == TypeKind::OpenArray)
        return types[from].element == types[to].element && types[from].dimensions.size() == types[to].dimensions.size()
                   ? Implicit::Same
                   : Implicit::Forbidden;
    if (a == TypeKind::OpenArray && b == TypeKind::OpenArray)
        return types[from].element == types[to].element && types[from].dimensions.size() == types[to].dimensions.size()
                   ? Implicit::Same
                   : Implicit::Forbidden;
    return Implicit::Forbidden;
}

int64_t wrapInteger(TypeKind kind, int64_t value) {
    switch (kind) {
    case TypeKind::Bool:
        return value != 0;
    case TypeKind::Sint:
        return static_cast<int8_t>(value);
    case TypeKind::Int:
        return static_cast<int16_t>(value);
    case TypeKind::Dint:
        return static_cast<int32_t>(value);
    case TypeKind::Byte:
    case TypeKind::Usint:
    case TypeKind::Char:
        return static_cast<uint8_t>(value);
    case TypeKind::Word:
    case TypeKind::Uint:
    case TypeKind::Wchar:
        return static_cast<uint16_t>(value);
    case TypeKind::Dword:
    case TypeKind::Udint:
        return static_cast<uint32_t>(value);
    default:
        return value;
    }
}

int64_t roundToInteger(TypeKind kind, double value) {
    return toInteger(kind, kind == TypeKind::Bool ? value : std::nearbyint(value));
}

Value truncate(const TypeTable& types, const Value& value, TypeId to) {
    if (!std::holds_alternative<double>(value.data)) return convert(types, value, to);
    return {to, toInteger(types.storageKind(to), std::trunc(value.real()))};
}

} // namespace plc::types
