#include "projects/session/session.h"
#include "tests/runtime/hand_made_program.h"
#include "tests/support/eventually.h"
#include "tests/support/patience.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace plc::session {
namespace {

using namespace std::chrono_literals;
using image::Area;
using plc::testing::at;
using plc::testing::HandMade;
using plc::testing::RuntimeContext;
using plc::testing::valueAt;
using types::TypeKind;
using types::TypeTable;
using types::Value;
using PlcState = controller::State;

// Globals: count (DINT) counts runs of the fast task, x (DINT) what users write, log (16 DINT) the values of x that the
// slow task saw, n how many.
constexpr uint32_t kCount = 112, kX = 116, kN = 120, kSlow = 124, kLog = 128, kButton = 192, kSeen = 193;

void fast(RuntimeContext* c, std::byte* image, uint32_t instance) {
    if (c->siteFlags && c->siteFlags[1]) controller::runtimeSymbols().atSite(c, 1, instance, 0);
    ++at<int32_t>(image, kCount);
    auto& n = at<int32_t>(image, kN);
    if (n < 16 && (n == 0 || at<int32_t>(image, kLog + 4u * uint32_t(n - 1)) != at<int32_t>(image, kX)))
        at<int32_t>(image, kLog + 4u * uint32_t(n++)) = at<int32_t>(image, kX);
}
void slow(RuntimeContext*, std::byte* image, uint32_t) {
    ++at<int32_t>(image, kSlow);
    if (image[kButton] != std::byte{}) image[kSeen] = std::byte{1};
}

/// `bulk`: how many more variables there are, which take time to copy.
driver::Built program(std::chrono::nanoseconds interval = 1ms, std::chrono::nanoseconds slowInterval = 10ms,
                      int bulk = 0) {
    HandMade made;
    const FileId file = made.program().sources.add("main.st", "count := count + 1;\n");
    made.add("count", TypeKind::Dint).retain = true;
    made.add("x", TypeKind::Dint);
    made.add("n", TypeKind::Dint);
    made.add("slow", TypeKind::Dint);
    made.add("log", made.types().array({{0, 15}}, TypeTable::of(TypeKind::Dint)));
    made.add("button", TypeKind::Bool);
    made.add("seen", TypeKind::Bool);
    if (bulk > 0) made.add("bulk", made.types().array({{1, bulk}}, TypeTable::of(TypeKind::Dint)));
    made.locate("lamp", TypeKind::Bool, "%QX0.0", 80, 0, Area::Output);
    const uint32_t function = made.function("Fast", &fast);
    made.site(function, {file, 0, 19});
    made.task("fast", function, interval);
    made.task("slow", made.function("Slow", &slow), slowInterval, 1);
    driver::Built built;
    built.program = made.finish();
    built.program->optimised.store(built.program->quick.get()); // nothing to optimise in C++ functions
    auto input = std::make_shared<driver::BuildInput>();
    input->files.push_back({"main.st", "count := count + 1;\n"});
    built.input = input;
    return built;
}
Value dint(int64_t number) { return Value{TypeTable::of(TypeKind::Dint), number}; }
Value boolean(bool value) { return Value{TypeTable::of(TypeKind::Bool), int64_t(value)}; }

template <class T> T shown(const Session& session, uint32_t offset) {
    const std::vector<std::byte> image = session.snapshot();
    return image.empty() ? T{} : valueAt<T>(image, offset);
}
RunMode real() { return {Pace::Real, 1.0}; }
RunMode fastest() { return {Pace::Fastest, 1.0}; }

Breakpoint atLineOne() {
    Breakpoint breakpoint;
    breakpoint.file = FileId(0u);
    breakpoint.line = 1;
    return breakpoint;
}

TEST(Session, SteppedByTheCallerItRunsUntilItIsToldToStop) {
    Session session(program());
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 100; });
    EXPECT_EQ(session.status().scans, 100u);
    EXPECT_EQ(session.status().time, 99ms);
    EXPECT_EQ(session.history().statistics().end, 100u);
    EXPECT_EQ(shown<int32_t>(session, kCount), 100);
    session.write("x", dint(5));
    EXPECT_EQ(session.controller().read("x")->integer(), 5);
    session.write("y", dint(5));
    const std::vector<Error> refused = session.takeRefusals();
    ASSERT_EQ(refused.size(), 1u);
    EXPECT_EQ(refused[0].english(), "y: there is no variable 'y'; check the name or declare it");
}

