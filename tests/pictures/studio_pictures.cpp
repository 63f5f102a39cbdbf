// Makes docs/pictures: drives the real window on the shipped examples and saves what it shows, light and dark. Run by
// docs/make_pictures.sh under Xvfb.
#include "app/editor_tabs.h"
#include "app/main_window.h"
#include "app/problems_view.h"
#include "app/settings.h"
#include "app/start_page.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/theme.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <functional>

using namespace plc;

namespace {

QString g_folder;

bool waitFor(const std::function<bool()>& condition, int ms = 6000) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < ms && !condition()) QTest::qWait(20);
    return condition();
}

void copyProject(const QString& from, const QString& to) {
    QDir().mkpath(to);
    for (const QFileInfo& entry : QDir(from).entryInfoList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot)) {
        if (entry.isDir()) copyProject(entry.filePath(), to + "/" + entry.fileName());
        else QFile::copy(entry.filePath(), to + "/" + entry.fileName());
    }
}

void save(QWidget& window, const QString& name) {
    QTest::qWait(150);
    const QString file = g_folder + "/" + name + (kit::colors().dark ? "_dark" : "_light") + ".png";
    // The screen, so that lists and tips over the window are seen, too.
    const QPixmap picture = window.screen()->grabWindow(0, window.x(), window.y(), window.width(), window.height());
    if (!picture.save(file)) std::fprintf(stderr, "%s can not be written\n", qPrintable(file));
    else std::printf("%s\n", qPrintable(file));
}

void takeAll(const QString& examples) {
    QTemporaryDir scratch;
    copyProject(examples + "/pid_pt1", scratch.path() + "/pid_pt1");
    app::MainWindow window;
    window.resize(1440, 900);
    window.show();
    (void)QTest::qWaitForWindowExposed(&window);
    save(window, "start_page");

    window.openProject(scratch.path() + "/pid_pt1");
    waitFor([&] { return window.workspace().model() != nullptr; });
    auto* page = window.tabs().openFile("src/main.st");
    editor::StEditor& editor = page->first();
    const auto offset = [&](const char* text) { return static_cast<uint32_t>(editor.utf8().find(text)); };

    editor.goTo(offset("ControlError := SetPoint"));
    QTest::keyClicks(editor.viewport(), "Rin := TRUE;");
    QTest::keyClick(editor.viewport(), Qt::Key_Return);
    waitFor([&] { return window.problems().errorCount() > 0; });
    QTest::keyClicks(editor.viewport(), "pid.q");
    waitFor([&] { return editor.isListActive(); }, 1500);
    save(window, "editor_completion");
    QTest::keyClick(editor.viewport(), Qt::Key_Escape);
    while (editor.isUndoAvailable()) editor.undo();
    waitFor([&] { return window.problems().errorCount() == 0; });

    window.showDock("watch");
    window.watch().setExpressions({"Main.SetPoint", "Main.ControlError", "Main.pid", "IO.Drive", "Plant.OpenLoop * 2.0"});
    window.action("run.start")->trigger();
    waitFor([&] { return window.control().status().scans > 60; }, 8000);
    editor.goTo(offset("generator(MODE"));
    save(window, "online_values");

    window.showDock("tasks");
    QTest::qWait(600);
    save(window, "task_monitor");

    const int line = static_cast<int>(editor.SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, static_cast<unsigned long>(offset("SetPoint := INT_TO_REAL")))) + 1;
    window.control().toggleBreakpoint("src/main.st", line);
    waitFor([&] { return window.control().status().state == controller::State::Halted; });
    QTest::qWait(300);
    save(window, "breakpoint");
    window.control().setBreakpoints({});
    window.control().disconnectSession();
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
        takeAll(app::StartPage::examplesFolder());
    }
    return 0;
}
