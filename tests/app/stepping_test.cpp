// Halting and stepping as a commissioning engineer does it: into calls of every kind, with the call path and the mark
// of the line in step; breakpoints on any line, in texts that were edited since; resets wherever the controller stands.
#include "app/panels/live_views.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/eventually.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QLabel>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>

namespace plc::app {
namespace {

const char* const kPlant = R"(FUNCTION_BLOCK Axis
VAR_INPUT
    target : INT;
END_VAR
VAR_OUTPUT
    pos : INT;
END_VAR
VAR
    speed : INT := 2;
END_VAR

METHOD Move : INT
VAR_INPUT
    amount : INT;
END_VAR
VAR
    twice : INT;
END_VAR
twice := amount * 2;
Move := twice;
END_METHOD

ACTION Count:
pos := pos + 1;
END_ACTION

pos := pos + Move(amount := speed);
Count();
END_FUNCTION_BLOCK

FUNCTION Half : INT
VAR_INPUT
    whole : INT;
END_VAR
Half := whole / 2;
END_FUNCTION

PROGRAM Main
VAR
    a : Axis;
    b : Axis;
    pulse : TON;
    counter : INT;
    divisor : INT := 1;
END_VAR

counter := counter + 1;
a(target := counter);
b(target := Half(whole := counter));
pulse(IN := NOT pulse.Q, PT := T#100ms);

counter := counter / divisor;
END_PROGRAM
)";

class SteppingTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        const auto end = static_cast<uint32_t>(editor().utf8().size());
        editor().applyEdits({{{FileId(), 0, end}, kPlant}});
        analysed();
        QAction* save = window->action("file.save");
        save->trigger();
    }
    int lineOf(const char* text) {
        const std::string all = editor().utf8();
        const size_t at = all.find(text);
        EXPECT_NE(at, std::string::npos) << text;
        return static_cast<int>(std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(at), '\n')) + 1;
    }
    std::string textOfLine(int line) { return editor().text(line - 1).trimmed().toStdString(); }
    bool isHalted() { return window->control().status().state == controller::State::Halted; }
    /// The line that the arrow in the margin marks now; 0 = none.
    int marked() { return editor().markerFindNext(0, 1u << 7) + 1; }
    QTreeWidget* treeCalled(const QString& name) {
        for (QTreeWidget* each : window->findChild<editor::CallPathView*>()->findChildren<QTreeWidget*>())
            if (each->accessibleName() == name) return each;
        return nullptr;
    }
    QTreeWidget* callPath() { return treeCalled("Call stack"); }
    QTreeWidget* frameValues() { return treeCalled("Values of the frame"); }
    std::string frames() {
        QStringList out;
        for (int i = 0; i < callPath()->topLevelItemCount(); ++i) out << callPath()->topLevelItem(i)->text(0);
        return out.join(" < ").toStdString();
    }
    QString frameValue(const QString& name) {
        for (int i = 0; i < frameValues()->topLevelItemCount(); ++i)
            if (frameValues()->topLevelItem(i)->text(0) == name) return frameValues()->topLevelItem(i)->text(1);
        return "(none)";
    }
    void haltAt(const char* text) {
        window->control().toggleBreakpoint("src/main.st", lineOf(text));
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return isHalted() && marked() > 0; }));
        window->control().setBreakpoints({});
    }
    /// A step with its key; waits for the mark to come to the line with the text.
    void stepTo(Qt::Key key, Qt::KeyboardModifiers modifiers, const char* text) {
        QTest::keyClick(window.get(), key, modifiers);
        EXPECT_TRUE(waitFor([&] { return isHalted() && textOfLine(marked()).find(text) != std::string::npos; }))
            << "expected " << text << ", stands at " << (marked() > 0 ? textOfLine(marked()) : "nothing");
    }
};

