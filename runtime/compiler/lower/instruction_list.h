// Instruction lists (IEC 61131-3 ed. 2, 3.2) as statements: the current result is followed as an expression and kept in
// a compiler variable only where it is needed twice or meets another way at a label. One body, one use.
#pragma once
#include "runtime/compiler/lower/builder.h"
#include "runtime/compiler/lower/lower.h"

namespace plc::lower {

struct LoweredList {
    Block statements;
    Expr* result = nullptr; // the current result at the end, when wanted
};

struct ListContext {
    Builder& builder;
    const std::vector<syntax::VarSection*>& sections; // the unit's own, to know its block instances
    const std::vector<std::string>& blockTypes;       // folded names of the file's function blocks
    syntax::VarSection& section;                      // compiler variables are declared here
    int& counter;                                     // and numbered with this
    diagnostics::Sink& sink;
    Keep keep = Keep::Needed;
    syntax::Name functionName{}; // of a function: it takes the current result at the end unless one is stored
};

[[nodiscard]] LoweredList lowerInstructions(const Block& instructions, const ListContext& context, bool wantsResult);

} // namespace plc::lower
