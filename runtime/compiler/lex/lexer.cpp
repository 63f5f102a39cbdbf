#include "runtime/base/chars.h"
#include "runtime/compiler/lex/exported_lines.h"
#include "runtime/compiler/lex/literal_prefix.h"
#include "runtime/compiler/lex/relex.h"
#include "runtime/compiler/lex/words.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace plc::lex {

namespace {

bool isAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isAlnum(char c) { return isDigit(c) || isAsciiLetter(c); }
int digitValue(char c) {
    if (isDigit(c)) return c - '0';
    return isAsciiLetter(c) ? detail::upper(c) - 'A' + 10 : 99;
}

/// Control characters are more than one byte in 32 of its beginning: in texts they are a slip, in other files every
/// tenth byte is one.
bool isBinary(std::string_view text) {
    constexpr size_t kBeginning = 8192, kSlips = 8;
    text = text.substr(0, kBeginning);
    const auto isControl = [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 && (byte < '\t' || byte > '\r') && byte != 0x1A; // old editors end a file with 1A
    };
    const auto controls = static_cast<size_t>(std::count_if(text.begin(), text.end(), isControl));
    return controls > kSlips && controls * 32 > text.size();
}

class Lexer {
public:
    Lexer(FileId file, std::string_view text, diagnostics::Sink& sink) : m_file(file), m_text(text), m_sink(sink) {}

    TokenList run() {
        if (isBinary(m_text)) return nothingToRead();
        m_list.tokens.reserve(m_text.size() / 4 + 16);
        if (m_text.starts_with("\xEF\xBB\xBF")) m_at = 3;
        return readOn();
    }
    /// Behind tokens that are known.
    TokenList runFrom(const TokenList& before, size_t kept) {
        const Token& first = before.tokens[kept];
        m_at = first.begin;
        m_newline = first.afterNewline;
        m_list.tokens.reserve(kept + (m_text.size() - m_at) / 4 + 16);
        m_list.tokens.assign(before.tokens.begin(), before.tokens.begin() + static_cast<std::ptrdiff_t>(kept));
        const auto end = std::lower_bound(before.comments.begin(), before.comments.end(), first.begin,
                                          [](const Comment& each, size_t at) { return each.begin < at; });
        m_list.comments.assign(before.comments.begin(), end);
        return readOn();
    }

private:
    /// One message, and one token that means nothing: a picture or an archive has thousands of mistakes.
    TokenList nothingToRead() {
        emit(0, 0, findings::InvalidUtf8());
        push(TokenKind::Error, 0, m_text.size());
        push(TokenKind::EndOfFile, m_text.size(), m_text.size());
        return std::move(m_list);
    }
    TokenList readOn() {
        if (const auto bad = firstInvalidUtf8(m_text.substr(m_at)))
            emit(m_at + *bad, m_at + *bad + 1, findings::InvalidUtf8());
        while (skipBlanks()) lexToken();
        push(TokenKind::EndOfFile, m_text.size(), m_text.size());
        return std::move(m_list);
    }

