// Statements → checked statements; reachability and "is the result set" are followed on the way.
#include "runtime/compiler/sema/checker.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

using lex::TokenKind;
using syntax::StmtKind;

tree::Stmt* Checker::newStmt(tree::StmtKind kind, SourceRange range) {
    tree::Stmt* stmt = arena.make<tree::Stmt>();
    stmt->kind = kind;
    stmt->range = range;
    stmt->isHidden = !range.file.isValid();
    return stmt;
}

tree::Stmt* Checker::assignStmt(tree::Place* place, tree::Expr* value, SourceRange range) {
    tree::Stmt* stmt = newStmt(tree::StmtKind::Assign, range);
    stmt->place = place;
    stmt->a = value;
    stmt->operandType = place->type;
    return stmt;
}

///   ok:    IF x > 1 THEN RETURN; END_IF x := 1;      advice: RETURN; x := 1;  (P3007)
void Checker::statements(const syntax::Block& block, std::vector<tree::Stmt*>& out) {
    bool reported = false;
    for (size_t i = 0; i < block.size(); ++i) {
        const syntax::Stmt& stmt = *block[i];
        if (!flow.isReachable && stmt.kind == StmtKind::Label) flow.isReachable = true;
        if (!flow.isReachable && !reported && !insideUnreachable && stmt.kind != StmtKind::Empty &&
            stmt.range.file.isValid() && block.back()->range.file == stmt.range.file && !stmt.origin) {
            emit(stmt.range, findings::UnreachableCode());
            reported = true;
        }
        const bool outer = std::exchange(insideUnreachable, insideUnreachable || (reported && !flow.isReachable));
        statement(stmt, out);
        insideUnreachable = outer;
    }
}

///   ok:    WHILE x < 5 DO EXIT; END_WHILE      wrong: x := 1; EXIT;  (P3020)   ASSERT x = 1;  in a PROGRAM (P6001)
void Checker::statement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    switch (stmt.kind) {
    case StmtKind::Empty:
        return;
    case StmtKind::Assign:
        return assignment(stmt, out);
    case StmtKind::Call:
        return callStatement(stmt, out);
    case StmtKind::If:
        return ifStatement(stmt, out);
    case StmtKind::Case:
        return caseStatement(stmt, out);
    case StmtKind::For:
        return forStatement(stmt, out);
    case StmtKind::While:
        return whileStatement(stmt, out);
    case StmtKind::Repeat:
        return repeatStatement(stmt, out);
    case StmtKind::Exit:
    case StmtKind::Continue:
        if (loops.empty()) {
            emit(stmt.range, findings::OutsideLoop(Verbatim(stmt.kind == StmtKind::Exit ? "EXIT" : "CONTINUE")));
            return;
        }
        if (stmt.kind == StmtKind::Exit) {
            loops.back().hasExit = true;
            loops.back().resultSetAtExit = loops.back().resultSetAtExit && flow.isResultSet;
        }
        out.push_back(
            newStmt(stmt.kind == StmtKind::Exit ? tree::StmtKind::Exit : tree::StmtKind::Continue, stmt.range));
        flow.isReachable = false;
        return;
    case StmtKind::Return:
        return returnStatement(stmt, out);
    case StmtKind::Label:
        return labelStatement(stmt, out);
    case StmtKind::Jump:
        return jumpStatement(stmt, out);
    case StmtKind::Block: {
        tree::Stmt* made = newStmt(tree::StmtKind::Block, stmt.range);
        statements(stmt.body, made->body);
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
        if (isTest) return testStatement(stmt, out);
        static constexpr const char* kWords[] = {"RUN", "ASSERT", "FORCE", "RELEASE", "COMPARE", "POWER_OFF"};
        emit(stmt.range, findings::TestUnknownStatement(
                             Verbatim(kWords[static_cast<int>(stmt.kind) - static_cast<int>(StmtKind::Run)])));
        return;
    }
    }
}

