// The manual pages and shell completions, made from the tables of the commands: what --help shows, in the forms that
// man, bash and zsh read. Functions, any thread.
#pragma once
#include "app/cli/kit/arguments.h"

#include <string>
#include <vector>

namespace plc::cli {

/// stepwise(1): what it is and one line for each command.
[[nodiscard]] std::string overviewPage(const std::vector<CommandSpec>& commands, const std::string& version);
/// stepwise-run(1) and so on.
[[nodiscard]] std::string manualPage(const CommandSpec& command, const std::string& version);
[[nodiscard]] std::string bashCompletion(const std::vector<CommandSpec>& commands);
[[nodiscard]] std::string zshCompletion(const std::vector<CommandSpec>& commands);

} // namespace plc::cli
