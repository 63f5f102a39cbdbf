#include "runtime/base/mpsc_queue.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace plc {
namespace {

TEST(MpscQueue, GivesValuesInTheOrderInWhichTheyWerePushed) {
    MpscQueue<int> queue;
    EXPECT_TRUE(queue.isEmpty());
    EXPECT_EQ(queue.pop(), std::nullopt);
    for (const int value : {3, 1, 2}) queue.push(value);
    EXPECT_FALSE(queue.isEmpty());
    for (const int value : {3, 1, 2}) EXPECT_EQ(queue.pop(), value);
    EXPECT_EQ(queue.pop(), std::nullopt);
    queue.push(4); // after it ran empty
    EXPECT_EQ(queue.pop(), 4);
}

TEST(MpscQueue, WhoPopsUpToWhatWasPushedEndsWhileMoreComes) {
    MpscQueue<int> queue;
    for (const int value : {3, 1}) queue.push(value);
    const uint64_t end = queue.pushed();
    std::vector<int> taken;
    while (const std::optional<int> value = queue.popBefore(end)) {
        taken.push_back(*value);
        queue.push(*value + 10); // another each time
    }
    EXPECT_EQ(taken, (std::vector<int>{3, 1}));
    EXPECT_EQ(queue.popBefore(end + 1), 13);
    EXPECT_EQ(queue.popBefore(end), std::nullopt) << "behind the end";
    EXPECT_EQ(queue.pop(), 11);
    EXPECT_EQ(queue.popBefore(queue.pushed()), std::nullopt);
}

TEST(MpscQueue, TakesValuesThatCanOnlyBeMoved) {
    MpscQueue<std::unique_ptr<std::string>> queue;
    queue.push(std::make_unique<std::string>("write"));
    const auto value = queue.pop();
    ASSERT_TRUE(value && *value);
    EXPECT_EQ(**value, "write");
}

TEST(MpscQueue, LetsGoOfAValueOnceItIsPoppedAndOfTheRestWhenItEnds) {
    const auto counted = std::make_shared<int>(0);
    {
        MpscQueue<std::shared_ptr<int>> queue;
        for (int i = 0; i < 3; ++i) queue.push(counted);
        EXPECT_EQ(counted.use_count(), 4);
        queue.pop(); // the popped value itself ends here
        EXPECT_EQ(counted.use_count(), 3);
    }
    EXPECT_EQ(counted.use_count(), 1);
}

TEST(MpscQueue, KeepsEachProducersOrderAndLosesNothing) {
    constexpr int kProducers = 4, kEach = 20'000;
    MpscQueue<std::pair<int, int>> queue; // producer, number
    std::vector<std::thread> producers;
    for (int producer = 0; producer < kProducers; ++producer)
        producers.emplace_back([&queue, producer] {
            for (int i = 0; i < kEach; ++i) queue.push({producer, i});
        });
    std::vector<int> next(kProducers, 0);
    for (int taken = 0; taken < kProducers * kEach;) {
        const auto value = queue.pop();
        if (!value) {
            std::this_thread::yield();
            continue;
        }
        ASSERT_EQ(value->second, next[static_cast<size_t>(value->first)]++);
        ++taken;
    }
    for (std::thread& producer : producers) producer.join();
    EXPECT_TRUE(queue.isEmpty());
}

} // namespace
} // namespace plc
