// The commands about operator panels and what belongs to them, for the table of the command line; each in a file of
// its own. Functions, main thread.
#pragma once
#include "app/cli/kit/command.h"

namespace plc::cli {

[[nodiscard]] Command panelCommand();
[[nodiscard]] Command peopleCommand();
[[nodiscard]] Command recipeCommand();
[[nodiscard]] Command alarmsCommand();
[[nodiscard]] Command textsCommand();

} // namespace plc::cli
