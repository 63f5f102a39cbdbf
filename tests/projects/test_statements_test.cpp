// What the statements of a TEST do to the controller.
#include "projects/testing/test_run.h"

#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "tests/support/long_scans.h"
#include "tests/support/processor_time.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace plc::testing {
namespace {

Report runOf(const std::string& program, const std::string& test,
             types::StringCode strings = types::StringCode::Latin1) {
    projects::Project project;
    project.strings = strings;
    project.sources.push_back({"main.st", program});
    project.tests.push_back({"tests.st", test});
    auto report = runTests(project, {});
    EXPECT_TRUE(report) << report.error().english();
    return report ? *report : Report{};
}

/// Whatever takes long in a test: scans that would take years, and loops of the test itself.
struct LongTest {
    std::string name, program, statements;
    bool isEndless = true; // else a fast machine may use up the work that a scan or the statements of a test may do
};
std::vector<LongTest> longTests() {
    std::vector<LongTest> out;
    for (const LongScan& scan : longScans()) out.push_back({scan.name, scan.text, "RUN 1000 SCANS;\n", false});
    const std::string idle = "PROGRAM Main\nVAR a : INT; END_VAR\na := a + 1;\nEND_PROGRAM\n";
    out.push_back({"FOR", idle, "FOR i := 1 TO 9000000000000000000 DO\nEND_FOR\n", false});
    out.push_back({"WHILE", idle, "WHILE i < 1 DO\nEND_WHILE\n", false});
    out.push_back({"RUN", idle, "RUN T#100d;\n"});
    out.push_back({"RunInFor", idle, "FOR i := 1 TO 9000000000000000000 DO\nRUN 1 SCANS;\nEND_FOR\n"});
    return out;
}

TEST(Cancelling, EndsATestAtOnceInTheMiddleOfWhateverItDoes) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    for (const LongTest& kind : longTests()) {
        projects::Project project;
        project.sources.push_back({"main.st", kind.program});
        project.tests.push_back({"tests.st", "TEST 'first'\nASSERT TRUE;\nEND_TEST\nTEST 'long'\nVAR\n    i : "
                                             "LINT;\nEND_VAR\n" +
                                                 kind.statements + "END_TEST\n"});
        Progress work;
        Options options;
        options.watched = &work;
        std::atomic<bool> isBegun = false;
        double asked = 0;
        options.progress = [&](const TestResult&) { isBegun = true; };
        std::thread canceller([&] {
            while (!isBegun) std::this_thread::yield();
            // a duration: of the second test, into its work
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            asked = ownSeconds();
            work.cancel();
        });
        const auto report = runTests(project, options);
        const double over = ownSeconds();
        isBegun = true; // had it been refused
        canceller.join();
        ASSERT_TRUE(report) << kind.name;
        if (kind.isEndless) {
            ASSERT_EQ(report->results.size(), 1u)
                << kind.name << " has ended: "
                << (report->results.back().failures.empty() ? "passed"
                                                            : report->results.back().failures[0].message.english());
        }
        // with the image of the test, which is given back
        EXPECT_LT(over - asked, kAtOnceSeconds + secondsForNewMemory(360'000'000)) << kind.name;
        RecordProperty(kind.name, std::to_string(over - asked));
    }
}

TEST(PowerOff, LosesAllButWhatIsRetainedWhileThePlantGoesOn) {
    const Report report =
        runOf("PROGRAM Main\nVAR\n    passes : INT;\nEND_VAR\nVAR RETAIN\n    total : INT;\nEND_VAR\n"
              "passes := passes + 1;\ntotal := total + 1;\nDrive := TRUE;\nEND_PROGRAM\n"
              "{attribute 'simulation'}\nPROGRAM Plant\nVAR\n    scans : INT;\n    driven : INT;\nEND_VAR\n"
              "scans := scans + 1;\nIF Drive THEN\n    driven := driven + 1;\nEND_IF\nEND_PROGRAM\n"
              "VAR_GLOBAL\n    Drive AT %QX0.0 : BOOL;\nEND_VAR\n"
              "CONFIGURATION c\nRESOURCE r ON p\nTASK t(INTERVAL := T#10ms, PRIORITY := 1);\n"
              "PROGRAM Main WITH t : Main;\nEND_RESOURCE\nEND_CONFIGURATION\n",
              "TEST 'off'\nVAR\n    scans : INT;\n    driven : INT;\nEND_VAR\nRUN 5 SCANS;\n"
              "scans := Plant.scans;\ndriven := Plant.driven;\nPOWER_OFF T#100ms;\n"
              "ASSERT scans > 0 AND driven > 0;\nASSERT Plant.scans = scans + 10;\nASSERT Plant.driven = driven;\n"
              "ASSERT NOT Drive;\nASSERT Main.passes = 0;\nASSERT Main.total = 5;\n"
              "RUN 2 SCANS;\nASSERT Main.passes = 2;\nASSERT Main.total = 7;\nASSERT Drive;\nEND_TEST\n");
    ASSERT_EQ(report.results.size(), 1u);
    for (const Failure& failure : report.results[0].failures)
        ADD_FAILURE() << failure.line << ": " << failure.message << " " << failure.detail;
}

