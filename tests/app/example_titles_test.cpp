// The start page speaks the language of the studio: each example's title and its sentence are translated and fit.
#include "app/settings/translation.h"
#include "app/start/example_titles.h"
#include "app/start/start_page.h"
#include "tests/app/studio_fixture.h"

#include <QFontMetrics>
#include <QJsonDocument>
#include <QJsonObject>
#include <QListWidget>
#include <QTranslator>

namespace plc::app {
namespace {

QStringList titles() {
    QStringList out;
    const QDir folder(StartPage::examplesFolder());
    for (const QString& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(folder.filePath(name + "/project.json"));
        if (file.open(QIODevice::ReadOnly))
            out << QJsonDocument::fromJson(file.readAll()).object().value("name").toString();
    }
    return out;
}

TEST(ExampleTitles, AreInEveryLanguage) {
    const QStringList all = titles();
    ASSERT_GT(all.size(), 40);
    for (const QString& language : translatedLanguages()) {
        if (language == "en") continue;
        QTranslator texts;
        ASSERT_TRUE(texts.load(":/translations/stepwise_" + language + ".qm"));
        for (const QString& title : all)
            EXPECT_FALSE(texts.translate("Examples", title.toUtf8().constData()).isEmpty())
                << language.toStdString() << ": “" << title.toStdString()
                << "”; list it in app/start/example_titles.cpp";
    }
}

TEST(ExampleTitles, HaveASentenceInEveryLanguage) {
    for (const QString& title : titles()) {
        const QString english = exampleSummary(title);
        EXPECT_FALSE(english.isEmpty()) << "“" << title.toStdString() << "”: write it in app/start/example_titles.cpp";
        for (const QString& language : translatedLanguages()) {
            if (language == "en") continue;
            installTranslation(*qApp, language);
            const QString shown = exampleSummary(title);
            EXPECT_NE(shown, english) << language.toStdString();
        }
        installTranslation(*qApp, "en");
    }
    EXPECT_EQ(exampleSummary("My machine"), QString());
}

/// The cards paint three lines and cut the rest off.
TEST(ExampleTitles, FitOnTheirCards) {
    for (const QString& language : translatedLanguages()) {
        installTranslation(*qApp, language);
        Settings settings;
        StartPage page(settings);
        QListWidget& cards = page.examples();
        const QFontMetrics font(cards.font());
        QFont bold = cards.font();
        bold.setBold(true);
        const int width = cards.sizeHintForIndex(cards.model()->index(0, 0)).width() - 14 - 24;
        for (int row = 0; row < cards.count(); ++row) {
            const QListWidgetItem* item = cards.item(row);
            const QString summary = item->data(Qt::UserRole + 2).toString();
            const QRect needed = font.boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, summary);
            EXPECT_LE(needed.height(), 3 * font.lineSpacing() + 1)
                << language.toStdString() << ": " << summary.toStdString();
            EXPECT_LE(font.horizontalAdvance(summary), width * 2.8) << language.toStdString() << summary.toStdString();
            EXPECT_LE(QFontMetrics(bold).horizontalAdvance(item->text()), width)
                << language.toStdString() << ": " << item->text().toStdString();
        }
    }
    installTranslation(*qApp, "en");
}

TEST(ExampleTitles, AreWrittenOnTheCards) {
    installTranslation(*qApp, "de");
    EXPECT_EQ(exampleTitle("Traffic light"), "Ampel");
    EXPECT_EQ(exampleTitle("My machine"), "My machine") << "a project of the user";
    Settings settings;
    StartPage page(settings);
    bool isShown = false;
    for (const QListWidget* list : page.findChildren<QListWidget*>())
        isShown = isShown || !list->findItems("Ampel", Qt::MatchExactly).isEmpty();
    EXPECT_TRUE(isShown);
    installTranslation(*qApp, "en");
}

} // namespace
} // namespace plc::app
