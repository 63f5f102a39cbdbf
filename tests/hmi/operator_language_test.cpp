// What operators of each language see: units and truth in words, tables from right to left, keys of their script,
// digits by choice, and the language that was chosen last.
#include "hmi/player/keypad.h"
#include "hmi/player/keypad_letters.h"
#include "hmi/view/controls/arrays.h"
#include "hmi/view/element_factory.h"
#include "tests/hmi/running.h"

#include <QPushButton>
#include <QTemporaryDir>

namespace plc::hmi {
namespace {

TEST(OperatorLanguage, UnitsThatAreWordsAndTruthAreTranslated) {
    LanguageSettings settings;
    settings.languages = QStringList{"en", "de", "zh", "da"};
    settings.units["da"]["box"] = QStringLiteral("kasse");
    EXPECT_EQ(settings.unitFor("de", "rpm").unit.toStdString(), "U/min");
    EXPECT_EQ(settings.unitFor("zh-CN", "min").unit.toStdString(), "分钟");
    EXPECT_EQ(settings.unitFor("en", "rpm").unit.toStdString(), "rpm");
    EXPECT_EQ(settings.unitFor("de", "bar").unit.toStdString(), "bar");
    EXPECT_EQ(settings.unitFor("da", "box").unit.toStdString(), "kasse") << "a project has words of its own";
    EXPECT_EQ(settings.unitFor("da", "box").factor, 1);
    EXPECT_EQ(formatValue(Value::ofBool(true), {}, localeOf("de")).toStdString(), "WAHR");
    EXPECT_EQ(formatValue(Value::ofBool(false), {}, localeOf("en")).toStdString(), "FALSE");
    EXPECT_EQ(formatValue(Value::ofBool(true), "%d", localeOf("de")).toStdString(), "1");
}

TEST(OperatorLanguage, TheTagChoosesTheDigitsOfArabic) {
    EXPECT_EQ(localeOf("ar-u-nu-latn").toString(120).toStdString(), "120");
    EXPECT_EQ(localeOf("ar-u-nu-arab").toString(120).toStdString(), "١٢٠");
    EXPECT_TRUE(isRightToLeft("ar-u-nu-latn"));
    EXPECT_EQ(nativeName("ar-u-nu-latn").toStdString(), nativeName("ar").toStdString());
    LanguageSettings settings;
    EXPECT_TRUE(settings.chain("ar-u-nu-latn").contains("ar")) << "texts are those of the language";
}

TEST(OperatorLanguage, TheFirstColumnOfATableIsWhereReadingBegins) {
    const Panel panel = panelOf(R"({"id":"t","kind":"table","rect":[0,0,400,200],"count":2,
                                    "columns":[{"title":"A","value":""},{"title":"B","value":""}]})");
    const auto leftOfFirst = [&](const char* tag) {
        PanelScene scene{makeElementView};
        scene.setLanguage(QLatin1String(tag));
        scene.setPanel(panel);
        std::vector<TextBox> boxes;
        scene.view("t")->collectTexts(QLatin1String(tag), boxes);
        return boxes.at(0).rect.left();
    };
    EXPECT_LT(leftOfFirst("en"), 100);
    EXPECT_GT(leftOfFirst("ar"), 150);
}

TEST(OperatorLanguage, TheKeypadHasTheLettersOfTheScriptAndLatinOnesOnAKey) {
    const TextCatalog texts;
    EntryRequest request;
    request.kind = EntryKind::Text;
    QWidget window;
    window.resize(900, 600);
    window.show();
    Keypad russian(request, {PanelTheme::of(PanelThemeKind::Light), &texts, QStringLiteral("ru")}, &window);
    russian.show();
    const auto shown = [&](const QString& letter) {
        for (QPushButton* button : russian.findChildren<QPushButton*>())
            if (button->text() == letter) return !button->isHidden();
        return false;
    };
    EXPECT_TRUE(shown("ж"));
    EXPECT_FALSE(shown("q"));
    auto* script = russian.findChild<QPushButton*>("script");
    ASSERT_TRUE(script);
    QTest::mouseClick(script, Qt::LeftButton);
    EXPECT_TRUE(shown("q"));
    EXPECT_FALSE(shown("ж"));
    EXPECT_TRUE(letterRows("de").isEmpty());
    EXPECT_FALSE(letterRows("ar").isEmpty());
}

TEST(OperatorLanguage, TheLanguageThatWasChosenLastComesBack) {
    const QTemporaryDir folder;
    PanelProject project = machineProject();
    project.folder = folder.path();
    {
        PanelPlayer player(project, nullptr);
        player.keepLanguageInProject();
        emit player.scene().languageRequested(QStringLiteral("da"));
        EXPECT_EQ(player.language().toStdString(), "da");
    }
    PanelPlayer again(project, nullptr);
    EXPECT_EQ(again.language().toStdString(), "en");
    again.keepLanguageInProject();
    EXPECT_EQ(again.language().toStdString(), "da");
    // Started in another one (panel --play --language): this time, and the choice stays the operator's.
    PanelPlayer arabic(project, nullptr);
    arabic.keepLanguageInProject(QStringLiteral("ar"));
    EXPECT_EQ(arabic.language().toStdString(), "ar");
    PanelPlayer after(project, nullptr);
    after.keepLanguageInProject();
    EXPECT_EQ(after.language().toStdString(), "da");
    emit arabic.scene().languageRequested(QStringLiteral("en"));
    PanelPlayer chosen(project, nullptr);
    chosen.keepLanguageInProject();
    EXPECT_EQ(chosen.language().toStdString(), "en");
}

} // namespace
} // namespace plc::hmi
