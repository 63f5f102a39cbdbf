#include "app/cli/command.h"

#include <iostream>

namespace plc::cli {

namespace {
int check(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({"check needs a project folder or ST files (stepwise check --help)", ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const driver::Checked checked = driver::check(project->buildInput());
    const bool wrong = printDiagnostics(checked, arguments.wantsJson(), arguments.has("--infos") || arguments.wantsJson());
    if (!arguments.wantsJson() && !wrong) std::cout << project->name << ": no errors\n";
    return wrong ? kProgramWrong : kGood;
}
} // namespace

Command checkCommand() {
    return {{"check", "PATH… [OPTIONS]", "Checks a project, or ST files, and lists what is wrong.",
             {{"--library", "NAME", "a library the files use, besides the standard (repeatable)"},
              {"--infos", "", "also what is only worth knowing"},
              {"--format", "text|json", "text (default), or a list of objects with file, range, code, severity, message, fixes"}},
             "stepwise check projects/examples/motor"},
            check};
}

} // namespace plc::cli
