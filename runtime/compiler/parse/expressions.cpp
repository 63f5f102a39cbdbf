#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

namespace plc::parse {

namespace {

/// The first `$` sequence that means nothing (IEC 61131-3, table 6), as offset and length.
std::string_view badEscape(std::string_view literal, bool wide) {
    const auto isHex = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
    };
    for (size_t i = 1; i + 1 < literal.size(); ++i) {
        if (literal[i] != '$') continue;
        const char c = literal[i + 1];
        if (std::string_view("$'\"LlNnPpRrTt").find(c) != std::string_view::npos) {
            ++i;
            continue;
        }
        const size_t digits = wide ? 4 : 2;
        size_t have = 0;
        while (have < digits && i + 1 + have + 1 < literal.size() && isHex(literal[i + 1 + have])) ++have;
        if (have != digits) return literal.substr(i, 2 + (have > 0 ? have - 1 : 0));
        i += digits;
    }
    return {};
}

} // namespace

Expr* Parser::errorExpr() {
    Expr* e = make<Expr>();
    e->range = rangeOf(peek());
    return e;
}

/// Trees deeper than whoever walks them may recurse are refused here, once for all.
void Parser::setHeight(Expr& e) {
    uint32_t height = 0;
    if (e.base) height = std::max(height, e.base->height);
    if (e.right) height = std::max(height, e.right->height);
    for (const Argument& argument : e.arguments)
        if (argument.value) height = std::max(height, argument.value->height);
    e.height = height + 1;
    if (e.height <= kMaxHeight) return;
    m_sink.emit(e.range, findings::NestedTooDeep());
    e = Expr{};
    e.range = rangeOf(previous());
    skipTo({TokenKind::Semicolon});
}

Expr* Parser::makeName(Name name) {
    Expr* e = make<Expr>();
    e->kind = ExprKind::NameRef;
    e->name = name;
    e->range = name.range;
    return e;
}

Expr* Parser::parseExpression() { return parseBinary(1); }

/// A condition: an assignment in it is a comparison with one character too many.
Expr* Parser::parseCondition() {
    const bool outer = m_inCondition;
    m_inCondition = true;
    Expr* e = parseBinary(1);
    if (at(TokenKind::Assign)) {
        const SourceRange range = rangeOf(peek());
        if (auto* d = report(range, findings::AssignInCondition()))
            d->fixes.push_back({fixes::Write(Verbatim("=")), {{range, "="}}});
        advance();
        Expr* compare = make<Expr>();
        compare->kind = ExprKind::Binary;
        compare->op = TokenKind::Equal;
        compare->operatorRange = range;
        compare->base = e;
        compare->right = parseBinary(1);
        compare->range = joined(e->range, compare->right->range);
        setHeight(*compare);
        e = compare;
    }
    m_inCondition = outer;
    return e;
}

Expr* Parser::parseBinary(int level) {
    const Nesting nesting(*this);
    if (nesting.tooDeep) {
        skipTo({TokenKind::Semicolon});
        return errorExpr();
    }
    Expr* left = parseUnary();
    for (;;) {
        const int found = lex::precedenceOf(kind());
        if (found < level || found == 0) return left;
        const Token op = peek();
        advance();
        Expr* right = found == 8 ? parseUnary() : parseBinary(found + 1);
        Expr* e = make<Expr>();
        e->kind = ExprKind::Binary;
        e->op = op.kind == TokenKind::Ampersand ? TokenKind::And : op.kind;
        e->operatorRange = rangeOf(op);
        e->base = left;
        e->right = right;
        e->range = joined(left->range, right->range);
        setHeight(*e);
        left = e;
    }
}

Expr* Parser::parseUnary() {
    if (!atAny({TokenKind::Not, TokenKind::Minus, TokenKind::Plus})) return parsePostfix(parsePrimary());
    const Nesting nesting(*this);
    const Token op = peek();
    advance();
    if (nesting.tooDeep) {
        skipTo({TokenKind::Semicolon});
        return errorExpr();
    }
    Expr* e = make<Expr>();
    e->kind = ExprKind::Unary;
    e->op = op.kind;
    e->operatorRange = rangeOf(op);
    e->base = parseUnary();
    e->range = joined(e->operatorRange, e->base->range);
    setHeight(*e);
    return e;
}

Expr* Parser::parsePlace() { return parsePostfix(parsePrimary()); }

