#include "runtime/base/published.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace plc {
namespace {

TEST(Published, HasNothingToReadBeforeTheFirstPublication) {
    Published<int> published;
    bool wasRead = false;
    EXPECT_FALSE(published.read([&](int) { wasRead = true; }));
    *published.begin() = 7; // begun, not published
    EXPECT_FALSE(published.read([&](int) { wasRead = true; }));
    EXPECT_FALSE(wasRead);
}

TEST(Published, GivesTheNewestValueAsOftenAsItIsAsked) {
    Published<int> published;
    for (const int value : {1, 2, 3}) {
        int* slot = published.begin();
        ASSERT_NE(slot, nullptr);
        *slot = value;
        published.publish();
        for (int i = 0; i < 2; ++i) {
            int seen = 0;
            EXPECT_TRUE(published.read([&](int v) { seen = v; }));
            EXPECT_EQ(seen, value);
        }
    }
}

TEST(Published, AValueThatIsBeingReadStaysAsItIs) {
    Published<int> published;
    *published.begin() = 1;
    published.publish();
    published.read([&](const int& held) {
        for (int value = 2; value < 100; ++value) { // more often than there are spare values
            int* slot = published.begin();
            ASSERT_NE(slot, nullptr);
            ASSERT_NE(slot, &held);
            *slot = value;
            published.publish();
            EXPECT_EQ(held, 1);
        }
    });
}

/// Holds one value more for each call, then looks whether the writer still gets one.
void holdAll(Published<int>& published, int depth) {
    int* slot = published.begin();
    if (depth == 6) { // every spare value is held by a reader
        EXPECT_EQ(slot, nullptr);
        return;
    }
    ASSERT_NE(slot, nullptr);
    *slot = depth;
    published.publish();
    published.read([&](const int& held) {
        holdAll(published, depth + 1);
        EXPECT_EQ(held, depth);
    });
}

TEST(Published, WriterLeavesAPublicationOutRatherThanWait) {
    Published<int> published;
    holdAll(published, 0);
    EXPECT_NE(published.begin(), nullptr); // the readers have let go
}

TEST(Published, ReadersNeverSeeAHalfWrittenOrAnOlderValue) {
    struct Both {
        uint64_t a = 0, b = 0;
    };
    constexpr uint64_t kValues = 50'000;
    Published<Both> published;
    std::atomic<bool> ends{false};
    std::vector<std::thread> readers;
    for (int i = 0; i < 3; ++i)
        readers.emplace_back([&] {
            uint64_t before = 0;
            while (!ends.load()) {
                Both seen;
                if (!published.read([&](const Both& both) { seen = both; })) continue;
                ASSERT_EQ(seen.a, seen.b);
                ASSERT_GE(seen.a, before);
                before = seen.a;
            }
        });
    for (uint64_t value = 1; value <= kValues; ++value) {
        Both* slot = published.begin();
        if (!slot) continue;
        slot->a = value;
        slot->b = value;
        published.publish();
    }
    ends.store(true);
    for (std::thread& reader : readers) reader.join();
}

} // namespace
} // namespace plc
