// The loops of programs: found by their blocks, read from the recording, and the variables their parameters come from.
#include "projects/loops/loops.h"
#include "projects/session/session.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::loops;

namespace {

const char* const kProgram = R"(
TYPE Zone : STRUCT heater : FB_PI; END_STRUCT END_TYPE
PROGRAM Main
VAR
    Gain : REAL := 2.5;
    SetPoint : REAL := 10.0;
    Measured : REAL;
    para : stPiPara := (tCyclTime := T#50ms, tTn := T#4s, rKp := 1.5, rMaxLim := 100.0, rMinLim := -100.0);
    pid : FB_PID;
    parameters : stPid := (xActValType := TRUE, rTargCyclTime := 50.0, rLowLim := -20.0, rHighLim := 20.0);
    zones : ARRAY[1..2] OF Zone;
    cascade : FB_PI_PID;
    simple : util.PID;
END_VAR
pid(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := Gain, i_rTn := 800.0, i_rTd := 60.0, i_stPid := parameters);
zones[1].heater(i_xEn := TRUE, i_rSp := 5.0, i_stPara := para);
simple(SET_POINT := 3.0, KP := Gain * 2.0);
Measured := Measured + 0.05 * (pid.q_rPidOput - Measured);
END_PROGRAM
CONFIGURATION Plc
    RESOURCE Cpu ON Pc
        TASK Mast(INTERVAL := T#50ms, PRIORITY := 1);
        PROGRAM Main WITH Mast : Main;
    END_RESOURCE
END_CONFIGURATION
)";

driver::Built buildProgram() {
    driver::BuildInput input;
    input.files = {{"main.st", kProgram}};
    input.libraries = {"toolbox", "util"};
    return driver::build(input);
}

class Loops : public ::testing::Test {
protected:
    void SetUp() override {
        built = buildProgram();
        ASSERT_TRUE(built.program);
        session = std::make_unique<session::Session>(built);
        session->runHere([](const controller::Controller& c) { return c.nextScan() >= 200; });
    }
    driver::Built built;
    std::unique_ptr<session::Session> session;
};

} // namespace

TEST_F(Loops, AreFoundInProgramsStructuresAndArrays) {
    std::vector<std::string> names;
    for (const Loop& loop : loopsOf(*built.program)) names.push_back(loop.name);
    EXPECT_EQ(names, (std::vector<std::string>{"Main.pid", "Main.zones[1].heater", "Main.zones[2].heater",
                                               "Main.cascade.PI", "Main.cascade.PID", "Main.simple"}));
}

TEST_F(Loops, AreNamedInPart) {
    EXPECT_EQ(findLoop(*built.program, "PID")->name, "Main.pid"); // the whole last part, not that of the cascade
    EXPECT_EQ(findLoop(*built.program, "main.cascade.pi")->name, "Main.cascade.PI");
    const auto several = findLoop(*built.program, "heater");
    ASSERT_FALSE(several);
    EXPECT_NE(several.error().english().find("several"), std::string::npos) << several.error().english();
    EXPECT_NE(several.error().english().find("zones[2].heater"), std::string::npos) << several.error().english();
    EXPECT_EQ(several.error().english().find("Main.simple"), std::string::npos) << several.error().english();
    const auto none = findLoop(*built.program, "nothing");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().english().find("There is no loop"), std::string::npos) << none.error().english();
    EXPECT_NE(none.error().english().find("Main.simple"), std::string::npos) << none.error().english();
}

TEST_F(Loops, SignalsComeFromTheRecording) {
    const auto recorded = seriesOf(session->history(), signalsOf(*findLoop(*built.program, "Main.pid")));
    ASSERT_TRUE(recorded) << recorded.error().english();
    EXPECT_EQ(recorded->series.size(), 200U);
    EXPECT_NEAR(recorded->series.time[10], 0.5, 1e-9);
    EXPECT_EQ(recorded->series.setPoint[5], 10);
    EXPECT_GT(recorded->series.output.back(), 5);
    EXPECT_EQ(seriesOf(session->history(), {"Main.nothing", "Main.Gain", ""}).error().english().find("nothing") != 0,
              true);
    EXPECT_FALSE(seriesOf(session->history(), {"Main.nothing", "Main.Gain", ""}));
}

