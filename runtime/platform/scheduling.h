// Threads as the system schedules them: names, exact waking, and what a controller asks for so that its scans are not
// late. Free functions; what may be refused returns false and leaves the reason in errno.
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace plc::platform {

/// Of the calling thread; at most 15 letters are kept.
void nameThread(const char* name);
/// The calling thread's sleep ends when it should, not when it saves power.
void wakeExactly();
/// False: a signal came first.
[[nodiscard]] bool sleepUntil(std::chrono::steady_clock::time_point when);

/// The thread of this process with that name.
[[nodiscard]] std::optional<int64_t> threadNamed(const std::string& name);
/// The same of one that was started but may not have its name yet.
[[nodiscard]] std::optional<int64_t> awaitThreadNamed(const std::string& name, std::chrono::milliseconds atMost);
/// All memory of the process, now and later, stays in memory.
[[nodiscard]] bool lockMemory();
[[nodiscard]] bool bindToCore(int64_t thread, int core);
/// Before every ordinary thread, and until it sleeps; 1 to 99.
[[nodiscard]] bool runBeforeOthers(int64_t thread, int priority);

} // namespace plc::platform
