// Comma separated values as RFC 4180 says, at byte level: UTF-8 with or without BOM, read also with ';' or tab.
// Pure functions, any thread.
#pragma once
#include "runtime/base/result.h"

#include <QStringList>
#include <string>
#include <vector>

namespace plc::hmi {

struct CsvTable {
    std::vector<QStringList> rows; // the first one is the header
    std::vector<int> lines;        // line on which each row begins, from 1
    char separator = ',';
    /// Lines that are no row of a table, as they are; only where they are asked for.
    struct Damage {
        int line = 0;
        std::string bytes; // without the end of the line
        Error error;
    };
    std::vector<Damage> damaged;
};

/// Invalid UTF-8, text behind a closing quote and a quote that is never closed are refused with the line.
Result<CsvTable> parseCsv(const std::string& bytes, const QString& place);
/// The same, but such lines cost only themselves and are listed as damaged; refused when there are very many.
Result<CsvTable> parseDamagedCsv(const std::string& bytes, const QString& place);
/// One row with its end of line.
std::string writeCsvRow(const QStringList& row);
/// With BOM, ',' and CRLF; quotes only where a field needs them.
std::string writeCsv(const std::vector<QStringList>& rows);

} // namespace plc::hmi
