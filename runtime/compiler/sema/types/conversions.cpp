// Implicit and written conversions, and the common type of two operands (D11).
#include "runtime/compiler/sema/types/conversions.h"

#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

#include <cmath>

namespace plc::sema {

using types::Family;
using types::TypeTable;

static void strictMismatch(Context& context, SourceRange range, std::string what, TypeId to);
static std::optional<Operand> convertedConstant(Context& context, Operand& operand, TypeId to);
static std::optional<Operand> convertedCharacter(Context& context, const Operand& operand, TypeId to);
static std::optional<Operand> convertedObject(Context& context, const Operand& operand, TypeId to);
static bool tellEarlyOperation(Context& context, const Operand& operand, TypeId to);
static bool tellNarrowing(Context& context, const Operand& operand, TypeId to);
static Operand convertedByType(Context& context, const Operand& operand, TypeId to);

/// Can the type hold the constant as it is? A bit pattern such as 16#FFFF_FFFF_FFFF_FFFF is no negative number.
bool fits(const Context& context, const types::Value& value, TypeId type) {
    const types::Type& target = context.types[type];
    const TypeKind kind = context.types.storageKind(type);
    const Family family = types::familyOf(kind);
    if (std::holds_alternative<double>(value.data)) {
        // Half a unit above the greatest REAL still rounds to it.
        if (family == Family::Real) return kind == TypeKind::Lreal || std::abs(value.real()) <= 3.4028235677973366e38;
        return false;
    }
    if (!std::holds_alternative<int64_t>(value.data)) return false;
    if (family == Family::Real) return true;
    if (family == Family::Bool) return value.integer() == 0 || value.integer() == 1;
    if (!types::isInteger(family) && family != Family::Character) return false;
    const bool isBig = context.types.storageKind(value.type) == TypeKind::Ulint ||
                       context.types.storageKind(value.type) == TypeKind::Lword; // bit pattern
    const unsigned bits = types::bitsOf(kind);
    const bool isSigned = family == Family::Signed;
    const int64_t number = value.integer();
    // Stored as int64: the sign bit of a ULINT is a digit.
    if (isBig && number < 0) return !isSigned && bits == 64;
    if (target.kind == TypeKind::Subrange && (number < target.low || number > target.high)) return false;
    if (isSigned) return bits == 64 || (number >= -(int64_t(1) << (bits - 1)) && number < (int64_t(1) << (bits - 1)));
    if (number < 0) return false;
    return bits == 64 || number < (int64_t(1) << bits);
}

// INT at least: SINT would make 100 + 100 wrap.
TypeId smallestType(const Context& context, const Operand& flexible) {
    const types::Value& value = flexible.expr->value;
    if (std::holds_alternative<double>(value.data)) return context.elementary(TypeKind::Lreal);
    for (const TypeKind kind : {TypeKind::Int, TypeKind::Dint, TypeKind::Lint, TypeKind::Ulint})
        if (fits(context, value, context.elementary(kind))) return context.elementary(kind);
    return context.elementary(TypeKind::Lint);
}

/// The type in which two operands are computed: a literal takes the other's when it fits; else the wider one, and
/// between equally wide ones the signed one (D11).
TypeId commonType(const Context& context, const Operand& a, const Operand& b) {
    const TypeKind x = context.types.storageKind(a.type()), y = context.types.storageKind(b.type());
    const Family f = types::familyOf(x), g = types::familyOf(y);
    if (a.isFlexible != b.isFlexible) {
        const Operand& literal = a.isFlexible ? a : b;
        const TypeId other = context.types.storage(a.isFlexible ? b.type() : a.type());
        if (fits(context, literal.expr->value, other)) return other;
    }
    // Others have a common type only within their family: TIME and LTIME, TOD and LTOD.
    const bool numeric = isNumeric(context, a.type()) && isNumeric(context, b.type());
    if (!numeric)
        return f == g && f != Family::Other && !context.types.isText(a.type())
                   ? context.elementary(types::bitsOf(y) > types::bitsOf(x) ? y : x)
                   : TypeId();
    // 0.5 beside an INT is a REAL, beside a DINT an LREAL: the number decides how many digits are needed.
    const auto single = [&](const Operand& real, const Operand& whole) {
        if (!real.isFlexible) return real.type();
        return context.elementary(types::bitsOf(context.types.storageKind(whole.type())) <= 16 &&
                                          fits(context, real.expr->value, context.elementary(TypeKind::Real))
                                      ? TypeKind::Real
                                      : TypeKind::Lreal);
    };
    if (f == Family::Real && g == Family::Real)
        return context.elementary(x == TypeKind::Lreal || y == TypeKind::Lreal ? TypeKind::Lreal : TypeKind::Real);
    if (f == Family::Real) return context.types.storage(single(a, b));
    if (g == Family::Real) return context.types.storage(single(b, a));
    const TypeKind own = a.isFlexible ? context.types.storageKind(smallestType(context, a)) : x,
                   other = b.isFlexible ? context.types.storageKind(smallestType(context, b)) : y;
    const unsigned m = types::bitsOf(own), n = types::bitsOf(other);
    // The wider one, whatever its sign: UINT and DINT meet in DINT, which holds both.
    if (m != n) return context.elementary(m > n ? own : other);
    const Family p = types::familyOf(own), q = types::familyOf(other);
    if (p == q) return context.elementary(own);
    // Equal widths: DINT and UDINT meet in DINT, as the sum of two counters may go below zero (D11).
    if (p == Family::Signed || q == Family::Signed) return context.elementary(p == Family::Signed ? own : other);
    // WORD and UINT: the number and not the pattern.
    return context.elementary(p == Family::Unsigned ? own : other);
}

///   wrong: x := 'a text'; b := r; t := 5;  with INT, BOOL and TIME (P2003)
void mismatch(Context& context, SourceRange range, TypeId from, TypeId to) {
    auto& diagnostic = context.emit(range, findings::TypeMismatch(context.nameOf(from), context.nameOf(to)));
    // A fix where a conversion of these names exists.
    const TypeKind a = context.types.storageKind(from), b = context.types.storageKind(to);
    const auto named = [](TypeKind kind) -> std::string {
        return kind == TypeKind::String    ? "STRING"
               : kind == TypeKind::Wstring ? "WSTRING"
                                           : std::string(types::spelling(kind));
    };
    if (!named(a).empty() && !named(b).empty() && range.file.isValid()) {
        const std::string function = named(a) + "_TO_" + named(b);
        const std::string text(context.textOf(range));
        // t := 5: the message is about the number that has no unit, not about INT and TIME.
        if (context.types.family(to) == types::Family::Duration && !text.empty() && text.size() < 10 &&
            text.find_first_not_of("0123456789") == std::string::npos) { // a number without its unit
            for (const char* unit : {"ms", "s"}) {
                const std::string duration = (b == TypeKind::Ltime ? "LT#" : "T#") + text + unit;
                diagnostic.fixes.push_back({fixes::Write(duration), {{range, duration}}});
            }
            diagnostic.message = findings::TypeMismatch(text, context.nameOf(to)).message;
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
void strictMismatch(Context& context, SourceRange range, std::string what, TypeId to) {
    auto& diagnostic = context.emit(range, findings::StrictEnum(std::move(what), context.nameOf(to)));
    // A list of more than five is no help as a fix; completion shows them.
    if (!range.file.isValid() || context.types[to].enumerators.empty() || context.types[to].enumerators.size() > 5)
        return;
    for (const types::Enumerator& enumerator : context.types[to].enumerators) {
        const std::string name = context.nameOf(to) + "." + enumerator.name;
        diagnostic.fixes.push_back({fixes::Write(name), {{range, name}}});
    }
}

///   wrong: i := c + 1;  with c of an enumeration with {attribute 'strict'} (P2039)
// Asked before each operator: a strict enumeration has names and no numbers.
bool isStrict(Context& context, const Operand& operand) {
    if (!context.isKind(operand.type(), TypeKind::Enum) || !context.types[operand.type()].isStrict) return false;
    const std::string function = "TO_" + std::string(types::spelling(context.types.storageKind(operand.type())));
    const SourceRange range = operand.expr->range;
    auto& diagnostic = context.emit(range, findings::StrictCalculation(context.nameOf(operand.type()), function));
    if (range.file.isValid())
        diagnostic.fixes.push_back(
            {fixes::ConvertWith(function),
             {{{range.file, range.begin, range.begin}, function + "("}, {{range.file, range.end, range.end}, ")"}}});
    return true;
}

Operand convertNode(Context& context, Operand operand, TypeId to) {
    if (operand.isUnknown() || operand.type() == to) {
        operand.isFlexible = false;
        return operand;
    }
    // types::convert is what the code does when it runs: folding must not differ.
    if (operand.isConstant() && !context.types.isAggregate(to)) {
        types::Value value = types::convert(context.types, operand.expr->value, to);
        value.type = to;
        return constant(context, std::move(value), operand.expr->range);
    }
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Convert;
    e->type = to;
    e->range = operand.expr->range;
    e->a = operand.expr;
    return {e, &context.types};
}

// Another name for the same bits: no code, but a node, since trees are typed.
Operand sameBits(Context& context, Operand operand, TypeId to) {
    if (operand.isUnknown() || operand.type() == to) return operand;
    if (operand.isConstant()) {
        types::Value value = operand.expr->value;
        value.type = to;
        return constant(context, std::move(value), operand.expr->range);
    }
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Intrinsic;
    e->intrinsic = library::Intrinsic::SameBits;
    e->type = to;
    e->range = operand.expr->range;
    e->operands.push_back(operand.expr);
    return {e, &context.types};
}

/// What a text needs as a WSTRING, which counts UTF-16 units, or as a STRING, which counts bytes.
size_t lengthAs(types::StringCode code, const std::string& narrow, bool asWide) {
    return asWide ? types::wideOfString(code, narrow).size() : narrow.size();
}
size_t lengthAs(types::StringCode code, const std::u16string& wide, bool asWide) {
    bool ignored = true;
    return asWide ? wide.size() : types::stringOfWide(code, wide, ignored).size();
}

/// In one byte a character both are the same.
messages::Phrase lengthOfText(types::StringCode code, size_t length, bool isWide) {
    const auto count = static_cast<int64_t>(length);
    return code == types::StringCode::Utf8 && !isWide ? phrases::BytesInUtf8(count) : phrases::CharactersOfText(count);
}

///   ok:    s := 'abcd';  with STRING(4)      advice: with STRING(3) (P2028)      wrong: s := 'Ω';  (P2027)
Operand convertedText(Context& context, Operand operand, TypeId to) {
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    if (operand.isConstant()) {
        const types::Type& target = context.types[to];
        if (context.types.isText(from) && context.types.isText(to)) {
            const auto* narrow = std::get_if<std::string>(&operand.expr->value.data);
            const auto* wide = std::get_if<std::u16string>(&operand.expr->value.data);
            const bool toWide = context.types.kind(to) == TypeKind::Wstring;
            if (wide && !toWide) {
                const std::string utf8 = utf16ToUtf8(*wide);
                size_t bad = 0;
                if (!types::stringOfUtf8(context.types.strings, utf8, &bad)) {
                    size_t end = bad;
                    (void)decodeUtf8(utf8, end);
                    context.emit(range, findings::CharacterNotInString(utf8.substr(bad, end - bad),
                                                                       types::nameOf(context.types.strings)));
                    return unknown(context, range);
                }
            }
            const size_t length = narrow ? lengthAs(context.types.strings, *narrow, toWide)
                                  : wide ? lengthAs(context.types.strings, *wide, toWide)
                                         : 0;
            // Too long is only advised: the assignment cuts at the capacity.
            if (length > target.capacity)
                context.emit(range, findings::StringTooLong(lengthOfText(context.types.strings, length, toWide),
                                                            target.capacity));
            if (context.types.kind(from) == context.types.kind(to)) return operand;
            return convertNode(context, operand, textType(context, length, toWide));
        }
    }
    if (context.types.kind(from) == context.types.kind(to)) return operand; // any capacity: the assignment cuts
    switch (types::implicitConversion(context.types, from, to)) {
    case types::Implicit::Narrowing:
        context.emit(range, findings::LossyAssignment(context.nameOf(from), context.nameOf(to)));
        break;
    case types::Implicit::Forbidden:
        mismatch(context, range, from, to);
        return unknown(context, range);
    default:
        break;
    }
    return convertNode(context, operand, to);
}

namespace {
bool holdsAddress(TypeKind kind) {
    return kind == TypeKind::Pointer || kind == TypeKind::Interface || kind == TypeKind::Reference;
}
} // namespace

/// A literal or a constant number as `to`: by its value, not by its type. None: as any operand of its type, which a
/// literal then has taken.
///   ok:    x := 40000;  with DINT      wrong: with INT (P2018)   x := 11;  with INT(1..10) (P2018)
std::optional<Operand> convertedConstant(Context& context, Operand& operand, TypeId to) {
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    const types::Type& target = context.types[to];
    const Family toFamily = types::familyOf(context.types.storageKind(to));
    const types::Value& value = operand.expr->value;
    const bool isReal = std::holds_alternative<double>(value.data);
    // The value is known, so "does not fit" is an error and no advice.
    const auto refused = [&] {
        context.emit(range, findings::ConstantOutOfRange(context.textOf(range), context.nameOf(to)));
        return unknown(context, range);
    };
    if (toFamily == Family::Real) {
        // See foldIntegers.
        if (operand.isDivided) context.emit(range, findings::IntegerDivisionToReal(context.nameOf(to)));
        return fits(context, value, to) ? convertNode(context, operand, to) : refused();
    }
    // b := 1 is common in converted programs; b := 2 is a mistake.
    if (toFamily == Family::Bool && operand.isFlexible && !isReal) {
        if (fits(context, value, to)) return convertNode(context, operand, to);
        mismatch(context, range, smallestType(context, operand), to);
        return unknown(context, range);
    }
    if (target.kind == TypeKind::Enum && !isReal) {
        const auto& enumerators = target.enumerators;
        const bool known = std::any_of(enumerators.begin(), enumerators.end(),
                                       [&](const types::Enumerator& e) { return e.value == value.integer(); });
        if (target.isStrict && !known) {
            strictMismatch(context, range, context.textOf(range), to);
            return unknown(context, range);
        }
        // c := 1 with a value of that number is accepted as it is written in so many programs; a constant by name is
        // advised.
        if (!target.isStrict && (!known || !operand.isFlexible))
            context.emit(range, findings::IntegerToEnum(context.textOf(range), target.name));
        return convertNode(context, operand, to);
    }
    if (types::isInteger(toFamily) || (toFamily == Family::Character && operand.isFlexible)) {
        // i := 2.7 rounds; i := 2.0 too, since the reader cannot see which was meant.
        if (isReal) {
            context.emit(range,
                         findings::LossyAssignment(operand.isFlexible ? context.textOf(range) : context.nameOf(from),
                                                   context.nameOf(to)));
            return convertNode(context, operand, to);
        }
        if (fits(context, value, to)) return convertNode(context, operand, to);
        if (operand.isFlexible || target.kind == TypeKind::Subrange) return refused();
    }
    // 0 is the null of pointers, references and interfaces.
    if (holdsAddress(target.kind) && !isReal && value.integer() == 0) return constant(context, {to, int64_t(0)}, range);
    // From here on it is an operand of an ordinary type.
    if (operand.isFlexible) operand = settled(context, operand);
    if (context.types.isText(to) || context.types.isAggregate(to) || context.isKind(to, TypeKind::Block)) {
        mismatch(context, range, operand.type(), to);
        return unknown(context, range);
    }
    return std::nullopt;
}

/// One character of text as a CHAR or its code.
std::optional<Operand> convertedCharacter(Context& context, const Operand& operand, TypeId to) {
    const TypeKind toKind = context.types.storageKind(to);
    const Family toFamily = types::familyOf(toKind);
    if (!context.types.isText(operand.type()) || !operand.isConstant()) return std::nullopt;
    if (toFamily != Family::Character && !(types::isInteger(toFamily) && types::bitsOf(toKind) <= 16))
        return std::nullopt;
    const auto* narrow = std::get_if<std::string>(&operand.expr->value.data);
    const auto* wide = std::get_if<std::u16string>(&operand.expr->value.data);
    if (narrow && toKind == TypeKind::Wchar) { // of a named constant: a literal has been wide already
        const std::u16string same = types::wideOfString(context.types.strings, *narrow);
        if (same.size() != 1) return std::nullopt;
        return constant(context, {to, int64_t(same.front())}, operand.expr->range);
    }
    if (narrow && narrow->size() == 1)
        return constant(context, {to, int64_t(static_cast<unsigned char>(narrow->front()))}, operand.expr->range);
    if (wide && wide->size() == 1 && types::bitsOf(toKind) == 16)
        return constant(context, {to, int64_t(wide->front())}, operand.expr->range);
    return std::nullopt;
}

/// Aggregates, blocks, interfaces, references and pointers: what is of the type already, what is derived from it.
std::optional<Operand> convertedObject(Context& context, const Operand& operand, TypeId to) {
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    const types::Type& target = context.types[to];
    const bool isPointer = context.isKind(from, TypeKind::Pointer);
    const bool isBlockPointer = isPointer && context.isKind(context.types[from].element, TypeKind::Block);
    switch (target.kind) {
    case TypeKind::Array:
    case TypeKind::Struct:
    case TypeKind::Union:
    // Whole values are copied between equal types only: a derived block has more fields than its base has room.
    case TypeKind::Block:
        if (sameType(context.world, from, to)) return operand;
        mismatch(context, range, from, to);
        return unknown(context, range);
    case TypeKind::Interface:
        if (context.isKind(from, TypeKind::Block) && operand.expr->kind == tree::ExprKind::Load &&
            context.types.implements(from, to)) {
            // An interface is the address of the block; which block it is, is written at its beginning.
            takeAddress(context, operand.expr->place);
            tree::Expr* e = context.arena.make<tree::Expr>();
            e->kind = tree::ExprKind::InterfaceOf;
            e->type = to;
            e->range = range;
            e->place = operand.expr->place;
            return Operand{e, &context.types};
        }
        if (context.isKind(from, TypeKind::Interface) && context.types.isDerivedFrom(from, to))
            return sameBits(context, operand, to);
        if (isBlockPointer && context.types.implements(context.types[from].element, to))
            return sameBits(context, operand, to);
        break;
    case TypeKind::Reference:
        // of another REFERENCE what it refers to, which may be nothing
        if (operand.expr->kind == tree::ExprKind::Load && operand.expr->place->kind == tree::PlaceKind::Deref &&
            context.isKind(operand.expr->place->pointer->type, TypeKind::Reference) &&
            sameType(context.world, from, target.element))
            return sameBits(context, {operand.expr->place->pointer, &context.types}, to);
        if (operand.expr->kind == tree::ExprKind::Load &&
            (sameType(context.world, from, target.element) ||
             (context.isKind(from, TypeKind::Block) && context.types.isDerivedFrom(from, target.element))))
            return addressOf(context, operand.expr->place, to, range);
        if ((isPointer || context.isKind(from, TypeKind::Reference)) &&
            sameType(context.world, context.types[from].element, target.element))
            return sameBits(context, operand, to);
        break;
    case TypeKind::Pointer:
        if (isPointer && sameType(context.world, context.types[from].element, target.element))
            return sameBits(context, operand, to);
        if (isBlockPointer && context.types.isDerivedFrom(context.types[from].element, target.element))
            return sameBits(context, operand, to);
        // POINTER TO BYTE looks at the bytes of anything, as a MEMCPY does
        if (isPointer && context.isKind(target.element, TypeKind::Byte)) return sameBits(context, operand, to);
        break;
    default:
        break;
    }
    if (!context.isKind(from, TypeKind::Null)) return std::nullopt;
    if (holdsAddress(target.kind)) return constant(context, {to, int64_t(0)}, range);
    mismatch(context, range, from, to);
    return unknown(context, range);
}

/// Says where an operation was done in fewer bits than its result is given; returns whether it divides integers for a
/// REAL, which is reported as that and not as narrowing.
///   ok:    d := INT_TO_DINT(i) * i; r := i / 2.0;      advice: d := i * i;  (P2030)   r := i / 2;  (P2029)
bool tellEarlyOperation(Context& context, const Operand& operand, TypeId to) {
    const tree::Expr& e = *operand.expr;
    const TypeId from = operand.type();
    const TypeKind toKind = context.types.storageKind(to), fromKind = context.types.storageKind(from);
    const Family toFamily = types::familyOf(toKind);
    if (e.kind != tree::ExprKind::Binary || !types::isInteger(types::familyOf(fromKind)) || !isNumeric(context, to))
        return false;
    if (toFamily == Family::Real && e.binary == library::BinaryOp::Divide) {
        context.emit(e.range, findings::IntegerDivisionToReal(context.nameOf(to)));
        return true;
    }
    // d := i * i is computed in INT and wraps before it is widened: the type of the target does not reach into
    // operators.
    const bool widens = types::bitsOf(toKind) > types::bitsOf(fromKind) || toFamily == Family::Real;
    const bool isSum = e.binary == library::BinaryOp::Add || e.binary == library::BinaryOp::Subtract;
    if (widens && types::bitsOf(fromKind) < 64 &&
        (e.binary == library::BinaryOp::Multiply ||
         // i + 1 is left alone: it wraps for one value of 65,536, and the advice would be everywhere.
         (isSum && e.a->kind != tree::ExprKind::Constant && e.b->kind != tree::ExprKind::Constant)))
        context.emit(e.range,
                     findings::WrapsBeforeWidening(context.textOf(e.range), context.nameOf(from), context.nameOf(to)));
    return false;
}

/// An implicit conversion that may lose something; false: it is refused.
///   ok:    d := i; l := r;      advice: i := d;  (P2004)   c := i;  with an enumeration (P2032)
bool tellNarrowing(Context& context, const Operand& operand, TypeId to) {
    const SourceRange range = operand.expr->range;
    const TypeId from = operand.type();
    const types::Type& target = context.types[to];
    if (target.kind == TypeKind::Enum) {
        if (target.isStrict) {
            strictMismatch(context, range, context.textOf(range), to);
            return false;
        }
        context.emit(range, findings::IntegerToEnum(context.nameOf(from), context.nameOf(to)));
        return true;
    }
    auto& diagnostic = context.emit(range, findings::LossyAssignment(context.nameOf(from), context.nameOf(to)));
    const TypeKind toKind = context.types.storageKind(to), fromKind = context.types.storageKind(from);
    if (!types::isElementary(fromKind) || !types::isElementary(toKind) || !range.file.isValid()) return true;
    const std::string function = std::string(types::spelling(fromKind)) + "_TO_" + std::string(types::spelling(toKind));
    diagnostic.fixes.push_back(
        {fixes::ConvertWith(function),
         {{{range.file, range.begin, range.begin}, function + "("}, {{range.file, range.end, range.end}, ")"}}});
    return true;
}

// Every assignment, argument and condition comes by here: it either gives a value of type `to` or has said why not.
Operand converted(Context& context, Operand operand, TypeId to) {
    if (operand.isUnknown() || context.isKind(to, TypeKind::Unknown))
        return operand.expr ? operand : unknown(context, {});
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    if (context.isKind(from, TypeKind::Void)) {
        context.emit(range, findings::NoValue(context.textOf(range)));
        return unknown(context, range);
    }
    // Same type, but a literal still has to be looked at: its type is only a carrier.
    if (from == to && !operand.isFlexible) return operand;
    const auto isReferenceOrPointer = [&](TypeId type) {
        return context.isKind(type, TypeKind::Reference) || context.isKind(type, TypeKind::Pointer);
    };
    if (context.isKind(from, TypeKind::Reference) &&
        !isReferenceOrPointer(to)) // of a call: a variable's is read already
        return converted(context, load(context, referredBy(context, operand, range), range), to);
    if (operand.isFlexible ||
        (operand.isConstant() && isNumeric(context, from) && !context.isKind(from, TypeKind::Enum)))
        if (const auto made = convertedConstant(context, operand, to)) return *made;
    return convertedByType(context, operand, to);
}

/// The part of converted() that knows types only.
Operand convertedByType(Context& context, const Operand& operand, TypeId to) {
    const TypeId from = operand.type();
    const SourceRange range = operand.expr->range;
    const Family fromFamily = types::familyOf(context.types.storageKind(from));
    // a literal FALSE or TRUE as a number
    if (fromFamily == Family::Bool && operand.isConstant() && isNumeric(context, to))
        return convertNode(context, operand, to);
    if (const auto made = convertedCharacter(context, operand, to)) return *made;
    if (context.types.isText(to) && (context.types.isText(from) || fromFamily == Family::Character))
        return convertedText(context, operand, to);

    if (const auto made = convertedObject(context, operand, to)) return *made;
    // Before the switch: it is an advice in addition, whether the conversion itself is widening or narrowing.
    const bool isDividing = tellEarlyOperation(context, operand, to);
    switch (types::implicitConversion(context.types, from, to)) {
    case types::Implicit::Same:
    case types::Implicit::Widening:
        break;
    case types::Implicit::Narrowing:
        if (!isDividing && !tellNarrowing(context, operand, to)) return unknown(context, range);
        break;
    case types::Implicit::Forbidden:
        mismatch(context, range, from, to);
        return unknown(context, range);
    }
    const bool fromAddress = context.isKind(from, TypeKind::Pointer) || context.isKind(from, TypeKind::Reference);
    const bool toAddress = context.isKind(to, TypeKind::Pointer) || context.isKind(to, TypeKind::Reference);
    if (fromAddress && toAddress) return sameBits(context, operand, to);
    // By way of LWORD: an address is 64 bits, and narrowing it is then a conversion between numbers with its own
    // advice.
    if (fromAddress) return convertNode(context, sameBits(context, operand, context.elementary(TypeKind::Lword)), to);
    if (toAddress) return sameBits(context, convertNode(context, operand, context.elementary(TypeKind::Lword)), to);
    if (context.types.storage(from) == context.types.storage(to) && operand.expr->kind == tree::ExprKind::Constant) {
        types::Value value = operand.expr->value;
        value.type = to;
        return constant(context, std::move(value), range);
    }
    return convertNode(context, operand, to);
}

} // namespace plc::sema
