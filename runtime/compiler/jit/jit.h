// Machine code from a checked tree, through LLVM ORC. LLVM stays behind this header. compile() may run on any thread;
// the Code keeps its memory alive.
#pragma once
#include "runtime/compiler/codegen/codegen.h"

namespace plc::jit {

/// The controller's three functions; registered once at start-up before the first compile.
void setRuntimeSymbols(const image::RuntimeSymbols& symbols);

/// Quick: -O0-like, fast instruction selection. Optimised: -O2 pipeline, whole program, contraction and fast-math off.
[[nodiscard]] Result<std::shared_ptr<const image::Code>> compile(const tree::Program& program,
                                                                 const codegen::Options& options);

/// Quick code of the functions in `only` that reports what it computes (image/watch.h); the others are `quick`, which
/// compile() made of the same program. Who calls a function of `only` must be in it as well, or it runs unwatched.
[[nodiscard]] Result<std::shared_ptr<const image::Code>> compileWatched(const tree::Program& program,
                                                                        const std::vector<bool>& only,
                                                                        std::shared_ptr<const image::Code> quick,
                                                                        Progress* progress = nullptr);

} // namespace plc::jit
