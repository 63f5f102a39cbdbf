// Blocks with VAR_GENERIC CONSTANT (CODESYS, TwinCAT): Buffer<100> is a block of its own, made of the declaration of
// Buffer with the values of its constants. Made before bases and types are resolved; functions of the builder's thread.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// Makes the block of each list of values that a declaration names.
void declareGenericBlocks(WorldBuilder& world);
/// The path of the block that `spec`, which has values, stands for; nothing: it was reported.
[[nodiscard]] std::optional<syntax::Path> pathOfGeneric(const Check& check, const syntax::TypeSpec& spec,
                                                        const Scope& scope);
/// An upper bound below the lower one in such a block, for a value of 0: one element that nobody uses.
[[nodiscard]] bool isInGeneric(const Scope& scope);

} // namespace plc::sema
