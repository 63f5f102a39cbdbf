#include "projects/waveform/codesys_trace.h"

#include "projects/waveform/errors.h"
#include "projects/waveform/table_parts.h"

#include <cmath>
#include <cstdlib>
#include <pugixml.hpp>

namespace plc::waveform {

namespace {

/// "0.Variable" and no other key of a variable.
bool isVariableKey(const std::string& key) {
    const size_t point = key.find('.');
    return point != std::string::npos && point > 0 && key.find_first_not_of("0123456789") == point &&
           lowered(key.substr(point + 1)) == "variable";
}

std::string lineAt(const std::string& text, size_t at) {
    const size_t end = text.find('\n', at);
    std::string line = text.substr(at, end == std::string::npos ? end : end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
}

/// The unit of the times is a bit of the trace's flags; without it they are milliseconds, as a new trace has them.
double unitOf(const std::string& flags) {
    constexpr long kMicroseconds = 32;
    return (std::strtol(flags.c_str(), nullptr, 0) & kMicroseconds) != 0 ? 1e-6 : 1e-3;
}

/// "a,b,c"; an empty one stays empty, so that values and times keep to each other.
std::vector<std::string> listOf(const std::string& text) {
    std::vector<std::string> out;
    splitLine(text, 0, ',', out);
    return out;
}

} // namespace

bool isCodesysTraceCsv(const std::string& text) {
    const size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    std::vector<std::string> cells;
    splitLine(text, at, ';', cells);
    return cells.size() >= 2 && (isVariableKey(cells[0]) || (cells[0] == "[key]" && cells[1] == "[value]"));
}

Result<Table> parseCodesysTraceCsv(const std::string& text) {
    std::vector<OwnTimes> columns;
    double unit = 1e-3;
    size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (size_t line = 1; at < text.size(); ++line) {
        const std::string whole = lineAt(text, at);
        at = text.find('\n', at);
        at = at == std::string::npos ? text.size() : at + 1;
        const size_t first = whole.find(';');
        if (first == std::string::npos) continue;
        const std::string key = trimmed(whole.substr(0, first)), rest = whole.substr(first + 1);
        if (!key.empty()) {
            if (isVariableKey(key)) columns.emplace_back(trimmed(rest));
            if (lowered(key) == "flags") unit = unitOf(trimmed(rest));
            continue;
        }
        const size_t second = rest.find(';');
        const double time = numberOf(rest.substr(0, second)) * unit;
        if (columns.empty() || second == std::string::npos || std::isnan(time))
            return Error{errors::TraceNotASample(line), ""};
        if (!columns.back().add(time, rest.substr(second + 1))) return Error{errors::CsvTimeRunsBack(line), ""};
    }
    return tableOf(columns);
}

bool isCodesysTraceXml(const std::string& text) {
    // UTF-8 or UTF-16: the letters are the same, perhaps with a zero between them
    constexpr size_t kHead = 4096;
    std::string head = text.substr(0, kHead);
    std::erase(head, '\0');
    const size_t open = head.find('<');
    return open != std::string::npos && open < 4 && head.find("<Trace") != std::string::npos;
}

Result<Table> parseCodesysTraceXml(const std::string& text) {
    pugi::xml_document document;
    if (const auto parsed = document.load_buffer(text.data(), text.size()); !parsed)
        return Error{errors::TraceXmlBroken(Verbatim(parsed.description())), ""};
    const pugi::xml_node setting = document.find_node(
        [](pugi::xml_node node) { return node.attribute("Name").value() == std::string("MicroSeconds"); });
    const double unit = lowered(setting.text().as_string()) == "true" ? 1e-6 : 1e-3;
    std::vector<OwnTimes> columns;
    std::string broken;
    for (const pugi::xpath_node& found : document.select_nodes("//TraceData//TraceVariable")) {
        const pugi::xml_node node = found.node();
        columns.emplace_back(node.attribute("VarName").as_string());
        const auto values = listOf(node.child_value("Values")), times = listOf(node.child_value("Timestamps"));
        if (values.size() != times.size())
            return Error{errors::TraceListsDiffer(columns.back().column().name, values.size(), times.size()), ""};
        for (size_t i = 0; i < values.size(); ++i) {
            const double time = numberOf(times[i]) * unit;
            if (std::isnan(time)) continue; // no sample yet
            if (!columns.back().add(time, values[i]))
                return Error{errors::TraceTimesRunBack(columns.back().column().name), ""};
        }
    }
    return tableOf(columns);
}

} // namespace plc::waveform
