// "Show as ST" for an instruction list and back: texts with the same results. The tree must not be lowered yet. Pure
// functions over one file's tree; any thread.
#pragma once
#include "runtime/base/result.h"
#include "runtime/compiler/parse/syntax.h"

#include <functional>
#include <string>

namespace plc::lower {

struct ConvertedBody {
    std::string declarations; // lines for a VAR section: what the other language needs
    std::string body;
};
/// The type of the `number`-th result (from 0) that is kept for the instruction or label at `place`; empty when
/// unknown. Without it the types come from the unit's own declarations.
using TypeNamer = std::function<std::string(SourceRange place, size_t number)>;

/// With the file's text the comments of the body are kept, each above the statement it belongs to.
[[nodiscard]] Result<ConvertedBody> instructionListAsSt(syntax::SyntaxFile& file, const syntax::Pou& pou,
                                                        const syntax::Body& body, const TypeNamer& typeOf = {},
                                                        std::string_view text = {});
/// Assignments, calls, IF, CASE, WHILE, REPEAT, counted loops with small constant ends, RETURN and jumps; says which
/// statement has no like in IL.
[[nodiscard]] Result<ConvertedBody> stAsInstructionList(const syntax::SyntaxFile& file, const syntax::Body& body,
                                                        std::string_view text = {});

} // namespace plc::lower
