// What the readers of tables share: cells, numbers, and columns that have their own times each. Functions, any thread.
#pragma once
#include "projects/waveform/samples.h"
#include "projects/waveform/table.h"

#include <limits>
#include <optional>

namespace plc::waveform {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Without blanks around it.
[[nodiscard]] std::string trimmed(const std::string& text);
[[nodiscard]] std::string lowered(std::string text);
/// TRUE is 1; the decimal mark may be a comma. Not a number: none.
[[nodiscard]] double numberOf(std::string cell);
/// One line into cells; quotes as in RFC 4180. Returns where the next line starts.
size_t splitLine(const std::string& text, size_t at, char separator, std::vector<std::string>& cells);
/// The line with the headings, and where the rows below it start.
struct TableHead {
    char separator = ',';
    std::vector<std::string> cells;
    std::vector<std::optional<double>> unitOf; // of the columns of times
    std::vector<std::string> units;            // where a row below the headings has them
    std::optional<size_t> dateCell;            // the day, where the time of day is in the next column
    size_t next = 0, line = 1;                 // where the first row starts, and its line
};
/// Several columns of times: each column of values follows its own; they meet on all instants there are.
[[nodiscard]] Table merged(const std::vector<Samples>& pairs, std::vector<Column> columns);

/// A column with times of its own, sample by sample.
class OwnTimes {
public:
    explicit OwnTimes(std::string name);
    /// False: the time is before that of the sample above. A cell without a number is left out, and so is a time that
    /// was written twice.
    bool add(double time, const std::string& cell);
    [[nodiscard]] bool isEmpty() const { return m_samples.size() == 0; }
    [[nodiscard]] const Samples& samples() const { return m_samples; }
    [[nodiscard]] Column column() const;

private:
    std::string m_name;
    Samples m_samples;
    bool m_onlyBool = true;
};
/// The columns that have a number, on all their instants.
[[nodiscard]] Result<Table> tableOf(const std::vector<OwnTimes>& columns);

} // namespace plc::waveform
