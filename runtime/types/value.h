// A value of any type outside the image: constants of the compiler, what a watch or CSV shows, what a write brings.
// Plain data, any thread.
#pragma once
#include "runtime/base/result.h"
#include "runtime/types/type_table.h"

#include <span>
#include <variant>

namespace plc::types {

struct Value {
    TypeId type; // none: no value
    /// Integers, BOOL, enums, durations and dates: int64 (the bit pattern for ULINT/LWORD); REAL/LREAL: double (a REAL
    /// holds a value exact in single precision); STRING: its bytes; WSTRING: UTF-16; aggregates: elements or fields
    /// in order; references, pointers: int64 image offset.
    std::variant<std::monostate, int64_t, double, std::string, std::u16string, std::vector<Value>> data;

    [[nodiscard]] bool hasValue() const { return data.index() != 0; }
    [[nodiscard]] int64_t integer() const { return std::get<int64_t>(data); }
    [[nodiscard]] bool isTrue() const { return std::holds_alternative<int64_t>(data) && integer() != 0; }
    [[nodiscard]] double real() const { return std::get<double>(data); }
    bool operator==(const Value&) const = default;
};

/// Reads `type` at the begin of `bytes` (which must hold its size). `bit` ≥ 0 reads that bit as BOOL.
[[nodiscard]] Value readValue(const TypeTable& types, TypeId type, std::span<const std::byte> bytes, int bit = -1);
/// Writes `value` (of `type`, or an aggregate's shape) at the begin of `bytes`; text is cut to the capacity.
void writeValue(const TypeTable& types, TypeId type, const Value& value, std::span<std::byte> bytes, int bit = -1);

/// How numbers are shown.
/// Time: integers as a duration in milliseconds.
enum class NumberFormat { Decimal, Hex, Binary, Time };
/// As the command line and CSV show it: TRUE, 5, 1.5, T#1s500ms, Red, 'text', [1, 2], (a := 1, b := 2), NULL.
[[nodiscard]] std::string toText(const TypeTable& types, const Value& value,
                                 NumberFormat format = NumberFormat::Decimal);
/// As in the JSON of `run`: JSON's own booleans, numbers, strings; times and enums as strings; NaN, ±INF, integers
/// beyond ±2^53 as strings.
[[nodiscard]] std::string toJson(const TypeTable& types, const Value& value);
/// T#1d2h3m4s5ms6us7ns without zero units; T#0ms → "T#0s".
[[nodiscard]] std::string durationText(int64_t nanoseconds, bool isLong = false);
[[nodiscard]] std::string dateText(int64_t nanoseconds, bool isLong = false);      // D#1996-03-15
[[nodiscard]] std::string timeOfDayText(int64_t nanoseconds, bool isLong = false); // TOD#01:10:03.300
[[nodiscard]] std::string dateTimeText(int64_t nanoseconds, bool isLong = false);  // DT#…-01:10:03
/// Civil date ⇄ days since 1970-01-01 (proleptic Gregorian).
struct CivilDate {
    int year;
    int month;
    int day;
};
[[nodiscard]] int64_t daysFromCivil(CivilDate date);
[[nodiscard]] CivilDate civilFromDays(int64_t days);
[[nodiscard]] bool isValidDate(CivilDate date);

// Reading what the functions above write, and every spelling of IEC 61131-3 tables 8 and 9. The prefix (T#, TIME#, LT#,
// D#, TOD#, …) may be missing or be any of its forms, in either case; `_` may stand between digits. None: not of that
// form or too large.
[[nodiscard]] std::optional<int64_t> parseDuration(std::string_view text);  // T#1d2h3m4.5s, -T#5s, T#-5s; nanoseconds
[[nodiscard]] std::optional<int64_t> parseDate(std::string_view text);      // D#1996-3-15
[[nodiscard]] std::optional<int64_t> parseTimeOfDay(std::string_view text); // TOD#1:10:3.3
[[nodiscard]] std::optional<int64_t> parseDateTime(std::string_view text);  // DT#1996-3-15-1:10:3.3
/// A value of `type` from what `toText` shows or a person types: TRUE, 1, 16#FF, INT#5, 1.5, T#5s, Red, Color.Red,
/// Color#Red, 'text', [1, 2, 3(0)], (a := 1, b := 2), NULL. UTF-8. None when it does not read as that type or does not
/// fit.
[[nodiscard]] std::optional<Value> parseValue(const TypeTable& types, TypeId type, std::string_view text);
/// The value of a variable that nobody set: the type's own initial value.
[[nodiscard]] Value initialValue(const TypeTable& types, TypeId type);

} // namespace plc::types
