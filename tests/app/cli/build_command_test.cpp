// `stepwise build`: the programs it makes run without JIT and give the recording of `stepwise run` bit for bit, on this
// machine and, by emulation, on the other; what it refuses.
#include "tests/app/cli/command_fixture.h"
#include "tests/support/paths.h"
#include "tests/support/patience.h"

#include <QProcess>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace plc {
namespace {

namespace fs = std::filesystem;

const char* const kCounter =
    "PROGRAM Main\nVAR RETAIN\n    count : INT;\nEND_VAR\nVAR\n    go : BOOL;\n    half : REAL;\n"
    "END_VAR\nIF go THEN count := count + 1; END_IF;\nhalf := SIN(INT_TO_REAL(count)) / 2.0;\n"
    "END_PROGRAM\n";

class BuildCommand : public CommandTest {
protected:
    int build(std::vector<std::string> words) {
        words.insert(words.begin(), "build");
        return command(words);
    }
    /// Runs a built program, on a machine that is not this one by emulation; its standard output and error.
    int start(const std::string& program, const std::string& target, const std::vector<std::string>& words) {
        QStringList all;
        const bool isEmulated = target == "aarch64" && QSysInfo::currentCpuArchitecture() != "arm64";
        if (isEmulated) all << QString::fromStdString(program);
        for (const std::string& word : words) all << QString::fromStdString(word);
        QProcess process;
        process.start(isEmulated ? QString("qemu-aarch64-static") : QString::fromStdString(program), all);
        EXPECT_TRUE(process.waitForFinished(4 * kPatience)) << process.errorString().toStdString();
        said = (process.readAllStandardOutput() + process.readAllStandardError()).toStdString();
        return process.exitCode();
    }
    void expectTheSameRecording(const std::string& project, const std::string& target,
                                const std::vector<std::string>& options, int code = 0) {
        SCOPED_TRACE(project + " for " + target);
        std::vector<std::string> words{"run", project, "--record", path("jit.rec"), "--watch", "1"};
        words.insert(words.end(), options.begin(), options.end());
        ASSERT_EQ(command(words), code) << err;
        ASSERT_EQ(build({project, "--target", target, "--output", path("program")}), 0) << err;
        std::vector<std::string> own{"--record", path("built.rec")};
        own.insert(own.end(), options.begin(), options.end());
        ASSERT_EQ(start(path("program"), target, own), code) << said;
        const std::string expected = read("jit.rec"), made = read("built.rec");
        ASSERT_GT(expected.size(), 1000u);
        EXPECT_TRUE(expected == made) << expected.size() << " and " << made.size() << " bytes";
    }
    static std::string example(const std::string& name) { return sourceDir() + "/projects/examples/" + name; }
    std::string said;
};

class BuildFor : public BuildCommand, public ::testing::WithParamInterface<const char*> {};

} // namespace

TEST_P(BuildFor, AProgramRecordsWhatTheJitRecords) {
    for (const char* name : {"motor", "pid_pt1", "gravel", "robot_cnc", "workbook", "traffic_light", "weigh", "stack"})
        expectTheSameRecording(example(name), GetParam(), {"--scans", "2000"});
}

TEST_P(BuildFor, WritesAndForcesActAsInARun) {
    write("main.st", kCounter);
    expectTheSameRecording(path("main.st"), GetParam(),
                           {"--for", "200ms", "--set", "Main.go=TRUE@50ms", "--force", "Main.count=7@100ms", "--force",
                            "Main.count=RELEASE@150ms", "--start", "DT#2026-01-31-06:00:00"});
}

TEST_P(BuildFor, AFaultIsTheSameFault) {
    write("main.st", "PROGRAM Main\nVAR\n    i, x : INT;\n    a : ARRAY[1..5] OF INT;\nEND_VAR\ni := i + 1;\n"
                     "x := a[i];\nEND_PROGRAM\n");
    expectTheSameRecording(path("main.st"), GetParam(), {"--scans", "100"}, 1);
    EXPECT_NE(said.find("main.st:7"), std::string::npos) << said;
    EXPECT_NE(said.find("6"), std::string::npos) << said;
}