    char peek(size_t ahead = 0) const { return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0'; }
    std::string_view slice(size_t begin, size_t end) const { return m_text.substr(begin, end - begin); }

    diagnostics::Diagnostic& emit(size_t begin, size_t end, diagnostics::Finding finding) {
        return m_sink.emit({m_file, static_cast<uint32_t>(begin), static_cast<uint32_t>(end)}, std::move(finding));
    }
    void push(TokenKind kind, size_t begin, size_t end, SoftWord soft = SoftWord::None) {
        m_list.tokens.push_back({kind, soft, m_newline, static_cast<uint32_t>(begin), static_cast<uint32_t>(end)});
        m_newline = false;
    }

    /// False at the end of the text.
    bool skipBlanks() {
        while (m_at < m_text.size()) {
            const char c = m_text[m_at];
            if (c == '\n') {
                m_newline = true;
                ++m_at;
            } else if (c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v') {
                ++m_at;
            } else if (c == '/' && peek(1) == '/') {
                lineComment();
            } else if ((c == '(' || c == '/') && peek(1) == '*') {
                blockComment(c);
            } else if (!skipUnicodeBlank()) {
                return true;
            }
        }
        return false;
    }

    bool skipUnicodeBlank() {
        if (static_cast<unsigned char>(m_text[m_at]) < 0x80) return false;
        size_t next = m_at;
        const char32_t c = decodeUtf8(m_text, next);
        const bool blank = c == 0xA0 || c == 0xFEFF || (c >= 0x2000 && c <= 0x200F) || c == 0x2028 || c == 0x2029 ||
                           c == 0x202F || c == 0x3000;
        if (blank) m_at = next;
        return blank;
    }

    void comment(TriviaKind kind, size_t begin) {
        m_list.comments.push_back({kind, static_cast<uint32_t>(begin), static_cast<uint32_t>(m_at),
                                   static_cast<uint32_t>(m_list.tokens.size())});
    }
    void lineComment() {
        const size_t begin = m_at;
        m_at = std::min(m_text.find('\n', m_at), m_text.size());
        size_t end = m_at;
        if (end > begin && m_text[end - 1] == '\r') --end;
        m_at = end;
        comment(TriviaKind::LineComment, begin);
    }

    /// (* (* nested *) *) and /* */; an inner one that is not closed does not count.
    void blockComment(char open) {
        const size_t begin = m_at;
        const std::string_view opener = open == '(' ? "(*" : "/*";
        const std::string_view closer = open == '(' ? "*)" : "*/";
        const size_t firstClose = m_text.find(closer, begin + 2);
        int depth = 1;
        size_t inner = std::string_view::npos; // the last one that begins inside
        m_at = begin + 2;
        while (m_at < m_text.size() && depth > 0) {
            const void* star = std::memchr(m_text.data() + m_at, '*', m_text.size() - m_at);
            if (!star) {
                m_at = m_text.size();
                break;
            }
            const size_t at = static_cast<size_t>(static_cast<const char*>(star) - m_text.data());
            if (at + 1 < m_text.size() && m_text[at + 1] == closer[1]) {
                --depth;
                m_at = at + 2;
            } else if (at > m_at && m_text[at - 1] == opener[0]) {
                ++depth;
                inner = at - 1;
                m_at = at + 1;
            } else {
                m_at = at + 1;
            }
        }
        if (depth > 0) {
            if (open == '(' || firstClose == std::string_view::npos) {
                auto& diagnostic = emit(begin, begin + 2, findings::UnterminatedComment());
                if (inner != std::string_view::npos && firstClose != std::string_view::npos)
                    diagnostic.related.push_back(
                        {{m_file, static_cast<uint32_t>(inner), static_cast<uint32_t>(inner + 2)},
                         notes::InnerComment()});
            }
            m_at = firstClose == std::string_view::npos ? m_text.size() : firstClose + 2;
        }
        if (std::memchr(m_text.data() + begin, '\n', m_at - begin)) m_newline = true;
        comment(TriviaKind::BlockComment, begin);
    }

    void lexToken() {
        const char c = m_text[m_at];
        if (isAsciiLetter(c) || c == '_') return word();
        if (isDigit(c)) return number();
        switch (c) {
        case '\'':
            return string('\'', TokenKind::StringLiteral);
        case '"':
            return string('"', TokenKind::WstringLiteral);
        case '{':
            return pragma();
        case '%':
            if (directAddress()) return;
            break;
        default:
            break;
        }
        if ((std::string_view("=!&|%").find(c) != std::string_view::npos && foreign()) || symbol()) return;
        if (static_cast<unsigned char>(c) >= 0x80) {
            size_t next = m_at;
            const char32_t character = decodeUtf8(m_text, next);
            if (isNameLetter(character)) return word();
            if (typographic(character, next)) return;
        }
        unknown();
    }

    /// Operators of other languages: one message with the word of this one, read as it.
    bool foreign() {
        struct Row {
            std::string_view text, meant;
            TokenKind kind;
        };
        if (m_text[m_at] == '%' && !m_list.tokens.empty() && m_list.tokens.back().kind == TokenKind::At) {
            const size_t begin = m_at++; // AT %Z5
            m_at = wordEnd(m_at);
            emit(begin, m_at, findings::InvalidLiteral(slice(begin, m_at), phrases::AddressLiteral()));
            push(TokenKind::DirectAddress, begin, m_at);
            return true;
        }
        static constexpr Row rows[] = {{"==", "=", TokenKind::Equal}, {"!=", "<>", TokenKind::NotEqual},
                                       {"&&", "AND", TokenKind::And}, {"||", "OR", TokenKind::Or},
                                       {"!", "NOT", TokenKind::Not},  {"%", "MOD", TokenKind::Mod}};
        for (const Row& row : rows) {
            if (!m_text.substr(m_at).starts_with(row.text)) continue;
            if (row.text == "%" && !(peek(1) == ' ' || isDigit(peek(1)))) continue; // a direct address to be
            const auto end = static_cast<uint32_t>(m_at + row.text.size());
            std::string word(row.meant);
            if (row.kind == TokenKind::Not) word += ' ';
            emit(m_at, end, findings::ForeignOperator(row.text, row.meant))
                .fixes.push_back(
                    {fixes::Write(std::string(row.meant)), {{{m_file, static_cast<uint32_t>(m_at), end}, word}}});
            return takeSymbol(row.kind, row.text.size());
        }
        return false;
    }

    bool symbol() {
        struct Row {
            std::string_view text;
            TokenKind kind;
        };
        static constexpr Row two[] = {{":=", TokenKind::Assign},       {"=>", TokenKind::Output},
                                      {"?=", TokenKind::TryAssign},    {"**", TokenKind::Power},
                                      {"<>", TokenKind::NotEqual},     {"<=", TokenKind::LessEqual},
                                      {">=", TokenKind::GreaterEqual}, {"..", TokenKind::DotDot}};
        static constexpr Row one[] = {
            {"+", TokenKind::Plus},       {"-", TokenKind::Minus},       {"*", TokenKind::Star},
            {"/", TokenKind::Slash},      {"=", TokenKind::Equal},       {"<", TokenKind::Less},
            {">", TokenKind::Greater},    {"&", TokenKind::Ampersand},   {"(", TokenKind::LeftParen},
            {")", TokenKind::RightParen}, {"[", TokenKind::LeftBracket}, {"]", TokenKind::RightBracket},
            {",", TokenKind::Comma},      {";", TokenKind::Semicolon},   {":", TokenKind::Colon},
            {".", TokenKind::Dot},        {"^", TokenKind::Caret},       {"#", TokenKind::Hash}};
        const char first = peek(), second = peek(1);
        if (std::string_view("=>*.").find(second) != std::string_view::npos) // few symbols have two characters
            for (const Row& row : two)
                if (row.text[0] == first && row.text[1] == second) return takeSymbol(row.kind, 2);
        for (const Row& row : one)
            if (row.text[0] == first) return takeSymbol(row.kind, 1);
        return false;
    }
    bool takeSymbol(TokenKind kind, size_t length) {
        push(kind, m_at, m_at + length);
        m_at += length;
        return true;
    }

    size_t wordEnd(size_t at) const {
        while (at < m_text.size()) {
            const char c = m_text[at];
            if (isAlnum(c) || c == '_') {
                ++at;
                continue;
            }
            if (static_cast<unsigned char>(c) < 0x80) break;
            size_t next = at;
            if (!isNameLetter(decodeUtf8(m_text, next))) break;
            at = next;
        }
        return at;
    }

    void word() {
        const size_t begin = m_at;
        m_at = wordEnd(m_at);
        if (m_at == begin) return unknown();
        if (m_newline)
            if (const size_t end = m_exported.endOf(begin, m_list)) {
                m_at = end;
                return push(TokenKind::Pragma, begin, end);
            }
        const std::string_view text = slice(begin, m_at);
        if (peek() == '#') return prefixed(begin, text);
        if (peek() == '=' && m_at + 1 <= m_text.size() && setOrReset(begin, text)) return;
        if (text.size() == 6 && equalsIgnoringCase(text, "ELSEIF")) return elseIf(begin);
        const Word word = lookUpWord(text);
        push(word.kind, begin, m_at, word.soft);
    }

    /// Other languages' ELSIF: read as what is meant.
    void elseIf(size_t begin) {
        const SourceRange range{m_file, static_cast<uint32_t>(begin), static_cast<uint32_t>(m_at)};
        emit(begin, m_at, findings::ForeignOperator(slice(begin, m_at), std::string_view("ELSIF")))
            .fixes.push_back({fixes::Write(std::string("ELSIF")), {{range, "ELSIF"}}});
        push(TokenKind::Elsif, begin, m_at);
    }

    /// `a S= b`: the word stands directly before `=` and behind an operand.
    bool setOrReset(size_t begin, std::string_view text) {
        TokenKind kind = TokenKind::Error;
        if (text == "S" || text == "s")
            kind = TokenKind::SetAssign;
        else if (text == "R" || text == "r")
            kind = TokenKind::ResetAssign;
        else if (text.size() == 3 && equalsIgnoringCase(text, "REF"))
            kind = TokenKind::RefAssign;
        if (kind == TokenKind::Error || peek(1) == '>' || m_list.tokens.empty()) return false;
        switch (m_list.tokens.back().kind) {
        case TokenKind::Identifier:
        case TokenKind::RightBracket:
        case TokenKind::RightParen:
        case TokenKind::Caret:
        case TokenKind::DirectAddress:
        case TokenKind::WstringLiteral:
        case TokenKind::IntegerLiteral:
            break;
        default:
            return false;
        }
        ++m_at;
        push(kind, begin, m_at);
        return true;
    }

    void prefixed(size_t begin, std::string_view text) {
        const PrefixKind kind = prefixKind(text);
        ++m_at; // the #
        const char next = peek();
        const bool number = isDigit(next) || ((next == '-' || next == '+') && isDigit(peek(1)));
        switch (kind) {
        case PrefixKind::Duration:
            if (number || next == '.') return duration(begin);
            break;
        case PrefixKind::Date:
            if (number) return date(begin, TokenKind::DateLiteral, phrases::DateLiteral());
            break;
        case PrefixKind::TimeOfDay:
            if (number) return date(begin, TokenKind::TimeOfDayLiteral, phrases::TimeOfDayLiteral());
            break;
        case PrefixKind::DateTime:
            if (number) return date(begin, TokenKind::DateTimeLiteral, phrases::DateAndTimeLiteral());
            break;
        case PrefixKind::Bcd:
            if (number) {
                takeDigits(10);
                return finishNumber(begin, TokenKind::IntegerLiteral, Verbatim("BCD"));
            }
            break;
        case PrefixKind::Type:
            break;
        }
        if (kind != PrefixKind::Type && kind != PrefixKind::Bcd &&
            (next == ' ' || next == ';' || next == ')' || next == ',' || next == '\n' || next == '\0')) {
            emit(begin, m_at,
                 findings::InvalidLiteral(slice(begin, m_at), kind == PrefixKind::Duration ? phrases::DurationLiteral()
                                                                                           : phrases::DateLiteral()));
            return push(kind == PrefixKind::Duration ? TokenKind::DurationLiteral : TokenKind::DateLiteral, begin,
                        m_at);
        }
        push(TokenKind::TypedPrefix, begin, m_at);
    }

    /// T#1d2h_3m4.5s, either case, overflow of the leading unit allowed (IEC 61131-3 ed. 3, 6.3.4).
    void duration(size_t begin) {
        if (peek() == '-' || peek() == '+') ++m_at;
        bool valid = false;
        int lastRank = -1;
        bool fraction = false, ordered = true;
        while (isDigit(peek())) {
            if (fraction) ordered = false; // only the last may have a fraction
            while (isDigit(peek()) || (peek() == '_' && isDigit(peek(1)))) ++m_at;
            if (peek() == '.' && isDigit(peek(1))) {
                fraction = true;
                ++m_at;
                while (isDigit(peek()) || (peek() == '_' && isDigit(peek(1)))) ++m_at;
            }
            const size_t unitBegin = m_at;
            while (isAsciiLetter(peek())) ++m_at;
            const int rank = unitRank(slice(unitBegin, m_at));
            valid = rank >= 0;
            if (rank <= lastRank) ordered = false;
            lastRank = rank;
            if (!valid) break;
            if (peek() == '_' && isDigit(peek(1))) ++m_at;
        }
        const size_t good = m_at;
        m_at = wordEnd(m_at);
        if (!valid || !ordered || good != m_at)
            emit(begin, m_at, findings::InvalidLiteral(slice(begin, m_at), phrases::DurationLiteral()));
        push(TokenKind::DurationLiteral, begin, m_at);
    }
    static int unitRank(std::string_view unit) {
        static constexpr std::string_view units[] = {"D", "H", "M", "S", "MS", "US", "NS"};
        for (int i = 0; i < 7; ++i)
            if (unit.size() == units[i].size() && equalsIgnoringCase(unit, units[i])) return i;
        return -1;
    }

    /// The digits and separators of the three calendar literals; how many of each: the numbers between them.
    void date(size_t begin, TokenKind kind, messages::Thing what) {
        const size_t digits = m_at;
        while (isDigit(peek()) || peek() == '_' ||
               ((peek() == '-' || peek() == ':' || peek() == '.') && isDigit(peek(1))))
            ++m_at;
        const size_t good = m_at;
        m_at = wordEnd(m_at);
        int dashes = 0, colons = 0;
        for (char c : slice(digits, good)) {
            dashes += c == '-';
            colons += c == ':';
        }
        const bool shape = kind == TokenKind::DateLiteral        ? dashes == 2 && colons == 0
                           : kind == TokenKind::TimeOfDayLiteral ? dashes == 0 && (colons == 1 || colons == 2)
                                                                 : dashes == 3 && (colons == 1 || colons == 2);
        if (!shape || good != m_at) emit(begin, m_at, findings::InvalidLiteral(slice(begin, m_at), std::move(what)));
        push(kind, begin, m_at);
    }

    /// Digits of a base with underscores between them, several as TwinCAT has it; false when there is no digit or one
    /// is out of place.
    bool takeDigits(int base) {
        bool any = false, good = true;
        for (;; ++m_at) {
            const char c = peek();
            if (c == '_') {
                if (!any || !(isAlnum(peek(1)) || peek(1) == '_')) break;
                continue;
            }
            if (base <= 10 ? !isDigit(c) : !isAlnum(c)) break;
            if (digitValue(c) >= base) {
                if (isDigit(c) || base > 10)
                    good = false;
                else
                    break;
            }
            any = true;
        }
        return any && good;
    }

    /// 10. and 10.E3, which CODESYS accepts, but neither 1..5 nor a member of something.
    bool endsBehindPoint() const {
        const char next = peek(1);
        if (next == 'e' || next == 'E')
            return isDigit(peek(2)) || ((peek(2) == '-' || peek(2) == '+') && isDigit(peek(3)));
        return next != '.' && next != '%' && next != '_' && !isAlnum(next) && static_cast<unsigned char>(next) < 0x80;
    }

    void number() {
        const size_t begin = m_at;
        const bool afterDot =
            !m_list.tokens.empty() && m_list.tokens.back().kind == TokenKind::Dot && m_list.tokens.back().end == m_at;
        takeDigits(10);
        if (peek() == '#' && !afterDot) return based(begin);
        bool real = false;
        if (!afterDot && peek() == '.' && (isDigit(peek(1)) || endsBehindPoint())) {
            real = true;
            ++m_at;
            if (isDigit(peek())) takeDigits(10);
        }
        if (!afterDot && (peek() == 'e' || peek() == 'E')) {
            const size_t sign = peek(1) == '+' || peek(1) == '-' ? 2 : 1;
            if (isDigit(peek(sign))) {
                real = true;
                m_at += sign;
                takeDigits(10);
            }
        }
        finishNumber(begin, real ? TokenKind::RealLiteral : TokenKind::IntegerLiteral,
                     real ? messages::Thing(Verbatim("REAL")) : messages::Thing(phrases::IntegerLiteral()));
    }
    void based(size_t begin) {
        int base = 0;
        for (char c : slice(begin, m_at)) base = c == '_' ? base : std::min(base * 10 + (c - '0'), 1000);
        ++m_at;
        const bool valid = (base == 2 || base == 8 || base == 10 || base == 16) && takeDigits(base);
        const size_t good = m_at;
        m_at = wordEnd(m_at);
        if (!valid || good != m_at)
            emit(begin, m_at, findings::InvalidLiteral(slice(begin, m_at), phrases::IntegerLiteral()));
        push(TokenKind::IntegerLiteral, begin, m_at);
    }
    void finishNumber(size_t begin, TokenKind kind, messages::Thing what) {
        const size_t good = m_at;
        m_at = wordEnd(m_at);
        if (good != m_at) {
            const std::string text(slice(begin, m_at));
            auto& d = emit(begin, m_at, findings::InvalidLiteral(text, std::move(what)));
            if (text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'b' || text[1] == 'o')) { // 0x1F
                const std::string own = (text[1] == 'x' ? "16#" : text[1] == 'b' ? "2#" : "8#") + text.substr(2);
                d.fixes.push_back(
                    {fixes::Write(own), {{{m_file, static_cast<uint32_t>(begin), static_cast<uint32_t>(m_at)}, own}}});
            }
        }
        push(kind, begin, m_at);
    }

