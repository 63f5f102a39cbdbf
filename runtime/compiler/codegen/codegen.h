// Checked tree → LLVM IR (D5). Two tiers: Quick keeps every local in the frame area and stops at sites (debugging,
// first scan); Optimised inlines and vectorises with all guards on. One module per call; LLVM stays behind this header.
#pragma once
#include "runtime/base/progress.h"
#include "runtime/compiler/tree/tree.h"
#include "runtime/image/program.h"

#include <memory>

namespace llvm {
class LLVMContext;
class Module;
} // namespace llvm

namespace plc::codegen {

enum class Tier : uint8_t { Quick, Optimised };

/// Shared by both tiers: sites and frames of every function, made once.
struct DebugMap {
    std::vector<image::Site> sites;             // 0 unused
    std::vector<image::FunctionInfo> functions; // by FunctionId; 0 unused
};
[[nodiscard]] DebugMap makeDebugMap(const tree::Program& program);

/// `threadSanitizer` instruments the code (tests of the thread contract).
struct Options {
    Tier tier = Tier::Quick;
    bool threadSanitizer = false;
    Progress* progress = nullptr; // cancels between functions; what was emitted till then is of no use
    double progressFrom = 0;      // the share of the whole that is done before
};

/// What both the whole program and every function need to know; made once, shared by the threads that emit parts of it.
class ProgramFacts;
[[nodiscard]] std::shared_ptr<const ProgramFacts> gatherFacts(const tree::Program& program, const Options& options);

/// One of several modules that together hold the quick code: each emits the functions whose number modulo `count` is
/// `index`.
struct Part {
    uint32_t index = 0;
    uint32_t count = 1;
};
/// The module's entries stand in the table "plc.entries.<part>": {i64 function, ptr code} …, ended by {0, null}.
[[nodiscard]] std::unique_ptr<llvm::Module> emitModule(llvm::LLVMContext& context, const tree::Program& program,
                                                       const ProgramFacts& facts, const Options& options,
                                                       Part part = {});

} // namespace plc::codegen
