// The graph under real keys and mouse: drags, edits in place with their complaints, random edits that all undo, nested
// charts, marks, breakpoints that stop when a step becomes active and when a transition is taken, the past.
#include "tests/app/studio_fixture.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QGraphicsItem>
#include <QImage>
#include <QTemporaryFile>

namespace plc::app {
namespace {

const char* const kChoice = R"(PROGRAM Main
VAR
    go, full, lamp, horn : BOOL;
END_VAR
INITIAL_STEP Ready: END_STEP
// to the left
TRANSITION FROM Ready TO Left := go AND full; END_TRANSITION
// to the right
TRANSITION FROM Ready TO Right := go AND NOT full; END_TRANSITION
STEP Left:
    lamp(N);
    horn(D, T#2s);
END_STEP
STEP Right: lamp(S); END_STEP
TRANSITION FROM Left TO Ready := NOT go; END_TRANSITION
TRANSITION FROM Right TO Ready := NOT go; END_TRANSITION
END_PROGRAM
)";

const char* const kRunning = R"(PROGRAM Main
VAR
    go : BOOL := TRUE;
    lamp, inner : BOOL;
    runs : INT;
END_VAR
INITIAL_STEP Ready:
END_STEP
TRANSITION FROM Ready TO Work := Ready.T > T#300ms; END_TRANSITION
STEP Work:
    lamp(N);
    count(D, T#400ms);
    Deep(N);
END_STEP
TRANSITION FROM Work TO Ready := Work.T > T#900ms; END_TRANSITION
ACTION count: runs := runs + 1; END_ACTION
ACTION Deep:
    INITIAL_STEP One: inner(N); END_STEP
    TRANSITION FROM One TO Two := One.T > T#100ms; END_TRANSITION
    STEP Two: END_STEP
    TRANSITION FROM Two TO One := Two.T > T#100ms; END_TRANSITION
END_ACTION
END_PROGRAM
)";

class ChartEventsTest : public StudioTest {
protected:
    void open(const char* text, const QString& unit = "Main") {
        begin = text;
        editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, text}});
        editor().SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
        analysed();
        view = window->tabs().currentPage()->showChart(unit);
        ASSERT_NE(view, nullptr);
        settle();
    }
    QGraphicsItem* select(editor::ChartScene::ItemKind kind, int index, int sub = -1) {
        view->scene().clearSelection();
        QGraphicsItem* item = view->scene().itemOf(kind, index, sub);
        if (item) item->setSelected(true);
        return item;
    }
    QPoint onScreen(QPointF scene) { return view->canvas().mapFromScene(scene); }
    void drag(QPointF from, QPointF to) {
        QWidget* ground = view->canvas().viewport();
        QTest::mousePress(ground, Qt::LeftButton, {}, onScreen(from));
        for (int i = 1; i <= 4; ++i) {
            QMouseEvent move(QEvent::MouseMove, onScreen(from + (to - from) * i / 4),
                             ground->mapToGlobal(onScreen(from + (to - from) * i / 4)), Qt::NoButton, Qt::LeftButton,
                             Qt::NoModifier);
            QApplication::sendEvent(ground, &move);
        }
        QTest::mouseRelease(ground, Qt::LeftButton, {}, onScreen(to));
    }
    int step(const char* name) {
        const auto id = view->scene().chart()->find(name);
        return id.isValid() ? static_cast<int>(id.value) : -1;
    }
    std::string text() { return editor().utf8(); }
    void undoAll() {
        while (editor().isUndoAvailable()) editor().undo();
    }
    std::string begin;
    editor::ChartView* view = nullptr;
};

TEST_F(ChartEventsTest, ABranchDraggedToTheOtherSideReordersTheTransitionsAndOneUndoBringsItBack) {
    open(kChoice);
    const QRectF left = view->scene().barRect(0), right = view->scene().barRect(1);
    ASSERT_LT(left.center().x(), right.center().x());
    drag(left.center() + QPointF(4, 0), right.center() + QPointF(20, 0));
    EXPECT_LT(text().find("TO Right :="), text().find("TO Left :="));
    EXPECT_LT(text().find("// to the right"), text().find("// to the left")) << "comments move with their transition";
    EXPECT_LT(view->scene().stepRect(step("Right")).center().x(), view->scene().stepRect(step("Left")).center().x());
    editor().undo();
    EXPECT_EQ(text(), begin);
}

