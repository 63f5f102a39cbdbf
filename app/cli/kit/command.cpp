#include "app/cli/kit/command.h"

#include "app/cli/kit/errors.h"
#include "app/cli/kit/interrupt.h"
#include "editor/kit/theme.h"
#include "projects/exchange/import.h"
#include "projects/storage/project_file.h"
#include "runtime/base/text.h"
#include "runtime/platform/streams.h"

#include <QApplication>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

namespace plc::cli {

namespace {
std::atomic<int> g_interrupts = 0;
std::atomic<Progress*> g_cancelled = nullptr; // what a handler touches: without locks
static_assert(std::atomic<Progress*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
              std::atomic<int>::is_always_lock_free);

extern "C" void onInterrupt(int) {
    const int before = g_interrupts++;
    if (Progress* work = g_cancelled) work->cancel();
    if (before > 0) std::_Exit(kInterrupted);
}

} // namespace

int wrongUse(const Error& error) {
    std::cerr << "stepwise: " << error.english() << "\n";
    return kWrongUse;
}

namespace {

/// Files of TwinCAT, CODESYS and PLCopen XML are imported in memory, everything else is a project of ours.
Result<projects::Project> openPaths(const std::vector<std::string>& paths) {
    const bool isForeign = std::any_of(paths.begin(), paths.end(), exchange::isForeignFile);
    if (!isForeign) return projects::openProject(paths);
    auto imported = exchange::importFiles(paths);
    if (!imported) return imported.error();
    for (const exchange::Note& note : imported->report.notes)
        if (exchange::severityOf(note.kind) == exchange::NoteSeverity::Loss)
            std::cerr << note.place << ": " << note.message.english() << "\n";
    return exchange::toProject(*imported);
}

} // namespace

Result<projects::Project> openNamedProject(const Arguments& arguments) {
    return openNamedProject(arguments, arguments.paths());
}

Result<projects::Project> openNamedProject(const Arguments& arguments, const std::vector<std::string>& paths) {
    auto project = openPaths(paths);
    if (!project) return project;
    const auto known = driver::libraryNames();
    for (const std::string& value : arguments.values("--library")) {
        const std::string name = foldCase(value);
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            const auto near = nearestName(name, known);
            return Error{near ? errors::NoLibrarySuggest(value, *near) : errors::NoSuchLibrary(value), ""};
        }
        project->libraries.push_back(name);
    }
    return project;
}

bool printDiagnostics(const driver::Checked& checked, bool asJson, bool withInfos,
                      const std::vector<std::string>& moreJson, Entry entry) {
    const bool colours = wantsColours(platform::kStandardError);
    std::string out;
    size_t shown = 0;
    bool hasErrors = false;
    for (diagnostics::Diagnostic diagnostic : checked.analysis->diagnostics) {
        if (entry == Entry::Optional && diagnostic.kind == diagnostics::Kind::SeveralPrograms)
            diagnostic.severity = diagnostics::Severity::Warning;
        hasErrors |= diagnostic.severity == diagnostics::Severity::Error;
        if (!withInfos && diagnostic.severity == diagnostics::Severity::Info) continue;
        out += asJson ? (shown ? ",\n " : "[") + diagnostics::renderJson(*checked.sources, diagnostic)
                      : diagnostics::renderText(*checked.sources, diagnostic, colours);
        ++shown;
    }
    for (const std::string& object : moreJson) out += (shown++ ? ",\n " : "[") + object;
    if (asJson)
        std::cout << (shown ? out + "]" : "[]") << "\n";
    else
        std::cerr << out;
    return hasErrors;
}

void needApplication() {
    if (QCoreApplication::instance()) return;
    static const QtMessageHandler others =
        qInstallMessageHandler([](QtMsgType type, const QMessageLogContext& context, const QString& text) {
            if (!text.startsWith("QStandardPaths:") && others)
                others(type, context, text); // where there is no session, nobody asked for one
        });
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    static int count = 1;
    static char name[] = "stepwise";
    static char* words[] = {name, nullptr};
    // Never destroyed: at the end of the process what its fonts and plugins hold may be gone before it.
    static const auto* const application = new QApplication(count, words);
    (void)application;
    kit::Theme::current();
}

bool wantsColours(int fileDescriptor) { return platform::isTerminal(fileDescriptor) && !std::getenv("NO_COLOR"); }
bool isInterrupted() { return g_interrupts != 0; }
void catchInterrupt() { platform::catchInterrupts(onInterrupt); }

InterruptCancels::InterruptCancels(Progress& work) {
    g_cancelled = &work;
    catchInterrupt();
}
InterruptCancels::~InterruptCancels() { g_cancelled = nullptr; }

int interruptedAnswer() {
    std::cerr << "stepwise: " << errors::AnswerInterrupted().english() << "\n";
    return kInterrupted;
}

std::string jsonString(std::string_view text) {
    return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void ProgressLine::show(const std::string& text) {
    const auto now = std::chrono::steady_clock::now();
    if (now - m_begin < std::chrono::seconds(1) || now - m_last < std::chrono::milliseconds(100) ||
        !platform::isTerminal(platform::kStandardError))
        return;
    m_last = now;
    m_isShown = true;
    std::fprintf(stderr, "\r\033[K%s", text.c_str());
    std::fflush(stderr);
}

ProgressLine::~ProgressLine() {
    if (m_isShown) std::fprintf(stderr, "\r\033[K");
}

Busy::Busy(std::string what)
    : m_thread([what = std::move(what)](const std::stop_token& stop) {
          ProgressLine line;
          for (int ticks = 0; !stop.stop_requested(); ++ticks) {
              std::this_thread::sleep_for(std::chrono::milliseconds(20));
              if (ticks % 5 == 0) line.show(what + ", " + std::to_string(ticks / 50) + " s");
          }
      }) {}

} // namespace plc::cli
