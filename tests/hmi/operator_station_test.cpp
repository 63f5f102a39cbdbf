// What an operator does and what comes of it, with no window anywhere: the logic that the Qt player and a browser's
// panel share.
#include "running.h"
#include "tests/support/patience.h"

#include "hmi/people/password.h"
#include "hmi/station/operator_station.h"
#include "hmi/station/plc_convert.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace plc::hmi {
namespace {

using std::chrono_literals::operator""s;

struct Operated : testing::Test {
    PanelProject project = machineProject();
    session::Session session{builtMachine()};
    std::unique_ptr<OperatorStation> station;
    Moment now{1000s};

    void TearDown() override { EXPECT_TRUE(QApplication::allWidgets().isEmpty()) << "a widget was made"; }

    void addPanel(const char* name, const std::string& fields) {
        Result<Panel> panel = Panel::parse("{\"size\": [640, 400], " + fields + "}", QLatin1String(name));
        ASSERT_TRUE(panel);
        project.panels.push_back({QLatin1String(name), *panel});
    }
    void start(bool run = true) {
        station = std::make_unique<OperatorStation>(project, &session);
        if (run) session.startThread({session::Pace::Factor, 5});
    }
    /// Lets scan and alarms go on until something is so; at most a minute. The operator's clock stands still.
    template <class Condition> bool waitFor(Condition condition) {
        return QTest::qWaitFor(
            [&] {
                station->frame(now);
                return condition();
            },
            kPatience);
    }
    bool waitFor(const char* expression) {
        const BindingId id = station->values()->bind(QLatin1String(expression));
        return waitFor([&] { return station->values()->value(id).toBool(); });
    }
    QString write(const char* target, const Value& value, WriteKind kind = WriteKind::Write) {
        return station->post(
            WriteRequest{QStringLiteral("e"), QLatin1String(target), kind, value, Value::ofBool(false)});
    }
};

TEST(PanelValues, TextsAreThoseOfTheProjectsStrings) {
    const QString pump = QStringLiteral("\u041D\u0430\u0441\u043E\u0441");
    for (const auto& [code, bytes] :
         {std::pair{types::StringCode::Windows1251, std::string("\xCD\xE0\xF1\xEE\xF1")},
          std::pair{types::StringCode::Utf8, std::string("\u041D\u0430\u0441\u043E\u0441")}}) {
        types::TypeTable types;
        types.strings = code;
        const types::TypeId type = types.string(10);
        const auto written = toPlc(types, type, Value::ofText(pump));
        ASSERT_TRUE(written) << written.error().english();
        EXPECT_EQ(std::get<std::string>(written->data), bytes);
        EXPECT_EQ(toPanel(types, *written).text(), pump);
    }
    types::TypeTable types;
    types.strings = types::StringCode::Windows1251;
    const auto refused = toPlc(types, types.string(10), Value::ofText(QStringLiteral("\u03A9")));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().english(),
              "STRING contains characters of Windows-1251 only; declare the variable as WSTRING");
    types.strings = types::StringCode::Utf8; // ten bytes
    EXPECT_FALSE(toPlc(types, types.string(9), Value::ofText(pump)));
}

TEST_F(Operated, EveryRefusalOfAWriteHasItsReasonInTheOperatorsLanguage) {
    start(false);
    QSignalSpy refused(station.get(), &OperatorStation::writeRefused);
    EXPECT_EQ(write("Main.start", Value::ofBool(true)).toStdString(), "Not written: the controller is not running.");
    session.startThread({session::Pace::Factor, 5});
    ASSERT_TRUE(waitFor("Main.count > 2"));
    EXPECT_EQ(write("Main.small", Value::ofInteger(300)).toStdString(),
              "Not written: the value is outside its limits. -128 to 127");
    station->setLanguage(QStringLiteral("da"));
    EXPECT_EQ(write("Main.name", Value::ofText(QStringLiteral("Too long"))).toStdString(),
              "Ikke skrevet: højst 5 tegn.");
    station->setLanguage(QStringLiteral("en"));
    station->setRights(
        [](const ElementId& element) { return element == "e" ? QStringLiteral("operator") : QString(); });
    EXPECT_EQ(write("Main.start", Value::ofBool(true)).toStdString(), "Only for: operator");
    station->setRights({});
    station->setLocked(true);
    const QString locked = write("Main.start", Value::ofBool(true));
    EXPECT_EQ(locked, station->say(SystemText::LogInFirst));
    station->setLocked(false);
    EXPECT_EQ(refused.size(), 5);
    EXPECT_EQ(station->refusal(), locked);
    station->frame(now);
    station->frame(now + 3s);
    EXPECT_EQ(station->refusal(), locked);
    station->frame(now + 5s);
    EXPECT_TRUE(station->refusal().isEmpty());
    EXPECT_TRUE(waitFor("NOT Main.start AND Main.small = 0 AND Main.presses = 0")); // nothing came through
}