TEST_F(ChartEventsTest, AStepDraggedOntoATransitionGoesBehindIt) {
    open("PROGRAM Main\nINITIAL_STEP A: END_STEP\nTRANSITION FROM A TO B := TRUE; END_TRANSITION\nSTEP B: "
         "END_STEP\nTRANSITION FROM B TO C := B.T > T#1s; END_TRANSITION\nSTEP C: END_STEP\nTRANSITION FROM C TO A := "
         "C.T > T#1s; END_TRANSITION\nEND_PROGRAM\n");
    drag(view->scene().stepRect(step("B")).center(), view->scene().barRect(2).center());
    EXPECT_NE(text().find("FROM A TO C"), std::string::npos) << text();
    EXPECT_NE(text().find("FROM C TO B"), std::string::npos);
    EXPECT_NE(text().find("FROM B TO A"), std::string::npos);
    editor().undo();
    EXPECT_EQ(text(), begin);
    // where it cannot go, nothing happens
    drag(view->scene().stepRect(step("A")).center(), view->scene().barRect(1).center());
    EXPECT_EQ(text(), begin);
}

TEST_F(ChartEventsTest, AnActionIsDraggedToAnotherPlaceAndToAnotherStep) {
    open(kChoice);
    const int left = step("Left");
    drag(view->scene().actionRect(left, 0).center(), view->scene().actionRect(left, 1).center());
    EXPECT_LT(text().find("horn(D"), text().find("lamp(N)"));
    drag(view->scene().actionRect(left, 0).center(), view->scene().stepRect(step("Ready")).center());
    EXPECT_NE(text().find("horn(D, T#2s)"), std::string::npos);
    EXPECT_LT(text().find("horn(D, T#2s)"), text().find("// to the left"));
    editor().undo();
    editor().undo();
    EXPECT_EQ(text(), begin);
}

TEST_F(ChartEventsTest, ATransitionDraggedOntoAStepLeadsThere) {
    open(kChoice);
    drag(view->scene().barRect(2).center(), view->scene().stepRect(step("Right")).center());
    EXPECT_NE(text().find("FROM Left TO Right"), std::string::npos) << text();
    editor().undo();
    EXPECT_EQ(text(), begin);
}

TEST_F(ChartEventsTest, TheFieldCompletesAndComplainsWhileItIsTyped) {
    open(kChoice);
    select(editor::ChartScene::Transition, 2);
    QTest::keyClick(&view->canvas(), Qt::Key_F2);
    auto& field = view->field();
    ASSERT_TRUE(field.isVisible());
    EXPECT_EQ(field.text(), "NOT go");
    field.clear();
    QTest::keyClicks(&field, "fu");
    field.complete();
    EXPECT_TRUE(field.shownCompletions().contains("full")) << field.shownCompletions().join(",").toStdString();
    QTest::keyClick(&field, Qt::Key_Escape);
    field.setText("full AND");
    EXPECT_NE(field.complaint(), "");
    field.setText("fully");
    EXPECT_NE(field.complaint(), "") << "an unknown name";
    field.setText("T#2s");
    EXPECT_NE(field.complaint(), "") << "not a BOOL";
    field.setText("full AND NOT Left.X");
    EXPECT_EQ(field.complaint(), "");
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_NE(text().find("TO Ready := full AND NOT Left.X;"), std::string::npos) << text();
    select(editor::ChartScene::Action, step("Left"), 1);
    QTest::keyClick(&view->canvas(), Qt::Key_F2);
    EXPECT_EQ(field.text(), "D T#2s horn");
    field.setText("D horn");
    EXPECT_NE(field.complaint(), "") << "D without a time";
    field.setText("Q horn");
    EXPECT_NE(field.complaint(), "");
    field.setText("SL T#1s horn");
    EXPECT_EQ(field.complaint(), "");
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_NE(text().find("horn(SL, T#1s)"), std::string::npos) << text();
    editor().undo();
    editor().undo();
    EXPECT_EQ(text(), begin);
}

