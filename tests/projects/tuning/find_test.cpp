// Steps planted in long recordings are found, and nothing else is; what is not usable is said to be so, and why.
#include "projects/tuning/model/find.h"
#include "tests/projects/tuning/processes.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

using namespace plc::tuning;

namespace {

/// A loop by hand: the input steps at these samples, the output follows with noise and a slow drift.
struct Plan {
    ProcessModel process = equalLags(2, 20, 10, 2);
    double interval = 1;
    size_t samples = 0;
    std::vector<std::pair<size_t, double>> inputs; // from this sample on
    double noise = 0, inputNoise = 0, drift = 0;
    unsigned seed = 1;
};

LoopSeries play(const Plan& plan) {
    LoopSeries out;
    std::mt19937 random(plan.seed);
    std::normal_distribution<double> normal(0, 1);
    SampledProcess process(plan.process, plan.interval);
    double input = 0;
    size_t next = 0;
    for (size_t i = 0; i < plan.samples; ++i) {
        while (next < plan.inputs.size() && plan.inputs[next].first <= i) input = plan.inputs[next++].second;
        const double time = static_cast<double>(i) * plan.interval;
        out.time.push_back(time);
        out.input.push_back(40 + input + plan.inputNoise * normal(random));
        out.output.push_back(60 + process.output() + plan.noise * normal(random) + plan.drift * std::sin(time / 9000));
        process.advance(input);
    }
    return out;
}

} // namespace

TEST(FindSteps, OfADayNinetyFivePerCentAreFoundAndLessThanFiveAreFalse) {
    for (const double inputNoise : {0.0, 0.05}) {
        Plan plan;
        plan.samples = 86'400;
        plan.noise = 0.2;
        plan.inputNoise = inputNoise;
        plan.drift = 0.5;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> wait(300, 1800), height(-5, 5);
        double level = 0;
        for (double at = 600; at < 85'000; at += wait(random)) {
            double move = height(random);
            if (std::abs(move) < 1) move = move < 0 ? -1.5 : 1.5;
            level += move;
            plan.inputs.emplace_back(static_cast<size_t>(at), level);
        }
        const std::vector<FoundStep> found = findSteps(play(plan));
        size_t right = 0;
        for (const auto& [at, value] : plan.inputs)
            right += std::any_of(found.begin(), found.end(), [at = at](const FoundStep& step) {
                return step.isUsable() && step.step + 2 >= at && step.step <= at + 2;
            });
        EXPECT_GE(right * 100, plan.inputs.size() * 95) << "noise of the input " << inputNoise;
        EXPECT_LE((found.size() - std::min(found.size(), right)) * 100, plan.inputs.size() * 5) << inputNoise;
    }
}

namespace {

/// Of the steps in a day's recording, how many per cent are usable; each moves the output by so many times its noise.
double usableOf(double timesNoise, double drift, unsigned seed, double answer = 1) {
    Plan plan;
    plan.samples = 86'400;
    plan.noise = 0.2;
    plan.drift = drift;
    plan.seed = seed;
    const double height = timesNoise * plan.noise / plan.process.gain;
    plan.process.gain *= answer;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> wait(300, 1800);
    double level = 0;
    for (double at = 600; at < 85'000; at += wait(random)) {
        level += random() % 2 ? height : -height;
        plan.inputs.emplace_back(static_cast<size_t>(at), level);
    }
    const std::vector<FoundStep> found = findSteps(play(plan));
    const auto usable = std::count_if(found.begin(), found.end(), [](const auto& step) { return step.isUsable(); });
    EXPECT_EQ(found.size(), plan.inputs.size());
    return 100.0 * static_cast<double>(usable) / static_cast<double>(plan.inputs.size());
}

} // namespace

TEST(FindSteps, StepsOfFourTimesTheNoiseAreUsable) {
    for (const unsigned seed : {101U, 102U})
        for (const double drift : {0.0, 0.4}) {
            EXPECT_GE(usableOf(4, drift, seed), 95) << seed << " " << drift;
            EXPECT_GE(usableOf(3, drift, seed), 90) << seed << " " << drift;
        }
}

TEST(FindSteps, WhatTheProcessDoesNotAnswerIsNotUsable) {
    for (const unsigned seed : {101U, 102U})
        for (const double drift : {0.0, 0.4}) EXPECT_LT(usableOf(4, drift, seed, 1e-6), 5) << seed << " " << drift;
}

