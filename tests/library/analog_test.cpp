// The blocks of IEC 61131-3 Annex F, with the slips of the printed text corrected.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plc::test {
namespace {

const std::vector<std::string> analog{"analog"};

TEST(Lag1, FollowsTheLagEvenWhenItStartsRunning) {
    for (const char* suffix : {"", "_LREAL"}) {
        const std::string type = *suffix ? "LREAL" : "REAL";
        Bench bench("VAR f : LAG1" + std::string(suffix) + "; x : " + type + "; END_VAR",
                    "f(RUN := TRUE, XIN := x, TAU := T#900ms, CYCLE := T#100ms);", analog, 100ms);
        bench.scan();
        types::Value one = bench.value("x");
        one.data = 10.0;
        bench.write("x", one);
        for (int n = 1; n <= 50; ++n) {
            bench.scan();
            ASSERT_NEAR(bench.real("f.XOUT"), 10.0 * (1 - std::pow(0.9, n)), 1e-4) << n;
        }
    }
}

TEST(Delay, GivesTheSampleOfNCallsAgo) {
    Bench bench("VAR f : DELAY; x : REAL; run : BOOL; n : INT := 127; END_VAR",
                "x := x + 1.0;\nf(RUN := run, XIN := x, N := n);", analog);
    bench.scan(3);
    EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), 3.0);
    bench.set("run", 1);
    for (int n = 1; n <= 400; ++n) {
        bench.scan();
        ASSERT_DOUBLE_EQ(bench.real("f.XOUT"), std::max(3.0, 3.0 + n - 127)) << n;
    }
    bench.set("n", 5);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), 404.0 - 5);
    bench.set("n", 1000); // stays within the ring
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), 405.0 - 127);
}

TEST(Average, IsTheMeanOfTheLastN) {
    Bench bench("VAR f : AVERAGE; x : REAL := 4.0; run : BOOL; END_VAR", "f(RUN := run, XIN := x, N := 4);", analog);
    bench.scan();
    bench.set("run", 1);
    bench.set("x", 8.0);
    for (const double expected : {5.0, 6.0, 7.0, 8.0, 8.0}) {
        bench.scan();
        EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), expected);
    }
}

TEST(IntegralAndDerivative, CountInSeconds) {
    Bench bench("VAR i : Analog.INTEGRAL; d : Analog.DERIVATIVE; x : REAL; run : BOOL; r : BOOL := TRUE; END_VAR",
                "x := x + 0.3;\ni(RUN := TRUE, R1 := r, XIN := 2.0, X0 := 7.0, CYCLE := T#100ms);\nd(RUN := run, XIN "
                ":= x, CYCLE := T#100ms);",
                analog, 100ms);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("i.XOUT"), 7.0);
    EXPECT_FALSE(bench.is("i.Q"));
    EXPECT_DOUBLE_EQ(bench.real("d.XOUT"), 0.0);
    bench.set("r", 0);
    bench.set("run", 1);
    bench.scan(50);
    EXPECT_NEAR(bench.real("i.XOUT"), 17.0, 1e-4);
    EXPECT_TRUE(bench.is("i.Q"));
    EXPECT_NEAR(bench.real("d.XOUT"), 3.0, 1e-3);
}

TEST(Integral, DoesNotLoseSmallStepsBesideALargeSum) {
    Bench bench("VAR i : Analog.INTEGRAL; r : BOOL := TRUE; END_VAR",
                "i(RUN := TRUE, R1 := r, XIN := 0.001, X0 := 1000000.0, CYCLE := T#10ms);", analog);
    bench.scan();
    bench.set("r", 0);
    bench.scan(100000);
    EXPECT_NEAR(bench.real("i.XOUT"), 1000001.0, 0.1);
}

TEST(LimitsAlarm, HasItsHysteresisInside) {
    Bench bench("VAR f : LIMITS_ALARM; x : REAL; END_VAR", "f(H := 100.0, X := x, L := 0.0, EPS := 4.0);", analog);
    for (const auto& [x, high, low] : {std::tuple{50.0, 0, 0},
                                       {100.0, 0, 0},
                                       {100.5, 1, 0},
                                       {96.5, 1, 0},
                                       {95.5, 0, 0},
                                       {0.0, 0, 0},
                                       {-0.5, 0, 1},
                                       {3.5, 0, 1},
                                       {4.5, 0, 0}}) {
        bench.set("x", x);
        bench.scan();
        EXPECT_EQ(bench.is("f.QH"), high) << x;
        EXPECT_EQ(bench.is("f.QL"), low) << x;
        EXPECT_EQ(bench.is("f.Q"), high || low) << x;
    }
}

