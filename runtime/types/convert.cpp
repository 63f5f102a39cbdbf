// X_TO_Y for every pair of elementary types (edition 3, table 22, and the units of CODESYS for times and dates).
#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

#include <charconv>
#include <cmath>

namespace plc::types {
namespace {

constexpr int64_t kSecond = 1'000'000'000;
constexpr int64_t kDay = 86'400 * kSecond;

/// Nanoseconds that one count of the number stands for: TIME and TOD count milliseconds, DATE and DT seconds, long forms nanoseconds.
int64_t unitOf(TypeKind kind) {
    switch (kind) {
    case TypeKind::Time:
    case TypeKind::Tod: return 1'000'000;
    case TypeKind::Date:
    case TypeKind::Dt: return kSecond;
    default: return 1;
    }
}

bool isTime(Family family) { return family == Family::Duration || family == Family::Date || family == Family::TimeOfDay || family == Family::DateTime; }
bool isUnsigned64(TypeKind kind) { return kind == TypeKind::Ulint || kind == TypeKind::Lword; }

int64_t startOfDay(int64_t nanoseconds) {
    const int64_t rest = nanoseconds % kDay;
    return nanoseconds - rest - (rest < 0 ? kDay : 0);
}

/// Any instant or duration as a value of `to`: dates begin their day, times of day stay within it.
int64_t fitTime(TypeKind to, int64_t nanoseconds) {
    const Family family = familyOf(to);
    if (family == Family::Date) return startOfDay(nanoseconds);
    if (family == Family::TimeOfDay) return nanoseconds - startOfDay(nanoseconds);
    return nanoseconds;
}

double realOf(TypeKind to, TypeKind from, int64_t number) {
    if (isUnsigned64(from)) {
        const auto word = static_cast<uint64_t>(number);
        return to == TypeKind::Real ? static_cast<double>(static_cast<float>(word)) : static_cast<double>(word);
    }
    return to == TypeKind::Real ? static_cast<double>(static_cast<float>(number)) : static_cast<double>(number);
}

Value fromInteger(TypeId type, TypeKind to, TypeKind from, int64_t number) {
    const Family family = familyOf(to);
    if (family == Family::Real) return {type, realOf(to, from, number)};
    if (isTime(family)) {
        const auto nanoseconds = static_cast<int64_t>(static_cast<uint64_t>(number) * static_cast<uint64_t>(unitOf(to)));
        return {type, fitTime(to, nanoseconds)};
    }
    return {type, wrapInteger(to, number)};
}

Value fromReal(TypeId type, TypeKind to, double number) {
    const Family family = familyOf(to);
    if (family == Family::Real) return {type, to == TypeKind::Real ? static_cast<double>(static_cast<float>(number)) : number};
    if (isTime(family)) {
        const int64_t limit = INT64_MAX / unitOf(to);
        const int64_t count = std::clamp(roundToInteger(TypeKind::Lint, number), -limit, limit);
        return {type, fitTime(to, count * unitOf(to))};
    }
    return {type, roundToInteger(to, number)};
}

Value fromTime(TypeId type, TypeKind to, TypeKind from, int64_t nanoseconds) {
    const Family family = familyOf(to);
    if (isTime(family)) return {type, fitTime(to, nanoseconds)};
    if (family == Family::Bool) return {type, int64_t(nanoseconds != 0)};
    const int64_t count = nanoseconds / unitOf(from);
    if (family == Family::Real) return {type, realOf(to, TypeKind::Lint, count)};
    return {type, wrapInteger(to, count)};
}

std::string textOf(TypeKind from, const Value& value) {
    if (const auto* real = std::get_if<double>(&value.data)) return from == TypeKind::Real ? shortestReal(static_cast<float>(*real)) : shortestReal(*real);
    const int64_t number = value.integer();
    switch (from) {
    case TypeKind::Bool: return number ? "TRUE" : "FALSE";
    case TypeKind::Time: return durationText(number);
    case TypeKind::Ltime: return durationText(number, true);
    case TypeKind::Date: return dateText(number);
    case TypeKind::Ldate: return dateText(number, true);
    case TypeKind::Tod: return timeOfDayText(number);
    case TypeKind::Ltod: return timeOfDayText(number, true);
    case TypeKind::Dt: return dateTimeText(number);
    case TypeKind::Ldt: return dateTimeText(number, true);
    case TypeKind::Ulint:
    case TypeKind::Lword: return std::to_string(static_cast<uint64_t>(number));
    default: return std::to_string(number);
    }
}

/// One text type into the other, or a scalar's text into either, cut to the capacity. Latin-1 maps onto the first 256 of UTF-16.
Value toTextValue(const TypeTable& types, TypeId type, const Value& value, bool& ok) {
    const Type& target = types[types.storage(type)];
    std::u16string wide;
    if (const auto* text = std::get_if<std::string>(&value.data)) {
        for (const char c : *text) wide += static_cast<unsigned char>(c);
    } else if (const auto* text16 = std::get_if<std::u16string>(&value.data)) {
        wide = *text16;
    } else if (const TypeKind from = types.storageKind(value.type); familyOf(from) == Family::Character) {
        if (value.integer() != 0) wide += static_cast<char16_t>(value.integer());
    } else {
        for (const char c : textOf(from, value)) wide += static_cast<unsigned char>(c);
    }
    if (wide.size() > target.capacity) wide.resize(target.capacity);
    if (target.kind == TypeKind::Wstring) return {type, std::move(wide)};
    std::string narrow;
    for (const char16_t c : wide) {
        if (c > 0xFF) ok = false;
        narrow += c > 0xFF ? '?' : static_cast<char>(c);
    }
    return {type, std::move(narrow)};
}

std::string_view withoutBlanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

/// The number that a text begins with: "12;", "-5 mm", "16#FF". None without a digit or beyond the range of `kind`.
std::optional<int64_t> leadingInteger(TypeKind kind, std::string_view text) {
    const bool isNegative = !text.empty() && text.front() == '-';
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
    int base = 10;
    for (const auto& [prefix, radix] : {std::pair<std::string_view, int>{"16#", 16}, {"8#", 8}, {"2#", 2}}) {
        if (!text.starts_with(prefix)) continue;
        base = radix;
        text.remove_prefix(prefix.size());
        break;
    }
    std::string digits;
    for (const char c : text) {
        if (c == '_' && !digits.empty()) continue;
        digits += c;
    }
    uint64_t magnitude = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), magnitude, base);
    if (error != std::errc()) return std::nullopt;
    const auto [low, high] = TypeTable::integerRange(kind);
    if (isNegative && magnitude > 0 - static_cast<uint64_t>(low)) return std::nullopt;
    if (!isNegative && magnitude > high && !(base != 10 && bitsOf(kind) >= 64)) return std::nullopt;
    return static_cast<int64_t>(isNegative ? 0 - magnitude : magnitude);
}

