// Expressions: values of names, constants, conditions.
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/literals.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

using lex::TokenKind;
using syntax::ExprKind;
using types::TypeTable;

static Operand durationExpression(Context& context, const syntax::Expr& e);
static Operand anyExpression(Context& context, const syntax::Expr& e, TypeId hint);

Context::Context(const Check& check, Scope theScope, diagnostics::Sink& theSink, Arena& theArena)
    : Check(check), types(check.gathered.types), scope(theScope), sink(theSink), arena(theArena) {}

// What was reported goes on as a node of type Unknown: it fits everywhere and nobody complains about it again.
Operand unknown(Context& context, SourceRange range) {
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->type = context.elementary(TypeKind::Unknown);
    e->range = range;
    return {e, &context.types};
}

Operand constant(Context& context, types::Value value, SourceRange range, bool isFlexible) {
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Constant;
    e->type = value.type;
    e->range = range;
    e->value = std::move(value);
    // Flexible: a literal without a type of its own; it takes that of what it meets (settled, converted).
    return {e, &context.types, isFlexible};
}

tree::Expr* newSequence(Context& context, TypeId type, SourceRange range) {
    tree::Expr* sequence = context.arena.make<tree::Expr>();
    sequence->kind = tree::ExprKind::Sequence;
    sequence->type = type;
    sequence->range = range;
    return sequence;
}

Operand load(Context& context, tree::Place* place, SourceRange range) {
    tree::Expr* e = context.arena.make<tree::Expr>();
    e->kind = tree::ExprKind::Load;
    e->type = place->type;
    e->range = range;
    e->place = place;
    return {e, &context.types};
}

bool isNumeric(const Context& context, TypeId type) {
    const types::Family family = context.types.family(type);
    return types::isInteger(family) || family == types::Family::Real;
}

void refer(Context& context, SourceRange range, SymbolId symbol, Access access) {
    if (context.isMuted || context.isExpression) return;
    // "Find writes" shows addresses too: whoever has one may write.
    const bool isWrite = access == Access::Write || access == Access::ReadWrite || access == Access::Address;
    refer(static_cast<const Check&>(context), range, symbol, access != Access::Write, isWrite);
}

TypeId textType(Context& context, size_t length, bool isWide) {
    if (context.isExpression) length = length <= 80 ? 80 : 255; // no new types once others may read the table
    const auto capacity = static_cast<uint32_t>(std::max<size_t>(1, length));
    return isWide ? context.types.wstring(capacity) : context.types.string(capacity);
}

// The end of being a literal: from here on it has a type.
Operand settled(Context& context, Operand operand, TypeId hint) {
    if (!operand.isFlexible) return operand;
    TypeId type = smallestType(context, operand);
    // Only when it fits; otherwise the conversion that follows gives the message, with the value.
    if (hint.isValid() && isNumeric(context, hint) && fits(context, operand.expr->value, hint)) type = hint;
    if (operand.expr->type == type) {
        operand.isFlexible = false;
        return operand;
    }
    return convertNode(context, operand, type);
}

///   wrong: x := F;  with a FUNCTION F that has parameters (P2023)
Operand value(Context& context, Denoted denoted, const syntax::Expr& e, TypeId hint) {
    switch (denoted.kind) {
    case Denoted::Kind::Nothing:
        return unknown(context, e.range);
    case Denoted::Kind::Value:
        return denoted.value;
    case Denoted::Kind::Place:
        return load(context, denoted.place, e.range);
    case Denoted::Kind::Property:
        return propertyValue(context, denoted, e.range);
    case Denoted::Kind::Unit: {
        Unit& unit = *denoted.unit;
        const bool callable = unit.kind == UnitKind::Function || unit.kind == UnitKind::Method;
        // CODESYS lets a method without parameters be read without parentheses.
        if (callable && unit.parameters.empty() && context.isExpression == false && unit.kind == UnitKind::Method) {
            syntax::Expr bare = e; // a method without parameters may be read like a property
            bare.arguments.clear();
            return callUnit(context, denoted, bare);
        }
        auto& diagnostic = context.emit(e.range, findings::NoValue(unit.name));
        if (callable) diagnostic.fixes.push_back({fixes::CallIt(), {{{e.range.file, e.range.end, e.range.end}, "()"}}});
        return unknown(context, e.range);
    }
    case Denoted::Kind::Type:
    case Denoted::Kind::List:
    case Denoted::Kind::Space:
    case Denoted::Kind::Standard:
        context.emit(e.range, findings::NoValue(context.textOf(e.range)));
        return unknown(context, e.range);
    }
    // Not needed here: a name was already looked up with it.
    (void)hint;
    return unknown(context, e.range);
}

/// The time of a chart's action or step.
///   ok:    lamp(L, T#5s); lamp(D, delay);      wrong: lamp(L, 5);  (P2003)
// Times of actions and steps come from the chart's own syntax, where a number would be taken for milliseconds by some.
Operand durationExpression(Context& context, const syntax::Expr& e) {
    const TypeId time = context.elementary(TypeKind::Time);
    Operand value = anyExpression(context, e, time);
    if (value.isUnknown() || context.types.family(value.type()) == types::Family::Duration) return value;
    mismatch(context, e.range, value.type(), time);
    return unknown(context, e.range);
}

Operand expression(Context& context, const syntax::Expr& e, TypeId hint) {
    return e.isDuration ? durationExpression(context, e) : anyExpression(context, e, hint);
}

