// What was recorded before the controller went back, as a recording of its own.
#include "editor/trace/recording/branch_recording.h"

#include "tests/editor/trace/fake_recording.h"

#include <gtest/gtest.h>

namespace plc::trace {
namespace {

class BranchRecordingTest : public ::testing::Test {
protected:
    void SetUp() override {
        recording.addReal("level", [](double time) { return time * 1000; });
        recording.run(100);
    }
    FakeRecording recording;
};

TEST_F(BranchRecordingTest, HoldsWhatWasThereBeforeAndNothingOfTheBranch) {
    recording.goBackTo(39);
    recording.run(50);
    const BranchRecording before(recording, 100);
    EXPECT_EQ(before.extent(), (std::pair<Position, Position>(0, 100)));
    EXPECT_EQ(before.samples("level", 0, 150).size(), 100u);
    EXPECT_FALSE(before.stamp(100));
    ASSERT_TRUE(before.stamp(99));
    EXPECT_EQ(before.stamp(99)->scan, 99u);
    EXPECT_FALSE(before.findChange("level", 99, history::History::Direction::Forward)) << "behind it lies the branch";
}

TEST_F(BranchRecordingTest, FindsATimeAlongItsOwnScans) {
    recording.goBackTo(39);
    recording.run(80); // the branch has been further than what was before
    const BranchRecording before(recording, 100);
    EXPECT_EQ(before.positionAt(70 * recording.period), 70u) << "not the scan of the branch with that time";
    EXPECT_EQ(recording.positionAt(70 * recording.period), 130u);
    EXPECT_EQ(before.positionAt(110 * recording.period), 99u) << "the last there was";
    EXPECT_FALSE(before.positionAt(-1));
}

TEST_F(BranchRecordingTest, ABranchThatWasGoneBackFromKeepsItsOwnPast) {
    recording.goBackTo(39);
    recording.run(50); // 100 … 149: the scans 40 … 89 again
    recording.goBackTo(120);
    recording.run(10);
    const BranchRecording before(recording, 150);
    ASSERT_EQ(before.branches().size(), recording.branches().size() - 1) << "the newest is not its own";
    EXPECT_EQ(before.positionAt(20 * recording.period), 20u) << "before the first fork";
    EXPECT_EQ(before.positionAt(60 * recording.period), 120u) << "behind it on the branch";
    EXPECT_EQ(before.positionAt(89 * recording.period), 149u);
}

TEST_F(BranchRecordingTest, MarksBehindItsEndAreNotItsOwn) {
    recording.markList = {{}, {}};
    recording.markList[0].position = 10;
    recording.markList[1].position = 120;
    const BranchRecording before(recording, 100);
    ASSERT_EQ(before.marks().size(), 1u);
    EXPECT_EQ(before.marks()[0].position, 10u);
}

} // namespace
} // namespace plc::trace
