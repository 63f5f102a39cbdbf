// Finds the steps in a recording that a model can be made from, and says of the others why not. One pass over the
// samples. Values and functions, any thread.
#pragma once
#include "projects/tuning/model/identify.h"
#include "projects/tuning/model/series.h"

namespace plc::tuning {

/// Load: something else moved the process, and the controller brought it back.
enum class Moved : uint8_t { Input, SetPoint, Load };
enum class Verdict : uint8_t { Usable, Saturated, Noisy, TooShort, Disturbed, Unanswered };

/// Samples [begin, end) around the change at `step`.
struct FoundStep {
    size_t begin = 0, step = 0, settled = 0, end = 0;
    Moved moved{};
    double from = 0, to = 0;  // of what moved; of a load the input, before and after
    double outputChange = 0;  // greatest, from where it was
    double signalToNoise = 0; // of the output
    bool startsAtRest = true;
    Verdict verdict{};
    Message reason;
    [[nodiscard]] bool isUsable() const { return verdict == Verdict::Usable; }
    /// What moved the process is known: a model can be made from it.
    [[nodiscard]] bool canModel() const { return moved != Moved::Load; }
};

/// Steps of the set point and of the input, and disturbances where a set point is known, in the order of the recording.
[[nodiscard]] std::vector<FoundStep> findSteps(const LoopSeries& series);
/// The disturbances alone. `steps`: where the process moves for another reason.
[[nodiscard]] std::vector<FoundStep> findLoads(const LoopSeries& series, const std::vector<FoundStep>& steps);
/// Standard deviation of what changes from sample to sample without the signal moving.
[[nodiscard]] double noiseOf(const std::vector<double>& values);
/// Evenly sampled with about so many points, one of them at the step.
[[nodiscard]] Excerpt excerptOf(const LoopSeries& series, const FoundStep& step, size_t points = 400);
/// The instants of an excerpt's samples [s].
[[nodiscard]] std::vector<double> timesOf(const LoopSeries& series, const FoundStep& step, const Excerpt& excerpt);

/// From a recording to a model: what was found, what of it was used, which models explain it, best first.
struct Study {
    std::vector<FoundStep> steps;
    std::vector<size_t> used; // indices in steps
    std::vector<Excerpt> excerpts;
    std::vector<Identified> models;
};
[[nodiscard]] Result<Study> study(const LoopSeries& series);
/// The same with steps chosen by hand.
[[nodiscard]] Result<Study> study(const LoopSeries& series, std::vector<FoundStep> steps,
                                  const std::vector<size_t>& chosen);

} // namespace plc::tuning
