#include "editor/debug/line_map.h"

#include "editor/text/line_diff.h"

#include <algorithm>

namespace plc::editor {

namespace {

/// Lines without the space around them: formatting moves no breakpoint.
std::vector<std::string_view> trimmedLines(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r";
    std::vector<std::string_view> lines = splitLines(text);
    for (std::string_view& line : lines) {
        const size_t first = line.find_first_not_of(kSpace);
        line = first == std::string_view::npos ? std::string_view()
                                               : line.substr(first, line.find_last_not_of(kSpace) - first + 1);
    }
    return lines;
}

} // namespace

LineMap::LineMap(std::string_view from, std::string_view to) {
    const std::vector<std::string_view> there = trimmedLines(to);
    m_to = matchLines(trimmedLines(from), there);
    m_lastLine = static_cast<int>(there.size());
}

std::optional<int> LineMap::exact(int line) const {
    if (line < 1 || line > static_cast<int>(m_to.size()) || m_to[static_cast<size_t>(line - 1)] < 0)
        return std::nullopt;
    return m_to[static_cast<size_t>(line - 1)] + 1;
}

int LineMap::nearest(int line) const {
    for (int each = std::max(line, 1); each <= static_cast<int>(m_to.size()); ++each)
        if (const std::optional<int> same = exact(each)) return *same;
    return m_lastLine;
}

} // namespace plc::editor