/// Where a value goes: a place or a property. Reports what can not be written.
///   ok:    x := 5;      wrong: t.Q := TRUE;  (P2005)      advice: FOR i := 1 TO 5 DO i := i + 1; END_FOR  (P3021)
Denoted Checker::target(const syntax::Expr& e, TypeId* type) {
    Denoted denoted = denote(e, Access::Write);
    switch (denoted.kind) {
    case Denoted::Kind::Nothing:
        return denoted;
    case Denoted::Kind::Place: {
        if (denoted.isReadOnly) {
            emit(e.range, findings::NotAssignable(denoted.whyReadOnly));
            return {};
        }
        const tree::Place* root = rootOf(denoted.place);
        if (root->kind == tree::PlaceKind::Temporary) {
            emit(e.range, findings::NotAssignable(textOf(e.range)));
            return {};
        }
        if (root->kind == tree::PlaceKind::Absolute && scope.unit && scope.unit->self() &&
            scope.unit->self()->kind == UnitKind::Program && !scope.unit->self()->isSimulation && !isExpression) {
            const image::AreaRange inputs = world.areaOf(image::Area::Input);
            if (root->offset >= inputs.begin && root->offset < inputs.begin + inputs.size) {
                auto& diagnostic = emit(e.range, findings::NotAssignable(phrases::InputAddress(textOf(e.range))));
                diagnostic.severity = diagnostics::Severity::Warning;
            }
        }
        if (world.options.strict && denoted.variable && denoted.variable->kind == syntax::SectionKind::Input &&
            scope.unit && denoted.variable->owner == scope.unit)
            emit(e.range, findings::NotAssignable(phrases::Input(denoted.variable->name))).severity =
                diagnostics::Severity::Warning;
        for (const Variable* variable : loopVariables)
            if (variable == denoted.variable && denoted.place->type == variable->type)
                emit(e.range, findings::LoopVariableWritten(variable->name));
        if (type) *type = denoted.place->type;
        return denoted;
    }
    case Denoted::Kind::Property:
        if (!denoted.property->set) {
            emit(e.range, findings::NotAssignable(phrases::PropertyWithoutSet(denoted.property->name)));
            return {};
        }
        if (type) *type = world.typeOf(denoted.property->set->variables.front());
        return denoted;
    default:
        emit(e.range, findings::NotAssignable(textOf(e.range)));
        return {};
    }
}

void Checker::assignTo(const Denoted& target, Operand value, SourceRange range, std::vector<tree::Stmt*>& out,
                       bool isHidden) {
    if (target.kind == Denoted::Kind::Nothing || value.isUnknown()) return;
    if (target.kind == Denoted::Kind::Property) {
        Unit& set = *target.property->set;
        world.completeUnit(set, range);
        checkAccess(set.access, target.property->owner, target.property->name, value.expr->range);
        const Operand fitting = converted(value, world.typeOf(set.variables.front()));
        if (fitting.isUnknown()) return;
        tree::Expr* e = arena.make<tree::Expr>();
        e->kind = tree::ExprKind::Call;
        e->type = elementary(TypeKind::Void);
        e->range = range.file.isValid() ? range : value.expr->range;
        e->call = arena.make<tree::Call>();
        Denoted callee = target;
        callee.kind = Denoted::Kind::Unit;
        callee.unit = &set;
        prepareCall(*e->call, callee, e->range);
        tree::CallArgument argument;
        argument.local = set.variables.front().local;
        argument.value = fitting.expr;
        e->call->arguments.push_back(argument);
        tree::Stmt* evaluate = newStmt(tree::StmtKind::Evaluate, range);
        evaluate->a = e;
        out.push_back(evaluate);
        return;
    }
    const Operand fitting = converted(value, target.place->type);
    if (fitting.isUnknown()) return;
    tree::Stmt* made = assignStmt(target.place, fitting.expr, range);
    made->isHidden = made->isHidden || isHidden;
    out.push_back(made);
}

/// A REFERENCE TO gets its variable.
void Checker::bindReference(tree::Place* raw, const syntax::Expr& value, SourceRange range,
                            std::vector<tree::Stmt*>& out) {
    const TypeId type = raw->type;
    const TypeId element = types[type].element;
    const Denoted denoted = denote(value, Access::Address);
    if (denoted.kind == Denoted::Kind::Nothing) return;
    Operand source;
    if (denoted.kind == Denoted::Kind::Place) {
        const TypeId given = denoted.place->type;
        const bool fitsElement =
            world.sameType(given, element) || (isKind(given, TypeKind::Block) && types.isDerivedFrom(given, element));
        if (!fitsElement && (isKind(given, TypeKind::Pointer) && world.sameType(types[given].element, element)))
            source = sameBits(load(denoted.place, value.range), type);
        else if (!fitsElement)
            return mismatch(value.range, given, type);
        else
            source = addressOf(denoted.place, type, value.range);
    } else {
        const Operand other = this->value(denoted, value, type);
        if (other.isUnknown()) return;
        source = converted(other, type);
    }
    if (!source.isUnknown()) out.push_back(assignStmt(raw, source.expr, range));
}

