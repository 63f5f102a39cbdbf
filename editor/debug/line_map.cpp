#include "editor/debug/line_map.h"

#include <algorithm>
#include <cstdint>

namespace plc::editor {

namespace {

/// Lines without the space around them: formatting moves no breakpoint.
std::vector<std::string_view> linesOf(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r";
    std::vector<std::string_view> lines;
    for (;;) {
        const size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        const size_t first = line.find_first_not_of(kSpace);
        line = first == std::string_view::npos ? std::string_view()
                                               : line.substr(first, line.find_last_not_of(kSpace) - first + 1);
        lines.push_back(line);
        if (end == std::string_view::npos) return lines;
        text.remove_prefix(end + 1);
    }
}

constexpr size_t kMostCells = 4'000'000;

} // namespace

LineMap::LineMap(std::string_view from, std::string_view to) {
    const std::vector<std::string_view> a = linesOf(from), b = linesOf(to);
    m_to.assign(a.size(), -1);
    m_lastLine = static_cast<int>(b.size());
    size_t begin = 0, aEnd = a.size(), bEnd = b.size();
    while (begin < aEnd && begin < bEnd && a[begin] == b[begin]) m_to[begin] = static_cast<int>(begin), ++begin;
    while (aEnd > begin && bEnd > begin && a[aEnd - 1] == b[bEnd - 1])
        --aEnd, --bEnd, m_to[aEnd] = static_cast<int>(bEnd);
    const size_t rows = aEnd - begin, columns = bEnd - begin;
    if (rows == 0 || columns == 0 || rows * columns > kMostCells) return;
    // Longest common run of lines of what lies between, from behind so that it is read forwards.
    std::vector<uint32_t> length((rows + 1) * (columns + 1), 0);
    const auto at = [&](size_t row, size_t column) -> uint32_t& { return length[row * (columns + 1) + column]; };
    for (size_t row = rows; row-- > 0;)
        for (size_t column = columns; column-- > 0;)
            at(row, column) = a[begin + row] == b[begin + column] ? at(row + 1, column + 1) + 1
                                                                  : std::max(at(row + 1, column), at(row, column + 1));
    for (size_t row = 0, column = 0; row < rows && column < columns;) {
        if (a[begin + row] == b[begin + column])
            m_to[begin + row++] = static_cast<int>(begin + column++);
        else if (at(row + 1, column) >= at(row, column + 1))
            ++row;
        else
            ++column;
    }
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
