// `stepwise test`: a line per project, filter, the three formats, coverage, what a failing assertion says, and COMPARE.
#include "app/cli/command_line.h"
#include "tests/support/paths.h"

#include <QDir>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace plc {
namespace {

namespace fs = std::filesystem;

const char* const kProgram = R"(PROGRAM Main
VAR
    Count : INT;
    Level : REAL;
    Wide : BOOL;
END_VAR
Count := Count + 1;
Level := Level + 0.5;
IF Count > 1000 THEN
    Wide := TRUE;
END_IF
END_PROGRAM
CONFIGURATION Plc
    RESOURCE Cpu ON Pc
        TASK Fast(INTERVAL := T#10ms, PRIORITY := 1);
        PROGRAM Main WITH Fast : Main;
    END_RESOURCE
END_CONFIGURATION
)";

struct Outcome {
    int exitCode = 0;
    std::string out, err;
};

class TestCommand : public ::testing::Test {
protected:
    void SetUp() override {
        m_before = fs::current_path();
        fs::current_path(folder.path().toStdString());
        fs::create_directories("counter/src");
        fs::create_directories("counter/tests");
        write("counter/project.json", "{\"name\": \"Counter\"}\n");
        write("counter/src/main.st", kProgram);
    }
    void TearDown() override { fs::current_path(m_before); }
    static void write(const std::string& path, const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
    }
    static Outcome run(std::vector<std::string> words, const char* command = "test") {
        words.insert(words.begin(), command);
        std::ostringstream out, err;
        std::streambuf* const oldOut = std::cout.rdbuf(out.rdbuf());
        std::streambuf* const oldErr = std::cerr.rdbuf(err.rdbuf());
        const int exitCode = cli::runCommandLine(words);
        std::cout.rdbuf(oldOut);
        std::cerr.rdbuf(oldErr);
        return {exitCode, out.str(), err.str()};
    }
    static size_t lines(const std::string& text) {
        return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
    }
    static bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
    QTemporaryDir folder;
    const std::string examples = plc::sourceDir() + "/projects/examples";

private:
    fs::path m_before;
};

TEST_F(TestCommand, OfTheExamplesIsGreenWithALinePerProject) {
    const Outcome outcome = run({examples});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out;
    size_t projects = 0;
    for (const auto& entry : fs::directory_iterator(examples)) projects += entry.is_directory() ? 1 : 0;
    EXPECT_EQ(lines(outcome.out), projects + 1) << outcome.out;
    EXPECT_TRUE(holds(outcome.out, "Motor with latching "));
    EXPECT_TRUE(outcome.out.ends_with(" passed, 0 failed\n"));
    EXPECT_FALSE(fs::exists("out")) << "nothing failed, so no recording";
}

TEST_F(TestCommand, FilterChoosesByTitle) {
    write("counter/tests/a.st",
          "TEST 'counts up'\nRUN 3 SCANS;\nASSERT Main.Count = 3;\nEND_TEST\nTEST 'is slow'\nRUN 1 SCANS;\nEND_TEST\n");
    const Outcome one = run({"counter", "--filter", "COUNTS"});
    EXPECT_EQ(one.exitCode, 0);
    EXPECT_TRUE(one.out.ends_with("1 passed, 0 failed\n")) << one.out;
    EXPECT_TRUE(run({"counter", "--filter", "*s?ow"}).out.ends_with("1 passed, 0 failed\n"));
    const Outcome none = run({"counter", "--filter", "brakes"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_TRUE(holds(none.err, "No test has \"brakes\" in its title; without --filter, all titles are shown"))
        << none.err;
}

TEST_F(TestCommand, AFailingAssertionSaysBothValuesScanTimeAndWhereTheRecordingIs) {
    write("counter/tests/a.st", "TEST 'counts up'\nRUN 3 SCANS;\nASSERT Main.Count = 5, 'five by now';\nEND_TEST\n");
    const Outcome outcome = run({"counter"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(holds(outcome.out, "FAILED"));
    EXPECT_TRUE(holds(outcome.out, "tests/a.st:3: ")) << outcome.out;
    EXPECT_TRUE(holds(outcome.out, "five by now"));
    EXPECT_TRUE(holds(outcome.out, "Main.Count is 3, expected = 5")) << outcome.out;
    EXPECT_TRUE(holds(outcome.out, "scan 3, T#20ms")) << outcome.out;
    const size_t at = outcome.out.find("recording: ");
    ASSERT_NE(at, std::string::npos) << outcome.out;
    const std::string path = outcome.out.substr(at + 11, outcome.out.find('\n', at) - at - 11);
    ASSERT_TRUE(fs::exists(path)) << path;
    std::ostringstream replayed;
    std::streambuf* const oldOut = std::cout.rdbuf(replayed.rdbuf());
    const int exitCode = cli::runCommandLine({"replay", path, "--watch", "Main.Count"});
    std::cout.rdbuf(oldOut);
    EXPECT_EQ(exitCode, 0);
    EXPECT_TRUE(holds(replayed.str(), "3")) << replayed.str();
}

TEST_F(TestCommand, JsonAndJunitHoldWhatTheTextHolds) {
    write("counter/tests/a.st", "TEST 'counts <up> & \"on\"'\nRUN 3 SCANS;\nASSERT Main.Count = 5;\nEND_TEST\nTEST "
                                "'good'\nRUN 1 SCANS;\nEND_TEST\n");
    const Outcome json = run({"counter", "--format", "json", "--coverage"});
    EXPECT_EQ(json.exitCode, 1);
    const auto parsed = nlohmann::json::parse(json.out, nullptr, false);
    ASSERT_TRUE(parsed.is_array()) << json.out;
    EXPECT_EQ(parsed[0]["project"], "Counter");
    ASSERT_EQ(parsed[0]["tests"].size(), 2u);
    EXPECT_EQ(parsed[0]["tests"][0]["passed"], false);
    EXPECT_EQ(parsed[0]["tests"][0]["failures"][0]["detail"], "Main.Count is 3, expected = 5");
    EXPECT_EQ(parsed[0]["tests"][1]["passed"], true);
    EXPECT_EQ(parsed[0]["coverage"][0]["pou"], "Main");

    const Outcome junit = run({"counter", "--format", "junit"});
    EXPECT_EQ(junit.exitCode, 1);
    QXmlStreamReader xml(QByteArray::fromStdString(junit.out));
    int cases = 0, failures = 0;
    QString firstName, suite;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("testsuite"))
            suite = xml.attributes().value("failures").toString() + "/" + xml.attributes().value("tests").toString();
        if (xml.name() == QLatin1String("testcase") && cases++ == 0)
            firstName = xml.attributes().value("name").toString();
        if (xml.name() == QLatin1String("failure")) ++failures;
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    EXPECT_EQ(suite, "1/2");
    EXPECT_EQ(cases, 2);
    EXPECT_EQ(failures, 1);
    EXPECT_EQ(firstName, "counts <up> & \"on\"");
    EXPECT_EQ(run({"counter", "--format", "yaml"}).exitCode, 2);
}

TEST_F(TestCommand, CoverageNamesTheLinesThatDidNotRun) {
    write("counter/tests/a.st", "TEST 'short'\nRUN 3 SCANS;\nEND_TEST\n");
    const Outcome part = run({"counter", "--coverage"});
    EXPECT_TRUE(holds(part.out, "3 of 4 lines   not run: 10")) << part.out;
    write("counter/tests/b.st", "TEST 'long'\nRUN 1001 SCANS;\nASSERT Main.Wide;\nEND_TEST\n");
    const Outcome whole = run({"counter", "--coverage"});
    EXPECT_TRUE(holds(whole.out, "100.0 %  4 of 4 lines")) << whole.out;
}

TEST_F(TestCommand, CompareHoldsARunAgainstARecording) {
    write("counter/tests/a.st", "TEST 'as it was'\nRUN 20 SCANS;\nCOMPARE 'before', TOLERANCE := 0.01;\nEND_TEST\n");
    const Outcome missing = run({"counter"});
    EXPECT_EQ(missing.exitCode, 1);
    const size_t at = missing.out.find("recording: ");
    ASSERT_NE(at, std::string::npos) << missing.out;
    const std::string left = missing.out.substr(at + 11, missing.out.find('\n', at) - at - 11);
    fs::copy_file(left, "counter/tests/before.rec"); // the recording it left is the one to compare with from now on
    EXPECT_EQ(run({"counter"}).exitCode, 0) << run({"counter"}).out;

    std::string changed = kProgram;
    changed.replace(changed.find("+ 0.5"), 5, "+ 0.5001");
    write("counter/src/main.st", changed);
    EXPECT_EQ(run({"counter"}).exitCode, 0) << "within the tolerance: " << run({"counter"}).out;
    changed.replace(changed.find("+ 0.5001"), 8, "+ 0.55");
    write("counter/src/main.st", changed);
    const Outcome off = run({"counter"});
    EXPECT_EQ(off.exitCode, 1);
    EXPECT_TRUE(
        holds(off.out,
              "The run differs from the recording before; delete it to record it again, if the new behaviour is right"))
        << off.out;
    EXPECT_TRUE(holds(off.out, "Main.Level is 0.55, recorded 0.5 in scan 0")) << off.out;
}

TEST_F(TestCommand, ErrorsOfAProjectAreItsLineAndTheExitCode) {
    write("counter/tests/a.st", "TEST 'wrong'\nASSERT Main.Cuont = 1;\nEND_TEST\n");
    const Outcome outcome = run({"counter"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(holds(outcome.out, "does not build") || holds(outcome.out, "FAILED")) << outcome.out;
    EXPECT_TRUE(holds(outcome.out + outcome.err, "Cuont")) << outcome.err;
    EXPECT_EQ(run({}).exitCode, 2);
    EXPECT_EQ(run({"nowhere"}).exitCode, 2);
}

TEST_F(TestCommand, RunsTheTestsOfLooseFiles) {
    write("loose.st", "PROGRAM Main\nVAR n : INT; END_VAR\nn := n + 1;\nEND_PROGRAM\n"
                      "TEST 'counts'\nRUN 3 SCANS;\nASSERT Main.n = 3;\nEND_TEST\n");
    write("more.st", "TEST 'miscounts'\nRUN 3 SCANS;\nASSERT Main.n = 4;\nEND_TEST\n");
    const Outcome one = run({"loose.st"});
    EXPECT_EQ(one.exitCode, 0) << one.err;
    EXPECT_NE(one.out.find("1 passed, 0 failed"), std::string::npos) << one.out;
    const Outcome both = run({"loose.st", "more.st"});
    EXPECT_EQ(both.exitCode, 1);
    EXPECT_NE(both.out.find("1 passed, 1 failed"), std::string::npos) << both.out;
    EXPECT_NE(both.out.find("more.st:3"), std::string::npos) << both.out;
}

TEST_F(TestCommand, CheckReadsTheTests) {
    EXPECT_EQ(run({"counter"}, "check").exitCode, 0);
    write("counter/tests/wrong.st",
          "TEST 'wrong'\nVAR n : INT; END_VAR\nIF Main.Cuont > 3 THEN n := 1; END_IF\nEND_TEST\n");
    const Outcome project = run({"counter"}, "check");
    EXPECT_EQ(project.exitCode, 1);
    EXPECT_NE(project.err.find("tests/wrong.st:3:"), std::string::npos) << project.err;
    write("loose.st", "PROGRAM Main\nVAR n : INT; END_VAR\nn := n + 1;\nEND_PROGRAM\n"
                      "TEST 'wrong'\nIF Main.m > 3 THEN Main.n := 1; END_IF\nEND_TEST\n");
    const Outcome loose = run({"loose.st", "--format", "json"}, "check");
    EXPECT_EQ(loose.exitCode, 1);
    const auto objects = nlohmann::json::parse(loose.out);
    EXPECT_EQ(objects.back()["code"], "P2002") << loose.out;
}

TEST_F(TestCommand, RunsTheTestsBesideTheProgram) {
    write("counter/src/more.st", "TEST 'in src'\nRUN 2 SCANS;\nASSERT Main.Count = 2;\nEND_TEST\n");
    const Outcome outcome = run({"counter"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("1 passed, 0 failed"), std::string::npos) << outcome.out;
    write("counter/src/more.st", "TEST 'in src'\nASSERT Main.Counter = 2;\nEND_TEST\n");
    EXPECT_EQ(run({"counter"}).exitCode, 1);
}

} // namespace
} // namespace plc
