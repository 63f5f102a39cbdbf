#include "runtime/types/dates.h"

#include "runtime/base/chars.h"
#include "runtime/types/value.h"

#include <array>

namespace plc::types {
namespace {

struct Unit {
    std::string_view name;
    int64_t nanoseconds;
};
constexpr std::array<Unit, 7> kUnits{{{"d", kDay},
                                      {"h", 3600 * kSecond},
                                      {"m", 60 * kSecond},
                                      {"s", kSecond},
                                      {"ms", 1'000'000},
                                      {"us", 1'000},
                                      {"ns", 1}}};

/// Nanoseconds since midnight. The day's begin itself need not be a number of 64 bits: the oldest one is not.
int64_t clockOf(int64_t nanoseconds) { return (nanoseconds % kDay + kDay) % kDay; }

int64_t floorDivide(int64_t a, int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Takes one of `prefixes` and the `#` behind it off the begin. False: there is another prefix.
bool takePrefix(std::string_view& text, std::initializer_list<std::string_view> prefixes) {
    const size_t hash = text.find('#');
    if (hash == std::string_view::npos) return true;
    for (const std::string_view prefix : prefixes) {
        if (hash != prefix.size()) continue;
        bool isSame = true;
        for (size_t i = 0; i < hash; ++i) isSame = isSame && asciiLower(text[i]) == prefix[i];
        if (!isSame) continue;
        text.remove_prefix(hash + 1);
        return true;
    }
    return false;
}

/// Digits with `_` between them; none when there are none or more than 18 digits.
std::optional<int64_t> takeNumber(std::string_view& text, size_t* digits = nullptr) {
    int64_t value = 0;
    size_t count = 0, i = 0;
    for (; i < text.size() &&
           (isDigit(text[i]) || (text[i] == '_' && count > 0 && i + 1 < text.size() && isDigit(text[i + 1])));
         ++i) {
        if (text[i] == '_') continue;
        if (++count > 18) return std::nullopt;
        value = value * 10 + (text[i] - '0');
    }
    if (count == 0) return std::nullopt;
    text.remove_prefix(i);
    if (digits) *digits = count;
    return value;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

/// ".3" → 300,000,000; digits beyond the ninth are cut. Nothing there → 0.
std::optional<int64_t> takeFraction(std::string_view& text) {
    if (!take(text, '.')) return 0;
    int64_t value = 0;
    size_t count = 0, i = 0;
    for (; i < text.size() && (isDigit(text[i]) || (text[i] == '_' && count > 0)); ++i) {
        if (text[i] == '_') continue;
        if (++count <= 9) value = value * 10 + (text[i] - '0');
    }
    if (count == 0) return std::nullopt;
    for (size_t k = count; k < 9; ++k) value *= 10;
    text.remove_prefix(i);
    return value;
}

std::optional<CivilDate> takeDate(std::string_view& text) {
    const auto year = takeNumber(text);
    if (!year || !take(text, '-')) return std::nullopt;
    const auto month = takeNumber(text);
    if (!month || !take(text, '-')) return std::nullopt;
    const auto day = takeNumber(text);
    if (!day || *year > 2261 || *month > 12 || *day > 31) return std::nullopt;
    const CivilDate date{static_cast<int>(*year), static_cast<int>(*month), static_cast<int>(*day)};
    if (!isValidDate(date)) return std::nullopt;
    return date;
}

std::optional<int64_t> takeTimeOfDay(std::string_view& text) {
    const auto hour = takeNumber(text);
    if (!hour || !take(text, ':')) return std::nullopt;
    const auto minute = takeNumber(text);
    if (!minute) return std::nullopt;
    int64_t second = 0, fraction = 0;
    if (take(text, ':')) {
        const auto whole = takeNumber(text);
        if (!whole) return std::nullopt;
        const auto part = takeFraction(text);
        if (!part) return std::nullopt;
        second = *whole;
        fraction = *part;
    }
    if (*hour > 23 || *minute > 59 || second > 59) return std::nullopt;
    return ((*hour * 60 + *minute) * 60 + second) * kSecond + fraction;
}

void appendClock(ScalarText& out, int64_t nanoseconds) {
    const int64_t seconds = nanoseconds / kSecond, fraction = nanoseconds % kSecond;
    out.append(seconds / 3600, 2);
    out.append(":");
    out.append(seconds / 60 % 60, 2);
    out.append(":");
    out.append(seconds % 60, 2);
    if (fraction == 0) return;
    out.append(".");
    if (fraction % 1'000'000 == 0)
        out.append(fraction / 1'000'000, 3);
    else if (fraction % 1'000 == 0)
        out.append(fraction / 1'000, 6);
    else
        out.append(fraction, 9);
}

void appendCivil(ScalarText& out, int64_t days) {
    const CivilDate date = civilFromDays(days);
    out.append(date.year, 4);
    out.append("-");
    out.append(date.month, 2);
    out.append("-");
    out.append(date.day, 2);
}

template <class Append> std::string toString(Append append) {
    ScalarText text;
    append(text);
    return std::string(text.view());
}

} // namespace

// Days are counted in eras of 400 years that begin on 1 March, so that the leap day is the last of its year.
int64_t daysFromCivil(CivilDate date) {
    const int64_t year = date.month <= 2 ? date.year - 1 : date.year;
    const int64_t era = floorDivide(year, 400);
    const int64_t yearOfEra = year - era * 400;
    const int64_t dayOfYear = (153 * ((date.month + 9) % 12) + 2) / 5 + date.day - 1;
    return era * 146'097 + yearOfEra * 365 + yearOfEra / 4 - yearOfEra / 100 + dayOfYear - 719'468;
}

CivilDate civilFromDays(int64_t days) {
    const int64_t shifted = days + 719'468;
    const int64_t era = floorDivide(shifted, 146'097);
    const int64_t dayOfEra = shifted - era * 146'097;
    const int64_t yearOfEra = (dayOfEra - dayOfEra / 1'460 + dayOfEra / 36'524 - dayOfEra / 146'096) / 365;
    const int64_t dayOfYear = dayOfEra - (365 * yearOfEra + yearOfEra / 4 - yearOfEra / 100);
    const int64_t monthFromMarch = (5 * dayOfYear + 2) / 153;
    const int month = static_cast<int>(monthFromMarch < 10 ? monthFromMarch + 3 : monthFromMarch - 9);
    const int64_t year = yearOfEra + era * 400 + (month <= 2 ? 1 : 0);
    return {static_cast<int>(year), month, static_cast<int>(dayOfYear - (153 * monthFromMarch + 2) / 5 + 1)};
}

bool isValidDate(CivilDate date) {
    if (date.month < 1 || date.month > 12 || date.day < 1) return false;
    const CivilDate back = civilFromDays(daysFromCivil(date));
    return back.year == date.year && back.month == date.month && back.day == date.day;
}

void appendDuration(ScalarText& out, int64_t nanoseconds, bool isLong) {
    out.append(isLong ? "LTIME#" : "T#");
    if (nanoseconds == 0) return out.append("0s");
    if (nanoseconds < 0) out.append("-");
    uint64_t rest = nanoseconds < 0 ? 0 - static_cast<uint64_t>(nanoseconds) : static_cast<uint64_t>(nanoseconds);
    for (const Unit& unit : kUnits) {
        const uint64_t count = rest / static_cast<uint64_t>(unit.nanoseconds);
        rest %= static_cast<uint64_t>(unit.nanoseconds);
        if (count == 0) continue;
        out.append(static_cast<int64_t>(count));
        out.append(unit.name);
    }
}

void appendDate(ScalarText& out, int64_t nanoseconds, bool isLong) {
    out.append(isLong ? "LDATE#" : "D#");
    appendCivil(out, floorDivide(nanoseconds, kDay));
}

void appendTimeOfDay(ScalarText& out, int64_t nanoseconds, bool isLong) {
    out.append(isLong ? "LTOD#" : "TOD#");
    appendClock(out, clockOf(nanoseconds));
}

void appendDateTime(ScalarText& out, int64_t nanoseconds, bool isLong) {
    out.append(isLong ? "LDT#" : "DT#");
    appendCivil(out, floorDivide(nanoseconds, kDay));
    out.append("-");
    appendClock(out, clockOf(nanoseconds));
}

std::string durationText(int64_t nanoseconds, bool isLong) {
    return toString([&](ScalarText& out) { appendDuration(out, nanoseconds, isLong); });
}
std::string dateText(int64_t nanoseconds, bool isLong) {
    return toString([&](ScalarText& out) { appendDate(out, nanoseconds, isLong); });
}
std::string timeOfDayText(int64_t nanoseconds, bool isLong) {
    return toString([&](ScalarText& out) { appendTimeOfDay(out, nanoseconds, isLong); });
}
std::string dateTimeText(int64_t nanoseconds, bool isLong) {
    return toString([&](ScalarText& out) { appendDateTime(out, nanoseconds, isLong); });
}

std::optional<int64_t> parseDuration(std::string_view text) {
    text = withoutBlanks(text);
    bool isNegative = take(text, '-');
    if (!takePrefix(text, {"t", "time", "lt", "ltime"})) return std::nullopt;
    if (take(text, '-'))
        isNegative = !isNegative;
    else
        take(text, '+');
    __int128 sum = 0;
    size_t nextUnit = 0;
    bool hadFraction = false;
    if (text.empty()) return std::nullopt;
    while (!text.empty()) {
        if (hadFraction) return std::nullopt; // only the last part may have a fraction
        const auto whole = takeNumber(text);
        if (!whole) return std::nullopt;
        int64_t fraction = 0;
        if (!text.empty() && text.front() == '.') {
            const auto part = takeFraction(text);
            if (!part) return std::nullopt;
            fraction = *part;
            hadFraction = true;
        }
        // The longest unit that fits: "ms" before "m", unless "m" is followed by a digit.
        size_t found = kUnits.size();
        for (size_t i = nextUnit; i < kUnits.size(); ++i) {
            const std::string_view name = kUnits[i].name;
            if (text.size() < name.size()) continue;
            bool isSame = true;
            for (size_t k = 0; k < name.size(); ++k) isSame = isSame && asciiLower(text[k]) == name[k];
            if (!isSame) continue;
            if (found == kUnits.size() || name.size() > kUnits[found].name.size()) found = i;
        }
        if (found == kUnits.size()) return std::nullopt;
        text.remove_prefix(kUnits[found].name.size());
        while (!text.empty() && text.front() == '_') text.remove_prefix(1);
        sum += static_cast<__int128>(*whole) * kUnits[found].nanoseconds +
               static_cast<__int128>(fraction) * kUnits[found].nanoseconds / kSecond;
        nextUnit = found + 1;
        if (sum > static_cast<__int128>(INT64_MAX)) return std::nullopt;
    }
    return isNegative ? -static_cast<int64_t>(sum) : static_cast<int64_t>(sum);
}

/// None when the moment is no number of 64 bits: before 1677-09-21 or after 2262-04-11.
static std::optional<int64_t> momentOf(CivilDate date, int64_t time) {
    const __int128 moment = static_cast<__int128>(daysFromCivil(date)) * kDay + time;
    if (moment < INT64_MIN || moment > INT64_MAX) return std::nullopt;
    return static_cast<int64_t>(moment);
}

std::optional<int64_t> parseDate(std::string_view text) {
    text = withoutBlanks(text);
    if (!takePrefix(text, {"d", "date", "ld", "ldate"})) return std::nullopt;
    const auto date = takeDate(text);
    if (!date || !text.empty()) return std::nullopt;
    return momentOf(*date, 0);
}

std::optional<int64_t> parseTimeOfDay(std::string_view text) {
    text = withoutBlanks(text);
    if (!takePrefix(text, {"tod", "time_of_day", "ltod", "ltime_of_day"})) return std::nullopt;
    const auto time = takeTimeOfDay(text);
    return time && text.empty() ? time : std::nullopt;
}

std::optional<int64_t> parseDateTime(std::string_view text) {
    text = withoutBlanks(text);
    if (!takePrefix(text, {"dt", "date_and_time", "ldt", "ldate_and_time"})) return std::nullopt;
    const auto date = takeDate(text);
    if (!date || !take(text, '-')) return std::nullopt;
    const auto time = takeTimeOfDay(text);
    if (!time || !text.empty()) return std::nullopt;
    return momentOf(*date, *time);
}

} // namespace plc::types