TEST(AnalogMonitor, ShowsTheMostSevere) {
    Bench bench("VAR f : ANALOG_MONITOR; l : ANALOG_LIMITS; x : REAL; END_VAR",
                "l.HS := 110.0; l.HM := 100.0; l.HA := 90.0; l.HW := 80.0; l.NV := 50.0; l.EPS := 2.0; l.LW := 20.0; "
                "l.LA := 10.0; l.LM := 0.0; l.LS := -10.0;\nf(X := x, L := l);",
                analog);
    for (const auto& [x, severity, high] : {std::tuple{50.0, 0, 0},
                                            {85.0, 1, 1},
                                            {95.0, 2, 1},
                                            {105.0, 3, 1},
                                            {115.0, 4, 1},
                                            {50.0, 0, 0},
                                            {15.0, 1, 0},
                                            {5.0, 2, 0},
                                            {-5.0, 3, 0},
                                            {-15.0, 4, 0}}) {
        bench.set("x", x);
        bench.scan();
        EXPECT_EQ(bench.is("f.WARN"), severity == 1) << x;
        EXPECT_EQ(bench.is("f.ALRM"), severity == 2) << x;
        EXPECT_EQ(bench.is("f.ME"), severity == 3) << x;
        EXPECT_EQ(bench.is("f.SE"), severity == 4) << x;
        EXPECT_EQ(bench.is("f.QH"), high) << x;
    }
}

TEST(AnalogPid, IsBumplessForEveryGain) {
    for (const double gain : {1.0, -3.0, 0.25}) {
        Bench bench(
            "VAR f : Analog.PID; auto : BOOL; kp : REAL; END_VAR",
            "f(AUTO := auto, PV := 55.0, SP := 50.0, X0 := 30.0, KP := kp, TR := 10.0, TD := 0.5, CYCLE := T#100ms);",
            analog, 100ms);
        bench.set("kp", gain);
        bench.scan(5);
        EXPECT_NEAR(bench.real("f.XOUT"), 30.0, 1e-4);
        bench.set("auto", 1);
        for (int n = 1; n <= 100; ++n) {
            bench.scan();
            ASSERT_NEAR(bench.real("f.XOUT"), 30.0 + gain * 5.0 * n * 0.1 / 10.0, 1e-3)
                << "the integral moves on by KP e / TR";
        }
    }
}

TEST(AnalogPid, ClosesALoopAsTheContinuousSolutionSays) {
    // reset time = time constant of the process: the loop is a PT1 of T / (K KP); the output is built from PV - SP, so
    // KP is negative
    Bench bench("VAR f : Analog.PID; plant : LAG1_LREAL; y : REAL; END_VAR",
                "f(AUTO := TRUE, PV := y, SP := 1.0, X0 := 0.0, KP := -2.0, TR := 1.0, TD := 0.0, CYCLE := T#1ms);\n"
                "plant(RUN := TRUE, XIN := REAL_TO_LREAL(f.XOUT), TAU := T#1s, CYCLE := T#1ms);\ny := "
                "LREAL_TO_REAL(plant.XOUT);",
                analog, 1ms);
    double worst = 0;
    for (int n = 1; n <= 3000; ++n) {
        bench.scan();
        worst = std::max(worst, std::abs(bench.real("y") - (1 - std::exp(-n * 0.001 * 2.0))));
    }
    EXPECT_LT(worst, 0.005);
}

TEST(Diffeq, UsesTheLastOutputNotTheOneBefore) {
    // y(k) = x(k) + 0.5 y(k-1)
    Bench bench("VAR f : DIFFEQ; a : ARRAY[1..2] OF REAL := [0.5, 0.0]; b : ARRAY[0..1] OF REAL := [1.0, 0.0]; run : "
                "BOOL; END_VAR",
                "f(RUN := run, XIN := 1.0, A := a, M := 2, B := b, N := 1);", analog);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), 1.0);
    bench.set("run", 1);
    double expected = 0;
    for (int n = 0; n < 20; ++n) {
        bench.scan();
        expected = 1 + 0.5 * expected;
        EXPECT_NEAR(bench.real("f.XOUT"), expected, 1e-6) << n;
    }
}

TEST(Ramp, RunsInAStraightLine) {
    Bench bench("VAR f : RAMP; run : BOOL; END_VAR",
                "f(RUN := run, X0 := 2.0, X1 := 12.0, TR := T#1s, CYCLE := T#100ms);", analog, 100ms);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), 2.0);
    bench.set("run", 1);
    for (int n = 0; n < 10; ++n) {
        bench.scan();
        EXPECT_NEAR(bench.real("f.XOUT"), 2.0 + n, 1e-5);
        EXPECT_TRUE(bench.is("f.BUSY"));
    }
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), 12.0);
    EXPECT_FALSE(bench.is("f.BUSY"));
}

