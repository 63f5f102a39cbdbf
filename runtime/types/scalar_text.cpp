#include "runtime/types/scalar_text.h"

#include "runtime/base/chars.h"
#include "runtime/types/dates.h"
#include "runtime/types/type_table.h"
#include "runtime/types/value.h"

#include <charconv>
#include <cmath>
#include <cstring>

namespace plc::types {
namespace {

bool isWord(std::string_view text, std::string_view upper) {
    if (text.size() != upper.size()) return false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i] >= 'a' && text[i] <= 'z' ? static_cast<char>(text[i] - 32) : text[i];
        if (c != upper[i]) return false;
    }
    return true;
}

unsigned digitValue(char c) {
    if (isDigit(c)) return static_cast<unsigned>(c - '0');
    if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
    if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
    return 99;
}

/// Takes "16#", "8#" or "2#" off the begin.
unsigned takeBase(std::string_view& text) {
    for (const auto& [prefix, base] : {std::pair<std::string_view, unsigned>{"16#", 16}, {"8#", 8}, {"2#", 2}}) {
        if (!text.starts_with(prefix)) continue;
        text.remove_prefix(prefix.size());
        return base;
    }
    return 10;
}

/// The digits that a text begins with, taken off it; none without one or beyond 64 bits.
std::optional<uint64_t> takeDigits(std::string_view& text, unsigned base) {
    uint64_t value = 0;
    size_t at = 0;
    for (; at < text.size(); ++at) {
        if (text[at] == '_' && at > 0 && at + 1 < text.size() && digitValue(text[at + 1]) < base) continue;
        const unsigned digit = digitValue(text[at]);
        if (digit >= base) break;
        if (value > (UINT64_MAX - digit) / base) return std::nullopt;
        value = value * base + digit;
    }
    if (at == 0) return std::nullopt;
    text.remove_prefix(at);
    return value;
}

bool takeSign(std::string_view& text) {
    const bool isNegative = text.starts_with('-');
    if (isNegative || text.starts_with('+')) text.remove_prefix(1);
    return isNegative;
}

/// "12;", "-5 mm", "16#FF" → 12, -5, 255.
std::optional<int64_t> leadingInteger(TypeKind kind, std::string_view text) {
    const bool isNegative = takeSign(text);
    const unsigned base = takeBase(text);
    const auto magnitude = takeDigits(text, base);
    if (!magnitude) return std::nullopt;
    const auto [low, high] = TypeTable::integerRange(kind);
    if (isNegative ? *magnitude > 0 - static_cast<uint64_t>(low) : *magnitude > high) return std::nullopt;
    return static_cast<int64_t>(isNegative ? 0 - *magnitude : *magnitude);
}

std::optional<int64_t> boolFromText(std::string_view text) {
    if (isWord(text, "TRUE") || text == "1") return 1;
    if (isWord(text, "FALSE") || text == "0") return 0;
    return std::nullopt;
}

/// Reads a real number at the begin of `text`; `end` is behind it.
template <class Number> std::optional<double> leadingReal(std::string_view text, const char*& end) {
    const size_t first = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
    if (first >= text.size() ||
        !(isDigit(text[first]) || (text[first] == '.' && first + 1 < text.size() && isDigit(text[first + 1]))))
        return std::nullopt;
    if (text.front() == '+') text.remove_prefix(1);
    Number number = 0;
    const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return std::nullopt;
    end = last;
    return static_cast<double>(number);
}

} // namespace

void ScalarText::append(std::string_view text) {
    const size_t count = std::min(text.size(), sizeof data - size);
    std::memcpy(data + size, text.data(), count);
    size += static_cast<uint32_t>(count);
}

void ScalarText::append(int64_t number, unsigned minimumDigits) {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    for (auto length = static_cast<size_t>(end - digits); length < minimumDigits; ++length) append("0");
    append(std::string_view(digits, static_cast<size_t>(end - digits)));
}

