// Makes docs/pictures: drives the real window on the shipped examples and saves what it shows, light and dark. Run by
// docs/make_pictures.sh under Xvfb; with a second argument only those of "start", "loop", "chart" or "inside".
#include "app/documents/design_pages.h"
#include "app/main_window.h"
#include "app/online/inside_views.h"
#include "app/pages/editor_tabs.h"
#include "app/panels/live_views.h"
#include "app/project/problems_view.h"
#include "app/settings/settings.h"
#include "app/start/start_page.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/graph/chart/chart_view.h"
#include "editor/kit/theme.h"
#include "editor/plot/plot_view.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <cstdio>
#include <functional>

using namespace plc;

namespace {

QString g_folder;

bool waitFor(const std::function<bool()>& condition, int ms = 6000) { return QTest::qWaitFor(condition, ms); }

void copyProject(const QString& from, const QString& to) {
    QDir().mkpath(to);
    for (const QFileInfo& entry : QDir(from).entryInfoList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot)) {
        if (entry.isDir())
            copyProject(entry.filePath(), to + "/" + entry.fileName());
        else
            QFile::copy(entry.filePath(), to + "/" + entry.fileName());
    }
}

void save(QWidget& window, const QString& name) {
    QTest::qWait(600); // a duration: values refresh, a list slides and a curve is drawn some frames later
    const QString file = g_folder + "/" + name + (kit::colors().dark ? "_dark" : "_light") + ".png";
    // The screen, so that lists and tips over the window are seen, too.
    const QPixmap picture = window.screen()->grabWindow(0, window.x(), window.y(), window.width(), window.height());
    if (!picture.save(file))
        std::fprintf(stderr, "%s cannot be written\n", qPrintable(file));
    else
        std::printf("%s\n", qPrintable(file));
}

void hideDocks(app::MainWindow& window) {
    for (const char* side :
         {"forces", "callPath", "breakpoints", "panel", "watch", "trace", "problems", "search", "tasks", "log"})
        window.dock(side)->hide();
}