TEST_F(Operated, AConfirmationAsksInTheOperatorsWordsAndNumbers) {
    addPanel(
        "main",
        R"("elements": [{"id":"e","kind":"numberEntry","rect":[0,0,90,40],"title":"Speed","target":"Main.small"}])");
    start();
    const ConfirmRequest request{
        {}, {QStringLiteral("e"), QStringLiteral("main.SMALL"), WriteKind::Write, Value::ofReal(55.5), {}}, false};
    EXPECT_EQ(station->questionFor(request).toStdString(), "Write 55.5 to Speed?");
    station->setLanguage(QStringLiteral("da"));
    EXPECT_EQ(station->questionFor(request).toStdString(), "Skriv 55,5 til Speed?");
    ConfirmRequest unnamed = request;
    unnamed.write.target = QStringLiteral("Main.count");
    EXPECT_EQ(station->questionFor(unnamed).toStdString(), "Skriv 55,5 til Main.count?");
    unnamed.question = QStringLiteral("Sure?");
    EXPECT_EQ(station->questionFor(unnamed).toStdString(), "Sure?");
}

TEST_F(Operated, AMomentaryPressIsSeenByAScanHoweverShortItIsAndComesUpAgain) {
    start();
    ASSERT_TRUE(waitFor("Main.count > 2"));
    EXPECT_EQ(write("Main.start", Value::ofBool(true), WriteKind::Press), "");
    EXPECT_EQ(write("Main.start", {}, WriteKind::Release), ""); // at once
    EXPECT_TRUE(waitFor("Main.presses = 1 AND NOT Main.start"));
    station->confirmed(WriteRequest{QStringLiteral("e"), QStringLiteral("Main.start"), WriteKind::Press,
                                    Value::ofBool(true), Value::ofBool(false)},
                       QStringLiteral("confirmed"));
    EXPECT_TRUE(waitFor("Main.presses = 2 AND NOT Main.start"));
}

TEST_F(Operated, TheLanguageIsWrittenToTheProgramAndFollowsIt) {
    start();
    ASSERT_TRUE(waitFor("Main.count > 2"));
    station->requestLanguage(QStringLiteral("da"));
    EXPECT_EQ(station->language().toStdString(), "da"); // at once, though the scan has not seen it
    EXPECT_TRUE(waitFor("Language = 1"));
    EXPECT_EQ(station->language().toStdString(), "da");
    EXPECT_EQ(write("Language", Value::ofInteger(2)), "");
    EXPECT_TRUE(waitFor([&] { return station->language() == QStringLiteral("ar"); }));
    station->requestLanguage(QStringLiteral("fr")); // no language of this project
    EXPECT_EQ(station->language().toStdString(), "ar");
}

TEST_F(Operated, OneOfSeveralPeopleKeepsTheirOwnLanguage) {
    start();
    ASSERT_TRUE(waitFor("Main.count > 2"));
    station->setOwnLanguage(true);
    station->requestLanguage(QStringLiteral("da"));
    EXPECT_EQ(write("Language", Value::ofInteger(2)), "");
    ASSERT_TRUE(waitFor("Language = 2"));
    EXPECT_EQ(station->language().toStdString(), "da");
}

TEST_F(Operated, StationsOfOneControllerShareTheAlarmsThatOneOfThemKeeps) {
    start();
    OperatorStation other(project, &session);
    other.shareAlarms(*station);
    EXPECT_EQ(&other.alarms(), &station->alarms());
    ASSERT_TRUE(waitFor("Main.count > 2"));
    EXPECT_EQ(write("Main.overload", Value::ofBool(true)), "");
    ASSERT_TRUE(waitFor([&] {
        return station->alarms().indexOf(QStringLiteral("over")) >= 0 &&
               !station->alarms().present({}, AlarmOrder::Time).empty() && station->alarms().unacknowledgedCount() > 0;
    }));
    other.setLocked(true);
    other.acknowledge(AcknowledgeRequest{});
    EXPECT_EQ(other.refusal(), other.say(SystemText::LogInFirst));
    other.setLocked(false);
    ASSERT_TRUE(waitFor("Main.count > 60")); // the one-scan alarm has come and gone, too
    station->alarmWatch()->catchUp();
    other.acknowledge(AcknowledgeRequest{});
    EXPECT_TRUE(waitFor([&] { return station->alarms().unacknowledgedCount() == 0; }));
    other.act(AlarmAction::ShelveShort, QStringLiteral("over"));
    EXPECT_TRUE(station->alarms().present({}, AlarmOrder::Time).empty()); // set aside for both
    station->act(AlarmAction::PutBack, QStringLiteral("over"));
    EXPECT_EQ(other.alarms().present({}, AlarmOrder::Time).size(), 1u);
}

