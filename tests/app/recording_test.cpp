// A recording from a file in the place of the controller: slider, values in the text and watch move to it, and back.
#include "app/panels/live_views.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>

namespace plc::app {
namespace {

TEST_F(StudioTest, AnOpenedRecordingIsShownEverywhereUntilOneGoesBack) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 5; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    const auto newest = [&] {
        const session::Session& session = *window->control().session();
        const auto counter = session.expression("Main.counter");
        return counter ? counter->number(session.snapshot()) : std::nullopt;
    };
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toDouble() == newest(); }));
    const QString recorded = window->control().value("Main.counter").text;
    const QString path = folder.path() + "/before.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > recorded.toInt() + 5; }));

    ASSERT_TRUE(window->live().openRecording(path));
    EXPECT_TRUE(window->control().showsRecorded());
    EXPECT_EQ(window->control().value("Main.counter").text, recorded);
    EXPECT_EQ(window->control().valueIn("counter", "Main").text, recorded) << "as in the text";
    auto* marker = window->findChild<QToolButton*>("recordingShown");
    ASSERT_NE(marker, nullptr);
    EXPECT_TRUE(waitFor([&] { return marker->isVisible(); }));
    EXPECT_TRUE(marker->text().contains("before.rec"));
    window->live().slider().stepScans(-1);
    EXPECT_EQ(window->control().value("Main.counter").text.toInt(), recorded.toInt() - 1);
    EXPECT_FALSE(window->control().write("Main.counter", "1")) << "the past of a file is read only";

    QTest::mouseClick(marker, Qt::LeftButton);
    EXPECT_FALSE(window->control().showsRecorded());
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > recorded.toInt(); }));
    EXPECT_TRUE(waitFor([&] { return !marker->isVisible(); }));
}

TEST_F(StudioTest, ARecordingOpensWithoutAController) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 5; }));
    const QString path = folder.path() + "/before.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    window->control().disconnectSession();
    ASSERT_TRUE(window->live().openRecording(path));
    EXPECT_GT(window->control().value("Main.counter").text.toInt(), 5);
    window->action("run.start")->trigger(); // goes back by itself
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 1; }));
    EXPECT_FALSE(window->control().showsRecorded());
}

const char* const kFaulting = R"(PROGRAM Main
VAR
    counter, zero : INT;
END_VAR
counter := counter + 1;
IF counter > 20 THEN
    counter := counter / zero;
END_IF
END_PROGRAM
)";

class EarlierRunsTest : public StudioTest {
protected:
    [[nodiscard]] bool hasRun(const std::function<bool()>& until) {
        window->action("run.start")->trigger();
        return waitFor(until);
    }
    [[nodiscard]] bool isKept(size_t number) {
        return waitFor([&] {
            return !window->control().archive().isWriting() && window->control().archive().runs().size() == number;
        });
    }
    /// What the menu offers now.
    QList<QAction*> offered() {
        auto* menu = window->findChild<QMenu*>("earlierRuns");
        emit menu->aboutToShow();
        return menu->actions();
    }
};

TEST_F(EarlierRunsTest, RunningAgainAfterAFaultKeepsTheRecordingOfTheFault) {
    window->workspace().setText("src/main.st", kFaulting);
    ASSERT_FALSE(offered().first()->isEnabled()) << "none yet";
    const auto isFault = [&] { return window->control().status().state == controller::State::Fault; };
    ASSERT_TRUE(hasRun(isFault));
    ASSERT_TRUE(hasRun([&] { return !window->control().archive().runs().empty() && isFault(); }));
    ASSERT_TRUE(isKept(1));
    EXPECT_TRUE(window->control().archive().runs().front().isFault);
    offered().first()->trigger();
    ASSERT_TRUE(window->control().showsRecorded());
    EXPECT_EQ(window->control().value("Main.counter").text, "21") << "as it was at the fault";
    window->workspace().revert("src/main.st");
}

TEST_F(EarlierRunsTest, ClosingTheProjectWhileItRunsKeepsTheRun) {
    ASSERT_TRUE(hasRun([&] { return window->control().status().scans > 10; }));
    window->closeProject();
    ASSERT_TRUE(window->openProject(folder.path()));
    ASSERT_TRUE(isKept(1));
    offered().first()->trigger();
    EXPECT_GT(window->control().value("Main.counter").text.toInt(), 10);
}

TEST_F(EarlierRunsTest, AnotherProjectWhileItRunsKeepsTheRun) {
    ASSERT_TRUE(hasRun([&] { return window->control().status().scans > 10; }));
    QTemporaryDir other;
    ASSERT_TRUE(QFile::copy(folder.path() + "/project.json", other.path() + "/project.json"));
    ASSERT_TRUE(window->openProject(other.path())); // as New Project does with the folder that it has made
    ASSERT_TRUE(window->openProject(folder.path()));
    ASSERT_TRUE(isKept(1));
    offered().first()->trigger();
    EXPECT_GT(window->control().value("Main.counter").text.toInt(), 10);
}

TEST_F(EarlierRunsTest, ClosingTheWindowWaitsUntilTheRunIsOnDisk) {
    ASSERT_TRUE(hasRun([&] { return window->control().status().scans > 10; }));
    window->close();
    EXPECT_FALSE(window->control().archive().isWriting());
    EXPECT_EQ(window->control().archive().runs().size(), 1U);
}

TEST_F(EarlierRunsTest, TheOldestGoWhenTheRoomIsUsedUp) {
    editor::RunArchive& archive = window->control().archive();
    archive.setBudget(1); // the newest stays all the same
    for (int run = 0; run < 3; ++run) {
        ASSERT_TRUE(hasRun([&] { return window->control().status().scans > 5; }));
        window->control().disconnectSession();
    }
    ASSERT_TRUE(isKept(1));
    archive.setBudget(0);
    const QString before = archive.runs().front().path;
    ASSERT_TRUE(hasRun([&] { return window->control().status().scans > 5; }));
    window->control().disconnectSession();
    ASSERT_TRUE(isKept(1));
    EXPECT_EQ(archive.runs().front().path, before) << "nothing is kept then";
}

TEST_F(EarlierRunsTest, ANewSessionRecordsIntoTheMemoryOfTheSettings) {
    window->control().setHistoryBudget(size_t(64) << 20);
    ASSERT_TRUE(hasRun([&] { return window->control().status().scans > 1; }));
    EXPECT_EQ(window->control().session()->history().statistics().budget, size_t(64) << 20);
}

} // namespace
} // namespace plc::app
