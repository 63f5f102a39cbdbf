#include "runtime/compiler/format/format.h"

#include "runtime/compiler/format/structure.h"
#include "runtime/compiler/parse/parser.h"

#include <algorithm>

namespace plc::format {

using lex::SoftWord;
using lex::Token;
using lex::TokenKind;

namespace {

/// A token or a comment.
struct Item {
    uint32_t begin, end;
    const Token* token; // null: a comment
    bool isLineComment = false;
};

struct SourceLine {
    size_t first, last; // items [first, last)
    int blanksBefore = 0;
    bool frozen = false;
};

bool endsOperand(TokenKind kind) {
    if (lex::isLiteral(kind)) return true;
    switch (kind) {
    case TokenKind::Identifier:
    case TokenKind::DirectAddress:
    case TokenKind::RightParen:
    case TokenKind::RightBracket:
    case TokenKind::Caret:
        return true;
    default:
        return false;
    }
}

class Formatter {
public:
    Formatter(std::string_view text, const FormatOptions& options, const syntax::SyntaxFile& file,
              const Structure& structure)
        : m_text(text), m_options(options), m_structure(structure) {
        const auto& tokens = file.tokens.tokens;
        size_t c = 0;
        for (const Token& token : tokens) {
            while (c < file.tokens.comments.size() && file.tokens.comments[c].begin < token.begin)
                pushComment(file.tokens.comments[c++]);
            if (token.kind != TokenKind::EndOfFile) m_items.push_back({token.begin, token.end, &token});
        }
        while (c < file.tokens.comments.size()) pushComment(file.tokens.comments[c++]);
        m_lineEnd = text.find("\r\n") != std::string_view::npos ? "\r\n" : "\n";
    }

    std::string run() {
        split();
        layOut();
        alignDeclarations();
        alignComments();
        std::string out;
        out.reserve(m_text.size() + m_text.size() / 8);
        if (m_text.starts_with("\xEF\xBB\xBF")) out += "\xEF\xBB\xBF";
        for (size_t i = 0; i < m_lines.size(); ++i) {
            int blanks = m_lines[i].blanksBefore;
            const bool betweenFrozen = m_lines[i].frozen && i > 0 && m_lines[i - 1].frozen;
            if (!betweenFrozen) blanks = i == 0 ? 0 : std::min(blanks, m_options.maxBlankLines);
            for (int b = 0; b < blanks; ++b) out += m_lineEnd;
            out += m_code[i];
            if (!m_trailing[i].empty()) {
                out.append(static_cast<size_t>(m_gap[i]), ' ');
                out += m_trailing[i];
            }
            out += m_lineEnd;
        }
        return out;
    }

private:
    void pushComment(const lex::Comment& comment) {
        m_items.push_back({comment.begin, comment.end, nullptr, comment.kind == lex::TriviaKind::LineComment});
    }
    std::string_view slice(uint32_t begin, uint32_t end) const { return m_text.substr(begin, end - begin); }

    void split() {
        for (size_t i = 0; i < m_items.size(); ++i) {
            const uint32_t before = i == 0 ? 0 : m_items[i - 1].end;
            const auto newlines = std::count(m_text.begin() + before, m_text.begin() + m_items[i].begin, '\n');
            if (i == 0 || newlines > 0) m_lines.push_back({i, i, i == 0 ? 0 : static_cast<int>(newlines) - 1});
            m_lines.back().last = i + 1;
            if (m_structure.isFrozen(m_items[i].begin, m_items[i].end)) m_lines.back().frozen = true;
        }
    }

    int columnsBefore(uint32_t offset) const {
        uint32_t begin = offset;
        while (begin > 0 && m_text[begin - 1] != '\n') --begin;
        int columns = 0;
        for (uint32_t at = begin; at < offset; ++at)
            columns += m_text[at] == '\t' ? m_options.indentWidth - columns % m_options.indentWidth : 1;
        return columns;
    }
    std::string indent(int columns) const {
        if (!m_options.useTabs) return std::string(static_cast<size_t>(std::max(columns, 0)), ' ');
        return std::string(static_cast<size_t>(columns / m_options.indentWidth), '\t') +
               std::string(static_cast<size_t>(columns % m_options.indentWidth), ' ');
    }

