#include "projects/tuning/series.h"

#include "projects/tuning/errors.h"
#include "projects/waveform/table.h"

#include <cmath>

namespace plc::tuning {

namespace {

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
        for (double& value : series.*target) // those before the first one
            if (std::isnan(value)) value = 0;
    }
    if (auto checked = checkSeries(series); !checked) return checked.error();
    return series;
}

} // namespace

Result<LoopSeries> parseCsv(const std::string& text, const CsvColumns& columns) {
    const auto table = waveform::parseTable(text);
    if (!table) return table.error();
    return seriesOf(*table, columns);
}

Result<LoopSeries> readCsv(const std::string& path, const CsvColumns& columns) {
    const auto table = waveform::readTable(path);
    if (!table) return table.error();
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

} // namespace plc::tuning
