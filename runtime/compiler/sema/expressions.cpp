// Expressions: values of names, constants, conditions.
#include "runtime/compiler/sema/checker.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

using lex::TokenKind;
using syntax::ExprKind;
using types::TypeTable;

Checker::Checker(World& theWorld, Scope theScope, diagnostics::Sink& theSink, Arena& theArena)
    : world(theWorld), types(theWorld.types), scope(theScope), sink(theSink), arena(theArena) {}

Operand Checker::unknown(SourceRange range) {
    tree::Expr* e = arena.make<tree::Expr>();
    e->type = elementary(TypeKind::Unknown);
    e->range = range;
    return {e, &types};
}

Operand Checker::constant(types::Value value, SourceRange range, bool isFlexible) {
    tree::Expr* e = arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Constant;
    e->type = value.type;
    e->range = range;
    e->value = std::move(value);
    return {e, &types, isFlexible};
}

Operand Checker::load(tree::Place* place, SourceRange range) {
    tree::Expr* e = arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Load;
    e->type = place->type;
    e->range = range;
    e->place = place;
    return {e, &types};
}

bool Checker::isNumeric(TypeId type) const {
    const types::Family family = types.family(type);
    return types::isInteger(family) || family == types::Family::Real;
}

void Checker::refer(SourceRange range, SymbolId symbol, Access access) {
    if (isMuted || isExpression) return;
    const bool isWrite = access == Access::Write || access == Access::ReadWrite || access == Access::Address;
    world.refer(range, symbol, access != Access::Write, isWrite);
}

TypeId Checker::textType(size_t length, bool isWide) {
    if (world.frozen) length = length <= 80 ? 80 : 255; // no new types once others may read the table
    const auto capacity = static_cast<uint32_t>(std::max<size_t>(1, length));
    return isWide ? types.wstring(capacity) : types.string(capacity);
}

Operand Checker::settled(Operand operand, TypeId hint) {
    if (!operand.isFlexible) return operand;
    TypeId type = smallestType(operand);
    if (hint.isValid() && isNumeric(hint) && fits(operand.expr->value, hint)) type = hint;
    if (operand.expr->type == type) {
        operand.isFlexible = false;
        return operand;
    }
    return convertNode(operand, type);
}

///   wrong: x := F;  with a FUNCTION F that has parameters (P2023)
Operand Checker::value(Denoted denoted, const syntax::Expr& e, TypeId hint) {
    switch (denoted.kind) {
    case Denoted::Kind::Nothing:
        return unknown(e.range);
    case Denoted::Kind::Value:
        return denoted.value;
    case Denoted::Kind::Place:
        return load(denoted.place, e.range);
    case Denoted::Kind::Property:
        return propertyValue(denoted, e.range);
    case Denoted::Kind::Unit: {
        Unit& unit = *denoted.unit;
        const bool callable = unit.kind == UnitKind::Function || unit.kind == UnitKind::Method;
        if (callable && unit.parameters.empty() && isExpression == false && unit.kind == UnitKind::Method) {
            syntax::Expr bare = e; // a method without parameters may be read like a property
            bare.arguments.clear();
            return callUnit(denoted, bare);
        }
        auto& diagnostic = emit(e.range, findings::NoValue(unit.name));
        if (callable) diagnostic.fixes.push_back({fixes::CallIt(), {{{e.range.file, e.range.end, e.range.end}, "()"}}});
        return unknown(e.range);
    }
    case Denoted::Kind::Type:
    case Denoted::Kind::List:
    case Denoted::Kind::Space:
    case Denoted::Kind::Standard:
        emit(e.range, findings::NoValue(textOf(e.range)));
        return unknown(e.range);
    }
    (void)hint;
    return unknown(e.range);
}

/// The time of a chart's action or step.
///   ok:    lamp(L, T#5s); lamp(D, delay);      wrong: lamp(L, 5);  (P2003)
Operand Checker::durationExpression(const syntax::Expr& e) {
    const TypeId time = elementary(TypeKind::Time);
    Operand value = anyExpression(e, time);
    if (value.isUnknown() || types.family(value.type()) == types::Family::Duration) return value;
    mismatch(e.range, value.type(), time);
    return unknown(e.range);
}

Operand Checker::expression(const syntax::Expr& e, TypeId hint) {
    return e.isDuration ? durationExpression(e) : anyExpression(e, hint);
}