TEST_P(BuildFor, RetainedValuesComeBack) {
    write("main.st", kCounter);
    ASSERT_EQ(build({path("main.st"), "--target", GetParam(), "--output", path("program")}), 0) << err;
    for (const char* expected : {"Main.count  10\n", "Main.count  20\n"}) {
        ASSERT_EQ(start(path("program"), GetParam(),
                        {"--scans", "10", "--set", "Main.go=TRUE", "--retain", path("kept"), "--watch", "Main.count"}),
                  0)
            << said;
        EXPECT_NE(said.find(expected), std::string::npos) << said;
    }
}

INSTANTIATE_TEST_SUITE_P(Machines, BuildFor, ::testing::Values("x86_64", "aarch64"),
                         [](const auto& info) { return std::string(info.param); });

TEST_F(BuildCommand, AnEndlessLoopIsStoppedByItsBudget) { // 200 million passes: not by emulation
    write("main.st", "PROGRAM Main\nVAR\n    x : LINT;\nEND_VAR\nWHILE TRUE DO x := x + 1; END_WHILE;\nEND_PROGRAM\n");
    expectTheSameRecording(path("main.st"), "x86_64", {"--scans", "2"}, 1);
}

TEST_F(BuildCommand, TheProgramRefusesWhatItDoesNotKnow) {
    write("main.st", kCounter);
    ASSERT_EQ(build({path("main.st"), "--output", path("program")}), 0) << err;
    const std::string program = path("program");
    for (const auto& [words, expected] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--scan", "5"}, "There is no option --scan"},
             {{"--scans"}, "--scans needs a value"},
             {{"--scans", "many"}, "needs a whole number"},
             {{"--for", "5 apples"}, "needs a duration"},
             {{"--set", "Main.go"}, "PATH=VALUE"},
             {{"--set", "Main.gone=1"}, "gone"},
             {{"--set", "Main.count=red", "--scans", "1"}, "is not a value for Main.count; write one of type INT"},
             {{"--watch", "Nobody"}, "Nobody"},
             {{"--start", "tomorrow"}, "is not a date and time"},
             {{"--record", path("no/such/folder/x.rec"), "--scans", "1"}, "no/such/folder"}}) {
        EXPECT_EQ(start(program, "", words), 2) << words[0];
        EXPECT_NE(said.find(expected), std::string::npos) << said;
    }
    EXPECT_EQ(start(program, "", {"--help"}), 0);
    EXPECT_NE(said.find("--record FILE"), std::string::npos) << said;
}

TEST_F(BuildCommand, WhatCannotBeBuiltLeavesNothingBehind) {
    write("main.st", kCounter);
    write("wrong.st", "PROGRAM Main\nVAR x : INT; END_VAR\nx := 'text';\nEND_PROGRAM\n");
    write("kept", "the program before");
    const auto expectRefused = [&](const std::vector<std::string>& words, int code, const std::string& expected) {
        EXPECT_EQ(build(words), code) << expected;
        EXPECT_NE(err.find(expected), std::string::npos) << err;
        EXPECT_EQ(read("kept"), "the program before");
        EXPECT_FALSE(fs::exists(path("kept.new")));
        EXPECT_FALSE(fs::exists(path("kept.o.new")));
    };
    const std::string main = path("main.st"), kept = path("kept");
    expectRefused({}, 2, "needs a project folder");
    expectRefused({main}, 2, "build needs --output FILE");
    expectRefused({main, "--output", kept, "--target", "z80"}, 2, "x86_64 or aarch64, not z80");
    expectRefused({main, "--output", path("no/where/x")}, 2, "cannot be written: it is a folder");
    expectRefused({main, "--output", path("")}, 2, "cannot be written: it is a folder");
    expectRefused({main, "--output", kept, "--linker", "no-such-linker"}, 2,
                  "There is no linker no-such-linker; install it, or leave --linker out");
    expectRefused({main, "--output", kept, "--linker", "/bin/false"}, 2, "could not link");
    expectRefused({path("wrong.st"), "--output", kept}, 1, "");
}

TEST_F(BuildCommand, WithoutALinkerItSaysWhichPackageHasOne) {
    write("main.st", kCounter);
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", path("").c_str());
    EXPECT_EQ(build({path("main.st"), "--target", "aarch64", "--output", path("program")}), 2);
    qputenv("PATH", before);
    EXPECT_NE(err.find("install the package lld-19"), std::string::npos) << err;
}

} // namespace plc
