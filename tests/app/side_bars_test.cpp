// Docks that hide themselves: the pin, the button at the edge, sliding out over the documents, and what brings them
// back to their place; kept with the project.
#include "app/frame/perspectives.h"
#include "app/frame/side_bars.h"
#include "editor/debug/watch_view.h"
#include "editor/text/st_editor.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QDockWidget>
#include <QToolBar>
#include <QToolButton>

namespace plc::app {
namespace {

class SideBarsTest : public StudioTest {
protected:
    QDockWidget& watch() { return *window->dock("watch"); }
    QToolBar& bar(const char* name) { return *window->findChild<QToolBar*>(name); }
    QToolButton* edgeButton(const char* dock) { return window->findChild<QToolButton*>(QString("sideBar.") + dock); }
    void hideWatch() {
        window->showDock("watch");
        ASSERT_TRUE(waitFor([&] { return window->watch().isVisible(); }));
        auto* pin = watch().titleBarWidget()->findChild<QToolButton*>("pin");
        ASSERT_NE(pin, nullptr);
        QTest::mouseClick(pin, Qt::LeftButton);
    }
};

TEST_F(SideBarsTest, APinTurnsTheDockIntoAButtonThatSlidesItOut) {
    hideWatch();
    EXPECT_FALSE(watch().isVisible());
    EXPECT_TRUE(bar("sideBarRight").isVisible());
    EXPECT_FALSE(bar("sideBarLeft").isVisible());
    ASSERT_NE(edgeButton("watch"), nullptr);
    QTest::mouseClick(edgeButton("watch"), Qt::LeftButton);
    EXPECT_TRUE(window->watch().isVisible());
    EXPECT_FALSE(watch().isVisible());
    EXPECT_EQ(window->sideBars().revealed(), &watch());
    const QPoint right = window->watch().mapTo(window.get(), window->watch().rect().topRight());
    EXPECT_LT(window->width() - right.x(), 80) << "from its own edge";
    QTest::mouseClick(edgeButton("watch"), Qt::LeftButton);
    EXPECT_FALSE(window->watch().isVisible());
}

TEST_F(SideBarsTest, EscapeAndWorkElsewhereHideItAgain) {
    hideWatch();
    window->showDock("watch"); // as a shortcut or another view asks for it
    ASSERT_TRUE(window->watch().isVisible());
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &window->watch(), Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return !window->watch().isVisible(); }));
    window->showDock("watch");
    ASSERT_TRUE(window->watch().isVisible());
    window->tabs().openFile("src/main.st");
    editor().setFocus();
    EXPECT_TRUE(waitFor([&] { return !window->watch().isVisible(); }));
    EXPECT_TRUE(window->sideBars().hidesItself(watch()));
}

TEST_F(SideBarsTest, ThePinOfTheOpenOneBringsItBackToItsPlace) {
    hideWatch();
    window->sideBars().reveal(watch());
    QToolButton* pin = nullptr;
    for (QToolButton* each : window->findChildren<QToolButton*>("pin"))
        if (each->isVisible() && each->parentWidget()->objectName() == "slidOutTitle") pin = each;
    ASSERT_NE(pin, nullptr);
    QTest::mouseClick(pin, Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return watch().isVisible() && window->watch().isVisible(); }));
    EXPECT_EQ(watch().widget(), &window->watch());
    EXPECT_FALSE(bar("sideBarRight").isVisible());
    EXPECT_EQ(window->sideBars().revealed(), nullptr);
}

TEST_F(SideBarsTest, TheKeyDoesWhatThePinDoes) {
    window->showDock("watch");
    ASSERT_TRUE(waitFor([&] { return window->watch().isVisible(); }));
    window->watch().setFocus();
    window->action("view.hideDock")->trigger();
    if (!window->sideBars().hidesItself(watch())) { // the focus may be with a child
        for (QWidget* child : window->watch().findChildren<QWidget*>())
            if (child->focusPolicy() != Qt::NoFocus && child->isVisible()) {
                child->setFocus();
                break;
            }
        window->action("view.hideDock")->trigger();
    }
    EXPECT_TRUE(window->sideBars().hidesItself(watch()));
    window->showDock("watch");
    window->action("view.hideDock")->trigger();
    EXPECT_FALSE(window->sideBars().hidesItself(watch()));
    EXPECT_TRUE(watch().isVisible());
}

TEST_F(SideBarsTest, TheProjectRemembersItAndArrangingKeepsIt) {
    hideWatch();
    window->perspectives().show(Perspective::Debugging);
    EXPECT_TRUE(window->sideBars().hidesItself(watch())) << "although debugging wants the watch";
    window->perspectives().toggleMaximised();
    window->perspectives().toggleMaximised();
    EXPECT_TRUE(waitFor([&] { return bar("sideBarRight").isVisible(); }));
    window->closeProject();
    EXPECT_TRUE(waitFor([&] { return !bar("sideBarRight").isVisible(); })) << "the start page has no docks";
    ASSERT_TRUE(window->openProject(folder.path()));
    EXPECT_TRUE(window->sideBars().hidesItself(watch()));
    EXPECT_FALSE(watch().isVisible());
    EXPECT_TRUE(waitFor([&] { return bar("sideBarRight").isVisible(); }));
    window->resetLayout();
    EXPECT_FALSE(window->sideBars().hidesItself(watch()));
    EXPECT_TRUE(waitFor([&] { return watch().isVisible(); }));
}

} // namespace
} // namespace plc::app
