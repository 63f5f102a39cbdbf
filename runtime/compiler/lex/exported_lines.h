// Lines that the Siemens editors write around the code: REGION … END_REGION, VERSION : 0.1, BEGIN, TITLE = …, AUTHOR :
// …. They mean nothing to the program and become Pragma tokens, kept as they are written. Pure functions, any thread.
#pragma once
#include "runtime/compiler/lex/token.h"

#include <optional>

namespace plc::lex {

class ExportedLines {
public:
    explicit ExportedLines(std::string_view text) : m_text(text) {}
    /// The end of such a line that begins at `begin`, the first token of its line; 0 when it is none.
    [[nodiscard]] size_t endOf(size_t begin, const TokenList& before);

private:
    [[nodiscard]] bool hasRegions();
    std::string_view m_text;
    std::optional<bool> m_hasRegions; // END_REGION stands somewhere
};

} // namespace plc::lex
