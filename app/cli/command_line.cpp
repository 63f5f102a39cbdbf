#include "app/cli/command_line.h"

#include "app/cli/devices/commands.h"
#include "app/cli/kit/errors.h"
#include "app/cli/panels/commands.h"
#include "app/cli/program/commands.h"
#include "app/cli/remote/commands.h"
#include "app/cli/run/commands.h"
#include "app/cli/tune/commands.h"
#include "runtime/base/text.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include "stepwise_version.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace plc::cli {

namespace {

std::string overview() {
    std::string out = "Stepwise: write, run and watch IEC 61131-3 programs.\n\n"
                      "Usage: stepwise [PROJECT]            opens the studio\n"
                      "       stepwise COMMAND …            works without a display\n\nCommands:\n";
    for (const Command& command : commands()) {
        std::string name(command.spec.name);
        name.resize(10, ' ');
        out += "  " + name + std::string(command.spec.summary) + "\n";
    }
    return out + "\n`stepwise COMMAND --help` shows the options and an example.\n";
}

/// The first word is neither a command nor what the studio opens: it may be meant as the one or as the other.
Message notACommand(const std::string& word, const std::vector<std::string>& commandNames) {
    const std::filesystem::path path(std::u8string(word.begin(), word.end()));
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored))
        return equalsIgnoringCase(path.extension().string(), ".st") ? errors::SourceNotAProject(word)
                                                                    : errors::NotAProjectFile(word);
    if (word.starts_with('-')) return errors::OptionWithoutCommand(word);
    if (word.find_first_of("/\\.") != std::string::npos) return errors::NoFileOrFolder(word);
    const auto near = nearestName(word, commandNames);
    return near ? errors::NoCommandSuggest(word, *near) : errors::NoCommandNorFolder(word);
}

} // namespace

const std::vector<Command>& commands() {
    static const std::vector<Command> all = {
        checkCommand(),  runCommand(),     formatCommand(),  testCommand(),   traceCommand(),  replayCommand(),
        panelCommand(),  docCommand(),     convertCommand(), importCommand(), exportCommand(), ladderCommand(),
        whyCommand(),    tuneCommand(),    serveCommand(),   textsCommand(),  recipeCommand(), peopleCommand(),
        alarmsCommand(), devicesCommand(), lspCommand(),     dapCommand(),    mcpCommand(),    explainCommand(),
        buildCommand(),  attachCommand()};
    return all;
}

int runCommandLine(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "--help" || words[0] == "-h" || words[0] == "help") {
        std::cout << overview();
        return kGood;
    }
    if (words[0] == "--version") {
        std::cout << "Stepwise " STEPWISE_VERSION "\n";
        return kGood;
    }
    const auto& all = commands();
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const Command& command) { return command.spec.name == words[0]; });
    if (it == all.end()) {
        std::vector<std::string> names;
        for (const Command& command : all) names.emplace_back(command.spec.name);
        return wrongUse({notACommand(words[0], names), ""});
    }
    const auto arguments = Arguments::parse(it->spec, {words.begin() + 1, words.end()});
    if (!arguments) return wrongUse(arguments.error());
    if (arguments->wantsHelp()) {
        std::cout << helpText(it->spec);
        return kGood;
    }
    if (const auto format = arguments->value("--format");
        format && *format != "text" && *format != "json" && *format != "junit")
        return wrongUse({errors::FormatIs(*format), ""});
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    const int code = it->run(*arguments);
    std::cout.flush();
    if (std::cout) return code;
    return wrongUse({errors::OutputNotWritten(), ""});
}

} // namespace plc::cli
