// The commands about the text of a program: checks, formats, conversions, tests, for the table of the command line;
// each in a file of its own. Functions, main thread.
#pragma once
#include "app/cli/kit/command.h"

namespace plc::cli {

[[nodiscard]] Command checkCommand();
[[nodiscard]] Command formatCommand();
[[nodiscard]] Command convertCommand();
[[nodiscard]] Command ladderCommand();
[[nodiscard]] Command explainCommand();
[[nodiscard]] Command buildCommand();
[[nodiscard]] Command importCommand();
[[nodiscard]] Command exportCommand();
[[nodiscard]] Command testCommand();

} // namespace plc::cli
