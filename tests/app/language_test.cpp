// Every action, menu and dock of the real window speaks the languages of the studio.
#include "app/main_window.h"
#include "tests/app/studio_fixture.h"

#include <QDockWidget>
#include <QTranslator>

namespace plc::app {
namespace {

class StudioLanguage : public ::testing::TestWithParam<const char*> {};

TEST_P(StudioLanguage, HasEveryActionAndMenu) {
    QTranslator texts;
    ASSERT_TRUE(texts.load(QString(":/translations/stepwise_%1.qm").arg(GetParam())));
    ASSERT_GT(actionTable().size(), 50u);
    for (const ActionSpec& spec : actionTable()) {
        EXPECT_FALSE(texts.translate("plc::app::MainWindow", spec.text).isEmpty()) << spec.text;
        EXPECT_FALSE(texts.translate("plc::app::MainWindow", spec.menu).isEmpty()) << spec.menu;
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, StudioLanguage, ::testing::Values("de", "da"));

} // namespace
} // namespace plc::app
