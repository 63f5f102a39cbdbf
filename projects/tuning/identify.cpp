#include "projects/tuning/identify.h"

#include "projects/tuning/output_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plc::tuning {

std::string_view title(Structure structure) {
    switch (structure) {
#define PLC_STRUCTURE(Name, Title)                                                                                     \
    case Structure::Name:                                                                                              \
        return Title;
#include "projects/tuning/structures.def"
    }
    return {};
}

namespace {

double squares(const std::vector<std::vector<double>>& measured, const std::vector<std::vector<double>>& simulated) {
    double sum = 0;
    for (size_t i = 0; i < measured.size(); ++i)
        for (size_t k = 0; k < measured[i].size(); ++k) sum += std::pow(measured[i][k] - simulated[i][k], 2);
    return sum;
}

/// Around the mean of each excerpt.
double deviation(const std::vector<std::vector<double>>& measured) {
    double sum = 0;
    for (const std::vector<double>& one : measured) {
        double mean = 0;
        for (const double value : one) mean += value / static_cast<double>(one.size());
        for (const double value : one) sum += (value - mean) * (value - mean);
    }
    return sum;
}

std::vector<std::vector<double>> outputs(const std::vector<Excerpt>& excerpts) {
    std::vector<std::vector<double>> out;
    for (const Excerpt& excerpt : excerpts) out.push_back(excerpt.output);
    return out;
}

double percent(double residual, double total) { return total > 0 ? 100 * (1 - std::sqrt(residual / total)) : 0; }

/// What is explained better than this cannot be told from rounding.
constexpr double kFloor = 1e-10;

/// Bayes' criterion: a parameter more must pay for itself.
double criterion(double residual, double total, size_t samples, size_t parameters) {
    const auto n = static_cast<double>(samples);
    return n * std::log(std::max(residual, kFloor * total) / n) + static_cast<double>(parameters) * std::log(n);
}

/// Fits on all but the last excerpts and looks how well those are foretold.
std::optional<double> validate(const std::vector<Excerpt>& excerpts, Structure structure) {
    if (excerpts.size() < 2) return std::nullopt;
    const size_t kept = excerpts.size() - std::max<size_t>(excerpts.size() / 3, 1);
    const std::vector<Excerpt> known(excerpts.begin(), excerpts.begin() + static_cast<std::ptrdiff_t>(kept));
    const std::vector<Excerpt> unknown(excerpts.begin() + static_cast<std::ptrdiff_t>(kept), excerpts.end());
    const auto fitted = fitOutputError(known, structure);
    if (!fitted) return std::nullopt;
    const auto measured = outputs(unknown);
    return percent(squares(measured, simulate(fitted->model, unknown)), deviation(measured));
}

bool isUpward(const Excerpt& excerpt) {
    double sum = 0;
    for (const double input : excerpt.input) sum += input - excerpt.input.front();
    return sum > 0;
}

/// A valve or heater often does more in one direction than in the other.
void compareDirections(const std::vector<Excerpt>& excerpts, Identified& found) {
    std::vector<Excerpt> up, down;
    for (const Excerpt& excerpt : excerpts) (isUpward(excerpt) ? up : down).push_back(excerpt);
    if (up.empty() || down.empty()) return;
    const double gainUp = gainOf(found.model, up), gainDown = gainOf(found.model, down);
    const double bound = found.bounds.empty() ? 0 : found.bounds.front().halfWidth;
    if (std::abs(gainUp - gainDown) < std::max(0.1 * std::abs(found.model.gain), 2 * bound)) return;
    found.gainUp = gainUp;
    found.gainDown = gainDown;
}

/// A longer chain is tried only while the shorter one was worth it.
std::vector<Structure> longerChains() {
    return {Structure::FiveEqual, Structure::SixEqual, Structure::SevenEqual, Structure::EightEqual};
}

std::vector<Structure> firstStructures() {
    std::vector<Structure> out;
    for (const Structure structure : {
#define PLC_STRUCTURE(Name, Title) Structure::Name,
#include "projects/tuning/structures.def"
         }) {
        const auto longer = longerChains();
        if (std::find(longer.begin(), longer.end(), structure) == longer.end()) out.push_back(structure);
    }
    return out;
}

/// Best first: of those that foretell the last excerpt about equally well, the one with the best criterion.
void order(std::vector<Identified>& all, const std::vector<Excerpt>& excerpts) {
    const auto byScore = [](const Identified& a, const Identified& b) { return a.score < b.score; };
    std::stable_sort(all.begin(), all.end(), byScore);
    if (excerpts.size() < 2) return;
    constexpr size_t kMost = 4;
    double best = -1e9;
    const size_t count = std::min(all.size(), kMost);
    for (size_t i = 0; i < count; ++i) {
        all[i].validation = validate(excerpts, all[i].structure);
        best = std::max(best, all[i].validation.value_or(-1e9));
    }
    std::stable_partition(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), [&](const Identified& one) {
        return 100 - one.validation.value_or(-1e9) <= (100 - best) * 1.1 + 0.01;
    });
}

} // namespace

std::optional<Identified> identify(const std::vector<Excerpt>& excerpts, Structure structure) {
    const auto fitted = fitOutputError(excerpts, structure);
    if (!fitted) return std::nullopt;
    Identified out;
    out.model = fitted->model;
    out.structure = structure;
    out.simulated = fitted->simulated;
    const auto measured = outputs(excerpts);
    const double residual = squares(measured, out.simulated), total = deviation(measured);
    size_t samples = 0;
    for (const auto& one : measured) samples += one.size();
    out.fit = percent(residual, total);
    out.noise = std::sqrt(residual / static_cast<double>(std::max<size_t>(samples, 1)));
    out.score = criterion(residual, total, samples, fitted->parameters);
    return out;
}

std::vector<Identified> identify(const std::vector<Excerpt>& excerpts) {
    std::vector<Identified> all;
    if (excerpts.empty() || deviation(outputs(excerpts)) <= 0) return all;
    const auto add = [&](Structure structure) {
        auto found = identify(excerpts, structure);
        if (!found || !(found->fit > 5)) return 1e300;
        all.push_back(std::move(*found));
        return all.back().score;
    };
    double three = 0, four = 0;
    for (const Structure structure : firstStructures()) {
        const double score = add(structure);
        if (structure == Structure::ThreeEqual) three = score;
        if (structure == Structure::FourEqual) four = score;
    }
    for (const Structure structure : longerChains()) {
        if (!(four < three)) break;
        three = std::exchange(four, add(structure));
    }
    order(all, excerpts);
    if (!all.empty()) {
        all.front().bounds = confidence(all.front().model, excerpts);
        compareDirections(excerpts, all.front());
    }
    return all;
}

} // namespace plc::tuning
