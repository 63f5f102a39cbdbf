#include "app/serve/real_time.h"

#include "runtime/platform/scheduling.h"

#include <cerrno>
#include <cstring>

namespace plc::serve {

namespace {

std::string outcome(const std::string& wish, bool isGranted) {
    return wish + (isGranted ? std::string(": granted") : ": not granted (" + std::string(std::strerror(errno)) + ")");
}

} // namespace

std::vector<std::string> askForRealTime(const RealTimeWishes& wishes) {
    std::vector<std::string> out;
    out.push_back(outcome("memory locked", platform::lockMemory()));
    // By the name that projects/session gives it.
    const std::optional<int64_t> thread = platform::awaitThreadNamed("scan", std::chrono::seconds(5));
    if (!thread) {
        out.emplace_back("scan thread: not found");
        return out;
    }
    if (wishes.core)
        out.push_back(outcome("scan thread on core " + std::to_string(*wishes.core),
                              platform::bindToCore(*thread, *wishes.core)));
    out.push_back(outcome("scan thread at SCHED_FIFO priority " + std::to_string(wishes.priority),
                          platform::runBeforeOthers(*thread, wishes.priority)));
    return out;
}

} // namespace plc::serve
