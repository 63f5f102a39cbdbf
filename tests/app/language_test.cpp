// Every action, menu and dock of the real window speaks the languages of the studio.
#include "app/main_window.h"
#include "app/settings/translation.h"
#include "editor/kit/translation_tag.h"
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

TEST(TranslationTag, IsTheFileThatSpeaksALanguage) {
    EXPECT_EQ(kit::translationTag("de-AT"), "de");
    EXPECT_EQ(kit::translationTag("fr_CA"), "fr");
    for (const char* simplified : {"zh", "zh-CN", "zh_CN", "zh-Hans", "zh_SG"})
        EXPECT_EQ(kit::translationTag(simplified), "zh_CN") << simplified;
    for (const char* traditional : {"zh-TW", "zh_HK", "zh-Hant"})
        EXPECT_EQ(kit::translationTag(traditional), "en") << traditional;
    for (const QString& language : translatedLanguages()) {
        EXPECT_EQ(kit::translationTag(language), language);
        QTranslator texts;
        EXPECT_TRUE(texts.load(":/translations/stepwise_" + language + ".qm")) << language.toStdString();
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, StudioLanguage, ::testing::Values("de", "da", "fr", "es", "zh_CN"));

} // namespace
} // namespace plc::app
