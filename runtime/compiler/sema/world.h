// Everything about one program while it is checked, and what stays of it for expressions (Analysis::scopes): name
// tables, types, the tree being made. One thread builds it; `freeze` makes it read only.
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

/// An address as written: %IX0.0, %QW4, %M*.
struct DirectAddress {
    image::Area area = image::Area::Input;
    TypeKind kind = TypeKind::Bool;
    uint32_t byte = 0;
    int16_t bit = -1;
    bool isOpen = false; // %I*
};
[[nodiscard]] std::optional<DirectAddress> parseAddress(std::string_view text);
/// What direct addresses begin with.
[[nodiscard]] inline std::vector<std::string> addressAreas() { return {"%I", "%Q", "%M"}; }

class Checker;

class World {
public:
    World(const SourceSet& sources, const Options& options);

    // world.cpp
    void build(std::vector<std::unique_ptr<syntax::SyntaxFile>>& files);
    [[nodiscard]] NameId key(std::string_view spelling) {
        return frozen ? names.find(spelling) : names.intern(spelling);
    }
    diagnostics::Diagnostic& emit(SourceRange range, diagnostics::Finding finding) {
        return (frozen && expressionSink ? *expressionSink : sink).emit(range, std::move(finding));
    }
    static thread_local diagnostics::Sink*
        expressionSink; // of the expression this thread checks against a frozen World
    SymbolId addSymbol(SymbolKind kind, std::string_view name, std::string_view owner, SourceRange range,
                       std::string_view comment = {});
    void refer(SourceRange range, SymbolId symbol, bool isRead, bool isWrite);
    [[nodiscard]] std::string_view textOf(SourceRange range) const {
        return range.file.isValid() ? sources[range.file].slice(range) : std::string_view{};
    }
    [[nodiscard]] bool isLibraryFile(FileId file) const;
    [[nodiscard]] bool hasSyntaxErrorAt(SourceRange range) const; // in it or just behind it
    tree::Function& function(tree::FunctionId id) { return functions[id.index()]; }
    tree::FunctionId newFunction(std::string name, const Unit* unit);

    // declare.cpp
    void declareFile(const syntax::SyntaxFile& file);
    void declare(const syntax::Decl& decl, Space& space, const syntax::SyntaxFile& file);
    Unit* declareUnit(const syntax::Pou& pou, Space& space, const syntax::SyntaxFile& file);
    Unit* declareMethod(const syntax::Pou& pou, Unit& owner, std::string_view name, UnitKind kind);
    void declareMembers(Unit& unit);
    void declareVariables(Unit& unit, const std::vector<syntax::VarSection*>& sections);
    void declareImplicitEno(Unit& unit);
    Variable& addVariable(Unit& unit, Variable variable, const std::vector<syntax::Pragma>* pragmas);
    void declareInlineEnums(const syntax::TypeSpec* spec, const Scope& scope,
                            std::unordered_map<NameId, std::vector<EnumeratorRef>>& table);
    void declareGlobals(const syntax::GlobalList& list, Space& space, const syntax::SyntaxFile& file,
                        std::string_view name);
    void declareType(const syntax::TypeDecl& type, Space& space, const syntax::SyntaxFile& file);
    EnumType* declareEnum(const syntax::TypeSpec& spec, std::string name, const Scope& scope,
                          std::unordered_map<NameId, std::vector<EnumeratorRef>>& table,
                          const std::vector<syntax::Pragma>* attributes);
    TypeId declareStruct(const syntax::TypeSpec& spec, std::string name, const Scope& scope);
    Space& childSpace(Space& parent, std::string_view name);
    void resolveUsings();

    // tests.cpp
    void declareTest(const syntax::TestDecl& test, Space& space, const syntax::SyntaxFile& file);
    void checkTestNames();
    [[nodiscard]] bool isAccessName(std::string_view name) const; // of a VAR_ACCESS

