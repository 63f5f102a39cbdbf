// Whether a valve that sticks explains an oscillation: a process behind a valve with friction is fitted to what was
// recorded, the same without friction, and with a wave from outside instead. Values and functions, any thread.
#pragma once
#include "projects/tuning/model/series.h"

#include <optional>

namespace plc::tuning {

struct ValveFit {
    double without = 1; // share of the measured value's movement that a valve without friction leaves unexplained
    double with = 1;    // the same with the best friction
    double wave = 1;    // the same without friction, but with a sawtooth or triangle from outside
    double noise = 0;   // share that nothing can explain
    double band = 0;    // of the output within which the valve stays where it is
    [[nodiscard]] double gain() const { return (without + 1e-4) / (with + 1e-4); }
};

/// Over whole cycles of an oscillation, samples [begin, end); none where there are too few of them, or the output does
/// not move.
[[nodiscard]] std::optional<ValveFit> fitValve(const LoopSeries& series, size_t begin, size_t end, double period);

} // namespace plc::tuning
