// Assignments: where a value may go, and what :=, REF=, S=, R= and ?= make of it.
#include "runtime/compiler/sema/statements/statements.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/layout.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

namespace plc::sema {

using lex::TokenKind;

///   advice: limit := 5;  with VAR_INPUT CONSTANT limit (P2048)
void tellConstantInput(Context& context, const Denoted& denoted, const syntax::Expr& e) {
    const Variable* variable = denoted.variable;
    if (!variable || variable->kind != syntax::SectionKind::Input || !variable->section || !variable->section->constant)
        return;
    const syntax::Expr* root = &e;
    while (root->base && root->kind != syntax::ExprKind::Call) root = root->base;
    // axis.limit is written from outside, where an input takes its value.
    if (root->kind == syntax::ExprKind::NameRef && equalsIgnoringCase(root->name.text, variable->name))
        context.emit(e.range, findings::ConstantInputWritten(variable->name));
}

/// A place that may be written, with its advice: a program writes an input, a loop its variable.
static Denoted placeTarget(Context& context, const syntax::Expr& e, Denoted denoted) {
    // The root decides what may be written: a field of F() is in a temporary, whatever its own type says.
    const tree::Place* root = rootOf(denoted.place);
    if (denoted.isReadOnly || root->kind == tree::PlaceKind::Temporary) {
        context.emit(e.range, denoted.isReadOnly ? findings::NotAssignable(denoted.whyReadOnly)
                                                 : findings::NotAssignable(context.textOf(e.range)));
        return {};
    }
    tellConstantInput(context, denoted, e);
    const Unit* self = context.scope.unit ? context.scope.unit->self() : nullptr;
    // A warning: writing an input lasts until the next scan reads the devices. Simulations do it on purpose.
    if (root->kind == tree::PlaceKind::Absolute && self && self->kind == UnitKind::Program && !self->isSimulation &&
        !context.isExpression) {
        const image::AreaRange inputs = areaOf(context.world, image::Area::Input);
        if (root->offset >= inputs.begin && root->offset < inputs.begin + inputs.size)
            context.emit(e.range, findings::NotAssignable(phrases::InputAddress(context.textOf(e.range)))).severity =
                diagnostics::Severity::Warning;
    }
    // The standard forbids a unit to write its own inputs (2.4.3); many programs do it to normalise them.
    if (context.world.options.strict && denoted.variable && denoted.variable->kind == syntax::SectionKind::Input &&
        context.scope.unit && denoted.variable->owner == context.scope.unit)
        context.emit(e.range, findings::NotAssignable(phrases::Input(denoted.variable->name))).severity =
            diagnostics::Severity::Warning;
    // Only the variable itself: a[i] with a counting array element as loop variable may be another element.
    for (const Variable* variable : context.loopVariables)
        if (variable == denoted.variable && denoted.place->type == variable->type)
            context.emit(e.range, findings::LoopVariableWritten(variable->name));
    return denoted;
}

/// The variable that a property without SET refers to, when it is a REFERENCE TO; else null.
static tree::Place* behindProperty(Context& context, const Denoted& denoted, SourceRange range) {
    const Property& property = *denoted.property;
    if (property.set || !property.get || !property.get->resultVariable) return nullptr;
    if (!context.isKind(typeOf(context, *property.get->resultVariable), TypeKind::Reference)) return nullptr;
    const Operand reference = propertyValue(context, denoted, range);
    if (reference.isUnknown()) return nullptr;
    return referredBy(context, reference, range);
}

/// Where a value goes: a place or a property. Reports what cannot be written.
///   ok:    x := 5;      wrong: t.Q := TRUE;  (P2005)      advice: FOR i := 1 TO 5 DO i := i + 1; END_FOR  (P3021)
Denoted target(Context& context, const syntax::Expr& e, TypeId* type) {
    // Access::Write counts a write and no read, so that a variable that is only written is found.
    Denoted denoted = denote(context, e, Access::Write);
    switch (denoted.kind) {
    case Denoted::Kind::Nothing:
        return denoted;
    case Denoted::Kind::Place:
        denoted = placeTarget(context, e, denoted);
        if (type && denoted.place) *type = denoted.place->type;
        return denoted;
    case Denoted::Kind::Property:
        if (tree::Place* behind = behindProperty(context, denoted, e.range)) {
            if (type) *type = behind->type;
            return placeOf(behind);
        }
        if (!denoted.property->set) {
            context.emit(e.range, findings::NotAssignable(phrases::PropertyWithoutSet(denoted.property->name)));
            return {};
        }
        // SET's only variable in front is the value that is assigned (declareMembers).
        if (type) *type = typeOf(context, denoted.property->set->variables.front());
        return denoted;
    default:
        context.emit(e.range, findings::NotAssignable(context.textOf(e.range)));
        return {};
    }
}

/// Calls SET of a property.
static void assignProperty(Context& context, const Denoted& target, Operand value, SourceRange range,
                           std::vector<tree::Stmt*>& out) {
    Unit& set = *target.property->set;
    // Accessors are completed when they are first used, as all units are.
    completeUnit(context, set, range);
    checkAccess(context, set.access, target.property->owner, target.property->name, value.expr->range);
    const Operand fitting = converted(context, value, typeOf(context, set.variables.front()));
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
}

void assignTo(Context& context, const Denoted& target, Operand value, SourceRange range, std::vector<tree::Stmt*>& out,
              bool isHidden) {
    if (target.kind == Denoted::Kind::Nothing || value.isUnknown()) return;
    if (target.kind == Denoted::Kind::Property) return assignProperty(context, target, value, range, out);
    const Operand fitting = converted(context, value, target.place->type);
    if (fitting.isUnknown()) return;
    tree::Stmt* made = assignStmt(context, target.place, fitting.expr, range);
    // Hidden: the debugger does not stop at what belongs to another statement.
    made->isHidden = made->isHidden || isHidden;
    out.push_back(made);
}

/// What a reference of that type is given with REF=.
static Operand referenceTo(Context& context, TypeId type, const syntax::Expr& value) {
    const TypeId element = context.types[type].element;
    // Whoever has the address may read and write: it counts as both.
    const Denoted denoted = denote(context, value, Access::Address);
    if (denoted.kind == Denoted::Kind::Nothing) return unknown(context, value.range);
    if (denoted.kind != Denoted::Kind::Place) {
        const Operand other = sema::value(context, denoted, value, type);
        return other.isUnknown() ? other : converted(context, other, type);
    }
    // What fits: the same type, a block or structure derived from it, or a pointer to it, whose address is taken over.
    const TypeId given = denoted.place->type;
    const bool isExtendable = context.isKind(given, TypeKind::Block) || context.isKind(given, TypeKind::Struct);
    const bool fitsElement =
        sameType(context.world, given, element) || (isExtendable && context.types.isDerivedFrom(given, element));
    if (!fitsElement && context.isKind(given, TypeKind::Pointer) &&
        sameType(context.world, context.types[given].element, element))
        return sameBits(context, load(context, denoted.place, value.range), type);
    if (!fitsElement) {
        mismatch(context, value.range, given, type);
        return unknown(context, value.range);
    }
    // A reference to what a reference refers to is a copy of it. Following it first would fault where it refers to
    // nothing.
    if (denoted.place->kind == tree::PlaceKind::Deref &&
        context.isKind(denoted.place->pointer->type, TypeKind::Reference))
        return sameBits(context, {denoted.place->pointer, &context.types}, type);
    return addressOf(context, denoted.place, type, value.range);
}

/// A REFERENCE TO gets its variable.
void bindReference(Context& context, tree::Place* raw, const syntax::Expr& value, SourceRange range,
                   std::vector<tree::Stmt*>& out) {
    const Operand source = referenceTo(context, raw->type, value);
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
    if (place && !context.isKind(place->type, TypeKind::Unknown))
        context.emit(place->range, findings::NotAPointer(context.textOf(place->range)));
}

void assignAggregate(Context& context, tree::Place* place, const syntax::Expr& value, SourceRange range,
                     std::vector<tree::Stmt*>& out) {
    // constants at once, the rest element by element
    if (!fitsIntoCode(context, place->type, value.range)) return;
    // As for a declaration: the same rules for lists, and bytes at once for what is constant. Members that are not
    // named get the type's initial value.
    InitialValue initial;
    initial.bytes = context.types[place->type].initial;
    initial.bytes.resize(context.types[place->type].size);
    initialise(context, initial, place->type, 0, -1, &value, context.scope, nullptr);
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
    const TypeId type = variable ? typeOf(context, *variable) : TypeId();
    if (variable ? context.isKind(type, TypeKind::Unknown) || context.types.storageKind(type) == TypeKind::Bool
                 : found.member.property != nullptr || !found.ambiguous.empty())
        return true;
    // The lowering resets associations with a literal FALSE; the mistake was said at the association itself.
    if (stmt.value->kind == syntax::ExprKind::Literal) return false;
    std::vector<std::string> candidates;
    for (Unit* unit = context.scope.unit ? context.scope.unit->self() : nullptr; unit; unit = unit->base) {
        for (const Unit* action : unit->actions) candidates.push_back(action->name);
        for (Variable& own : unit->variables)
            if (!own.name.starts_with("__") && context.types.storageKind(typeOf(context, own)) == TypeKind::Bool)
                candidates.push_back(own.name);
    }
    suggest(context, context.emit(name.range, findings::UnknownAction(name.name.text)), name.range, name.name.text,
            candidates);
    return false;
}

/// p REF= x
static void referenceStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const Denoted denoted = denote(context, *stmt.target, Access::Write);
    if (denoted.kind == Denoted::Kind::Place) return assignReference(context, denoted, *stmt.value, stmt.range, out);
    if (denoted.kind == Denoted::Kind::Property && denoted.property->set) { // SET takes the reference
        const TypeId type = typeOf(context, denoted.property->set->variables.front());
        if (context.isKind(type, TypeKind::Reference)) {
            const Operand source = referenceTo(context, type, *stmt.value);
            if (!source.isUnknown()) assignProperty(context, denoted, source, stmt.range, out);
            return;
        }
        if (context.isKind(type, TypeKind::Unknown)) return; // the declaration has its message
    }
    if (denoted.kind != Denoted::Kind::Nothing)
        context.emit(stmt.target->range, findings::NotAPointer(context.textOf(stmt.target->range)));
}

