// The tuning dock with each controller block that can be tuned: it is found, written and taken back, and the output
// goes on without a bump.
#include "projects/loops/loops.h"
#include "tests/app/tuning_dock.h"
#include "tests/support/repeats.h"

namespace plc::app {
namespace {

/// Each controller block that can be tuned, with parameters in variables.
struct DockBlock {
    const char* name;
    const char* loop; // in the list
    const char* library;
    const char* declaration; // with the gain in Kp, or in para
    const char* call;
    const char* output;
    const char* gain; // path
};

const DockBlock kDockBlocks[] = {
    {"P", "Main.c", "toolbox", "c : FB_P;", "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActVal := Measured, i_rKp := Kp);",
     "c.q_rOput", "Main.Kp"},
    {"Pi", "Main.c", "toolbox",
     "c : FB_PI; para : stPiPara := (tCyclTime := T#10ms, tTn := T#900ms, rKp := 1.5, rMaxLim := 1000.0, rMinLim := "
     "-1000.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActVal := Measured, i_stPara := para);", "c.q_rOput", "Main.para.rKp"},
    {"Pid", "Main.c", "toolbox",
     "c : FB_PID; para : stPid := (xActValType := TRUE, rTargCyclTime := 10.0, rLowLim := -1000.0, rHighLim := "
     "1000.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := Kp, i_rTn := Tn, i_rTd := 60.0, i_stPid := "
     "para);",
     "c.q_rPidOput", "Main.Kp"},
    {"Cascade", "Main.c.PID", "toolbox",
     "c : FB_PI_PID; inner : stPIPIDOutLoop := (rKp := 1.5, tTn := T#900ms, tTd := T#60ms, rMaxLim := 1000.0, rMinLim "
     ":= -1000.0); outer : stPIPIDInLoop := (tCyclTime := T#10ms, rKp := 0.5, tTn := T#2s, rMaxLim := 100.0, rMinLim "
     ":= -100.0);",
     "c(i_xEn := TRUE, i_xManModePI := TRUE, i_rManValPI := SetPoint, i_rActValPID := Measured, i_stParaPID := inner, "
     "i_stParaPI := outer);",
     "c.q_rOput", "Main.inner.rKp"},
    {"Util", "Main.c", "util", "c : util.PID;",
     "c(ACTUAL := Measured, SET_POINT := SetPoint, KP := Kp, TN := Seconds, TV := 0.0, Y_MIN := -1000.0, Y_MAX := "
     "1000.0);",
     "c.Y", "Main.Kp"},
    {"UtilFixed", "Main.c", "util", "c : util.PID_FIXCYCLE;",
     "c(ACTUAL := Measured, SET_POINT := SetPoint, KP := Kp, TN := Seconds, TV := 0.0, Y_MIN := -1000.0, Y_MAX := "
     "1000.0, CYCLE := 0.01);",
     "c.Y", "Main.Kp"},
    {"AnnexF", "Main.c", "analog", "c : analog.PID; Reversed : REAL := -1.5;",
     "c(AUTO := TRUE, PV := Measured, SP := SetPoint, KP := Reversed, TR := Seconds, TD := 0.0, CYCLE := T#10ms);",
     "c.XOUT", "Main.Reversed"},
};

class TuningDockBlocks : public TuningDock, public ::testing::WithParamInterface<DockBlock> {
protected:
    QByteArray program() const override {
        QByteArray text = kTunedLoop;
        const int call = text.indexOf("pid(i_xEn"), end = text.indexOf('\n', call);
        text.replace(call, end - call, GetParam().call);
        const int declaration = text.indexOf("    pid : FB_PID;"), first = text.indexOf("    first : REAL;");
        text.replace(declaration, first - declaration,
                     QByteArray("    Seconds : REAL := 0.9;\n    ") + GetParam().declaration + "\n");
        return text.replace("pid.q_rPidOput", GetParam().output);
    }
    QByteArray libraries() const override { return GetParam().library; }
};

TEST_P(TuningDockBlocks, IsFoundWrittenAndTakenBack) {
    const DockBlock& block = GetParam();
    auto* loop = part<QComboBox>("tuningLoop");
    loop->setCurrentIndex(loop->findText(block.loop));
    ASSERT_EQ(loop->currentText(), block.loop);
    findSteps();
    ASSERT_TRUE(waitForTrial()) << chart("tuningTrial").title;
    const double before = value(block.gain);
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    ASSERT_TRUE(part<QPushButton>("tuningWrite")->isEnabled());
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value(block.gain) != before; }));
    EXPECT_EQ(value(block.gain) < 0, before < 0);
    click("tuningBack");
    ASSERT_TRUE(waitFor([&] { return value(block.gain) == before; }));
}

INSTANTIATE_TEST_SUITE_P(All, TuningDockBlocks, ::testing::ValuesIn(kDockBlocks),
                         [](const auto& info) { return std::string(info.param.name); });

