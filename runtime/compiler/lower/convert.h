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
/// The name of an expression's type; empty when unknown. Without it the types come from the unit's own declarations.
using TypeNamer = std::function<std::string(const syntax::Expr&)>;

[[nodiscard]] Result<ConvertedBody> instructionListAsSt(syntax::SyntaxFile& file, const syntax::Pou& pou, const syntax::Body& body, const TypeNamer& typeOf = {});
/// Assignments, calls, IF, CASE, WHILE, REPEAT, RETURN and jumps; says which statement has no like in IL.
[[nodiscard]] Result<ConvertedBody> stAsInstructionList(const syntax::Body& body);

} // namespace plc::lower
