// What runtime and projects say in English reads German and Danish in the window, on the panel and in the log.
#include "app/panels/live_views.h"
#include "app/settings/translation.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/errors.h"
#include "editor/kit/message_text.h"
#include "editor/kit/occurrence_text.h"
#include "hmi/model/errors.h"
#include "hmi/player/player_status.h"
#include "runtime/controller/fault_report.h"
#include "runtime/diagnostics/diagnostic.h"
#include "runtime/inside/texts.h"
#include "tests/app/studio_fixture.h"

#include <QLocale>
#include <QToolButton>
#include <QTreeWidget>

namespace plc::app {
namespace {

using image::FaultCode;
using messages::Form;
using messages::ParameterKind;

/// Every row of every list that a reader's language is used for.
const Form* const kForms[] = {
#define PLC_DIAGNOSTIC(Row, Severity, Code, Text, ...) &findings::Row,
#include "runtime/diagnostics/diagnostics.def"
#define PLC_MESSAGE(Row, ...) &fixes::Row,
#include "runtime/diagnostics/fixes.def"
#define PLC_MESSAGE(Row, ...) &notes::Row,
#include "runtime/diagnostics/notes.def"
#define PLC_MESSAGE(Row, ...) &phrases::Row,
#include "runtime/base/phrases.def"
#define PLC_MESSAGE(Row, ...) &errors::Row,
#include "runtime/base/messages.def"
#define PLC_MESSAGE(Row, ...) &errors::Row,
#include "editor/kit/errors.def"
#define PLC_MESSAGE(Row, ...) &errors::Row,
#include "hmi/model/errors.def"
#define PLC_MESSAGE(Row, ...) &inside::texts::Row,
#include "runtime/inside/texts.def"
};

/// An argument that is found again in the text: "<0>", or 70 for the number of parameter 0.
messages::Argument sample(ParameterKind kind, size_t index) {
    const std::string mark = "<" + std::to_string(index) + ">";
    switch (kind) {
    case ParameterKind::Integer:
        return static_cast<int64_t>(70 + index);
    case ParameterKind::Real:
        return 70.5 + static_cast<double>(index);
    case ParameterKind::Names:
        return std::vector<std::string>{mark};
    case ParameterKind::Nested:
    case ParameterKind::Phrase:
        return std::make_shared<const Message>(errors::Plainly(mark));
    case ParameterKind::Name:
    case ParameterKind::Path:
    case ParameterKind::Thing:
        return mark;
    }
    return mark;
}

QString shownMark(ParameterKind kind, size_t index, const char* language) {
    if (kind == ParameterKind::Integer) return QString::number(70 + index);
    if (kind == ParameterKind::Real)
        return QLocale(QString::fromLatin1(language)).toString(70.5 + static_cast<double>(index)); // its decimal sign
    return QStringLiteral("<%1>").arg(index);
}

TEST(MessageText, EveryMessageShowsItsArgumentsInEveryLanguage) {
    for (const Form* form : kForms) {
        std::vector<messages::Argument> arguments;
        for (size_t i = 0; i < form->count; ++i) arguments.push_back(sample(form->parameters[i], i));
        const Message message(*form, arguments);
        for (const char* language : {"en", "de", "da", "fr", "es", "zh-CN"}) {
            const QString shown = kit::messageText(message, language);
            EXPECT_FALSE(shown.isEmpty()) << form->name << ' ' << language;
            EXPECT_FALSE(shown.contains(u'{') || shown.contains(u'|')) << language << ": " << shown.toStdString();
            for (size_t i = 0; i < form->count; ++i) {
                if (!QString::fromUtf8(form->text).contains(QStringLiteral("{%1}").arg(i))) continue; // chooses only
                EXPECT_TRUE(shown.contains(shownMark(form->parameters[i], i, language)))
                    << form->name << ' ' << language << ": " << shown.toStdString();
            }
        }
    }
}

TEST(MessageText, EveryMessageComesBackFromARecording) {
    for (const Form* form : kForms) {
        if (std::string_view(form->context) != "Errors") continue;
        std::vector<messages::Argument> arguments;
        for (size_t i = 0; i < form->count; ++i) arguments.push_back(sample(form->parameters[i], i));
        const Message message(*form, arguments);
        EXPECT_EQ(errors::unpacked(errors::packed(message)).english(), message.english()) << form->name;
    }
    EXPECT_EQ(errors::unpacked("warm").english(), "warm") << "of an older recording";
    EXPECT_EQ(errors::unpacked("\x02"
                               "7:Nothing")
                  .english(),
              "\x02"
              "7:Nothing")
        << "damaged: shown as it is";
    EXPECT_EQ(errors::unpacked(errors::packed(errors::InSimulation(errors::DivisionByZero()))),
              errors::InSimulation(errors::DivisionByZero()));
}

TEST(MessageText, EveryFaultIsTranslated) {
    for (int code = static_cast<int>(FaultCode::DivisionByZero); code <= static_cast<int>(FaultCode::Stopped); ++code) {
        image::RuntimeContext context{};
        context.fault = static_cast<FaultCode>(code);
        context.faultDetail[0] = 7;
        context.faultDetail[1] = 1;
        for (const int last : {0, 5}) {
            context.faultDetail[2] = last;
            const Message fault = controller::faultMessage(context);
            for (const char* language : {"de", "da", "fr", "es", "zh-CN"}) {
                const QString shown = kit::messageText(fault, language);
                EXPECT_NE(shown.toStdString(), fault.english()) << language;
                EXPECT_EQ(shown.contains(u'7'), fault.english().find('7') != std::string::npos) << shown.toStdString();
            }
            if (context.fault == FaultCode::Stopped) continue; // somebody did that: there is nothing to do
            for (const char* language : {"en", "de", "da", "fr", "es", "zh-CN"}) {
                const QString shown = kit::messageText(fault, language), briefly = kit::occurrenceText(fault, language);
                EXPECT_TRUE(shown.startsWith(briefly)) << briefly.toStdString();
                EXPECT_LT(briefly.size() + 5, shown.size()) << shown.toStdString();
                EXPECT_GE(briefly.size(), 3) << shown.toStdString();
                EXPECT_FALSE(briefly.contains(u';') || briefly.contains(u'；')) << briefly.toStdString();
                EXPECT_EQ(briefly, briefly.trimmed());
            }
        }
    }
}

TEST(MessageText, WhatHappenedKeepsTheNamesAsTheyAre) {
    EXPECT_EQ(kit::occurrenceText(errors::NoVariable(std::string("a; b")), "en"), "there is no variable 'a; b'");
    EXPECT_EQ(kit::occurrenceText(Error{errors::DivisionByZero(), "Main.x"}, "de"), "Main.x: Division durch null");
    EXPECT_EQ(kit::occurrenceText(errors::InSimulation(errors::DivisionByZero()), "en"),
              "simulation: division by zero");
}

TEST(MessageText, PlacesAndWhatTheSystemSaysAreKeptAndTranslated) {
    const Error error{errors::FileNotWritten(errors::ofSystem(EACCES)), "/a/b.st"};
    EXPECT_EQ(kit::messageText(error, "de"),
              QString("/a/b.st: Die Datei kann nicht geschrieben werden: keine Berechtigung; prüfen Sie die Rechte der "
                      "Datei und ihres Ordners"));
    EXPECT_EQ(kit::messageText(errors::About(std::string("Main.x"), errors::ConstantNotWritten()), "de"),
              QString("Main.x: eine Konstante kann nicht geschrieben werden; ändern Sie sie im Programm"));
    EXPECT_EQ(kit::messageText(errors::NoVariableSuggest(std::string("a{0}b"), std::string("ab")), "de"),
              QString("es gibt keine Variable „a{0}b“; meinten Sie „ab“?"));
    EXPECT_EQ(kit::messageText(error, "en").toStdString(), error.english());
    EXPECT_EQ(kit::messageText(errors::PartCount(std::string("a"), 1, 2), "de"),
              QString("a hat 1 Teil, der Wert hat 2; schreiben Sie für jedes Teil einen Wert"));
    EXPECT_EQ(kit::messageText(errors::PartCount(std::string("a"), 3, 2), "de"),
              QString("a hat 3 Teile, der Wert hat 2; schreiben Sie für jedes Teil einen Wert"));
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
            isOnButton |= button->isVisible() && button->text() == "Division durch null" &&
                          button->toolTip().contains("prüfen Sie zuerst den Divisor");
        return isOnButton;
    }));
    EXPECT_TRUE(waitFor([&] {
        for (auto* tree : window->log().findChildren<QTreeWidget*>())
            for (int i = 0; i < tree->topLevelItemCount(); ++i)
                if (tree->topLevelItem(i)->text(3).contains(": Division durch null")) return true; // the place follows
        return false;
    }));
    const auto* strip = window->live().player()->findChild<hmi::PlayerStatus*>();
    ASSERT_NE(strip, nullptr);
    EXPECT_TRUE(waitFor([&] { return strip->stateText().endsWith(": Division durch null"); }))
        << strip->stateText().toStdString();
}

TEST_F(GermanStudioTest, ARefusalReadsGerman) {
    const auto refused = window->control().parse("Main.nothing", "1");
    ASSERT_FALSE(refused);
    EXPECT_EQ(kit::messageText(refused.error()), QString("Die Steuerung läuft nicht; drücken Sie F5"));
    window->watch().setExpressions({"Main.nothing"});
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 1; }));
    const QString reason = window->control().value("Main.nothing").reason;
    EXPECT_FALSE(reason.isEmpty());
    EXPECT_FALSE(reason.contains(" is ")) << reason.toStdString();
}

} // namespace
} // namespace plc::app
