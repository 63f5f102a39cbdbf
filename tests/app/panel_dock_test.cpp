// The operator panel in the studio's dock: its alarm history outlives the window, and a recording from a file is the
// past of the panel, too.
#include "app/panels/live_views.h"
#include "app/settings/translation.h"
#include "hmi/player/panel_player.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QPlainTextEdit>
#include <QScreen>
#include <QToolButton>
#include <QTreeWidget>

namespace plc::app {
namespace {

class PanelDockTest : public StudioTest {
protected:
    void SetUp() override {
        write("hmi/overview.panel.json",
              "{\n  \"elements\": [\n    {\n      \"kind\": \"number\",\n      \"id\": \"count\",\n      \"rect\": "
              "[40, 40, 120, 40],\n      \"value\": \"Main.counter\"\n    }\n  ]\n}\n");
        write("hmi/alarms.json",
              "{\n  \"version\": 1,\n  \"classes\": [\n    {\n      \"name\": \"fault\"\n    }\n  ],\n  \"alarms\": "
              "[\n    {\n      \"id\": \"high\",\n      \"condition\": \"Main.counter > 5\",\n"
              "      \"class\": \"fault\",\n      \"text\": \"high\"\n    }\n  ]\n}\n");
        if (!blocked.isEmpty()) write(blocked, "not a folder");
        StudioTest::SetUp();
    }
    hmi::PanelPlayer& player() { return *window->live().player(); }
    size_t occurrences() { return player().alarms().history({}, 100).size(); }
    void runUntilRaised() {
        const size_t before = occurrences();
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return occurrences() > before; }));
        window->action("run.pause")->trigger();
    }
    QString blocked;
};

class PanelDockReadOnlyTest : public PanelDockTest {
protected:
    PanelDockReadOnlyTest() { blocked = ".stepwise"; }
};

TEST_F(PanelDockTest, ThePanelSpeaksTheStudiosLanguageUntilAnotherIsChosen) {
    write("project.json",
          "{\n  \"name\": \"Test\",\n  \"libraries\": [],\n  \"hmi\": {\"languages\": [\"en\", \"de\", \"fr\"]}\n}\n");
    installTranslation(*qApp, "de");
    const auto openedAgain = [&] {
        window->closeProject();
        EXPECT_TRUE(window->openProject(folder.path()));
        return player().language().toStdString();
    };
    EXPECT_EQ(openedAgain(), "de");
    emit player().scene().languageRequested(QStringLiteral("fr"));
    EXPECT_EQ(openedAgain(), "fr") << "remembered";
    installTranslation(*qApp, "en");
}

TEST_F(PanelDockTest, TheAlarmHistoryOutlivesTheWindow) {
    ASSERT_NE(window->live().player(), nullptr);
    EXPECT_EQ(occurrences(), 0u);
    runUntilRaised();
    EXPECT_EQ(occurrences(), 1u);
    EXPECT_TRUE(QFile::exists(folder.path() + "/.stepwise/alarms.sqlite"));
    // Panels read again while the controller runs: the watch finds everything again, the history keeps it once.
    window->live().reloadPanels();
    ASSERT_TRUE(waitFor([&] { return player().alarms().present({}, hmi::AlarmOrder::Time).size() == 1; }));
    EXPECT_EQ(occurrences(), 1u);

    window->control().disconnectSession();
    window.reset();
    window = std::make_unique<MainWindow>();
    window->show();
    ASSERT_TRUE(window->openProject(folder.path()));
    ASSERT_TRUE(waitFor([&] { return window->workspace().model() != nullptr; }));
    EXPECT_EQ(occurrences(), 1u) << "of the run before";
    EXPECT_EQ(player().alarms().history({}, 1)[0].text.toStdString(), "high");
    runUntilRaised();
    EXPECT_EQ(occurrences(), 2u) << "the same alarm at the same scan of another run is another occurrence";
}

TEST_F(PanelDockReadOnlyTest, WithoutAFolderToWriteTheAlarmHistoryIsInMemoryAndTheLogSaysSo) {
    runUntilRaised();
    EXPECT_EQ(occurrences(), 1u);
    window->live().reloadPanels();
    int lines = 0;
    for (QTreeWidget* tree : window->findChildren<QTreeWidget*>())
        for (int i = 0; i < tree->topLevelItemCount(); ++i)
            for (int column = 0; column < tree->columnCount(); ++column)
                lines += tree->topLevelItem(i)->text(column).contains("alarm history is kept in memory");
    EXPECT_EQ(lines, 1);
}

