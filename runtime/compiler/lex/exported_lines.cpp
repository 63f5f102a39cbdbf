#include "runtime/compiler/lex/exported_lines.h"

#include "runtime/base/chars.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::lex {

namespace {

bool isBlankInLine(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

std::string_view skipBlanks(std::string_view text) {
    while (!text.empty() && isBlankInLine(text.front())) text.remove_prefix(1);
    return text;
}

constexpr int kFarthest = 60; // no header has more pragmas

/// Tokens back to the begin of the unit: its name, its result, and pragmas. Nothing of a declaration or a body.
bool isBehindHeader(const TokenList& before) {
    int tokens = 0, looked = 0;
    for (size_t i = before.tokens.size(); i-- > 0 && tokens < 8 && ++looked < kFarthest;) {
        switch (before.tokens[i].kind) {
        case TokenKind::Pragma:
            continue;
        case TokenKind::Function:
        case TokenKind::FunctionBlock:
        case TokenKind::Program:
        case TokenKind::TypeWord:
            return tokens > 0;
        case TokenKind::Identifier:
        case TokenKind::WstringLiteral:
        case TokenKind::Colon:
        case TokenKind::Dot:
            ++tokens;
            continue;
        default:
            return false;
        }
    }
    return false;
}

bool isBehindSections(const TokenList& before) {
    int looked = 0;
    for (size_t i = before.tokens.size(); i-- > 0 && ++looked < kFarthest;) {
        if (before.tokens[i].kind == TokenKind::Pragma) continue;
        return before.tokens[i].kind == TokenKind::EndVar || isBehindHeader(before);
    }
    return false;
}

} // namespace

bool ExportedLines::hasRegions() {
    if (!m_hasRegions) {
        static constexpr std::string_view kWord = "END_REGION";
        m_hasRegions = std::search(m_text.begin(), m_text.end(), kWord.begin(), kWord.end(), [](char a, char b) {
                           return (a >= 'a' && a <= 'z' ? static_cast<char>(a - 32) : a) == b;
                       }) != m_text.end();
    }
    return *m_hasRegions;
}

size_t ExportedLines::endOf(size_t begin, const TokenList& before) {
    static constexpr std::string_view kWords[] = {"REGION", "END_REGION", "VERSION", "BEGIN",
                                                  "TITLE",  "AUTHOR",     "FAMILY",  "NAME"};
    size_t at = begin;
    while (at < m_text.size() && at - begin < 12 && (isLetter(m_text[at]) || isDigit(m_text[at]))) ++at;
    const std::string_view word = m_text.substr(begin, at - begin);
    const auto* const found = std::find_if(std::begin(kWords), std::end(kWords),
                                           [&](std::string_view w) { return equalsIgnoringCase(w, word); });
    if (found == std::end(kWords)) return 0;
    std::string_view line = m_text.substr(at, m_text.substr(at).find('\n'));
    for (const char* comment : {"//", "(*", "/*"}) line = line.substr(0, line.find(comment));
    while (!line.empty() && isBlankInLine(line.back())) line.remove_suffix(1);
    const size_t end = at + line.size();
    const std::string_view rest = skipBlanks(line);
    const auto endsAt = [&](bool isOne) { return isOne ? end : 0; };
    if (*found == "REGION" || *found == "END_REGION") {
        const bool isName = rest.empty() || (rest.size() < line.size() && (isLetter(rest[0]) || isDigit(rest[0]))) ||
                            (*found == "END_REGION" && rest == ";");
        return endsAt(isName && rest.find(":=") == std::string_view::npos && hasRegions());
    }
    if (*found == "BEGIN") return endsAt(rest.empty() && isBehindSections(before));
    if (!isBehindHeader(before)) return 0;
    if (*found == "TITLE") return endsAt(rest.starts_with('='));
    if (!rest.starts_with(':') || rest.find(';') != std::string_view::npos) return 0;
    const std::string_view value = skipBlanks(rest.substr(1));
    if (*found == "VERSION") return endsAt(!value.empty() && isDigit(value[0]));
    return endsAt(!value.empty());
}

} // namespace plc::lex
