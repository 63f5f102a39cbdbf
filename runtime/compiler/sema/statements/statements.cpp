// Statements → checked statements; reachability and "is the result set" are followed on the way.
#include "runtime/compiler/sema/statements/statements.h"

#include "runtime/compiler/sema/calls/call_statements.h"
#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/tests.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/layout.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/statements/case_statement.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

using lex::TokenKind;
using syntax::StmtKind;

static void statement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void assignReference(Context& context, const Denoted& target, const syntax::Expr& value, SourceRange range,
                            std::vector<tree::Stmt*>& out);
static bool isAssociable(Context& context, const syntax::Stmt& stmt);
static void ifStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void forStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void whileStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void repeatStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void returnStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void labelStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void jumpStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);

tree::Stmt* newStmt(Context& context, tree::StmtKind kind, SourceRange range) {
    tree::Stmt* stmt = context.arena.make<tree::Stmt>();
    stmt->kind = kind;
    stmt->range = range;
    stmt->isHidden = !range.file.isValid();
    return stmt;
}

tree::Stmt* assignStmt(Context& context, tree::Place* place, tree::Expr* value, SourceRange range) {
    tree::Stmt* stmt = newStmt(context, tree::StmtKind::Assign, range);
    stmt->place = place;
    stmt->a = value;
    stmt->operandType = place->type;
    return stmt;
}

///   ok:    IF x > 1 THEN RETURN; END_IF x := 1;      advice: RETURN; x := 1;  (P3007)
void statements(Context& context, const syntax::Block& block, std::vector<tree::Stmt*>& out) {
    bool reported = false;
    for (size_t i = 0; i < block.size(); ++i) {
        const syntax::Stmt& stmt = *block[i];
        if (!context.flow.isReachable && stmt.kind == StmtKind::Label) context.flow.isReachable = true;
        if (!context.flow.isReachable && !reported && !context.insideUnreachable && stmt.kind != StmtKind::Empty &&
            stmt.range.file.isValid() && block.back()->range.file == stmt.range.file && !stmt.origin) {
            context.emit(stmt.range, findings::UnreachableCode());
            reported = true;
        }
        const bool outer = std::exchange(context.insideUnreachable,
                                         context.insideUnreachable || (reported && !context.flow.isReachable));
        statement(context, stmt, out);
        context.insideUnreachable = outer;
    }
}

///   ok:    WHILE x < 5 DO EXIT; END_WHILE      wrong: x := 1; EXIT;  (P3020)   ASSERT x = 1;  in a PROGRAM (P6001)
void statement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    switch (stmt.kind) {
    case StmtKind::Empty:
        return;
    case StmtKind::Assign:
        return assignment(context, stmt, out);
    case StmtKind::Call:
        return callStatement(context, stmt, out);
    case StmtKind::If:
        return ifStatement(context, stmt, out);
    case StmtKind::Case:
        return caseStatement(context, stmt, out);
    case StmtKind::For:
        return forStatement(context, stmt, out);
    case StmtKind::While:
        return whileStatement(context, stmt, out);
    case StmtKind::Repeat:
        return repeatStatement(context, stmt, out);
    case StmtKind::Exit:
    case StmtKind::Continue:
        if (context.loops.empty()) {
            context.emit(stmt.range,
                         findings::OutsideLoop(Verbatim(stmt.kind == StmtKind::Exit ? "EXIT" : "CONTINUE")));
            return;
        }
        if (stmt.kind == StmtKind::Exit) {
            context.loops.back().hasExit = true;
            context.loops.back().resultSetAtExit = context.loops.back().resultSetAtExit && context.flow.isResultSet;
        }
        out.push_back(newStmt(context, stmt.kind == StmtKind::Exit ? tree::StmtKind::Exit : tree::StmtKind::Continue,
                              stmt.range));
        context.flow.isReachable = false;
        return;
    case StmtKind::Return:
        return returnStatement(context, stmt, out);
    case StmtKind::Label:
        return labelStatement(context, stmt, out);
    case StmtKind::Jump:
        return jumpStatement(context, stmt, out);
    case StmtKind::Block: {
        tree::Stmt* made = newStmt(context, tree::StmtKind::Block, stmt.range);
        statements(context, stmt.body, made->body);
        out.push_back(made);
        return;
    }
    case StmtKind::Il:
        return; // lowered before
    case StmtKind::Run:
    case StmtKind::Assert:
    case StmtKind::Force:
    case StmtKind::Release:
    case StmtKind::Compare:
    case StmtKind::PowerOff: {
        if (context.isTest) return testStatement(context, stmt, out);
        static constexpr const char* kWords[] = {"RUN", "ASSERT", "FORCE", "RELEASE", "COMPARE", "POWER_OFF"};
        context.emit(stmt.range, findings::TestUnknownStatement(
                                     Verbatim(kWords[static_cast<int>(stmt.kind) - static_cast<int>(StmtKind::Run)])));
        return;
    }
    }
}