TEST_F(SteppingTest, StepsIntoCallsMethodsAndActionsWithTheCallPathInStep) {
    haltAt("a(target := counter)");
    EXPECT_EQ(frames(), "Main");
    stepTo(Qt::Key_F8, Qt::NoModifier, "pos := pos + Move");
    EXPECT_EQ(frames(), "Axis < Main");
    stepTo(Qt::Key_F8, Qt::NoModifier, "twice := amount * 2");
    EXPECT_EQ(frames(), "Axis.Move < Axis < Main");
    EXPECT_EQ(frameValue("amount"), "2");
    EXPECT_EQ(frameValue("twice"), "0");
    stepTo(Qt::Key_F10, Qt::NoModifier, "Move := twice");
    EXPECT_EQ(frameValue("twice"), "4") << "values follow each step";
    stepTo(Qt::Key_F10, Qt::ShiftModifier, "Count()");
    stepTo(Qt::Key_F8, Qt::NoModifier, "pos := pos + 1");
    EXPECT_EQ(frames(), "Axis.Count < Axis < Main");
    stepTo(Qt::Key_F10, Qt::ShiftModifier, "b(target");
    EXPECT_EQ(frames(), "Main");
    stepTo(Qt::Key_F8, Qt::NoModifier, "Half := whole / 2");
    EXPECT_EQ(frames(), "Half < Main");
    stepTo(Qt::Key_F8, Qt::NoModifier, "pos := pos + Move");
    stepTo(Qt::Key_F10, Qt::ShiftModifier, "pulse(IN");
    // Into the library's block: its source opens.
    QTest::keyClick(window.get(), Qt::Key_F8);
    EXPECT_TRUE(waitFor([&] { return frames() == "Standard.TON < Main"; })) << frames();
    EXPECT_TRUE(waitFor([&] { return editor().file() != "src/main.st" && marked() > 0; }));
    QTest::keyClick(window.get(), Qt::Key_F10, Qt::ShiftModifier);
    EXPECT_TRUE(waitFor([&] { return frames() == "Main" && editor().file() == "src/main.st"; })) << frames();
}

TEST_F(SteppingTest, StepsFromAPauseToTheNextStatement) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 3; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    ASSERT_TRUE(waitFor([&] { return window->action("run.stepIn")->isEnabled(); }));
    stepTo(Qt::Key_F8, Qt::NoModifier, "counter := counter + 1");
}

TEST_F(SteppingTest, ABreakpointOnALineWithoutCodeMovesToTheNext) {
    const int empty = lineOf("counter := counter / divisor") - 1;
    window->control().toggleBreakpoint("src/main.st", empty);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return isHalted() && marked() > 0; }));
    ASSERT_EQ(window->control().breakpoints().size(), 1u);
    EXPECT_EQ(window->control().breakpoints()[0].line, empty + 1) << "the mark stands where it halts";
    EXPECT_EQ(marked(), empty + 1);
    window->control().toggleBreakpoint("src/main.st", 1); // while it stands: moved at once
    ASSERT_EQ(window->control().breakpoints().size(), 2u);
    EXPECT_EQ(window->control().breakpoints()[1].line, lineOf("twice := amount * 2"));
}

TEST_F(SteppingTest, BreakpointsStayAtTheirLinesWhenTheTextIsEdited) {
    haltAt("a(target := counter)");
    window->control().toggleBreakpoint("src/main.st", lineOf("pulse(IN"));
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return isHalted() && marked() == lineOf("pulse(IN"); }));
    // Two lines more above, not built: breakpoint and mark move with the text, the halt is at the same statement.
    editor().applyEdits({{{FileId(), 0, 0}, "// first\n// second\n"}});
    EXPECT_EQ(window->control().breakpoints()[0].line, lineOf("pulse(IN"));
    EXPECT_EQ(marked(), lineOf("pulse(IN"));
    const auto haltsAgainAfter = [&](uint64_t halts) {
        return waitFor([&] { return isHalted() && window->control().status().halts > halts; });
    };
    uint64_t halts = window->control().status().halts;
    window->action("run.start")->trigger();
    ASSERT_TRUE(haltsAgainAfter(halts));
    EXPECT_EQ(textOfLine(marked()), "pulse(IN := NOT pulse.Q, PT := T#100ms);");
    // One that is set in the edited text is one of the statement under it.
    window->control().setBreakpoints({});
    window->control().toggleBreakpoint("src/main.st", lineOf("counter := counter + 1"));
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] { return isHalted() && marked() == lineOf("counter := counter + 1"); }))
        << textOfLine(marked());
    // After the online change it is the same statement, too.
    QSignalSpy built(&window->control(), &editor::RunControl::buildFinished);
    window->action("run.change")->trigger();
    ASSERT_TRUE(waitFor([&] { return built.count() == 1; }));
    halts = window->control().status().halts;
    window->action("run.start")->trigger();
    EXPECT_TRUE(haltsAgainAfter(halts));
    EXPECT_TRUE(waitFor([&] { return marked() == lineOf("counter := counter + 1"); })) << textOfLine(marked());
    EXPECT_EQ(window->control().session()->built().input->files[0].text.substr(0, 8), "// first");
}

