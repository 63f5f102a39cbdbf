#include "projects/waveform/long_table.h"

#include "projects/waveform/errors.h"
#include "projects/waveform/time_stamps.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace plc::waveform {

namespace {

using Words = std::set<std::string>;

const Words kNames = {"name",        "variable",   "variablename", "varname",     "tag",       "tagname",
                      "signal",      "channel",    "signalname",   "channelname", "symbol",    "metric",
                      "field",       "point",      "item",         "pointname",   "parameter", "sensor",
                      "bezeichnung", "messstelle", "kanal",        "nom",         "nombre",    "navn"};
/// Only where none of those is there: of a data base, they say less.
const Words kOtherNames = {"measurement", "series", "path", "topic", "itemid", "source", "key", "id"};
const Words kValues = {"value", "val", "varvalue", "wert", "messwert", "valeur", "valor", "værdi", "reading", "data"};
const Words kUnits = {"unit", "units", "einheit", "unite", "unidad", "enhed", "uom"};

/// Letters alone, small; without a unit.
std::string headingOf(const std::string& cell) {
    std::string word = lowered(cell.substr(0, cell.find_first_of("[(")));
    std::erase_if(word, [](char c) { return std::ispunct(static_cast<unsigned char>(c)) || c == ' '; });
    return word;
}

/// The only heading that is one of these; none or several: none.
std::optional<size_t> onlyCell(const TableHead& head, const Words& words) {
    std::optional<size_t> out;
    for (size_t i = 0; i < head.cells.size(); ++i) {
        if (!words.contains(headingOf(head.cells[i]))) continue;
        if (out) return std::nullopt;
        out = i;
    }
    return out;
}

/// The rows below the headings; the time of day comes with its day.
class LongRows {
public:
    LongRows(const std::string& text, const TableHead& head)
        : line(head.line - 1), m_text(text), m_head(head), m_at(head.next) {}
    bool next() {
        while (m_at < m_text.size()) {
            m_at = splitLine(m_text, m_at, m_head.separator, cells);
            ++line;
            if (cells.empty() || (cells.size() == 1 && cells[0].empty())) continue;
            if (const auto day = m_head.dateCell; day && *day + 1 < cells.size())
                cells[*day + 1] = cells[*day] + " " + cells[*day + 1];
            return true;
        }
        return false;
    }
    [[nodiscard]] std::string cell(size_t i) const { return i < cells.size() ? trimmed(cells[i]) : std::string(); }

    std::vector<std::string> cells;
    size_t line;

private:
    const std::string& m_text;
    const TableHead& m_head;
    size_t m_at;
};

/// One variable, gathered from its rows.
struct Gathered {
    OwnTimes times;
    TimeStamps stamps;
    std::string unit;
    size_t words = 0, wordLine = 0, sameTimes = 0, sameLine = 0;
    std::string word;
    double last = kNoNumber;
};

TimeStamps stampsOf(const std::string& text, const TableHead& head, const LongForm& form) {
    constexpr size_t kRows = 5000;
    std::vector<std::string> first;
    LongRows rows(text, head);
    while (first.size() < kRows && rows.next())
        if (const std::string cell = rows.cell(form.time); !cell.empty()) first.push_back(cell);
    return {head.unitOf[form.time].value_or(1), isDateHeading(head.cells[form.time]), first};
}

double timeOf(Gathered& of, const std::string& cell, const LongForm& form) {
    constexpr double kDayOf1970 = 25'569, kDay = 86'400;
    return form.isWinCc ? (numberOf(cell) * 1e-6 - kDayOf1970) * kDay : of.stamps.next(cell);
}

void takeValue(Gathered& of, double time, const std::string& cell, size_t line) {
    if (std::isnan(numberOf(cell)) && !cell.empty()) {
        if (of.words++ == 0) of.word = cell, of.wordLine = line;
    } else if (time == of.last) {
        if (of.sameTimes++ == 0) of.sameLine = line;
    }
    if (!std::isnan(numberOf(cell))) of.last = time;
}

} // namespace

std::optional<LongForm> longFormOf(const std::string& text, const TableHead& head) {
    LongForm out;
    auto name = onlyCell(head, kNames);
    if (!name) name = onlyCell(head, kOtherNames);
    const auto value = onlyCell(head, kValues);
    if (!name || !value) return std::nullopt;
    std::vector<size_t> times;
    for (size_t i = 0; i < head.cells.size(); ++i)
        if (head.unitOf[i] && head.dateCell != i) times.push_back(i);
    out.isWinCc = times.size() == 2 && headingOf(head.cells[times[0]]) == "timestring" &&
                  headingOf(head.cells[times[1]]) == "timems";
    if (times.empty() || (times.size() > 1 && !out.isWinCc)) return std::nullopt;
    out.time = times.back();
    out.name = *name;
    out.value = *value;
    out.unit = onlyCell(head, kUnits);
    constexpr int kLooked = 200;
    bool hasName = false, hasValue = false;
    LongRows rows(text, head);
    for (int i = 0; i < kLooked && rows.next(); ++i) {
        if (!std::isnan(numberOf(rows.cell(out.name)))) return std::nullopt; // a column of numbers as any other
        hasName = hasName || !rows.cell(out.name).empty();
        hasValue = hasValue || !std::isnan(numberOf(rows.cell(out.value)));
    }
    return hasName && hasValue ? std::optional(out) : std::nullopt;
}

Result<Table> readLongTable(const std::string& text, const TableHead& head, const LongForm& form) {
    const TimeStamps stamps = stampsOf(text, head, form);
    std::vector<Gathered> all;
    std::map<std::string, size_t> known;
    LongRows rows(text, head);
    while (rows.next()) {
        const std::string name = rows.cell(form.name), cell = rows.cell(form.value);
        if (name.empty() || name.starts_with('$')) continue; // WinCC's own, "$RT_COUNT$"
        const auto [found, isNew] = known.try_emplace(name, all.size());
        if (isNew) all.push_back({OwnTimes(name), stamps, form.unit ? rows.cell(*form.unit) : "", 0, 0, 0, 0, {}});
        Gathered& of = all[found->second];
        const double time = timeOf(of, rows.cell(form.time), form);
        if (std::isnan(time)) return Error{errors::CsvNotANumber(rows.line, head.cells[form.time]), ""};
        if (!of.times.add(time, cell)) return Error{errors::CsvTimeRunsBack(rows.line), ""};
        takeValue(of, time, cell, rows.line);
    }
    std::vector<OwnTimes> columns;
    for (const Gathered& each : all) columns.push_back(each.times);
    auto out = tableOf(columns);
    if (!out) return out;
    size_t c = 0;
    for (const Gathered& each : all) {
        if (each.times.isEmpty()) {
            out->withoutNumbers.push_back(each.times.column().name);
            continue;
        }
        Column& column = out->columns[c++];
        column.unit = each.unit;
        if (each.words > 0)
            out->notes.push_back(errors::CsvWordsHeld(column.name, each.words, each.word, each.wordLine));
        if (each.sameTimes > 0) out->notes.push_back(errors::CsvSameTimes(each.sameTimes, each.sameLine));
    }
    return out;
}

} // namespace plc::waveform