/// Where a value goes: a place or a property. Reports what cannot be written.
///   ok:    x := 5;      wrong: t.Q := TRUE;  (P2005)      advice: FOR i := 1 TO 5 DO i := i + 1; END_FOR  (P3021)
Denoted target(Context& context, const syntax::Expr& e, TypeId* type) {
    Denoted denoted = denote(context, e, Access::Write);
    switch (denoted.kind) {
    case Denoted::Kind::Nothing:
        return denoted;
    case Denoted::Kind::Place: {
        if (denoted.isReadOnly) {
            context.emit(e.range, findings::NotAssignable(denoted.whyReadOnly));
            return {};
        }
        const tree::Place* root = rootOf(denoted.place);
        if (root->kind == tree::PlaceKind::Temporary) {
            context.emit(e.range, findings::NotAssignable(context.textOf(e.range)));
            return {};
        }
        if (root->kind == tree::PlaceKind::Absolute && context.scope.unit && context.scope.unit->self() &&
            context.scope.unit->self()->kind == UnitKind::Program && !context.scope.unit->self()->isSimulation &&
            !context.isExpression) {
            const image::AreaRange inputs = areaOf(context.world, image::Area::Input);
            if (root->offset >= inputs.begin && root->offset < inputs.begin + inputs.size) {
                auto& diagnostic =
                    context.emit(e.range, findings::NotAssignable(phrases::InputAddress(context.textOf(e.range))));
                diagnostic.severity = diagnostics::Severity::Warning;
            }
        }
        if (context.world.options.strict && denoted.variable && denoted.variable->kind == syntax::SectionKind::Input &&
            context.scope.unit && denoted.variable->owner == context.scope.unit)
            context.emit(e.range, findings::NotAssignable(phrases::Input(denoted.variable->name))).severity =
                diagnostics::Severity::Warning;
        for (const Variable* variable : context.loopVariables)
            if (variable == denoted.variable && denoted.place->type == variable->type)
                context.emit(e.range, findings::LoopVariableWritten(variable->name));
        if (type) *type = denoted.place->type;
        return denoted;
    }
    case Denoted::Kind::Property:
        if (!denoted.property->set) {
            context.emit(e.range, findings::NotAssignable(phrases::PropertyWithoutSet(denoted.property->name)));
            return {};
        }
        if (type) *type = typeOf(context.world, denoted.property->set->variables.front());
        return denoted;
    default:
        context.emit(e.range, findings::NotAssignable(context.textOf(e.range)));
        return {};
    }
}

void assignTo(Context& context, const Denoted& target, Operand value, SourceRange range, std::vector<tree::Stmt*>& out,
              bool isHidden) {
    if (target.kind == Denoted::Kind::Nothing || value.isUnknown()) return;
    if (target.kind == Denoted::Kind::Property) {
        Unit& set = *target.property->set;
        completeUnit(context.world, set, range);
        checkAccess(context, set.access, target.property->owner, target.property->name, value.expr->range);
        const Operand fitting = converted(context, value, typeOf(context.world, set.variables.front()));
        if (fitting.isUnknown()) return;
        tree::Expr* e = context.arena.make<tree::Expr>();
        e->kind = tree::ExprKind::Call;
        e->type = context.elementary(TypeKind::Void);
        e->range = range.file.isValid() ? range : value.expr->range;
        e->call = context.arena.make<tree::Call>();
        Denoted callee = target;
        callee.kind = Denoted::Kind::Unit;
        callee.unit = &set;
        prepareCall(context, *e->call, callee, e->range);
        tree::CallArgument argument;
        argument.local = set.variables.front().local;
        argument.value = fitting.expr;
        e->call->arguments.push_back(argument);
        tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, range);
        evaluate->a = e;
        out.push_back(evaluate);
        return;
    }
    const Operand fitting = converted(context, value, target.place->type);
    if (fitting.isUnknown()) return;
    tree::Stmt* made = assignStmt(context, target.place, fitting.expr, range);
    made->isHidden = made->isHidden || isHidden;
    out.push_back(made);
}

