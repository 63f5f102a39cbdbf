// The ladder diagram beside its text, with real keys and clicks: what is drawn, edits as minimal text edits, one undo
// history, power flow while it runs, and the way of a new user to a motor that holds itself.
#include "app/project/new_project.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAction>
#include <QDropEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>

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
    /// One rung that holds itself.
    void drawMotor() {
        press(Qt::Key_T, Qt::ControlModifier);
        type("motor");
        press(Qt::Key_K, Qt::ControlModifier);
        type("start");
        press(Qt::Key_R, Qt::ControlModifier);
        type("motor");
        press(Qt::Key_Escape);
        press(Qt::Key_K, Qt::ControlModifier);
        type("/stop");
    }
    /// The part with this label, or its place on the screen.
    [[nodiscard]] editor::LadderPick pickOf(const char* label) const {
        for (size_t rung = 0; rung < view->diagram().rungs.size(); ++rung)
            for (const editor::LadderPick& pick : view->scene().picksOf(ladder::RungId(rung)))
                if (view->diagram()[pick.node].label == label) return pick;
        ADD_FAILURE() << label;
        return {};
    }
    [[nodiscard]] QPoint on(QPointF scenePoint) const { return view->canvas().mapFromScene(scenePoint); }
    /// Only rungs that are seen are looked into.
    void seeAll() {
        QApplication::processEvents();
        view->canvas().zoomToFit();
    }
    /// On the wire right of a contact.
    [[nodiscard]] QPoint behind(const char* label) const {
        const QRectF rect = view->scene().rectOf(pickOf(label));
        return on({rect.right() + view->scene().cellWidth() * 0.7, rect.bottom() - view->scene().cellHeight() / 2});
    }
    [[nodiscard]] QPoint middleOf(const char* label) const { return on(view->scene().rectOf(pickOf(label)).center()); }
    void drag(QPoint from, QPoint to) {
        QWidget* port = view->canvas().viewport();
        QTest::mousePress(port, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 4; ++i) {
            QMouseEvent move(QEvent::MouseMove, from + (to - from) * i / 4,
                             port->mapToGlobal(from + (to - from) * i / 4), Qt::NoButton, Qt::LeftButton,
                             Qt::NoModifier);
            QApplication::sendEvent(port, &move);
        }
        QTest::mouseRelease(port, Qt::LeftButton, {}, to);
    }
    void drop(const char* text, QPoint at) {
        QMimeData mime;
        mime.setText(text);
        QDragEnterEvent enter(at, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(view->canvas().viewport(), &enter);
        QDropEvent event(QPointF(at), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(view->canvas().viewport(), &event);
    }
    [[nodiscard]] ladder::Power powerBehind(const char* label) const {
        const auto& power = view->scene().online().power;
        const size_t at = pickOf(label).node.index();
        return at < power.size() ? power[at] : ladder::Power::Unknown;
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
    EXPECT_EQ(editor().cursorOffset(), editor().utf8().find("stop; // till")) << "on the name, for rename and uses";
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
    drawMotor();
    EXPECT_EQ(editor().utf8(), "PROGRAM Main\nVAR\n    motor : BOOL;\n    start : BOOL;\n    stop : BOOL;\nEND_VAR\n"
                               "motor := (start OR motor) AND NOT stop;\n\nEND_PROGRAM\n");
    EXPECT_EQ(words(), "(start + motor^) /stop -> ()motor\n");
    analysed();
    window->action("run.start")->trigger();
    ++presses;
    EXPECT_LT(presses, 40);
    ASSERT_TRUE(waitFor([&] { return view->scene().online().isOn; }));
    const auto coil = [&] { return view->scene().online().power[view->diagram().rungs[0].branches[0].output.index()]; };
    seeAll(); // the docks of a run have taken their room
    EXPECT_TRUE(waitFor([&] { return coil() == ladder::Power::Off; }));
    ASSERT_TRUE(window->control().force("Main.start", "TRUE"));
    EXPECT_TRUE(waitFor([&] { return coil() == ladder::Power::On; }));
    window->control().unforce("Main.start");
    EXPECT_EQ(coil(), ladder::Power::On) << "it holds itself";
}

/// From the template "Empty", whose program runs in a task of a CONFIGURATION in the same file.
TEST_F(LadderTest, ANewRungInAProgramWithAConfigurationShowsItsFlow) {
    const QString made = folder.filePath("new");
    ASSERT_TRUE(createProject(made.toStdString(), "New", "empty"));
    QFile file(made + "/src/main.st");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const std::string text = file.readAll().toStdString();
    ASSERT_NE(text.find("CONFIGURATION"), std::string::npos);
    open(text.c_str());
    window->action("file.save")->trigger();
    drawMotor();
    EXPECT_NE(words().find("(start + motor^) /stop -> ()motor\n"), std::string::npos) << words();
    window->action("run.start")->trigger(); // the docks of a run take room: what is worked on stays in sight
    ASSERT_TRUE(waitFor([&] { return view->scene().online().isOn; }));
    EXPECT_TRUE(waitFor([&] { return powerBehind("stop") == ladder::Power::Off; })) << int(powerBehind("stop"));
    ASSERT_TRUE(window->control().force("Main.start", "TRUE"));
    EXPECT_TRUE(waitFor([&] { return powerBehind("stop") == ladder::Power::On; })) << int(powerBehind("stop"));
    EXPECT_TRUE(waitFor([&] { return view->scene().online().isExact; }));
}

// ------------------------------------------------------------------ what the program computed there

const char* const kRewritten = R"(PROGRAM Main
VAR
    early, late, y, z, never : BOOL;
    n : INT;
END_VAR
n := n + 1;
early := TRUE;
y := early AND n > 0;

early := FALSE;
z := early OR late;

IF n < 0 THEN
    never := y;
    CASE n OF 1: z := y; END_CASE
END_IF
END_PROGRAM
)";

/// `early` is FALSE at the end of each scan, and was TRUE where it was read first.
TEST_F(LadderTest, LiveFlowIsWhatWasReadThereAndNotTheValueAtTheEnd) {
    open(kRewritten);
    seeAll();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return view->scene().online().isOn && view->scene().online().isExact; }));
    EXPECT_EQ(powerBehind("early"), ladder::Power::On);
    EXPECT_EQ(powerBehind("y"), ladder::Power::On);
    EXPECT_EQ(powerBehind("z"), ladder::Power::Off);
    const auto& leftOut = view->scene().online().leftOut;
    EXPECT_TRUE(std::find(leftOut.begin(), leftOut.end(), true) != leftOut.end()) << "the IF is not entered";
}

