// Models found again in what they made: without noise within one per cent, with five per cent of noise within ten.
#include "projects/tuning/loop_report.h"
#include "tests/projects/tuning/processes.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

using namespace plc::tuning;

namespace {

struct Family {
    std::string name;
    ProcessModel process;
    double duration;
};

/// All; with a sanitizer every third, since the figures are the same and take ten times as long.
std::vector<Family> families() {
    std::vector<Family> out;
    for (int n = 1; n <= 8; ++n) out.push_back({"(s+1)^-" + std::to_string(n), equalLags(n), 8.0 + 3 * n});
    out.push_back({"four lags", lags({1, 0.2, 0.04, 0.008}), 8});
    out.push_back({"four lags 0.5", lags({1, 0.5, 0.25, 0.125}), 12});
    for (const double lag : {0.2, 1.0, 4.0})
        out.push_back({"delay and lag " + std::to_string(lag), equalLags(1, lag, 1, 3), 3 + 7 * lag});
    out.push_back({"delay and two lags", lags({3, 1}, 1), 25});
    out.push_back({"delay and two equal lags", equalLags(2, 2, 1, -4), 25});
    for (const double dead : {0.0, 0.7}) {
        ProcessModel integrating = lags({}, dead, 0.3);
        integrating.isIntegrating = true;
        out.push_back({"integrator " + std::to_string(dead), integrating, 10});
        integrating.lags = {1};
        out.push_back({"integrator with lag " + std::to_string(dead), integrating, 12});
    }
    for (const double zero : {0.5, 2.0}) {
        ProcessModel inverse = equalLags(3);
        inverse.zero = -zero;
        out.push_back({"right-half zero " + std::to_string(zero), inverse, 14});
    }
    for (const double damping : {0.1, 0.3, 0.7}) {
        ProcessModel oscillating = lags({}, 0, 2);
        oscillating.oscillation = Oscillation{2, damping};
        out.push_back({"oscillating " + std::to_string(damping), oscillating, 15});
        oscillating.deadTime = 0.4;
        out.push_back({"oscillating late " + std::to_string(damping), oscillating, 15});
    }
    if (plc::kFewer == 1) return out;
    std::vector<Family> some;
    for (size_t at = 0; at < out.size(); at += 3) some.push_back(out[at]);
    return some;
}

double deadAndLag(const ProcessModel& model) { return model.deadTime + model.lagSum(); }

} // namespace

TEST(Identify, WithoutNoiseWithinOnePerCentOverAllFamilies) {
    for (const Family& family : families()) {
        const auto found = identify({stepOf(family.process, family.duration)});
        ASSERT_FALSE(found.empty()) << family.name;
        const ProcessModel& model = found.front().model;
        const ProcessModel& truth = family.process;
        const std::string what = family.name + ": " + formula(model) + " for " + formula(truth) + " (" +
                                 std::string(title(found.front().structure)) + ")";
        EXPECT_NEAR(model.gain, truth.gain, 0.01 * std::abs(truth.gain)) << what;
        EXPECT_NEAR(deadAndLag(model), deadAndLag(truth), 0.01 * deadAndLag(truth)) << what;
        EXPECT_NEAR(model.deadTime, truth.deadTime, 0.01 * truth.timeScale()) << what;
        EXPECT_EQ(model.isIntegrating, truth.isIntegrating) << what;
        EXPECT_EQ(model.zero < -1e-3, truth.zero < 0) << what;
        if (!truth.lags.empty() && !model.lags.empty()) {
            EXPECT_NEAR(model.lags[0], truth.lags[0], 0.01 * truth.lags[0]) << what;
        }
        if (truth.oscillation) {
            ASSERT_TRUE(model.oscillation) << what;
            EXPECT_NEAR(model.oscillation->frequency, truth.oscillation->frequency, 0.01 * 2) << what;
            EXPECT_NEAR(model.oscillation->damping, truth.oscillation->damping, 0.01) << what;
        }
        EXPECT_GT(found.front().fit, 99) << what;
    }
}