/// A REFERENCE TO gets its variable.
void bindReference(Context& context, tree::Place* raw, const syntax::Expr& value, SourceRange range,
                   std::vector<tree::Stmt*>& out) {
    const TypeId type = raw->type;
    const TypeId element = context.types[type].element;
    const Denoted denoted = denote(context, value, Access::Address);
    if (denoted.kind == Denoted::Kind::Nothing) return;
    Operand source;
    if (denoted.kind == Denoted::Kind::Place) {
        const TypeId given = denoted.place->type;
        const bool fitsElement =
            sameType(context.world, given, element) ||
            (context.isKind(given, TypeKind::Block) && context.types.isDerivedFrom(given, element));
        if (!fitsElement && (context.isKind(given, TypeKind::Pointer) &&
                             sameType(context.world, context.types[given].element, element)))
            source = sameBits(context, load(context, denoted.place, value.range), type);
        else if (!fitsElement)
            return mismatch(context, value.range, given, type);
        else
            source = addressOf(context, denoted.place, type, value.range);
    } else {
        const Operand other = sema::value(context, denoted, value, type);
        if (other.isUnknown()) return;
        source = converted(context, other, type);
    }
    if (!source.isUnknown()) out.push_back(assignStmt(context, raw, source.expr, range));
}

///   ok:    p REF= x;  with p : REFERENCE TO INT      wrong: x REF= y;  with x : INT (P2020)
void assignReference(Context& context, const Denoted& target, const syntax::Expr& value, SourceRange range,
                     std::vector<tree::Stmt*>& out) {
    tree::Place* place = target.place;
    if (place && place->kind == tree::PlaceKind::Deref && place->pointer &&
        place->pointer->kind == tree::ExprKind::Load && context.isKind(place->pointer->type, TypeKind::Reference))
        return bindReference(context, place->pointer->place, value, range, out);
    if (place && context.isKind(place->type, TypeKind::Pointer)) { // REF= on a pointer: its address
        const Denoted source = denote(context, value, Access::Address);
        if (source.kind != Denoted::Kind::Place) return;
        const Operand address =
            converted(context, addressOf(context, source.place, context.types.pointer(source.place->type), value.range),
                      place->type);
        if (!address.isUnknown()) out.push_back(assignStmt(context, place, address.expr, range));
        return;
    }
    if (place) context.emit(place->range, findings::NotAPointer(context.textOf(place->range)));
}

void assignAggregate(Context& context, tree::Place* place, const syntax::Expr& value, SourceRange range,
                     std::vector<tree::Stmt*>& out) {
    // constants at once, the rest element by element
    if (!fitsIntoCode(context, place->type, value.range)) return;
    InitialValue initial;
    initial.bytes = context.types[place->type].initial;
    initial.bytes.resize(context.types[place->type].size);
    initialise(context.world, initial, place->type, 0, -1, &value, context.scope, nullptr);
    const Operand whole = constant(context, types::readValue(context.types, place->type, initial.bytes), value.range);
    out.push_back(assignStmt(context, place, whole.expr, range));
    for (const DynamicInit& dynamic : initial.dynamics) {
        if (!dynamic.value) continue;
        Operand part = converted(context, expression(context, *dynamic.value, dynamic.type), dynamic.type);
        if (!part.isUnknown())
            out.push_back(assignStmt(
                context, fieldPlace(context, place, dynamic.offset, dynamic.type, dynamic.bit, dynamic.value->range),
                part.expr, {}));
    }
}

