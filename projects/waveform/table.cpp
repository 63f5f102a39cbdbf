#include "projects/waveform/table.h"

#include "projects/waveform/errors.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

namespace plc::waveform {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string withoutBlanks(const std::string& text) {
    const size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// One line into cells; quotes as in RFC 4180. Returns where the next line starts.
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
            if (separator != ' ' || !cell.empty()) cells.push_back(std::move(cell));
            cell.clear();
        } else if (c == '\n') {
            ++at;
            break;
        } else if (c != '\r') {
            cell += c;
        }
    }
    if (separator != ' ' || !cell.empty()) cells.push_back(withoutBlanks(cell));
    return at;
}

double numberOf(std::string cell, char separator) {
    if (separator != ',') std::replace(cell.begin(), cell.end(), ',', '.');
    const size_t begin = cell.find_first_not_of(" +");
    if (begin == std::string::npos) return kNoNumber;
    const std::string word = lower(withoutBlanks(cell));
    if (word == "true") return 1;
    if (word == "false") return 0;
    double value = 0;
    const auto [end, problem] = std::from_chars(cell.data() + begin, cell.data() + cell.size(), value);
    if (problem != std::errc() || !std::isfinite(value)) return kNoNumber;
    return value;
}

/// "2026-03-01 06:00:00.250" or with a T, in seconds since 1970.
double dateOf(const std::string& cell) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, used = 0;
    if (std::sscanf(cell.c_str(), " %d-%d-%d%*[ T]%d:%d:%n", &year, &month, &day, &hour, &minute, &used) != 5 || !used)
        return kNoNumber;
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    const double seconds = numberOf(cell.substr(static_cast<size_t>(used)), ';');
    if (!date.ok() || std::isnan(seconds)) return kNoNumber;
    const auto days = std::chrono::sys_days(date).time_since_epoch().count();
    return static_cast<double>(days) * 86400 + hour * 3600 + minute * 60 + seconds;
}

/// "Level [m]" without its unit, which goes to `unit`.
std::string nameOf(const std::string& cell, std::string& unit) {
    const std::string text = withoutBlanks(cell);
    const size_t open = text.rfind('[');
    if (open == std::string::npos || open == 0 || text.back() != ']' || text[open - 1] != ' ') return text;
    unit = text.substr(open + 1, text.size() - open - 2);
    return withoutBlanks(text.substr(0, open));
}

