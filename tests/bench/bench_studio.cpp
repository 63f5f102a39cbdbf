// What the engineer waits for in the real window, on a project of 10,000 lines: start, open, keystroke to diagnostics,
// completion, rename; and what the window costs while a program runs at 1 ms with online values, watch and trace in
// sight. Needs no display: QT_QPA_PLATFORM=offscreen bench_studio [LINES [SECONDS]]
#include "app/main_window.h"
#include "app/pages/editor_tabs.h"
#include "app/panels/live_views.h"
#include "app/settings/settings.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/theme.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "tests/bench/program_generator.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <unistd.h>

using namespace plc;

namespace {

double seconds(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Since the process began, loading of the program included.
double sinceStart() {
    std::ifstream file("/proc/self/stat");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    text.erase(0, text.rfind(')') + 2);
    double ticks = 0;
    size_t at = 0;
    for (int field = 3; field < 22; ++field) at = text.find(' ', at) + 1;
    ticks = std::strtod(text.c_str() + at, nullptr);
    return seconds(CLOCK_BOOTTIME) - ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Counts what is painted anywhere in the window.
class PaintWatch : public QObject {
public:
    int paints = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        paints += event->type() == QEvent::Paint;
        return false;
    }
};

bool runUntil(const std::function<bool()>& condition, int ms = 20'000) {
    QElapsedTimer timer;
    timer.start();
    while (!condition() && timer.elapsed() < ms)
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 5);
    return condition();
}

/// What the measured action is not to pay for: lists that are filled late, pictures that are drawn again.
void letItRest() {
    QTest::qWait(300); // a duration: nothing tells when the last of them is done
}

struct Figures {
    std::vector<double> ms;
    void add(double seconds) { ms.push_back(seconds * 1e3); }
    void print(const char* name, const char* target = "") {
        std::sort(ms.begin(), ms.end());
        if (ms.empty())
            std::printf("%-46s        –\n", name);
        else
            std::printf("%-46s %8.1f ms   worst %8.1f ms   %s\n", name, ms[ms.size() / 2], ms.back(), target);
        std::fflush(stdout);
    }
};

void writeFile(const QString& path, const std::string& text) {
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) file.write(QByteArray::fromStdString(text));
}

} // namespace