/// What a step names with a qualifier is an ACTION or a BOOL variable (2.6.4.1). A reset of the chart says nothing
/// again.
///   wrong: STEP s: missing(N); END_STEP  (P4010)
bool isAssociable(Context& context, const syntax::Stmt& stmt) {
    const syntax::Expr& name = *stmt.target;
    if (!name.name.isValid()) return true;
    const Found found = lookup(context.world, context.scope, context.key(name.name.text));
    Variable* variable = found.member.variable ? found.member.variable : found.entity.variable;
    const TypeId type = variable ? typeOf(context.world, *variable) : TypeId();
    if (variable ? context.isKind(type, TypeKind::Unknown) || context.types.storageKind(type) == TypeKind::Bool
                 : found.member.property != nullptr || !found.ambiguous.empty())
        return true;
    if (stmt.value->kind == syntax::ExprKind::Literal) return false;
    std::vector<std::string> candidates;
    for (Unit* unit = context.scope.unit ? context.scope.unit->self() : nullptr; unit; unit = unit->base) {
        for (const Unit* action : unit->actions) candidates.push_back(action->name);
        for (Variable& own : unit->variables)
            if (!own.name.starts_with("__") && context.types.storageKind(typeOf(context.world, own)) == TypeKind::Bool)
                candidates.push_back(own.name);
    }
    suggest(context, context.emit(name.range, findings::UnknownAction(name.name.text)), name.range, name.name.text,
            candidates);
    return false;
}

void assignment(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.target || !stmt.value) return;
    const syntax::Expr& value = *stmt.value;
    if (stmt.op == TokenKind::RefAssign) {
        const Denoted denoted = denote(context, *stmt.target, Access::Write);
        if (denoted.kind == Denoted::Kind::Place)
            assignReference(context, denoted, value, stmt.range, out);
        else if (denoted.kind != Denoted::Kind::Nothing)
            context.emit(stmt.target->range, findings::NotAPointer(context.textOf(stmt.target->range)));
        return;
    }
    if (value.kind == syntax::ExprKind::ArrayInit || value.kind == syntax::ExprKind::StructInit) {
        const Denoted to = target(context, *stmt.target);
        if (to.kind == Denoted::Kind::Place && context.types.isAggregate(to.place->type))
            return assignAggregate(context, to.place, value, stmt.range, out);
        if (to.kind == Denoted::Kind::Place) expression(context, value, to.place->type);
        return;
    }
    if (stmt.isAssociation) {
        const bool isCall = !stmt.branches.empty(); // what runs where the name is an action of a base
        if (stmt.target->name.isValid())
            if (const Unit* unit =
                    lookup(context.world, context.scope, context.key(stmt.target->name.text)).member.unit;
                unit && unit->kind == UnitKind::Action) {
                if (isCall) statements(context, stmt.branches[0].body, out);
                return;
            }
        if (isCall || !isAssociable(context, stmt)) return;
    }
    TypeId type;
    // the target's type is known before the value, but its effects count after it
    const Flow before = context.flow;
    const Denoted to = target(context, *stmt.target, &type);
    const Flow after = context.flow;
    context.flow = before;
    if (stmt.op == TokenKind::SetAssign || stmt.op == TokenKind::ResetAssign) {
        tree::Expr* when = condition(context, value);
        context.flow = after;
        if (to.kind == Denoted::Kind::Nothing || context.isKind(when->type, TypeKind::Unknown)) return;
        if (context.types.storageKind(type) != TypeKind::Bool)
            return mismatch(context, stmt.target->range, type, context.elementary(TypeKind::Bool));
        tree::Stmt* choice = newStmt(context, tree::StmtKind::If, stmt.range);
        choice->a = when;
        assignTo(context, to,
                 constant(context, {context.elementary(TypeKind::Bool), int64_t(stmt.op == TokenKind::SetAssign)},
                          stmt.range),
                 {}, choice->body, true);
        out.push_back(choice);
        return;
    }
    if (stmt.op == TokenKind::TryAssign) {
        Operand from = expression(context, value);
        context.flow = after;
        if (to.kind != Denoted::Kind::Place || from.isUnknown()) return;
        const bool goodTarget = context.isKind(type, TypeKind::Interface) || context.isKind(type, TypeKind::Pointer);
        if (context.isKind(from.type(), TypeKind::Block) && from.expr->kind == tree::ExprKind::Load)
            from = addressOf(context, from.expr->place, context.types.pointer(from.type()), value.range);
        if (!goodTarget ||
            (!context.isKind(from.type(), TypeKind::Interface) && !context.isKind(from.type(), TypeKind::Pointer)))
            return mismatch(context, value.range, from.type(), type);
        tree::Expr* cast = context.arena.make<tree::Expr>();
        cast->kind = tree::ExprKind::TryCast;
        cast->type = type;
        cast->range = value.range;
        cast->a = from.expr;
        out.push_back(assignStmt(context, to.place, cast, stmt.range));
        return;
    }
    const Operand from = expression(context, value, type);
    context.flow = after;
    if (to.kind == Denoted::Kind::Place && context.isKind(to.place->type, TypeKind::OpenArray)) {
        context.emit(stmt.target->range, findings::NotAssignable(context.textOf(stmt.target->range)));
        return;
    }
    assignTo(context, to, from, stmt.range, out);
}

void ifStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const Flow before = context.flow;
    Flow joined{false, true};
    bool hasElse = false;
    std::vector<tree::Stmt*>* into = &out;
    for (const syntax::IfBranch& branch : stmt.branches) {
        context.flow = before;
        if (!branch.condition) {
            hasElse = true;
            statements(context, branch.body, *into);
        } else {
            const SourceRange range =
                into == &out
                    ? (stmt.range.file.isValid() ? SourceRange{stmt.range.file, stmt.range.begin,
                                                               std::max(stmt.range.begin, branch.condition->range.end)}
                                                 : stmt.range)
                    : branch.condition->range;
            tree::Stmt* choice = newStmt(context, tree::StmtKind::If, range);
            choice->a = condition(context, *branch.condition);
            statements(context, branch.body, choice->body);
            into->push_back(choice);
            into = &choice->elseBody;
        }
        if (context.flow.isReachable) joined.isResultSet = joined.isResultSet && context.flow.isResultSet;
        joined.isReachable = joined.isReachable || context.flow.isReachable;
    }
    if (!hasElse) {
        joined.isResultSet = (joined.isReachable ? joined.isResultSet : true) && before.isResultSet;
        joined.isReachable = joined.isReachable || before.isReachable;
    }
    context.flow = joined;
    if (!before.isReachable) context.flow.isReachable = false;
}

