#include "projects/testing/test_run.h"

#include "projects/session/session.h"
#include "projects/testing/coverage.h"
#include "projects/testing/interpreter.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/controller/leave_hook.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace plc::testing {

namespace {

bool matchesPattern(std::string_view text, std::string_view pattern) {
    if (pattern.empty()) return text.empty();
    if (pattern[0] == '*')
        return matchesPattern(text, pattern.substr(1)) || (!text.empty() && matchesPattern(text.substr(1), pattern));
    return !text.empty() && (pattern[0] == '?' || pattern[0] == text[0]) &&
           matchesPattern(text.substr(1), pattern.substr(1));
}

bool isWanted(const std::string& title, const std::string& filter) {
    if (filter.empty()) return true;
    const std::string folded = foldCase(title), wanted = foldCase(filter);
    if (wanted.find_first_of("*?") == std::string::npos) return folded.find(wanted) != std::string::npos;
    return matchesPattern(folded, wanted);
}

/// Diagnostics of project and tests, rendered; those of made text at their place in the test file.
void renderDiagnostics(const TestProgram& program, const driver::Checked* checked, bool colours, Report& report) {
    for (const diagnostics::Diagnostic& each : program.problems().all())
        report.diagnostics.push_back(diagnostics::renderText(program.testSources(), each, colours));
    report.hasErrors = program.problems().hasErrors();
    if (!checked) return;
    for (diagnostics::Diagnostic each : checked->analysis->diagnostics) {
        if (each.severity != diagnostics::Severity::Error) continue;
        bool isTestFile = false;
        each.range = program.originalOf(each.range, isTestFile);
        each.fixes.clear();
        report.diagnostics.push_back(
            diagnostics::renderText(isTestFile ? program.testSources() : *checked->sources, each, colours));
        report.hasErrors = true;
    }
}

std::string fileNameOf(std::string title) {
    for (char& c : title)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return title.substr(0, 60);
}

} // namespace

size_t Report::failed() const {
    return static_cast<size_t>(
        std::count_if(results.begin(), results.end(), [](const TestResult& result) { return !result.passed(); }));
}

std::vector<std::string> checkTests(const projects::Project& project, bool asJson, bool colours) {
    const TestProgram program(project);
    std::vector<std::string> out;
    const auto add = [&](const SourceSet& sources, const diagnostics::Diagnostic& each) {
        out.push_back(asJson ? diagnostics::renderJson(sources, each)
                             : diagnostics::renderText(sources, each, colours));
    };
    for (const diagnostics::Diagnostic& each : program.problems().all())
        if (each.severity == diagnostics::Severity::Error) add(program.testSources(), each);
    if (!out.empty() || program.testSources().files.empty()) return out;
    const driver::Checked checked = driver::check(program.input());
    for (diagnostics::Diagnostic each : checked.analysis->diagnostics) {
        bool isTestFile = false;
        each.range = program.originalOf(each.range, isTestFile);
        each.fixes.clear(); // they are places of the made text
        if (isTestFile && each.severity == diagnostics::Severity::Error) add(program.testSources(), each);
    }
    return out;
}

Result<Report> runTests(const projects::Project& project, const Options& options) {
    Report report;
    const TestProgram program(project);
    if (program.problems().hasErrors()) {
        renderDiagnostics(program, nullptr, options.colours, report);
        return report;
    }
    const driver::Built built = driver::build(program.input(), options.watched);
    if (built.isCancelled) return report;
    report.buildMs = built.checkMs + built.codeMs;
    renderDiagnostics(program, &built.checked, options.colours, report);
    if (report.hasErrors) return report;
    if (!built.program) return Error{built.failure.isEmpty() ? errors::NothingToTest() : built.failure, project.name};
    if (!options.coverage)
        if (auto optimised = driver::optimise(built, options.watched); !optimised && !isCancelled(options.watched))
            return optimised.error();
    if (isCancelled(options.watched)) return report;
    double begun = 0;

    Coverage coverage(*built.program);
    for (const PlannedTest& test : program.tests()) {
        if (!goesOn(options.watched, begun++ / static_cast<double>(program.tests().size()))) break;
        if (!isWanted(test.title, options.filter)) continue;
        if (!options.titles.empty() &&
            std::find(options.titles.begin(), options.titles.end(), test.title) == options.titles.end())
            continue;
        const auto begin = std::chrono::steady_clock::now();
        session::Session session(built, {});
        controller::setLeaveHook(session.controller(), [&] { return isCancelled(options.watched); });
        if (options.coverage) coverage.attach(session.controller());
        TestResult result;
        result.title = test.title;
        result.file = program.testSources()[FileId(test.fileIndex)].path();
        result.line = program.testSources()[FileId(test.fileIndex)].lineColumn(test.test->titleRange.begin).line;
        Interpreter interpreter(project, program, test, built, session);
        interpreter.cancelWith(options.watched);
        interpreter.run(result);
        if (isCancelled(options.watched)) break; // not a whole test
        if (options.coverage) coverage.collect(session.controller());
        if (!result.passed() && !options.recordingFolder.empty()) {
            std::error_code ignored;
            std::filesystem::create_directories(options.recordingFolder, ignored);
            const std::string file = options.recordingFolder + "/" + fileNameOf(test.title) + ".rec";
            if (session.history().save(file)) result.failures.back().recording = file;
        }
        result.scans = session.controller().nextScan();
        result.plcTime = session.controller().lastTime();
        result.wallMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        if (options.finished) options.finished(session);
        if (options.progress) options.progress(result);
        report.results.push_back(std::move(result));
    }
    if (options.coverage) report.coverage = coverage.perPou();
    return report;
}

} // namespace plc::testing
