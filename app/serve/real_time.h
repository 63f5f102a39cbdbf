// What a served controller asks of the machine so that its scans are not late: memory that stays in memory, a scan
// thread that goes before others, a core of its own. Each may be refused; the answers say what was granted. Functions,
// main thread.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace plc::serve {

struct RealTimeWishes {
    int priority = 60; // SCHED_FIFO, 1..99
    std::optional<int> core;
};

/// Asks for all of it for the scan thread of this process, which must run; one line for each wish.
[[nodiscard]] std::vector<std::string> askForRealTime(const RealTimeWishes& wishes);

} // namespace plc::serve
