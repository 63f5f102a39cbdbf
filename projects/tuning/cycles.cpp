#include "projects/tuning/cycles.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

constexpr size_t kPerCycle = 48, kMostCycles = 10;
constexpr double kLeastCycles = 4;

void sumUp(Measured& measured) {
    measured.base.setZero();
    measured.right.setZero();
    for (size_t i = measured.skip; i < measured.values.size(); ++i) {
        const double time = static_cast<double>(i) / static_cast<double>(measured.values.size());
        const Eigen::Vector2d row(1, time);
        measured.base += row * row.transpose();
        measured.right += row * measured.values[i];
        measured.total += measured.values[i] * measured.values[i];
    }
}

/// Of the process's gain: against that of the controller, which the movements of output and error say.
double processSign(const std::vector<double>& input, const std::vector<double>& error) {
    double ee = 0, ed = 0, dd = 0, eu = 0, du = 0;
    for (size_t i = 1; i < input.size(); ++i) {
        const double moved = input[i] - input[i - 1], change = error[i] - error[i - 1];
        ee += error[i] * error[i], ed += error[i] * change, dd += change * change;
        eu += error[i] * moved, du += change * moved;
    }
    const double size = ee * dd - ed * ed;
    if (!(size > 0)) return 1;
    const double integral = (eu * dd - du * ed) / size, gain = (du * ee - eu * ed) / size;
    // both have the controller's sign; the clearer one decides
    return integral * std::sqrt(ee) + gain * std::sqrt(dd) >= 0 ? 1 : -1;
}

} // namespace

std::vector<double> averaged(const std::vector<double>& values, size_t begin, const Stretch& stretch) {
    std::vector<double> out(stretch.parts);
    for (size_t i = 0; i < stretch.parts; ++i)
        out[i] = meanOf(values, begin + i * stretch.stride, begin + (i + 1) * stretch.stride);
    return out;
}

std::vector<double> responseOf(const std::vector<double>& drive, const LagShape& shape) {
    const double mean = meanOf(drive, 0, drive.size());
    std::vector<double> out(drive.size());
    if (shape.isIntegrating) {
        double sum = 0;
        for (size_t i = 0; i < drive.size(); ++i) out[i] = sum += drive[i] - mean;
        return out;
    }
    for (size_t i = 0; i < drive.size(); ++i) out[i] = drive[i] - mean;
    for (const double share : {1.0, shape.second, shape.third}) {
        constexpr double kNone = 1e-3;
        if (share * shape.lag < kNone) break;
        const double moves = 1 - std::exp(-1 / (share * shape.lag));
        double at = 0;
        for (double& value : out) value = at += moves * (value - at);
    }
    return out;
}

std::vector<double> delayed(const std::vector<double>& values, double delay) {
    std::vector<double> out(values.size());
    for (size_t i = 0; i < values.size(); ++i) {
        const double at = std::max(static_cast<double>(i) - delay, 0.0);
        const auto whole = static_cast<size_t>(at);
        const double share = at - static_cast<double>(whole);
        out[i] = values[whole] + share * (values[std::min(whole + 1, values.size() - 1)] - values[whole]);
    }
    return out;
}

std::optional<Cycles> cyclesOf(const LoopSeries& series, size_t begin, size_t end, double period) {
    if (end <= begin + 1) return std::nullopt;
    const double interval = (series.time[end - 1] - series.time[begin]) / static_cast<double>(end - 1 - begin);
    const double samples = period / interval; // of a cycle
    if (static_cast<double>(end - begin) < kLeastCycles * samples || samples < 8) return std::nullopt;
    Cycles out;
    Stretch& stretch = out.stretch;
    stretch.stride = std::max<size_t>(static_cast<size_t>(samples / kPerCycle), 1);
    out.perCycle = samples / static_cast<double>(stretch.stride);
    const size_t wanted = static_cast<size_t>(static_cast<double>(kMostCycles) * out.perCycle);
    stretch.parts = std::min((end - begin) / stretch.stride, wanted);
    stretch.begin = end - stretch.parts * stretch.stride; // the last cycles: an oscillation grows at first
    Measured& measured = out.measured;
    measured.values = averaged(series.output, stretch.begin, stretch);
    if (!series.setPoint.empty()) {
        const std::vector<double> wantedValue = averaged(series.setPoint, stretch.begin, stretch);
        for (size_t i = 0; i < stretch.parts; ++i) measured.values[i] -= wantedValue[i];
    }
    const double mean = meanOf(measured.values, 0, stretch.parts);
    for (double& value : measured.values) value -= mean;
    measured.skip = static_cast<size_t>(2 * out.perCycle);
    std::vector<double> error = measured.values;
    for (double& value : error) value = -value;
    out.input = averaged(series.input, stretch.begin, stretch);
    measured.sign = processSign(out.input, error);
    sumUp(measured);
    const auto [low, high] = std::minmax_element(out.input.begin(), out.input.end());
    out.range = *high - *low;
    if (!(out.range > 0) || !(measured.total > 0)) return std::nullopt;
    return out;
}

} // namespace plc::tuning
