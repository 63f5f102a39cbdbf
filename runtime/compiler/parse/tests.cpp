#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

namespace plc::parse {

/// TEST 'name' … END_TEST: sections and statements, from a cold start in virtual time.
TestDecl* Parser::parseTest() {
    TestDecl* test = make<TestDecl>();
    const size_t first = mark();
    const Token opening = peek();
    advance();
    std::string_view title = textOf(peek());
    if (title.starts_with('\'')) title.remove_prefix(1);
    if (title.ends_with('\'')) title.remove_suffix(1);
    test->title = title;
    test->titleRange = rangeOf(peek());
    advance();
    take(TokenKind::Semicolon);
    {
        const OpenBlock open(*this, TokenKind::EndTest);
        const bool outer = std::exchange(m_inTest, true);
        while (atVarSection()) test->sections.push_back(parseVarSection());
        test->body = parseStatements(BodyContext::Unit);
        m_inTest = outer;
    }
    expectEnd(TokenKind::EndTest, opening);
    take(TokenKind::Semicolon);
    test->range = rangeFrom(first);
    return test;
}

/// Is the word here that of a test's statement, and not a variable or block of that name?
bool Parser::atTestStatement() const {
    switch (peek().soft) {
    case SoftWord::Run:
    case SoftWord::Assert:
    case SoftWord::Force:
    case SoftWord::Release:
    case SoftWord::Compare:
    case SoftWord::PowerOff:
        break;
    default:
        return false;
    }
    switch (kind(1)) {
    case TokenKind::Assign:
    case TokenKind::Dot:
    case TokenKind::LeftBracket:
    case TokenKind::Caret:
    case TokenKind::Semicolon:
    case TokenKind::SetAssign:
    case TokenKind::ResetAssign:
    case TokenKind::Equal:
    case TokenKind::Colon:
        return false;
    case TokenKind::LeftParen:
        return m_inTest;
    default:
        break;
    }
    return m_inTest || kind(1) == TokenKind::Identifier || kind(1) == TokenKind::IntegerLiteral ||
           kind(1) == TokenKind::DurationLiteral || kind(1) == TokenKind::StringLiteral ||
           kind(1) == TokenKind::Until || kind(1) == TokenKind::Not;
}

/// RUN UNTIL condition FOR time; RUN 5 SCANS; RUN T#5s
void Parser::parseRun(Stmt& stmt) {
    if (take(TokenKind::Until)) {
        stmt.value = parseCondition();
        if (take(TokenKind::For))
            stmt.to = parseExpression();
        else
            expected(phrases::ForAndATime());
        return;
    }
    stmt.to = parseExpression();
    stmt.countsScans = take(SoftWord::Scans);
    if (!stmt.countsScans && at(TokenKind::Identifier) && equalsIgnoringCase(textOf(peek()), "SCAN")) {
        stmt.countsScans = true;
        advance();
    }
}

/// COMPARE value, TOLERANCE := limit
void Parser::parseCompare(Stmt& stmt) {
    stmt.value = parseExpression();
    if (!take(TokenKind::Comma)) return;
    if (atName() && kind(1) == TokenKind::Assign) {
        if (!equalsIgnoringCase(textOf(peek()), "TOLERANCE")) expected(Verbatim("TOLERANCE"));
        advance();
        advance();
    }
    stmt.to = parseExpression();
}

/// RUN, ASSERT, FORCE, RELEASE, COMPARE, POWER_OFF; elsewhere these are names.
Stmt* Parser::parseTestStatement() {
    if (!at(TokenKind::Identifier) || !atTestStatement()) return nullptr;
    const SoftWord word = peek().soft;
    if (!m_inTest) report(rangeOf(peek()), findings::TestUnknownStatement(shown(peek())));
    advance();
    Stmt* stmt = makeStmt(StmtKind::Run);
    switch (word) {
    case SoftWord::Run:
        parseRun(*stmt);
        break;
    case SoftWord::Assert:
        stmt->kind = StmtKind::Assert;
        stmt->value = parseCondition();
        if (take(TokenKind::Comma)) stmt->to = parseExpression();
        break;
    case SoftWord::Force:
        stmt->kind = StmtKind::Force;
        stmt->target = parsePlace();
        if (expect(TokenKind::Assign)) stmt->value = parseExpression();
        break;
    case SoftWord::Release:
        stmt->kind = StmtKind::Release;
        stmt->target = parsePlace();
        break;
    case SoftWord::PowerOff:
        stmt->kind = StmtKind::PowerOff;
        stmt->to = parseExpression();
        break;
    default:
        stmt->kind = StmtKind::Compare;
        parseCompare(*stmt);
        break;
    }
    endStatement();
    return stmt;
}

} // namespace plc::parse
