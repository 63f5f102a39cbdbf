// From a recording into columns: every scan, every n-th, under a condition, over gaps, over branches; and the trigger.
#include "editor/trace/curves/trace_feed.h"
#include "editor/trace/setup/trigger.h"
#include "tests/editor/trace/fake_recording.h"

#include <gtest/gtest.h>

using namespace plc::trace;
namespace plot = plc::plot;
namespace history = plc::history;

namespace {

constexpr int64_t Ms = 1'000'000;

class FeedTest : public ::testing::Test {
protected:
    FeedTest() {
        recording.addReal("sine", [](double t) { return std::sin(t * 20); });
    }

    std::vector<plc::SignalSample> all(const std::string& expression) {
        std::vector<plc::SignalSample> out;
        const auto source = feed.source(expression);
        source->visit(INT64_MIN, INT64_MAX, [&](std::span<const plc::SignalSample> block) {
            out.insert(out.end(), block.begin(), block.end());
        });
        return out;
    }
    FakeRecording recording;
    TraceFeed feed{recording, std::make_shared<history::ColumnStore>()};
};

} // namespace

TEST_F(FeedTest, EveryScanArrivesExactly) {
    recording.run(30'000);
    feed.setExpressions({"sine"});
    feed.pumpAll();
    recording.run(5);
    EXPECT_TRUE(feed.pump(std::chrono::seconds(1)));
    const auto samples = all("sine");
    ASSERT_EQ(samples.size(), 30'005u);
    for (size_t i = 0; i < samples.size(); ++i) {
        ASSERT_EQ(samples[i].time, static_cast<int64_t>(i) * Ms);
        ASSERT_EQ(samples[i].value,
                  static_cast<double>(static_cast<float>(std::sin(static_cast<double>(samples[i].time) / 1e9 * 20))));
    }
}

TEST_F(FeedTest, AChannelAddedLaterHasItsPast) {
    recording.run(1000);
    feed.setExpressions({"sine"});
    feed.pumpAll();
    recording.addBool("late", [](double t) { return t >= 0.5; });
    feed.setExpressions({"sine", "late"});
    feed.pumpAll();
    EXPECT_EQ(all("late").size(), 1000u);
    EXPECT_EQ(all("sine").size(), 1000u);
    const size_t before = feed.store().bytes();
    feed.setExpressions({"sine"});
    EXPECT_LT(feed.store().bytes(), before);
}

TEST_F(FeedTest, BadExpressionsSayWhyAndMayBecomeGood) {
    recording.run(10);
    feed.setExpressions({"missing"});
    feed.pumpAll();
    EXPECT_FALSE(feed.source("missing"));
    EXPECT_EQ(feed.problem("missing").english(), "there is no variable 'missing'; check the name or declare it");
    recording.addReal("missing", [](double) { return 1; });
    feed.retryProblems();
    feed.pumpAll();
    EXPECT_EQ(all("missing").size(), 10u);
}

TEST_F(FeedTest, EveryNthScan) {
    recording.run(100);
    feed.setSettings({10, ""});
    feed.setExpressions({"sine"});
    feed.pumpAll();
    const auto samples = all("sine");
    ASSERT_EQ(samples.size(), 10u);
    EXPECT_EQ(samples[3].time, 30 * Ms);
}

TEST_F(FeedTest, TheConditionLeavesGapsWhereItDoesNotHold) {
    recording.addBool("wanted", [](double t) { return t < 0.020 || t >= 0.050; });
    recording.run(100);
    feed.setSettings({1, "wanted"});
    feed.setExpressions({"sine"});
    feed.pumpAll();
    EXPECT_EQ(all("sine").size(), 70u);
    const auto gaps = feed.source("sine")->gaps(0, 100 * Ms);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].from, 19 * Ms);
    EXPECT_EQ(gaps[0].to, 50 * Ms);
    EXPECT_EQ(gaps[0].reason, plc::SignalGap::Reason::NotRecorded);
}

