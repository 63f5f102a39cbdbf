// The command that tunes controllers, for the table of the command line; each in a file of its own. Functions, main
// thread.
#pragma once
#include "app/cli/kit/command.h"

namespace plc::cli {

[[nodiscard]] Command tuneCommand();

} // namespace plc::cli
