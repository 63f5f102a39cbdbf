// Limits, ticks and texts of axes: round numbers, times in the unit that suits their span. Pure functions, any thread.
#pragma once

#include <QString>

#include <cstdint>
#include <vector>

namespace plc::plot {

struct PlotTick {
    double value = 0;
    QString label;
};

/// The next of 1, 2, 5 times a power of ten at or above `step`.
double roundStep(double step);
/// Widens [low, high] to multiples of a round step; a flat range gets room on both sides.
void roundLimits(double& low, double& high, int wantedTicks);
/// Ticks at round numbers within the limits, at most `most` of them.
std::vector<PlotTick> numberTicks(double low, double high, int most);

/// Time steps: 1, 2, 5 times a power of ten below a minute, then 10, 15, 30 s, 1, 2, 5 … min, h, days.
int64_t roundTimeStep(int64_t step);
struct TimeTicks {
    int64_t step = 0;
    QString unit;                                   // "s", "ms", "min:s", "h:min:s"
    std::vector<std::pair<int64_t, QString>> ticks; // time and label; times count from `origin`
};
TimeTicks timeTicks(int64_t from, int64_t to, int64_t origin, int most);
/// Label width to expect, for choosing how many ticks fit.
QString widestTimeLabel(int64_t from, int64_t to, int64_t origin, int64_t step);

/// A value for reading: at most `digits` significant ones, no trailing zeros, exponents only where needed.
QString valueText(double value, int digits = 6);
/// A duration for reading, in the unit that suits it: "12.5 ms", "3.20 s", "2 min 5 s".
QString durationText(int64_t nanoseconds);
/// A moment on the axis with the exactness of nanoseconds: "12.345 s", "1:02:03.5".
QString momentText(int64_t nanoseconds);
QString frequencyText(int64_t period);

} // namespace plc::plot
