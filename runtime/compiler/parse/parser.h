// Text → syntax tree. Never fails: what can not be read is skipped with one message per mistake, and the tree holds the
// rest. Pure functions; any thread, one file at a time.
#pragma once
#include "runtime/compiler/parse/syntax.h"

namespace plc::parse {

/// `text` must outlive the tree (names view it). Diagnostics go to `sink`.
[[nodiscard]] std::unique_ptr<syntax::SyntaxFile> parseFile(FileId file, std::string_view text,
                                                            diagnostics::Sink& sink);
/// A single expression (watch, binding, breakpoint condition): the tree is in `file.arena`; null when nothing could be
/// read.
[[nodiscard]] syntax::Expr* parseExpression(syntax::SyntaxFile& file, std::string_view text, diagnostics::Sink& sink);
/// A list of statements (graph actions, IL shown as ST).
[[nodiscard]] syntax::Block parseStatements(syntax::SyntaxFile& file, std::string_view text, diagnostics::Sink& sink);

} // namespace plc::parse
