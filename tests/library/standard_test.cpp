// The standard function blocks: input and output tables per scan, after the timing diagrams of IEC 61131-3.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

namespace plc::test {
namespace {

std::string series(Bench& bench, const std::string& input, const std::string& inputs, const std::string& output) {
    std::string out;
    for (const char c : inputs) {
        bench.set(input, c == '1');
        bench.scan();
        out += bench.is(output) ? '1' : '0';
    }
    return out;
}

TEST(Timers, FollowTheTimingDiagrams) {
    for (const std::string kind : {"", "_TIME", "_LTIME"}) { // 300 ms at 100 ms a scan
        const std::string preset = kind == "_LTIME" ? "LTIME#300ms" : "T#300ms";
        const auto bench = [&](const std::string& block) {
            return Bench("VAR t : " + block + kind + "; x : BOOL; END_VAR", "t(IN := x, PT := " + preset + ");", {},
                         100ms);
        };
        Bench on = bench("TON"), off = bench("TOF"), pulse = bench("TP");
        EXPECT_EQ(series(on, "x", "0111000111111100", "t.Q"), "0000000000111100");
        EXPECT_EQ(series(off, "x", "0110000001001111000", "t.Q"), "0111110001111111111");
        EXPECT_EQ(series(pulse, "x", "0100000111111101011100", "t.Q"), "0111000111000001110000");
    }
    Bench shortened("VAR t : LTON; x : BOOL; END_VAR", "t(IN := x, PT := LTIME#300ms);", {}, 100ms);
    EXPECT_EQ(series(shortened, "x", "0111110", "t.Q"), "0000110");
}

TEST(Timers, CountTheirElapsedTime) {
    Bench bench("VAR t : TON; f : TOF; p : TP; x : BOOL := TRUE; END_VAR",
                "t(IN := x, PT := T#250ms); f(IN := x, PT := T#250ms); p(IN := x, PT := T#250ms);", {}, 100ms);
    for (const int64_t ms : {0, 100, 200, 250, 250}) {
        bench.scan();
        EXPECT_EQ(bench.integer("t.ET"), ms * 1'000'000);
        EXPECT_EQ(bench.integer("p.ET"), ms * 1'000'000);
        EXPECT_EQ(bench.integer("f.ET"), 0);
    }
    bench.set("x", 0);
    for (const int64_t ms : {0, 100, 200, 250, 250}) {
        bench.scan();
        EXPECT_EQ(bench.integer("t.ET"), 0);
        EXPECT_EQ(bench.integer("p.ET"), 0);
        EXPECT_EQ(bench.integer("f.ET"), ms * 1'000'000);
    }
}

TEST(Timers, RestartThemselvesEveryPresetPlusTwoScans) {
    Bench bench("VAR t : TON; n : INT; END_VAR", "t(IN := NOT t.Q, PT := T#1s); IF t.Q THEN n := n + 1; END_IF", {},
                100ms);
    bench.scan(1 + 10);
    EXPECT_EQ(bench.integer("n"), 1);
    bench.scan(12 * 9);
    EXPECT_EQ(bench.integer("n"), 10);
}

TEST(Edges, GiveOneScan) {
    Bench rising("VAR t : R_TRIG; x : BOOL; END_VAR", "t(CLK := x);", {}),
        falling("VAR t : F_TRIG; x : BOOL; END_VAR", "t(CLK := x);", {});
    EXPECT_EQ(series(rising, "x", "0110100", "t.Q"), "0100100");
    EXPECT_EQ(series(falling, "x", "1100100", "t.Q"), "0010010");
}

TEST(Bistables, DifferInWhatWins) {
    Bench bench("VAR s : SR; r : RS; a, b : BOOL; END_VAR", "s(S1 := a, R := b); r(S := a, R1 := b);", {});
    for (const auto& [set, reset, sr, rs] :
         {std::tuple{0, 0, 0, 0}, {1, 0, 1, 1}, {0, 0, 1, 1}, {1, 1, 1, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}}) {
        bench.set("a", set);
        bench.set("b", reset);
        bench.scan();
        EXPECT_EQ(bench.is("s.Q1"), sr);
        EXPECT_EQ(bench.is("r.Q1"), rs);
    }
}

TEST(Semaphore, IsOwnedByWhoFindsItFree) {
    Bench bench("VAR s : SEMA; c, r : BOOL; END_VAR", "s(CLAIM := c, RELEASE := r);", {});
    for (const auto& [claim, release, busy] :
         {std::tuple{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}) {
        bench.set("c", claim);
        bench.set("r", release);
        bench.scan();
        EXPECT_EQ(bench.is("s.BUSY"), busy);
    }
}

TEST(Counters, CountEdgesInEveryWidth) {
    for (const std::string suffix : {"", "_INT", "_DINT", "_LINT", "_UINT", "_UDINT", "_ULINT"}) {
        Bench bench("VAR u : CTU" + suffix + "; d : CTD" + suffix + "; b : CTUD" + suffix +
                        "; x, y, r, l : BOOL; END_VAR",
                    "u(CU := x, RESET := r, PV := 3); d(CD := x, LOAD := l, PV := 3); b(CU := x, CD := y, R := r, LD "
                    ":= l, PV := 3);",
                    {});
        SCOPED_TRACE("CTU" + suffix);
        bench.set("l", 1);
        bench.scan();
        EXPECT_EQ(bench.integer("d.CV"), 3);
        EXPECT_EQ(bench.integer("b.CV"), 3);
        EXPECT_TRUE(bench.is("b.QU"));
        bench.set("l", 0);
        bench.set("r", 1);
        bench.scan();
        EXPECT_TRUE(bench.is("b.QD"));
        bench.set("r", 0);
        EXPECT_EQ(series(bench, "x", "0110101011", "u.Q"), "0000001111");
        EXPECT_EQ(bench.integer("u.CV"), 4);
        EXPECT_EQ(bench.integer("b.CV"), 4);
        EXPECT_TRUE(bench.is("d.Q"));
        bench.set("x", 0);
        bench.scan();
        bench.set("x", 1);
        bench.set("y", 1);
        bench.scan();
        EXPECT_EQ(bench.integer("b.CV"), 4) << "both edges at once";
        EXPECT_EQ(series(bench, "y", "0101", "b.QU"), "1110");
        EXPECT_EQ(bench.integer("b.CV"), 2);
    }
}

TEST(Counters, StopAtTheEndOfTheirRange) {
    Bench bench("VAR u : CTU; d : CTD; x : BOOL; END_VAR", "x := NOT x; u(CU := x, PV := 100); d(CD := x, PV := 100);",
                {});
    bench.scan();
    bench.set("u.CV", 32766);
    bench.set("d.CV", -32767);
    bench.scan(20);
    EXPECT_EQ(bench.integer("u.CV"), 32767);
    EXPECT_EQ(bench.integer("d.CV"), -32768);
}

TEST(RealTimeClock, GoesOnFromWhatItIsSetTo) {
    Bench bench("VAR c : RTC; on : BOOL; END_VAR", "c(IN := on, PDT := DT#2024-02-28-23:59:58);", {}, 500ms);
    bench.scan();
    EXPECT_FALSE(bench.is("c.Q"));
    bench.set("on", 1);
    bench.scan(7);
    const types::Value now = bench.value("c.CDT");
    EXPECT_EQ(types::toText(*bench.built().program->layout.types, now), "DT#2024-02-29-00:00:01");
    EXPECT_TRUE(bench.is("c.Q"));
}

} // namespace
} // namespace plc::test
