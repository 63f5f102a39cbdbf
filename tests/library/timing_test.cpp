// Timing stays right where 32-bit milliseconds wrap elsewhere: 2^31 ms are 24.86 days, 2^32 ms are 49.71 days.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

namespace plc::test {
namespace {

constexpr Nanoseconds wraps[] = {Nanoseconds(std::chrono::milliseconds(int64_t{1} << 31)),
                                 Nanoseconds(std::chrono::milliseconds(int64_t{1} << 32))};

TEST(LongRuns, TimersCrossTheWrapOf32Bits) {
    for (const Nanoseconds wrap : wraps) {
        Bench bench("VAR on : TON; off : TOF; pulse : TP; lon : LTON; x : BOOL; END_VAR",
                    "on(IN := x, PT := T#5s); off(IN := NOT x, PT := T#5s); pulse(IN := x, PT := T#5s); lon(IN := x, "
                    "PT := LTIME#5s);",
                    {});
        bench.scan();
        bench.jumpTo(wrap - 2s);
        bench.set("x", 1);
        bench.scanUntil(wrap + 2980ms);
        EXPECT_FALSE(bench.is("on.Q"));
        EXPECT_TRUE(bench.is("off.Q"));
        EXPECT_TRUE(bench.is("pulse.Q"));
        EXPECT_FALSE(bench.is("lon.Q"));
        bench.scanUntil(wrap + 3010ms);
        EXPECT_TRUE(bench.is("on.Q"));
        EXPECT_FALSE(bench.is("off.Q"));
        EXPECT_FALSE(bench.is("pulse.Q"));
        EXPECT_TRUE(bench.is("lon.Q"));
        EXPECT_EQ(bench.integer("on.ET"), Nanoseconds(5s).count());
    }
}

TEST(LongRuns, ATimerMayRunFor60Days) {
    Bench bench("VAR on : TON; END_VAR", "on(IN := TRUE, PT := T#60d);", {}, 1h);
    bench.scan(60 * 24);
    EXPECT_FALSE(bench.is("on.Q"));
    bench.scan();
    EXPECT_TRUE(bench.is("on.Q"));
}

TEST(LongRuns, TheHourMeterCountsEveryHourOf100Days) {
    Bench bench(
        "VAR m : Hour_Meter; p : Par_HM; h : HMI_HM; END_VAR",
        "p.wTypeTime := 4; p.diWaitTime := 100000;\nm(i_xAut := TRUE, i_xIn := TRUE, i_strPara := p, iq_strHmi := h);",
        {"toolbox"}, 10min);
    bench.scan(100 * 24 * 6);
    EXPECT_EQ(bench.integer("m.q_diHr"), 2399);
    bench.scan();
    EXPECT_EQ(bench.integer("m.q_diHr"), 2400);
}

TEST(LongRuns, ClockedBlocksOfTheToolboxCrossTheWrap) {
    for (const Nanoseconds wrap : wraps) {
        Bench bench("VAR second : ONE_SEC_PULSE; multiplier : Frequency_Multiplier; output : Frequency_Output; pulses "
                    ": INT; on : INT; enable : BOOL; END_VAR",
                    "second(); IF second.q_xOput THEN pulses := pulses + 1; END_IF\n"
                    "multiplier(i_xEn := enable, i_tBase := T#100ms, i_xHold := FALSE);\n"
                    "output(i_xEn := enable, i_rInput := 0.25, i_rEdge := 0.1, i_tBase := T#1s); IF output.q_xOput "
                    "THEN on := on + 1; END_IF",
                    {"toolbox"});
        bench.scan();
        bench.jumpTo(wrap - 5s);
        bench.set("enable", 1);
        bench.scan();
        bench.set("pulses", 0);
        bench.set("on", 0);
        bench.scan(1000);
        EXPECT_EQ(bench.integer("pulses"), 10);
        EXPECT_EQ(bench.integer("multiplier.q_dwOput"), 100);
        EXPECT_EQ(bench.integer("on"), 250);
    }
}

TEST(LongRuns, AValveStillSupervisesItsFeedbackAcrossTheWrap) {
    for (const Nanoseconds wrap : wraps) {
        Bench bench("VAR v : Bistable_Valve; p : Par_Val_Bi; open : BOOL; END_VAR",
                    "p.xFbckEn := TRUE; p.iFbckDly := 5;\nv(i_xAut := TRUE, i_xAutOpen := open, i_xFbckCls := NOT "
                    "open, i_strPara := p);",
                    {"toolbox"}, 100ms);
        bench.scan();
        bench.jumpTo(wrap - 2s);
        bench.set("open", 1);
        bench.scanUntil(wrap + 2900ms);
        EXPECT_FALSE(bench.is("v.q_xErr"));
        bench.scanUntil(wrap + 3300ms);
        EXPECT_TRUE(bench.is("v.q_xErr"));
        EXPECT_EQ((bench.integer("v.q_dwStat") >> 26) & 1, 1);
    }
}

/// The drive to the default position that an error started ends with the acknowledge, as the block says.
TEST(BistableValve, AcknowledgingWhileForcingSwitchesTheForcedOutputOff) {
    for (const bool opens : {false, true}) {
        Bench bench("VAR v : Bistable_Valve; p : Par_Val_Bi; error, acknowledge, opens : BOOL; END_VAR",
                    "p.xFrceEn := TRUE; p.iFbckDly := 60; p.xPosDflt := opens;\n"
                    "v(i_xAut := TRUE, i_xErr := error, i_xAckn := acknowledge, i_strPara := p);",
                    {"toolbox"}, 100ms);
        const std::string forced = opens ? "v.q_xOpen" : "v.q_xCls";
        bench.set("opens", opens);
        bench.scan();
        bench.set("error", 1);
        bench.scan(3);
        EXPECT_TRUE(bench.is(forced));
        bench.set("error", 0);
        bench.scan();
        EXPECT_TRUE(bench.is(forced)) << "the error is latched, the drive goes on";
        bench.set("acknowledge", 1);
        bench.scan();
        EXPECT_FALSE(bench.is(forced));
        EXPECT_FALSE(bench.is("v.q_xErr"));
        bench.scan(10);
        EXPECT_FALSE(bench.is(forced));
    }
}

TEST(OneSecondPulse, DoesNotDriftWithACycleThatDoesNotDivideASecond) {
    Bench bench("VAR second : ONE_SEC_PULSE; pulses : INT; END_VAR",
                "second(); IF second.q_xOput THEN pulses := pulses + 1; END_IF", {"toolbox"}, 70ms);
    bench.scanUntil(1000s + 70ms);
    EXPECT_EQ(bench.integer("pulses"), 1000);
}

} // namespace
} // namespace plc::test
