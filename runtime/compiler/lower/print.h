// Statements and expressions as ST text, with the parentheses that precedence needs. Pure functions, any thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <string>

namespace plc::lower {

[[nodiscard]] std::string print(const syntax::Expr& e);
/// One statement a line, `indent` blanks before each, four more for each block.
[[nodiscard]] std::string print(const syntax::Block& block, int indent);
[[nodiscard]] std::string print(const syntax::TypeSpec& spec);
/// What stands between the parentheses of a call, an index or a list: `a, p := b, NOT q => c`.
[[nodiscard]] std::string printArguments(const std::vector<syntax::Argument>& list);

} // namespace plc::lower