TEST_F(Operated, SomebodyLogsInBySignatureAndIsLoggedOutWhenTheyAreGone) {
    const QTemporaryDir folder;
    project.folder = folder.path();
    project.people.setRole({QStringLiteral("operator"), {}, QStringLiteral("second")});
    project.people.setUser({QStringLiteral("anna"), {QStringLiteral("operator")}, *hashOf(QStringLiteral("4711"))});
    addPanel("main", "\"elements\": []");
    addPanel("second", "\"elements\": []");
    project.startPanel = QStringLiteral("main");
    start();
    ASSERT_TRUE(waitFor("Main.count > 2"));
    QSignalSpy users(station.get(), &OperatorStation::userChanged);
    EXPECT_EQ(station->users(), QStringList{"anna"});
    EXPECT_EQ(station->logIn(QStringLiteral("anna"), QStringLiteral("1"), now), LogIn::Answer::Wrong);
    EXPECT_EQ(station->refusal(), station->say(SystemText::WrongPassword));
    EXPECT_TRUE(users.isEmpty());
    EXPECT_EQ(station->logIn(QStringLiteral("anna"), QStringLiteral("4711"), now), LogIn::Answer::Good);
    EXPECT_EQ(station->navigation().current().panel.toStdString(), "second"); // where her role starts
    const WriteRequest critical{
        QStringLiteral("e"), QStringLiteral("Main.level"), WriteKind::Write, Value::ofReal(3), {}};
    station->sign(critical, QStringLiteral("wrong"), now);
    EXPECT_EQ(station->refusal(), station->say(SystemText::WrongPassword));
    EXPECT_TRUE(waitFor("Main.level = 12.5"));
    station->sign(critical, QStringLiteral("4711"), now);
    EXPECT_TRUE(waitFor("Main.level = 3.0"));
    station->logOut();
    EXPECT_EQ(users.size(), 2);
    EXPECT_FALSE(station->people().isLoggedIn());
    const Result<AuditRead> trail = readAudit(folder.filePath(QStringLiteral(".stepwise/audit.csv")));
    ASSERT_TRUE(trail);
    QStringList actions;
    for (const AuditEntry& one : trail->entries) actions += one.action;
    EXPECT_EQ(actions.join(QStringLiteral(", ")).toStdString(),
              "log in refused, log in, signature refused, write, log out");
    EXPECT_EQ(trail->entries[3].comment.toStdString(), "signed by anna");
}

TEST_F(Operated, AHighScreenAndAFrameHaveTheirPanels) {
    addPanel("main", R"("portrait": "high", "framed": true, "elements": [])");
    addPanel("high", R"("framed": false, "elements": [])");
    addPanel("frame", R"("elements": [])");
    project.frame = QStringLiteral("frame");
    project.startPanel = QStringLiteral("main");
    start(false);
    const OperatorStation::Shown wide = station->shown(false), high = station->shown(true);
    EXPECT_EQ(wide.name.toStdString(), "main");
    ASSERT_TRUE(wide.frame);
    EXPECT_EQ(wide.frame->name.toStdString(), "frame");
    EXPECT_EQ(high.name.toStdString(), "high");
    EXPECT_FALSE(high.frame);
    EXPECT_TRUE(station->setPanelName(QStringLiteral("main")));
    EXPECT_FALSE(station->setPanelName(QStringLiteral("main")));
}

TEST_F(Operated, ThePastIsShownAndNotWritten) {
    start();
    ASSERT_TRUE(waitFor("Main.count > 20"));
    EXPECT_EQ(station->state().text, "");
    const BindingId count = station->values()->bind(QStringLiteral("Main.count"));
    station->setPosition(9);
    station->frame(now);
    EXPECT_EQ(station->values()->value(count).toLiteral().toStdString(), "10");
    EXPECT_EQ(station->alarmPosition(), std::optional<quint64>(9));
    EXPECT_EQ(station->state().weight, StateWeight::Notice);
    EXPECT_FALSE(station->state().text.isEmpty());
    EXPECT_EQ(write("Main.start", Value::ofBool(true)), station->say(SystemText::InThePast));
    station->setPosition({});
    EXPECT_EQ(write("Main.start", Value::ofBool(true)), "");
    QSignalSpy leaving(station.get(), &OperatorStation::sourcesAboutToChange);
    station->setRun(nullptr);
    EXPECT_EQ(leaving.size(), 1);
    EXPECT_EQ(station->values(), nullptr);
    EXPECT_EQ(station->state().weight, StateWeight::Quiet);
    EXPECT_EQ(write("Main.start", Value::ofBool(true)), station->say(SystemText::NoController));
}

} // namespace
} // namespace plc::hmi