TEST(Session, TheScanThreadRunsInRealTimeAndStops) {
    Session session(program());
    const auto begin = std::chrono::steady_clock::now();
    session.startThread(real());
    ASSERT_TRUE(eventually([&] { return session.status().scans >= 200; }));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    EXPECT_GT(seconds, 0.19); // never faster than real time
    EXPECT_EQ(session.status().state, PlcState::Running);
    session.pause();
    ASSERT_TRUE(eventually([&] { return session.status().state == PlcState::Paused; }));
    const uint64_t scans = session.status().scans;
    session.singleScan();
    ASSERT_TRUE(eventually([&] { return session.status().scans == scans + 1; }));
    session.singleScan();
    ASSERT_TRUE(eventually([&] { return session.status().scans >= scans + 2; }));
    EXPECT_EQ(session.status().scans, scans + 2) << "one for each order, and none between them";
    session.start();
    ASSERT_TRUE(eventually([&] { return session.status().scans > scans + 6; }));
    session.stop();
    ASSERT_TRUE(eventually([&] { return session.status().state == PlcState::Stopped; }));
    session.reset(controller::ResetKind::Origin);
    ASSERT_TRUE(eventually([&] { return shown<int32_t>(session, kCount) == 0; }));
}

TEST(Session, AFactorAndVirtualTimeRunFasterThanTheClock) {
    Session session(program());
    session.startThread({Pace::Factor, 20.0});
    ASSERT_TRUE(eventually([&] { return session.status().time >= 2s; }));
    session.setMode(fastest());
    ASSERT_TRUE(eventually([&] { return session.status().time >= 300s; }));
    ASSERT_TRUE(eventually([&] { return session.status().load > 0.1; }));
}