TEST(FindSteps, ADayOfNoiseAloneHasNone) {
    Plan plan;
    plan.samples = 86'400;
    plan.noise = plan.inputNoise = 0.3;
    EXPECT_TRUE(findSteps(play(plan)).empty());
}

TEST(FindSteps, IntegersOfAConverterAreSignalsToo) {
    // what a 16-bit input and output show: whole numbers that come and go by one
    for (const double inputNoise : {0.0, 0.03, 0.3}) {
        Plan plan;
        plan.samples = 40'000;
        plan.noise = 0.1;
        plan.inputNoise = inputNoise;
        plan.drift = 0.2;
        for (size_t i = 1; i < 40; ++i) plan.inputs.emplace_back(i * 950, i % 2 ? 4.0 : i % 4 ? 1.0 : -2.0);
        LoopSeries series = play(plan);
        for (std::vector<double>* column : {&series.input, &series.output})
            for (double& value : *column) value = std::round(value * 10);
        const std::vector<FoundStep> found = findSteps(series);
        EXPECT_EQ(found.size(), plan.inputs.size()) << inputNoise;
        const auto usable = std::count_if(found.begin(), found.end(), [](const auto& step) { return step.isUsable(); });
        EXPECT_GE(usable, 38) << inputNoise;
    }
}

TEST(FindSteps, ARampIsOneChange) {
    const std::vector<size_t> lengths = plc::kFewer == 1 ? std::vector<size_t>{5, 20, 60} : std::vector<size_t>{20};
    for (const double inputNoise : {0.0, 0.05})
        for (const size_t length : lengths) {
            Plan plan;
            plan.samples = 9000;
            plan.noise = 0.1;
            plan.inputNoise = inputNoise;
            double level = 0;
            for (size_t i = 1; i < 6; ++i) {
                const double next = level + (i % 2 ? 6 : -4);
                for (size_t k = 0; k < length; ++k)
                    plan.inputs.emplace_back(i * 1400 + k, level + (next - level) * double(k + 1) / double(length));
                level = next;
            }
            const auto result = study(play(plan));
            ASSERT_TRUE(result) << result.error().english();
            EXPECT_EQ(result->steps.size(), 5U) << length << " noise of the input " << inputNoise;
            EXPECT_NEAR(result->models.front().model.gain, 2, 0.06) << length;
        }
}

TEST(FindSteps, ASensorAtTheEndOfItsRangeIsSaid) {
    for (const double noise : {0.0, 0.02}) {
        Plan plan;
        plan.samples = 6000;
        plan.noise = noise;
        plan.inputs = {{1000, 8}, {2500, 0}, {4000, 3}};
        LoopSeries series = play(plan);
        for (double& value : series.output) value = std::min(value, 68.0); // the first step goes to 76
        const std::vector<FoundStep> found = findSteps(series);
        ASSERT_EQ(found.size(), 3U);
        EXPECT_EQ(found[0].verdict, Verdict::Saturated) << found[0].reason.english();
        EXPECT_NE(found[0].reason.english().find("end of its range"), std::string::npos);
        EXPECT_TRUE(found[2].isUsable()) << found[2].reason.english();
    }
}

TEST(FindSteps, AnOutputPutToItsLimitIsSaid) {
    Plan plan;
    plan.samples = 4000;
    plan.inputs = {{1000, 5}, {2500, 0}};
    LoopSeries series = play(plan); // 40 and 45
    series.low = 0;
    series.high = 45;
    const std::vector<FoundStep> found = findSteps(series);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NE(found[0].reason.english().find("limit"), std::string::npos) << found[0].reason.english();
    EXPECT_EQ(found[1].reason.english().find("limit"), std::string::npos) << found[1].reason.english();
}

TEST(FindSteps, SaysWhyOneIsNotUsable) {
    Plan plan;
    plan.samples = 4000;
    plan.noise = 0.1;
    plan.inputs = {{500, 4}, {1500, 4.001}, {2500, 8}, {2508, 2}};
    const std::vector<FoundStep> found = findSteps(play(plan));
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].verdict, Verdict::Usable);
    EXPECT_EQ(found[1].verdict, Verdict::Noisy);
    EXPECT_NE(found[1].reason.english().find("noise"), std::string::npos);
    EXPECT_EQ(found[2].verdict, Verdict::TooShort);
    EXPECT_EQ(found[3].verdict, Verdict::Usable);
    EXPECT_FALSE(found[3].startsAtRest);
}