/// Whatever keys do to a chart: it parses and is drawn, and undo leads back to the first byte.
TEST_F(ChartEventsTest, RandomKeysAlwaysLeaveAChartAndUndoLeadsBack) {
    for (uint32_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        open(kChoice);
        uint32_t state = seed * 977;
        const auto random = [&](int limit) {
            state = state * 1664525u + 1013904223u;
            return static_cast<int>((state >> 8) % static_cast<uint32_t>(std::max(1, limit)));
        };
        int changed = 0;
        for (int round = 0; round < 40; ++round) {
            ASSERT_FALSE(view->isReadOnly()) << text();
            const auto* chart = view->scene().chart();
            const auto steps = static_cast<int>(chart->steps.size()),
                       transitions = static_cast<int>(chart->transitions.size());
            const bool isStep = random(2) || transitions == 0;
            const int index = random(isStep ? steps : transitions);
            select(isStep ? editor::ChartScene::Step : editor::ChartScene::Transition, index);
            const std::string before = text();
            const auto type = [&](const QString& typed) {
                if (!view->field().isVisible()) return;
                view->field().setText(typed);
                QTest::keyClick(&view->field(), Qt::Key_Return);
            };
            switch (random(8)) {
            case 0:
                QTest::keyClick(&view->canvas(), Qt::Key_Insert);
                break;
            case 1:
                QTest::keyClick(&view->canvas(), Qt::Key_Delete);
                break;
            case 2:
                QTest::keyClick(&view->canvas(), Qt::Key_Right, Qt::ControlModifier);
                break;
            case 3:
                QTest::keyClick(&view->canvas(), Qt::Key_F2);
                type(isStep ? "Step_" + QString::number(round) : "full OR go");
                break;
            case 4:
                view->insertAlternative();
                break;
            case 5:
                view->insertSimultaneous();
                break;
            case 6:
                view->insertAction();
                type("D T#2s lamp");
                break;
            default:
                view->makeInitial();
            }
            if (text() == before) continue;
            ++changed;
            const std::string after = text();
            editor().undo();
            ASSERT_EQ(text(), before) << "one edit is one step of undo";
            editor().redo();
            ASSERT_EQ(text(), after);
        }
        EXPECT_GT(changed, 12);
        undoAll();
        EXPECT_EQ(text(), begin);
    }
}

TEST_F(ChartEventsTest, FindingsAreMarkedInTheGraphAndWarningsToo) {
    open(kChoice);
    EXPECT_EQ(view->scene().problemCount(), 0);
    const auto at = static_cast<uint32_t>(text().find("lamp(N)"));
    editor().applyEdits({{{FileId(), at, at + 7}, "lamp(D)"}});
    analysed();
    EXPECT_TRUE(waitFor([&] { return view->scene().problemCount() > 0; }));
    EXPECT_NE(view->scene().itemOf(editor::ChartScene::Action, step("Left"), 0)->toolTip(), "");
    EXPECT_EQ(view->scene().itemOf(editor::ChartScene::Step, step("Ready"))->toolTip(), "");
}

TEST_F(ChartEventsTest, TheSelectionFollowsTheCursorAndTheArrowKeys) {
    open(kChoice);
    editor().setFocus();
    editor().goTo(static_cast<uint32_t>(text().find("horn(D")));
    EXPECT_TRUE(
        waitFor([&] { return view->scene().itemOf(editor::ChartScene::Action, step("Left"), 1)->isSelected(); }));
    select(editor::ChartScene::Step, step("Ready"));
    QTest::keyClick(&view->canvas(), Qt::Key_Down);
    ASSERT_EQ(view->scene().selectedItems().size(), 1);
    EXPECT_EQ(view->scene().selectedItems().front()->data(editor::ChartScene::Kind).toInt(),
              editor::ChartScene::Transition);
}

TEST_F(ChartEventsTest, TheMapIsThereForBigChartsAndPicturesAreWritten) {
    open(kChoice);
    EXPECT_FALSE(view->canvas().isMapVisible());
    std::string big = "PROGRAM Main\nINITIAL_STEP S0: END_STEP\n";
    for (int i = 1; i < 60; ++i) big += "STEP S" + std::to_string(i) + ": END_STEP\n";
    for (int i = 0; i < 60; ++i)
        big += "TRANSITION FROM S" + std::to_string(i) + " TO S" + std::to_string((i + 1) % 60) + " := S" +
               std::to_string(i) + ".T > T#1s; END_TRANSITION\n";
    open((big + "END_PROGRAM\n").c_str());
    EXPECT_TRUE(view->canvas().isMapVisible());
    QTemporaryDir pictures;
    ASSERT_TRUE(view->canvas().exportPng(pictures.path() + "/c.png"));
    EXPECT_GT(QImage(pictures.path() + "/c.png").height(), 3000);
    ASSERT_TRUE(view->canvas().exportSvg(pictures.path() + "/c.svg"));
    QFile svg(pictures.path() + "/c.svg");
    ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
    EXPECT_TRUE(svg.readAll().contains("S59"));
}

