#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

namespace plc::parse {

namespace {

bool isAssignment(TokenKind kind) {
    switch (kind) {
    case TokenKind::Assign:
    case TokenKind::SetAssign:
    case TokenKind::ResetAssign:
    case TokenKind::RefAssign:
    case TokenKind::TryAssign:
        return true;
    default:
        return false;
    }
}

/// A word of the language with a slip of the pen: IFF, WHLIE, ENDIF.
TokenKind misspelled(std::string_view word) {
    struct Row {
        std::string_view spelling;
        TokenKind kind;
    };
    static constexpr Row rows[] = {{"IF", TokenKind::If},
                                   {"CASE", TokenKind::Case},
                                   {"FOR", TokenKind::For},
                                   {"WHILE", TokenKind::While},
                                   {"REPEAT", TokenKind::Repeat}};
    for (const Row& row : rows) {
        const size_t difference =
            word.size() > row.spelling.size() ? word.size() - row.spelling.size() : row.spelling.size() - word.size();
        if (difference > 1 || word.empty() || (word[0] | 0x20) != (row.spelling[0] | 0x20)) continue;
        if (editDistance(word, row.spelling) == 1 ||
            (word.size() == row.spelling.size() && word.size() >= 4 && editDistance(word, row.spelling) == 2))
            return row.kind;
    }
    return TokenKind::Error;
}

} // namespace

/// The words that end a list of statements, whoever opened it.
bool Parser::atStatementEnd() const {
    switch (kind()) {
    case TokenKind::EndOfFile:
    case TokenKind::Else:
    case TokenKind::Elsif:
    case TokenKind::Until:
    case TokenKind::EndCase:
    case TokenKind::EndFor:
    case TokenKind::EndIf:
    case TokenKind::EndRepeat:
    case TokenKind::EndWhile:
    case TokenKind::EndFunction:
    case TokenKind::EndFunctionBlock:
    case TokenKind::EndClass:
    case TokenKind::EndProgram:
    case TokenKind::EndStruct:
    case TokenKind::EndType:
    case TokenKind::EndUnion:
    case TokenKind::EndVar:
    case TokenKind::EndAction:
    case TokenKind::EndMethod:
    case TokenKind::EndProperty:
    case TokenKind::EndGet:
    case TokenKind::EndSet:
    case TokenKind::EndInterface:
    case TokenKind::EndNamespace:
    case TokenKind::EndStep:
    case TokenKind::EndTransition:
    case TokenKind::EndConfiguration:
    case TokenKind::EndResource:
    case TokenKind::EndTest:
    case TokenKind::Catch:
    case TokenKind::Finally:
    case TokenKind::EndTry:
        return true;
    default:
        return false;
    }
}

Stmt* Parser::makeStmt(StmtKind kind) {
    Stmt* stmt = make<Stmt>();
    stmt->kind = kind;
    return stmt;
}

/// Up to a word that ends a block which is open; a lonely END_IF is told and skipped.
Block Parser::parseStatements(BodyContext context) {
    Block out;
    for (;;) {
        if (atEnd()) return out;
        if (m_inCaseArm && (at(TokenKind::EndCase) || at(TokenKind::Else) || atCaseLabel())) return out;
        if (!m_inCaseArm && at(TokenKind::IntegerLiteral) && endIsOpen(TokenKind::EndCase) &&
            m_open.back() != TokenKind::EndCase && atCaseLabel())
            return out;
        if (atStatementEnd()) {
            if (at(TokenKind::Else) || at(TokenKind::Elsif)) {
                if (endIsOpen(TokenKind::EndIf) || (at(TokenKind::Else) && endIsOpen(TokenKind::EndCase))) return out;
            } else if (at(TokenKind::Until)) {
                if (endIsOpen(TokenKind::EndRepeat)) return out;
            } else if (atAny({TokenKind::Catch, TokenKind::Finally})) {
                if (endIsOpen(TokenKind::EndTry)) return out;
            } else if (endIsOpen(kind())) {
                return out;
            } else if (context != BodyContext::Fragment &&
                       !atAny({TokenKind::EndCase, TokenKind::EndFor, TokenKind::EndIf, TokenKind::EndRepeat,
                               TokenKind::EndWhile, TokenKind::EndVar, TokenKind::EndStruct, TokenKind::EndTry,
                               TokenKind::Catch, TokenKind::Finally})) {
                return out; // the end of another unit: the caller says what is missing
            }
            report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
            advance();
            take(TokenKind::Semicolon);
            continue;
        }
        if (context != BodyContext::Fragment && (atDeclaration() || atPouMember() || atVarSection() || atChart()))
            return out;
        const size_t before = mark();
        out.push_back(parseStatement());
        if (mark() == before) advance(); // never stand still
    }
}

Block Parser::parseBlock(TokenKind end) {
    const OpenBlock open(*this, end);
    const bool arm = std::exchange(m_inCaseArm, false);
    Block block = parseStatements(BodyContext::Unit);
    m_inCaseArm = arm;
    return block;
}

Stmt* Parser::parseStatement() {
    const Nesting nesting(*this);
    const size_t first = mark();
    Stmt* stmt = nullptr;
    // its expressions need room too
    if (!nesting.tooDeep && m_depth > kMaxDepth - 8) report(rangeOf(peek()), findings::NestedTooDeep());
    if (m_depth > kMaxDepth - 8) {
        // jump over the whole depth: every level above would stumble over the same place
        while (!atEnd() && !atDeclaration() &&
               !atAny({TokenKind::EndProgram, TokenKind::EndFunction, TokenKind::EndFunctionBlock, TokenKind::EndClass,
                       TokenKind::EndMethod, TokenKind::EndAction, TokenKind::EndTest}))
            advance();
        m_lastErrorAt = m_at;
        stmt = makeStmt(StmtKind::Empty);
        stmt->range = rangeFrom(first);
        return stmt;
    }
    switch (kind()) {
    case TokenKind::Semicolon:
        stmt = makeStmt(StmtKind::Empty);
        advance();
        break;
    case TokenKind::If:
        stmt = parseIf();
        break;
    case TokenKind::Case:
        stmt = parseCase();
        break;
    case TokenKind::For:
        stmt = parseFor();
        break;
    case TokenKind::While:
        stmt = parseWhile();
        break;
    case TokenKind::Repeat:
        stmt = parseRepeat();
        break;
    case TokenKind::Try:
        stmt = parseTry();
        break;
    case TokenKind::Exit:
    case TokenKind::Continue:
        stmt = makeStmt(at(TokenKind::Exit) ? StmtKind::Exit : StmtKind::Continue);
        advance();
        endStatement();
        break;
    case TokenKind::Return:
        stmt = makeStmt(StmtKind::Return);
        advance();
        if (startsExpression() && !peek().afterNewline) stmt->value = parseExpression();
        endStatement();
        break;
    default:
        stmt = parseSimple();
        break;
    }
    stmt->range = rangeFrom(first);
    return stmt;
}

/// i += 1;  i++;  of other languages.
bool Parser::atCompoundAssignment() const {
    if (!atAny({TokenKind::Plus, TokenKind::Minus, TokenKind::Star, TokenKind::Slash})) return false;
    if (peek().end != peek(1).begin) return false;
    return kind(1) == TokenKind::Equal ||
           (kind(1) == kind() && atAny({TokenKind::Plus, TokenKind::Minus}) && kind(2) == TokenKind::Semicolon);
}

Stmt* Parser::parseCompoundAssignment(Expr* place) {
    const Token op = peek();
    const bool isStep = kind(1) == kind();
    const SourceRange range = joined(rangeOf(op), rangeOf(peek(1)));
    const std::string name(m_text.substr(place->range.begin, place->range.end - place->range.begin));
    const std::string sign(textOf(op));
    advance();
    advance();
    const std::string meant = " := " + name + " " + sign + (isStep ? " 1" : "");
    if (auto* d = report(range, findings::ForeignOperator(std::string(textOf(op)) + std::string(isStep ? sign : "="),
                                                          name + meant + (isStep ? "" : " …"))))
        d->fixes.push_back({fixes::Write(name + meant), {{{range.file, place->range.end, range.end}, meant}}});
    Stmt* stmt = makeStmt(StmtKind::Assign);
    stmt->op = TokenKind::Assign;
    stmt->target = place;
    stmt->value = isStep ? place : parseAssigned();
    endStatement();
    return stmt;
}

/// `name:` and `JMP name;`; null: neither.
Stmt* Parser::parseLabelOrJump() {
    if (atName() && kind(1) == TokenKind::Colon && kind(2) != TokenKind::Equal && !m_inCaseArm) {
        Stmt* stmt = makeStmt(StmtKind::Label);
        stmt->name = takeName();
        advance();
        return stmt;
    }
    if (at(TokenKind::Identifier) && kind(1) == TokenKind::Identifier && !peek(1).afterNewline &&
        (at(SoftWord::Jmp) || equalsIgnoringCase(textOf(peek()), "GOTO"))) {
        Stmt* stmt = makeStmt(StmtKind::Jump);
        advance();
        stmt->name = takeName(phrases::ALabel());
        endStatement();
        return stmt;
    }
    return nullptr;
}

/// WHLIE x DO: reported, and taken for the word that was meant.
bool Parser::correctMisspelledWord() {
    if (!at(TokenKind::Identifier) || (kind(1) != TokenKind::Identifier && kind(1) != TokenKind::Not)) return false;
    const TokenKind meant = misspelled(textOf(peek()));
    if (meant == TokenKind::Error) return false;
    const std::string word(lex::spelling(meant));
    if (auto* d = report(rangeOf(peek()), findings::Expected(word, shown(peek()))))
        d->fixes.push_back({fixes::Write(word), {{rangeOf(peek()), word}}});
    m_tokens[m_at].kind = meant;
    return true;
}

/// What no statement begins with: a sign, a literal.
bool Parser::isNoStatement() const {
    const bool isValue =
        !startsExpression() ||
        atAny({TokenKind::Plus, TokenKind::Minus, TokenKind::Not, TokenKind::LeftBracket, TokenKind::IntegerLiteral,
               TokenKind::RealLiteral, TokenKind::DurationLiteral, TokenKind::DateLiteral, TokenKind::TimeOfDayLiteral,
               TokenKind::DateTimeLiteral, TokenKind::StringLiteral, TokenKind::True, TokenKind::False});
    const bool operatorFunction =
        kind(1) == TokenKind::LeftParen && atAny({TokenKind::And, TokenKind::Or, TokenKind::Xor, TokenKind::Mod});
    return isValue && !operatorFunction;
}

/// `a = b;` and `a : = b;`: reported, and taken for an assignment. Null: something else follows the place.
Stmt* Parser::parseMistakenAssignment(Expr* place) {
    if (at(TokenKind::Equal)) {
        const SourceRange range = rangeOf(peek());
        if (auto* d = report(range, findings::EqualsAsAssignment()))
            d->fixes.push_back({fixes::Write(Verbatim(":=")), {{range, ":="}}});
        advance();
    } else if (at(TokenKind::Colon) && kind(1) == TokenKind::Equal && place->kind != ExprKind::Call &&
               place->kind != ExprKind::Error) {
        const SourceRange range{m_file.file, peek().begin, peek(1).end};
        if (auto* d = report(range, findings::Expected(Verbatim(":="), Verbatim(": ="))))
            d->fixes.push_back({fixes::Write(Verbatim(":=")), {{range, ":="}}});
        advance();
        advance();
    } else {
        return nullptr;
    }
    Stmt* stmt = makeStmt(StmtKind::Assign);
    stmt->target = place;
    stmt->value = parseAssigned();
    endStatement();
    return stmt;
}

/// Labels, jumps, assignments, calls, and the statements of tests.
Stmt* Parser::parseSimple() {
    if (Stmt* jump = parseLabelOrJump()) return jump;
    if (Stmt* test = parseTestStatement()) return test;
    if (correctMisspelledWord()) return parseStatement();
    if (isNoStatement()) {
        report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
        if (!atStatementEnd()) advance();
        skipStatement();
        return makeStmt(StmtKind::Empty);
    }
    Expr* place = parsePlace();
    const Token op = peek();
    if (isAssignment(op.kind)) {
        advance();
        Stmt* stmt = makeStmt(StmtKind::Assign);
        stmt->op = op.kind;
        stmt->target = place;
        stmt->value = parseAssigned();
        decimalComma(stmt->value);
        endStatement();
        return stmt;
    }
    if (Stmt* assignment = parseMistakenAssignment(place)) return assignment;
    if (atCompoundAssignment()) return parseCompoundAssignment(place);
    Stmt* stmt = makeStmt(StmtKind::Call);
    stmt->value = place;
    endStatement();
    return stmt;
}

/// The right side of an assignment; `b := c` in it makes a chain.
Expr* Parser::parseAssigned() {
    const Nesting nesting(*this);
    if (nesting.tooDeep) {
        skipTo({TokenKind::Semicolon});
        return errorExpr();
    }
    Expr* value = parseExpression();
    if (!isAssignment(kind())) return value;
    Expr* chain = make<Expr>();
    chain->kind = ExprKind::AssignChain;
    chain->op = kind();
    chain->operatorRange = rangeOf(peek());
    advance();
    chain->base = value;
    chain->right = parseAssigned();
    chain->range = joined(value->range, chain->right->range);
    setHeight(*chain);
    return chain;
}

/// x := 3,14;
void Parser::decimalComma(Expr* value) {
    if (!at(TokenKind::Comma) || !value || kind(1) != TokenKind::IntegerLiteral ||
        previous().kind != TokenKind::IntegerLiteral || previous().end != peek().begin || peek().end != peek(1).begin)
        return;
    const std::string meant = std::string(textOf(previous())) + "." + std::string(textOf(peek(1)));
    const SourceRange comma = rangeOf(peek());
    if (auto* d = report({m_file.file, previous().begin, peek(1).end}, findings::DecimalComma(meant)))
        d->fixes.push_back({fixes::Write(meant), {{comma, "."}}});
    advance();
    advance();
}

/// THEN, DO, OF: where it is missing the statement goes on as if it stood there; junk before it is skipped.
void Parser::expectWord(TokenKind word, const char* fixText) {
    if (take(word)) return;
    const size_t errorAt = mark();
    for (size_t ahead = 1; ahead < 40; ++ahead) {
        const Token& token = peek(ahead);
        if (token.kind == word) {
            report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
            m_at += ahead + 1;
            return;
        }
        if (token.afterNewline || token.kind == TokenKind::Semicolon || token.kind == TokenKind::EndOfFile) break;
    }
    const SourceRange range = onNewLine() && m_at > 0 ? rangeOf(previous()) : rangeOf(peek());
    insertFix(report(range, findings::Expected(lex::spelling(word), shown(peek()))), fixText);
    m_lastErrorAt = errorAt;
    if (at(TokenKind::Semicolon)) advance(); // IF a; b := 1; END_IF
}

Stmt* Parser::parseIf() {
    Stmt* stmt = makeStmt(StmtKind::If);
    const Token opening = peek();
    bool hasElse = false;
    SourceRange elseIf; // ELSE IF: ELSIF may be meant
    do {
        IfBranch branch;
        const size_t first = mark();
        if (take(TokenKind::Else)) {
            hasElse = true;
            if (at(TokenKind::If) && !peek().afterNewline) elseIf = joined(rangeOf(previous()), rangeOf(peek()));
        } else {
            advance(); // IF or ELSIF
            branch.condition = parseCondition();
            expectWord(TokenKind::Then, " THEN");
        }
        branch.body = parseBlock(TokenKind::EndIf);
        branch.range = rangeFrom(first);
        stmt->branches.push_back(std::move(branch));
        if (hasElse && (at(TokenKind::Else) || at(TokenKind::Elsif)) && !(m_inCaseArm && at(TokenKind::Else)))
            report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
    } while ((at(TokenKind::Elsif) || at(TokenKind::Else)) && !(hasElse && m_inCaseArm));
    if (expectEnd(TokenKind::EndIf, opening, elseIf)) take(TokenKind::Semicolon);
    return stmt;
}

/// True when the tokens up to a colon can be the labels of a CASE arm.
bool Parser::atCaseLabel() const {
    if (at(TokenKind::Identifier) && (kind(1) == TokenKind::Assign || kind(1) == TokenKind::LeftParen)) return false;
    for (size_t ahead = 0; ahead < 4000; ++ahead) {
        switch (kind(ahead)) {
        case TokenKind::Colon:
            return ahead > 0;
        case TokenKind::Identifier:
        case TokenKind::IntegerLiteral:
        case TokenKind::RealLiteral:
        case TokenKind::StringLiteral:
        case TokenKind::WstringLiteral:
        case TokenKind::DurationLiteral:
        case TokenKind::DateLiteral:
        case TokenKind::TimeOfDayLiteral:
        case TokenKind::DateTimeLiteral:
        case TokenKind::TypedPrefix:
        case TokenKind::True:
        case TokenKind::False:
        case TokenKind::Hash:
        case TokenKind::Dot:
        case TokenKind::DotDot:
        case TokenKind::Comma:
        case TokenKind::Plus:
        case TokenKind::Minus:
        case TokenKind::Star:
        case TokenKind::Slash:
        case TokenKind::LeftParen:
        case TokenKind::RightParen:
            break;
        default:
            return false;
        }
        // two operands side by side: a statement without its semicolon
        if (ahead > 0 && kind(ahead) == TokenKind::Identifier && kind(ahead - 1) != TokenKind::Dot &&
            kind(ahead - 1) != TokenKind::DotDot && kind(ahead - 1) != TokenKind::Comma &&
            kind(ahead - 1) != TokenKind::TypedPrefix && kind(ahead - 1) != TokenKind::Plus &&
            kind(ahead - 1) != TokenKind::Minus && kind(ahead - 1) != TokenKind::LeftParen &&
            kind(ahead - 1) != TokenKind::Hash && kind(ahead - 1) != TokenKind::Star &&
            kind(ahead - 1) != TokenKind::Slash)
            return false;
    }
    return false;
}

void Parser::parseCaseLabels(CaseArm& arm) {
    do {
        CaseLabel label;
        label.low = parseExpression();
        if (take(TokenKind::DotDot)) label.high = parseExpression();
        arm.labels.push_back(label);
    } while (take(TokenKind::Comma));
    expect(TokenKind::Colon);
}

Stmt* Parser::parseCase() {
    Stmt* stmt = makeStmt(StmtKind::Case);
    const Token opening = peek();
    advance();
    stmt->value = parseCondition();
    expectWord(TokenKind::Of, " OF");
    {
        const OpenBlock open(*this, TokenKind::EndCase);
        const bool outer = m_inCaseArm;
        while (!atEnd() && !at(TokenKind::EndCase)) {
            const size_t first = mark();
            if (take(TokenKind::Else)) {
                take(TokenKind::Colon);
                stmt->hasElse = true;
                m_inCaseArm = false;
                stmt->elseBody = parseStatements(BodyContext::Unit);
                m_inCaseArm = outer;
                break;
            }
            if (atStatementEnd() || atDeclaration() || atPouMember()) break;
            CaseArm arm;
            if (atCaseLabel() || at(TokenKind::IntegerLiteral)) { // the colon may be what is missing
                parseCaseLabels(arm);
            } else {
                expected(phrases::ACaseLabel());
                if (!startsStatement()) advance();
                if (stmt->arms.empty() && atEnd()) break;
            }
            m_inCaseArm = true;
            arm.body = parseStatements(BodyContext::Unit);
            m_inCaseArm = outer;
            arm.range = rangeFrom(first);
            stmt->arms.push_back(std::move(arm));
            if (mark() == first) advance();
        }
    }
    if (expectEnd(TokenKind::EndCase, opening)) take(TokenKind::Semicolon);
    return stmt;
}

Stmt* Parser::parseFor() {
    Stmt* stmt = makeStmt(StmtKind::For);
    const Token opening = peek();
    advance();
    stmt->target = parsePlace();
    if (at(TokenKind::Equal)) {
        const SourceRange range = rangeOf(peek());
        if (auto* d = report(range, findings::Expected(Verbatim(":="), Verbatim("="))))
            d->fixes.push_back({fixes::Write(Verbatim(":=")), {{range, ":="}}});
        advance();
    } else {
        expect(TokenKind::Assign);
    }
    stmt->from = parseExpression();
    if (take(TokenKind::To))
        stmt->to = parseExpression();
    else {
        expected(Verbatim("TO"));
        stmt->to = errorExpr();
        if (startsExpression() && !peek().afterNewline) stmt->to = parseExpression();
    }
    if (take(TokenKind::By)) stmt->by = parseExpression();
    expectWord(TokenKind::Do, " DO");
    stmt->body = parseBlock(TokenKind::EndFor);
    if (expectEnd(TokenKind::EndFor, opening)) take(TokenKind::Semicolon);
    return stmt;
}

Stmt* Parser::parseWhile() {
    Stmt* stmt = makeStmt(StmtKind::While);
    const Token opening = peek();
    advance();
    stmt->value = parseCondition();
    expectWord(TokenKind::Do, " DO");
    stmt->body = parseBlock(TokenKind::EndWhile);
    if (expectEnd(TokenKind::EndWhile, opening)) take(TokenKind::Semicolon);
    return stmt;
}

Stmt* Parser::parseRepeat() {
    Stmt* stmt = makeStmt(StmtKind::Repeat);
    const Token opening = peek();
    advance();
    stmt->body = parseBlock(TokenKind::EndRepeat);
    if (take(TokenKind::Until)) {
        stmt->value = parseCondition();
        take(TokenKind::Semicolon);
    } else {
        expected(Verbatim("UNTIL"));
        stmt->value = errorExpr();
    }
    if (expectEnd(TokenKind::EndRepeat, opening)) take(TokenKind::Semicolon);
    return stmt;
}

/// __TRY … __CATCH(code) … __FINALLY … __ENDTRY (CODESYS): at least one of the two parts behind.
Stmt* Parser::parseTry() {
    Stmt* stmt = makeStmt(StmtKind::Try);
    const Token opening = peek();
    const auto part = [&](bool isCatch) {
        IfBranch branch;
        const size_t first = mark();
        advance();
        if (isCatch && at(TokenKind::LeftParen)) { // without a code: whatever the fault is
            advance();
            branch.condition = parsePlace();
            expect(TokenKind::RightParen);
        }
        branch.body = parseBlock(TokenKind::EndTry);
        branch.range = rangeFrom(first);
        return branch;
    };
    stmt->branches.push_back(part(false));
    if (at(TokenKind::Catch)) stmt->branches.push_back(part(true));
    if (at(TokenKind::Finally)) {
        stmt->hasElse = true;
        stmt->elseBody = part(false).body;
    }
    if (stmt->branches.size() < 2 && !stmt->hasElse) expected(Verbatim("__CATCH"));
    while (atAny({TokenKind::Catch, TokenKind::Finally})) {
        report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
        const Block rest = part(at(TokenKind::Catch)).body;
        stmt->elseBody.insert(stmt->elseBody.end(), rest.begin(), rest.end());
    }
    if (expectEnd(TokenKind::EndTry, opening)) take(TokenKind::Semicolon);
    return stmt;
}

} // namespace plc::parse
