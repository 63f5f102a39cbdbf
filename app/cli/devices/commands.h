// The command about the devices of a project, for the table of the command line; each in a file of its own.
// Functions, main thread.
#pragma once
#include "app/cli/kit/command.h"

namespace plc::cli {

[[nodiscard]] Command devicesCommand();

} // namespace plc::cli
