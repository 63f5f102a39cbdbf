// The syntax tree: what the user wrote, with every range, before any name is resolved. Nodes live in the arena of their
// SyntaxFile and are plain; strings view the source text (or the arena's interned spellings). IL and SFC bodies stand
// here as written; compiler/lower turns them into statements. Immutable after parsing, except for lowering, which adds
// nodes.
#pragma once
#include "runtime/base/arena.h"
#include "runtime/base/source.h"
#include "runtime/compiler/lex/token.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plc::syntax {

/// A name as spelled, without `#` and quotes. Comparison ignores case (base/text foldCase).
struct Name {
    std::string_view text;
    SourceRange range;
    [[nodiscard]] bool isValid() const { return !text.empty(); }
};
/// A.B.C
using Path = std::vector<Name>;

// ---------------------------------------------------------------- expressions

enum class ExprKind : uint8_t {
    Error,     // after a syntax error
    Literal,   // token = literal kind, True, False; prefix = INT of INT#5 when typed; text = as written without prefix
    TypedName, // Color#Red: prefix, name
    NameRef,   // name
    Address,   // %IX0.0: text
    Member,    // base.name
    Bit,       // base.5  base.%X3  base.%B1: text after the dot
    Index,     // base[arguments…]
    Deref,     // base^
    Call,      // base(arguments…)
    Unary,     // op: Minus, Plus, Not
    Binary,    // op: arithmetic, comparison, And, Or, Xor, AndThen, OrElse, Mod, Power
    AssignChain, // b := c as the value in a := b := c
    ArrayInit,   // [a, 3(0), b]: arguments; a repetition is a Repeat
    StructInit,  // (a := 1, b := 2): arguments with names
    Repeat,      // 3(0) / 3(1, 2): base = count, arguments
    This,        // THIS or THIS^ (Deref around it)
    Super,
};

struct Expr;
struct Stmt;
using Block = std::vector<Stmt*>;
enum class ArgumentKind : uint8_t { Positional, Input /* := */, Output /* => */ };
struct Argument {
    ArgumentKind kind = ArgumentKind::Positional;
    Name name;
    bool negated = false;                // NOT out => x, and LD/IL negated pins
    Expr* value = nullptr;               // null: left empty, "out =>"
    const Block* instructions = nullptr; // IL: IN := ( LD a AND b ), instead of a value
    SourceRange range;
};

struct Expr {
    ExprKind kind = ExprKind::Error;
    lex::TokenKind op = lex::TokenKind::Error; // Unary, Binary; Literal: the literal's token kind
    bool parenthesised = false;
    bool isDuration = false; // lowering: the time of an action or step, which must be one
    uint32_t height = 1;     // of the tree below, limited by the parser: whoever walks it may recurse
    SourceRange range;
    SourceRange operatorRange;
    Name name;             // NameRef, Member, TypedName
    std::string_view text; // Literal, Bit, Address
    Name prefix;           // typed literals; a sign belongs to the text: INT#-5
    Expr* base = nullptr;  // Member, Index, Call, Deref, Unary (operand), Binary (left)
    Expr* right = nullptr; // Binary, AssignChain (value; base = target)
    std::vector<Argument> arguments;
};

// ---------------------------------------------------------------- types

enum class TypeSpecKind : uint8_t {
    Error,
    Named,
    String,
    Array,
    OpenArray,
    Pointer,
    RefTo,
    Reference,
    Enum,
    Struct,
    Union,
    Subrange,
    Inferred
};

struct VarDecl;
struct EnumeratorDecl {
    Name name;
    Expr* value = nullptr;
    SourceRange range;
    std::string_view comment;
};
struct Bounds {
    Expr* low = nullptr;
    Expr* high = nullptr;
};
struct TypeSpec {
    TypeSpecKind kind = TypeSpecKind::Error;
    SourceRange range;
    Path path;                   // Named (INT, Motor, Lib.Motor), String ("STRING"/"WSTRING"), Subrange and Enum base
    Expr* length = nullptr;      // STRING(n), STRING[n]
    std::vector<Bounds> bounds;  // Array; Subrange: one; OpenArray: only the count
    TypeSpec* element = nullptr; // Array, Pointer, RefTo, Reference; Enum: base type
    std::vector<EnumeratorDecl> enumerators;
    std::vector<VarDecl*> fields;      // Struct, Union
    TypeSpec* extends = nullptr;       // Struct
    std::vector<Argument> constructor; // fb : Motor(speed := 5): FB_Init arguments or struct/FB initial values
    std::vector<std::vector<Argument>> constructors; // of an array's elements one by one: Motor[(1), (2)]
    Expr* inferredFrom = nullptr;                    // Inferred (compiler temporaries): the type of this expression
};

struct Pragma {
    SourceRange range;
    std::string_view text; // without braces
    std::string_view key; // "attribute" → the attribute's name: 'alias'; else the first word: gvl, language, minTime…
    std::string_view value; // behind := , without quotes
    bool isAttribute = false;
};

