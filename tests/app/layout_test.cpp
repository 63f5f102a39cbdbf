// Room for the work: the editor alone, arrangements for editing, debugging and drawing, a window of 1024 × 700; and
// small things of the window one meets every day.
#include "app/perspectives.h"
#include "app/project_tree.h"
#include "app/translation.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QTreeWidget>

namespace plc::app {
namespace {

class LayoutTest : public StudioTest {
protected:
    QStringList shownDocks() {
        QStringList out;
        for (QDockWidget* dock : window->findChildren<QDockWidget*>())
            if (!dock->isHidden()) out << dock->objectName();
        out.sort();
        return out;
    }
};

TEST_F(LayoutTest, ADoubleClickOnATabGivesTheEditorAllTheRoom) {
    const QStringList before = shownDocks();
    const int width = window->tabs().width();
    QTabBar* bar = window->tabs().tabBar();
    QTest::mouseDClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(0).center());
    EXPECT_TRUE(waitFor([&] { return shownDocks().isEmpty() && window->tabs().width() > width; }));
    QTest::mouseDClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(0).center());
    EXPECT_TRUE(waitFor([&] { return shownDocks() == before; }));
}

TEST_F(LayoutTest, EachWorkHasItsDocksAndKeepsWhatWasMoved) {
    window->action("view.debugging")->trigger();
    QStringList wanted = Perspectives::docksOf(Perspective::Debugging);
    wanted.sort();
    EXPECT_EQ(shownDocks(), wanted);
    window->dock("forces")->hide();
    window->action("view.editing")->trigger();
    EXPECT_FALSE(shownDocks().contains("watch"));
    EXPECT_TRUE(shownDocks().contains("problems"));
    window->action("view.debugging")->trigger();
    EXPECT_TRUE(shownDocks().contains("watch"));
    EXPECT_FALSE(shownDocks().contains("forces")) << "it was closed there";
}

TEST_F(LayoutTest, TheWindowFitsIntoASmallScreen) {
    window->resize(1024, 700);
    EXPECT_TRUE(waitFor([&] { return window->width() <= 1024 && window->height() <= 700; }))
        << window->width() << " x " << window->height();
    EXPECT_GT(window->tabs().width(), 240);
    EXPECT_GT(window->tabs().height(), 150);
}

TEST_F(LayoutTest, TheTreeShowsNothingOfTheCompilersOwn) {
    write("src/steps.st", "PROGRAM Steps\nVAR go : BOOL; END_VAR\nINITIAL_STEP A: END_STEP\nTRANSITION FROM A TO B := "
                          "go; END_TRANSITION\nSTEP B: END_STEP\nTRANSITION FROM B TO A := NOT go; "
                          "END_TRANSITION\nEND_PROGRAM\n");
    QTreeWidget& tree = window->projectTree().tree();
    ASSERT_TRUE(waitFor([&] { return !tree.findItems("Steps", Qt::MatchExactly | Qt::MatchRecursive).isEmpty(); }));
    EXPECT_TRUE(tree.findItems("__", Qt::MatchStartsWith | Qt::MatchRecursive).isEmpty());
}

TEST(StudioLanguage, ButtonsOfQtsOwnDialogsAreTranslated) {
    installTranslation(*qApp, "de");
    QMessageBox box(QMessageBox::Question, "", "", QMessageBox::SaveAll | QMessageBox::Discard | QMessageBox::Cancel);
    EXPECT_EQ(box.button(QMessageBox::Cancel)->text().remove('&'), "Abbrechen");
    EXPECT_NE(box.button(QMessageBox::SaveAll)->text().remove('&'), "Save All");
    installTranslation(*qApp, "en");
}

} // namespace
} // namespace plc::app
