// Sines planted in recordings are found with their frequency and amplitude; a lag answers as its formula says.
#include "projects/waveform/derivation.h"
#include "projects/waveform/runs.h"
#include "projects/waveform/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace plc::waveform;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Samples sampled(size_t count, double interval, const std::function<double(double)>& f) {
    Samples out;
    for (size_t i = 0; i < count; ++i) {
        out.time.push_back(static_cast<double>(i) * interval);
        out.value.push_back(f(out.time.back()));
    }
    return out;
}

} // namespace

TEST(Spectrum, FindsTwoSinesInNoise) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.5);
    const Samples samples = sampled(60'000, 0.001, [&](double t) {
        return 20 + 3 * std::sin(kTurn * 12.3 * t) + 0.8 * std::sin(kTurn * 50.7 * t + 1) + noise(random);
    });
    const auto spectrum = spectrumOf(samples);
    ASSERT_TRUE(spectrum);
    EXPECT_NEAR(spectrum->mean, 20, 0.05);
    const std::vector<Peak> peaks = spectrum->peaks(2);
    ASSERT_EQ(peaks.size(), 2U);
    EXPECT_NEAR(peaks[0].frequency, 12.3, 0.01);
    EXPECT_NEAR(peaks[0].amplitude, 3, 0.06);
    EXPECT_NEAR(peaks[1].frequency, 50.7, 0.01);
    EXPECT_NEAR(peaks[1].amplitude, 0.8, 0.03);
}

TEST(Spectrum, TheFlatTopMeasuresAmplitudesBetweenTheLines) {
    for (const double frequency : {10.0, 10.07, 10.11}) {
        const Samples samples = sampled(8192, 0.001, [&](double t) { return 2 * std::sin(kTurn * frequency * t); });
        const auto spectrum = spectrumOf(samples, {Window::FlatTop, 1 << 13});
        ASSERT_TRUE(spectrum);
        EXPECT_NEAR(*std::max_element(spectrum->amplitude.begin(), spectrum->amplitude.end()), 2, 0.01) << frequency;
    }
}

TEST(Spectrum, TooFewSamplesAndOneInstantAreSaidToBeSo) {
    EXPECT_FALSE(spectrumOf({}));
    EXPECT_FALSE(spectrumOf({{1}, {2}}));
    Samples still; // a broken time column
    still.time.assign(100, 3.0);
    still.value.assign(100, 1.0);
    const auto none = spectrumOf(still);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.english().find("too few"), std::string::npos);
}

TEST(Spectrum, GapsHoldTheValueBefore) {
    Samples samples = sampled(4000, 0.01, [](double t) { return std::sin(kTurn * 2 * t); });
    for (size_t i = 1000; i < 1050; ++i) samples.value[i] = std::nan("");
    const auto spectrum = spectrumOf(samples);
    ASSERT_TRUE(spectrum);
    ASSERT_FALSE(spectrum->peaks(1).empty());
    EXPECT_NEAR(spectrum->peaks(1)[0].frequency, 2, 0.02);
}

TEST(FrequencyResponse, OfALagIsItsFormula) {
    constexpr double kInterval = 0.01, kLag = 0.5, kGain = 2;
    std::mt19937 random(11);
    std::normal_distribution<double> normal(0, 1);
    Samples input, output;
    double state = 0;
    for (int i = 0; i < 200'000; ++i) {
        const double u = normal(random);
        input.time.push_back(i * kInterval);
        output.time.push_back(i * kInterval);
        input.value.push_back(u);
        output.value.push_back(state);
        state += (kGain * u - state) * (1 - std::exp(-kInterval / kLag));
    }
    const auto points = frequencyResponse(input, output);
    ASSERT_TRUE(points);
    size_t compared = 0;
    for (const ResponsePoint& point : *points) {
        if (point.frequency < 0.05 || point.frequency > 2) continue;
        const double omega = kTurn * point.frequency;
        const std::complex<double> right =
            kGain / (1.0 + std::complex<double>(0, omega * kLag)) * std::polar(1.0, -omega * kInterval / 2);
        EXPECT_LT(std::abs(point.gain - right) / std::abs(right), 0.2) << point.frequency;
        EXPECT_GT(point.coherence, 0.9) << point.frequency;
        ++compared;
    }
    EXPECT_GT(compared, 100U);
}