/// FOR (edition 3, 7.3.3.4.2): the variable and its bounds are integers; they are computed once.
///   ok:    FOR i := 1 TO 10 BY 2 DO … END_FOR      wrong: FOR r := 1.0 TO 2.0 DO … END_FOR  (P2006)
///   advice: FOR i := 1 TO 10 BY 0 DO … END_FOR  (P3033)   FOR i := 5 TO 1 DO … END_FOR  (P3007)
void forStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.target) return;
    const Denoted variable = target(context, *stmt.target);
    if (variable.kind == Denoted::Kind::Place && variable.variable) ++variable.variable->reads;
    TypeId type = variable.kind == Denoted::Kind::Place ? variable.place->type : context.elementary(TypeKind::Unknown);
    if (variable.kind == Denoted::Kind::Property)
        context.emit(stmt.target->range, findings::NotAssignable(context.textOf(stmt.target->range)));
    const bool known = !context.isKind(type, TypeKind::Unknown);
    if (known && !types::isInteger(context.types.family(type))) {
        context.emit(stmt.target->range, findings::OperatorNotForType(Verbatim("FOR"), context.nameOf(type)));
        type = context.elementary(TypeKind::Unknown);
    }
    const bool good = !context.isKind(type, TypeKind::Unknown);
    const TypeId storage = good ? context.types.storage(type) : type;
    Operand from = stmt.from ? expression(context, *stmt.from, storage) : unknown(context, stmt.range);
    Operand to = stmt.to ? expression(context, *stmt.to, storage) : unknown(context, stmt.range);
    Operand by = stmt.by ? expression(context, *stmt.by)
                         : constant(context, {context.elementary(TypeKind::Lint), int64_t(1)}, stmt.range, true);
    const bool stepNegative =
        good && by.isConstant() && std::holds_alternative<int64_t>(by.expr->value.data) && by.expr->value.integer() < 0;
    const bool isSigned = good && context.types.family(storage) == types::Family::Signed;
    // counted in the variable's type; downwards or beyond an unsigned or narrow type in a wider signed one
    TypeId counted = storage;
    const unsigned width = good ? types::bitsOf(context.types.storageKind(storage)) : 0;
    const bool variableStep = good && !by.isUnknown() && !by.isConstant() && !isSigned &&
                              context.types.family(by.type()) == types::Family::Signed;
    if (good && !isSigned && (stepNegative || variableStep))
        counted = context.elementary(width == 8 ? TypeKind::Int : width == 16 ? TypeKind::Dint : TypeKind::Lint);
    const auto limit = [&](Operand operand, TypeId wanted) {
        if (!good || operand.isUnknown()) return operand;
        if (!isNumeric(context, operand.type())) return converted(context, operand, wanted);
        if (operand.isConstant() && !fits(context, operand.expr->value, storage) &&
            std::holds_alternative<int64_t>(operand.expr->value.data) && wanted == storage)
            return converted(context, operand, wanted); // its message
        // a limit of a wider type is compared as it is
        return operand.isFlexible || operand.isConstant() ? converted(context, operand, wanted)
                                                          : converted(context, operand, wanted);
    };
    if (by.isConstant() && std::holds_alternative<int64_t>(by.expr->value.data) && by.expr->value.integer() == 0)
        context.emit(by.expr->range, findings::EndlessLoop());
    from = limit(from, counted);
    to = limit(to, counted);
    by = good ? converted(context, by, counted) : by;
    tree::Stmt* made = newStmt(context, tree::StmtKind::For,
                               stmt.range.file.isValid() && stmt.to
                                   ? SourceRange{stmt.range.file, stmt.range.begin,
                                                 std::max(stmt.range.begin, (stmt.by ? stmt.by : stmt.to)->range.end)}
                                   : stmt.range);
    if (good) {
        made->place = variable.place;
        made->a = from.expr;
        made->b = to.expr;
        made->c = by.expr;
        made->operandType = counted;
    }
    const Flow before = context.flow;
    context.loops.push_back({});
    if (variable.variable) context.loopVariables.push_back(variable.variable);
    statements(context, stmt.body, made->body);
    if (variable.variable) context.loopVariables.pop_back();
    const bool runs = from.isConstant() && to.isConstant() && by.isConstant() &&
                      std::holds_alternative<int64_t>(from.expr->value.data) &&
                      std::holds_alternative<int64_t>(to.expr->value.data) &&
                      (stepNegative ? from.expr->value.integer() >= to.expr->value.integer()
                                    : from.expr->value.integer() <= to.expr->value.integer());
    const auto isWritten = [](const syntax::Expr* e) {
        return e && (e->kind == syntax::ExprKind::Literal ||
                     (e->kind == syntax::ExprKind::Unary && e->base->kind == syntax::ExprKind::Literal));
    };
    if (!runs && from.isConstant() && to.isConstant() && by.isConstant() && isWritten(stmt.from) &&
        isWritten(stmt.to) && std::holds_alternative<int64_t>(from.expr->value.data) &&
        std::holds_alternative<int64_t>(to.expr->value.data))
        context.emit(joined(stmt.from->range, stmt.to->range), findings::UnreachableCode()); // FOR i := 5 TO 1
    const bool setInside =
        context.flow.isResultSet && (!context.loops.back().hasExit || context.loops.back().resultSetAtExit);
    context.loops.pop_back();
    context.flow.isReachable = before.isReachable;
    context.flow.isResultSet = before.isResultSet || (runs && setInside);
    if (good && !from.isUnknown() && !to.isUnknown() && !by.isUnknown()) out.push_back(made);
}

///   advice: WHILE TRUE DO x := 1; END_WHILE  (P3033)
void whileStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    tree::Stmt* made =
        newStmt(context, tree::StmtKind::While,
                stmt.range.file.isValid() && stmt.value
                    ? SourceRange{stmt.range.file, stmt.range.begin, std::max(stmt.range.begin, stmt.value->range.end)}
                    : stmt.range);
    if (stmt.value) made->a = condition(context, *stmt.value);
    const Flow before = context.flow;
    context.loops.push_back({});
    statements(context, stmt.body, made->body);
    const Loop loop = context.loops.back();
    context.loops.pop_back();
    const bool endless = made->a && made->a->kind == tree::ExprKind::Constant && made->a->value.isTrue();
    context.flow = before;
    if (endless && !loop.hasExit && !loop.isLeft && before.isReachable) {
        context.emit(stmt.value->range, findings::EndlessLoop());
    } else if (endless) {
        context.flow.isReachable = before.isReachable && loop.hasExit;
        context.flow.isResultSet = before.isResultSet || loop.resultSetAtExit;
    }
    if (made->a) out.push_back(made);
}

