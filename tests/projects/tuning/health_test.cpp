// What is said of loops that were made to be ill in a known way.
#include "projects/tuning/health.h"
#include "projects/tuning/loop.h"
#include "projects/tuning/proposal.h"
#include "projects/tuning/rules.h"
#include "tests/projects/tuning/processes.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

using namespace plc::tuning;

namespace {

struct Illness {
    ControllerGains gains{1, 8, 0, 0};
    double stick = 0;       // the valve moves only in steps of this size
    double disturbance = 0; // a sine from outside
    double disturbancePeriod = 60;
    double noise = 0;
    double cycle = 0.1;
    int scans = 8000;
    unsigned seed = 5;
};

LoopSeries played(const ProcessModel& process, const Illness& illness, double limit = 1e9) {
    LoopSeries out;
    const double cycle = illness.cycle;
    SampledProcess sampled(process, cycle);
    std::mt19937 random(illness.seed);
    std::normal_distribution<double> normal(0, 1);
    double integral = 0, valve = 0;
    for (int i = 0; i < illness.scans; ++i) {
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

namespace {

/// A loop by chance, ill in one way: at the edge of stability, with a valve that sticks, or moved by a sine.
Cause diagnosed(Cause illness, unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
    };
    const double lag = between(1, 20), gain = between(0.5, 3);
    ProcessModel process = equalLags(1, lag, lag * between(0.1, 0.6), gain);
    if (seed % 3 == 1) process = lags({lag, lag * 0.4}, lag * between(0.05, 0.4), gain);
    if (seed % 3 == 2) process = equalLags(3, lag, 0, gain);
    const double cycle = process.timeScale() / 150;
    const auto gains = tune(process, seed % 2 ? Rule::Simc : Rule::Optimum,
                            {ControllerKind::Pi, between(0.1, 0.6), 0.5, samplingDelay(cycle)});
    EXPECT_TRUE(gains);
    Illness ill{*gains, 0, 0, 60, between(0.002, 0.03), cycle, 24'000, seed};
    const LoopFigures sound = analyse(process, ill.gains, cycle / 2);
    double limit = 1e9;
    if (illness == Cause::Tuning) {
        ill.gains.gain *= sound.gainMargin * between(0.97, 1.1);
        limit = 60 / gain;
    } else if (illness == Cause::Stiction) {
        ill.stick = between(0.3, 3) / gain;
    } else {
        ill.disturbance = between(1, 4);
        ill.disturbancePeriod = 2 * std::numbers::pi / (sound.crossover * between(0.3, 1.2));
    }
    const LoopFigures figures = analyse(process, ill.gains, cycle / 2);
    const double sensitivity = figures.isStable ? figures.sensitivity : 1e9;
    const Health health = healthOf(played(process, ill, limit), {{}, {}, sensitivity, figures.crossover});
    return health.oscillation ? health.oscillation->cause : Cause::None;
}

} // namespace

TEST(Health, TheCauseIsToldApartOverLoopsByChance) {
    constexpr unsigned kLoops = 30;
    std::map<Cause, std::map<Cause, unsigned>> percent; // ill, said
    for (const Cause illness : {Cause::Tuning, Cause::Stiction, Cause::Outside}) {
        for (unsigned seed = 0; seed < kLoops; ++seed) ++percent[illness][diagnosed(illness, seed)];
        for (auto& [said, count] : percent[illness]) count = 100 * count / kLoops;
    }
    EXPECT_GE(percent[Cause::Tuning][Cause::Tuning], 95U);
    EXPECT_GE(percent[Cause::Outside][Cause::Outside], 90U);
    EXPECT_GE(percent[Cause::Stiction][Cause::Stiction], 70U);
    // nobody takes out a valve that is well
    EXPECT_EQ(percent[Cause::Tuning][Cause::Stiction], 0U);
    EXPECT_EQ(percent[Cause::Outside][Cause::Stiction], 0U);
}

TEST(Health, AnOscillationAroundAnOffsetIsSeen) {
    LoopSeries series;
    for (int i = 0; i < 2000; ++i) { // no integral part: the error is never 0
        series.time.push_back(i * 0.1);
        series.setPoint.push_back(10);
        series.output.push_back(7 + std::sin(i * 0.1));
        series.input.push_back(2 * (3 - std::sin(i * 0.1)));
    }
    const Health health = healthOf(series, {});
    ASSERT_TRUE(health.oscillation);
    EXPECT_NEAR(health.oscillation->period, 2 * std::numbers::pi, 0.1);
    EXPECT_NEAR(health.oscillation->amplitude, 1, 0.1);
}
