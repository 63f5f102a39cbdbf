// Implicit and written conversions, and the common type of two operands (D11).
#include "runtime/compiler/sema/checker.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

#include <cmath>

namespace plc::sema {

using types::Family;
using types::TypeTable;

bool Checker::fits(const types::Value& value, TypeId type) const {
    const types::Type& target = types[type];
    const TypeKind kind = types.storageKind(type);
    const Family family = types::familyOf(kind);
    if (std::holds_alternative<double>(value.data)) {
        if (family == Family::Real) return kind == TypeKind::Lreal || std::abs(value.real()) <= 3.4028235677973366e38;
        return false;
    }
    if (!std::holds_alternative<int64_t>(value.data)) return false;
    if (family == Family::Real) return true;
    if (family == Family::Bool) return value.integer() == 0 || value.integer() == 1;
    if (!types::isInteger(family) && family != Family::Character) return false;
    const bool isBig = types.storageKind(value.type) == TypeKind::Ulint ||
                       types.storageKind(value.type) == TypeKind::Lword; // bit pattern
    const unsigned bits = types::bitsOf(kind);
    const bool isSigned = family == Family::Signed;
    const int64_t number = value.integer();
    if (isBig && number < 0) return !isSigned && bits == 64;
    if (target.kind == TypeKind::Subrange && (number < target.low || number > target.high)) return false;
    if (isSigned) return bits == 64 || (number >= -(int64_t(1) << (bits - 1)) && number < (int64_t(1) << (bits - 1)));
    if (number < 0) return false;
    return bits == 64 || number < (int64_t(1) << bits);
}

TypeId Checker::smallestType(const Operand& flexible) const {
    const types::Value& value = flexible.expr->value;
    if (std::holds_alternative<double>(value.data)) return elementary(TypeKind::Lreal);
    for (const TypeKind kind : {TypeKind::Int, TypeKind::Dint, TypeKind::Lint, TypeKind::Ulint})
        if (fits(value, elementary(kind))) return elementary(kind);
    return elementary(TypeKind::Lint);
}

TypeId Checker::commonType(const Operand& a, const Operand& b) const {
    const TypeKind x = types.storageKind(a.type()), y = types.storageKind(b.type());
    const Family f = types::familyOf(x), g = types::familyOf(y);
    if (a.isFlexible != b.isFlexible) {
        const Operand& literal = a.isFlexible ? a : b;
        const TypeId other = types.storage(a.isFlexible ? b.type() : a.type());
        if (fits(literal.expr->value, other)) return other;
    }
    const bool numeric = isNumeric(a.type()) && isNumeric(b.type());
    if (!numeric)
        return f == g && f != Family::Other && !types.isText(a.type())
                   ? elementary(types::bitsOf(y) > types::bitsOf(x) ? y : x)
                   : TypeId();
    const auto single = [&](const Operand& real, const Operand& whole) {
        if (!real.isFlexible) return real.type();
        return elementary(types::bitsOf(types.storageKind(whole.type())) <= 16 &&
                                  fits(real.expr->value, elementary(TypeKind::Real))
                              ? TypeKind::Real
                              : TypeKind::Lreal);
    };
    if (f == Family::Real && g == Family::Real)
        return elementary(x == TypeKind::Lreal || y == TypeKind::Lreal ? TypeKind::Lreal : TypeKind::Real);
    if (f == Family::Real) return types.storage(single(a, b));
    if (g == Family::Real) return types.storage(single(b, a));
    const TypeKind own = a.isFlexible ? types.storageKind(smallestType(a)) : x,
                   other = b.isFlexible ? types.storageKind(smallestType(b)) : y;
    const unsigned m = types::bitsOf(own), n = types::bitsOf(other);
    if (m != n) return elementary(m > n ? own : other);
    const Family p = types::familyOf(own), q = types::familyOf(other);
    if (p == q) return elementary(own);
    if (p == Family::Signed || q == Family::Signed) return elementary(p == Family::Signed ? own : other);
    return elementary(p == Family::Unsigned ? own : other);
}

///   wrong: x := 'a text'; b := r; t := 5;  with INT, BOOL and TIME (P2003)
void Checker::mismatch(SourceRange range, TypeId from, TypeId to) {
    auto& diagnostic = emit(range, findings::TypeMismatch(nameOf(from), nameOf(to)));
    const TypeKind a = types.storageKind(from), b = types.storageKind(to);
    const auto named = [](TypeKind kind) -> std::string {
        return kind == TypeKind::String    ? "STRING"
               : kind == TypeKind::Wstring ? "WSTRING"
                                           : std::string(types::spelling(kind));
    };
    if (!named(a).empty() && !named(b).empty() && range.file.isValid()) {
        const std::string function = named(a) + "_TO_" + named(b);
        const std::string text(textOf(range));
        if (types.family(to) == types::Family::Duration && !text.empty() && text.size() < 10 &&
            text.find_first_not_of("0123456789") == std::string::npos) { // a number without its unit
            for (const char* unit : {"ms", "s"}) {
                const std::string duration = (b == TypeKind::Ltime ? "LT#" : "T#") + text + unit;
                diagnostic.fixes.push_back({fixes::Write(duration), {{range, duration}}});
            }
            diagnostic.message = findings::TypeMismatch(text, nameOf(to)).message;
            return;
        }
        if (library::findConversion(function))
            diagnostic.fixes.push_back({fixes::ConvertWith(function),
                                        {{{range.file, range.begin, range.begin}, function + "("},
                                         {{range.file, range.end, range.end}, ")"}}});
    }
}

/// A number or another enumeration's value for a strict enumeration; a name of another enumeration may be meant as one
/// of its own.
///   wrong: c := i;  with c of an enumeration with {attribute 'strict'} (P2038)
void Checker::strictMismatch(SourceRange range, std::string what, TypeId to) {
    auto& diagnostic = emit(range, findings::StrictEnum(std::move(what), nameOf(to)));
    if (!range.file.isValid() || types[to].enumerators.empty() || types[to].enumerators.size() > 5) return;
    for (const types::Enumerator& enumerator : types[to].enumerators) {
        const std::string name = nameOf(to) + "." + enumerator.name;
        diagnostic.fixes.push_back({fixes::Write(name), {{range, name}}});
    }
}

///   wrong: i := c + 1;  with c of an enumeration with {attribute 'strict'} (P2039)
bool Checker::isStrict(const Operand& operand) {
    if (!isKind(operand.type(), TypeKind::Enum) || !types[operand.type()].isStrict) return false;
    const std::string function = "TO_" + std::string(types::spelling(types.storageKind(operand.type())));
    const SourceRange range = operand.expr->range;
    auto& diagnostic = emit(range, findings::StrictCalculation(nameOf(operand.type()), function));
    if (range.file.isValid())
        diagnostic.fixes.push_back(
            {fixes::ConvertWith(function),
             {{{range.file, range.begin, range.begin}, function + "("}, {{range.file, range.end, range.end}, ")"}}});
    return true;
}

Operand Checker::convertNode(Operand operand, TypeId to) {
    if (operand.isUnknown() || operand.type() == to) {
        operand.isFlexible = false;
        return operand;
    }
    if (operand.isConstant() && !types.isAggregate(to)) {
        types::Value value = types::convert(types, operand.expr->value, to);
        value.type = to;
        return constant(std::move(value), operand.expr->range);
    }
    tree::Expr* e = arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Convert;
    e->type = to;
    e->range = operand.expr->range;
    e->a = operand.expr;
    return {e, &types};
}

Operand Checker::sameBits(Operand operand, TypeId to) {
    if (operand.isUnknown() || operand.type() == to) return operand;
    if (operand.isConstant()) {
        types::Value value = operand.expr->value;
        value.type = to;
        return constant(std::move(value), operand.expr->range);
    }
    tree::Expr* e = arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Intrinsic;
    e->intrinsic = library::Intrinsic::SameBits;
    e->type = to;
    e->range = operand.expr->range;
    e->operands.push_back(operand.expr);
    return {e, &types};
}

///   ok:    s := 'abcd';  with STRING(4)      advice: with STRING(3) (P2028)      wrong: s := 'Ω';  (P2027)
Operand Checker::convertedText(Operand operand, TypeId to) {
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    if (operand.isConstant()) {
        const types::Type& target = types[to];
        if (types.isText(from) && types.isText(to)) {
            const auto* narrow = std::get_if<std::string>(&operand.expr->value.data);
            const auto* wide = std::get_if<std::u16string>(&operand.expr->value.data);
            const size_t length = narrow ? narrow->size() : wide ? wide->size() : 0;
            if (length > target.capacity) emit(range, findings::StringTooLong(length, target.capacity));
            if (types.kind(from) == types.kind(to)) return operand;
            if (wide) {
                for (const char16_t c : *wide) {
                    if (c <= 0xFF) continue;
                    emit(range, findings::CharacterNotInString(utf16ToUtf8(std::u16string(1, c))));
                    return unknown(range);
                }
            }
            return convertNode(operand,
                               types.kind(to) == TypeKind::Wstring ? textType(length, true) : textType(length, false));
        }
    }
    if (types.kind(from) == types.kind(to)) return operand; // any capacity: the assignment cuts
    switch (types::implicitConversion(types, from, to)) {
    case types::Implicit::Narrowing:
        emit(range, findings::LossyAssignment(nameOf(from), nameOf(to)));
        break;
    case types::Implicit::Forbidden:
        mismatch(range, from, to);
        return unknown(range);
    default:
        break;
    }
    return convertNode(operand, to);
}

namespace {
bool holdsAddress(TypeKind kind) {
    return kind == TypeKind::Pointer || kind == TypeKind::Interface || kind == TypeKind::Reference;
}
} // namespace

/// A literal or a constant number as `to`: by its value, not by its type. None: as any operand of its type, which a
/// literal then has taken.
///   ok:    x := 40000;  with DINT      wrong: with INT (P2018)   x := 11;  with INT(1..10) (P2018)
std::optional<Operand> Checker::convertedConstant(Operand& operand, TypeId to) {
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    const types::Type& target = types[to];
    const Family toFamily = types::familyOf(types.storageKind(to));
    const types::Value& value = operand.expr->value;
    const bool isReal = std::holds_alternative<double>(value.data);
    const auto refused = [&] {
        emit(range, findings::ConstantOutOfRange(textOf(range), nameOf(to)));
        return unknown(range);
    };
    if (toFamily == Family::Real) {
        if (operand.isDivided) emit(range, findings::IntegerDivisionToReal(nameOf(to)));
        return fits(value, to) ? convertNode(operand, to) : refused();
    }
    if (toFamily == Family::Bool && operand.isFlexible && !isReal) {
        if (fits(value, to)) return convertNode(operand, to);
        mismatch(range, smallestType(operand), to);
        return unknown(range);
    }
    if (target.kind == TypeKind::Enum && !isReal) {
        const auto& enumerators = target.enumerators;
        const bool known = std::any_of(enumerators.begin(), enumerators.end(),
                                       [&](const types::Enumerator& e) { return e.value == value.integer(); });
        if (target.isStrict && !known) {
            strictMismatch(range, textOf(range), to);
            return unknown(range);
        }
        if (!target.isStrict && (!known || !operand.isFlexible))
            emit(range, findings::IntegerToEnum(textOf(range), target.name));
        return convertNode(operand, to);
    }
    if (types::isInteger(toFamily) || (toFamily == Family::Character && operand.isFlexible)) {
        if (isReal) {
            emit(range, findings::LossyAssignment(operand.isFlexible ? textOf(range) : nameOf(from), nameOf(to)));
            return convertNode(operand, to);
        }
        if (fits(value, to)) return convertNode(operand, to);
        if (operand.isFlexible || target.kind == TypeKind::Subrange) return refused();
    }
    if (holdsAddress(target.kind) && !isReal && value.integer() == 0) return constant({to, int64_t(0)}, range);
    if (operand.isFlexible) operand = settled(operand);
    if (types.isText(to) || types.isAggregate(to) || isKind(to, TypeKind::Block)) {
        mismatch(range, operand.type(), to);
        return unknown(range);
    }
    return std::nullopt;
}

/// One character of text as a CHAR or its code.
std::optional<Operand> Checker::convertedCharacter(const Operand& operand, TypeId to) {
    const TypeKind toKind = types.storageKind(to);
    const Family toFamily = types::familyOf(toKind);
    if (!types.isText(operand.type()) || !operand.isConstant()) return std::nullopt;
    if (toFamily != Family::Character && !(types::isInteger(toFamily) && types::bitsOf(toKind) <= 16))
        return std::nullopt;
    const auto* narrow = std::get_if<std::string>(&operand.expr->value.data);
    const auto* wide = std::get_if<std::u16string>(&operand.expr->value.data);
    if (narrow && narrow->size() == 1)
        return constant({to, int64_t(static_cast<unsigned char>(narrow->front()))}, operand.expr->range);
    if (wide && wide->size() == 1 && types::bitsOf(toKind) == 16)
        return constant({to, int64_t(wide->front())}, operand.expr->range);
    return std::nullopt;
}

/// Aggregates, blocks, interfaces, references and pointers: what is of the type already, what is derived from it.
std::optional<Operand> Checker::convertedObject(const Operand& operand, TypeId to) {
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    const types::Type& target = types[to];
    const bool isPointer = isKind(from, TypeKind::Pointer);
    const bool isBlockPointer = isPointer && isKind(types[from].element, TypeKind::Block);
    switch (target.kind) {
    case TypeKind::Array:
    case TypeKind::Struct:
    case TypeKind::Union:
    case TypeKind::Block:
        if (world.sameType(from, to)) return operand;
        mismatch(range, from, to);
        return unknown(range);
    case TypeKind::Interface:
        if (isKind(from, TypeKind::Block) && operand.expr->kind == tree::ExprKind::Load && types.implements(from, to)) {
            takeAddress(operand.expr->place);
            tree::Expr* e = arena.make<tree::Expr>();
            e->kind = tree::ExprKind::InterfaceOf;
            e->type = to;
            e->range = range;
            e->place = operand.expr->place;
            return Operand{e, &types};
        }
        if (isKind(from, TypeKind::Interface) && types.isDerivedFrom(from, to)) return sameBits(operand, to);
        if (isBlockPointer && types.implements(types[from].element, to)) return sameBits(operand, to);
        break;
    case TypeKind::Reference:
        if (operand.expr->kind == tree::ExprKind::Load &&
            (world.sameType(from, target.element) ||
             (isKind(from, TypeKind::Block) && types.isDerivedFrom(from, target.element))))
            return addressOf(operand.expr->place, to, range);
        if ((isPointer || isKind(from, TypeKind::Reference)) && world.sameType(types[from].element, target.element))
            return sameBits(operand, to);
        break;
    case TypeKind::Pointer:
        if (isPointer && world.sameType(types[from].element, target.element)) return sameBits(operand, to);
        if (isBlockPointer && types.isDerivedFrom(types[from].element, target.element)) return sameBits(operand, to);
        break;
    default:
        break;
    }
    if (!isKind(from, TypeKind::Null)) return std::nullopt;
    if (holdsAddress(target.kind)) return constant({to, int64_t(0)}, range);
    mismatch(range, from, to);
    return unknown(range);
}

/// Says where an operation was done in fewer bits than its result is given; returns whether it divides integers for a
/// REAL, which is told as that and not as narrowing.
///   ok:    d := INT_TO_DINT(i) * i; r := i / 2.0;      advice: d := i * i;  (P2030)   r := i / 2;  (P2029)
bool Checker::tellEarlyOperation(const Operand& operand, TypeId to) {
    const tree::Expr& e = *operand.expr;
    const TypeId from = operand.type();
    const TypeKind toKind = types.storageKind(to), fromKind = types.storageKind(from);
    const Family toFamily = types::familyOf(toKind);
    if (e.kind != tree::ExprKind::Binary || !types::isInteger(types::familyOf(fromKind)) || !isNumeric(to))
        return false;
    if (toFamily == Family::Real && e.binary == library::BinaryOp::Divide) {
        emit(e.range, findings::IntegerDivisionToReal(nameOf(to)));
        return true;
    }
    const bool widens = types::bitsOf(toKind) > types::bitsOf(fromKind) || toFamily == Family::Real;
    const bool isSum = e.binary == library::BinaryOp::Add || e.binary == library::BinaryOp::Subtract;
    if (widens && types::bitsOf(fromKind) < 64 &&
        (e.binary == library::BinaryOp::Multiply ||
         (isSum && e.a->kind != tree::ExprKind::Constant && e.b->kind != tree::ExprKind::Constant)))
        emit(e.range, findings::WrapsBeforeWidening(textOf(e.range), nameOf(from), nameOf(to)));
    return false;
}

/// An implicit conversion that may lose something; false: it is refused.
///   ok:    d := i; l := r;      advice: i := d;  (P2004)   c := i;  with an enumeration (P2032)
bool Checker::tellNarrowing(const Operand& operand, TypeId to) {
    const SourceRange range = operand.expr->range;
    const TypeId from = operand.type();
    const types::Type& target = types[to];
    if (target.kind == TypeKind::Enum) {
        if (target.isStrict) {
            strictMismatch(range, textOf(range), to);
            return false;
        }
        emit(range, findings::IntegerToEnum(nameOf(from), nameOf(to)));
        return true;
    }
    auto& diagnostic = emit(range, findings::LossyAssignment(nameOf(from), nameOf(to)));
    const TypeKind toKind = types.storageKind(to), fromKind = types.storageKind(from);
    if (!types::isElementary(fromKind) || !types::isElementary(toKind) || !range.file.isValid()) return true;
    const std::string function = std::string(types::spelling(fromKind)) + "_TO_" + std::string(types::spelling(toKind));
    diagnostic.fixes.push_back(
        {fixes::ConvertWith(function),
         {{{range.file, range.begin, range.begin}, function + "("}, {{range.file, range.end, range.end}, ")"}}});
    return true;
}

Operand Checker::converted(Operand operand, TypeId to) {
    if (operand.isUnknown() || isKind(to, TypeKind::Unknown)) return operand.expr ? operand : unknown({});
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    if (isKind(from, TypeKind::Void)) {
        emit(range, findings::NoValue(textOf(range)));
        return unknown(range);
    }
    if (from == to && !operand.isFlexible) return operand;
    if (operand.isFlexible || (operand.isConstant() && isNumeric(from) && !isKind(from, TypeKind::Enum)))
        if (const auto made = convertedConstant(operand, to)) return *made;
    return convertedByType(operand, to);
}

/// The part of converted() that knows types only.
Operand Checker::convertedByType(const Operand& operand, TypeId to) {
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    const Family fromFamily = types::familyOf(types.storageKind(from));
    // a literal FALSE or TRUE as a number
    if (fromFamily == Family::Bool && operand.isConstant() && isNumeric(to)) return convertNode(operand, to);
    if (const auto made = convertedCharacter(operand, to)) return *made;
    if (types.isText(to) && (types.isText(from) || fromFamily == Family::Character)) return convertedText(operand, to);

    if (const auto made = convertedObject(operand, to)) return *made;
    const bool isDividing = tellEarlyOperation(operand, to);
    switch (types::implicitConversion(types, from, to)) {
    case types::Implicit::Same:
    case types::Implicit::Widening:
        break;
    case types::Implicit::Narrowing:
        if (!isDividing && !tellNarrowing(operand, to)) return unknown(range);
        break;
    case types::Implicit::Forbidden:
        mismatch(range, from, to);
        return unknown(range);
    }
    const bool fromAddress = isKind(from, TypeKind::Pointer) || isKind(from, TypeKind::Reference);
    const bool toAddress = isKind(to, TypeKind::Pointer) || isKind(to, TypeKind::Reference);
    if (fromAddress && toAddress) return sameBits(operand, to);
    if (fromAddress) return convertNode(sameBits(operand, elementary(TypeKind::Lword)), to);
    if (toAddress) return sameBits(convertNode(operand, elementary(TypeKind::Lword)), to);
    if (types.storage(from) == types.storage(to) && operand.expr->kind == tree::ExprKind::Constant) {
        types::Value value = operand.expr->value;
        value.type = to;
        return constant(std::move(value), range);
    }
    return convertNode(operand, to);
}

} // namespace plc::sema