TEST(Identify, WithFivePerCentOfNoiseWithinTenPerCent) {
    for (const Family& family : families())
        for (unsigned seed = 1; seed <= plc::repeats(3U); ++seed) {
            const auto found = identify({stepOf(family.process, family.duration, 0.05, seed, 1, 2000)});
            ASSERT_FALSE(found.empty()) << family.name;
            const ProcessModel& model = found.front().model;
            const ProcessModel& truth = family.process;
            const std::string what = family.name + ": " + formula(model) + " for " + formula(truth) + " (" +
                                     std::string(title(found.front().structure)) + ")";
            EXPECT_EQ(model.isIntegrating, truth.isIntegrating) << what;
            EXPECT_NEAR(model.gain, truth.gain, 0.1 * std::abs(truth.gain)) << what;
            EXPECT_NEAR(deadAndLag(model), deadAndLag(truth), 0.1 * truth.timeScale()) << what;
        }
}

namespace {

/// One of the families with parameters by chance; every kind comes in turn.
Family byChance(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
    };
    const double gain = between(0.1, 10) * (random() % 2 ? 1 : -1), scale = between(0.05, 200);
    Family out{"seed " + std::to_string(seed), {}, 0};
    switch (seed % 6) {
    case 0:
        out.process = equalLags(2 + static_cast<int>(random() % 6), scale, 0, gain);
        break;
    case 1: {
        const double share = between(0.15, 0.6);
        out.process = lags({scale, scale * share, scale * share * share, scale * share * share * share}, 0, gain);
        break;
    }
    case 2:
        out.process = equalLags(1, scale, scale * between(0.1, 3), gain);
        break;
    case 3:
        out.process = lags({}, scale * between(0.1, 1), gain);
        out.process.isIntegrating = true;
        break;
    case 4:
        out.process = equalLags(3, scale, 0, gain);
        out.process.zero = -scale * between(0.3, 2.5);
        break;
    case 5:
        out.process = lags({}, 0, gain);
        out.process.oscillation = Oscillation{1 / scale, between(0.1, 0.8)};
        break;
    }
    const double slow = out.process.oscillation ? scale / out.process.oscillation->damping : 0;
    out.duration = 10 * out.process.timeScale() + 4 * slow;
    return out;
}

} // namespace

TEST(Identify, OtherParametersOfTheFamiliesWithoutNoiseWithinOnePerCent) {
    for (unsigned seed = 0; seed < plc::repeats(36U); ++seed) {
        const Family family = byChance(seed);
        const auto found = identify({stepOf(family.process, family.duration)});
        ASSERT_FALSE(found.empty()) << family.name;
        const ProcessModel &model = found.front().model, &truth = family.process;
        const std::string what = family.name + ": " + formula(model) + " for " + formula(truth);
        EXPECT_NEAR(model.gain, truth.gain, 0.01 * std::abs(truth.gain)) << what;
        EXPECT_NEAR(deadAndLag(model), deadAndLag(truth), 0.01 * truth.timeScale()) << what;
        EXPECT_NEAR(model.deadTime, truth.deadTime, 0.01 * truth.timeScale()) << what;
        EXPECT_EQ(model.isIntegrating, truth.isIntegrating) << what;
    }
}

TEST(Identify, OtherParametersOfTheFamiliesWithFivePerCentOfNoiseWithinTenPerCent) {
    for (unsigned seed = 0; seed < plc::repeats(36U); ++seed) {
        const Family family = byChance(seed);
        const auto found = identify({stepOf(family.process, family.duration, 0.05, seed + 100, 1, 2000)});
        ASSERT_FALSE(found.empty()) << family.name;
        const ProcessModel &model = found.front().model, &truth = family.process;
        const std::string what = family.name + ": " + formula(model) + " for " + formula(truth);
        EXPECT_EQ(model.isIntegrating, truth.isIntegrating) << what;
        EXPECT_NEAR(model.gain, truth.gain, 0.1 * std::abs(truth.gain)) << what;
        EXPECT_NEAR(deadAndLag(model), deadAndLag(truth), 0.1 * truth.timeScale()) << what;
    }
}