Operand anyExpression(Context& context, const syntax::Expr& e, TypeId hint) {
    switch (e.kind) {
    case ExprKind::Error:
        return unknown(context, e.range);
    case ExprKind::Literal:
        return literal(context, e, hint);
    case ExprKind::TypedName:
        return typedName(context, e);
    case ExprKind::NameRef:
    case ExprKind::Address:
    case ExprKind::Member:
    case ExprKind::Bit:
    case ExprKind::Index:
    case ExprKind::Deref:
        return value(context, denote(context, e, Access::Read, hint), e, hint);
    case ExprKind::Call:
        return call(context, e, hint);
    case ExprKind::Unary:
        return unary(context, e, hint);
    case ExprKind::Binary:
        return binary(context, e, hint);
    case ExprKind::AssignChain: {
        if (!context.function) {
            context.emit(e.range, context.isExpression ? findings::NotAllowedInExpression(Verbatim(":="))
                                                       : findings::NotConstant());
            return unknown(context, e.range);
        }
        // b := c as a value: assign c to b, then read b
        // a := b := c of CODESYS; not in an initial value, where nothing can be assigned.
        const Denoted inner = target(context, *e.base);
        const TypeId type = inner.kind == Denoted::Kind::Place ? inner.place->type : hint;
        Operand value = expression(context, *e.right, type);
        tree::Expr* sequence = newSequence(context, type, e.range);
        assignTo(context, inner, value, e.range, sequence->statements, true);
        if (inner.kind != Denoted::Kind::Place) return value;
        sequence->a = load(context, inner.place, e.base->range).expr;
        return {sequence, &context.types};
    }
    case ExprKind::ArrayInit:
    case ExprKind::StructInit:
        return aggregate(context, e, hint);
    case ExprKind::Repeat:
        context.emit(e.range, findings::NotAllowedHere(context.textOf(e.range), phrases::InAnExpression()));
        return unknown(context, e.range);
    case ExprKind::This:
    case ExprKind::Super: {
        // THIS as a value is the pointer to the instance.
        const Denoted self = denote(context, e, Access::Address);
        if (self.kind != Denoted::Kind::Place) return unknown(context, e.range);
        if (self.place->type.isValid() &&
            (context.isKind(self.place->type, TypeKind::Block) || self.place->type == context.scope.structure))
            return addressOf(context, self.place,
                             context.isExpression ? context.elementary(TypeKind::Lword)
                                                  : context.types.pointer(self.place->type),
                             e.range);
        return load(context, self.place, e.range);
    }
    }
    return unknown(context, e.range);
}

/// [1, 2] and (a := 1) as a value: needs the type it is for, and constants inside.
/// A structured value in a body is a tree of all its elements, so it must not be as large as a variable may be.
bool fitsIntoCode(Context& context, TypeId type, SourceRange range) {
    if (!context.types.isAggregate(type) || context.types[type].size <= kMaximumConstantBytes) return true;
    context.emit(range, findings::ImageTooLarge(context.types[type].size, kMaximumConstantBytes));
    return false;
}

Operand aggregate(Context& context, const syntax::Expr& e, TypeId hint) {
    // Lists need the initialiser's machinery, which adds types.
    if (context.isExpression) {
        context.emit(e.range, findings::NotAllowedInExpression(context.textOf(e.range)));
        return unknown(context, e.range);
    }
    if (!hint.isValid() || !context.types.isAggregate(hint)) {
        if (!hint.isValid() || !context.isKind(hint, TypeKind::Unknown))
            context.emit(e.range, findings::NotAllowedHere(Verbatim(e.kind == ExprKind::ArrayInit ? "[…]" : "(… := …)"),
                                                           phrases::Here()));
        return unknown(context, e.range);
    }
    if (!fitsIntoCode(context, hint, e.range)) return unknown(context, e.range);
    InitialValue initial;
    initial.bytes = context.types[hint].initial;
    initial.bytes.resize(context.types[hint].size);
    initialise(context, initial, hint, 0, -1, &e, context.scope, nullptr);
    // As a value it has to be constant; the assignment of a list with variables is taken apart elsewhere.
    if (!initial.dynamics.empty()) {
        context.emit(e.range, findings::NotConstant());
        return unknown(context, e.range);
    }
    return constant(context, types::readValue(context.types, hint, initial.bytes), e.range);
}

///   ok:    IF x > 0 THEN      wrong: IF x THEN  with x : INT (P2022)
tree::Expr* condition(Context& context, const syntax::Expr& e) {
    Operand operand = expression(context, e, context.elementary(TypeKind::Bool));
    if (operand.isUnknown()) return operand.expr;
    if (context.isKind(operand.type(), TypeKind::Reference)) // of a call or a property
        operand = load(context, referredBy(context, operand, e.range), e.range);
    const TypeId boolean = context.elementary(TypeKind::Bool);
    if (context.types.storageKind(operand.type()) == TypeKind::Bool) return operand.expr;
    // WHILE 1 DO: accepted, 1 is TRUE.
    if (operand.isFlexible && std::holds_alternative<int64_t>(operand.expr->value.data) &&
        fits(context, operand.expr->value, boolean))
        return converted(context, operand, boolean).expr;
    if (context.isKind(operand.type(), TypeKind::Void))
        context.emit(e.range, findings::NoValue(context.textOf(e.range)));
    else {
        auto& diagnostic = context.emit(e.range, findings::ConditionNotBool(context.nameOf(operand.type())));
        if (isNumeric(context, operand.type()))
            diagnostic.fixes.push_back(
                {fixes::CompareWithZero(), {{{e.range.file, e.range.end, e.range.end}, " <> 0"}}});
    }
    return unknown(context, e.range).expr;
}

} // namespace plc::sema
