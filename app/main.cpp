// stepwise: with a command it works without a display, else it opens the studio.
#include "app/cli/command_line.h"
#include "app/frame/kept_size.h"
#include "app/main_window.h"
#include "app/settings/settings.h"
#include "app/settings/translation.h"
#include "app/start/start_page.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include "stepwise_version.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QScreen>
#include <QTimer>

#include <algorithm>
#include <cstdio>

namespace {

/// A double click on a recording opens it.
bool isRecording(const QFileInfo& path) {
    return path.isFile() && (path.suffix() == "rec" || path.suffix() == "swrec");
}

bool isCommandLine(const std::vector<std::string>& words) {
    if (words.empty()) return false;
    const auto& commands = plc::cli::commands();
    if (std::any_of(commands.begin(), commands.end(), [&](const auto& c) { return c.spec.name == words[0]; }))
        return true;
    // A folder, project file or recording opens the studio; anything else is a mistyped command and gets the help's
    // answer.
    const QFileInfo path(QString::fromStdString(words[0]));
    return !path.isDir() && path.fileName() != "project.json" && !isRecording(path);
}

int openStudio(int argc, char** argv, const std::vector<std::string>& words) {
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        std::fprintf(
            stderr,
            "stepwise: there is no display for the studio; `stepwise --help` lists the commands that need none\n");
        return 2;
    }
    QApplication application(argc, argv);
    QApplication::setApplicationName("Stepwise");
    QApplication::setOrganizationName("Stepwise");
    QApplication::setApplicationVersion(STEPWISE_VERSION);
    plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols());
    plc::app::Settings settings;
    plc::kit::Theme::install(application, settings.theme());
    QString folder, recording;
    if (!words.empty()) {
        const QFileInfo path(QString::fromStdString(words[0]));
        if (isRecording(path))
            recording = path.absoluteFilePath();
        else
            folder = path.isDir() ? path.absoluteFilePath() : path.absolutePath();
    }
    plc::app::installTranslation(application, settings.language());
    auto window = std::make_unique<plc::app::MainWindow>();
    if (const QByteArray geometry = settings.windowGeometry(); !geometry.isEmpty()) window->restoreGeometry(geometry);
    const QSize size =
        settings.windowGeometry().isEmpty() ? plc::app::MainWindow::firstSize(*window->screen()) : window->size();
    window->show();
    plc::app::KeptSize::keep(*window, size); // all docks at once took more while it was made
    if (!folder.isEmpty()) window->openProject(folder);
    if (!recording.isEmpty()) window->showRecording(recording);
    const bool hasTour = window->workspace().isOpen() || !plc::app::StartPage::examplesInstalled().isEmpty();
    if (hasTour && !settings.sawTour()) QTimer::singleShot(400, window.get(), &plc::app::MainWindow::startTour);
    for (;;) { // once, and again for each change of the language
        bool changesLanguage = false;
        QObject::connect(window.get(), &plc::app::MainWindow::rebuildRequested, &application, [&changesLanguage] {
            changesLanguage = true;
            QApplication::exit(0);
        });
        const int code = QApplication::exec();
        if (!changesLanguage) return code;
        window = plc::app::inOtherLanguage(std::move(window), application, settings.language());
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (isCommandLine(words)) return plc::cli::runCommandLine(words);
    return openStudio(argc, argv, words);
}
