// Checked tree → LLVM IR (D5), on the facts of runtime/compiler/facts. Two tiers: Quick keeps every local in the frame
// area and stops at sites; Optimised inlines and vectorises with all guards on. One module per call; LLVM stays behind
// this header.
#pragma once
#include "runtime/base/progress.h"
#include "runtime/base/result.h"
#include "runtime/compiler/facts/tier.h"
#include "runtime/compiler/tree/tree.h"

#include <memory>

namespace plc::facts {
class ProgramFacts;
}
namespace llvm {
class LLVMContext;
class Module;
} // namespace llvm

namespace plc::codegen {

using facts::Tier;

/// Frames on the machine's stack up to this many bytes are bounded by the depth of calls alone; functions with larger
/// ones ask for room at their entry.
inline constexpr uint64_t kSmallStackFrame = 8 * 1024;
/// The attribute of those that do.
inline constexpr const char* kGuardsStack = "plc-guards-stack";

/// `threadSanitizer` instruments the code (tests of the thread contract).
struct Options {
    Tier tier = Tier::Quick;
    bool threadSanitizer = false;
    bool watched = false;                    // quick code that reports what it computes (image/watch.h)
    const std::vector<bool>* only = nullptr; // functions to emit; the others lie in code that is there already
    Progress* progress = nullptr;            // cancels between functions; what was emitted till then is of no use
    double progressFrom = 0;                 // the share of the whole that is done before
    bool guardsEveryStack = false; // every function asks for room on the stack, not only those that look large
};

/// One of several modules that together hold the quick code: each emits the functions whose number modulo `count` is
/// `index`.
struct Part {
    uint32_t index = 0;
    uint32_t count = 1;
};
/// The module's entries are in the table "plc.entries.<part>": {i64 function, ptr code} …, ended by {0, null}.
[[nodiscard]] Result<std::unique_ptr<llvm::Module>> emitModule(llvm::LLVMContext& context, const tree::Program& program,
                                                               const facts::ProgramFacts& facts, const Options& options,
                                                               Part part = {});

} // namespace plc::codegen
