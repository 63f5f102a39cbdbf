#include "app/serve/real_time.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sched.h>
#include <sys/mman.h>
#include <sys/types.h>

namespace plc::serve {

namespace {

/// By the name that projects/session gives it.
std::optional<pid_t> scanThread() {
    std::error_code problem;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", problem)) {
        std::ifstream file(entry.path() / "comm");
        std::string name;
        if (std::getline(file, name) && name == "scan") return std::stoi(entry.path().filename().string());
    }
    return {};
}

std::string outcome(const std::string& wish, bool isGranted) {
    return wish + (isGranted ? std::string(": granted") : ": not granted (" + std::string(std::strerror(errno)) + ")");
}

} // namespace

std::vector<std::string> askForRealTime(const RealTimeWishes& wishes) {
    std::vector<std::string> out;
    out.push_back(outcome("memory locked", ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0));
    const std::optional<pid_t> thread = scanThread();
    if (!thread) {
        out.emplace_back("scan thread: not found");
        return out;
    }
    if (wishes.core) {
        cpu_set_t cores;
        CPU_ZERO(&cores);
        CPU_SET(static_cast<size_t>(*wishes.core), &cores);
        out.push_back(outcome("scan thread on core " + std::to_string(*wishes.core),
                              ::sched_setaffinity(*thread, sizeof cores, &cores) == 0));
    }
    sched_param parameters{};
    parameters.sched_priority = wishes.priority;
    out.push_back(outcome("scan thread at SCHED_FIFO priority " + std::to_string(wishes.priority),
                          ::sched_setscheduler(*thread, SCHED_FIFO, &parameters) == 0));
    return out;
}

} // namespace plc::serve
