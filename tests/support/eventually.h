// Waits for what another thread does, at most as long as patience.h says. For tests without an event loop; those with a
// window use QTest::qWaitFor and settle.h.
#pragma once
#include "tests/support/patience.h"

#include <chrono>
#include <thread>

namespace plc {

template <class Condition>
bool eventually(Condition condition, std::chrono::milliseconds limit = std::chrono::milliseconds(kPatience)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (std::chrono::steady_clock::now() < end) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return condition();
}

} // namespace plc
