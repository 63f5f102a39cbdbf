#include "projects/waveform/table.h"

#include "projects/waveform/codesys_trace.h"
#include "projects/waveform/errors.h"
#include "projects/waveform/table_parts.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

namespace plc::waveform {

namespace {

/// "2026-03-01 06:00:00.250" or with a T, in seconds since 1970.
double dateOf(const std::string& cell) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, used = 0;
    if (std::sscanf(cell.c_str(), " %d-%d-%d%*[ T]%d:%d:%n", &year, &month, &day, &hour, &minute, &used) != 5 || !used)
        return kNoNumber;
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    const double seconds = numberOf(cell.substr(static_cast<size_t>(used)));
    if (!date.ok() || std::isnan(seconds)) return kNoNumber;
    const auto days = std::chrono::sys_days(date).time_since_epoch().count();
    return static_cast<double>(days) * 86400 + hour * 3600 + minute * 60 + seconds;
}

/// "Level [m]" without its unit, which goes to `unit`.
std::string nameOf(const std::string& cell, std::string& unit) {
    const std::string text = trimmed(cell);
    const size_t open = text.rfind('[');
    if (open == std::string::npos || open == 0 || text.back() != ']' || text[open - 1] != ' ') return text;
    unit = text.substr(open + 1, text.size() - open - 2);
    return trimmed(text.substr(0, open));
}

/// The unit that a column of times is in [s]; none: not a column of times.
std::optional<double> unitOfTime(const std::string& name) {
    static const std::map<std::string, double> kKnown = {{"times", 1},
                                                         {"time", 1},
                                                         {"t", 1},
                                                         {"ts", 1},
                                                         {"seconds", 1},
                                                         {"timestamp", 1},
                                                         {"timems", 1e-3},
                                                         {"tms", 1e-3},
                                                         {"cycle", 1e-3},
                                                         {"timestamps", 1},
                                                         {"timestampms", 1e-3},
                                                         {"milliseconds", 1e-3},
                                                         {"timeus", 1e-6},
                                                         {"tus", 1e-6},
                                                         {"timestampus", 1e-6},
                                                         {"timens", 1e-9},
                                                         {"tns", 1e-9},
                                                         {"timestampns", 1e-9},
                                                         {"date", 1},
                                                         {"datetime", 1},
                                                         {"zeit", 1},
                                                         {"zeits", 1},
                                                         {"zeitms", 1e-3},
                                                         {"zeitstempel", 1},
                                                         {"zeitstempelms", 1e-3},
                                                         {"zeitstempelus", 1e-6},
                                                         {"horodatagems", 1e-3},
                                                         {"horodatageus", 1e-6},
                                                         {"temps", 1},
                                                         {"tempss", 1},
                                                         {"tempsms", 1e-3}};
    std::string word = lowered(name);
    for (const std::string_view micro : {"\xC2\xB5", "\xCE\xBC"}) // the sign, and the Greek letter
        if (const size_t at = word.find(micro); at != std::string::npos) word.replace(at, micro.size(), "u");
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
    // TwinCAT Scope: the word and whatever was chosen to separate
    for (const std::string_view word : {"Name", "\"Name\""})
        if (line.starts_with(word) && line.size() > word.size() &&
            !std::isalnum(static_cast<unsigned char>(line[word.size()])))
            return line[word.size()];
    const auto count = [&](char c) { return std::count(line.begin(), line.end(), c); };
    if (count('\t') > 0 && count('\t') >= count(';') && count('\t') >= count(',')) return '\t';
    if (count(';') > 0 && count(';') >= count(',')) return ';';
    return count(',') > 0 || count(' ') == 0 ? ',' : ' ';
}

/// The symbols as names; a variable that is there several times gets numbers.
std::vector<std::string> symbolsOf(const std::vector<std::string>& cells) {
    std::vector<std::string> out;
    std::map<std::string, int> seen;
    for (const std::string& cell : cells) {
        if (cell == "SymbolName") {
            out.emplace_back("Name");
            continue;
        }
        const int number = ++seen[cell];
        out.push_back(number > 1 ? cell + "_" + std::to_string(number) : cell);
    }
    return out;
}

/// As TwinCAT Scope exports: a block of lines, each with its own word in the columns of times and what it says of each
/// channel in the others ("Name", "Data-Type", "SampleTime[ms]", "Unit"…); then the rows. Times are milliseconds since
/// the start, or dates in steps of 100 ns. `next` at the line after the names. False: it is no such head.
bool readScopeHead(const std::string& text, Head& head) {
    if (head.cells.size() < 2 || head.cells[0] != "Name") return false;
    std::vector<std::string> names = head.cells, cells;
    size_t at = head.next, line = head.line;
    bool isScope = false;
    size_t count = 0; // of columns
    while (at < text.size()) {
        const size_t next = splitLine(text, at, head.separator, cells);
        const std::string word = cells.empty() ? "" : lowered(cells[0]);
        if (word.empty() || !std::isnan(numberOf(cells[0]))) break;
        isScope = isScope || word == "data-type" || word == "sampletime[ms]";
        // blanks separate, and there is one in a name: the symbols have none
        if (word == "data-type") count = cells.size();
        if (word == "symbolname" && count > 0 && names.size() != count && cells.size() == count)
            names = symbolsOf(cells);
        const bool hasUnits = word == "unit" && (head.separator != ' ' || cells.size() == names.size());
        for (size_t i = 0; hasUnits && i < std::min(cells.size(), names.size()); ++i)
            if (names[i] != "Name" && !names[i].empty() && cells[i] != "(None)" && !cells[i].empty())
                names[i] += " [" + cells[i].substr(0, cells[i].find(' ')) + "]"; // "dV (Voltage)"
        at = next;
        ++line;
    }
    if (!isScope) return false;
    for (; at < text.size() && (text[at] == '\r' || text[at] == '\n'); ++at) line += text[at] == '\n';
    splitLine(text, at, head.separator, cells);
    constexpr double kDates = 1e14; // more milliseconds than that are no time since a start
    const bool isDate = !cells.empty() && numberOf(cells[0]) > kDates;
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

/// As UTF-8: spreadsheets and some tools write UTF-16 or the characters of Windows.
std::string decoded(std::string bytes) {
    const bool isLittle = bytes.starts_with("\xFF\xFE"), isBig = bytes.starts_with("\xFE\xFF");
    if (!isLittle && !isBig) return firstInvalidUtf8(bytes) ? latin1ToUtf8(bytes) : bytes;
    std::u16string units;
    for (size_t i = 2; i + 1 < bytes.size(); i += 2) {
        const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
        units += static_cast<char16_t>(isLittle ? first | second << 8 : first << 8 | second);
    }
    return utf16ToUtf8(units);
}

Result<std::string> wholeFile(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return Error{errors::ofSystem(EISDIR), path};
    std::ifstream in(path, std::ios::binary);
    if (!in) return Error{errors::ofSystem(errno), path};
    std::stringstream text;
    text << in.rdbuf();
    return std::move(text).str();
}

/// What the cells of one column say, and whose times they have.
struct Reading {
    size_t cell = 0, timeCell = 0;
    bool onlyBool = true, hasNumber = false;
    double held = kNoNumber;
};

} // namespace

Result<Table> parseTable(const std::string& text) {
    if (text.find('\0') != std::string::npos) return Error{errors::CsvNotText(), ""};
    if (text.find_first_not_of("\xEF\xBB\xBF \t\r\n") == std::string::npos) return Error{errors::CsvIsEmpty(), ""};
    if (isCodesysTraceCsv(text)) return parseCodesysTraceCsv(text);
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
            return std::isnan(number) ? numberOf(cells[cell]) * *head->unitOf[cell] : number;
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
            const double value = numberOf(cell);
            if (!std::isnan(value)) {
                reading.held = value;
                reading.hasNumber = true;
                const std::string word = lowered(trimmed(cell));
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
        out.withoutNumbers.push_back(columns[c].name);
        columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(c));
        pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(c));
    }
    if (times > 1) {
        std::vector<std::string> withoutNumbers = std::move(out.withoutNumbers);
        out = merged(pairs, std::move(columns));
        out.withoutNumbers = std::move(withoutNumbers);
    } else
        out.columns = std::move(columns);
    if (out.time.empty()) return Error{errors::CsvHasNoRows(), ""};
    if (out.columns.empty()) return Error{errors::CsvHasNoValues(), ""};
    return out;
}

