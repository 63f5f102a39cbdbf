// THE CONTRACT, part 5: what watched code reports while it runs (D13). Watched code is quick code that says, in the
// order in which it happens, each statement, branch, value, read and write, to whoever runs the scan again.
#pragma once
#include "runtime/image/runtime_context.h"

#include <cstdint>

namespace plc::image {

/// `node` is the tree's: what it points to is said behind each kind.
enum class WatchKind : uint32_t {
    Begin,     // tree::Function; a: its index. THIS and frame are its own
    End,       // tree::Function
    Call,      // tree::Call: about to be made, the arguments are evaluated. a: function
    Statement, // tree::Stmt: about to run (WHILE: before each look at the condition)
    Pass,      // tree::Stmt: a loop's next pass begins
    Arm,       // tree::Stmt: IF: a = 1 (then) or 0 (else); CASE: a = number of the arm, -1 = else
    Value,     // tree::Expr: a = the bits of a scalar
    Text,      // tree::Expr: a = address of the characters, b = capacity, bit 32 = wide
    Bytes,     // tree::Expr: a = address, b = size (arrays, structures)
    Read,      // tree::Place: a = address, b = size | (bit + 1) << 32
    Load,      // tree::Expr, a scalar variable: its Read and its Value in one; a, b as Read
    Write      // tree::Stmt that caused it, null: parameters and initial values; a, b as Read, after the write
};

/// `where`: THIS (image offset) in the low, frame in the high half.
using Watch = void (*)(RuntimeContext* context, const void* node, WatchKind kind, uint64_t where, uint64_t a,
                       uint64_t b);

/// What watched code runs with: the usual context, and where the reports go.
struct WatchedContext {
    RuntimeContext base;
    Watch watch = nullptr; // `watcher` is its own
    void* watcher = nullptr;
};

} // namespace plc::image
