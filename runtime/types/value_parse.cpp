#include "runtime/base/text.h"
#include "runtime/types/conversion.h"
#include "runtime/types/scalar_text.h"
#include "runtime/types/value.h"
#include "runtime/types/wide_text.h"

#include <charconv>
#include <cmath>

namespace plc::types {
namespace {

/// Reads one value text from left to right; every function gives none at the first thing that does not fit.
class ValueReader {
public:
    ValueReader(const TypeTable& types, std::string_view text) : m_types(types), m_text(text) {}

    std::optional<Value> readAll(TypeId type) {
        auto value = read(type, 0);
        skipBlanks();
        return value && m_at == m_text.size() ? value : std::nullopt;
    }

private:
    static constexpr int kMaximumDepth = 64;

    void skipBlanks() {
        while (m_at < m_text.size() &&
               (m_text[m_at] == ' ' || m_text[m_at] == '\t' || m_text[m_at] == '\n' || m_text[m_at] == '\r'))
            ++m_at;
    }
    bool take(char c) {
        skipBlanks();
        if (m_at >= m_text.size() || m_text[m_at] != c) return false;
        ++m_at;
        return true;
    }
    /// Everything up to the next separator outside of it.
    std::string_view takeWord() {
        skipBlanks();
        const size_t begin = m_at;
        while (m_at < m_text.size() && m_text[m_at] != ',' && m_text[m_at] != ')' && m_text[m_at] != ']' &&
               m_text[m_at] != '(')
            ++m_at;
        size_t end = m_at;
        while (end > begin && (m_text[end - 1] == ' ' || m_text[end - 1] == '\t')) --end;
        return m_text.substr(begin, end - begin);
    }

    std::optional<Value> read(TypeId type, int depth) {
        if (depth > kMaximumDepth) return std::nullopt;
        const Type& t = m_types[type];
        if (t.kind == TypeKind::Array) return readArray(type, depth);
        if (t.kind == TypeKind::Struct || t.kind == TypeKind::Union || t.kind == TypeKind::Block)
            return readFields(type, depth);
        if (t.kind == TypeKind::String || t.kind == TypeKind::Char) return readText(type, '\'');
        if (t.kind == TypeKind::Wstring || t.kind == TypeKind::Wchar) return readText(type, '"');
        return readScalar(type, takeWord());
    }

    std::optional<Value> readArray(TypeId type, int depth) {
        const Type& t = m_types[type];
        uint64_t count = 1;
        for (const Dimension& dimension : t.dimensions) count *= dimension.count();
        if (!take('[')) return std::nullopt;
        std::vector<Value> elements;
        skipBlanks();
        if (!take(']')) {
            do {
                if (!readElements(t.element, elements, count, depth)) return std::nullopt;
            } while (take(','));
            if (!take(']')) return std::nullopt;
        }
        while (elements.size() < count) elements.push_back(initialValue(m_types, t.element));
        return Value{type, std::move(elements)};
    }
    bool readElements(TypeId element, std::vector<Value>& elements, uint64_t count, int depth) {
        const size_t before = m_at;
        skipBlanks();
        size_t digits = m_at;
        while (digits < m_text.size() && m_text[digits] >= '0' && m_text[digits] <= '9') ++digits;
        uint64_t repeat = 0;
        if (digits > m_at && digits < m_text.size() && m_text[digits] == '(') {
            std::from_chars(m_text.data() + m_at, m_text.data() + digits, repeat);
            if (repeat > count) return false;
            m_at = digits + 1;
            const auto value = read(element, depth + 1);
            if (!value || !take(')')) return false;
            for (uint64_t i = 0; i < repeat; ++i) elements.push_back(*value);
        } else {
            m_at = before;
            auto value = read(element, depth + 1);
            if (!value) return false;
            elements.push_back(std::move(*value));
        }
        return elements.size() <= count;
    }

    std::optional<Value> readFields(TypeId type, int depth) {
        const Type& t = m_types[type];
        if (!take('(')) return std::nullopt;
        Value value = initialValue(m_types, type);
        auto& fields = std::get<std::vector<Value>>(value.data);
        if (take(')')) return value;
        do {
            skipBlanks();
            const size_t assign = m_text.find(":=", m_at);
            if (assign == std::string_view::npos) return std::nullopt;
            std::string_view name = m_text.substr(m_at, assign - m_at);
            while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
            const Field* field = t.findField(name);
            if (!field) return std::nullopt;
            m_at = assign + 2;
            if (field->section == FieldSection::InOut) return std::nullopt;
            auto part = read(field->type, depth + 1);
            if (!part) return std::nullopt;
            fields[static_cast<size_t>(field - t.fields.data())] = std::move(*part);
        } while (take(','));
        return take(')') ? std::optional(std::move(value)) : std::nullopt;
    }

