// Statistics between cursors, against values worked out by hand.
#include "editor/plot/model/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace plc::plot;

namespace {

constexpr int64_t Ms = 1'000'000;
const double NaN = std::numeric_limits<double>::quiet_NaN();

SampleList listOf(const std::vector<double>& values, int64_t step = Ms) {
    SampleList list;
    for (size_t i = 0; i < values.size(); ++i) list.append(static_cast<int64_t>(i) * step, values[i]);
    return list;
}

} // namespace

TEST(Measure, ExtremesMeanAndRms) {
    struct Row {
        std::vector<double> values;
        double minimum, maximum, mean, rms;
    };
    for (const Row& row : {Row{{5}, 5, 5, 5, 5}, Row{{1, 2, 3}, 1, 3, 2, std::sqrt(14.0 / 3)},
                           Row{{3, -4}, -4, 3, -0.5, std::sqrt(12.5)}, Row{{0, 0, 0, 0}, 0, 0, 0, 0},
                           Row{{NaN, 2, NaN, 4}, 2, 4, 3, std::sqrt(10.0)},
                           Row{{1e9 + 1, 1e9 + 3}, 1e9 + 1, 1e9 + 3, 1e9 + 2, 1e9 + 2}}) {
        const Measurement m = measure(listOf(row.values), 0, 100 * Ms);
        EXPECT_EQ(m.minimum, row.minimum);
        EXPECT_EQ(m.maximum, row.maximum);
        EXPECT_NEAR(m.mean, row.mean, 1e-9 * std::max(1.0, std::abs(row.mean)));
        EXPECT_NEAR(m.rms, row.rms, 1e-9 * std::max(1.0, row.rms));
    }
}

TEST(Measure, TakesBothEndsAndNothingBeyond) {
    const SampleList list = listOf({10, 1, 2, 3, 20});
    const Measurement m = measure(list, 1 * Ms, 3 * Ms);
    EXPECT_EQ(m.count, 3u);
    EXPECT_EQ(m.first, 1);
    EXPECT_EQ(m.last, 3);
    EXPECT_EQ(measure(list, 3 * Ms, 1 * Ms).count, 3u) << "cursors may be the other way round";
    EXPECT_EQ(measure(list, 10 * Ms, 20 * Ms).count, 0u);
}

TEST(Measure, SineOverWholePeriodsHasItsRms) {
    SampleList list;
    for (int i = 0; i < 10'000; ++i) list.append(i * Ms, 3 * std::sin(2 * M_PI * i / 1000.0));
    const Measurement m = measure(list, 0, 9'999 * Ms);
    EXPECT_NEAR(m.rms, 3 / std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(m.mean, 0, 1e-9);
}

TEST(Measure, FirstOrderLagRisesInItsTimeConstants) {
    // y = 1 - exp(-t/T): 10 to 90 % takes T ln 9; within 2 % after T ln 50.
    SampleList list;
    const double T = 0.1;
    for (int i = 0; i <= 20'000; ++i) list.append(i * Ms / 10, 1 - std::exp(-i * 1e-4 / T));
    MeasureOptions options;
    options.isHeld = false;
    const Measurement m = measure(list, 0, 2'000 * Ms, options);
    ASSERT_TRUE(m.riseTime && m.settlingTime && m.overshoot);
    EXPECT_NEAR(static_cast<double>(*m.riseTime), T * std::log(9.0) * 1e9, 2e5);
    EXPECT_NEAR(static_cast<double>(*m.settlingTime), T * std::log(50.0) * 1e9, 2e5);
    EXPECT_NEAR(*m.overshoot, 0, 1e-3);
}

TEST(Measure, SecondOrderOvershootsByItsDamping) {
    // Damping 0.5: overshoot exp(-pi d / sqrt(1 - d²)) = 16.3 %.
    SampleList list;
    const double d = 0.5, w = 10, wd = w * std::sqrt(1 - d * d);
    for (int i = 0; i <= 10'000; ++i) {
        const double t = i * 1e-3;
        list.append(i * Ms, 20 + 40 * (1 - std::exp(-d * w * t) * (std::cos(wd * t) + d * w / wd * std::sin(wd * t))));
    }
    const Measurement m = measure(list, 0, 10'000 * Ms);
    ASSERT_TRUE(m.overshoot && m.settlingTime);
    EXPECT_NEAR(*m.overshoot, 16.303, 0.01);
    EXPECT_NEAR(m.final, 60, 1e-6);
    EXPECT_NEAR(static_cast<double>(*m.settlingTime), 0.808e9, 5e6);
}

TEST(Measure, FallingStepsAreMeasuredAlike) {
    std::vector<double> up, down;
    for (int i = 0; i < 100; ++i)
        up.push_back(i < 10 ? 0 : std::min(1.0, (i - 10) / 9.7)), down.push_back(5 - up.back());
    const Measurement a = measure(listOf(up), 0, 99 * Ms), b = measure(listOf(down), 0, 99 * Ms);
    ASSERT_TRUE(a.riseTime && b.riseTime);
    EXPECT_EQ(*a.riseTime, 8 * Ms);
    EXPECT_EQ(*a.riseTime, *b.riseTime);
    EXPECT_EQ(a.settlingTime, b.settlingTime);
}

TEST(Measure, WithoutAStepThereIsNoStepResponse) {
    const Measurement m = measure(listOf({7, 7, 7, 7}), 0, 3 * Ms);
    EXPECT_FALSE(m.riseTime || m.overshoot || m.settlingTime);
    std::vector<double> restless; // leaves the band at the very end
    for (int i = 0; i < 100; ++i) restless.push_back(i < 50 ? 0 : 10);
    restless.push_back(14);
    EXPECT_FALSE(measure(listOf(restless), 0, 100 * Ms).settlingTime);
}

TEST(SampleList, AnswersLikeAChartNeeds) {
    SampleList list;
    for (int i = 0; i < 5; ++i) list.append(i * 10, i);
    list.append(35, 99); // before the last one
    EXPECT_EQ(list.countIn(0, 41), 5u);
    EXPECT_EQ(list.inForceAt(25)->value, 2);
    EXPECT_FALSE(list.inForceAt(-1));
    EXPECT_EQ(list.after(20)->time, 30);
    EXPECT_EQ(nearestSample(list, 26)->time, 30);
    EXPECT_EQ(nearestSample(list, -100)->time, 0);
    EXPECT_EQ(nearestSample(list, 1'000)->time, 40);
    std::vector<plc::SignalBucket> buckets(2);
    list.buckets(0, 50, buckets);
    EXPECT_EQ(buckets[0].count, 3u);
    EXPECT_EQ(buckets[0].last, 2);
    EXPECT_EQ(buckets[1].first, 3);
    list.keepNewest(2);
    EXPECT_EQ(list.timeRange()->first, 30);
}

TEST(ExactText, ReadsBackTheSame) {
    EXPECT_EQ(exactText(static_cast<double>(0.1f), PlotValueKind::Single), "0.1");
    EXPECT_EQ(exactText(0.1, PlotValueKind::Double), "0.1");
    EXPECT_EQ(exactText(-7, PlotValueKind::Integer), "-7");
    EXPECT_EQ(exactText(1, PlotValueKind::Bool), "1");
    EXPECT_EQ(exactText(NaN, PlotValueKind::Double), "");
    EXPECT_EQ(exactText(-INFINITY, PlotValueKind::Double), "-INF");
}
