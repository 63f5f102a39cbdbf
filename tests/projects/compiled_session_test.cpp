// The session with compiled programs: going back in time, changing the program while it runs, breakpoints in ST,
// threads.
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/projects/random_program.h"
#include "tests/support/eventually.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <random>
#include <thread>

namespace plc::session {
namespace {

using namespace std::chrono_literals;
using types::TypeKind;
using types::TypeTable;
using types::Value;
using PlcState = controller::State;

driver::Built build(const std::string& text) {
    static const bool once = (jit::setRuntimeSymbols(controller::runtimeSymbols()), true);
    (void)once;
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
#ifdef PLC_THREAD_SANITIZED
    input.threadSanitizer = true; // the thread contract holds for generated code too
#endif
    driver::Built built = driver::build(input);
    std::string messages;
    for (const auto& d : built.checked.analysis->diagnostics) messages += d.message.english() + "\n";
    EXPECT_TRUE(built.program) << messages << built.failure.english();
    return built;
}

const char* const kPlant = R"(
TYPE Mode : (Idle, Filling, Draining); END_TYPE
FUNCTION_BLOCK Filter
VAR_INPUT x : REAL; k : REAL; END_VAR
VAR_OUTPUT y : REAL; END_VAR
  y := y + (x - y) * k;
END_FUNCTION_BLOCK
FUNCTION Noise : DWORD
VAR_IN_OUT seed : DWORD; END_VAR
  seed := seed XOR SHL(seed, 13);
  seed := seed XOR SHR(seed, 17);
  seed := seed XOR SHL(seed, 5);
  Noise := seed;
END_FUNCTION
PROGRAM Main
VAR
  seed : DWORD := 16#12345678; level : REAL; phase : Mode; lowPass : Filter; t : TON; count : CTU; log : ARRAY[0..31] OF INT; here : INT;
  text : STRING(20); p : REF_TO INT; lamp AT %QX0.0 : BOOL; pulse : R_TRIG; n : ULINT; input : INT;
END_VAR
  n := n + 1;
  Noise(seed := seed);
  CASE phase OF
    Mode#Idle: IF seed.3 THEN phase := Mode#Filling; END_IF
    Mode#Filling: level := level + 0.7; IF level > 50.0 THEN phase := Mode#Draining; END_IF
    Mode#Draining: level := level - 1.3; IF level < 1.0 THEN phase := Mode#Idle; END_IF
  END_CASE
  lowPass(x := level, k := 0.1);
  t(IN := phase = Mode#Filling, PT := T#130ms);
  pulse(CLK := t.Q);
  count(CU := pulse.Q, PV := 10, RESET := count.Q);
  here := (here + 1) MOD 32;
  p := REF(log[here]);
  p^ := DINT_TO_INT(REAL_TO_DINT(lowPass.y)) + input;
  text := CONCAT('n', UDINT_TO_STRING(seed));
  lamp := t.Q;
END_PROGRAM
PROGRAM Slow
VAR sum : LREAL; END_VAR
  sum := sum + 0.1;
END_PROGRAM
CONFIGURATION C
  RESOURCE R ON PLC
    TASK Fast (INTERVAL := T#10ms, PRIORITY := 1);
    TASK Other (INTERVAL := T#35ms, PRIORITY := 2);
    PROGRAM Main WITH Fast : Main;
    PROGRAM Slow WITH Other : Slow;
  END_RESOURCE
END_CONFIGURATION
)";

/// A session whose inputs are written as from a recipe: what is written depends on the scan alone.
class Plant {
public:
    Plant(unsigned seed, const std::string& program, std::string input)
        : m_seed(seed), m_input(std::move(input)), session(build(program)) {
        session.controller().start();
    }
    void run(uint64_t until) {
        while (session.controller().nextScan() < until) {
            std::mt19937 dice(m_seed + static_cast<unsigned>(session.controller().nextScan()));
            if (dice() % 5 == 0) {
                ASSERT_TRUE(
                    session.controller().write(m_input, Value{TypeTable::of(TypeKind::Int), int64_t(dice() % 100)}));
            }
            ASSERT_TRUE(session.controller().scan()) << session.controller().fault()->message.english();
        }
    }

private:
    unsigned m_seed;
    std::string m_input;

public:
    Session session;
};

unsigned seedOfRun() {
    const char* given = std::getenv("STEPWISE_SEED");
    return given ? static_cast<unsigned>(std::atoi(given)) : std::random_device()();
}

/// Runs, goes back to random scans and on from there; every image made again must be the one made first.
void expectSameAgain(Plant& plant, uint64_t scans, int times, unsigned seed) {
    plant.run(scans);
    std::mt19937 dice(seed);
    for (int i = 0; i < times; ++i) {
        const history::Position back = dice() % scans;
        const history::Position end = plant.session.history().statistics().end;
        ASSERT_TRUE(plant.session.resumeFrom(back));
        ASSERT_EQ(plant.session.controller().nextScan(), back + 1);
        plant.session.start();
        const uint64_t until = std::min<uint64_t>(scans, back + 1 + dice() % 400);
        plant.run(until);
        for (uint64_t scan = back + 1; scan < until; ++scan) {
            const std::vector<std::byte> first = plant.session.history().seek(scan);
            const std::vector<std::byte> again = plant.session.history().seek(end + scan - back - 1);
            ASSERT_FALSE(first.empty());
            ASSERT_EQ(first, again) << "scan " << scan << " after going back to " << back;
        }
    }
}

TEST(TimeTravel, ResumingFromAnyScanGivesTheImagesOfARunThatWasNeverInterrupted) {
    const unsigned seed = seedOfRun();
    SCOPED_TRACE("seed " + std::to_string(seed) + " (STEPWISE_SEED sets it)");
    Plant plant(seed, kPlant, "Main.input");
#ifdef PLC_THREAD_SANITIZED
    expectSameAgain(plant, 2000, 10, seed); // twenty times slower
#else
    expectSameAgain(plant, 10'000, 20, seed);
#endif
}

TEST(TimeTravel, HoldsForRandomProgramsTasksAndInputs) {
    const unsigned seed = seedOfRun();
    for (unsigned run = 0; run < repeats(12U); ++run) {
        const std::string program = plc::testing::RandomProgram(seed + run).text();
        SCOPED_TRACE("seed " + std::to_string(seed) + " run " + std::to_string(run) + " (STEPWISE_SEED sets it)\n" +
                     program);
        Plant plant(seed + run, program, "input");
#ifdef PLC_THREAD_SANITIZED
        expectSameAgain(plant, 500, 3, seed + run); // twenty times slower
#else
        expectSameAgain(plant, run % 6 == 0 ? 10'000 : 1500, 6, seed + run);
#endif
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(TimeTravel, GoingBackBeforeAnOnlineChangeBringsTheOldProgramBack) {
    Session session(build("PROGRAM Main VAR x : INT; END_VAR x := x + 1; END_PROGRAM"));
    if (!session.program()) return;
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 50; });
    const auto old = session.program();
    controller::OnlineChangeReport report;
    session.changeProgram(
        build("PROGRAM Main VAR fresh : REAL; x : INT; END_VAR x := x + 10; fresh := 1.5; END_PROGRAM"),
        [&](const auto& r) { report = r; });
    EXPECT_EQ(report.initialised, std::vector<std::string>{"Main.fresh"});
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 60; });
    EXPECT_EQ(session.controller().read("Main.x")->integer(), 150);
    // A series crosses the change by path; where the path did not exist there is a gap.
    const auto x = session.expression("Main.x");
    const auto fresh = session.expression("Main.fresh * 2.0");
    ASSERT_TRUE(x && fresh);
    const auto series = session.history().series(*x, session.recompile("Main.x"), 0, 60, 1000);
    ASSERT_EQ(series.size(), 60u);
    EXPECT_EQ(series[10].last, 11);
    EXPECT_EQ(series[55].last, 110);
    const auto gaps = session.history().series(*fresh, session.recompile("Main.fresh * 2.0"), 0, 60, 1000);
    EXPECT_EQ(gaps[49].count, 0u);
    EXPECT_EQ(gaps[50].last, 3.0);
    const auto when = session.expression("Main.x > 25");
    ASSERT_TRUE(when);
    EXPECT_EQ(session.history().find(*when, session.recompile("Main.x > 25"), 0, history::History::Direction::Forward),
              25u);
    ASSERT_TRUE(session.resumeFrom(20));
    EXPECT_EQ(session.program(), old);
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 30; });
    EXPECT_EQ(session.controller().read("Main.x")->integer(), 30);
    EXPECT_FALSE(session.controller().read("Main.fresh"));
}

TEST(OnlineChangeOfCompiledPrograms, KeepsBlocksReferencesAndArraysWhileRunning) {
    const std::string before = R"(
FUNCTION_BLOCK Motor VAR_INPUT on : BOOL; END_VAR VAR hours : DINT; t : TON; END_VAR
  IF on THEN hours := hours + 1; END_IF
  t(IN := on, PT := T#1s);
END_FUNCTION_BLOCK
PROGRAM Main VAR m : ARRAY[1..3] OF Motor; p : REF_TO Motor; q : REF_TO Motor; i : INT; END_VAR
  FOR i := 1 TO 3 DO m[i](on := TRUE); END_FOR
  IF p = NULL THEN p := REF(m[2]); END_IF
  q := REF(m[3]);
END_PROGRAM)";
    const std::string after = R"(
FUNCTION_BLOCK Motor VAR_INPUT on : BOOL; END_VAR VAR extra : ARRAY[0..9] OF LREAL; watch : CTU; hours : DINT; t : TON; END_VAR
  IF on THEN hours := hours + 1; END_IF
  t(IN := on, PT := T#1s);
END_FUNCTION_BLOCK
PROGRAM Main VAR first : STRING := 'new'; m : ARRAY[1..2] OF Motor; p : REF_TO Motor; q : REF_TO Motor; i : INT; seen : DINT; END_VAR
  FOR i := 1 TO 2 DO m[i](on := TRUE); END_FOR
  seen := p^.hours + 1000;
END_PROGRAM)";
    Session session(build(before));
    if (!session.program()) return;
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 20; });
    controller::OnlineChangeReport report;
    session.changeProgram(build(after), [&](const auto& r) { report = r; });
    ASSERT_EQ(report.refusal.english(), "");
    EXPECT_EQ(session.controller().read("Main.m[2].hours")->integer(), 20);
    EXPECT_EQ(session.controller().read("Main.m[2].t.ET")->integer(), 190'000'000);
    EXPECT_EQ(report.nulled, std::vector<std::string>{"Main.q"});
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 21; });
    ASSERT_FALSE(session.controller().fault()) << session.controller().fault()->message.english();
    EXPECT_EQ(session.controller().read("Main.seen")->integer(), 1021);
    EXPECT_EQ(session.controller().read("Main.m[1].hours")->integer(), 21);
}