    std::optional<std::u32string> takeQuoted(char quote) {
        skipBlanks();
        if (m_at >= m_text.size() || (m_text[m_at] != '\'' && m_text[m_at] != '"')) return std::nullopt;
        quote = m_text[m_at++];
        std::u32string out;
        while (m_at < m_text.size() && m_text[m_at] != quote) {
            if (m_text[m_at] != '$') {
                out += decodeUtf8(m_text, m_at);
                continue;
            }
            if (++m_at >= m_text.size()) return std::nullopt;
            const char c = m_text[m_at];
            const size_t digits = quote == '"' ? 4 : 2;
            uint32_t code = 0;
            if (m_at + digits <= m_text.size() &&
                std::from_chars(m_text.data() + m_at, m_text.data() + m_at + digits, code, 16).ptr ==
                    m_text.data() + m_at + digits) {
                out += digits == 2 ? kRawByte + code : code;
                m_at += digits;
                continue;
            }
            ++m_at;
            const auto character = escapedCharacter(c);
            if (!character) return std::nullopt;
            out += *character;
        }
        if (m_at >= m_text.size()) return std::nullopt;
        ++m_at;
        return out;
    }
    std::optional<Value> readText(TypeId type, char quote) {
        const auto text = takeQuoted(quote);
        if (!text) return std::nullopt;
        const Type& t = m_types[type];
        if (t.kind == TypeKind::Wstring || t.kind == TypeKind::Wchar) {
            std::u16string wide = wideOfCharacters(*text);
            if (t.kind == TypeKind::Wchar)
                return wide.size() == 1 ? std::optional(Value{type, static_cast<int64_t>(wide[0])}) : std::nullopt;
            if (wide.size() > t.capacity) return std::nullopt;
            return Value{type, std::move(wide)};
        }
        std::string narrow;
        for (const char32_t c : *text)
            if (!appendCharacter(m_types.strings, narrow, c)) return std::nullopt;
        if (t.kind == TypeKind::Char)
            return narrow.size() == 1
                       ? std::optional(Value{type, static_cast<int64_t>(static_cast<unsigned char>(narrow[0]))})
                       : std::nullopt;
        if (narrow.size() > t.capacity) return std::nullopt;
        return Value{type, std::move(narrow)};
    }

    static std::string withoutUnderscores(std::string_view word) {
        std::string out;
        for (const char c : word)
            if (c != '_') out += c;
        return out;
    }

    /// 16#FF, -5, 1_000: value and whether it needs the unsigned 64-bit range.
    static std::optional<__int128> integerOf(std::string_view word) {
        std::string digits = withoutUnderscores(word);
        bool isNegative = false;
        size_t at = 0;
        if (!digits.empty() && (digits[0] == '-' || digits[0] == '+')) isNegative = digits[at++] == '-';
        int base = 10;
        if (const size_t hash = digits.find('#', at); hash != std::string::npos) {
            if (std::from_chars(digits.data() + at, digits.data() + hash, base).ptr != digits.data() + hash ||
                base < 2 || base > 16)
                return std::nullopt;
            at = hash + 1;
        }
        uint64_t magnitude = 0;
        const auto [end, error] = std::from_chars(digits.data() + at, digits.data() + digits.size(), magnitude, base);
        if (error != std::errc() || end != digits.data() + digits.size() || at == digits.size()) return std::nullopt;
        return isNegative ? -static_cast<__int128>(magnitude) : static_cast<__int128>(magnitude);
    }

    std::optional<Value> readEnumerator(TypeId type, std::string_view word) {
        if (const size_t mark = word.find_last_of(".#");
            mark != std::string_view::npos && !word.empty() && !(word[0] >= '0' && word[0] <= '9'))
            word = word.substr(mark + 1);
        for (TypeId id = type; m_types.kind(id) == TypeKind::Enum || m_types.kind(id) == TypeKind::Subrange;
             id = m_types[id].element)
            for (const Enumerator& enumerator : m_types[id].enumerators)
                if (equalsIgnoringCase(enumerator.name, word)) return Value{type, enumerator.value};
        return std::nullopt;
    }

