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
// The root decides: an element of a field of a local is in the frame as well.
/// The place begins in the frame of this call, so a reference to it must not outlive it.
bool isInFrame(const tree::Place& place, const tree::Function& function) {
    const tree::Place* root = &place;
    while (root->base) root = root->base;
    return root->kind == tree::PlaceKind::Local && root->local < function.locals.size();
}

bool isAction(const Denoted& denoted) {
    return denoted.kind == Denoted::Kind::Unit && denoted.unit->kind == UnitKind::Action;
}

void evaluateAction(Context& context, const Denoted& action, SourceRange call, SourceRange statement,
                    std::vector<tree::Stmt*>& out) {
    tree::Expr* made = context.arena.make<tree::Expr>();
    made->kind = tree::ExprKind::Call;
    made->type = context.elementary(TypeKind::Void);
    made->range = call;
    made->call = context.arena.make<tree::Call>();
    prepareCall(context, *made->call, action, call);
    tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, statement);
    evaluate->a = made;
    out.push_back(evaluate);
}

bool isProgram(const Denoted& denoted) {
    return denoted.kind == Denoted::Kind::Unit && denoted.unit->kind == UnitKind::Program;
}

/// A program may be called by its name while it has one instance (CODESYS does so); with two nobody knows which one.
void callProgram(Context& context, const Denoted& callee, const syntax::Expr& call, SourceRange statement,
                 std::vector<tree::Stmt*>& out) {
    Unit& unit = *callee.unit;
    const SourceRange name = call.base->range;
    if (!unit.instance) {
        context.emit(name, findings::NotCallable(phrases::NoSingleInstance(unit.name)));
        return;
    }
    Denoted exact = callee;
    // It is the program's own variable: the call needs no dispatch.
    exact.isExact = true;
    instanceCall(context, absolutePlace(context, unit.instance->offset, unit.type, -1, name), unit, call, exact, out,
                 statement);
}

/// `x;` and `a = b;`: TwinCAT and CODESYS read the value, a property's accessor included, and drop it.
void valueAlone(Context& context, const syntax::Expr& e, SourceRange statement, std::vector<tree::Stmt*>& out) {
    const size_t errors = context.sink.all().size();
    const Operand value = settled(context, expression(context, e));
    if (value.isUnknown()) return;
    // The expression may have said what is odd about it already.
    if (context.sink.all().size() == errors)
        context.emit(e.range, findings::FunctionResultIgnored(context.textOf(e.range)));
    if (value.expr->kind != tree::ExprKind::Call && value.expr->kind != tree::ExprKind::Sequence) return;
    tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, statement);
    evaluate->a = value.expr;
    out.push_back(evaluate);
}

} // namespace

