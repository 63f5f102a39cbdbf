// The times in a column of a table, as other tools write them: seconds, dates with times of day in the order of several
// countries, time zones, days of a spreadsheet. Values and functions, any thread.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace plc::waveform {

/// The unit that a column of times is in [s], from its heading; none: not a column of times.
[[nodiscard]] std::optional<double> unitOfTime(const std::string& heading);
/// A heading that speaks of the day: the time of day may be in the column beside it.
[[nodiscard]] bool isDateHeading(const std::string& heading);
[[nodiscard]] bool isTimeOfDayHeading(const std::string& heading);

/// Reads the cells of one column, in the order of the table.
class TimeStamps {
public:
    /// `unit`: of plain numbers [s]. `first`: the first cells, which say what the numbers are, and whether the month or
    /// the day is first in 3/4/2026.
    TimeStamps(double unit, bool isDate, const std::vector<std::string>& first);
    /// In seconds, since 1970 for a date; not a number: no time. After midnight, times without a date go on.
    [[nodiscard]] double next(const std::string& cell);

private:
    double m_unit = 1;
    bool m_isDayFirst = false;
    double m_midnight = 0, m_last = 0; // of times of day [s]
};

} // namespace plc::waveform
