#include "projects/tuning/model/identify.h"

#include "projects/tuning/model/output_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plc::tuning {

std::string_view title(Structure structure) {
    switch (structure) {
#define PLC_STRUCTURE(Name, Title)                                                                                     \
    case Structure::Name:                                                                                              \
        return Title;
#include "projects/tuning/model/structures.def"
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

/// What one step alone says, when everything but the gain stays.
struct SingleGain {
    double gain = 0, level = 0, travel = 0; // level and travel of the measured value
    bool isUp = false;
};

std::vector<SingleGain> singleGains(const std::vector<Excerpt>& excerpts, const ProcessModel& model) {
    std::vector<SingleGain> out;
    for (const Excerpt& excerpt : excerpts) {
        const auto [low, high] = std::minmax_element(excerpt.output.begin(), excerpt.output.end());
        out.push_back({gainOf(model, {excerpt}), (*low + *high) / 2, *high - *low, isUpward(excerpt)});
    }
    std::sort(out.begin(), out.end(), [](const SingleGain& a, const SingleGain& b) { return a.level < b.level; });
    return out;
}

/// Two groups of steps, and how far the gains inside them are spread.
struct Grouped {
    double first = 0, second = 0, firstLevel = 0, secondLevel = 0;
    double scatter = 1e300; // squares
    bool isApart = false;   // the measured values of the two have nothing in common
};

template <class IsFirst> std::optional<Grouped> grouped(const std::vector<SingleGain>& all, const IsFirst& isFirst) {
    double count[2] = {}, gain[2] = {}, level[2] = {};
    for (size_t i = 0; i < all.size(); ++i) {
        const int group = isFirst(i) ? 0 : 1;
        count[group] += 1, gain[group] += all[i].gain, level[group] += all[i].level;
    }
    if (count[0] == 0 || count[1] == 0) return std::nullopt;
    Grouped out{gain[0] / count[0], gain[1] / count[1], level[0] / count[0], level[1] / count[1], 0};
    for (size_t i = 0; i < all.size(); ++i)
        out.scatter += std::pow(all[i].gain - (isFirst(i) ? out.first : out.second), 2);
    return out;
}

double highest(const std::vector<SingleGain>& all, size_t end) {
    double out = -1e300;
    for (size_t i = 0; i < end; ++i) out = std::max(out, all[i].level + all[i].travel / 2);
    return out;
}

double lowest(const std::vector<SingleGain>& all, size_t begin) {
    double out = 1e300;
    for (size_t i = begin; i < all.size(); ++i) out = std::min(out, all[i].level - all[i].travel / 2);
    return out;
}

/// Below and above some level; the groups do not overlap.
std::optional<Grouped> groupedByLevel(const std::vector<SingleGain>& all) {
    std::optional<Grouped> best;
    for (size_t split = 1; split < all.size(); ++split) {
        // next to each other they tell nothing of the operating point
        if (all[split].level - all[split - 1].level < 0.5 * std::min(all[split].travel, all[split - 1].travel))
            continue;
        const auto now = grouped(all, [&](size_t i) { return i < split; });
        if (!now || (best && now->scatter >= best->scatter)) continue;
        best = now;
        best->isApart = highest(all, split) + 0.1 * all[split].travel < lowest(all, split);
    }
    return best;
}

/// A valve or heater often does more in one direction than in the other, or more in one part of its range.
void compareGains(const std::vector<Excerpt>& excerpts, Identified& found) {
    const std::vector<SingleGain> all = singleGains(excerpts, found.model);
    const double bound = found.bounds.empty() ? 0 : found.bounds.front().halfWidth;
    const double least = std::max(0.1 * std::abs(found.model.gain), 2 * bound);
    const auto isClear = [&](const std::optional<Grouped>& groups) {
        return groups && std::abs(groups->first - groups->second) >= least;
    };
    const auto byLevel = groupedByLevel(all);
    const auto byDirection = grouped(all, [&](size_t i) { return all[i].isUp; });
    const bool isLevel = isClear(byLevel), isDirection = isClear(byDirection);
    // the same steps in both groupings: from one level up and down it is the direction
    const bool isSame = isLevel && isDirection && byLevel->scatter > 0.8 * byDirection->scatter;
    if (isLevel && (!isDirection || (isSame ? byLevel->isApart : byLevel->scatter < byDirection->scatter))) {
        found.gainsAt = {{byLevel->firstLevel, byLevel->first}, {byLevel->secondLevel, byLevel->second}};
    } else if (isDirection) {
        found.gainUp = byDirection->first;
        found.gainDown = byDirection->second;
    }
}

/// A longer chain is tried only while the shorter one was worth it.
std::vector<Structure> longerChains() {
    return {Structure::FiveEqual, Structure::SixEqual, Structure::SevenEqual, Structure::EightEqual};
}

std::vector<Structure> firstStructures() {
    std::vector<Structure> out;
    for (const Structure structure : {
#define PLC_STRUCTURE(Name, Title) Structure::Name,
#include "projects/tuning/model/structures.def"
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
        compareGains(excerpts, all.front());
    }
    return all;
}

} // namespace plc::tuning
