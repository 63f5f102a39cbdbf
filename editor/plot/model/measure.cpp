#include "editor/plot/model/measure.h"

#include <algorithm>
#include <cmath>

namespace plc::plot {

namespace {

/// First pass: everything but the step response, which needs the final value.
struct Sums {
    Measurement m;
    int64_t firstTime = 0, finalFrom = 0;
    double mean = 0, squares = 0, finalSum = 0;
    uint64_t finalCount = 0;

    void add(const SignalSample& s) {
        if (std::isnan(s.value)) return;
        if (m.count++ == 0) {
            m.minimum = m.maximum = m.first = s.value;
            firstTime = s.time;
        }
        m.minimum = std::min(m.minimum, s.value);
        m.maximum = std::max(m.maximum, s.value);
        m.last = s.value;
        const double n = static_cast<double>(m.count);
        mean += (s.value - mean) / n;
        squares += (s.value * s.value - squares) / n;
        if (s.time < finalFrom) return;
        finalSum += s.value;
        ++finalCount;
    }
};

/// Second pass: crossings and the band.
struct StepResponse {
    const MeasureOptions& options;
    double initial, step; // the way from the initial to the final value
    int64_t firstTime;
    std::optional<int64_t> lowAt, highAt, settledAt;
    double beyond = 0; // greatest part past the final value
    bool any = false;
    int64_t beforeTime = 0;
    double before = 0; // part of the step at the sample before

    int64_t crossing(double level, int64_t time, double part) const {
        if (options.isHeld || !any || part == before) return time;
        const double share = (level - before) / (part - before);
        return beforeTime + static_cast<int64_t>(std::llround(share * static_cast<double>(time - beforeTime)));
    }
    void add(const SignalSample& s) {
        if (std::isnan(s.value)) return;
        const double part = (s.value - initial) / step;
        if (!lowAt && part >= options.riseFrom) lowAt = crossing(options.riseFrom, s.time, part);
        if (!highAt && part >= options.riseTo) highAt = crossing(options.riseTo, s.time, part);
        beyond = std::max(beyond, part - 1);
        const bool inBand = std::abs(part - 1) <= options.settleBand;
        if (!inBand)
            settledAt.reset();
        else if (!settledAt)
            settledAt = s.time;
        any = true;
        before = part;
        beforeTime = s.time;
    }
};

} // namespace

Measurement measure(const SampleSource& source, int64_t from, int64_t to, const MeasureOptions& options) {
    if (from > to) std::swap(from, to);
    const int64_t end = to + 1; // both cursors lie on samples: the interval has both ends
    Sums sums;
    sums.finalFrom = to - static_cast<int64_t>(static_cast<double>(to - from) * options.finalPart);
    source.visit(from, end, [&](std::span<const SignalSample> block) {
        for (const SignalSample& s : block) sums.add(s);
    });
    Measurement& m = sums.m;
    if (m.count == 0) return m;
    m.mean = std::abs(sums.mean) < 1e-13 * std::max(std::abs(m.minimum), std::abs(m.maximum))
                 ? 0
                 : sums.mean; // rounding of many sums
    m.rms = std::sqrt(sums.squares);
    m.initial = m.first;
    m.final = sums.finalCount > 0 ? sums.finalSum / static_cast<double>(sums.finalCount) : m.last;
    const double step = m.final - m.initial, size = std::max(std::abs(m.final), std::abs(m.initial));
    // What ends about where it began has no step, whatever it did in between.
    if (m.count < 3 || std::abs(step) <= 1e-9 * size || std::abs(step) < 0.02 * (m.maximum - m.minimum) ||
        !std::isfinite(step))
        return m;

    StepResponse response{options, m.initial, step, sums.firstTime, {}, {}, {}};
    source.visit(from, end, [&](std::span<const SignalSample> block) {
        for (const SignalSample& s : block) response.add(s);
    });
    if (response.lowAt && response.highAt && *response.highAt >= *response.lowAt)
        m.riseTime = *response.highAt - *response.lowAt;
    m.overshoot = response.beyond * 100;
    if (response.settledAt) m.settlingTime = *response.settledAt - sums.firstTime;
    return m;
}

} // namespace plc::plot
