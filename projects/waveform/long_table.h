// Tables with one row for each value of one variable, as historians, data bases and WinCC panels export them: the time,
// the name of the variable, its value. Functions, any thread.
#pragma once
#include "projects/waveform/table_parts.h"

namespace plc::waveform {

/// Which cell of a row is what.
struct LongForm {
    size_t time = 0, name = 0, value = 0;
    std::optional<size_t> unit;
    bool isWinCc = false; // times are days of a spreadsheet, times a million
};

/// None: each variable has a column of its own.
[[nodiscard]] std::optional<LongForm> longFormOf(const std::string& text, const TableHead& head);
/// Each name becomes a column; the rows of one name are in the order of their times.
[[nodiscard]] Result<Table> readLongTable(const std::string& text, const TableHead& head, const LongForm& form);

} // namespace plc::waveform
