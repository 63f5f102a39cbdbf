// Room for the work: the editor alone, arrangements for editing, debugging and drawing, a window of 1024 × 700; and
// small things of the window one meets every day.
#include "app/documents/design_pages.h"
#include "app/frame/perspectives.h"
#include "app/panels/live_views.h"
#include "app/project/project_tree.h"
#include "app/settings/translation.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTabBar>
#include <QTreeWidget>

namespace plc::app {
namespace {

class PerspectivesTest : public StudioTest {
protected:
    QStringList shownDocks() {
        QStringList out;
        for (QDockWidget* dock : window->findChildren<QDockWidget*>())
            if (!dock->isHidden()) out << dock->objectName();
        out.sort();
        return out;
    }
};

TEST_F(PerspectivesTest, ADoubleClickOnATabGivesTheEditorAllTheRoom) {
    const QStringList before = shownDocks();
    const int width = window->tabs().width();
    QTabBar* bar = window->tabs().tabBar();
    QTest::mouseDClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(0).center());
    EXPECT_TRUE(waitFor([&] { return shownDocks().isEmpty() && window->tabs().width() > width; }));
    QTest::mouseDClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(0).center());
    EXPECT_TRUE(waitFor([&] { return shownDocks() == before; }));
}

TEST_F(PerspectivesTest, EachWorkHasItsDocksAndKeepsWhatWasMoved) {
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

TEST_F(PerspectivesTest, DrawingPanelsHasTheRoomOnASmallScreen) {
    window->resize(1366, 768);
    ASSERT_TRUE(window->live().addPanel("overview"));
    window->showDock("trace"); // which is high
    window->designs().openPanel("overview");
    EXPECT_TRUE(window->statusBar()->currentMessage().startsWith("Ctrl+Alt+3"))
        << window->statusBar()->currentMessage().toStdString();
    QTest::keyClick(window.get(), Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window->tabs().pageByKey("panel:overview"));
    ASSERT_NE(designer, nullptr);
    EXPECT_TRUE(waitFor([&] { return designer->canvas().height() > 380; })) << designer->canvas().height();
}

TEST_F(PerspectivesTest, APanelThatIsAddedDoesNotTakeThePlaceOfTheStartPanel) {
    ASSERT_TRUE(window->live().addPanel("overview"));
    EXPECT_EQ(window->workspace().project().startPanel, "") << "nothing is written while there is no other";
    ASSERT_TRUE(window->live().addPanel("process"));
    EXPECT_EQ(window->workspace().project().startPanel, "") << "overview is the first by name";
    ASSERT_TRUE(window->live().addPanel("detail"));
    EXPECT_EQ(window->workspace().project().startPanel, "overview");
    ASSERT_TRUE(window->live().addPanel("alarms"));
    EXPECT_EQ(window->workspace().project().startPanel, "overview");
}

TEST_F(PerspectivesTest, TheWindowFitsIntoASmallScreen) {
    window->resize(1024, 700);
    EXPECT_TRUE(waitFor([&] { return window->width() <= 1024 && window->height() <= 700; }))
        << window->width() << " x " << window->height();
    EXPECT_GT(window->tabs().width(), 240);
    EXPECT_GT(window->tabs().height(), 150);
}

TEST_F(PerspectivesTest, OpeningAProjectKeepsTheSizeOfTheWindow) {
    window->closeProject();
    window->resize(1024, 700);
    ASSERT_TRUE(waitFor([&] { return window->size() == QSize(1024, 700); }));
    ASSERT_TRUE(window->openProject(folder.path()));
    settle(); // what the docks have posted
    EXPECT_EQ(window->size(), QSize(1024, 700));
}

TEST_F(PerspectivesTest, RoomThatDocksTakeLateIsGivenBackHoweverLongTheyTake) {
    window->closeProject();
    window->resize(1024, 700);
    ASSERT_TRUE(waitFor([&] { return window->size() == QSize(1024, 700); }));
    ASSERT_TRUE(window->openProject(folder.path()));
    // A dock that needs more than there is, and then does not: as one whose tabs come late on a slow machine.
    QWidget* inside = window->findChild<QDockWidget*>("panel")->widget();
    inside->setMinimumWidth(1400);
    ASSERT_TRUE(waitFor([&] { return window->width() > 1024; }));
    inside->setMinimumWidth(0);
    EXPECT_TRUE(waitFor([&] { return window->size() == QSize(1024, 700); })) << window->width();
}

TEST_F(PerspectivesTest, ClickingWithAltPutsOneMoreCaret) {
    const auto at = [&](const char* text) {
        const auto position = static_cast<long>(editor().utf8().find(text));
        using S = QsciScintillaBase;
        return QPoint(static_cast<int>(editor().SendScintilla(S::SCI_POINTXFROMPOSITION, 0UL, position)),
                      static_cast<int>(editor().SendScintilla(S::SCI_POINTYFROMPOSITION, 0UL, position)) + 4);
    };
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("counter : INT")));
    QTest::mouseClick(editor().viewport(), Qt::LeftButton, Qt::AltModifier, at("limit : INT"));
    QTest::keyClicks(editor().viewport(), "x");
    EXPECT_NE(editor().utf8().find("xcounter : INT"), std::string::npos) << editor().utf8();
    EXPECT_NE(editor().utf8().find("xlimit : INT"), std::string::npos);
    window->workspace().revert("src/main.st");
}