TEST_F(FeedTest, WhereThePathDidNotExistIsAGap) {
    recording.channels["young"] = {
        ChannelType{}, [](const history::ScanStamp& s) { return s.scan >= 40 ? std::optional(1.0) : std::nullopt; }};
    recording.run(100);
    feed.setExpressions({"young"});
    feed.pumpAll();
    EXPECT_EQ(all("young").size(), 60u);
    const auto gaps = feed.source("young")->gaps(0, 100 * Ms);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].reason, plc::SignalGap::Reason::NoPath);
    EXPECT_EQ(gaps[0].from, 0);
    EXPECT_EQ(gaps[0].to, 40 * Ms);
}

TEST_F(FeedTest, WhatLeftTheHistoryBeforeItWasReadIsAGap) {
    recording.run(100);
    recording.oldest = 30;
    feed.setExpressions({"sine"});
    feed.pumpAll();
    EXPECT_EQ(all("sine").front().time, 30 * Ms);
    auto gaps = feed.source("sine")->gaps(0, 100 * Ms);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].reason, plc::SignalGap::Reason::Evicted);
    recording.run(100);
    recording.oldest = 150; // the window slept too long
    feed.pumpAll();
    gaps = feed.source("sine")->gaps(90 * Ms, 200 * Ms);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].from, 99 * Ms);
    EXPECT_EQ(gaps[0].to, 150 * Ms);
    EXPECT_EQ(all("sine").size(), 70u + 50u) << "what the columns have outlives the images";
}

TEST_F(FeedTest, WhatLeavesTheHistoryWhileItIsReadIsAGap) {
    recording.run(100);
    feed.setExpressions({"sine"});
    feed.pumpAll();
    recording.run(100);
    recording.whileRead = [&] { recording.oldest = 150; }; // after the feed has asked what is there
    feed.pumpAll();
    auto gaps = feed.source("sine")->gaps(90 * Ms, 200 * Ms);
    ASSERT_EQ(gaps.size(), 1u) << "the line went on over scans that nobody has";
    EXPECT_EQ(gaps[0], (plc::SignalGap{99 * Ms, 150 * Ms, plc::SignalGap::Reason::Evicted}));
    recording.run(100);
    recording.whileRead = [&] { recording.oldest = 300; }; // all of it
    feed.pumpAll();
    recording.whileRead = nullptr;
    recording.run(50);
    feed.pumpAll();
    gaps = feed.source("sine")->gaps(190 * Ms, 400 * Ms);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0], (plc::SignalGap{199 * Ms, 300 * Ms, plc::SignalGap::Reason::Evicted}));
}

TEST_F(FeedTest, GoingBackReplacesTheFuture) {
    recording.channels["branch"] = {ChannelType{},
                                    [](const history::ScanStamp& s) { return s.position >= 100 ? 2.0 : 1.0; }};
    recording.run(100);
    feed.setExpressions({"branch"});
    feed.pumpAll();
    recording.goBackTo(39);
    recording.run(20);
    feed.pumpAll();
    const auto samples = all("branch");
    ASSERT_EQ(samples.size(), 60u);
    for (size_t i = 0; i < samples.size(); ++i) {
        EXPECT_EQ(samples[i].time, static_cast<int64_t>(i) * Ms);
        EXPECT_EQ(samples[i].value, i < 40 ? 1 : 2) << i;
    }
    // A channel added now reads the same story.
    recording.channels["second"] = recording.channels["branch"];
    feed.setExpressions({"branch", "second"});
    feed.pumpAll();
    EXPECT_EQ(all("second"), samples);
    // And back again to before the branch.
    recording.goBackTo(10);
    recording.run(5);
    feed.pumpAll();
    EXPECT_EQ(all("branch").size(), 16u);
    EXPECT_EQ(all("second"), all("branch"));
}