/// What a step associates with a qualifier: an action is called, anything else assigned. True: there is no more to do.
static bool associationStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    // What the lowering of charts could not know is decided here: whether the name is an action of a base or a
    // variable.
    const bool isCall = !stmt.branches.empty(); // what runs where the name is an action of a base
    if (stmt.target->name.isValid())
        if (const Unit* unit = lookup(context.world, context.scope, context.key(stmt.target->name.text)).member.unit;
            unit && unit->kind == UnitKind::Action) {
            if (isCall) statements(context, stmt.branches[0].body, out);
            return true;
        }
    return isCall || !isAssociable(context, stmt);
}

/// x S= condition; x R= condition
static void setOrReset(Context& context, const syntax::Stmt& stmt, const Denoted& to, TypeId type, const Flow& after,
                       std::vector<tree::Stmt*>& out) {
    const TypeId boolean = context.elementary(TypeKind::Bool);
    // x S= c is IF c THEN x := TRUE: x keeps its value otherwise and is thus no plain assignment.
    tree::Expr* when = condition(context, *stmt.value);
    context.flow = after;
    if (to.kind == Denoted::Kind::Nothing || context.isKind(when->type, TypeKind::Unknown)) return;
    if (context.types.storageKind(type) != TypeKind::Bool) return mismatch(context, stmt.target->range, type, boolean);
    tree::Stmt* choice = newStmt(context, tree::StmtKind::If, stmt.range);
    choice->a = when;
    assignTo(context, to, constant(context, {boolean, int64_t(stmt.op == TokenKind::SetAssign)}, stmt.range), {},
             choice->body, true);
    out.push_back(choice);
}