    // lookup.cpp
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
    [[nodiscard]] Member findMember(Unit& unit, NameId id);
    [[nodiscard]] Member findInInterfaces(Unit& first, NameId id);
    [[nodiscard]] Found lookup(const Scope& scope, NameId id, bool wantsType = false);
    [[nodiscard]] Found lookupIn(Space& space, NameId id);
    [[nodiscard]] Found lookupUsed(const std::vector<Space*>& used, NameId id, bool wantsType);
    [[nodiscard]] static bool hasWanted(const Found& found, bool wantsType);
    void addNames(const Space& space, std::vector<std::string>& out);
    [[nodiscard]] Found lookupPath(const Scope& scope, const syntax::Path& path);
    [[nodiscard]] std::vector<std::string> visibleNames(const Scope& scope);
    [[nodiscard]] std::vector<std::string> memberNames(TypeId type);
    void suggest(diagnostics::Diagnostic& diagnostic, SourceRange range, std::string_view name,
                 const std::vector<std::string>& candidates);

    // type_specs.cpp
    TypeId resolveSpec(const syntax::TypeSpec* spec, const Scope& scope, std::string_view anonymousName = {});
    TypeId resolveNamed(const syntax::Path& path, const Scope& scope, SourceRange range);
    TypeId resolveDeclared(DeclaredType& type);
    TypeId typeOf(Variable& variable);
    bool completeType(TypeId type, SourceRange usedAt);
    [[nodiscard]] const types::Field* fieldOf(TypeId type, std::string_view name);
    [[nodiscard]] uint32_t nestingOf(TypeId type) const;
    TypeId nested(TypeId type, SourceRange range);
    void noteNesting(TypeId type, uint32_t nesting);
    bool checkSize(TypeId type, SourceRange range);
    [[nodiscard]] uint64_t neededBytes(TypeId type) const;
    bool completeArray(TypeId type, SourceRange usedAt);
    void completeEnum(EnumType& type);
    void completeStruct(StructType& type);
    void completeAlias(DeclaredType& type, SourceRange usedAt);
    // relative_addresses.cpp
    void locateMembers(const StructType& type, std::vector<types::Field>& fields, size_t inherited,
                       const std::vector<const syntax::VarDecl*>& declarations);
    bool locateMember(types::Field& field, const syntax::VarDecl& declaration);
    void checkMemberOverlaps(const StructType& type, const std::vector<types::Field>& fields, size_t inherited,
                             const std::vector<const syntax::VarDecl*>& declarations);
    void reportCycle(TypeId type, SourceRange usedAt);
    TypeId resolveArray(const syntax::TypeSpec& spec, const Scope& scope);
    TypeId resolveSubrange(const syntax::TypeSpec& spec, const Scope& scope);
    [[nodiscard]] std::optional<int64_t> constantInteger(const syntax::Expr* expr, const Scope& scope);
    [[nodiscard]] Unit* unitOf(TypeId type) const {
        const auto it = unitsByType.find(type);
        return it == unitsByType.end() ? nullptr : it->second;
    }
    [[nodiscard]] bool sameType(TypeId a, TypeId b) const;
    [[nodiscard]] const std::string& nameOf(TypeId type) const { return types[type].name; }

    // units.cpp
    void resolveBases(Unit& unit);
    void completeUnit(Unit& unit, SourceRange usedAt);
    void completeFunction(Unit& unit);
    void collectParameters(Unit& unit);
    void noteBlockNesting(const Unit& unit);
    void placeVariables(Unit& unit, std::vector<std::pair<Variable*, uint32_t>>& fields);
    void makeStatic(Variable& variable);
    void markHeaders();

    // oop.cpp
    void checkInheritance(Unit& unit);
    void assignSlots();
    void buildDispatch();
    [[nodiscard]] bool isAccessible(syntax::Access access, const Unit* owner, const Scope& from);

    // constants.cpp
    const types::Value* constantOf(Variable& variable);
    const types::Value* fold(Variable& variable);
    void foldNeeded(Variable& first);
    bool planFolding(Variable& variable, std::vector<Variable*>& waiting);
    void gatherConstants(const syntax::Expr* root, const Scope& scope, std::vector<Variable*>& out);
    Variable* constantNamed(const syntax::Expr& e, const Scope& scope);
    void checkConstants();

