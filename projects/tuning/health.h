// How a loop is doing, from its recording: whether it oscillates and what is likely to blame, how long the output was
// at its limits, the error, the effort, the share of noise. Values and functions, any thread.
#pragma once
#include "projects/tuning/loop.h"
#include "projects/tuning/model/series.h"

#include <optional>

namespace plc::tuning {

enum class Cause : uint8_t { None, Tuning, Stiction, Outside, StictionOrOutside };

struct OscillationFinding {
    double period = 0;    // [s]
    double amplitude = 0; // of the measured value
    size_t cycles = 0;    // counted in a row
    Cause cause{};
};

struct Health {
    double duration = 0;                           // [s]
    std::optional<OscillationFinding> oscillation; // a lasting one
    double timeAtLimit = 0;                        // share of the time
    double integratedError = 0;                    // of the absolute error [unit s]
    double meanError = 0;                          // absolute [unit]
    double effort = 0;                             // movements of the output per hour
    double noise = 0;                              // standard deviation of the measured value
    double noiseShare = 0;                         // of the movement of the measured value
};

struct LoopLimits {
    std::optional<double> low, high; // of the controller's output
    /// Sensitivity and crossover of the loop with its present settings, where a model is known.
    double sensitivity = 0, crossover = 0;
};

/// `now`: of the loop with its present settings; an unstable one swings by itself.
[[nodiscard]] LoopLimits limitsOf(const LoopSeries& series, const std::optional<LoopFigures>& now);
[[nodiscard]] Health healthOf(const LoopSeries& series, const LoopLimits& limits);
/// Sentences for the report, the most important first.
[[nodiscard]] std::vector<Message> wordsOf(const Health& health);

} // namespace plc::tuning
