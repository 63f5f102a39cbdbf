// Faults that a program catches: what is recorded is replayed bit for bit, and the debugger goes through the parts.
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <gtest/gtest.h>

#include <thread>

namespace plc::session {
namespace {

using namespace std::chrono_literals;

driver::Built build(const std::string& text) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    driver::Built built = driver::build(input);
    std::string messages;
    for (const auto& each : built.checked.analysis->diagnostics) messages += each.message.english() + "\n";
    EXPECT_TRUE(built.program) << messages << built.failure.english();
    return built;
}

template <class Condition> bool eventually(Condition condition) {
    for (int i = 0; i < 60'000; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(1ms);
    }
    return false;
}

// Every third scan divides by zero, every fifth leaves the array: in place and in what is called.
const char* const kFaulty = "FUNCTION Share : INT\n"                                                   // 1
                            "VAR_INPUT whole, parts : INT; END_VAR\n"                                  // 2
                            "  Share := whole / parts;\n"                                              // 3
                            "END_FUNCTION\n"                                                           // 4
                            "PROGRAM Main\n"                                                           // 5
                            "VAR n, share, caught, ended : INT; a : ARRAY[0..4] OF INT; sum : DINT;\n" // 6
                            "  code, last : __SYSTEM.ExceptionCode; END_VAR\n"                         // 7
                            "  n := n + 1;\n"                                                          // 8
                            "  __TRY\n"                                                                // 9
                            "    a[n MOD 6] := n;\n"                                                   // 10
                            "    share := Share(1000, n MOD 3);\n"                                     // 11
                            "    sum := sum + share;\n"                                                // 12
                            "  __CATCH(code)\n"                                                        // 13
                            "    caught := caught + 1;\n"                                              // 14
                            "    last := code;\n"                                                      // 15
                            "  __FINALLY\n"                                                            // 16
                            "    ended := ended + 1;\n"                                                // 17
                            "  __ENDTRY\n"                                                             // 18
                            "  sum := sum + n;\n"                                                      // 19
                            "END_PROGRAM\n";

void runTo(Session& session, uint64_t scans) {
    session.runHere([&](const controller::Controller& controller) { return controller.nextScan() >= scans; });
}

/// The values of the program, as text; what differs by a bit differs here.
std::string valuesOf(Session& session) {
    std::string out;
    for (const char* name : {"n", "share", "caught", "ended", "sum", "last", "a[0]", "a[4]"}) {
        const auto value = session.controller().read(std::string("Main.") + name);
        out += std::string(name) + "=" + (value ? std::to_string(value->integer()) : "?") + " ";
    }
    return out;
}

TEST(CaughtFaults, GoingBackAndRunningAgainGivesTheSameBits) {
    Session session(build(kFaulty));
    ASSERT_TRUE(session.program());
    session.controller().start();
    runTo(session, 200);
    const std::string first = valuesOf(session);
    EXPECT_EQ(session.controller().state(), controller::State::Running);
    EXPECT_EQ(session.controller().read("Main.ended")->integer(), 200);
    EXPECT_GT(session.controller().read("Main.caught")->integer(), 60);
    for (const history::Position from : {history::Position(17), history::Position(99), history::Position(150)}) {
        ASSERT_TRUE(session.resumeFrom(from));
        runTo(session, 200);
        EXPECT_EQ(valuesOf(session), first) << "from " << from;
    }
}

TEST(CaughtFaults, TwoRunsGiveTheSameBitsScanByScan) {
    Session one(build(kFaulty)), two(build(kFaulty));
    ASSERT_TRUE(one.program() && two.program());
    one.controller().start();
    two.controller().start();
    for (uint64_t scan = 1; scan <= 60; ++scan) {
        runTo(one, scan);
        runTo(two, scan);
        ASSERT_EQ(valuesOf(one), valuesOf(two)) << "scan " << scan;
    }
}

TEST(CaughtFaults, TheDebuggerGoesThroughTheParts) {
    Session session(build(kFaulty));
    ASSERT_TRUE(session.program());
    session.startThread({Pace::Real, 1.0});
    const auto place = [&]() -> std::string {
        const auto frames = session.haltFrames();
        if (frames.empty()) return "";
        const auto program = session.program();
        return frames[0].function + ":" +
               std::to_string(program->sources[frames[0].range.file].lineColumn(frames[0].range.begin).line);
    };
    const auto step = [&](Step kind, const std::string& expected) {
        session.step(kind);
        EXPECT_TRUE(eventually([&] { return place() == expected; })) << "at " << place() << ", expected " << expected;
    };
    Breakpoint atDivision;
    atDivision.file = FileId(0u);
    atDivision.line = 3;
    atDivision.condition = "parts = 0";
    session.setBreakpoints({atDivision});
    ASSERT_TRUE(eventually([&] { return place() == "Share:3"; })) << place();
    session.setBreakpoints({});
    step(Step::Over, "Main:14"); // the fault leaves the function for what catches it
    step(Step::Over, "Main:15");
    step(Step::Over, "Main:17");
    step(Step::Over, "Main:19");
    step(Step::Over, "Main:8"); // of the next scan
    Breakpoint inCatch;
    inCatch.file = FileId(0u);
    inCatch.line = 14;
    session.setBreakpoints({inCatch});
    session.resume();
    ASSERT_TRUE(eventually([&] { return place() == "Main:14"; })) << place();
    session.setBreakpoints({});
    session.resume();
    EXPECT_TRUE(eventually([&] { return session.status().state == controller::State::Running; }));
    session.end();
}

} // namespace
} // namespace plc::session
