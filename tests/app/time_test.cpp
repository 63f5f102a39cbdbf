// The time that the window shows: the plot comes back to the present with everything else, each project has its own,
// and status line, log and slider agree.
#include "app/panels/live_views.h"
#include "editor/debug/debug_views.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/plot_view.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QTreeWidget>

namespace plc::app {
namespace {

class TimeTest : public StudioTest {
protected:
    void TearDown() override {
        QLocale::setDefault(QLocale::c());
        StudioTest::TearDown();
    }
    void runFor(int scans) {
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().status().scans > static_cast<uint64_t>(scans); }));
    }
    plc::plot::PlotView& plot() { return *window->live().traceView().plot(); }
};

TEST_F(TimeTest, BackToLiveBringsThePlotAlong) {
    window->showDock("trace");
    window->live().traceView().addChannel("Main.counter");
    runFor(20);
    ASSERT_TRUE(waitFor([&] { return plot().isFollowing(); }));
    QTest::keyClick(&window->live().slider(), Qt::Key_PageUp);
    ASSERT_TRUE(waitFor([&] { return window->control().viewed().has_value(); }));
    plot().setFollowing(false);
    plot().setRange(0, 50'000'000); // one looks at the start of it
    window->action("time.live")->trigger();
    EXPECT_TRUE(waitFor([&] { return plot().isFollowing(); }));
    EXPECT_FALSE(window->control().viewed().has_value());
    const uint64_t now = window->control().status().scans;
    EXPECT_TRUE(waitFor([&] { return window->control().status().scans > now + 20; })) << "and it goes on";
    EXPECT_TRUE(waitFor([&] { return plot().model().to > window->control().status().time.count() / 2; }));
}

TEST_F(TimeTest, TheTraceOfANewProjectStartsAtItsOwnTime) {
    window->showDock("trace");
    window->live().traceView().addChannel("Main.counter");
    window->control().setMode({session::Pace::Factor, 20});
    runFor(200);
    const int64_t reached = window->control().status().time.count();
    ASSERT_TRUE(waitFor([&] { return plot().model().to >= reached; }));
    window->control().disconnectSession();
    window->control().setMode({session::Pace::Real, 1.0});

    QTemporaryDir other;
    for (const char* path : {"project.json", "src/main.st"}) {
        QDir().mkpath(other.path() + "/src");
        ASSERT_TRUE(QFile::copy(folder.path() + "/" + path, other.path() + "/" + path));
    }
    ASSERT_TRUE(window->openProject(other.path()));
    ASSERT_TRUE(waitFor([&] { return window->workspace().model() != nullptr; }));
    window->live().traceView().addChannel("Main.counter");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 5; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    const int64_t its = window->control().status().time.count();
    EXPECT_TRUE(waitFor([&] { return plot().model().from <= its && plot().model().to >= its / 2; }));
    EXPECT_LT(plot().model().from, reached) << "not where the project before had come to";
    window->control().disconnectSession();
    window->openProject(folder.path());
}

TEST_F(TimeTest, StatusLineAndLogReadTheSameClock) {
    runFor(10);
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    const QString now = plot::momentText(window->control().status().time.count() / 1'000'000 * 1'000'000);
    EXPECT_TRUE(waitFor([&] {
        for (const QLabel* each : window->statusBar()->findChildren<QLabel*>())
            if (each->text().startsWith(now + " ")) return true;
        return false;
    })) << now.toStdString();
    const auto events = window->control().session()->eventsSince(0);
    ASSERT_FALSE(events.empty());
    const QString last = plot::momentText(events.back().time.count());
    EXPECT_TRUE(waitFor([&] { return window->log().shownText().contains(last); }))
        << window->log().shownText().toStdString();
}

TEST_F(TimeTest, RecentProjectsAreListedWithTheirFolder) {
    QMenu* recent = nullptr;
    for (QMenu* menu : window->menuBar()->findChildren<QMenu*>())
        if (menu->title().remove(u'&') == "Recent Projects") recent = menu;
    ASSERT_TRUE(recent);
    emit recent->aboutToShow();
    ASSERT_FALSE(recent->actions().isEmpty());
    const QString parent = QDir::toNativeSeparators(QFileInfo(folder.path()).path());
    EXPECT_TRUE(recent->actions().first()->text().remove(u'&').contains(parent));
    window->closeProject();
    auto* list = window->findChild<QListWidget*>("recentProjects");
    ASSERT_TRUE(list);
    EXPECT_TRUE(list->item(0)->text().contains(QDir::toNativeSeparators(folder.path())))
        << "two projects of one name are told apart";
}

} // namespace
} // namespace plc::app
