// Every kind of controller block that can be tuned, in a loop that moves: tried with its own parameters it repeats what
// was recorded, bit for bit; with others it does not.
#include "projects/loops/trial.h"
#include "projects/session/session.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>

using namespace plc;
using namespace plc::loops;

namespace {

struct Kind {
    const char* name; // of the loop
    const char* declaration;
    const char* call;
    const char* output; // what goes to the process
    const char* gain;   // written by the counter-check
};

const Kind kKinds[] = {
    {"Main.c", "c : FB_P;", "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActVal := Measured, i_rKp := Kp);", "c.q_rOput",
     "Main.Kp"},
    {"Main.c",
     "c : FB_PI; para : stPiPara := (tCyclTime := T#20ms, tTn := T#900ms, rKp := 1.3, rMaxLim := 60.0, rMinLim := "
     "-60.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActVal := Measured, i_stPara := para);", "c.q_rOput", "Main.para.rKp"},
    {"Main.c",
     "c : FB_PID; para : stPid := (xActValType := TRUE, rTargCyclTime := 20.0, rLowLim := -60.0, rHighLim := 60.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := Kp, i_rTn := 800.0, i_rTv := 90.0, "
     "i_rTd := 30.0, i_stPid := para);",
     "c.q_rPidOput", "Main.Kp"},
    {"Main.c.PI",
     "c : FB_PI_PID; inner : stPIPIDOutLoop := (rKp := 0.9, tTn := T#700ms, tTd := T#20ms, rMaxLim := 60.0, rMinLim := "
     "-60.0); "
     "outer : stPIPIDInLoop := (tCyclTime := T#20ms, rKp := 1.1, tTn := T#2s, rMaxLim := 80.0, rMinLim := -80.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActValPI := Measured, i_rActValPID := Middle, i_stParaPID := inner, "
     "i_stParaPI := outer);",
     "c.q_rOput", "Main.outer.rKp"},
    {"Main.c.PID",
     "c : FB_PI_PID; inner : stPIPIDOutLoop := (rKp := 0.9, tTn := T#700ms, tTd := T#20ms, rMaxLim := 60.0, rMinLim := "
     "-60.0); "
     "outer : stPIPIDInLoop := (tCyclTime := T#20ms, rKp := 1.1, tTn := T#2s, rMaxLim := 80.0, rMinLim := -80.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActValPI := Measured, i_rActValPID := Middle, i_stParaPID := inner, "
     "i_stParaPI := outer);",
     "c.q_rOput", "Main.inner.rKp"},
    {"Main.c", "c : util.PID;",
     "c(ACTUAL := Measured, SET_POINT := SetPoint, KP := Kp, TN := 0.9, TV := 0.05, Y_MIN := -60.0, Y_MAX := 60.0);",
     "c.Y", "Main.Kp"},
    {"Main.c", "c : util.PID_FIXCYCLE;",
     "c(ACTUAL := Measured, SET_POINT := SetPoint, KP := Kp, TN := 0.9, TV := 0.05, Y_MIN := -60.0, Y_MAX := 60.0, "
     "CYCLE := 0.02);",
     "c.Y", "Main.Kp"},
    {"Main.c", "c : analog.PID;",
     "c(AUTO := TRUE, PV := Measured, SP := SetPoint, KP := -Kp, TR := 0.9, TD := 0.05, CYCLE := T#20ms);", "c.XOUT",
     "Main.Kp"},
    {"Main.c", "c : analog.PID; Gain : REAL := -1.3; Reset : REAL := 0.9;",
     "c(AUTO := TRUE, PV := Measured, SP := SetPoint, KP := Gain, TR := Reset, TD := 0.0, CYCLE := T#20ms);", "c.XOUT",
     "Main.Gain"},
};

std::string programOf(const Kind& kind) {
    return std::string("PROGRAM Main\nVAR\n    Kp : REAL := 1.3; SetPoint, Measured, Middle, Drive : REAL; "
                       "Count, Chance : UDINT := 1;\n    ") +
           kind.declaration +
           "\nEND_VAR\nCount := Count + 1;\nSetPoint := SEL(Count / 150 MOD 2 = 1, 3.3, -7.7);\n"
           "Chance := Chance * 1664525 + 1013904223;\n" +
           kind.call + "\nDrive := " + kind.output +
           ";\nMiddle := Middle + 0.11 * (Drive - Middle);\nMeasured := Measured + 0.07 * (Middle - Measured) + "
           "0.02 * (UDINT_TO_REAL(SHR(Chance, 16)) / 32768.0 - 1.0);\nEND_PROGRAM\n"
           "CONFIGURATION Plc\n    RESOURCE Cpu ON Pc\n        TASK Mast(INTERVAL := T#20ms, PRIORITY := 1);\n"
           "        PROGRAM Main WITH Mast : Main;\n    END_RESOURCE\nEND_CONFIGURATION\n";
}

} // namespace

