#include "tests/golden/golden_script.h"

namespace plc::golden {
namespace {

std::string trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return std::string(text);
}

/// Splits at the first `mark` outside of parentheses, brackets and quotes.
bool split(std::string_view text, std::string_view mark, Line& line) {
    int depth = 0;
    char quote = 0;
    for (size_t i = 0; i + mark.size() <= text.size(); ++i) {
        const char c = text[i];
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '\'' || c == '"') {
            quote = c;
        } else if (c == '(' || c == '[') {
            ++depth;
        } else if (c == ')' || c == ']') {
            --depth;
        } else if (depth == 0 && text.substr(i, mark.size()) == mark) {
            line.left = trimmed(text.substr(0, i));
            line.right = trimmed(text.substr(i + mark.size()));
            return true;
        }
    }
    return false;
}

Line parseLine(std::string_view raw) {
    Line line;
    line.text = std::string(raw);
    const std::string text = trimmed(raw);
    const auto rest = [&](std::string_view word) { return trimmed(std::string_view(text).substr(word.size())); };
    const auto begins = [&](std::string_view word) { return text.starts_with(word); };
    if (text.empty() || text[0] == '#') {
        line.kind = LineKind::Comment;
    } else if (begins("library ")) {
        line.kind = LineKind::Library;
        line.left = rest("library ");
    } else if (begins("with ")) {
        line.kind = LineKind::With;
        line.left = rest("with ");
    } else if (begins("setting ")) {
        line.kind = LineKind::Setting;
        line.left = rest("setting ");
    } else if (begins("scans ")) {
        line.kind = LineKind::Scans;
        line.left = rest("scans ");
    } else if (begins("reset ")) {
        line.kind = LineKind::Reset;
        line.left = rest("reset ");
    } else if (begins("release ")) {
        line.kind = LineKind::Release;
        line.left = rest("release ");
    } else if (begins("fault ")) {
        line.kind = LineKind::Fault;
        const std::string what = rest("fault ");
        const size_t at = what.rfind(" at ");
        line.left = at == std::string::npos ? what : what.substr(0, at);
        if (at != std::string::npos) line.right = what.substr(at + 4);
    } else if (begins("force ") && split(std::string_view(text).substr(6), ":=", line)) {
        line.kind = LineKind::Force;
    } else if (split(text, ":=", line)) {
        line.kind = LineKind::Write;
    } else if (split(text, " = ", line)) {
        line.kind = LineKind::Expect;
    }
    return line;
}

} // namespace

std::vector<Line> parseScript(std::string_view text) {
    std::vector<Line> lines;
    for (size_t at = 0; at < text.size();) {
        size_t end = text.find('\n', at);
        if (end == std::string_view::npos) end = text.size();
        lines.push_back(parseLine(text.substr(at, end - at)));
        at = end + 1;
    }
    return lines;
}

} // namespace plc::golden