    void string(char quote, TokenKind kind) {
        const size_t begin = m_at++;
        while (m_at < m_text.size() && m_text[m_at] != quote && m_text[m_at] != '\n')
            m_at += m_text[m_at] == '$' && peek(1) != '\n' && m_at + 1 < m_text.size() ? 2 : 1;
        if (peek() == quote && m_at < m_text.size()) {
            ++m_at;
            return push(kind, begin, m_at);
        }
        // what closes the statement is not part of the text
        while (m_at > begin + 1 && (m_text[m_at - 1] == '\r' || m_text[m_at - 1] == ' ')) --m_at;
        if (m_at > begin + 1 && m_text[m_at - 1] == ';') {
            --m_at;
            while (m_at > begin + 1 && m_text[m_at - 1] == ')') --m_at;
        }
        emit(begin, m_at, findings::UnterminatedString())
            .fixes.push_back(
                {fixes::Insert(std::string(1, quote)),
                 {{{m_file, static_cast<uint32_t>(m_at), static_cast<uint32_t>(m_at)}, std::string(1, quote)}}});
        push(kind, begin, m_at);
    }

    /// {{ … }}: code in C of Beremiz and OpenPLC, kept and passed over.
    bool codeOfC() {
        if (peek(1) != '{') return false;
        const size_t end = m_text.find("}}", m_at);
        if (end == std::string_view::npos) return false;
        emit(m_at, m_at + 2, findings::CodeOfC());
        push(TokenKind::Pragma, m_at, end + 2);
        m_at = end + 2;
        return true;
    }

