// Program units get their shape: bases, parameters, where each variable lies (instance field, local, static, constant).
#include "runtime/compiler/sema/layout/units.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/layout.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/program/oop.h"
#include "runtime/compiler/sema/types/type_specs.h"

#include "runtime/base/text.h"
#include "runtime/compiler/parse/section_keyword.h"

#include <cstring>

namespace plc::sema {

using syntax::SectionKind;
using types::FieldSection;
using types::TypeTable;

static void makeStatic(Variable& variable);
static void placeVariables(World& world, Unit& unit, std::vector<std::pair<Variable*, uint32_t>>& fields);
static void noteBlockNesting(World& world, const Unit& unit);
static void completeFunction(World& world, Unit& unit);

namespace {

FieldSection fieldSectionOf(SectionKind kind) {
    switch (kind) {
    case SectionKind::Input:
        return FieldSection::Input;
    case SectionKind::Output:
        return FieldSection::Output;
    case SectionKind::InOut:
        return FieldSection::InOut;
    default:
        return FieldSection::Local;
    }
}

bool isParameter(SectionKind kind) {
    return kind == SectionKind::Input || kind == SectionKind::Output || kind == SectionKind::InOut;
}

} // namespace

/// A constant of a type whose value needs no storage: it is folded wherever it is used.
bool isFoldable(const types::TypeTable& types, TypeId type) {
    const TypeKind kind = types.storageKind(type);
    return types::isElementary(kind) || kind == TypeKind::String || kind == TypeKind::Wstring;
}

void collectParameters(World& world, Unit& unit) {
    if (unit.memberProgress == Progress::Done) return;
    unit.memberProgress = Progress::Done;
    resolveBases(world, unit);
    if (unit.isInstanced() && unit.base) {
        collectParameters(world, *unit.base);
        unit.parameters = unit.base->parameters;
    }
    for (Variable& variable : unit.variables)
        if (isParameter(variable.kind) && !variable.isResult) unit.parameters.push_back(&variable);
}

/// A variable that lives once for all instances and calls: VAR_STAT, constants with storage.
void makeStatic(Variable& variable) {
    variable.storage = Storage::Absolute; // offset: layoutGlobals
}

/// Where the variables of a block or program live.
///   wrong: FUNCTION_BLOCK B VAR_GLOBAL x : INT; END_VAR  (P3018)
void placeVariables(World& world, Unit& unit, std::vector<std::pair<Variable*, uint32_t>>& fields) {
    types::Type& type = world.types.edit(unit.type);
    const auto add = [&](Variable& variable, std::string name, TypeId fieldType, bool isHidden) {
        types::Field field;
        field.name = std::move(name);
        field.type = fieldType;
        field.section = fieldSectionOf(variable.kind);
        field.isPrivate = isHidden;
        if (variable.section) {
            field.retain = variable.section->retain;
            field.persistent = variable.section->persistent;
            field.constant = variable.isConstant;
        }
        field.declaration = variable.range;
        if (variable.name.starts_with("__")) field.isPrivate = true; // made by the lowering of charts and lists
        if (variable.spec && variable.spec->path.size() == 1 &&
            equalsIgnoringCase(variable.spec->path.front().text, "SFC_STEP")) {
            field.section = FieldSection::Step;
            if (variable.symbol.isValid()) world.symbols[variable.symbol.index()].kind = SymbolKind::Step;
        }
        if (variable.declaration) {
            field.comment = std::string(variable.declaration->comment);
            for (const syntax::Pragma& pragma : variable.declaration->pragmas) {
                if (!pragma.isAttribute) continue;
                if (equalsIgnoringCase(pragma.key, "hide")) field.isPrivate = true;
                if (!equalsIgnoringCase(pragma.key, "alias")) continue;
                std::string word;
                for (const char c : std::string(pragma.value) + ",") {
                    if (c != ',') {
                        if (c != ' ' && c != '\'') word += c;
                    } else if (!word.empty()) {
                        field.aliases.push_back(std::exchange(word, {}));
                    }
                }
            }
        }
        fields.emplace_back(&variable, static_cast<uint32_t>(type.fields.size()));
        type.fields.push_back(std::move(field));
    };
    for (Variable& variable : unit.variables) {
        TypeId variableType = typeOf(world, variable);
        const SourceRange at = variable.spec ? variable.spec->range : variable.range;
        if (variable.kind != SectionKind::InOut && !completeType(world, variableType, at))
            variable.type = variableType = TypeTable::of(TypeKind::Unknown);
        if (variable.kind != SectionKind::InOut && nestingOf(world, variableType) >= kMaximumNesting) {
            world.emit(at, findings::NestedTooDeep());
            variable.type = variableType = TypeTable::of(TypeKind::Unknown);
        }
        switch (variable.kind) {
        case SectionKind::Temp:
            variable.storage = Storage::Temporary;
            continue;
        case SectionKind::External:
            continue;
        case SectionKind::Stat:
            makeStatic(variable);
            continue;
        case SectionKind::Var:
        case SectionKind::Input:
        case SectionKind::Output:
        case SectionKind::InOut:
        case SectionKind::Inst:
            break;
        case SectionKind::Global:
        case SectionKind::Access:
        case SectionKind::Config:
            world.emit(variable.range, findings::NotAllowedHere(syntax::keywordOf(variable.kind),
                                                                unit.kind == UnitKind::Program ? phrases::InAProgram()
                                                                                               : phrases::InABlock()));
            continue;
        }
        if (variable.isConstant && variable.kind == SectionKind::Var) {
            if (isFoldable(world.types, variableType) && unit.kind != UnitKind::Program) continue;
            makeStatic(variable); // a program's constants can be watched
            continue;
        }
        if (variable.isLocated && variable.declaration->address.find('*') == std::string_view::npos) {
            variable.storage = Storage::Absolute;
            locate(world, variable, variable.declaration->address);
            continue;
        }
        variable.storage = Storage::Instance;
        add(variable, variable.name, variableType, false);
        if (variable.isLocated) world.openAddresses.push_back({&variable, false});
        if (variable.declaration && variable.declaration->edge != syntax::VarEdge::None) {
            add(variable, variable.name + "__edge", TypeTable::of(TypeKind::Bool), true);
            type.fields.back().section = FieldSection::Local;
            add(variable, variable.name + "__before", TypeTable::of(TypeKind::Bool), true);
            type.fields.back().section = FieldSection::Local;
        }
    }
    for (Unit* method : unit.methods) {
        for (Variable& variable : method->variables) {
            if (variable.kind != SectionKind::Inst) continue;
            const TypeId variableType = typeOf(world, variable);
            completeType(world, variableType, variable.range);
            variable.storage = Storage::Instance;
            add(variable, method->name + "__" + variable.name, variableType, true);
        }
    }
}

void noteBlockNesting(World& world, const Unit& unit) {
    uint32_t nesting = 0;
    for (const types::Field& field : world.types[unit.type].fields)
        if (field.section != FieldSection::InOut) nesting = std::max(nesting, 1 + nestingOf(world, field.type));
    noteNesting(world, unit.type, nesting);
}

/// Gives a unit its parameters and its variables their places; of a block or program also the type with its initial
/// bytes. A base lies at the beginning of what extends it, so that a pointer to the one is a pointer to the other.
void completeUnit(World& world, Unit& unit, SourceRange usedAt) {
    if (unit.layoutProgress != Progress::Open) return;
    unit.layoutProgress = Progress::Working;
    resolveBases(world, unit);
    collectParameters(world, unit);
    if (unit.kind == UnitKind::Interface) {
        unit.layoutProgress = Progress::Done;
        return;
    }
    if (!unit.isInstanced()) {
        completeFunction(world, unit);
        unit.layoutProgress = Progress::Done;
        return;
    }
    uint32_t inherited = 0;
    if (unit.base) {
        if (unit.base->layoutProgress == Progress::Working) {
            reportCycle(world, unit.base->type, usedAt);
            unit.base = nullptr;
        } else {
            const Waiting wait(world.completing, 1, kMaximumNesting + kMaximumBases);
            if (wait.isTooDeep) world.emit(unit.range, findings::NestedTooDeep());
            if (!wait.isTooDeep) completeUnit(world, *unit.base, unit.range);
            world.types.edit(unit.type).fields = world.types[unit.base->type].fields;
            inherited = static_cast<uint32_t>(world.types[unit.type].fields.size());
        }
    }
    std::vector<std::pair<Variable*, uint32_t>> fields;
    placeVariables(world, unit, fields);
    noteBlockNesting(world, unit);
    world.types.layoutFields(unit.type, unit.hasHeader ? 8 : 0);
    if (!checkSize(world, unit.type, unit.range)) {
        unit.layoutProgress = Progress::Done;
        world.types.edit(unit.type).base = unit.base ? unit.base->type : TypeId();
        return;
    }
    InitialValue initial;
    initial.bytes = world.types[unit.type].initial;
    initial.bytes.resize(world.types[unit.type].size);
    if (unit.base) {
        const std::vector<std::byte>& base = world.types[unit.base->type].initial;
        std::copy_n(base.begin(), std::min(base.size(), initial.bytes.size()), initial.bytes.begin());
        initial.dynamics = world.typeInitials[unit.base->type].dynamics;
    }
    if (unit.hasHeader) {
        // an instance says what it is: calls through interfaces and pointers ask for it
        const uint32_t number = world.types[unit.type].blockNumber;
        std::memcpy(initial.bytes.data(), &number, sizeof number);
    }
    unit.layoutProgress = Progress::Done; // initial values may name own variables (REF) and constants
    Variable* previous = nullptr;
    for (const auto& [variable, index] : fields) {
        const types::Field& field = world.types[unit.type].fields[index];
        if (variable == previous) { // hidden fields of an edge input
            if (variable->edgeOffset == Id<int>::kNone) variable->edgeOffset = field.offset;
            continue;
        }
        previous = variable;
        variable->offset = field.offset;
    }
    previous = nullptr;
    for (const auto& [variable, index] : fields) {
        if (variable == previous || index < inherited) continue;
        previous = variable;
        const uint32_t offset = world.types[unit.type].fields[index].offset;
        if (variable->kind != SectionKind::InOut) setInitial(world, initial, *variable, offset);
    }
    const bool isZero =
        std::all_of(initial.bytes.begin(), initial.bytes.end(), [](std::byte b) { return b == std::byte{}; });
    world.types.edit(unit.type).initial = isZero ? std::vector<std::byte>{} : std::move(initial.bytes);
    world.typeInitials[unit.type].dynamics = std::move(initial.dynamics);
    world.types.edit(unit.type).base = unit.base ? unit.base->type : TypeId();
}

/// A function keeps nothing between its calls (edition 3, 6.6.2).
///   wrong: FUNCTION F VAR RETAIN x : INT; END_VAR  (P3018)      advice: FUNCTION F VAR t : TON; END_VAR  (P3030)
void completeFunction(World& world, Unit& unit) {
    const auto addLocal = [&](Variable& variable, tree::LocalKind kind) {
        tree::Function& function = world.functions[unit.function.index()];
        tree::Local local;
        local.name = variable.name;
        local.type = variable.type;
        local.kind = kind;
        local.isInOut = kind == tree::LocalKind::InOut;
        local.declaration = variable.range;
        variable.storage = Storage::Local;
        variable.local = static_cast<uint32_t>(function.locals.size());
        function.locals.push_back(std::move(local));
    };
    for (Variable& variable : unit.variables) {
        const TypeId type = typeOf(world, variable);
        if (variable.kind != SectionKind::InOut &&
            !completeType(world, type, variable.spec ? variable.spec->range : variable.range))
            variable.type = TypeTable::of(TypeKind::Unknown);
        if (variable.declaration && variable.declaration->edge != syntax::VarEdge::None)
            world.emit(variable.range, findings::NotAllowedHere(Verbatim("R_EDGE"), phrases::InAFunction()));
        if (variable.section && (variable.section->retain || variable.section->persistent) &&
            unit.kind == UnitKind::Function)
            world.emit(variable.range,
                       findings::NotAllowedHere(Verbatim(variable.section->retain ? "RETAIN" : "PERSISTENT"),
                                                phrases::InAFunction()));
    }
    for (Variable* parameter : unit.parameters) {
        const tree::LocalKind kind = parameter->kind == SectionKind::Input    ? tree::LocalKind::Input
                                     : parameter->kind == SectionKind::Output ? tree::LocalKind::Output
                                                                              : tree::LocalKind::InOut;
        addLocal(*parameter, kind);
    }
    unit.result = TypeTable::of(TypeKind::Void);
    if (unit.resultVariable) {
        unit.result = unit.resultVariable->type;
        addLocal(*unit.resultVariable, tree::LocalKind::Result);
        world.functions[unit.function.index()].resultLocal = unit.resultVariable->local;
    }
    world.functions[unit.function.index()].result = unit.result;
    for (Variable& variable : unit.variables) {
        if (isParameter(variable.kind)) continue;
        switch (variable.kind) {
        case SectionKind::External:
        case SectionKind::Inst:
            continue;
        case SectionKind::Stat:
            makeStatic(variable);
            continue;
        case SectionKind::Var:
        case SectionKind::Temp:
            break;
        default:
            world.emit(variable.range,
                       findings::NotAllowedHere(syntax::keywordOf(variable.kind), phrases::InAFunction()));
            continue;
        }
        if (variable.isConstant) {
            if (!isFoldable(world.types, variable.type)) makeStatic(variable);
            continue;
        }
        if (variable.isLocated) {
            variable.storage = Storage::Absolute;
            locate(world, variable, variable.declaration->address);
            continue;
        }
        addLocal(variable, tree::LocalKind::Local);
        if (world.types.kind(variable.type) == TypeKind::Block && unit.kind == UnitKind::Function &&
            !isLibraryFile(world, variable.range.file))
            world.emit(variable.range, findings::TimerInFunction(variable.name));
    }
    world.symbols[unit.symbol.index()].type = unit.property ? typeOf(world, unit.variables.front()) : unit.result;
}

/// Blocks with methods, interfaces or relatives carry their number at offset 0 of each instance.
void markHeaders(World& world) {
    uint32_t number = 0;
    for (Unit& unit : world.units) {
        if (!unit.isInstanced()) continue;
        unit.hasHeader = unit.base || unit.isExtended || !unit.methods.empty() || !unit.interfaces.empty();
        if (unit.hasHeader) world.types.edit(unit.type).blockNumber = ++number;
    }
}

} // namespace plc::sema
