#include "projects/tuning/response.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

/// The standard form, sampled: backward differences, the integral held at a limit.
class Controller {
public:
    explicit Controller(const SampledController& settings) : m(settings) {}
    double next(double error) {
        const ControllerGains& g = m.gains;
        const double proportional = g.gain * error;
        if (g.derivativeTime > 0)
            m_derivative = (g.filterTime * m_derivative + g.gain * g.derivativeTime * (error - m_before)) /
                           (g.filterTime + m.cycle);
        m_before = error;
        const double increment = g.integralTime > 0 ? proportional * m.cycle / g.integralTime : 0;
        const double sum = proportional + m_integral + increment + m_derivative;
        const bool isHeld = (m.high && sum >= *m.high && increment > 0) || (m.low && sum <= *m.low && increment < 0);
        if (!isHeld) m_integral += increment;
        return std::clamp(sum, m.low.value_or(-1e300), m.high.value_or(1e300));
    }

private:
    const SampledController& m;
    double m_integral = 0, m_derivative = 0, m_before = 0;
};

Trajectory run(const ProcessModel& process, const SampledController& controller, double setPoint, double load,
               double duration) {
    constexpr size_t kMost = 200'000;
    const auto count = static_cast<size_t>(std::clamp(duration / controller.cycle, 20.0, static_cast<double>(kMost)));
    SampledProcess sampled(process, controller.cycle);
    Controller block(controller);
    Trajectory out{controller.cycle, {}, {}};
    for (size_t i = 0; i < count; ++i) {
        out.output.push_back(sampled.output());
        out.input.push_back(block.next(setPoint - sampled.output()));
        sampled.advance(out.input.back() + load);
    }
    return out;
}

} // namespace

double trialDuration(const ProcessModel& process, const ControllerGains& gains) {
    return std::max({12 * process.timeScale(), 6 * gains.integralTime, 20 * process.deadTime});
}

Trajectory setPointResponse(const ProcessModel& process, const SampledController& controller, const Trial& trial) {
    const double duration = trial.duration > 0 ? trial.duration : trialDuration(process, controller.gains);
    return run(process, controller, trial.setPointStep, 0, duration);
}

Trajectory loadResponse(const ProcessModel& process, const SampledController& controller, const Trial& trial) {
    const double duration = trial.duration > 0 ? trial.duration : trialDuration(process, controller.gains);
    return run(process, controller, 0, trial.loadStep, duration);
}

ResponseFigures figuresOf(const Trajectory& trajectory, double target) {
    ResponseFigures out;
    const double cycle = trajectory.cycle;
    const size_t count = trajectory.output.size();
    double greatest = 0, at10 = -1, at90 = -1, worst = 0;
    for (const double value : trajectory.output) worst = std::max(worst, std::abs(target - value));
    const double band = target != 0 ? 0.02 * std::abs(target) : 0.02 * worst;
    size_t outside = 0;
    for (size_t i = 0; i < count; ++i) {
        const double value = trajectory.output[i], error = target - value;
        out.integratedError += std::abs(error) * cycle;
        out.greatestError = std::max(out.greatestError, std::abs(error));
        if (std::abs(error) > band) outside = i + 1;
        const double input = trajectory.input[i];
        out.greatestInput = std::max(out.greatestInput, std::abs(input));
        const double move = std::abs(input - (i > 0 ? trajectory.input[i - 1] : 0));
        out.effort += move;
        if (i > 1) out.greatestRate = std::max(out.greatestRate, move / cycle);
        if (target == 0) continue;
        const double share = value / target;
        greatest = std::max(greatest, share);
        if (at10 < 0 && share >= 0.1) at10 = static_cast<double>(i) * cycle;
        if (at90 < 0 && share >= 0.9) at90 = static_cast<double>(i) * cycle;
    }
    out.overshoot = target != 0 ? std::max(greatest - 1, 0.0) * 100 : 0;
    if (at90 >= 0) out.riseTime = at90 - at10;
    if (outside < count) out.settlingTime = static_cast<double>(outside) * cycle;
    return out;
}

Robustness robustnessOf(const LoopFigures& figures) {
    if (!figures.isStable) return Robustness::Unstable;
    if (figures.sensitivity > 2.1) return Robustness::Fragile;
    if (figures.sensitivity > 1.75) return Robustness::Brisk;
    if (figures.sensitivity > 1.35) return Robustness::Good;
    return Robustness::Calm;
}

} // namespace plc::tuning
