// Which lines two texts have in common, and what lies between: for marks that move with a text, and for comparing what
// was changed here with what was changed elsewhere. Pure functions, any thread.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plc::editor {

/// Without the ends of the lines; one more than there are ends.
[[nodiscard]] std::vector<std::string_view> splitLines(std::string_view text);

/// For each line of `from` the same line of `to` (both from 0), -1 where there is none. In order, and as many as can be
/// unless the texts differ in very much.
[[nodiscard]] std::vector<int> matchLines(const std::vector<std::string_view>& from,
                                          const std::vector<std::string_view>& to);

/// A stretch that differs: lines [hereBegin, hereEnd) of the one, [otherBegin, otherEnd) of the other, from 0.
struct Hunk {
    int hereBegin = 0, hereEnd = 0, otherBegin = 0, otherEnd = 0;
    bool operator==(const Hunk&) const = default;
};
[[nodiscard]] std::vector<Hunk> differences(std::string_view here, std::string_view other);
/// `here` with the lines of the other in one stretch.
[[nodiscard]] std::string withHunk(std::string_view here, std::string_view other, const Hunk& hunk);

} // namespace plc::editor
