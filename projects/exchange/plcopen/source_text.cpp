#include "projects/exchange/plcopen/source_text.h"

#include "projects/exchange/base/xml.h"

#include <algorithm>

namespace plc::exchange {

namespace {

bool isEndWord(lex::TokenKind kind) {
    using lex::TokenKind;
    switch (kind) {
    case TokenKind::EndProgram:
    case TokenKind::EndFunction:
    case TokenKind::EndFunctionBlock:
    case TokenKind::EndClass:
    case TokenKind::EndMethod:
    case TokenKind::EndProperty:
    case TokenKind::EndGet:
    case TokenKind::EndSet:
    case TokenKind::EndAction:
    case TokenKind::EndInterface:
        return true;
    default:
        return false;
    }
}

} // namespace

uint32_t SourceView::leadingBegin(uint32_t begin) const {
    const auto& tokens = m_file.tokens.tokens;
    auto it = std::lower_bound(tokens.begin(), tokens.end(), begin,
                               [](const lex::Token& token, uint32_t at) { return token.begin < at; });
    while (it != tokens.begin() && (it - 1)->kind == lex::TokenKind::Pragma) --it;
    const uint32_t floor = it == tokens.begin() ? 0 : trailingEnd((it - 1)->end);
    const size_t word = m_text.find_first_not_of(" \t\r\n", floor);
    return word == std::string_view::npos ? begin : std::min(begin, static_cast<uint32_t>(word));
}

uint32_t SourceView::attachedBegin(uint32_t begin) const {
    const uint32_t from = leadingBegin(begin);
    const std::string_view above = m_text.substr(from, begin - from);
    uint32_t attached = from;
    for (size_t line = above.find('\n'); line != std::string_view::npos; line = above.find('\n', line + 1)) {
        const size_t next = above.find_first_not_of(" \t\r", line + 1);
        if (next == std::string_view::npos || above[next] != '\n') continue;
        const size_t word = above.find_first_not_of(" \t\r\n", next);
        attached = word == std::string_view::npos ? begin : from + static_cast<uint32_t>(word);
    }
    return attached;
}

uint32_t SourceView::trailingEnd(uint32_t end) const {
    const uint32_t lineEnd = static_cast<uint32_t>(std::min(m_text.find('\n', end), m_text.size()));
    uint32_t at = end;
    for (const lex::Comment& comment : m_file.tokens.comments) {
        if (comment.begin < end) continue;
        if (comment.begin >= lineEnd || comment.end > lineEnd) break;
        if (m_text.substr(at, comment.begin - at).find_first_not_of(" \t;") != std::string_view::npos) break;
        at = comment.end;
    }
    return at;
}

uint32_t SourceView::endWord(SourceRange range) const {
    const auto& tokens = m_file.tokens.tokens;
    auto it = std::lower_bound(tokens.begin(), tokens.end(), range.end,
                               [](const lex::Token& token, uint32_t at) { return token.begin < at; });
    while (it != tokens.begin() && (it - 1)->begin >= range.begin) {
        --it;
        if (isEndWord(it->kind)) return it->begin;
        if (it->kind != lex::TokenKind::Semicolon) break;
    }
    return range.end;
}

UnitText SourceView::textOf(const syntax::Pou& pou) const {
    uint32_t declared = pou.header.end;
    for (const syntax::VarSection* section : pou.sections) declared = std::max(declared, section->range.end);
    declared = trailingEnd(declared);
    uint32_t end = pou.hasEnd ? endWord(pou.range) : pou.range.end;
    const auto member = [&](SourceRange range) {
        if (range.begin >= declared && range.begin < end) end = std::min(end, leadingBegin(range.begin));
    };
    for (const syntax::Pou* each : pou.methods) member(each->range);
    for (const syntax::Property* each : pou.properties) member(each->range);
    for (const syntax::ActionDecl* each : pou.actions)
        if (each->range.begin >= declared && each->range.begin < end)
            end = std::min(end, attachedBegin(each->range.begin));
    const uint32_t begin = leadingBegin(pou.header.begin);
    return {trimmedLines(m_text.substr(begin, declared - begin)),
            declared < end ? trimmedLines(m_text.substr(declared, end - declared)) : std::string()};
}

UnitText SourceView::textOf(const syntax::ActionDecl& action) const {
    uint32_t declared = action.name.range.end;
    const size_t colon = m_text.find(':', declared);
    if (colon != std::string_view::npos && colon < action.range.end) declared = static_cast<uint32_t>(colon) + 1;
    for (const syntax::VarSection* section : action.sections) declared = std::max(declared, section->range.end);
    const uint32_t end = std::max(declared, endWord(action.range));
    const uint32_t begin = attachedBegin(action.range.begin);
    std::string above = trimmedLines(m_text.substr(begin, action.range.begin - begin));
    std::string body = trimmedLines(m_text.substr(declared, end - declared));
    if (!above.empty()) body = above + (body.empty() ? "" : "\n" + body);
    return {{}, std::move(body)};
}

std::string SourceView::declarationOf(const syntax::Property& property) const {
    const uint32_t begin = leadingBegin(property.range.begin);
    uint32_t end = property.type ? property.type->range.end : property.name.range.end;
    end = trailingEnd(end);
    return trimmedLines(m_text.substr(begin, end - begin));
}

std::string SourceView::commentsBetween(uint32_t begin, uint32_t end) const {
    std::string out;
    for (const lex::Comment& comment : m_file.tokens.comments)
        if (comment.begin >= begin && comment.end <= end)
            out += (out.empty() ? "" : "\n") + std::string(m_text.substr(comment.begin, comment.end - comment.begin));
    return out;
}

} // namespace plc::exchange
