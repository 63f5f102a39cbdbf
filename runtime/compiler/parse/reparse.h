// A file read again after an edit: declarations well in front of the first change are those of the tree before, so that
// typing at the end of a long file costs its end. Pure functions, any thread.
#pragma once
#include "runtime/compiler/parse/parser.h"

#include <optional>

namespace plc::parse {

struct EarlierReading {
    const syntax::SyntaxFile& tree;
    std::string_view text;
    const std::vector<diagnostics::Diagnostic>& diagnostics; // of lexer, parser and lowering
};

struct Reparsed {
    std::unique_ptr<syntax::SyntaxFile> tree;
    size_t shared = 0; // so many declarations are nodes of the earlier tree, which with its text must outlive this one
};

/// As parseFile for a tree that is lowered from declaration `shared` on. Nothing when it pays to read, or when it has
/// to be read, from the begin.
[[nodiscard]] std::optional<Reparsed> reparseFile(const EarlierReading& before, std::string_view text,
                                                  diagnostics::Sink& sink, const Definitions* known);

} // namespace plc::parse