TEST_F(SteppingTest, RunToCursorStartsTheControllerAndSaysWhenThereIsNoCode) {
    editor().setCursorPosition(lineOf("pulse(IN") - 1, 0);
    QTest::keyClick(window.get(), Qt::Key_F10, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([&] { return isHalted() && marked() == lineOf("pulse(IN"); }));
    QSignalSpy said(&window->control(), &editor::RunControl::messageAdded);
    editor().setCursorPosition(lineOf("END_PROGRAM") - 1, 0);
    QTest::keyClick(window.get(), Qt::Key_F10, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([&] { return said.count() == 1; }));
    EXPECT_TRUE(isHalted()) << "it does not run on without an end";
}

TEST_F(SteppingTest, ResetsWhereverItStands) {
    using controller::ResetKind;
    using controller::State;
    const auto state = [&] { return window->control().status().state; };
    const auto counter = [&] { return window->control().value("Main.counter").text; };
    for (const char* reset : {"run.resetWarm", "run.resetCold", "run.resetOrigin"}) {
        haltAt("a(target := counter)");
        window->action(reset)->trigger();
        EXPECT_TRUE(waitFor([&] { return state() == State::Stopped && counter() == "0"; })) << reset;
        EXPECT_TRUE(waitFor([&] { return marked() == 0; })) << "no line is executed any more";
        EXPECT_EQ(callPath()->topLevelItemCount(), 0);

        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return counter().toInt() > 2; }));
        window->action("run.pause")->trigger();
        ASSERT_TRUE(waitFor([&] { return state() == State::Paused; }));
        window->action(reset)->trigger();
        EXPECT_TRUE(waitFor([&] { return state() == State::Stopped && counter() == "0"; })) << reset;

        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return counter().toInt() > 2; }));
        (void)window->control().write("Main.divisor", "0");
        ASSERT_TRUE(waitFor([&] { return state() == State::Fault; }));
        window->action(reset)->trigger();
        EXPECT_TRUE(waitFor([&] { return state() == State::Stopped && counter() == "0"; })) << reset;
        EXPECT_FALSE(window->control().status().fault) << "the fault is gone from the status line";
    }
}

TEST_F(SteppingTest, RunAfterStopGoesOnWithTheSameControllerUnlessTheTextChanged) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 10; }));
    (void)window->control().force("Main.a.speed", "3");
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.a.speed").isForced; }));
    window->action("run.stop")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Stopped; }));
    const session::Session* before = window->control().session();
    const int counted = window->control().value("Main.counter").text.toInt();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Running; }));
    EXPECT_EQ(window->control().session(), before) << "recording, forces and values stay";
    EXPECT_GE(window->control().value("Main.counter").text.toInt(), counted);
    EXPECT_TRUE(window->control().value("Main.a.speed").isForced);

    window->action("run.stop")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Stopped; }));
    const auto at = static_cast<uint32_t>(editor().utf8().find("counter + 1"));
    editor().applyEdits({{{FileId(), at, at + 11}, "counter + 2"}});
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Running; }));
    EXPECT_NE(window->control().session()->built().input->files[0].text.find("counter + 2"), std::string::npos);
}

TEST_F(SteppingTest, ABreakpointOfOneInstanceWithConditionAndCount) {
    window->control().setBreakpoints({{"src/main.st", lineOf("pos := pos + Move"), "target > 6", 2, "Main.b", true}});
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return isHalted() && marked() > 0; }));
    EXPECT_EQ(callPath()->topLevelItem(0)->text(1), "Main.b");
    EXPECT_EQ(window->control().value("Main.b.target").text, "7") << "half of 14 and 15: the second hit";
    EXPECT_EQ(window->control().value("Main.counter").text, "15");
}

