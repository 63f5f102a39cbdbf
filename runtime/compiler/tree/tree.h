// The checked tree: what the program means, with every name resolved, every conversion written out, every default made
// explicit. Made by compiler/sema, read by codegen and by the expression compiler. Plain nodes in an arena; immutable
// once made.
//
// Conventions
//   * Operands of an operator have the same type, which is stated; differing types have a Convert between.
//   * A Place names storage. Loading, assigning and taking its address are separate nodes.
//   * BOOL values are 0/1. Text values (STRING, WSTRING) and aggregates are handled through places or Text expressions.
//   * FB and program calls are Blocks: inputs assigned into the instance, InOut slots bound, body called, outputs
//   assigned.
#pragma once
#include "runtime/base/arena.h"
#include "runtime/base/source.h"
#include "runtime/image/program.h"
#include "runtime/library/evaluate.h"
#include "runtime/types/type_table.h"

#include <string>
#include <vector>

namespace plc::tree {

using types::TypeId;
using FunctionId = Id<struct FunctionTag>; // index into Program::functions; 0 is reserved
using LabelId = Id<struct LabelTag>;       // per function

struct Expr;
struct Stmt;

// ---------------------------------------------------------------- places

enum class PlaceKind : uint8_t {
    Absolute, // image offset `offset` (globals, located variables, program instances)
    Instance, // THIS + offset
    Local, // function local `local` (a Local that isInOut is followed through: the place is the variable it refers to)
    InOutSlot, // InOut field of an instance: base + offset holds the variable's offset; followed (null → MissingInOut)
    Field,     // base + offset
    Index,     // base[indices…] of an Array or OpenArray: guarded
    Bit,       // bit `bit` of the integer at base (constant)
    TextIndex, // character `index` (from 0) of the STRING/WSTRING at base: guarded: 0..LEN-1 for writing, 0..LEN for
               // reading (the end mark is 0)
    Deref,     // variable at the offset `pointer`: null and foreign references guarded; writes lie within declared
               // variables
    Temporary, // the value of `value` kept in a temporary (struct or array result of a call, function result's member)
};

struct Place {
    PlaceKind kind = PlaceKind::Absolute;
    TypeId type;       // of the storage named
    SourceRange range; // the user's text, for faults
    uint32_t offset = 0;
    int16_t bit = -1; // Absolute/Instance/Field located at a bit; Bit
    uint32_t local = 0;
    Place* base = nullptr;
    std::vector<Expr*> indices; // Index: one per dimension (LINT typed); TextIndex: one
    Expr* pointer = nullptr;    // Deref: an Expr of Pointer/Reference type (or LWORD)
    Expr* value = nullptr;      // Temporary
};

// ---------------------------------------------------------------- expressions

enum class ExprKind : uint8_t {
    Constant, // value (scalar, text or aggregate)
    Load,     // place (scalar or text or aggregate)
    Unary,    // unary, a; type = operand type
    Binary,   // binary, a, b of operandType; comparisons have type BOOL
    AndThen,  // a, b BOOL: b only if a
    OrElse,
    Convert,   // a → type with the semantics of types::convert (Enum, Subrange by storage; text ↔ number included)
    AddressOf, // place → Pointer/Reference offset; bits and locals in registers are refused by sema
    InterfaceOf, // place of a Block → Interface value (its offset)
    Intrinsic,   // intrinsic, operands, selector
    Call,        // call
    Conditional, // a ? b : c (EN/ENO, SEL with side effects)
    Sequence,    // statements, then a
    Bound,       // LOWER_BOUND / UPPER_BOUND of `place` (OpenArray), selector = dimension from 0, flag isUpper
    IsNull,      // a (pointer/interface) = 0
    TryCast, // ?= and __QUERYINTERFACE: a (interface or pointer value) → interface/pointer `type`, 0 when it does not
             // implement it
};

enum class ArgumentMode : uint8_t { Input, InOut, Output };
struct CallArgument {
    uint32_t local = 0; // index of the callee's local
    ArgumentMode mode = ArgumentMode::Input;
    Expr* value = nullptr;  // Input: converted to the local's type
    Place* place = nullptr; // InOut: the variable; Output: target, may differ in type (converted as Convert does)
};

struct Call {
    enum class Dispatch : uint8_t { Direct, Virtual, Interface };
    Dispatch dispatch = Dispatch::Direct;
    FunctionId callee;         // Direct; Virtual and Interface: the declared method (signature)
    Place* instance = nullptr; // methods, FB bodies, program bodies, actions: THIS (Direct, Virtual)
    Expr* interface = nullptr; // Interface dispatch: the interface value
    std::vector<CallArgument> arguments;
};

struct Expr {
    ExprKind kind = ExprKind::Constant;
    TypeId type;
    TypeId operandType; // Binary comparison
    SourceRange range;
    library::UnaryOp unary{};
    library::BinaryOp binary{};
    library::Intrinsic intrinsic{};
    int64_t selector = -1;
    bool isUpper = false;
    types::Value value; // Constant
    Place* place = nullptr;
    Expr* a = nullptr;
    Expr* b = nullptr;
    Expr* c = nullptr;
    std::vector<Expr*> operands; // Intrinsic
    Call* call = nullptr;
    std::vector<Stmt*> statements; // Sequence
    Place* ok = nullptr;           // Intrinsic, Convert: BOOL place that receives ENO, may be null
};

// ---------------------------------------------------------------- statements

enum class StmtKind : uint8_t {
    Assign,   // place := a; scalars of equal type, text of any capacities (cut), aggregates of equal type
    Bind,     // InOut slot `place` (not followed) := address of `target`; OpenArray slots get bounds too; target null =
              // unbind (0)
    Evaluate, // a for its effects
    If,       // a, body, elseBody
    Case,     // a (LINT or unsigned as ULINT bit pattern), arms, elseBody
    While,    // a, body
    Repeat,   // body, a = until
    // Try: body; where a fault leaves it, its exception code goes to place and elseBody runs (place null: nothing
    // catches it). Then arms[0].body, if there is one, whichever way; then a fault that nothing caught goes on.
    Try,
    // For: place from a to b by c, evaluated once; operandType decides the width. The sign of c is the direction (0: no
    // pass). Afterwards the variable is one step past the limit, or at its last value where its type has no such step.
    For,
    Exit,
    Continue,
    Return,
    Label, // label
    Jump,  // label; when a: only if a
    Block, // body (a scope only, no site of its own)
};

struct CaseRange {
    int64_t low = 0;
    int64_t high = 0;
};
struct CaseArm {
    std::vector<CaseRange> ranges;
    std::vector<Stmt*> body;
};

struct Stmt {
    StmtKind kind = StmtKind::Block;
    SourceRange range;     // what a breakpoint on it shows; file none for made statements (no site)
    bool isHidden = false; // made by the compiler: no breakpoint
    TypeId operandType;
    Place* place = nullptr;
    Place* target = nullptr;
    Expr* a = nullptr;
    Expr* b = nullptr;
    Expr* c = nullptr;
    std::vector<Stmt*> body;
    std::vector<Stmt*> elseBody;
    std::vector<CaseArm> arms;
    LabelId label;
};

// ---------------------------------------------------------------- functions

enum class LocalKind : uint8_t { Input, InOut, Output, Local, Result };

struct Local {
    std::string name;
    TypeId type;
    LocalKind kind = LocalKind::Local;
    bool isInOut = false;        // holds a reference (8-byte offset; OpenArray: offset and bounds)
    bool isAddressTaken = false; // must live in the frame area in every tier
    bool isHidden = false;
    Expr* initial = nullptr; // assigned at entry; null: the type's initial value
    SourceRange declaration;
};

struct Function {
    std::string name; // "Motor", "Motor.Start", "Main.Fill"
    std::string library;
    TypeId instanceType;       // THIS; none for FUNCTION
    std::vector<Local> locals; // parameters first, in order of declaration; then the others
    uint32_t resultLocal = Id<int>::kNone;
    TypeId result; // Void: none
    std::vector<Stmt*> body;
    SourceRange declaration;
    uint32_t labelCount = 0;
    bool isAbstract = false;
    bool mayRecurse = false;              // in a cycle of calls, or called through an interface: depth is guarded
    uint32_t methodSlot = Id<int>::kNone; // virtual methods: slot in dispatch tables
};

/// Virtual dispatch: dispatch[blockNumber][slot] → FunctionId (none: not implemented). Interface methods use slots too:
/// a method of an interface and every implementation of it share one slot number program-wide.
struct Program {
    Arena arena;
    std::vector<Function> functions; // 0 is reserved
    std::vector<std::vector<FunctionId>> dispatch;
    std::shared_ptr<types::TypeTable> types;
    image::Layout layout;
    std::vector<std::byte> initialImage; // filled by sema with constant initial values, data part
    FunctionId initializer;              // computes the rest of the initial values, may be none
    std::vector<image::Task> tasks;      // TaskProgram::function etc. are FunctionId values
};

} // namespace plc::tree
