// Runs a project as `run` does, in virtual time and recorded, and then asks its recording: what `why` and `tune` have
// in common. Each function is called once, on the command line's thread.
#pragma once
#include "app/cli/kit/command.h"

#include "projects/session/session.h"

#include <chrono>
#include <functional>

namespace plc::cli {

struct RecordedRun {
    std::string path; // of the project
    std::chrono::nanoseconds length{};
    /// Looked at before the run; an error ends it. Empty: nothing to check.
    std::function<Result<void>(const driver::Built&)> check;
    /// What is asked of the recording; its exit code is the command's.
    std::function<int(const history::History&)> ask;
};

/// With --set, --force, --start and --for as they are given. The exit code.
int askRecordedRun(const Arguments& arguments, const RecordedRun& run);

/// Whether a file begins as a recording does, whatever it is called.
[[nodiscard]] bool isRecording(const std::string& path);

/// The calendar at the first scan: as --start says, else the project.
Result<void> setCalendarStart(const Arguments& arguments, const projects::Project& project,
                              session::Settings& settings);

} // namespace plc::cli
