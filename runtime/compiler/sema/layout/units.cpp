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
static void placeVariables(WorldBuilder& world, Unit& unit, std::vector<std::pair<Variable*, uint32_t>>& fields);
static void noteBlockNesting(WorldBuilder& world, const Unit& unit);
static void completeFunction(WorldBuilder& world, Unit& unit);

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

// Arrays and structures have a place: elements may be chosen by a variable.
/// A constant of a type whose value needs no storage: it is folded wherever it is used.
bool isFoldable(const types::TypeTable& types, TypeId type) {
    const TypeKind kind = types.storageKind(type);
    return types::isElementary(kind) || kind == TypeKind::String || kind == TypeKind::Wstring;
}

// Only which there are and in which order; their types may still be open. Calls and overriding need no more.
void collectParameters(WorldBuilder& world, Unit& unit) {
    if (unit.memberProgress == Progress::Done) return;
    unit.memberProgress = Progress::Done;
    // Without bases the order of parameters is unknown: those of the base come first, as positional calls count.
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

namespace {

/// Names whose address a unit takes: ADR(name). Its tokens are read, once and not its tree: where a constant lies is
/// decided before anything of a body is resolved.
class AddressedNames {
public:
    AddressedNames(const World& world, const Unit& unit) : m_world(world), m_unit(unit) {}
    [[nodiscard]] bool contain(const Variable& variable) {
        if (!m_areRead) read();
        return m_names.count(variable.id) > 0;
    }

private:
    void read() {
        m_areRead = true;
        if (!m_unit.file || !m_unit.pou) return;
        const SourceRange range = m_unit.pou->range;
        const auto& tokens = m_unit.file->tokens.tokens;
        auto at = std::lower_bound(tokens.begin(), tokens.end(), range.begin,
                                   [](const lex::Token& token, uint32_t begin) { return token.begin < begin; });
        for (; at + 2 < tokens.end() && at->begin < range.end; ++at)
            if (at->kind == lex::TokenKind::Identifier && at->end - at->begin == 3 &&
                (at + 1)->kind == lex::TokenKind::LeftParen && equalsIgnoringCase(textOf(*at), "ADR"))
                m_names.insert(m_world.names.find(textOf(*(at + 2))));
    }
    [[nodiscard]] std::string_view textOf(const lex::Token& token) const {
        return m_world.textOf({m_unit.pou->range.file, token.begin, token.end});
    }

    const World& m_world;
    const Unit& m_unit;
    std::set<NameId> m_names;
    bool m_areRead = false;
};

/// {attribute 'alias' := 'a, b'}
void addAliases(types::Field& field, std::string_view list) {
    std::string word;
    for (const char c : std::string(list) + ",") {
        if (c != ',') {
            if (c != ' ' && c != '\'') word += c;
        } else if (!word.empty()) {
            field.aliases.push_back(std::exchange(word, {}));
        }
    }
}

/// Decides for each variable of a block or program where it is stored; what lies in the instance becomes a field.
class FieldPlacing {
public:
    FieldPlacing(WorldBuilder& world, Unit& unit, std::vector<std::pair<Variable*, uint32_t>>& fields)
        : m_world(world), m_unit(unit), m_fields(fields), m_addressed(world, unit) {}

    void own(Variable& variable) {
        const TypeId type = completedType(variable);
        switch (variable.kind) {
        case SectionKind::Temp:
            variable.storage = Storage::Temporary;
            return;
        // It is the global that it names; globalOf finds it when it is first used.
        case SectionKind::External:
            return;
        case SectionKind::Stat:
            makeStatic(variable);
            return;
        case SectionKind::Var:
        case SectionKind::Input:
        case SectionKind::Output:
        case SectionKind::InOut:
        case SectionKind::Inst:
            return place(variable, type);
        case SectionKind::Global:
        case SectionKind::Access:
        case SectionKind::Config:
            m_world.emit(variable.range,
                         findings::NotAllowedHere(syntax::keywordOf(variable.kind), m_unit.kind == UnitKind::Program
                                                                                        ? phrases::InAProgram()
                                                                                        : phrases::InABlock()));
            return;
        }
    }

    /// VAR_INST of a method is stored in the instance, so that it keeps its value from call to call.
    void ofMethod(const Unit& method, Variable& variable) {
        if (variable.kind != SectionKind::Inst) return;
        const TypeId type = typeOf(m_world, variable);
        completeType(m_world, type, variable.range);
        variable.storage = Storage::Instance;
        add(variable, method.name + "__" + variable.name, type, true);
    }

private:
    TypeId completedType(Variable& variable) {
        const TypeId type = typeOf(m_world, variable);
        // A block may thus have an in-out of its own type.
        if (variable.kind == SectionKind::InOut) return type; // a reference: its size is known
        const SourceRange at = variable.spec ? variable.spec->range : variable.range;
        const bool isGood = completeType(m_world, type, at);
        // Blocks in blocks in blocks: paths, recordings and the tree of variables all walk down to the last.
        const bool isTooDeep = isGood && nestingOf(m_world, type) >= kMaximumNesting;
        if (isTooDeep) m_world.emit(at, findings::NestedTooDeep());
        // Unknown silences everything that would follow from a wrong type.
        if (!isGood || isTooDeep) variable.type = TypeTable::of(TypeKind::Unknown);
        return isGood && !isTooDeep ? type : variable.type;
    }

    void place(Variable& variable, TypeId type) {
        if (variable.isConstant && variable.kind == SectionKind::Var) {
            if (isFoldable(m_world.types, type) && m_unit.kind != UnitKind::Program && !m_addressed.contain(variable))
                return;
            // Everybody's instance has the same value: it is stored once.
            makeStatic(variable); // a program's constants can be watched
            return;
        }
        if (variable.isLocated && variable.declaration->address.find('*') == std::string_view::npos) {
            variable.storage = Storage::Absolute;
            locate(m_world, variable, variable.declaration->address);
            return;
        }
        variable.storage = Storage::Instance;
        add(variable, variable.name, type, false);
        // AT %I* in a block: each instance has its own channel.
        if (variable.isLocated) m_world.openAddresses.push_back({&variable, false});
        if (!variable.declaration || variable.declaration->edge == syntax::VarEdge::None) return;
        // R_EDGE and F_EDGE (2.5.2.2) compare with the value of the last call, which has to be kept in each instance.
        for (const char* part : {"__edge", "__before"}) { // what emitEdges compares
            add(variable, variable.name + part, TypeTable::of(TypeKind::Bool), true);
            m_world.types.edit(m_unit.type).fields.back().section = FieldSection::Local;
        }
    }

    void add(Variable& variable, std::string name, TypeId type, bool isHidden) {
        types::Field field;
        field.name = std::move(name);
        field.type = type;
        field.section = fieldSectionOf(variable.kind);
        field.isPrivate = isHidden || variable.name.starts_with("__"); // made by the lowering of charts and lists
        if (variable.section) {
            field.retain = variable.section->retain;
            field.persistent = variable.section->persistent;
            field.constant = variable.isConstant;
        }
        field.declaration = variable.range;
        // Steps are shown as steps, not as the structures that they are stored in.
        if (variable.spec && variable.spec->path.size() == 1 &&
            equalsIgnoringCase(variable.spec->path.front().text, "SFC_STEP")) {
            field.section = FieldSection::Step;
            if (variable.symbol.isValid()) m_world.symbols[variable.symbol.index()].kind = SymbolKind::Step;
        }
        if (variable.declaration) {
            field.comment = std::string(variable.declaration->comment);
            for (const syntax::Pragma& pragma : variable.declaration->pragmas) {
                if (!pragma.isAttribute) continue;
                if (equalsIgnoringCase(pragma.key, "hide")) field.isPrivate = true;
                if (equalsIgnoringCase(pragma.key, "alias")) addAliases(field, pragma.value);
            }
        }
        // Taken last: what is above may add types, and the table moves.
        std::vector<types::Field>& all = m_world.types.edit(m_unit.type).fields;
        m_fields.emplace_back(&variable, static_cast<uint32_t>(all.size()));
        all.push_back(std::move(field));
    }

    WorldBuilder& m_world;
    Unit& m_unit;
    std::vector<std::pair<Variable*, uint32_t>>& m_fields;
    AddressedNames m_addressed;
};

} // namespace

/// Where the variables of a block or program live.
///   wrong: FUNCTION_BLOCK B VAR_GLOBAL x : INT; END_VAR  (P3018)
void placeVariables(WorldBuilder& world, Unit& unit, std::vector<std::pair<Variable*, uint32_t>>& fields) {
    FieldPlacing placing(world, unit, fields);
    for (Variable& variable : unit.variables) placing.own(variable);
    // After the block's own, so that a new VAR_INST moves none of them.
    for (Unit* method : unit.methods)
        for (Variable& variable : method->variables) placing.ofMethod(*method, variable);
}

void noteBlockNesting(WorldBuilder& world, const Unit& unit) {
    // In-outs are addresses and do not count: they end the nesting.
    uint32_t nesting = 0;
    for (const types::Field& field : world.types[unit.type].fields)
        if (field.section != FieldSection::InOut) nesting = std::max(nesting, 1 + nestingOf(world, field.type));
    noteNesting(world, unit.type, nesting);
}

/// Gives a unit its parameters and its variables their places; of a block or program also the type with its initial
/// bytes. A base lies at the beginning of what extends it, so that a pointer to the one is a pointer to the other.
void completeUnit(WorldBuilder& world, Unit& unit, SourceRange usedAt) {
    if (unit.layoutProgress != Progress::Open) return;
    // Working marks the way down: whoever meets it again has found a block that contains itself.
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
            // The depth of the C++ stack, not of the type: a chain of bases in reverse order of declaration recurses
            // once for each.
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
    // 8 and not 4: fields behind the number stay aligned.
    world.types.layoutFields(unit.type, unit.hasHeader ? 8 : 0);
    // Too large for an image: without initial bytes, which would have to be allocated to be thrown away.
    if (!checkSize(world, unit.type, unit.range)) {
        unit.layoutProgress = Progress::Done;
        world.types.edit(unit.type).base = unit.base ? unit.base->type : TypeId();
        return;
    }
    InitialValue initial;
    initial.bytes = world.types[unit.type].initial;
    initial.bytes.resize(world.types[unit.type].size);
    if (unit.base) {
        // The base's bytes are a prefix of these, its number included; the number is replaced below.
        const std::vector<std::byte>& base = world.types[unit.base->type].initial;
        std::copy_n(base.begin(), std::min(base.size(), initial.bytes.size()), initial.bytes.begin());
        // Dynamic initial values of the base apply at the same offsets here.
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
            // __edge is the first of the two; __before follows directly.
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
    // No bytes mean zeros: most types begin so, and their instances need no copy.
    const bool isZero =
        std::all_of(initial.bytes.begin(), initial.bytes.end(), [](std::byte b) { return b == std::byte{}; });
    world.types.edit(unit.type).initial = isZero ? std::vector<std::byte>{} : std::move(initial.bytes);
    world.typeInitials[unit.type].dynamics = std::move(initial.dynamics);
    world.types.edit(unit.type).base = unit.base ? unit.base->type : TypeId();
}

void completeUnit(const Check& check, Unit& unit, SourceRange usedAt) {
    if (check.builder) completeUnit(*check.builder, unit, usedAt);
}

/// A function keeps nothing between its calls (edition 3, 6.6.2).
///   wrong: FUNCTION F VAR RETAIN x : INT; END_VAR  (P3018)      advice: FUNCTION F VAR t : TON; END_VAR  (P3030)
void completeFunction(WorldBuilder& world, Unit& unit) {
    // The function is asked for by its index each time: the list of functions grows while types are completed.
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
    AddressedNames addressed(world, unit);
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
    // Parameters first and in their order: calls place arguments by the index of the local.
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
        // Folded where it is used, or stored once: a constant costs nothing in a frame.
        if (variable.isConstant) {
            if (!isFoldable(world.types, variable.type) || addressed.contain(variable)) makeStatic(variable);
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
    // A property shows the type of its value, whichever accessor this is.
    world.symbols[unit.symbol.index()].type = unit.property ? typeOf(world, unit.variables.front()) : unit.result;
}

/// Blocks with methods, interfaces or relatives carry their number at offset 0 of each instance.
// A block without any of these is never asked what it is, and its instances save the eight bytes.
void markHeaders(WorldBuilder& world) {
    // Numbers follow the order of declaration and are made again at each build; a recording keeps those of its own
    // version.
    uint32_t number = 0;
    for (Unit& unit : world.units) {
        if (!unit.isInstanced()) continue;
        unit.hasHeader = unit.base || unit.isExtended || !unit.methods.empty() || !unit.interfaces.empty();
        if (unit.hasHeader) world.types.edit(unit.type).blockNumber = ++number;
    }
}

} // namespace plc::sema
