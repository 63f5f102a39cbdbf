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

} // namespace plc::jit