TEST(Debugging, BreaksStepsAndShowsVariablesOfCompiledCode) {
    Session session(build("FUNCTION Twice : INT\nVAR_INPUT a : INT; END_VAR\nVAR t : INT; END_VAR\n  t := a;\n  Twice "
                          ":= t + a;\nEND_FUNCTION\n"
                          "FUNCTION_BLOCK B\nVAR_INPUT i : INT; END_VAR\nVAR_OUTPUT o : INT; END_VAR\n  o := "
                          "Twice(i);\n  o := o + 1;\nEND_FUNCTION_BLOCK\n"
                          "PROGRAM Main\nVAR n : INT; b1, b2 : B; END_VAR\n  n := n + 1;\n  b1(i := n);\n  b2(i := "
                          "b1.o);\nEND_PROGRAM\n"));
    if (!session.program()) return;
    session.startThread({Pace::Real, 1.0});
    Breakpoint inBlock;
    inBlock.file = FileId(0u);
    inBlock.line = 11; // o := o + 1
    inBlock.instance = "Main.b2";
    inBlock.condition = "i > 10";
    session.setBreakpoints({inBlock});
    ASSERT_TRUE(
        eventually([&] { return session.status().state == PlcState::Halted && session.haltFrames().size() == 2; }));
    EXPECT_EQ(session.haltProblem().english(), "");
    EXPECT_EQ(session.haltFrames()[0].function, "B");
    EXPECT_EQ(session.haltFrames()[0].instance, "Main.b2");
    EXPECT_EQ(session.haltFrames()[1].function, "Main");
    Snapshot now;
    session.latest(now);
    const auto o = session.expression("o", "Main.b2");
    const auto i = session.expression("Main.b2.i");
    ASSERT_TRUE(o && i);
    EXPECT_GT(*i->number(now.image), 10);
    EXPECT_EQ(o->number(now.image), *i->number(now.image) * 2);

    const auto place = [&]() -> std::string {
        const auto frames = session.haltFrames();
        if (frames.empty()) return "";
        const auto built = session.program();
        return frames[0].function + ":" +
               std::to_string(built->sources[frames[0].range.file].lineColumn(frames[0].range.begin).line);
    };
    const auto step = [&](Step kind, const std::string& expected) {
        session.step(kind);
        EXPECT_TRUE(eventually([&] { return place() == expected; })) << "at " << place() << ", expected " << expected;
    };
    session.setBreakpoints({});
    step(Step::Over, "Main:15"); // to the next scan
    step(Step::Over, "Main:16");
    step(Step::In, "B:10");
    step(Step::In, "Twice:4");
    session.step(Step::Over);
    ASSERT_TRUE(eventually([&] { return place() == "Twice:5"; }));
    const auto variables = session.frameVariables(0);
    std::map<std::string, Value> byName(variables.begin(), variables.end());
    ASSERT_TRUE(byName.count("a") && byName.count("t") && byName.count("Twice"));
    EXPECT_GT(byName["a"].integer(), 0);
    EXPECT_EQ(byName["a"], byName["t"]); // t := a
    step(Step::Out, "B:11");
    step(Step::Out, "Main:17");
    session.runTo(FileId(0u), 15);
    EXPECT_TRUE(eventually([&] { return place() == "Main:15"; })) << place();
    session.resume();
    ASSERT_TRUE(eventually([&] { return session.status().state == PlcState::Running; }));
}