TEST(FindSteps, OneAtTheVeryEndIsTooShort) {
    Plan plan;
    plan.samples = 1001;
    plan.inputs = {{200, 4}, {1000, 0}};
    const std::vector<FoundStep> found = findSteps(play(plan));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[1].reason.english(), "too short: 1 sample until the next change or the end");
}

TEST(FindSteps, OneWithAGapIsNotUsed) {
    Plan plan;
    plan.samples = 3000;
    plan.inputs = {{500, 4}, {1500, 0}};
    LoopSeries series = play(plan);
    for (std::vector<double>* column : {&series.time, &series.input, &series.output})
        column->erase(column->begin() + 515, column->begin() + 545);
    const std::vector<FoundStep> found = findSteps(series);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(found[0].isUsable());
    EXPECT_NE(found[0].reason.english().find("gap"), std::string::npos);
    EXPECT_TRUE(found[1].isUsable());
}

namespace {

/// A PI controller on the process, the set point stepped; the input is limited.
LoopSeries closedLoop(const ProcessModel& process, double gain, double integralTime, double limit, double noise) {
    LoopSeries out;
    const double cycle = 0.1;
    SampledProcess sampled(process, cycle);
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 1);
    double integral = 0;
    for (int i = 0; i < 6000; ++i) {
        const double setPoint = i < 600 ? 0 : i < 2400 ? 10 : i < 4200 ? 25 : 5;
        const double measured = sampled.output() + noise * normal(random), error = setPoint - measured;
        const double sum = gain * error + integral + gain * error * cycle / integralTime;
        if (std::abs(sum) < limit) integral += gain * error * cycle / integralTime;
        const double input = std::clamp(sum, -limit, limit);
        out.time.push_back(i * cycle);
        out.input.push_back(input);
        out.output.push_back(measured);
        out.setPoint.push_back(setPoint);
        sampled.advance(input);
    }
    return out;
}

} // namespace

TEST(Study, ModelsTheProcessInAClosedLoop) {
    const ProcessModel process = equalLags(1, 8, 2, 1.5);
    for (const double noise : {0.0, 0.1}) {
        const auto result = study(closedLoop(process, 1.5, 8, 1e9, noise));
        ASSERT_TRUE(result) << result.error().english();
        EXPECT_EQ(result->steps.size(), 3U);
        const ProcessModel& model = result->models.front().model;
        const double tolerance = noise > 0 ? 0.1 : 0.01;
        EXPECT_NEAR(model.gain, 1.5, 1.5 * tolerance) << formula(model);
        EXPECT_NEAR(model.deadTime + model.lagSum(), 10, 10 * tolerance) << formula(model);
    }
}

TEST(Study, AnIntegratorInAClosedLoopIsNoEndlessLag) {
    for (const double deadTime : {0.5, 2.0}) {
        ProcessModel process = lags({}, deadTime, 0.3);
        process.isIntegrating = true;
        const auto result = study(closedLoop(process, 1 / (0.3 * 4 * deadTime), 12 * deadTime, 1e9, 0));
        ASSERT_TRUE(result) << result.error().english();
        const ProcessModel& model = result->models.front().model;
        EXPECT_TRUE(model.isIntegrating) << formula(model);
        EXPECT_NEAR(model.gain, 0.3, 0.003) << formula(model);
        EXPECT_NEAR(model.deadTime + model.lagSum(), deadTime, 0.03 * deadTime) << formula(model);
    }
}

TEST(Study, RoundedTimesShiftNoSample) {
    // another tool writes whole milliseconds, or nine digits; the scans are even all the same
    for (const double digits : {1e3, 1e7}) {
        ProcessModel process = equalLags(1, 0.5, 0.5, 0.2);
        process.isIntegrating = true;
        const Excerpt ideal = stepOf(process, 14, 0, 1, 1, 600);
        LoopSeries series;
        for (size_t i = 0; i < ideal.input.size(); ++i)
            series.time.push_back(std::round(static_cast<double>(i) * ideal.interval * digits) / digits);
        series.input = ideal.input;
        series.output = ideal.output;
        const auto found = study(series);
        ASSERT_TRUE(found);
        const ProcessModel& model = found->models.front().model;
        EXPECT_NEAR(model.deadTime, 0.5, 0.005) << formula(model);
        EXPECT_NEAR(model.gain, 0.2, 0.002) << formula(model);
    }
}