Operand Checker::anyExpression(const syntax::Expr& e, TypeId hint) {
    switch (e.kind) {
    case ExprKind::Error:
        return unknown(e.range);
    case ExprKind::Literal:
        return literal(e, hint);
    case ExprKind::TypedName:
        return typedName(e);
    case ExprKind::NameRef:
    case ExprKind::Address:
    case ExprKind::Member:
    case ExprKind::Bit:
    case ExprKind::Index:
    case ExprKind::Deref:
        return value(denote(e, Access::Read, hint), e, hint);
    case ExprKind::Call:
        return call(e, hint);
    case ExprKind::Unary:
        return unary(e, hint);
    case ExprKind::Binary:
        return binary(e, hint);
    case ExprKind::AssignChain: {
        if (!function) {
            emit(e.range, isExpression ? findings::NotAllowedInExpression(Verbatim(":=")) : findings::NotConstant());
            return unknown(e.range);
        }
        // b := c as a value: assign c to b, then read b
        const Denoted inner = target(*e.base);
        const TypeId type = inner.kind == Denoted::Kind::Place ? inner.place->type : hint;
        Operand value = expression(*e.right, type);
        tree::Expr* sequence = arena.make<tree::Expr>();
        sequence->kind = tree::ExprKind::Sequence;
        sequence->range = e.range;
        assignTo(inner, value, e.range, sequence->statements, true);
        if (inner.kind != Denoted::Kind::Place) return value;
        sequence->a = load(inner.place, e.base->range).expr;
        sequence->type = sequence->a->type;
        return {sequence, &types};
    }
    case ExprKind::ArrayInit:
    case ExprKind::StructInit:
        return aggregate(e, hint);
    case ExprKind::Repeat:
        emit(e.range, findings::NotAllowedHere(textOf(e.range), phrases::InAnExpression()));
        return unknown(e.range);
    case ExprKind::This:
    case ExprKind::Super: {
        const Denoted self = denote(e, Access::Address);
        if (self.kind != Denoted::Kind::Place) return unknown(e.range);
        if (self.place->type.isValid() && isKind(self.place->type, TypeKind::Block))
            return addressOf(self.place, world.frozen ? elementary(TypeKind::Lword) : types.pointer(self.place->type),
                             e.range);
        return load(self.place, e.range);
    }
    }
    return unknown(e.range);
}

/// [1, 2] and (a := 1) as a value: needs the type it is for, and constants inside.
/// A structured value in a body is a tree of all its elements, so it must not be as large as a variable may be.
bool Checker::fitsIntoCode(TypeId type, SourceRange range) {
    if (!types.isAggregate(type) || types[type].size <= kMaximumConstantBytes) return true;
    emit(range, findings::ImageTooLarge(types[type].size, kMaximumConstantBytes));
    return false;
}

Operand Checker::aggregate(const syntax::Expr& e, TypeId hint) {
    if (isExpression) {
        emit(e.range, findings::NotAllowedInExpression(textOf(e.range)));
        return unknown(e.range);
    }
    if (!hint.isValid() || !types.isAggregate(hint)) {
        if (!hint.isValid() || !isKind(hint, TypeKind::Unknown))
            emit(e.range, findings::NotAllowedHere(Verbatim(e.kind == ExprKind::ArrayInit ? "[…]" : "(… := …)"),
                                                   phrases::Here()));
        return unknown(e.range);
    }
    if (!fitsIntoCode(hint, e.range)) return unknown(e.range);
    InitialValue initial;
    initial.bytes = types[hint].initial;
    initial.bytes.resize(types[hint].size);
    world.initialise(initial, hint, 0, -1, &e, scope, nullptr);
    if (!initial.dynamics.empty()) {
        emit(e.range, findings::NotConstant());
        return unknown(e.range);
    }
    return constant(types::readValue(types, hint, initial.bytes), e.range);
}

///   ok:    IF x > 0 THEN      wrong: IF x THEN  with x : INT (P2022)
tree::Expr* Checker::condition(const syntax::Expr& e) {
    Operand operand = expression(e, elementary(TypeKind::Bool));
    if (operand.isUnknown()) return operand.expr;
    const TypeId boolean = elementary(TypeKind::Bool);
    if (types.storageKind(operand.type()) == TypeKind::Bool) return operand.expr;
    if (operand.isFlexible && std::holds_alternative<int64_t>(operand.expr->value.data) &&
        fits(operand.expr->value, boolean))
        return converted(operand, boolean).expr;
    if (isKind(operand.type(), TypeKind::Void))
        emit(e.range, findings::NoValue(textOf(e.range)));
    else {
        auto& diagnostic = emit(e.range, findings::ConditionNotBool(nameOf(operand.type())));
        if (isNumeric(operand.type()))
            diagnostic.fixes.push_back(
                {fixes::CompareWithZero(), {{{e.range.file, e.range.end, e.range.end}, " <> 0"}}});
    }
    return unknown(e.range).expr;
}

} // namespace plc::sema
