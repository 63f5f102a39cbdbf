#include "projects/waveform/table.h"

#include "projects/waveform/codesys_trace.h"
#include "projects/waveform/errors.h"
#include "projects/waveform/long_table.h"
#include "projects/waveform/table_parts.h"
#include "projects/waveform/time_stamps.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace plc::waveform {

namespace {

/// "Level [m]" without its unit, which goes to `unit`.
std::string nameOf(const std::string& cell, std::string& unit) {
    const std::string text = trimmed(cell);
    const size_t open = text.rfind('[');
    if (open == std::string::npos || open == 0 || text.back() != ']' || text[open - 1] != ' ') return text;
    unit = text.substr(open + 1, text.size() - open - 2);
    return trimmed(text.substr(0, open));
}

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
bool readScopeHead(const std::string& text, TableHead& head) {
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

/// Below the headings some tools write a row of units: words only, in each column that has a heading.
void readUnits(const std::string& text, TableHead& head) {
    std::vector<std::string> cells;
    const size_t next = splitLine(text, head.next, head.separator, cells);
    size_t words = 0;
    for (size_t i = 0; i < cells.size(); ++i) {
        if (!std::isnan(numberOf(cells[i]))) return;
        words += !cells[i].empty() && lowered(cells[i]) != "true" && lowered(cells[i]) != "false";
    }
    const auto isBracket = [](char c) { return std::string_view("[]()").find(c) != std::string_view::npos; };
    for (std::string& cell : cells) std::erase_if(cell, isBracket);
    constexpr std::array kTimes = {"s", "sec", "ms", "us", "min", "h"};
    const bool hasTime = std::any_of(cells.begin(), cells.end(), [&](const std::string& cell) {
        const size_t i = static_cast<size_t>(&cell - cells.data());
        return i < head.unitOf.size() && head.unitOf[i] &&
               (cell.empty() || std::find(kTimes.begin(), kTimes.end(), lowered(cell)) != kTimes.end());
    });
    if (words == 0 || !hasTime) return;
    for (size_t i = 0; i < std::min(cells.size(), head.unitOf.size()); ++i)
        if (head.unitOf[i] && !cells[i].empty()) head.unitOf[i] = unitOfTime("time" + cells[i]);
    head.units = std::move(cells);
    head.next = next;
    ++head.line;
}

/// The first of the leading lines with a column of times and one of something else.
Result<TableHead> headOf(const std::string& text) {
    constexpr size_t kMostLines = 60;
    size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    TableHead head;
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
        if (times == 0 || times == head.cells.size()) continue;
        for (size_t i = 0; i + 1 < head.cells.size(); ++i)
            if (times == 2 && isDateHeading(head.cells[i]) && isTimeOfDayHeading(head.cells[i + 1])) head.dateCell = i;
        readUnits(text, head);
        return head;
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

/// How often something happened in the rows, and where first.
struct Occurrences {
    size_t count = 0, line = 0;
    void add(size_t at) {
        if (count++ == 0) line = at;
    }
};

/// What the cells of one column say, and whose times they have.
struct Reading {
    size_t cell = 0, timeCell = 0;
    bool onlyBool = true, hasNumber = false;
    double held = kNoNumber;
    Occurrences words = {};
    std::string word = {}; // the first
};

/// The rows below the headings, one after the other.
class Rows {
public:
    Rows(const std::string& text, const TableHead& head);
    [[nodiscard]] Result<Table> read();

private:
    /// False: the table has ended.
    bool nextRow();
    void makeColumns();
    void makeTimes();
    [[nodiscard]] double timeAt(size_t cell);
    [[nodiscard]] Result<void> readRow();
    void countCells();
    void noteWord(Reading& reading, const std::string& cell) const;
    [[nodiscard]] std::vector<Message> notes() const;
    [[nodiscard]] Result<void> addOwn(size_t column, double time, double value);
    [[nodiscard]] Result<Table> finished();

    const std::string& m_text;
    const TableHead& m_head;
    size_t m_at, m_line;
    std::vector<std::string> m_cells;
    size_t m_times = 0, m_timeCell = 0; // columns of times; the only one
    std::vector<TimeStamps> m_stamps;   // of each column of times, by its cell
    std::vector<Column> m_columns;
    std::vector<Reading> m_readings;
    std::vector<Samples> m_pairs; // where each column has times of its own
    size_t m_least = 0;           // cells that a row has at least: an empty heading needs none
    Occurrences m_short, m_long, m_sameTime;
    Table m_out;
};

Rows::Rows(const std::string& text, const TableHead& head)
    : m_text(text), m_head(head), m_at(head.next), m_line(head.line - 1) {
    makeColumns();
    makeTimes();
}

void Rows::makeColumns() {
    const auto isTime = [&](size_t i) { return m_head.unitOf[i] && m_head.dateCell != i; };
    for (size_t i = m_head.cells.size(); i-- > 0;)
        if (isTime(i)) ++m_times, m_timeCell = i;
    size_t timeCell = m_timeCell;
    for (size_t i = 0; i < m_head.cells.size(); ++i) {
        if (isTime(i)) timeCell = i;
        if (m_head.unitOf[i]) continue;
        Column column;
        column.name = nameOf(m_head.cells[i], column.unit);
        if (column.name.empty()) continue; // the separator at the end of a line
        if (column.unit.empty() && i < m_head.units.size()) column.unit = m_head.units[i];
        m_columns.push_back(std::move(column));
        m_readings.push_back({i, m_times > 1 ? timeCell : m_timeCell});
        m_least = i + 1;
    }
    m_pairs.resize(m_columns.size());
}

/// The first rows say how the times are written.
void Rows::makeTimes() {
    constexpr size_t kRows = 5000;
    std::vector<std::vector<std::string>> first(m_head.cells.size());
    for (size_t row = 0; row < kRows && nextRow(); ++row)
        for (size_t i = 0; i < std::min(first.size(), m_cells.size()); ++i)
            if (m_head.unitOf[i] && !m_cells[i].empty()) first[i].push_back(m_cells[i]);
    m_at = m_head.next;
    m_line = m_head.line - 1;
    for (size_t i = 0; i < m_head.cells.size(); ++i)
        m_stamps.emplace_back(m_head.unitOf[i].value_or(1), isDateHeading(m_head.cells[i]), first[i]);
}

bool Rows::nextRow() {
    while (m_at < m_text.size()) {
        m_at = splitLine(m_text, m_at, m_head.separator, m_cells);
        ++m_line;
        if (m_cells.empty() || (m_cells.size() == 1 && m_cells[0].empty())) continue;
        if (m_cells[0] == "EOF") return false;
        if (m_head.dateCell && *m_head.dateCell + 1 < m_cells.size())
            m_cells[*m_head.dateCell + 1] = m_cells[*m_head.dateCell] + " " + m_cells[*m_head.dateCell + 1];
        return true;
    }
    return false;
}

double Rows::timeAt(size_t cell) { return cell < m_cells.size() ? m_stamps[cell].next(m_cells[cell]) : kNoNumber; }

Result<void> Rows::addOwn(size_t column, double time, double value) {
    if (std::isnan(time) || std::isnan(value)) return {};
    Samples& pair = m_pairs[column];
    if (pair.size() > 0 && time < pair.time.back()) return Error{errors::CsvTimeRunsBack(m_line), ""};
    if (pair.size() > 0 && time == pair.time.back()) return {};
    pair.time.push_back(time);
    pair.value.push_back(value);
    return {};
}

/// Where columns have times of their own, the shorter ones end earlier.
void Rows::countCells() {
    if (m_cells.size() < m_least && m_times == 1) m_short.add(m_line);
    const auto hasText = [](const std::string& cell) { return !trimmed(cell).empty(); };
    const auto beyond = m_cells.begin() + static_cast<std::ptrdiff_t>(std::min(m_cells.size(), m_head.cells.size()));
    if (std::any_of(beyond, m_cells.end(), hasText)) m_long.add(m_line);
}

void Rows::noteWord(Reading& reading, const std::string& cell) const {
    if (trimmed(cell).empty()) return;
    if (reading.words.count == 0) reading.word = trimmed(cell);
    reading.words.add(m_line);
}

std::vector<Message> Rows::notes() const {
    std::vector<Message> out;
    if (m_long.count > 0) out.push_back(errors::CsvLongRows(m_long.count, m_long.line));
    if (m_short.count > 0) out.push_back(errors::CsvShortRows(m_short.count, m_short.line));
    if (m_sameTime.count > 0) out.push_back(errors::CsvSameTimes(m_sameTime.count, m_sameTime.line));
    for (size_t c = 0; c < m_columns.size(); ++c)
        if (const Reading& reading = m_readings[c]; reading.hasNumber && reading.words.count > 0)
            out.push_back(
                errors::CsvWordsHeld(m_columns[c].name, reading.words.count, reading.word, reading.words.line));
    return out;
}

Result<void> Rows::readRow() {
    const bool isOne = m_times == 1;
    if (isOne) {
        const double time = timeAt(m_timeCell);
        if (std::isnan(time)) return Error{errors::CsvNotANumber(m_line, m_head.cells[m_timeCell]), ""};
        if (!m_out.time.empty() && time < m_out.time.back()) return Error{errors::CsvTimeRunsBack(m_line), ""};
        if (!m_out.time.empty() && time == m_out.time.back()) { // written twice
            m_sameTime.add(m_line);
            return {};
        }
        m_out.time.push_back(time);
    }
    countCells();
    size_t timeCell = m_head.cells.size();
    double own = kNoNumber; // read once for all columns that share it: after midnight it goes on
    for (size_t c = 0; c < m_columns.size(); ++c) {
        Reading& reading = m_readings[c];
        const std::string cell = reading.cell < m_cells.size() ? m_cells[reading.cell] : std::string();
        const double value = numberOf(cell);
        if (!std::isnan(value)) {
            reading.held = value;
            reading.hasNumber = true;
            const std::string word = lowered(trimmed(cell));
            reading.onlyBool = reading.onlyBool && (word == "true" || word == "false");
        } else {
            noteWord(reading, cell);
        }
        if (isOne) {
            m_columns[c].value.push_back(reading.held);
            continue;
        }
        if (reading.timeCell != timeCell) timeCell = reading.timeCell, own = timeAt(timeCell);
        if (auto added = addOwn(c, own, value); !added) return added.error();
    }
    return {};
}

Result<Table> Rows::finished() {
    std::vector<std::string> withoutNumbers;
    std::vector<Message> notes = this->notes();
    for (size_t c = m_columns.size(); c-- > 0;) { // words only: comments, names of states
        m_columns[c].isBool = m_readings[c].onlyBool;
        if (m_readings[c].hasNumber) continue;
        withoutNumbers.push_back(m_columns[c].name);
        m_columns.erase(m_columns.begin() + static_cast<std::ptrdiff_t>(c));
        m_pairs.erase(m_pairs.begin() + static_cast<std::ptrdiff_t>(c));
    }
    if (m_times > 1)
        m_out = merged(m_pairs, std::move(m_columns));
    else
        m_out.columns = std::move(m_columns);
    m_out.withoutNumbers = std::move(withoutNumbers);
    m_out.notes = std::move(notes);
    if (m_out.time.empty()) return Error{errors::CsvHasNoRows(), ""};
    if (m_out.columns.empty()) return Error{errors::CsvHasNoValues(), ""};
    return std::move(m_out);
}

Result<Table> Rows::read() {
    while (nextRow())
        if (auto row = readRow(); !row) return row.error();
    return finished();
}

} // namespace

Result<Table> parseTable(const std::string& text) {
    if (text.find('\0') != std::string::npos) return Error{errors::CsvNotText(), ""};
    if (text.find_first_not_of("\xEF\xBB\xBF \t\r\n") == std::string::npos) return Error{errors::CsvIsEmpty(), ""};
    if (isCodesysTraceCsv(text)) return parseCodesysTraceCsv(text);
    const auto head = headOf(text);
    if (!head) return head.error();
    if (const auto form = longFormOf(text, *head)) return readLongTable(text, *head, *form);
    return Rows(text, *head).read();
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
