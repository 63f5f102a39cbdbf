// The commands that run a program or ask a recording, for the table of the command line; each in a file of its own.
// Functions, main thread.
#pragma once
#include "app/cli/kit/command.h"

namespace plc::cli {

[[nodiscard]] Command runCommand();
[[nodiscard]] Command replayCommand();
[[nodiscard]] Command traceCommand();
[[nodiscard]] Command whyCommand();

} // namespace plc::cli