TEST_F(ChartEventsTest, ANestedChartOpensFromItsActionAndRunsLit) {
    open(kRunning);
    select(editor::ChartScene::Action, step("Work"), 2);
    QTest::keyClick(&view->canvas(), Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(view->unit(), "Main.Deep");
    ASSERT_NE(view->scene().chart(), nullptr);
    EXPECT_EQ(view->scene().chart()->steps.size(), 2u);
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] {
        return view->scene().online().isOn && view->scene().online().steps.size() == 2 &&
               view->scene().online().steps[1].isActive;
    }));
    EXPECT_TRUE(waitFor([&] { return view->scene().online().actions.value("inner"); }));
    // an edit inside goes to the same text
    select(editor::ChartScene::Step, 0);
    QTest::keyClick(&view->canvas(), Qt::Key_Insert);
    EXPECT_EQ(view->scene().chart()->steps.size(), 3u);
    editor().undo();
    EXPECT_EQ(text(), begin);
    QTest::keyClick(&view->canvas(), Qt::Key_Backspace);
    EXPECT_EQ(view->unit(), "Main");
    EXPECT_EQ(view->scene().chart()->steps.size(), 2u);
}

TEST_F(ChartEventsTest, QualifiersConditionsAndTheTakenPathAreLive) {
    open(kRunning);
    window->action("run.start")->trigger();
    const auto& online = view->scene().online();
    const int work = step("Work");
    ASSERT_TRUE(waitFor([&] { return online.isOn && online.steps[static_cast<size_t>(work)].isActive; }));
    const auto delayed = [&] { return online.associations[static_cast<size_t>(work)][1]; };
    EXPECT_TRUE(waitFor([&] {
        return online.steps[static_cast<size_t>(work)].isActive && delayed().progress > 0 && delayed().progress < 1 &&
               !delayed().asks;
    })) << "waits for its time";
    EXPECT_TRUE(waitFor([&] { return delayed().asks && delayed().isActive; })) << "the time is over";
    EXPECT_TRUE(waitFor([&] { return online.taken[0] > 0; })) << "the way into Work fades";
    EXPECT_TRUE(waitFor([&] { return online.transitions[1].has_value() && *online.transitions[1]; }))
        << "the condition holds in the scan in which it is taken";
}

TEST_F(ChartEventsTest, ABreakpointStopsWhenTheStepBecomesActiveAndWhenTheTransitionIsTaken) {
    open(kRunning);
    select(editor::ChartScene::Step, step("Work"));
    view->toggleBreakpoint();
    settle();
    EXPECT_TRUE(view->scene().marks().steps.value(step("Work")));
    window->action("run.start")->trigger();
    const auto halted = [&] { return window->control().status().state == controller::State::Halted; };
    ASSERT_TRUE(waitFor(halted));
    EXPECT_EQ(window->control().value("Main.Work.X").text, "TRUE");
    EXPECT_EQ(window->control().value("Main.Work.on").text, "TRUE");
    const auto scan = window->control().status().scans;
    select(editor::ChartScene::Step, step("Work"));
    view->toggleBreakpoint();
    select(editor::ChartScene::Transition, 1);
    view->toggleBreakpoint();
    settle();
    EXPECT_TRUE(view->scene().marks().transitions.value(1));
    window->control().resume();
    ASSERT_TRUE(waitFor([&] { return halted() && window->control().status().scans > scan; }));
    EXPECT_EQ(window->control().value("Main.Work.T > T#900ms").text, "TRUE") << "not before it is taken";
    window->control().setBreakpoints({});
    window->control().resume();
}

