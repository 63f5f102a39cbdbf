// The bodies of a file that a ladder or function block diagram can show: of programs, functions, blocks, methods,
// properties and actions, by their name ("Main", "Motor.Start"). Views of a syntax tree, which must outlive them; any
// thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"
#include "runtime/diagnostics/text_edits.h"

#include <string>
#include <vector>

namespace plc::ladder {

struct Unit {
    std::string name;
    const syntax::Pou* pou = nullptr;   // whose variables the body sees
    const syntax::Pou* owner = nullptr; // of a method or property: the block around it
    const syntax::Body* body = nullptr;
    SourceRange range;     // PROGRAM … END_PROGRAM, ACTION … END_ACTION
    SourceRange header;    // up to the first section or statement
    std::string_view view; // 'ladder', 'fbd': the value of {attribute 'view' := …}, else empty
    SourceRange viewRange; // of that pragma
};

[[nodiscard]] std::vector<Unit> unitsOf(const syntax::SyntaxFile& file);
/// Upper and lower case are the same; an empty name is the first unit. A unit without a body when there is none.
[[nodiscard]] Unit findUnit(const syntax::SyntaxFile& file, std::string_view name);
/// The innermost unit around a place in the text.
[[nodiscard]] Unit unitAt(const syntax::SyntaxFile& file, uint32_t offset);
/// {attribute 'view' := …} above the unit, added, changed or (empty) removed; no edits for an action, which has no
/// place for it, and when nothing changes.
[[nodiscard]] diagnostics::Edits preferView(std::string_view text, const Unit& unit, std::string_view view);

} // namespace plc::ladder
