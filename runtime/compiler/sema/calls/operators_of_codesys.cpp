// Operators that CODESYS has beside the standard: __POUNAME, __POSITION, TEST_AND_SET, and names of enumerators.
#include "runtime/compiler/sema/calls/operators_of_codesys.h"

#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

namespace plc::sema {
namespace {

Operand textConstant(Context& context, TypeId type, const std::string& text, SourceRange range) {
    return constant(context, types::Value{type, text}, range);
}

/// "Motor.Start" of a method, as CODESYS writes it.
std::string nameOfUnit(const Context& context) {
    const Unit* unit = context.scope.unit;
    if (!unit) return {};
    return unit->owner ? unit->owner->name + "." + unit->name : unit->name;
}

} // namespace

///   ok:    s := __POUNAME();      wrong: s := __POUNAME(1);  (P2011)
Operand placeText(Context& context, const syntax::Expr& e, bool isUnit) {
    if (!e.arguments.empty()) {
        context.emit(e.arguments[0].range, findings::TooManyArguments(context.textOf(e.base->range), 0));
        return unknown(context, e.range);
    }
    const TypeId type = textType(context, 80, false);
    // An expression typed into a watch has no line.
    if (isUnit || !e.range.file.isValid()) return textConstant(context, type, nameOfUnit(context), e.range);
    const LineColumn place = context.world.sources[e.range.file].lineColumn(e.range.begin);
    return textConstant(context, type,
                        "Line " + std::to_string(place.line) + ", Column " + std::to_string(place.column), e.range);
}

/// Programs are not interrupted between two statements: reading and setting in one expression is enough.
///   ok:    IF NOT TEST_AND_SET(busy) THEN …      wrong: TEST_AND_SET(5)  (P2005)
Operand testAndSet(Context& context, const syntax::Expr& e) {
    if (e.arguments.size() != 1 || !e.arguments[0].value) {
        const Verbatim name("TEST_AND_SET");
        context.emit(e.base->range, e.arguments.empty() ? findings::MissingArgument(name, Verbatim("IN"))
                                                        : findings::TooManyArguments(name, 1));
        return unknown(context, e.range);
    }
    if (!context.function) {
        context.emit(e.range, context.isExpression ? findings::NotAllowedInExpression(context.textOf(e.base->range))
                                                   : findings::NotConstant());
        return unknown(context, e.range);
    }
    const syntax::Expr& argument = *e.arguments[0].value;
    const Denoted flag = target(context, argument);
    if (flag.kind != Denoted::Kind::Place) return unknown(context, e.range);
    const TypeId type = flag.place->type, boolean = context.elementary(TypeKind::Bool);
    // CODESYS has it for BOOL and for whole numbers, where any number but 0 counts as set.
    const types::Family family = context.types.family(type);
    if (family != types::Family::Bool && !types::isInteger(family)) {
        context.emit(argument.range, findings::OperatorNotForType(context.textOf(e.base->range), context.nameOf(type)));
        return unknown(context, e.range);
    }
    const bool isBool = family == types::Family::Bool;
    Operand before = load(context, flag.place, argument.range);
    if (!isBool) before = convertNode(context, before, boolean);
    tree::Place* was = localPlace(context, newLocal(context, "was", boolean), boolean, e.range);
    tree::Expr* sequence = newSequence(context, boolean, e.range);
    sequence->statements.push_back(assignStmt(context, was, before.expr, {}));
    sequence->statements.push_back(
        assignStmt(context, flag.place, constant(context, {type, int64_t(1)}, e.range).expr, {}));
    sequence->a = load(context, was, e.range).expr;
    return {sequence, &context.types};
}

// A CASE over the enumerators. Nothing: the type has no such attribute, or no function is there to hold the CASE; the
// caller then converts the number.
std::optional<Operand> nameOfValue(Context& context, const Operand& value, TypeId text, SourceRange range) {
    const auto known = context.world.enumsByType.find(value.type());
    if (known == context.world.enumsByType.end() || !known->second->isTextNamed || !context.types.isText(text))
        return std::nullopt;
    const std::vector<types::Enumerator>& enumerators = context.types[value.type()].enumerators;
    if (value.isConstant()) {
        for (const types::Enumerator& each : enumerators)
            if (each.value == value.expr->value.integer()) return textConstant(context, text, each.name, range);
        return std::nullopt;
    }
    if (!context.function) return std::nullopt;
    tree::Place* name = localPlace(context, newLocal(context, "name", text), text, range);
    tree::Stmt* choice = newStmt(context, tree::StmtKind::Case, {});
    tree::Place* kept = localPlace(context, newLocal(context, "value", value.type()), value.type(), range);
    const Operand selector = load(context, kept, range);
    choice->a = convertNode(context, selector, context.elementary(TypeKind::Lint)).expr;
    for (const types::Enumerator& each : enumerators) {
        tree::CaseArm arm;
        arm.ranges.push_back({each.value, each.value});
        arm.body.push_back(assignStmt(context, name, textConstant(context, text, each.name, range).expr, {}));
        choice->arms.push_back(std::move(arm));
    }
    // A variable of an enumeration can hold a number without a name (a cast, a register): its digits are shown.
    choice->elseBody.push_back(assignStmt(context, name, convertNode(context, selector, text).expr, {}));
    tree::Expr* sequence = newSequence(context, text, range);
    sequence->statements.push_back(assignStmt(context, kept, value.expr, {}));
    sequence->statements.push_back(choice);
    sequence->a = load(context, name, range).expr;
    return Operand{sequence, &context.types};
}

} // namespace plc::sema
