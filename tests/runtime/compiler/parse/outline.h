// The syntax tree as short text, so that a test's table says what a tree must be in one line. Tests only, any thread.
#pragma once
#include "runtime/compiler/parse/parser.h"

#include <string>

namespace plc::parse::testing {

std::string outline(const syntax::Expr* e);
std::string outline(const syntax::TypeSpec& spec);
std::string outline(const syntax::VarSection& section);
std::string outline(const syntax::Block& block);
std::string outline(const syntax::SfcBody& chart);
std::string outline(const syntax::Decl& decl);
std::string outline(const syntax::SyntaxFile& file);

/// A parsed text with its diagnostics as "P1010@line:column …".
struct Parsed {
    SourceSet sources;
    std::unique_ptr<syntax::SyntaxFile> file;
    std::vector<diagnostics::Diagnostic> diagnostics;
    explicit Parsed(std::string text);
    [[nodiscard]] std::string codes() const;
    [[nodiscard]] size_t errors() const;
};

std::string expressionOutline(std::string text);
/// Of statements in a program of their own.
std::string statementsOutline(const std::string& text);

} // namespace plc::parse::testing
