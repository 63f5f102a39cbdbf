#include "projects/tuning/series.h"

#include "projects/tuning/errors.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace plc::tuning {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

struct Table {
    char separator = ',';
    std::vector<std::string> names;
    size_t timeColumn = 0;
    double timeUnit = 1; // [s]
};

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// One line into cells; quotes as in RFC 4180. Returns where the next line begins.
size_t splitLine(const std::string& text, size_t at, char separator, std::vector<std::string>& cells) {
    cells.clear();
    std::string cell;
    bool isQuoted = false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (isQuoted) {
            if (c != '"')
                cell += c;
            else if (at + 1 < text.size() && text[at + 1] == '"')
                cell += text[++at];
            else
                isQuoted = false;
        } else if (c == '"') {
            isQuoted = true;
        } else if (c == separator) {
            cells.push_back(std::move(cell));
            cell.clear();
        } else if (c == '\n') {
            ++at;
            break;
        } else if (c != '\r') {
            cell += c;
        }
    }
    const size_t first = cell.find_first_not_of(' ');
    cells.push_back(first == std::string::npos ? std::string() : cell);
    return at;
}

double numberOf(std::string cell, char separator) {
    if (separator != ',') std::replace(cell.begin(), cell.end(), ',', '.');
    const size_t begin = cell.find_first_not_of(" +");
    if (begin == std::string::npos) return kNoNumber;
    const std::string word = lower(cell.substr(begin));
    if (word == "true") return 1;
    if (word == "false") return 0;
    double value = 0;
    const auto [end, problem] = std::from_chars(cell.data() + begin, cell.data() + cell.size(), value);
    if (problem != std::errc() || !std::isfinite(value)) return kNoNumber;
    return value;
}

/// The unit that a column of times is in; none: not a column of times.
std::optional<double> unitOfTime(const std::string& name) {
    std::string word = lower(name);
    std::erase_if(word, [](char c) { return c == ' ' || c == '_' || c == '[' || c == ']' || c == '(' || c == ')'; });
    for (const auto& [known, unit] : std::initializer_list<std::pair<const char*, double>>{{"times", 1.0},
                                                                                           {"time", 1.0},
                                                                                           {"t", 1.0},
                                                                                           {"ts", 1.0},
                                                                                           {"seconds", 1.0},
                                                                                           {"timestamp", 1.0},
                                                                                           {"timems", 1e-3},
                                                                                           {"tms", 1e-3},
                                                                                           {"timestampms", 1e-3},
                                                                                           {"milliseconds", 1e-3},
                                                                                           {"timeus", 1e-6},
                                                                                           {"tus", 1e-6},
                                                                                           {"timens", 1e-9},
                                                                                           {"tns", 1e-9}})
        if (word == known) return unit;
    return std::nullopt;
}

Result<Table> headOf(const std::string& text, size_t& next) {
    Table table;
    const std::string first = text.substr(0, text.find('\n'));
    const auto count = [&](char c) { return std::count(first.begin(), first.end(), c); };
    if (count('\t') > count(',') && count('\t') >= count(';'))
        table.separator = '\t';
    else if (count(';') > 0 && count(';') >= count(','))
        table.separator = ';';
    const size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    next = splitLine(text, begin, table.separator, table.names);
    for (std::string& name : table.names) {
        name.erase(0, name.find_first_not_of(' '));
        name.erase(name.find_last_not_of(' ') + 1);
    }
    for (size_t i = 0; i < table.names.size(); ++i)
        if (const auto unit = unitOfTime(table.names[i])) {
            table.timeColumn = i;
            table.timeUnit = *unit;
            return table;
        }
    return Error{errors::CsvHasNoTime(), ""};
}

Result<size_t> columnOf(const Table& table, const std::string& name) {
    std::vector<std::string> others;
    for (size_t i = 0; i < table.names.size(); ++i) {
        if (lower(table.names[i]) == lower(name)) return i;
        if (i != table.timeColumn) others.push_back(table.names[i]);
    }
    if (const auto near = nearestName(name, others)) return Error{errors::CsvNoColumnSuggest(name, *near), ""};
    return Error{errors::CsvNoColumn(name, others), ""};
}

Result<std::string> wholeFile(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return Error{errors::ofSystem(errno), path};
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

} // namespace

Result<LoopSeries> parseCsv(const std::string& text, const CsvColumns& columns) {
    size_t next = 0;
    const auto table = headOf(text, next);
    if (!table) return table.error();
    std::vector<std::pair<size_t, std::vector<double> LoopSeries::*>> wanted;
    for (const auto& [name, target] :
         {std::pair{columns.input, &LoopSeries::input}, std::pair{columns.output, &LoopSeries::output},
          std::pair{columns.setPoint, &LoopSeries::setPoint}}) {
        if (name.empty()) continue;
        const auto column = columnOf(*table, name);
        if (!column) return column.error();
        wanted.emplace_back(*column, target);
    }
    LoopSeries series;
    std::vector<std::string> cells;
    for (size_t line = 2; next < text.size(); ++line) {
        next = splitLine(text, next, table->separator, cells);
        if (cells.size() == 1 && cells[0].empty()) continue;
        const auto valueAt = [&](size_t column) {
            return column < cells.size() ? numberOf(cells[column], table->separator) : kNoNumber;
        };
        const double time = valueAt(table->timeColumn) * table->timeUnit;
        if (std::isnan(time)) return Error{errors::CsvNotANumber(line, table->names[table->timeColumn]), ""};
        if (!series.time.empty() && time < series.time.back()) return Error{errors::CsvTimeRunsBack(line), ""};
        if (!series.time.empty() && time == series.time.back()) continue; // written twice
        series.time.push_back(time);
        for (const auto& [column, target] : wanted) {
            std::vector<double>& values = series.*target;
            const double value = valueAt(column);
            // an empty cell: unchanged
            values.push_back(!std::isnan(value) ? value : values.empty() ? 0.0 : values.back());
        }
    }
    if (auto checked = checkSeries(series); !checked) return checked.error();
    return series;
}

Result<LoopSeries> readCsv(const std::string& path, const CsvColumns& columns) {
    const auto text = wholeFile(path);
    if (!text) return text.error();
    auto series = parseCsv(*text, columns);
    if (!series) return Error{series.error().message, path};
    return series;
}

Result<std::vector<std::string>> csvColumns(const std::string& path) {
    const auto text = wholeFile(path);
    if (!text) return text.error();
    size_t next = 0;
    const auto table = headOf(*text, next);
    if (!table) return Error{table.error().message, path};
    std::vector<std::string> names = table->names;
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(table->timeColumn));
    return names;
}

Result<void> checkSeries(const LoopSeries& series) {
    constexpr size_t kLeast = 20;
    if (series.size() < kLeast) return Error{errors::TooFewSamples(series.size()), ""};
    return {};
}

double usualInterval(const LoopSeries& series) {
    std::vector<double> steps;
    const size_t count = std::min<size_t>(series.size() - 1, 2000);
    for (size_t i = 0; i < count; ++i) steps.push_back(series.time[i + 1] - series.time[i]);
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(count / 2), steps.end());
    return steps[count / 2];
}

} // namespace plc::tuning