TEST(Identify, TheBoundsHoldWhatIsTrue) {
    // 95 per cent of the bounds, over parameters and noise; chance leaves a little
    int inside = 0, all = 0;
    const auto count = [&](const Bound& bound, double truth) {
        ++all;
        inside += std::abs(bound.value - truth) <= bound.halfWidth;
        EXPECT_LT(bound.halfWidth, 0.5 * truth) << bound.name;
    };
    for (unsigned seed = 1; seed <= plc::repeats(40U); ++seed) {
        const auto best = identify({stepOf(equalLags(1, 2, 1, 3), 16, 0.03, seed)});
        ASSERT_FALSE(best.empty());
        if (best.front().structure != Structure::OneLagDelay) continue;
        for (const Bound& bound : best.front().bounds)
            count(bound, bound.name == "gain" ? 3 : bound.name == "dead time" ? 1 : 2);
    }
    EXPECT_GE(all, plc::repeats(90));
    EXPECT_GE(inside * 100, all * 88) << inside << " of " << all;
}

TEST(Identify, SeveralStepsAreFittedTogetherAndTheLastIsForetold) {
    std::vector<Excerpt> steps;
    for (unsigned i = 0; i < 4; ++i) steps.push_back(stepOf(lags({3, 1}, 1, 2), 25, 0.05, i + 1, i % 2 ? -1.0 : 1.0));
    const auto found = identify(steps);
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found.front().model.gain, 2, 0.04);
    EXPECT_NEAR(deadAndLag(found.front().model), 5, 0.1);
    ASSERT_TRUE(found.front().validation);
    EXPECT_GT(*found.front().validation, 80);
    EXPECT_FALSE(found.front().gainUp);
}

TEST(Identify, AGainThatDependsOnTheOperatingPointIsSaid) {
    std::vector<Excerpt> steps; // up and down about two levels: 7 and 47
    for (unsigned i = 0; i < 6; ++i) {
        const bool isHigh = i >= 3;
        steps.push_back(stepOf(lags({3}, 1, isHigh ? 1.2 : 3.0), 25, 0.01, i + 1, i % 2 ? -1.0 : 1.0));
        if (isHigh)
            for (double& value : steps.back().output) value += 40;
    }
    const auto found = identify(steps);
    ASSERT_FALSE(found.empty());
    const Identified& best = found.front();
    ASSERT_EQ(best.gainsAt.size(), 2U);
    EXPECT_NEAR(best.gainsAt[0].gain, 3, 0.15);
    EXPECT_NEAR(best.gainsAt[0].level, 7, 2);
    EXPECT_NEAR(best.gainsAt[1].gain, 1.2, 0.1);
    EXPECT_NEAR(best.gainsAt[1].level, 47, 2);
    EXPECT_FALSE(best.gainUp);
    ASSERT_EQ(gainWords(best).size(), 1U);
    EXPECT_NE(gainWords(best)[0].english().find("operating point"), std::string::npos);
    // the same gain everywhere: nothing to say
    steps.erase(steps.begin() + 3, steps.end());
    EXPECT_TRUE(identify(steps).front().gainsAt.empty());
    EXPECT_TRUE(gainWords(identify(steps).front()).empty());
}

TEST(Identify, ADifferentGainUpAndDownIsSaid) {
    std::vector<Excerpt> steps;
    for (unsigned i = 0; i < 4; ++i)
        steps.push_back(stepOf(lags({3}, 1, i % 2 ? 1.5 : 3.0), 25, 0.01, i + 1, i % 2 ? -1.0 : 1.0));
    const auto found = identify(steps);
    ASSERT_FALSE(found.empty());
    ASSERT_TRUE(found.front().gainUp);
    EXPECT_NEAR(*found.front().gainUp, 3, 0.15);
    EXPECT_NEAR(*found.front().gainDown, 1.5, 0.15);
}

TEST(Identify, WhatDoesNotMoveHasNoModel) {
    EXPECT_TRUE(identify({Excerpt{0.1, std::vector<double>(100, 1), std::vector<double>(100, 5), true}}).empty());
    EXPECT_TRUE(identify(std::vector<Excerpt>{}).empty());
}
