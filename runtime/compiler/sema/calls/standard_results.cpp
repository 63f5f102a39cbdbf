// What a standard function gives: its operands brought to one type, and the type of the result, by the rule of the
// signature (runtime/library/signatures.h).
#include "runtime/compiler/sema/calls/standard_results.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

using library::Intrinsic;
using library::Rule;
using library::Signature;
using types::Family;

namespace {

/// The widest kind of text there is among them, with the largest capacity.
// WSTRING wins over STRING whatever the capacities: the other way characters would be lost.
TypeId widestText(const Context& context, const std::vector<Operand>& operands, size_t first) {
    TypeId type;
    for (size_t i = first; i < operands.size(); ++i)
        if (context.isKind(operands[i].type(), TypeKind::Wstring) &&
            (!type.isValid() || context.types[operands[i].type()].capacity > context.types[type].capacity))
            type = operands[i].type();
    for (size_t i = first; i < operands.size() && (!type.isValid() || !context.isKind(type, TypeKind::Wstring)); ++i)
        if (context.types.isText(operands[i].type()) &&
            (!type.isValid() || context.types[operands[i].type()].capacity > context.types[type].capacity))
            type = operands[i].type();
    return type;
}

// Only the kind of text is made equal; lengths stay, since text functions take any capacity. The longest operand gives
// the result's capacity.
Operand makeCommonText(Context& context, std::vector<Operand>& operands, size_t first) {
    const SourceRange range = operands[first].expr->range;
    const TypeId type = widestText(context, operands, first);
    for (size_t i = first; i < operands.size(); ++i) {
        if (context.types.kind(operands[i].type()) != context.types.kind(type))
            operands[i] = converted(context, operands[i], type);
        if (operands[i].isUnknown()) return unknown(context, range);
    }
    Operand out = operands[first];
    for (size_t i = first; i < operands.size(); ++i)
        if (context.types[operands[i].type()].capacity > context.types[out.type()].capacity) out = operands[i];
    return out;
}

/// A value of the type, to ask what it has in common with another.
// Offset 0 is never read: only the type of the load is looked at.
Operand valueOfType(Context& context, TypeId type, SourceRange range) {
    return load(context, absolutePlace(context, 0, type, -1, range), range);
}

/// What those that have a type have in common; nothing: all are literals; unknown: reported.
std::optional<Operand> strongestOf(Context& context, const std::vector<Operand>& operands, size_t first,
                                   const Signature& signature) {
    const SourceRange range = operands[first].expr->range;
    std::optional<Operand> strongest;
    for (size_t i = first; i < operands.size(); ++i) {
        const Operand& operand = operands[i];
        if (operand.isFlexible) continue;
        if (!strongest) {
            strongest = operand;
            continue;
        }
        // Also keeps structures and enumerations, which have nothing in common with anything else.
        if (sameType(context.world, strongest->type(), operand.type())) continue;
        const TypeId type = commonType(context, *strongest, operand);
        if (!type.isValid()) {
            context.emit(operand.expr->range,
                         findings::OperandsDoNotMatch(signature.name, context.nameOf(strongest->type()),
                                                      context.nameOf(operand.type())));
            return unknown(context, range);
        }
        // The common type may be that of none of them: SINT and USINT meet in INT.
        strongest = valueOfType(context, type, range);
    }
    return strongest;
}

/// The type of those that have one, wider where a literal beside it needs it.
TypeId widenedFor(Context& context, const std::vector<Operand>& operands, size_t first, TypeId type, TypeId hint) {
    // A subrange's values leave it as soon as they are computed with; enumerations stay what they are.
    if (context.types.family(type) != Family::Other && !context.isKind(type, TypeKind::Enum))
        type = context.types.storage(type);
    for (size_t i = first; i < operands.size(); ++i) {
        if (!operands[i].isFlexible) continue;
        // what does not fit otherwise is converted later, with its message
        if (!isNumeric(context, type) || fits(context, operands[i].expr->value, type)) continue;
        const Operand probe = valueOfType(context, type, operands[first].expr->range);
        const TypeId wider = commonType(context, probe, operands[i]);
        if (wider.isValid()) type = wider;
        // i + 0.5 in a REAL assignment: REAL, although the common type of an INT and a literal is LREAL.
        if (context.types.family(type) == Family::Real && hint.isValid() && context.types.family(hint) == Family::Real)
            type = context.types.storage(hint);
    }
    return type;
}

/// Literals alone: the type wanted when all fit, else the smallest that holds them.
// At least INT, since a sum of two small literals would otherwise wrap in SINT.
TypeId typeOfLiterals(Context& context, const std::vector<Operand>& operands, size_t first, TypeId hint) {
    const bool real = std::any_of(operands.begin() + static_cast<std::ptrdiff_t>(first), operands.end(),
                                  [](const Operand& o) { return std::holds_alternative<double>(o.expr->value.data); });
    bool hintFits = hint.isValid() && isNumeric(context, hint) && (!real || context.types.family(hint) == Family::Real);
    for (size_t i = first; hintFits && i < operands.size(); ++i)
        hintFits = fits(context, operands[i].expr->value, hint);
    if (hintFits) return context.types.storage(hint);
    if (real) return context.elementary(TypeKind::Lreal);
    TypeId type = context.elementary(TypeKind::Int);
    for (size_t i = first; i < operands.size(); ++i) {
        const TypeId smallest = smallestType(context, operands[i]);
        if (context.types[smallest].size > context.types[type].size || context.types.kind(smallest) == TypeKind::Ulint)
            type = smallest;
    }
    return type;
}

/// Makes the operands from `first` on equal in type; the first of them is returned (for its type), unknown when they do
/// not combine.
Operand makeCommon(Context& context, std::vector<Operand>& operands, size_t first, const Signature& signature,
                   TypeId hint) {
    const SourceRange range = operands[first].expr->range;
    if (std::any_of(operands.begin() + static_cast<std::ptrdiff_t>(first), operands.end(),
                    [&](const Operand& o) { return context.types.isText(o.type()); }))
        return makeCommonText(context, operands, first);
    const std::optional<Operand> strongest = strongestOf(context, operands, first, signature);
    if (strongest && strongest->isUnknown()) return *strongest;
    const TypeId type = strongest ? widenedFor(context, operands, first, strongest->type(), hint)
                                  : typeOfLiterals(context, operands, first, hint);
    // Numbers are converted without a question here (they are widened, see strongestOf); all others by the rules of
    // assignment, which refuse what does not fit.
    const bool isImplicit = context.types.isAggregate(type) || context.isKind(type, TypeKind::Interface) ||
                            context.isKind(type, TypeKind::Pointer) || !isNumeric(context, type);
    for (size_t i = first; i < operands.size(); ++i) {
        Operand& operand = operands[i];
        operand =
            operand.isFlexible || isImplicit ? converted(context, operand, type) : convertNode(context, operand, type);
        if (operand.isUnknown()) return unknown(context, range);
    }
    return operands[first];
}

/// A text that holds `sum` characters, at most 255 where the operands are no longer themselves.
// CONCAT and INSERT must not cut what fits by declaration. 255 is the longest text without a declared length of its
// own; without a bound, texts in loops of calls would grow with every nesting.
TypeId grownText(Context& context, TypeId text, size_t sum) {
    const size_t own = context.types[text].capacity;
    return textType(context, std::max<size_t>(own, std::min<size_t>(sum, 255)),
                    context.isKind(text, TypeKind::Wstring));
}

// What the rules make of the operands: the result's type, invalid when it was reported.

TypeId commonResult(Context& context, const Signature& signature, std::vector<Operand>& operands, TypeId hint) {
    const Operand common = makeCommon(context, operands, 0, signature, hint);
    if (common.isUnknown()) return {};
    if (*signature.intrinsic != Intrinsic::Concat) return common.type();
    size_t sum = 0;
    for (const Operand& operand : operands) sum += context.types[operand.type()].capacity;
    return sum > context.types[common.type()].capacity ? grownText(context, common.type(), sum) : common.type();
}

// SHL, LEFT, DELETE …: the result is what the first operand is, the others are counts and positions.
TypeId firstOperandResult(Context& context, const Signature& signature, std::vector<Operand>& operands, TypeId hint) {
    for (size_t i = 0; i < operands.size(); ++i) operands[i] = settled(context, operands[i], i == 0 ? hint : TypeId());
    TypeId result = operands[0].type();
    if (context.isKind(result, TypeKind::Subrange)) result = context.types.storage(result);
    const Intrinsic code = *signature.intrinsic;
    if ((code != Intrinsic::Insert && code != Intrinsic::Replace) || operands.size() < 2) return result;
    if (context.types.kind(operands[1].type()) != context.types.kind(result))
        operands[1] = converted(context, operands[1], result);
    if (operands[1].isUnknown()) return {};
    return grownText(context, result, context.types[result].capacity + context.types[operands[1].type()].capacity);
}

// LEN, FIND, TRUNC …: the result's type is in the signature.
TypeId fixedResult(Context& context, const Signature& signature, std::vector<Operand>& operands, TypeId hint) {
    for (Operand& operand : operands) operand = settled(context, operand);
    if (*signature.intrinsic == Intrinsic::Find &&
        context.types.kind(operands[0].type()) != context.types.kind(operands[1].type())) {
        const bool isFirstNarrow = context.isKind(operands[0].type(), TypeKind::String);
        Operand& narrow = operands[isFirstNarrow ? 0 : 1];
        const bool isFirstWide = context.isKind(operands[0].type(), TypeKind::Wstring);
        narrow = convertedText(context, narrow, operands[isFirstWide ? 0 : 1].type());
        if (narrow.isUnknown()) return {};
    }
    // TRUNC gives ANY_INT (table 22): the variable it is assigned to chooses which.
    if (signature.name == "TRUNC" && hint.isValid() && types::isInteger(context.types.family(hint)))
        return context.types.storage(hint);
    if (signature.result == TypeKind::String || signature.result == TypeKind::Wstring)
        return textType(context, 1, signature.result == TypeKind::Wstring);
    return context.elementary(signature.result);
}

/// LREAL as soon as an operand needs it; literals and integers alone take the real type that is wanted.
TypeKind realKindOf(const Context& context, const std::vector<Operand>& operands, TypeId hint) {
    TypeKind kind = TypeKind::Unknown;
    bool onlyFlexible = true, wholeOnly = true;
    for (const Operand& operand : operands) {
        wholeOnly = wholeOnly && context.types.family(operand.type()) != Family::Real;
        if (operand.isFlexible) continue;
        onlyFlexible = false;
        const TypeKind own = context.types.storageKind(operand.type());
        // More than 16 bits do not fit into REAL's 24 bits of mantissa in general.
        const bool wide = own == TypeKind::Lreal ||
                          (types::isInteger(context.types.family(operand.type())) && types::bitsOf(own) > 16);
        if (wide)
            kind = TypeKind::Lreal;
        else if (kind == TypeKind::Unknown)
            kind = TypeKind::Real;
    }
    // SQRT(i) for a REAL is computed as REAL: the assignment would otherwise be reported as lossy, for an LREAL that
    // nobody asked for.
    if (wholeOnly && hint.isValid() && context.types.family(hint) == Family::Real)
        return context.types.storageKind(hint);
    if (!onlyFlexible) return kind;
    return hint.isValid() && context.types.storageKind(hint) == TypeKind::Real ? TypeKind::Real : TypeKind::Lreal;
}

TypeId realResult(Context& context, std::vector<Operand>& operands, TypeId hint) {
    const TypeId result = context.elementary(realKindOf(context, operands, hint));
    for (Operand& operand : operands) {
        operand = operand.isFlexible ? converted(context, operand, result) : convertNode(context, operand, result);
        if (operand.isUnknown()) return {};
    }
    return result;
}

TypeId resultType(Context& context, const Signature& signature, std::vector<Operand>& operands, TypeId hint) {
    switch (signature.rule) {
    case Rule::Common:
        return commonResult(context, signature, operands, hint);
    case Rule::FirstOperand:
        return firstOperandResult(context, signature, operands, hint);
    case Rule::FixedResult:
        return fixedResult(context, signature, operands, hint);
    case Rule::RealOperand:
        return realResult(context, operands, hint);
    // SEL and MUX: the first operand chooses, the others share the type of the result.
    case Rule::SecondOperand: {
        operands[0] = settled(context, operands[0]);
        const Operand common = makeCommon(context, operands, 1, signature, hint);
        return common.isUnknown() ? TypeId() : common.type();
    }
    case Rule::Compare:
    case Rule::Special:
        return {};
    }
    return {};
}

} // namespace

Operand signatureResult(Context& context, const Signature& signature, std::vector<Operand> operands,
                        const syntax::Expr& e, TypeId hint) {
    const TypeId result = resultType(context, signature, operands, hint);
    if (!result.isValid()) return unknown(context, e.range);
    const Intrinsic code = *signature.intrinsic;
    const bool cuts = code == Intrinsic::Trunc || code == Intrinsic::Floor || code == Intrinsic::Ceil;
    if (cuts && signature.rule == Rule::FixedResult && context.types.family(operands[0].type()) != Family::Real)
        return convertNode(context, operands[0], result); // an integer has nothing to cut
    // In an expression MOVE is its argument: nothing is there to copy it to.
    if (context.isExpression && code == Intrinsic::Move) return operands[0];
    return intrinsic(context, code, result, operands, e.range, signature.selector);
}

} // namespace plc::sema
