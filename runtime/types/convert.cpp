// X_TO_Y for every pair of elementary types (edition 3, table 22, and the units of CODESYS for times and dates).
#include "runtime/types/conversion.h"
#include "runtime/types/dates.h"
#include "runtime/types/scalar_text.h"

#include <algorithm>

namespace plc::types {
namespace {

bool isTime(Family family) {
    return family == Family::Duration || family == Family::Date || family == Family::TimeOfDay ||
           family == Family::DateTime;
}
bool isUnsigned64(TypeKind kind) { return kind == TypeKind::Ulint || kind == TypeKind::Lword; }

/// From the last midnight, also before 1970.
int64_t sinceMidnight(int64_t nanoseconds) {
    const int64_t rest = nanoseconds % kDay;
    return rest < 0 ? rest + kDay : rest;
}

/// Any instant or duration as a value of `to`: dates begin their day, times of day stay within it.
int64_t fitTime(TypeKind to, int64_t nanoseconds) {
    const Family family = familyOf(to);
    if (family == Family::Date)
        return static_cast<int64_t>(
            static_cast<uint64_t>(nanoseconds) -
            static_cast<uint64_t>(sinceMidnight(nanoseconds))); // wraps on the first day there is
    if (family == Family::TimeOfDay) return sinceMidnight(nanoseconds);
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
        const auto nanoseconds =
            static_cast<int64_t>(static_cast<uint64_t>(number) * static_cast<uint64_t>(nanosecondsOf(to)));
        return {type, fitTime(to, nanoseconds)};
    }
    return {type, wrapInteger(to, number)};
}

Value fromReal(TypeId type, TypeKind to, double number) {
    const Family family = familyOf(to);
    if (family == Family::Real)
        return {type, to == TypeKind::Real ? static_cast<double>(static_cast<float>(number)) : number};
    if (isTime(family)) return {type, timeFromReal(to, number)};
    return {type, roundToInteger(to, number)};
}

Value fromTime(TypeId type, TypeKind to, TypeKind from, int64_t nanoseconds) {
    const Family family = familyOf(to);
    if (isTime(family)) return {type, fitTime(to, nanoseconds)};
    if (family == Family::Bool) return {type, int64_t(nanoseconds != 0)};
    const int64_t count = nanoseconds / nanosecondsOf(from);
    if (family == Family::Real) return {type, realOf(to, TypeKind::Lint, count)};
    return {type, wrapInteger(to, count)};
}

ScalarText textOf(TypeKind from, const Value& value) {
    if (const auto* real = std::get_if<double>(&value.data)) return realText(from, *real);
    return scalarText(from, value.integer());
}

/// One text type into the other, or a scalar's text into either, cut to the capacity.
Value toTextValue(const TypeTable& types, TypeId type, const Value& value, bool& ok) {
    const Type& target = types[types.storage(type)];
    std::u16string wide;
    if (const auto* text = std::get_if<std::string>(&value.data)) {
        if (target.kind == TypeKind::String) return {type, text->substr(0, target.capacity)};
        wide = wideOfString(types.strings, *text);
    } else if (const auto* text16 = std::get_if<std::u16string>(&value.data)) {
        wide = *text16;
    } else if (const TypeKind from = types.storageKind(value.type); familyOf(from) == Family::Character) {
        if (value.integer() != 0 && from == TypeKind::Char) {
            const auto byte = static_cast<char>(value.integer());
            if (target.kind == TypeKind::String) return {type, std::string(target.capacity > 0 ? 1 : 0, byte)};
            wide = wideOfString(types.strings, {&byte, 1});
        } else if (value.integer() != 0) {
            wide += static_cast<char16_t>(value.integer());
        }
    } else {
        const ScalarText text = textOf(from, value);
        for (const char c : text.view()) wide += static_cast<unsigned char>(c);
    }
    if (target.kind == TypeKind::Wstring) {
        if (wide.size() > target.capacity) {
            wide.resize(target.capacity);
            const bool isHalf = !wide.empty() && (wide.back() & 0xFC00) == 0xD800;
            if (isHalf && std::holds_alternative<std::string>(value.data)) wide.pop_back(); // as plc_text_to_wide_by
        }
        return {type, std::move(wide)};
    }
    return {type, stringOfWide(types.strings, wide, ok, target.capacity)};
}

Value fromText(TypeId type, TypeKind to, std::string_view text, bool& ok) {
    if (familyOf(to) == Family::Real) {
        const auto number = realFromText(to, text);
        ok = number.has_value();
        return {type, number.value_or(0.0)};
    }
    const auto number = integerFromText(to, text);
    ok = number.has_value();
    return {type, number.value_or(0)};
}

Value firstOfWide(TypeId type, std::u16string_view text, bool& ok) {
    if (text.empty()) ok = false;
    return {type, text.empty() ? int64_t{0} : static_cast<int64_t>(text.front())};
}

/// Texts and characters of both widths where STRING is not Latin-1, whose characters have the same numbers in both;
/// none: the conversion is not between them.
std::optional<Value> betweenWidths(StringCode code, TypeId type, TypeKind from, TypeKind to, const Value& value,
                                   bool& ok) {
    if (code == StringCode::Latin1) return std::nullopt;
    if (from == TypeKind::Char && to == TypeKind::Wchar)
        return Value{type, int64_t{wideOfCharacter(code, static_cast<unsigned char>(value.integer()))}};
    if (from == TypeKind::Wchar && to == TypeKind::Char) {
        const auto made = characterOfWide(code, static_cast<char16_t>(value.integer()));
        ok = made.has_value();
        return Value{type, int64_t{made.value_or('?')}};
    }
    if (from == TypeKind::String && to == TypeKind::Wchar)
        return firstOfWide(type, wideOfString(code, std::get<std::string>(value.data)), ok);
    if (from == TypeKind::Wstring && to == TypeKind::Char) {
        const std::string first = stringOfWide(code, std::get<std::u16string>(value.data), ok, 1);
        if (first.empty()) ok = false;
        return Value{type, first.empty() ? int64_t{0} : int64_t{static_cast<unsigned char>(first.front())}};
    }
    return std::nullopt;
}

Value fromWideText(TypeId type, TypeKind to, std::u16string_view text, bool& ok) {
    if (to == TypeKind::Wchar) return firstOfWide(type, text, ok);
    std::string narrow; // a character beyond Latin-1 ends the number, as any other letter does
    for (const char16_t c : text) narrow += c > 0xFF ? '?' : static_cast<char>(c);
    Value value = fromText(type, to, narrow, ok);
    if (to == TypeKind::Char && !text.empty() && text.front() > 0xFF) ok = false;
    return value;
}

} // namespace

int64_t nanosecondsOf(TypeKind kind) {
    switch (kind) {
    case TypeKind::Time:
    case TypeKind::Tod:
        return 1'000'000;
    case TypeKind::Date:
    case TypeKind::Dt:
        return kSecond;
    default:
        return 1;
    }
}

int64_t timeFromReal(TypeKind kind, double value) {
    const int64_t limit = INT64_MAX / nanosecondsOf(kind);
    const int64_t count = std::clamp(roundToInteger(TypeKind::Lint, value), -limit, limit);
    return fitTime(kind, count * nanosecondsOf(kind));
}

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
    if (auto made = betweenWidths(types.strings, to, source, target, value, good)) return finish(std::move(*made));
    if (const auto* text = std::get_if<std::string>(&value.data)) return finish(fromText(to, target, *text, good));
    if (const auto* wide = std::get_if<std::u16string>(&value.data))
        return finish(fromWideText(to, target, *wide, good));
    if (const auto* real = std::get_if<double>(&value.data)) return finish(fromReal(to, target, *real));
    if (isTime(familyOf(source))) return finish(fromTime(to, target, source, value.integer()));
    return finish(fromInteger(to, target, source, value.integer()));
}

} // namespace plc::types
