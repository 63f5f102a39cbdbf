// Everything about one program while it is checked, and what stays of it for expressions (Analysis::scopes): name
// tables, types, the tree being made. One thread builds it.
#pragma once
#include "runtime/compiler/sema/limits.h"
#include "runtime/compiler/sema/scopes.h"

#include <map>
#include <memory>
#include <optional>
#include <unordered_set>

namespace plc::sema {

/// A part of an initial value that needs code: an expression assigned, a block's FB_Init called, a type's own
/// initialiser run.
struct DynamicInit {
    uint32_t offset = 0; // from the begin of what is initialised
    int16_t bit = -1;
    TypeId type;
    const syntax::Expr* value = nullptr;                        // assigned
    const std::vector<syntax::Argument>* constructor = nullptr; // FB_Init's arguments
    bool isConstruction = false;                                // run the type's initialiser and FB_Init
    bool isReference = false;                                   // REFERENCE TO: bind, not assign
    Scope scope;
};

/// Initial bytes of a type or variable, and what code must add.
struct InitialValue {
    std::vector<std::byte> bytes; // empty: zero
    std::vector<DynamicInit> dynamics;
};

struct Call {
    uint32_t from = 0, to = 0;
    bool isDispatched = false;
    SourceRange range;
};

using image::DirectAddress;
/// What direct addresses begin with.
[[nodiscard]] inline std::vector<std::string> addressAreas() { return {"%I", "%Q", "%M"}; }

/// Where %IW3.1 is in its area.
struct HierarchicalPlace {
    DirectAddress address;
    uint32_t size = 0;
};

struct Found {
    Entity entity;
    Member member;
    std::vector<EnumeratorRef> enumerators;
    GlobalsList* list = nullptr;
    Space* space = nullptr;
    std::vector<std::string> ambiguous; // the namespaces that hold it
    [[nodiscard]] bool isNothing() const {
        return !entity && !member && enumerators.empty() && !list && !space && ambiguous.empty();
    }
};

struct Configuration {
    const syntax::ConfigurationDecl* declaration = nullptr;
    const syntax::SyntaxFile* file = nullptr;
    Space* space = nullptr;
};

struct Instance {
    Variable* variable = nullptr;
    const syntax::ProgramInstance* declaration = nullptr; // null: by default
    const syntax::ResourceDecl* resource = nullptr;
    Scope scope;
    uint32_t root = 0;
    std::string resourceName; // where another RESOURCE has an instance of the same name: R1.A
};

struct Located { // an open address that VAR_CONFIG completes, copied at the scan's borders when it lies in a block
    Variable* variable = nullptr;
    bool isCompleted = false;
};

/// That a body reads or writes a variable.
struct VariableUse {
    uint32_t variable = 0; // World::numbered
    bool isRead = false, isWrite = false;
    bool operator==(const VariableUse&) const = default;
};
struct LastCheck;

struct Copy {
    image::Place data, address;
    bool isInput = false;
    uint32_t root = 0;
};

struct World {
    /// Where all counting goes through: what a body uses is kept for the next check.
    void count(Variable& variable, bool isRead, bool isWrite) {
        if (isRead) ++variable.reads;
        if (isWrite) ++variable.writes;
        uses.push_back({variable.number, isRead, isWrite});
    }

    World(const SourceSet& sources, const Options& options);

    [[nodiscard]] NameId key(std::string_view spelling) { return names.intern(spelling); }
    diagnostics::Diagnostic& emit(SourceRange range, diagnostics::Finding finding) {
        return sink.emit(range, std::move(finding));
    }
    [[nodiscard]] std::string_view textOf(SourceRange range) const {
        return range.file.isValid() ? sources[range.file].slice(range) : std::string_view{};
    }
    tree::Function& function(tree::FunctionId id) { return functions[id.index()]; }

    [[nodiscard]] Unit* unitOf(TypeId type) const {
        const auto it = unitsByType.find(type);
        return it == unitsByType.end() ? nullptr : it->second;
    }
    [[nodiscard]] const std::string& nameOf(TypeId type) const { return types[type].name; }

    InitialValue& typeInitial(TypeId type) { return typeInitials[type]; }

    void checkInferred();

    const SourceSet& sources;
    Options options;
    diagnostics::Sink sink;
    Names names;
    std::shared_ptr<tree::Program> program;
    types::TypeTable& types;
    Arena& arena;
    std::deque<tree::Function> functions; // moved into the program at the end

    Space top;
    std::deque<Space> spaces;
    std::vector<Space*> libraries;
    std::deque<Unit> units;
    std::deque<Property> properties;
    std::deque<DeclaredType> declaredTypes;
    std::deque<EnumType> enums;
    std::deque<StructType> structs;
    std::deque<GlobalsList> lists;
    std::deque<Variable> globals; // globals, program instances, statics
    std::unordered_map<TypeId, Unit*> unitsByType;
    std::unordered_map<TypeId, EnumType*> enumsByType;
    std::unordered_map<TypeId, StructType*> structsByType;
    std::unordered_map<const syntax::TypeSpec*, EnumType*> enumsBySpec;
    std::unordered_map<const syntax::TypeSpec*, TypeId> typesBySpec; // structures and unions written in a VAR
    std::unordered_map<TypeId, DeclaredType*>
        aliasesByType; // TYPE with a default of its own: a copy of the type behind it
    std::unordered_map<TypeId, TypeId> aliasOf;
    std::map<TypeId, InitialValue> typeInitials;
    std::map<TypeId, tree::FunctionId> initialisers;
    std::unordered_map<const syntax::SyntaxFile*, std::vector<Space*>> fileUsings;
    std::unordered_map<const Unit*, std::vector<Space*>> unitUsings;
    std::vector<const syntax::SyntaxFile*> fileOf; // by FileId

    std::vector<Symbol> symbols;
    std::vector<Reference> references;
    std::vector<Call> calls;
    std::vector<Variable*> numbered; // all variables, by Variable::number, from before the bodies on
    std::vector<VariableUse> uses;   // by the body being checked
    size_t completions = 0;          // of anything shared, whoever needed it first
    std::shared_ptr<const LastCheck> check;

    std::vector<Configuration> configurations;
    std::vector<Instance> instances;
    std::vector<Located> openAddresses;
    std::vector<Copy> copies;
    std::vector<DynamicInit> programInits; // absolute offsets, in order
    std::vector<SourceRange> syntaxErrors;
    uint32_t waiting = 0, completing = 0; // see limits.h
    std::vector<uint32_t> nestings;       // by type: of those complete
    std::unordered_set<TypeId> tooLarge;  // reported
    TypeId anyInput;                      // of VAR_INPUT a : ANY, where there is one
    uint64_t initialBytes = 0;            // of all types
    size_t suggestions = 0;               // so many near names were looked for; at some point a reader has enough
    uint32_t rangeOfInputs = 0, rangeOfOutputs = 0, rangeOfMemory = 0;
    std::map<std::string, HierarchicalPlace> hierarchical; // by image::hierarchicalName
    std::vector<std::byte> image;
    std::vector<NameId> slotNames;
};

} // namespace plc::sema
