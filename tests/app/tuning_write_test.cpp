// Writing the proposed parameters from the tuning dock, and taking them back: variables in one scan, constants of the
// call in the text with an online change.
#include "projects/loops/loops.h"
#include "tests/app/tuning_dock.h"

namespace plc::app {
namespace {

/// Parameters that are constants of the call.
class TuningDockWithConstants : public TuningDock {
    QByteArray program() const override {
        QByteArray text = kTunedLoop;
        text.replace("i_rTn := Tn", "i_rTn := 900.0");
        return text;
    }

protected:
    std::string source() { return window->workspace().text("src/main.st"); }
};

TEST_F(TuningDockWithConstants, AreWrittenInTheTextWithAnOnlineChangeAndTakenBack) {
    findSteps();
    EXPECT_TRUE(part<QLabel>("tuningConstants")->isVisibleTo(view));
    EXPECT_TRUE(part<QLabel>("tuningConstants")->text().contains("i_rTn"));
    ASSERT_TRUE(waitForTrial()) << chart("tuningTrial").title;
    const std::string before = source();
    ASSERT_NE(before.find("i_rTn := 900.0"), std::string::npos);
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    const uint64_t scans = control().status().scans;
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value("Main.pid.i_rTn") != 900 && value("Main.Kp") != 1.5; }));
    EXPECT_EQ(source().find("i_rTn := 900.0"), std::string::npos);
    EXPECT_GT(control().status().scans, scans); // it went on
    EXPECT_EQ(control().status().state, controller::State::Running);
    ASSERT_TRUE(waitFor([&] { return control().isUpToDate() && part<QPushButton>("tuningBack")->isEnabled(); }));
    click("tuningBack");
    ASSERT_TRUE(waitFor([&] { return value("Main.pid.i_rTn") == 900 && value("Main.Kp") == 1.5; }));
    EXPECT_EQ(source(), before);
}

/// Gain and integral time are constants: an online change writes them.
class TuningDockWithGainConstant : public TuningDock {
    QByteArray program() const override {
        QByteArray text = kTunedLoop;
        text.replace("i_rKp := Kp, i_rTn := Tn", "i_rKp := 1.5, i_rTn := 900.0");
        return text.replace("MOD 2) * 10.0;", "MOD 2) * 10.0 + 10.0;"); // at rest the output is 5 or 10, never 0
    }

protected:
    /// By how much the controller's output moves in the scan in which a pin changes.
    double bumpAt(const char* pin, history::Position& from) {
        const session::Session& session = *control().session();
        const auto at = [&](const char* path, history::Position position) {
            return loops::numberAt(*session.program(), session.history().seek(position), path).value_or(1e9);
        };
        const auto expression = session.expression(pin);
        EXPECT_TRUE(expression);
        const auto changed = session.history().findChange(*expression, session.recompile(pin), from,
                                                          history::History::Direction::Forward);
        EXPECT_TRUE(changed) << pin;
        if (!changed) return 1e9;
        from = *changed;
        return std::abs(at("Main.pid.q_rPidOput", *changed) - at("Main.pid.q_rPidOput", *changed - 1));
    }
};

TEST_F(TuningDockWithGainConstant, TheOutputGoesOnWhereItIs) {
    findSteps();
    const double gain = value("Main.pid.i_rKp");
    control().setMode({session::Pace::Real, 1.0}); // as a plant runs: what is seen on the screen is hardly older
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value("Main.pid.i_rKp") != gain; }));
    waitForScan();
    pause();
    history::Position from = control().session()->history().statistics().first;
    const double bump = bumpAt("Main.pid.i_rKp", from);
    history::Position same = control().session()->history().statistics().first;
    bumpAt("Main.pid.i_rTn", same);
    EXPECT_EQ(from, same); // both in one scan
    EXPECT_GT(std::abs(value("Main.pid.i_rKp") / gain - 1),
              0.2); // with the integral part as it was, it would jump by 1
    EXPECT_LT(bump, 0.3);
}

TEST_F(TuningDockWithConstants, OneUndoTakesTheTextBack) {
    findSteps();
    const std::string before = source();
    click("tuningWrite");
    ASSERT_NE(source(), before);
    window->tabs().undo();
    EXPECT_EQ(source(), before);
}

TEST_F(TuningDock, WritesAllParametersInOneScanAndTakesThemBack) {
    findSteps();
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    EXPECT_EQ(now("Gain"), "1.5");
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value("Main.Kp") != 1.5 && value("Main.Tn") != 900; }));
    EXPECT_EQ(now("Gain"), proposed("Gain")); // in force by now
    EXPECT_EQ(now("Sensitivity Ms"), proposed("Sensitivity Ms"));
    click("tuningBack");
    EXPECT_EQ(now("Gain"), "1.5");
    ASSERT_TRUE(waitFor([&] { return value("Main.Kp") == 1.5 && value("Main.Tn") == 900; }));
    waitForScan();
    pause();
    const session::Session& session = *control().session();
    const auto change = [&](const char* path, history::Position from) {
        const auto expression = session.expression(path);
        EXPECT_TRUE(expression);
        return session.history().findChange(*expression, session.recompile(path), from,
                                            history::History::Direction::Forward);
    };
    const auto first = session.history().statistics().first;
    const auto written = change("Main.Kp", first);
    ASSERT_TRUE(written);
    EXPECT_EQ(written, change("Main.Tn", first));
    const auto back = change("Main.Kp", *written);
    ASSERT_TRUE(back);
    EXPECT_EQ(back, change("Main.Tn", *written));
    EXPECT_FALSE(part<QPushButton>("tuningBack")->isEnabled());
}

} // namespace
} // namespace plc::app
