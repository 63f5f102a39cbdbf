#include "projects/tuning/loop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace plc::tuning {

namespace {
constexpr double kPi = std::numbers::pi;
}

Complex ControllerGains::at(double omega) const {
    const Complex s(0, omega);
    Complex value = 1;
    if (integralTime > 0) value += 1.0 / (integralTime * s);
    if (derivativeTime > 0) value += derivativeTime * s / (filterTime * s + 1.0);
    return gain * value;
}

std::vector<double> logSpace(double from, double to, size_t points) {
    std::vector<double> out(points);
    const double step = std::log(to / from) / static_cast<double>(points - 1);
    for (size_t i = 0; i < points; ++i) out[i] = from * std::exp(step * static_cast<double>(i));
    return out;
}

std::pair<double, double> frequencyRange(const ProcessModel& process) {
    double quickest = process.deadTime > 0 ? process.deadTime : process.timeScale();
    for (const double lag : process.lags) quickest = std::min(quickest, std::max(lag, process.timeScale() * 1e-3));
    if (process.oscillation) quickest = std::min(quickest, 1 / process.oscillation->frequency);
    return {1e-3 / process.timeScale(), 300 / quickest};
}

std::vector<double> frequenciesFor(const ProcessModel& process, size_t points) {
    const auto [low, high] = frequencyRange(process);
    std::vector<double> out = logSpace(low, high, points);
    if (!process.oscillation) return out;
    const auto& [frequency, damping] = *process.oscillation;
    constexpr int kBeside = 120; // on each side, at distances from a hundredth to ten times the width of the peak
    for (int i = 0; i <= kBeside; ++i)
        for (const double side : {-1.0, 1.0}) {
            const double at = frequency * (1 + side * damping * 0.01 * std::pow(1e3, static_cast<double>(i) / kBeside));
            if (at > low && at < high) out.push_back(at);
        }
    out.push_back(frequency);
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<BodePoint> bode(const Response& response, double from, double to, size_t points) {
    std::vector<BodePoint> out;
    double turns = 0, before = 0;
    for (const double omega : logSpace(from, to, points)) {
        const Complex value = response(omega);
        const double angle = std::arg(value);
        if (!out.empty()) turns -= std::round((angle - before) / (2 * kPi));
        before = angle;
        out.push_back({omega, 20 * std::log10(std::abs(value)), (angle + turns * 2 * kPi) * 180 / kPi});
    }
    return out;
}

namespace {

/// Frequencies dense enough that the phase of the loop turns by less than a fifth of a radian between two.
std::vector<double> frequencies(const ProcessModel& process, double delay) {
    std::vector<double> out = frequenciesFor(process, 1500);
    const double dead = process.deadTime + delay;
    if (dead <= 0) return out;
    std::vector<double> fine;
    for (size_t i = 0; i + 1 < out.size(); ++i) {
        const double width = out[i + 1] - out[i];
        const int parts = static_cast<int>(std::min(std::ceil(width * dead / 0.2), 50.0));
        for (int k = 0; k < std::max(parts, 1); ++k) fine.push_back(out[i] + width * k / std::max(parts, 1));
    }
    fine.push_back(out.back());
    return fine;
}

/// Where `value` changes its sign between a and b.
template <class Value> double crossing(double a, double b, const Value& value) {
    bool isUp = value(a) < 0;
    for (int i = 0; i < 60; ++i) {
        const double middle = std::sqrt(a * b);
        ((value(middle) < 0) == isUp ? a : b) = middle;
    }
    return std::sqrt(a * b);
}

/// The greatest of `value` near the sampled one, by golden section on a logarithmic axis.
template <class Value> double greatestNear(double a, double b, const Value& value) {
    constexpr double kRatio = 0.6180339887498949;
    double low = std::log(a), high = std::log(b);
    for (int i = 0; i < 60; ++i) {
        const double left = high - kRatio * (high - low), right = low + kRatio * (high - low);
        (value(std::exp(left)) > value(std::exp(right)) ? high : low) =
            value(std::exp(left)) > value(std::exp(right)) ? right : left;
    }
    return value(std::exp((low + high) / 2));
}

} // namespace

LoopFigures analyse(const ProcessModel& process, const ControllerGains& controller, double delay) {
    const auto loop = [&](double omega) {
        return process.at(omega) * controller.at(omega) * std::exp(Complex(0, -delay * omega));
    };
    const auto sensitivityAt = [&](double omega) { return 1 / std::abs(1.0 + loop(omega)); };
    const auto complementaryAt = [&](double omega) { return std::abs(loop(omega) / (1.0 + loop(omega))); };
    const std::vector<double> omegas = frequencies(process, delay);
    std::vector<Complex> values(omegas.size());
    for (size_t i = 0; i < omegas.size(); ++i) values[i] = loop(omegas[i]);
    LoopFigures out;
    size_t worst = 0, worstT = 0;
    double turn = 0; // of 1 + L
    double phase = 0;
    out.gainMargin = out.phaseMargin = out.delayMargin = std::numeric_limits<double>::infinity();
    // the phase at the start: integrators count -90 degrees each, a negative gain makes the loop unstable
    phase = std::arg(values[0]);
    if (phase > kPi / 2 + 0.3) phase -= 2 * kPi;
    for (size_t i = 0; i < values.size(); ++i) {
        if (std::abs(1.0 + values[i]) < std::abs(1.0 + values[worst])) worst = i;
        if (std::abs(values[i] / (1.0 + values[i])) > std::abs(values[worstT] / (1.0 + values[worstT]))) worstT = i;
        if (i == 0) continue;
        turn += std::arg((1.0 + values[i]) / (1.0 + values[i - 1]));
        const double before = phase;
        phase += std::arg(values[i] / values[i - 1]);
        if ((std::abs(values[i - 1]) - 1) * (std::abs(values[i]) - 1) <= 0 && std::abs(values[i - 1]) != 1) {
            const double at = crossing(omegas[i - 1], omegas[i], [&](double w) { return std::abs(loop(w)) - 1; });
            const double margin = 180 + (before + std::arg(loop(at) / values[i - 1])) * 180 / kPi; // of this crossing
            if (out.crossover == 0) out.crossover = at;
            if (margin < out.phaseMargin) out.phaseMargin = margin, out.phaseMarginAt = at;
            out.delayMargin = std::min(out.delayMargin, margin / 180 * kPi / at);
        }
        if (std::imag(values[i - 1]) * std::imag(values[i]) <= 0 && std::real(values[i]) < 0 &&
            std::abs(std::arg(values[i] / values[i - 1])) < 1) {
            const double at = crossing(omegas[i - 1], omegas[i], [&](double w) { return std::imag(loop(w)); });
            const double size = std::abs(loop(at));
            if (size < 1 && 1 / size < out.gainMargin) out.gainMargin = 1 / size, out.gainMarginAt = at;
        }
    }
    const auto refine = [&](size_t i, const auto& value) {
        return greatestNear(omegas[i > 0 ? i - 1 : 0], omegas[std::min(i + 1, omegas.size() - 1)], value);
    };
    out.sensitivity = std::max(1.0, refine(worst, sensitivityAt));
    out.complementary = refine(worstT, complementaryAt);
    // Nyquist: from -90 degrees per integrator the vector 1 + L must come back to 1, without a whole turn
    const int integrators = (process.isIntegrating ? 1 : 0) + (controller.integralTime > 0 ? 1 : 0);
    const double first = std::arg(1.0 + values[0]);
    const double wanted = std::arg(1.0 + values.back()) - (integrators == 2 && first > 0 ? first - 2 * kPi : first);
    out.isStable = std::abs(turn - wanted) < kPi && process.gain * controller.gain > 0;
    const double filter = controller.filterTime;
    out.noiseGain = controller.gain * (1 + (filter > 0 ? controller.derivativeTime / filter : 0));
    return out;
}

} // namespace plc::tuning
