// Where blocks of ST begin and end, from the tokens: folding, matching of IF…END_IF, indentation, and what Enter
// closes. Pure functions over a text, any thread; they work on texts with errors.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plc::analysis {

struct BlockMark {
    uint32_t begin = 0, end = 0; // bytes of the word
};
struct BlockPair {
    BlockMark open, close;
    std::vector<BlockMark> middle; // ELSE, ELSIF, UNTIL
    int depth = 0;
};
/// All pairs whose end is there, and comments of several lines (no middle).
[[nodiscard]] std::vector<BlockPair> findBlocks(std::string_view text);
/// Fold level per line (0-based), with flags: a header line opens a block that ends on a later line.
struct FoldLine {
    int level = 0;
    bool isHeader = false;
};
[[nodiscard]] std::vector<FoldLine> foldLines(std::string_view text);
/// The word that would close the innermost block open at `offset` when the text does not close it; "" otherwise.
[[nodiscard]] std::string missingEnd(std::string_view text, uint32_t offset);
/// Blanks in front of the line after `offset`'s line (Enter there): the line's own, one step
/// more behind an opener, but for units whose VAR and statements begin at their own column.
[[nodiscard]] int indentAfter(std::string_view text, uint32_t offset, int step);
/// The part of the line before `offset` opens a block that is still open there.
[[nodiscard]] bool opensBlock(std::string_view text, uint32_t offset);
/// A line that begins with END_…, ELSE, ELSIF, UNTIL belongs one step to the left of what is inside.
[[nodiscard]] bool closesBlock(std::string_view lineText);

} // namespace plc::analysis
