// Calls as statements: instances of blocks, programs, actions; functions whose result nobody takes.
#include "runtime/compiler/sema/calls/call_statements.h"

#include "runtime/compiler/sema/calls/any_inputs.h"
#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/standard_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

namespace plc::sema {

using syntax::ArgumentKind;
using syntax::SectionKind;

static void instanceCall(Context& context, tree::Place* instance, Unit& unit, const syntax::Expr& e,
                         const Denoted& callee, std::vector<tree::Stmt*>& out, SourceRange range);

namespace {
/// The place begins in the frame of this call, so a reference to it must not outlive it.
bool isInFrame(const tree::Place& place, const tree::Function& function) {
    const tree::Place* root = &place;
    while (root->base) root = root->base;
    return root->kind == tree::PlaceKind::Local && root->local < function.locals.size();
}
} // namespace

/// A call as a statement: an instance, an action, a function for its effects.
///   ok:    t(IN := TRUE); SetUp();      wrong: x();  with x : INT (P2008)
///   advice: SIN(r);  (P2033)
void callStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.value) return;
    const syntax::Expr& e = *stmt.value;
    if (e.kind != syntax::ExprKind::Call) {
        if (e.kind == syntax::ExprKind::Error) return;
        if (e.kind == syntax::ExprKind::NameRef || e.kind == syntax::ExprKind::Member ||
            e.kind == syntax::ExprKind::Index || e.kind == syntax::ExprKind::Deref) {
            const Denoted denoted = denote(context, e, Access::Call);
            if (denoted.kind == Denoted::Kind::Nothing || hasSyntaxErrorAt(context.world, stmt.range)) return;
            const bool callable =
                denoted.kind == Denoted::Kind::Unit || denoted.kind == Denoted::Kind::Standard ||
                (denoted.kind == Denoted::Kind::Place && context.isKind(denoted.place->type, TypeKind::Block));
            auto& diagnostic = context.emit(e.range, callable ? findings::Expected(Verbatim("()"), Verbatim(";"))
                                                              : findings::NotCallable(context.textOf(e.range)));
            if (callable)
                diagnostic.fixes.push_back({fixes::CallIt(), {{{e.range.file, e.range.end, e.range.end}, "()"}}});
            return;
        }
        const size_t errors = context.sink.all().size();
        const Operand value = expression(context, e);
        if (!value.isUnknown() && context.sink.all().size() == errors)
            context.emit(e.range, findings::NotCallable(context.textOf(e.range)));
        return;
    }
    const Denoted callee = denote(context, *e.base, Access::Call);
    if (callee.kind == Denoted::Kind::Place && context.isKind(callee.place->type, TypeKind::Block)) {
        Unit* unit = context.world.unitOf(callee.place->type);
        if (unit) instanceCall(context, callee.place, *unit, e, callee, out, stmt.range);
        return;
    }
    if (callee.kind == Denoted::Kind::Unit && callee.unit->kind == UnitKind::Program) {
        Unit& unit = *callee.unit;
        if (!unit.instance) {
            context.emit(e.base->range, findings::NotCallable(phrases::NoSingleInstance(unit.name)));
            return;
        }
        Denoted exact = callee;
        exact.isExact = true;
        instanceCall(context, absolutePlace(context, unit.instance->offset, unit.type, -1, e.base->range), unit, e,
                     exact, out, stmt.range);
        return;
    }
    Operand value;
    if (callee.kind == Denoted::Kind::Unit && callee.unit->kind == UnitKind::Action) {
        tree::Expr* made = context.arena.make<tree::Expr>();
        made->kind = tree::ExprKind::Call;
        made->type = context.elementary(TypeKind::Void);
        made->range = e.range;
        made->call = context.arena.make<tree::Call>();
        prepareCall(context, *made->call, callee, e.range);
        if (!e.arguments.empty())
            context.emit(e.arguments.front().range, findings::TooManyArguments(callee.unit->name, 0));
        value = {made, &context.types};
    } else if (callee.kind == Denoted::Kind::Unit &&
               (callee.unit->kind == UnitKind::Function || callee.unit->kind == UnitKind::Method)) {
        value = callUnit(context, callee, e);
        if (value.expr && !value.isUnknown() && !context.isKind(value.type(), TypeKind::Void) &&
            callee.unit->kind == UnitKind::Function)
            context.emit(e.base->range, findings::FunctionResultIgnored(callee.unit->name));
    } else if (callee.kind == Denoted::Kind::Standard) {
        value = settled(context, standardCall(context, callee.name, e, {}));
        if (!value.isUnknown() && value.expr->kind != tree::ExprKind::Sequence && !value.expr->ok)
            context.emit(e.base->range, findings::FunctionResultIgnored(callee.name));
    } else if (callee.kind == Denoted::Kind::Nothing) {
        return checkArguments(context, e);
    } else {
        const bool isType = callee.kind == Denoted::Kind::Unit || callee.kind == Denoted::Kind::Type;
        const std::string name = context.textOf(e.base->range);
        context.emit(e.base->range,
                     isType ? findings::NotCallable(phrases::TypeNotInstance(name)) : findings::NotCallable(name));
        return;
    }
    if (value.isUnknown() && value.expr->kind != tree::ExprKind::Call) return;
    tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, stmt.range);
    evaluate->a = value.expr;
    out.push_back(evaluate);
}