///   ok:    p REF= x;  with p : REFERENCE TO INT      wrong: x REF= y;  with x : INT (P2020)
void Checker::assignReference(const Denoted& target, const syntax::Expr& value, SourceRange range,
                              std::vector<tree::Stmt*>& out) {
    tree::Place* place = target.place;
    if (place && place->kind == tree::PlaceKind::Deref && place->pointer &&
        place->pointer->kind == tree::ExprKind::Load && isKind(place->pointer->type, TypeKind::Reference))
        return bindReference(place->pointer->place, value, range, out);
    if (place && isKind(place->type, TypeKind::Pointer)) { // REF= on a pointer: its address
        const Denoted source = denote(value, Access::Address);
        if (source.kind != Denoted::Kind::Place) return;
        const Operand address =
            converted(addressOf(source.place, types.pointer(source.place->type), value.range), place->type);
        if (!address.isUnknown()) out.push_back(assignStmt(place, address.expr, range));
        return;
    }
    if (place) emit(place->range, findings::NotAPointer(textOf(place->range)));
}

void Checker::assignAggregate(tree::Place* place, const syntax::Expr& value, SourceRange range,
                              std::vector<tree::Stmt*>& out) {
    // constants at once, the rest element by element
    if (!fitsIntoCode(place->type, value.range)) return;
    InitialValue initial;
    initial.bytes = types[place->type].initial;
    initial.bytes.resize(types[place->type].size);
    world.initialise(initial, place->type, 0, -1, &value, scope, nullptr);
    const Operand whole = constant(types::readValue(types, place->type, initial.bytes), value.range);
    out.push_back(assignStmt(place, whole.expr, range));
    for (const DynamicInit& dynamic : initial.dynamics) {
        if (!dynamic.value) continue;
        Operand part = converted(expression(*dynamic.value, dynamic.type), dynamic.type);
        if (!part.isUnknown())
            out.push_back(assignStmt(fieldPlace(place, dynamic.offset, dynamic.type, dynamic.bit, dynamic.value->range),
                                     part.expr, {}));
    }
}

/// What a step names with a qualifier is an ACTION or a BOOL variable (2.6.4.1). A reset of the chart says nothing
/// again.
///   wrong: STEP s: missing(N); END_STEP  (P4010)
bool Checker::isAssociable(const syntax::Stmt& stmt) {
    const syntax::Expr& name = *stmt.target;
    if (!name.name.isValid()) return true;
    const World::Found found = world.lookup(scope, world.key(name.name.text));
    Variable* variable = found.member.variable ? found.member.variable : found.entity.variable;
    const TypeId type = variable ? world.typeOf(*variable) : TypeId();
    if (variable ? isKind(type, TypeKind::Unknown) || types.storageKind(type) == TypeKind::Bool
                 : found.member.property != nullptr || !found.ambiguous.empty())
        return true;
    if (stmt.value->kind == syntax::ExprKind::Literal) return false;
    std::vector<std::string> candidates;
    for (Unit* unit = scope.unit ? scope.unit->self() : nullptr; unit; unit = unit->base) {
        for (const Unit* action : unit->actions) candidates.push_back(action->name);
        for (Variable& own : unit->variables)
            if (!own.name.starts_with("__") && types.storageKind(world.typeOf(own)) == TypeKind::Bool)
                candidates.push_back(own.name);
    }
    world.suggest(emit(name.range, findings::UnknownAction(name.name.text)), name.range, name.name.text, candidates);
    return false;
}

