// Disturbances of a loop in its recording: found beside the steps, those that are not usable with the reason.
#include "projects/tuning/model/find.h"
#include "tests/projects/tuning/processes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace plc::tuning;

namespace {

/// A PI loop of a process with 2 e^(-1 s) / (6 s + 1), sampled every 100 ms; the set point and the load step.
struct Plan {
    size_t samples = 8000;
    std::vector<std::pair<size_t, double>> setPoints, loads; // from this sample on
    double noise = 0, limit = 1e9;
    std::pair<size_t, size_t> byHand{0, 0}; // the controller is not in charge
    unsigned seed = 1;
};

double valueAt(const std::vector<std::pair<size_t, double>>& changes, size_t i) {
    double out = 0;
    for (const auto& [from, value] : changes)
        if (from <= i) out = value;
    return out;
}

LoopSeries play(const Plan& plan) {
    constexpr double kCycle = 0.1, kGain = 1, kIntegralTime = 6;
    SampledProcess process(equalLags(1, 6, 1, 2), kCycle);
    std::mt19937 random(plan.seed);
    std::normal_distribution<double> normal(0, 1);
    LoopSeries out;
    double integral = 0, input = 0;
    for (size_t i = 0; i < plan.samples; ++i) {
        const double setPoint = valueAt(plan.setPoints, i);
        const double measured = process.output() + plan.noise * normal(random), error = setPoint - measured;
        if (i < plan.byHand.first || i >= plan.byHand.second) {
            const double sum = kGain * error + integral + kGain * error * kCycle / kIntegralTime;
            if (std::abs(sum) < plan.limit) integral += kGain * error * kCycle / kIntegralTime;
            input = std::clamp(sum, -plan.limit, plan.limit);
        }
        out.time.push_back(static_cast<double>(i) * kCycle);
        out.input.push_back(input);
        out.output.push_back(measured);
        out.setPoint.push_back(setPoint);
        process.advance(input + valueAt(plan.loads, i));
    }
    return out;
}

std::vector<FoundStep> loadsOf(const std::vector<FoundStep>& all) {
    std::vector<FoundStep> out;
    std::copy_if(all.begin(), all.end(), std::back_inserter(out),
                 [](const FoundStep& step) { return step.moved == Moved::Load; });
    return out;
}

} // namespace

TEST(FindLoads, AreFoundBetweenTheStepsWithAndWithoutNoise) {
    for (const double noise : {0.0, 0.05}) {
        Plan plan;
        plan.setPoints = {{500, 10}, {5000, 4}};
        plan.loads = {{2000, -3}, {3500, 1}, {6500, -2}};
        plan.noise = noise;
        const auto found = loadsOf(findSteps(play(plan)));
        ASSERT_EQ(found.size(), 3U) << noise;
        for (size_t i = 0; i < 3; ++i) {
            // a second of dead time, then as long as it takes to be seen
            EXPECT_GE(found[i].step + 10, plan.loads[i].first) << noise;
            EXPECT_LE(found[i].step, plan.loads[i].first + 60) << noise;
            EXPECT_TRUE(found[i].isUsable()) << found[i].reason.english();
            // what the controller did about it
            const double moved = plan.loads[i].second - (i > 0 ? plan.loads[i - 1].second : 0);
            EXPECT_NEAR(found[i].to - found[i].from, -moved, 0.3) << noise;
        }
    }
}

TEST(FindLoads, ManyByChanceAreFoundAndHardlyAnythingElse) {
    Plan plan;
    plan.samples = 200'000;
    plan.noise = 0.1;
    std::mt19937 random(11);
    std::uniform_int_distribution<size_t> wait(900, 2500);
    std::uniform_real_distribution<double> height(1, 4);
    double level = 0;
    for (size_t at = 1000; at < plan.samples - 1000; at += wait(random)) {
        level += (level > 0 ? -1 : 1) * height(random);
        plan.loads.emplace_back(at, level);
    }
    const auto found = loadsOf(findSteps(play(plan)));
    size_t right = 0;
    for (const auto& [at, value] : plan.loads)
        right += std::any_of(found.begin(), found.end(), [at = at](const FoundStep& load) {
            return load.isUsable() && load.step + 10 >= at && load.step <= at + 60;
        });
    EXPECT_GE(right * 100, plan.loads.size() * 95) << right << " of " << plan.loads.size();
    EXPECT_LE((found.size() - std::min(found.size(), right)) * 100, plan.loads.size() * 5) << found.size();
}

TEST(FindLoads, ALoopAtRestHasNone) {
    Plan plan;
    plan.samples = 100'000;
    plan.noise = 0.2;
    plan.setPoints = {{300, 10}};
    EXPECT_TRUE(loadsOf(findSteps(play(plan))).empty());
}

TEST(FindLoads, ALongRestIsSearchedInOneGo) {
    // an hour in scans of a millisecond; looking back over the rest at each of its samples takes minutes
    Plan plan;
    plan.samples = 3'600'000;
    plan.noise = 0.1;
    plan.setPoints = {{300, 10}};
    plan.loads = {{3'590'000, -3}};
    const auto found = loadsOf(findSteps(play(plan)));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(static_cast<double>(found[0].step), 3'590'000, 60);
    EXPECT_TRUE(found[0].isUsable()) << found[0].reason.english();
}

TEST(FindLoads, SaysWhyOneIsNotUsable) {
    Plan plan;
    plan.setPoints = {{500, 10}, {2100, 12}};
    plan.loads = {{2000, -3}, {6000, 2}};
    plan.byHand = {5500, 8000};
    plan.noise = 0.02;
    auto found = loadsOf(findSteps(play(plan)));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].verdict, Verdict::TooShort) << found[0].reason.english();
    EXPECT_FALSE(found[1].isUsable());
    Plan limited;
    limited.setPoints = {{500, 4}, {6000, 0}};
    limited.loads = {{2000, -5}, {2900, 0}};
    limited.limit = 4;
    found = loadsOf(findSteps(play(limited)));
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].verdict, Verdict::Saturated) << found[0].reason.english();
}

TEST(FindLoads, MakeNoModelAndSpoilNone) {
    Plan plan;
    plan.setPoints = {{500, 10}, {4500, 4}};
    plan.loads = {{1500, -3}, {6000, 1}};
    plan.noise = 0.02;
    const LoopSeries series = play(plan);
    const auto result = study(series);
    ASSERT_TRUE(result) << result.error().english();
    for (const size_t index : result->used) EXPECT_EQ(result->steps[index].moved, Moved::SetPoint);
    EXPECT_NEAR(result->models.front().model.gain, 2, 0.1) << formula(result->models.front().model);
    const auto load = std::find_if(result->steps.begin(), result->steps.end(),
                                   [](const FoundStep& step) { return step.moved == Moved::Load; });
    ASSERT_NE(load, result->steps.end());
    EXPECT_FALSE(study(series, result->steps, {static_cast<size_t>(load - result->steps.begin())}));
    plan.setPoints.clear();
    const auto only = study(play(plan));
    ASSERT_FALSE(only);
    EXPECT_NE(only.error().english().find("2 disturbances"), std::string::npos) << only.error().english();
}
