// Declarations and the sections they stand in, as text edits: where a line of a section goes, a declaration that moves
// to another section. Functions; any thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"
#include "runtime/diagnostics/diagnostic.h"

#include <optional>
#include <string>
#include <vector>

namespace plc::analysis {

/// Where the line of a place in the text begins.
[[nodiscard]] uint32_t lineBegin(std::string_view text, uint32_t at);
/// Where the line of END_VAR begins; none when the section stands on one line.
[[nodiscard]] std::optional<uint32_t> lineOfEnd(const syntax::VarSection& section, std::string_view text);
/// A line in the section of that kind, or in a new one: inputs stand first, all others behind what is there.
[[nodiscard]] diagnostics::TextEdit declareIn(const syntax::Pou& pou, syntax::SectionKind kind, FileId file,
                                              std::string_view text, const std::string& line);

/// A name of a declaration goes to a plain section of another kind. `lines`: the declaration's whole lines with the
/// comments above them; a declaration of several names, or one that shares its line, leaves the others where they are.
/// Empty when it cannot be: a section on one line.
[[nodiscard]] std::vector<diagnostics::TextEdit> moveToSection(const syntax::Pou& pou, const syntax::VarSection& from,
                                                               const syntax::VarDecl& declaration, size_t name,
                                                               syntax::SectionKind to, SourceRange lines,
                                                               std::string_view text);

} // namespace plc::analysis
