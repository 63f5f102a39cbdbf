// Mutation by the grammar: whole declarations, variable declarations, statements, types and expressions of two texts
// are exchanged, doubled, moved or removed, so that what comes out mostly parses and reaches the checker and the code
// behind it. Pure functions of their arguments and the seed; any thread.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace plc::fuzz {

/// `text` with one to four pieces changed; `donor` lends some of them. The same seed makes the same text.
[[nodiscard]] std::string mutateByGrammar(std::string_view text, std::string_view donor, uint32_t seed);
/// `text` as an engineer changes it under a running controller: one to three of its variables more, fewer, moved, of
/// another type, or arrays with other bounds.
[[nodiscard]] std::string redeclaredByGrammar(std::string_view text, uint32_t seed);

} // namespace plc::fuzz
