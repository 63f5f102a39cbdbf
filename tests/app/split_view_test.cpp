// Two files of the project side by side: both are edited, and there is one text of each.
#include "app/pages/st_page.h"
#include "tests/app/studio_fixture.h"

namespace plc::app {
namespace {

class SplitViewTest : public StudioTest {};

TEST_F(SplitViewTest, AnotherFileIsEditedBesideTheOneInFront) {
    write("src/other.st", "FUNCTION Twice : INT\nVAR_INPUT\n    x : INT;\nEND_VAR\nTwice := 2 * x;\nEND_FUNCTION\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/other.st"); }) ||
                window->openProject(folder.path()));
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/other.st"); }));
    StPage* main = window->tabs().openFile("src/main.st");
    ASSERT_TRUE(main);
    window->tabs().openBeside("src/other.st");
    EXPECT_EQ(window->tabs().currentPage(), main);
    editor::StEditor* beside = main->beside();
    ASSERT_TRUE(beside && beside->isVisible());
    EXPECT_EQ(beside->file(), "src/other.st");
    beside->SendScintilla(QsciScintillaBase::SCI_GOTOPOS, 0ul);
    beside->setFocus();
    QTest::keyClicks(beside, "//");
    EXPECT_EQ(window->workspace().text("src/other.st").substr(0, 10), "//FUNCTION");
    EXPECT_EQ(main->first().utf8(), kMain);
    EXPECT_TRUE(window->workspace().isModified("src/other.st"));
    delete window->tabs().openFile("src/other.st"); // its page is closed
    EXPECT_FALSE(main->beside());
}

} // namespace
} // namespace plc::app