TEST(NewestChain, LeavesAbandonedFuturesOut) {
    using R = std::vector<PositionRange>;
    EXPECT_EQ(history::chainTo({}, 100), (R{{0, 100}}));
    EXPECT_EQ(history::chainTo({{0, 0}, {100, 39}}, 120), (R{{0, 40}, {100, 120}}));
    EXPECT_EQ(history::chainTo({{0, 0}, {100, 39}, {120, 110}}, 130), (R{{0, 40}, {100, 111}, {120, 130}}));
    EXPECT_EQ(history::chainTo({{0, 0}, {100, 39}, {120, 10}}, 130), (R{{0, 11}, {120, 130}}));
    const auto chain = history::chainTo({{0, 0}, {100, 39}}, 120);
    EXPECT_EQ(nextOnChain(chain, 38), 39u);
    EXPECT_EQ(nextOnChain(chain, 39), 100u);
    EXPECT_EQ(nextOnChain(chain, 119), std::nullopt);
    EXPECT_EQ(previousOnChain(chain, 100), 39u);
    EXPECT_EQ(previousOnChain(chain, 0), std::nullopt);
}

namespace {

/// Feeds "_" for false, "#" for true, "?" for no value, one a millisecond; gives back the times of complete shots.
std::vector<int64_t> shots(const TriggerSetup& setup, const char* signal) {
    TriggerMachine machine;
    machine.setSetup(setup);
    std::vector<int64_t> out;
    int64_t time = 0;
    for (const char* c = signal; *c; ++c, time += Ms) {
        const uint64_t before = machine.shots();
        machine.feed(time, *c == '?' ? std::nullopt : std::optional(*c == '#'));
        if (machine.shots() > before) out.push_back(*machine.completeAt() / Ms);
    }
    return out;
}

TriggerSetup trigger(TriggerEdge edge, TriggerMode mode, int64_t after) { return {"x", edge, mode, 0, after * Ms, {}}; }

} // namespace

TEST(TriggerMachine, FiresAtItsEdges) {
    using V = std::vector<int64_t>;
    struct Row {
        TriggerEdge edge;
        TriggerMode mode;
        int64_t after;
        const char* signal;
        V shots;
    };
    for (const Row& row : {Row{TriggerEdge::Rising, TriggerMode::Single, 2, "__##__##____", {2}},
                           Row{TriggerEdge::Rising, TriggerMode::Repeated, 2, "__##__##____", {2, 6}},
                           Row{TriggerEdge::Falling, TriggerMode::Repeated, 0, "__##__##__", {4, 8}},
                           Row{TriggerEdge::Both, TriggerMode::Repeated, 2, "_#_#_____", {1, 3}},
                           Row{TriggerEdge::Level, TriggerMode::Repeated, 3, "__#########", {2, 5}},
                           Row{TriggerEdge::Rising, TriggerMode::Single, 1, "####__", {}},
                           Row{TriggerEdge::Level, TriggerMode::Single, 1, "####__", {0}},
                           Row{TriggerEdge::Rising, TriggerMode::Single, 1, "_?##__", {}},
                           Row{TriggerEdge::Rising, TriggerMode::Off, 1, "_##__", {}},
                           Row{TriggerEdge::Rising, TriggerMode::Single, 50, "_#___", {}}})
        EXPECT_EQ(shots(trigger(row.edge, row.mode, row.after), row.signal), row.shots)
            << row.signal << " edge " << static_cast<int>(row.edge);
}

TEST(TriggerMachine, ShowsItsStateAndCanBeArmedAgain) {
    TriggerMachine machine;
    machine.setSetup(trigger(TriggerEdge::Rising, TriggerMode::Single, 5));
    EXPECT_EQ(machine.state(), TriggerState::Armed);
    machine.feed(0, false);
    machine.feed(Ms, true);
    EXPECT_EQ(machine.state(), TriggerState::Collecting);
    EXPECT_EQ(machine.firedAt(), Ms);
    EXPECT_FALSE(machine.completeAt());
    machine.advanceTo(6 * Ms);
    EXPECT_EQ(machine.state(), TriggerState::Done);
    EXPECT_EQ(machine.completeAt(), Ms);
    machine.arm();
    machine.feed(7 * Ms, true);
    EXPECT_EQ(machine.state(), TriggerState::Armed) << "being true already is no edge";
    machine.feed(8 * Ms, false);
    machine.feed(9 * Ms, true);
    EXPECT_EQ(machine.firedAt(), 9 * Ms);
    machine.disarm();
    EXPECT_EQ(machine.state(), TriggerState::Off);
}
