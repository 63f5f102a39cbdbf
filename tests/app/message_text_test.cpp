// What runtime and projects say in English reads German and Danish in the window, on the panel and in the log.
#include "app/live_views.h"
#include "app/translation.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/message_text.h"
#include "hmi/player/player_status.h"
#include "runtime/controller/fault_report.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/paths.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QToolButton>
#include <QTreeWidget>

namespace plc::app {
namespace {

using image::FaultCode;

TEST(MessageText, EveryFaultIsTranslated) {
    for (int code = static_cast<int>(FaultCode::DivisionByZero); code <= static_cast<int>(FaultCode::Stopped); ++code) {
        image::RuntimeContext context{};
        context.fault = static_cast<FaultCode>(code);
        context.faultDetail[0] = 7;
        context.faultDetail[1] = 1;
        for (const int last : {0, 5}) {
            context.faultDetail[2] = last;
            const std::string english = controller::faultMessage(context);
            for (const char* language : {"de", "da"}) {
                const QString shown = kit::messageText(english, language);
                EXPECT_NE(shown, QString::fromStdString(english)) << language;
                EXPECT_FALSE(shown.contains('{')) << shown.toStdString();
                EXPECT_EQ(shown.contains(u'7'), english.find('7') != std::string::npos) << shown.toStdString();
            }
        }
    }
}

TEST(MessageText, PlacesAndWhatTheSystemSaysAreKeptAndTranslated) {
    const Error error{"The file can not be written: Permission denied; check the permissions of the folder", "/a/b.st"};
    EXPECT_EQ(kit::messageText(error, "de"),
              QString("/a/b.st: Die Datei kann nicht geschrieben werden: keine Berechtigung; prüfen Sie die Rechte des "
                      "Ordners"));
    EXPECT_EQ(kit::messageText("Main.x: a constant can not be written", "de"),
              "Main.x: eine Konstante kann nicht geschrieben werden");
    EXPECT_EQ(kit::messageText("there is no variable 'a{0}b'; did you mean 'ab'?", "de"),
              QString("es gibt keine Variable „a{0}b“; meinten Sie „ab“?"));
    EXPECT_EQ(kit::messageText("something that nobody says", "de"), "something that nobody says");
    EXPECT_EQ(kit::messageText(error, "en"), QString::fromStdString(error.text()));
}

/// The texts between the quotes of an Error{…}.
QStringList textsOf(const QString& source, qsizetype at) {
    QStringList texts;
    for (int depth = 0; at < source.size(); ++at) {
        const QChar c = source[at];
        if (c == '{') ++depth;
        if (c == '}' && --depth == 0) break;
        if (c == '\'' && source.mid(at, 3).endsWith('\'')) at += 2;
        if (c != '"') continue;
        QString text;
        for (++at; at < source.size() && source[at] != '"'; ++at) {
            text += source[at];
            if (source[at] == '\\') text += source[++at];
        }
        texts << text;
    }
    return texts;
}

TEST(MessageText, EveryErrorOfTheLowerLayersIsInTheList) {
    QFile file(QString::fromStdString(plc::sourceDir() + "/runtime/base/messages.def"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString list = QString::fromUtf8(file.readAll());
    int checked = 0;
    for (const char* folder : {"/runtime", "/projects"})
        for (QDirIterator it(QString::fromStdString(plc::sourceDir()) + folder, {"*.cpp"}, QDir::Files,
                             QDirIterator::Subdirectories);
             it.hasNext();) {
            QFile source(it.next());
            ASSERT_TRUE(source.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(source.readAll());
            for (qsizetype at = text.indexOf("Error{"); at >= 0; at = text.indexOf("Error{", at + 1))
                for (const QString& said : textsOf(text, at + 5)) {
                    if (said.size() < 6) continue;
                    ++checked;
                    EXPECT_TRUE(list.contains(said)) << it.filePath().toStdString() << ": " << said.toStdString();
                }
        }
    EXPECT_GT(checked, 60);
}

class GermanStudioTest : public StudioTest {
protected:
    void SetUp() override {
        installTranslation(*qApp, "de");
        StudioTest::SetUp();
    }
    void TearDown() override {
        StudioTest::TearDown();
        installTranslation(*qApp, "en");
    }
};

TEST_F(GermanStudioTest, ADivisionByZeroReadsGermanEverywhere) {
    ASSERT_TRUE(window->live().addPanel("overview"));
    typeAtEnd("counter := counter / (limit - limit);");
    analysed();
    window->live().player()->setLanguage("de");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Fault; }));
    bool isOnButton = false;
    ASSERT_TRUE(waitFor([&] {
        for (auto* button : window->findChildren<QToolButton*>())
            isOnButton |= button->isVisible() && button->text() == "Division durch Null";
        return isOnButton;
    }));
    EXPECT_TRUE(waitFor([&] {
        for (auto* tree : window->log().findChildren<QTreeWidget*>())
            for (int i = 0; i < tree->topLevelItemCount(); ++i)
                if (tree->topLevelItem(i)->text(3).endsWith(": Division durch Null")) return true;
        return false;
    }));
    const auto* strip = window->live().player()->findChild<hmi::PlayerStatus*>();
    ASSERT_NE(strip, nullptr);
    EXPECT_TRUE(waitFor([&] { return strip->stateText().endsWith(": Division durch Null"); }))
        << strip->stateText().toStdString();
}

TEST_F(GermanStudioTest, ARefusalReadsGerman) {
    const auto refused = window->control().parse("Main.nothing", "1");
    ASSERT_FALSE(refused);
    EXPECT_EQ(kit::messageText(refused.error()), QString("Die Steuerung läuft nicht"));
    window->watch().setExpressions({"Main.nothing"});
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 1; }));
    const QString reason = window->control().value("Main.nothing").reason;
    EXPECT_FALSE(reason.isEmpty());
    EXPECT_FALSE(reason.contains(" is ")) << reason.toStdString();
}

} // namespace
} // namespace plc::app
