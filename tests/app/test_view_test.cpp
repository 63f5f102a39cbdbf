// The view of the project's tests: what passed and failed, one or the failed ones run again, from a failure to its line
// and to the recording of it.
#include "app/panels/live_views.h"
#include "app/testing/test_view.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/long_scans.h"
#include "tests/support/processor_time.h"

#include <QAction>
#include <QToolButton>
#include <QTreeWidget>

namespace plc::app {
namespace {

const char* const kTests = R"(TEST 'counts'
RUN 5 SCANS;
ASSERT Main.counter = 5, 'five scans';
END_TEST

TEST 'is wrong'
RUN 2 SCANS;
ASSERT Main.counter = 7, 'seven';
END_TEST
)";

class TestViewTest : public StudioTest {
protected:
    void SetUp() override {
        write("tests/first.st", kTests);
        StudioTest::SetUp();
        ASSERT_TRUE(waitFor([&] { return item("counts") != nullptr; }));
    }
    QTreeWidgetItem* item(const QString& title) {
        const auto found = window->tests().tree().findItems(title, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.first();
    }
    QString state(const QString& title) { return item(title)->text(1); }
    void runAll() {
        const auto isDone = [&] { return window->tests().summary() == "1 passed, 1 failed"; };
        ASSERT_TRUE(waitFor([&] {
            if (!isDone()) window->action("run.tests")->trigger(); // nothing while a run is not over yet
            return isDone();
        }));
    }
};

TEST_F(TestViewTest, ShowsWhatPassedAndWhatFailedWithTheTime) {
    EXPECT_EQ(state("counts"), "not run yet");
    runAll();
    EXPECT_EQ(state("counts"), "passed");
    EXPECT_EQ(state("is wrong"), "failed");
    EXPECT_TRUE(item("counts")->text(2).endsWith("ms"));
    ASSERT_EQ(item("is wrong")->childCount(), 1);
    EXPECT_TRUE(item("is wrong")->child(0)->text(0).contains("seven"));
}

TEST_F(TestViewTest, RunsOneAndTheFailedOnes) {
    window->tests().tree().setCurrentItem(item("counts"));
    window->tests().runSelected();
    ASSERT_TRUE(waitFor([&] { return state("counts") == "passed"; }));
    EXPECT_EQ(state("is wrong"), "not run yet");
    runAll();
    window->workspace().setText("tests/first.st", QString(kTests).replace("= 7", "= 2").toStdString());
    ASSERT_TRUE(waitFor([&] {
        window->tests().runFailed();
        return state("is wrong") == "passed";
    }));
    EXPECT_EQ(window->tests().summary(), "2 passed, 0 failed");
    window->workspace().revert("tests/first.st");
}

TEST_F(TestViewTest, AFailureLeadsToItsLineAndItsRecording) {
    runAll();
    QTreeWidgetItem* failure = item("is wrong")->child(0);
    emit window->tests().tree().itemActivated(failure, 0);
    EXPECT_EQ(editor().file(), "tests/first.st");
    int line = 0, column = 0;
    editor().getCursorPosition(&line, &column);
    EXPECT_EQ(line + 1, 8);
    const QString recording = failure->data(0, Qt::UserRole + 3).toString();
    ASSERT_FALSE(recording.isEmpty());
    emit window->tests().recordingRequested(recording);
    ASSERT_TRUE(window->control().showsRecorded());
    EXPECT_EQ(window->control().value("Main.counter").text, "2");
}

TEST_F(TestViewTest, ARunIsCancelledAtOnceInTheMiddleOfAScan) {
    auto* cancel = window->findChild<QToolButton*>("cancelWork");
    ASSERT_TRUE(cancel);
    int cancelled = 0;
    for (const LongScan& scan : longScans()) {
        const QString first = QStringLiteral("before ") + scan.name, second = QStringLiteral("long ") + scan.name;
        window->workspace().setText("src/main.st", scan.text);
        window->workspace().setText("tests/first.st", QStringLiteral("TEST '%1'\nASSERT TRUE;\nEND_TEST\n\nTEST "
                                                                     "'%2'\nRUN 1000 SCANS;\nEND_TEST\n")
                                                          .arg(first, second)
                                                          .toStdString());
        ASSERT_TRUE(waitFor([&] { return item(second) != nullptr; })) << scan.name;
        ASSERT_TRUE(waitFor([&] {
            if (state(first) != "passed") window->action("run.tests")->trigger(); // nothing while the last run ends
            return state(first) == "passed";
        })) << scan.name;
        QTest::qWait(200); // a duration: of the scan in the second test
        const auto isOver = [&] { return state(second) != "not run yet"; };
        ASSERT_TRUE(waitFor([&] { return cancel->isVisible() || isOver(); })) << scan.name; // it comes a moment later
        if (isOver()) continue; // a fast machine has used up the work that virtual time gives a scan
        const double since = ownSeconds();
        QTest::mouseClick(cancel, Qt::LeftButton);
        EXPECT_TRUE(waitFor([&] { return !cancel->isVisible(); })) << scan.name;
        const double took = ownSeconds() - since; // with what is given back of three images
        EXPECT_LT(took, kAtOnceSeconds + secondsForNewMemory(360'000'000)) << scan.name;
        if (state(second) == "failed") { // the same, just before the click
            const QString why = item(second)->child(0)->text(0);
            EXPECT_TRUE(why.contains("units of work")) << scan.name << ": " << why.toStdString();
            continue;
        }
        ++cancelled;
        EXPECT_EQ(state(second), "not run yet") << scan.name;
    }
    EXPECT_GT(cancelled, 0) << "none was long";
    window->workspace().revert("src/main.st");
    window->workspace().revert("tests/first.st");
}

} // namespace
} // namespace plc::app
