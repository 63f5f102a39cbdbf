#include "projects/tuning/model/series.h"

#include "projects/tuning/model/errors.h"
#include "projects/waveform/table.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

/// The rows above the first in which every column has a value: nobody knows what it was.
void dropUnknown(LoopSeries& series) {
    size_t first = 0;
    for (const std::vector<double>* column : {&series.input, &series.output, &series.setPoint})
        while (first < column->size() && std::isnan((*column)[first])) ++first;
    for (std::vector<double>* column : {&series.time, &series.input, &series.output, &series.setPoint})
        column->erase(column->begin(), column->begin() + static_cast<std::ptrdiff_t>(std::min(first, column->size())));
}

/// A date is no time to read a step at: from the first sample on.
void sinceStart(LoopSeries& series) {
    constexpr double kDate = 1e8; // seconds since 1970; no recording is as long
    if (series.time.empty() || series.time.front() < kDate) return;
    const double start = series.time.front();
    for (double& time : series.time) time -= start;
}

Result<LoopSeries> seriesOf(const waveform::Table& table, const CsvColumns& columns) {
    LoopSeries series;
    series.time = table.time;
    for (const auto& [name, target] :
         {std::pair{columns.input, &LoopSeries::input}, std::pair{columns.output, &LoopSeries::output},
          std::pair{columns.setPoint, &LoopSeries::setPoint}}) {
        if (name.empty()) continue;
        const auto column = waveform::columnOf(table, name);
        if (!column) return column.error();
        series.*target = table.columns[*column].value;
    }
    dropUnknown(series);
    sinceStart(series);
    if (auto checked = checkSeries(series); !checked) return checked.error();
    const auto [low, high] = std::minmax_element(series.input.begin(), series.input.end());
    if (*low < *high && series.input == series.output) return Error{errors::SameSamples(), ""};
    return series;
}

} // namespace

Result<LoopSeries> parseCsv(const std::string& text, const CsvColumns& columns) {
    const auto table = waveform::parseTable(text);
    if (!table) return table.error();
    return seriesOf(*table, columns);
}

Result<LoopSeries> readCsv(const std::string& path, const CsvColumns& columns, std::vector<Message>* notes) {
    const auto table = waveform::readTable(path);
    if (!table) return table.error();
    if (notes) *notes = table->notes;
    auto series = seriesOf(*table, columns);
    if (!series) return Error{series.error().message, path};
    return series;
}

Result<std::vector<std::string>> csvColumns(const std::string& path) {
    const auto table = waveform::readTable(path);
    if (!table) return table.error();
    return waveform::columnNames(*table);
}

Result<void> checkSeries(const LoopSeries& series) {
    constexpr size_t kLeast = 20;
    if (series.size() < kLeast) return Error{errors::TooFewSamples(series.size()), ""};
    return {};
}

double usualInterval(const LoopSeries& series) { return waveform::usualInterval(series.time); }

double meanOf(const std::vector<double>& values, size_t begin, size_t end) {
    if (begin >= end) return 0;
    double sum = 0;
    for (size_t i = begin; i < end; ++i) sum += values[i];
    return sum / static_cast<double>(end - begin);
}

} // namespace plc::tuning
