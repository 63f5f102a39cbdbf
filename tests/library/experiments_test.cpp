// The experiments that tuning needs: a relay and a step, their results, limits and aborts.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plc::test {
namespace {

const std::vector<std::string> util{"util"};

/// Three lags of 1 s, gain 2: ultimate gain 4 at a period of 2 pi / sqrt(3) s.
const char* const kProcess = "a := a + (y * 2.0 - a) * 0.01;\nb := b + (a - b) * 0.01;\nc := c + (b - c) * 0.01;\n";

Bench relayBench() {
    return Bench("VAR r : FB_RelayTest; on, abort : BOOL; ampl : REAL := 5.0; low : REAL := 0.0; high : REAL := 200.0; "
                 "max : TIME := T#10m; closed : REAL := 0.0; a, b, c : REAL := 100.0; y : REAL := 50.0; END_VAR",
                 "r(i_xEn := on, i_rPv := c, i_rSp := 100.0, i_rBias := 50.0, i_rAmpl := ampl, i_rHyst := 0.05, "
                 "i_rLowLim := low, i_rHighLim := high, i_tMax := max, i_xAbort := abort, i_rOutLow := closed, "
                 "i_rOutHigh := 100.0, q_rOput => y);\n" +
                     std::string(kProcess),
                 util);
}

TEST(RelayTest, FindsUltimateGainAndPeriod) {
    Bench bench = relayBench();
    bench.scan(10);
    EXPECT_FALSE(bench.is("r.q_xBusy"));
    EXPECT_DOUBLE_EQ(bench.real("y"), 50);
    bench.set("on", 1);
    bench.scan();
    EXPECT_TRUE(bench.is("r.q_xBusy"));
    for (int n = 0; n < 6000 && bench.is("r.q_xBusy"); ++n) {
        bench.scan();
        const double y = bench.real("y");
        ASSERT_TRUE(y == 55 || y == 45 || !bench.is("r.q_xBusy")) << y;
    }
    EXPECT_TRUE(bench.is("r.q_xDone"));
    EXPECT_FALSE(bench.is("r.q_xErr"));
    EXPECT_EQ(bench.integer("r.q_uiCount"), 4);
    // the describing function says a few per cent less or more
    EXPECT_NEAR(bench.real("r.q_rPeriod"), 2 * M_PI / std::sqrt(3.0), 0.3);
    EXPECT_NEAR(bench.real("r.q_rUltGain"), 4, 0.4);
    EXPECT_DOUBLE_EQ(bench.real("y"), 50);
}

TEST(RelayTest, AbortsAtALimitAndPutsOutTheBias) {
    Bench bench = relayBench();
    bench.set("high", 100.4);
    bench.set("on", 1);
    for (int n = 0; n < 3000 && !bench.is("r.q_xErr"); ++n) bench.scan();
    EXPECT_EQ(bench.integer("r.q_uiErrId"), 3);
    EXPECT_FALSE(bench.is("r.q_xBusy"));
    EXPECT_DOUBLE_EQ(bench.real("y"), 50);
    bench.set("on", 0);
    bench.scan();
    EXPECT_FALSE(bench.is("r.q_xErr"));
}

TEST(RelayTest, SaysWhyItDoesNotRun) {
    struct Row {
        const char* variable;
        double value;
        int error;
    };
    for (const Row& row : {Row{"ampl", 0, 1}, Row{"high", -1, 2}, Row{"low", 150, 3}, Row{"abort", 1, 5},
                           Row{"ampl", 50.1, 6}, Row{"ampl", -50.1, 6}, Row{"closed", 45.1, 6}}) {
        Bench bench = relayBench();
        bench.set(row.variable, row.value);
        bench.set("on", 1);
        bench.scan();
        EXPECT_EQ(bench.integer("r.q_uiErrId"), row.error) << row.variable;
        EXPECT_DOUBLE_EQ(bench.real("y"), 50) << row.variable;
    }
}

TEST(RelayTest, ASensorThatIsCutEndsIt) {
    for (const double cut :
         {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity(), -1.0}) {
        Bench bench = relayBench();
        bench.set("on", 1);
        bench.scan(100);
        ASSERT_TRUE(bench.is("r.q_xBusy"));
        bench.set("c", cut);
        bench.scan();
        EXPECT_EQ(bench.integer("r.q_uiErrId"), 3) << cut;
        EXPECT_DOUBLE_EQ(bench.real("y"), 50) << cut;
        EXPECT_FALSE(bench.is("r.q_xDone"));
    }
}

TEST(RelayTest, AProcessThatRunsAwayEndsIt) {
    // pushed by something else, beyond what the relay can hold
    Bench bench = relayBench();
    bench.set("high", 130);
    bench.set("on", 1);
    bench.scan(100);
    for (int n = 0; n < 2000 && bench.is("r.q_xBusy"); ++n) {
        bench.set("a", 180);
        bench.scan();
    }
    EXPECT_EQ(bench.integer("r.q_uiErrId"), 3);
    EXPECT_DOUBLE_EQ(bench.real("y"), 50);
}

TEST(RelayTest, EndsWhenItTakesTooLong) {
    Bench bench = relayBench();
    bench.set("ampl", 0.01); // never leaves the hysteresis
    bench.set("on", 1);
    bench.scan(60'002);
    EXPECT_EQ(bench.integer("r.q_uiErrId"), 4);
}

Bench stepBench() {
    return Bench("VAR s : FB_StepTest; on, abort : BOOL; pv : REAL := 10.0; step : REAL := 5.0; high : REAL := 20.0; "
                 "END_VAR",
                 "s(i_xEn := on, i_rPv := pv, i_rBias := 40.0, i_rStep := step, i_tBefore := T#1s, i_tAfter := T#2s, "
                 "i_rLowLim := 0.0, i_rHighLim := high, i_xAbort := abort, i_rOutLow := 0.0, i_rOutHigh := 100.0);",
                 util, 100ms);
}

TEST(StepTest, HoldsStepsAndComesBack) {
    Bench bench = stepBench();
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("s.q_rOput"), 40);
    bench.set("on", 1);
    for (int n = 0; n < 40; ++n) {
        bench.scan();
        const bool isStepped = n >= 10 && n < 30;
        ASSERT_DOUBLE_EQ(bench.real("s.q_rOput"), isStepped ? 45 : 40) << n;
        ASSERT_EQ(bench.is("s.q_xDone"), n >= 30) << n;
    }
    bench.set("on", 0);
    bench.scan();
    bench.set("on", 1);
    bench.scan();
    EXPECT_TRUE(bench.is("s.q_xBusy")) << "it can be repeated";
    EXPECT_FALSE(bench.is("s.q_xDone"));
}

TEST(StepTest, AbortsAtALimitAndByHand) {
    // a sensor that is cut says 0, its greatest value or nothing that is a number
    const double cut = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [variable, value, error] :
         {std::tuple{"pv", 25.0, 3}, std::tuple{"pv", -0.1, 3}, std::tuple{"pv", cut, 3}, std::tuple{"abort", 1.0, 5},
          std::tuple{"step", 0.0, 1}, std::tuple{"high", -1.0, 2}, std::tuple{"step", 60.1, 6},
          std::tuple{"step", -40.1, 6}}) {
        Bench bench = stepBench();
        bench.set("on", 1);
        bench.scan(15);
        EXPECT_DOUBLE_EQ(bench.real("s.q_rOput"), 45);
        bench.set(variable, value);
        bench.scan();
        EXPECT_EQ(bench.integer("s.q_uiErrId"), error) << variable;
        EXPECT_DOUBLE_EQ(bench.real("s.q_rOput"), 40) << variable;
    }
}

} // namespace
} // namespace plc::test
