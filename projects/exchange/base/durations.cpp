#include "projects/exchange/base/durations.h"

#include "projects/exchange/base/xml.h"
#include "runtime/base/text.h"

#include <charconv>
#include <cmath>

namespace plc::exchange {

namespace {

std::string durationOf(double nanoseconds) {
    if (!(nanoseconds >= 0) || nanoseconds > 9e18) return {};
    auto rest = static_cast<int64_t>(std::llround(nanoseconds));
    if (rest == 0) return "T#0ms";
    std::string out = "T#";
    struct Unit {
        int64_t size;
        const char* name;
    };
    static constexpr Unit units[] = {{3'600'000'000'000, "h"}, {60'000'000'000, "m"}, {1'000'000'000, "s"},
                                     {1'000'000, "ms"},        {1000, "us"},          {1, "ns"}};
    for (const Unit& unit : units)
        if (const int64_t count = rest / unit.size; count > 0) {
            out += std::to_string(count) + unit.name;
            rest %= unit.size;
        }
    return out;
}

double scaleOf(std::string_view unit) {
    struct Row {
        std::string_view name;
        double nanoseconds;
    };
    static constexpr Row rows[] = {{"ns", 1},   {"us", 1e3}, {"\xC2\xB5s", 1e3}, {"µs", 1e3},
                                   {"ms", 1e6}, {"s", 1e9},  {"m", 60e9},        {"h", 3600e9}};
    for (const Row& row : rows)
        if (equalsIgnoringCase(row.name, unit)) return row.nanoseconds;
    return 0;
}

/// PT1H2M0.05S
std::string isoDuration(std::string_view text) {
    double total = 0;
    bool isTime = false;
    for (size_t at = 1; at < text.size();) {
        if (text[at] == 'T') {
            isTime = true;
            ++at;
            continue;
        }
        double value = 0;
        const auto [end, problem] = std::from_chars(text.data() + at, text.data() + text.size(), value);
        if (problem != std::errc() || end == text.data() + text.size()) return {};
        at = static_cast<size_t>(end - text.data());
        switch (text[at++]) {
        case 'D':
            total += value * 86400e9;
            break;
        case 'H':
            total += value * 3600e9;
            break;
        case 'M':
            if (!isTime) return {};
            total += value * 60e9;
            break;
        case 'S':
            total += value * 1e9;
            break;
        default:
            return {};
        }
    }
    return durationOf(total);
}

} // namespace

std::string durationText(std::string_view text, std::string_view unit) {
    const std::string value = trimmed(text);
    if (value.empty()) return {};
    if (value[0] == 'P') return isoDuration(value);
    if (const size_t hash = value.find('#'); hash != std::string::npos) {
        std::string literal = "T#" + value.substr(hash + 1);
        return literal;
    }
    double number = 0;
    const auto [end, problem] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (problem != std::errc()) return {};
    const std::string rest(end, value.data() + value.size());
    const double scale =
        scaleOf(rest.empty() ? (unit.empty() ? std::string_view("ms") : unit) : std::string_view(rest));
    return scale > 0 ? durationOf(number * scale) : std::string();
}

} // namespace plc::exchange
