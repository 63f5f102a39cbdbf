// Where the bodies are in a text: what lies between them declares, what is in them does not. Two readings of a file
// whose bodies have the same text between them declare the same; a place of one is then found in the other. Immutable
// values.
#pragma once
#include "runtime/base/source.h"
#include "runtime/compiler/parse/syntax.h"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace plc::sema {

/// Of one file: its bodies of structured text with the blanks and comments around them, in order, not overlapping.
struct FileShape {
    struct Piece {
        uint32_t begin = 0, end = 0;
        bool operator==(const Piece&) const = default;
    };
    std::vector<Piece> bodies;
    /// The body around a place.
    [[nodiscard]] std::optional<size_t> bodyAt(uint32_t offset) const;
};
[[nodiscard]] std::shared_ptr<const FileShape> shapeOf(const syntax::SyntaxFile& file, std::string_view text);

/// Which bodies of a file are not as they were; nothing when more than bodies changed.
[[nodiscard]] std::optional<std::vector<bool>> changedBodies(const FileShape& before, std::string_view textBefore,
                                                             const FileShape& now, std::string_view textNow);

/// Of all files, by FileId.
using Shapes = std::vector<std::shared_ptr<const FileShape>>;
/// From places of one reading to those of another that differs in bodies only. A place in a body that changed has none.
class Moves {
public:
    Moves(const Shapes& from, const Shapes& to) : m_from(from), m_to(to), m_isNeeded(from != to) {}
    [[nodiscard]] bool isNeeded() const { return m_isNeeded; }
    [[nodiscard]] SourceRange operator()(SourceRange range) const;

private:
    const Shapes& m_from;
    const Shapes& m_to;
    bool m_isNeeded;
};

} // namespace plc::sema
