// Which lines of one version of a text are which of another: breakpoints, the executed line and faults belong to the
// program that runs, marks to the text as it stands in the editor. A value; any thread.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

namespace plc::editor {

class LineMap {
public:
    LineMap(std::string_view from, std::string_view to);
    /// The same line in the other text, from 1; none when it was changed or deleted.
    [[nodiscard]] std::optional<int> exact(int line) const;
    /// The same line, else the next one below that both have, else the last.
    [[nodiscard]] int nearest(int line) const;

private:
    std::vector<int> m_to; // by line of `from`, from 0; -1 = not in the other
    int m_lastLine = 1;
};

} // namespace plc::editor
