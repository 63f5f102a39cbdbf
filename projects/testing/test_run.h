// `stepwise test`: TESTs are ST (tests/*.st, or beside the program), each from a cold start, in virtual time. Ordinary
// statements become actions of a hidden block beside the program, RUN, ASSERT, FORCE… are carried out here between
// scans. Functions; one thread.
#pragma once
#include "projects/model/project.h"
#include "runtime/base/progress.h"
#include "runtime/base/result.h"
#include "runtime/controller/controller.h"

#include <functional>
#include <string>
#include <vector>

namespace plc::session {
class Session;
}

namespace plc::testing {

struct Failure {
    Message message; // "ASSERT failed: motor runs (Main.K1 = TRUE)"
    Message detail;  // "Main.K1 is FALSE, expected = TRUE"
    std::string file;
    uint32_t line = 0;
    uint64_t scan = 0;
    controller::Nanoseconds time{};
    std::string recording; // file left behind, may be empty
};

struct TestResult {
    std::string title, file;
    uint32_t line = 0;
    std::vector<Failure> failures;
    uint64_t scans = 0;
    controller::Nanoseconds plcTime{};
    double wallMs = 0;
    [[nodiscard]] bool passed() const { return failures.empty(); }
};

/// Lines of one POU that a statement stands on, and how many of them ran.
struct PouCoverage {
    std::string pou, file;
    uint32_t lines = 0, covered = 0;
    std::vector<uint32_t> missed;
};

struct Report {
    std::vector<TestResult> results;
    std::vector<PouCoverage> coverage;
    std::vector<std::string> diagnostics; // rendered; the project or its tests have errors when `hasErrors`
    bool hasErrors = false;
    double buildMs = 0;
    [[nodiscard]] size_t failed() const;
};

struct Options {
    std::string filter;              // substring of the title, without case; * and ? as in file names
    std::vector<std::string> titles; // only those; empty = all
    bool coverage = false;
    bool colours = false;
    std::string recordingFolder; // where a failing test leaves its recording; empty = none
    Progress* watched = nullptr; // cancels at once, in the middle of a scan too; the tests that had ended are reported
    std::function<void(const TestResult&)> progress;
    std::function<void(session::Session&)> finished; // after each test, with the recording of its scans
};

/// The errors in the TESTs of a project whose program has none, rendered as text or as JSON objects: of syntax and in
/// what the compiler translates; names in ASSERT, RUN, FORCE and plain writes are looked up when the test runs.
[[nodiscard]] std::vector<std::string> checkTests(const projects::Project& project, bool asJson, bool colours);

[[nodiscard]] Result<Report> runTests(const projects::Project& project, const Options& options);

} // namespace plc::testing
