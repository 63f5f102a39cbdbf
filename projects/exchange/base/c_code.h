// C in the text of Beremiz and OpenPLC, which MATIEC passes on to its compiler. Function, any thread.
#pragma once
#include <string>

namespace plc::exchange {

/// C code between {{ and }}, and in pragmas as MATIEC has it, becomes a comment; true when there was some.
bool commentOutC(std::string& text);

} // namespace plc::exchange
