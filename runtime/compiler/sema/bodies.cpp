// The bodies of all units: prologue (initial values of locals, edges of inputs), statements, end-of-body checks.
#include "runtime/compiler/sema/checker.h"

#include "runtime/base/text.h"

namespace plc::sema {

using library::BinaryOp;

void World::checkBodies() {
    for (size_t i = 0; i < units.size(); ++i)
        if (units[i].isCode()) checkBody(units[i]);
}

namespace {

/// before := CLK; edge := CLK AND NOT before — for each R_EDGE or F_EDGE input of a block.
void emitEdges(Checker& checker, Unit& unit, std::vector<tree::Stmt*>& out) {
    const TypeId boolean = types::TypeTable::of(TypeKind::Bool);
    // a body that runs its base's leaves the inputs of the base to it
    const bool runsBase =
        unit.base && foldCase(checker.world.textOf(unit.pou->body.range)).find("super") != std::string::npos;
    for (Unit* at = &unit; at; at = runsBase ? nullptr : at->base) {
        for (Variable& variable : at->variables) {
            if (variable.edgeOffset == Id<int>::kNone) continue;
            const auto place = [&](uint32_t offset) {
                return checker.fieldPlace(checker.thisPlace(variable.range), offset, boolean, -1, variable.range);
            };
            const auto input = [&] {
                Operand value = checker.load(place(variable.offset), variable.range);
                return variable.declaration->edge == syntax::VarEdge::Rising ? value
                                                                             : checker.inverted(value, variable.range);
            };
            const uint32_t before = variable.edgeOffset + 1;
            const Operand notBefore = checker.inverted(checker.load(place(before), variable.range), variable.range);
            out.push_back(checker.assignStmt(
                place(variable.edgeOffset),
                checker.makeBinary(BinaryOp::And, boolean, input(), notBefore, variable.range).expr, {}));
            out.push_back(checker.assignStmt(place(before), input().expr, {}));
        }
    }
}

/// Initial values of a function's own locals.
void emitLocals(World& world, Checker& checker, Unit& unit, std::vector<tree::Stmt*>& out) {
    types::TypeTable& types = world.types;
    for (Variable& variable : unit.variables) {
        if (variable.storage != Storage::Local || variable.isInOut() || variable.kind == syntax::SectionKind::Input)
            continue;
        const TypeId type = variable.type;
        const syntax::Expr* initial = variable.declaration ? variable.declaration->initial : nullptr;
        if (types.isAggregate(type)) {
            const syntax::TypeSpec* spec = variable.isResult ? nullptr : variable.spec;
            if (!initial && !World::hasConstructor(spec) && !world.needsConstruction(type)) continue;
            if (!checker.fitsIntoCode(type, initial ? initial->range : variable.range)) continue;
            InitialValue value;
            value.bytes = types[type].initial;
            value.bytes.resize(types[type].size);
            world.initialiseDeclared(value, type, 0, -1, initial, variable.scope, spec);
            if (value.bytes != types[type].initial &&
                std::any_of(value.bytes.begin(), value.bytes.end(), [](std::byte b) { return b != std::byte{}; }))
                checker.function->locals[variable.local].initial =
                    checker.constant(types::readValue(types, type, value.bytes), variable.range).expr;
            if (value.dynamics.empty()) continue;
            checker.function->locals[variable.local].isAddressTaken = true;
            world.emitDynamics(
                checker, value.dynamics,
                [&](const DynamicInit& dynamic) {
                    return checker.fieldPlace(checker.localPlace(variable.local, type, variable.range), dynamic.offset,
                                              dynamic.type, dynamic.bit, variable.range);
                },
                out);
            continue;
        }
        if (!initial) continue;
        if (types.kind(type) == TypeKind::Reference) {
            checker.bindReference(checker.localPlace(variable.local, type, variable.range), *initial, {}, out);
            continue;
        }
        const Operand value = checker.converted(checker.expression(*initial, type), type);
        if (value.isUnknown()) continue;
        if (variable.isResult) continue;
        checker.function->locals[variable.local].initial = value.expr;
    }
}

} // namespace

///   ok:    IF a > 0 THEN F := 1; ELSE F := 2; END_IF      advice: IF a > 0 THEN F := 1; END_IF  in FUNCTION F (P3008)
void World::checkBody(Unit& unit) {
    tree::Function& function = functions[unit.function.index()];
    const syntax::Body* body = unit.action ? &unit.action->body : &unit.pou->body;
    Unit* self = unit.self();
    if (self) function.instanceType = self->type;
    function.isAbstract = unit.isAbstract && unit.kind != UnitKind::Block;
    if (unit.owner && unit.owner->kind == UnitKind::Interface) return;
    if (function.isAbstract && body->statements.empty()) return;
    Checker checker(*this, {&unit, unit.space, unit.file}, sink, arena);
    checker.function = &function;
    checker.functionId = unit.function;
    checker.isTest = unit.isTest;
    if (unit.isInstanced())
        emitEdges(checker, unit, function.body);
    else
        emitLocals(*this, checker, unit, function.body);
    if (unit.hasImplicitEno && unit.isInstanced()) {
        const Denoted eno = checker.ofVariable(*unit.members[key("ENO")].variable, nullptr, unit.range, Access::Write);
        if (eno.place)
            function.body.push_back(checker.assignStmt(
                eno.place, checker.constant({types::TypeTable::of(TypeKind::Bool), int64_t(1)}, unit.range).expr, {}));
    }
    checker.declareLabels(body->statements);
    checker.statements(body->statements, function.body);
    if (unit.isTest) function.body.clear();
    if (unit.resultVariable && types.kind(unit.result) != TypeKind::Void &&
        types.kind(unit.result) != TypeKind::Unknown && !unit.isLibrary()) {
        const bool atEnd = !checker.flow.isReachable || checker.flow.isResultSet;
        // the methods the controller calls need no result, and who adds to the result relies on its beginning
        const bool isCallback = equalsIgnoringCase(unit.name, "FB_Init") ||
                                equalsIgnoringCase(unit.name, "FB_Reinit") || equalsIgnoringCase(unit.name, "FB_Exit");
        if ((!atEnd || !checker.returnsSet) && !isCallback && unit.resultVariable->reads == 0)
            emit(unit.range, findings::ResultNotSet(unit.name));
    }
}

} // namespace plc::sema
