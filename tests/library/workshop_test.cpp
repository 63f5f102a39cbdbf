// The blocks that books on Structured Text build, right where the books slip.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace plc::test {
namespace {

const std::vector<std::string> workshop{"workshop"};

TEST(WorkshopEdges, SeeEachPressOnce) {
    Bench bench(
        "VAR o : R_OneShot; t : FBToggle; p : PulseCount; x : BOOL; n : INT; END_VAR",
        "o(CLK := x); IF o.Q THEN n := n + 1; END_IF t(CLK := x); p(Pulse := x, Amount := 0.1, Reset := FALSE);",
        workshop);
    for (int i = 0; i < 5; ++i) {
        bench.set("x", 1);
        bench.scan(3);
        bench.set("x", 0);
        bench.scan(3);
        EXPECT_EQ(bench.is("t.Q"), i % 2 == 0);
    }
    EXPECT_EQ(bench.integer("n"), 5);
    EXPECT_NEAR(bench.real("p.AmountTotal"), 0.5, 1e-6);
}

TEST(WorkshopFlashers, KeepTheTimesOfTheirNames) {
    Bench bench("VAR f : FB_LightFlash; p : FB_PulsePause; END_VAR",
                "f(Enable := TRUE, Value := T#1s); p(Enable := TRUE, PulseSec := 1, PauseSec := 3);", workshop, 100ms);
    int pulse = 0, flash = 0;
    for (int n = 0; n < 840; ++n) {
        bench.scan();
        pulse += bench.is("p.Q");
        flash += bench.is("f.Q");
    }
    EXPECT_NEAR(flash, 420, 30);
    EXPECT_NEAR(pulse, 210, 25) << "a quarter of the time, not three quarters";
}

TEST(AlarmDelay, IgnoresPulsesShorterThanItsDelay) {
    Bench bench("VAR a : AlarmOnOffDelay; x : BOOL; END_VAR",
                "a(IN := x, OnDelaySec := 5, OffDelaySec := 70, AlarmInhibit := FALSE);", workshop, 100ms);
    bench.set("x", 1);
    bench.scan(20);
    bench.set("x", 0);
    bench.scan();
    EXPECT_FALSE(bench.is("a.Q"));
    bench.scan(100);
    EXPECT_FALSE(bench.is("a.Q"));
    bench.set("x", 1);
    bench.scan(51);
    EXPECT_TRUE(bench.is("a.Q"));
    bench.set("x", 0);
    bench.scan(695);
    EXPECT_TRUE(bench.is("a.Q"));
    bench.scan(10);
    EXPECT_FALSE(bench.is("a.Q"));
}

TEST(AnalogAlarm, SwapsLimitsThatAreTheWrongWayRound) {
    Bench bench("VAR a : FB_AlarmAnalogValue; v : REAL := 7.0; END_VAR",
                "a(LimitH := 4.0, AnalogValue := v, LimitL := 10.0, AlarmDelay := T#2s);", workshop, 100ms);
    bench.scan(50);
    EXPECT_FALSE(bench.is("a.Q"));
    bench.set("v", 10.5);
    bench.scan(20);
    EXPECT_FALSE(bench.is("a.Q"));
    bench.scan(2);
    EXPECT_TRUE(bench.is("a.Q"));
}

TEST(Tonp, StandsStillDuringAPause) {
    Bench bench("VAR t : TONP; x, p : BOOL; END_VAR", "t(IN := x, PT := T#10s, PAUSE := p);", workshop, 100ms);
    bench.set("x", 1);
    bench.scan(41); // 4 s
    bench.set("p", 1);
    bench.scan(200);
    EXPECT_NEAR(double(bench.integer("t.ET")) * 1e-9, 4.0, 0.11);
    bench.set("p", 0);
    bench.scan(58);
    EXPECT_FALSE(bench.is("t.Q"));
    bench.scan(4);
    EXPECT_TRUE(bench.is("t.Q"));
    bench.set("p", 1);
    bench.scan();
    EXPECT_TRUE(bench.is("t.Q"));
}

TEST(Fifo, GivesBackInOrderAndDropsTheOldest) {
    Bench bench("VAR f : FIFO; x : REAL; s : INT; END_VAR", "f(DataIn := x, INOutStatus := s);", workshop);
    const auto put = [&](double value) {
        bench.set("x", value);
        bench.set("s", 1);
        bench.scan();
    };
    const auto take = [&] {
        bench.set("s", 2);
        bench.scan();
        return bench.real("f.DataOut");
    };
    for (int round = 0; round < 4; ++round) {
        for (int i = 1; i <= 3; ++i) put(i + 10 * round);
        for (int i = 1; i <= 3; ++i) EXPECT_DOUBLE_EQ(take(), i + 10 * round);
    }
    for (int i = 1; i <= 7; ++i) put(i);
    for (int i = 3; i <= 7; ++i) EXPECT_DOUBLE_EQ(take(), i);
    EXPECT_DOUBLE_EQ(take(), 7.0) << "empty: stays";
}

TEST(Rnd, CoversItsRangeEvenlyAndRepeats) {
    Bench bench("VAR a, b : RND; END_VAR", "a(Seed := 5, ValueMax := 5); b(Seed := 5, ValueMax := 5);", workshop);
    std::map<int64_t, int> counts;
    for (int n = 0; n < 6000; ++n) {
        bench.scan();
        ++counts[bench.integer("a.ValueRandom")];
        ASSERT_EQ(bench.integer("a.ValueRandom"), bench.integer("b.ValueRandom"));
    }
    EXPECT_EQ(counts.size(), 6u);
    for (const auto& [value, count] : counts) {
        EXPECT_GE(value, 0);
        EXPECT_LE(value, 5);
        EXPECT_NEAR(count, 1000, 150) << value;
    }
}

TEST(LowPass, FollowsItsGeometricSeries) {
    Bench bench("VAR f : LP_Filter; END_VAR", "f(ValueRaw := 10.0, k := 0.1);", workshop);
    for (int n = 1; n <= 60; ++n) {
        bench.scan();
        ASSERT_NEAR(bench.real("f.ValueFiltered"), 10 * (1 - std::pow(0.9, n)), 1e-4);
    }
}

TEST(DataCollect, MeasuresTenSecondsAfterItsStart) {
    Bench bench("VAR d : DataCollect; e : BOOL; END_VAR", "d(Enabled := e, Flow := 4.0, Power := 1000.0);", workshop,
                100ms);
    bench.scan(150);
    EXPECT_FALSE(bench.is("d.Done")) << "not started";
    bench.set("e", 1);
    bench.scan(99);
    EXPECT_FALSE(bench.is("d.Done"));
    EXPECT_DOUBLE_EQ(bench.real("d.ValueResult"), 1000.0);
    bench.scan(3);
    EXPECT_TRUE(bench.is("d.Done"));
    EXPECT_DOUBLE_EQ(bench.real("d.ValueResult"), 250.0);
}

TEST(RobotSim, IsDoneAfterItsProgram) {
    Bench bench("VAR r : RobotSim; d : BOOL; END_VAR", "r(DI1 := d, PrgCycle := T#7s);", workshop, 100ms);
    bench.set("d", 1);
    bench.scan();
    bench.set("d", 0);
    bench.scan(60);
    EXPECT_FALSE(bench.is("r.DO1"));
    bench.scan(12);
    EXPECT_TRUE(bench.is("r.DO1"));
}

TEST(WorkshopFunctions, GiveTheNumbersOfTheirExamples) {
    Bench bench("VAR a, f, s, t, t2 : REAL; i, o : BOOL; n1, n2, n3, n4 : INT; END_VAR",
                "a := ValueAverage(85.1, 17.6); f := fcTemperatureCalculateCtoF(23.6); i := FC_InsideRange(50, 10, "
                "90); o := FC_InsideRange(95, 10, 90);\n"
                "s := Scale(12.0, 4.0, 20.0, 0.0, 100.0); t := TankVolumenCal(2.0, 3.0, 1.0); t2 := "
                "TankVolumenCal(2.0, 3.0, 9.0);\n"
                "n1 := GetNoFromString(1, '1;20;300'); n2 := GetNoFromString(2, '1;20;300'); n3 := GetNoFromString(3, "
                "'1;20;300'); n4 := GetNoFromString(4, '1;20;300');",
                workshop);
    bench.scan();
    EXPECT_NEAR(bench.real("a"), 51.35, 1e-4);
    EXPECT_NEAR(bench.real("f"), 74.48, 1e-4);
    EXPECT_TRUE(bench.is("i"));
    EXPECT_FALSE(bench.is("o"));
    EXPECT_NEAR(bench.real("s"), 50.0, 1e-4);
    EXPECT_NEAR(bench.real("t"), 2.0 / 3 * M_PI, 1e-4);
    EXPECT_NEAR(bench.real("t2"), 2.0 / 3 * M_PI + 3 * M_PI, 1e-4);
    EXPECT_EQ(bench.integer("n1"), 1);
    EXPECT_EQ(bench.integer("n2"), 20);
    EXPECT_EQ(bench.integer("n3"), 300);
    EXPECT_EQ(bench.integer("n4"), 0);
}

TEST(Waves, HaveTheirFrequencyAndAmplitude) {
    Bench bench("VAR s : WaveSine; t : WaveTriangle; w : WaveSawtooth; q : WaveSquare; f : WaveSquareFiltered; END_VAR",
                "s(Hz := 0.5, Amplitude := 10.0); t(Hz := 0.5, Amplitude := 10.0); w(Hz := 0.5, Amplitude := 10.0); "
                "q(Hz := 0.5, Amplitude := 10.0); f(Hz := 0.5, Amplitude := 10.0, k := 0.2);",
                workshop);
    for (int n = 0; n < 1000; ++n) {
        bench.scan();
        const double p = std::fmod(n * 0.01 * 0.5, 1.0);
        ASSERT_NEAR(bench.real("s.Value"), 10 * std::sin(2 * M_PI * p), 1e-3) << n;
        if (n % 50 == 0) continue; // the corners themselves may fall either way
        ASSERT_NEAR(bench.real("t.Value"), 10 * (p < 0.25 ? 4 * p : p < 0.75 ? 2 - 4 * p : 4 * p - 4), 1e-3) << n;
        ASSERT_NEAR(bench.real("w.Value"), 10 * p, 1e-3) << n;
        ASSERT_NEAR(bench.real("q.Value"), p >= 0.5 ? 10.0 : 0.0, 1e-6) << n;
    }
    EXPECT_NEAR(bench.real("f.Value"), 10.0, 0.1);
}

} // namespace
} // namespace plc::test
