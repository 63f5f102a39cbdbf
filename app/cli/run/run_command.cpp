#include "app/cli/run/commands.h"

#include "app/cli/devices/device_output.h"
#include "app/cli/kit/errors.h"
#include "app/cli/run/recorded_run.h"
#include "app/cli/run/run_output.h"
#include "app/cli/run/timed_write.h"
#include "projects/session/session.h"
#include "projects/session/value_text.h"
#include "projects/storage/project_file.h"
#include "runtime/base/text.h"
#include "runtime/controller/leave_hook.h"
#include "runtime/types/conversion.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <thread>

namespace plc::cli {

namespace {

using std::chrono::nanoseconds;

struct RunPlan {
    std::optional<nanoseconds> length;
    std::optional<uint64_t> scans;
    expression::Expression until;
    std::vector<TimedWrite> writes; // by time
    std::vector<Watch> watches;
    bool isReal = false;
    double speed = 1.0;
};

Result<RunPlan> planRun(const Arguments& arguments, const driver::Built& built,
                        const controller::Controller& controller) {
    RunPlan plan;
    if (const auto text = arguments.value("--for")) {
        const auto length = parseDuration(*text);
        if (!length) return length.error();
        plan.length = *length;
    }
    if (const auto text = arguments.value("--scans")) {
        const auto count = parseCount(*text);
        if (!count) return count.error();
        plan.scans = *count;
    }
    if (const auto text = arguments.value("--until")) {
        auto until = driver::compileExpression(built.checked, *text);
        if (!until) return Error{errors::Option(Verbatim("--until"), until.error().message), *text};
        if (until->types().storageKind(until->type()) != types::TypeKind::Bool)
            return Error{errors::UntilNeedsBool(), *text};
        plan.until = *until;
    }
    if (!plan.length && !plan.scans && !plan.until.isValid()) plan.length = std::chrono::seconds(10);
    if (const auto text = arguments.value("--speed")) {
        char* end = nullptr;
        plan.speed = std::strtod(text->c_str(), &end);
        if (end == text->c_str() || *end || !(plan.speed > 0)) return Error{errors::SpeedAboveZero(), *text};
        plan.isReal = true;
    }
    plan.isReal = plan.isReal || arguments.has("--real") || arguments.has("--devices");
    auto writes = readWrites(arguments, built.checked, controller);
    if (!writes) return writes.error();
    plan.writes = std::move(*writes);
    for (const std::string& text : arguments.values("--watch")) {
        auto expression = driver::compileExpression(built.checked, text);
        if (!expression) return Error{errors::Option(Verbatim("--watch"), expression.error().message), text};
        plan.watches.push_back({text, *expression});
    }
    if (plan.watches.empty()) plan.watches = allVariables(built);
    return plan;
}

/// A missing folder is reported before hours are simulated, not after.
template <class What> Result<void> checkFolder(const std::string& file, const What& missing) {
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return {};
    return Error{missing(folder.string()), file};
}

/// Why a run with --until ended before; nothing when it did come true.
Message untilProblem(const RunPlan& plan, const std::string& text, const controller::Controller& controller) {
    if (!plan.until.isValid() || controller.fault() || plan.until.isTrue(controller.image())) return {};
    const expression::Outcome last = plan.until.evaluate(controller.image());
    return last.hasValue() ? errors::UntilNotTrue(text) : errors::HasNoValue(Verbatim("--until " + text), last.reason);
}

/// Drives the controller scan by scan and hands each finished scan to the CSV.
Result<void> runScans(const RunPlan& plan, const driver::Built& built, session::Session& session, CsvWriter& csv) {
    controller::Controller& controller = session.controller();
    controller.start();
    ProgressLine progress;
    size_t nextWrite = 0;
    uint64_t done = 0;
    const auto wallBegin = std::chrono::steady_clock::now();
    while (!isInterrupted() && controller.state() == controller::State::Running) {
        const nanoseconds due = controller.nextDue();
        if (plan.length && due >= *plan.length) break;
        if (plan.scans && done >= *plan.scans) break;
        if (plan.isReal) {
            const auto at =
                wallBegin +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                    std::chrono::duration<double, std::nano>(static_cast<double>(due.count()) / plan.speed));
            while (!isInterrupted() && std::chrono::steady_clock::now() < at)
                std::this_thread::sleep_until(
                    std::min(at, std::chrono::steady_clock::now() + std::chrono::milliseconds(50)));
            if (isInterrupted()) break;
        }
        for (; nextWrite < plan.writes.size() && plan.writes[nextWrite].at <= due; ++nextWrite)
            if (auto written = apply(built.checked, controller, plan.writes[nextWrite]); !written) return written;
        controller.scan();
        ++done;
        csv.scanFinished(controller);
        if (plan.until.isValid() && plan.until.isTrue(controller.image())) break;
        if ((done & 0xfff) == 0)
            progress.show("scan " + std::to_string(done) + ", " + types::durationText(controller.lastTime().count()));
    }
    return {};
}

int runProject(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("run")), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const driver::Built built = [&] {
        const Busy busy("building " + project->name);
        return driver::build(project->buildInput());
    }();
    const bool json = arguments.wantsJson();
    if (built.checked.analysis->hasErrors) {
        printDiagnostics(built.checked, json, false);
        return kProgramWrong;
    }
    if (!json) printDiagnostics(built.checked, false, false);
    if (!built.program)
        return wrongUse({built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project->name});
    if (built.program->tasks.empty()) {
        std::cerr << "stepwise: " << project->name << ": there is no PROGRAM to run\n";
        return kProgramWrong;
    }
    {
        const Busy busy("optimising " + project->name);
        if (auto optimised = driver::optimise(built); !optimised) return wrongUse(optimised.error());
    }

