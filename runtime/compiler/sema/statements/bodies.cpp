// The bodies of all units: prologue (initial values of locals, edges of inputs), statements, end-of-body checks.
#include "runtime/compiler/sema/statements/bodies.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

namespace plc::sema {

using library::BinaryOp;

// In the order of declaration, which a kept record relies on: its uses are numbers.
void numberVariables(WorldBuilder& world) {
    const auto number = [&](Variable& variable) {
        variable.number = static_cast<uint32_t>(world.numbered.size());
        world.numbered.push_back(&variable);
    };
    for (Variable& variable : world.globals) number(variable);
    for (Unit& unit : world.units)
        for (Variable& variable : unit.variables) number(variable);
}

void noteUses(WorldBuilder& world, const std::vector<VariableUse>& uses) {
    for (const VariableUse& use : uses) {
        // Variables that the body's own check made (temporaries) have no number.
        if (use.variable >= world.numbered.size()) continue;
        Variable& variable = *world.numbered[use.variable];
        variable.reads += use.isRead;
        variable.writes += use.isWrite;
    }
}

size_t checkBodies(WorldBuilder& world) {
    numberVariables(world);
    size_t checked = 0;
    for (Unit& unit : world.units) {
        if (!beginBody(world, unit)) continue;
        world.uses.clear();
        checkBody({world, world}, unit, world.arena);
        noteUses(world, world.uses);
        ++checked;
    }
    return checked;
}

// What is true of a function before its body is looked at, so that calls from bodies before it find it.
bool beginBody(Gathered& gathered, const Unit& unit) {
    if (!unit.isCode()) return false;
    tree::Function& function = gathered.functions[unit.function.index()];
    const syntax::Body* body = unit.action ? &unit.action->body : &unit.pou->body;
    if (const Unit* self = unit.self()) function.instanceType = self->type;
    // An abstract block still has a body that SUPER^() may call; an abstract method has none.
    function.isAbstract = unit.isAbstract && unit.kind != UnitKind::Block;
    if (unit.owner && unit.owner->kind == UnitKind::Interface) return false;
    // A body behind ABSTRACT is checked, although nobody calls it.
    return !function.isAbstract || !body->statements.empty();
}

namespace {

/// before := CLK; edge := CLK AND NOT before — for each R_EDGE or F_EDGE input of a block.
void emitEdges(Context& checker, Unit& unit, std::vector<tree::Stmt*>& out) {
    const TypeId boolean = types::TypeTable::of(TypeKind::Bool);
    // a body that runs its base's leaves the inputs of the base to it
    const bool runsBase =
        unit.base && foldCase(checker.world.textOf(unit.pou->body.range)).find("super") != std::string::npos;
    // In front of the body, so that the input reads as its edge in the whole scan.
    for (Unit* at = &unit; at; at = runsBase ? nullptr : at->base) {
        for (Variable& variable : at->variables) {
            if (variable.edgeOffset == Id<int>::kNone) continue;
            const auto place = [&](uint32_t offset) {
                return fieldPlace(checker, thisPlace(checker, variable.range), offset, boolean, -1, variable.range);
            };
            const auto input = [&] {
                Operand value = load(checker, place(variable.offset), variable.range);
                return variable.declaration->edge == syntax::VarEdge::Rising ? value
                                                                             : inverted(checker, value, variable.range);
            };
            // __before follows __edge in the instance (units.cpp).
            const uint32_t before = variable.edgeOffset + 1;
            const Operand notBefore = inverted(checker, load(checker, place(before), variable.range), variable.range);
            out.push_back(
                assignStmt(checker, place(variable.edgeOffset),
                           makeBinary(checker, BinaryOp::And, boolean, input(), notBefore, variable.range).expr, {}));
            out.push_back(assignStmt(checker, place(before), input().expr, {}));
        }
    }
}

/// Initial values of a function's own locals.
// Scalars have their value in the function's list of locals; what needs code is put in front of the body.
void emitLocals(Context& checker, Unit& unit, std::vector<tree::Stmt*>& out) {
    const types::TypeTable& types = checker.types;
    for (Variable& variable : unit.variables) {
        // Inputs have what the caller gave.
        if (variable.storage != Storage::Local || variable.isInOut() || variable.kind == syntax::SectionKind::Input)
            continue;
        const TypeId type = variable.type;
        const syntax::Expr* initial = variable.declaration ? variable.declaration->initial : nullptr;
        if (types.isAggregate(type)) {
            const syntax::TypeSpec* spec = variable.isResult ? nullptr : variable.spec;
            if (!initial && !hasConstructor(spec) && !needsConstruction(checker.world, type)) continue;
            // A local's initial value is in the code, once; its bytes count against what code may hold.
            if (!fitsIntoCode(checker, type, initial ? initial->range : variable.range)) continue;
            InitialValue value;
            value.bytes = types[type].initial;
            value.bytes.resize(types[type].size);
            initialiseDeclared(checker, value, type, 0, -1, initial, variable.scope, spec);
            if (value.bytes != types[type].initial &&
                std::any_of(value.bytes.begin(), value.bytes.end(), [](std::byte b) { return b != std::byte{}; }))
                checker.function->locals[variable.local].initial =
                    constant(checker, types::readValue(types, type, value.bytes), variable.range).expr;
            if (value.dynamics.empty()) continue;
            // Code for its parts needs an address.
            checker.function->locals[variable.local].isAddressTaken = true;
            emitDynamics(
                checker, value.dynamics,
                [&](const DynamicInit& dynamic) {
                    return fieldPlace(checker, localPlace(checker, variable.local, type, variable.range),
                                      dynamic.offset, dynamic.type, dynamic.bit, variable.range);
                },
                out);
            continue;
        }
        if (!initial) continue;
        if (types.kind(type) == TypeKind::Reference) {
            bindReference(checker, localPlace(checker, variable.local, type, variable.range), *initial, {}, out);
            continue;
        }
        const Operand value = converted(checker, expression(checker, *initial, type), type);
        if (value.isUnknown()) continue;
        // The result begins with its type's value: the declaration of a function has no place for another.
        if (variable.isResult) continue;
        checker.function->locals[variable.local].initial = value.expr;
    }
}

/// By this body, or where something was declared.
bool isRead(const Check& check, const Variable& variable) {
    const auto& uses = check.gathered.uses;
    return variable.reads != 0 || std::any_of(uses.begin(), uses.end(), [&](const VariableUse& use) {
               return use.variable == variable.number && use.isRead;
           });
}

} // namespace

///   ok:    IF a > 0 THEN F := 1; ELSE F := 2; END_IF      advice: IF a > 0 THEN F := 1; END_IF  in FUNCTION F (P3008)
void checkBody(const Check& check, Unit& unit, Arena& arena) {
    tree::Function& function = check.gathered.functions[unit.function.index()];
    const syntax::Body* body = unit.action ? &unit.action->body : &unit.pou->body;
    Context checker(check, {&unit, unit.space, unit.file}, check.gathered.sink, arena);
    checker.function = &function;
    checker.functionId = unit.function;
    checker.isTest = unit.isTest;
    // Blocks have their initial values in the instance; functions start again in each call.
    if (unit.isInstanced())
        emitEdges(checker, unit, function.body);
    else
        emitLocals(checker, unit, function.body);
    if (unit.hasImplicitEno && unit.isInstanced()) {
        const Denoted eno =
            ofVariable(checker, *findMember(unit, checker.key("ENO")).variable, nullptr, unit.range, Access::Write);
        if (eno.place)
            function.body.push_back(
                assignStmt(checker, eno.place,
                           constant(checker, {types::TypeTable::of(TypeKind::Bool), int64_t(1)}, unit.range).expr, {}));
    }
    declareLabels(checker, body->statements);
    statements(checker, body->statements, function.body);
    // The runner interprets tests statement by statement; only the check is wanted here.
    if (unit.isTest) function.body.clear();
    if (unit.resultVariable && checker.types.kind(unit.result) != TypeKind::Void &&
        checker.types.kind(unit.result) != TypeKind::Unknown && !unit.isLibrary()) {
        const bool atEnd = !checker.flow.isReachable || checker.flow.isResultSet;
        // the methods the controller calls need no result, and who adds to the result relies on its beginning
        const bool isCallback = equalsIgnoringCase(unit.name, "FB_Init") ||
                                equalsIgnoringCase(unit.name, "FB_Reinit") || equalsIgnoringCase(unit.name, "FB_Exit");
        if ((!atEnd || !checker.returnsSet) && !isCallback && !isRead(check, *unit.resultVariable))
            check.emit(unit.range, findings::ResultNotSet(unit.name));
    }
}

} // namespace plc::sema
