#include "projects/tuning/health.h"

#include "projects/tuning/errors.h"
#include "projects/tuning/find.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace plc::tuning {

namespace {

/// The control error; without a set point, the distance from the mean.
std::vector<double> errorsOf(const LoopSeries& series) {
    const double mean =
        std::accumulate(series.output.begin(), series.output.end(), 0.0) / static_cast<double>(series.size());
    std::vector<double> out(series.size());
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = (series.setPoint.empty() ? mean : series.setPoint[i]) - series.output[i];
    return out;
}

/// A half wave between two changes of sign that noise does not make.
struct HalfWave {
    size_t begin = 0, end = 0;
    double peak = 0;
};

std::vector<HalfWave> halfWaves(const std::vector<double>& errors, double dead) {
    std::vector<HalfWave> out;
    int sign = 0;
    for (size_t i = 0; i < errors.size(); ++i) {
        const int now = errors[i] > dead ? 1 : errors[i] < -dead ? -1 : 0;
        if (now != 0 && now != sign) {
            if (!out.empty()) out.back().end = i;
            out.push_back({i, errors.size(), 0});
            sign = now;
        }
        if (!out.empty()) out.back().peak = std::max(out.back().peak, std::abs(errors[i]));
    }
    return out;
}

/// The longest row of half waves about as long and as high as each other.
std::pair<size_t, size_t> longestRow(const std::vector<HalfWave>& waves) {
    std::pair<size_t, size_t> best{0, 0};
    size_t begin = 0;
    for (size_t i = 1; i <= waves.size(); ++i) {
        const auto length = [&](size_t k) { return static_cast<double>(waves[k].end - waves[k].begin); };
        constexpr double kAlike = 2.0, kAsHigh = 1.6;
        const auto alike = [&](double a, double b, double factor) { return a < factor * b && b < factor * a; };
        if (i < waves.size() && alike(length(i), length(i - 1), kAlike) &&
            alike(waves[i].peak, waves[i - 1].peak, kAsHigh))
            continue;
        if (i - begin > best.second - best.first) best = {begin, i};
        begin = i;
    }
    return best;
}

/// Mean distance from the middle as a share of the greatest: 0.5 of a triangle, 0.64 of a sine, 1 of a rectangle.
double fullness(const std::vector<double>& values, size_t begin, size_t end) {
    const auto [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                                 values.begin() + static_cast<std::ptrdiff_t>(end));
    const double middle = (*low + *high) / 2, half = (*high - *low) / 2;
    if (half <= 0) return 0;
    double sum = 0;
    for (size_t i = begin; i < end; ++i) sum += std::abs(values[i] - middle);
    return sum / static_cast<double>(end - begin) / half;
}

Cause causeOf(const LoopSeries& series, size_t begin, size_t end, double period, const LoopLimits& limits) {
    // a valve that sticks: the integral moves the output evenly, the process answers in jumps
    if (fullness(series.input, begin, end) < 0.57 && fullness(series.output, begin, end) > 0.72) return Cause::Stiction;
    const double frequency = 2 * std::numbers::pi / period;
    constexpr double kLively = 2.0, kNear = 1.8;
    const bool isLively = limits.sensitivity > kLively && limits.crossover > 0;
    if (isLively && frequency < kNear * limits.crossover && limits.crossover < kNear * frequency) return Cause::Tuning;
    return Cause::Outside;
}

std::optional<OscillationFinding> oscillationOf(const LoopSeries& series, const std::vector<double>& errors,
                                                double noise, const LoopLimits& limits) {
    const auto [low, high] = std::minmax_element(errors.begin(), errors.end());
    const double dead = std::max(3 * noise, 0.01 * (*high - *low));
    const std::vector<HalfWave> waves = halfWaves(errors, dead);
    const auto [begin, end] = longestRow(waves);
    constexpr size_t kLeast = 8; // half waves in a row
    if (end - begin < kLeast) return std::nullopt;
    // the first and the last may be cut off
    const size_t first = waves[begin + 1].begin, last = waves[end - 1].begin;
    const auto count = static_cast<double>(end - begin - 2);
    OscillationFinding out;
    out.period = 2 * (series.time[last] - series.time[first]) / count;
    for (size_t i = begin + 1; i + 1 < end; ++i) out.amplitude += waves[i].peak / count;
    out.cycles = (end - begin) / 2;
    out.cause = causeOf(series, first, last, out.period, limits);
    return out;
}

} // namespace

Health healthOf(const LoopSeries& series, const LoopLimits& limits) {
    Health out;
    const std::vector<double> errors = errorsOf(series);
    out.noise = noiseOf(series.output);
    out.duration = series.time.back() - series.time.front();
    double atLimit = 0, moved = 0;
    for (size_t i = 0; i + 1 < series.size(); ++i) {
        const double step = series.time[i + 1] - series.time[i];
        out.integratedError += std::abs(errors[i]) * step;
        const double input = series.input[i];
        if ((limits.high && input >= *limits.high) || (limits.low && input <= *limits.low)) atLimit += step;
        moved += std::abs(series.input[i + 1] - input);
    }
    if (out.duration > 0) {
        out.timeAtLimit = atLimit / out.duration;
        out.meanError = out.integratedError / out.duration;
        out.effort = moved / out.duration * 3600;
    }
    const double mean =
        std::accumulate(series.output.begin(), series.output.end(), 0.0) / static_cast<double>(series.size());
    double variance = 0;
    for (const double value : series.output) variance += (value - mean) * (value - mean);
    variance /= static_cast<double>(series.size());
    out.noiseShare = variance > 0 ? std::min(out.noise * out.noise / variance, 1.0) : 0;
    out.oscillation = oscillationOf(series, errors, out.noise, limits);
    return out;
}

std::vector<Message> wordsOf(const Health& health) {
    std::vector<Message> out;
    const auto rounded = [](double value) { return std::strtod(numberText(value, 3).c_str(), nullptr); };
    if (const auto& found = health.oscillation) {
        out.push_back(errors::Oscillates(rounded(found->period), rounded(found->amplitude), found->cycles));
        switch (found->cause) {
        case Cause::Tuning:
            out.push_back(errors::CauseTuning());
            break;
        case Cause::Stiction:
            out.push_back(errors::CauseStiction());
            break;
        case Cause::Outside:
            out.push_back(errors::CauseOutside());
            break;
        case Cause::None:
            break;
        }
    } else {
        out.push_back(errors::DoesNotOscillate());
    }
    constexpr double kOften = 0.05;
    if (health.timeAtLimit > kOften)
        out.push_back(errors::OftenAtLimit(static_cast<int64_t>(std::llround(health.timeAtLimit * 100))));
    constexpr double kMuch = 0.2;
    if (health.noiseShare > kMuch)
        out.push_back(errors::MuchNoise(static_cast<int64_t>(std::llround(health.noiseShare * 100))));
    return out;
}

} // namespace plc::tuning
