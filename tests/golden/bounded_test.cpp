// No program harms the studio: what would take more memory, stack or time than there is ends with a message or a fault,
// the same in both tiers, and a scan that takes long can be left.
#include "projects/session/session.h"
#include "runtime/compiler/driver/driver.h"
#include "tests/support/kinds_of_long_scans.h"
#include "tests/support/patience.h"
#include "tests/support/processor_time.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace plc::golden {
namespace {

using namespace std::chrono_literals;
using image::FaultCode;

driver::Built built(const std::string& text) {
    driver::BuildInput input;
    input.files.push_back({"bounded.st", text});
    return driver::build(input);
}

/// The error of the check or of the compiler.
std::string refusal(const std::string& text) {
    const driver::Built made = built(text);
    if (made.program) return {};
    if (!made.failure.isEmpty()) return made.failure.english();
    for (const auto& diagnostic : made.checked.analysis->diagnostics)
        if (diagnostic.severity == diagnostics::Severity::Error) return diagnostic.message.english();
    return {};
}

/// Fault and image after one scan of each tier, which must agree.
struct Ran {
    FaultCode code = FaultCode::None;
    size_t depth = 0; // of the call path
    std::string line;
};
Ran scanned(const driver::Built& made, int64_t budget) {
    controller::Settings settings;
    settings.loopBudgetPerScan = budget;
    controller::Controller controller(made.program, settings);
    controller.start();
    (void)controller.scan();
    if (!controller.fault()) return {};
    const controller::Fault& fault = *controller.fault();
    const SourceText* file = fault.range.file.isValid() ? &made.program->sources[fault.range.file] : nullptr;
    return {fault.code, fault.calls.size(),
            file ? std::to_string(file->lineColumn(fault.range.begin).line) : std::string()};
}
FaultCode faultOf(const std::string& text, int64_t budget = 200'000'000) {
    const driver::Built made = built(text);
    EXPECT_TRUE(made.program) << refusal(text);
    if (!made.program) return FaultCode::None;
    const Ran quick = scanned(made, budget);
    EXPECT_TRUE(driver::optimise(made));
    const Ran optimised = scanned(made, budget);
    EXPECT_EQ(quick.code, optimised.code);
    EXPECT_EQ(quick.depth, optimised.depth);
    EXPECT_EQ(quick.line, optimised.line);
    return quick.code;
}

std::string repeated(int count, const std::function<std::string(int)>& piece) {
    std::string out;
    for (int i = 0; i < count; ++i) out += piece(i);
    return out;
}

// ---------------------------------------------------------------- memory

TEST(Bounded, LocalsBeyondTheImageAreRefused) {
    constexpr const char* kBig = " : ARRAY[0..268435455] OF BYTE;\n";
    const std::string many = "FUNCTION F : INT\nVAR_INPUT q : DINT; END_VAR\nVAR\n" +
                             repeated(16, [&](int i) { return "t" + std::to_string(i) + kBig; }) +
                             "END_VAR\nt15[q] := 5; F := t15[q];\nEND_FUNCTION\n"
                             "PROGRAM Main\nVAR a : INT; END_VAR\na := F(3);\nEND_PROGRAM\n";
    EXPECT_NE(refusal(many), "");
    const std::string chain = repeated(17,
                                       [&](int i) {
                                           const std::string n = std::to_string(i);
                                           return "FUNCTION F" + n + " : INT\nVAR_INPUT q : DINT; END_VAR\nVAR t" +
                                                  kBig + "END_VAR\nt[q] := 5; F" + n + " := t[q]" +
                                                  (i ? " + F" + std::to_string(i - 1) + "(q)" : std::string()) +
                                                  ";\nEND_FUNCTION\n";
                                       }) +
                              "PROGRAM Main\nVAR a : INT; END_VAR\na := F16(3);\nEND_PROGRAM\n";
    EXPECT_NE(refusal(chain), "");
    const std::string temporaries = "PROGRAM Main\nVAR a : INT; END_VAR\nVAR_TEMP\n" +
                                    repeated(16, [&](int i) { return "t" + std::to_string(i) + kBig; }) + "END_VAR\n" +
                                    repeated(16, [](int i) { return "t" + std::to_string(i) + "[5] := 1;\n"; }) +
                                    "a := t15[5];\nEND_PROGRAM\n";
    EXPECT_NE(refusal(temporaries), "");
}

// ---------------------------------------------------------------- stack

/// F0, F1 … each calls the one before.
std::string chain(int length, const std::string& parameter, const std::string& argument, const std::string& work) {
    return repeated(length, [&](int i) {
        const std::string n = std::to_string(i);
        return "FUNCTION F" + n + " : DINT\n" + parameter + "F" + n +
               " := " + (i ? "F" + std::to_string(i - 1) + "(" + argument + ") + 1" : work) + ";\nEND_FUNCTION\n";
    });
}

TEST(Bounded, CallsAreAsDeepInEachTierWhetherTheyCanFaultOrNot) {
    const auto program = [](int length, const std::string& work) {
        return chain(length, "VAR_INPUT q : DINT; END_VAR\n", "q", work) +
               "PROGRAM Main\nVAR a : DINT := 7; END_VAR\na := F" + std::to_string(length - 1) + "(a);\nEND_PROGRAM\n";
    };
    for (const char* work : {"q", "100 / q"}) {
        EXPECT_EQ(faultOf(program(250, work)), FaultCode::None) << work;
        EXPECT_EQ(faultOf(program(300, work)), FaultCode::StackOverflow) << work;
    }
}

TEST(Bounded, ADeepChainOfCallsWithManyBoundsKeepsToTheMachinesStack) {
    // LLVM's optimiser takes the square of the parameters: a hundred seconds for 1,000 dimensions.
    for (const auto& [isOptimised, functions, count] :
         {std::tuple(false, 250, repeats(1000)), std::tuple(true, 750, repeats(100))}) {
        const auto dimensions = [count = count](const std::string& each) {
            return "[" + repeated(count, [&](int i) { return (i ? "," : "") + each; }) + "]";
        };
        const std::string text =
            chain(functions, "VAR_IN_OUT a : ARRAY" + dimensions("*") + " OF BYTE; END_VAR\n", "a", "1") +
            "PROGRAM Main\nVAR t : ARRAY" + dimensions("0..0") + " OF BYTE; r : DINT; END_VAR\nr := F" +
            std::to_string(functions - 1) + "(t);\nEND_PROGRAM\n";
        const driver::Built made = built(text);
        ASSERT_TRUE(made.program) << refusal(text);
        if (isOptimised) {
            ASSERT_TRUE(driver::optimise(made));
        }
        const FaultCode code = scanned(made, 200'000'000).code; // not a crash
        EXPECT_TRUE(code == FaultCode::None || code == FaultCode::StackOverflow) << static_cast<int>(code);
    }
}

// ---------------------------------------------------------------- time

TEST(Bounded, CallsWithoutLoopsAreCharged) {
    const std::string text = "FUNCTION F0 : INT\nVAR_INPUT q : INT; END_VAR\nF0 := q;\nEND_FUNCTION\n" +
                             repeated(59,
                                      [](int i) {
                                          const std::string before = "F" + std::to_string(i),
                                                            name = "F" + std::to_string(i + 1);
                                          return "FUNCTION " + name + " : INT\nVAR_INPUT q : INT; END_VAR\n" + name +
                                                 " := " + before + "(q) + " + before + "(q + 1) MOD 7;\nEND_FUNCTION\n";
                                      }) +
                             "PROGRAM Main\nVAR a : INT; END_VAR\na := F59(a);\nEND_PROGRAM\n";
    EXPECT_EQ(faultOf(text, 5'000'000), FaultCode::Watchdog);
}

TEST(Bounded, LargeCopiesAreCharged) {
    EXPECT_EQ(faultOf("PROGRAM Main\nVAR a, b : ARRAY[0..60000000] OF BYTE; i : DINT; END_VAR\n"
                      "FOR i := 0 TO 100000000 DO a[i MOD 1000] := b[5]; b := a; END_FOR\nEND_PROGRAM\n",
                      10'000'000),
              FaultCode::Watchdog);
}

TEST(Bounded, LongTextsAreChargedAndSearchedInALineOfTime) {
    // The needle is nearly everywhere: the naive search compares a thousand million times.
    EXPECT_EQ(faultOf("PROGRAM Main\nVAR i : LINT; k : INT; s, n : STRING(65000); END_VAR\n"
                      "s := 'a'; FOR i := 1 TO 15 DO s := CONCAT(s, s); END_FOR\n"
                      "n := CONCAT(LEFT(s, 16000), 'b'); FOR i := 0 TO 10000000 DO k := FIND(s, n); END_FOR\n"
                      "END_PROGRAM\n",
                      2'000'000),
              FaultCode::Watchdog);
}

TEST(Bounded, ALongBodyIsChargedByItsLength) {
    // A pass of 2,000 statements is not one unit.
    const std::string text = "PROGRAM Main\nVAR i, k : DINT; END_VAR\nFOR i := 1 TO 100000 DO\n" +
                             repeated(2000, [](int i) { return "k := k + " + std::to_string(i) + ";\n"; }) +
                             "END_FOR\nEND_PROGRAM\n";
    EXPECT_EQ(faultOf(text, 1'000'000), FaultCode::Watchdog);
}

TEST(Bounded, InitialValuesEndWhereNobodyCanStopThem) {
    const std::string text = "FUNCTION_BLOCK B\nVAR x : DINT; END_VAR\nMETHOD FB_Init : BOOL\nVAR_INPUT bInitRetains, "
                             "bInCopyCode : BOOL; END_VAR\nWHILE TRUE DO x := x + 1; END_WHILE\nEND_METHOD\n"
                             "END_FUNCTION_BLOCK\nPROGRAM Main\nVAR b : B; END_VAR\nb();\nEND_PROGRAM\n";
    const driver::Built made = built(text);
    ASSERT_TRUE(made.program) << refusal(text);
    const controller::Controller controller(made.program);
    ASSERT_TRUE(controller.fault());
    EXPECT_EQ(controller.fault()->code, FaultCode::Watchdog);
}

// ---------------------------------------------------------------- building

/// Processor time, so that what else the machine does is not measured.
double secondsToBuild(const std::string& text) {
    const double begin = processorSeconds();
    const driver::Built made = built(text);
    const double seconds = processorSeconds() - begin;
    EXPECT_TRUE(made.program) << refusal(text).substr(0, 300);
    return seconds;
}

TEST(Bounded, LongProgramsAreBuiltInSecondsThatGrowAsTheyDo) {
    const auto inMain = [](const std::string& statements) {
        return "PROGRAM Main\nVAR a, b : DINT; END_VAR\n" + statements + "END_PROGRAM\n";
    };
    const auto labels = [&](int count) {
        return inMain("CASE a OF\n" + repeated(count, [](int i) { return std::to_string(i) + ": b := b + 1;\n"; }) +
                      "END_CASE\n");
    };
    const auto branches = [&](int count) {
        return inMain("IF a = -1 THEN b := 1;\n" +
                      repeated(count, [](int i) { return "ELSIF a = " + std::to_string(i) + " THEN b := b + 1;\n"; }) +
                      "END_IF\n");
    };
    const auto calls = [&](int count) {
        return chain(count, "VAR_INPUT q : DINT; END_VAR\n", "q", "q") + inMain("a := F249(a);\n");
    };
    struct Row {
        const char* name;
        std::function<std::string(int)> text;
        int size; // of the one that was reported
    };
    for (const Row& row : {Row{"labels of a CASE", labels, 8'000}, Row{"ELSIF", branches, 100'000},
                           Row{"functions in a chain", calls, 20'000}}) {
        const int size = repeats(row.size);
        const double quarter = secondsToBuild(row.text(size / 4));
        const std::string all = row.text(size);
        const double most = 6 * quarter + 0.3; // what grows with the square takes 16 times as long
        double whole = secondsToBuild(all);
        // What else the machine does only adds (pages and caches are shared): the least is the program's own.
        for (int again = 0; again < 3 && whole >= most; ++again) whole = std::min(whole, secondsToBuild(all));
        RecordProperty(row.name, std::to_string(whole));
        EXPECT_LT(whole, most) << row.name << ": " << quarter << " s, four times as many " << whole << " s";
    }
}

// ---------------------------------------------------------------- leaving a scan

constexpr const char* kEndless = "PROGRAM Main\nVAR x : DINT; END_VAR\nWHILE TRUE DO x := x + 1; END_WHILE\n"
                                 "END_PROGRAM\nCONFIGURATION C\nRESOURCE R ON Soft\nTASK T (INTERVAL := T#10ms, "
                                 "PRIORITY := 1, WATCHDOG := T#1h);\nPROGRAM Main WITH T : Main;\nEND_RESOURCE\n"
                                 "END_CONFIGURATION\n";

/// Asked when a task starts, and then while it takes long.
struct SeenClock final : controller::Clock {
    std::atomic<bool> wasAsked{false};
    int64_t nowNs() override {
        wasAsked = true;
        return std::chrono::steady_clock::now().time_since_epoch().count();
    }
};

/// A session that is in the middle of a scan without an end.
class EndlessScan {
public:
    explicit EndlessScan(session::Pace pace, const std::string& text = kEndless) {
        driver::Built made = built(text);
        session::Settings settings;
        settings.controller.loopBudgetPerScan = INT64_MAX / 2;
        settings.controller.defaultWatchdog = 1h;
        settings.controller.clock = &clock;
        session = std::make_unique<session::Session>(std::move(made), settings);
        session->startThread({pace, 1.0});
        while (!clock.wasAsked) std::this_thread::yield();
    }
    /// The processor time from the request to the end; `seconds` says of what.
    double secondsToStop(const std::function<void(session::Session&)>& ask, double (*seconds)() = processorSeconds) {
        const auto begin = std::chrono::steady_clock::now();
        const double used = seconds();
        ask(*session);
        while (session->status().state != controller::State::Stopped &&
               std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(kPatience))
            std::this_thread::sleep_for(1ms); // a duration: between two looks
        EXPECT_EQ(session->status().state, controller::State::Stopped);
        return seconds() - used;
    }
    SeenClock clock;
    std::unique_ptr<session::Session> session;
};

TEST(Bounded, StopAndResetEndAnyScan) {
    for (const session::Pace pace : {session::Pace::Real, session::Pace::Fastest}) {
        EXPECT_LT(EndlessScan(pace).secondsToStop([](session::Session& session) { session.stop(); }), kAtOnceSeconds);
        EXPECT_LT(EndlessScan(pace).secondsToStop(
                      [](session::Session& session) { session.reset(controller::ResetKind::Cold); }),
                  kAtOnceSeconds);
    }
}

TEST(Bounded, ClosingEndsAnyScan) {
    EndlessScan scan(session::Pace::Real);
    const double used = processorSeconds();
    scan.session.reset();
    EXPECT_LT(processorSeconds() - used, kAtOnceSeconds);
}

TEST(Bounded, AScanIsLeftInTheMiddleOfAnyWork) {
    for (const LongScan& kind : kindsOfLongScans()) {
        ASSERT_TRUE(built(kind.text).program) << kind.name << ": " << refusal(kind.text);
        EndlessScan scan(session::Pace::Real, kind.text);
        std::this_thread::sleep_for(200ms); // a duration: of the scan, until it is in that work
        ASSERT_EQ(scan.session->status().scans, 0u) << kind.name << " is not long";
        const double seconds = scan.secondsToStop([](session::Session& session) { session.stop(); }, ownSeconds);
        EXPECT_LT(seconds, kAtOnceSeconds + secondsForNewMemory(240'000'000)) << kind.name;
        RecordProperty(kind.name, std::to_string(seconds));
    }
}

} // namespace
} // namespace plc::golden