TEST_F(ChartEventsTest, AForcedStepStaysOnAndIsMarked) {
    open(kRunning);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return view->scene().online().isOn; }));
    select(editor::ChartScene::Step, step("Work"));
    view->forceSelected(true);
    const auto work = static_cast<size_t>(step("Work"));
    EXPECT_TRUE(waitFor(
        [&] { return view->scene().online().steps[work].isForced && view->scene().online().steps[work].isActive; }));
    select(editor::ChartScene::Step, step("Work"));
    view->forceSelected(false);
    EXPECT_TRUE(waitFor([&] { return !view->scene().online().steps[work].isForced; }));
    EXPECT_TRUE(waitFor([&] { return !view->scene().online().steps[work].isActive; }));
}

TEST_F(ChartEventsTest, TheTimeSliderShowsTheStepsOfThatScan) {
    open(kRunning);
    window->action("run.start")->trigger();
    const auto work = static_cast<size_t>(step("Work"));
    ASSERT_TRUE(waitFor([&] { return view->scene().online().isOn && view->scene().online().steps[work].isActive; }));
    ASSERT_TRUE(waitFor([&] { return !view->scene().online().steps[work].isActive; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    auto* session = window->control().session();
    const auto found = session->history().find(*session->expression("Main.Work.X AND Main.Work.T > T#500ms"),
                                               session->recompile("Main.Work.X AND Main.Work.T > T#500ms"), 0,
                                               history::History::Direction::Forward);
    ASSERT_TRUE(found);
    window->control().view(*found);
    EXPECT_TRUE(
        waitFor([&] { return view->scene().online().steps[work].isActive && view->scene().online().taken[0] > 0.3; }));
    EXPECT_TRUE(view->scene().online().associations[work][1].asks) << "D after its 400 ms";
    window->control().view(*found - 35);
    EXPECT_TRUE(waitFor([&] { return !view->scene().online().associations[work][1].asks; }));
    window->control().view(std::nullopt);
}

// ------------------------------------------------------------------ instruction lists

const char* const kList = R"(PROGRAM Main
VAR
    counter : INT;
    over : BOOL;
END_VAR
        LD      counter
        ADD     1
        ST      counter
        GT      100
        ST      over
        LD      5
END_PROGRAM
)";

TEST_F(ChartEventsTest, EachLineOfAListShowsItsCurrentResultLiveAndInThePast) {
    editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, kList}});
    analysed();
    window->action("run.start")->trigger();
    const auto shown = [&](int line) {
        for (const auto& [at, values] : editor().shownValues())
            if (at == line && !values.empty() && values.front().isAccumulator) return values.front().value;
        return QString();
    };
    ASSERT_TRUE(waitFor([&] { return !shown(6).isEmpty() && shown(8) == "TRUE"; }));
    EXPECT_EQ(shown(10), "5") << "a constant is its own result";
    EXPECT_FALSE(shown(5).isEmpty());
    if (qEnvironmentVariableIsSet("STEPWISE_PICTURES"))
        editor().grab().save(qEnvironmentVariable("STEPWISE_PICTURES") + "/list_online.png");
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    window->control().view(9);
    EXPECT_TRUE(waitFor([&] { return shown(6) == "10" && shown(5) == "9" && shown(7) == "10" && shown(8) == "FALSE"; }))
        << shown(5).toStdString() << " " << shown(6).toStdString();
    for (const auto& [line, values] : editor().shownValues())
        for (const auto& value : values)
            EXPECT_FALSE(value.name.contains(u' '))
                << "an instruction is shown as its result: " << value.name.toStdString();
    window->control().view(std::nullopt);
}

TEST_F(ChartEventsTest, AListIsShownAsStAndReplacedAsOneStepOfUndo) {
    editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, kList}});
    editor().SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
    analysed();
    editor().goTo(static_cast<uint32_t>(text().find("ADD")));
    window->action("edit.asSt")->trigger();
    QWidget* dialog = nullptr;
    ASSERT_TRUE(waitFor([&] {
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (widget->inherits("plc::app::ConversionDialog") && widget->isVisible()) dialog = widget;
        return dialog != nullptr;
    }));
    auto* replace = dialog->findChild<QWidget*>("replace");
    ASSERT_NE(replace, nullptr);
    QTest::mouseClick(replace, Qt::LeftButton);
    EXPECT_NE(text().find("counter := "), std::string::npos) << text();
    EXPECT_EQ(text().find("LD      "), std::string::npos) << text();
    editor().undo();
    EXPECT_EQ(text(), kList);
}

} // namespace
} // namespace plc::app
