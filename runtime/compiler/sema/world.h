// What one program declares: name tables, types, what was found out about them. A WorldBuilder makes it on one thread
// (world_builder.h); bodies are checked against a `const World`, and so are the expressions of an Analysis, on any
// thread.
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

struct LastCheck;

/// Immutable but for its builder. Ask it through const: what it points to is only changed by who declares.
struct World {
    World(const SourceSet& theSources, Options theOptions, std::shared_ptr<const tree::Program> theProgram)
        : sources(theSources), options(std::move(theOptions)), program(std::move(theProgram)), types(*program->types) {}

    [[nodiscard]] std::string_view textOf(SourceRange range) const {
        return range.file.isValid() ? sources[range.file].slice(range) : std::string_view{};
    }
    [[nodiscard]] Unit* unitOf(TypeId type) const {
        const auto it = unitsByType.find(type);
        return it == unitsByType.end() ? nullptr : it->second;
    }
    [[nodiscard]] const std::string& nameOf(TypeId type) const { return types[type].name; }

    const SourceSet& sources;
    Options options;
    Names names;
    std::shared_ptr<const tree::Program> program;
    const types::TypeTable& types;

    std::unique_ptr<Space> outermost = std::make_unique<Space>();
    Space& top = *outermost; // stays where it is when the World moves
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
    std::unordered_map<const syntax::SyntaxFile*, std::vector<Space*>> fileUsings;
    std::unordered_map<const Unit*, std::vector<Space*>> unitUsings;
    std::vector<const syntax::SyntaxFile*> fileOf; // by FileId
    std::vector<Variable*> numbered;               // all variables, by Variable::number, from before the bodies on

    std::vector<Configuration> configurations;
    std::vector<Instance> instances;
    std::vector<SourceRange> syntaxErrors;
    std::shared_ptr<const LastCheck> check; // what its bodies gave, where they are kept
    std::vector<uint32_t> nestings;         // by type: of those complete
    std::unordered_set<TypeId> tooLarge;    // reported
    TypeId anyInput;                        // of VAR_INPUT a : ANY, where there is one
    uint32_t rangeOfInputs = 0, rangeOfOutputs = 0, rangeOfMemory = 0;
    std::map<std::string, HierarchicalPlace> hierarchical; // by image::hierarchicalName
};

} // namespace plc::sema