/// The first operand of an IL instruction: no operators, but a sign.
Expr* Parser::parsePrimaryIl() { return atAny({TokenKind::Minus, TokenKind::Plus}) ? parseUnary() : parsePlace(); }

Expr* Parser::parsePrimary() {
    const Token token = peek();
    switch (token.kind) {
    case TokenKind::Identifier: {
        advance();
        Expr* e = makeName(nameOf(token));
        if (token.soft == SoftWord::This) e->kind = ExprKind::This;
        if (token.soft == SoftWord::Super) e->kind = ExprKind::Super;
        if (token.soft == SoftWord::Pointer && at(TokenKind::To)) { // a type where __NEW wants one: POINTER of T
            const Nesting nesting(*this);
            advance();
            if (nesting.tooDeep) {
                skipTo({TokenKind::Semicolon});
                return errorExpr();
            }
            Expr* pointer = make<Expr>();
            pointer->kind = ExprKind::Call;
            pointer->base = e;
            pointer->arguments.emplace_back();
            pointer->arguments.back().value = parsePlace();
            pointer->arguments.back().range = pointer->arguments.back().value->range;
            pointer->range = joined(e->range, pointer->arguments.back().range);
            return pointer;
        }
        return e;
    }
    case TokenKind::Hash:
        if (atName()) {
            advance();
            Expr* e = makeName(nameOf(peek()));
            e->range.begin = token.begin;
            advance();
            return e;
        }
        break;
    case TokenKind::TypedPrefix:
        return parseTyped();
    case TokenKind::DirectAddress: {
        advance();
        Expr* e = make<Expr>();
        e->kind = ExprKind::Address;
        e->text = textOf(token);
        e->range = rangeOf(token);
        return e;
    }
    case TokenKind::LeftParen:
        return parseParenthesised();
    case TokenKind::LeftBracket:
        return parseArrayInit();
    case TokenKind::And:
    case TokenKind::Or:
    case TokenKind::Xor:
    case TokenKind::Mod:
    case TokenKind::Not:
        if (kind(1) == TokenKind::LeftParen) { // AND(a, b): the operator as a function
            advance();
            return makeName(nameOf(token));
        }
        break;
    case TokenKind::WstringLiteral:
        // "Motor".run and "Motor" := …: a quoted name
        if (token.end - token.begin > 2) switch (kind(1)) {
            case TokenKind::Dot:
            case TokenKind::LeftBracket:
            case TokenKind::LeftParen:
            case TokenKind::Caret:
            case TokenKind::Assign:
            case TokenKind::SetAssign:
            case TokenKind::ResetAssign:
                advance();
                return makeName(nameOf(token));
            default:
                for (std::string_view quoted : m_quotedNames)
                    if (equalsIgnoringCase(quoted, nameOf(token).text)) {
                        advance();
                        return makeName(nameOf(token));
                    }
                break;
            }
        break;
    default:
        break;
    }
    if (lex::isLiteral(token.kind)) return parseLiteral();
    expected(phrases::AnExpression());
    return errorExpr();
}

Expr* Parser::parseLiteral() {
    const Token token = peek();
    advance();
    Expr* e = make<Expr>();
    e->kind = ExprKind::Literal;
    e->op = token.kind;
    e->text = textOf(token);
    e->range = rangeOf(token);
    if (token.kind == TokenKind::StringLiteral || token.kind == TokenKind::WstringLiteral) {
        const std::string_view bad = badEscape(e->text, token.kind == TokenKind::WstringLiteral);
        if (!bad.empty()) {
            const auto begin = static_cast<uint32_t>(bad.data() - m_text.data());
            m_sink.emit({m_file.file, begin, begin + static_cast<uint32_t>(bad.size())},
                        findings::InvalidLiteral(bad, phrases::StringLiteral()));
        }
    }
    return e;
}

/// INT#5  INT#-5  STRING#'a'  BOOL#TRUE  Color#Red
Expr* Parser::parseTyped() {
    const Token prefixToken = peek();
    advance();
    Name prefix = nameOf(prefixToken);
    prefix.text.remove_suffix(1);
    --prefix.range.end;
    const Token token = peek();
    const bool sign = atAny({TokenKind::Minus, TokenKind::Plus}) &&
                      (kind(1) == TokenKind::IntegerLiteral || kind(1) == TokenKind::RealLiteral);
    if (sign) advance();
    if (lex::isLiteral(kind())) {
        Expr* e = parseLiteral();
        e->prefix = prefix;
        if (sign) e->text = m_text.substr(token.begin, previous().end - token.begin);
        e->range.begin = prefixToken.begin;
        return e;
    }
    if (at(TokenKind::TypedPrefix)) { // INT#INT#5: the inner one says it again
        return parseTyped();
    }
    Expr* e = make<Expr>();
    e->range = rangeOf(prefixToken);
    e->prefix = prefix;
    if (!at(TokenKind::Identifier)) {
        expected(phrases::AValue());
        return e;
    }
    e->kind = ExprKind::TypedName;
    e->name = nameOf(peek());
    advance();
    e->range = joined(e->range, e->name.range);
    return e;
}

