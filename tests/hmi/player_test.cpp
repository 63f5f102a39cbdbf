// Panels on a running controller: press, see, be refused with a reason, switch language, alarms, the past.
#include "running.h"

#include "hmi/player/keypad.h"
#include "hmi/player/player_status.h"
#include "tests/support/patience.h"
#include "tests/support/settle.h"

#include <QPushButton>
#include <QSignalSpy>

namespace plc::hmi {
namespace {

struct Machine {
    PanelProject project = machineProject();
    session::Session session{builtMachine()};
    std::unique_ptr<PanelPlayer> player;

    explicit Machine(const std::string& elements, bool run = true) {
        project.panels.push_back({QStringLiteral("main"), panelOf(elements)});
        project.startPanel = QStringLiteral("main");
        player = std::make_unique<PanelPlayer>(project, &session);
        player->resize(640, 400);
        player->show();
        if (run) session.startThread({session::Pace::Factor, 5});
    }
    Value value(const char* expression) {
        const BindingId id = player->values()->bind(QString::fromUtf8(expression));
        player->frame();
        return player->values()->value(id);
    }
    bool waitFor(const char* expression) {
        const BindingId id = player->values()->bind(QString::fromUtf8(expression));
        return hmi::waitFor(*player, [&] { return player->values()->value(id).toBool(); });
    }
    QString write(const char* target, const Value& value) {
        return player->post(WriteRequest{{}, QLatin1String(target), WriteKind::Write, value, {}});
    }
};

TEST(Player, AButtonPressedOnThePanelRunsTheMachineAndTheLampShowsIt) {
    Machine machine(R"({"id":"b","kind":"button","rect":[10,10,120,60],"text":"@start","target":"Main.start"},
                       {"id":"l","kind":"lamp","rect":[200,10,60,60],"value":"Main.running"})");
    ASSERT_TRUE(machine.waitFor("Main.count > 2"));
    const QImage dark = machine.player->scene().picture().copy(200, 10, 60, 60);
    for (int press = 1; press <= 3; ++press) {
        QTest::mousePress(&machine.player->view(), Qt::LeftButton, {}, QPoint(60, 40));
        QTest::mouseRelease(&machine.player->view(), Qt::LeftButton, {}, QPoint(60, 40)); // quicker than a scan
        ASSERT_TRUE(machine.waitFor(QStringLiteral("Main.presses = %1").arg(press).toLatin1().constData())) << press;
    }
    EXPECT_TRUE(machine.waitFor("Main.running AND NOT Main.start"));
    EXPECT_NE(dark, machine.player->scene().picture().copy(200, 10, 60, 60));
}

TEST(Player, SaysWhyAWriteIsRefused) {
    Machine machine(R"({"id":"l","kind":"lamp","rect":[200,10,60,60],"value":"Main.running"})", false);
    EXPECT_EQ(machine.write("Main.start", Value::ofBool(true)).toStdString(),
              "Not written: the controller is not running.");
    machine.session.startThread({session::Pace::Factor, 5});
    ASSERT_TRUE(machine.waitFor("Main.count > 2"));
    EXPECT_EQ(machine.write("Main.small", Value::ofInteger(300)).toStdString(),
              "Not written: the value is outside its limits. -128 to 127");
    EXPECT_EQ(machine.write("Main.count + 1", Value::ofInteger(3)).toStdString(),
              "Not written: this is not a variable.");
    EXPECT_FALSE(machine.write("Main.cuont", Value::ofInteger(3)).isEmpty());
    machine.session.force("Main.forced", types::Value{types::TypeTable::of(types::TypeKind::Bool), int64_t(1)});
    ASSERT_TRUE(machine.waitFor("Main.forced"));
    machine.player->setLanguage(QStringLiteral("da"));
    EXPECT_EQ(machine.write("Main.forced", Value::ofBool(false)).toStdString(), "Ikke skrevet: Variablen er forceret.");
    EXPECT_EQ(machine.player->lastRefusal().toStdString(), "Ikke skrevet: Variablen er forceret.");
    EXPECT_TRUE(machine.write("Main.small", Value::ofInteger(-100)).isEmpty());
    EXPECT_TRUE(machine.waitFor("Main.small = -100"));
    EXPECT_TRUE(machine.write("Main.name", Value::ofText(QStringLiteral("Grød"))).isEmpty());
    EXPECT_TRUE(waitFor(*machine.player, [&] { return machine.value("Main.name").text() == QStringLiteral("Grød"); }))
        << machine.value("Main.name").text().toStdString();
    EXPECT_TRUE(machine.value("Main.name = 'Grød'").toBool());
    EXPECT_EQ(machine.write("Main.name", Value::ofText(QStringLiteral("Too long"))).toStdString(),
              "Ikke skrevet: højst 5 tegn.");
    EXPECT_EQ(machine.write("Main.name", Value::ofText(QStringLiteral("容器"))).toStdString(),
              "Ikke skrevet: Variablen kan ikke rumme et af tegnene.");
    EXPECT_EQ(machine.write("Main.small", Value::ofInteger(300)).toStdString(),
              "Ikke skrevet: Værdien ligger uden for grænserne. -128 til 127");
    EXPECT_TRUE(machine.write("Main.operation", Value::ofInteger(2)).isEmpty());
    EXPECT_TRUE(machine.waitFor("Main.operation = Mode.Auto"));
    EXPECT_TRUE(machine.write("Main.wait", Value::ofReal(2.5)).isEmpty());
    EXPECT_TRUE(machine.waitFor("Main.wait = T#2s500ms"));
}

TEST(Player, TheKeypadKeepsItsLimitsAndWritesTheNumber) {
    Machine machine(
        R"({"id":"n","kind":"numberEntry","rect":[10,10,140,44],"target":"Main.level","minimum":"0","maximum":"50","unit":"°C"})");
    ASSERT_TRUE(machine.waitFor("Main.count > 2"));
    QTest::mouseClick(&machine.player->view(), Qt::LeftButton, {}, QPoint(60, 30));
    auto* keypad = dynamic_cast<Keypad*>(machine.player->overlay());
    ASSERT_TRUE(keypad);
    EXPECT_EQ(keypad->entered().toStdString(), "12.5");
    for (const QPushButton* button : keypad->findChildren<QPushButton*>()) {
        EXPECT_GE(button->height(), 44);
        EXPECT_GE(button->width(), 44);
    }
    for (const char key : std::string("99")) QTest::keyClick(keypad, key);
    QTest::keyClick(keypad, Qt::Key_Return);
    ASSERT_TRUE(machine.player->overlay()); // refused, still open
    EXPECT_TRUE(keypad->complaint().contains(QStringLiteral("50")));
    const QSignalSpy cancelled(keypad, &Overlay::cancelled);
    QTest::mouseClick(keypad->box(), Qt::LeftButton, {}, QPoint(5, 5));
    EXPECT_EQ(cancelled.size(), 0) << "a finger that misses a key cancels nothing";
    QTest::keyClick(keypad, Qt::Key_Backspace);
    QTest::keyClick(keypad, '.');
    QTest::keyClick(keypad, '2');
    QTest::keyClick(keypad, Qt::Key_Return);
    EXPECT_TRUE(machine.waitFor("Main.level > 9.1 AND Main.level < 9.3"));
}

TEST(Player, AfterARefusedNumberTheNextDigitBeginsAnother) {
    Machine machine(
        R"({"id":"n","kind":"numberEntry","rect":[10,10,140,44],"target":"Main.level","minimum":"0","maximum":"50"},{"id":"p","kind":"maskedEntry","rect":[10,100,140,44],"target":"Main.name","mask":"##"})");
    ASSERT_TRUE(machine.waitFor("Main.count > 2"));
    const auto opened = [&](int y) {
        QTest::mouseClick(&machine.player->view(), Qt::LeftButton, {}, QPoint(60, y));
        return dynamic_cast<Keypad*>(machine.player->overlay());
    };
    Keypad* keypad = opened(30);
    ASSERT_TRUE(keypad);
    QTest::keyClicks(keypad, "99");
    QTest::keyClick(keypad, Qt::Key_Return);
    ASSERT_TRUE(machine.player->overlay());
    QTest::keyClicks(keypad, "42");
    EXPECT_EQ(keypad->entered().toStdString(), "42");
    QTest::keyClick(keypad, Qt::Key_Return);
    EXPECT_TRUE(machine.waitFor("Main.level = 42.0"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !machine.player->overlay(); }, kPatience)) << "it is deleted later";
    // A code that is not whole is completed.
    keypad = opened(120);
    ASSERT_TRUE(keypad);
    QTest::keyClicks(keypad, "4");
    QTest::keyClick(keypad, Qt::Key_Return);
    ASSERT_TRUE(machine.player->overlay());
    QTest::keyClicks(keypad, "2");
    EXPECT_EQ(keypad->entered().toStdString(), "42");
}

TEST(Player, TheKeypadSpeaksTheLanguage) {
    Machine machine(
        R"({"id":"n","kind":"numberEntry","rect":[10,10,140,44],"target":"Main.level"},{"id":"t","kind":"textEntry","rect":[10,100,140,44],"target":"Main.name"})");
    ASSERT_TRUE(machine.waitFor("Main.count > 2"));
    const auto press = [&](const QString& text) {
        for (QPushButton* button : machine.player->overlay()->findChildren<QPushButton*>())
            if (button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
        ADD_FAILURE() << "no key " << text.toStdString();
    };
    const auto open = [&](const char* tag, int y) {
        machine.player->setLanguage(QLatin1String(tag));
        QTest::mouseClick(&machine.player->view(), Qt::LeftButton, {}, QPoint(60, y));
        ASSERT_TRUE(machine.player->overlay());
    };
    open("ar", 30);
    const auto keys = machine.player->overlay()->findChildren<QPushButton*>();
    const auto placeOf = [&](const QString& text) {
        for (const QPushButton* button : keys)
            if (button->text() == text) return button->mapToGlobal(QPoint()).x();
        return -1;
    };
    EXPECT_LT(placeOf(QStringLiteral("١")), placeOf(QStringLiteral("٣"))); // not mirrored
    press(QStringLiteral("٩"));
    press(QStringLiteral("٫"));
    press(QStringLiteral("٥"));
    press(QStringLiteral("موافق"));
    EXPECT_TRUE(machine.waitFor("Main.level = 9.5"));
    settle();
    open("da", 120);
    press(QStringLiteral("æ"));
    press(QStringLiteral("⇧"));
    press(QStringLiteral("Å"));
    press(QStringLiteral("OK"));
    EXPECT_TRUE(waitFor(*machine.player, [&] { return machine.value("Main.name").text() == QStringLiteral("æÅ"); }))
        << machine.value("Main.name").text().toStdString();
}

TEST(Player, TheLanguageFollowsTheVariableAndIsWrittenToIt) {
    Machine machine(R"({"id":"s","kind":"languages","rect":[10,10,300,44]})");
    ASSERT_TRUE(machine.waitFor("Main.count > 2"));
    QTest::mouseClick(&machine.player->view(), Qt::LeftButton, {}, QPoint(160, 30));
    EXPECT_EQ(machine.player->language().toStdString(), "da"); // at once
    EXPECT_TRUE(machine.waitFor("Language = 1"));
    EXPECT_EQ(machine.player->language().toStdString(), "da");
    machine.write("Language", Value::ofInteger(2));
    EXPECT_TRUE(waitFor(*machine.player, [&] { return machine.player->language() == QStringLiteral("ar"); }));
}

TEST(Player, AnAlarmOfOneScanIsNotLostAndAcknowledgingEndsIt) {
    Machine machine(R"({"id":"a","kind":"alarmList","rect":[10,10,600,300]})");
    ASSERT_TRUE(machine.waitFor("Main.count > 120"));
    machine.player->alarmWatch()->catchUp();
    std::vector<AlarmEntry> present = machine.player->alarms().present({}, AlarmOrder::Time);
    ASSERT_EQ(present.size(), 1u);
    EXPECT_EQ(present[0].id.toStdString(), "flash");
    EXPECT_EQ(present[0].state, AlarmState::Returned);
    EXPECT_EQ(present[0].raised.scan, 49u);
    EXPECT_EQ(present[0].returned->scan, 50u);
    machine.write("Main.overload", Value::ofBool(true));
    ASSERT_TRUE(
        waitFor(*machine.player, [&] { return machine.player->alarms().present({}, AlarmOrder::Time).size() == 2; }));
    const AlarmEntry raised = machine.player->alarms().present({}, AlarmOrder::Priority)[0];
    EXPECT_EQ(raised.state, AlarmState::Unacknowledged);
    const QString danish = AlarmBook::render(raised, machine.project.texts, QStringLiteral("da"));
    EXPECT_EQ(danish, QStringLiteral("Overbelastet ved %1").arg(raised.raised.scan + 1)); // count of that scan
    QTest::mouseClick(&machine.player->view(), Qt::LeftButton, {}, QPoint(560, 35));      // acknowledge all
    EXPECT_TRUE(waitFor(*machine.player, [&] { return machine.player->alarms().unacknowledgedCount() == 0; }));
    EXPECT_EQ(machine.player->alarms().present({}, AlarmOrder::Time).size(), 1u); // overload is still there
}

TEST(Player, WhatWasAcknowledgedStaysSoWhenAlarmsAreEdited) {
    Machine machine(R"({"id":"a","kind":"alarmList","rect":[10,10,600,300]})");
    ASSERT_TRUE(machine.waitFor("Main.count > 120"));
    machine.write("Main.overload", Value::ofBool(true));
    AlarmBook& alarms = machine.player->alarms();
    ASSERT_TRUE(waitFor(*machine.player, [&] { return alarms.present({}, AlarmOrder::Time).size() == 2; }));
    machine.player->alarmWatch()->acknowledgeAll({}, QStringLiteral("shift 2"));
    ASSERT_TRUE(waitFor(*machine.player, [&] { return alarms.unacknowledgedCount() == 0; }));
    const std::vector<AlarmEntry> before = alarms.present({}, AlarmOrder::Time);
    ASSERT_EQ(before.size(), 1u);

    machine.player->projectChanged(); // texts only: the watch goes on
    EXPECT_EQ(alarms.unacknowledgedCount(), 0);
    EXPECT_EQ(alarms.present({}, AlarmOrder::Time).size(), 1u);

    std::string more = machine.project.alarms.write();
    more.insert(more.find("\"alarms\"") + more.substr(more.find("\"alarms\"")).find('[') + 1,
                R"({"id":"first","condition":"Main.count > 1000000","text":"none"},)");
    machine.project.alarms = *AlarmFile::parse(more, QString());
    machine.player->projectChanged();
    machine.player->alarmWatch()->catchUp();
    const std::vector<AlarmEntry> after = alarms.present({}, AlarmOrder::Time);
    ASSERT_EQ(after.size(), 1u) << "what had returned and was acknowledged is gone for good";
    EXPECT_EQ(after[0].id, before[0].id);
    EXPECT_EQ(after[0].state, AlarmState::Acknowledged);
    EXPECT_EQ(after[0].raised.scan, before[0].raised.scan);
    const std::vector<AlarmEntry> history = alarms.history({}, 100);
    EXPECT_EQ(history.size(), 2u) << "nothing is in the history twice";
}

TEST(Player, TheAlarmListIsSortedFilteredAndAcknowledgedByTouch) {
    Machine machine(R"({"id":"a","kind":"alarmList","rect":[10,10,600,300]})", false);
    machine.project.alarms =
        *AlarmFile::parse(R"({"classes":[{"name":"fault","title":"Fault"},{"name":"hint","title":"Hint"}],"alarms":[
        {"id":"late","class":"hint","condition":"Main.count > 20","text":"late","priority":3},{"id":"early","class":"fault","condition":"Main.count > 10","text":"early","priority":1}]})",
                          QString());
    machine.player->projectChanged();
    machine.session.runHere([](const controller::Controller& controller) { return controller.nextScan() > 40; });
    machine.player->alarmWatch()->catchUp();
    machine.player->frame();
    PanelView& view = machine.player->view();
    QStringList asked;
    QObject::connect(&view.scene(), &PanelScene::acknowledgeRequested, &view, [&](const AcknowledgeRequest& one) {
        asked += one.all ? QStringLiteral("all ") + one.classes.join(u',')
                         : machine.player->alarms().definitions()[one.alarm].id;
    });
    const auto touch = [&](int x, int y) {
        QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(x, y));
        return std::exchange(asked, {}).join(u' ').toStdString();
    };
    const QPoint first(10 + 600 - 24, 10 + 50 + 23); // the key of the first row
    const QImage byPriority = view.scene().picture();
    touch(100, 30); // the heading of the time
    EXPECT_NE(view.scene().picture(), byPriority);
    EXPECT_EQ(touch(first.x(), first.y()), "late"); // the newest one is first
    ASSERT_TRUE(waitFor(*machine.player, [&] { return machine.player->alarms().unacknowledgedCount() == 1; }));
    EXPECT_EQ(touch(first.x(), first.y()), ""); // it was acknowledged
    EXPECT_EQ(touch(first.x(), first.y() + 22 + 4), "early");
    const int filter = 10 + 600 - 4 - 154 - 4 - 77;
    touch(filter, 30); // not acknowledged
    touch(filter, 30); // faults
    EXPECT_EQ(touch(540, 30), "all fault");
    touch(filter, 30); // hints
    EXPECT_EQ(touch(540, 30), "all hint");
    touch(filter, 30);
    EXPECT_EQ(touch(540, 30), "all "); // all again
}

