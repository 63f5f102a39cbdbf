// Standard functions with rules of their own: bounds, sizes, addresses, powers, queries of interfaces.
#include "runtime/compiler/sema/calls/special_calls.h"

#include "runtime/compiler/sema/calls/any_inputs.h"
#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/dynamic_memory.h"
#include "runtime/compiler/sema/calls/operators_of_codesys.h"
#include "runtime/compiler/sema/calls/standard_calls.h"
#include "runtime/compiler/sema/calls/variable_info.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/layout.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

namespace plc::sema {

using types::Family;

static Operand boundCall(Context& context, const syntax::Expr& e, bool isUpper);
static Operand sizeCall(Context& context, const syntax::Expr& e, TypeKind result);
static Operand addressCall(Context& context, const syntax::Expr& e, bool isReference);
static Operand queryCall(Context& context, const syntax::Expr& e);
static tree::Place* placeToAddress(Context& context, const Denoted& denoted, SourceRange range);

///   ok:    p := REF(w);      wrong: p := REF(w.3);  (P2037)
Operand addressOf(Context& context, tree::Place* place, TypeId pointer, SourceRange range) {
    if (!hasAddress(place)) {
        context.emit(range, findings::TemporaryReference());
        return unknown(context, range);
    }
    takeAddress(context, place);
    // From here on the variable has to be in memory: takeAddress keeps it out of registers.
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::AddressOf;
    e->type = pointer;
    e->range = range;
    e->place = place;
    return {e, &context.types};
}

// Of pointers, references and interfaces alike: all three are an address, and 0 is none.
Operand isNull(Context& context, Operand pointer, SourceRange range) {
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::IsNull;
    e->type = context.elementary(TypeKind::Bool);
    e->range = range;
    e->a = pointer.expr;
    return {e, &context.types};
}

/// A VAR_IN_OUT of a block that no call has connected yet; those of functions always are.
Operand isUnbound(Context& context, const tree::Place& inOut, SourceRange range) {
    if (inOut.kind != tree::PlaceKind::InOutSlot)
        return constant(context, {context.elementary(TypeKind::Bool), int64_t(0)}, range);
    // The slot in the instance, seen as what it holds: an address. Reading the in-out itself would already follow it.
    tree::Place* slot = fieldPlace(context, inOut.base ? inOut.base : thisPlace(context, range), inOut.offset,
                                   context.elementary(TypeKind::Lword), -1, range);
    return isNull(context, load(context, slot, range), range);
}

/// LOWER_BOUND and UPPER_BOUND of ARRAY[*] .
///   ok:    UPPER_BOUND(a, 1)      wrong: UPPER_BOUND(x, 1)  with x : INT (P2014)   UPPER_BOUND(a, 3)  of two (P2016)
Operand boundCall(Context& context, const syntax::Expr& e, bool isUpper) {
    const library::Signature* signature = library::findSignature(isUpper ? "UPPER_BOUND" : "LOWER_BOUND");
    const StandardArguments arguments = standardArguments(context, *signature, e);
    if (!arguments.isGood) return unknown(context, e.range);
    tree::Place* array = place(context, *arguments.inputs[0]->value, Access::Read);
    // The dimension must be constant: it chooses which bound is read, and code has no list of them.
    const Operand dimension = expression(context, *arguments.inputs[1]->value);
    if (!array || dimension.isUnknown()) return unknown(context, e.range);
    const types::Type& type = context.types[array->type];
    if (type.kind == TypeKind::Unknown) return unknown(context, e.range);
    if (type.kind != TypeKind::Array && type.kind != TypeKind::OpenArray) {
        context.emit(arguments.inputs[0]->value->range,
                     findings::NotAnArray(context.textOf(arguments.inputs[0]->value->range)));
        return unknown(context, e.range);
    }
    if (!dimension.isConstant() || !std::holds_alternative<int64_t>(dimension.expr->value.data)) {
        context.emit(arguments.inputs[1]->value->range, findings::NotConstant());
        return unknown(context, e.range);
    }
    const int64_t number = dimension.expr->value.integer();
    if (number < 1 || number > static_cast<int64_t>(type.dimensions.size())) {
        context.emit(arguments.inputs[1]->value->range,
                     findings::ConstantIndexOutOfRange(number, 1, type.dimensions.size()));
        return unknown(context, e.range);
    }
    const TypeId dint = context.elementary(TypeKind::Dint);
    if (type.kind == TypeKind::Array) {
        // Of an ordinary array the bounds are known, and may be used in constants.
        const types::Dimension& bounds = type.dimensions[static_cast<size_t>(number - 1)];
        return constant(context, {dint, isUpper ? bounds.high : bounds.low}, e.range);
    }
    tree::Expr* out = context.arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Bound;
    out->type = dint;
    out->range = e.range;
    out->place = array;
    out->selector = number - 1;
    out->isUpper = isUpper;
    return {out, &context.types};
}

///   ok:    SIZEOF(a); SIZEOF(INT)      wrong: SIZEOF(a, b)  (P2011)
Operand sizeCall(Context& context, const syntax::Expr& e, TypeKind result) {
    if (e.arguments.size() != 1 || !e.arguments[0].value) {
        const Verbatim name("SIZEOF");
        context.emit(e.base->range, e.arguments.empty() ? findings::MissingArgument(Verbatim("IN"), name)
                                                        : findings::TooManyArguments(name, 1));
        return unknown(context, e.range);
    }
    const syntax::Expr& argument = *e.arguments[0].value;
    // A type, a variable, a constant, a block: all have a size. The argument is looked at as a name first, because INT
    // is no expression.
    TypeId type;
    if (argument.kind == syntax::ExprKind::NameRef || argument.kind == syntax::ExprKind::Member ||
        argument.kind == syntax::ExprKind::Index || argument.kind == syntax::ExprKind::Deref) {
        const Denoted denoted = denote(context, argument, Access::Read);
        if (denoted.kind == Denoted::Kind::Nothing) return unknown(context, e.range);
        if (denoted.kind == Denoted::Kind::Place)
            type = denoted.place->type;
        else if (denoted.kind == Denoted::Kind::Type)
            type = denoted.type;
        else if (denoted.kind == Denoted::Kind::Value)
            type = settled(context, denoted.value).type();
        else if (denoted.kind == Denoted::Kind::Unit && denoted.unit->type.isValid())
            type = denoted.unit->type;
        else if (const auto kind =
                     denoted.kind == Denoted::Kind::Standard ? elementaryNamed(denoted.name) : std::nullopt)
            type = context.elementary(*kind); // SIZEOF(TIME): TIME() is a function, too
    } else {
        const Operand value = settled(context, expression(context, argument));
        if (value.isUnknown()) return unknown(context, e.range);
        type = value.type();
    }
    if (!type.isValid()) {
        context.emit(argument.range, findings::NoValue(context.textOf(argument.range)));
        return unknown(context, e.range);
    }
    // A watch sees the finished program: its types are complete, and it must not complete any.
    if (!context.isExpression) completeType(context, type, argument.range);
    // Not the declared result: as a literal it takes whatever integer type is wanted beside it.
    (void)result;
    return constant(context, {context.elementary(TypeKind::Lint), int64_t(context.types[type].size)}, e.range, true);
}

/// ADR('text'), as programs for CODESYS give texts to functions that take addresses, and ADR of a constant without a
/// place: valid until the unit ends.
Operand addressOfLiteral(Context& context, const syntax::Expr& argument, SourceRange range) {
    std::vector<tree::Stmt*> before;
    tree::Place* place = placeOfArgument(context, argument, before);
    if (!place) return unknown(context, range);
    tree::Expr* sequence = newSequence(context, context.types.pointer(place->type), range);
    sequence->statements = std::move(before);
    sequence->a = addressOf(context, place, sequence->type, range).expr;
    return {sequence, &context.types};
}

/// What ADR may point to; null: nothing that is stored. Constants of programs and global ones are in the image beside
/// their value in the code, one of another unit is if the unit takes its address (layout/units.cpp). REF gives no way
/// to them: it is there to write through.
tree::Place* placeToAddress(Context& context, const Denoted& denoted, SourceRange range) {
    if (denoted.kind == Denoted::Kind::Place) return denoted.place;
    const Variable* constant = denoted.kind == Denoted::Kind::Value ? denoted.variable : nullptr;
    if (!constant) return nullptr;
    const bool isStored =
        !constant->owner || constant->owner->kind == UnitKind::Program || constant->storage == Storage::Absolute;
    return isStored ? absolutePlace(context, constant->offset, constant->type, constant->bit, range) : nullptr;
}

// REF is the standard's (edition 3, 6.4.4.10), ADR CODESYS's; both give a pointer to the variable.
Operand addressCall(Context& context, const syntax::Expr& e, bool isReference) {
    const library::Signature* signature = library::findSignature(isReference ? "REF" : "ADR");
    const StandardArguments arguments = standardArguments(context, *signature, e);
    if (!arguments.isGood) return unknown(context, e.range);
    if (context.isExpression) {
        context.emit(e.range, findings::NotAllowedInExpression(signature->name));
        return unknown(context, e.range);
    }
    const syntax::Expr& argument = *arguments.inputs[0]->value;
    const bool isInBody = context.function && !context.isInitialiser;
    if (!isReference && isInBody && argument.kind == syntax::ExprKind::Literal)
        return withEnable(context, addressOfLiteral(context, argument, e.range), arguments, e.range);
    const Denoted denoted = denote(context, argument, Access::Address);
    if (denoted.kind == Denoted::Kind::Nothing) return unknown(context, e.range);
    if (isReference && denoted.kind == Denoted::Kind::Value && denoted.variable && denoted.variable->isConstant) {
        context.emit(argument.range, findings::NotAssignable(phrases::ConstantVariable(denoted.variable->name)));
        return unknown(context, e.range);
    }
    tree::Place* const place = isReference ? denoted.place : placeToAddress(context, denoted, argument.range);
    // A value of an enumeration, a constant of another block: nothing of it is stored.
    if (!isReference && !place && isInBody && denoted.kind == Denoted::Kind::Value && denoted.value.isConstant())
        return withEnable(context, addressOfLiteral(context, argument, e.range), arguments, e.range);
    // ARRAY[*] is an address with bounds: its address alone would lose them.
    if (!place || context.isKind(place->type, TypeKind::OpenArray)) {
        context.emit(argument.range, findings::TemporaryReference());
        return unknown(context, e.range);
    }
    // In an initial value it is allowed: such values become code that runs before the first scan.
    if (!context.function && !context.isInitialiser && !context.isMuted) {
        context.emit(e.range, findings::NotConstant());
        return unknown(context, e.range);
    }
    return withEnable(context, addressOf(context, place, context.types.pointer(place->type), e.range), arguments,
                      e.range);
}

// ** and EXPT. The result's type follows table 24 as far as it says something: a real base keeps its type; two whole
// numbers stay whole unless a real is wanted, as in CODESYS.
Operand exptCall(Context& context, Operand base, Operand exponent, SourceRange range, SourceRange operatorRange,
                 TypeId hint) {
    if (isStrict(context, base) || isStrict(context, exponent)) return unknown(context, range);
    if (!isNumeric(context, base.type()) || !isNumeric(context, exponent.type())) {
        const Operand& wrong = isNumeric(context, base.type()) ? exponent : base;
        context.emit(isNumeric(context, base.type()) || isNumeric(context, exponent.type()) ? wrong.expr->range
                                                                                            : operatorRange,
                     findings::OperatorNotForType(Verbatim("**"), context.nameOf(wrong.type())));
        return unknown(context, range);
    }
    const bool realBase = context.types.family(base.type()) == Family::Real,
               realExponent = context.types.family(exponent.type()) == Family::Real;
    const bool wantsReal = hint.isValid() && context.types.family(hint) == Family::Real;
    if (!realBase && !realExponent && !wantsReal) {
        // 2 ** 20 of two literals is a literal again, so that it fits wherever the number fits.
        if (base.isFlexible && exponent.isFlexible && exponent.expr->value.integer() >= 0 &&
            exponent.expr->value.integer() < 64) {
            // Wide enough for one multiplication too many; after each it is asked whether the result still fits.
            __int128 result = 1;
            const int64_t factor = base.expr->value.integer();
            bool fitsIn = true;
            for (int64_t i = 0; i < exponent.expr->value.integer() && fitsIn; ++i) {
                result *= factor;
                fitsIn = result <= INT64_MAX && result >= INT64_MIN;
            }
            if (fitsIn)
                return constant(context, {context.elementary(TypeKind::Lint), static_cast<int64_t>(result)}, range,
                                true);
        }
        // A literal base takes the type that is wanted when it fits, else what it shares with the exponent; a variable
        // decides for itself.
        const TypeId type = base.isFlexible ? (hint.isValid() && types::isInteger(context.types.family(hint)) &&
                                                       fits(context, base.expr->value, hint)
                                                   ? context.types.storage(hint)
                                               : exponent.isFlexible ? smallestType(context, base)
                                                                     : commonType(context, base, exponent))
                                            : context.types.storage(base.type());
        base = base.isFlexible ? converted(context, base, type) : convertNode(context, base, type);
        exponent = exponent.isFlexible && fits(context, exponent.expr->value, type)
                       ? converted(context, exponent, type)
                       : convertNode(context, settled(context, exponent), type);
        if (base.isUnknown() || exponent.isUnknown()) return unknown(context, range);
        return intrinsic(context, library::Intrinsic::ExptInt, type, {base, exponent}, range);
    }
    TypeKind kind = TypeKind::Real;
    bool onlyFlexible = true;
    for (const Operand& o : {base, exponent}) {
        if (o.isFlexible) continue;
        onlyFlexible = false;
        if (context.types.storageKind(o.type()) == TypeKind::Lreal) kind = TypeKind::Lreal;
        // REAL has 24 bits of mantissa: a DINT would lose digits before the power is even taken.
        if (context.types.family(o.type()) != Family::Real && types::bitsOf(context.types.storageKind(o.type())) > 16 &&
            !realBase)
            kind = TypeKind::Lreal;
    }
    if (onlyFlexible) kind = TypeKind::Lreal;
    // Where only whole numbers are raised to a power for a REAL, the variable that gets it says how exact.
    if (wantsReal && (onlyFlexible || (!realBase && !realExponent))) kind = context.types.storageKind(hint);
    const TypeId type = context.elementary(kind);
    base = base.isFlexible ? converted(context, base, type) : convertNode(context, base, type);
    exponent = exponent.isFlexible ? converted(context, exponent, type) : convertNode(context, exponent, type);
    if (base.isUnknown() || exponent.isUnknown()) return unknown(context, range);
    return intrinsic(context, library::Intrinsic::Expt, type, {base, exponent}, range);
}

/// __QUERYINTERFACE(from, to): to becomes from's block seen through its interface, or null; gives whether it could.
///   ok:    __QUERYINTERFACE(i, j)      wrong: __QUERYINTERFACE(i)  (P2010)
Operand queryCall(Context& context, const syntax::Expr& e) {
    if (e.arguments.size() != 2 || !e.arguments[0].value || !e.arguments[1].value) {
        context.emit(e.base->range, findings::MissingArgument(Verbatim("TO"), context.textOf(e.base->range)));
        return unknown(context, e.range);
    }
    if (!context.function) {
        context.emit(e.range, context.isExpression ? findings::NotAllowedInExpression(context.textOf(e.base->range))
                                                   : findings::NotConstant());
        return unknown(context, e.range);
    }
    Operand from = expression(context, *e.arguments[0].value);
    const Denoted to = target(context, *e.arguments[1].value);
    if (from.isUnknown() || to.kind != Denoted::Kind::Place) return unknown(context, e.range);
    const TypeId wanted = to.place->type;
    // The target is an interface (__QUERYINTERFACE) or a pointer to a block (__QUERYPOINTER).
    if (!context.isKind(wanted, TypeKind::Interface) &&
        !(context.isKind(wanted, TypeKind::Pointer) &&
          context.isKind(context.types[wanted].element, TypeKind::Block))) {
        context.emit(e.arguments[1].value->range,
                     findings::OperatorNotForType(context.textOf(e.base->range), context.nameOf(wanted)));
        return unknown(context, e.range);
    }
    // A block itself may be asked as well; what is compared is the number at the start of the instance it refers to.
    if (context.isKind(from.type(), TypeKind::Block) && from.expr->place)
        from = addressOf(context, from.expr->place, context.types.pointer(from.type()), from.expr->range);
    if (!context.isKind(from.type(), TypeKind::Interface) && !context.isKind(from.type(), TypeKind::Pointer)) {
        context.emit(e.arguments[0].value->range,
                     findings::OperatorNotForType(context.textOf(e.base->range), context.nameOf(from.type())));
        return unknown(context, e.range);
    }
    tree::Expr* cast = context.arena.make<tree::Expr>();
    cast->kind = tree::ExprKind::TryCast;
    cast->type = wanted;
    cast->range = e.range;
    cast->a = from.expr;
    tree::Expr* sequence = newSequence(context, context.elementary(TypeKind::Bool), e.range);
    sequence->statements.push_back(assignStmt(context, to.place, cast, {}));
    // The result is read from the target and not from the cast, which is thus made once.
    sequence->a = inverted(context, isNull(context, load(context, to.place, e.range), e.range), e.range).expr;
    return {sequence, &context.types};
}

// Functions whose arguments are not values of a type: names of types, variables themselves, units. First those that
// read their arguments themselves.
Operand specialCall(Context& context, const library::Signature& signature, const syntax::Expr& e, TypeId hint) {
    const std::string_view name = signature.name;
    if (name == "LOWER_BOUND" || name == "UPPER_BOUND") return boundCall(context, e, name.front() == 'U');
    if (name == "SIZEOF" || name == "XSIZEOF") return sizeCall(context, e, signature.result);
    if (name == "ADR" || name == "REF") return addressCall(context, e, name == "REF");
    if (name == "__POUNAME" || name == "__POSITION") return placeText(context, e, name == "__POUNAME");
    if (name == "__VARINFO") return variableInfo(context, e);
    if (name == "__NEW") return newCall(context, e);
    if (name == "__DELETE") return deleteCall(context, e);
    if (name == "TEST_AND_SET") return testAndSet(context, e);
    if (name == "__QUERYINTERFACE" || name == "__QUERYPOINTER") return queryCall(context, e);
    const StandardArguments arguments = standardArguments(context, signature, e);
    if (!arguments.isGood) return unknown(context, e.range);
    const syntax::Expr& first = *arguments.inputs[0]->value;
    if (name == "EXPT") {
        const Operand base = expression(context, first, hint),
                      exponent = expression(context, *arguments.inputs[1]->value);
        if (base.isUnknown() || exponent.isUnknown()) return unknown(context, e.range);
        return withEnable(context, exptCall(context, base, exponent, e.range, e.base->range, hint), arguments, e.range);
    }
    if (name == "__ISVALIDREF") {
        const Denoted denoted = denote(context, first, Access::Read);
        if (denoted.kind == Denoted::Kind::Nothing) return unknown(context, e.range);
        if (denoted.kind == Denoted::Kind::Place && context.isKind(denoted.place->type, TypeKind::Unknown))
            // __ISVALIDREF asks a pointer, a reference, an interface or an in-out; each keeps its address in another
            // way, so each has its own question below.
            return unknown(context, e.range); // its type was reported
        if (denoted.kind == Denoted::Kind::Property || denoted.kind == Denoted::Kind::Value) {
            const Operand given = value(context, denoted, first, TypeId());
            if (given.isUnknown()) return given;
            for (const TypeKind kind : {TypeKind::Reference, TypeKind::Pointer, TypeKind::Interface})
                if (context.isKind(given.type(), kind))
                    return inverted(context, isNull(context, given, e.range), e.range);
        }
        if (denoted.kind == Denoted::Kind::Place && denoted.place->kind == tree::PlaceKind::Deref &&
            denoted.place->pointer)
            return inverted(context, isNull(context, {denoted.place->pointer, &context.types}, e.range), e.range);
        if (denoted.kind == Denoted::Kind::Place && (context.isKind(denoted.place->type, TypeKind::Pointer) ||
                                                     context.isKind(denoted.place->type, TypeKind::Interface)))
            return inverted(context, isNull(context, load(context, denoted.place, first.range), e.range), e.range);
        if (denoted.kind == Denoted::Kind::Place && denoted.variable && denoted.variable->isInOut())
            return inverted(context, isUnbound(context, *denoted.place, e.range), e.range);
        context.emit(first.range, findings::NotAPointer(context.textOf(first.range)));
        return unknown(context, e.range);
    }
    const Denoted denoted = denote(context, first, Access::Read);
    if (denoted.kind == Denoted::Kind::Nothing) return unknown(context, e.range);
    if (name == "BITADR") {
        // BITADR gives the number of the bit within its area, as the address was written; an address in memory would
        // mean nothing to a register map.
        const tree::Place* place = denoted.place;
        if (denoted.kind != Denoted::Kind::Place || place->kind != tree::PlaceKind::Absolute) {
            context.emit(first.range, findings::TemporaryReference());
            return unknown(context, e.range);
        }
        for (const image::Area area : {image::Area::Input, image::Area::Output, image::Area::Memory}) {
            const image::AreaRange range = areaOf(context.world, area);
            if (place->offset >= range.begin && place->offset < range.begin + range.size)
                return constant(context,
                                {context.elementary(TypeKind::Dword),
                                 int64_t(place->offset - range.begin) * 8 + std::max<int64_t>(0, place->bit)},
                                e.range);
        }
        context.emit(first.range, findings::TemporaryReference());
        return unknown(context, e.range);
    }
    if (name == "INDEXOF") {
        // INDEXOF of CODESYS: a number for a unit. Here it is that of its function, which only says whether two are the
        // same.
        if (denoted.kind != Denoted::Kind::Unit) {
            context.emit(first.range, findings::NotCallable(context.textOf(first.range)));
            return unknown(context, e.range);
        }
        return constant(context, {context.elementary(TypeKind::Dint), int64_t(denoted.unit->function.value)}, e.range);
    }
    return unknown(context, e.range);
}

} // namespace plc::sema
