// Settings for a loop with everything that is to be known of them before they are written: margins, responses, what
// that means in plain words. Values and functions, any thread.
#pragma once
#include "projects/tuning/model/find.h"
#include "projects/tuning/response.h"
#include "projects/tuning/rules.h"

namespace plc::tuning {

struct Assessment {
    ControllerGains gains;
    LoopFigures figures;
    Trajectory setPointTrajectory, loadTrajectory;
    ResponseFigures setPoint, load;
    double noise = 0; // standard deviation of the input that the measured noise makes
};

struct LoopConditions {
    double cycle = 0.01; // [s]
    double noise = 0;    // standard deviation of the output
    double duration = 0; // of the responses, 0: as long as needed
};

[[nodiscard]] Assessment assess(const ProcessModel& process, const ControllerGains& gains,
                                const LoopConditions& conditions);
/// What sampling adds to the dead time: on average half a cycle.
[[nodiscard]] double samplingDelay(double cycle);

/// "Calm: …", one sentence about the robustness, one about the speed.
[[nodiscard]] Message robustnessWords(const Assessment& assessment);
[[nodiscard]] Message overshootWords(const Assessment& assessment);
/// What speaks against a rule, empty for the others.
[[nodiscard]] Message cautionOf(Rule rule);

} // namespace plc::tuning