TEST_F(SteppingTest, AConditionThatCanNotBeEvaluatedIsToldWhereItHalts) {
    window->control().setBreakpoints({{"src/main.st", lineOf("counter := counter + 1"), "nonsense > 6", 0, {}, true}});
    QSignalSpy said(&window->control(), &editor::RunControl::messageAdded);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return isHalted() && marked() > 0; }));
    ASSERT_TRUE(waitFor([&] { return said.count() >= 1; }));
    EXPECT_TRUE(said.last()[0].toString().contains("nonsense")) << said.last()[0].toString().toStdString();
}

TEST_F(SteppingTest, TheFaultIsALinkAndItsCallPathHasValues) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 2; }));
    (void)window->control().write("Main.divisor", "0");
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Fault; }));
    editor().applyEdits({{{FileId(), 0, 0}, "// edited since\n"}});
    QToolButton* link = nullptr;
    for (QToolButton* each : window->findChildren<QToolButton*>())
        if (each->toolTip().endsWith("\nGo to the line")) link = each;
    ASSERT_NE(link, nullptr);
    ASSERT_TRUE(waitFor([&] { return link->isVisible(); }));
    QTest::mouseClick(link, Qt::LeftButton);
    int line = 0, column = 0;
    editor().getCursorPosition(&line, &column);
    EXPECT_EQ(textOfLine(line + 1), "counter := counter / divisor;");
    ASSERT_EQ(frames(), "Main");
    EXPECT_EQ(frameValue("divisor"), "0");
}

TEST_F(SteppingTest, CallStackAndWatchShowTheScanOfTheTimeSlider) {
    window->showDock("callPath");
    window->showDock("watch");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 5; }));
    window->control().toggleBreakpoint("src/main.st", lineOf("a(target := counter)"));
    ASSERT_TRUE(waitFor([&] { return isHalted() && marked() > 0; }));
    window->watch().add("Main.counter");
    auto* watched = window->watch().findChild<QTreeWidget*>();
    const auto counter = [&] { return watched->topLevelItem(watched->topLevelItemCount() - 1)->text(1).toInt(); };
    auto* none = window->findChild<QLabel*>("noCallStack");
    ASSERT_TRUE(none);
    ASSERT_TRUE(waitFor([&] { return counter() > 5 && frames() == "Main"; }));
    EXPECT_EQ(frameValue("counter").toInt(), counter());
    EXPECT_FALSE(none->isVisible());
    const int halted = counter();

    // A finished scan is looked at: the stack of the scan that is halted is not that of this one.
    QTest::keyClick(&window->live().slider(), Qt::Key_Left);
    ASSERT_TRUE(waitFor([&] { return window->control().viewed() && counter() < halted; }));
    EXPECT_EQ(frames(), "");
    EXPECT_EQ(frameValue("counter"), "(none)");
    EXPECT_TRUE(waitFor([&] { return none->isVisible(); }));

    QTest::keyClick(&window->live().slider(), Qt::Key_End);
    EXPECT_TRUE(waitFor([&] { return frames() == "Main" && counter() == halted; }));
    EXPECT_EQ(frameValue("counter").toInt(), halted);
    EXPECT_FALSE(none->isVisible());
    window->control().setBreakpoints({});
}

TEST_F(SteppingTest, TheLastScanOfAFaultHasItsCallStackAndTheOnesBeforeHaveNone) {
    window->showDock("callPath");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 5; }));
    (void)window->control().write("Main.divisor", "0");
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Fault; }));
    ASSERT_TRUE(waitFor([&] { return frames() == "Main"; }));
    window->action("time.back")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().viewed().has_value(); }));
    EXPECT_EQ(frames(), "");
    EXPECT_TRUE(window->findChild<QLabel*>("noCallStack")->isVisible());
    window->control().view(window->control().shownHistory()->statistics().end - 1);
    EXPECT_EQ(frames(), "Main") << "the image at the fault is the last record";
    EXPECT_EQ(frameValue("divisor"), "0");
}

