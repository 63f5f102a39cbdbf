// Finds the steps in a recording that a model can be made from, and says of the others why not. One pass over the
// samples. Values and functions, any thread.
#pragma once
#include "projects/tuning/identify.h"
#include "projects/tuning/series.h"

namespace plc::tuning {

enum class Moved : uint8_t { Input, SetPoint };
enum class Verdict : uint8_t { Usable, Saturated, Noisy, TooShort, Disturbed };

/// Samples [begin, end) around the change at `step`.
struct FoundStep {
    size_t begin = 0, step = 0, settled = 0, end = 0;
    Moved moved{};
    double from = 0, to = 0;
    double outputChange = 0;  // greatest, from where it was
    double signalToNoise = 0; // of the output
    bool startsAtRest = true;
    Verdict verdict{};
    Message reason;
    [[nodiscard]] bool isUsable() const { return verdict == Verdict::Usable; }
};

[[nodiscard]] std::vector<FoundStep> findSteps(const LoopSeries& series);
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
