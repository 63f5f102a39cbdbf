// The start page speaks the language of the studio: each example's title is translated.
#include "app/example_titles.h"
#include "app/start_page.h"
#include "app/translation.h"
#include "tests/app/studio_fixture.h"

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
                << language.toStdString() << ": “" << title.toStdString() << "”; list it in app/example_titles.cpp";
    }
}

TEST(ExampleTitles, AreWrittenOnTheCards) {
    installTranslation(*qApp, "de");
    EXPECT_EQ(exampleTitle("Traffic light"), "Ampel");
    EXPECT_EQ(exampleTitle("My machine"), "My machine") << "a project of the user";
    Settings settings;
    const StartPage page(settings);
    bool isShown = false;
    for (const QListWidget* list : page.findChildren<QListWidget*>())
        isShown = isShown || !list->findItems("Ampel", Qt::MatchExactly).isEmpty();
    EXPECT_TRUE(isShown);
    installTranslation(*qApp, "en");
}

} // namespace
} // namespace plc::app
