// Processes: this one, whether another still runs, and running a program to its end. Free functions, any thread.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace plc::platform {

[[nodiscard]] int64_t processId();
/// Whether there certainly is no such process any more.
[[nodiscard]] bool isGone(int64_t process);
/// Tells the users of this machine apart.
[[nodiscard]] std::string userNumber();

/// The file of the program that runs; empty: the system does not say.
[[nodiscard]] std::string ownProgram();
/// The program of that name in the folders of PATH.
[[nodiscard]] std::optional<std::string> programInPath(const std::string& name);
/// Runs words[0] with the others, without a shell, its output beside ours; its exit code (127: it could not be
/// started), none when it was killed.
[[nodiscard]] std::optional<int> runProgram(const std::vector<std::string>& words);

} // namespace plc::platform
