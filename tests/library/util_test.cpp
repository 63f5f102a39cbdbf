// The blocks with the names and pins of CODESYS Util.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plc::test {
namespace {

const std::vector<std::string> util{"util"};

TEST(Gen, MakesItsWaves) {
    const auto wave = [](int mode, double p) {
        switch (mode) {
        case 0:
            return p < 0.25 ? 4 * p : p < 0.75 ? 2 - 4 * p : 4 * p - 4;
        case 1:
            return p < 0.5 ? 2 * p : 2 - 2 * p;
        case 2:
            return 2 * p - 1;
        case 3:
            return 1 - 2 * p;
        case 4:
            return p < 0.5 ? -1.0 : 1.0;
        case 5:
            return std::sin(2 * M_PI * p);
        default:
            return std::cos(2 * M_PI * p);
        }
    };
    for (const bool byTime : {true, false}) {
        Bench bench("VAR g : GEN; mode : GEN_MODE; byTime, r : BOOL; END_VAR",
                    "g(MODE := mode, BASE := byTime, PERIOD := T#1s, CYCLES := 100, AMPLITUDE := 1000, RESET := r);",
                    util);
        bench.set("byTime", byTime);
        for (int mode = 0; mode <= 6; ++mode) {
            bench.set("mode", mode);
            bench.set("r", 1);
            bench.scan();
            EXPECT_EQ(bench.integer("g.OUT"), 0);
            bench.set("r", 0);
            for (int n = 0; n < 250; ++n) {
                bench.scan();
                ASSERT_NEAR(bench.integer("g.OUT"), 1000 * wave(mode, (n % 100) / 100.0), 0.501)
                    << "mode " << mode << ", scan " << n;
            }
        }
    }
}

TEST(Blink, BeginsHighAndKeepsItsTimes) {
    Bench bench("VAR b : BLINK; on : BOOL := TRUE; END_VAR",
                "b(ENABLE := on, TIMELOW := T#300ms, TIMEHIGH := T#200ms);", util, 100ms);
    for (int n = 0; n < 50; ++n) {
        bench.scan();
        ASSERT_EQ(bench.is("b.OUT"), n % 5 < 2) << n;
    }
    bench.scan();
    bench.set("on", 0);
    bench.scan(20);
    EXPECT_TRUE(bench.is("b.OUT")) << "stays as it is";
}

TEST(FreqMeasure, AveragesPeriods) {
    Bench bench("VAR f : FREQ_MEASURE; wave : GEN; END_VAR",
                "wave(MODE := GEN_MODE.RECTANGLE, BASE := TRUE, PERIOD := T#400ms, AMPLITUDE := 1);\nf(IN := wave.OUT "
                "> 0, PERIODS := 3, RESET := FALSE);",
                util, 10ms);
    bench.scan(100);
    EXPECT_FALSE(bench.is("f.VALID"));
    bench.scan(100);
    EXPECT_TRUE(bench.is("f.VALID"));
    EXPECT_NEAR(bench.real("f.OUT"), 2.5, 1e-5);
}

TEST(CharCurve, InterpolatesAndTellsItsErrors) {
    Bench bench("VAR c : CHARCURVE; p : ARRAY[0..10] OF POINT := [(X := 0, Y := 0), (X := 100, Y := 1000), (X := 300, "
                "Y := -1000)]; x : INT; n : BYTE := 3; END_VAR",
                "c(IN := x, N := n, P := p);", util);
    for (const auto& [x, out, err] : {std::tuple{0, 0, 0},
                                      {50, 500, 0},
                                      {100, 1000, 0},
                                      {200, 0, 0},
                                      {300, -1000, 0},
                                      {301, -1000, 2},
                                      {-1, 0, 2}}) {
        bench.set("x", x);
        bench.scan();
        EXPECT_EQ(bench.integer("c.OUT"), out) << x;
        EXPECT_EQ(bench.integer("c.ERR"), err) << x;
    }
    bench.set("n", 1);
    bench.scan();
    EXPECT_EQ(bench.integer("c.ERR"), 4);
    bench.set("n", 3);
    bench.set("p[1].X", 0);
    bench.scan();
    EXPECT_EQ(bench.integer("c.ERR"), 1);
}

TEST(Ramps, LimitTheSlope) {
    Bench bench("VAR i : RAMP_INT; r : RAMP_REAL; s : RAMP_REAL; x : REAL := 100.0; END_VAR",
                "i(IN := REAL_TO_INT(x), ASCEND := 10, DESCEND := 20, TIMEBASE := T#1s, RESET := FALSE);\nr(IN := x, "
                "ASCEND := 10.0, DESCEND := 20.0, TIMEBASE := T#1s, RESET := FALSE);\n"
                "s(IN := x, ASCEND := 0.5, DESCEND := 1.0, TIMEBASE := T#0s, RESET := FALSE);",
                util, 100ms);
    bench.scan(31); // 3 s after the first call
    EXPECT_EQ(bench.integer("i.OUT"), 30);
    EXPECT_NEAR(bench.real("r.OUT"), 30.0, 1e-4);
    EXPECT_NEAR(bench.real("s.OUT"), 15.5, 1e-5);
    bench.set("x", 0.0);
    bench.scan(10);
    EXPECT_EQ(bench.integer("i.OUT"), 10);
    EXPECT_NEAR(bench.real("r.OUT"), 10.0, 1e-4);
    EXPECT_NEAR(bench.real("s.OUT"), 5.5, 1e-5);
    bench.scan(20);
    EXPECT_EQ(bench.integer("i.OUT"), 0);
}

TEST(LimitsAndHysteresis, CompareStrictly) {
    Bench bench("VAR l : LIMITALARM; h : Util.HYSTERESIS; x : INT; END_VAR",
                "l(IN := x, HIGH := 90, LOW := 10); h(IN := x, HIGH := 90, LOW := 10);", util);
    for (const auto& [x, over, under, out] :
         {std::tuple{50, 0, 0, 0}, {9, 0, 1, 1}, {10, 0, 0, 1}, {90, 0, 0, 1}, {91, 1, 0, 0}, {10, 0, 0, 0}}) {
        bench.set("x", x);
        bench.scan();
        EXPECT_EQ(bench.is("l.O"), over) << x;
        EXPECT_EQ(bench.is("l.U"), under) << x;
        EXPECT_EQ(bench.is("l.IL"), !over && !under) << x;
        EXPECT_EQ(bench.is("h.OUT"), out) << x;
    }
}

TEST(LinearTransformation, MapsARangeAndRefusesWhatIsOutside) {
    Bench bench("VAR t, back, none : LIN_TRAFO; x : REAL; END_VAR",
                "t(IN := x, IN_MIN := 4.0, IN_MAX := 20.0, OUT_MIN := 0.0, OUT_MAX := 100.0);\n"
                "back(IN := x, IN_MIN := 20.0, IN_MAX := 4.0, OUT_MIN := 0.0, OUT_MAX := 100.0);\n"
                "none(IN := x, IN_MIN := 4.0, IN_MAX := 4.0, OUT_MIN := 1.0, OUT_MAX := 2.0);",
                util);
    for (const auto& [x, out, error] : {std::tuple{4.0, 0.0, 0},
                                        {20.0, 100.0, 0},
                                        {12.0, 50.0, 0},
                                        {20.5, 50.0, 1},
                                        {3.9, 50.0, 1},
                                        {8.0, 25.0, 0}}) {
        bench.set("x", x);
        bench.scan();
        EXPECT_NEAR(bench.real("t.OUT"), out, 1e-4) << x;
        EXPECT_NEAR(bench.real("back.OUT"), 100.0 - out, 1e-4) << x;
        EXPECT_EQ(bench.is("t.ERROR"), error) << x;
        EXPECT_EQ(bench.is("back.ERROR"), error) << x;
        EXPECT_TRUE(bench.is("none.ERROR"));
    }
}

TEST(Mathematics, IntegratesDifferentiatesAndCounts) {
    Bench bench(
        "VAR i : Util.INTEGRAL; d : Util.DERIVATIVE; s : STATISTICS_REAL; n : STATISTICS_INT; v : VARIANCE; x : REAL; "
        "k : INT; END_VAR",
        "x := x + 0.5; k := k + 1;\ni(IN := 2.0, TM := 100, RESET := FALSE); d(IN := x, TM := 100, RESET := FALSE);\n"
        "s(IN := x, RESET := FALSE); n(IN := k, RESET := FALSE); v(IN := x, RESET := FALSE);",
        util, 100ms);
    bench.scan(100);
    EXPECT_NEAR(bench.real("i.OUT"), 20.0, 1e-4);
    EXPECT_NEAR(bench.real("d.OUT"), 5.0, 1e-4);
    EXPECT_DOUBLE_EQ(bench.real("s.MN"), 0.5);
    EXPECT_DOUBLE_EQ(bench.real("s.MX"), 50.0);
    EXPECT_NEAR(bench.real("s.AVG"), 25.25, 1e-5);
    EXPECT_EQ(bench.integer("n.MN"), 1);
    EXPECT_EQ(bench.integer("n.MX"), 100);
    EXPECT_EQ(bench.integer("n.AVG"), 50) << "50.5, ties to even";
    EXPECT_NEAR(bench.real("v.OUT"), 0.25 * (100.0 * 100.0 - 1) / 12, 1e-3);
}

TEST(UtilPid, FollowsPPlusIPlusDAndRespectsItsLimits) {
    Bench bench("VAR p : Util.PID; q : PID_FIXCYCLE; d : PD; sp : REAL; manual : BOOL; high : REAL; END_VAR",
                "p(ACTUAL := 0.0, SET_POINT := sp, KP := 2.0, TN := 1.0, TV := 0.0, Y_MANUAL := 33.0, Y_OFFSET := 1.0, "
                "Y_MIN := 0.0, Y_MAX := high, MANUAL := manual, RESET := FALSE);\n"
                "q(ACTUAL := 0.0, SET_POINT := sp, KP := 2.0, TN := 1.0, TV := 0.0, Y_OFFSET := 1.0, CYCLE := 0.01, "
                "MANUAL := FALSE, RESET := FALSE);\n"
                "d(ACTUAL := 0.0, SET_POINT := sp, KP := 2.0, TV := 0.1, MANUAL := FALSE, RESET := FALSE);",
                util);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("p.Y"), 1.0);
    bench.set("sp", 5.0);
    bench.scan();
    EXPECT_NEAR(bench.real("d.Y"), 10.0 + 2.0 * 0.1 * 5.0 / 0.01, 1e-3);
    for (int n = 2; n <= 100; ++n) bench.scan();
    EXPECT_NEAR(bench.real("p.Y"), 1.0 + 10.0 * (1 + 1.0), 1e-3);
    EXPECT_NEAR(bench.real("q.Y"), bench.real("p.Y"), 1e-4);
    EXPECT_NEAR(bench.real("d.Y"), 10.0, 1e-4);
    EXPECT_FALSE(bench.is("p.LIMITS_ACTIVE"));
    bench.set("manual", 1);
    bench.scan(10);
    EXPECT_DOUBLE_EQ(bench.real("p.Y"), 33.0);
    bench.set("manual", 0);
    bench.scan();
    EXPECT_NEAR(bench.real("p.Y"), 33.0, 1e-4);
    bench.set("high", 40.0);
    bench.scan(10000);
    EXPECT_DOUBLE_EQ(bench.real("p.Y"), 40.0);
    EXPECT_TRUE(bench.is("p.LIMITS_ACTIVE"));
    bench.set("sp", -5.0);
    bench.scan();
    EXPECT_LT(bench.real("p.Y"), 25.0) << "the integral did not wind up";
}