TEST_F(PanelDockTest, ARecordingFromAFileIsShownInThePanelAndCanNotBeWritten) {
    runUntilRaised();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    const QString path = folder.path() + "/before.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    const auto shown = [&] { return player().values()->value(player().values()->bind("Main.counter")).toNumber(); };
    player().frame();
    const double recorded = shown();
    EXPECT_GT(recorded, 5);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return shown() > recorded + 5; }));

    ASSERT_TRUE(window->live().openRecording(path));
    EXPECT_EQ(shown(), recorded) << "the newest scan of the file, while the controller goes on";
    const uint64_t opened = window->control().session()->status().scans;
    ASSERT_TRUE(waitFor([&] { return window->control().session()->status().scans > opened + 5; }));
    EXPECT_EQ(shown(), recorded);
    EXPECT_EQ(player().values()->freshness(), hmi::Freshness::Past);
    EXPECT_EQ(player()
                  .post(hmi::WriteRequest{{}, "Main.counter", hmi::WriteKind::Write, hmi::Value::ofInteger(1), {}})
                  .toStdString(),
              "Not written: the panel shows recorded values.");
    EXPECT_EQ(player().alarms().present({}, hmi::AlarmOrder::Time).size(), 1u) << "found in the file";
    window->live().slider().stepScans(-1);
    EXPECT_EQ(shown(), recorded - 1);
    window->live().reloadPanels();
    EXPECT_EQ(shown(), recorded - 1) << "panels read again still show the file";

    window->live().closeRecording();
    ASSERT_TRUE(waitFor([&] { return shown() > recorded + 5; }));
    EXPECT_EQ(player().values()->freshness(), hmi::Freshness::Live);
    EXPECT_EQ(player()
                  .post(hmi::WriteRequest{{}, "Main.limit", hmi::WriteKind::Write, hmi::Value::ofInteger(2000), {}})
                  .toStdString(),
              "");

    window->control().disconnectSession();
    ASSERT_TRUE(window->live().openRecording(path));
    EXPECT_EQ(shown(), recorded) << "without any controller";
    window->live().closeRecording();
    EXPECT_EQ(player().values(), nullptr);
}

TEST_F(PanelDockTest, FullScreenShowsThePanelAloneAndEscapeBringsItBackIntoItsDock) {
    window->showDock("panel");
    ASSERT_TRUE(waitFor([&] { return player().isVisible(); }));
    const QWidget* dock = player().parentWidget();
    const QSize inDock = player().size();
    QToolButton* button = nullptr;
    for (QToolButton* each : window->live().panelArea()->findChildren<QToolButton*>())
        if (each->text().startsWith("Full screen")) button = each;
    ASSERT_TRUE(button);
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return player().isFullScreen(); }));
    EXPECT_TRUE(player().isWindow()) << "the panel, not the studio";
    EXPECT_FALSE(window->isFullScreen());
    EXPECT_TRUE(waitFor([&] { return player().size() == player().screen()->size(); }));
    QTest::keyClick(&player(), Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return !player().isWindow() && player().isVisible(); }));
    EXPECT_EQ(player().parentWidget(), dock);
    EXPECT_TRUE(waitFor([&] { return player().size() == inDock; }));
}

TEST_F(PanelDockTest, APanelThatIsMadeLargerLeavesNoStrips) {
    window->showDock("panel");
    ASSERT_TRUE(waitFor([&] { return player().isVisible(); }));
    for (const QSize size : {QSize(1400, 900), QSize(1024, 700), QSize(1399, 901)}) {
        window->resize(size);
        ASSERT_TRUE(waitFor([&] { return player().view().height() > 0; }));
        player().frame();
        const QRect below = player().view().geometry(); // under the strip that tells the state
        EXPECT_EQ(below.bottom(), player().rect().bottom());
        EXPECT_EQ(below.left(), 0);
        EXPECT_EQ(below.right(), player().rect().right());
        const QImage shown = player().view().grab().toImage();
        const QColor ground = shown.pixelColor(1, 1);
        for (const QPoint corner : {QPoint(shown.width() - 2, 1), QPoint(1, shown.height() - 2),
                                    QPoint(shown.width() - 2, shown.height() - 2)})
            EXPECT_EQ(shown.pixelColor(corner), ground) << corner.x() << ", " << corner.y();
    }
}

} // namespace
} // namespace plc::app
