// F1 on a problem: its page, from the list of problems and from the text.
#include "app/project/explanation_dialog.h"
#include "app/project/problems_view.h"
#include "tests/app/studio_fixture.h"

#include <QTextBrowser>
#include <QTreeWidget>

namespace plc::app {
namespace {

class ExplanationTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        typeAtEnd("missing := 1;");
        ASSERT_TRUE(waitFor([&] { return window->problems().errorCount() > 0; }));
    }
    ExplanationDialog* dialog() { return window->findChild<ExplanationDialog*>(); }
};

TEST_F(ExplanationTest, F1OnAProblemOfTheListShowsItsPage) {
    window->showDock("problems");
    QTreeWidget& list = window->problems().list();
    list.setCurrentItem(list.topLevelItem(0));
    list.setFocus();
    ASSERT_TRUE(waitFor([&] { return list.hasFocus(); }));
    window->action("help.explain")->trigger();
    ASSERT_NE(dialog(), nullptr);
    EXPECT_TRUE(dialog()->isVisible());
    EXPECT_TRUE(dialog()->windowTitle().contains("P2001")) << dialog()->windowTitle().toStdString();
    EXPECT_TRUE(dialog()->page().toPlainText().contains("y is not declared"));
}

TEST_F(ExplanationTest, F1InTheTextShowsThatOfTheCursor) {
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("missing")) + 2);
    editor().setFocus();
    window->action("help.explain")->trigger();
    ASSERT_NE(dialog(), nullptr);
    EXPECT_TRUE(dialog()->windowTitle().contains("P2001"));
}

TEST_F(ExplanationTest, WithoutAProblemItSaysWhatToDo) {
    editor().goTo(0);
    editor().setFocus();
    window->action("help.explain")->trigger();
    EXPECT_FALSE(dialog() && dialog()->isVisible());
}

} // namespace
} // namespace plc::app