enum class VarEdge : uint8_t { None, Rising, Falling };
struct VarDecl {
    std::vector<Name> names;
    std::string_view address; // AT %IX0.0, also written after the colon; first name only
    SourceRange addressRange;
    Path configPath;         // VAR_CONFIG and VAR_ACCESS: the path; names is empty or the access name
    bool isReadOnly = false; // VAR_ACCESS … READ_ONLY
    TypeSpec* type = nullptr;
    Expr* initial = nullptr;
    VarEdge edge = VarEdge::None;
    std::vector<Pragma> pragmas;
    std::string_view comment; // behind the declaration on its line, else directly above
    SourceRange range;
};

enum class SectionKind : uint8_t { Var, Input, Output, InOut, Temp, Stat, Inst, Global, External, Access, Config };
struct VarSection {
    SectionKind kind = SectionKind::Var;
    bool constant = false, retain = false, nonRetain = false, persistent = false;
    bool isPublic = false, isPrivate = false, isProtected = false, isInternal = false;
    std::vector<VarDecl*> declarations;
    std::vector<Pragma> pragmas;
    SourceRange range;
};

// ---------------------------------------------------------------- statements

enum class StmtKind : uint8_t {
    Empty,
    Assign, // target op value; op: Assign, SetAssign, ResetAssign, RefAssign, TryAssign
    Call,   // value (a Call expression, or a bare name: ACTION or PROGRAM call without parentheses is an error)
    If,     // branches; an ELSE has no condition
    Case,
    For,
    While,
    Repeat,
    Try, // branches: the protected part; then __CATCH, its condition the variable; hasElse, elseBody: __FINALLY
    Exit,
    Continue,
    Return,   // value: RETURN expr (CODESYS conditional RETURN(cond) of FBD is not ST)
    Label,    // name:
    Jump,     // JMP name; condition in `value` after lowering from IL
    Block,    // body only: made by lowering
    Il,       // one IL instruction, see il
    Run,      // tests: RUN T#5s | RUN 3 SCANS | RUN UNTIL expr FOR T#10s
    Assert,   // tests: ASSERT value, message
    Force,    // tests: FORCE target := value
    Release,  // tests: RELEASE target
    Compare,  // tests: COMPARE 'recording', TOLERANCE := 0.01
    PowerOff, // tests: POWER_OFF T#5s
};

struct IfBranch {
    Expr* condition = nullptr; // null: ELSE
    Block body;
    SourceRange range;
};
struct CaseLabel {
    Expr* low = nullptr;
    Expr* high = nullptr; // null: a single value
};
struct CaseArm {
    std::vector<CaseLabel> labels;
    Block body;
    SourceRange range;
};

/// One instruction of IL (edition 2, clause 3.2).
struct IlInstruction {
    Name label;                      // "next:" before it
    Name op;                         // LD, AND, CAL, an input operator (S1), a function's or instance's name
    bool negate = false;             // N
    bool conditional = false;        // C of JMPC, CALC, RETC (CN: both)
    bool opensParenthesis = false;   // AND( ; the instructions up to `)` are in body
    Expr* operand = nullptr;         // first operand, may be null
    std::vector<Argument> arguments; // further operands and formal lists: CAL fb(IN := a, Q => b)
    Block body;                      // deferred operations
    Expr* result =
        nullptr; // lowering: the current result behind this line, a compiler variable or a constant; null: unknown
};

struct Stmt {
    StmtKind kind = StmtKind::Empty;
    lex::TokenKind op = lex::TokenKind::Assign;
    SourceRange range;
    Name name;                // Label, Jump
    Expr* target = nullptr;   // Assign, For (variable), Force, Release
    Expr* value = nullptr;    // Assign, Call, Return, While/Repeat (condition), Case (selector), Assert, Run UNTIL,
                              // Compare (recording)
    Expr* from = nullptr;     // For
    Expr* to = nullptr;       // For; Run: the duration or count; Assert: message; Compare: tolerance
    Expr* by = nullptr;       // For
    bool countsScans = false; // Run n SCANS
    Block body;               // loops; Block
    std::vector<IfBranch> branches;
    std::vector<CaseArm> arms;
    bool hasElse = false; // Case, Try
    Block elseBody;       // Case, Try
    IlInstruction* il = nullptr;
    bool isAssociation = false; // lowering: a BOOL variable follows the control block of a chart's action
    Stmt* origin = nullptr;     // lowering: the statement of the source it stands for
};

// ---------------------------------------------------------------- sequential function charts

struct ActionAssociation { // N, D, … of a STEP
    Name action;
    Name qualifier; // "" = N
    Expr* time = nullptr;
    std::vector<Name> indicators;
    SourceRange range;
};
struct StepDecl {
    Name name;
    bool isInitial = false;
    std::vector<ActionAssociation> actions;
    std::vector<Pragma> pragmas; // minTime, maxTime
    SourceRange range;           // STEP … END_STEP
    SourceRange extent;          // with the comment lines directly above and the rest of its last line
};
struct TransitionDecl {
    Name name; // may be empty
    Expr* priority = nullptr;
    std::vector<Name> from, to;
    Expr* condition = nullptr; // := expr ;
    Block ilCondition;         // : IL instructions
    SourceRange range, extent;
};