    // initial_values.cpp
    InitialValue& typeInitial(TypeId type) { return typeInitials[type]; }
    bool needsConstruction(TypeId type);
    void initialise(InitialValue& out, TypeId type, uint32_t offset, int16_t bit, const syntax::Expr* value,
                    const Scope& scope, const std::vector<syntax::Argument>* constructor);
    static bool hasConstructor(const syntax::TypeSpec* spec);
    void initialiseDeclared(InitialValue& out, TypeId type, uint32_t offset, int16_t bit, const syntax::Expr* value,
                            const Scope& scope, const syntax::TypeSpec* spec);
    void writeConstant(InitialValue& out, TypeId type, uint32_t offset, int16_t bit, const types::Value& value);
    void setInitial(InitialValue& out, Variable& variable, uint32_t offset);
    tree::FunctionId initialiserOf(TypeId type);
    void emitDynamics(Checker& checker, const std::vector<DynamicInit>& dynamics,
                      const std::function<tree::Place*(const DynamicInit&)>& place, std::vector<tree::Stmt*>& out);
    void buildInitialiser();

    // layout.cpp
    void measureAddresses();
    void layoutGlobals();
    void finishLayout();
    void locate(Variable& variable, std::string_view path);
    [[nodiscard]] image::AreaRange areaOf(image::Area area) const;
    void checkOverlaps();

    // configuration.cpp
    void declareConfigurations();
    void applyVarConfig();
    void addAccess(const syntax::VarDecl& declaration, const image::Place& place, std::string list);
    void accessAddress(const syntax::VarDecl& declaration, const Scope& scope);
    void accessPrograms();

    // tasks.cpp
    void buildTasks();

    // bodies.cpp
    void checkBodies();
    void checkBody(Unit& unit);
    void checkInferred();

    // flow.cpp
    void checkUsage();
    void gatherConfigured();
    void checkUnusedGlobals();
    void useNamesIn(SourceRange range);
    void checkUnusedActions();
    void checkAddressSize(const Variable& variable, std::string_view text, SourceRange range);
    void checkRecursion();
    void checkFrames(const std::vector<std::vector<uint32_t>>& edges,
                     const std::vector<std::vector<uint32_t>>& components);

    const SourceSet& sources;
    Options options;
    diagnostics::Sink sink;
    Names names;
    bool frozen = false;
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

    struct Configuration {
        const syntax::ConfigurationDecl* declaration = nullptr;
        const syntax::SyntaxFile* file = nullptr;
        Space* space = nullptr;
    };
    std::vector<Configuration> configurations;
    void forEachResource(const std::function<void(const Configuration&, const syntax::ResourceDecl&)>& visit) const;
    struct Instance {
        Variable* variable = nullptr;
        const syntax::ProgramInstance* declaration = nullptr; // null: by default
        const syntax::ResourceDecl* resource = nullptr;
        Scope scope;
        uint32_t root = 0;
    };
    std::vector<Instance> instances;
    struct Located { // an open address that VAR_CONFIG completes, copied at the scan's borders when it lies in a block
        Variable* variable = nullptr;
        bool isCompleted = false;
    };
    std::vector<Located> openAddresses;
    struct Copy {
        image::Place data, address;
        bool isInput = false;
        uint32_t root = 0;
    };
    std::vector<Copy> copies;
    std::vector<DynamicInit> programInits; // absolute offsets, in order
    std::vector<SourceRange> syntaxErrors;
    uint32_t waiting = 0, completing = 0; // see limits.h
    [[nodiscard]] uint32_t* completingCounter() { return frozen ? nullptr : &completing; }
    [[nodiscard]] uint32_t* waitingCounter() { return frozen ? nullptr : &waiting; }
    std::vector<uint32_t> nestings;      // by type: of those complete
    std::unordered_set<TypeId> tooLarge; // reported
    uint64_t initialBytes = 0;           // of all types
    size_t suggestions = 0;              // so many near names were looked for; at some point a reader has enough
    uint32_t rangeOfInputs = 0, rangeOfOutputs = 0, rangeOfMemory = 0;
    std::vector<std::byte> image;
    std::vector<NameId> slotNames;
};

} // namespace plc::sema
