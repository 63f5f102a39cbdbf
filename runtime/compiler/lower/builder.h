// Makes statements of the syntax tree: by hand, from clones, or from a piece of ST text with holes for expressions of
// the user. Everything lives in the file's arena. One lowering, one thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace plc::lower {

using lex::TokenKind;
using syntax::Argument;
using syntax::Block;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Name;
using syntax::Stmt;
using syntax::StmtKind;

class Builder {
public:
    explicit Builder(syntax::SyntaxFile& file) : m_file(file) {}

    template <class T> T* make() { return m_file.arena.make<T>(); }
    /// Text that lives as long as the tree.
    std::string_view keep(std::string text) { return *m_file.arena.make<std::string>(std::move(text)); }
    Name name(std::string text, SourceRange range) { return {keep(std::move(text)), range}; }

    Expr* clone(const Expr* e);
    Expr* nameRef(Name name);
    Expr* unary(TokenKind op, Expr* operand, SourceRange range);
    Expr* binary(TokenKind op, Expr* left, Expr* right, SourceRange range);
    Expr* call(Expr* base, std::vector<Argument> arguments, SourceRange range);
    Stmt* statement(StmtKind kind, SourceRange range, Stmt* origin);
    Stmt* assign(Expr* target, Expr* value, SourceRange range, Stmt* origin, TokenKind op = TokenKind::Assign);
    Stmt* ifThen(Expr* condition, Block body, SourceRange range, Stmt* origin);

    /// Statements from ST text; `__hole0`, `__hole1`… stand for the expressions. Every other range becomes `place`.
    Block statements(const std::string& text, SourceRange place, const std::vector<Expr*>& holes = {});

    /// An expression that the user wrote where the parser keeps text (a pragma); null when it is none.
    Expr* expression(std::string_view text, SourceRange place);

    /// Declares `name : type` (or of the type of `inferredFrom`) in the section.
    syntax::VarDecl* declare(syntax::VarSection& section, Name name, std::string_view type,
                             Expr* inferredFrom = nullptr);
    syntax::VarSection* section(syntax::SectionKind kind, SourceRange range);

private:
    void settle(Expr*& e, SourceRange place, const std::vector<Expr*>& holes);
    void settle(Block& block, SourceRange place, const std::vector<Expr*>& holes);
    void setHeight(Expr& e);

    syntax::SyntaxFile& m_file;
};

/// A name as ST writes it: in quotes when it is not an identifier.
[[nodiscard]] std::string spelled(std::string_view name);
/// The name as a part of an identifier.
[[nodiscard]] std::string identifierFrom(std::string_view name);

} // namespace plc::lower
