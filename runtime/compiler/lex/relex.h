// Tokens of a text that begins as another one did: those in front of a place are taken over, the rest is read. For who
// reads a file again at every keystroke. Pure function, any thread.
#pragma once
#include "runtime/compiler/lex/token.h"

namespace plc::lex {

/// `before`: tokens of an earlier text, equal to `text` up to the end of the token `kept`, which stays the first token
/// to be read; none of those before it may be an Error or a line that Siemens editors write (REGION …), since what
/// these are read as depends on the rest of the text.
[[nodiscard]] TokenList tokenizeFrom(FileId file, std::string_view text, const TokenList& before, size_t kept,
                                     diagnostics::Sink& sink);

} // namespace plc::lex
