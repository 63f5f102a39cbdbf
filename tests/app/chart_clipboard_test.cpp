// The chart as an engineer expects it: copying and pasting with the keys of the Edit menu, a name open for typing after
// an insert, a text that follows, a chart that begins where there was none, fit that fits.
#include "tests/app/studio_fixture.h"

#include <QClipboard>
#include <QGraphicsItem>
#include <QPushButton>

namespace plc::app {
namespace {

const char* const kChart = R"(PROGRAM Main
VAR
    go, lamp, horn : BOOL;
END_VAR
INITIAL_STEP Ready: END_STEP
TRANSITION FROM Ready TO Work := go; END_TRANSITION
STEP Work:
    lamp(N);
    horn(D, T#2s);
END_STEP
TRANSITION FROM Work TO Ready := NOT go; END_TRANSITION
END_PROGRAM
)";

class ChartClipboardTest : public StudioTest {
protected:
    void open(const char* text) {
        editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, text}});
        editor().SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
        analysed();
        view = window->tabs().currentPage()->showChart("Main");
        ASSERT_NE(view, nullptr);
        view->canvas().setFocus();
        QApplication::processEvents();
    }
    void select(editor::ChartScene::ItemKind kind, int index, int sub = -1) {
        view->scene().clearSelection();
        QGraphicsItem* item = view->scene().itemOf(kind, index, sub);
        ASSERT_NE(item, nullptr);
        item->setSelected(true);
        view->canvas().setFocus();
    }
    void press(const char* command) {
        window->action(command)->trigger();
        QApplication::processEvents();
    }
    editor::ChartView* view = nullptr;
};

TEST_F(ChartClipboardTest, AStepIsCopiedWithItsActionsAndPastedAsOneStepOfUndo) {
    open(kChart);
    select(editor::ChartScene::Step, 1);
    press("edit.copy");
    press("edit.paste");
    ASSERT_EQ(view->scene().chart()->steps.size(), 3u);
    const std::string text = editor().utf8();
    EXPECT_NE(text.find("STEP Step1:"), std::string::npos) << text;
    EXPECT_EQ(view->scene().chart()->steps[2].decl->actions.size(), 2u) << text;
    EXPECT_NE(text.find("horn(D, T#2s)", text.find("Step1:")), std::string::npos) << text;
    press("edit.undo");
    EXPECT_EQ(editor().utf8(), kChart);
}

TEST_F(ChartClipboardTest, AnActionIsPastedIntoAnotherStepAndAConditionOntoAnotherTransition) {
    open(kChart);
    select(editor::ChartScene::Action, 1, 1);
    press("edit.copy");
    select(editor::ChartScene::Step, 0);
    press("edit.paste");
    ASSERT_EQ(view->scene().chart()->steps[0].decl->actions.size(), 1u) << editor().utf8();
    select(editor::ChartScene::Transition, 0);
    press("edit.copy");
    select(editor::ChartScene::Transition, 1);
    press("edit.paste");
    EXPECT_EQ(view->scene().conditionText(1), "go");
}

TEST_F(ChartClipboardTest, AStepThatIsCutGoesAndWhatIsNoStepIsRefusedWithAReason) {
    open(kChart);
    select(editor::ChartScene::Step, 1);
    press("edit.cut");
    EXPECT_EQ(view->scene().chart()->steps.size(), 1u) << editor().utf8();
    EXPECT_EQ(QApplication::clipboard()->text().left(10), "STEP Work:");
    QApplication::clipboard()->setText("IF a THEN b; END_IF");
    QString said;
    QObject::connect(view, &editor::GraphView::failed, window.get(), [&](const QString& text) { said = text; });
    const std::string before = editor().utf8();
    select(editor::ChartScene::Step, 0);
    press("edit.paste");
    EXPECT_EQ(said, "The clipboard contains no step, action or transition; copy one first");
    EXPECT_EQ(editor().utf8(), before);
}

TEST_F(ChartClipboardTest, TheNameIsOpenForTypingAfterAnInsertAndTheTextFollows) {
    open(kChart);
    select(editor::ChartScene::Step, 0);
    QTest::keyClick(&view->canvas(), Qt::Key_Insert);
    ASSERT_TRUE(waitFor([&] { return view->field().isVisible(); }));
    EXPECT_EQ(editor().cursorOffset(), editor().utf8().find("Step1:"));
    QTest::keyClicks(&view->field(), "Warm");
    QTest::keyClick(&view->field(), Qt::Key_Return);
    EXPECT_NE(editor().utf8().find("STEP Warm:"), std::string::npos) << editor().utf8();
    EXPECT_EQ(editor().utf8().find("Step1"), std::string::npos);
}

TEST_F(ChartClipboardTest, AProgramWithoutAChartSaysHowToBeginOneAndTheButtonDoes) {
    open("PROGRAM Main\nVAR\n    go : BOOL;\nEND_VAR\nEND_PROGRAM\n");
    auto* button = view->findChild<QPushButton*>();
    ASSERT_TRUE(button && button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_NE(view->scene().chart(), nullptr) << editor().utf8();
    EXPECT_EQ(view->scene().chart()->steps.size(), 1u);
    EXPECT_FALSE(button->isVisible());
    EXPECT_EQ(editor().utf8().find("INITIAL_STEP"), editor().utf8().find("END_VAR\n") + 8) << editor().utf8();
    open("PROGRAM Main\nVAR\n    go : BOOL;\nEND_VAR\ngo := TRUE;\nEND_PROGRAM\n");
    EXPECT_FALSE(button->isVisible()) << "nothing is written over";
}

TEST_F(ChartClipboardTest, FitShowsTheWholeChartWithoutScrollBarsAndASmallOneHasNoMap) {
    open(kChart);
    window->resize(1300, 900);
    view->canvas().setZoom(3);
    view->canvas().zoomToFit();
    QApplication::processEvents();
    const QRectF seen = view->canvas().mapToScene(view->canvas().viewport()->rect()).boundingRect();
    EXPECT_TRUE(seen.contains(view->scene().itemsBoundingRect()));
    EXPECT_FALSE(view->canvas().horizontalScrollBar()->isVisible());
    EXPECT_FALSE(view->canvas().verticalScrollBar()->isVisible());
    EXPECT_FALSE(view->canvas().isMapVisible());
}

} // namespace
} // namespace plc::app