TEST(Player, FollowsTheTimeSliderAndRefusesToWriteIntoThePast) {
    Machine machine(R"({"id":"n","kind":"number","rect":[10,10,140,44],"value":"Main.count","format":"%d"})");
    ASSERT_TRUE(machine.waitFor("Main.count > 30"));
    const auto position = machine.session.history().positionOfScan(9);
    ASSERT_TRUE(position);
    machine.player->setPosition(*position);
    EXPECT_EQ(machine.value("Main.count").toInteger(), 10);
    EXPECT_EQ(machine.player->values()->freshness(), Freshness::Past);
    EXPECT_EQ(machine.write("Main.level", Value::ofReal(1)).toStdString(),
              "Not written: the panel shows recorded values.");
    machine.player->setPosition(std::nullopt);
    EXPECT_GT(machine.value("Main.count").toInteger(), 30);
}

TEST(Player, SaysWhenTheControllerStoppedOrFaultedAndVeilsTheOldValues) {
    Machine machine(R"({"id":"n","kind":"number","rect":[10,200,140,44],"value":"Main.quotient","format":"%d"})");
    PlayerStatus* status = machine.player->findChild<PlayerStatus*>();
    ASSERT_TRUE(status);
    ASSERT_TRUE(machine.waitFor("Main.quotient = 100"));
    EXPECT_EQ(status->stateText().toStdString(), "");
    EXPECT_FALSE(status->isVisible());
    const QImage fresh = machine.player->grab(QRect(0, 150, 640, 200)).toImage();
    EXPECT_TRUE(machine.write("Main.divisor", Value::ofInteger(0)).isEmpty());
    ASSERT_TRUE(waitFor(*machine.player, [&] { return machine.player->values()->freshness() == Freshness::Fault; }));
    machine.player->frame();
    EXPECT_EQ(status->stateText().toStdString(), "The controller has a fault: division by zero")
        << "what its programmer should do is not for the operator";
    EXPECT_NE(machine.player->grab(QRect(0, 150, 640, 200)).toImage(),
              fresh); // the last value is still there, but not as a fresh one
    machine.player->setLanguage(QStringLiteral("da"));
    EXPECT_TRUE(status->stateText().startsWith(QStringLiteral("Styringen har en fejl")))
        << status->stateText().toStdString();
    EXPECT_EQ(machine.write("Main.divisor", Value::ofInteger(1)).toStdString(), "Ikke skrevet: Styringen kører ikke.");
    machine.player->setRun(nullptr);
    machine.player->frame();
    EXPECT_EQ(status->stateText().toStdString(), "Ingen styring");
}

