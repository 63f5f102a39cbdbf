// The controller with the greatest integral gain whose loop keeps the sensitivity Ms below a bound: what suppresses
// load disturbances best at a robustness that is asked for. Functions, any thread.
#pragma once
#include "projects/tuning/loop.h"

namespace plc::tuning {

enum class ControllerKind : uint8_t { P, Pi, Pid };

/// None: no such controller (a process that cannot be controlled with this kind). `delay` as for analyse().
[[nodiscard]] std::optional<ControllerGains> optimum(const ProcessModel& process, ControllerKind kind,
                                                     double sensitivity, double delay = 0);

} // namespace plc::tuning