/// interface ?= other: NULL when the other's block does not have it.
static void tryAssign(Context& context, const syntax::Stmt& stmt, const Denoted& to, TypeId type, const Flow& after,
                      std::vector<tree::Stmt*>& out) {
    const auto canPoint = [&](TypeId id) {
        return context.isKind(id, TypeKind::Interface) || context.isKind(id, TypeKind::Pointer);
    };
    Operand from = expression(context, *stmt.value);
    context.flow = after;
    if (to.kind != Denoted::Kind::Place || from.isUnknown()) return;
    // Of a block itself its address is asked.
    if (context.isKind(from.type(), TypeKind::Block) && from.expr->kind == tree::ExprKind::Load)
        from = addressOf(context, from.expr->place, context.types.pointer(from.type()), stmt.value->range);
    if (!canPoint(type) || !canPoint(from.type())) return mismatch(context, stmt.value->range, from.type(), type);
    const auto pointsToBlock = [&](TypeId id) {
        return context.isKind(id, TypeKind::Interface) || context.isKind(context.types[id].element, TypeKind::Block);
    };
    if (!pointsToBlock(type) && sameType(context.world, type, from.type())) // known before it runs
        return out.push_back(assignStmt(context, to.place, from.expr, stmt.range));
    tree::Expr* cast = context.arena.make<tree::Expr>();
    cast->kind = tree::ExprKind::TryCast;
    cast->type = type;
    cast->range = stmt.value->range;
    cast->a = from.expr;
    out.push_back(assignStmt(context, to.place, cast, stmt.range));
}

void assignment(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.target || !stmt.value) return;
    const syntax::Expr& value = *stmt.value;
    if (stmt.op == TokenKind::RefAssign) return referenceStatement(context, stmt, out);
    // Lists need to know the type they are for before they are read.
    if (value.kind == syntax::ExprKind::ArrayInit || value.kind == syntax::ExprKind::StructInit) {
        const Denoted to = target(context, *stmt.target);
        if (to.kind == Denoted::Kind::Place && context.types.isAggregate(to.place->type))
            return assignAggregate(context, to.place, value, stmt.range, out);
        if (to.kind == Denoted::Kind::Place) expression(context, value, to.place->type);
        return;
    }
    if (stmt.isAssociation && associationStatement(context, stmt, out)) return;
    TypeId type;
    // the target's type is known before the value, but its effects count after it
    const Flow before = context.flow;
    const Denoted to = target(context, *stmt.target, &type);
    const Flow after = context.flow;
    context.flow = before;
    if (stmt.op == TokenKind::SetAssign || stmt.op == TokenKind::ResetAssign)
        return setOrReset(context, stmt, to, type, after, out);
    if (stmt.op == TokenKind::TryAssign) return tryAssign(context, stmt, to, type, after, out);
    const Operand from = expression(context, value, type);
    context.flow = after;
    if (to.kind == Denoted::Kind::Place && context.isKind(to.place->type, TypeKind::OpenArray)) {
        context.emit(stmt.target->range, findings::NotAssignable(context.textOf(stmt.target->range)));
        return;
    }
    assignTo(context, to, from, stmt.range, out);
}

} // namespace plc::sema
