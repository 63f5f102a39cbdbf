// What is said of loops that were made to be ill in a known way.
#include "projects/tuning/health.h"
#include "projects/tuning/loop.h"
#include "tests/projects/tuning/processes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace plc::tuning;

namespace {

struct Illness {
    ControllerGains gains{1, 8, 0, 0};
    double stick = 0;       // the valve moves only in steps of this size
    double disturbance = 0; // a sine from outside
    double disturbancePeriod = 60;
    double noise = 0;
};

LoopSeries played(const ProcessModel& process, const Illness& illness, double limit = 1e9) {
    LoopSeries out;
    const double cycle = 0.1;
    SampledProcess sampled(process, cycle);
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, 1);
    double integral = 0, valve = 0;
    for (int i = 0; i < 8000; ++i) {
        const double time = i * cycle, setPoint = 10;
        const double measured = sampled.output() + illness.noise * normal(random) +
                                illness.disturbance * std::sin(2 * std::numbers::pi * time / illness.disturbancePeriod);
        const double error = setPoint - measured;
        const double step = illness.gains.gain * error * cycle / illness.gains.integralTime;
        const double sum = illness.gains.gain * error + integral + step;
        if (std::abs(sum) < limit) integral += step;
        const double input = std::clamp(sum, -limit, limit);
        if (std::abs(input - valve) >= illness.stick) valve = input;
        out.time.push_back(time);
        out.input.push_back(input);
        out.output.push_back(measured);
        out.setPoint.push_back(setPoint);
        sampled.advance(valve);
    }
    return out;
}

LoopLimits limitsFor(const ProcessModel& process, const Illness& illness) {
    const LoopFigures figures = analyse(process, illness.gains, 0.05);
    return {{}, {}, figures.sensitivity, figures.crossover};
}

} // namespace

TEST(Health, AQuietLoopIsWell) {
    const ProcessModel process = equalLags(1, 8, 2, 1.5);
    const Illness none{{1.2, 8, 0, 0}, 0, 0, 60, 0.02};
    const Health health = healthOf(played(process, none), limitsFor(process, none));
    EXPECT_FALSE(health.oscillation);
    EXPECT_NEAR(health.noise, 0.02, 0.005);
    EXPECT_EQ(health.timeAtLimit, 0);
    EXPECT_EQ(wordsOf(health).size(), 1U);
}

TEST(Health, SettingsAtTheEdgeAreToBlame) {
    const ProcessModel process = equalLags(1, 8, 2, 1.5);
    const Illness lively{{4.1, 8, 0, 0}, 0, 0, 60, 0.02};
    const Health health = healthOf(played(process, lively, 60), limitsFor(process, lively));
    ASSERT_TRUE(health.oscillation);
    EXPECT_EQ(health.oscillation->cause, Cause::Tuning);
    EXPECT_NEAR(health.oscillation->period, 8, 2.5);
}

TEST(Health, ASineFromOutsideIsOutside) {
    const ProcessModel process = equalLags(1, 8, 2, 1.5);
    const Illness outside{{1.0, 8, 0, 0}, 0, 3, 60, 0.02};
    const Health health = healthOf(played(process, outside), limitsFor(process, outside));
    ASSERT_TRUE(health.oscillation);
    EXPECT_NEAR(health.oscillation->period, 60, 2);
    EXPECT_EQ(health.oscillation->cause, Cause::Outside);
}

TEST(Health, AValveThatSticksIsToBlame) {
    const ProcessModel process = equalLags(1, 1.5, 0.3, 1.5);
    const Illness sticks{{0.3, 4, 0, 0}, 1.5, 0, 60, 0.01};
    const Health health = healthOf(played(process, sticks), limitsFor(process, sticks));
    ASSERT_TRUE(health.oscillation);
    EXPECT_EQ(health.oscillation->cause, Cause::Stiction);
}

TEST(Health, TimeAtALimitAndTheErrorAreCounted) {
    const ProcessModel process = equalLags(1, 8, 2, 1.5);
    const Illness none{{1.2, 8, 0, 0}, 0, 0, 60, 0};
    LoopLimits limits = limitsFor(process, none);
    limits.low = -5;
    limits.high = 5;
    const Health health = healthOf(played(process, none, 5), limits);
    EXPECT_GT(health.timeAtLimit, 0.8);
    EXPECT_NEAR(health.meanError, 2.5, 0.6);
    EXPECT_EQ(wordsOf(health).size(), 2U);
}
