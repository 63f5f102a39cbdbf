// The ladder diagram beside its text, with real keys and clicks: what is drawn, edits as minimal text edits, one undo
// history, power flow while it runs, and the way of a new user to a motor that holds itself.
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QMessageBox>

#include <algorithm>

namespace plc::app {
namespace {

const char* const kLadder = R"(PROGRAM Main
VAR
    start : BOOL := TRUE;
    stop, motor, lamp : BOOL;
    T1 : TON;
END_VAR

// holds itself
motor := (start OR motor) AND NOT stop; // till stop

T1(IN := motor, PT := T#100ms);
lamp := T1.Q;
END_PROGRAM
)";

class LadderTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        open(kLadder);
    }
    void open(const char* text) {
        editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, text}});
        editor().SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
        analysed();
        view = window->tabs().currentPage()->showLadder("Main");
        ASSERT_NE(view, nullptr);
        view->canvas().setFocus();
    }
    std::string words() const { return ladder::describe(view->diagram()); }
    void select(const char* label) {
        for (size_t rung = 0; rung < view->diagram().rungs.size(); ++rung)
            for (const editor::LadderPick& pick : view->scene().picksOf(ladder::RungId(rung)))
                if (view->diagram()[pick.node].label == label) return view->scene().select(pick);
        FAIL() << label;
    }
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&view->canvas(), static_cast<Qt::Key>(key), modifiers);
        ++presses;
    }
    /// Types into the field that is open, and Enter.
    void type(const QString& text) {
        ASSERT_TRUE(view->field().isVisible());
        QTest::keyClicks(&view->field(), text);
        QTest::keyClick(&view->field(), Qt::Key_Return);
        if (view->field().isVisible())
            QTest::keyClick(&view->field(), Qt::Key_Return); // the first one took a completion
        presses += static_cast<int>(text.size()) + 1;
    }
    editor::LadderView* view = nullptr;
    int presses = 0;
};

TEST_F(LadderTest, DrawsTheTextAndFollowsIt) {
    EXPECT_EQ(words(), "# holds itself till stop # (start + motor^) /stop -> ()motor\n"
                       "motor TON:T1[IN=~ PT=T#100ms]>.Q -> ()lamp\n");
    const auto at = static_cast<uint32_t>(editor().utf8().find("stop; // till"));
    editor().applyEdits({{{FileId(), at, at + 4}, "lamp"}});
    EXPECT_NE(words().find("/lamp"), std::string::npos);
    editor().undo();
    EXPECT_EQ(editor().utf8(), kLadder);
    EXPECT_NE(words().find("/stop"), std::string::npos);
}

TEST_F(LadderTest, AContactInsertedByKeyboardIsAMinimalEditAndUndoRestoresEveryByte) {
    select("stop");
    press(Qt::Key_K, Qt::ControlModifier);
    type("/lamp");
    std::string expected = kLadder;
    expected.insert(expected.find("NOT stop"), "NOT lamp AND ");
    EXPECT_EQ(editor().utf8(), expected);
    EXPECT_NE(words().find("/lamp^ /stop"), std::string::npos) << words();
    editor().undo();
    EXPECT_EQ(editor().utf8(), kLadder);
}

TEST_F(LadderTest, NegatesDeletesAndChangesTheCoil) {
    select("stop");
    press(Qt::Key_N, Qt::ControlModifier);
    EXPECT_NE(editor().utf8().find("AND stop; // till stop"), std::string::npos);
    press(Qt::Key_Delete);
    select("start");
    press(Qt::Key_Delete);
    EXPECT_NE(editor().utf8().find("motor := motor"), std::string::npos) << editor().utf8();
    select("lamp");
    press(Qt::Key_M, Qt::ControlModifier);
    EXPECT_NE(editor().utf8().find("lamp S= T1.Q;"), std::string::npos) << editor().utf8();
}

TEST_F(LadderTest, ATextWithErrorsLeavesTheLastGoodDrawing) {
    const std::string before = words();
    const auto at = static_cast<uint32_t>(editor().utf8().find("motor := ("));
    editor().applyEdits({{{FileId(), at, at + 8}, "motor := := "}});
    EXPECT_TRUE(view->isReadOnly());
    EXPECT_EQ(words(), before);
    press(Qt::Key_Delete);
    EXPECT_NE(editor().utf8().find("motor := := "), std::string::npos) << "nothing is deleted in an old drawing";
    editor().undo();
    EXPECT_FALSE(view->isReadOnly());
}

