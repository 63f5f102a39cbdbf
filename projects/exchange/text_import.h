// Text of other tools: .EXP of CODESYS 2.3, loose ST of Beremiz and OpenPLC. Functions, any thread.
#pragma once
#include "projects/exchange/twincat_import.h"

namespace plc::exchange {

/// CODESYS 2.3 marks objects by comments: (* @PATH := … *), (* @END_DECLARATION := … *).
[[nodiscard]] bool isCodesys2Text(std::string_view text);
void importCodesys2Text(const std::string& text, const std::string& place, Imported& imported, TwinCatProject& tasks);
/// One file stays one file.
void importLooseText(const std::string& text, const std::string& place, const std::string& folder,
                     const std::string& name, Imported& imported);
/// C code between {{ and }}, and in pragmas as MATIEC has it, becomes a comment; true when there was some.
bool commentOutC(std::string& text);

} // namespace plc::exchange