TEST(Player, ATrendShowsTheRecordedScans) {
    Machine machine(
        R"({"id":"t","kind":"trend","rect":[10,10,400,300],"seconds":1,"series":[{"value":"Main.count"}]})");
    ASSERT_TRUE(machine.waitFor("Main.count > 150"));
    machine.session.pause();
    ASSERT_TRUE(waitFor(*machine.player,
                        [&] { return machine.player->values()->status().state == controller::State::Paused; }));
    const BindingId id = machine.player->values()->bind(QStringLiteral("Main.count"));
    const std::vector<CurvePiece> curve = machine.player->values()->curve(id, 1.0, 1000);
    ASSERT_GT(curve.size(), 20u); // a hundred, fewer where a busy machine or a sanitizer holds scans up
    EXPECT_LE(curve.size(), 102u);
    EXPECT_EQ(curve.back().last, machine.value("Main.count").toNumber());
    EXPECT_NEAR(static_cast<double>(curve.front().from), -1e9, 1e8);
    for (size_t i = 1; i < curve.size(); ++i) EXPECT_EQ(curve[i].first, curve[i - 1].last + 1);
}

TEST(Player, ATrendLeavesOutWhatWasGoneBackFrom) {
    Machine machine(
        R"({"id":"t","kind":"trend","rect":[10,10,400,300],"seconds":100,"series":[{"value":"Main.count"}]})");
    ASSERT_TRUE(machine.waitFor("Main.count > 60"));
    machine.session.pause();
    ASSERT_TRUE(waitFor(*machine.player,
                        [&] { return machine.player->values()->status().state == controller::State::Paused; }));
    const history::Position past = 30;
    ASSERT_TRUE(machine.session.resumeFrom(past));
    machine.session.start();
    ASSERT_TRUE(machine.waitFor("Main.count > 50"));
    machine.session.pause();
    ASSERT_TRUE(waitFor(*machine.player,
                        [&] { return machine.player->values()->status().state == controller::State::Paused; }));
    const std::vector<CurvePiece> curve =
        machine.player->values()->curve(machine.player->values()->bind(QStringLiteral("Main.count")), 100.0, 100000);
    ASSERT_GT(curve.size(), 40u);
    for (size_t i = 1; i < curve.size(); ++i) EXPECT_EQ(curve[i].first, curve[i - 1].last + 1) << i;
}

