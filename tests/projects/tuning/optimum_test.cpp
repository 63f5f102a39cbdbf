// The optimum against figures of the literature, and against its own definition where no figure is known.
#include "projects/tuning/optimum.h"
#include "tests/projects/tuning/processes.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

using namespace plc::tuning;

namespace {

struct Known {
    const char* name;
    ProcessModel process;
    double sensitivity, gain, integral;
};

std::vector<Known> known() {
    const auto rows = [](const char* name, const ProcessModel& process, std::vector<std::pair<double, double>> gains) {
        std::vector<Known> out;
        const double bounds[] = {1.4, 1.59, 2.0};
        for (size_t i = 0; i < gains.size(); ++i)
            out.push_back({name, process, bounds[i], gains[i].first, gains[i].second});
        return out;
    };
    std::vector<Known> all;
    for (const auto& some :
         {rows("1/(s+1)^3", equalLags(3), {{0.635, 0.3253}, {0.855, 0.4545}, {1.216, 0.6852}}),
          rows("1/(s+1)^4", equalLags(4), {{0.4335, 0.1920}, {0.5665, 0.2614}, {0.772, 0.378}}),
          rows("four lags", lags({1, 0.2, 0.04, 0.008}), {{1.93, 2.586}, {2.70, 4.00}, {4.14, 6.99}}),
          rows("e^-5s/(s+1)^3", equalLags(3, 1, 5), {{0.190, 0.0637}, {0.2405, 0.0842}, {0.310, 0.1162}}),
          rows("e^-s/(s+1)", equalLags(1, 1, 1), {{0.360, 0.373}, {0.458, 0.503}, {0.602, 0.714}}),
          rows("e^-s/(4s+1)", equalLags(1, 4, 1), {{1.178, 0.466}, {1.52, 0.672}, {2.03, 1.042}})})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

} // namespace

TEST(Optimum, GainsOfTheLiteratureWithinOnePerCent) {
    for (const Known& row : known()) {
        const auto found = optimum(row.process, ControllerKind::Pi, row.sensitivity);
        ASSERT_TRUE(found) << row.name << " Ms " << row.sensitivity;
        EXPECT_NEAR(found->gain, row.gain, 0.01 * row.gain) << row.name << " Ms " << row.sensitivity;
        EXPECT_NEAR(found->integralGain(), row.integral, 0.01 * row.integral) << row.name << " Ms " << row.sensitivity;
    }
}

namespace {

std::vector<std::pair<std::string, ProcessModel>> families() {
    std::vector<std::pair<std::string, ProcessModel>> out;
    for (int n = 2; n <= 8; ++n) out.emplace_back("(s+1)^-" + std::to_string(n), equalLags(n));
    for (const double alpha : {0.1, 0.3, 0.5, 0.7})
        out.emplace_back("four lags " + std::to_string(alpha), lags({1, alpha, alpha * alpha, alpha * alpha * alpha}));
    for (const double lag : {0.1, 0.5, 2.0, 10.0, 100.0}) {
        out.emplace_back("delay and lag " + std::to_string(lag), equalLags(1, lag, 1));
        out.emplace_back("delay and two lags " + std::to_string(lag), equalLags(2, lag, 1));
    }
    for (const double lag : {0.1, 1.0, 5.0}) {
        ProcessModel integrating = equalLags(1, lag, 0.5);
        integrating.isIntegrating = true;
        out.emplace_back("integrator " + std::to_string(lag), integrating);
    }
    for (const double zero : {0.2, 1.0, 2.0}) {
        ProcessModel inverse = equalLags(3);
        inverse.zero = -zero;
        out.emplace_back("right-half zero " + std::to_string(zero), inverse);
    }
    for (const double frequency : {1.0, 3.0}) {
        ProcessModel oscillating = lags({1});
        oscillating.oscillation = Oscillation{frequency, 0.3};
        out.emplace_back("oscillating " + std::to_string(frequency), oscillating);
    }
    return out;
}

} // namespace

TEST(Optimum, KeepsTheBoundAndIsStableOverAllFamilies) {
    for (const auto& [name, process] : families())
        for (const ControllerKind kind : {ControllerKind::Pi, ControllerKind::Pid})
            for (const double bound : {1.4, 2.0}) {
                const auto found = optimum(process, kind, bound);
                ASSERT_TRUE(found) << name;
                const LoopFigures figures = analyse(process, *found);
                EXPECT_TRUE(figures.isStable) << name << " " << bound << " kind " << int(kind);
                EXPECT_NEAR(figures.sensitivity, bound, 0.01 * bound) << name << " kind " << int(kind);
            }
}

TEST(Optimum, NoOtherGainsOfTheFamiliesHaveMoreIntegralAtTheSameRobustness) {
    for (const auto& [name, process] : families()) {
        const auto found = optimum(process, ControllerKind::Pi, 1.6);
        ASSERT_TRUE(found);
        for (int i = 0; i <= 30; ++i) {
            const double gain = found->gain * (0.05 + i * 0.08), integral = found->integralGain() * 1.01;
            const LoopFigures figures = analyse(process, {gain, gain / integral, 0, 0});
            EXPECT_FALSE(figures.isStable && figures.sensitivity < 1.6)
                << name << " gain " << gain << " of " << found->gain << " Ms " << figures.sensitivity;
        }
    }
}

namespace {

/// Resonances that only just fade, with lags and dead times of any size, of both signs.
std::vector<ProcessModel> resonances() {
    std::vector<ProcessModel> out;
    double gain = 0.4;
    for (const double damping : {0.012, 0.05, 0.2, 0.5})
        for (const auto& [lag, dead] : {std::pair{0.0, 0.1}, std::pair{0.0, 9.6}, std::pair{0.4, 0.0},
                                        std::pair{15.0, 0.14}, std::pair{3.0, 1.0}}) {
            ProcessModel model = lags(lag > 0 ? std::vector{lag} : std::vector<double>(), dead, gain = -gain * 1.3);
            model.oscillation = Oscillation{1, damping};
            out.push_back(model);
        }
    return out;
}

} // namespace

TEST(Optimum, AResonanceKeepsTheBoundAndNoOtherGainsAreBetter) {
    for (const ProcessModel& process : resonances())
        for (const double bound : {1.4, 2.0}) {
            const auto found = optimum(process, ControllerKind::Pi, bound);
            ASSERT_TRUE(found) << formula(process);
            const LoopFigures figures = analyse(process, *found);
            EXPECT_TRUE(figures.isStable) << formula(process);
            EXPECT_LT(figures.sensitivity, 1.01 * bound) << formula(process);
            const double largest = std::max(std::abs(found->gain), 0.2 / std::abs(process.gain));
            for (int i = 1; i <= 40; i += plc::kFewer) {
                const double gain = std::copysign(largest * i * 0.06, process.gain);
                for (const double factor : {1.012, 1.05, 1.2}) {
                    const double integral = found->integralGain() * factor;
                    const LoopFigures other = analyse(process, {gain, gain / integral, 0, 0});
                    EXPECT_FALSE(other.isStable && other.sensitivity < 0.999 * bound)
                        << formula(process) << " gain " << gain << " of " << found->gain << ", " << factor << " Ms "
                        << other.sensitivity;
                }
            }
        }
}

TEST(Optimum, ResonancesWithinOnePerCentOfAnotherSolver) {
    // by a search over a grid of both gains, with a stability test of its own
    ProcessModel slow = lags({}, 1179, -0.8031);
    slow.oscillation = Oscillation{1 / std::sqrt(1.513e4), 3.258 / 2 / std::sqrt(1.513e4)};
    for (const auto& [bound, integral] :
         {std::pair{1.4, 0.00041809}, std::pair{1.59, 0.00055916}, std::pair{2.0, 0.00078177}}) {
        const auto found = optimum(slow, ControllerKind::Pi, bound);
        ASSERT_TRUE(found);
        EXPECT_NEAR(-found->integralGain(), integral, 0.01 * integral) << bound;
        EXPECT_LT(found->gain, 0);
    }
}

TEST(Optimum, OtherMembersOfTheFamiliesWithinOnePerCentOfAnotherSolver) {
    // maximised by a search over a grid of gains and frequencies, written apart from this program
    const std::vector<Known> rows = {
        {"delay, lag 0.1", equalLags(1, 0.1, 1), 1.2, 0.10021, 0.24856},
        {"delay, two lags of 200", equalLags(2, 200, 1), 2, 5.0938, 0.01638},
        {"delay, two lags of 6", equalLags(2, 6, 1), 2, 1.9711, 0.24313},
        {"four lags, 0.5", lags({1, 0.5, 0.25, 0.125}), 1.4, 0.66644, 0.57022},
        {"delay, lag 6", equalLags(1, 6, 1), 1.59, 2.2408, 0.80713},
        {"delay of 0.5, three lags", equalLags(3, 1, 0.5), 1.59, 0.54471, 0.29527},
        {"delay, two lags of 0.3", equalLags(2, 0.3, 1), 1.4, 0.20854, 0.33195},
    };
    for (const Known& row : rows) {
        const auto found = optimum(row.process, ControllerKind::Pi, row.sensitivity);
        ASSERT_TRUE(found) << row.name;
        EXPECT_NEAR(found->gain, row.gain, 0.01 * row.gain) << row.name;
        EXPECT_NEAR(found->integralGain(), row.integral, 0.01 * row.integral) << row.name;
    }
}

TEST(Optimum, ANegativeProcessGetsANegativeGain) {
    const auto found = optimum(equalLags(3, 1, 0, -2), ControllerKind::Pi, 1.4);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->gain, -0.635 / 2, 0.005);
    EXPECT_TRUE(analyse(equalLags(3, 1, 0, -2), *found).isStable);
}

TEST(Optimum, WhatNothingLimitsHasNoAnswer) {
    EXPECT_FALSE(optimum(equalLags(1, 1, 0), ControllerKind::Pi, 1.4));
    EXPECT_TRUE(optimum(equalLags(1, 1, 0), ControllerKind::Pi, 1.4, 0.01)); // sampled it has an answer
}
