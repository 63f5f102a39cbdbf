#include "projects/exchange/base/assemble.h"

#include "projects/exchange/base/xml.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"

namespace plc::exchange {

namespace {

using lex::SoftWord;
using lex::TokenKind;

struct Opening {
    PieceKind kind = PieceKind::Unknown;
    bool isClass = false; // edition 3: a block without a body
    std::string name;
};

PieceKind kindOf(const lex::Token& token) {
    switch (token.kind) {
    case TokenKind::Program:
        return PieceKind::Program;
    case TokenKind::Function:
        return PieceKind::Function;
    case TokenKind::FunctionBlock:
        return PieceKind::FunctionBlock;
    case TokenKind::TypeWord:
        return PieceKind::Type;
    case TokenKind::VarGlobal:
    case TokenKind::VarConfig:
        return PieceKind::Globals;
    default:
        break;
    }
    switch (token.soft) {
    case SoftWord::Class:
        return PieceKind::FunctionBlock;
    case SoftWord::Interface:
        return PieceKind::Interface;
    case SoftWord::Method:
        return PieceKind::Method;
    case SoftWord::Property:
        return PieceKind::Property;
    case SoftWord::Action:
        return PieceKind::Action;
    default:
        return PieceKind::Unknown;
    }
}

bool isModifier(SoftWord word) {
    return word == SoftWord::Abstract || word == SoftWord::Final || word == SoftWord::Override ||
           word == SoftWord::Public || word == SoftWord::Private || word == SoftWord::Protected ||
           word == SoftWord::Internal;
}

/// Reads only as far as the name: a list of globals may be long.
Opening openingOf(std::string_view declaration) {
    diagnostics::Sink ignored;
    size_t length = std::min<size_t>(declaration.size(), 4096);
    for (;;) {
        const lex::TokenList list = lex::tokenize(FileId(0), declaration.substr(0, length), ignored);
        Opening opening;
        for (const lex::Token& token : list.tokens) {
            if (token.kind == TokenKind::Pragma || token.kind == TokenKind::EndOfFile) continue;
            if (opening.kind == PieceKind::Unknown) {
                opening.kind = kindOf(token);
                opening.isClass = token.soft == SoftWord::Class;
                if (opening.kind == PieceKind::Unknown) break;
                continue;
            }
            if (isModifier(token.soft)) continue;
            if (token.kind == TokenKind::Identifier || lex::isKeyword(token.kind))
                opening.name = declaration.substr(token.begin, token.end - token.begin);
            break;
        }
        if (!opening.name.empty() || opening.kind == PieceKind::Globals || length == declaration.size()) return opening;
        length = declaration.size(); // a long comment above
    }
}

std::string_view endOf(PieceKind kind) {
    switch (kind) {
    case PieceKind::Program:
        return "END_PROGRAM";
    case PieceKind::Function:
        return "END_FUNCTION";
    case PieceKind::FunctionBlock:
        return "END_FUNCTION_BLOCK";
    case PieceKind::Interface:
        return "END_INTERFACE";
    case PieceKind::Method:
        return "END_METHOD";
    case PieceKind::Property:
        return "END_PROPERTY";
    case PieceKind::PropertyGet:
        return "END_GET";
    case PieceKind::PropertySet:
        return "END_SET";
    case PieceKind::Action:
        return "END_ACTION";
    case PieceKind::Type:
    case PieceKind::Globals:
    case PieceKind::Unknown:
        return "";
    }
    return "";
}

void appendBlock(std::string& out, const std::string& text) {
    if (text.empty()) return;
    out += text;
    if (!text.ends_with('\n')) out += '\n';
}

void append(std::string& out, const Piece& piece) {
    std::string head = trimmedLines(piece.declaration);
    if (piece.kind == PieceKind::PropertyGet) head = "GET" + (head.empty() ? "" : "\n" + head);
    if (piece.kind == PieceKind::PropertySet) head = "SET" + (head.empty() ? "" : "\n" + head);
    if (piece.kind == PieceKind::Action) head = "ACTION " + piece.name + ":";
    appendBlock(out, head);
    appendBlock(out, trimmedLines(piece.body));
    for (const Piece& member : piece.members) {
        if (member.kind != PieceKind::PropertyGet && member.kind != PieceKind::PropertySet) out += '\n';
        append(out, member);
    }
    std::string_view end = endOf(piece.kind);
    if (piece.kind == PieceKind::FunctionBlock && openingOf(piece.declaration).isClass) end = "END_CLASS";
    if (!end.empty()) {
        out += end;
        out += '\n';
    }
}

} // namespace

PieceKind kindOfDeclaration(std::string_view declaration) { return openingOf(declaration).kind; }
std::string nameInDeclaration(std::string_view declaration) { return openingOf(declaration).name; }

std::string_view keywordOf(PieceKind kind) {
    const std::string_view end = endOf(kind);
    if (kind == PieceKind::Type) return "TYPE";
    if (kind == PieceKind::Globals) return "VAR_GLOBAL";
    return end.empty() ? end : end.substr(4);
}

bool needsEnd(std::string_view declaration, PieceKind kind) {
    const std::string_view end = endOf(kind);
    return !end.empty() && trimmed(declaration).rfind(end) == std::string::npos;
}

std::string commentLines(const std::string& text, const std::string& indent) {
    const std::string lines = trimmed(text);
    if (lines.empty()) return {};
    std::string out;
    for (size_t at = 0; at <= lines.size();) {
        const size_t end = std::min(lines.find('\n', at), lines.size());
        const std::string line = trimmed(lines.substr(at, end - at));
        out += indent + (line.empty() ? "//" : "// " + line) + "\n";
        at = end + 1;
    }
    return out;
}

std::string assemble(const Piece& piece) {
    std::string out;
    append(out, piece);
    return out;
}

} // namespace plc::exchange