    session::Settings settings;
    settings.record = arguments.has("--record");
    settings.retainFile = arguments.value("--retain").value_or("");
    if (const auto file = arguments.value("--retain"))
        if (auto good = checkFolder(*file, errors::NoFolderForRetain); !good) return wrongUse(good.error());
    if (const auto file = arguments.value("--record"))
        if (auto good = checkFolder(*file, errors::NoFolderForRecording); !good) return wrongUse(good.error());
    if (auto set = setCalendarStart(arguments, *project, settings); !set) return wrongUse(set.error());
    catchInterrupt();
    std::unique_ptr<devices::Engine> engine;
    if (arguments.has("--devices")) {
        auto made = makeEngine(*project, &built.program->layout);
        if (!made) return wrongUse(made.error());
        engine = std::move(*made);
    }
    session::Session session(built, settings);
    if (engine) engine->attach(session.controller());
    controller::setLeaveHook(session.controller(), isInterrupted);
    const auto plan = planRun(arguments, built, session.controller());
    if (!plan) return wrongUse(plan.error());
    CsvWriter csv(plan->watches);
    if (const auto every = arguments.value("--every"); every && *every != "scan") {
        const auto interval = parseDuration(*every);
        if (!interval || interval->count() <= 0)
            return wrongUse(interval ? Error{errors::EveryScanOrTime(), *every} : interval.error());
        csv.setInterval(*interval);
    }
    if (const auto file = arguments.value("--csv"))
        if (auto opened = csv.open(*file); !opened) return wrongUse(opened.error());
    if (engine) engine->connect();
    if (auto ran = runScans(*plan, built, session, csv); !ran) return wrongUse(ran.error());

    if (const Message problem = session.status().retainProblem; !problem.isEmpty())
        std::cerr << "stepwise: " << problem << "\n";
    if (const Message problem = untilProblem(*plan, arguments.value("--until").value_or(""), session.controller());
        !problem.isEmpty())
        std::cerr << "stepwise: " << problem << "\n";
    RunReport report{session.controller(), built, plan->watches, arguments.has("--stats")};
    (arguments.value("--csv") == "-" ? std::cerr : std::cout)
        << (json ? report.toJson() : report.toText(wantsColours(1)));
    if (engine && !json) std::cerr << statusText(engine->status());
    const bool faulted = session.controller().state() == controller::State::Fault;
    session.controller().stop();
    if (engine) engine->disconnect(); // with the safe outputs of the stop
    // One file that cannot be written costs neither the values nor the other files.
    std::optional<Error> problem;
    const auto note = [&](const Result<void>& done) {
        if (!done && problem) std::cerr << "stepwise: " << done.error().english() << "\n";
        if (!done && !problem) problem = done.error();
    };
    note(csv.close());
    if (const auto file = arguments.value("--record")) note(session.history().save(*file));
    if (!settings.retainFile.empty()) note(session.saveRetained());
    if (problem) return wrongUse(*problem);
    return faulted ? kProgramWrong : kGood;
}

} // namespace

Command runCommand() {
    return {{"run",
             "PATH… [OPTIONS]",
             "Runs a project, or ST files, in virtual time and prints the values.",
             {{"--for", "10s", "PLC time to run (default 10s)"},
              {"--scans", "N", "number of scans to run"},
              {"--until", "EXPR", "run until the ST expression is true"},
              {"--real", "", "in real time instead of as fast as possible"},
              {"--speed", "10", "that many times faster than real time"},
              {"--set", "PATH=VALUE[@TIME]", "write before the first scan at or after TIME (repeatable)"},
              {"--force", "PATH=VALUE[@TIME]", "force likewise; VALUE RELEASE ends it (repeatable)"},
              {"--watch", "EXPR", "a value to show and record (repeatable; default: all variables)"},
              {"--csv", "FILE", "write a row per scan: time_s, scan, the watches; - is the standard output"},
              {"--every", "scan|100ms", "a row for each scan (default) or each interval"},
              {"--record", "FILE", "save the recording of every scan, for replay and the studio"},
              {"--devices", "", "connect the devices of devices.json; in real time"},
              {"--retain", "FILE", "restore retained variables from FILE, save them there at the end"},
              {"--start", "DT#2026-01-01-06:00:00", "calendar at the first scan"},
              {"--stats", "", "also task statistics"},
              {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"},
              {"--format", "text|json", "text (default) or one JSON object"}},
             "stepwise run projects/examples/motor --for 5s --set 'Plant.StartButton=TRUE@1s' --watch IO.K1 --csv "
             "motor.csv "
             "--record motor.rec"},
            runProject};
}

} // namespace plc::cli