/// The set point goes up and down without rest, so that there is an error in every scan and the output always moves.
class TuningDockMoving : public TuningDockBlocks {
protected:
    QByteArray program() const override {
        QByteArray text = TuningDockBlocks::program();
        text.replace("    scan : UDINT;", "    scan : UDINT;\n    Waves : BOOL;");
        return text.replace("MOD 2) * 10.0;",
                            "MOD 2) * 10.0;\nIF Waves THEN\n    SetPoint := ABS(UDINT_TO_REAL(scan MOD 400) - 200.0) / "
                            "10.0;\nEND_IF");
    }
    void startWaves() {
        control().start();
        ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
        ASSERT_TRUE(control().write("Main.Waves", "TRUE"));
        ASSERT_TRUE(waitFor([&] { return control().value("Main.Waves").text == "TRUE"; }));
        waitForScans();
    }
    /// Enough of them to see how the loop moves with the settings of now.
    void waitForScans() {
        const uint64_t now = control().status().scans;
        ASSERT_TRUE(waitFor([&] { return control().status().scans > now + 3000; }));
    }
    void changeGain(const char* button, const std::string& pin) {
        ASSERT_TRUE(waitFor([&] { return part<QPushButton>(button)->isEnabled() && control().isUpToDate(); }));
        const double before = value(pin.c_str());
        click(button);
        ASSERT_TRUE(waitFor([&] { return value(pin.c_str()) != before; })) << button;
        waitForScans();
    }
    /// Writes and takes back a few times at full speed. After each the output's move in the scan in which the gain
    /// changed is compared with its greatest move in the scans around; at once, because at this speed the recording
    /// soon forgets its beginning.
    void writeAndTakeBackWithoutABump() {
        auto* list = part<QComboBox>("tuningLoop");
        list->setCurrentIndex(list->findText(GetParam().loop));
        findSteps();
        startWaves();
        const auto loop = loops::findLoop(*control().session()->program(), GetParam().loop);
        ASSERT_TRUE(loop);
        const std::string gain = loop->pin(loop->form->parameters.front().member);
        const std::string output = loop->pin(loop->form->input);
        for (int i = 0; i < 2 * repeats(3); ++i) {
            const history::Position begin = control().status().position;
            changeGain(i % 2 == 0 ? "tuningWrite" : "tuningBack", gain);
            pause();
            expectNoBumpWhereItChanged(gain, output, begin, i);
            control().start();
            ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
            waitForScans();
        }
    }
    void expectNoBumpWhereItChanged(const std::string& gain, const std::string& output, history::Position begin,
                                    int change) {
        const session::Session& session = *control().session();
        const auto expression = session.expression(gain), moved = session.expression(output);
        ASSERT_TRUE(expression && moved);
        const auto changed = session.history().findChange(*expression, session.recompile(gain), begin,
                                                          history::History::Direction::Forward);
        const history::Statistics recorded = session.history().statistics();
        ASSERT_TRUE(changed) << "change " << change << " behind " << begin << ": recorded from " << recorded.first
                             << " to " << recorded.end;
        double there = 0, around = 0, last = 0;
        const auto samples =
            session.history().samples(*moved, session.recompile(output), *changed - 1000, *changed + 1000);
        ASSERT_EQ(samples.size(), 2000U);
        for (size_t s = 0; s < samples.size(); last = samples[s++].value)
            if (s > 0)
                (s == 1000 ? there : around) = std::max(s == 1000 ? 0 : around, std::abs(samples[s].value - last));
        EXPECT_GT(around, 0.01) << "nothing moves: nothing is compared";
        EXPECT_LE(there, around * 1.01) << "change " << change;
    }
};

TEST_P(TuningDockMoving, TheOutputGoesOnAtFullSpeed) { writeAndTakeBackWithoutABump(); }

// FB_P has no integral part: its output is its gain times the error
INSTANTIATE_TEST_SUITE_P(All, TuningDockMoving, ::testing::ValuesIn(std::begin(kDockBlocks) + 1, std::end(kDockBlocks)),
                         [](const auto& info) { return std::string(info.param.name); });

/// The same with constants in the call: an online change writes them.
class TuningDockMovingConstants : public TuningDockMoving {
    QByteArray program() const override {
        QByteArray text = TuningDockMoving::program();
        text.replace("i_rKp := Kp, i_rTn := Tn", "i_rKp := 1.5, i_rTn := 900.0");
        text.replace("KP := Kp, TN := Seconds", "KP := 1.5, TN := 0.9");
        return text.replace("KP := Reversed, TR := Seconds", "KP := -1.5, TR := 0.9");
    }
};

TEST_P(TuningDockMovingConstants, TheOutputGoesOnAtFullSpeed) { writeAndTakeBackWithoutABump(); }

INSTANTIATE_TEST_SUITE_P(All, TuningDockMovingConstants,
                         ::testing::Values(kDockBlocks[2], kDockBlocks[4], kDockBlocks[5], kDockBlocks[6]),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace
} // namespace plc::app