TEST(Bits, PackUnpackExtractAndPut) {
    Bench bench("VAR u : UNPACK; b : BYTE := 16#A5; p : BYTE; e4, e0, e40 : BOOL; x : DWORD; d : DWORD_AS_BIT; back : "
                "DWORD; w : WORD; END_VAR",
                "u(B := b);\np := PACK(u.B0, u.B1, u.B2, u.B3, u.B4, u.B5, u.B6, u.B7);\ne4 := EXTRACT(X := 81, N := "
                "4); e0 := EXTRACT(X := 33, N := 0); e40 := EXTRACT(X := 16#FFFFFFFF, N := 40);\n"
                "x := PUTBIT(X := PUTBIT(38, 4, TRUE), N := 1, B := FALSE);\nd(X := 16#80000001);\nback := "
                "BIT_AS_DWORD(B00 := d.B00, B31 := d.B31);\nw := BIT_AS_WORD(B15 := TRUE, B00 := TRUE);",
                util);
    bench.scan();
    EXPECT_EQ(bench.integer("p"), 0xA5);
    EXPECT_TRUE(bench.is("e4"));
    EXPECT_TRUE(bench.is("e0"));
    EXPECT_FALSE(bench.is("e40"));
    EXPECT_EQ(bench.integer("x"), 52);
    EXPECT_EQ(static_cast<uint32_t>(bench.integer("back")), 0x80000001u);
    EXPECT_EQ(bench.integer("w"), 0x8001);
}

} // namespace
} // namespace plc::test