class BlockKinds : public ::testing::TestWithParam<Kind> {};

TEST_P(BlockKinds, RepeatsItsRecordingBitForBit) {
    const Kind& kind = GetParam();
    driver::BuildInput input;
    input.files = {{"main.st", programOf(kind)}};
    input.libraries = {"toolbox", "util", "analog"};
    const driver::Built built = driver::build(input);
    ASSERT_TRUE(built.program) << kind.declaration;
    session::Session session(built);
    session.runHere([](const controller::Controller& c) { return c.nextScan() >= 1000; });
    const auto loop = findLoop(*built.program, kind.name);
    ASSERT_TRUE(loop) << loop.error().english();
    auto plan = planFor(*loop, session.history(), 40, 1000);
    ASSERT_TRUE(plan) << plan.error().english();

    const auto same = tryOut(session.history(), *plan, std::nullopt);
    ASSERT_TRUE(same) << same.error().english();
    ASSERT_EQ(same->scans, 959U);
    EXPECT_FALSE(same->firstDifference) << kind.declaration << " scan " << same->firstDifference.value_or(0);
    double least = 1e30, greatest = -1e30;
    for (size_t i = 0; i < same->series.size(); ++i) {
        ASSERT_EQ(std::bit_cast<uint64_t>(same->series.input[i]), std::bit_cast<uint64_t>(same->before.input[i])) << i;
        least = std::min(least, same->series.input[i]);
        greatest = std::max(greatest, same->series.input[i]);
    }
    EXPECT_GT(greatest - least, 1) << "nothing moves: nothing is compared";

    plan->writes = {{kind.gain, 1.3000001}}; // the last bit of a REAL
    const auto other = tryOut(session.history(), *plan, std::nullopt);
    ASSERT_TRUE(other) << other.error().english();
    EXPECT_TRUE(other->firstDifference);
}

TEST_P(BlockKinds, GoesOnFromItsOutputWithOtherParameters) {
    const Kind& kind = GetParam();
    driver::BuildInput input;
    input.files = {{"main.st", programOf(kind)}};
    input.libraries = {"toolbox", "util", "analog"};
    const driver::Built built = driver::build(input);
    ASSERT_TRUE(built.program) << kind.declaration;
    const auto loop = findLoop(*built.program, kind.name);
    ASSERT_TRUE(loop) << loop.error().english();
    const auto output = [&](const session::Session& session) {
        return *numberAt(*built.program, session.snapshot(), loop->pin(loop->form->input));
    };
    // how far the output moves in the scan of the write, just behind a step of the set point: there is a large error
    bool isWritten = false;
    const auto jump = [&](bool isBumpless) {
        session::Session session(built);
        session.runHere([](const controller::Controller& c) { return c.nextScan() >= 455; });
        const tuning::ControllerGains now = settingsOf(*loop, *built.program, session.snapshot()).gains;
        const auto wanted =
            tuning::parametersOf(*loop->form, {now.gain * 2, now.integralTime * 1.5, 0, 0}, loop->taskTime);
        auto writes = writesOf(*loop, built.program, wanted);
        isWritten = !writes.empty();
        if (isBumpless)
            for (auto& write : bumplessWrites(*loop, *built.program)) writes.push_back(write);
        for (const ParameterWrite& write : writes) {
            const auto value = valueFor(*built.program, write.path, write.value);
            EXPECT_TRUE(value) << write.path;
            EXPECT_TRUE(session.controller().write(write.path, *value)) << write.path;
        }
        const double before = output(session);
        session.runHere([](const controller::Controller& c) { return c.nextScan() >= 456; });
        return std::abs(output(session) - before);
    };
    if (loop->form->kinds().size() == 1) { // its output is the error times the gain, and nothing else
        EXPECT_GT(jump(true), 1);
        return;
    }
    const double bump = jump(false);
    EXPECT_TRUE(bump > 1 || !isWritten) << kind.declaration;
    // the integral and the measured value move on in that scan
    EXPECT_LT(jump(true), std::max(0.5, 0.1 * bump)) << kind.declaration;
}

