#include "app/pages/zero_divisor.h"

#include "runtime/compiler/lex/token.h"

namespace plc::app {

namespace {

using lex::TokenKind;

/// The token behind the brackets that open at `at`.
size_t behindBrackets(const std::vector<lex::Token>& tokens, size_t at) {
    int depth = 0;
    for (; tokens[at].kind != TokenKind::EndOfFile; ++at) {
        const TokenKind kind = tokens[at].kind;
        depth += kind == TokenKind::LeftParen || kind == TokenKind::LeftBracket;
        depth -= kind == TokenKind::RightParen || kind == TokenKind::RightBracket;
        if (depth == 0) return at + 1;
    }
    return at;
}

/// The token behind a name with its members, indices and arguments, a bracketed expression or a literal.
size_t behindOperand(const std::vector<lex::Token>& tokens, size_t at) {
    if (tokens[at].kind == TokenKind::LeftParen) return behindBrackets(tokens, at);
    if (tokens[at].kind != TokenKind::Identifier) return at + (tokens[at].kind != TokenKind::EndOfFile);
    ++at;
    for (;;) {
        const TokenKind kind = tokens[at].kind;
        if (kind == TokenKind::LeftParen || kind == TokenKind::LeftBracket)
            at = behindBrackets(tokens, at);
        else if (kind == TokenKind::Dot && tokens[at + 1].kind == TokenKind::Identifier)
            at += 2;
        else
            return at;
    }
}

} // namespace

std::optional<std::pair<uint32_t, uint32_t>> zeroDivisor(std::string_view statement) {
    diagnostics::Sink sink;
    const std::vector<lex::Token> tokens = lex::tokenize(FileId(size_t(0)), statement, sink).tokens;
    std::optional<std::pair<uint32_t, uint32_t>> found;
    for (size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (tokens[i].kind != TokenKind::Slash && tokens[i].kind != TokenKind::Mod) continue;
        if (lex::isLiteral(tokens[i + 1].kind)) continue; // never zero: the check says so
        const size_t end = behindOperand(tokens, i + 1);
        if (found || end == i + 1) return std::nullopt;
        found = {tokens[i + 1].begin, tokens[end - 1].end - tokens[i + 1].begin};
    }
    return found;
}

} // namespace plc::app