TEST_F(PerspectivesTest, TheNextOccurrenceIsSelectedToo) {
    const auto at = static_cast<uint32_t>(editor().utf8().find("limit"));
    editor().goTo(at, 5);
    QTest::keyClick(editor().viewport(), Qt::Key_J, Qt::AltModifier);
    QTest::keyClicks(editor().viewport(), "most");
    EXPECT_EQ(editor().utf8().find("limit"), std::string::npos) << editor().utf8();
    EXPECT_NE(editor().utf8().find("counter >= most"), std::string::npos);
    window->workspace().revert("src/main.st");
}

TEST_F(PerspectivesTest, TheSelectedTextOfSeveralCaretsIsThatOfTheLast) {
    const auto at = static_cast<uint32_t>(editor().utf8().find("limit"));
    editor().goTo(at, 5);
    QTest::keyClick(editor().viewport(), Qt::Key_J, Qt::AltModifier);
    QTest::keyClick(editor().viewport(), Qt::Key_End, Qt::ShiftModifier); // of different length
    const QString text = editor().selectedText();
    EXPECT_TRUE(text.startsWith("limit")) << text.toStdString();
    EXPECT_EQ(text.count("limit"), 1) << text.toStdString();
    window->action("edit.findAll")->trigger(); // the search takes it
    window->action("edit.findNext")->trigger();
}

TEST_F(PerspectivesTest, AChangedFileThatIsNotOpenIsMarkedInTheTree) {
    write("src/other.st", "FUNCTION Twice : INT\nVAR_INPUT x : INT; END_VAR\nTwice := 2 * x;\nEND_FUNCTION\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/other.st"); }));
    QTreeWidget& tree = window->projectTree().tree();
    const auto note = [&] {
        const auto found = tree.findItems("Twice", Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? QString() : found.first()->data(0, Qt::UserRole + 6).toString();
    };
    ASSERT_TRUE(waitFor([&] { return note() == "other.st"; })) << note().toStdString();
    window->workspace().setText("src/other.st", window->workspace().text("src/other.st") + "// more\n");
    EXPECT_TRUE(waitFor([&] { return note() == "other.st ●"; })) << note().toStdString();
    window->workspace().revert("src/other.st");
    EXPECT_EQ(note(), "other.st");
}

TEST_F(PerspectivesTest, TheTreeShowsNothingOfTheCompilersOwn) {
    write("src/steps.st", "PROGRAM Steps\nVAR go : BOOL; END_VAR\nINITIAL_STEP A: END_STEP\nTRANSITION FROM A TO B := "
                          "go; END_TRANSITION\nSTEP B: END_STEP\nTRANSITION FROM B TO A := NOT go; "
                          "END_TRANSITION\nEND_PROGRAM\n");
    QTreeWidget& tree = window->projectTree().tree();
    ASSERT_TRUE(waitFor([&] { return !tree.findItems("Steps", Qt::MatchExactly | Qt::MatchRecursive).isEmpty(); }));
    EXPECT_TRUE(tree.findItems("__", Qt::MatchStartsWith | Qt::MatchRecursive).isEmpty());
}

TEST(QtTranslations, ButtonsOfQtsOwnDialogsAreTranslated) {
    installTranslation(*qApp, "de");
    QMessageBox box(QMessageBox::Question, "", "", QMessageBox::SaveAll | QMessageBox::Discard | QMessageBox::Cancel);
    EXPECT_EQ(box.button(QMessageBox::Cancel)->text().remove('&'), "Abbrechen");
    EXPECT_NE(box.button(QMessageBox::SaveAll)->text().remove('&'), "Save All");
    installTranslation(*qApp, "en");
}

} // namespace
} // namespace plc::app
