#include "runtime/compiler/parse/conditions.h"

#include "runtime/base/chars.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <optional>

namespace plc::parse {

namespace {

using lex::TokenKind;

bool isWordCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::string_view takeWord(std::string_view& text) {
    text = trimmed(text);
    size_t end = 0;
    while (end < text.size() && isWordCharacter(text[end])) ++end;
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
}

/// NOT defined (a) AND (hasvalue (b, 'x') OR defined (type: T))
class Condition {
public:
    Condition(std::string_view text, const Definitions& known) : m_rest(text), m_known(known) {}

    /// Nothing when it cannot be read.
    std::optional<bool> read() {
        const std::optional<bool> value = readOr();
        return trimmed(m_rest).empty() ? value : std::nullopt;
    }
    [[nodiscard]] bool asksForNames() const { return m_asksForNames; }

private:
    static constexpr int kDeepest = 100;

    bool takeOperator(std::string_view word) {
        std::string_view rest = m_rest;
        if (!equalsIgnoringCase(takeWord(rest), word)) return false;
        m_rest = rest;
        return true;
    }
    bool takeSign(char sign) {
        m_rest = trimmed(m_rest);
        if (m_rest.empty() || m_rest.front() != sign) return false;
        m_rest.remove_prefix(1);
        return true;
    }

    std::optional<bool> readOr() {
        std::optional<bool> value = readAnd();
        while (value && takeOperator("OR")) {
            const std::optional<bool> right = readAnd();
            if (!right) return right;
            value = *value || *right;
        }
        return value;
    }
    std::optional<bool> readAnd() {
        std::optional<bool> value = readNot();
        while (value && takeOperator("AND")) {
            const std::optional<bool> right = readNot();
            if (!right) return right;
            value = *value && *right;
        }
        return value;
    }
    std::optional<bool> readNot() {
        if (++m_depth > kDeepest) return std::nullopt;
        std::optional<bool> value;
        if (takeOperator("NOT")) {
            value = readNot();
            if (value) value = !*value;
        } else if (takeSign('(')) {
            value = readOr();
            if (!takeSign(')')) value.reset();
        } else {
            value = readQuestion();
        }
        --m_depth;
        return value;
    }

    /// The arguments between parentheses, at the comma outside quotes.
    bool takeArguments(std::string_view& first, std::string_view& second) {
        if (!takeSign('(')) return false;
        char quote = 0;
        int depth = 0;
        size_t comma = std::string_view::npos, at = 0;
        for (; at < m_rest.size(); ++at) {
            const char c = m_rest[at];
            if (quote != 0) {
                if (c == quote) quote = 0;
            } else if (c == '\'' || c == '"') {
                quote = c;
            } else if (c == '(') {
                ++depth;
            } else if (c == ')' && depth-- == 0) {
                break;
            } else if (c == ',' && depth == 0 && comma == std::string_view::npos) {
                comma = at;
            }
        }
        if (at == m_rest.size()) return false;
        first = trimmed(m_rest.substr(0, std::min(comma, at)));
        if (comma != std::string_view::npos) second = trimmed(m_rest.substr(comma + 1, at - comma - 1));
        m_rest.remove_prefix(at + 1);
        return !first.empty();
    }

    std::optional<bool> readQuestion() {
        const std::string_view word = takeWord(m_rest);
        std::string_view first, second;
        if (word.empty() || !takeArguments(first, second)) return std::nullopt;
        if (equalsIgnoringCase(word, "defined") || equalsIgnoringCase(word, "project_defined")) return isDefined(first);
        if (equalsIgnoringCase(word, "hasvalue")) {
            const auto it = m_known.values.find(foldCase(first));
            return it != m_known.values.end() && it->second == unquoted(second);
        }
        const auto [kind, name] = kindAndName(first);
        if (equalsIgnoringCase(word, "hasattribute")) {
            m_asksForNames = true;
            const auto it = m_known.attributes.find(foldCase(name));
            return it != m_known.attributes.end() && it->second.count(foldCase(unquoted(second))) != 0;
        }
        if (equalsIgnoringCase(word, "hastype")) {
            m_asksForNames = true;
            const auto it = m_known.variables.find(foldCase(name));
            return it != m_known.variables.end() && equalsIgnoringCase(it->second, second);
        }
        return std::nullopt;
    }

    static std::pair<std::string_view, std::string_view> kindAndName(std::string_view text) {
        const size_t colon = text.find(':');
        if (colon == std::string_view::npos) return {{}, text};
        return {trimmed(text.substr(0, colon)), trimmed(text.substr(colon + 1))};
    }

    std::optional<bool> isDefined(std::string_view text) {
        const auto [kind, name] = kindAndName(text);
        const std::string folded = foldCase(name);
        if (kind.empty()) return m_known.values.count(folded) != 0;
        m_asksForNames = true;
        if (equalsIgnoringCase(kind, "variable")) return m_known.variables.count(folded) != 0;
        if (equalsIgnoringCase(kind, "type"))
            return m_known.types.count(folded) != 0 || m_known.pous.count(folded) != 0;
        if (equalsIgnoringCase(kind, "pou")) return m_known.pous.count(folded) != 0;
        if (equalsIgnoringCase(kind, "task")) return m_known.tasks.count(folded) != 0;
        if (equalsIgnoringCase(kind, "resource")) return false; // no device has resources to ask for
        return std::nullopt;
    }