int main(int argc, char** argv) {
    const size_t lines = argc > 1 ? static_cast<size_t>(std::atoi(argv[1])) : 10'000;
    const int runFor = argc > 2 ? std::atoi(argv[2]) : 10;
    QTemporaryDir scratch;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, scratch.path());
    QApplication application(argc, argv);
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    app::Settings().setSawTour();
    kit::Theme::install(application, kit::ThemeChoice::Light);
    PaintWatch paints;
    application.installEventFilter(&paints);

    // ---- start
    app::MainWindow window;
    window.resize(1440, 900);
    window.show();
    runUntil([&] { return paints.paints > 0; });
    QCoreApplication::processEvents();
    std::printf("%-46s %8.1f ms\n", "start of the process to the first paint", sinceStart() * 1e3);

    // ---- open
    const QString folder = scratch.path() + "/plant";
    writeFile(folder + "/project.json", "{\n  \"name\": \"Plant\",\n  \"libraries\": []\n}\n");
    writeFile(folder + "/src/plant.st",
              bench::generateProgram(lines) +
                  "\nCONFIGURATION Plc\n    RESOURCE Cpu ON Pc\n        TASK Fast(INTERVAL := T#1ms, PRIORITY := 1);\n "
                  "       PROGRAM Main WITH Fast : Main;\n    END_RESOURCE\nEND_CONFIGURATION\n");
    double begin = seconds(CLOCK_MONOTONIC);
    window.openProject(folder);
    auto* page = window.tabs().openFile("src/plant.st");
    QCoreApplication::processEvents();
    std::printf("%-46s %8.1f ms\n", "open, the text in sight", (seconds(CLOCK_MONOTONIC) - begin) * 1e3);
    runUntil([&] { return window.workspace().model() != nullptr; });
    QCoreApplication::processEvents();
    std::printf("%-46s %8.1f ms\n", "open, checked and the tree filled", (seconds(CLOCK_MONOTONIC) - begin) * 1e3);
    std::fflush(stdout);

    editor::StEditor& editor = page->first();
    const std::string text = editor.utf8();
    const auto middle = static_cast<uint32_t>(text.find("edge(CLK := start);", text.size() / 2));
    const auto isChecked = [&] {
        const auto model = window.workspace().model();
        const auto id = model ? model->fileOf("src/plant.st") : std::nullopt;
        return id && model->sources()[*id].text() == window.workspace().text("src/plant.st");
    };

    // ---- keystrokes
    Figures shown, key, gone;
    editor.goTo(middle);
    letItRest();
    for (int i = 0; i < 15; ++i) {
        begin = seconds(CLOCK_MONOTONIC);
        QTest::keyClick(editor.viewport(), 'y');
        QCoreApplication::processEvents();
        key.add(seconds(CLOCK_MONOTONIC) - begin);
        runUntil([&] { return !editor.diagnosticsHere().empty(); });
        QCoreApplication::processEvents();
        shown.add(seconds(CLOCK_MONOTONIC) - begin);
        QTest::keyClick(editor.viewport(), Qt::Key_Escape);
        begin = seconds(CLOCK_MONOTONIC);
        QTest::keyClick(editor.viewport(), Qt::Key_Backspace);
        QCoreApplication::processEvents();
        runUntil([&] { return editor.diagnosticsHere().empty() && isChecked(); });
        gone.add(seconds(CLOCK_MONOTONIC) - begin);
    }
    key.print("keystroke to its letter in sight", "target 16 ms");
    shown.print("keystroke to its diagnostic shown", "target 300 ms, 150 ms of them the pause in typing");
    gone.print("keystroke to the diagnostic gone");

    // ---- completion
    Figures members, names;
    for (int i = 0; i < 10; ++i) {
        QTest::keyClicks(editor.viewport(), "fillTime");
        QTest::keyClick(editor.viewport(), Qt::Key_Escape);
        runUntil(isChecked);
        begin = seconds(CLOCK_MONOTONIC);
        QTest::keyClick(editor.viewport(), '.');
        runUntil([&] { return editor.isListActive(); }, 3000);
        members.add(seconds(CLOCK_MONOTONIC) - begin);
        QTest::keyClick(editor.viewport(), Qt::Key_Escape);
        while (editor.cursorOffset() > middle) QTest::keyClick(editor.viewport(), Qt::Key_Backspace);
        runUntil(isChecked);
        begin = seconds(CLOCK_MONOTONIC);
        editor.triggerCompletion();
        runUntil([&] { return editor.isListActive(); }, 3000);
        names.add(seconds(CLOCK_MONOTONIC) - begin);
        QTest::keyClick(editor.viewport(), Qt::Key_Escape);
    }
    members.print("completion of members after a dot", "target 50 ms");
    names.print("completion of every name", "target 50 ms");

    // ---- rename
    Figures edits, applied;
    size_t places = 0;
    for (int i = 0; i < 6; ++i) {
        const std::string from = i % 2 == 0 ? "ScaleReading" : "ScaledReading",
                          to = i % 2 == 0 ? "ScaledReading" : "ScaleReading";
        runUntil(isChecked);
        const auto model = window.workspace().model();
        begin = seconds(CLOCK_MONOTONIC);
        const auto found = model->rename(*model->fileOf("src/plant.st"),
                                         static_cast<uint32_t>(editor.utf8().find("FUNCTION " + from) + 9), to);
        if (!found) {
            std::fprintf(stderr, "rename: %s\n", found.error().english().c_str());
            return 1;
        }
        edits.add(seconds(CLOCK_MONOTONIC) - begin);
        places = 0;
        for (const auto& file : *found) places += file.edits.size();
        window.tabs().applyEdits(*found, model->sources());
        QCoreApplication::processEvents();
        applied.add(seconds(CLOCK_MONOTONIC) - begin);
    }
    edits.print("rename: finding the places");
    applied.print("rename: places changed and in sight", "target 200 ms");
    std::printf("%-46s %8zu\n", "    places", places);
    runUntil(isChecked);

    // ---- the window while it runs
    window.showDock("watch");
    window.watch().setExpressions({"Main.tick", "Main.level", "Main.station1", "Main.station1.mean",
                                   "Main.station1.mode", "Main.station2.message", "Main.station3.fillTime.ET",
                                   "plantRunning"});
    window.showDock("trace");
    for (const char* channel : {"Main.level", "Main.station1.mean", "Main.station1.mode", "Main.station1.heater"})
        window.live().traceView().addChannel(channel);
    editor.goTo(static_cast<uint32_t>(editor.utf8().find("PROGRAM Main")));
    window.action("run.start")->trigger();
    if (!runUntil([&] { return window.control().status().scans > 500; })) {
        std::fprintf(stderr, "the program does not run\n");
        return 1;
    }
    const auto inSight = [](QWidget* widget) {
        return widget && widget->isVisible() && !widget->visibleRegion().isEmpty();
    };
    std::printf("in sight: text %d, watch %d, trace %d\n", inSight(&editor), inSight(&window.watch()),
                inSight(&window.live().traceView()));
    const auto measure = [&](const char* name) {
        const session::Status before = window.control().status();
        paints.paints = 0;
        const double wall = seconds(CLOCK_MONOTONIC), thread = seconds(CLOCK_THREAD_CPUTIME_ID),
                     process = seconds(CLOCK_PROCESS_CPUTIME_ID);
        QTest::qWait(runFor * 1000); // a duration: over which is measured
        const double took = seconds(CLOCK_MONOTONIC) - wall, own = seconds(CLOCK_THREAD_CPUTIME_ID) - thread,
                     all = seconds(CLOCK_PROCESS_CPUTIME_ID) - process;
        const session::Status after = window.control().status();
        std::printf("%-46s %8.1f %% of a core   all threads %.1f %%   %.0f scans/s, %llu skipped, %.0f paints/s\n",
                    name, own / took * 100, all / took * 100, static_cast<double>(after.scans - before.scans) / took,
                    static_cast<unsigned long long>(after.skippedScans - before.skippedScans), paints.paints / took);
        std::fflush(stdout);
    };
    QTest::qWait(5000); // a duration: optimised code is made meanwhile
    measure("window: values, watch and trace");
    window.dock("trace")->hide();
    letItRest();
    measure("window: values and watch");
    window.dock("watch")->hide();
    letItRest();
    measure("window: values");
    window.action("view.values")->trigger();
    letItRest();
    measure("window: the program only");
    window.control().disconnectSession();
    return 0;
}
