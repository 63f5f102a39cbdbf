// A signal over time on its way from the store to the pixel: one sample, the extremes of a stretch, a stretch in which
// nothing is known. Column store, trace, panel trends and whoever draws curves pass these on as they are. Values; any
// thread.
#pragma once
#include <cstdint>

namespace plc {

struct SignalSample {
    int64_t time = 0; // nanoseconds
    double value = 0;
    bool operator==(const SignalSample&) const = default;
};

/// First, least, greatest and last value of a span of time. `count` 0: nothing was recorded in it. Values that are not
/// a number count as samples but take no part in minimum and maximum; a bucket of only such has `isNumber` false.
struct SignalBucket {
    double first = 0, minimum = 0, maximum = 0, last = 0;
    uint64_t count = 0;
    bool isNumber = false;
};

struct SignalGap {
    enum class Reason : uint8_t { Evicted, NoPath, SkippedScans, NotRecorded };
    int64_t from = 0, to = 0; // no sample is strictly between
    Reason reason = Reason::NotRecorded;
    bool operator==(const SignalGap&) const = default;
};

} // namespace plc
