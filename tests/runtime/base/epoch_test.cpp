#include "runtime/base/epoch.h"

#include <gtest/gtest.h>

#include <optional>
#include <thread>
#include <vector>

namespace plc {
namespace {

TEST(Epochs, AdvanceFreelyWithoutReaders) {
    Epochs epochs;
    for (uint64_t epoch = 0; epoch < 5; ++epoch) {
        EXPECT_EQ(epochs.current(), epoch);
        epochs.tryAdvance();
    }
}

TEST(Epochs, AReaderHoldsBackTheEpochAfterTheNext) {
    Epochs epochs;
    std::optional<Epochs::Pin> pin(epochs.pin());
    epochs.tryAdvance(); // new readers pin the next
    EXPECT_EQ(epochs.current(), 1u);
    for (int i = 0; i < 3; ++i) epochs.tryAdvance();
    EXPECT_EQ(epochs.current(), 1u) << "what was taken out in epoch 0 must not be freed while it is read";
    pin.reset();
    epochs.tryAdvance();
    EXPECT_EQ(epochs.current(), 2u);
}

TEST(Epochs, AMovedPinLetsGoOnce) {
    Epochs epochs;
    {
        Epochs::Pin first = epochs.pin();
        const Epochs::Pin second(std::move(first));
    }
    epochs.tryAdvance();
    epochs.tryAdvance();
    EXPECT_EQ(epochs.current(), 2u);
}

TEST(Epochs, NothingIsFreedWhileAReaderMayLookAtIt) {
    struct Taken {
        uint64_t epoch;
        int* value;
    };
    constexpr int kValues = 20'000;
    Epochs epochs;
    std::atomic<int*> shared{new int(1)};
    std::atomic<bool> ends{false};
    std::vector<std::thread> readers;
    for (int i = 0; i < 3; ++i)
        readers.emplace_back([&] {
            while (!ends.load()) {
                const Epochs::Pin pin = epochs.pin();
                ASSERT_NE(*shared.load(), 0);
            }
        });
    std::vector<Taken> taken;
    for (int i = 1; i <= kValues; ++i) {
        taken.push_back({epochs.current(), shared.exchange(new int(i + 1))});
        epochs.tryAdvance();
        std::erase_if(taken, [&](const Taken& each) {
            if (epochs.current() < each.epoch + 2) return false;
            *each.value = 0; // a reader that still looks would see it, and the sanitizers the rest
            delete each.value;
            return true;
        });
    }
    ends.store(true);
    for (std::thread& reader : readers) reader.join();
    for (const Taken& each : taken) delete each.value;
    delete shared.load();
}

} // namespace
} // namespace plc
