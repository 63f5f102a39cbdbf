#include "projects/waveform/time_stamps.h"

#include "projects/waveform/table_parts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

namespace plc::waveform {

namespace {

constexpr double kDay = 86400;

/// Only what tells headings apart: letters and digits, small.
std::string wordOf(const std::string& heading) {
    std::string word = lowered(heading);
    for (const std::string_view micro : {"\xC2\xB5", "\xCE\xBC"}) // the sign, and the Greek letter
        if (const size_t at = word.find(micro); at != std::string::npos) word.replace(at, micro.size(), "u");
    if (word.find("\xE6\x97\xB6\xE9\x97\xB4") != std::string::npos) return "time"; // Chinese
    std::erase_if(word, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
    // "0.Timestamp": the time of the first channel
    word.erase(0, word.find_first_not_of("0123456789"));
    return word;
}

/// "12:30", "12:30:05.250", "12:30:05 PM" in seconds.
double timeOfDay(std::string text) {
    text = lowered(trimmed(text));
    const bool isMorning = text.ends_with("am"), isEvening = text.ends_with("pm");
    if (isMorning || isEvening) text = trimmed(text.substr(0, text.size() - 2));
    int hour = 0, minute = 0, used = 0;
    if (std::sscanf(text.c_str(), "%2d:%2d%n", &hour, &minute, &used) != 2 || hour < 0 || minute < 0) return kNoNumber;
    const std::string rest = text.substr(static_cast<size_t>(used));
    double seconds = 0;
    if (!rest.empty()) {
        if (rest[0] != ':' || rest.size() < 2 || !std::isdigit(static_cast<unsigned char>(rest[1]))) return kNoNumber;
        seconds = numberOf(rest.substr(1));
    }
    if (isMorning || isEvening) hour = hour % 12 + (isEvening ? 12 : 0);
    if (hour > 24 || minute > 59 || std::isnan(seconds) || seconds >= 61) return kNoNumber;
    return hour * 3600 + minute * 60 + seconds;
}

/// The zone behind a time of day, "Z" or "+02:00", which is cut off: what local time is ahead by [s].
double takeZone(std::string& time) {
    if (time.ends_with('Z') || time.ends_with('z')) {
        time.pop_back();
        return 0;
    }
    const size_t at = time.find_first_of("+-");
    int hours = 0, minutes = 0;
    if (at == std::string::npos || std::sscanf(time.c_str() + at + 1, "%2d:%2d", &hours, &minutes) < 1) return 0;
    if (hours > 99 || time.size() == at + 5) std::sscanf(time.c_str() + at + 1, "%2d%2d", &hours, &minutes);
    const double ahead = hours * 3600 + minutes * 60;
    const bool isAhead = time[at] == '+';
    time.erase(at);
    return isAhead ? ahead : -ahead;
}

struct Parts {
    std::array<int, 3> numbers{};
    char mark = 0;
    std::string time;
};

/// "2026-03-01 06:00:00", "1.3.2026 06:00", "3/1/2026 6:00 AM"; the day alone is at midnight.
std::optional<Parts> partsOf(const std::string& cell) {
    const std::string text = trimmed(cell);
    Parts out;
    char first = 0, second = 0;
    int used = 0;
    auto& [a, b, c] = out.numbers;
    if (std::sscanf(text.c_str(), "%4d%c%2d%c%4d%n", &a, &first, &b, &second, &c, &used) != 5) return std::nullopt;
    if (first != second || std::string_view("-./").find(first) == std::string_view::npos) return std::nullopt;
    out.mark = first;
    out.time = text.substr(static_cast<size_t>(used));
    if (!out.time.empty() && std::string_view(" T,").find(out.time[0]) == std::string_view::npos) return std::nullopt;
    out.time = trimmed(out.time.empty() ? "" : out.time.substr(1));
    return out;
}

double secondsOf(Parts parts, bool isDayFirst) {
    auto [year, month, day] = parts.numbers;
    constexpr int kYears = 1000; // four digits are a year
    if (year < kYears) {
        std::swap(year, day); // day, month, year
        if (parts.mark == '/' && !isDayFirst) std::swap(month, day);
        constexpr int kShort = 100, kCentury = 2000;
        if (year < kShort) year += kCentury;
    }
    if (month < 1 || day < 1) return kNoNumber;
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok()) return kNoNumber;
    const auto days = static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
    const double ahead = takeZone(parts.time);
    return days * kDay + (parts.time.empty() ? 0 : timeOfDay(parts.time)) - ahead;
}

/// Seconds would be thousands of years: smaller units. Days of a spreadsheet are a matter of the heading.
double unitOfNumbers(double unit, bool isDate, double first) {
    constexpr double kLeastDay = 20'000, kMostDay = 80'000; // 1954 to 2119
    if (isDate && first > kLeastDay && first < kMostDay) return kDay;
    constexpr double kMilli = 1e11, kMicro = 1e14, kNano = 1e17;
    if (unit == 1 && first > kNano) return 1e-9;
    if (unit == 1 && first > kMicro) return 1e-6;
    return unit == 1 && first > kMilli ? 1e-3 : unit;
}

const std::set<std::string> kDates = {"date", "datum", "dato", "fecha", "day", "datetime", "datumuhrzeit", "datumzeit"};

} // namespace

std::optional<double> unitOfTime(const std::string& heading) {
    static const std::map<std::string, double> kEnds = {{"", 1},      {"s", 1},       {"sec", 1},   {"seconds", 1},
                                                        {"ms", 1e-3}, {"msec", 1e-3}, {"us", 1e-6}, {"ns", 1e-9},
                                                        {"min", 60},  {"h", 3600},    {"utc", 1},   {"local", 1}};
    static const std::set<std::string> kWords = {
        "time",        "t",          "ts",           "timestamp",   "timestring", "elapsedtime",  "relativetime",
        "datetime",    "date",       "dateandtime",  "datetimes",   "epoch",      "unixtime",     "utc",
        "localtime",   "zeit",       "datum",        "datumzeit",   "uhrzeit",    "datumuhrzeit", "datumunduhrzeit",
        "zeitstempel", "horodatage", "temps",        "heure",       "dateheure",  "dateetheure",  "tid",
        "tidspunkt",   "dato",       "datotid",      "tidsstempel", "tiempo",     "hora",         "fecha",
        "fechahora",   "fechayhora", "marcadetiempo"};
    const std::string word = wordOf(heading);
    if (word == "cycle" || word == "ms" || word == "milliseconds") return 1e-3;
    if (word == "seconds" || word == "sec") return 1;
    for (const auto& [end, unit] : kEnds)
        if (word.ends_with(end) && kWords.contains(word.substr(0, word.size() - end.size()))) return unit;
    return std::nullopt;
}

bool isDateHeading(const std::string& heading) { return kDates.contains(wordOf(heading)); }

bool isTimeOfDayHeading(const std::string& heading) {
    static const std::set<std::string> kTimes = {"time", "uhrzeit", "zeit",      "heure",
                                                 "hora", "tid",     "klokkeslt", "timeofday"};
    return kTimes.contains(wordOf(heading));
}

TimeStamps::TimeStamps(double unit, bool isDate, const std::vector<std::string>& first) : m_unit(unit) {
    if (first.empty()) return;
    if (const double number = numberOf(first[0]); !std::isnan(number)) m_unit = unitOfNumbers(unit, isDate, number);
    // the number that runs through more values within the table, or that no month can have, is the day
    bool isMonthFirst = false;
    int before[2] = {0, 0};
    size_t changes[2] = {0, 0};
    for (const std::string& cell : first) {
        const auto parts = partsOf(cell);
        if (!parts) continue;
        m_isDayFirst = m_isDayFirst || parts->numbers[0] > 12;
        isMonthFirst = isMonthFirst || parts->numbers[1] > 12;
        for (size_t i = 0; i < 2; ++i) {
            changes[i] += before[i] != 0 && parts->numbers[i] != before[i];
            before[i] = parts->numbers[i];
        }
    }
    if (!isMonthFirst && changes[0] > changes[1]) m_isDayFirst = true;
}

double TimeStamps::next(const std::string& cell) {
    if (const auto parts = partsOf(cell)) return secondsOf(*parts, m_isDayFirst);
    if (cell.find(':') == std::string::npos) return numberOf(cell) * m_unit;
    const double time = timeOfDay(cell);
    if (time < m_last - kDay / 2) m_midnight += kDay;
    m_last = time;
    return m_midnight + time;
}

} // namespace plc::waveform