TEST_F(LadderTest, FlowInThePastIsOfTheScanAtTheTimeSlider) {
    open("PROGRAM Main\nVAR\n    n : INT;\n    even, y : BOOL;\nEND_VAR\nn := n + 1;\neven := n MOD 2 = 0;\ny := "
         "even;\neven := "
         "TRUE;\nEND_PROGRAM\n");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 20; }));
    window->control().pause();
    for (const history::Position at : {history::Position(7), history::Position(8), history::Position(7)}) {
        window->control().view(at);
        const ladder::Power expected = (at + 1) % 2 == 0 ? ladder::Power::On : ladder::Power::Off;
        EXPECT_TRUE(waitFor([&] { return view->scene().online().isExact && powerBehind("y") == expected; })) << at;
    }
}

TEST_F(LadderTest, HaltedItShowsHowFarTheScanCameAndTheRungWhereItStands) {
    open(kRewritten);
    window->control().toggleBreakpoint("src/main.st", 11);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Halted; }));
    ASSERT_TRUE(waitFor([&] { return view->scene().online().isExact; }));
    EXPECT_EQ(powerBehind("y"), ladder::Power::On);
    EXPECT_EQ(powerBehind("z"), ladder::Power::Unknown) << "not executed yet";
    ASSERT_TRUE(waitFor([&] { return view->scene().standing().isValid(); }));
    const auto& rung = view->diagram()[view->scene().standing()];
    EXPECT_EQ(rung.range.begin, editor().utf8().find("z := early"));
    window->control().step(session::Step::Over);
    EXPECT_TRUE(waitFor([&] {
        const ladder::RungId at = view->scene().standing();
        return at.isValid() && view->diagram()[at].range.begin == editor().utf8().find("IF n < 0");
    }));
    EXPECT_TRUE(waitFor([&] { return powerBehind("z") == ladder::Power::Off; }));
}

