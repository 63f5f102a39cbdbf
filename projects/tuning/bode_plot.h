// The Bode plot of a process and of the loops that controllers make with it: gain and phase as charts, with crossover
// and margins marked. Values and functions, any thread.
#pragma once
#include "projects/tuning/loop.h"

#include <array>

namespace plc::tuning {

/// A controller whose loop is drawn.
struct PlottedLoop {
    std::string name;
    ControllerGains gains;
    LoopFigures figures; // analyse() of it
    int colour = 0;
    bool isMarked = false; // crossover and margins
};

/// What is written beside the curves, in the user's language.
struct BodeWords {
    std::string title = "Bode plot", gain = "magnitude [dB]", phase = "phase [°]", frequency = "frequency [rad/s]";
    std::string process = "process", gainMargin = "gain margin", phaseMargin = "phase margin";
};

/// Gain and phase. `delay`: what sampling adds to the dead time [s], as for analyse().
[[nodiscard]] std::array<waveform::Chart, 2> bodeCharts(const ProcessModel& process,
                                                        const std::vector<PlottedLoop>& loops, double delay,
                                                        const BodeWords& words = {});

} // namespace plc::tuning
