// Faults that a program catches: what is recorded is replayed bit for bit, and the debugger goes through the parts.
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/support/eventually.h"

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

// Every third scan divides by zero, every fifth leaves the array: in place and in what is called.
const char* const kFaulty = "FUNCTION Share : INT\n"                                                  // 1
                            "VAR_INPUT whole, parts : INT; END_VAR\n"                                 // 2
                            "  Share := whole / parts;\n"                                             // 3
                            "END_FUNCTION\n"                                                          // 4
                            "PROGRAM Main\n"                                                          // 5
                            "VAR n, part, caught, ended : INT; a : ARRAY[0..4] OF INT; sum : DINT;\n" // 6
                            "  code, last : __SYSTEM.ExceptionCode; END_VAR\n"                        // 7
                            "  n := n + 1;\n"                                                         // 8
                            "  __TRY\n"                                                               // 9
                            "    a[n MOD 6] := n;\n"                                                  // 10
                            "    part := Share(1000, n MOD 3);\n"                                     // 11
                            "    sum := sum + part;\n"                                                // 12
                            "  __CATCH(code)\n"                                                       // 13
                            "    caught := caught + 1;\n"                                             // 14
                            "    last := code;\n"                                                     // 15
                            "  __FINALLY\n"                                                           // 16
                            "    ended := ended + 1;\n"                                               // 17
                            "  __ENDTRY\n"                                                            // 18
                            "  sum := sum + n;\n"                                                     // 19
                            "END_PROGRAM\n";

void runTo(Session& session, uint64_t scans) {
    controller::Controller& controller = session.controller();
    if (controller.state() != controller::State::Running) controller.start();
    while (controller.nextScan() < scans) ASSERT_TRUE(controller.scan());
}

/// The values of the program, as text; what differs by a bit differs here.
std::string valuesOf(Session& session) {
    std::string out;
    for (const char* name : {"n", "part", "caught", "ended", "sum", "last", "a[0]", "a[4]"}) {
        const auto value = session.controller().read(std::string("Main.") + name);
        out += std::string(name) + "=" + (value ? std::to_string(value->integer()) : "?") + " ";
    }
    return out;
}

TEST(CaughtFaults, GoingBackAndRunningAgainGivesTheSameBits) {
    Session session(build(kFaulty));
    ASSERT_TRUE(session.program());
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
    const auto line = [&]() -> uint32_t {
        const auto frames = session.haltFrames();
        if (frames.empty()) return 0;
        const auto program = session.program();
        return program->sources[frames[0].range.file].lineColumn(frames[0].range.begin).line;
    };
    Breakpoint beforeTheFault;
    beforeTheFault.file = FileId(0u);
    beforeTheFault.line = 11;
    beforeTheFault.instance = "Main";
    beforeTheFault.condition = "n MOD 3 = 0";
    session.setBreakpoints({beforeTheFault});
    ASSERT_TRUE(eventually([&] { return line() == 11; })) << line();
    EXPECT_EQ(session.haltProblem().english(), "");
    session.setBreakpoints({});
    session.step(Step::In);
    ASSERT_TRUE(eventually([&] { return line() == 3; })) << line();
    std::vector<uint32_t> seen; // the fault leaves the function for what catches it, and so on into the next scan
    for (uint32_t before = 3; seen.size() < 10 && before != 8; before = seen.back()) {
        session.step(Step::Over);
        ASSERT_TRUE(eventually([&] { return line() != 0 && line() != before; })) << "after line " << before;
        seen.push_back(line());
    }
    std::erase_if(seen, [](uint32_t each) { return each == 9 || each == 13 || each == 16 || each == 18; });
    EXPECT_EQ(seen, (std::vector<uint32_t>{14, 15, 17, 19, 8}));
    Breakpoint inCatch;
    inCatch.file = FileId(0u);
    inCatch.line = 14;
    session.setBreakpoints({inCatch});
    session.resume();
    ASSERT_TRUE(eventually([&] { return line() == 14; })) << line();
    session.setBreakpoints({});
    session.resume();
    EXPECT_TRUE(eventually([&] { return session.status().state == controller::State::Running; }));
    session.end();
}

} // namespace
} // namespace plc::session
