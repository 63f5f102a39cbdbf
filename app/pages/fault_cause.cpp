#include "app/pages/fault_cause.h"

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
        else if (kind == TokenKind::Caret)
            ++at;
        else
            return at;
    }
}

/// What may be meant: one piece of text, however often it stands there.
class Candidates {
public:
    Candidates(std::string_view statement, const std::vector<lex::Token>& tokens)
        : m_statement(statement), m_tokens(tokens) {}

    /// The tokens from `begin` to `end`; a literal is never the cause, since the check would have said so.
    void add(size_t begin, size_t end) {
        if (begin >= end) return;
        bool isLiteral = true;
        for (size_t i = begin; i < end; ++i)
            isLiteral = isLiteral && (lex::isLiteral(m_tokens[i].kind) || m_tokens[i].kind == TokenKind::Minus);
        if (isLiteral) return;
        const std::pair piece{m_tokens[begin].begin, m_tokens[end - 1].end - m_tokens[begin].begin};
        if (m_found && textOf(*m_found) != textOf(piece)) m_areSeveral = true;
        if (!m_found) m_found = piece;
    }
    [[nodiscard]] std::optional<std::pair<uint32_t, uint32_t>> only() const {
        return m_areSeveral ? std::nullopt : m_found;
    }

private:
    [[nodiscard]] std::string_view textOf(const std::pair<uint32_t, uint32_t>& piece) const {
        return m_statement.substr(piece.first, piece.second);
    }
    std::string_view m_statement;
    const std::vector<lex::Token>& m_tokens;
    std::optional<std::pair<uint32_t, uint32_t>> m_found;
    bool m_areSeveral = false;
};

using Tokens = std::vector<lex::Token>;

void addDivisors(const Tokens& tokens, Candidates& out) {
    for (size_t i = 0; i + 1 < tokens.size(); ++i)
        if (tokens[i].kind == TokenKind::Slash || tokens[i].kind == TokenKind::Mod)
            out.add(i + 1, behindOperand(tokens, i + 1));
}

/// Each index of what is indexed; a list of values in brackets has nothing in front.
void addIndices(const Tokens& tokens, Candidates& out) {
    for (size_t i = 1; i < tokens.size(); ++i) {
        const TokenKind before = tokens[i - 1].kind;
        if (tokens[i].kind != TokenKind::LeftBracket ||
            (before != TokenKind::Identifier && before != TokenKind::Caret && before != TokenKind::RightBracket))
            continue;
        const size_t end = behindBrackets(tokens, i);
        const bool isClosed = tokens[end - 1].kind == TokenKind::RightBracket;
        const size_t last = isClosed ? end - 1 : end;
        size_t begin = i + 1;
        for (size_t at = begin; at < last; ++at) {
            if (tokens[at].kind == TokenKind::LeftBracket || tokens[at].kind == TokenKind::LeftParen) {
                at = behindBrackets(tokens, at) - 1;
            } else if (tokens[at].kind == TokenKind::Comma) {
                out.add(begin, at);
                begin = at + 1;
            }
        }
        out.add(begin, last);
    }
}

/// What is followed with `^`, and names that are followed without.
void addReferences(const Tokens& tokens, const IsFollowed& isFollowed, Candidates& out) {
    for (size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind != TokenKind::Identifier || (i > 0 && tokens[i - 1].kind == TokenKind::Dot)) continue;
        const size_t end = behindOperand(tokens, i);
        for (size_t at = i; at < end; ++at) {
            const bool isName = tokens[at].kind == TokenKind::Identifier;
            if (isName && tokens[at + 1].kind == TokenKind::RefAssign) continue; // is given something
            if (tokens[at].kind == TokenKind::Caret)
                out.add(i, at);
            else if (isName && (at == i || tokens[at - 1].kind == TokenKind::Dot) && isFollowed &&
                     isFollowed(tokens[at].begin, tokens[at].end))
                out.add(i, at + 1);
            else if (tokens[at].kind == TokenKind::LeftBracket || tokens[at].kind == TokenKind::LeftParen)
                at = behindBrackets(tokens, at) - 1; // what is inside is looked at by itself
        }
    }
}

/// What the statement assigns, or gives to a parameter.
void addValues(const Tokens& tokens, Candidates& out) {
    if (tokens.front().kind == TokenKind::For) return; // its variable counts
    for (size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (tokens[i].kind != TokenKind::Assign) continue;
        size_t end = i + 1;
        while (tokens[end].kind != TokenKind::EndOfFile && tokens[end].kind != TokenKind::Semicolon &&
               tokens[end].kind != TokenKind::Comma && tokens[end].kind != TokenKind::RightParen) {
            const bool opens = tokens[end].kind == TokenKind::LeftParen || tokens[end].kind == TokenKind::LeftBracket;
            end = opens ? behindBrackets(tokens, end) : end + 1;
        }
        out.add(i + 1, end);
    }
}

/// Of the head of a loop, its only variable, else the whole condition; of FOR, where it ends.
std::optional<std::pair<uint32_t, uint32_t>> conditionOfLoop(std::string_view statement, const Tokens& tokens) {
    size_t begin = 0;
    if (tokens[0].kind == TokenKind::While || tokens[0].kind == TokenKind::Until) {
        begin = 1;
    } else if (tokens[0].kind == TokenKind::For) {
        while (tokens[begin].kind != TokenKind::EndOfFile && tokens[begin].kind != TokenKind::To) ++begin;
        ++begin;
    } else {
        return std::nullopt; // a statement that is long by itself
    }
    size_t end = begin;
    while (end < tokens.size() && tokens[end].kind != TokenKind::EndOfFile && tokens[end].kind != TokenKind::Do &&
           tokens[end].kind != TokenKind::By && tokens[end].kind != TokenKind::EndRepeat)
        ++end;
    Candidates variables(statement, tokens), whole(statement, tokens);
    for (size_t i = begin; i < end; ++i)
        if (tokens[i].kind == TokenKind::Identifier) {
            const size_t behind = std::min(behindOperand(tokens, i), end);
            variables.add(i, behind);
            i = behind - 1;
        }
    whole.add(begin, end);
    const auto variable = variables.only();
    return variable ? variable : whole.only();
}

} // namespace

std::optional<std::pair<uint32_t, uint32_t>> causeOfFault(image::FaultCode code, std::string_view statement,
                                                          const IsFollowed& isFollowed) {
    using image::FaultCode;
    diagnostics::Sink sink;
    const Tokens tokens = lex::tokenize(FileId(size_t(0)), statement, sink).tokens;
    Candidates found(statement, tokens);
    switch (code) {
    case FaultCode::DivisionByZero:
        addDivisors(tokens, found);
        break;
    case FaultCode::IndexOutOfRange:
    case FaultCode::StringIndex:
        addIndices(tokens, found);
        break;
    case FaultCode::NullReference:
    case FaultCode::ForeignReference:
        addReferences(tokens, isFollowed, found);
        break;
    case FaultCode::ValueOutOfRange:
        addValues(tokens, found);
        break;
    case FaultCode::Watchdog:
        return conditionOfLoop(statement, tokens);
    case FaultCode::None:
    case FaultCode::MissingInOut:
    case FaultCode::StackOverflow:
    case FaultCode::AbstractCall:
    case FaultCode::Stopped:
        break; // no value is the cause
    }
    return found.only();
}

} // namespace plc::app