/// inst(in := a, io := b, out => c): a Block of assignments, bindings, the call of the body, and assignments from the
/// outputs.
///   wrong: b();  for VAR_IN_OUT x (P2010); b();  of FUNCTION_BLOCK ABSTRACT B (P2025)
void instanceCall(Context& context, tree::Place* instance, Unit& unit, const syntax::Expr& e, const Denoted& callee,
                  std::vector<tree::Stmt*>& out, SourceRange range) {
    completeUnit(context.world, unit, e.range);
    if (unit.isAbstract && callee.isExact) context.emit(e.base->range, findings::AbstractInstance(unit.name));
    const Matched matched = match(context, e, unit.name, unit.parameters);
    if (!matched.isGood) {
        for (const Match& each : matched.matches)
            if (each.argument && each.argument->value) {
                if (each.argument->kind == ArgumentKind::Output)
                    denote(context, *each.argument->value, Access::Write);
                else
                    expression(context, *each.argument->value, typeOf(context.world, *each.parameter));
            }
        return;
    }
    tree::Stmt* block = newStmt(context, tree::StmtKind::Block, range);
    std::vector<tree::Stmt*> before, after, outputs;
    for (const Match& each : matched.matches) {
        Variable& parameter = *each.parameter;
        const TypeId type = typeOf(context.world, parameter);
        const syntax::Argument* argument = each.argument;
        tree::Place* field = nullptr;
        if (parameter.storage == Storage::Absolute)
            field = absolutePlace(context, parameter.offset, type, parameter.bit, {});
        else if (parameter.isInOut()) {
            field = context.arena.make<tree::Place>();
            field->kind = tree::PlaceKind::InOutSlot;
            field->type = type;
            field->base = instance;
            field->offset = parameter.offset;
            field->range = e.range;
        } else {
            field = fieldPlace(context, instance, parameter.offset, type, -1,
                               argument && argument->value ? argument->value->range : e.range);
        }
        if (parameter.isInOut()) {
            if (!argument || !argument->value) {
                context.emit(e.base->range, findings::MissingArgument(parameter.name, unit.name));
                continue;
            }
            tree::Place* target = inOutTarget(context, parameter, *argument, before, after);
            if (!target) continue;
            tree::Stmt* bind = newStmt(context, tree::StmtKind::Bind, {});
            bind->place = field;
            bind->target = target;
            before.push_back(bind);
            if (context.function && isInFrame(*target, *context.function)) {
                tree::Stmt* unbind = newStmt(context, tree::StmtKind::Bind, {});
                unbind->place = field;
                after.push_back(unbind);
            }
            continue;
        }
        if (!argument || !argument->value) continue; // keeps its last value
        if (parameter.kind == SectionKind::Output) {
            const Denoted target = sema::target(context, *argument->value);
            if (target.kind == Denoted::Kind::Nothing) continue;
            Operand value = load(context, field, argument->value->range);
            if (argument->negated) value = inverted(context, value, argument->value->range);
            assignTo(context, target, value, {}, outputs, true);
            continue;
        }
        if (context.isKind(type, TypeKind::Reference)) {
            bindReference(context, field, *argument->value, {}, before);
            continue;
        }
        if (context.types.isAggregate(type) && (argument->value->kind == syntax::ExprKind::ArrayInit ||
                                                argument->value->kind == syntax::ExprKind::StructInit)) {
            assignAggregate(context, field, *argument->value, {}, before);
            continue;
        }
        Operand value = isAnyInput(context.world, parameter)
                            ? anyArgument(context, parameter, *argument->value)
                            : converted(context, expression(context, *argument->value, type), type);
        if (argument->negated) value = inverted(context, value, argument->value->range);
        if (!value.isUnknown()) before.push_back(assignStmt(context, field, value.expr, {}));
    }
    tree::Expr* made = context.arena.make<tree::Expr>();
    made->kind = tree::ExprKind::Call;
    made->type = context.elementary(TypeKind::Void);
    made->range = e.range;
    made->call = context.arena.make<tree::Call>();
    Denoted body = callee;
    body.kind = Denoted::Kind::Unit;
    body.unit = &unit;
    body.instance = instance;
    body.interface = nullptr;
    prepareCall(context, *made->call, body, e.range);
    tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, range);
    evaluate->a = made;
    block->body = std::move(before);
    block->body.push_back(evaluate);
    block->body.insert(block->body.end(), outputs.begin(), outputs.end());
    block->body.insert(block->body.end(), after.begin(), after.end());
    if (!matched.en && !matched.eno) {
        out.push_back(block);
        return;
    }
    const TypeId boolean = context.elementary(TypeKind::Bool);
    tree::Place* eno = nullptr;
    if (matched.eno && matched.eno->value) {
        const Denoted denoted = target(context, *matched.eno->value);
        if (denoted.kind == Denoted::Kind::Place && context.types.storageKind(denoted.place->type) == TypeKind::Bool)
            eno = denoted.place;
    }
    tree::Expr* en = matched.en && matched.en->value ? condition(context, *matched.en->value)
                                                     : constant(context, {boolean, int64_t(1)}, e.range).expr;
    tree::Stmt* choice = newStmt(context, tree::StmtKind::If, range);
    choice->a = en;
    choice->body.push_back(block);
    if (eno) {
        choice->body.push_back(assignStmt(context, eno, constant(context, {boolean, int64_t(1)}, e.range).expr, {}));
        choice->elseBody.push_back(
            assignStmt(context, eno, constant(context, {boolean, int64_t(0)}, e.range).expr, {}));
    }
    out.push_back(choice);
}

} // namespace plc::sema