/// The unit that a column of times is in [s]; none: not a column of times.
std::optional<double> unitOfTime(const std::string& name) {
    static const std::map<std::string, double> kKnown = {
        {"times", 1},      {"time", 1},           {"t", 1},
        {"ts", 1},         {"seconds", 1},        {"timestamp", 1},
        {"timems", 1e-3},  {"tms", 1e-3},         {"cycle", 1e-3},
        {"timestamps", 1}, {"timestampms", 1e-3}, {"milliseconds", 1e-3},
        {"timeus", 1e-6},  {"tus", 1e-6},         {"timestampus", 1e-6},
        {"timens", 1e-9},  {"tns", 1e-9},         {"timestampns", 1e-9},
        {"date", 1},       {"datetime", 1}};
    std::string word = lower(name);
    std::erase_if(word, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
    // "0.Timestamp": the time of the first channel
    word.erase(0, word.find_first_not_of("0123456789"));
    const auto it = kKnown.find(word);
    return it == kKnown.end() ? std::nullopt : std::optional(it->second);
}

struct Head {
    char separator = ',';
    std::vector<std::string> cells;
    std::vector<std::optional<double>> unitOf; // of the columns of times
    size_t next = 0, line = 1;                 // where the first row starts, and its line
};

char separatorOf(const std::string& line) {
    const auto count = [&](char c) { return std::count(line.begin(), line.end(), c); };
    if (count('\t') > 0 && count('\t') >= count(';') && count('\t') >= count(',')) return '\t';
    if (count(';') > 0 && count(';') >= count(',')) return ';';
    return count(',') > 0 || count(' ') == 0 ? ',' : ' ';
}

/// As TwinCAT Scope exports: a block of lines, each with its own word in the columns of times and what it says of each
/// channel in the others ("Name", "Data-Type", "SampleTime[ms]", "Unit"…); then the rows. Times are milliseconds since
/// the start, or dates in steps of 100 ns. `next` at the line after the names. False: it is no such head.
bool readScopeHead(const std::string& text, Head& head) {
    if (head.cells.size() < 2 || head.cells[0] != "Name") return false;
    std::vector<std::string> names = head.cells, cells;
    size_t at = head.next, line = head.line;
    bool isScope = false;
    while (at < text.size()) {
        const size_t next = splitLine(text, at, head.separator, cells);
        const std::string word = cells.empty() ? "" : lower(cells[0]);
        if (word.empty() || !std::isnan(numberOf(cells[0], head.separator))) break;
        isScope = isScope || word == "data-type" || word == "sampletime[ms]";
        for (size_t i = 0; word == "unit" && i < std::min(cells.size(), names.size()); ++i)
            if (names[i] != "Name" && !names[i].empty() && cells[i] != "(None)" && !cells[i].empty())
                names[i] += " [" + cells[i].substr(0, cells[i].find(' ')) + "]"; // "dV (Voltage)"
        at = next;
        ++line;
    }
    if (!isScope) return false;
    for (; at < text.size() && (text[at] == '\r' || text[at] == '\n'); ++at) line += text[at] == '\n';
    splitLine(text, at, head.separator, cells);
    constexpr double kDates = 1e14; // more milliseconds than that are no time since a start
    const bool isDate = !cells.empty() && numberOf(cells[0], head.separator) > kDates;
    head.unitOf.clear();
    for (const std::string& name : names)
        head.unitOf.push_back(name == "Name" ? std::optional(isDate ? 1e-7 : 1e-3) : std::nullopt);
    head.cells = std::move(names);
    head.next = at;
    head.line = line;
    return true;
}

/// The first of the leading lines with a column of times and one of something else.
Result<Head> headOf(const std::string& text) {
    constexpr size_t kMostLines = 60;
    size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    Head head;
    for (size_t line = 1; line <= kMostLines && at < text.size(); ++line) {
        head.separator = separatorOf(text.substr(at, text.find('\n', at) - at));
        at = splitLine(text, at, head.separator, head.cells);
        head.next = at;
        head.line = line + 1;
        if (readScopeHead(text, head)) return head;
        head.unitOf.clear();
        size_t times = 0;
        for (const std::string& cell : head.cells) {
            head.unitOf.push_back(unitOfTime(cell));
            times += head.unitOf.back() ? 1 : 0;
        }
        if (times > 0 && times < head.cells.size()) return head;
    }
    return Error{errors::CsvHasNoTime(), ""};
}

/// Several columns of times: each column of values follows its own; they meet on all instants there are.
Table merged(const std::vector<Samples>& pairs, std::vector<Column> columns) {
    Table out;
    for (const Samples& pair : pairs) out.time.insert(out.time.end(), pair.time.begin(), pair.time.end());
    std::sort(out.time.begin(), out.time.end());
    out.time.erase(std::unique(out.time.begin(), out.time.end()), out.time.end());
    for (size_t c = 0; c < columns.size(); ++c) {
        size_t next = 0;
        double held = kNoNumber;
        for (const double time : out.time) {
            for (; next < pairs[c].size() && pairs[c].time[next] <= time; ++next) held = pairs[c].value[next];
            columns[c].value.push_back(held);
        }
    }
    out.columns = std::move(columns);
    return out;
}

Result<std::string> wholeFile(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return Error{errors::ofSystem(errno), path};
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// What the cells of one column say, and whose times they have.
struct Reading {
    size_t cell = 0, timeCell = 0;
    bool onlyBool = true, hasNumber = false;
    double held = kNoNumber;
};

} // namespace

Result<Table> parseTable(const std::string& text) {
    const auto head = headOf(text);
    if (!head) return head.error();
    std::vector<Column> columns;
    std::vector<Reading> readings;
    size_t timeCell = 0, times = 0;
    for (size_t i = 0; i < head->cells.size(); ++i)
        if (head->unitOf[i] && times++ == 0) timeCell = i;
    for (size_t i = 0; i < head->cells.size(); ++i) {
        if (head->unitOf[i]) {
            if (times > 1) timeCell = i;
            continue;
        }
        Column column;
        column.name = nameOf(head->cells[i], column.unit);
        if (column.name.empty()) continue; // the separator at the end of a line
        columns.push_back(std::move(column));
        readings.push_back({i, timeCell});
    }
    Table out;
    std::vector<Samples> pairs(columns.size());
    std::vector<std::string> cells;
    size_t at = head->next;
    for (size_t line = head->line; at < text.size(); ++line) {
        at = splitLine(text, at, head->separator, cells);
        if (cells.empty() || (cells.size() == 1 && cells[0].empty())) continue;
        if (cells[0] == "EOF") break;
        const auto timeAt = [&](size_t cell) {
            if (cell >= cells.size()) return kNoNumber;
            const double number = dateOf(cells[cell]);
            return std::isnan(number) ? numberOf(cells[cell], head->separator) * *head->unitOf[cell] : number;
        };
        const double time = times > 1 ? 0 : timeAt(timeCell);
        if (std::isnan(time)) return Error{errors::CsvNotANumber(line, head->cells[timeCell]), ""};
        if (times == 1 && !out.time.empty()) {
            if (time < out.time.back()) return Error{errors::CsvTimeRunsBack(line), ""};
            if (time == out.time.back()) continue; // written twice
        }
        if (times == 1) out.time.push_back(time);
        for (size_t c = 0; c < columns.size(); ++c) {
            Reading& reading = readings[c];
            const std::string cell = reading.cell < cells.size() ? cells[reading.cell] : std::string();
            const double value = numberOf(cell, head->separator);
            if (!std::isnan(value)) {
                reading.held = value;
                reading.hasNumber = true;
                const std::string word = lower(withoutBlanks(cell));
                reading.onlyBool = reading.onlyBool && (word == "true" || word == "false");
            }
            if (times == 1) {
                columns[c].value.push_back(reading.held);
            } else if (const double own = timeAt(reading.timeCell); !std::isnan(own) && !std::isnan(value)) {
                Samples& pair = pairs[c];
                if (pair.size() > 0 && own < pair.time.back()) return Error{errors::CsvTimeRunsBack(line), ""};
                if (pair.size() > 0 && own == pair.time.back()) continue;
                pair.time.push_back(own);
                pair.value.push_back(value);
            }
        }
    }
    for (size_t c = columns.size(); c-- > 0;) { // words only: comments, names of states
        columns[c].isBool = readings[c].onlyBool;
        if (readings[c].hasNumber) continue;
        columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(c));
        pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(c));
    }
    if (times > 1)
        out = merged(pairs, std::move(columns));
    else
        out.columns = std::move(columns);
    if (out.time.empty()) return Error{errors::CsvHasNoRows(), ""};
    if (out.columns.empty()) return Error{errors::CsvHasNoValues(), ""};
    return out;
}

Result<Table> readTable(const std::string& path) {
    const auto text = wholeFile(path);
    if (!text) return text.error();
    auto table = parseTable(*text);
    if (!table) return Error{table.error().message, path};
    return table;
}

std::vector<std::string> columnNames(const Table& table) {
    std::vector<std::string> out;
    for (const Column& column : table.columns) out.push_back(column.name);
    return out;
}

Result<size_t> columnOf(const Table& table, const std::string& name) {
    for (size_t i = 0; i < table.columns.size(); ++i)
        if (equalsIgnoringCase(table.columns[i].name, name)) return i;
    const std::vector<std::string> others = columnNames(table);
    if (const auto near = nearestName(name, others)) return Error{errors::CsvNoColumnSuggest(name, *near), ""};
    return Error{errors::CsvNoColumn(name, others), ""};
}

} // namespace plc::waveform
