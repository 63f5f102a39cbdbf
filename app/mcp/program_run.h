// One command of this program, run as a process of its own: what it printed, within limits of time and size. So a
// command that does not end, or fails badly, costs its caller nothing. Function, any thread.
#pragma once
#include <chrono>
#include <string>
#include <vector>

namespace plc::mcp {

struct RunLimits {
    std::chrono::milliseconds time{120'000};
    size_t output = size_t(1) << 20; // bytes of each stream
};
struct ProgramRun {
    int exitCode = -1;
    std::string out, err;
    bool isTimedOut = false, isCut = false; // longer than the limit: the begin is kept
    bool hasStarted = true;
};
/// `program`: the executable's path. It gets no input.
[[nodiscard]] ProgramRun runProgram(const std::string& program, const std::vector<std::string>& words,
                                    RunLimits limits);

} // namespace plc::mcp
