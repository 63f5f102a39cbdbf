// The task monitor's figures and histogram, and prepared values of the watch, as a user meets them.
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/theme.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QToolBar>
#include <QTreeWidget>

namespace plc::app {
namespace {

/// Pixels of the bars' colour in the histogram, by column.
int barPixels(QWidget& histogram) {
    const QImage picture = histogram.grab().toImage();
    const QRgb bar = kit::colors().accent.rgb();
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) count += picture.pixel(x, y) == bar;
    return count;
}

TEST_F(StudioTest, TheTaskMonitorCountsScansAndDrawsTheirHistogram) {
    window->showDock("tasks");
    auto* monitor = window->findChild<editor::TaskMonitor*>();
    ASSERT_NE(monitor, nullptr);
    ASSERT_TRUE(waitFor([&] { return monitor->isVisible(); }));
    QWidget* histogram = nullptr;
    for (QWidget* each : monitor->findChildren<QWidget*>())
        if (each->accessibleName() == "Histogram of execution times") histogram = each;
    ASSERT_NE(histogram, nullptr);
    EXPECT_EQ(barPixels(*histogram), 0) << "nothing ran";

    window->action("run.start")->trigger();
    auto* tree = monitor->findChild<QTreeWidget*>();
    ASSERT_TRUE(waitFor([&] { return tree->topLevelItemCount() == 1 && tree->topLevelItem(0)->text(1).toInt() > 20; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    const auto tasks = window->control().session()->taskStatistics();
    ASSERT_EQ(tasks.size(), 1u);
    EXPECT_TRUE(waitFor([&] {
        monitor->refresh();
        return tree->topLevelItem(0)->text(1) == QString::number(tasks[0].count);
    })) << tree->topLevelItem(0)->text(1).toStdString();
    uint64_t inBins = 0;
    for (const uint32_t bin : tasks[0].histogram) inBins += bin;
    EXPECT_EQ(inBins, tasks[0].count) << "every scan is in a bar";
    EXPECT_GT(barPixels(*histogram), 100);

    QAction* reset = nullptr;
    for (QAction* each : monitor->findChild<QToolBar*>()->actions())
        if (each->text() == "Reset the statistics") reset = each;
    ASSERT_NE(reset, nullptr);
    reset->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().session()->taskStatistics()[0].count == 0; }));
    monitor->refresh();
    EXPECT_EQ(barPixels(*histogram), 0);
}

TEST_F(StudioTest, PreparedValuesAreWrittenTogetherAndARefusedOneStays) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 2; }));
    window->watch().setExpressions({"Main.limit", "Main.done", "Main.counter"});
    const auto row = [&](int i) { return window->watch().tree().topLevelItem(i); };
    row(0)->setText(3, "32000");
    row(1)->setText(3, "TRUE");
    row(2)->setText(3, "no number");
    EXPECT_EQ(window->control().value("Main.limit").text, "1000") << "prepared is not written";
    window->action("run.write")->trigger();
    EXPECT_TRUE(waitFor([&] { return window->control().value("Main.limit").text == "32000"; }));
    EXPECT_TRUE(waitFor([&] { return window->control().value("Main.done").text == "TRUE"; }));
    EXPECT_EQ(row(0)->text(3), "");
    EXPECT_EQ(row(1)->text(3), "");
    EXPECT_EQ(row(2)->text(3), "no number") << "what was refused stays to be fixed";
    EXPECT_FALSE(row(2)->toolTip(3).isEmpty()) << "and says why";
}

TEST_F(StudioTest, SameNamesInTwoTasksStayApart) {
    write("src/two.st", "PROGRAM Other\nVAR counter : INT := 500; END_VAR\nEND_PROGRAM\n"
                        "CONFIGURATION C\nRESOURCE R ON PLC\nTASK Fast(INTERVAL := T#10ms, PRIORITY := 1);\nTASK "
                        "Slow(INTERVAL := T#50ms, PRIORITY := 2);\nPROGRAM Main WITH Fast : Main;\n"
                        "PROGRAM Other WITH Slow : Other;\nEND_RESOURCE\nEND_CONFIGURATION\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/two.st"); }));
    analysed();
    window->watch().setExpressions({"Main.counter", "Other.counter"});
    window->showDock("watch");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 3; }));
    window->watch().refresh();
    EXPECT_EQ(window->watch().tree().topLevelItem(1)->text(1), "500");
    EXPECT_NE(window->watch().tree().topLevelItem(0)->text(1), "500");
}

TEST_F(StudioTest, TheLogTellsWhatHappenedAndTheMonitorWhatItCost) {
    const auto listIn = [&](const QString& dock) {
        window->showDock(dock);
        return window->dock(dock)->findChild<QTreeWidget*>();
    };
    QTreeWidget* log = listIn("log");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 20; }));
    window->watch().setExpressions({"Main.limit"});
    window->watch().tree().topLevelItem(0)->setText(3, "5");
    window->action("run.force")->trigger();
    const auto logged = [&](const QString& word) {
        for (int i = 0; i < log->topLevelItemCount(); ++i)
            for (int c = 0; c < log->columnCount(); ++c)
                if (log->topLevelItem(i)->text(c).contains(word, Qt::CaseInsensitive)) return true;
        return false;
    };
    EXPECT_TRUE(waitFor([&] { return logged("force") || logged("limit"); }));
    QTreeWidget* tasks = listIn("tasks");
    ASSERT_TRUE(waitFor([&] { return tasks->topLevelItemCount() > 0; }));
    EXPECT_TRUE(waitFor([&] {
        return tasks->topLevelItem(0)->text(1).toInt() > 0 || tasks->topLevelItem(0)->text(2).toInt() > 0;
    })) << "its count";
    window->action("run.stop")->trigger();
    EXPECT_TRUE(waitFor([&] { return logged("stop"); }));
}

} // namespace
} // namespace plc::app
