#include "app/cli/remote/commands.h"

#include "app/cli/devices/device_output.h"
#include "app/cli/kit/errors.h"
#include "app/cli/panels/panel_findings.h"
#include "app/cli/run/recorded_run.h"
#include "app/cli/run/run_output.h"
#include "app/serve/errors.h"
#include "app/serve/serve.h"
#include "app/serve/state_place.h"

#include <QDateTime>

#include <filesystem>
#include <iostream>

namespace plc::cli {

namespace {

Result<uint64_t> parseSize(const std::string& text) {
    uint64_t factor = 1;
    std::string digits = text;
    if (!digits.empty())
        for (const auto& [letter, shift] : {std::pair('k', 10), std::pair('M', 20), std::pair('G', 30)})
            if (digits.back() == letter) factor = uint64_t(1) << shift;
    if (factor > 1) digits.pop_back();
    const auto count = parseCount(digits);
    if (!count || *count > (uint64_t(1) << 44) / factor) return Error{errors::NotASize(text), {}};
    return *count * factor;
}

Result<serve::ServeSettings> readSettings(const Arguments& arguments, const projects::Project& project) {
    serve::ServeSettings out;
    out.server.name = project.name;
    if (const auto text = arguments.value("--port")) {
        const auto port = parseCount(*text);
        if (!port || *port > 65535) return Error{errors::PortRange(*text), {}};
        out.server.port = static_cast<quint16>(*port);
    }
    if (const auto text = arguments.value("--address"))
        if (!out.server.address.setAddress(QString::fromStdString(*text)))
            return Error{serve::errors::AddressNotNumeric(*text), {}};
    out.server.certificate = QString::fromStdString(arguments.value("--certificate").value_or(""));
    out.server.key = QString::fromStdString(arguments.value("--key").value_or(""));
    if (out.server.certificate.isEmpty() != out.server.key.isEmpty()) return Error{errors::CertificateNeedsKey(), {}};
    out.tokenFile = arguments.value("--access-code").value_or("");
    const std::filesystem::path home =
        project.folder.empty() ? std::filesystem::current_path() : std::filesystem::path(project.folder);
    const auto state = arguments.value("--state");
    out.stateFolder = state ? *state : serve::stateFolderOf(home, serve::surroundings()).string();
    if (const auto text = arguments.value("--trial")) {
        const auto length = parseDuration(*text);
        if (!length) return length.error();
        out.trialLength = *length;
    }
    if (const auto text = arguments.value("--recording-size")) {
        const auto size = parseSize(*text);
        if (!size) return size.error();
        out.recordingLimit = *size;
    }
    out.allowsBreakpoints = arguments.has("--allow-breakpoints");
    if (arguments.has("--real-time")) out.realTime.emplace();
    if (const auto text = arguments.value("--core")) {
        const auto core = parseCount(*text);
        if (!core || *core >= std::thread::hardware_concurrency()) return Error{errors::NoSuchCore(*text), {}};
        if (!out.realTime) out.realTime.emplace();
        out.realTime->core = static_cast<int>(*core);
    }
    return out;
}

template <class Counts> void printHistogram(const Counts& counts) {
    for (size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0) std::cout << "  up to " << (uint64_t(1) << i) << " us: " << counts[i] << "\n";
}

/// How late scans began and ended, and which ended latest: `stepwise replay` shows them in the recording.
void printScanTimes(const session::ScanTimes& times) {
    for (const auto& [what, of] : {std::pair("wake-up", &times.wakeUp), std::pair("execution", &times.execution),
                                   std::pair("end of scan", &times.end)}) {
        std::cout << what << ": mean " << static_cast<int64_t>(of->meanNs()) / 1000 << " us, most "
                  << of->mostNs() / 1000 << " us\n";
        printHistogram(of->buckets());
    }
    for (const session::ScanTime& scan : times.worst)
        std::cout << "scan " << scan.scan << " at " << types::durationText(scan.at.count()) << " began "
                  << scan.wakeUpNs / 1000 << " us late and ran " << scan.executionNs / 1000 << " us\n";
}

/// Execution times in powers of two of a microsecond, the greatest lateness of a start beside them.
void printStatistics(const std::vector<controller::TaskStatistics>& tasks) {
    for (const controller::TaskStatistics& task : tasks) {
        std::cout << task.name << ": " << task.count << " runs, " << task.overruns << " overruns, least "
                  << task.minNs / 1000 << " us, mean " << static_cast<int64_t>(task.meanNs) / 1000 << " us, most "
                  << task.maxNs / 1000 << " us, latest start " << task.jitterNs / 1000 << " us\n";
        printHistogram(task.histogram);
    }
}

/// What operators read beside an alarm: the local date and time, in nanoseconds as DATE_AND_TIME has them.
int64_t timeOnTheWall() {
    const QDateTime now = QDateTime::currentDateTime();
    return (now.toMSecsSinceEpoch() + now.offsetFromUtc() * 1000LL) * 1'000'000;
}

int runServe(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("serve")), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const auto settings = readSettings(arguments, *project);
    if (!settings) return wrongUse(settings.error());
    driver::Built built = driver::build(project->buildInput());
    printDiagnostics(built.checked, false, false);
    if (built.checked.analysis->hasErrors) return kProgramWrong;
    if (!built.program)
        return wrongUse({built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project->name});
    if (auto optimised = driver::optimise(built); !optimised) return wrongUse(optimised.error());
    const auto state = serve::StateFolder::open(settings->stateFolder);
    if (!state) return wrongUse(state.error());
    session::Settings forSession;
    forSession.retainFile = serve::retainFileOf(*settings);
    forSession.historyBudget = size_t(64) << 20; // the rest is on disk
    forSession.retainInterval = std::chrono::seconds(1);
    if (auto set = setCalendarStart(arguments, *project, forSession); !set) return wrongUse(set.error());
    const bool isDateGiven = arguments.has("--start") || !project->calendarStart.empty();
    if (!isDateGiven && !settings->trial) forSession.controller.calendarStartNs = timeOnTheWall();
    catchInterrupt();
    needApplication();
    hmi::PanelProject panels = hmi::loadPanelProject(*project);
    for (const Error& problem : panels.problems) std::cerr << problem.english() << "\n";
    if (auto chosen = hmi::chooseTheme(panels, arguments.value("--theme").value_or("")); !chosen)
        return wrongUse(chosen.error());
    std::unique_ptr<devices::Engine> engine;
    if (arguments.has("--devices")) {
        auto made = makeEngine(*project, &built.program->layout);
        if (!made) return wrongUse(made.error());
        engine = std::move(*made);
    }
    serve::Trial trial;
    session::Session session(std::move(built), forSession);
    if (settings->trialLength) trial.watch(session, *settings->trialLength);
    if (engine) {
        engine->attach(session.controller());
        engine->connect();
    }
    if (const Message problem = session.status().retainProblem; !problem.isEmpty())
        std::cerr << "stepwise: " << problem << "\n";
    serve::ServeSettings forServer = *settings;
    forServer.devices = engine.get();
    if (settings->trialLength) forServer.trial = &trial;
    const auto served = serve::serve(panels, session, forServer, isInterrupted);
    if (engine) engine->disconnect();
    if (!served) return wrongUse(served.error());
    if (arguments.has("--stats")) {
        printStatistics(session.taskStatistics());
        printScanTimes(session.scanTimes());
    }
    if (const Message problem = session.status().retainProblem; !problem.isEmpty()) {
        std::cerr << "stepwise: " << problem << "\n";
        return kWrongUse;
    }
    return kGood;
}

} // namespace

