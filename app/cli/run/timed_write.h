// A write or force of the command line: PATH=VALUE or PATH=VALUE@TIME. Values and functions, any thread.
#pragma once
#include "app/cli/kit/arguments.h"
#include "projects/session/session.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/controller/controller.h"

#include <chrono>
#include <string>
#include <vector>

namespace plc::cli {

/// "Main.start=TRUE@1.5s": written (or forced) before the first scan at or after the time.
struct TimedWrite {
    std::string path;
    std::string text;
    std::chrono::nanoseconds at{0};
    bool isForce = false;
    bool isRelease = false;
};

[[nodiscard]] Result<TimedWrite> parseWrite(const std::string& word, bool isForce);
/// What --force and --set say, in the order of their times, forces first. Refuses a variable that is not there and a
/// value that its type does not read.
[[nodiscard]] Result<std::vector<TimedWrite>> readWrites(const Arguments& arguments, const driver::Checked& checked,
                                                         const controller::Controller& controller);
Result<void> apply(const driver::Checked& checked, controller::Controller& controller, const TimedWrite& write);

/// Runs the project as `run` does, in virtual time, with the writes and forces of --set and --force at their times,
/// until the time that the option `lengthOption` says, else `length`.
Result<void> runProject(const Arguments& arguments, const driver::Built& built, session::Session& session,
                        std::chrono::nanoseconds length, std::string_view lengthOption);

} // namespace plc::cli
