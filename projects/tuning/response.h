// What a loop does: a step of the set point, a step of the load at the process's input, with the controller sampled at
// its task time and limited as it will be; and what that is in figures. Values and functions, any thread.
#pragma once
#include "projects/tuning/loop.h"

namespace plc::tuning {

/// The controller as it will run.
struct SampledController {
    ControllerGains gains;
    double cycle = 0.01; // [s]
    std::optional<double> low, high;
};

struct Trial {
    double setPointStep = 1;
    double loadStep = 1; // at the process's input; 0: none
    double duration = 0; // [s]; 0: as long as the loop needs
};

struct Trajectory {
    double cycle = 0;
    std::vector<double> output, input;
};

struct ResponseFigures {
    double overshoot = 0;       // per cent of the step
    double riseTime = 0;        // 10 to 90 per cent [s]; 0: does not get there
    double settlingTime = 0;    // to stay within 2 per cent [s]; 0: does not
    double integratedError = 0; // of the absolute error [unit s]
    double greatestError = 0;   // after the load step
    double effort = 0;          // sum of all movements of the input
    double greatestInput = 0;   // largest deviation of the input
    double greatestRate = 0;    // of the input [1/s], the step itself left out
    double timeAtLimit = 0;     // share
};

[[nodiscard]] double trialDuration(const ProcessModel& process, const ControllerGains& gains);
[[nodiscard]] Trajectory setPointResponse(const ProcessModel& process, const SampledController& controller,
                                          const Trial& trial);
[[nodiscard]] Trajectory loadResponse(const ProcessModel& process, const SampledController& controller,
                                      const Trial& trial);
/// `target`: where the output should be.
[[nodiscard]] ResponseFigures figuresOf(const Trajectory& trajectory, double target);

/// What Ms and margins mean, for somebody who does not tune every day.
enum class Robustness : uint8_t { Unstable, Fragile, Brisk, Good, Calm };
[[nodiscard]] Robustness robustnessOf(const LoopFigures& figures);

} // namespace plc::tuning
