// `stepwise build`: a project as a program of its own, for machines without a compiler. The object code is ours, a
// linker of the system puts it together with the runner (runtime/runner).
#include "app/cli/program/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/run/run_output.h"
#include "runtime/base/text.h"
#include "runtime/compiler/driver/object_file.h"
#include "runtime/platform/files.h"
#include "runtime/platform/processes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace plc::cli {

namespace {

namespace fs = std::filesystem;

struct Target {
    const char* name;
    const char* triple;
    const char* cpu;
};
constexpr Target kTargets[] = {{"x86_64", "x86_64-linux-gnu", "x86-64"}, {"aarch64", "aarch64-linux-gnu", "generic"}};

#if defined(__aarch64__)
constexpr const char* kThisMachine = "aarch64";
#else
constexpr const char* kThisMachine = "x86_64";
#endif

Result<Target> targetOf(const Arguments& arguments) {
    const std::string wanted = arguments.value("--target").value_or(kThisMachine);
    for (const Target& target : kTargets)
        if (wanted == target.name) return target;
    return Error{errors::NoSuchTarget(wanted), ""};
}

/// Beside the program, in the build tree as installed: bin/stepwise and lib/stepwise/runner-aarch64.o.
Result<std::string> runnerFor(const Target& target) {
    std::error_code ignored;
    const fs::path file = fs::path(platform::ownProgram()).parent_path().parent_path() / "lib" / "stepwise" /
                          ("runner-" + std::string(target.name) + ".o");
    if (!fs::exists(file, ignored)) return Error{errors::NoRunner(file.string()), ""};
    return file.string();
}

/// LLD links for every machine. Older ones and the GNU linker make programs of the runner that do not start.
Result<std::string> linkerFor(const Arguments& arguments) {
    if (const auto named = arguments.value("--linker")) {
        if (const auto found = named->find('/') == std::string::npos ? platform::programInPath(*named) : named)
            return *found;
        return Error{errors::NoSuchLinker(*named), ""};
    }
    if (const auto found = platform::programInPath("ld.lld-19")) return *found;
    return Error{errors::NoLinker(Verbatim("lld-19")), ""};
}

/// Runs it without a shell; what it says goes to stderr as it is.
Result<void> runLinker(const std::vector<std::string>& words) {
    if (platform::runProgram(words) != 0) return Error{errors::NotLinked(words[0]), ""};
    return {};
}

/// A file that goes with the object that names it.
struct Temporary {
    std::string path;
    ~Temporary() {
        if (!path.empty()) platform::removeFile(path);
    }
};

Result<void> writeObject(const std::string& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) return Error{errors::BuildNotWritten(path, errors::ofSystem(errno)), ""};
    return {};
}

Result<void> link(const std::string& linker, const std::string& runner, const std::string& object,
                  const std::string& output) {
    const Temporary objectFile{output + ".o.new"}, program{output + ".new"};
    if (auto written = writeObject(objectFile.path, object); !written) return written;
    if (auto linked = runLinker({linker, "-static", "--eh-frame-hdr", "--gc-sections", "--strip-debug", "-z",
                                 "noexecstack", "-o", program.path, runner, objectFile.path});
        !linked)
        return linked;
    std::error_code problem;
    fs::rename(program.path, output, problem);
    if (problem) return Error{errors::BuildNotWritten(output, errors::ofSystem(problem)), ""};
    return {};
}

/// Everything that can refuse before the program is compiled.
struct Plan {
    Target target;
    std::string linker, runner, output;
    int64_t calendarStartNs = controller::Settings().calendarStartNs;
};

Result<Plan> planBuild(const Arguments& arguments, const projects::Project& project) {
    Plan plan;
    const auto target = targetOf(arguments);
    if (!target) return target.error();
    plan.target = *target;
    const auto output = arguments.value("--output");
    if (!output) return Error{errors::BuildNeedsOutput(), ""};
    plan.output = *output;
    std::error_code ignored;
    const fs::path folder = fs::path(*output).parent_path();
    if (fs::is_directory(*output, ignored) || (!folder.empty() && !fs::is_directory(folder, ignored)))
        return Error{errors::BuildNotAFile(*output), ""};
    auto runner = runnerFor(*target);
    if (!runner) return runner.error();
    plan.runner = *runner;
    auto linker = linkerFor(arguments);
    if (!linker) return linker.error();
    plan.linker = *linker;
    const auto start = calendarStart(arguments.value("--start").value_or(project.calendarStart));
    if (!start) return start.error();
    plan.calendarStartNs = start->value_or(plan.calendarStartNs);
    return plan;
}

int build(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("build")), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const auto plan = planBuild(arguments, *project);
    if (!plan) return wrongUse(plan.error());
    const driver::Built built = driver::build(project->buildInput());
    printDiagnostics(built.checked, false, false);
    if (built.checked.analysis->hasErrors) return kProgramWrong;
    if (!built.program)
        return wrongUse({built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project->name});
    if (built.program->tasks.empty()) return wrongUse({errors::NothingToRun(), project->name});
    const auto object =
        driver::compileObject(built, {plan->target.triple, arguments.value("--cpu").value_or(plan->target.cpu),
                                      project->name, plan->calendarStartNs});
    if (!object) return wrongUse(object.error());
    if (auto linked = link(plan->linker, plan->runner, *object, plan->output); !linked) return wrongUse(linked.error());
    std::cout << plan->output << ": " << fs::file_size(plan->output) / 1024 << " KiB for " << plan->target.name << "\n";
    return kGood;
}

} // namespace

Command buildCommand() {
    return {{"build",
             "PATH… --output FILE [OPTIONS]",
             "Compiles a project into a program that runs without Stepwise and without a compiler.",
             {{"--output", "FILE", "the program to write"},
              {"--target", "x86_64|aarch64", "the machine it is for (default: this one)"},
              {"--cpu", "NAME", "its processor, as LLVM names it (default: x86-64, generic)"},
              {"--linker", "NAME", "the linker: LLD 19 or later (default: of the package lld-19)"},
              {"--start", "DT#2026-01-01-06:00:00", "calendar at the first scan, unless the run says otherwise"},
              {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"}},
             "stepwise build projects/examples/motor --target aarch64 --output motor"},
            build};
}

} // namespace plc::cli
