// Checked tree → LLVM IR (D5). Two tiers: Quick keeps every local in the frame area and stops at sites (debugging, first scan);
// Optimised inlines and vectorises with all guards on. One module per call; LLVM stays behind this header.
#pragma once
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
    std::vector<image::Site> sites;                 // 0 unused
    std::vector<image::FunctionInfo> functions;     // by FunctionId; 0 unused
};
[[nodiscard]] DebugMap makeDebugMap(const tree::Program& program);

/// Entry symbols are "plc.entry.<FunctionId>". `threadSanitizer` instruments the code (tests of the thread contract).
struct Options {
    Tier tier = Tier::Quick;
    bool threadSanitizer = false;
};
[[nodiscard]] std::unique_ptr<llvm::Module> emitModule(llvm::LLVMContext& context, const tree::Program& program, const DebugMap& debug, const Options& options);

} // namespace plc::codegen