Command serveCommand() {
    return {
        {"serve",
         "PROJECT [OPTIONS]",
         "Runs the controller in real time, without a window, and shows its panels in browsers.",
         {{"--port", "8080", "the port to listen on; 0 selects a free one"},
          {"--address", "127.0.0.1", "the address to listen on (default: this computer only); 0.0.0.0 for all"},
          {"--certificate", "FILE", "serve by TLS with this certificate (PEM), and --key"},
          {"--key", "FILE", "the private key of the certificate (PEM)"},
          {"--access-code", "FILE",
           "the access code for operating, not only viewing (default: generated in the state folder)"},
          {"--state", "DIR",
           "retained variables, codes and recording (default: .stepwise/serve in the project; of an installed example "
           "in ~/.local/state/stepwise)"},
          {"--recording-size", "256M", "bytes of the recording on disk, oldest deleted first; 0 for none"},
          {"--real-time", "", "ask for locked memory and SCHED_FIFO; says what was granted"},
          {"--core", "N", "runs the scan thread on this core only, with --real-time"},
          {"--theme", "NAME", "show all panels in this theme: light, dark, contrast, or one of hmi/themes"},
          {"--devices", "", "connect the devices of devices.json"},
          {"--allow-breakpoints", "", "attached studios may stop the controller inside a scan"},
          {"--stats", "", "at the end how long tasks ran, how late scans began and ended, and the latest scans"},
          {"--trial", "24h", "this much plant time as fast as the machine can, then the end: what a day needs of disk"},
          {"--start", "DT#2026-01-01-06:00:00",
           "calendar at the first scan; the date and time of this computer if neither this nor the project gives one"},
          {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"}},
         "stepwise serve projects/examples/alarm_texts --port 8080"},
        runServe};
}

} // namespace plc::cli