template <class Number> std::optional<double> leadingReal(std::string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    if (equalsIgnoringCase(text, "INF")) return HUGE_VAL;
    if (equalsIgnoringCase(text, "-INF")) return -HUGE_VAL;
    if (equalsIgnoringCase(text, "NAN")) return std::nan("");
    const size_t digit = text.starts_with('-') ? 1 : 0;
    if (digit >= text.size() || !((text[digit] >= '0' && text[digit] <= '9') || text[digit] == '.')) return std::nullopt; // not "infinity…"
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return std::nullopt;
    return static_cast<double>(number);
}

Value fromText(const TypeTable&, TypeId type, TypeKind to, std::string_view text, bool& ok) {
    const std::string_view trimmed = withoutBlanks(text);
    const auto scalar = [&](std::optional<int64_t> number) -> Value {
        if (!number) ok = false;
        return {type, number.value_or(0)};
    };
    switch (familyOf(to)) {
    case Family::Bool:
        if (equalsIgnoringCase(trimmed, "TRUE") || trimmed == "1") return {type, int64_t{1}};
        ok = equalsIgnoringCase(trimmed, "FALSE") || trimmed == "0";
        return {type, int64_t{0}};
    case Family::Bits:
    case Family::Signed:
    case Family::Unsigned: return scalar(leadingInteger(to, trimmed));
    case Family::Real: {
        const auto number = to == TypeKind::Real ? leadingReal<float>(trimmed) : leadingReal<double>(trimmed);
        if (!number) ok = false;
        return {type, number.value_or(0.0)};
    }
    case Family::Duration: return scalar(parseDuration(trimmed));
    case Family::Date: return scalar(parseDate(trimmed));
    case Family::TimeOfDay: return scalar(parseTimeOfDay(trimmed));
    case Family::DateTime: return scalar(parseDateTime(trimmed));
    case Family::Character:
        if (text.empty()) ok = false;
        return {type, text.empty() ? int64_t{0} : static_cast<int64_t>(static_cast<unsigned char>(text.front()))};
    case Family::Other: break;
    }
    ok = false;
    return {type, int64_t{0}};
}

Value fromWideText(const TypeTable& types, TypeId type, TypeKind to, std::u16string_view text, bool& ok) {
    if (to == TypeKind::Wchar) {
        if (text.empty()) ok = false;
        return {type, text.empty() ? int64_t{0} : static_cast<int64_t>(text.front())};
    }
    std::string narrow; // a character beyond Latin-1 ends the number, as any other letter does
    for (const char16_t c : text) narrow += c > 0xFF ? '?' : static_cast<char>(c);
    if (to == TypeKind::Char && !text.empty() && text.front() > 0xFF) ok = false;
    return fromText(types, type, to, narrow, ok);
}

} // namespace

Value convert(const TypeTable& types, const Value& value, TypeId to, bool* ok) {
    bool good = true;
    const auto finish = [&](Value result) {
        if (ok) *ok = good;
        return result;
    };
    if (value.type == to) return finish(value);
    if (!value.hasValue() || std::holds_alternative<std::vector<Value>>(value.data)) {
        good = false;
        return finish({to, value.data});
    }
    const TypeKind source = types.storageKind(value.type), target = types.storageKind(to);
    if (target == TypeKind::String || target == TypeKind::Wstring) return finish(toTextValue(types, to, value, good));
    if (const auto* text = std::get_if<std::string>(&value.data)) return finish(fromText(types, to, target, *text, good));
    if (const auto* wide = std::get_if<std::u16string>(&value.data)) return finish(fromWideText(types, to, target, *wide, good));
    if (const auto* real = std::get_if<double>(&value.data)) return finish(fromReal(to, target, *real));
    if (isTime(familyOf(source))) return finish(fromTime(to, target, source, value.integer()));
    return finish(fromInteger(to, target, source, value.integer()));
}

} // namespace plc::types