TEST_F(LadderTest, AnEditedLineShowsTheLastValuesAndTheOthersStayExact) {
    open(kRewritten);
    seeAll();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return view->scene().online().isExact; }));
    const auto at = static_cast<uint32_t>(editor().utf8().find("early OR late"));
    editor().applyEdits({{{FileId(), at, at}, "late OR "}});
    EXPECT_TRUE(waitFor([&] { return view->scene().online().isExact && powerBehind("y") == ladder::Power::On; }));
    EXPECT_EQ(powerBehind("z"), ladder::Power::Off);
}

TEST_F(LadderTest, ATimerShowsItsProgress) {
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] {
        const auto& progress = view->scene().online().progress;
        return std::any_of(progress.begin(), progress.end(), [](double each) { return each > 0; });
    }));
}

// ------------------------------------------------------------------ mouse

TEST_F(LadderTest, AClickOnAWireInsertsAContactThere) {
    QTest::mouseClick(view->canvas().viewport(), Qt::LeftButton, {}, behind("stop"));
    type("lamp");
    EXPECT_NE(editor().utf8().find("(start OR motor) AND NOT stop AND lamp;"), std::string::npos) << editor().utf8();
    // in front of the branch, before both
    const QRectF first = view->scene().rectOf(pickOf("start"));
    QTest::mouseClick(view->canvas().viewport(), Qt::LeftButton, {},
                      on({first.left() - view->scene().cellWidth(), first.bottom() - view->scene().cellHeight() / 2}));
    type("/lamp");
    EXPECT_NE(editor().utf8().find("NOT lamp AND (start OR motor)"), std::string::npos) << editor().utf8();
}

TEST_F(LadderTest, EscapeLeavesTheWireAsItWas) {
    QTest::mouseClick(view->canvas().viewport(), Qt::LeftButton, {}, behind("stop"));
    ASSERT_TRUE(view->field().isVisible());
    QTest::keyClick(&view->field(), Qt::Key_Escape);
    EXPECT_FALSE(view->field().isVisible());
    EXPECT_EQ(editor().utf8(), kLadder);
}

TEST_F(LadderTest, AContactIsDraggedWithinItsRungAndToAnother) {
    drag(middleOf("stop"), middleOf("start") - QPoint(12, 0));
    EXPECT_NE(editor().utf8().find("motor := (NOT stop AND start OR motor); // till stop"), std::string::npos)
        << editor().utf8();
    editor().undo();
    EXPECT_EQ(editor().utf8(), kLadder);
    drag(middleOf("stop"), middleOf("motor") + QPoint(12, 0));
    EXPECT_NE(editor().utf8().find("motor := (start OR motor AND NOT stop); // till stop"), std::string::npos)
        << editor().utf8();
    editor().undo();
    open(
        "PROGRAM Main\nVAR\n    a, b, c, y, z : BOOL;\nEND_VAR\ny := a AND b; // one\n\nz := c; // two\nEND_PROGRAM\n");
    drag(middleOf("b"), middleOf("c") + QPoint(12, 0));
    EXPECT_NE(editor().utf8().find("y := a; // one\n\nz := c AND b; // two\n"), std::string::npos) << editor().utf8();
}