    std::optional<Value> readScalar(TypeId type, std::string_view word) {
        if (word.empty()) return std::nullopt;
        if (const auto named = readEnumerator(type, word)) return named;
        const TypeKind kind = m_types.storageKind(type);
        const Family family = familyOf(kind);
        // INT#5, REAL#1.5, BOOL#1: the type's own name before the value
        if (const size_t hash = word.find('#'); hash != std::string_view::npos &&
                                                equalsIgnoringCase(word.substr(0, hash), spelling(kind)) &&
                                                (family == Family::Bool || isInteger(family) || family == Family::Real))
            word = word.substr(hash + 1);
        const auto scalar = [&](std::optional<int64_t> number) {
            return number ? std::optional(Value{type, *number}) : std::nullopt;
        };
        switch (family) {
        case Family::Bool:
            if (equalsIgnoringCase(word, "TRUE") || word == "1") return Value{type, int64_t{1}};
            if (equalsIgnoringCase(word, "FALSE") || word == "0") return Value{type, int64_t{0}};
            return std::nullopt;
        case Family::Duration:
            return scalar(parseDuration(word));
        case Family::Date:
            return scalar(parseDate(word));
        case Family::TimeOfDay:
            return scalar(parseTimeOfDay(word));
        case Family::DateTime:
            return scalar(parseDateTime(word));
        case Family::Real:
            return readReal(type, kind, word);
        case Family::Bits:
        case Family::Signed:
        case Family::Unsigned:
            return readInteger(type, kind, word);
        case Family::Character:
            return std::nullopt;
        case Family::Other:
            if (equalsIgnoringCase(word, "NULL") || word == "0") return Value{type, int64_t{0}};
            return std::nullopt;
        }
        return std::nullopt;
    }

    std::optional<Value> readInteger(TypeId type, TypeKind kind, std::string_view word) {
        const auto number = integerOf(word);
        if (!number) return std::nullopt;
        const auto [low, high] = TypeTable::integerRange(kind);
        // 16#FFFF may also be written for the -1 of a signed type of that width
        const bool isPattern =
            word.find('#') != std::string_view::npos && *number >= 0 &&
            *number <= static_cast<__int128>(bitsOf(kind) == 64 ? UINT64_MAX : (uint64_t(1) << bitsOf(kind)) - 1);
        if (!isPattern && (*number < low || *number > static_cast<__int128>(high))) return std::nullopt;
        const int64_t value = wrapInteger(kind, static_cast<int64_t>(static_cast<uint64_t>(*number)));
        const Type& t = m_types[type];
        if (t.kind == TypeKind::Subrange && (value < t.low || value > t.high)) return std::nullopt;
        return Value{type, value};
    }

    std::optional<Value> readReal(TypeId type, TypeKind kind, std::string_view word) {
        const std::string digits = withoutUnderscores(word);
        if (equalsIgnoringCase(digits, "NaN")) return Value{type, std::nan("")};
        if (equalsIgnoringCase(digits, "INF") || equalsIgnoringCase(digits, "+INF")) return Value{type, HUGE_VAL};
        if (equalsIgnoringCase(digits, "-INF")) return Value{type, -HUGE_VAL};
        if (digits.find('#') != std::string::npos) {
            const auto number = integerOf(digits);
            return number ? std::optional(Value{type, static_cast<double>(*number)}) : std::nullopt;
        }
        const char* begin = digits.data() + (digits[0] == '+' ? 1 : 0);
        const char* end = digits.data() + digits.size();
        if (kind == TypeKind::Real) {
            float number = 0;
            const auto [last, error] = std::from_chars(begin, end, number);
            return error == std::errc() && last == end && std::isfinite(number)
                       ? std::optional(Value{type, static_cast<double>(number)})
                       : std::nullopt;
        }
        double number = 0;
        const auto [last, error] = std::from_chars(begin, end, number);
        return error == std::errc() && last == end && std::isfinite(number) ? std::optional(Value{type, number})
                                                                            : std::nullopt;
    }

    const TypeTable& m_types;
    std::string_view m_text;
    size_t m_at = 0;
};

} // namespace

std::optional<Value> parseValue(const TypeTable& types, TypeId type, std::string_view text) {
    return ValueReader(types, text).readAll(type);
}

} // namespace plc::types
