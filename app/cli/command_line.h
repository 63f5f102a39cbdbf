// What the window does, the command line does (D9): the table of its commands, which are in folders by subject, all on
// the same libraries, none needs a display. Main thread.
#pragma once
#include "app/cli/kit/command.h"

namespace plc::cli {

[[nodiscard]] const std::vector<Command>& commands();

/// Runs `stepwise WORDS…`; the words do not hold the program's name.
int runCommandLine(const std::vector<std::string>& words);

[[nodiscard]] Command docCommand(); // here, because it describes all of them

} // namespace plc::cli
