// Rules against their published formulas, margins against what can be worked out by hand, parameters against the
// blocks' limits.
#include "projects/tuning/block_forms.h"
#include "projects/tuning/proposal.h"
#include "tests/projects/tuning/processes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace plc::tuning;

TEST(Rules, SimcOfOneLagWithDeadTime) {
    const auto gains = tune(equalLags(1, 4, 1, 2), Rule::Simc, {ControllerKind::Pi, 0.5, 0.5, 0});
    ASSERT_TRUE(gains);
    EXPECT_NEAR(gains->gain, 4.0 / (2 * 2), 1e-9);
    EXPECT_NEAR(gains->integralTime, 4, 1e-9);
}

TEST(Rules, SimcShortensTheIntegralOfASlowProcess) {
    const auto gains = tune(equalLags(1, 100, 1, 1), Rule::Simc, {ControllerKind::Pi, 0.5, 0.5, 0});
    EXPECT_NEAR(gains->gain, 50, 1e-6);
    EXPECT_NEAR(gains->integralTime, 8, 1e-9);
}

TEST(Rules, SimcOfAnIntegratorAndOfTwoLagsWithDerivative) {
    ProcessModel integrating = equalLags(0, 1, 2, 0.5);
    integrating.isIntegrating = true;
    const auto gains = tune(integrating, Rule::Simc, {ControllerKind::Pi, 0.5, 0.5, 0});
    EXPECT_NEAR(gains->gain, 1 / (0.5 * 4), 1e-9);
    EXPECT_NEAR(gains->integralTime, 16, 1e-9);
    const auto serial = tune(lags({6, 2}, 1, 1), Rule::Simc, {ControllerKind::Pid, 0.5, 0.5, 0});
    // serial gain 3, integral 6, derivative 2
    EXPECT_NEAR(serial->gain, 3 * (1 + 2.0 / 6), 1e-9);
    EXPECT_NEAR(serial->integralTime, 8, 1e-9);
    EXPECT_NEAR(serial->derivativeTime, 1.5, 1e-9);
}

TEST(Rules, HalfRuleOfTheFourLags) {
    const FirstOrder first = halfRule(lags({1, 0.2, 0.04, 0.008}), false);
    EXPECT_NEAR(first.lag, 1.1, 1e-9);
    EXPECT_NEAR(first.deadTime, 0.148, 1e-9);
    const FirstOrder second = halfRule(lags({1, 0.2, 0.04, 0.008}), true);
    EXPECT_NEAR(second.secondLag, 0.22, 1e-9);
    EXPECT_NEAR(second.deadTime, 0.028, 1e-9);
}

TEST(Rules, AmigoOfOneLagWithDeadTime) {
    const double l = 1, t = 4, k = 2;
    const auto pi = tune(equalLags(1, t, l, k), Rule::Amigo, {ControllerKind::Pi, 0.5, 0.5, 0});
    EXPECT_NEAR(pi->gain, 0.15 / k + (0.35 - l * t / 25) * t / (k * l), 2e-3);
    EXPECT_NEAR(pi->integralTime, 0.35 * l + 13 * l * t * t / (t * t + 12 * l * t + 7 * l * l), 2e-2);
    const auto pid = tune(equalLags(1, t, l, k), Rule::Amigo, {ControllerKind::Pid, 0.5, 0.5, 0});
    EXPECT_NEAR(pid->gain, (0.2 + 0.45 * t / l) / k, 5e-3);
    EXPECT_NEAR(pid->derivativeTime, 0.5 * l * t / (0.3 * l + t), 5e-3);
}

