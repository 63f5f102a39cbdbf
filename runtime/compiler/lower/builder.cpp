#include "runtime/compiler/lower/builder.h"

#include "runtime/base/assert.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/compiler/parse/parser.h"

#include <algorithm>
#include <charconv>

namespace plc::lower {

namespace {
constexpr std::string_view kHole = "__hole";
}

namespace {
bool isOneToken(std::string_view text, TokenKind kind) {
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(), text, sink);
    return sink.all().empty() && list.comments.empty() && list.tokens.size() == 2 && list.tokens[0].kind == kind &&
           list.tokens[0].begin == 0 && list.tokens[0].end == text.size();
}
} // namespace

std::string spelled(std::string_view name) {
    if (isOneToken(name, TokenKind::Identifier)) return std::string(name);
    std::string quoted = "\"" + std::string(name) + "\"";
    // A quote that is never closed makes names that nothing can spell; the lexer has complained about it.
    return name.empty() || isOneToken(quoted, TokenKind::WstringLiteral) ? quoted : "__unspellable";
}

std::string identifierFrom(std::string_view name) {
    std::string out;
    for (char c : name)
        out += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       static_cast<unsigned char>(c) >= 0x80
                   ? c
                   : '_';
    if (isOneToken("_" + out, TokenKind::Identifier)) return out;
    for (char& c : out)
        if (static_cast<unsigned char>(c) >= 0x80) c = '_';
    return out;
}

void Builder::setHeight(Expr& e) {
    e.height = 1;
    if (e.base) e.height = std::max(e.height, e.base->height + 1);
    if (e.right) e.height = std::max(e.height, e.right->height + 1);
    for (const Argument& a : e.arguments)
        if (a.value) e.height = std::max(e.height, a.value->height + 1);
}

Expr* Builder::clone(const Expr* e) {
    if (!e) return nullptr;
    // Lowered trees are changed in place (ranges, heights): a node that two statements share would be moved twice.
    Expr* copy = make<Expr>();
    *copy = *e;
    copy->base = clone(e->base);
    copy->right = clone(e->right);
    for (Argument& argument : copy->arguments) argument.value = clone(argument.value);
    return copy;
}

Expr* Builder::nameRef(Name name) {
    Expr* e = make<Expr>();
    e->kind = ExprKind::NameRef;
    e->name = name;
    e->range = name.range;
    return e;
}

Expr* Builder::unary(TokenKind op, Expr* operand, SourceRange range) {
    Expr* e = make<Expr>();
    e->kind = ExprKind::Unary;
    e->op = op;
    e->base = operand;
    e->range = e->operatorRange = range;
    setHeight(*e);
    return e;
}

Expr* Builder::binary(TokenKind op, Expr* left, Expr* right, SourceRange range) {
    Expr* e = make<Expr>();
    e->kind = ExprKind::Binary;
    e->op = op;
    e->base = left;
    e->right = right;
    e->range = e->operatorRange = range;
    e->parenthesised = true;
    setHeight(*e);
    return e;
}

Expr* Builder::call(Expr* base, std::vector<Argument> arguments, SourceRange range) {
    Expr* e = make<Expr>();
    e->kind = ExprKind::Call;
    e->base = base;
    e->arguments = std::move(arguments);
    e->range = range;
    setHeight(*e);
    return e;
}

Stmt* Builder::statement(StmtKind kind, SourceRange range, Stmt* origin) {
    Stmt* stmt = make<Stmt>();
    stmt->kind = kind;
    stmt->range = range;
    stmt->origin = origin;
    return stmt;
}

Stmt* Builder::assign(Expr* target, Expr* value, SourceRange range, Stmt* origin, TokenKind op) {
    Stmt* stmt = statement(StmtKind::Assign, range, origin);
    stmt->op = op;
    stmt->target = target;
    stmt->value = value;
    return stmt;
}

Stmt* Builder::ifThen(Expr* condition, Block body, SourceRange range, Stmt* origin) {
    Stmt* stmt = statement(StmtKind::If, range, origin);
    syntax::IfBranch branch;
    branch.condition = condition;
    branch.body = std::move(body);
    branch.range = range;
    stmt->branches.push_back(std::move(branch));
    return stmt;
}

Block Builder::statements(const std::string& text, SourceRange place, const std::vector<Expr*>& holes) {
    // The text is ours: an error in it is a mistake of a lowering and not of the user.
    diagnostics::Sink sink;
    Block block = parse::parseStatements(m_file, keep(text), sink);
    PLC_ASSERT(!sink.hasErrors(), return {});
    settle(block, place, holes);
    return block;
}

Expr* Builder::expression(std::string_view text, SourceRange place) {
    diagnostics::Sink sink;
    Expr* e = parse::parseExpression(m_file, text, sink);
    if (sink.hasErrors()) return nullptr;
    settle(e, place, {});
    return e;
}

void Builder::settle(Expr*& e, SourceRange place, const std::vector<Expr*>& holes) {
    if (!e) return;
    if (e->kind == ExprKind::NameRef && e->name.text.starts_with(kHole)) {
        size_t index = 0;
        const std::string_view digits = e->name.text.substr(kHole.size());
        const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (end.ec == std::errc() && end.ptr == digits.data() + digits.size() &&
            index < holes.size()) { // else the user's own name
            e = holes[index];
            return;
        }
    }
    // Everything generated stands for one place of the user's text: diagnostics and breakpoints lead there. What fills
    // a hole is the user's own and keeps its places.
    e->range = e->operatorRange = e->name.range = e->prefix.range = place;
    settle(e->base, place, holes);
    settle(e->right, place, holes);
    for (Argument& argument : e->arguments) {
        argument.range = argument.name.range = place;
        settle(argument.value, place, holes);
    }
    setHeight(*e);
}

void Builder::settle(Block& block, SourceRange place, const std::vector<Expr*>& holes) {
    for (Stmt* stmt : block) {
        stmt->range = stmt->name.range = place;
        for (Expr** e : {&stmt->target, &stmt->value, &stmt->from, &stmt->to, &stmt->by}) settle(*e, place, holes);
        settle(stmt->body, place, holes);
        for (syntax::IfBranch& branch : stmt->branches) {
            branch.range = place;
            settle(branch.condition, place, holes);
            settle(branch.body, place, holes);
        }
    }
}

syntax::VarDecl* Builder::declare(syntax::VarSection& section, Name name, std::string_view type, Expr* inferredFrom) {
    auto* decl = make<syntax::VarDecl>();
    decl->names.push_back(name);
    decl->range = name.range;
    decl->type = make<syntax::TypeSpec>();
    decl->type->range = name.range;
    if (inferredFrom) {
        decl->type->kind = syntax::TypeSpecKind::Inferred;
        decl->type->inferredFrom = inferredFrom;
    } else {
        decl->type->kind = syntax::TypeSpecKind::Named;
        decl->type->path.push_back({type, name.range});
    }
    section.declarations.push_back(decl);
    return decl;
}

syntax::VarSection* Builder::section(syntax::SectionKind kind, SourceRange range) {
    auto* section = make<syntax::VarSection>();
    section->kind = kind;
    section->range = range;
    return section;
}

} // namespace plc::lower
