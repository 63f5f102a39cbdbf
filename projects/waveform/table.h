// A table of measured values, as spreadsheets, plotters and other PLC tools export them: a head line with names, a
// column of times, columns of numbers. Values and functions, any thread.
#pragma once
#include "projects/waveform/samples.h"
#include "runtime/base/message.h"
#include "runtime/base/result.h"

#include <string>
#include <vector>

namespace plc::waveform {

struct Column {
    std::string name, unit;    // "Level [m]" is Level in m
    std::vector<double> value; // one for each time; not a number: none yet
    bool isBool = false;       // TRUE and FALSE only
};

struct Table {
    std::vector<double> time; // [s], rising
    std::vector<Column> columns;
    std::vector<std::string> withoutNumbers; // columns that are left out
    std::vector<Message> notes;              // what was not as it should be, and what was done about it
};

/// A column of times (time_s as `run --csv` writes it, or one named time, t, timestamp…, in s, ms, us or ns as its name
/// says; dates with times of day), or one of them before each column of values, or the head of several lines of TwinCAT
/// Scope; or one row for each value of one variable, with columns of times, of names and of values (long_table.h).
/// Lines above the head are skipped. Comma, semicolon, tab or blanks; where a comma does not separate, or in quotes, it
/// may be the decimal point. An empty cell is unchanged.
[[nodiscard]] Result<Table> parseTable(const std::string& text);
[[nodiscard]] Result<Table> readTable(const std::string& path);
/// The names of the columns, the time's left out.
[[nodiscard]] std::vector<std::string> columnNames(const Table& table);
/// By name, without case; the error names what there is.
[[nodiscard]] Result<size_t> columnOf(const Table& table, const std::string& name);

} // namespace plc::waveform
