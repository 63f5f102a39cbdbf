// The names of a project that conditional pragmas can ask for. Pure functions, any thread.
#pragma once
#include "runtime/compiler/parse/parser.h"

#include <memory>
#include <string>
#include <vector>

namespace plc::driver {

/// NAME or NAME=VALUE of the project, as {define} would set them.
[[nodiscard]] parse::Definitions definitionsOf(const std::vector<std::string>& defines);
/// Adds units, types, tasks and global variables of a file with their attributes.
void addNames(const syntax::SyntaxFile& file, std::string_view text, parse::Definitions& out);
/// Adds every variable of a file: its own conditions may ask for them.
void addVariables(const syntax::SyntaxFile& file, std::string_view text, parse::Definitions& out);

} // namespace plc::driver
