#include "app/cli/program/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/kit/interrupt.h"
#include "app/cli/kit/written_file.h"
#include "app/cli/program/coverage_output.h"
#include "projects/testing/test_run.h"
#include "runtime/base/xml_text.h"
#include "runtime/platform/streams.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

namespace plc::cli {

namespace {

namespace fs = std::filesystem;

struct ProjectReport {
    std::string name, path;
    testing::Report report;
};

/// A project folder, or a folder of projects.
std::vector<std::string> projectFolders(const std::string& path) {
    std::error_code ignored;
    if (fs::exists(fs::path(path) / "project.json", ignored) || !fs::is_directory(path, ignored)) return {path};
    std::vector<std::string> out;
    for (const auto& entry : fs::directory_iterator(path, ignored))
        if (fs::exists(entry.path() / "project.json", ignored)) out.push_back(entry.path().string());
    std::sort(out.begin(), out.end());
    return out.empty() ? std::vector<std::string>{path} : out;
}

/// Each a project folder, or the loose ST files, which are one program.
std::vector<std::vector<std::string>> projectsOf(const std::vector<std::string>& paths) {
    std::vector<std::vector<std::string>> out;
    std::optional<size_t> loose;
    for (const std::string& path : paths) {
        if (fs::path(path).extension() != ".st") {
            for (const std::string& folder : projectFolders(path)) out.push_back({folder});
        } else if (loose) {
            out[*loose].push_back(path);
        } else {
            loose = out.size();
            out.push_back({path});
        }
    }
    return out;
}

std::string failureText(const testing::Failure& failure) {
    std::string out =
        "    " + failure.file + ":" + std::to_string(failure.line) + ": " + failure.message.english() + "\n";
    if (!failure.detail.isEmpty()) out += "      " + failure.detail.english() + "\n";
    out += "      scan " + std::to_string(failure.scan) + ", " + types::durationText(failure.time.count()) + "\n";
    if (!failure.recording.empty()) out += "      recording: " + failure.recording + "\n";
    return out;
}

void printText(const ProjectReport& project, bool coverage) {
    const size_t failed = project.report.failed(), all = project.report.results.size();
    char line[300];
    double ms = 0, plc = 0;
    for (const testing::TestResult& result : project.report.results) {
        ms += result.wallMs;
        plc += std::chrono::duration<double>(result.plcTime).count();
    }
    const char* verdict = project.report.hasErrors ? "does not build" : failed ? "FAILED" : "ok";
    std::snprintf(line, sizeof line, "%-50s %-14s %3zu passed %3zu failed   %8.1f s of plant time in %.0f ms\n",
                  project.name.c_str(), verdict, all - failed, failed, plc, ms);
    std::cout << line;
    for (const std::string& text : project.report.diagnostics) std::cerr << text;
    for (const testing::TestResult& result : project.report.results) {
        if (result.passed()) continue;
        std::cout << "  " << result.title << "\n";
        for (const testing::Failure& failure : result.failures) std::cout << failureText(failure);
    }
    if (!coverage) return;
    for (const testing::PouCoverage& pou : project.report.coverage) {
        std::snprintf(line, sizeof line, "  %-40s %5.1f %%  %u of %u lines", pou.pou.c_str(),
                      pou.lines ? 100.0 * pou.covered / pou.lines : 100.0, pou.covered, pou.lines);
        std::cout << line;
        for (size_t i = 0; i < pou.missed.size() && i < 12; ++i)
            std::cout << (i ? ", " : "   not run: ") << pou.missed[i];
        std::cout << "\n";
    }
}

void printJson(const std::vector<ProjectReport>& projects) {
    std::cout << "[";
    for (size_t i = 0; i < projects.size(); ++i) {
        const ProjectReport& project = projects[i];
        std::cout << (i ? ",\n " : "") << "{\"project\":" << jsonString(project.name) << ",\"errors\":[";
        for (size_t k = 0; k < project.report.diagnostics.size(); ++k)
            std::cout << (k ? "," : "") << jsonString(project.report.diagnostics[k]);
        std::cout << "],\"tests\":[";
        for (size_t k = 0; k < project.report.results.size(); ++k) {
            const testing::TestResult& result = project.report.results[k];
            std::cout << (k ? "," : "") << "{\"title\":" << jsonString(result.title)
                      << ",\"file\":" << jsonString(result.file) << ",\"line\":" << result.line
                      << ",\"passed\":" << (result.passed() ? "true" : "false") << ",\"scans\":" << result.scans
                      << ",\"failures\":[";
            for (size_t f = 0; f < result.failures.size(); ++f) {
                const testing::Failure& failure = result.failures[f];
                std::cout << (f ? "," : "") << "{\"message\":" << jsonString(failure.message.english())
                          << ",\"detail\":" << jsonString(failure.detail.english())
                          << ",\"file\":" << jsonString(failure.file) << ",\"line\":" << failure.line
                          << ",\"scan\":" << failure.scan
                          << ",\"time\":" << jsonString(types::durationText(failure.time.count()))
                          << ",\"recording\":" << jsonString(failure.recording) << "}";
            }
            std::cout << "]}";
        }
        std::cout << "],\"coverage\":[";
        for (size_t k = 0; k < project.report.coverage.size(); ++k) {
            const testing::PouCoverage& pou = project.report.coverage[k];
            std::cout << (k ? "," : "") << "{\"pou\":" << jsonString(pou.pou) << ",\"file\":" << jsonString(pou.file)
                      << ",\"lines\":" << pou.lines << ",\"covered\":" << pou.covered << "}";
        }
        std::cout << "]}";
    }
    std::cout << "]\n";
}

void printJunit(const std::vector<ProjectReport>& projects) {
    std::cout << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const ProjectReport& project : projects) {
        std::cout << "  <testsuite name=\"" << xmlText(project.name) << "\" tests=\"" << project.report.results.size()
                  << "\" failures=\"" << project.report.failed() << "\" errors=\"" << (project.report.hasErrors ? 1 : 0)
                  << "\">\n";
        for (const std::string& text : project.report.diagnostics)
            std::cout << "    <testcase name=\"build\"><error>" << xmlText(text) << "</error></testcase>\n";
        for (const testing::TestResult& result : project.report.results) {
            std::cout << "    <testcase classname=\"" << xmlText(project.name) << "\" name=\"" << xmlText(result.title)
                      << "\" file=\"" << xmlText(result.file) << "\" line=\"" << result.line << "\" time=\""
                      << result.wallMs / 1000 << "\">";
            for (const testing::Failure& failure : result.failures)
                std::cout << "\n      <failure message=\"" << xmlText(failure.message.english()) << "\">"
                          << xmlText(failureText(failure)) << "</failure>\n    ";
            std::cout << "</testcase>\n";
        }
        std::cout << "  </testsuite>\n";
    }
    std::cout << "</testsuites>\n";
}

int test(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProjects(Verbatim("test")), ""});
    const std::string format = arguments.value("--format").value_or("text");
    testing::Options options;
    options.filter = arguments.value("--filter").value_or("");
    options.coverage = arguments.has("--coverage");
    options.colours = wantsColours(platform::kStandardError);
    Progress work;
    const InterruptCancels ctrlC(work);
    options.watched = &work;
    std::vector<ProjectReport> reports;
    size_t failed = 0, passed = 0, broken = 0;
    ProgressLine progress;
    std::vector<std::string> all = arguments.paths();
    const bool wantsConditions = options.coverage && std::erase(all, "mcdc") > 0; // --coverage mcdc
    const auto reportFile = arguments.value("--report");
    if (reportFile)
        if (auto good = checkPlace(*reportFile); !good) return wrongUse(good.error());
    for (const std::vector<std::string>& paths : projectsOf(all)) {
        CoverageRun coverage;
        if (wantsConditions || reportFile) {
            options.coverage = false; // of lines: the other one counts them too
            coverage.follow(options);
        }
        const auto project = openNamedProject(arguments, paths);
        if (!project) return wrongUse(project.error());
        progress.show("testing " + project->name);
        options.recordingFolder =
            project->folder.empty() ? "" : (fs::current_path() / "out" / "recordings" / project->name).string();
        auto report = testing::runTests(*project, options);
        if (!report) return wrongUse(report.error());
        failed += report->failed();
        passed += report->results.size() - report->failed();
        broken += report->hasErrors ? 1 : 0;
        reports.push_back({project->name, paths.front(), std::move(*report)});
        if (format == "text") printText(reports.back(), options.coverage);
        if (format == "text" && wantsConditions) std::cout << coverage.text();
        if (reportFile)
            if (auto written = coverage.write(*reportFile); !written) return wrongUse(written.error());
        if (work.isCancelled()) break;
    }
    if (format == "json")
        printJson(reports);
    else if (format == "junit")
        printJunit(reports);
    else
        std::cout << passed << " passed, " << failed << " failed\n";
    if (work.isCancelled()) {
        std::cerr << "stepwise: " << errors::TestsInterrupted().english() << "\n";
        return kInterrupted;
    }
    if (passed + failed == 0 && !broken && !options.filter.empty())
        return wrongUse({errors::NoTestNamed(options.filter), ""});
    return failed || broken ? kProgramWrong : kGood;
}

} // namespace

Command testCommand() {
    return {{"test",
             "PATH… [OPTIONS]",
             "Runs the TESTs of projects (tests/*.st), or of ST files, in virtual time.",
             {{"--filter", "TEXT", "only tests whose title holds TEXT (* and ? as in file names)"},
              {"--library", "NAME", "a library the ST files use, in addition to the standard library (repeatable)"},
              {"--coverage", "", "lines of each POU that ran; --coverage mcdc: statements, branches and conditions"},
              {"--report", "FILE.html|FILE.xml", "coverage as a page, or in Cobertura's form"},
              {"--format", "text|json|junit", "text (default), JSON or JUnit XML"}},
             "stepwise test projects/examples --filter 'stop*' --coverage"},
            test};
}

} // namespace plc::cli