TEST(FrequencyResponse, AnInputThatDoesNotMoveIsSaidToBeSo) {
    const Samples still = sampled(1000, 0.1, [](double) { return 4.0; });
    const Samples moving = sampled(1000, 0.1, [](double t) { return std::sin(t); });
    const auto none = frequencyResponse(still, moving);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.english().find("does not change"), std::string::npos);
}

TEST(Runs, StartAtTheirTriggersAndTheBandSaysWhereTheyDiffer) {
    const Samples samples = sampled(10'000, 0.01, [](double t) {
        const double within = std::fmod(t, 20);
        return (t > 60 ? 1.5 : 1.0) * (1 - std::exp(-within / 2));
    });
    const std::vector<plc::waveform::Run> runs = alignedRuns(samples, {20, 40, 60, 80}, 1, 10);
    ASSERT_EQ(runs.size(), 4U);
    for (const plc::waveform::Run& run : runs) {
        EXPECT_GE(run.samples.time.front(), -1.0 - 1e-9);
        EXPECT_LE(run.samples.time.back(), 10.0 + 1e-9);
    }
    const RunBand band = bandOf(runs, 200);
    ASSERT_EQ(band.time.size(), 200U);
    EXPECT_NEAR(band.widest, 0.5, 0.05);
    EXPECT_TRUE(alignedRuns(samples, {5000}, 1, 1).size() <= 1);
    EXPECT_TRUE(bandOf({}, 10).time.empty());
}

TEST(Derivation, PeelsTheOperationsOffTheExpression) {
    const auto found = parseDerivation(" derivative( FILTER(Main.Level - LIMIT(0.0, Main.Out, 1.0), T#1s500ms) ) ");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->expression, "Main.Level - LIMIT(0.0, Main.Out, 1.0)");
    ASSERT_EQ(found->operations.size(), 2U);
    EXPECT_EQ(found->operations[0].kind, OperationKind::Filter);
    EXPECT_DOUBLE_EQ(found->operations[0].time, 1.5);
    EXPECT_EQ(found->operations[1].kind, OperationKind::Derivative);
    const auto plain = parseDerivation("LIMIT(0.0, Main.Out, 1.0) * 2.0");
    ASSERT_TRUE(plain);
    EXPECT_TRUE(plain->isPlain());
}

TEST(Derivation, WhatItCannotDoIsSaidWithTheRemedy) {
    for (const auto& [text, words] :
         {std::pair{"FILTER(Main.Level)", "needs a time"}, std::pair{"FILTER(Main.Level, T#0s)", "needs a time"},
          std::pair{"FILTER(Main.Level, soon)", "needs a time"}, std::pair{"DERIVATIVE(a, b)", "takes one expression"},
          std::pair{"INTEGRAL(a) + 1.0", "enclose the whole expression"}, std::pair{"INTEGRAL(a", "parenthesis"}}) {
        const auto refused = parseDerivation(text);
        ASSERT_FALSE(refused) << text;
        EXPECT_NE(refused.error().message.english().find(words), std::string::npos)
            << refused.error().message.english();
    }
}

TEST(Derivation, OperationsFollowTheirFormulas) {
    const auto last = [](const std::string& text, const std::function<double(double)>& f) {
        Deriver deriver(*parseDerivation(text));
        double out = 0;
        for (int i = 0; i <= 2000; ++i) out = deriver.next(i * 0.001, f(i * 0.001));
        return out;
    };
    EXPECT_NEAR(last("DERIVATIVE(x)", [](double t) { return 3 * t; }), 3, 1e-9);
    EXPECT_NEAR(last("INTEGRAL(x)", [](double t) { return t; }), 2, 0.002);
    EXPECT_NEAR(last("FILTER(x, T#1s)", [](double) { return 5.0; }), 5, 1e-12);
    EXPECT_NEAR(last("FILTER(x, T#500ms)", [](double t) { return t < 1 ? 0.0 : 1.0; }), 1 - std::exp(-2), 1e-3);
    EXPECT_NEAR(last("DERIVATIVE(INTEGRAL(x))", [](double t) { return std::cos(t); }), std::cos(2), 1e-2);
}

TEST(Derivation, StartsAgainAfterAGap) {
    Deriver deriver(*parseDerivation("DERIVATIVE(x)"));
    (void)deriver.next(0, 0);
    EXPECT_DOUBLE_EQ(deriver.next(1, 2), 2);
    EXPECT_TRUE(std::isnan(deriver.next(2, std::nan(""))));
    EXPECT_DOUBLE_EQ(deriver.next(3, 1000), 0); // not a jump from before the gap
}
