// Edits of one text as replacements: applied, and taken back. What the graph views (D4) and their tests share. Pure
// functions; any thread.
#pragma once
#include "runtime/diagnostics/diagnostic.h"

namespace plc::diagnostics {

using Edits = std::vector<TextEdit>; // of one file, by place, not overlapping

[[nodiscard]] std::string applyEdits(std::string_view text, const Edits& edits);
/// What undoes `edits` in the text they lead to.
[[nodiscard]] Edits inverseOf(std::string_view text, const Edits& edits);

} // namespace plc::diagnostics