TEST(Session, WritesToOneVariableKeepTheirOrderOnePerScan) {
    Session session(program());
    session.startThread(real());
    for (int i = 1; i <= 10; ++i) session.write("x", dint(i));
    ASSERT_TRUE(eventually([&] { return shown<int32_t>(session, kX) == 10 && shown<int32_t>(session, kN) >= 10; }));
    const uint64_t written = session.status().scans;
    ASSERT_TRUE(eventually([&] { return session.status().scans > written + 5; })); // what came twice would be seen
    const std::vector<std::byte> image = session.snapshot();
    std::vector<int32_t> seen;
    for (int i = 0; i < valueAt<int32_t>(image, kN); ++i)
        seen.push_back(valueAt<int32_t>(image, kLog + 4u * uint32_t(i)));
    if (!seen.empty() && seen.front() == 0) seen.erase(seen.begin());
    EXPECT_EQ(seen, (std::vector<int32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
}

TEST(Session, AButtonsReleaseWaitsUntilEveryCyclicTaskHasRunWithThePress) {
    Session session(program(1ms, 50ms));
    session.startThread(real());
    ASSERT_TRUE(eventually([&] { return shown<int32_t>(session, kSlow) >= 1; }));
    session.press("button", boolean(true), boolean(false)); // shorter than the slow task's interval
    session.release("button");
    session.write("button", boolean(false));
    ASSERT_TRUE(eventually([&] { return shown<uint8_t>(session, kSeen) == 1; }));
    ASSERT_TRUE(eventually([&] { return shown<uint8_t>(session, kButton) == 0; }));
}

TEST(Session, ForcesRefusalsAndEventsCanBeSeen) {
    Session session(program());
    session.startThread(real());
    session.force("x", dint(77));
    ASSERT_TRUE(eventually([&] { return session.forces().size() == 1; }));
    session.write("x", dint(3));
    std::vector<std::string> refusals;
    ASSERT_TRUE(eventually([&] {
        for (const Error& each : session.takeRefusals()) refusals.push_back(each.english());
        return !refusals.empty();
    }));
    EXPECT_EQ(refusals.front(), "x: x is forced; release the force before writing");
    session.unforceAll();
    ASSERT_TRUE(eventually([&] { return session.forces().empty(); }));
    const auto asked = [](const controller::Event& event) {
        return event.kind != controller::EventKind::SkippedScans; // of a busy machine
    };
    std::vector<controller::Event> events;
    ASSERT_TRUE(eventually([&] {
        events = session.eventsSince(0);
        return std::count_if(events.begin(), events.end(), asked) >= 3;
    }));
    EXPECT_EQ(session.eventsSince(events.size() - 1).at(0).kind, events.back().kind);
    std::erase_if(events, std::not_fn(asked));
    EXPECT_EQ(events[0].kind, controller::EventKind::Started);
    EXPECT_EQ(events[1].kind, controller::EventKind::Force);
    EXPECT_EQ(events[1].text.english(), "x := 77");
    EXPECT_EQ(events[2].kind, controller::EventKind::Release);
}

TEST(Session, HaltedAtABreakpointItServesWritesAndGoesOnOrLeavesTheScan) {
    Session session(program());
    session.startThread(real());
    const Breakpoint breakpoint = atLineOne();
    session.setBreakpoints({breakpoint});
    ASSERT_TRUE(
        eventually([&] { return session.status().state == PlcState::Halted && !session.haltFrames().empty(); }));
    EXPECT_EQ(session.haltFrames().front().function, "Fast");
    const int32_t count = shown<int32_t>(session, kCount);
    session.write("x", dint(5));
    ASSERT_TRUE(eventually([&] { return shown<int32_t>(session, kX) == 5; }));
    session.resume(); // halts again in the next scan
    ASSERT_TRUE(eventually([&] { return shown<int32_t>(session, kCount) == count + 1; }));
    bool isChanged = false;
    std::atomic<bool> isDone{false};
    session.changeProgram(program(), [&](const controller::OnlineChangeReport& report) {
        isChanged = report.refusal.isEmpty();
        isDone = true;
    });
    session.write("x", dint(6)); // carried out while it is halted, after the change was asked for
    ASSERT_TRUE(eventually([&] { return shown<int32_t>(session, kX) == 6; }));
    EXPECT_FALSE(isDone); // waits for the end of the scan
    session.setBreakpoints({});
    session.resume();
    ASSERT_TRUE(eventually([&] { return isDone.load(); }));
    EXPECT_TRUE(isChanged);
    session.setBreakpoints({breakpoint});
    ASSERT_TRUE(eventually([&] { return session.status().state == PlcState::Halted; }));
    session.stop();
    ASSERT_TRUE(eventually([&] { return session.status().state == PlcState::Stopped; }));
    session.start();
    ASSERT_TRUE(eventually([&] { return session.status().state == PlcState::Halted; }));
    // closing abandons the scan
}

/// Looks without a pause, as somebody does who happens to look at the worst moment.
bool becomes(const Session& session, PlcState state) {
    const auto latest = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatience);
    while (session.status().state != state)
        if (std::chrono::steady_clock::now() > latest) return false;
    return true;
}

TEST(Session, WhoSeesAStateReadsTheValuesThatBelongToIt) {
    Session session(program(1ms, 10ms, 250'000));
    session.startThread(real());
    ASSERT_TRUE(eventually([&] { return session.status().scans > 0; }));
    Snapshot now;
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE(round);
        session.setBreakpoints({atLineOne()});
        ASSERT_TRUE(becomes(session, PlcState::Halted));
        session.latest(now);
        ASSERT_TRUE(now.isHalted) << "the image of a scan before";
        ASSERT_EQ(now.scan + 1, session.status().scans);
        ASSERT_EQ(session.haltFrames().size(), 1u);
        session.setBreakpoints({});
        session.resume();
        ASSERT_TRUE(becomes(session, PlcState::Running));
        const uint64_t scans = session.status().scans;
        ASSERT_TRUE(eventually([&] { return session.status().scans > scans + 2; }));
        session.pause();
        ASSERT_TRUE(becomes(session, PlcState::Paused));
        session.latest(now);
        ASSERT_FALSE(now.isHalted);
        ASSERT_EQ(now.scan + 1, session.status().scans);
        ASSERT_EQ(valueAt<int32_t>(now.image, kCount), static_cast<int32_t>(session.status().scans));
        session.start();
        ASSERT_TRUE(becomes(session, PlcState::Running));
    }
}

TEST(Session, TheTimeAtABreakpointIsNotTheScans) {
    using namespace std::chrono_literals;
    Session session(program());
    session.startThread(real());
    const Breakpoint breakpoint = atLineOne();
    session.setBreakpoints({breakpoint});
    ASSERT_TRUE(eventually([&] { return session.status().state == PlcState::Halted; }));
    constexpr auto stood = 500ms;
    std::this_thread::sleep_for(stood); // a duration: somebody looks at the values
    session.setBreakpoints({});
    session.resume();
    ASSERT_TRUE(eventually([&] { return session.scanTimes().execution.count() > 3; }));
    EXPECT_LT(std::chrono::nanoseconds(session.scanTimes().execution.mostNs()), stood);
    EXPECT_LT(session.status().load, 0.9);
}

TEST(Session, GoesBackToAScanAndOnFromThere) {
    Session session(program());
    session.startThread(fastest());
    ASSERT_TRUE(eventually([&] { return session.status().scans > 5000; }));
    session.pause();
    ASSERT_TRUE(eventually([&] { return session.status().state == PlcState::Paused; }));
    const history::Position last = session.history().statistics().end;
    ASSERT_TRUE(session.resumeFrom(1234));
    EXPECT_EQ(session.status().scans, 1235u);
    EXPECT_EQ(shown<int32_t>(session, kCount), 1235);
    session.singleScan();
    ASSERT_TRUE(eventually([&] { return session.history().statistics().end == last + 1; }));
    ASSERT_EQ(session.history().branches().size(), 1u);
    EXPECT_EQ(session.history().branches()[0].parent, 1234u);
    const std::vector<std::byte> again = session.history().seek(last);
    const std::vector<std::byte> before = session.history().seek(1235);
    EXPECT_EQ(again, before);
    EXPECT_FALSE(session.resumeFrom(last + 1000));
}

TEST(Session, RetainedValuesComeBackFromTheFile) {
    const std::string file =
        (std::filesystem::temp_directory_path() / ("retain_" + std::to_string(::getpid()))).string();
    std::filesystem::remove(file);
    Settings settings;
    settings.retainFile = file;
    {
        Session session(program(), settings);
        session.startThread(fastest());
        ASSERT_TRUE(eventually([&] { return session.status().scans > 100; }));
        session.stop();
        ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file); })); // at the stop, not only at the end
    }
    int64_t saved = 0;
    {
        Session session(program(), settings);
        saved = session.controller().read("count")->integer();
        EXPECT_GT(saved, 100);
        EXPECT_EQ(session.controller().read("x")->integer(), 0);
        EXPECT_EQ(session.status().retainProblem.english(), "");
    }
    std::ofstream(file, std::ios::app) << "x";
    std::ofstream(file) << "nonsense";
    {
        Session session(program(), settings);
        EXPECT_EQ(session.controller().read("count")->integer(), 0);
        EXPECT_NE(session.status().retainProblem.english(), "");
    }
    std::filesystem::remove(file);
}