TEST_F(LadderTest, ShowsPowerWhileItRuns) {
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] {
        const editor::LadderOnline& online = view->scene().online();
        if (!online.isOn) return false;
        const auto& rungs = view->diagram().rungs;
        return std::all_of(rungs.begin(), rungs.end(), [&](const ladder::Rung& rung) {
            return online.power[rung.branches[0].output.index()] == ladder::Power::On;
        });
    }));
    select("stop");
    view->forceSelected("TRUE");
    EXPECT_TRUE(waitFor([&] {
        const auto& rung = view->diagram().rungs[0];
        return view->scene().online().power[rung.branches[0].output.index()] == ladder::Power::Off;
    }));
}

TEST_F(LadderTest, SelectingInTheDrawingMovesTheCursorAndTheCursorTheSelection) {
    select("stop");
    EXPECT_EQ(editor().cursorOffset(), editor().utf8().find("NOT stop"));
    view->showCursor(static_cast<uint32_t>(editor().utf8().find("lamp := T1.Q")));
    ASSERT_TRUE(view->scene().picked().node.isValid());
    EXPECT_EQ(view->diagram()[view->scene().picked().node].label, "lamp");
}

TEST_F(LadderTest, ABreakpointOfTheTextIsOnTheRung) {
    select("lamp");
    press(Qt::Key_F9);
    EXPECT_TRUE(waitFor([&] { return !window->control().breakpoints().empty(); }));
    EXPECT_EQ(window->control().breakpoints().front().line, 11);
}

TEST_F(LadderTest, F1ListsTheKeys) {
    press(Qt::Key_F1);
    auto* box = view->findChild<QMessageBox*>("ladderKeys");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains("Ctrl+K"));
    box->close();
}

TEST_F(LadderTest, ANewUserDrawsAMotorThatHoldsItselfInUnderFortyKeys) {
    open("PROGRAM Main\nVAR\nEND_VAR\n\nEND_PROGRAM\n");
    press(Qt::Key_T, Qt::ControlModifier);
    type("motor");
    press(Qt::Key_K, Qt::ControlModifier);
    type("start");
    press(Qt::Key_R, Qt::ControlModifier);
    type("motor");
    press(Qt::Key_Escape);
    press(Qt::Key_K, Qt::ControlModifier);
    type("/stop");
    EXPECT_EQ(editor().utf8(), "PROGRAM Main\nVAR\n    motor : BOOL;\n    start : BOOL;\n    stop : BOOL;\nEND_VAR\n"
                               "motor := (start OR motor) AND NOT stop;\n\nEND_PROGRAM\n");
    EXPECT_EQ(words(), "(start + motor^) /stop -> ()motor\n");
    analysed();
    window->action("run.start")->trigger();
    ++presses;
    EXPECT_LT(presses, 40);
    ASSERT_TRUE(waitFor([&] { return view->scene().online().isOn; }));
    const auto coil = [&] { return view->scene().online().power[view->diagram().rungs[0].branches[0].output.index()]; };
    EXPECT_EQ(coil(), ladder::Power::Off);
    ASSERT_TRUE(window->control().force("Main.start", "TRUE"));
    EXPECT_TRUE(waitFor([&] { return coil() == ladder::Power::On; }));
    window->control().unforce("Main.start");
    EXPECT_EQ(coil(), ladder::Power::On);
}

TEST_F(LadderTest, TheActionShowsAndHidesTheDiagramThatTheUnitPrefers) {
    open("{attribute 'view' := 'fbd'}\nPROGRAM Main\nVAR a, b : BOOL; END_VAR\na := b AND a;\nEND_PROGRAM\n");
    EXPECT_EQ(view->form(), ladder::Form::Blocks);
    window->action("view.chart")->trigger();
    EXPECT_FALSE(view->isVisible());
    window->action("view.chart")->trigger();
    EXPECT_TRUE(view->isVisible());
}

} // namespace
} // namespace plc::app
