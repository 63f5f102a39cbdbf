// What lies between two cursors: extremes, mean, RMS, and the step response (rise time, overshoot, settling time).
// Pure C++, any thread. Samples come in blocks and are gone through twice, so nothing is copied.
#pragma once

#include "editor/plot/model/plot_sample.h"

namespace plc::plot {

struct MeasureOptions {
    double riseFrom = 0.1, riseTo = 0.9; // parts of the step
    double settleBand = 0.02;            // part of the step, to either side of the final value
    double finalPart = 0.1;              // the final value is the mean of this last part of the time
    bool isHeld = true;                  // a value holds until the next sample; else crossings are interpolated
};

/// Mean and RMS weigh every sample alike. Times are in nanoseconds.
struct Measurement {
    uint64_t count = 0; // samples that are numbers
    double minimum = 0, maximum = 0, mean = 0, rms = 0;
    double first = 0, last = 0;          // values at the ends
    double initial = 0, final = 0;       // of the step response
    std::optional<int64_t> riseTime;     // first crossing of riseFrom to first crossing of riseTo
    std::optional<double> overshoot;     // beyond the final value, in percent of the step
    std::optional<int64_t> settlingTime; // from the first sample until the value stays in the band
};

[[nodiscard]] Measurement measure(const SampleSource& source, int64_t from, int64_t to,
                                  const MeasureOptions& options = {});

} // namespace plc::plot
