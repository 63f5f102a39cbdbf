#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

namespace plc::parse {

bool Parser::atStep() const {
    if (kind(1) != TokenKind::Identifier || peek(1).afterNewline) return false;
    return at(SoftWord::InitialStep) || at(SoftWord::Step);
}

bool Parser::atTransition() const {
    if (!at(SoftWord::Transition)) return false;
    if (kind(1) == TokenKind::LeftParen) return peek(2).soft == SoftWord::Priority;
    return kind(1) == TokenKind::Identifier && kind(2) != TokenKind::Colon;
}

bool Parser::atChart() const { return at(TokenKind::Identifier) && (atStep() || atTransition()); }

/// Steps, transitions and actions in any order, up to what belongs to the unit around.
SfcBody* Parser::parseChart() {
    SfcBody* chart = make<SfcBody>();
    const size_t first = mark();
    while (!atEnd()) {
        if (take(TokenKind::Semicolon)) continue;
        const size_t before = mark();
        if (atStep()) {
            chart->steps.push_back(parseStep());
        } else if (atTransition()) {
            chart->transitions.push_back(parseTransition());
        } else if (atPouMember() && at(SoftWord::Action)) {
            chart->actions.push_back(parseAction());
        } else if (atPouMember() || atDeclaration() || atVarSection()) {
            break;
        } else if (atStatementEnd() &&
                   (endIsOpen(kind()) ||
                    !atAny({TokenKind::EndStep, TokenKind::EndTransition, TokenKind::EndIf, TokenKind::EndCase,
                            TokenKind::EndFor, TokenKind::EndWhile, TokenKind::EndRepeat, TokenKind::Else,
                            TokenKind::Elsif, TokenKind::Until, TokenKind::EndVar}))) {
            break;
        } else {
            report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
            do advance();
            while (!atEnd() && !atChart() && !atPouMember() && !atStatementEnd() && !atDeclaration() &&
                   !atVarSection());
            if (atAny({TokenKind::EndStep, TokenKind::EndTransition}) && !endIsOpen(kind())) advance();
            m_lastErrorAt = SIZE_MAX;
        }
        if (mark() == before) advance();
    }
    chart->range = rangeFrom(first);
    return chart;
}

/// STEP name {minTime := T#1s}: action(N); END_STEP  (IEC 61131-3, 2.6.2)
StepDecl* Parser::parseStep() {
    StepDecl* step = make<StepDecl>();
    const size_t first = mark();
    const Token opening = peek();
    step->isInitial = at(SoftWord::InitialStep);
    advance();
    step->name = takeName();
    step->pragmas = pragmasHere();
    if (!take(TokenKind::Colon)) {
        if (auto* d = report(rangeOf(previous()), findings::Expected(Verbatim(":"), shown(peek()))))
            d->fixes.push_back({fixes::Insert(Verbatim(":")), {{afterPrevious(), ":"}}});
        m_lastErrorAt = SIZE_MAX;
    }
    {
        const OpenBlock open(*this, TokenKind::EndStep);
        parseAssociations(*step);
    }
    expectEnd(TokenKind::EndStep, opening);
    step->range = rangeFrom(first);
    step->extent = extentOf(step->range, first);
    return step;
}

/// IF …, x := …, block.x := …, block(in := …): what belongs into an ACTION.
bool Parser::startsStatementInStep() const {
    if (atAny({TokenKind::If, TokenKind::Case, TokenKind::For, TokenKind::While, TokenKind::Repeat, TokenKind::Return}))
        return true;
    if (!atName()) return false;
    if (kind(1) == TokenKind::LeftParen) return kind(2) == TokenKind::Identifier && kind(3) == TokenKind::Assign;
    return kind(1) == TokenKind::Assign || kind(1) == TokenKind::SetAssign || kind(1) == TokenKind::ResetAssign ||
           kind(1) == TokenKind::LeftBracket || kind(1) == TokenKind::Caret ||
           (kind(1) == TokenKind::Dot && kind(2) == TokenKind::Identifier &&
            (kind(3) == TokenKind::Assign || kind(3) == TokenKind::LeftParen || kind(3) == TokenKind::Dot));
}

void Parser::parseAssociations(StepDecl& step) {
    while (!atEnd() && !atStatementEnd()) {
        if (take(TokenKind::Semicolon)) continue;
        if (atChart() || atPouMember() || atDeclaration()) return;
        const size_t first = mark();
        if (startsStatementInStep()) {
            auto* told = report(rangeOf(peek()), findings::StatementInStep());
            do advance();
            while (!atEnd() && !atAny({TokenKind::EndStep, TokenKind::EndTransition}) && !atChart() && !atPouMember() &&
                   !atDeclaration() && !atVarSection());
            if (told) told->range = joined(told->range, rangeOf(previous()));
            m_lastErrorAt = SIZE_MAX;
            return;
        }
        ActionAssociation association;
        association.action = takeName(phrases::AnAction());
        if (!association.action.isValid()) {
            while (!atEnd() && !at(TokenKind::Semicolon) && !atStatementEnd() && !atChart() && !atDeclaration())
                advance();
            m_lastErrorAt = SIZE_MAX;
            if (mark() == first) return;
            continue;
        }
        if (take(TokenKind::LeftParen)) {
            if (at(TokenKind::Identifier) && kind(1) != TokenKind::Dot) {
                association.qualifier = nameOf(peek());
                advance();
                take(TokenKind::Comma);
            }
            bool firstOperand = true;
            while (!at(TokenKind::RightParen) && !atEnd() && !at(TokenKind::Semicolon) && !atStatementEnd()) {
                const std::string_view q = association.qualifier.text;
                const bool timed = q.size() <= 2 && !q.empty() &&
                                   (std::string_view("LlDd").find(q[0]) != std::string_view::npos ||
                                    (q.size() == 2 && std::string_view("LlDd").find(q[1]) != std::string_view::npos));
                const bool isTime = firstOperand && (timed || !at(TokenKind::Identifier));
                if (isTime)
                    association.time = parseExpression();
                else if (atName())
                    association.indicators.push_back(takeName());
                else {
                    expected(phrases::AVariablesName());
                    break;
                }
                firstOperand = false;
                if (!take(TokenKind::Comma)) break;
            }
            if (!take(TokenKind::RightParen)) {
                expected(Verbatim(")"));
                while (!atEnd() && !atAny({TokenKind::RightParen, TokenKind::Semicolon}) && !atStatementEnd() &&
                       !onNewLine())
                    advance();
                take(TokenKind::RightParen);
            }
        }
        association.range = rangeFrom(first);
        step.actions.push_back(std::move(association));
        if (take(TokenKind::Semicolon)) {
            m_lastErrorAt = SIZE_MAX;
            continue;
        }
        if (at(TokenKind::EndStep))
            missingSemicolon(true);
        else if (m_lastErrorAt != m_at && (onNewLine() || atStatementEnd()))
            missingSemicolon(false);
        else if (m_lastErrorAt != m_at) {
            report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
            while (!atEnd() && !at(TokenKind::Semicolon) && !atStatementEnd() && !onNewLine()) advance();
        }
    }
}

void Parser::parseStepNames(std::vector<Name>& out) {
    const bool list = take(TokenKind::LeftParen);
    const size_t first = mark();
    do {
        const Name name = takeName(phrases::AStepsName());
        if (name.isValid()) out.push_back(name);
    } while ((list || (at(TokenKind::Comma) && kind(1) == TokenKind::Identifier)) && take(TokenKind::Comma));
    if (list) {
        expect(TokenKind::RightParen);
    } else if (out.size() > 1) { // FROM a, b TO
        const SourceRange names = rangeFrom(first);
        const std::string own = "(" + std::string(m_text.substr(names.begin, names.end - names.begin)) + ")";
        if (auto* d = report(names, findings::Expected(Verbatim("("), out.front().text)))
            d->fixes.push_back({fixes::Write(own), {{names, own}}});
        m_lastErrorAt = SIZE_MAX;
    }
}

/// TRANSITION name (PRIORITY := 1) FROM a TO (b, c) := condition; END_TRANSITION  (IEC 61131-3, 2.6.3)
TransitionDecl* Parser::parseTransition() {
    TransitionDecl* transition = make<TransitionDecl>();
    const size_t first = mark();
    const Token opening = peek();
    advance();
    if (at(TokenKind::Identifier) &&
        !(at(SoftWord::From) && !(kind(1) == TokenKind::Identifier && peek(1).soft == SoftWord::From))) {
        transition->name = nameOf(peek());
        advance();
    }
    if (at(TokenKind::LeftParen) && peek(1).soft == SoftWord::Priority) {
        advance();
        advance();
        expect(TokenKind::Assign);
        transition->priority = parseExpression();
        expect(TokenKind::RightParen);
    }
    if (take(SoftWord::From))
        parseStepNames(transition->from);
    else
        expected(Verbatim("FROM"));
    if (take(TokenKind::To))
        parseStepNames(transition->to);
    else
        expected(Verbatim("TO"));
    {
        const OpenBlock open(*this, TokenKind::EndTransition);
        if (take(TokenKind::Assign)) {
            transition->condition = parseCondition();
            if (!take(TokenKind::Semicolon)) {
                if (at(TokenKind::EndTransition))
                    missingSemicolon(true);
                else if (m_lastErrorAt != m_at && (atStatementEnd() || atChart()))
                    missingSemicolon(false);
                else if (m_lastErrorAt != m_at) {
                    report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
                }
            }
        } else if (take(TokenKind::Colon)) {
            if (atInstructionList())
                transition->ilCondition = parseInstructions(BodyContext::Unit);
            else {
                expected(phrases::AssignOrInstructions());
            }
        } else {
            expected(Verbatim(":="));
        }
        while (!atEnd() && !atStatementEnd() && !atChart() && !atPouMember() && !atDeclaration())
            advance(); // the rest of a condition that cannot be read
    }
    expectEnd(TokenKind::EndTransition, opening);
    transition->range = rangeFrom(first);
    transition->extent = extentOf(transition->range, first);
    m_lastErrorAt = SIZE_MAX;
    return transition;
}

} // namespace plc::parse