TEST(Session, ScansGoOnWhileTheNextCommandAlwaysWaits) {
    std::atomic<bool> isDone{false};
    Session* running = nullptr;
    const std::function<void(const controller::OnlineChangeReport&)> again = [&](const auto&) {
        if (!isDone)
            running->changeProgram(program(), again); // posted before the last one is done: there is always one
    };
    Session session(program());
    running = &session;
    for (const bool isFast : {true, false}) {
        const uint64_t before = session.status().scans;
        isDone = false;
        session.startThread(isFast ? fastest() : real());
        session.changeProgram(program(), again);
        EXPECT_TRUE(eventually([&] { return session.status().scans > before + 100; })) << isFast;
        isDone = true;
        session.pause();
        EXPECT_TRUE(eventually([&] { return session.status().state == controller::State::Paused; }));
    }
}

TEST(Session, AnyThreadMayPostAndReadWhileScansRun) {
    Session session(program());
    session.startThread(fastest());
    std::atomic<bool> isDone{false};
    std::atomic<int> rounds{0};
    const auto use = [&](int number) {
        for (int i = 0; !isDone; ++i, ++rounds) {
            session.write("x", dint(i));
            if (i % 5 == number) session.force("lamp", boolean(i % 2));
            if (i % 7 == number) session.unforceAll();
            Snapshot now;
            session.latest(now);
            if (!now.image.empty()) {
                ASSERT_EQ(now.image.size(), now.program->layout.imageSize);
            }
            (void)session.status();
            (void)session.forces();
            (void)session.taskStatistics();
            (void)session.eventsSince(0);
            (void)session.takeRefusals();
            const history::Statistics recorded = session.history().statistics();
            if (recorded.end > 0) (void)session.history().seek(recorded.end - 1);
            if (number == 1 && i % 20 == 0) session.changeProgram(program(), {});
            std::this_thread::sleep_for(100us); // a duration: leaves the scan thread room on two cores
        }
    };
    std::thread a(use, 1), b(use, 2);
    EXPECT_TRUE(eventually([&] { return rounds > 1500 && session.status().scans > 100; }));
    isDone = true;
    a.join();
    b.join();
    EXPECT_GT(session.status().scans, 100u);
}

} // namespace
} // namespace plc::session
