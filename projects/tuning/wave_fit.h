// Whether a sawtooth or a triangle from outside explains an oscillation: it is added to what a process without friction
// makes of the controller's output, or to that output. Values and functions, any thread.
#pragma once
#include "projects/tuning/cycles.h"

namespace plc::tuning {

/// The share of the measured value's movement that the best such wave leaves unexplained.
[[nodiscard]] double fitWave(const Cycles& cycles);

} // namespace plc::tuning
