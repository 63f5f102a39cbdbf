#include "editor/text/line_diff.h"

#include <algorithm>
#include <cstdint>

namespace plc::editor {

namespace {
constexpr size_t kMostCells = 4'000'000;
} // namespace

std::vector<std::string_view> splitLines(std::string_view text) {
    std::vector<std::string_view> lines;
    for (;;) {
        const size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return lines;
        text.remove_prefix(end + 1);
    }
}

std::vector<int> matchLines(const std::vector<std::string_view>& from, const std::vector<std::string_view>& to) {
    std::vector<int> match(from.size(), -1);
    size_t begin = 0, fromEnd = from.size(), toEnd = to.size();
    while (begin < fromEnd && begin < toEnd && from[begin] == to[begin])
        match[begin] = static_cast<int>(begin), ++begin;
    while (fromEnd > begin && toEnd > begin && from[fromEnd - 1] == to[toEnd - 1])
        --fromEnd, --toEnd, match[fromEnd] = static_cast<int>(toEnd);
    const size_t rows = fromEnd - begin, columns = toEnd - begin;
    if (rows == 0 || columns == 0 || rows * columns > kMostCells) return match;
    // Longest common run of lines of what lies between, from behind so that it is read forwards.
    std::vector<uint32_t> length((rows + 1) * (columns + 1), 0);
    const auto at = [&](size_t row, size_t column) -> uint32_t& { return length[row * (columns + 1) + column]; };
    for (size_t row = rows; row-- > 0;)
        for (size_t column = columns; column-- > 0;)
            at(row, column) = from[begin + row] == to[begin + column]
                                  ? at(row + 1, column + 1) + 1
                                  : std::max(at(row + 1, column), at(row, column + 1));
    for (size_t row = 0, column = 0; row < rows && column < columns;) {
        if (from[begin + row] == to[begin + column])
            match[begin + row++] = static_cast<int>(begin + column++);
        else if (at(row + 1, column) >= at(row, column + 1))
            ++row;
        else
            ++column;
    }
    return match;
}

std::vector<Hunk> differences(std::string_view here, std::string_view other) {
    const std::vector<std::string_view> a = splitLines(here), b = splitLines(other);
    const std::vector<int> match = matchLines(a, b);
    std::vector<Hunk> out;
    int line = 0, there = 0;
    const int end = static_cast<int>(a.size()), thereEnd = static_cast<int>(b.size());
    while (line < end || there < thereEnd) {
        if (line < end && match[static_cast<size_t>(line)] == there) {
            ++line, ++there;
            continue;
        }
        Hunk hunk{line, line, there, there};
        while (line < end && match[static_cast<size_t>(line)] < 0) ++line;
        hunk.hereEnd = line;
        hunk.otherEnd = there = line < end ? match[static_cast<size_t>(line)] : thereEnd;
        out.push_back(hunk);
    }
    return out;
}

std::string withHunk(std::string_view here, std::string_view other, const Hunk& hunk) {
    const std::vector<std::string_view> theirs = splitLines(other);
    std::vector<std::string_view> lines = splitLines(here);
    lines.erase(lines.begin() + hunk.hereBegin, lines.begin() + hunk.hereEnd);
    lines.insert(lines.begin() + hunk.hereBegin, theirs.begin() + hunk.otherBegin, theirs.begin() + hunk.otherEnd);
    std::string out;
    for (size_t i = 0; i < lines.size(); ++i) out.append(i ? "\n" : "").append(lines[i]);
    return out;
}

} // namespace plc::editor