TEST(Rules, EveryRuleIsStableOverItsProcessesAndCalmIsCalmerThanBrisk) {
    for (const ProcessModel& process : {equalLags(1, 4, 1), equalLags(3), equalLags(2, 5, 1, -3), equalLags(1, 0.5, 1)})
        for (const Rule rule : allRules())
            for (const ControllerKind kind : {ControllerKind::Pi, ControllerKind::Pid}) {
                const auto calm = tune(process, rule, {kind, 0.0, 0.5, 0.05});
                const auto brisk = tune(process, rule, {kind, 1.0, 0.5, 0.05});
                ASSERT_TRUE(calm && brisk) << title(rule);
                if (rule == Rule::ZieglerNichols) continue; // not what to take
                const LoopFigures figures = analyse(process, *calm, 0.05);
                EXPECT_TRUE(figures.isStable) << title(rule) << " " << formula(process);
                EXPECT_LE(figures.sensitivity, analyse(process, *brisk, 0.05).sensitivity + 1e-6) << title(rule);
            }
}

TEST(Rules, NoneForWhatHasNoGain) { EXPECT_FALSE(tune(equalLags(1, 1, 1, 0), Rule::Simc, {})); }

TEST(Loop, MarginsOfAnIntegratorWithDeadTime) {
    // k e^-s / s with k = 1: phase margin 90 - 57.3 degrees, gain margin pi/2
    ProcessModel process = equalLags(0, 1, 1);
    process.isIntegrating = true;
    const LoopFigures figures = analyse(process, {1, 0, 0, 0});
    EXPECT_TRUE(figures.isStable);
    EXPECT_NEAR(figures.crossover, 1, 1e-6);
    EXPECT_NEAR(figures.phaseMargin, 90 - 180 / std::numbers::pi, 1e-3);
    EXPECT_NEAR(figures.gainMargin, std::numbers::pi / 2, 1e-3);
    EXPECT_FALSE(analyse(process, {1.6, 0, 0, 0}).isStable);
    EXPECT_TRUE(analyse(process, {1.55, 0, 0, 0}).isStable);
    EXPECT_FALSE(analyse(process, {-0.5, 0, 0, 0}).isStable);
}

TEST(Loop, StabilityAgreesWithTheResponse) {
    for (const ProcessModel& process : {equalLags(3), equalLags(1, 1, 1), lags({1, 0.2, 0.04, 0.008})})
        for (const double gain : {0.2, 1.0, 4.0, 9.0, 30.0})
            for (const double integral : {0.5, 2.0, 10.0}) {
                const ControllerGains gains{gain, integral, 0, 0};
                const LoopFigures figures = analyse(process, gains, 0.005);
                if (figures.sensitivity > 20) continue; // too near to the edge for a short simulation
                const Trajectory way = setPointResponse(process, {gains, 0.01, {}, {}}, {1, 0, 900});
                const double last = std::abs(way.output.back() - 1);
                EXPECT_EQ(figures.isStable, last < 0.2) << formula(process) << " gain " << gain << " Ti " << integral;
            }
}

TEST(Loop, BodePhaseRunsOn) {
    const ProcessModel process = equalLags(1, 1, 3);
    const auto points = bode([&](double w) { return process.at(w); }, 0.01, 20, 800);
    EXPECT_NEAR(points.back().degrees, -(std::atan(20.0) + 60) * 180 / std::numbers::pi, 0.1);
    EXPECT_NEAR(points.front().decibels, 0, 0.01);
}

TEST(Process, SampledResponseIsExactWithAnyDeadTime) {
    SampledProcess process(equalLags(1, 2, 0.37, 3), 0.1);
    for (int i = 0; i < 100; ++i) {
        const double time = i * 0.1;
        const double expected = time < 0.37 ? 0 : 3 * (1 - std::exp(-(time - 0.37) / 2));
        EXPECT_NEAR(process.output(), expected, 1e-12);
        process.advance(1);
    }
}

TEST(Process, SettledStaysWhereItIs) {
    SampledProcess process(lags({3, 1}, 0.5, 2), 0.1);
    process.settle(4);
    for (int i = 0; i < 50; ++i) {
        EXPECT_NEAR(process.output(), 8, 1e-9);
        process.advance(4);
    }
}