    std::string_view m_rest;
    const Definitions& m_known;
    bool m_asksForNames = false;
    int m_depth = 0;
};

class Reader {
public:
    Reader(FileId file, std::string_view text, const lex::TokenList& tokens, const Definitions* known,
           diagnostics::Sink& sink)
        : m_file(file), m_text(text), m_tokens(tokens), m_sink(sink) {
        if (known) m_known = *known;
    }

    Conditions read() {
        for (size_t i = 0; i < m_tokens.tokens.size(); ++i) {
            const lex::Token& token = m_tokens.tokens[i];
            if (token.kind == TokenKind::Pragma) readPragma(token);
            if (isActive()) continue;
            if (m_out.isInactive.empty()) m_out.isInactive.resize(m_tokens.tokens.size());
            if (token.kind != TokenKind::EndOfFile) m_out.isInactive[i] = true;
        }
        for (const Level& level : m_levels)
            m_sink.emit(level.range, findings::ConditionNotClosed(Verbatim("END_IF"), Verbatim("IF")));
        return std::move(m_out);
    }

private:
    struct Level {
        SourceRange range;
        bool isOuterActive = true, isActive = true, wasTaken = false, hasElse = false;
    };
    bool isActive() const { return m_levels.empty() || m_levels.back().isActive; }

    bool evaluate(std::string_view text, SourceRange range) {
        Condition condition(text, m_known);
        const std::optional<bool> value = condition.read();
        m_out.asksForNames |= condition.asksForNames();
        if (!value) m_sink.emit(range, findings::ConditionNotRead(trimmed(text)));
        return value.value_or(false);
    }

    void readPragma(const lex::Token& token) {
        std::string_view text = m_text.substr(token.begin, token.end - token.begin);
        if (!text.starts_with('{') || text.starts_with("{{")) return;
        text.remove_prefix(1);
        if (text.ends_with('}')) text.remove_suffix(1);
        const SourceRange range{m_file, token.begin, token.end};
        const std::string_view word = takeWord(text);
        if (equalsIgnoringCase(word, "IF")) return open(text, range);
        if (equalsIgnoringCase(word, "ELSIF") || equalsIgnoringCase(word, "ELSE") || equalsIgnoringCase(word, "END_IF"))
            return goOn(word, text, range);
        if (!isActive()) return;
        if (equalsIgnoringCase(word, "define")) {
            const std::string name = foldCase(takeWord(text));
            if (!name.empty()) m_known.values[name] = unquoted(text);
        } else if (equalsIgnoringCase(word, "undefine")) {
            m_known.values.erase(foldCase(takeWord(text)));
        } else {
            speak(word, text, range);
        }
    }

    void speak(std::string_view word, std::string_view text, SourceRange range) {
        if (!trimmed(text).starts_with('\'')) return; // {warning disable C0195} switches a message of its own compiler
        const std::string_view said = unquoted(text);
        if (equalsIgnoringCase(word, "error")) m_sink.emit(range, findings::PragmaError(said));
        if (equalsIgnoringCase(word, "warning")) m_sink.emit(range, findings::PragmaWarning(said));
        if (equalsIgnoringCase(word, "info") || equalsIgnoringCase(word, "text"))
            m_sink.emit(range, findings::PragmaNote(said));
    }

    void open(std::string_view condition, SourceRange range) {
        Level level;
        level.range = range;
        level.isOuterActive = isActive();
        level.isActive = level.isOuterActive && evaluate(condition, range);
        level.wasTaken = level.isActive;
        m_levels.push_back(level);
    }

    void goOn(std::string_view word, std::string_view condition, SourceRange range) {
        if (m_levels.empty()) {
            m_sink.emit(range, findings::ConditionNotClosed(Verbatim("IF"), word));
            return;
        }
        Level& level = m_levels.back();
        if (equalsIgnoringCase(word, "END_IF")) {
            m_levels.pop_back();
            return;
        }
        if (level.hasElse) {
            m_sink.emit(range, findings::ConditionNotClosed(Verbatim("IF"), word));
            return;
        }
        const bool isElse = equalsIgnoringCase(word, "ELSE");
        level.hasElse = isElse;
        const bool isOpen = level.isOuterActive && !level.wasTaken;
        level.isActive = isOpen && (isElse || evaluate(condition, range));
        level.wasTaken |= level.isActive;
    }

    FileId m_file;
    std::string_view m_text;
    const lex::TokenList& m_tokens;
    diagnostics::Sink& m_sink;
    Definitions m_known;
    std::vector<Level> m_levels;
    Conditions m_out;
};

} // namespace

Conditions readConditions(FileId file, std::string_view text, const lex::TokenList& tokens, const Definitions* known,
                          diagnostics::Sink& sink) {
    const bool hasPragmas = std::any_of(tokens.tokens.begin(), tokens.tokens.end(),
                                        [](const lex::Token& token) { return token.kind == TokenKind::Pragma; });
    return hasPragmas ? Reader(file, text, tokens, known, sink).read() : Conditions();
}

} // namespace plc::parse