Expr* Parser::parseParenthesised() {
    const Token open = peek();
    advance();
    // (a := 1, b := 2): the initial value of a structure; in a condition a slip that parseCondition tells
    const bool named = atName() && kind(1) == TokenKind::Assign;
    if (!m_inCondition && (named || (m_inInitialiser && at(TokenKind::RightParen)))) {
        Expr* e = make<Expr>();
        e->kind = ExprKind::StructInit;
        parseArguments(e->arguments, TokenKind::RightParen);
        e->range = {m_file.file, open.begin, previous().end};
        setHeight(*e);
        return e;
    }
    Expr* e = m_inCondition ? parseCondition() : parseExpression();
    e->parenthesised = true;
    if (!take(TokenKind::RightParen)) {
        expected(Verbatim(")"));
        if (at(TokenKind::Comma) && !m_inInitialiser)
            skipTo({TokenKind::Semicolon, TokenKind::RightParen, TokenKind::Then, TokenKind::Do, TokenKind::Of}),
                take(TokenKind::RightParen);
    }
    e->range = {m_file.file, open.begin, std::max(previous().end, e->range.end)};
    return e;
}

/// [a, 3(0), b]
Expr* Parser::parseArrayInit() {
    const Token open = peek();
    const bool outer = std::exchange(m_inInitialiser, true);
    advance();
    Expr* e = make<Expr>();
    e->kind = ExprKind::ArrayInit;
    parseArguments(e->arguments, TokenKind::RightBracket);
    e->range = {m_file.file, open.begin, previous().end};
    m_inInitialiser = outer;
    setHeight(*e);
    return e;
}

/// Lib.Color#Red: a member of a member; the first takes its end from the sign.
Expr* Parser::parseQualifiedEnumerator(Expr* member) {
    member->kind = ExprKind::Member;
    member->name = nameOf(peek());
    member->name.text.remove_suffix(1);
    --member->name.range.end;
    member->range = joined(member->base->range, member->name.range);
    advance();
    Expr* value = make<Expr>();
    value->kind = ExprKind::Member;
    value->name = nameOf(peek());
    value->base = member;
    advance();
    member->height = member->base->height + 1;
    return value;
}

/// .Name, .3, .%X3. `isNamed` becomes false when no name follows the point.
Expr* Parser::parseMember(Expr* base, bool& isNamed) {
    const Token dot = peek();
    advance();
    Expr* e = make<Expr>();
    e->base = base;
    const Token member = peek();
    const bool adjacent = member.begin == dot.end && !member.afterNewline;
    if (!member.afterNewline && (member.kind == TokenKind::IntegerLiteral || member.kind == TokenKind::DirectAddress)) {
        e->kind = ExprKind::Bit;
        e->text = textOf(member);
        advance();
    } else if ((member.kind == TokenKind::Identifier &&
                (!member.afterNewline || (base->kind == ExprKind::Call && kind(1) == TokenKind::LeftParen))) ||
               (adjacent && (lex::isKeyword(member.kind) || member.kind == TokenKind::WstringLiteral))) {
        e->kind = ExprKind::Member;
        e->name = nameOf(member);
        advance();
    } else if (member.kind == TokenKind::TypedPrefix && kind(1) == TokenKind::Identifier) {
        return parseQualifiedEnumerator(e);
    } else {
        expected(phrases::AMembersName());
        e->kind = ExprKind::Member; // of no name: completion asks what stands before the point
        e->range = {m_file.file, base->range.begin, dot.end};
        e->height = base->height + 1;
        isNamed = false;
    }
    return e;
}

