// `stepwise run`: the CSV on the standard output, into a pipe and on a full disk; Ctrl+C while it waits; the exit
// codes.
#include "tests/app/cli/command_fixture.h"
#include "tests/support/eventually.h"
#include "tests/support/long_scans.h"
#include "tests/support/processor_time.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <poll.h>
#include <pty.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace plc {
namespace {

namespace fs = std::filesystem;

const char* const kCounter =
    "PROGRAM Main\nVAR\n    count : INT;\nEND_VAR\ncount := count + 1;\nEND_PROGRAM\n"
    "CONFIGURATION Plc\n    RESOURCE Cpu ON Pc\n        TASK Slow(INTERVAL := T#10ms, PRIORITY := 1);\n        PROGRAM "
    "Main WITH Slow : Main;\n    END_RESOURCE\nEND_CONFIGURATION\n";

class RunCommand : public CommandTest {
protected:
    void SetUp() override { write("main.st", kCounter); }
    int run(std::vector<std::string> words) {
        words.insert(words.begin(), "run");
        return command(words);
    }
};

const std::string kThreeRows = "time_s,scan,Main.count\r\n0,0,1\r\n0.01,1,2\r\n0.02,2,3\r\n";

} // namespace

TEST_F(RunCommand, ADashIsTheStandardOutputAndTheReportGoesBesideIt) {
    testing::internal::CaptureStdout();
    const int code = run({path("main.st"), "--scans", "3", "--csv", "-"});
    EXPECT_EQ(testing::internal::GetCapturedStdout(), kThreeRows);
    EXPECT_EQ(code, 0);
    EXPECT_EQ(out, "") << "the report would stand in the table";
    EXPECT_NE(err.find("Main.count"), std::string::npos);
    EXPECT_FALSE(fs::exists("-"));
}

TEST_F(RunCommand, APipeIsWrittenAndStaysAPipe) {
    const std::string pipe = path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(reader, 0);
    EXPECT_EQ(run({path("main.st"), "--scans", "3", "--csv", pipe}), 0) << err;
    char text[4096];
    const ssize_t n = ::read(reader, text, sizeof text);
    ::close(reader);
    EXPECT_EQ(std::string(text, n > 0 ? static_cast<size_t>(n) : 0), kThreeRows);
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_FALSE(fs::exists(pipe + ".part"));
}

TEST_F(RunCommand, AFullDiskLeavesTheOldTableAndIsTold) {
    write("old.csv", "kept");
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit tight{2000, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const int code = run({path("main.st"), "--scans", "1000", "--csv", path("old.csv")});
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(code, 2);
    EXPECT_NE(err.find("The CSV file cannot be written"), std::string::npos) << err;
    EXPECT_EQ(read("old.csv"), "kept");
    EXPECT_FALSE(fs::exists(path("old.csv.part")));
}

TEST_F(RunCommand, AFolderIsNoTable) {
    fs::create_directory(path("folder"));
    EXPECT_EQ(run({path("main.st"), "--scans", "1", "--csv", path("folder")}), 2);
    EXPECT_NE(err.find("it is a folder; choose a file"), std::string::npos) << err;
    EXPECT_EQ(run({path("main.st"), "--scans", "1", "--csv", path("none/x.csv")}), 2);
    EXPECT_NE(err.find("none/x.csv"), std::string::npos) << err;
}

bool catchesInterrupts() {
    struct sigaction now {};
    ::sigaction(SIGINT, nullptr, &now);
    return now.sa_handler != SIG_DFL;
}

TEST_F(RunCommand, CtrlCEndsAWaitAtOnceAndStillReports) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    std::string slow = kCounter;
    slow.replace(slow.find("T#10ms"), 6, "T#60s");
    write("slow.st", slow);
    const auto interrupted = [&] {
        std::thread presser([] {
            eventually(catchesInterrupts);
            // a duration: the first scan is over; that the run waits for the next one cannot be seen from outside
            std::this_thread::sleep_for(std::chrono::milliseconds(500));
            ::kill(::getpid(), SIGINT);
        });
        const auto begin = std::chrono::steady_clock::now();
        const int code = run({path("slow.st"), "--for", "10m", "--real"});
        presser.join();
        const bool isFast = std::chrono::steady_clock::now() - begin < std::chrono::seconds(30);
        const bool isTold = out.find("Main.count") != std::string::npos && out.find("1 scans") != std::string::npos;
        std::_Exit(isFast && isTold ? 40 + code : 99);
    };
    EXPECT_EXIT(interrupted(), testing::ExitedWithCode(40), "");
}

