// What happened to the controller, for the log and the markers of charts. A value; any thread with a copy.
#pragma once
#include "runtime/base/message.h"

#include <chrono>
#include <cstdint>

namespace plc::controller {

using Nanoseconds = std::chrono::nanoseconds;

enum class EventKind : uint8_t {
    Started,
    Stopped,
    Paused,
    Fault,
    Reset,
    Write,
    Force,
    Release,
    OnlineChange,
    Breakpoint,
    RetainSaved,
    RetainRestored,
    SkippedScans,
    WentBack
};
struct Event {
    EventKind kind{};
    uint64_t scan = 0;
    Nanoseconds time{};
    Message text; // which variable, which fault; empty where the kind says it all
};

} // namespace plc::controller