TEST(Transfer, TracksInAutomaticAndMovesByHand) {
    Bench bench("VAR f : TRANSFER; auto : BOOL := TRUE; x : REAL := 40.0; fu, su, fd, sd : BOOL; END_VAR",
                "f(AUTO := auto, XIN := x, FAST_RATE := 10.0, SLOW_RATE := 1.0, FAST_UP := fu, SLOW_UP := su, "
                "FAST_DOWN := fd, SLOW_DOWN := sd, CYCLE := T#100ms);",
                analog, 100ms);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), 40.0);
    bench.set("auto", 0);
    bench.set("x", 99.0);
    bench.scan(10);
    EXPECT_DOUBLE_EQ(bench.real("f.XOUT"), 40.0);
    bench.set("fu", 1);
    bench.set("su", 1);
    bench.scan(10);
    EXPECT_NEAR(bench.real("f.XOUT"), 51.0, 1e-4);
    bench.set("fu", 0);
    bench.set("su", 0);
    bench.set("sd", 1);
    bench.scan(10);
    EXPECT_NEAR(bench.real("f.XOUT"), 50.0, 1e-4);
}

TEST(Weigh, TellsByEnoWhetherThereIsAWeight) {
    Bench bench("VAR gross : WORD; tare : INT := 20; net : WORD; ok, cmd : BOOL := TRUE; END_VAR",
                "net := WEIGH(weigh_command := cmd, gross_weight := gross, tare_weight := tare, ENO => ok);", analog);
    for (const auto& [gross, valid, net] :
         {std::tuple{0x1234, true, 0x1214}, {0x0020, true, 0x0000}, {0x0019, false, 0}, {0x12A4, false, 0}}) {
        bench.set("gross", gross);
        bench.scan();
        EXPECT_EQ(bench.is("ok"), valid) << std::hex << gross;
        EXPECT_EQ(bench.integer("net"), net) << std::hex << gross;
    }
    bench.set("cmd", 0);
    bench.scan();
    EXPECT_FALSE(bench.is("ok"));
}

TEST(CmdMonitor, AlarmsWithoutFeedbackUntilAcknowledged) {
    Bench bench("VAR f : CMD_MONITOR; cmd, fb, ack : BOOL; END_VAR",
                "f(AUTO_CMD := cmd, AUTO_MODE := TRUE, MAN_CMD := FALSE, MAN_CMD_CHK := TRUE, T_CMD_MAX := T#2s, FDBK "
                ":= fb, ACK := ack);",
                analog, 100ms);
    bench.set("cmd", 1);
    bench.scan(20);
    EXPECT_TRUE(bench.is("f.CMD"));
    EXPECT_FALSE(bench.is("f.ALRM"));
    bench.scan(2);
    EXPECT_TRUE(bench.is("f.ALRM"));
    bench.set("fb", 1);
    bench.scan();
    EXPECT_TRUE(bench.is("f.ALRM"));
    bench.set("ack", 1);
    bench.scan();
    EXPECT_FALSE(bench.is("f.ALRM"));
}

TEST(FwdRevMon, BlocksBothDirectionsOnAConflict) {
    Bench bench("VAR f : FWD_REV_MON; fwd, rev, ack : BOOL; END_VAR",
                "f(AUTO := TRUE, ACK := ack, AUTO_FWD := fwd, T_FWD_MAX := T#5s, FWD_FDBK := TRUE, AUTO_REV := rev, "
                "T_REV_MAX := T#5s, REV_FDBK := TRUE);",
                analog);
    bench.set("fwd", 1);
    bench.scan();
    EXPECT_TRUE(bench.is("f.FWD_CMD"));
    bench.set("rev", 1);
    bench.scan();
    EXPECT_FALSE(bench.is("f.FWD_CMD"));
    EXPECT_FALSE(bench.is("f.REV_CMD"));
    EXPECT_TRUE(bench.is("f.KLAXON"));
    bench.set("fwd", 0);
    bench.scan();
    EXPECT_FALSE(bench.is("f.REV_CMD")) << "until acknowledged";
    bench.set("ack", 1);
    bench.scan();
    EXPECT_TRUE(bench.is("f.REV_CMD"));
    EXPECT_FALSE(bench.is("f.KLAXON"));
}

TEST(StackInt, PushesPopsAndOverflows) {
    Bench bench("VAR f : STACK_INT; pu, po, r : BOOL; x : INT; END_VAR",
                "f(PUSH := pu, POP := po, R1 := r, IN := x, N := 2);", analog);
    const auto pulse = [&](const char* button) {
        bench.set(button, 1);
        bench.scan();
        bench.set(button, 0);
        bench.scan();
    };
    pulse("r");
    EXPECT_TRUE(bench.is("f.EMPTY"));
    for (const int value : {11, 22}) {
        bench.set("x", value);
        pulse("pu");
        EXPECT_EQ(bench.integer("f.OUT"), value);
    }
    EXPECT_FALSE(bench.is("f.OFLO"));
    bench.set("x", 33);
    pulse("pu");
    EXPECT_TRUE(bench.is("f.OFLO"));
    EXPECT_EQ(bench.integer("f.OUT"), 0);
    pulse("po");
    EXPECT_FALSE(bench.is("f.OFLO"));
    EXPECT_EQ(bench.integer("f.OUT"), 22);
    pulse("po");
    EXPECT_EQ(bench.integer("f.OUT"), 11);
    pulse("po");
    EXPECT_TRUE(bench.is("f.EMPTY"));
}

} // namespace
} // namespace plc::test