/// The pictures on the PID example: text, values, watch, trace, breakpoint, panel.
void takeLoop(app::MainWindow& window, const QString& project) {
    window.openProject(project);
    waitFor([&] { return window.workspace().model() != nullptr; });
    auto* page = window.tabs().openFile("src/main.st");
    editor::StEditor& editor = page->first();
    const auto offset = [&](const char* text) { return static_cast<uint32_t>(editor.utf8().find(text)); };

    editor.goTo(offset("ControlError := SetPoint"));
    QTest::keyClicks(editor.viewport(), "Rin := TRUE;");
    QTest::keyClick(editor.viewport(), Qt::Key_Return);
    QTest::keyClicks(editor.viewport(), "SetPoint := Sine;");
    QTest::keyClick(editor.viewport(), Qt::Key_Escape);
    QTest::keyClick(editor.viewport(), Qt::Key_Return);
    waitFor([&] { return window.problems().errorCount() > 1; });
    window.showDock("problems");
    save(window, "problems");
    QTest::keyClicks(editor.viewport(), "pid.q");
    waitFor([&] { return editor.isListActive(); }, 1500);
    save(window, "editor_completion");
    QTest::keyClick(editor.viewport(), Qt::Key_Escape);
    while (editor.isUndoAvailable()) editor.undo();
    waitFor([&] { return window.problems().errorCount() == 0; });

    window.showDock("watch");
    window.showDock("trace");
    window.watch().setExpressions({"Main.SetPoint", "Main.ControlError", "Main.Kp", "Main.parameters", "IO.Drive",
                                   "Plant.OpenLoop * 2.0", "Main.Run AND NOT Main.Manual"});
    window.action("run.start")->trigger();
    waitFor([&] { return window.control().status().scans > 60; }, 8000);
    editor.goTo(offset("generator(MODE"));
    save(window, "online_values");

    (void)window.control().force("Main.Kp", "2.5");
    QTreeWidget& tree = window.watch().tree();
    tree.topLevelItem(3)->setExpanded(true);
    tree.topLevelItem(0)->setText(3, "50.0");
    window.resizeDocks({window.dock("watch"), window.dock("panel")}, {560, 160}, Qt::Vertical);
    window.resizeDocks({window.dock("watch")}, {560}, Qt::Horizontal);
    window.showDock("tasks");
    save(window, "watch");
    window.control().unforce("Main.Kp");
    tree.topLevelItem(0)->setText(3, QString());
    tree.topLevelItem(3)->setExpanded(false);
    window.resetLayout();

    window.showDock("tasks");
    save(window, "task_monitor");

    const int line =
        static_cast<int>(editor.SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION,
                                              static_cast<unsigned long>(offset("SetPoint := INT_TO_REAL")))) +
        1;
    window.control().toggleBreakpoint("src/main.st", line);
    waitFor([&] { return window.control().status().state == controller::State::Halted; });
    window.showDock("callPath");
    save(window, "breakpoint");
    window.control().setBreakpoints({});
    window.control().start();

    // The trace with cursors and the measuring table, large.
    window.resetLayout();
    window.showDock("trace");
    window.dock("watch")->hide();
    for (const char* side : {"forces", "callPath", "breakpoints", "panel"}) window.dock(side)->hide();
    window.resizeDocks({window.dock("trace")}, {620}, Qt::Vertical);
    waitFor([&] { return window.control().status().time > std::chrono::seconds(6); }, 9000);
    trace::TraceView& trace = window.live().traceView();
    trace.plot()->setFollowing(false);
    trace.plot()->setRange(4'400'000'000, 5'600'000'000);
    trace.plot()->setCursorsShown(true);
    trace.plot()->setCursor(0, 4'500'000'000);
    trace.plot()->setCursor(1, 4'950'000'000);
    for (QAction* action : trace.findChildren<QAction*>())
        if (action->text() == "Measure" && !action->isChecked()) action->trigger();
    save(window, "trace");

    // Back in time: every window shows that scan.
    for (QAction* action : trace.findChildren<QAction*>())
        if (action->text() == "Measure" && action->isChecked()) action->trigger();
    trace.plot()->setCursorsShown(false);
    window.resetLayout();
    window.control().pause();
    waitFor([&] { return window.control().status().state == controller::State::Paused; });
    trace.plot()->setRange(3'000'000'000, 7'000'000'000);
    const auto position = window.live().traceView().recording()->positionAt(5'100'000'000);
    window.live().slider().variable()->setText("Main.SetPoint");
    window.live().slider().setPosition(position);
    save(window, "time_slider");
    window.control().disconnectSession();
    settle();

    hideDocks(window);
    window.designs().openPanel("loop");
    window.action("view.panelDesign")->trigger();
    save(window, "panel_designer_studio");
    window.action("view.editing")->trigger();
}

/// A chart that runs: the active step is marked.
void takeChart(app::MainWindow& window, const QString& project) {
    window.resetLayout();
    window.openProject(project);
    waitFor([&] { return window.workspace().model() != nullptr; });
    auto* page = window.tabs().openFile("src/main.st");
    page->first().goTo(static_cast<uint32_t>(page->first().utf8().find("INITIAL_STEP")));
    page->showChart("Main");
    hideDocks(window);
    window.action("run.start")->trigger();
    waitFor([&] { return window.control().status().scans > 20; }, 8000);
    (void)window.control().force("IO.SinglePb", "TRUE");
    waitFor([&] { return window.control().status().time > std::chrono::seconds(3); }, 8000);
    save(window, "chart");
    window.control().disconnectSession();
}

/// Inside a scan of the motor: exact values and an answer, the walk, coverage.
void takeInside(app::MainWindow& window, const QString& project) {
    window.resetLayout();
    window.openProject(project);
    waitFor([&] { return window.workspace().model() != nullptr; });
    editor::StEditor& editor = window.tabs().openFile("src/main.st")->first();
    hideDocks(window);
    window.action("run.start")->trigger();
    waitFor([&] { return window.control().status().scans > 30; }, 8000);
    (void)window.control().write("Plant.StartButton", "TRUE");
    waitFor([&] { return window.control().value("IO.K1").isTrue; }, 8000);
    const uint64_t pressed = window.control().status().scans;
    waitFor([&] { return window.control().status().scans > pressed + 20; }); // as long as a finger
    (void)window.control().write("Plant.StartButton", "FALSE");
    waitFor([&] { return window.control().value("Plant.Speed").text.toDouble() > 600; }, 8000);
    window.action("run.pause")->trigger();
    waitFor([&] { return window.control().status().state == controller::State::Paused; });

    editor.goTo(static_cast<uint32_t>(editor.utf8().find("K1 := K1Latch")));
    window.inside().ask(kit::AskWhy::Why, "IO.K1");
    waitFor([&] { return window.inside().whyView().tree().topLevelItemCount() > 0; }, 8000);
    window.resizeDocks({window.dock("why")}, {330}, Qt::Vertical);
    waitFor([&] { return editor.exactText().has_value(); }, 8000);
    save(window, "inside_why");

    window.dock("why")->hide();
    window.action("time.walk")->trigger();
    waitFor([&] { return window.inside().slowScan().isOpen(); }, 8000);
    const auto isAtTheSpeed = [&] {
        const editor::StEditor& shown = *window.tabs().currentEditor();
        int line = 0, column = 0;
        shown.getCursorPosition(&line, &column);
        return shown.text(line).contains("MIN(");
    };
    for (int i = 0; i < 30 && !isAtTheSpeed(); ++i) window.action("run.stepOver")->trigger();
    save(window, "inside_walk");
    window.inside().slowScan().close();
    window.dock("slowScan")->hide();

    window.action("time.coverage")->trigger();
    waitFor([&] { return !editor.coverageAt(editor.lineAt(QPoint(10, 200))).isEmpty(); }, 8000);
    save(window, "inside_coverage");
    window.action("time.noCoverage")->trigger();
    window.control().disconnectSession();
}

void takeAll(const QString& examples, const QString& only) {
    QTemporaryDir scratch;
    for (const char* each : {"pid_pt1", "agv", "motor"})
        copyProject(examples + "/" + each, scratch.path() + "/" + each);
    const auto isWanted = [&](const char* name) { return only.isEmpty() || only == name; };
    app::MainWindow window;
    window.resize(1440, 900);
    window.show();
    (void)QTest::qWaitForWindowExposed(&window);
    if (isWanted("start")) save(window, "start_page");
    if (isWanted("loop")) takeLoop(window, scratch.path() + "/pid_pt1");
    if (isWanted("chart")) takeChart(window, scratch.path() + "/agv");
    if (isWanted("inside")) takeInside(window, scratch.path() + "/motor");
}

} // namespace

int main(int argc, char** argv) {
    QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QApplication application(argc, argv);
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    g_folder = argc > 1 ? argv[1] : "docs/pictures";
    QDir().mkpath(g_folder);
    app::Settings().setSawTour();
    for (const kit::ThemeChoice choice : {kit::ThemeChoice::Light, kit::ThemeChoice::Dark}) {
        kit::Theme::install(application, choice);
        takeAll(app::StartPage::examplesFolder(), argc > 2 ? argv[2] : "");
    }
    return 0;
}