TEST_F(RunCommand, CtrlCEndsAScanThatTakesYears) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const std::string file = path("long.st");
    write("long_test.st", "TEST 'long'\nRUN 1000 SCANS;\nEND_TEST\n");
    int way = 0;
    for (const LongScan& scan : longScans()) {
        write("long.st", scan.text);
        const std::string variable = "Main." + scan.variable;
        for (const std::vector<std::string>& line :
             {std::vector<std::string>{"run", file, "--for", "10m", "--real"},
              {"run", file, "--for", "10m"},
              {"trace", file, "--channels", variable, "--for", "10m", "--csv", path("out.csv")},
              {"why", file, variable, "--for", "10m"},
              {"test", file, path("long_test.st")}}) {
            if (kFewer > 1 && way++ % 4 != 0) continue; // run, test, why and trace once each
            const auto interrupted = [&] {
                double pressed = 0;
                std::atomic<bool> isOver = false;
                std::thread presser([&pressed, &isOver] {
                    eventually([&] { return catchesInterrupts() || isOver; });
                    if (!catchesInterrupts()) std::_Exit(98); // refused: it has not run
                    // a duration: that the scan has begun cannot be seen from outside
                    std::this_thread::sleep_for(std::chrono::milliseconds(300));
                    pressed = ownSeconds();
                    ::kill(::getpid(), SIGINT);
                });
                (void)command(line);
                isOver = true;
                presser.join(); // a fast machine may have used up the budget of virtual time before
                const double took = ownSeconds() - pressed; // with an image of memory for the last values
                std::_Exit(took < kAtOnceSeconds + secondsForNewMemory(360'000'000) ? 40 : 99);
            };
            EXPECT_EXIT(interrupted(), testing::ExitedWithCode(40), "") << scan.name << ": " << line[0];
        }
    }
}

TEST_F(RunCommand, CtrlCEndsALookIntoALongScan) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    write("long.st", "FUNCTION Next : LINT\nVAR_INPUT q : LINT; END_VAR\nNext := q + 1;\nEND_FUNCTION\n"
                     "PROGRAM Main\nVAR a, i : LINT; END_VAR\nFOR i := 1 TO " +
                         std::to_string(repeats(40'000'000)) +
                         " DO a := Next(a); END_FOR\nEND_PROGRAM\n"
                         "CONFIGURATION C\nRESOURCE R ON Soft\n"
                         "TASK T (INTERVAL := T#10ms, PRIORITY := 1, WATCHDOG := T#1h);\n"
                         "PROGRAM Main WITH T : Main;\nEND_RESOURCE\nEND_CONFIGURATION\n");
    const std::string recording = path("long.rec");
    ASSERT_EQ(run({path("long.st"), "--for", "20ms", "--record", recording}), 0) << err;
    for (const std::vector<std::string>& line : {std::vector<std::string>{"replay", recording, "--inside", "1"},
                                                 {"replay", recording, "--writers", "Main.a"},
                                                 {"why", recording, "Main.a"},
                                                 {"why", recording, "Main.a > 5", "--not"}}) {
        const auto interrupted = [&] {
            std::signal(SIGINT, SIG_DFL); // the run that was recorded has caught it
            const double atMost = kAtOnceSeconds + secondsForNewMemory(360'000'000); // what was seen is given back
            std::thread presser([atMost] {
                eventually(catchesInterrupts);
                // a duration: that the look has begun cannot be seen from outside
                std::this_thread::sleep_for(std::chrono::milliseconds(300));
                const double pressed = ownSeconds();
                ::kill(::getpid(), SIGINT);
                eventually([&] { return ownSeconds() - pressed >= atMost; });
                std::_Exit(99);
            });
            const int code = command(line);
            std::_Exit(code == 130 && err.find("before the answer was known") != std::string::npos ? 40 : 98);
        };
        EXPECT_EXIT(interrupted(), testing::ExitedWithCode(40), "") << line[0] << " " << line[2];
    }
}