void Checker::assignment(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.target || !stmt.value) return;
    const syntax::Expr& value = *stmt.value;
    if (stmt.op == TokenKind::RefAssign) {
        const Denoted denoted = denote(*stmt.target, Access::Write);
        if (denoted.kind == Denoted::Kind::Place)
            assignReference(denoted, value, stmt.range, out);
        else if (denoted.kind != Denoted::Kind::Nothing)
            emit(stmt.target->range, findings::NotAPointer(textOf(stmt.target->range)));
        return;
    }
    if (value.kind == syntax::ExprKind::ArrayInit || value.kind == syntax::ExprKind::StructInit) {
        const Denoted to = target(*stmt.target);
        if (to.kind == Denoted::Kind::Place && types.isAggregate(to.place->type))
            return assignAggregate(to.place, value, stmt.range, out);
        if (to.kind == Denoted::Kind::Place) expression(value, to.place->type);
        return;
    }
    if (stmt.isAssociation) {
        const bool isCall = !stmt.branches.empty(); // what runs where the name is an action of a base
        if (stmt.target->name.isValid())
            if (const Unit* unit = world.lookup(scope, world.key(stmt.target->name.text)).member.unit;
                unit && unit->kind == UnitKind::Action) {
                if (isCall) statements(stmt.branches[0].body, out);
                return;
            }
        if (isCall || !isAssociable(stmt)) return;
    }
    TypeId type;
    // the target's type is known before the value, but its effects count after it
    const Flow before = flow;
    const Denoted to = target(*stmt.target, &type);
    const Flow after = flow;
    flow = before;
    if (stmt.op == TokenKind::SetAssign || stmt.op == TokenKind::ResetAssign) {
        tree::Expr* when = condition(value);
        flow = after;
        if (to.kind == Denoted::Kind::Nothing || isKind(when->type, TypeKind::Unknown)) return;
        if (types.storageKind(type) != TypeKind::Bool)
            return mismatch(stmt.target->range, type, elementary(TypeKind::Bool));
        tree::Stmt* choice = newStmt(tree::StmtKind::If, stmt.range);
        choice->a = when;
        assignTo(to, constant({elementary(TypeKind::Bool), int64_t(stmt.op == TokenKind::SetAssign)}, stmt.range), {},
                 choice->body, true);
        out.push_back(choice);
        return;
    }
    if (stmt.op == TokenKind::TryAssign) {
        Operand from = expression(value);
        flow = after;
        if (to.kind != Denoted::Kind::Place || from.isUnknown()) return;
        const bool goodTarget = isKind(type, TypeKind::Interface) || isKind(type, TypeKind::Pointer);
        if (isKind(from.type(), TypeKind::Block) && from.expr->kind == tree::ExprKind::Load)
            from = addressOf(from.expr->place, types.pointer(from.type()), value.range);
        if (!goodTarget || (!isKind(from.type(), TypeKind::Interface) && !isKind(from.type(), TypeKind::Pointer)))
            return mismatch(value.range, from.type(), type);
        tree::Expr* cast = arena.make<tree::Expr>();
        cast->kind = tree::ExprKind::TryCast;
        cast->type = type;
        cast->range = value.range;
        cast->a = from.expr;
        out.push_back(assignStmt(to.place, cast, stmt.range));
        return;
    }
    const Operand from = expression(value, type);
    flow = after;
    if (to.kind == Denoted::Kind::Place && isKind(to.place->type, TypeKind::OpenArray)) {
        emit(stmt.target->range, findings::NotAssignable(textOf(stmt.target->range)));
        return;
    }
    assignTo(to, from, stmt.range, out);
}

void Checker::ifStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const Flow before = flow;
    Flow joined{false, true};
    bool hasElse = false;
    std::vector<tree::Stmt*>* into = &out;
    for (const syntax::IfBranch& branch : stmt.branches) {
        flow = before;
        if (!branch.condition) {
            hasElse = true;
            statements(branch.body, *into);
        } else {
            const SourceRange range =
                into == &out
                    ? (stmt.range.file.isValid() ? SourceRange{stmt.range.file, stmt.range.begin,
                                                               std::max(stmt.range.begin, branch.condition->range.end)}
                                                 : stmt.range)
                    : branch.condition->range;
            tree::Stmt* choice = newStmt(tree::StmtKind::If, range);
            choice->a = condition(*branch.condition);
            statements(branch.body, choice->body);
            into->push_back(choice);
            into = &choice->elseBody;
        }
        if (flow.isReachable) joined.isResultSet = joined.isResultSet && flow.isResultSet;
        joined.isReachable = joined.isReachable || flow.isReachable;
    }
    if (!hasElse) {
        joined.isResultSet = (joined.isReachable ? joined.isResultSet : true) && before.isResultSet;
        joined.isReachable = joined.isReachable || before.isReachable;
    }
    flow = joined;
    if (!before.isReachable) flow.isReachable = false;
}

