// The graph of a chart beside its text: what is drawn, edits as minimal text edits, one undo history, and the lit steps
// while it runs.
#include "tests/app/studio_fixture.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QGraphicsItem>

namespace plc::app {
namespace {

const char* const kChart = R"(PROGRAM Main
VAR
    go : BOOL := TRUE;
    lamp : BOOL;
END_VAR

(* where it rests *)
INITIAL_STEP Ready:
END_STEP

// lamp on
STEP Work:
    lamp(N);
END_STEP

TRANSITION FROM Ready TO Work := go; END_TRANSITION
TRANSITION FROM Work TO Ready := Work.T > T#200ms; END_TRANSITION
END_PROGRAM
)";

class ChartTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, kChart}});
        editor().SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
        analysed();
        view = window->tabs().currentPage()->showChart("Main");
        ASSERT_NE(view, nullptr);
        settle();
    }
    void select(editor::ChartScene::ItemKind kind, int index) {
        view->scene().clearSelection();
        QGraphicsItem* item = view->scene().itemOf(kind, index);
        ASSERT_NE(item, nullptr);
        item->setSelected(true);
    }
    editor::ChartView* view = nullptr;
};

TEST_F(ChartTest, DrawsStepsTransitionsAndActions) {
    ASSERT_NE(view->scene().chart(), nullptr);
    EXPECT_EQ(view->scene().chart()->steps.size(), 2u);
    EXPECT_EQ(view->scene().chart()->transitions.size(), 2u);
    EXPECT_EQ(view->scene().conditionText(0), "go");
    EXPECT_LT(view->scene().stepRect(0).bottom(), view->scene().stepRect(1).top());
}

TEST_F(ChartTest, InsertingAStepEditsTheTextAndUndoRestoresEveryByte) {
    select(editor::ChartScene::Step, 0);
    QTest::keyClick(&view->canvas(), Qt::Key_Insert);
    EXPECT_EQ(view->scene().chart()->steps.size(), 3u);
    EXPECT_NE(editor().utf8().find("(* where it rests *)"), std::string::npos);
    editor().undo();
    EXPECT_EQ(editor().utf8(), kChart);
    EXPECT_EQ(view->scene().chart()->steps.size(), 2u);
}

TEST_F(ChartTest, RenamingAStepInPlaceRenamesItsUses) {
    select(editor::ChartScene::Step, 1);
    QTest::keyClick(&view->canvas(), Qt::Key_F2);
    auto* field = view->findChild<kit::ExpressionEdit*>();
    ASSERT_TRUE(field && field->isVisible());
    field->setText("Shine");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_NE(editor().utf8().find("STEP Shine:"), std::string::npos) << editor().utf8();
    EXPECT_NE(editor().utf8().find("Shine.T > T#200ms"), std::string::npos);
    EXPECT_EQ(editor().utf8().find("Work"), std::string::npos);
}

TEST_F(ChartTest, ATextWithErrorsLeavesTheLastGoodDrawing) {
    const auto at = static_cast<uint32_t>(editor().utf8().find("STEP Work"));
    editor().applyEdits({{{FileId(), at, at + 4}, "STEP STEP ("}});
    EXPECT_TRUE(view->isReadOnly());
    EXPECT_EQ(view->scene().chart()->steps.size(), 2u);
    editor().undo();
    EXPECT_FALSE(view->isReadOnly());
}

TEST_F(ChartTest, TheActiveStepIsLitWhileItRuns) {
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] {
        const auto& online = view->scene().online();
        return online.isOn && online.steps.size() == 2 && online.steps[1].isActive && online.actions.value("lamp");
    }));
    EXPECT_TRUE(
        waitFor([&] { return view->scene().online().steps[0].isActive || view->scene().online().taken[1] > 0; }));
}

TEST_F(ChartTest, SelectingInTheGraphMovesTheCursor) {
    select(editor::ChartScene::Transition, 1);
    EXPECT_EQ(editor().cursorOffset(), editor().utf8().find("TRANSITION FROM Work"));
}

} // namespace
} // namespace plc::app
