#include "runtime/compiler/parse/parser_state.h"

#include <algorithm>

namespace plc::parse {

using diagnostics::Diagnostic;

Parser::Parser(SyntaxFile& file, const lex::TokenList& tokens, std::string_view text, diagnostics::Sink& sink,
               size_t lexicalErrors, Conditions conditions, size_t firstToken)
    : m_file(file), m_list(tokens), m_conditions(std::move(conditions)), m_text(text), m_sink(sink),
      m_firstToken(static_cast<uint32_t>(firstToken)) {
    m_tokens.reserve(tokens.tokens.size() - firstToken);
    m_sourceIndex.reserve(tokens.tokens.size() - firstToken);
    bool newline = false;
    for (auto i = m_firstToken; i < tokens.tokens.size(); ++i) {
        const Token& token = tokens.tokens[i];
        newline |= token.afterNewline;
        if (token.kind == TokenKind::Pragma || token.kind == TokenKind::Error || m_conditions.isLeftOut(i)) continue;
        m_tokens.push_back(token);
        m_tokens.back().afterNewline = newline;
        m_sourceIndex.push_back(i);
        newline = false;
    }
    for (size_t i = lexicalErrors; i < sink.all().size(); ++i) m_badOffsets.push_back(sink.all()[i].range.begin);
    std::sort(m_badOffsets.begin(), m_badOffsets.end());
}

bool Parser::atAny(std::initializer_list<TokenKind> kinds) const {
    return std::find(kinds.begin(), kinds.end(), kind()) != kinds.end();
}

SourceRange Parser::rangeFrom(size_t first) const {
    const Token& begin = m_tokens[std::min(first, m_tokens.size() - 1)];
    if (m_at <= first) return {m_file.file, begin.begin, begin.begin};
    return {m_file.file, begin.begin, std::max(previous().end, begin.begin)};
}

Name Parser::nameOf(const Token& token) const {
    std::string_view text = textOf(token);
    if (token.kind == TokenKind::WstringLiteral) {
        text.remove_prefix(1);
        if (text.ends_with('"')) text.remove_suffix(1);
    }
    return {text, rangeOf(token)};
}

/// A name, with Siemens's `#` or quotes allowed.
bool Parser::atName(size_t ahead) const {
    const TokenKind k = kind(ahead);
    if (k == TokenKind::Identifier) return true;
    if (k == TokenKind::WstringLiteral) return peek(ahead).end - peek(ahead).begin > 2;
    return k == TokenKind::Hash &&
           (kind(ahead + 1) == TokenKind::Identifier || kind(ahead + 1) == TokenKind::WstringLiteral);
}

/// A word of the language where only a name can be meant: before `:`, `,` or AT.
bool Parser::atKeywordAsName() const {
    return lex::isKeyword(kind()) && (kind(1) == TokenKind::Colon || kind(1) == TokenKind::Comma ||
                                      kind(1) == TokenKind::At || kind(1) == TokenKind::Assign);
}

Name Parser::takeName(messages::Thing what) {
    if (!atName() && atKeywordAsName()) {
        const Name name = nameOf(peek());
        if (auto* d = report(name.range, findings::KeywordAsName(name.text)))
            d->fixes.push_back(
                {fixes::Write(std::string(name.text) + "_"), {{name.range, std::string(name.text) + "_"}}});
        m_lastErrorAt = SIZE_MAX;
        advance();
        return name;
    }
    if (!atName()) {
        expected(std::move(what));
        return {};
    }
    take(TokenKind::Hash);
    const Name name = nameOf(peek());
    if (at(TokenKind::WstringLiteral)) m_quotedNames.push_back(name.text);
    advance();
    return name;
}

Path Parser::takePath() {
    Path path;
    do {
        const Name name = takeName();
        if (!name.isValid()) break;
        path.push_back(name);
    } while (take(TokenKind::Dot));
    return path;
}

/// The lexer's complaint about this or the token before stands for the syntax error it causes.
Diagnostic* Parser::report(SourceRange range, diagnostics::Finding finding) {
    if (m_lastErrorAt == m_at) return nullptr;
    m_lastErrorAt = m_at;
    if (!m_badOffsets.empty()) {
        const uint32_t from = m_at >= 1 ? m_tokens[m_at - 1].begin : 0;
        const uint32_t to = std::max(peek().end, range.end);
        const auto bad = std::lower_bound(m_badOffsets.begin(), m_badOffsets.end(), from);
        if (bad != m_badOffsets.end() && *bad <= to) return nullptr;
        // a comment that is never closed swallowed the rest
        if (atEnd() && m_badOffsets.back() >= previous().end) return nullptr;
    }
    return &m_sink.emit(range, std::move(finding));
}

messages::Thing Parser::shown(const Token& token) const {
    if (token.kind == TokenKind::EndOfFile) return phrases::TheEndOfTheFile();
    std::string_view text = textOf(token);
    if (text.size() <= 40) return text;
    size_t cut = 37;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;
    return std::string(text.substr(0, cut)) + "...";
}

void Parser::expected(messages::Thing what) {
    const SourceRange range = atEnd() ? afterPrevious() : rangeOf(peek());
    report(range, findings::Expected(std::move(what), shown(peek())));
}

bool Parser::expect(TokenKind wanted) {
    if (take(wanted)) return true;
    expected(lex::spelling(wanted));
    return false;
}

SourceRange Parser::afterPrevious() const {
    const uint32_t end = m_at == 0 ? peek().begin : previous().end;
    return {m_file.file, end, end};
}

void Parser::insertFix(Diagnostic* diagnostic, std::string text) {
    if (!diagnostic) return;
    std::string title = text;
    while (!title.empty() && (title.back() == '\n' || title.back() == ' ')) title.pop_back();
    while (!title.empty() && (title.front() == '\n' || title.front() == ' ')) title.erase(0, 1);
    diagnostic->fixes.push_back({fixes::Insert(title), {{afterPrevious(), std::move(text)}}});
}

void Parser::missingSemicolon(bool accepted) {
    // the last character of what is there: an empty range would show nothing
    SourceRange range = afterPrevious();
    if (range.begin > 0 && m_at > 0) --range.begin;
    insertFix(report(range, accepted ? findings::MissingSemicolonAccepted() : findings::MissingSemicolon()), ";");
}

/// What may follow a statement without its semicolon: then only the semicolon is missing.
bool Parser::startsStatement(size_t ahead) const {
    switch (kind(ahead)) {
    case TokenKind::If:
    case TokenKind::Case:
    case TokenKind::For:
    case TokenKind::While:
    case TokenKind::Repeat:
    case TokenKind::Exit:
    case TokenKind::Continue:
    case TokenKind::Return:
        return true;
    case TokenKind::Identifier:
    case TokenKind::Hash:
    case TokenKind::WstringLiteral:
    case TokenKind::DirectAddress:
        return true;
    default:
        return false;
    }
}

bool Parser::startsExpression() const {
    if (lex::isLiteral(kind())) return true;
    switch (kind()) {
    case TokenKind::Identifier:
    case TokenKind::TypedPrefix:
    case TokenKind::DirectAddress:
    case TokenKind::Hash:
    case TokenKind::Plus:
    case TokenKind::Minus:
    case TokenKind::Not:
    case TokenKind::LeftParen:
    case TokenKind::LeftBracket:
        return true;
    default:
        return false;
    }
}

void Parser::endStatement() {
    if (take(TokenKind::Semicolon)) {
        m_lastErrorAt = SIZE_MAX;
        return;
    }
    if (m_lastErrorAt == m_at) return skipStatement();
    if (atStatementEnd()) return missingSemicolon(at(TokenKind::EndCase));
    if (peek().afterNewline && startsStatement()) return missingSemicolon(false);
    const bool wordStarts = startsStatement() && !atName();
    const bool assignment = atName() && (kind(1) == TokenKind::Assign || kind(1) == TokenKind::LeftParen);
    const bool alone = previous().kind == TokenKind::Identifier || previous().kind == TokenKind::RightParen ||
                       previous().kind == TokenKind::IntegerLiteral;
    if (wordStarts || (assignment && alone)) return missingSemicolon(false);
    report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
    skipStatement();
}

/// To behind the next semicolon, or before what can only begin or end a statement.
void Parser::skipStatement() {
    int parentheses = 0;
    while (!atEnd()) {
        if (at(TokenKind::Semicolon)) {
            advance();
            break;
        }
        if (atStatementEnd() || atDeclaration()) break;
        if (peek().afterNewline && m_at != m_lastErrorAt) {
            if (startsStatement() && !atName()) break;
            if (parentheses <= 0 && atName() &&
                (kind(1) == TokenKind::Assign || kind(1) == TokenKind::LeftParen || kind(1) == TokenKind::Dot ||
                 kind(1) == TokenKind::LeftBracket))
                break;
        }
        if (at(TokenKind::LeftParen)) ++parentheses;
        if (at(TokenKind::RightParen)) --parentheses;
        advance();
    }
    m_lastErrorAt = SIZE_MAX;
}

void Parser::skipTo(std::initializer_list<TokenKind> kinds) {
    while (!atEnd() && !atAny(kinds)) advance();
    m_lastErrorAt = m_at;
}

bool Parser::endIsOpen(TokenKind end) const { return std::find(m_open.begin(), m_open.end(), end) != m_open.end(); }

bool Parser::expectEnd(TokenKind end, const Token& opening, SourceRange elseIf) {
    if (take(end)) return true;
    const std::string word(lex::spelling(end));
    Diagnostic* diagnostic = report(rangeOf(opening), findings::MissingEnd(word, shown(opening)));
    if (diagnostic && elseIf.file.isValid())
        diagnostic->fixes.push_back({fixes::Write(Verbatim("ELSIF")), {{elseIf, "ELSIF"}}});
    insertFix(diagnostic, "\n" + word + ";");
    return false;
}

Parser::Nesting::Nesting(Parser& p) : parser(p), tooDeep(++p.m_depth > kMaxDepth) {
    if (!tooDeep) return;
    parser.report(parser.rangeOf(parser.peek()), findings::NestedTooDeep());
}

} // namespace plc::parse
