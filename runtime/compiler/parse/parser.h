// Text → syntax tree. Never fails: what cannot be read is skipped with one message per mistake, and the tree holds the
// rest. Pure functions; any thread, one file at a time.
#pragma once
#include "runtime/compiler/parse/conditions.h"
#include "runtime/compiler/parse/syntax.h"

namespace plc::parse {

/// Which branches of {IF …} are read: those whose condition holds, or all of them (the formatter).
enum class Branches : uint8_t { Active, All };
/// `text` must outlive the tree (names view it). Diagnostics go to `sink`. `known`: what conditional pragmas ask for.
[[nodiscard]] std::unique_ptr<syntax::SyntaxFile> parseFile(FileId file, std::string_view text, diagnostics::Sink& sink,
                                                            const Definitions* known = nullptr,
                                                            Branches branches = Branches::Active);
/// A single expression (watch, binding, breakpoint condition): the tree is in `file.arena`; null when nothing could be
/// read.
[[nodiscard]] syntax::Expr* parseExpression(syntax::SyntaxFile& file, std::string_view text, diagnostics::Sink& sink);
/// A list of statements (graph actions, IL shown as ST).
[[nodiscard]] syntax::Block parseStatements(syntax::SyntaxFile& file, std::string_view text, diagnostics::Sink& sink);

} // namespace plc::parse