TEST_F(RunCommand, ExitCodesTellWhoseMistakeItWas) {
    EXPECT_EQ(run({path("main.st"), "--scans", "1"}), 0);
    EXPECT_NE(out.find("1 scans"), std::string::npos) << out;

    write("none.st", "FUNCTION F : INT\nF := 1;\nEND_FUNCTION\n");
    EXPECT_EQ(run({path("none.st")}), 1);
    EXPECT_NE(out.find("There is no PROGRAM") != std::string::npos ||
                  err.find("there is no PROGRAM") != std::string::npos,
              false)
        << out << err;

    write("wrong.st", "PROGRAM Main\nx := 1;\nEND_PROGRAM\n");
    EXPECT_EQ(run({path("wrong.st")}), 1);
    EXPECT_NE((out + err).find("x is not declared"), std::string::npos) << out << err;

    write("fault.st", "PROGRAM Main\nVAR\n    a, b : INT;\nEND_VAR\na := 10 / b;\nb := 0;\nEND_PROGRAM\n");
    EXPECT_EQ(run({path("fault.st")}), 1);
    EXPECT_NE(out.find("fault: "), std::string::npos) << out << err;
    EXPECT_NE(out.find("fault.st:5"), std::string::npos) << out;

    EXPECT_EQ(run({}), 2);
    EXPECT_EQ(run({path("missing.st")}), 2);
    EXPECT_NE(err.find("missing.st"), std::string::npos) << err;
    EXPECT_EQ(run({path("main.st"), "--sacns", "1"}), 2);
    EXPECT_NE(err.find("--sacns"), std::string::npos) << err;
    EXPECT_EQ(run({path("main.st"), "--scans", "many"}), 2);
    EXPECT_EQ(run({path("main.st"), "--set", "Main.nothing=1"}), 2);
    EXPECT_NE(err.find("Main.nothing"), std::string::npos) << err;
    EXPECT_EQ(run({path("main.st"), "--until", "Main.count"}), 2);
    EXPECT_EQ(run({path("main.st"), "--every", "0s", "--csv", path("x.csv")}), 2);
}

TEST_F(RunCommand, WorkThatTakesOverASecondHasALineOnATerminalAndNoneElsewhere) {
    int terminal = -1, end = -1;
    ASSERT_EQ(::openpty(&terminal, &end, nullptr, nullptr, nullptr), 0);
    const int before = ::dup(STDERR_FILENO);
    ::dup2(end, STDERR_FILENO);
    std::string text;
    const auto readMore = [&](int milliseconds) {
        pollfd more{terminal, POLLIN, 0};
        char part[4096];
        if (::poll(&more, 1, milliseconds) <= 0) return false;
        const auto count = ::read(terminal, part, sizeof part);
        if (count > 0) text.append(part, static_cast<size_t>(count));
        return count > 0;
    };
    {
        const cli::Busy busy("checking plant");
        while (text.find("checking plant, 1 s") == std::string::npos && readMore(20'000)) continue;
    }
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    while (readMore(0)) continue; // what the end wrote is there already
    ::close(end);
    ::close(terminal);
    EXPECT_NE(text.find("checking plant, 1 s"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\033[K")) << "erased at the end";
}

} // namespace plc
