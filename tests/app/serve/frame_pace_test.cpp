// Frames begin at even distances whatever they take.
#include "app/serve/frame_pace.h"

#include <gtest/gtest.h>

namespace plc::serve {
namespace {

/// Milliseconds from one beginning to the next, on average over 100 frames that take as long as `took` says.
template <class Took> double period(const Took& took) {
    FramePace pace;
    int64_t now = 1000;
    for (int i = 0; i < 100; ++i) {
        const int64_t begin = now;
        now += took(i);
        now += pace.waitAfter(begin, now);
    }
    return static_cast<double>(now - 1000) / 100;
}

TEST(FramePace, LeavesAQuarterOfTheTime) {
    EXPECT_NEAR(period([](int) { return 0; }), 33, 0.5);
    EXPECT_NEAR(period([](int) { return 12; }), 33, 0.5);
    EXPECT_NEAR(period([](int) { return 24; }), 33, 0.5) << "thirty a second as long as there is time for them";
    EXPECT_NEAR(period([](int) { return 60; }), 80, 1);
    EXPECT_NEAR(period([](int i) { return i % 2 == 0 ? 20 : 23; }), 33, 0.5) << "another time for each frame";
    EXPECT_NEAR(period([](int) { return 10'000; }), 10'001, 1) << "never at once";
}

TEST(FramePace, DoesNotMakeUpForAPause) {
    FramePace pace;
    EXPECT_EQ(pace.waitAfter(0, 5), 28);
    EXPECT_EQ(pace.waitAfter(33, 38), 28);
    EXPECT_EQ(pace.waitAfter(60'000, 60'005), 28);
    EXPECT_EQ(pace.waitAfter(60'033, 60'038), 28);
}

TEST(PeerTime, CountsNoSilenceOfTheServersOwn) {
    PeerTime time;
    EXPECT_EQ(time.at(5'000), 0);
    EXPECT_EQ(time.at(5'033), 33);
    EXPECT_EQ(time.at(5'533), 533) << "as slow as frames become by themselves";
    EXPECT_EQ(time.at(65'533), 1'533) << "a minute for other work";
    EXPECT_EQ(time.at(65'500), 1'533) << "a clock that was set back";
    EXPECT_EQ(time.at(65'533), 1'566);
}

} // namespace
} // namespace plc::serve
