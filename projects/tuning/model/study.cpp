#include "projects/tuning/model/errors.h"
#include "projects/tuning/model/find.h"
#include "projects/tuning/model/output_error.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

constexpr size_t kMostUsed = 6;

/// The clearest steps, in the order of the recording.
std::vector<size_t> clearest(const std::vector<FoundStep>& steps) {
    std::vector<size_t> out;
    for (size_t i = 0; i < steps.size(); ++i)
        if (steps[i].isUsable() && steps[i].canModel()) out.push_back(i);
    const auto worth = [&](size_t i) {
        const double length = static_cast<double>(steps[i].end - steps[i].step);
        return (steps[i].startsAtRest ? 2.0 : 1.0) * std::min(steps[i].signalToNoise, 200.0) * std::sqrt(length);
    };
    std::stable_sort(out.begin(), out.end(), [&](size_t a, size_t b) { return worth(a) > worth(b); });
    out.resize(std::min(out.size(), kMostUsed));
    std::sort(out.begin(), out.end());
    return out;
}

double fitOf(const std::vector<double>& measured, const std::vector<double>& simulated) {
    double residual = 0, total = 0, mean = 0;
    for (const double value : measured) mean += value / static_cast<double>(measured.size());
    for (size_t i = 0; i < measured.size(); ++i) {
        residual += std::pow(measured[i] - simulated[i], 2);
        total += std::pow(measured[i] - mean, 2);
    }
    return total > 0 ? 100 * (1 - std::sqrt(residual / total)) : 0;
}

/// Whether a step alone is explained by some simple model; the noise of its samples is forgiven.
double ownFit(const Excerpt& excerpt) {
    double best = 0;
    constexpr double kGood = 85; // then it does not matter by how much
    for (const Structure structure :
         {Structure::OneLagDelay, Structure::OneLag, Structure::TwoLagsDelay, Structure::TwoLags,
          Structure::IntegratingLagDelay, Structure::IntegratingDelay, Structure::Integrating, Structure::Oscillating,
          Structure::InverseLag, Structure::Proportional}) {
        if (best > kGood) break;
        if (const auto fit = fitOutputError({excerpt}, structure))
            best = std::max(best, fitOf(excerpt.output, fit->simulated.front()));
    }
    return best;
}

/// What a perfect model of this excerpt would reach: the rest is noise.
double reachable(const Excerpt& excerpt) {
    std::vector<double> quiet = excerpt.output;
    const double noise = noiseOf(excerpt.output);
    double mean = 0, total = 0;
    for (const double value : quiet) mean += value / static_cast<double>(quiet.size());
    for (const double value : quiet) total += (value - mean) * (value - mean);
    const double share = noise * std::sqrt(static_cast<double>(quiet.size()) / std::max(total, 1e-300));
    return 100 * (1 - std::min(share, 1.0));
}

void markDisturbed(FoundStep& step, double fit) {
    step.verdict = Verdict::Disturbed;
    step.reason = errors::StepDisturbed(static_cast<int64_t>(std::max(fit, 0.0)));
}

Result<Study> nothing(const Study& study) {
    if (study.steps.empty()) return Error{errors::NoStepFound(), ""};
    const auto first =
        std::find_if(study.steps.begin(), study.steps.end(), [](const FoundStep& s) { return s.canModel(); });
    if (first == study.steps.end()) return Error{errors::OnlyDisturbances(study.steps.size()), ""};
    const auto count =
        std::count_if(study.steps.begin(), study.steps.end(), [](const FoundStep& s) { return s.canModel(); });
    return Error{errors::NoStepUsable(static_cast<size_t>(count), first->reason), ""};
}

} // namespace

Result<Study> study(const LoopSeries& series) {
    Study out;
    out.steps = findSteps(series);
    for (;;) {
        out.used = clearest(out.steps);
        if (out.used.empty()) return nothing(out);
        out.excerpts.clear();
        bool isClean = true;
        for (const size_t index : out.used) {
            out.excerpts.push_back(excerptOf(series, out.steps[index]));
            const Excerpt coarse = excerptOf(series, out.steps[index], 100);
            const double fit = ownFit(coarse), limit = reachable(coarse);
            if (fit >= 0.6 * limit || fit > 85) continue;
            markDisturbed(out.steps[index], fit);
            isClean = false;
        }
        if (isClean) break;
    }
    out.models = identify(out.excerpts);
    if (out.models.empty()) return Error{errors::NothingExplains(), ""};
    return out;
}

Result<Study> study(const LoopSeries& series, std::vector<FoundStep> steps, const std::vector<size_t>& chosen) {
    Study out;
    out.steps = std::move(steps);
    out.used = chosen;
    for (const size_t index : chosen)
        if (!out.steps[index].canModel()) return Error{errors::NoModelFromLoad(index + 1), ""};
    for (const size_t index : chosen) out.excerpts.push_back(excerptOf(series, out.steps[index]));
    out.models = identify(out.excerpts);
    if (out.models.empty()) return Error{errors::NothingExplains(), ""};
    return out;
}

} // namespace plc::tuning