    /// The next `quote` closes the value of a pragma over several lines: a } follows it.
    bool endsPragma(char quote) const {
        const size_t at = m_text.find(quote, m_at);
        if (at == std::string_view::npos) return false;
        const size_t next = m_text.find_first_not_of(" \t\r\n", at + 1);
        return next != std::string_view::npos && m_text[next] == '}';
    }

    void pragma() {
        if (codeOfC()) return;
        const size_t begin = m_at++;
        char quote = '\0';
        while (m_at < m_text.size()) {
            const char c = m_text[m_at++];
            if (quote != '\0') {
                if (c == '\n' && !endsPragma(quote)) quote = '\0';
                if (c == quote) quote = '\0';
            } else if (c == '\'' || c == '"') {
                quote = c;
            } else if (c == '}') {
                return push(TokenKind::Pragma, begin, m_at);
            }
        }
        m_at = std::min(m_text.find('\n', begin), m_text.size());
        emit(begin, begin + 1, findings::UnterminatedComment());
        push(TokenKind::Pragma, begin, m_at);
    }

    /// %IX0.0 %I0.0 %QW3 %M* %IX*, behind a point %X3 %B1, and behind AT %X2.1 %B4 (of a member of a structure).
    bool directAddress() {
        size_t at = m_at + 1;
        const auto has = [&](std::string_view set) {
            return at < m_text.size() && set.find(detail::upper(m_text[at])) != std::string_view::npos;
        };
        const bool afterDot = !m_list.tokens.empty() && m_list.tokens.back().kind == TokenKind::Dot && !has("IQM");
        const bool isRelative = !m_list.tokens.empty() && m_list.tokens.back().kind == TokenKind::At && has("XBWDL");
        if (!afterDot && !isRelative) {
            if (!has("IQM")) return false;
            ++at;
        }
        if (has("XBWDL")) ++at;
        if (at < m_text.size() && m_text[at] == '*') {
            ++at;
        } else {
            if (at >= m_text.size() || !isDigit(m_text[at])) return false;
            while (at < m_text.size() && (isDigit(m_text[at]) || (!afterDot && m_text[at] == '.' &&
                                                                  at + 1 < m_text.size() && isDigit(m_text[at + 1]))))
                ++at;
        }
        push(TokenKind::DirectAddress, m_at, at);
        m_at = at;
        return true;
    }