TEST(RecordedLoop, IsReadScanByScanWhileTheOldestScansAreForgotten) {
    // three names of one count: where they differ, values of different scans stand side by side
    driver::BuildInput input;
    input.files = {{"main.st", R"(PROGRAM Main
VAR count, same, again : UDINT; END_VAR
count := count + 1;
same := count;
again := count;
END_PROGRAM
)"}};
    const driver::Built counter = driver::build(input);
    ASSERT_TRUE(counter.program);
    session::Settings settings;
    settings.historyBudget = size_t(4) << 20;
    session::Session session(counter, settings);
    session.startThread({session::Pace::Fastest, 1.0});
    while (session.history().statistics().first == 0) std::this_thread::yield();
    for (int i = 0; i < 50; ++i) {
        const auto recorded = seriesOf(session.history(), {"Main.count", "Main.same", "Main.again"});
        if (!recorded) continue; // all of it was forgotten while it was read
        const tuning::LoopSeries& series = recorded->series;
        ASSERT_EQ(series.input.size(), series.output.size());
        for (size_t at = 0; at < series.size(); ++at) {
            ASSERT_EQ(series.input[at], series.output[at]) << "row " << at << " of " << series.size();
            ASSERT_EQ(series.input[at], series.setPoint[at]) << "row " << at << " of " << series.size();
        }
        for (const size_t at : {size_t(0), series.size() / 2, series.size() - 1}) // each scan counts one
            ASSERT_EQ(recorded->position(at), static_cast<history::Position>(series.input[at]) - 1) << "sample " << at;
    }
}

TEST(RecordedLoop, KnowsItsScansWhereTimeWentBack) {
    const driver::Built built = buildProgram();
    ASSERT_TRUE(built.program);
    session::Session session(built);
    session.runHere([](const controller::Controller& c) { return c.nextScan() >= 100; });
    ASSERT_TRUE(session.resumeFrom(39));
    session.runHere([](const controller::Controller& c) { return c.nextScan() >= 60; });
    const auto recorded = seriesOf(session.history(), signalsOf(*findLoop(*built.program, "Main.pid")));
    ASSERT_TRUE(recorded) << recorded.error().english();
    ASSERT_EQ(recorded->series.size(), 60U);
    EXPECT_EQ(recorded->position(39), 39U);
    EXPECT_EQ(recorded->position(40), 100U); // the 60 scans between were left behind
    EXPECT_EQ(recorded->position(59), 119U);
    for (size_t i = 0; i < 60; ++i)
        EXPECT_NEAR(recorded->series.time[i],
                    std::chrono::duration<double>(session.history().stamp(recorded->position(i))->time).count(), 1e-9);
}

TEST_F(Loops, InternalSignalsOfACascadeCanBeRead) {
    const auto series = seriesOf(session->history(), signalsOf(*findLoop(*built.program, "Main.cascade.PI")));
    ASSERT_TRUE(series) << series.error().english();
}

TEST_F(Loops, SettingsAreReadInSeconds) {
    const auto image = session->snapshot();
    const Settings pid = settingsOf(*findLoop(*built.program, "Main.pid"), *built.program, image);
    EXPECT_NEAR(pid.gains.gain, 2.5, 1e-6);
    EXPECT_NEAR(pid.gains.integralTime, 0.8, 1e-6);
    EXPECT_NEAR(pid.gains.filterTime, 0.06, 1e-6);
    EXPECT_NEAR(pid.cycle, 0.05, 1e-9);
    EXPECT_EQ(pid.low, -20);
    EXPECT_EQ(pid.high, 20);
    const Settings heater = settingsOf(*findLoop(*built.program, "zones[1].heater"), *built.program, image);
    EXPECT_NEAR(heater.gains.integralTime, 4, 1e-9);
    EXPECT_NEAR(heater.cycle, 0.05, 1e-9);
}

TEST_F(Loops, ParametersAreWrittenWhereTheyComeFrom) {
    const auto pathsOf = [&](const char* name) {
        std::vector<std::string> out;
        for (const Target& target : targetsOf(*findLoop(*built.program, name), built.program))
            out.push_back(target.path);
        return out;
    };
    // a variable; a constant in the call; a pin that no call fills
    EXPECT_EQ(pathsOf("Main.pid"), (std::vector<std::string>{"Main.Gain", "", "Main.pid.i_rTv", ""}));
    EXPECT_EQ(pathsOf("Main.zones[2].heater"),
              (std::vector<std::string>{"Main.zones[2].heater.i_stPara.rKp", "Main.zones[2].heater.i_stPara.tTn"}));
    EXPECT_EQ(pathsOf("Main.simple"), (std::vector<std::string>{"", "Main.simple.TN", "Main.simple.TV"}));
}
