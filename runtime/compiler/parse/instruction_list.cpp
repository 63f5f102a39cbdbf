#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

#include <array>

namespace plc::parse {

namespace {

/// Operators of IEC 61131-3 ed. 2, table 52, and the modifiers each may carry.
struct Operator {
    std::string_view name;
    bool n, c, parenthesis;
};
constexpr std::array<Operator, 24> kOperators = {{
    {"LD", true, false, false},  {"ST", true, false, false},  {"S", false, false, false},
    {"R", false, false, false},  {"AND", true, false, true},  {"&", true, false, true},
    {"OR", true, false, true},   {"XOR", true, false, true},  {"NOT", false, false, false},
    {"ADD", false, false, true}, {"SUB", false, false, true}, {"MUL", false, false, true},
    {"DIV", false, false, true}, {"MOD", false, false, true}, {"GT", false, false, true},
    {"GE", false, false, true},  {"EQ", false, false, true},  {"NE", false, false, true},
    {"LE", false, false, true},  {"LT", false, false, true},  {"JMP", false, true, false},
    {"CAL", false, true, false}, {"RET", false, true, false}, {"STQ", false, false, false},
}};

struct Reading {
    const Operator* op = nullptr;
    bool negate = false, conditional = false;
};
/// LDN, ANDN, JMPCN: the operator and its modifiers.
Reading readOperator(std::string_view text) {
    for (const Operator& op : kOperators) {
        if (text.size() < op.name.size() || text.size() > op.name.size() + 2 ||
            !isWord(text.substr(0, op.name.size()), op.name))
            continue;
        const std::string_view rest = text.substr(op.name.size());
        if (rest.empty()) return {&op};
        if (op.n && isWord(rest, "N")) return {&op, true, false};
        if (op.c && isWord(rest, "C")) return {&op, false, true};
        if (op.c && (isWord(rest, "CN") || isWord(rest, "NC"))) return {&op, true, true};
    }
    return {};
}

} // namespace

/// The first statement is an instruction: an operator and an operand on its line.
bool Parser::atInstructionList(size_t ahead) const {
    while (kind(ahead) == TokenKind::Identifier && kind(ahead + 1) == TokenKind::Colon) ahead += 2;
    if (kind(ahead) != TokenKind::Identifier) return false;
    const Reading reading = readOperator(textOf(peek(ahead)));
    if (!reading.op) return atFunctionInstruction(ahead);
    const Token& next = peek(ahead + 1);
    const bool lineEnds = next.afterNewline || next.kind == TokenKind::EndOfFile;
    const std::string_view name = reading.op->name;
    if (name == "RET") return lineEnds;
    if (lineEnds) return false;
    const bool isOperand = lex::isLiteral(next.kind) || next.kind == TokenKind::Identifier ||
                           next.kind == TokenKind::TypedPrefix || next.kind == TokenKind::DirectAddress ||
                           next.kind == TokenKind::Hash || next.kind == TokenKind::Minus;
    if (!isOperand) return false;
    // `JMP there;` is ST
    if (name == "JMP") return kind(ahead + 2) != TokenKind::Semicolon;
    return true;
}

/// `Twice i`, `Twice(i)` or `CU counter` before a line with an operator: two names side by side are no ST.
bool Parser::atFunctionInstruction(size_t ahead) const {
    size_t at = ahead + 1;
    if (kind(at) == TokenKind::LeftParen && !peek(at).afterNewline) {
        for (size_t depth = 0; kind(at) != TokenKind::EndOfFile && kind(at) != TokenKind::Semicolon; ++at) {
            depth += kind(at) == TokenKind::LeftParen;
            if (kind(at) == TokenKind::RightParen && --depth == 0) break;
        }
        if (kind(at) != TokenKind::RightParen) return false;
    } else {
        const bool isOperand = lex::isLiteral(kind(at)) || kind(at) == TokenKind::Identifier ||
                               kind(at) == TokenKind::TypedPrefix || kind(at) == TokenKind::DirectAddress;
        if (!isOperand || peek(at).afterNewline) return false;
        while (!peek(at + 1).afterNewline && kind(at + 1) != TokenKind::EndOfFile) {
            const TokenKind next = kind(at + 1);
            if (next == TokenKind::Semicolon || next == TokenKind::Assign || next == TokenKind::LeftParen) return false;
            ++at;
        }
    }
    return peek(at + 1).afterNewline && kind(at + 1) == TokenKind::Identifier &&
           readOperator(textOf(peek(at + 1))).op != nullptr && atInstructionList(at + 1);
}

Block Parser::parseInstructions(BodyContext context) {
    const Nesting nesting(*this);
    Block out;
    if (nesting.tooDeep) {
        skipTo({TokenKind::EndProgram, TokenKind::EndFunctionBlock, TokenKind::EndFunction});
        return out;
    }
    while (!atEnd() && !atStatementEnd() && !at(TokenKind::RightParen)) {
        if (context != BodyContext::Fragment && (atDeclaration() || atPouMember() || atVarSection() || atChart()))
            break;
        if (take(TokenKind::Semicolon)) continue;
        const size_t before = mark();
        if (Stmt* stmt = parseInstruction()) out.push_back(stmt);
        if (mark() == before) advance();
    }
    return out;
}

/// To the next line, where the next instruction begins.
void Parser::skipInstruction() {
    do advance();
    while (!onNewLine() && !atStatementEnd());
    m_lastErrorAt = SIZE_MAX;
}

/// CAL block(in := value); the block's arguments may hold instructions.
void Parser::parseIlCall(IlInstruction& il) {
    if (!atName()) return expected(phrases::ABlocksName());
    const bool outer = std::exchange(m_inInstruction, true);
    Expr* target = parsePlace();
    m_inInstruction = outer;
    if (target->kind == ExprKind::Call) {
        il.arguments = std::move(target->arguments);
        target = target->base;
    }
    il.operand = target;
}

/// AND( … ): the instructions up to the bracket are one operand.
void Parser::parseIlParenthesis(IlInstruction& il, const Token& opToken) {
    const Token open = peek();
    il.opensParenthesis = true;
    advance();
    if (!onNewLine() && startsExpression()) il.operand = parsePrimaryIl();
    il.body = parseInstructions(BodyContext::Unit);
    if (!take(TokenKind::RightParen)) report({m_file.file, opToken.begin, open.end}, findings::IlParenthesis());
}

/// One instruction behind its label; false: the rest of the line is none and was passed over.
bool Parser::parseIlOperator(IlInstruction& il) {
    const Token opToken = peek();
    if (!atAny({TokenKind::Identifier, TokenKind::And, TokenKind::Or, TokenKind::Xor, TokenKind::Not, TokenKind::Mod,
                TokenKind::Ampersand})) {
        report(rangeOf(opToken), findings::IlUnknownOperator(shown(opToken)));
        skipInstruction();
        return false;
    }
    il.op = nameOf(opToken);
    advance();
    Reading reading = readOperator(il.op.text);
    if (opToken.kind == TokenKind::Ampersand && at(TokenKind::Identifier) && peek().begin == opToken.end &&
        isWord(textOf(peek()), "N")) {
        advance();
        reading.negate = true;
    }
    if (reading.op) {
        il.op.text = il.op.text.substr(0, reading.op->name.size());
        il.negate = reading.negate;
        il.conditional = reading.conditional;
    }
    if (at(TokenKind::Assign) || at(TokenKind::Dot)) { // an ST statement among instructions
        report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
        skipInstruction();
        return false;
    }
    if (reading.op && reading.op->parenthesis && at(TokenKind::LeftParen)) {
        parseIlParenthesis(il, opToken);
    } else if (reading.op && reading.op->name == "CAL") {
        parseIlCall(il);
    } else if (!reading.op && at(TokenKind::LeftParen)) {
        advance();
        const bool outer = std::exchange(m_inInstruction, true);
        parseArguments(il.arguments, TokenKind::RightParen);
        m_inInstruction = outer;
    } else {
        parseIlOperands(il);
    }
    return true;
}

Stmt* Parser::parseInstruction() {
    const size_t first = mark();
    Stmt* stmt = make<Stmt>();
    stmt->kind = StmtKind::Il;
    IlInstruction* il = stmt->il = make<IlInstruction>();
    if (atName() && kind(1) == TokenKind::Colon) {
        il->label = takeName();
        advance();
        if (atStatementEnd() || (atName() && kind(1) == TokenKind::Colon)) {
            stmt->range = rangeFrom(first);
            return stmt;
        }
    }
    if (parseIlOperator(*il)) {
        take(TokenKind::Semicolon);
        if (!onNewLine() && !atStatementEnd() && !at(TokenKind::RightParen)) {
            report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
            skipInstruction();
        }
    }
    stmt->range = rangeFrom(first);
    return stmt;
}

void Parser::parseIlOperands(IlInstruction& il) {
    if (onNewLine() || !startsExpression()) return;
    il.operand = parsePrimaryIl();
    while (take(TokenKind::Comma)) {
        Argument argument;
        argument.value = parsePrimaryIl();
        argument.range = argument.value->range;
        il.arguments.push_back(std::move(argument));
    }
}

} // namespace plc::parse