    /// Quotes and dashes of word processors: one message with the plain character as its fix.
    bool typographic(char32_t character, size_t next) {
        const auto isQuote = [](char32_t c) { return c >= 0x2018 && c <= 0x201F; };
        if (character >= 0x2010 && character <= 0x2015) {
            emit(m_at, next, findings::UnknownCharacter(slice(m_at, next)))
                .fixes.push_back({fixes::Write(Verbatim("-")),
                                  {{{m_file, static_cast<uint32_t>(m_at), static_cast<uint32_t>(next)}, "-"}}});
            push(TokenKind::Minus, m_at, next);
            m_at = next;
            return true;
        }
        if (!isQuote(character)) return false;
        const std::string plain = character <= 0x201B ? "'" : "\"";
        size_t at = next;
        while (at < m_text.size() && m_text[at] != '\n') {
            const size_t closeBegin = at;
            const char32_t c = decodeUtf8(m_text, at);
            if (!isQuote(c) && c != '\'' && c != '"') continue;
            emit(m_at, next, findings::UnknownCharacter(slice(m_at, next)))
                .fixes.push_back({fixes::WritePlainQuotes(),
                                  {{{m_file, static_cast<uint32_t>(m_at), static_cast<uint32_t>(next)}, plain},
                                   {{m_file, static_cast<uint32_t>(closeBegin), static_cast<uint32_t>(at)}, plain}}});
            push(TokenKind::StringLiteral, m_at, at);
            m_at = at;
            return true;
        }
        return false;
    }

