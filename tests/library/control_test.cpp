// The controllers and filters of the Toolbox against the closed-form solutions of the systems they stand for.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plc::test {
namespace {

constexpr const char* piParameters =
    "p.tCyclTime := T#10ms; p.tTn := T#1s; p.rKp := 2.0; p.rMaxLim := 1000.0; p.rMinLim := -1000.0; ";
const std::vector<std::string> toolbox{"toolbox"};

Bench piBench(const std::string& before = "") {
    return Bench("VAR f : FB_PI; p : stPiPara; first : BOOL := TRUE; sp, man : REAL; manual, hold, arw, on : BOOL; lim "
                 ": REAL := 1000.0; END_VAR",
                 std::string(piParameters) + before +
                     "p.xEnArw := arw; p.rMaxLim := lim; p.rMinLim := -lim;\n"
                     "f(i_xEn := on, i_rSp := sp, i_rActVal := 0.0, i_rManVal := man, i_xManMode := manual, i_xHold := "
                     "hold, i_stPara := p);",
                 toolbox);
}

Bench pidBench() {
    return Bench("VAR f : FB_PID; p : stPid; sp, man, pv : REAL; manual, hold, on : BOOL := FALSE; kp : REAL := 2.0; "
                 "tn : REAL := 1000.0; tv : REAL; td : REAL := 20.0; lim : REAL := 1000.0; END_VAR",
                 "p.xActValType := TRUE; p.rTargCyclTime := 10.0; p.rLowLim := -lim; p.rHighLim := lim;\n"
                 "f(i_xEn := on, i_rSp := sp, i_rPv1 := pv, i_xHold := hold, i_rKp := kp, i_rTn := tn, i_rTv := tv, "
                 "i_rTd := td, i_xManMode := manual, i_rManVal := man, i_stPid := p);",
                 toolbox);
}

TEST(FilterPt1, FollowsTheExponential) {
    for (const auto& [cycle, tau, gain] :
         {std::tuple{10, 500, 2.0}, {10, 100, 1.0}, {50, 50, 10.0}, {100, 3000, -0.5}}) {
        Bench bench("VAR f : Filter_PT1; x : REAL := 3.0; END_VAR",
                    "f(i_xEn := TRUE, i_rInput := x, i_tCyclTime := T#" + std::to_string(cycle) +
                        "ms, i_rKp := " + std::to_string(gain) + ", i_tFltrTime := T#" + std::to_string(tau) + "ms);",
                    toolbox, std::chrono::milliseconds(cycle));
        for (int n = 1; n <= 4 * tau / cycle; ++n) {
            bench.scan();
            const double exact = 3.0 * gain * (1 - std::exp(-double(n) * cycle / tau));
            ASSERT_NEAR(bench.real("f.q_rOput"), exact, 1e-5 * std::abs(3.0 * gain)) << n;
        }
    }
}

TEST(FilterPt1, Reaches63PercentAfterTAnd95After3T) {
    Bench bench("VAR f : Filter_PT1; END_VAR",
                "f(i_xEn := TRUE, i_rInput := 10.0, i_tCyclTime := T#10ms, i_rKp := 10.0, i_tFltrTime := T#1s);",
                toolbox);
    bench.scan(100);
    EXPECT_NEAR(bench.real("f.q_rOput"), 63.2, 0.05);
    bench.scan(200);
    EXPECT_NEAR(bench.real("f.q_rOput"), 95.0, 0.05);
}

TEST(FbPi, GrowsByKpTimesErrorPerTn) {
    Bench bench = piBench();
    bench.set("on", 1);
    bench.set("sp", 10.0);
    for (int n = 1; n <= 300; ++n) {
        bench.scan();
        const double continuous = 20.0 * (1 + n * 0.01);
        ASSERT_NEAR(bench.real("f.q_rOput"), continuous, 0.2 + 1e-6) << n; // one integral step
    }
}

TEST(FbPi, ClosesALoopAsTheContinuousSolutionSays) {
    // Tn = T cancels the pole of the process: the loop is a PT1 of T / (K Kp)
    Bench bench(
        "VAR f : FB_PI; p : stPiPara; plant : Filter_PT1; END_VAR",
        "p.tCyclTime := T#10ms; p.tTn := T#1s; p.rKp := 2.0; p.rMaxLim := 1000.0; p.rMinLim := -1000.0;\n"
        "f(i_xEn := TRUE, i_rSp := 1.0, i_rActVal := plant.q_rOput, i_stPara := p);\n"
        "plant(i_xEn := TRUE, i_rInput := f.q_rOput, i_tCyclTime := T#10ms, i_rKp := 1.0, i_tFltrTime := T#1s);",
        toolbox);
    double worst = 0;
    for (int n = 1; n <= 500; ++n) {
        bench.scan();
        worst = std::max(worst, std::abs(bench.real("plant.q_rOput") - (1 - std::exp(-n * 0.01 * 2.0))));
    }
    EXPECT_LT(worst, 0.01);
    EXPECT_NEAR(bench.real("plant.q_rOput"), 1.0, 1e-3);
}

TEST(FbPid, AnswersAStepAsPPlusIPlusFilteredD) {
    Bench bench = pidBench();
    bench.set("on", 1);
    bench.set("tv", 400.0);
    bench.set("td", 200.0);
    bench.scan(); // error 0
    bench.set("sp", 5.0);
    for (int n = 1; n <= 200; ++n) {
        bench.scan();
        const double t = n * 10.0; // the derivative filter is a backward Euler step: (Td / (Td + T))^n
        const double derivative = 2.0 * 5.0 * 400.0 / 200.0 * std::pow(200.0 / 210.0, n);
        const double continuousDerivative = 2.0 * 5.0 * 400.0 / 200.0 * std::exp(-t / 200.0);
        ASSERT_NEAR(bench.real("f.q_rPidOput"), 10.0 * (1 + t / 1000.0) + derivative, 0.01) << n;
        ASSERT_NEAR(derivative, continuousDerivative, 20.0 * 10.0 / 200.0) << n; // within what the sampling allows
    }
}

TEST(FbPid, ClosesALoopAsTheContinuousSolutionSays) {
    Bench bench(
        "VAR f : FB_PID; p : stPid; plant : Filter_PT1; END_VAR",
        "p.xActValType := TRUE; p.rTargCyclTime := 10.0; p.rLowLim := -1000.0; p.rHighLim := 1000.0;\n"
        "f(i_xEn := TRUE, i_rSp := 1.0, i_rPv1 := plant.q_rOput, i_rKp := 2.0, i_rTn := 1000.0, i_rTv := 0.0, i_rTd := "
        "20.0, i_stPid := p);\n"
        "plant(i_xEn := TRUE, i_rInput := f.q_rPidOput, i_tCyclTime := T#10ms, i_rKp := 1.0, i_tFltrTime := T#1s);",
        toolbox);
    double worst = 0;
    for (int n = 1; n <= 500; ++n) {
        bench.scan();
        worst = std::max(worst, std::abs(bench.real("plant.q_rOput") - (1 - std::exp(-n * 0.01 * 2.0))));
    }
    EXPECT_LT(worst, 0.01);
}

TEST(FbPiPid, IsAPiWhosePreControlledOutputIsTheSetPointOfAPid) {
    Bench bench("VAR f : FB_PI_PID; inner : stPIPIDOutLoop; outer : stPIPIDInLoop; END_VAR",
                "outer.tCyclTime := T#10ms; outer.rKp := 2.0; outer.tTn := T#1s; outer.rMaxLim := 1000.0; "
                "outer.rMinLim := -1000.0;\n"
                "inner.rKp := 3.0; inner.tTd := T#20ms; inner.rMaxLim := 10000.0; inner.rMinLim := -10000.0;\n"
                "f(i_xEn := TRUE, i_rSp := 5.0, i_rActValPI := 1.0, i_rActValPID := 7.0, i_rPreCtrlVal := 11.0, "
                "i_stParaPID := inner, i_stParaPI := outer);",
                toolbox);
    for (int n = 1; n <= 200; ++n) {
        bench.scan();
        ASSERT_NEAR(bench.real("f.q_rOput"), 3.0 * (2.0 * 4.0 * (1 + n * 0.01) + 11.0 - 7.0), 3 * 0.08 + 1e-3) << n;
    }
}

TEST(AntiWindup, LeavesALimitAtOnceInBothModes) {
    // the integral stops at 30 (whole output limited) or at 50 (integral part limited), the error then turns
    for (const auto& [mode, expected] : {std::pair{0, 10.0}, {1, 30.0}}) {
        Bench bench = piBench();
        bench.set("on", 1);
        bench.set("arw", mode);
        bench.set("lim", 50.0);
        bench.set("sp", 10.0);
        bench.scan(1000);
        EXPECT_DOUBLE_EQ(bench.real("f.q_rOput"), 50.0);
        EXPECT_TRUE(bench.is("f.q_xArwActv"));
        bench.set("sp", -10.0);
        bench.scan();
        EXPECT_NEAR(bench.real("f.q_rOput"), expected, 0.5);
    }
    Bench bench = pidBench();
    bench.set("on", 1);
    bench.set("lim", 50.0);
    bench.set("sp", 10.0);
    bench.scan(1000);
    EXPECT_TRUE(bench.is("f.q_xARWActv"));
    EXPECT_TRUE(bench.is("f.q_xMaxLimActv"));
    bench.set("sp", -10.0);
    bench.scan();
    EXPECT_NEAR(bench.real("f.q_rPidOput"), 10.0, 0.5);
}

TEST(AntiWindup, StillStartsFromALowerLimitAboveZero) {
    Bench bench("VAR f : FB_PI; p : stPiPara; END_VAR",
                "p.tCyclTime := T#10ms; p.tTn := T#1s; p.rKp := 1.0; p.rMaxLim := 100.0; p.rMinLim := 20.0;\n"
                "f(i_xEn := TRUE, i_rSp := 1.0, i_rActVal := 0.0, i_stPara := p);",
                toolbox);
    bench.scan();
    EXPECT_NEAR(bench.real("f.q_rOput"), 21.0, 0.02);
    bench.scan(100);
    EXPECT_NEAR(bench.real("f.q_rOput"), 22.0, 0.02);
}

TEST(HandToAutomatic, IsWithoutABump) {
    for (const bool isPid : {false, true}) {
        Bench bench = isPid ? pidBench() : piBench();
        const std::string output = isPid ? "f.q_rPidOput" : "f.q_rOput";
        bench.set("on", 1);
        bench.set("sp", 10.0);
        bench.scan(50);
        bench.set("manual", 1);
        bench.set("man", 77.0);
        bench.scan(20);
        EXPECT_DOUBLE_EQ(bench.real(output), 77.0);
        bench.set("manual", 0);
        bench.scan();
        EXPECT_NEAR(bench.real(output), 77.0, 0.01);
        bench.scan(100);
        EXPECT_NEAR(bench.real(output), 77.0 + 20.0, 0.05) << "Kp * e per Tn";
        // manual wins over hold
        bench.set("hold", 1);
        bench.set("manual", 1);
        bench.set("man", -3.0);
        bench.scan();
        EXPECT_DOUBLE_EQ(bench.real(output), -3.0);
    }
}

TEST(Hold, KeepsTheOutputAndGoesOnFromIt) {
    for (const bool isPid : {false, true}) {
        Bench bench = isPid ? pidBench() : piBench();
        const std::string output = isPid ? "f.q_rPidOput" : "f.q_rOput";
        bench.set("on", 1);
        bench.set("sp", 10.0);
        bench.scan(100);
        const double held = bench.real(output);
        EXPECT_NEAR(held, 40.0, 0.2);
        bench.set("hold", 1);
        bench.set("sp", 500.0);
        bench.scan(200);
        EXPECT_DOUBLE_EQ(bench.real(output), held);
        bench.set("sp", 10.0);
        bench.set("hold", 0);
        bench.scan();
        EXPECT_NEAR(bench.real(output), held + 0.2, 0.01);
    }
}

TEST(Disabling, GivesZeroAndAFreshStart) {
    Bench bench = piBench();
    bench.set("on", 1);
    bench.set("sp", 10.0);
    bench.scan(100);
    bench.set("on", 0);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.q_rOput"), 0.0);
    EXPECT_FALSE(bench.is("f.q_xBusy"));
    bench.set("on", 1);
    bench.scan();
    EXPECT_NEAR(bench.real("f.q_rOput"), 20.2, 0.01);
}

TEST(TwoPoint, SwitchesAtHalfTheHysteresisEitherSide) {
    Bench bench(
        "VAR f : FB_2points; p : stPtPara; actual : REAL; END_VAR",
        "p.tCyclTime := T#10ms; p.rHyst := 4.0;\nf(i_xEn := TRUE, i_rSp := 50.0, i_rActVal := actual, i_stPara := p);",
        toolbox);
    for (const auto& [actual, expected] : {std::pair{49.0, false},
                                           {48.0, false},
                                           {47.9, true},
                                           {51.9, true},
                                           {52.0, true},
                                           {52.1, false},
                                           {48.1, false}}) {
        bench.set("actual", actual);
        bench.scan();
        EXPECT_EQ(bench.is("f.q_xOput"), expected) << actual;
    }
}

} // namespace
} // namespace plc::test
