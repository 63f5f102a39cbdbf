// A TEST as the checker sees it: the body of a hidden block that may look at and write everything. Only files below
// tests/ are read so, and only for the editor: the program of a project never holds them. Functions; any thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <string>

namespace plc::sema {

/// Files whose TESTs are checked: "tests/…".
[[nodiscard]] inline bool isTestPath(std::string_view path) { return path.starts_with("tests/"); }
/// The hidden block's name, by its place: it owns the variables of the TEST.
[[nodiscard]] inline std::string testUnitName(const syntax::TestDecl& test) {
    return "__test" + std::to_string(test.range.file.index()) + "_" + std::to_string(test.range.begin);
}

} // namespace plc::sema