/// FOR (edition 3, 7.3.3.4.2): the variable and its bounds are integers; they are computed once.
///   ok:    FOR i := 1 TO 10 BY 2 DO … END_FOR      wrong: FOR r := 1.0 TO 2.0 DO … END_FOR  (P2006)
///   advice: FOR i := 1 TO 10 BY 0 DO … END_FOR  (P3033)   FOR i := 5 TO 1 DO … END_FOR  (P3007)
void Checker::forStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.target) return;
    const Denoted variable = target(*stmt.target);
    if (variable.kind == Denoted::Kind::Place && variable.variable) ++variable.variable->reads;
    TypeId type = variable.kind == Denoted::Kind::Place ? variable.place->type : elementary(TypeKind::Unknown);
    if (variable.kind == Denoted::Kind::Property)
        emit(stmt.target->range, findings::NotAssignable(textOf(stmt.target->range)));
    const bool known = !isKind(type, TypeKind::Unknown);
    if (known && !types::isInteger(types.family(type))) {
        emit(stmt.target->range, findings::OperatorNotForType(Verbatim("FOR"), nameOf(type)));
        type = elementary(TypeKind::Unknown);
    }
    const bool good = !isKind(type, TypeKind::Unknown);
    const TypeId storage = good ? types.storage(type) : type;
    Operand from = stmt.from ? expression(*stmt.from, storage) : unknown(stmt.range);
    Operand to = stmt.to ? expression(*stmt.to, storage) : unknown(stmt.range);
    Operand by = stmt.by ? expression(*stmt.by) : constant({elementary(TypeKind::Lint), int64_t(1)}, stmt.range, true);
    const bool stepNegative =
        good && by.isConstant() && std::holds_alternative<int64_t>(by.expr->value.data) && by.expr->value.integer() < 0;
    const bool isSigned = good && types.family(storage) == types::Family::Signed;
    // counted in the variable's type; downwards or beyond an unsigned or narrow type in a wider signed one
    TypeId counted = storage;
    const unsigned width = good ? types::bitsOf(types.storageKind(storage)) : 0;
    const bool variableStep =
        good && !by.isUnknown() && !by.isConstant() && !isSigned && types.family(by.type()) == types::Family::Signed;
    if (good && !isSigned && (stepNegative || variableStep))
        counted = elementary(width == 8 ? TypeKind::Int : width == 16 ? TypeKind::Dint : TypeKind::Lint);
    const auto limit = [&](Operand operand, TypeId wanted) {
        if (!good || operand.isUnknown()) return operand;
        if (!isNumeric(operand.type())) return converted(operand, wanted);
        if (operand.isConstant() && !fits(operand.expr->value, storage) &&
            std::holds_alternative<int64_t>(operand.expr->value.data) && wanted == storage)
            return converted(operand, wanted); // its message
        // a limit of a wider type is compared as it is
        return operand.isFlexible || operand.isConstant() ? converted(operand, wanted) : converted(operand, wanted);
    };
    if (by.isConstant() && std::holds_alternative<int64_t>(by.expr->value.data) && by.expr->value.integer() == 0)
        emit(by.expr->range, findings::EndlessLoop());
    from = limit(from, counted);
    to = limit(to, counted);
    by = good ? converted(by, counted) : by;
    tree::Stmt* made = newStmt(tree::StmtKind::For,
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
    const Flow before = flow;
    loops.push_back({});
    if (variable.variable) loopVariables.push_back(variable.variable);
    statements(stmt.body, made->body);
    if (variable.variable) loopVariables.pop_back();
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
        emit(joined(stmt.from->range, stmt.to->range), findings::UnreachableCode()); // FOR i := 5 TO 1
    const bool setInside = flow.isResultSet && (!loops.back().hasExit || loops.back().resultSetAtExit);
    loops.pop_back();
    flow.isReachable = before.isReachable;
    flow.isResultSet = before.isResultSet || (runs && setInside);
    if (good && !from.isUnknown() && !to.isUnknown() && !by.isUnknown()) out.push_back(made);
}

///   advice: WHILE TRUE DO x := 1; END_WHILE  (P3033)
void Checker::whileStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    tree::Stmt* made =
        newStmt(tree::StmtKind::While,
                stmt.range.file.isValid() && stmt.value
                    ? SourceRange{stmt.range.file, stmt.range.begin, std::max(stmt.range.begin, stmt.value->range.end)}
                    : stmt.range);
    if (stmt.value) made->a = condition(*stmt.value);
    const Flow before = flow;
    loops.push_back({});
    statements(stmt.body, made->body);
    const Loop loop = loops.back();
    loops.pop_back();
    const bool endless = made->a && made->a->kind == tree::ExprKind::Constant && made->a->value.isTrue();
    flow = before;
    if (endless && !loop.hasExit && !loop.isLeft && before.isReachable) {
        emit(stmt.value->range, findings::EndlessLoop());
    } else if (endless) {
        flow.isReachable = before.isReachable && loop.hasExit;
        flow.isResultSet = before.isResultSet || loop.resultSetAtExit;
    }
    if (made->a) out.push_back(made);
}