TEST(Study, AControllerAtItsLimitIsSaturated) {
    const auto steps = findSteps(closedLoop(equalLags(1, 8, 2, 1.5), 1.5, 8, 5.5, 0));
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[1].verdict, Verdict::Saturated) << steps[1].reason.english();
}

TEST(Study, ADisturbedStepIsLeftOut) {
    Plan plan;
    plan.samples = 4000;
    plan.noise = 0.05;
    plan.inputs = {{500, 4}, {1500, 0}, {2500, 4}};
    LoopSeries series = play(plan);
    for (size_t i = 1550; i < 2500; ++i)
        series.output[i] += 12 * std::sin(static_cast<double>(i - 1550) / 95 * 2 * M_PI);
    const auto result = study(series);
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_EQ(result->steps[1].verdict, Verdict::Disturbed);
    EXPECT_EQ(result->used.size(), 2U);
    EXPECT_NEAR(result->models.front().model.gain, 2, 0.1);
}

TEST(Study, WithoutAStepSaysWhatToDo) {
    Plan plan;
    plan.samples = 500;
    const auto result = study(play(plan));
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().english().find("set point"), std::string::npos);
}

TEST(Csv, ReadsWhatOtherToolsWrite) {
    std::string text = "\xEF\xBB\xBFTime [ms];Valve;\"Level; tank\"\r\n";
    for (int i = 0; i < 30; ++i) text += std::to_string(i * 100) + ";" + std::to_string(i / 10) + ",5;1,25\r\n";
    const auto series = parseCsv(text, {"valve", "Level; tank", ""});
    ASSERT_TRUE(series) << series.error().english();
    EXPECT_EQ(series->size(), 30U);
    EXPECT_DOUBLE_EQ(series->time[1], 0.1);
    EXPECT_DOUBLE_EQ(series->input[15], 1.5);
    EXPECT_DOUBLE_EQ(series->output[3], 1.25);
}

TEST(Csv, DatesCountFromTheFirstSample) {
    std::string text = "timestamp,u,y\n";
    for (int i = 0; i < 30; ++i) text += std::to_string(1774742280000 + i * 250) + ",1," + std::to_string(i) + "\n";
    const auto series = parseCsv(text, {"u", "y", ""});
    ASSERT_TRUE(series) << series.error().english();
    EXPECT_NEAR(series->time[0], 0, 1e-6);
    EXPECT_NEAR(series->time[29], 7.25, 1e-6);
}

TEST(Csv, RowsBeforeTheFirstValueAreLeftOut) {
    std::string text = "time_s,u,y\n0,,\n1,5,\n";
    for (int i = 2; i < 40; ++i) text += std::to_string(i) + ",5," + std::to_string(i) + "\n";
    const auto series = parseCsv(text, {"u", "y", ""});
    ASSERT_TRUE(series);
    EXPECT_EQ(series->time.front(), 2);
    EXPECT_EQ(series->output.front(), 2);
    EXPECT_EQ(series->size(), 38U);
}

TEST(Csv, NamesWhatIsWrong) {
    const auto problem = [](const std::string& text, const CsvColumns& columns) {
        const auto series = parseCsv(text, columns);
        return series ? std::string("none") : series.error().english();
    };
    EXPECT_NE(problem("a,b\n1,2\n", {"a", "b", ""}).find("no column of times"), std::string::npos);
    EXPECT_NE(problem("t,valve,level\n1,2,3\n", {"valv", "level", ""}).find("valve"), std::string::npos);
    EXPECT_NE(problem("t,a,b\n1,2,3\nx,2,3\n", {"a", "b", ""}).find("Line 3"), std::string::npos);
    EXPECT_NE(problem("t,a,b\n2,2,3\n1,2,3\n", {"a", "b", ""}).find("line 3"), std::string::npos);
    EXPECT_NE(problem("t,a,b\n1,2,3\n", {"a", "b", ""}).find("too few"), std::string::npos);
    EXPECT_NE(problem("", {"a", "b", ""}), "none");
}