namespace {

/// With the gain as a constant of the call, where the call hands it over by itself.
driver::BuildInput withConstant(const Kind& kind, const std::string& gain) {
    std::string text = programOf(kind);
    for (const char* word : {":= Kp", ":= -Kp"})
        if (const size_t at = text.find(word); at != std::string::npos) text.replace(text.find("Kp", at), 2, gain);
    driver::BuildInput input;
    input.files = {{"main.st", text}};
    input.libraries = {"toolbox", "util", "analog"};
    return input;
}

} // namespace

TEST_P(BlockKinds, GoesOnFromItsOutputAfterAnOnlineChangeAtFullSpeed) {
    const Kind& kind = GetParam();
    session::Session session(driver::build(withConstant(kind, "1.3")));
    const auto loop = findLoop(*session.program(), kind.name);
    ASSERT_TRUE(loop);
    if (loop->form->resumes.empty()) return; // its output is the error times the gain, and nothing else
    const driver::Built next = driver::build(withConstant(kind, "2.6"));
    ASSERT_TRUE(next.program);
    session::Together together;
    std::vector<ParameterWrite> writes = bumplessWrites(*loop, *next.program);
    ASSERT_EQ(writes.size(), 1U);
    if (kind.gain != std::string("Main.Kp"))
        writes.push_back({kind.gain, loop->form->isReversed ? -2.6 : 2.6}); // by no constant
    for (const ParameterWrite& write : writes)
        together.values.push_back({write.path, *valueFor(*next.program, write.path, write.value)});
    session.startThread({session::Pace::Fastest});
    const auto scans = [&](uint64_t wanted) { return eventually([&] { return session.status().scans >= wanted; }); };
    ASSERT_TRUE(scans(2000));
    session.changeProgram(next, {}, std::nullopt, together);
    const std::string gain = loop->pin(loop->form->parameters.front().member);
    const auto present = [&] { return std::abs(numberAt(*next.program, session.snapshot(), gain).value_or(0)); };
    ASSERT_TRUE(eventually([&] { return session.program() == next.program && present() > 2; }));
    ASSERT_TRUE(scans(session.status().scans + 1000));
    session.pause();
    ASSERT_TRUE(eventually([&] { return session.status().state == controller::State::Paused; }));
    const auto samplesOf = [&](const std::string& path, history::Position from, history::Position to) {
        return session.history().samples(*session.expression(path), session.recompile(path), from, to);
    };
    const auto changed =
        session.history().findChange(*session.expression(gain), session.recompile(gain),
                                     session.history().statistics().first, history::History::Direction::Forward);
    ASSERT_TRUE(changed);
    constexpr history::Position kAround = 900;
    const auto output = samplesOf(loop->pin(loop->form->input), *changed - kAround, *changed + kAround);
    const auto setPoint = samplesOf("Main.SetPoint", *changed - kAround, *changed + kAround);
    // Compared with the scans that are as far behind a step of the set point, with the old settings and with the new
    // ones. What changes soon after a step goes neither way: half as much again is no bump, which is the error times
    // the gain's difference.
    constexpr size_t kSettled = 11;
    std::array<double, kSettled + 1> around{};
    double there = 0;
    size_t sinceStep = kSettled, thereSinceStep = kSettled;
    for (size_t i = 1; i < output.size(); ++i) {
        const double moved = std::abs(output[i].value - output[i - 1].value);
        sinceStep = setPoint[i].value != setPoint[i - 1].value ? 0 : std::min(sinceStep + 1, kSettled);
        if (i == kAround) {
            there = moved;
            thereSinceStep = sinceStep;
        } else {
            around[sinceStep] = std::max(around[sinceStep], moved);
        }
    }
    EXPECT_GT(around[kSettled], 0.01) << "nothing moves: nothing is compared";
    EXPECT_LE(there, 1.5 * around[thereSinceStep])
        << kind.declaration << " scan " << *changed << ", " << thereSinceStep << " behind a step";
}

INSTANTIATE_TEST_SUITE_P(All, BlockKinds, ::testing::ValuesIn(kKinds),
                         [](const auto& info) { return "Number" + std::to_string(info.index); });