/// A call as a statement: an instance, an action, a function for its effects.
///   ok:    t(IN := TRUE); SetUp(); SetUp;      wrong: x();  with x : INT (P2008)
///   advice: SIN(r);  (P2033)                   advice: x;  (P2033)
void callStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.value) return;
    const syntax::Expr& e = *stmt.value;
    // Without parentheses it is a call of an action or a program, as CODESYS 2.3 writes them. "Compute;" of a function
    // or a block comes from other languages and is an error, since nobody would see that it does nothing.
    if (e.kind != syntax::ExprKind::Call) {
        if (e.kind == syntax::ExprKind::Error) return;
        if (e.kind == syntax::ExprKind::NameRef || e.kind == syntax::ExprKind::Member ||
            e.kind == syntax::ExprKind::Index || e.kind == syntax::ExprKind::Deref) {
            const Denoted denoted = denote(context, e, Access::Call);
            // A half-typed statement has been reported by the parser; a second message at the same place would only be
            // noise.
            if (denoted.kind == Denoted::Kind::Nothing || hasSyntaxErrorAt(context.world, stmt.range)) return;
            if (isAction(denoted)) return evaluateAction(context, denoted, e.range, stmt.range, out);
            if (isProgram(denoted)) {
                syntax::Expr call;
                call.kind = syntax::ExprKind::Call;
                call.range = e.range;
                call.base = stmt.value;
                return callProgram(context, denoted, call, stmt.range, out);
            }
            const bool callable =
                denoted.kind == Denoted::Kind::Unit || denoted.kind == Denoted::Kind::Standard ||
                (denoted.kind == Denoted::Kind::Place && context.isKind(denoted.place->type, TypeKind::Block));
            if (callable) {
                context.emit(e.range, findings::Expected(Verbatim("()"), Verbatim(";")))
                    .fixes.push_back({fixes::CallIt(), {{{e.range.file, e.range.end, e.range.end}, "()"}}});
                return;
            }
            if (denoted.kind != Denoted::Kind::Type) return valueAlone(context, e, stmt.range, out);
            context.emit(e.range, findings::NotCallable(context.textOf(e.range)));
            return;
        }
        return valueAlone(context, e, stmt.range, out);
    }
    // The order of the cases is that of how specific they are: an instance, then the only instance of a program, then
    // code without one.
    const Denoted callee = denote(context, *e.base, Access::Call);
    if (callee.kind == Denoted::Kind::Place && context.isKind(callee.place->type, TypeKind::Block)) {
        Unit* unit = context.world.unitOf(callee.place->type);
        if (unit) instanceCall(context, callee.place, *unit, e, callee, out, stmt.range);
        return;
    }
    if (isProgram(callee)) return callProgram(context, callee, e, stmt.range, out);
    Operand value;
    if (isAction(callee)) {
        // Actions have no parameters of their own (edition 2, 2.6.4): they work on those of their unit.
        if (!e.arguments.empty())
            context.emit(e.arguments.front().range, findings::TooManyArguments(callee.unit->name, 0));
        return evaluateAction(context, callee, e.range, stmt.range, out);
    }
    if (callee.kind == Denoted::Kind::Unit &&
        (callee.unit->kind == UnitKind::Function || callee.unit->kind == UnitKind::Method)) {
        value = callUnit(context, callee, e);
        // Methods are often called for their effect and give a result beside it; only functions are asked about.
        if (value.expr && !value.isUnknown() && !context.isKind(value.type(), TypeKind::Void) &&
            callee.unit->kind == UnitKind::Function)
            context.emit(e.base->range, findings::FunctionResultIgnored(callee.unit->name));
    } else if (callee.kind == Denoted::Kind::Standard) {
        value = settled(context, standardCall(context, callee.name, e, {}));
        // A sequence assigns to something, and with ENO the caller does use a result.
        if (!value.isUnknown() && value.expr->kind != tree::ExprKind::Sequence && !value.expr->ok)
            context.emit(e.base->range, findings::FunctionResultIgnored(callee.name));
        // The callee was reported; its arguments are still looked at, for their own mistakes and for the uses of
        // variables.
    } else if (callee.kind == Denoted::Kind::Nothing) {
        return checkArguments(context, e);
    } else {
        const bool isType = callee.kind == Denoted::Kind::Unit || callee.kind == Denoted::Kind::Type;
        const std::string name = context.textOf(e.base->range);
        context.emit(e.base->range,
                     isType ? findings::NotCallable(phrases::TypeNotInstance(name)) : findings::NotCallable(name));
        return;
    }
    // A call that is wrong in an argument stays in the tree: flow and "find usages" see it, and nothing is built
    // anyway.
    if (value.isUnknown() && value.expr->kind != tree::ExprKind::Call) return;
    tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, stmt.range);
    evaluate->a = value.expr;
    out.push_back(evaluate);
}

namespace {

/// The call of a block: inputs are assigned and in-outs bound before it, outputs assigned after it, and references to
/// what ends with the caller are taken back last.
class InstanceCall {
public:
    InstanceCall(Context& context, tree::Place* instance, Unit& unit, const syntax::Expr& e)
        : m_context(context), m_instance(instance), m_unit(unit), m_e(e) {}

    /// The instance, once and before the arguments: blocks[Next()](x := Next());
    void choose() { holdPlace(m_context, m_instance, *m_e.base, m_inputs); }

