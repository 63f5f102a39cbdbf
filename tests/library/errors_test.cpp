// Each error number of the Toolbox: what sets it, that it stays when the cause goes, that only a rising edge of the
// reset clears it.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

namespace plc::test {
namespace {

struct ErrorCase {
    const char* block;
    const char* declarations;                       // beside the block f
    const char* good;                               // statements that give right parameters
    const char* call;                               // arguments, without enable and reset
    const char* output;                             // must be 0 in error
    std::vector<std::pair<const char*, int>> wrong; // statement that spoils a parameter, error number
};

const std::vector<ErrorCase>& errorCases() {
    static const std::vector<ErrorCase> cases{
        {"FB_2points",
         "p : stPtPara;",
         "p.tCyclTime := T#10ms; p.rHyst := 2.0;",
         "i_rSp := 10.0, i_rActVal := 0.0, i_stPara := p",
         "BOOL_TO_INT(f.q_xOput)",
         {{"p.tCyclTime := T#0s;", 1},
          {"p.rHyst := 0.0;", 2},
          {"p.rHyst := -1.0;", 2},
          {"p.tCyclTime := T#0s; p.rHyst := 0.0;", 1}}},
        {"FB_3points",
         "p : st3PointsPara;",
         "p.rPstvOutOn := 2.0; p.rPstvOutOff := 1.0; p.rNgtvOutOn := 2.0; p.rNgtvOutOff := 1.0;",
         "i_rSp := 10.0, i_rActVal := 0.0, i_iManVal := 0, i_stPara := p",
         "BOOL_TO_INT(f.q_xPstv)",
         {{"p.rPstvOutOn := -1.0;", 1},
          {"p.rPstvOutOff := -1.0;", 1},
          {"p.rNgtvOutOn := -1.0;", 1},
          {"p.rNgtvOutOff := -1.0;", 1},
          {"p.rPstvOutOn := 0.5;", 2},
          {"p.rNgtvOutOn := 0.5;", 2}}},
        {"FB_3points_Ext",
         "p : st3PtsExtendedPara;",
         "p.rOutOn := 2.0; p.rOutOff := 1.0; p.rGain := 1.0; p.rOfst := 1.0;",
         "i_rSp := 10.0, i_rActVal := 0.0, i_stPara := p",
         "f.q_rOput",
         {{"p.rOutOn := -1.0;", 1},
          {"p.rOutOff := -1.0;", 1},
          {"p.rOutOn := 0.5;", 2},
          {"p.rGain := -1.0;", 3},
          {"p.rOfst := -1.0;", 4}}},
        {"FB_P",
         "kp : REAL;",
         "kp := 2.0;",
         "i_rSp := 10.0, i_rActVal := 0.0, i_rKp := kp",
         "f.q_rOput",
         {{"kp := -0.5;", 1}}},
        {"FB_PI",
         "p : stPiPara;",
         "p.tCyclTime := T#10ms; p.tTn := T#1s; p.rKp := 2.0; p.rMaxLim := 100.0; p.rMinLim := -100.0;",
         "i_rSp := 10.0, i_rActVal := 0.0, i_stPara := p",
         "f.q_rOput",
         {{"p.tCyclTime := T#0s;", 1}, {"p.rMaxLim := -101.0;", 2}, {"p.rKp := -1.0;", 3}, {"p.tTn := T#0s;", 4}}},
        {"FB_PID",
         "p : stPid; kp, tn, tv, td : REAL;",
         "p.xActValType := TRUE; p.rDbnd := 0.0; p.rTargCyclTime := 10.0; p.rLowLim := -100.0; p.rHighLim := 100.0; "
         "p.rInerWndo := 0.0; p.rOterWndo := 50.0;"
         "kp := 2.0; tn := 1000.0; tv := 0.0; td := 20.0;",
         "i_rSp := 10.0, i_rPv1 := 0.0, i_rKp := kp, i_rTn := tn, i_rTv := tv, i_rTd := td, i_stPid := p",
         "f.q_rPidOput",
         {{"p.rTargCyclTime := 0.0;", 20},
          {"p.rTargCyclTime := 60000.0;", 20},
          {"p.rHighLim := -101.0;", 114},
          {"p.rDbnd := -1.0;", 115},
          {"p.rDbnd := 101.0;", 115},
          {"kp := -1.0;", 200},
          {"tn := -1.0;", 200},
          {"tn := 60001.0;", 200},
          {"tv := -1.0;", 200},
          {"tv := 60001.0;", 200},
          {"td := 9.0;", 201},
          {"td := 60000.0;", 201},
          {"p.rInerWndo := -1.0;", 202},
          {"p.rOterWndo := -1.0;", 202},
          {"p.rInerWndo := 51.0;", 202}}},
        {"FB_DeadBand",
         "limit : REAL;",
         "limit := 1.0;",
         "i_rInput := 5.0, i_rThshVal := limit",
         "f.q_rOput",
         {{"limit := -1.0;", 1}}},
        {"FB_Limiter",
         "limit : REAL;",
         "limit := 1.0;",
         "i_rInput := 5.0, i_rMinOput := 0.0, i_rMaxOput := limit",
         "f.q_rOput",
         {{"limit := -1.0;", 1}}},
        {"FB_PWM",
         "p : stPwmPara;",
         "p.tCyclTime := T#10ms; p.tPwmPeriod := T#100ms;",
         "i_rInput := 100.0, i_stPara := p",
         "BOOL_TO_INT(f.q_xPstv)",
         {{"p.tCyclTime := T#0s;", 1}, {"p.tPwmPeriod := T#10ms;", 2}}},
        {"FB_Scaling",
         "high : REAL;",
         "high := 10.0;",
         "i_rInput := 5.0, i_rMinInput := 0.0, i_rMaxInput := high, i_rMinOutput := 0.0, i_rMaxOutput := 100.0",
         "f.q_rOput",
         {{"high := 0.0;", 1}}},
        {"Filter_AnalogInput",
         "limit : REAL;",
         "limit := 1.0;",
         "i_rInput := 5.0, i_rMaxInputDiff := limit",
         "f.q_rOput",
         {{"limit := -1.0;", 1}}},
        {"Filter_Arithmetic",
         "count : UINT;",
         "count := 1;",
         "i_rInput := 5.0, i_uiSmplCnt := count",
         "f.q_rOput",
         {{"count := 0;", 1}}},
        {"Filter_MovingAverage",
         "count : UINT;",
         "count := 10;",
         "i_rInput := 5.0, i_uiSmplCnt := count",
         "f.q_rOput",
         {{"count := 101;", 1}}},
        {"Filter_PT1",
         "cycle, tau : TIME;",
         "cycle := T#10ms; tau := T#100ms;",
         "i_rInput := 5.0, i_tCyclTime := cycle, i_rKp := 1.0, i_tFltrTime := tau",
         "f.q_rOput",
         {{"cycle := T#0s;", 1}, {"tau := T#9ms;", 2}}},
    };
    return cases;
}

TEST(ToolboxErrors, AreSetByTheirCauseAndClearedByTheResetOnly) {
    for (const ErrorCase& each : errorCases()) {
        std::string body = std::string(each.good) + "\nCASE spoil OF\n0: ;\n";
        for (size_t i = 0; i < each.wrong.size(); ++i)
            body += std::to_string(i + 1) + ": " + each.wrong[i].first + "\n";
        body += "END_CASE\nf(i_xEn := TRUE, i_xErrRst := reset, " + std::string(each.call) +
                ");\nout := " + each.output + ";\n";
        const driver::Built built =
            buildText(programText("VAR f : " + std::string(each.block) + "; " + each.declarations +
                                      " spoil : INT; reset : BOOL; out : REAL; END_VAR",
                                  body, 10ms),
                      {"toolbox"});
        for (size_t i = 0; i < each.wrong.size(); ++i) {
            SCOPED_TRACE(std::string(each.block) + ": " + each.wrong[i].first);
            Bench bench(built);
            bench.scan(2);
            EXPECT_EQ(bench.integer("f.q_uiErrId"), 0);
            EXPECT_TRUE(bench.is("f.q_xBusy"));
            EXPECT_NE(bench.real("out"), 0.0);
            if (std::string(each.block) == "FB_PID") { // its limits and windows are taken over by enabling
                bench = Bench(built);
            }
            bench.set("spoil", double(i + 1));
            bench.scan(2);
            EXPECT_EQ(bench.integer("f.q_uiErrId"), each.wrong[i].second);
            EXPECT_TRUE(bench.is("f.q_xErr"));
            EXPECT_TRUE(bench.is("f.q_xEn"));
            EXPECT_FALSE(bench.is("f.q_xBusy"));
            EXPECT_EQ(bench.real("out"), 0.0);
            // a reset while the cause lasts changes nothing
            bench.set("reset", 1);
            bench.scan();
            EXPECT_EQ(bench.integer("f.q_uiErrId"), each.wrong[i].second);
            // neither does the end of the cause, nor a reset that stays TRUE
            bench.set("spoil", 0);
            bench.scan(3);
            EXPECT_EQ(bench.integer("f.q_uiErrId"), each.wrong[i].second);
            bench.set("reset", 0);
            bench.scan();
            bench.set("reset", 1);
            bench.scan();
            EXPECT_EQ(bench.integer("f.q_uiErrId"), 0);
            EXPECT_FALSE(bench.is("f.q_xErr"));
            bench.scan(2);
            EXPECT_TRUE(bench.is("f.q_xBusy"));
            EXPECT_NE(bench.real("out"), 0.0);
        }
    }
}

TEST(ToolboxErrors, OfTheCascadeAreNumberedPerLoop) {
    const std::vector<std::tuple<const char*, int, int>> cases{
        {"outer.tCyclTime := T#0s;", 1, 0}, {"outer.tCyclTime := T#61s;", 1, 2}, {"outer.rMaxLim := -101.0;", 2, 0},
        {"outer.rKp := -1.0;", 3, 0},       {"outer.tTn := T#61s;", 4, 0},       {"inner.tTv := T#61s;", 0, 1},
        {"inner.tTn := T#61s;", 0, 1},      {"inner.tTd := T#61s;", 0, 1},       {"inner.rKp := -1.0;", 0, 1},
        {"inner.tTd := T#4ms;", 0, 2},      {"inner.rMaxLim := -101.0;", 0, 3},  {"inner.rInerWndo := -1.0;", 0, 4},
        {"inner.rOterWndo := -1.0;", 0, 4}, {"inner.rInerWndo := 60.0;", 0, 4}};
    std::string body =
        "outer.tCyclTime := T#10ms; outer.rKp := 2.0; outer.tTn := T#1s; outer.rMaxLim := 100.0; outer.rMinLim := "
        "-100.0;\n"
        "inner.rKp := 3.0; inner.tTn := T#1s; inner.tTv := T#0s; inner.tTd := T#20ms; inner.rMaxLim := 100.0; "
        "inner.rMinLim := -100.0; inner.rInerWndo := 0.0; inner.rOterWndo := 50.0;\nCASE spoil OF\n0: ;\n";
    for (size_t i = 0; i < cases.size(); ++i) body += std::to_string(i + 1) + ": " + std::get<0>(cases[i]) + "\n";
    body += "END_CASE\nf(i_xEn := TRUE, i_xErrRst := reset, i_rSp := 5.0, i_rActValPI := 0.0, i_rActValPID := 0.0, "
            "i_rPreCtrlVal := 0.0, i_stParaPID := inner, i_stParaPI := outer);";
    const driver::Built built = buildText(
        programText(
            "VAR f : FB_PI_PID; inner : stPIPIDOutLoop; outer : stPIPIDInLoop; spoil : INT; reset : BOOL; END_VAR",
            body, 10ms),
        {"toolbox"});
    for (size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(std::get<0>(cases[i]));
        Bench bench(built);
        bench.scan();
        EXPECT_TRUE(bench.is("f.q_xBusy"));
        bench.set("spoil", double(i + 1));
        bench.scan();
        bench.set("spoil", 0);
        bench.scan();
        EXPECT_EQ(bench.integer("f.q_uiErrIdPI"), std::get<1>(cases[i]));
        EXPECT_EQ(bench.integer("f.q_uiErrIdPID"), std::get<2>(cases[i]));
        EXPECT_EQ(bench.is("f.q_xErrPI"), std::get<1>(cases[i]) != 0);
        EXPECT_EQ(bench.is("f.q_xErrPID"), std::get<2>(cases[i]) != 0);
        EXPECT_EQ(bench.real("f.q_rOput"), 0.0);
        EXPECT_FALSE(bench.is("f.q_xBusy"));
        bench.set("reset", 1);
        bench.scan();
        EXPECT_TRUE(bench.is("f.q_xBusy"));
        EXPECT_FALSE(bench.is("f.q_xErrPI"));
        EXPECT_FALSE(bench.is("f.q_xErrPID"));
    }
}

} // namespace
} // namespace plc::test
