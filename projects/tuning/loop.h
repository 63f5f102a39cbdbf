// A loop of process and controller in the frequency domain: sensitivity, margins, the points of a Bode plot; and the
// controller's gains as every rule speaks of them. Values and functions, any thread.
#pragma once
#include "projects/tuning/model/process_model.h"

#include <functional>

namespace plc::tuning {

/// The standard form: gain (1 + 1/(integralTime s) + derivativeTime s / (filterTime s + 1)).
struct ControllerGains {
    double gain = 1;
    double integralTime = 0;   // [s]; 0: no integral part
    double derivativeTime = 0; // [s]
    double filterTime = 0;     // of the derivative [s]
    [[nodiscard]] double integralGain() const { return integralTime > 0 ? gain / integralTime : 0; }
    [[nodiscard]] Complex at(double omega) const;
};

using Response = std::function<Complex(double omega)>;

struct LoopFigures {
    bool isStable = false;
    double sensitivity = 1;   // Ms, the greatest |1 / (1 + L)|
    double complementary = 1; // Mt, the greatest |L / (1 + L)|
    double gainMargin = 0;    // factor; infinity: none needed
    double phaseMargin = 0;   // [degrees]
    double delayMargin = 0;   // [s]
    double crossover = 0;     // [rad/s], |L| = 1
    double gainMarginAt = 0;  // [rad/s], the phase is -180 degrees; 0: nowhere
    double phaseMarginAt = 0; // [rad/s], of the crossover with the least margin
    double noiseGain = 0;     // of the controller at high frequencies
};

/// `delay`: what sampling and calculation add to the dead time [s].
[[nodiscard]] LoopFigures analyse(const ProcessModel& process, const ControllerGains& controller, double delay = 0);

struct BodePoint {
    double omega = 0, decibels = 0, degrees = 0; // the phase runs on, without jumps
};
[[nodiscard]] std::vector<BodePoint> bode(const Response& response, double from, double to, size_t points);

/// Frequencies, evenly on a logarithmic axis.
[[nodiscard]] std::vector<double> logSpace(double from, double to, size_t points);
/// The range in which the process is of interest [rad/s].
[[nodiscard]] std::pair<double, double> frequencyRange(const ProcessModel& process);
/// About so many frequencies in that range, rising, and close to each other where the process has a resonance: a narrow
/// one would be between two of them.
[[nodiscard]] std::vector<double> frequenciesFor(const ProcessModel& process, size_t points);

} // namespace plc::tuning
