// Calls of conversions: INT_TO_REAL, TO_STRING, TRUNC_INT, BCD_TO_INT …
#include "runtime/compiler/sema/calls/conversion_calls.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/operators_of_codesys.h"
#include "runtime/compiler/sema/calls/standard_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

namespace plc::sema {

using library::Signature;
using types::Family;
using How = library::Conversion::How;

namespace {

/// A literal as the argument of a conversion named by types.
///   ok:    INT_TO_STRING(5); BOOL_TO_INT(TRUE);      wrong: STRING_TO_INT(5); INT_TO_STRING('x'); TIME_TO_INT(5);
bool suitsConversion(const Context& context, const Operand& literal, TypeId from) {
    const Family family = context.types.family(from);
    // TIME_TO_INT(5) is refused: 5 is no duration, and which unit is meant cannot be seen.
    const bool isNumber = std::holds_alternative<int64_t>(literal.expr->value.data) ||
                          std::holds_alternative<double>(literal.expr->value.data);
    const bool isText =
        context.types.isText(literal.type()) || context.types.family(literal.type()) == Family::Character;
    if (isText || !isNumber) return context.types.isText(from) || family == Family::Character;
    return types::isInteger(family) || family == Family::Real;
}

/// The type a conversion names; a text that is wanted longer than 80 characters is made that long.
TypeId typeNamed(Context& context, TypeKind kind, TypeId hint) {
    if (kind != TypeKind::String && kind != TypeKind::Wstring) return context.elementary(kind);
    // A watch adds no types; STRING(80) is there from the start.
    if (!context.isExpression && hint.isValid() && context.types.kind(hint) == kind &&
        context.types[hint].capacity > 80)
        return hint;
    return textType(context, 80, kind == TypeKind::Wstring);
}

bool isTextLiteral(const syntax::Expr& e) {
    return e.kind == syntax::ExprKind::Literal && !e.prefix.isValid() &&
           (e.op == lex::TokenKind::StringLiteral || e.op == lex::TokenKind::WstringLiteral);
}

/// The argument as it is written; 'x' is no number here. `from`: the type the name asks for, invalid: any.
Operand argumentOf(Context& context, const syntax::Expr& value, TypeId from) {
    const bool takesText =
        !from.isValid() || context.types.isText(from) || context.types.family(from) == Family::Character;
    // 'x' for a number: with the hint it would be read as a character's code and pass.
    const bool isMistakenText = isTextLiteral(value) && !takesText;
    const Operand operand = expression(context, value, isMistakenText ? TypeId() : from);
    if (operand.isUnknown()) return operand;
    if (isMistakenText)
        context.emit(value.range, findings::TypeMismatch(context.textOf(value.range), context.nameOf(from)));
    else if (context.isKind(operand.type(), TypeKind::Void))
        context.emit(operand.expr->range, findings::NoValue(context.textOf(operand.expr->range)));
    else
        return operand;
    return unknown(context, value.range);
}

/// The argument in the type the name asks for.
Operand inTypeAskedFor(Context& context, Operand operand, TypeId from, How how) {
    // TO_REAL(x) takes whatever x is; only the long names ask for a type.
    if (!from.isValid()) return settled(context, operand);
    // INT_TO_DINT(70000) is an error where it is written, not a wrapped number: the literal was never an INT.
    const bool isTooLarge = operand.isFlexible && how == How::Convert && types::isInteger(context.types.family(from)) &&
                            !fits(context, operand.expr->value, from) &&
                            std::holds_alternative<int64_t>(operand.expr->value.data);
    if (isTooLarge) return converted(context, operand, from);
    // INT_TO_STRING(5): the literal keeps its smallest type where a text is wanted, so that no sign or digit changes.
    if (operand.isFlexible && suitsConversion(context, operand, from))
        return convertNode(context, operand, context.types.isText(from) ? smallestType(context, operand) : from);
    if (context.types.isText(from) && context.types.isText(operand.type()))
        return convertedText(context, operand, from);
    return converted(context, operand, from);
}

/// Nothing to do for the same type; but ENO needs a value of its own.
Operand plainConversion(Context& context, Operand operand, TypeId to, bool hasEno, SourceRange range) {
    // The range becomes the call's: a message or a step shall mark INT_TO_REAL(i), not i alone.
    const Operand out = convertNode(context, operand, to);
    out.expr->range = range;
    const bool isSame = out.expr == operand.expr && out.expr->kind != tree::ExprKind::Constant;
    return isSame && hasEno ? intrinsic(context, library::Intrinsic::Move, to, {operand}, range) : out;
}

///   wrong: INT_TO_BCD(r)  with r : REAL (P2006)
Operand bcdConversion(Context& context, Operand operand, const library::Conversion& conversion, std::string_view name,
                      SourceRange range, TypeId hint) {
    if (!types::isInteger(context.types.family(operand.type()))) {
        context.emit(operand.expr->range, findings::OperatorNotForType(name, context.nameOf(operand.type())));
        return unknown(context, range);
    }
    TypeId to = typeNamed(context, conversion.to, hint);
    // A REAL has no digits in the sense of BCD (2.5.1.5.1): only whole numbers.
    const bool toBcd = conversion.how == How::ToBcd;
    // INT_TO_BCD takes the bit string that is wanted
    if (toBcd && foldCase(name).ends_with("_bcd") && hint.isValid() && context.types.family(hint) == Family::Bits)
        to = context.types.storage(hint);
    return intrinsic(context, toBcd ? library::Intrinsic::ToBcd : library::Intrinsic::BcdTo, to, {operand}, range);
}

/// CODESYS converts the number; other compilers take the bits as they are. Said where the program is the user's.
///   advice: r := DWORD_TO_REAL(bits);  (P2047)
void sayWhatIsConverted(Context& context, const Operand& operand, TypeId to, std::string_view name,
                        const syntax::Expr& e) {
    const auto isWide = [&](TypeId type) {
        const TypeKind kind = context.types.storageKind(type);
        return kind == TypeKind::Dword || kind == TypeKind::Lword;
    };
    const auto isReal = [&](TypeId type) { return context.types.family(type) == Family::Real; };
    const TypeId from = operand.type();
    const bool isBetween = (isWide(from) && isReal(to)) || (isReal(from) && isWide(to));
    // Libraries mean what they do, and an expression of a watch is nobody's program.
    const bool isUsers = !context.isExpression && context.scope.unit && !context.scope.unit->isLibrary();
    if (isBetween && isUsers && !operand.isFlexible)
        context.emit(e.base ? e.base->range : e.range, findings::ConvertsTheNumber(name));
}

} // namespace

///   ok:    INT_TO_REAL(i)      wrong: INT_TO_REAL(s)  with s : STRING (P2003)
// By the name alone: INT_TO_REAL, TO_REAL, REAL_TRUNC_INT; library::findConversion has taken it apart.
Operand conversionCall(Context& context, const library::Conversion& conversion, std::string_view name,
                       const syntax::Expr& e, TypeId hint) {
    // Conversions have no entry in the table of signatures (they are all pairs of types): one with a single input is
    // made up.
    Signature signature;
    signature.name = name;
    signature.parameters.push_back({"IN", {"IN1", "STR", "X"}, library::Generic::Any});
    const StandardArguments arguments = standardArguments(context, signature, e);
    if (!arguments.isGood || arguments.inputs.empty() || !arguments.inputs[0]) return unknown(context, e.range);
    const TypeId from = conversion.from == TypeKind::Unknown ? TypeId() : typeNamed(context, conversion.from, hint);
    Operand operand = argumentOf(context, *arguments.inputs[0]->value, from);
    if (operand.isUnknown()) return unknown(context, e.range);
    const TypeKind kind = context.types.kind(operand.type());
    // An address is 64 bits; DWORD_TO_… of a pointer would cut it, so it goes by LWORD and is narrowed visibly.
    if (kind == TypeKind::Pointer || kind == TypeKind::Reference || kind == TypeKind::Interface)
        operand = settled(context, sameBits(context, operand, context.elementary(TypeKind::Lword)));
    else
        operand = inTypeAskedFor(context, operand, from, conversion.how);
    if (operand.isUnknown()) return unknown(context, e.range);
    if (context.types.family(operand.type()) == Family::Other && !context.types.isText(operand.type())) {
        context.emit(operand.expr->range, findings::OperatorNotForType(name, context.nameOf(operand.type())));
        return unknown(context, e.range);
    }
    const TypeId to = typeNamed(context, conversion.to, hint);
    Operand out;
    switch (conversion.how) {
    case How::Convert:
        sayWhatIsConverted(context, operand, to, name, e);
        // {attribute 'to_string'}: TO_STRING of an enumeration is its name.
        if (const auto named = nameOfValue(context, operand, to, e.range))
            out = *named;
        else
            out = plainConversion(context, operand, to, arguments.eno != nullptr, e.range);
        break;
    case How::Truncate:
        out = intrinsic(context, library::Intrinsic::Trunc, to, {operand}, e.range);
        break;
    case How::FromBcd:
    case How::ToBcd:
        out = bcdConversion(context, operand, conversion, name, e.range, hint);
        if (out.isUnknown()) return out;
        break;
    }
    return withEnable(context, out, arguments, e.range);
}

} // namespace plc::sema