    /// A run of characters that mean nothing: one token, one message.
    void unknown() {
        const size_t begin = m_at;
        bool readable = decodeUtf8(m_text, m_at) != 0xFFFD;
        while (m_at < m_text.size() && static_cast<unsigned char>(m_text[m_at]) >= 0x80) {
            size_t next = m_at;
            const char32_t character = decodeUtf8(m_text, next);
            if (isNameLetter(character)) break;
            if (character == 0xFFFD) readable = false;
            m_at = next;
        }
        // the same character again on its line is the same mistake (a drawing, a pasted table)
        const bool again = slice(begin, m_at) == m_lastUnknown &&
                           m_text.substr(m_lastUnknownAt, begin - m_lastUnknownAt).find('\n') == std::string_view::npos;
        std::string shown(slice(begin, m_at));
        if (const auto byte = static_cast<unsigned char>(shown.empty() ? ' ' : shown.front());
            byte < 0x20 || byte == 0x7F) { // nobody sees a control character
            char code[8];
            std::snprintf(code, sizeof code, "U+%04X", byte);
            shown = code;
        }
        if (readable && !again) emit(begin, m_at, findings::UnknownCharacter(std::move(shown)));
        m_lastUnknown = slice(begin, m_at);
        m_lastUnknownAt = begin;
        push(TokenKind::Error, begin, m_at);
    }

    FileId m_file;
    std::string_view m_text;
    diagnostics::Sink& m_sink;
    TokenList m_list;
    ExportedLines m_exported{m_text};
    size_t m_at = 0;
    bool m_newline = true;
    std::string_view m_lastUnknown;
    size_t m_lastUnknownAt = 0;
};

} // namespace

TokenList tokenize(FileId file, std::string_view text, diagnostics::Sink& sink) {
    return Lexer(file, text, sink).run();
}

TokenList tokenizeFrom(FileId file, std::string_view text, const TokenList& before, size_t kept,
                       diagnostics::Sink& sink) {
    return Lexer(file, text, sink).runFrom(before, kept);
}

} // namespace plc::lex
