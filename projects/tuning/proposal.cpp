#include "projects/tuning/proposal.h"

#include "projects/tuning/model/errors.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

double samplingDelay(double cycle) { return cycle / 2; }

Assessment assess(const ProcessModel& process, const ControllerGains& gains, const LoopConditions& conditions) {
    Assessment out;
    out.gains = gains;
    out.figures = analyse(process, gains, samplingDelay(conditions.cycle));
    Trial trial;
    trial.duration = conditions.duration > 0 ? conditions.duration : trialDuration(process, gains);
    SampledController controller{gains, conditions.cycle, {}, {}};
    // a long trial of a quick task: a coarser controller shows the same
    constexpr double kMost = 20'000;
    controller.cycle = std::max(conditions.cycle, trial.duration / kMost);
    out.setPointTrajectory = setPointResponse(process, controller, trial);
    out.loadTrajectory = loadResponse(process, controller, trial);
    out.setPoint = figuresOf(out.setPointTrajectory, 1);
    out.load = figuresOf(out.loadTrajectory, 0);
    // what swings up because it is sampled
    constexpr double kSwungUp = 1000; // per cent
    if (!(out.setPoint.overshoot < kSwungUp)) out.figures.isStable = false;
    const double filter = gains.filterTime + conditions.cycle;
    out.noise =
        conditions.noise * std::abs(gains.gain * (1 + (gains.derivativeTime > 0 ? gains.derivativeTime / filter : 0)));
    return out;
}

Message robustnessWords(const Assessment& assessment) {
    switch (robustnessOf(assessment.figures)) {
    case Robustness::Unstable:
        return errors::LoopUnstable();
    case Robustness::Fragile:
        return errors::LoopFragile();
    case Robustness::Brisk:
        return errors::LoopBrisk();
    case Robustness::Good:
        return errors::LoopGood();
    case Robustness::Calm:
        return errors::LoopCalm();
    }
    return {};
}

Message overshootWords(const Assessment& assessment) {
    const auto percent = static_cast<int64_t>(std::llround(assessment.setPoint.overshoot));
    return percent < 1 ? errors::NoOvershoot() : errors::Overshoots(percent);
}

Message cautionOf(Rule rule) {
    switch (rule) {
    case Rule::ZieglerNichols:
        return errors::ZieglerNicholsCaution();
    case Rule::ChienHronesReswick:
        return errors::ChienHronesReswickCaution();
    case Rule::Simc:
    case Rule::Amigo:
    case Rule::Optimum:
        return {};
    }
    return {};
}

} // namespace plc::tuning
