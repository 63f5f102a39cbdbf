// What the checker knows by name: variables, program units, types, global lists and namespaces, with folded and
// interned names. Owned by the World (world.h); built by one thread, then read only.
#pragma once
#include "runtime/compiler/parse/syntax.h"
#include "runtime/compiler/sema/sema.h"
#include "runtime/compiler/tree/tree.h"

#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

namespace plc::sema {

using NameId = Id<struct NameTag>;
using types::TypeId;
using types::TypeKind;

/// Folded spellings, each once.
class Names {
public:
    NameId intern(std::string_view spelling);
    [[nodiscard]] NameId find(std::string_view spelling) const;
    [[nodiscard]] const std::string& folded(NameId id) const { return m_texts[id.index()]; }

private:
    std::deque<std::string> m_texts;
    std::unordered_map<std::string_view, uint32_t> m_ids;
};

struct Unit;
struct Space;
struct GlobalsList;
struct EnumType;

/// Where a name is looked up from.
struct Scope {
    Unit* unit = nullptr;
    Space* space = nullptr;
    const syntax::SyntaxFile* file = nullptr;
    TypeId structure{}; // whose fields get their initial values: THIS and the other fields are this one's
};

enum class Storage : uint8_t {
    None,      // not laid out (constants of functions, names after an error)
    Absolute,  // image offset
    Instance,  // THIS + offset
    Local,     // local of its function
    Temporary, // VAR_TEMP of a block or program: a local of each function that uses it
};
enum class Progress : uint8_t { Open, Working, Done };
enum class Folding : uint8_t { Open, Working, Constant, Dynamic };

struct Variable {
    std::string name;
    NameId id;
    const syntax::VarDecl* declaration = nullptr;
    const syntax::VarSection* section = nullptr;
    const syntax::TypeSpec* spec = nullptr; // the declaration's, or a result's
    SourceRange range;                      // the name
    syntax::SectionKind kind = syntax::SectionKind::Var;
    Scope scope;           // its initial value and type are seen from
    Unit* owner = nullptr; // null: global
    GlobalsList* list = nullptr;
    Space* space = nullptr;
    TypeId type;
    Progress typeProgress = Progress::Open;
    Storage storage = Storage::None;
    uint32_t offset = 0;
    int16_t bit = -1;
    uint32_t local = Id<int>::kNone;
    uint32_t edgeOffset = Id<int>::kNone; // R_EDGE, F_EDGE: the field that holds the edge
    bool isConstant = false;
    bool isLocated = false; // has an address, complete or not
    bool isProgramInstance = false;
    bool isResult = false;            // the function's own name
    bool isReadOnlyReference = false; // ARRAY[*] as input: passed like an in-out, not written
    bool isFoldingPlanned = false;    // what its initial value needs was folded, or is about to be
    Folding folding = Folding::Open;
    types::Value value;         // Folding::Constant
    Variable* target = nullptr; // VAR_EXTERNAL: the global
    Unit* program = nullptr;    // of a program instance
    SymbolId symbol;
    uint32_t reads = 0, writes = 0;
    uint32_t number = Id<int>::kNone; // World::numbered
    [[nodiscard]] bool isInOut() const { return kind == syntax::SectionKind::InOut; }
};

enum class UnitKind : uint8_t { Program, Function, Block, Interface, Method, PropertyGet, PropertySet, Action };

struct Property {
    std::string name;
    NameId id;
    const syntax::Property* declaration = nullptr;
    Unit* owner = nullptr;
    Unit* get = nullptr;
    Unit* set = nullptr;
    TypeId type;
    SymbolId symbol;
};

struct EnumeratorRef {
    EnumType* type = nullptr;
    uint32_t index = 0;
};

/// One name inside a program unit.
struct Member {
    Variable* variable = nullptr;
    Unit* unit = nullptr; // method or action
    Property* property = nullptr;
    [[nodiscard]] explicit operator bool() const { return variable || unit || property; }
};

/// A program, function, block, interface, method, property accessor or action.
struct Unit {
    UnitKind kind = UnitKind::Program;
    std::string name;
    std::string qualified; // "Motor.Start"
    NameId id;
    const syntax::Pou* pou = nullptr; // not for actions
    const syntax::ActionDecl* action = nullptr;
    const syntax::SyntaxFile* file = nullptr;
    SourceRange range; // the name
    Space* space = nullptr;
    Unit* owner = nullptr; // of methods, accessors, actions
    Property* property = nullptr;
    syntax::Access access = syntax::Access::Default;
    bool isAbstract = false, isFinal = false, isOverride = false, isSimulation = false;
    bool isTest = false;     // the hidden block of a TEST
    bool hasHeader = false;  // instances begin with the block number
    bool isExtended = false; // some block extends it
    bool hasImplicitEno = false;
    TypeId type;   // Block or Interface
    TypeId result; // functions and methods; Void: none
    Progress baseProgress = Progress::Open, memberProgress = Progress::Open, layoutProgress = Progress::Open;
    std::deque<Variable> variables; // own, in order of declaration
    std::unordered_map<NameId, Member> members;
    std::unordered_map<NameId, std::vector<EnumeratorRef>> enumerators; // of enumerations declared in a VAR
    std::vector<Unit*> methods;                                         // with accessors
    std::vector<Unit*> actions;
    std::vector<Property*> properties;
    Unit* base = nullptr;
    uint32_t level = 0;            // bases and interfaces above it
    std::vector<Unit*> interfaces; // IMPLEMENTS; EXTENDS of an interface
    Variable* resultVariable = nullptr;
    Variable* instance = nullptr; // of a PROGRAM: the only one
    uint32_t instanceCount = 0;
    tree::FunctionId function;         // its body
    std::vector<Variable*> parameters; // inputs, in-outs, outputs, base's first
    uint32_t slot = Id<int>::kNone;
    bool isOverridden = false;
    SymbolId symbol;

