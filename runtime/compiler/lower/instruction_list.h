// Instruction lists (IEC 61131-3 ed. 2, 3.2) as statements: the current result is followed as an expression and kept in a
// compiler variable only where it is needed twice or meets another way at a label. One body, one use.
#pragma once
#include "runtime/compiler/lower/builder.h"

namespace plc::lower {

struct LoweredList {
    Block statements;
    Expr* result = nullptr; // the current result at the end, when wanted
};

/// Declares what it needs in `section`; `sections` are the unit's own, to know its block instances. `counter` numbers the
/// compiler variables of the unit.
[[nodiscard]] LoweredList lowerInstructions(const Block& instructions, Builder& builder, const std::vector<syntax::VarSection*>& sections, const std::vector<std::string>& blockTypes,
                                            syntax::VarSection& section, int& counter, bool wantsResult, diagnostics::Sink& sink);

} // namespace plc::lower
