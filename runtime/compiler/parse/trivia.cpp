#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/chars.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <cstring>

namespace plc::parse {

namespace {

/// The pragmas that mean something to us or to the editors whose files we read.
bool isKnownPragma(std::string_view key) {
    static constexpr std::string_view known[] = {
        "attribute", "gvl",      "library",  "language", "minTime",  "maxTime", "region",    "endregion",
        "text",      "info",     "warning",  "error",    "IF",       "ELSE",    "ELSIF",     "END_IF",
        "define",    "undefine", "analysis", "flag",     "external", "comment", "namespace", "network"};
    return std::any_of(std::begin(known), std::end(known),
                       [&](std::string_view k) { return equalsIgnoringCase(k, key); });
}

/// { S7_Optimized_Access := 'TRUE' }, { ExternalVisible := 'False' }
bool isSiemensAttribute(std::string_view key) {
    return (key.size() > 3 && equalsIgnoringCase(key.substr(0, 3), "S7_")) ||
           (key.size() > 8 && equalsIgnoringCase(key.substr(0, 8), "External")) ||
           equalsIgnoringCase(key, "InstructionName") || equalsIgnoringCase(key, "LibVersion");
}

} // namespace

bool Parser::hasNewline(uint32_t begin, uint32_t end) const {
    return end > begin && std::memchr(m_text.data() + begin, '\n', end - begin) != nullptr;
}

std::vector<Pragma> Parser::pragmasHere() {
    std::vector<Pragma> out;
    const uint32_t end = sourceIndex(m_at);
    const uint32_t begin = m_at == 0 ? m_firstToken : sourceIndex(m_at - 1) + 1;
    for (uint32_t i = begin; i < end; ++i)
        if (m_list.tokens[i].kind == TokenKind::Pragma && !m_conditions.isLeftOut(i))
            out.push_back(readPragma(m_list.tokens[i]));
    return out;
}

/// {attribute 'qualified_only'}  {attribute 'x' := 'y'}  {gvl NAME}  {minTime := T#1s}
Pragma Parser::readPragma(const Token& token) {
    Pragma pragma;
    pragma.range = rangeOf(token);
    std::string_view text = textOf(token);
    if (!text.starts_with('{') || text.starts_with("{{")) { // REGION, VERSION : 0.1; code in C
        pragma.text = text;
        return pragma;
    }
    text.remove_prefix(1);
    if (text.ends_with('}')) text.remove_suffix(1);
    pragma.text = text;
    text = trimmed(text);
    size_t wordEnd = 0;
    while (wordEnd < text.size() && !isBlank(text[wordEnd]) && text[wordEnd] != ':' && text[wordEnd] != '\'') ++wordEnd;
    pragma.key = text.substr(0, wordEnd);
    std::string_view rest = trimmed(text.substr(wordEnd));
    if (equalsIgnoringCase(pragma.key, "attribute")) {
        pragma.isAttribute = true;
        const size_t assign = rest.find(":=");
        pragma.key = unquoted(rest.substr(0, assign));
        rest = assign == std::string_view::npos ? std::string_view() : rest.substr(assign);
    } else if (!isKnownPragma(pragma.key) && !isSiemensAttribute(pragma.key)) {
        m_sink.emit(pragma.range, findings::UnknownPragma(pragma.key));
    }
    if (rest.starts_with(":=")) rest.remove_prefix(2);
    pragma.value = unquoted(rest);
    return pragma;
}

/// The text of comments first…last without their markers; one view of the source where that is possible.
std::string_view Parser::cleanComment(uint32_t first, uint32_t last) const {
    const auto strip = [&](const lex::Comment& comment) {
        std::string_view text = m_text.substr(comment.begin, comment.end - comment.begin);
        if (comment.kind == lex::TriviaKind::LineComment) {
            while (text.starts_with('/')) text.remove_prefix(1);
            return trimmed(text);
        }
        text.remove_prefix(std::min<size_t>(2, text.size()));
        if (text.ends_with("*)") || text.ends_with("*/")) text.remove_suffix(2);
        while (text.starts_with('*')) text.remove_prefix(1);
        while (text.ends_with('*')) text.remove_suffix(1);
        return trimmed(text);
    };
    if (first == last) return strip(m_list.comments[first]);
    std::string* joinedText = m_file.arena.make<std::string>();
    for (uint32_t i = first; i <= last; ++i) {
        if (i != first) *joinedText += '\n';
        *joinedText += strip(m_list.comments[i]);
    }
    return trimmed(*joinedText);
}

/// The comments that stand on their own lines directly above a token (an index of the file's list).
std::string_view Parser::docCommentAbove(uint32_t tokenIndex) const {
    const auto& comments = m_list.comments;
    auto after = std::upper_bound(comments.begin(), comments.end(), tokenIndex,
                                  [](uint32_t index, const lex::Comment& c) { return index < c.beforeToken; });
    if (after == comments.begin() || (after - 1)->beforeToken != tokenIndex) return {};
    const uint32_t last = static_cast<uint32_t>(after - comments.begin()) - 1;
    uint32_t below = m_list.tokens[tokenIndex].begin;
    const auto newlines = [&](uint32_t begin, uint32_t end) {
        return std::count(m_text.begin() + begin, m_text.begin() + end, '\n');
    };
    const uint32_t floor = tokenIndex == 0 ? 0 : m_list.tokens[tokenIndex - 1].end;
    uint32_t first = last + 1;
    while (first > 0 && comments[first - 1].beforeToken == tokenIndex &&
           newlines(comments[first - 1].end, below) == 1) {
        const lex::Comment& comment = comments[first - 1];
        const uint32_t before =
            first >= 2 && comments[first - 2].beforeToken == tokenIndex ? comments[first - 2].end : floor;
        if (tokenIndex != 0 && before == floor && !hasNewline(floor, comment.begin)) break; // it stands behind code
        const bool isLine = comment.kind == lex::TriviaKind::LineComment;
        if (!isLine && first != last + 1) break;
        --first;
        below = comment.begin;
        if (!isLine) break;
    }
    return first > last ? std::string_view() : cleanComment(first, last);
}

std::string_view Parser::commentBehind(uint32_t tokenIndex) const {
    const auto& comments = m_list.comments;
    const auto it = std::lower_bound(comments.begin(), comments.end(), tokenIndex + 1,
                                     [](const lex::Comment& c, uint32_t index) { return c.beforeToken < index; });
    if (it == comments.end() || it->beforeToken != tokenIndex + 1 ||
        hasNewline(m_list.tokens[tokenIndex].end, it->begin))
        return {};
    const uint32_t at = static_cast<uint32_t>(it - comments.begin());
    return cleanComment(at, at);
}

/// With the comment lines directly above and the rest of the last line, when nothing else stands there.
SourceRange Parser::extentOf(SourceRange range, size_t firstToken) const {
    const uint32_t index = sourceIndex(firstToken);
    const auto& comments = m_list.comments;
    const auto lineBegin = [&](uint32_t at) {
        while (at > 0 && m_text[at - 1] != '\n') --at;
        return at;
    };
    const auto onlyBlanks = [&](uint32_t begin, uint32_t end) {
        return std::all_of(m_text.begin() + begin, m_text.begin() + end, isBlank);
    };
    uint32_t begin = range.begin;
    const uint32_t floor = index == 0 ? 0 : m_list.tokens[index - 1].end;
    const uint32_t line = std::max(lineBegin(begin), floor);
    if (onlyBlanks(line, begin)) begin = line;
    auto after = std::upper_bound(comments.begin(), comments.end(), index,
                                  [](uint32_t i, const lex::Comment& c) { return i < c.beforeToken; });
    while (begin > 0 && begin == lineBegin(begin) && after != comments.begin() && (after - 1)->beforeToken == index) {
        const lex::Comment& comment = *(after - 1);
        const uint32_t commentLine = lineBegin(comment.begin);
        if (commentLine < floor || !onlyBlanks(commentLine, comment.begin)) break;
        if (std::count(m_text.begin() + comment.end, m_text.begin() + begin, '\n') != 1) break;
        begin = commentLine;
        --after;
    }
    uint32_t end = range.end;
    const uint32_t lineEnd = static_cast<uint32_t>(std::min(m_text.find('\n', end), m_text.size() - 1) + 1);
    // the rest of the line: blanks and comments that end on it
    uint32_t at = end;
    auto behind = std::lower_bound(comments.begin(), comments.end(), end,
                                   [](const lex::Comment& c, uint32_t offset) { return c.begin < offset; });
    while (behind != comments.end() && behind->begin < lineEnd && onlyBlanks(at, behind->begin)) {
        at = behind->end;
        ++behind;
    }
    if (at > end && hasNewline(end, at)) at = end; // a comment over several lines belongs to what follows
    if (!m_text.empty() && at <= lineEnd && onlyBlanks(at, lineEnd)) end = lineEnd;
    return {range.file, begin, end};
}

} // namespace plc::parse