TEST_F(LadderTest, AVariableIsDroppedOnAWireAndABlockOfTheLibraryIntoTheRung) {
    drop("lamp", behind("stop"));
    EXPECT_NE(editor().utf8().find("AND NOT stop AND lamp;"), std::string::npos) << editor().utf8();
    editor().undo();
    drop("TON", behind("stop"));
    EXPECT_NE(editor().utf8().find("ton1 : TON;"), std::string::npos) << editor().utf8();
    EXPECT_NE(editor().utf8().find("ton1(IN := (start OR motor) AND NOT stop"), std::string::npos) << editor().utf8();
    editor().undo();
    EXPECT_EQ(editor().utf8(), kLadder);
}

// ------------------------------------------------------------------ names, fixes, marks

TEST_F(LadderTest, ANewNameIsDeclaredInPlaceWithItsType) {
    select("stop");
    press(Qt::Key_D, Qt::ControlModifier);
    type("ready : BOOL");
    EXPECT_NE(editor().utf8().find("    ready : BOOL;\n"), std::string::npos) << editor().utf8();
    select("T#100ms");
    press(Qt::Key_F2);
    QTest::keyClicks(&view->field(), "delay");
    QTest::keyClick(&view->field(), Qt::Key_Return);
    EXPECT_NE(editor().utf8().find("    delay : TIME;\n"), std::string::npos) << editor().utf8();
    EXPECT_NE(editor().utf8().find("PT := delay"), std::string::npos) << editor().utf8();
}

TEST_F(LadderTest, AFieldCompletesNamesAndBlocksOfTheLibraries) {
    select("stop");
    press(Qt::Key_K, Qt::ControlModifier);
    QTest::keyClicks(&view->field(), "lam");
    EXPECT_TRUE(waitFor([&] { return view->field().isCompletionShown(); }));
    QTest::keyClick(&view->field(), Qt::Key_Escape);
    QTest::keyClick(&view->field(), Qt::Key_Escape);
    press(Qt::Key_B, Qt::ControlModifier);
    QTest::keyClicks(&view->field(), "C1 : CTU_");
    EXPECT_TRUE(waitFor([&] { return view->field().isCompletionShown(); })) << "CTU_UDINT of the standard library";
    QTest::keyClick(&view->field(), Qt::Key_Escape);
    QTest::keyClick(&view->field(), Qt::Key_Escape);
}

TEST_F(LadderTest, AProblemIsOnItsElementAndAltEnterAppliesAFix) {
    open("PROGRAM Main\nVAR\n    start, motor : BOOL;\nEND_VAR\nmotor := start AND stopp;\nEND_PROGRAM\n");
    ASSERT_TRUE(waitFor([&] { return view->scene().problemCount() > 0; }));
    EXPECT_FALSE(view->scene().problemAt(pickOf("stopp")).isEmpty());
    select("stopp");
    inNextMenu(window.get(), // several fixes are a menu: the first one
               [](QMenu& menu) { QTest::keyClick(&menu, Qt::Key_Return); });
    press(Qt::Key_Return, Qt::AltModifier);
    EXPECT_TRUE(waitFor([&] { return editor().utf8().find("stopp : BOOL") != std::string::npos; })) << editor().utf8();
}

TEST_F(LadderTest, FindInTheTextSelectsInTheDrawing) {
    view->scene().select({});
    window->action("edit.find")->trigger();
    QWidget* line = QApplication::focusWidget();
    ASSERT_NE(line, nullptr);
    QTest::keyClicks(line, "NOT sto");
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] {
        const editor::LadderPick pick = view->scene().picked();
        return pick.node.isValid() && view->diagram()[pick.node].label == "stop";
    }));
}

