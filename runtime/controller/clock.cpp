#include "runtime/controller/clock.h"

#include <chrono>

namespace plc::controller {

int64_t SteadyClock::nowNs() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

} // namespace plc::controller