///   advice: REPEAT x := 1; UNTIL FALSE END_REPEAT  (P3033)
void repeatStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    tree::Stmt* made = newStmt(context, tree::StmtKind::Repeat,
                               stmt.range.file.isValid() && stmt.value ? stmt.value->range : stmt.range);
    const Flow before = context.flow;
    context.loops.push_back({});
    statements(context, stmt.body, made->body);
    const Loop loop = context.loops.back();
    context.loops.pop_back();
    const bool set = context.flow.isResultSet && (!loop.hasExit || loop.resultSetAtExit);
    if (stmt.value) made->a = condition(context, *stmt.value);
    if (made->a && made->a->kind == tree::ExprKind::Constant && made->a->value.hasValue() && !made->a->value.isTrue() &&
        !loop.hasExit && !loop.isLeft && context.flow.isReachable)
        context.emit(stmt.value->range, findings::EndlessLoop());
    context.flow.isReachable = before.isReachable && (context.flow.isReachable || loop.hasExit || before.isReachable);
    context.flow.isResultSet = before.isResultSet || set;
    if (made->a) out.push_back(made);
}

void returnStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    for (Loop& loop : context.loops) loop.isLeft = true;
    if (stmt.value) {
        Unit* unit = context.scope.unit;
        if (!unit || !unit->resultVariable) {
            expression(context, *stmt.value);
            context.emit(stmt.value->range, findings::NotAllowedHere(phrases::ReturnWithValue(),
                                                                     unit ? phrases::In(unit->name) : phrases::Here()));
            return;
        }
        Variable& result = *unit->resultVariable;
        const Operand value = converted(context, expression(context, *stmt.value, result.type), result.type);
        if (!value.isUnknown())
            out.push_back(assignStmt(context, localPlace(context, result.local, result.type, stmt.value->range),
                                     value.expr, stmt.range));
        context.flow.isResultSet = true;
    }
    if (context.flow.isReachable) context.returnsSet = context.returnsSet && context.flow.isResultSet;
    tree::Stmt* made = newStmt(context, tree::StmtKind::Return, stmt.range);
    if (stmt.value) made->isHidden = true;
    out.push_back(made);
    context.flow.isReachable = false;
}

void declareLabels(Context& context, const syntax::Block& block) {
    for (const syntax::Stmt* stmt : block) {
        if (stmt->kind == StmtKind::Label && stmt->name.isValid()) {
            Label label;
            label.id = tree::LabelId(context.function->labelCount++);
            label.range = stmt->name.range;
            const NameId id = context.key(stmt->name.text);
            if (context.labels.count(id))
                context.emit(stmt->name.range, findings::DuplicateName(stmt->name.text));
            else {
                label.symbol =
                    addSymbol(context.world, SymbolKind::Label, stmt->name.text,
                              context.scope.unit ? context.scope.unit->qualified : std::string(), stmt->name.range);
                context.labels.emplace(id, label);
            }
        }
        declareLabels(context, stmt->body);
        declareLabels(context, stmt->elseBody);
        for (const syntax::IfBranch& branch : stmt->branches) declareLabels(context, branch.body);
        for (const syntax::CaseArm& arm : stmt->arms) declareLabels(context, arm.body);
    }
}

void labelStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const auto it = context.labels.find(context.key(stmt.name.text));
    if (it == context.labels.end()) return;
    tree::Stmt* made = newStmt(context, tree::StmtKind::Label, {});
    made->label = it->second.id;
    out.push_back(made);
    context.flow.isReachable = true;
}

///   ok:    JMP here; … here: x := 2;      wrong: JMP there;  (P3019)
void jumpStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    for (Loop& loop : context.loops) loop.isLeft = true;
    const auto it = context.labels.find(context.key(stmt.name.text));
    tree::Expr* when = stmt.value ? condition(context, *stmt.value) : nullptr;
    if (it == context.labels.end()) {
        std::vector<std::string> candidates;
        for (const auto& [id, label] : context.labels) candidates.emplace_back(context.world.textOf(label.range));
        suggest(context, context.emit(stmt.name.range, findings::UnknownLabel(stmt.name.text)), stmt.name.range,
                stmt.name.text, candidates);
        return;
    }
    it->second.isUsed = true;
    refer(context, stmt.name.range, it->second.symbol, Access::Read);
    tree::Stmt* made = newStmt(context, tree::StmtKind::Jump, stmt.range);
    made->label = it->second.id;
    made->a = when;
    out.push_back(made);
    if (!when) context.flow.isReachable = false;
}

} // namespace plc::sema