TEST(CompiledSession, OptimisedCodeTakesOverWhileRunningWithTheSameResults) {
    Session quick(build(kPlant)), swapped(build(kPlant));
    if (!quick.program()) return;
    const auto until = [](uint64_t scan) {
        return [scan](const controller::Controller& c) { return c.nextScan() >= scan; };
    };
    quick.runHere(until(4000));
    swapped.runHere(until(1500));
    ASSERT_TRUE(driver::optimise(swapped.built()));
    swapped.runHere(until(4000));
    for (history::Position p = 0; p < 4000; p += 7)
        ASSERT_EQ(quick.history().seek(p), swapped.history().seek(p)) << "scan " << p;
}

TEST(CompiledSession, AnyThreadMayWriteForceReadAndChangeTheProgramWhileScansRun) {
    Session session(build(kPlant));
    if (!session.program()) return;
    session.startThread({Pace::Fastest, 1.0});
    std::atomic<bool> isDone{false};
    std::thread writer([&] {
        for (int i = 0; !isDone; ++i) {
            session.write("Main.input", Value{TypeTable::of(TypeKind::Int), int64_t(i % 100)});
            session.force("%QX0.1", Value{TypeTable::of(TypeKind::Bool), int64_t(i % 2)});
            if (i % 10 == 0) session.unforceAll();
            std::this_thread::sleep_for(200us); // a duration: leaves the scan thread room on two cores
        }
    });
    std::thread reader([&] {
        Snapshot now;
        while (!isDone) {
            session.latest(now);
            const auto level = session.expression("Main.level");
            if (level && now.program == session.program()) (void)level->number(now.image);
            const auto recorded = session.history().statistics();
            if (level && recorded.end > 100)
                (void)session.history().series(*level, session.recompile("Main.level"), recorded.end - 100,
                                               recorded.end, 10);
            (void)session.status();
        }
    });
    std::string changed = kPlant;
    changed.insert(changed.find("seed : DWORD := 16"), "more : LREAL; ");
    for (int i = 0; i < 4; ++i) {
        auto isChanged = std::make_shared<std::atomic<bool>>(false);
        session.changeProgram(build(i % 2 ? kPlant : changed),
                              [isChanged](const controller::OnlineChangeReport& report) {
                                  EXPECT_EQ(report.refusal.english(), "");
                                  *isChanged = true;
                              });
        EXPECT_TRUE(eventually([&] { return isChanged->load(); }));
        const uint64_t scans = session.status().scans;
        EXPECT_TRUE(eventually([&] { return session.status().scans > scans + 100; }));
    }
    isDone = true;
    writer.join();
    reader.join();
    const Status status = session.status();
    EXPECT_EQ(status.state, PlcState::Running) << (status.fault ? status.fault->message.english() : "");
}

#ifdef PLC_THREAD_SANITIZED
TEST(CompiledSession, ADeliberateRaceWithGeneratedCodeIsReported) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto race = [] {
        Session session(build(kPlant));
        const auto place = session.program()->layout.find("Main.n");
        const std::byte* live = session.controller().image().data();
        session.startThread({Pace::Fastest, 1.0});
        // What nobody may do: look into the live image from another thread.
        uint64_t sum = 0;
        for (int i = 0; i < 2000; ++i) {
            uint64_t n = 0;
            std::memcpy(&n, live + place->offset, sizeof n);
            sum += n;
            std::this_thread::sleep_for(50us); // a duration: the looks are spread over many scans
        }
        std::exit(sum == 1 ? 1 : 0); // the sanitizer turns 0 into its own exit code
    };
    EXPECT_EXIT(race(), ::testing::ExitedWithCode(66), "data race");
}
#endif

} // namespace
} // namespace plc::session