TEST(Response, FiguresOfAStep) {
    const ControllerGains gains = *tune(equalLags(1, 4, 1), Rule::Simc, {});
    const Trajectory way = setPointResponse(equalLags(1, 4, 1), {gains, 0.01, {}, {}}, {1, 0, 40});
    const ResponseFigures figures = figuresOf(way, 1);
    EXPECT_NEAR(figures.overshoot, 4, 1.5);
    EXPECT_GT(figures.settlingTime, 3);
    EXPECT_LT(figures.settlingTime, 12);
    EXPECT_NEAR(way.output.back(), 1, 1e-3);
    const Trajectory limited = setPointResponse(equalLags(1, 4, 1), {gains, 0.01, -1.2, 1.2}, {1, 0, 40});
    EXPECT_LE(figuresOf(limited, 1).greatestInput, 1.2);
}

TEST(BlockForms, ParametersInTheBlocksOwnUnits) {
    const ControllerGains gains{7.5, 4.25, 0.5, 0.05};
    const auto formOf = [](std::string_view type) {
        for (const BlockForm& form : blockForms())
            if (form.type == type) return form;
        return BlockForm{};
    };
    const auto textsOf = [&](std::string_view type, double cycle) {
        std::string out;
        for (const ParameterValue& value : parametersOf(formOf(type), gains, cycle))
            out += value.member + "=" + value.text + (value.isLimited ? "!" : "") + " ";
        return out;
    };
    EXPECT_EQ(textsOf("FB_P", 0.1), "i_rKp=7.5 ");
    EXPECT_EQ(textsOf("FB_PI", 0.1), "i_stPara.rKp=7.5 i_stPara.tTn=T#4250ms ");
    EXPECT_EQ(textsOf("FB_PID", 0.01), "i_rKp=7.5 i_rTn=4250.0 i_rTv=500.0 i_rTd=50.0 ");
    EXPECT_EQ(textsOf("PID_FIXCYCLE", 0.01), "KP=7.5 TN=4.25 TV=0.5 ");
    EXPECT_EQ(parametersOf(formOf("PID_LREAL"), gains, 0.1).front().text, "-7.5");
    EXPECT_EQ(textsOf("FB_PI_PID", 0.1), "i_stParaPI.rKp=7.5 i_stParaPI.tTn=T#4250ms ");
}

TEST(BlockForms, WhatTheBlockDoesNotTakeIsLimitedAndSaid) {
    const auto formOf = [](std::string_view type) {
        for (const BlockForm& form : blockForms())
            if (form.type == type) return form;
        return BlockForm{};
    };
    const auto negative = parametersOf(formOf("FB_PI"), {-2, 4, 0, 0}, 0.1);
    EXPECT_TRUE(negative[0].isLimited);
    const auto slow = parametersOf(formOf("FB_PID"), {1, 300, 0, 0}, 0.1);
    EXPECT_EQ(slow[1].text, "60000.0");
    EXPECT_TRUE(slow[1].isLimited);
    EXPECT_EQ(slow.size(), 3U); // without a derivative the filter stays as it is
    const auto filtered = parametersOf(formOf("FB_PID"), {1, 30, 1, 0.01}, 0.1);
    EXPECT_GT(filtered[3].value, 0.1); // never quicker than the calls
    EXPECT_FALSE(filtered[3].isLimited);
}

TEST(BlockForms, ThereAndBackAreTheSameGains) {
    for (const BlockForm& form : blockForms()) {
        const ControllerGains gains{2.5, 12, 1.5, 0.25};
        std::vector<double> values;
        for (const ParameterValue& value : parametersOf(form, gains, 0.05)) {
            const ParameterForm& parameter = form.parameters[values.size()];
            values.push_back(parameter.unit == Unit::Milliseconds ? value.value * 1000 : value.value);
        }
        const ControllerGains back = gainsOf(form, values);
        EXPECT_NEAR(back.gain, 2.5, 1e-9) << form.type;
        if (form.kinds().size() > 1) {
            EXPECT_NEAR(back.integralTime, 12, 1e-9) << form.type;
        }
    }
}
