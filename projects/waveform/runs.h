// Many runs of the same thing laid over each other: each begins where a trigger fired. Functions, any thread.
#pragma once
#include "projects/waveform/samples.h"

namespace plc::waveform {

struct Run {
    double start = 0; // when its trigger fired [s]
    Samples samples;  // times count from there
};

/// Runs from `before` ahead of each start to `after` behind it; one whose end is not recorded stays as it is, one
/// without any sample is left out.
[[nodiscard]] std::vector<Run> alignedRuns(const Samples& samples, const std::vector<double>& starts, double before,
                                           double after);

/// Least, greatest and mean of all runs at each instant of an even grid: where they agree and where not.
struct RunBand {
    std::vector<double> time, least, greatest, mean;
    double widest = 0, widestAt = 0; // the greatest distance of two runs, and when
};
[[nodiscard]] RunBand bandOf(const std::vector<Run>& runs, size_t points);

} // namespace plc::waveform