    void layOut() {
        int ownerNew = 0, ownerOld = 0;
        for (const SourceLine& line : m_lines) {
            if (line.frozen) {
                uint32_t begin = m_items[line.first].begin;
                while (begin > 0 && m_text[begin - 1] != '\n') --begin;
                uint32_t end = m_items[line.last - 1].end;
                std::string_view rest = m_text.substr(end);
                rest = rest.substr(0, rest.find('\n'));
                std::string_view raw = slice(begin, end + static_cast<uint32_t>(rest.size()));
                while (raw.ends_with('\r')) raw.remove_suffix(1); // belongs to the line's end
                if (line.first == 0 && raw.starts_with("\xEF\xBB\xBF")) raw.remove_prefix(3);
                m_code.emplace_back(raw);
                m_trailing.emplace_back();
                m_gap.push_back(0);
                ownerNew = ownerOld = columnsBefore(m_items[line.first].begin);
                continue;
            }
            const Item& first = m_items[line.first];
            const int depth = m_structure.depthAt(first.begin) * m_options.indentWidth;
            const int old = columnsBefore(first.begin);
            int columns = depth;
            const bool owner = !first.token || m_structure.beginsHere(first.begin);
            if (owner) {
                if (first.token || line.last - line.first > 1) ownerNew = depth, ownerOld = old;
            } else {
                columns = ownerNew + (old > ownerOld ? old - ownerOld : m_options.indentWidth);
            }
            std::string code = indent(columns);
            size_t last = line.last;
            const bool trailing = last - line.first > 1 && !m_items[last - 1].token;
            if (trailing) --last;
            for (size_t i = line.first; i < last; ++i) {
                if (i > line.first && space(i)) code += ' ';
                code += spelled(m_items[i]);
            }
            m_code.push_back(std::move(code));
            m_trailing.emplace_back(trailing ? std::string(rtrim(slice(m_items[last].begin, m_items[last].end)))
                                             : std::string());
            m_gap.push_back(trailing ? 1 : 0);
        }
    }
    static std::string_view rtrim(std::string_view text) {
        while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
            text.remove_suffix(1);
        return text;
    }