TEST_F(SteppingTest, ARecordingFromAFileHasNoCallStackOfTheController) {
    window->showDock("callPath");
    haltAt("a(target := counter)");
    ASSERT_TRUE(waitFor([&] { return frames() == "Main"; }));
    window->control().resume();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 5; }));
    const QString path = folder.path() + "/before.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    window->control().toggleBreakpoint("src/main.st", lineOf("a(target := counter)"));
    ASSERT_TRUE(waitFor([&] { return isHalted() && frames() == "Main"; }));
    ASSERT_TRUE(window->live().openRecording(path));
    EXPECT_EQ(frames(), "");
    EXPECT_TRUE(window->findChild<QLabel*>("noCallStack")->isVisible());
    QTest::mouseClick(window->findChild<QToolButton*>("recordingShown"), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return frames() == "Main"; }));
    window->control().setBreakpoints({});
}

TEST_F(SteppingTest, AFaultTakesTheEditorToItsLineAndTheLogSaysWhere) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 2; }));
    editor().goTo(0);
    (void)window->control().write("Main.divisor", "0");
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Fault; }));
    const int wanted = lineOf("counter := counter / divisor");
    EXPECT_TRUE(waitFor([&] { return editor().markerFindNext(0, 1U << 9) + 1 == wanted; })) << "marked";
    int line = 0, column = 0;
    editor().getCursorPosition(&line, &column);
    EXPECT_EQ(line + 1, wanted) << "one need not look for it";
    EXPECT_TRUE(waitFor([&] { return window->log().shownText().contains(QString("src/main.st:%1").arg(wanted)); }))
        << window->log().shownText().toStdString();
    (void)window->control().write("Main.divisor", "1");
    window->action("run.resetCold")->trigger();
    EXPECT_TRUE(waitFor([&] { return editor().markerFindNext(0, 1U << 9) < 0; })) << "and no more";
}

TEST_F(SteppingTest, TheLogSaysWhereAFaultIsThatTheWindowHasNotSeenYet) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 2; }));
    (void)window->control().write("Main.divisor", "0");
    const session::Session& session = *window->control().session();
    ASSERT_TRUE(eventually([&] { return session.status().fault.has_value(); })); // the window does nothing meanwhile
    ASSERT_FALSE(window->control().status().fault);
    emit window->control().refreshed(); // as where the fault comes while the window looks
    const QString place = QString("src/main.st:%1").arg(lineOf("counter := counter / divisor"));
    EXPECT_TRUE(window->log().shownText().contains(place)) << window->log().shownText().toStdString();
}

TEST_F(SteppingTest, TheLogTellsStepsFromBreakpointsAndStaysAtItsEnd) {
    haltAt("a(target := counter)");
    stepTo(Qt::Key_F10, Qt::NoModifier, "b(target := Half");
    const QString text = window->log().shownText();
    EXPECT_TRUE(text.contains(QString("Breakpoint: Main at src/main.st:%1").arg(lineOf("a(target := counter)"))))
        << text.toStdString();
    EXPECT_TRUE(text.contains("Step: Main at src/main.st:")) << text.toStdString();
    for (int i = 0; i < 200; ++i) window->log().addMessage("line", false); // while it is hidden
    window->showDock("log");
    const auto* tree = window->log().findChild<QTreeWidget*>();
    EXPECT_TRUE(waitFor([&] {
        return tree->verticalScrollBar()->value() == tree->verticalScrollBar()->maximum() &&
               tree->verticalScrollBar()->maximum() > 0;
    }));
}

TEST_F(SteppingTest, SavingAtABreakpointChangesAtTheEndOfTheScan) {
    haltAt("a(target := counter)");
    const auto at = static_cast<uint32_t>(editor().utf8().find("counter + 1"));
    editor().applyEdits({{{FileId(), at, at + 11}, "counter + 3"}});
    analysed();
    QSignalSpy built(&window->control(), &editor::RunControl::buildFinished);
    QSignalSpy changed(&window->control(), &editor::RunControl::onlineChangeFinished);
    window->action("file.save")->trigger();
    ASSERT_TRUE(waitFor([&] { return built.count() == 1; }));
    settle();
    EXPECT_TRUE(isHalted());
    EXPECT_EQ(changed.count(), 0);
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] { return changed.count() == 1; }));
    EXPECT_NE(window->control().session()->built().input->files[0].text.find("counter + 3"), std::string::npos);
}

} // namespace
} // namespace plc::app
