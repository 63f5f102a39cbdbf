// What is said of loops that were made to be ill in a known way.
#include "projects/tuning/health.h"
#include "projects/tuning/loop.h"
#include "projects/tuning/loop_report.h"
#include "projects/tuning/proposal.h"
#include "projects/tuning/rules.h"
#include "tests/projects/tuning/processes.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

using namespace plc::tuning;

namespace {

/// How a valve sticks: it jumps to where the controller wants it; it jumps, and stays behind; or it follows once it has
/// moved, until the controller turns round (two parameters).
enum class Friction : uint8_t { Jump, Behind, Follow };
enum class Wave : uint8_t { Sine, Square, TwoSines, Harmonics, Rising, Falling, Triangle };

struct Illness {
    ControllerGains gains{1, 8, 0, 0};
    double stick = 0; // how far the controller's output moves before the valve does
    double slide = 0; // by how much the valve then stays behind
    Friction friction{};
    double disturbance = 0; // from outside
    Wave wave{};
    bool isLoad = false; // it acts like the controller's output, not on what is measured
    double disturbancePeriod = 60;
    std::vector<std::pair<double, double>> harmonics; // from the second on: amplitude, phase
    double noise = 0;
    double cycle = 0.1;
    int scans = 8000;
    unsigned seed = 5;
};

class Valve {
public:
    explicit Valve(const Illness& illness) : m(illness) {}
    double next(double wanted) {
        const double moved = wanted - m_wanted;
        m_wanted = wanted;
        switch (m.friction) {
        case Friction::Jump:
            if (std::abs(wanted - m_at) >= m.stick) m_at = wanted;
            break;
        case Friction::Behind:
            m_pull += moved;
            if (std::abs(m_pull) > m.stick) {
                const double left = std::copysign(m.slide, m_pull);
                m_at += m_pull - left;
                m_pull = left;
            }
            break;
        case Friction::Follow:
            if (!m_isStuck && moved * m_moved <= 0) m_isStuck = true, m_stuckAt = wanted - moved;
            if (m_isStuck && m_direction * (wanted - m_stuckAt) <= -(m.stick + m.slide))
                m_direction = -m_direction, m_isStuck = false;
            else if (m_isStuck && m_direction * (wanted - m_stuckAt) > m.stick - m.slide)
                m_isStuck = false;
            if (!m_isStuck) m_at = wanted - m_direction * m.slide;
            m_moved = moved;
            break;
        }
        return m_at;
    }

private:
    const Illness& m;
    double m_at = 0, m_wanted = 0, m_pull = 0, m_moved = 0, m_stuckAt = 0, m_direction = 1;
    bool m_isStuck = true;
};

double waveAt(const Illness& illness, double turns) {
    const double angle = 2 * std::numbers::pi * turns;
    switch (illness.wave) {
    case Wave::Sine:
        return std::sin(angle);
    case Wave::Square:
        return std::sin(angle) >= 0 ? 1 : -1;
    case Wave::TwoSines:
        return std::sin(angle) + 0.4 * std::sin(3 * angle + 1);
    case Wave::Rising:
        return 2 * (turns + 0.25 - std::floor(turns + 0.25)) - 1;
    case Wave::Falling:
        return 1 - 2 * (turns + 0.25 - std::floor(turns + 0.25));
    case Wave::Triangle:
        return 4 * std::abs(turns + 0.25 - std::floor(turns + 0.25) - 0.5) - 1;
    case Wave::Harmonics:
        break;
    }
    double sum = std::sin(angle), order = 2;
    for (const auto& [amplitude, phase] : illness.harmonics) sum += amplitude * std::sin(order++ * angle + phase);
    return sum;
}

LoopSeries played(const ProcessModel& process, const Illness& illness, double limit = 1e9) {
    LoopSeries out;
    const double cycle = illness.cycle;
    SampledProcess sampled(process, cycle);
    std::mt19937 random(illness.seed);
    std::normal_distribution<double> normal(0, 1);
    double integral = 0;
    Valve valve(illness);
    for (int i = 0; i < illness.scans; ++i) {
        const double time = i * cycle, setPoint = 10;
        const double outside = illness.disturbance * waveAt(illness, time / illness.disturbancePeriod);
        const double measured = sampled.output() + illness.noise * normal(random) + (illness.isLoad ? 0 : outside);
        const double error = setPoint - measured;
        const double step = illness.gains.gain * error * cycle / illness.gains.integralTime;
        const double sum = illness.gains.gain * error + integral + step;
        if (std::abs(sum) < limit) integral += step;
        const double input = std::clamp(sum, -limit, limit);
        out.time.push_back(time);
        out.input.push_back(input);
        out.output.push_back(measured);
        out.setPoint.push_back(setPoint);
        sampled.advance((illness.stick > 0 ? valve.next(input) : input) + (illness.isLoad ? outside : 0));
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
    const Illness none{.gains = {1.2, 8, 0, 0}, .noise = 0.02};
    const Health health = healthOf(played(process, none), limitsFor(process, none));
    EXPECT_FALSE(health.oscillation);
    EXPECT_NEAR(health.noise, 0.02, 0.005);
    EXPECT_EQ(health.timeAtLimit, 0);
    EXPECT_EQ(wordsOf(health).size(), 1U);
}

TEST(Health, SettingsAtTheEdgeAreToBlame) {
    const ProcessModel process = equalLags(1, 8, 2, 1.5);
    const Illness lively{.gains = {4.1, 8, 0, 0}, .noise = 0.02};
    const Health health = healthOf(played(process, lively, 60), limitsFor(process, lively));
    ASSERT_TRUE(health.oscillation);
    EXPECT_EQ(health.oscillation->cause, Cause::Tuning);
    EXPECT_NEAR(health.oscillation->period, 8, 2.5);
}

TEST(Health, ASineFromOutsideIsOutside) {
    const ProcessModel process = equalLags(1, 8, 2, 1.5);
    const Illness outside{.gains = {1.0, 8, 0, 0}, .disturbance = 3, .noise = 0.02};
    const Health health = healthOf(played(process, outside), limitsFor(process, outside));
    ASSERT_TRUE(health.oscillation);
    EXPECT_NEAR(health.oscillation->period, 60, 2);
    EXPECT_EQ(health.oscillation->cause, Cause::Outside);
}

TEST(Health, AValveThatSticksIsToBlame) {
    const ProcessModel process = equalLags(1, 1.5, 0.3, 1.5);
    const Illness sticks{.gains = {0.3, 4, 0, 0}, .stick = 1.5, .noise = 0.01};
    const Health health = healthOf(played(process, sticks), limitsFor(process, sticks));
    ASSERT_TRUE(health.oscillation);
    EXPECT_EQ(health.oscillation->cause, Cause::Stiction);
    // before somebody takes the valve out
    EXPECT_NE(wordsOf(health)[1].english().find("manual"), std::string::npos);
}

TEST(Health, TimeAtALimitAndTheErrorAreCounted) {
    const ProcessModel process = equalLags(1, 8, 2, 1.5);
    const Illness none{.gains = {1.2, 8, 0, 0}};
    LoopLimits limits = limitsFor(process, none);
    limits.low = -5;
    limits.high = 5;
    const Health health = healthOf(played(process, none, 5), limits);
    EXPECT_GT(health.timeAtLimit, 0.8);
    EXPECT_NEAR(health.meanError, 2.5, 0.6);
    EXPECT_EQ(wordsOf(health).size(), 2U);
}

namespace {

struct FromOutside {
    std::optional<Wave> wave; // none: by chance, a ramp not among them
    bool isLoad = false;
};

/// A loop by chance, ill in one way: at the edge of stability, with a valve that sticks, or moved by a wave.
Cause diagnosed(Cause illness, unsigned seed, const FromOutside& outside = {}) {
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
    Illness ill{.gains = *gains, .noise = between(0.002, 0.03), .cycle = cycle, .scans = 24'000, .seed = seed};
    const LoopFigures sound = analyse(process, ill.gains, cycle / 2);
    double limit = 1e9;
    if (illness == Cause::Tuning) {
        ill.gains.gain *= sound.gainMargin * between(0.97, 1.1);
        limit = 60 / gain;
    } else if (illness == Cause::Stiction) {
        ill.stick = between(0.3, 3) / gain;
        ill.slide = ill.stick * (seed % 4 ? between(0.05, 0.9) : 0);
        ill.friction = static_cast<Friction>(seed / 2 % 3);
    } else {
        ill.disturbance = between(1, 4);
        ill.wave = outside.wave.value_or(static_cast<Wave>(seed / 3 % 4));
        ill.isLoad = outside.isLoad;
        if (ill.isLoad) ill.disturbance /= gain;
        ill.disturbancePeriod = 2 * std::numbers::pi / (sound.crossover * between(0.3, 1.2));
        for (int order = 2; order < 6; ++order) {
            const double amplitude = between(0.05, 0.5);
            ill.harmonics.emplace_back(amplitude, std::uniform_real_distribution<double>(0, 6.28)(random));
        }
    }
    const LoopFigures figures = analyse(process, ill.gains, cycle / 2);
    const double sensitivity = figures.isStable ? figures.sensitivity : 1e9;
    const Health health = healthOf(played(process, ill, limit), {{}, {}, sensitivity, figures.crossover});
    return health.oscillation ? health.oscillation->cause : Cause::None;
}

} // namespace

TEST(Health, TheCauseIsToldApartOverLoopsByChance) {
    constexpr unsigned kFirst = 20'000, kLoops = plc::repeats(60U);
    std::map<Cause, std::map<Cause, unsigned>> said; // of each illness, where the loop oscillates at all
    std::map<Cause, unsigned> all;
    for (const Cause illness : {Cause::Tuning, Cause::Stiction, Cause::Outside})
        for (unsigned seed = kFirst; seed < kFirst + kLoops; ++seed) // no limit was chosen on these
            if (const Cause cause = diagnosed(illness, seed); cause != Cause::None)
                ++said[illness][cause], ++all[illness];
    const auto percent = [&](Cause illness, Cause cause) { return 100 * said[illness][cause] / all[illness]; };
    EXPECT_GE(all[Cause::Stiction], kLoops * 8 / 10);
    EXPECT_GE(percent(Cause::Tuning, Cause::Tuning), 95U);
    EXPECT_GE(percent(Cause::Outside, Cause::Outside), 90U);
    EXPECT_GE(percent(Cause::Stiction, Cause::Stiction), 90U);
    // nobody takes out a valve that is well
    EXPECT_LT(100 * (said[Cause::Tuning][Cause::Stiction] + said[Cause::Outside][Cause::Stiction]),
              5 * (all[Cause::Tuning] + all[Cause::Outside]));
}

TEST(Health, SawteethAndTrianglesFromOutsideAreNotTheValve) {
    constexpr unsigned kFirst = 30'000, kLoops = plc::repeats(12U);
    unsigned all = 0, blamed = 0, either = 0;
    for (const Wave wave : {Wave::Rising, Wave::Falling, Wave::Triangle})
        for (const bool isLoad : {false, true})
            for (unsigned seed = kFirst; seed < kFirst + kLoops; ++seed) { // no limit was chosen on these
                const Cause cause = diagnosed(Cause::Outside, seed, {wave, isLoad});
                all += cause != Cause::None;
                blamed += cause == Cause::Stiction;
                either += cause == Cause::StictionOrOutside;
            }
    EXPECT_GE(all, 6 * kLoops * 8 / 10);
    EXPECT_LE(blamed * 100, all * 10);
    EXPECT_LE((blamed + either) * 100, all * 20);
}

TEST(Health, WhereBothExplainItAMinuteInManualTells) {
    Health health;
    health.oscillation = OscillationFinding{60, 1, 10, Cause::StictionOrOutside};
    const std::string words = wordsOf(health)[1].english();
    for (const char* word : {"sticking valve", "external", "manual"})
        EXPECT_NE(words.find(word), std::string::npos) << words;
}

TEST(Health, FiguresOfADayAreWrittenWithoutPowersOfTen) {
    Health health;
    health.duration = 86'400;
    health.integratedError = 12'345.6;
    health.effort = 0.25;
    const auto rows = healthRows(health);
    EXPECT_EQ(rows[0].second, "86400 s");
    EXPECT_EQ(rows[3].second, "12346");
    EXPECT_EQ(rows[4].second, "0.25");
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
