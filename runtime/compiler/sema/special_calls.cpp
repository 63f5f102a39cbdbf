// Standard functions with rules of their own: bounds, sizes, addresses, powers, queries of interfaces.
#include "runtime/compiler/sema/checker.h"

#include "runtime/base/text.h"

namespace plc::sema {

using types::Family;

///   ok:    p := REF(w);      wrong: p := REF(w.3);  (P2037)
Operand Checker::addressOf(tree::Place* place, TypeId pointer, SourceRange range) {
    if (!hasAddress(place)) {
        emit(range, findings::TemporaryReference());
        return unknown(range);
    }
    takeAddress(place);
    tree::Expr* e = arena.make<tree::Expr>();
    e->kind = tree::ExprKind::AddressOf;
    e->type = pointer;
    e->range = range;
    e->place = place;
    return {e, &types};
}

Operand Checker::isNull(Operand pointer, SourceRange range) {
    tree::Expr* e = arena.make<tree::Expr>();
    e->kind = tree::ExprKind::IsNull;
    e->type = elementary(TypeKind::Bool);
    e->range = range;
    e->a = pointer.expr;
    return {e, &types};
}

/// LOWER_BOUND and UPPER_BOUND of ARRAY[*] .
///   ok:    UPPER_BOUND(a, 1)      wrong: UPPER_BOUND(x, 1)  with x : INT (P2014)   UPPER_BOUND(a, 3)  of two (P2016)
Operand Checker::boundCall(const syntax::Expr& e, bool isUpper) {
    const library::Signature* signature = library::findSignature(isUpper ? "UPPER_BOUND" : "LOWER_BOUND");
    const StandardArguments arguments = standardArguments(*signature, e);
    if (!arguments.isGood) return unknown(e.range);
    tree::Place* array = place(*arguments.inputs[0]->value, Access::Read);
    const Operand dimension = expression(*arguments.inputs[1]->value);
    if (!array || dimension.isUnknown()) return unknown(e.range);
    const types::Type& type = types[array->type];
    if (type.kind == TypeKind::Unknown) return unknown(e.range);
    if (type.kind != TypeKind::Array && type.kind != TypeKind::OpenArray) {
        emit(arguments.inputs[0]->value->range, findings::NotAnArray(textOf(arguments.inputs[0]->value->range)));
        return unknown(e.range);
    }
    if (!dimension.isConstant() || !std::holds_alternative<int64_t>(dimension.expr->value.data)) {
        emit(arguments.inputs[1]->value->range, findings::NotConstant());
        return unknown(e.range);
    }
    const int64_t number = dimension.expr->value.integer();
    if (number < 1 || number > static_cast<int64_t>(type.dimensions.size())) {
        emit(arguments.inputs[1]->value->range, findings::ConstantIndexOutOfRange(number, 1, type.dimensions.size()));
        return unknown(e.range);
    }
    const TypeId dint = elementary(TypeKind::Dint);
    if (type.kind == TypeKind::Array) {
        const types::Dimension& bounds = type.dimensions[static_cast<size_t>(number - 1)];
        return constant({dint, isUpper ? bounds.high : bounds.low}, e.range);
    }
    tree::Expr* out = arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Bound;
    out->type = dint;
    out->range = e.range;
    out->place = array;
    out->selector = number - 1;
    out->isUpper = isUpper;
    return {out, &types};
}

///   ok:    SIZEOF(a); SIZEOF(INT)      wrong: SIZEOF(a, b)  (P2011)
Operand Checker::sizeCall(const syntax::Expr& e, TypeKind result) {
    if (e.arguments.size() != 1 || !e.arguments[0].value) {
        const Verbatim name("SIZEOF");
        emit(e.base->range, e.arguments.empty() ? findings::MissingArgument(Verbatim("IN"), name)
                                                : findings::TooManyArguments(name, 1));
        return unknown(e.range);
    }
    const syntax::Expr& argument = *e.arguments[0].value;
    TypeId type;
    if (argument.kind == syntax::ExprKind::NameRef || argument.kind == syntax::ExprKind::Member ||
        argument.kind == syntax::ExprKind::Index || argument.kind == syntax::ExprKind::Deref) {
        const Denoted denoted = denote(argument, Access::Read);
        if (denoted.kind == Denoted::Kind::Nothing) return unknown(e.range);
        if (denoted.kind == Denoted::Kind::Place)
            type = denoted.place->type;
        else if (denoted.kind == Denoted::Kind::Type)
            type = denoted.type;
        else if (denoted.kind == Denoted::Kind::Value)
            type = settled(denoted.value).type();
        else if (denoted.kind == Denoted::Kind::Unit && denoted.unit->type.isValid())
            type = denoted.unit->type;
    } else {
        const Operand value = settled(expression(argument));
        if (value.isUnknown()) return unknown(e.range);
        type = value.type();
    }
    if (!type.isValid()) {
        emit(argument.range, findings::NoValue(textOf(argument.range)));
        return unknown(e.range);
    }
    if (!world.frozen) world.completeType(type, argument.range);
    (void)result;
    return constant({elementary(TypeKind::Lint), int64_t(types[type].size)}, e.range, true);
}

Operand Checker::addressCall(const syntax::Expr& e, bool isReference) {
    const library::Signature* signature = library::findSignature(isReference ? "REF" : "ADR");
    const StandardArguments arguments = standardArguments(*signature, e);
    if (!arguments.isGood) return unknown(e.range);
    if (isExpression) {
        emit(e.range, findings::NotAllowedInExpression(signature->name));
        return unknown(e.range);
    }
    const syntax::Expr& argument = *arguments.inputs[0]->value;
    const Denoted denoted = denote(argument, Access::Address);
    if (denoted.kind == Denoted::Kind::Nothing) return unknown(e.range);
    if (denoted.kind != Denoted::Kind::Place) {
        emit(argument.range, findings::TemporaryReference());
        return unknown(e.range);
    }
    if (isKind(denoted.place->type, TypeKind::OpenArray)) {
        emit(argument.range, findings::TemporaryReference());
        return unknown(e.range);
    }
    if (!function && !isInitialiser && !isMuted) {
        emit(e.range, findings::NotConstant());
        return unknown(e.range);
    }
    return withEnable(addressOf(denoted.place, types.pointer(denoted.place->type), e.range), arguments, e.range);
}

Operand Checker::exptCall(Operand base, Operand exponent, SourceRange range, SourceRange operatorRange, TypeId hint) {
    if (isStrict(base) || isStrict(exponent)) return unknown(range);
    if (!isNumeric(base.type()) || !isNumeric(exponent.type())) {
        const Operand& wrong = isNumeric(base.type()) ? exponent : base;
        emit(isNumeric(base.type()) || isNumeric(exponent.type()) ? wrong.expr->range : operatorRange,
             findings::OperatorNotForType(Verbatim("**"), nameOf(wrong.type())));
        return unknown(range);
    }
    const bool realBase = types.family(base.type()) == Family::Real,
               realExponent = types.family(exponent.type()) == Family::Real;
    const bool wantsReal = hint.isValid() && types.family(hint) == Family::Real;
    if (!realBase && !realExponent && !wantsReal) {
        if (base.isFlexible && exponent.isFlexible && exponent.expr->value.integer() >= 0 &&
            exponent.expr->value.integer() < 64) {
            __int128 result = 1;
            const int64_t factor = base.expr->value.integer();
            bool fitsIn = true;
            for (int64_t i = 0; i < exponent.expr->value.integer() && fitsIn; ++i) {
                result *= factor;
                fitsIn = result <= INT64_MAX && result >= INT64_MIN;
            }
            if (fitsIn) return constant({elementary(TypeKind::Lint), static_cast<int64_t>(result)}, range, true);
        }
        const TypeId type =
            base.isFlexible ? (hint.isValid() && types::isInteger(types.family(hint)) && fits(base.expr->value, hint)
                                   ? types.storage(hint)
                               : exponent.isFlexible ? smallestType(base)
                                                     : commonType(base, exponent))
                            : types.storage(base.type());
        base = base.isFlexible ? converted(base, type) : convertNode(base, type);
        exponent = exponent.isFlexible && fits(exponent.expr->value, type) ? converted(exponent, type)
                                                                           : convertNode(settled(exponent), type);
        if (base.isUnknown() || exponent.isUnknown()) return unknown(range);
        return intrinsic(library::Intrinsic::ExptInt, type, {base, exponent}, range);
    }
    TypeKind kind = TypeKind::Real;
    bool onlyFlexible = true;
    for (const Operand& o : {base, exponent}) {
        if (o.isFlexible) continue;
        onlyFlexible = false;
        if (types.storageKind(o.type()) == TypeKind::Lreal) kind = TypeKind::Lreal;
        if (types.family(o.type()) != Family::Real && types::bitsOf(types.storageKind(o.type())) > 16 && !realBase)
            kind = TypeKind::Lreal;
    }
    if (onlyFlexible) kind = TypeKind::Lreal;
    if (wantsReal && (onlyFlexible || (!realBase && !realExponent))) kind = types.storageKind(hint);
    const TypeId type = elementary(kind);
    base = base.isFlexible ? converted(base, type) : convertNode(base, type);
    exponent = exponent.isFlexible ? converted(exponent, type) : convertNode(exponent, type);
    if (base.isUnknown() || exponent.isUnknown()) return unknown(range);
    return intrinsic(library::Intrinsic::Expt, type, {base, exponent}, range);
}

/// __QUERYINTERFACE(from, to): to becomes from's block seen through its interface, or null; gives whether it could.
///   ok:    __QUERYINTERFACE(i, j)      wrong: __QUERYINTERFACE(i)  (P2010)
Operand Checker::queryCall(const syntax::Expr& e) {
    if (e.arguments.size() != 2 || !e.arguments[0].value || !e.arguments[1].value) {
        emit(e.base->range, findings::MissingArgument(Verbatim("TO"), textOf(e.base->range)));
        return unknown(e.range);
    }
    if (!function) {
        emit(e.range, isExpression ? findings::NotAllowedInExpression(textOf(e.base->range)) : findings::NotConstant());
        return unknown(e.range);
    }
    Operand from = expression(*e.arguments[0].value);
    const Denoted to = target(*e.arguments[1].value);
    if (from.isUnknown() || to.kind != Denoted::Kind::Place) return unknown(e.range);
    const TypeId wanted = to.place->type;
    if (!isKind(wanted, TypeKind::Interface) &&
        !(isKind(wanted, TypeKind::Pointer) && isKind(types[wanted].element, TypeKind::Block))) {
        emit(e.arguments[1].value->range, findings::OperatorNotForType(textOf(e.base->range), nameOf(wanted)));
        return unknown(e.range);
    }
    if (isKind(from.type(), TypeKind::Block) && from.expr->place)
        from = addressOf(from.expr->place, types.pointer(from.type()), from.expr->range);
    if (!isKind(from.type(), TypeKind::Interface) && !isKind(from.type(), TypeKind::Pointer)) {
        emit(e.arguments[0].value->range, findings::OperatorNotForType(textOf(e.base->range), nameOf(from.type())));
        return unknown(e.range);
    }
    tree::Expr* cast = arena.make<tree::Expr>();
    cast->kind = tree::ExprKind::TryCast;
    cast->type = wanted;
    cast->range = e.range;
    cast->a = from.expr;
    tree::Expr* sequence = arena.make<tree::Expr>();
    sequence->kind = tree::ExprKind::Sequence;
    sequence->type = elementary(TypeKind::Bool);
    sequence->range = e.range;
    sequence->statements.push_back(assignStmt(to.place, cast, {}));
    sequence->a = inverted(isNull(load(to.place, e.range), e.range), e.range).expr;
    return {sequence, &types};
}

Operand Checker::specialCall(const library::Signature& signature, const syntax::Expr& e, TypeId hint) {
    const std::string_view name = signature.name;
    if (name == "LOWER_BOUND" || name == "UPPER_BOUND") return boundCall(e, name.front() == 'U');
    if (name == "SIZEOF" || name == "XSIZEOF") return sizeCall(e, signature.result);
    if (name == "ADR" || name == "REF") return addressCall(e, name == "REF");
    if (name == "__QUERYINTERFACE" || name == "__QUERYPOINTER") return queryCall(e);
    const StandardArguments arguments = standardArguments(signature, e);
    if (!arguments.isGood) return unknown(e.range);
    const syntax::Expr& first = *arguments.inputs[0]->value;
    if (name == "EXPT") {
        const Operand base = expression(first, hint), exponent = expression(*arguments.inputs[1]->value);
        if (base.isUnknown() || exponent.isUnknown()) return unknown(e.range);
        return withEnable(exptCall(base, exponent, e.range, e.base->range, hint), arguments, e.range);
    }
    if (name == "__ISVALIDREF") {
        const Denoted denoted = denote(first, Access::Read);
        if (denoted.kind == Denoted::Kind::Nothing) return unknown(e.range);
        if (denoted.kind == Denoted::Kind::Place && denoted.place->kind == tree::PlaceKind::Deref &&
            denoted.place->pointer)
            return inverted(isNull({denoted.place->pointer, &types}, e.range), e.range);
        if (denoted.kind == Denoted::Kind::Place &&
            (isKind(denoted.place->type, TypeKind::Pointer) || isKind(denoted.place->type, TypeKind::Interface)))
            return inverted(isNull(load(denoted.place, first.range), e.range), e.range);
        emit(first.range, findings::NotAPointer(textOf(first.range)));
        return unknown(e.range);
    }
    const Denoted denoted = denote(first, Access::Read);
    if (denoted.kind == Denoted::Kind::Nothing) return unknown(e.range);
    if (name == "BITADR") {
        const tree::Place* place = denoted.place;
        if (denoted.kind != Denoted::Kind::Place || place->kind != tree::PlaceKind::Absolute) {
            emit(first.range, findings::TemporaryReference());
            return unknown(e.range);
        }
        for (const image::Area area : {image::Area::Input, image::Area::Output, image::Area::Memory}) {
            const image::AreaRange range = world.areaOf(area);
            if (place->offset >= range.begin && place->offset < range.begin + range.size)
                return constant({elementary(TypeKind::Dword),
                                 int64_t(place->offset - range.begin) * 8 + std::max<int64_t>(0, place->bit)},
                                e.range);
        }
        emit(first.range, findings::TemporaryReference());
        return unknown(e.range);
    }
    if (name == "INDEXOF") {
        if (denoted.kind != Denoted::Kind::Unit) {
            emit(first.range, findings::NotCallable(textOf(first.range)));
            return unknown(e.range);
        }
        return constant({elementary(TypeKind::Dint), int64_t(denoted.unit->function.value)}, e.range);
    }
    return unknown(e.range);
}

} // namespace plc::sema