TEST(Player, PicturesOfEveryPanelInEveryLanguage) {
    Machine machine(R"({"id":"b","kind":"button","rect":[10,10,120,60],"text":"@start"})", false);
    machine.session.runHere([](const controller::Controller& controller) { return controller.nextScan() > 10; });
    const QString folder =
        QDir::tempPath() + QStringLiteral("/stepwise_pictures_%1").arg(QCoreApplication::applicationPid());
    PictureOptions options;
    options.folder = folder;
    const auto paths = renderPanels(machine.project, &machine.session, options);
    ASSERT_TRUE(paths) << paths.error().english();
    EXPECT_EQ(paths->size(), 3u);
    EXPECT_NE(QImage(folder + QStringLiteral("/main.en.png")), QImage(folder + QStringLiteral("/main.ar.png")));
    QDir(folder).removeRecursively();
}

TEST(Check, TheFrontEndChecksEveryBinding) {
    const driver::Built built = builtMachine();
    const struct {
        const char *expression, *wanted;
        bool isTarget;
        const char* complaint;
    } rows[] = {
        {"Main.running", "bool", false, ""},         {"Main.level > 3", "bool", false, ""},
        {"Main.level", "bool", false, "BOOL"},       {"Main.leve", "number", false, "did you mean level?"},
        {"Main.level + 1", "number", true, "not a"}, {"Main.level", "number", true, ""},
        {"Main.name", "number", false, "number"},    {"Main.name", "text", true, ""},
        {"Main.numbers", "array", false, ""},        {"Main.numbers[2]", "number", true, ""},
        {"Main.numbers", "any", false, "single"},    {"Main.operation", "number", true, ""},
        {"NOT Main.running", "bool", true, "not a"}, // of a switch: it could not be written
    };
    for (const auto& row : rows) {
        const std::string complaint =
            checkBinding(built.checked, QLatin1String(row.expression), row.wanted, row.isTarget).english();
        if (*row.complaint)
            EXPECT_NE(complaint.find(row.complaint), std::string::npos) << row.expression << ": " << complaint;
        else
            EXPECT_EQ(complaint, "") << row.expression;
    }
}

} // namespace
} // namespace plc::hmi
