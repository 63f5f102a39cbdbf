// What was recorded of a loop: output and input of the process, its set point, over time; read from a CSV file or
// filled from a recording. Values and functions, any thread.
#pragma once
#include "runtime/base/result.h"

#include <optional>
#include <string>
#include <vector>

namespace plc::tuning {

/// Same instants for all; a column that is not there is empty.
struct LoopSeries {
    std::vector<double> time;        // [s], rising
    std::vector<double> input;       // manipulated value: what the controller puts out
    std::vector<double> output;      // measured value
    std::vector<double> setPoint;    // optional
    std::optional<double> low, high; // of the input, where the controller's limits are known
    [[nodiscard]] size_t size() const { return time.size(); }
};

struct CsvColumns {
    std::string input, output, setPoint; // names in the head line; the set point's may be empty
};

/// Columns of a table as projects/waveform/table.h reads it.
[[nodiscard]] Result<LoopSeries> parseCsv(const std::string& text, const CsvColumns& columns);
/// `notes` receives what was not as it should be in the table.
[[nodiscard]] Result<LoopSeries> readCsv(const std::string& path, const CsvColumns& columns,
                                         std::vector<Message>* notes = nullptr);
/// The names of the columns, the time's left out.
[[nodiscard]] Result<std::vector<std::string>> csvColumns(const std::string& path);

/// The instants at which something happens at all; what comes from a table may be uneven or run backwards, which is an
/// error.
[[nodiscard]] Result<void> checkSeries(const LoopSeries& series);
/// The usual distance of two samples.
[[nodiscard]] double usualInterval(const LoopSeries& series);
/// Of the samples from `begin` up to `end`; 0 where there are none.
[[nodiscard]] double meanOf(const std::vector<double>& values, size_t begin, size_t end);

} // namespace plc::tuning
