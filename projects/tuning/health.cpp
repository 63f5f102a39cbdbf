#include "projects/tuning/health.h"

#include "projects/tuning/model/errors.h"
#include "projects/tuning/model/find.h"
#include "projects/tuning/valve_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Where the error is but for a twentieth of the time on each side, and at most.
struct Band {
    double low = 0, high = 0, least = 0, greatest = 0;
};

Band bandOf(std::vector<double> errors) {
    Band out;
    const auto [least, greatest] = std::minmax_element(errors.begin(), errors.end());
    out.least = *least, out.greatest = *greatest;
    const auto at = [&](size_t i) {
        std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(i), errors.end());
        return errors[i];
    };
    out.low = at(errors.size() / 20);
    out.high = at(errors.size() - 1 - errors.size() / 20);
    return out;
}

/// A half wave between two changes of sign that noise does not make.
struct HalfWave {
    size_t begin = 0, end = 0;
    double peak = 0;
};

std::vector<HalfWave> halfWaves(const std::vector<double>& errors, double dead, double middle = 0) {
    std::vector<HalfWave> out;
    int sign = 0;
    for (size_t i = 0; i < errors.size(); ++i) {
        const double away = errors[i] - middle;
        const int now = away > dead ? 1 : away < -dead ? -1 : 0;
        if (now != 0 && now != sign) {
            if (!out.empty()) out.back().end = i;
            out.push_back({i, errors.size(), 0});
            sign = now;
        }
        if (!out.empty()) out.back().peak = std::max(out.back().peak, std::abs(away));
    }
    return out;
}

/// The longest row of half waves about as long and as high as those on the same side before them: a valve that sticks
/// may stay on one side for longer than on the other.
std::pair<size_t, size_t> longestRow(const std::vector<HalfWave>& waves) {
    std::pair<size_t, size_t> best{0, 0};
    size_t begin = 0;
    for (size_t i = 2; i <= waves.size(); ++i) {
        const auto length = [&](size_t k) { return static_cast<double>(waves[k].end - waves[k].begin); };
        constexpr double kAlike = 2.0, kAsHigh = 1.6;
        const auto alike = [&](double a, double b, double factor) { return a < factor * b && b < factor * a; };
        if (i < waves.size() && alike(length(i), length(i - 2), kAlike) &&
            alike(waves[i].peak, waves[i - 2].peak, kAsHigh))
            continue;
        if (i - begin > best.second - best.first) best = {begin, i};
        begin = i - 1;
    }
    return best;
}

/// A valve with friction explains much better what the process does than one without, which explains little enough by
/// itself: what harmonics from outside leave to both is more. Limits chosen on loops by chance, others than those of
/// tests/projects/tuning/health_test.cpp.
bool mayStick(const ValveFit& fit) {
    constexpr double kBetter = 2, kUnexplained = 0.005, kExplained = 0.1;
    return fit.gain() >= kBetter && fit.without > kUnexplained + 3 * fit.noise && fit.with < kExplained;
}

/// A sawtooth or a triangle from outside makes the output move to and fro in ramps too, and a valve with friction
/// explains that in part: what explains it better is to blame, where the difference is clear. The search for the
/// friction is the harder one and may miss the best by a little.
Cause ofValve(const ValveFit& fit) {
    constexpr double kAsGood = 1.5, kClearlyWorse = 3;
    if (fit.with <= kAsGood * fit.wave) return Cause::Stiction;
    return fit.with <= kClearlyWorse * fit.wave ? Cause::StictionOrOutside : Cause::Outside;
}

/// A loop that its settings make oscillate swings where its model says so; a valve that sticks moves in jumps, which a
/// process behind friction explains and one without does not; the rest comes from outside.
Cause causeOf(const LoopSeries& series, size_t begin, size_t end, double period, const LoopLimits& limits) {
    const double frequency = 2 * std::numbers::pi / period;
    constexpr double kLively = 2.0, kAtTheEdge = 5.0, kNear = 1.8;
    const bool isNear =
        limits.crossover > 0 && frequency < kNear * limits.crossover && limits.crossover < kNear * frequency;
    if (isNear && limits.sensitivity > kAtTheEdge) return Cause::Tuning;
    if (const auto fit = fitValve(series, begin, end, period); fit && mayStick(*fit))
        if (const Cause cause = ofValve(*fit); cause != Cause::Outside || !isNear) return cause;
    if (isNear && limits.sensitivity > kLively) return Cause::Tuning;
    return Cause::Outside;
}

std::optional<OscillationFinding> oscillationOf(const LoopSeries& series, const std::vector<double>& errors,
                                                double noise, const LoopLimits& limits) {
    const Band band = bandOf(errors);
    const double dead = std::max({3 * noise, 0.05 * (band.high - band.low), 0.002 * (band.greatest - band.least)});
    // an offset of a controller without integral part
    const bool isAround = band.low <= 0 && band.high >= 0;
    const std::vector<HalfWave> waves = halfWaves(errors, dead, isAround ? 0 : (band.low + band.high) / 2);
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

LoopLimits limitsOf(const LoopSeries& series, const std::optional<LoopFigures>& now) {
    LoopLimits out{series.low, series.high, 0, 0};
    if (!now) return out;
    out.sensitivity = now->isStable ? now->sensitivity : std::numeric_limits<double>::infinity();
    out.crossover = now->crossover;
    return out;
}

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
        case Cause::StictionOrOutside:
            out.push_back(errors::CauseStictionOrOutside());
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