TEST_F(LadderTest, UsesAndDefinitionComeFromTheElement) {
    select("stop");
    press(Qt::Key_F12);
    const size_t declared = editor().utf8().find("stop, motor");
    EXPECT_TRUE(waitFor([&] { return editor().cursorOffset() - declared <= 4; })) << "at or behind the name";
    view->canvas().setFocus();
    select("stop");
    uint32_t asked = 0;
    QObject::connect(view, &editor::GraphView::usesRequested, view, [&](uint32_t offset) { asked = offset; });
    press(Qt::Key_F12, Qt::ShiftModifier);
    EXPECT_EQ(asked, editor().utf8().find("stop; // till"));
    QObject::connect(view, &editor::GraphView::renameRequested, view, [&](uint32_t offset) { asked = offset + 1000; });
    inNext<QDialog>(window.get(), [](QDialog& dialog) { dialog.close(); }); // it asks for the new name
    select("start");
    press(Qt::Key_F2, Qt::ShiftModifier);
    EXPECT_EQ(asked, editor().utf8().find("start OR") + 1000);
}

TEST_F(LadderTest, ABookmarkIsOnTheRungAndMovesWithIt) {
    select("lamp");
    press(Qt::Key_F2, Qt::ControlModifier);
    ASSERT_EQ(view->scene().bookmarks().size(), 2u);
    EXPECT_TRUE(view->scene().bookmarks()[1]);
    EXPECT_FALSE(view->scene().bookmarks()[0]);
    editor().applyEdits({{{FileId(), 0, 0}, "// above\n"}});
    EXPECT_TRUE(waitFor([&] { return view->scene().bookmarks() == std::vector<bool>({false, true}); }));
    view->scene().select(pickOf("stop"));
    window->action("edit.nextBookmark")->trigger();
    EXPECT_EQ(view->scene().picked().rung, ladder::RungId(1));
    view->canvas().setFocus();
    press(Qt::Key_F2, Qt::ControlModifier);
    EXPECT_EQ(view->scene().bookmarks(), std::vector<bool>({false, false}));
}

TEST_F(LadderTest, TheDrawingIsExported) {
    for (const char* ending : {"svg", "png", "pdf"}) {
        const QString path = folder.path() + "/drawing." + ending;
        const bool good = path.endsWith("svg")   ? view->canvas().exportSvg(path)
                          : path.endsWith("png") ? view->canvas().exportPng(path)
                                                 : view->canvas().exportPdf(path);
        EXPECT_TRUE(good) << ending;
        EXPECT_GT(QFileInfo(path).size(), 1000) << ending;
    }
}

TEST_F(LadderTest, WhatIsShownIsChosenAndKept) {
    open("PROGRAM Main\nVAR\n    start AT %IX0.0 : BOOL; // the green button\n    y : BOOL;\nEND_VAR\ny := "
         "start;\nEND_PROGRAM\n");
    auto* menu = view->findChild<QMenu*>("ladderLook");
    ASSERT_NE(menu, nullptr);
    const QRectF before = view->scene().rectOf(pickOf("start"));
    const auto choose = [&](const QString& part) {
        emit menu->aboutToShow();
        for (QAction* action : menu->actions())
            if (action->text().remove(u'&').contains(part)) return action->trigger();
        ADD_FAILURE() << qPrintable(part);
    };
    choose("Names and Addresses");
    choose("Comments of the Variables");
    choose("Circuit");
    choose("High Contrast");
    EXPECT_GT(view->scene().rectOf(pickOf("start")).height(), before.height() * 1.8);
    EXPECT_EQ(view->scene().colors().muted, view->scene().colors().text);
    const editor::LadderLook look = editor::LadderLook::fromBits(Settings().ladderLook());
    EXPECT_EQ(look, view->look());
    EXPECT_EQ(look.symbols, ladder::Symbols::Circuit);
    EXPECT_EQ(look.layout.naming, ladder::Naming::Both);
    Settings().setLadderLook(0);
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