enum class BodyLanguage : uint8_t { None, St, Il, Sfc };

struct SfcBody;
struct Body {
    BodyLanguage language = BodyLanguage::None;
    Block statements;         // St; Il: one Il statement each
    Block instructions;       // lowering: the Il statements as they were written
    SfcBody* chart = nullptr; // Sfc
    SourceRange range;        // from the first to the last statement (empty: where it would stand)
};
struct ActionDecl {
    Name name;
    std::vector<VarSection*> sections; // accepted, empty as a rule
    Body body;
    SourceRange range, extent;
};
struct SfcBody {
    std::vector<StepDecl*> steps; // in order of the text; all networks of the body
    std::vector<TransitionDecl*> transitions;
    std::vector<ActionDecl*> actions; // ACTION blocks inside the chart
    SourceRange range;
};

// ---------------------------------------------------------------- declarations

enum class Access : uint8_t { Default, Public, Private, Protected, Internal };
enum class PouKind : uint8_t { Program, Function, FunctionBlock, Method, PropertyGet, PropertySet, Interface };

struct Property;
struct Pou {
    PouKind kind = PouKind::Program;
    Name name;
    Access access = Access::Default;
    bool isAbstract = false, isFinal = false, isOverride = false;
    TypeSpec* result = nullptr;
    std::vector<Path> extends; // blocks: one; interfaces: any number
    std::vector<Path> implements;
    std::vector<VarSection*> sections;
    Body body;
    std::vector<Pou*> methods;
    std::vector<Property*> properties;
    std::vector<ActionDecl*> actions;
    std::vector<Path> usings;    // USING directly behind the header
    std::vector<Pragma> pragmas; // above the POU: attribute 'simulation', language 'IL'
    std::string_view comment;    // doc comment above: without its markers
    SourceRange range;           // PROGRAM … END_PROGRAM
    SourceRange header;          // PROGRAM name … up to the first section or statement
    bool hasEnd = true;
};
struct Property {
    Name name;
    Access access = Access::Default;
    bool isAbstract = false, isFinal = false, isOverride = false;
    TypeSpec* type = nullptr;
    Pou* get = nullptr;
    Pou* set = nullptr;
    std::vector<Pragma> pragmas;
    std::string_view comment;
    SourceRange range;
};
struct TypeDecl {
    Name name;
    Access access = Access::Default;
    TypeSpec* spec = nullptr;
    Expr* initial = nullptr;
    std::vector<Pragma> pragmas; // qualified_only, strict
    std::string_view comment;
    SourceRange range;
};
struct GlobalList {
    std::string_view name; // {gvl NAME}, or empty: the file's name is used
    VarSection* section = nullptr;
    std::string_view comment;
};

/// PROGRAM p WITH task : Type (in := x, out => y);
struct ProgramInstance {
    Name name;
    Name task;
    Path type;
    bool retain = false, nonRetain = false;
    std::vector<Argument> connections;
    std::vector<Argument> blockTasks; // fb WITH task: name, value = NameRef of the task
    std::vector<Pragma> pragmas;
    SourceRange range;
};
struct TaskDecl {
    Name name;
    Expr* interval = nullptr;
    Expr* single = nullptr;
    Expr* priority = nullptr;
    std::vector<Argument> others; // WATCHDOG := T#…, SENSITIVITY := …
    std::vector<Pragma> pragmas;
    SourceRange range;
};
struct ResourceDecl {
    Name name; // empty: directly in the CONFIGURATION
    Name on;
    std::vector<VarSection*> sections;
    std::vector<TaskDecl*> tasks;
    std::vector<ProgramInstance*> programs;
    SourceRange range;
};
struct ConfigurationDecl {
    Name name;
    std::vector<VarSection*> sections; // VAR_GLOBAL, VAR_CONFIG, VAR_ACCESS
    std::vector<ResourceDecl*> resources;
    SourceRange range;
};
struct TestDecl {
    std::string_view title; // between the quotes
    SourceRange titleRange;
    std::vector<VarSection*> sections;
    Block body;
    SourceRange range;
};

enum class DeclKind : uint8_t { Pou, Type, Globals, Configuration, Test, Namespace, Using };
struct Decl;
struct NamespaceDecl {
    Path path;
    bool isInternal = false;
    std::vector<Decl*> declarations;
};
struct Decl {
    DeclKind kind = DeclKind::Pou;
    SourceRange range;
    Pou* pou = nullptr;
    TypeDecl* type = nullptr;
    GlobalList* globals = nullptr;
    ConfigurationDecl* configuration = nullptr;
    TestDecl* test = nullptr;
    NamespaceDecl* space = nullptr;
    std::vector<Path> usings;
};

struct SyntaxFile {
    FileId file;
    Arena arena;
    lex::TokenList tokens;
    std::vector<Decl*> declarations;
    bool asksForNames = false; // a conditional pragma asks for names of other files
    std::string library;       // namespace given by the loader: "Standard", "Toolbox"; empty for project files
};

} // namespace plc::syntax
