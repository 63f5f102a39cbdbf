// The commands that serve: controllers, editors and other tools, for the table of the command line; each in a file of
// its own. Functions, main thread.
#pragma once
#include "app/cli/kit/command.h"

namespace plc::cli {

[[nodiscard]] Command serveCommand();
[[nodiscard]] Command attachCommand();
[[nodiscard]] Command lspCommand();
[[nodiscard]] Command dapCommand();
[[nodiscard]] Command mcpCommand();

} // namespace plc::cli
