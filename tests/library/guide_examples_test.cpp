// The usage examples of the guide: PID with GEN and two systems, PT1 filters with sines a decade apart, PWM of a sine,
// hour meter.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace plc::test {
namespace {

/// Amplitude and lag of what `path` shows of a sine of `hertz`, from scan by scan samples over whole periods.
std::pair<double, double> sineOf(Bench& bench, const std::string& path, double hertz, double interval, int scans) {
    std::complex<double> sum = 0;
    for (int n = 0; n < scans; ++n) {
        bench.scan();
        const double t = std::chrono::duration<double>(bench.controller().lastTime()).count();
        sum += bench.real(path) * std::exp(std::complex<double>(0, -2 * M_PI * hertz * t));
    }
    sum *= 2.0 / scans;
    (void)interval;
    return {std::abs(sum), -(std::arg(sum) + M_PI / 2) * 180 / M_PI}; // the sine itself has the argument -90 degrees
}

const char* pidDeclarations = "VAR wave : GEN; loop : FB_PID; system1, system2 : Filter_PT1; parameters : stPid; mode "
                              ": GEN_MODE := GEN_MODE.RECTANGLE; END_VAR";
const char* pidBody =
    "parameters.xActValType := TRUE; parameters.rTargCyclTime := 50.0; parameters.rLowLim := -2000.0; "
    "parameters.rHighLim := 2000.0;\n"
    "wave(MODE := mode, BASE := TRUE, PERIOD := T#1s, AMPLITUDE := 100);\n"
    "system1(i_xEn := TRUE, i_rInput := INT_TO_REAL(wave.OUT), i_tCyclTime := T#50ms, i_rKp := 1.0, i_tFltrTime := "
    "T#500ms);\n"
    "loop(i_xEn := TRUE, i_rSp := INT_TO_REAL(wave.OUT), i_rPv1 := system2.q_rOput, i_rKp := 7.5, i_rTn := 44.0, i_rTv "
    ":= 0.0, i_rTd := 60.0, i_stPid := parameters);\n"
    "system2(i_xEn := TRUE, i_rInput := loop.q_rPidOput, i_tCyclTime := T#50ms, i_rKp := 1.0, i_tFltrTime := T#500ms);";

TEST(GuidePid, ClosedLoopBeatsOpenLoopOnARectangle) {
    Bench bench(pidDeclarations, pidBody, {"toolbox", "util"}, 50ms);
    bench.scan(200); // ten periods: what is left of the start is gone
    double openHigh = -1e9, openLow = 1e9, openError = 0, closedError = 0, settled = 0;
    for (int n = 0; n < 200; ++n) {
        bench.scan();
        const double setPoint = bench.real("wave.OUT"), open = bench.real("system1.q_rOput"),
                     closed = bench.real("system2.q_rOput");
        openHigh = std::max(openHigh, open);
        openLow = std::min(openLow, open);
        openError += std::abs(setPoint - open) / 200;
        closedError += std::abs(setPoint - closed) / 200;
        if (n % 10 >= 5) settled = std::max(settled, std::abs(setPoint - closed)); // second half of each half period
    }
    EXPECT_NEAR(openHigh, 100 * std::tanh(0.5), 1.0) << "theory: 46.2";
    EXPECT_NEAR(openLow, -100 * std::tanh(0.5), 1.0);
    EXPECT_LT(closedError, openError / 10);
    EXPECT_LT(settled, 3.0);
}

TEST(GuidePid, ClosedLoopFollowsASineWhereTheOpenLoopLagsBehind) {
    Bench bench(pidDeclarations, pidBody, {"toolbox", "util"}, 50ms);
    bench.set("mode", 5);
    bench.scan(200);
    const auto [open, openLag] = sineOf(bench, "system1.q_rOput", 1.0, 0.05, 200);
    const auto [closed, closedLag] = sineOf(bench, "system2.q_rOput", 1.0, 0.05, 200);
    EXPECT_NEAR(open, 30.3, 1.5);
    EXPECT_GT(openLag, 60);
    EXPECT_GT(closed, 90);
    EXPECT_LT(closed, 130);
    EXPECT_LT(std::abs(closedLag), 25);
}

TEST(GuideFilter, PassesAndStopsSinesADecadeApart) {
    struct Row {
        double hertz;
        int tauMs;
        double amplitude, lag;
    };
    for (const Row& row : {Row{0.2, 100, 0.992, 7},
                           {2, 100, 0.623, 51},
                           {0.5, 100, 0.954, 17},
                           {5, 100, 0.303, 72},
                           {0.2, 500, 0.847, 32},
                           {2, 500, 0.157, 81},
                           {0.5, 500, 0.537, 58},
                           {5, 500, 0.064, 86}}) {
        Bench bench(
            "VAR wave : SinGen; f : Filter_PT1; END_VAR",
            "wave(Period := " + std::to_string(1 / row.hertz) +
                ");\nf(i_xEn := TRUE, i_rInput := wave.Sinus, i_tCyclTime := T#10ms, i_rKp := 1.0, i_tFltrTime := T#" +
                std::to_string(row.tauMs) + "ms);",
            {"toolbox"});
        bench.scan(1000); // 10 s: the start is forgotten
        const auto [amplitude, lag] = sineOf(bench, "f.q_rOput", row.hertz, 0.01, 1000);
        EXPECT_NEAR(amplitude, 100 * row.amplitude, 1.2) << row.hertz << " Hz, " << row.tauMs << " ms";
        // the filter answers within the scan: its lag is up to one cycle less than the continuous one
        EXPECT_NEAR(lag, row.lag, 1.0 + 360 * row.hertz * 0.01) << row.hertz << " Hz, " << row.tauMs << " ms";
    }
}

TEST(GuidePwm, PulsesFollowTheHalfWavesOfTheSine) {
    Bench bench("VAR wave : SinGen; pwm : FB_PWM; p : stPwmPara; END_VAR",
                "p.tCyclTime := T#10ms; p.tPwmPeriod := T#200ms;\nwave(Period := 5.0);\npwm(i_xEn := TRUE, i_rInput := "
                "wave.Sinus, i_stPara := p);",
                {"toolbox"});
    for (int period = 0; period < 25; ++period) { // 25 PWM periods in a period of the sine
        int positive = 0, negative = 0;
        double demand = 0;
        for (int n = 0; n < 20; ++n) {
            bench.scan();
            if (n == 0) demand = bench.real("wave.Sinus");
            positive += bench.is("pwm.q_xPstv");
            negative += bench.is("pwm.q_xNgtv");
        }
        EXPECT_NEAR(positive, std::max(0.0, demand) / 5, 1.0) << period;
        EXPECT_NEAR(negative, std::max(0.0, -demand) / 5, 1.0) << period;
    }
}

TEST(GuideHourMeter, CountsHoldsAndReturnsToItsPreset) {
    // reset at 0 s of every 25 s, enable from 15 s to 8 s of the next round
    Bench bench(
        "VAR m : Hour_Meter; p : Par_HM; h : HMI_HM; s : LINT; outReset : BOOL; outEnable : BOOL := TRUE; END_VAR",
        "s := (TIME_TO_LINT(TIME()) / 1000) MOD 25;\n"
        "IF s = 0 THEN outReset := TRUE; outEnable := TRUE; END_IF IF s = 4 THEN outReset := FALSE; END_IF IF s = 8 "
        "THEN outEnable := FALSE; END_IF IF s = 15 THEN outEnable := TRUE; END_IF\n"
        "p.diSp := 5; p.wTypeTime := 1; p.diWaitTime := 1000;\n"
        "m(i_xAut := TRUE, i_xIn := outEnable, i_xRst := outReset, i_strPara := p, iq_strHmi := h);",
        {"toolbox"}, 100ms);
    for (int round = 0; round < 3; ++round) {
        const Nanoseconds begin = 25s * round;
        bench.scanUntil(begin);
        EXPECT_EQ(bench.integer("m.q_diHr"), 5) << round;
        bench.scanUntil(begin + 8s);
        EXPECT_EQ(bench.integer("m.q_diHr"), 13) << round;
        bench.scanUntil(begin + 15s);
        EXPECT_EQ(bench.integer("m.q_diHr"), 13) << round;
        bench.scanUntil(begin + 24900ms);
        EXPECT_EQ(bench.integer("m.q_diHr"), 22) << round;
    }
}

TEST(Aliases, AreValidInCallsAndMemberAccess) {
    Bench bench("VAR f : FB_Limiter; s : st_Pid; out : REAL; END_VAR",
                "f(i_xEn := TRUE, i_rIput := 150.0, i_rMinOpot := 0.0, i_rMaxOpot := 100.0);\nf.i_rIput := f.i_rIput - "
                "1.0;\nout := f.i_rInput;\ns.rDbnd := 1.0;",
                {"toolbox"});
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.q_rOput"), 100.0);
    EXPECT_DOUBLE_EQ(bench.real("out"), 149.0);
    EXPECT_DOUBLE_EQ(bench.real("f.i_rIput"), 149.0);
}

} // namespace
} // namespace plc::test
