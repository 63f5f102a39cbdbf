#include "projects/tuning/optimum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace plc::tuning {

namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

/// Greatest of a function of one variable on [low, high]: a grid, then golden section around its best point.
template <class Value> std::pair<double, double> greatest(double low, double high, int points, const Value& value) {
    double best = low, bestValue = kNone;
    const double step = (high - low) / points;
    for (int i = 0; i <= points; ++i) {
        const double at = low + step * i, now = value(at);
        if (now > bestValue) best = at, bestValue = now;
    }
    constexpr double kRatio = 0.6180339887498949;
    double a = std::max(low, best - step), b = std::min(high, best + step);
    double left = b - kRatio * (b - a), right = a + kRatio * (b - a);
    double ofLeft = value(left), ofRight = value(right);
    for (int i = 0; i < 50; ++i) {
        if (ofLeft > ofRight) {
            b = right, right = left, ofRight = ofLeft;
            left = b - kRatio * (b - a), ofLeft = value(left);
        } else {
            a = left, left = right, ofLeft = ofRight;
            right = a + kRatio * (b - a), ofRight = value(right);
        }
    }
    const double at = (a + b) / 2, now = value(at);
    return now >= bestValue ? std::pair(at, now) : std::pair(best, bestValue);
}

/// The process, its gain turned positive, with what sampling adds.
class Plant {
public:
    Plant(const ProcessModel& process, double delay, double sensitivity)
        : m_process(process), m_distance(1 / sensitivity) {
        if (m_process.gain < 0) m_process.gain = -m_process.gain;
        m_process.deadTime += delay;
        // beyond the second time that the phase passes -180 degrees nothing is decided
        m_omegas = frequenciesFor(m_process, 1200);
        for (const double omega : m_omegas) m_values.push_back(m_process.at(omega));
    }

    /// For this proportional gain: the greatest integral gain with 1 + L nowhere nearer to 0 than 1/Ms; the points that
    /// are too near form an ellipse in the plane of both gains for each frequency.
    [[nodiscard]] double greatestIntegral(double gain) const {
        size_t best = m_omegas.size();
        double least = std::numeric_limits<double>::infinity();
        for (size_t i = 0; i < m_omegas.size(); ++i) {
            const double value = bound(m_omegas[i], m_values[i], gain);
            if (value < least) least = value, best = i;
        }
        if (best == m_omegas.size()) return kNone; // no bound at all: nothing limits the loop
        const double low = std::log(m_omegas[best > 0 ? best - 1 : 0]);
        const double high = std::log(m_omegas[std::min(best + 1, m_omegas.size() - 1)]);
        const auto near = greatest(low, high, 4, [&](double at) {
            const double omega = std::exp(at);
            return -bound(omega, m_process.at(omega), gain);
        });
        return std::min(least, -near.second);
    }
    /// The greatest proportional gain without an integral part.
    [[nodiscard]] double greatestGain() const {
        double least = std::numeric_limits<double>::infinity();
        for (const Complex& value : m_values) {
            const double a = value.real(), size = std::norm(value);
            const double root = a * a - size * (1 - m_distance * m_distance);
            if (a < 0 && root >= 0) least = std::min(least, (-a - std::sqrt(root)) / size);
        }
        return least;
    }
    [[nodiscard]] const ProcessModel& process() const { return m_process; }
    [[nodiscard]] const std::vector<double>& omegas() const { return m_omegas; }
    [[nodiscard]] const std::vector<Complex>& values() const { return m_values; }
    [[nodiscard]] double distance() const { return m_distance; }

    /// The same where a process that oscillates leaves room above an ellipse that a smaller integral gain is in: the
    /// uppermost room that is stable, if it is more than `least`.
    [[nodiscard]] double greatestAbove(double gain, double least) const {
        std::vector<std::pair<double, double>> near;
        for (size_t i = 0; i < m_omegas.size(); ++i) {
            const auto [low, high] = edges(m_omegas[i], m_values[i], gain);
            if (low < high && high > 0) near.emplace_back(low, high);
        }
        std::sort(near.begin(), near.end());
        constexpr double kRoom = 1.02; // narrower, it is between two frequencies
        std::vector<double> rooms;     // their upper ends
        double covered = least;
        for (const auto& [low, high] : near) {
            if (low > covered * kRoom) rooms.push_back(low);
            covered = std::max(covered, high);
        }
        for (auto top = rooms.rbegin(); top != rooms.rend(); ++top) {
            const LoopFigures figures = analyse(m_process, {gain, gain / *top, 0, 0});
            if (figures.isStable && figures.sensitivity * m_distance < 1.002) return *top;
        }
        return kNone;
    }

private:
    /// Of the ellipse at this proportional gain; the same value twice where it has no points.
    [[nodiscard]] std::pair<double, double> edges(double omega, const Complex& value, double gain) const {
        const double a = value.real(), b = value.imag(), size = std::norm(value);
        const double inside = m_distance * m_distance * size - (a + size * gain) * (a + size * gain);
        if (inside < 0) return {kNone, kNone};
        return {omega * (-b - std::sqrt(inside)) / size, omega * (-b + std::sqrt(inside)) / size};
    }
    /// The lower edge, where some of the ellipse is above 0.
    [[nodiscard]] double bound(double omega, const Complex& value, double gain) const {
        const auto [low, high] = edges(omega, value, gain);
        return low < high && high >= 0 ? low : std::numeric_limits<double>::infinity();
    }
    ProcessModel m_process;
    double m_distance;
    std::vector<double> m_omegas;
    std::vector<Complex> m_values;
};