    [[nodiscard]] bool isInstanced() const { return kind == UnitKind::Program || kind == UnitKind::Block; }
    [[nodiscard]] bool isCode() const { return kind != UnitKind::Interface; }
    /// The block or program THIS means inside.
    [[nodiscard]] Unit* self() { return isInstanced() || kind == UnitKind::Interface ? this : owner; }
    [[nodiscard]] const Unit* self() const { return isInstanced() || kind == UnitKind::Interface ? this : owner; }
    [[nodiscard]] bool isLibrary() const { return file && !file->library.empty(); }
};

/// TYPE name : …
struct DeclaredType {
    std::string name;
    NameId id;
    const syntax::TypeDecl* declaration = nullptr;
    Scope scope;
    Progress progress = Progress::Open;
    TypeId type;
    EnumType* enumeration = nullptr;
    SymbolId symbol;
};

/// An enumeration, declared or written in a VAR; its values are computed when first asked for.
struct EnumType {
    TypeId type;
    const syntax::TypeSpec* spec = nullptr;
    const syntax::Expr* initial = nullptr;
    Scope scope;
    std::string name;
    Progress progress = Progress::Open;
    std::vector<SymbolId> symbols;
    std::unordered_map<NameId, uint32_t> indices; // of its values by name
    bool isTextNamed = false;                     // {attribute 'to_string'}: TO_STRING gives the name
};

/// A structure or union whose fields are still to be laid out.
struct StructType {
    TypeId type;
    const syntax::TypeSpec* spec = nullptr;
    const syntax::Expr* initial = nullptr;
    Scope scope;
    std::string name;
    bool isUnion = false;
    Progress progress = Progress::Open;
    std::vector<SymbolId> symbols;                // by field
    std::unordered_map<NameId, uint32_t> indices; // of its fields by name and alias, once it is laid out
};

struct GlobalsList {
    std::string name;
    NameId id;
    Space* space = nullptr;
    std::unordered_map<NameId, Variable*> variables;
};

/// One thing a namespace holds by name.
struct Entity {
    Variable* variable = nullptr;
    Unit* unit = nullptr;
    DeclaredType* type = nullptr;
    [[nodiscard]] explicit operator bool() const { return variable || unit || type; }
};

struct Space {
    std::string name;
    std::string qualified;
    Space* parent = nullptr;
    bool isLibrary = false;
    std::unordered_map<NameId, std::vector<Entity>> entities;
    std::unordered_map<NameId, std::vector<EnumeratorRef>> enumerators;
    std::unordered_map<NameId, GlobalsList*> lists;
    std::unordered_map<NameId, Space*> spaces;
    std::vector<const syntax::Path*> usingPaths;
    std::vector<Space*> usings;
    [[nodiscard]] const std::vector<Entity>* find(NameId id) const {
        const auto it = entities.find(id);
        return it == entities.end() ? nullptr : &it->second;
    }
};

} // namespace plc::sema
