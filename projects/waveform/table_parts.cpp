#include "projects/waveform/table_parts.h"

#include "projects/waveform/errors.h"
#include "runtime/base/chars.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace plc::waveform {

std::string lowered(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string trimmed(const std::string& text) { return std::string(withoutBlanks(text)); }

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
    if (separator != ' ' || !cell.empty()) cells.push_back(trimmed(cell));
    return at;
}

namespace {

/// With a point in the place of a decimal comma, and without marks between the thousands: of comma and point the last
/// is the decimal mark, and one that is there several times is none. Where the comma separates, such a cell was quoted.
std::string withDecimalPoint(std::string cell) {
    if (cell.find(',') == std::string::npos) return cell;
    const size_t point = cell.rfind('.'), comma = cell.rfind(',');
    const bool isDecimal =
        std::count(cell.begin(), cell.end(), ',') == 1 && (point == std::string::npos || point < comma);
    std::erase(cell, isDecimal ? '.' : ',');
    std::replace(cell.begin(), cell.end(), ',', '.');
    return cell;
}

} // namespace

double numberOf(std::string cell) {
    cell = withDecimalPoint(std::move(cell));
    const size_t begin = cell.find_first_not_of(" +");
    if (begin == std::string::npos) return kNoNumber;
    const std::string word = lowered(trimmed(cell));
    if (word == "true") return 1;
    if (word == "false") return 0;
    double value = 0;
    const auto [end, problem] = std::from_chars(cell.data() + begin, cell.data() + cell.size(), value);
    if (problem != std::errc() || !std::isfinite(value)) return kNoNumber;
    return value;
}

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

OwnTimes::OwnTimes(std::string name) : m_name(std::move(name)) {}

bool OwnTimes::add(double time, const std::string& cell) {
    const double value = numberOf(cell);
    if (std::isnan(value)) return true;
    if (m_samples.size() > 0 && time < m_samples.time.back()) return false;
    if (m_samples.size() > 0 && time == m_samples.time.back()) return true;
    const std::string word = lowered(trimmed(cell));
    m_onlyBool = m_onlyBool && (word == "true" || word == "false");
    m_samples.time.push_back(time);
    m_samples.value.push_back(value);
    return true;
}

Column OwnTimes::column() const {
    Column out;
    out.name = m_name;
    out.isBool = m_onlyBool && !isEmpty();
    return out;
}

Result<Table> tableOf(const std::vector<OwnTimes>& columns) {
    std::vector<Samples> pairs;
    std::vector<Column> out;
    for (const OwnTimes& one : columns) {
        if (one.isEmpty()) continue;
        pairs.push_back(one.samples());
        out.push_back(one.column());
    }
    if (out.empty()) return Error{columns.empty() ? errors::CsvHasNoValues() : errors::CsvHasNoRows(), ""};
    return merged(pairs, std::move(out));
}

} // namespace plc::waveform
