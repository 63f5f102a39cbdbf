// Menus on a small screen: each is one column of at most 700 pixels, in every language.
#include "app/settings/translation.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include <set>

namespace plc::app {
namespace {

class MenuSizeTest : public StudioTest, public ::testing::WithParamInterface<const char*> {
protected:
    void SetUp() override {
        installTranslation(*qApp, GetParam());
        StudioTest::SetUp();
    }
    void TearDown() override {
        StudioTest::TearDown();
        installTranslation(*qApp, "en");
    }
};

TEST_P(MenuSizeTest, EachIsOneColumnOnASmallScreen) {
    size_t seen = 0;
    for (QMenu* menu : window->menuBar()->findChildren<QMenu*>()) {
        emit menu->aboutToShow();
        std::set<int> columns;
        for (QAction* action : menu->actions()) columns.insert(menu->actionGeometry(action).x());
        EXPECT_LE(columns.size(), 1u) << GetParam() << " " << menu->title().toStdString();
        EXPECT_LE(menu->sizeHint().height(), 640) << GetParam() << " " << menu->title().toStdString();
        ++seen;
    }
    EXPECT_GE(seen, 6u);
}

TEST_P(MenuSizeTest, EveryCommandIsInAMenu) {
    std::set<QString> inMenus;
    for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>())
        for (const QAction* action : menu->actions()) inMenus.insert(action->objectName());
    for (const ActionSpec& spec : actionTable()) EXPECT_TRUE(inMenus.contains(spec.id)) << spec.id;
    for (const QDockWidget* dock : window->findChildren<QDockWidget*>())
        EXPECT_TRUE(inMenus.contains("dock." + dock->objectName())) << dock->objectName().toStdString();
}

INSTANTIATE_TEST_SUITE_P(Languages, MenuSizeTest, ::testing::Values("en", "de", "da", "fr", "es", "zh_CN"));

} // namespace
} // namespace plc::app
