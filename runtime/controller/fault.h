// What stopped the controller, in the user's terms: kind, place, call path. A value; any thread with a copy.
#pragma once
#include "runtime/base/message.h"
#include "runtime/image/program.h"

#include <chrono>
#include <string>
#include <vector>

namespace plc::controller {

using Nanoseconds = std::chrono::nanoseconds;

/// A live call of a fault or halt, in the user's terms.
struct FaultFrame {
    std::string function; // "Main.Fill"
    std::string instance; // path of THIS, "" for functions
    SourceRange range;
    uint32_t instanceOffset = 0, frameOffset = 0, functionIndex = 0;
};
struct Fault {
    image::FaultCode code = image::FaultCode::None;
    Message message; // "index 7 is outside 1..5"
    std::string task;
    SourceRange range;
    std::vector<FaultFrame> calls; // innermost first
    uint64_t scan = 0;
    Nanoseconds time{};
    bool isSimulation = false; // the plant's, not the PLC's
};
[[nodiscard]] std::string_view name(image::FaultCode code); // "division by zero"

} // namespace plc::controller