TEST(TestStatements, SayTextsInTheEncodingOfTheProjectsStrings) {
    for (const types::StringCode code : {types::StringCode::Windows1251, types::StringCode::Utf8}) {
        const Report report =
            runOf("PROGRAM Main\nVAR\n    s : STRING := '\u041D\u0430\u0441\u043E\u0441';\nEND_VAR\nEND_PROGRAM\n",
                  "TEST 'said'\nMain.s := '\u0411\u0430\u043A';\nRUN 1 SCANS;\n"
                  "ASSERT Main.s = '\u041D\u0430\u0441\u043E\u0441', '\u041F\u0443\u0441\u043A';\nEND_TEST\n",
                  code);
        ASSERT_EQ(report.results.size(), 1u);
        ASSERT_EQ(report.results[0].failures.size(), 1u);
        const Failure& failure = report.results[0].failures[0];
        EXPECT_NE(failure.message.english().find("\u041F\u0443\u0441\u043A"), std::string::npos)
            << failure.message.english();
        EXPECT_NE(failure.detail.english().find("\u0411\u0430\u043A"), std::string::npos) << failure.detail.english();
    }
}

TEST(TestStatements, RefuseWhatIsNoTimeOrNumber) {
    for (const char* statement :
         {"POWER_OFF 'x'", "RUN 'x'", "RUN 2.5", "RUN 2.5 SCANS", "RUN UNTIL Main.a > 5 FOR 'x'", "POWER_OFF 1.5",
          "FOR i := 'x' TO 3 DO\nRUN 1 SCANS;\nEND_FOR"}) {
        const Report report =
            runOf("PROGRAM Main\nVAR\n    a : INT;\nEND_VAR\na := 1;\nEND_PROGRAM\n",
                  std::string("TEST 'off'\nVAR\n    i : INT;\nEND_VAR\n") + statement + ";\nEND_TEST\n");
        EXPECT_TRUE(report.hasErrors || report.failed() == 1) << statement;
    }
}

TEST(TestStatements, ReadAndWriteAPropertyAndCallFunctionsNamedAsStandardOnes) {
    const Report report = runOf(
        "FUNCTION TRIM : STRING\nVAR_INPUT s : STRING; END_VAR\nTRIM := s;\nEND_FUNCTION\n"
        "FUNCTION ROUND : REAL\nVAR_INPUT r : REAL; n : INT; END_VAR\nROUND := r + INT_TO_REAL(n);\nEND_FUNCTION\n"
        "FUNCTION_BLOCK Drive\nVAR v : INT; END_VAR\nPROPERTY PUBLIC Speed : INT\nGET\nSpeed := v * 2;\nEND_GET\n"
        "SET\nv := Speed;\nEND_SET\nEND_PROPERTY\nEND_FUNCTION_BLOCK\n"
        "PROGRAM Main\nVAR d : Drive; END_VAR\nd();\nEND_PROGRAM\n",
        "TEST 'property'\nMain.d.Speed := 4;\nASSERT Main.d.Speed = 8;\nASSERT Main.d.v = 4;\n"
        "ASSERT TRIM(' a') = ' a';\nASSERT ROUND(1.0, 2) = 3.0;\nEND_TEST\n"
        "TEST 'wrong'\nASSERT Main.d.Speed = 1;\nEND_TEST\n");
    ASSERT_EQ(report.results.size(), 2u);
    for (const Failure& failure : report.results[0].failures)
        ADD_FAILURE() << failure.line << ": " << failure.message << " " << failure.detail;
    EXPECT_EQ(report.results[1].failures.size(), 1u);
}

} // namespace
} // namespace plc::testing