ControllerGains signedAs(const ProcessModel& process, ControllerGains gains) {
    if (process.gain < 0) gains.gain = -gains.gain;
    return gains;
}

std::optional<ControllerGains> proportional(const Plant& plant) {
    const double gain = plant.greatestGain();
    if (!std::isfinite(gain)) return std::nullopt;
    return ControllerGains{gain, 0, 0, 0};
}

std::optional<ControllerGains> withIntegral(const Plant& plant) {
    const double limit = plant.greatestGain();
    if (!std::isfinite(limit)) return std::nullopt; // a first-order process without dead time takes any gain
    auto [gain, integral] = greatest(0, limit, 300, [&](double gain) { return plant.greatestIntegral(gain); });
    if (plant.process().oscillation) {
        const double least = std::max(integral, 0.0);
        constexpr double kBeyond = 3; // times what a proportional gain alone may be
        constexpr int kPoints = 60;
        const auto above = greatest(limit * kBeyond / kPoints, limit * kBeyond, kPoints,
                                    [&](double gain) { return plant.greatestAbove(gain, least); });
        if (above.second > least) std::tie(gain, integral) = above;
    }
    if (!(integral > 0) || !(gain > 0)) {
        if (!(integral > 0)) return std::nullopt;
        // all integral: a trace of gain keeps the standard form
        const double least = limit * 1e-6;
        return ControllerGains{least, least / integral, 0, 0};
    }
    return ControllerGains{gain, gain / integral, 0, 0};
}

/// Largest factor of the loop that keeps its distance from -1.
double greatestFactor(const Plant& plant, const std::vector<Complex>& loop) {
    double least = std::numeric_limits<double>::infinity();
    for (const Complex& value : loop) {
        const double a = value.real(), size = std::norm(value);
        const double root = a * a - size * (1 - plant.distance() * plant.distance());
        if (a < 0 && root >= 0) least = std::min(least, (-a - std::sqrt(root)) / size);
    }
    return least;
}

constexpr double kFilterShare = 0.1; // of the derivative time

/// Both zeros of the controller together (integral time four times the derivative time): the form that keeps an
/// optimum from turning into one that only just does not oscillate.
std::optional<ControllerGains> withDerivative(const Plant& plant) {
    const double scale = plant.process().timeScale();
    const auto gainsFor = [](double logTime, double integral) {
        const double half = std::exp(logTime); // of both zeros
        return ControllerGains{integral * 2 * half, 2 * half, half / 2, half / 2 * kFilterShare};
    };
    std::vector<Complex> loop(plant.omegas().size());
    const auto integralFor = [&](double logTime) {
        const ControllerGains unit = gainsFor(logTime, 1);
        for (size_t i = 0; i < loop.size(); ++i) loop[i] = plant.values()[i] * unit.at(plant.omegas()[i]);
        const double factor = greatestFactor(plant, loop);
        return std::isfinite(factor) ? factor : kNone;
    };
    const auto [at, integral] = greatest(std::log(scale * 1e-3), std::log(scale * 10), 200, integralFor);
    if (!(integral > 0)) return std::nullopt;
    return gainsFor(at, integral);
}

} // namespace

std::optional<ControllerGains> optimum(const ProcessModel& process, ControllerKind kind, double sensitivity,
                                       double delay) {
    const Plant plant(process, delay, sensitivity);
    std::optional<ControllerGains> found;
    switch (kind) {
    case ControllerKind::P:
        found = proportional(plant);
        break;
    case ControllerKind::Pi:
        found = withIntegral(plant);
        break;
    case ControllerKind::Pid:
        found = withDerivative(plant);
        break;
    }
    if (!found) return found;
    return signedAs(process, *found);
}

} // namespace plc::tuning
