#include "runtime/diagnostics/diagnostic.h"

#include "runtime/diagnostics/severity_name.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <tuple>

namespace plc::diagnostics {

namespace {
struct Entry {
    std::string_view name;
    Severity severity;
    std::string_view code;
};
constexpr Entry kEntries[] = {
#define PLC_DIAGNOSTIC(Name, SeverityName, Code, Text, ...) {#Name, Severity::SeverityName, Code},
#include "runtime/diagnostics/diagnostics.def"
};
const Entry& entry(Kind kind) { return kEntries[static_cast<size_t>(kind)]; }

std::string jsonString(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            (out += '\\') += c;
        else if (c == '\n')
            out += "\\n";
        else if (c == '\t')
            out += "\\t";
        else if (c == '\r')
            out += "\\r";
        else if (static_cast<unsigned char>(c) < 0x20) {
            out += "\\u00";
            out += "0123456789abcdef"[c >> 4];
            out += "0123456789abcdef"[c & 15];
        } else
            out += c;
    }
    return out + '"';
}
std::string rangeJson(const SourceSet& sources, SourceRange range) {
    const SourceText& file = sources[range.file];
    const LineColumn begin = file.lineColumn(range.begin), end = file.lineColumn(range.end);
    return "{\"line\":" + std::to_string(begin.line) + ",\"column\":" + std::to_string(begin.column) +
           ",\"endLine\":" + std::to_string(end.line) + ",\"endColumn\":" + std::to_string(end.column) + "}";
}
} // namespace

std::string_view codeOf(Kind kind) { return entry(kind).code; }
std::string_view nameOf(Kind kind) { return entry(kind).name; }
std::string_view severityName(Severity severity) {
    switch (severity) {
    case Severity::Error:
        return "error";
    case Severity::Warning:
        return "warning";
    case Severity::Info:
        return "info";
    }
    return {};
}

Severity severityOf(Kind kind) { return entry(kind).severity; }

Diagnostic& Sink::emit(SourceRange range, Finding finding) {
    return add({finding.kind, severityOf(finding.kind), range, std::move(finding.message), {}, {}});
}

Diagnostic& Sink::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::Error) ++m_errors;
    return m_all.emplace_back(std::move(diagnostic));
}

void Sink::sort() {
    const auto key = [](const Diagnostic& d) { return std::tuple(d.range.file, d.range.begin, d.range.end, d.kind); };
    std::stable_sort(m_all.begin(), m_all.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
    m_all.erase(std::unique(m_all.begin(), m_all.end(),
                            [&](const Diagnostic& a, const Diagnostic& b) {
                                return key(a) == key(b) && a.message == b.message;
                            }),
                m_all.end());
}

/// "src/a.st:3:7: ", as terminals and editors open it.
static std::string placeOf(const SourceSet& sources, SourceRange range) {
    const LineColumn at = sources[range.file].lineColumn(range.begin);
    return sources[range.file].path() + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
}

namespace {

/// A line for a terminal: without the control characters of a file that is no text, and not as long as it may be.
std::string shownLine(std::string_view line) {
    constexpr size_t kLongest = 1000;
    size_t end = std::min(line.size(), kLongest);
    while (end < line.size() && end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) --end;
    std::string out(line.substr(0, end));
    for (char& each : out)
        if (const auto byte = static_cast<unsigned char>(each); (byte < 0x20 && each != '\t') || byte == 0x7F)
            each = '?';
    return out;
}

} // namespace

std::string renderText(const SourceSet& sources, const Diagnostic& d, bool colours) {
    const auto colour = [&](std::string_view code) { return colours ? std::string(code) : std::string(); };
    const std::string_view tint = d.severity == Severity::Error     ? "\033[1;31m"
                                  : d.severity == Severity::Warning ? "\033[1;33m"
                                                                    : "\033[1;36m";
    const std::string head = colour(tint) + std::string(severityName(d.severity)) + " " + std::string(codeOf(d.kind)) +
                             colour("\033[0m") + ": " + d.message.english() + "\n";
    if (!d.range.file.isValid()) return head;
    const SourceText& file = sources[d.range.file];
    const LineColumn at = file.lineColumn(d.range.begin);
    std::string out = file.path() + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + head;
    const std::string line = shownLine(file.line(at.line));
    const std::string number = std::to_string(at.line);
    out += "  " + number + " | " + line + "\n  " + std::string(number.size(), ' ') + " | ";
    const uint32_t lineBegin = file.lineBegin(at.line);
    for (uint32_t i = lineBegin; i < d.range.begin && i < lineBegin + line.size(); ++i) {
        if (line[i - lineBegin] == '\t')
            out += '\t';
        else if ((static_cast<unsigned char>(line[i - lineBegin]) & 0xC0) != 0x80)
            out += ' ';
    }
    size_t marks = 0;
    for (uint32_t i = d.range.begin; i < d.range.end && i < lineBegin + line.size(); ++i)
        if ((static_cast<unsigned char>(line[i - lineBegin]) & 0xC0) != 0x80) ++marks;
    out += colour(tint) + "^" + std::string(marks > 1 ? marks - 1 : 0, '~') + colour("\033[0m") + "\n";
    const std::string aside = "  " + std::string(number.size(), ' ') + " = ";
    for (const Related& each : d.related)
        if (each.range.file.isValid()) out += aside + placeOf(sources, each.range) + each.note.english() + "\n";
    for (const Fix& fix : d.fixes) out += aside + fix.title.english() + "\n";
    return out;
}

std::string renderJson(const SourceSet& sources, const Diagnostic& d) {
    std::string out = "{\"file\":";
    out += d.range.file.isValid() ? jsonString(sources[d.range.file].path()) : "null";
    if (d.range.file.isValid()) out += ",\"range\":" + rangeJson(sources, d.range);
    out += ",\"code\":" + jsonString(codeOf(d.kind)) + ",\"severity\":" + jsonString(severityName(d.severity)) +
           ",\"message\":" + jsonString(d.message.english());
    out += ",\"fixes\":[";
    for (size_t i = 0; i < d.fixes.size(); ++i) {
        out += (i ? ",{" : "{") + std::string("\"title\":") + jsonString(d.fixes[i].title.english()) + ",\"edits\":[";
        for (size_t k = 0; k < d.fixes[i].edits.size(); ++k) {
            const TextEdit& edit = d.fixes[i].edits[k];
            out += (k ? ",{" : "{") + std::string("\"range\":") + rangeJson(sources, edit.range) +
                   ",\"text\":" + jsonString(edit.text) + "}";
        }
        out += "]}";
    }
    out += "]";
    for (size_t i = 0; i < d.related.size(); ++i) {
        const Related& each = d.related[i];
        out += (i ? ",{" : ",\"related\":[{") + std::string("\"file\":");
        out += each.range.file.isValid() ? jsonString(sources[each.range.file].path()) : "null";
        if (each.range.file.isValid()) out += ",\"range\":" + rangeJson(sources, each.range);
        out += ",\"message\":" + jsonString(each.note.english()) + "}";
    }
    return out + (d.related.empty() ? "}" : "]}");
}

} // namespace plc::diagnostics