/// A call, or the repetition 3(0) of an initial value. Null: the bracket does not belong to `base`.
Expr* Parser::parseCall(Expr* base) {
    const bool isLiteral = base->kind == ExprKind::Literal;
    if (isLiteral && (!m_inInitialiser || base->op != TokenKind::IntegerLiteral)) return nullptr;
    if (base->kind == ExprKind::Error || base->kind == ExprKind::ArrayInit || base->kind == ExprKind::StructInit ||
        base->kind == ExprKind::TypedName)
        return nullptr;
    advance();
    Expr* e = make<Expr>();
    e->kind = isLiteral ? ExprKind::Repeat : ExprKind::Call;
    e->base = base;
    const bool condition = isLiteral ? m_inCondition : std::exchange(m_inCondition, false);
    parseArguments(e->arguments, TokenKind::RightParen);
    m_inCondition = condition;
    return e;
}

Expr* Parser::parseIndex(Expr* base) {
    advance();
    Expr* e = make<Expr>();
    e->kind = ExprKind::Index;
    e->base = base;
    if (at(TokenKind::RightBracket)) expected(phrases::AnIndex());
    parseArguments(e->arguments, TokenKind::RightBracket, LeftOut::Refused);
    return e;
}

Expr* Parser::parsePostfix(Expr* base) {
    for (;;) {
        Expr* e = nullptr;
        bool isNamed = true;
        switch (kind()) {
        case TokenKind::Dot:
            e = parseMember(base, isNamed);
            if (!isNamed) return e;
            break;
        case TokenKind::LeftBracket:
            e = parseIndex(base);
            break;
        case TokenKind::Caret:
            advance();
            e = make<Expr>();
            e->kind = ExprKind::Deref;
            e->base = base;
            break;
        case TokenKind::LeftParen:
            e = parseCall(base);
            break;
        default:
            break;
        }
        if (!e) return base;
        e->range = {m_file.file, base->range.begin, previous().end};
        setHeight(*e);
        if (e->kind == ExprKind::Error) return e;
        base = e;
    }
}

/// What stands between the brackets, which are open; takes the closing one.
void Parser::parseArguments(std::vector<Argument>& out, TokenKind close, LeftOut leftOut) {
    const Nesting nesting(*this);
    if (nesting.tooDeep) return skipTo({TokenKind::Semicolon});
    bool missingComma = false;
    while (!at(close) && !atEnd() && !at(TokenKind::Semicolon)) {
        const size_t first = mark();
        Argument argument;
        const size_t nameAt = at(TokenKind::Not) ? 1 : 0;
        const bool hash = kind(nameAt) == TokenKind::Hash;
        const TokenKind sign = kind(nameAt + (hash ? 2 : 1));
        if (atName(nameAt) && (sign == TokenKind::Output || (sign == TokenKind::Assign && nameAt == 0))) {
            argument.negated = take(TokenKind::Not);
            argument.name = takeName();
            argument.kind = sign == TokenKind::Output ? ArgumentKind::Output : ArgumentKind::Input;
            advance();
            if (m_inInstruction && at(TokenKind::LeftParen) && atInstructionList(1)) {
                advance();
                Block* block = make<Block>();
                *block = parseInstructions(BodyContext::Unit);
                argument.instructions = block;
                expect(TokenKind::RightParen);
            } else if (!at(TokenKind::Comma) && !at(close)) {
                argument.value = parseExpression();
            }
        } else if (!at(TokenKind::Comma)) {
            argument.value = parseExpression();
        } else if (leftOut == LeftOut::Refused) {
            expected(phrases::AnIndex());
        }
        argument.range = rangeFrom(first);
        out.push_back(std::move(argument));
        if (take(TokenKind::Comma)) {
            // TwinCAT takes a comma behind the last of arguments that stand on lines of their own
            const bool isLast = at(close) && peek().afterNewline;
            if (at(close) && !isLast) expected(phrases::AnArgument());
            continue;
        }
        if (at(close)) break;
        if (startsExpression() && m_lastErrorAt != m_at && !peek().afterNewline && !missingComma) {
            missingComma = true; // once: more of them are junk
            expected(phrases::OneOf({{","}}, lex::spelling(close)));
            if (mark() != first) continue;
        }
        break;
    }
    if (take(close)) return;
    expected(lex::spelling(close));
    // junk before the closing bracket of the same line
    for (size_t ahead = 0; ahead < 30 && kind(ahead) != TokenKind::EndOfFile && kind(ahead) != TokenKind::Semicolon &&
                           (ahead == 0 || !peek(ahead).afterNewline);
         ++ahead)
        if (kind(ahead) == close) {
            m_at += ahead + 1;
            return;
        }
}

} // namespace plc::parse
