// The fit of one structure to excerpts: nonlinear least squares of the output error; gain, zero and each excerpt's
// offset are solved for directly. Used by identify() alone. Functions, any thread.
#pragma once
#include "projects/tuning/model/identify.h"

namespace plc::tuning {

struct OutputErrorFit {
    ProcessModel model;
    std::vector<std::vector<double>> simulated;
    size_t parameters = 0;
};

[[nodiscard]] std::optional<OutputErrorFit> fitOutputError(const std::vector<Excerpt>& excerpts, Structure structure);
/// The model over each excerpt, with the offset (and what moved before) that fits it best.
[[nodiscard]] std::vector<std::vector<double>> simulate(const ProcessModel& model,
                                                        const std::vector<Excerpt>& excerpts);
/// The gain that fits best when everything else stays.
[[nodiscard]] double gainOf(const ProcessModel& model, const std::vector<Excerpt>& excerpts);
[[nodiscard]] std::vector<Bound> confidence(const ProcessModel& model, const std::vector<Excerpt>& excerpts);

} // namespace plc::tuning