ScalarText scalarText(TypeKind kind, int64_t value) {
    ScalarText out;
    switch (kind) {
    case TypeKind::Bool:
        out.append(value ? "TRUE" : "FALSE");
        break;
    case TypeKind::Time:
        appendDuration(out, value, false);
        break;
    case TypeKind::Ltime:
        appendDuration(out, value, true);
        break;
    case TypeKind::Date:
        appendDate(out, value, false);
        break;
    case TypeKind::Ldate:
        appendDate(out, value, true);
        break;
    case TypeKind::Tod:
        appendTimeOfDay(out, value, false);
        break;
    case TypeKind::Ltod:
        appendTimeOfDay(out, value, true);
        break;
    case TypeKind::Dt:
        appendDateTime(out, value, false);
        break;
    case TypeKind::Ldt:
        appendDateTime(out, value, true);
        break;
    case TypeKind::Ulint:
    case TypeKind::Lword:
        out.size = static_cast<uint32_t>(
            std::to_chars(out.data, out.data + sizeof out.data, static_cast<uint64_t>(value)).ptr - out.data);
        break;
    default:
        out.append(value);
        break;
    }
    return out;
}

ScalarText realText(TypeKind kind, double value) {
    ScalarText out;
    if (std::isnan(value)) {
        out.append("NaN");
    } else if (std::isinf(value)) {
        out.append(value > 0 ? "INF" : "-INF");
    } else {
        const char* end = kind == TypeKind::Real
                              ? std::to_chars(out.data, out.data + sizeof out.data, static_cast<float>(value)).ptr
                              : std::to_chars(out.data, out.data + sizeof out.data, value).ptr;
        out.size = static_cast<uint32_t>(end - out.data);
        if (out.view().find_first_of(".e") == std::string_view::npos) out.append(".0");
    }
    return out;
}

std::optional<int64_t> integerFromText(TypeKind kind, std::string_view text) {
    const std::string_view trimmed = withoutBlanks(text);
    switch (familyOf(kind)) {
    case Family::Bool:
        return boolFromText(trimmed);
    case Family::Bits:
    case Family::Signed:
    case Family::Unsigned:
        return leadingInteger(kind, trimmed);
    case Family::Duration:
        return parseDuration(trimmed);
    case Family::Date:
        return parseDate(trimmed);
    case Family::TimeOfDay:
        return parseTimeOfDay(trimmed);
    case Family::DateTime:
        return parseDateTime(trimmed);
    case Family::Character:
        if (text.empty()) return std::nullopt;
        return static_cast<unsigned char>(text.front());
    case Family::Real:
    case Family::Other:
        break;
    }
    return std::nullopt;
}

std::optional<double> realFromText(TypeKind kind, std::string_view text) {
    const std::string_view trimmed = withoutBlanks(text);
    if (isWord(trimmed, "NAN")) return std::nan("");
    if (isWord(trimmed, "INF") || isWord(trimmed, "+INF")) return HUGE_VAL;
    if (isWord(trimmed, "-INF")) return -HUGE_VAL;
    const char* end = nullptr;
    return kind == TypeKind::Real ? leadingReal<float>(trimmed, end) : leadingReal<double>(trimmed, end);
}

bool isNumberText(std::string_view text) {
    const std::string_view trimmed = withoutBlanks(text);
    const char* end = nullptr;
    if (leadingReal<double>(trimmed, end) && end == trimmed.data() + trimmed.size()) return true;
    std::string_view rest = trimmed;
    takeSign(rest);
    const unsigned base = takeBase(rest);
    return takeDigits(rest, base).has_value() && rest.empty();
}

std::optional<char32_t> escapedCharacter(char c) {
    switch (c) {
    case 'L':
    case 'l':
    case 'N':
    case 'n':
        return U'\n';
    case 'P':
    case 'p':
        return U'\f';
    case 'R':
    case 'r':
        return U'\r';
    case 'T':
    case 't':
        return U'\t';
    case '$':
    case '\'':
    case '"':
        return static_cast<char32_t>(c);
    default:
        return std::nullopt;
    }
}

} // namespace plc::types
