#include "runtime/platform/scheduling.h"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/types.h>
#include <thread>

namespace plc::platform {

void nameThread(const char* name) { ::prctl(PR_SET_NAME, name); }
void wakeExactly() { ::prctl(PR_SET_TIMERSLACK, 1000); }

bool sleepUntil(std::chrono::steady_clock::time_point when) { // by an absolute clock: no drift
    const int64_t at = std::chrono::nanoseconds(when.time_since_epoch()).count();
    const timespec wanted{static_cast<time_t>(at / 1'000'000'000), static_cast<long>(at % 1'000'000'000)};
    return ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wanted, nullptr) == 0;
}

std::optional<int64_t> threadNamed(const std::string& name) {
    std::error_code problem;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", problem)) {
        std::ifstream file(entry.path() / "comm");
        std::string known;
        if (std::getline(file, known) && known == name) return std::stoll(entry.path().filename().string());
    }
    return {};
}

std::optional<int64_t> awaitThreadNamed(const std::string& name, std::chrono::milliseconds atMost) {
    const auto end = std::chrono::steady_clock::now() + atMost;
    std::optional<int64_t> found;
    while (!(found = threadNamed(name)) && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return found;
}

bool lockMemory() { return ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0; }

bool bindToCore(int64_t thread, int core) {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    CPU_SET(static_cast<size_t>(core), &cores);
    return ::sched_setaffinity(static_cast<pid_t>(thread), sizeof cores, &cores) == 0;
}

bool runBeforeOthers(int64_t thread, int priority) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    return ::sched_setscheduler(static_cast<pid_t>(thread), SCHED_FIFO, &parameters) == 0;
}

} // namespace plc::platform
