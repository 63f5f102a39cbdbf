#include "app/cli/run/recorded_run.h"

#include "app/cli/kit/errors.h"
#include "app/cli/run/run_output.h"
#include "app/cli/run/timed_write.h"

#include "projects/storage/project_file.h"

#include <filesystem>
#include <fstream>

namespace plc::cli {

Result<void> setCalendarStart(const Arguments& arguments, const projects::Project& project,
                              session::Settings& settings) {
    const auto start = calendarStart(arguments.value("--start").value_or(project.calendarStart));
    if (!start) return start.error();
    if (*start) settings.controller.calendarStartNs = **start;
    return {};
}

bool isRecording(const std::string& path) {
    if (std::filesystem::path(path).extension() == ".rec") return true; // damaged or not
    char magic[6] = {};
    std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
    return std::string_view(magic, sizeof magic) == "STWREC";
}

int askRecordedRun(const Arguments& arguments, const RecordedRun& run) {
    const auto project = openNamedProject(arguments, {run.path});
    if (!project) return wrongUse(project.error());
    const driver::Built built = [&] {
        const Busy busy("building " + project->name);
        return driver::build(project->buildInput());
    }();
    if (built.checked.analysis->hasErrors) {
        printDiagnostics(built.checked, arguments.wantsJson(), false);
        return kProgramWrong;
    }
    if (!built.program)
        return wrongUse({built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project->name});
    if (run.check)
        if (const auto good = run.check(built); !good) return wrongUse(good.error());
    session::Settings settings;
    if (auto set = setCalendarStart(arguments, *project, settings); !set) return wrongUse(set.error());
    catchInterrupt();
    session::Session session(built, settings);
    session.controller().actFor("the command line");
    if (auto ran = runProject(arguments, built, session, run.length, "--for"); !ran) return wrongUse(ran.error());
    return run.ask(session.history());
}

} // namespace plc::cli