    void pass(const Match& match) {
        Variable& parameter = *match.parameter;
        const syntax::Argument* argument = match.argument && match.argument->value ? match.argument : nullptr;
        const TypeId type = typeOf(m_context, parameter);
        tree::Place* field = fieldOfParameter(parameter, type, argument);
        if (parameter.isInOut()) return bind(parameter, field, argument);
        // 2.5.2.1: inputs of an instance that are not given keep the value of the call before.
        if (!argument) return; // keeps its last value
        if (parameter.kind == SectionKind::Output) return output(field, *argument);
        input(parameter, type, field, *argument);
    }

    tree::Stmt* block(const Denoted& callee, SourceRange range) {
        tree::Expr* made = m_context.arena.make<tree::Expr>();
        made->kind = tree::ExprKind::Call;
        made->type = m_context.elementary(TypeKind::Void);
        made->range = m_e.range;
        made->call = m_context.arena.make<tree::Call>();
        Denoted body = callee;
        body.kind = Denoted::Kind::Unit;
        body.unit = &m_unit;
        body.instance = m_instance;
        // From here on the callee is the body of the instance's block, not the name that led to it.
        body.interface = nullptr;
        prepareCall(m_context, *made->call, body, m_e.range);
        tree::Stmt* evaluate = newStmt(m_context, tree::StmtKind::Evaluate, range);
        evaluate->a = made;
        // The order is the meaning: inputs and bindings, the body, outputs, and only then are references taken back,
        // because an output may be read through one of them.
        m_block->body = std::move(m_inputs);
        m_block->body.push_back(evaluate);
        m_block->body.insert(m_block->body.end(), m_outputs.begin(), m_outputs.end());
        m_block->body.insert(m_block->body.end(), m_after.begin(), m_after.end());
        return m_block;
    }

    // The whole call is one step for the debugger: what is assigned for it has no range of its own and is hidden.
    void begin(SourceRange range) { m_block = newStmt(m_context, tree::StmtKind::Block, range); }

private:
    tree::Place* fieldOfParameter(const Variable& parameter, TypeId type, const syntax::Argument* argument) {
        // An input declared AT %I… is not in the instance at all.
        if (parameter.storage == Storage::Absolute)
            return absolutePlace(m_context, parameter.offset, type, parameter.bit, {});
        if (!parameter.isInOut())
            return fieldPlace(m_context, m_instance, parameter.offset, type, -1,
                              argument ? argument->value->range : m_e.range);
        tree::Place* slot = m_context.arena.make<tree::Place>();
        slot->kind = tree::PlaceKind::InOutSlot;
        slot->type = type;
        slot->base = m_instance;
        slot->offset = parameter.offset;
        slot->range = m_e.range;
        return slot;
    }

    void bind(Variable& parameter, tree::Place* slot, const syntax::Argument* argument) {
        if (!argument) {
            m_context.emit(m_e.base->range, findings::MissingArgument(parameter.name, m_unit.name));
            return;
        }
        tree::Place* target = inOutTarget(m_context, parameter, *argument, m_inputs, m_after);
        if (!target) return;
        tree::Stmt* bind = newStmt(m_context, tree::StmtKind::Bind, {});
        bind->place = slot;
        bind->target = target;
        m_inputs.push_back(bind);
        if (!m_context.function || !isInFrame(*target, *m_context.function)) return;
        // the instance outlives the local that it refers to
        // Otherwise the next scan could read through an address that is by then another call's frame.
        tree::Stmt* unbind = newStmt(m_context, tree::StmtKind::Bind, {});
        unbind->place = slot;
        m_after.push_back(unbind);
    }

    void output(tree::Place* field, const syntax::Argument& argument) {
        const Denoted target = sema::target(m_context, *argument.value);
        if (target.kind == Denoted::Kind::Nothing) return;
        // `Q => NOT x` has no meaning; the negation belongs to the pin.
        Operand value = load(m_context, field, argument.value->range);
        if (argument.negated) value = inverted(m_context, value, argument.value->range);
        assignTo(m_context, target, value, {}, m_outputs, true);
    }

