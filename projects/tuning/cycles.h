// The last cycles of an oscillation in even parts, and the simple processes that are tried on them: what the fits of a
// valve that sticks and of a wave from outside have in common. Values and functions, any thread.
#pragma once
#include "projects/tuning/model/series.h"

#include <Eigen/Dense>

namespace plc::tuning {

/// A stretch of the recording in even parts; `stride` samples make one.
struct Stretch {
    size_t begin = 0, stride = 1, parts = 0;
};

/// The values in parts: the mean of each.
[[nodiscard]] std::vector<double> averaged(const std::vector<double>& values, size_t begin, const Stretch& stretch);

/// The process: up to three lags, or an integrator; its dead time is kept beside it.
struct LagShape {
    double lag = 1;    // in parts
    double second = 0; // share of the first; 0: there is none
    double third = 0;
    bool isIntegrating = false;
};
/// The lags in falling order.
[[nodiscard]] inline bool isPossible(const LagShape& shape) {
    return shape.second <= 1 && shape.third >= 0 && shape.third <= shape.second;
}
/// To what is left of `drive` without its mean, with a gain of 1 and without the dead time.
[[nodiscard]] std::vector<double> responseOf(const std::vector<double>& drive, const LagShape& shape);

/// The values some parts later, in straight lines between two.
[[nodiscard]] std::vector<double> delayed(const std::vector<double>& values, double delay);

/// What was measured, with the sums over it that every fit needs.
struct Measured {
    std::vector<double> values; // less set point, in parts
    size_t skip = 0;            // parts at the start that have not forgotten where they came from
    double sign = 1;            // of the process's gain
    Eigen::Matrix2d base;       // products of offset and slope
    Eigen::Vector2d right;      // with the values
    double total = 0;           // squares
};

struct Cycles {
    Stretch stretch;
    Measured measured;
    std::vector<double> input; // in parts
    double perCycle = 0;       // parts
    double range = 0;          // of the input's samples
};

/// Of samples [begin, end) that oscillate with a period [s]; none where there are too few, or the output does not move.
[[nodiscard]] std::optional<Cycles> cyclesOf(const LoopSeries& series, size_t begin, size_t end, double period);

} // namespace plc::tuning