Result<Table> readTable(const std::string& path) {
    auto text = wholeFile(path);
    if (!text) return text.error();
    auto table = isCodesysTraceXml(*text) ? parseCodesysTraceXml(*text) : parseTable(decoded(std::move(*text)));
    if (!table) return Error{table.error().message, path};
    return table;
}

std::vector<std::string> columnNames(const Table& table) {
    std::vector<std::string> out;
    for (const Column& column : table.columns) out.push_back(column.name);
    return out;
}

Result<size_t> columnOf(const Table& table, const std::string& name) {
    const auto isNamed = [&](const Column& column) { return equalsIgnoringCase(column.name, name); };
    const auto found = std::find_if(table.columns.begin(), table.columns.end(), isNamed);
    const auto count = std::count_if(table.columns.begin(), table.columns.end(), isNamed);
    if (count == 1) return static_cast<size_t>(found - table.columns.begin());
    if (count > 1) return Error{errors::CsvColumnTwice(static_cast<size_t>(count), name), ""};
    const std::vector<std::string> others = columnNames(table);
    for (const std::string& other : table.withoutNumbers)
        if (equalsIgnoringCase(other, name)) return Error{errors::CsvColumnWithoutNumbers(name, others), ""};
    if (const auto near = nearestName(name, others)) return Error{errors::CsvNoColumnSuggest(name, *near), ""};
    return Error{errors::CsvNoColumn(name, others), ""};
}

} // namespace plc::waveform