///   advice: REPEAT x := 1; UNTIL FALSE END_REPEAT  (P3033)
void Checker::repeatStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    tree::Stmt* made =
        newStmt(tree::StmtKind::Repeat, stmt.range.file.isValid() && stmt.value ? stmt.value->range : stmt.range);
    const Flow before = flow;
    loops.push_back({});
    statements(stmt.body, made->body);
    const Loop loop = loops.back();
    loops.pop_back();
    const bool set = flow.isResultSet && (!loop.hasExit || loop.resultSetAtExit);
    if (stmt.value) made->a = condition(*stmt.value);
    if (made->a && made->a->kind == tree::ExprKind::Constant && made->a->value.hasValue() && !made->a->value.isTrue() &&
        !loop.hasExit && !loop.isLeft && flow.isReachable)
        emit(stmt.value->range, findings::EndlessLoop());
    flow.isReachable = before.isReachable && (flow.isReachable || loop.hasExit || before.isReachable);
    flow.isResultSet = before.isResultSet || set;
    if (made->a) out.push_back(made);
}

void Checker::returnStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    for (Loop& loop : loops) loop.isLeft = true;
    if (stmt.value) {
        Unit* unit = scope.unit;
        if (!unit || !unit->resultVariable) {
            expression(*stmt.value);
            emit(stmt.value->range, findings::NotAllowedHere(phrases::ReturnWithValue(),
                                                             unit ? phrases::In(unit->name) : phrases::Here()));
            return;
        }
        Variable& result = *unit->resultVariable;
        const Operand value = converted(expression(*stmt.value, result.type), result.type);
        if (!value.isUnknown())
            out.push_back(assignStmt(localPlace(result.local, result.type, stmt.value->range), value.expr, stmt.range));
        flow.isResultSet = true;
    }
    if (flow.isReachable) returnsSet = returnsSet && flow.isResultSet;
    tree::Stmt* made = newStmt(tree::StmtKind::Return, stmt.range);
    if (stmt.value) made->isHidden = true;
    out.push_back(made);
    flow.isReachable = false;
}

void Checker::declareLabels(const syntax::Block& block) {
    for (const syntax::Stmt* stmt : block) {
        if (stmt->kind == StmtKind::Label && stmt->name.isValid()) {
            Label label;
            label.id = tree::LabelId(function->labelCount++);
            label.range = stmt->name.range;
            const NameId id = world.key(stmt->name.text);
            if (labels.count(id))
                emit(stmt->name.range, findings::DuplicateName(stmt->name.text));
            else {
                label.symbol = world.addSymbol(SymbolKind::Label, stmt->name.text,
                                               scope.unit ? scope.unit->qualified : std::string(), stmt->name.range);
                labels.emplace(id, label);
            }
        }
        declareLabels(stmt->body);
        declareLabels(stmt->elseBody);
        for (const syntax::IfBranch& branch : stmt->branches) declareLabels(branch.body);
        for (const syntax::CaseArm& arm : stmt->arms) declareLabels(arm.body);
    }
}

void Checker::labelStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const auto it = labels.find(world.key(stmt.name.text));
    if (it == labels.end()) return;
    tree::Stmt* made = newStmt(tree::StmtKind::Label, {});
    made->label = it->second.id;
    out.push_back(made);
    flow.isReachable = true;
}

///   ok:    JMP here; … here: x := 2;      wrong: JMP there;  (P3019)
void Checker::jumpStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    for (Loop& loop : loops) loop.isLeft = true;
    const auto it = labels.find(world.key(stmt.name.text));
    tree::Expr* when = stmt.value ? condition(*stmt.value) : nullptr;
    if (it == labels.end()) {
        std::vector<std::string> candidates;
        for (const auto& [id, label] : labels) candidates.emplace_back(world.textOf(label.range));
        world.suggest(emit(stmt.name.range, findings::UnknownLabel(stmt.name.text)), stmt.name.range, stmt.name.text,
                      candidates);
        return;
    }
    it->second.isUsed = true;
    refer(stmt.name.range, it->second.symbol, Access::Read);
    tree::Stmt* made = newStmt(tree::StmtKind::Jump, stmt.range);
    made->label = it->second.id;
    made->a = when;
    out.push_back(made);
    if (!when) flow.isReachable = false;
}

} // namespace plc::sema