    void input(Variable& parameter, TypeId type, tree::Place* field, const syntax::Argument& argument) {
        const syntax::Expr& given = *argument.value;
        // REFERENCE TO as an input: the argument is the variable itself, not its value (REF=).
        if (m_context.isKind(type, TypeKind::Reference)) {
            bindReference(m_context, field, given, {}, m_inputs);
            return;
        }
        // fb(a := [1, 2]) and fb(s := (x := 1)) are assigned element by element: an aggregate has no value of its own.
        const bool isList = given.kind == syntax::ExprKind::ArrayInit || given.kind == syntax::ExprKind::StructInit;
        if (isList && m_context.types.isAggregate(type)) {
            assignAggregate(m_context, field, given, {}, m_inputs);
            return;
        }
        Operand value = isAnyInput(m_context.world, parameter)
                            ? anyArgument(m_context, parameter, given)
                            : converted(m_context, expression(m_context, given, type), type);
        if (argument.negated) value = inverted(m_context, value, given.range);
        if (!value.isUnknown()) m_inputs.push_back(assignStmt(m_context, field, value.expr, {}));
    }

    Context& m_context;
    tree::Place* m_instance;
    Unit& m_unit;
    const syntax::Expr& m_e;
    tree::Stmt* m_block = nullptr;
    std::vector<tree::Stmt*> m_inputs, m_outputs, m_after;
};

// Without it, a variable that is only used in a wrong call would be reported as unused beside the real mistake.
/// Arguments of a call that is wrong: what they name is used all the same.
void lookAtArguments(Context& context, const Matched& matched) {
    for (const Match& each : matched.matches) {
        if (!each.argument || !each.argument->value) continue;
        if (each.argument->kind == ArgumentKind::Output)
            denote(context, *each.argument->value, Access::Write);
        else
            expression(context, *each.argument->value, typeOf(context, *each.parameter));
    }
}

/// EN and ENO: the block runs only if EN is TRUE, and ENO says whether it did.
// 2.5.1.2: with EN = FALSE nothing of the block happens, its inputs are not assigned either.
tree::Stmt* withEnable(Context& context, const Matched& matched, tree::Stmt* block, SourceRange call,
                       SourceRange range) {
    const TypeId boolean = context.elementary(TypeKind::Bool);
    tree::Place* eno = nullptr;
    if (matched.eno && matched.eno->value) {
        const Denoted denoted = target(context, *matched.eno->value);
        if (denoted.kind == Denoted::Kind::Place && context.types.storageKind(denoted.place->type) == TypeKind::Bool)
            eno = denoted.place;
    }
    tree::Expr* en = matched.en && matched.en->value ? condition(context, *matched.en->value)
                                                     : constant(context, {boolean, int64_t(1)}, call).expr;
    tree::Stmt* choice = newStmt(context, tree::StmtKind::If, range);
    choice->a = en;
    choice->body.push_back(block);
    if (!eno) return choice;
    choice->body.push_back(assignStmt(context, eno, constant(context, {boolean, int64_t(1)}, call).expr, {}));
    choice->elseBody.push_back(assignStmt(context, eno, constant(context, {boolean, int64_t(0)}, call).expr, {}));
    return choice;
}

} // namespace

/// inst(in := a, io := b, out => c): a Block of assignments, bindings, the call of the body, and assignments from the
/// outputs.
///   wrong: b();  for VAR_IN_OUT x (P2010); b();  of FUNCTION_BLOCK ABSTRACT B (P2025)
void instanceCall(Context& context, tree::Place* instance, Unit& unit, const syntax::Expr& e, const Denoted& callee,
                  std::vector<tree::Stmt*>& out, SourceRange range) {
    completeUnit(context, unit, e.range);
    // An abstract type behind a pointer or an in-out is some block that is derived from it; only a variable of the type
    // itself is wrong.
    if (unit.isAbstract && callee.isExact) context.emit(e.base->range, findings::AbstractInstance(unit.name));
    const Matched matched = match(context, e, unit.name, unit.parameters);
    if (!matched.isGood) return lookAtArguments(context, matched);
    InstanceCall call(context, instance, unit, e);
    call.begin(range);
    call.choose();
    for (const Match& each : matched.matches) call.pass(each);
    tree::Stmt* block = call.block(callee, range);
    out.push_back(matched.en || matched.eno ? withEnable(context, matched, block, e.range, range) : block);
}

} // namespace plc::sema