    std::string spelled(const Item& item) const {
        std::string_view raw = slice(item.begin, item.end);
        if (!item.token) return std::string(item.isLineComment ? rtrim(raw) : raw);
        const bool keyword = lex::isKeyword(item.token->kind) ||
                             (item.token->soft != SoftWord::None && m_structure.isSoftKeyword(item.begin));
        std::string text(raw);
        if (!keyword || m_options.keywords == KeywordCase::AsWritten) return text;
        for (char& c : text) {
            if (m_options.keywords == KeywordCase::Upper && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
            if (m_options.keywords == KeywordCase::Lower && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        }
        return text;
    }

    /// The token before item `i`, without comments; null at the begin.
    const Token* tokenBefore(size_t i) const {
        while (i > 0)
            if (m_items[--i].token) return m_items[i].token;
        return nullptr;
    }
    /// A sign, not an operation: nothing it could be applied to stands before it.
    bool isUnary(size_t i) const {
        const Token* before = tokenBefore(i);
        return !before || !endsOperand(before->kind);
    }
    /// AND(a, b)
    bool isOperatorFunction(size_t i) const {
        switch (m_items[i].token->kind) {
        case TokenKind::And:
        case TokenKind::Or:
        case TokenKind::Xor:
        case TokenKind::Mod:
            return isUnary(i);
        default:
            return false;
        }
    }

    /// One blank between item i-1 and item i?
    bool space(size_t i) const {
        const Item& previous = m_items[i - 1];
        const Item& next = m_items[i];
        if (!previous.token || !next.token) return true;
        const TokenKind p = previous.token->kind, n = next.token->kind;
        switch (n) {
        case TokenKind::Comma:
        case TokenKind::Semicolon:
        case TokenKind::RightParen:
        case TokenKind::RightBracket:
        case TokenKind::Caret:
        case TokenKind::Dot:
        case TokenKind::DotDot:
            return p == TokenKind::Pragma;
        case TokenKind::Colon:
            return !m_structure.isLabelColon(next.begin);
        default:
            break;
        }
        switch (p) {
        case TokenKind::LeftParen:
        case TokenKind::LeftBracket:
        case TokenKind::Dot:
        case TokenKind::DotDot:
        case TokenKind::Hash:
        case TokenKind::TypedPrefix:
            return false;
        case TokenKind::Plus:
        case TokenKind::Minus:
            return !isUnary(i - 1);
        default:
            break;
        }
        if (n == TokenKind::LeftParen) {
            if (p == TokenKind::Identifier) return m_structure.isSoftKeyword(previous.begin) || isPriority(i);
            if (p == TokenKind::RightBracket || p == TokenKind::Caret || p == TokenKind::RightParen ||
                p == TokenKind::WstringLiteral || p == TokenKind::IntegerLiteral || p == TokenKind::Catch)
                return false;
            return !isOperatorFunction(i - 1);
        }
        if (n == TokenKind::LeftBracket)
            return !(p == TokenKind::Identifier || p == TokenKind::RightBracket || p == TokenKind::Caret ||
                     p == TokenKind::Array || p == TokenKind::RightParen || p == TokenKind::WstringLiteral);
        return true;
    }
    bool isPriority(size_t i) const {
        return i + 1 < m_items.size() && m_items[i + 1].token && m_items[i + 1].token->soft == SoftWord::Priority &&
               m_structure.isSoftKeyword(m_items[i + 1].begin);
    }

    static int width(std::string_view text) {
        int columns = 0;
        const size_t newline = text.rfind('\n');
        if (newline != std::string_view::npos) text = text.substr(newline + 1);
        for (char c : text) columns += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
        return columns;
    }

    /// The colons of neighbouring declarations stand in one column: `name, other : TYPE`, one declaration a line.
    void alignDeclarations() {
        if (!m_options.alignDeclarations) return;
        constexpr int kFarthest = 60;
        for (size_t i = 0; i < m_lines.size();) {
            if (colonOf(i) == std::string::npos) {
                ++i;
                continue;
            }
            size_t end = i;
            int column = 0;
            for (; end < m_lines.size() && colonOf(end) != std::string::npos &&
                   (end == i || m_lines[end].blanksBefore == 0);
                 ++end) {
                const int at = width(std::string_view(m_code[end]).substr(0, colonOf(end)));
                if (at <= kFarthest) column = std::max(column, at);
            }
            for (size_t k = i; k < end; ++k) {
                const size_t colon = colonOf(k);
                const int missing = column - width(std::string_view(m_code[k]).substr(0, colon));
                if (missing > 0) m_code[k].insert(colon, static_cast<size_t>(missing), ' ');
            }
            i = end;
        }
    }
    /// Where the colon of a line with one declaration stands in its text; npos: another line.
    size_t colonOf(size_t line) const {
        const SourceLine& source = m_lines[line];
        if (source.frozen || !m_structure.beginsDeclaration(m_items[source.first].begin)) return std::string::npos;
        const size_t colon = m_code[line].find(" :");
        const std::string_view before = std::string_view(m_code[line]).substr(0, colon);
        if (colon == std::string::npos || before.find_first_of("('{\"/") != std::string_view::npos ||
            m_code[line].substr(colon + 2).starts_with("="))
            return std::string::npos;
        return colon + 1;
    }

    /// Comments behind neighbouring lines of the same depth stand in one column.
    void alignComments() {
        if (!m_options.alignComments) return;
        constexpr int kFarthest = 100;
        for (size_t i = 0; i < m_lines.size();) {
            if (m_trailing[i].empty()) {
                ++i;
                continue;
            }
            size_t end = i;
            int column = 0;
            while (end < m_lines.size() && !m_trailing[end].empty() && (end == i || m_lines[end].blanksBefore == 0)) {
                if (width(m_code[end]) < kFarthest) column = std::max(column, width(m_code[end]));
                ++end;
            }
            for (size_t k = i; k < end; ++k) m_gap[k] = std::max(1, column + 1 - width(m_code[k]));
            i = end;
        }
    }

    std::string_view m_text;
    const FormatOptions& m_options;
    const Structure& m_structure;
    std::vector<Item> m_items;
    std::vector<SourceLine> m_lines;
    std::vector<std::string> m_code, m_trailing;
    std::vector<int> m_gap;
    std::string m_lineEnd;
};

/// The same tokens and comments, whatever the blanks and the case of words?
bool sameContents(std::string_view a, std::string_view b) {
    diagnostics::Sink sink;
    const lex::TokenList left = lex::tokenize(FileId(), a, sink), right = lex::tokenize(FileId(), b, sink);
    if (left.tokens.size() != right.tokens.size() || left.comments.size() != right.comments.size()) return false;
    const auto rtrim = [](std::string_view t) {
        while (!t.empty() && (t.back() == ' ' || t.back() == '\t' || t.back() == '\r')) t.remove_suffix(1);
        return t;
    };
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    for (size_t i = 0; i < left.tokens.size(); ++i) {
        const Token &l = left.tokens[i], &r = right.tokens[i];
        if (l.kind != r.kind || l.end - l.begin != r.end - r.begin) return false;
        const bool anyCase = lex::isKeyword(l.kind) || l.soft != SoftWord::None;
        for (uint32_t k = 0; k < l.end - l.begin; ++k) {
            const char x = a[l.begin + k], y = b[r.begin + k];
            if (x != y && !(anyCase && lower(x) == lower(y))) return false;
        }
    }
    for (size_t i = 0; i < left.comments.size(); ++i) {
        const auto &l = left.comments[i], &r = right.comments[i];
        if (l.beforeToken != r.beforeToken ||
            rtrim(a.substr(l.begin, l.end - l.begin)) != rtrim(b.substr(r.begin, r.end - r.begin)))
            return false;
    }
    return true;
}

} // namespace

std::string format(std::string_view text, const FormatOptions& options) {
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(0), text, sink, nullptr, parse::Branches::All);
    if (file->tokens.tokens.size() <= 1 && file->tokens.comments.empty()) return std::string(text);
    const Structure structure(*file, text, sink.all());
    std::string out = Formatter(text, options, *file, structure).run();
    return sameContents(text, out) ? out : std::string(text);
}

} // namespace plc::format
