// What waits: for bytes on a stream, for a connection, for a moment, for a signal of another thread.
#include "runtime/platform/files.h"
#include "runtime/platform/scheduling.h"
#include "runtime/platform/sockets.h"
#include "runtime/platform/streams.h"
#include "runtime/platform/wake_up.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <thread>
#include <unistd.h>

using namespace plc;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

TEST(Streams, NothingInTimeSomethingAndTheEndAreTold) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    char bytes[8];
    EXPECT_EQ(platform::readWithin(ends[0], bytes, 0), std::nullopt);
    EXPECT_TRUE(platform::writeAll(ends[1], "abc"));
    EXPECT_EQ(platform::readWithin(ends[0], bytes, -1), 3u);
    EXPECT_TRUE(platform::closeFile(ends[1]));
    EXPECT_EQ(platform::readWithin(ends[0], bytes, -1), 0u);
    EXPECT_FALSE(platform::isTerminal(ends[0]));
    EXPECT_TRUE(platform::closeFile(ends[0]));
}

TEST(Streams, AReaderThatIsGoneIsAFailedWriteOnly) {
    platform::ignoreLostReaders();
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    EXPECT_TRUE(platform::closeFile(ends[0]));
    EXPECT_FALSE(platform::writeAll(ends[1], "abc"));
    EXPECT_EQ(errno, EPIPE);
    EXPECT_TRUE(platform::closeFile(ends[1]));
}

TEST(Sockets, AConnectionIsTakenReadAndItsEndNoticed) {
    uint16_t port = 15'020;
    platform::Listener listener = platform::listenAt("127.0.0.1", port);
    while (listener.socket < 0 && port < 15'120) listener = platform::listenAt("127.0.0.1", ++port);
    ASSERT_GE(listener.socket, 0);
    EXPECT_LT(platform::acceptFrom(listener.socket), 0) << "nobody is there";
    ASSERT_EQ(platform::reach("127.0.0.1", port, 1000ms), 0); // connects and leaves
    platform::Awaited awaited[] = {{listener.socket}};
    for (int tries = 0; tries < 100 && !awaited[0].isReady; ++tries) platform::waitForAny(awaited, 100ms);
    const int client = platform::acceptFrom(listener.socket);
    ASSERT_GE(client, 0);
    awaited[0] = {client};
    for (int tries = 0; tries < 100 && !awaited[0].isReady; ++tries) platform::waitForAny(awaited, 100ms);
    uint8_t bytes[4];
    EXPECT_EQ(platform::receive(client, bytes), 0u);
    platform::closeSocket(client);
    platform::closeSocket(listener.socket);
    EXPECT_EQ(platform::reach("127.0.0.1", port, 1000ms), ECONNREFUSED);
}

TEST(Sockets, WhyNobodyCanListenIsSaid) {
    const platform::Listener foreign = platform::listenAt("192.0.2.1", 15'020); // an address for examples only
    EXPECT_LT(foreign.socket, 0);
    EXPECT_EQ(foreign.code, EADDRNOTAVAIL);
    const platform::Listener unknown = platform::listenAt("no such host", 15'020);
    EXPECT_LT(unknown.socket, 0);
    EXPECT_FALSE(unknown.says.empty());
}

TEST(Scheduling, SleepEndsAtItsTimeAndAThreadIsFoundByItsName) {
    const auto when = Clock::now() + 20ms;
    while (!platform::sleepUntil(when)) {
    }
    EXPECT_GE(Clock::now(), when);
    EXPECT_FALSE(platform::threadNamed("nobody"));
    std::atomic<bool> isNamed = false, isOver = false;
    std::thread thread([&] {
        platform::nameThread("somebody");
        platform::wakeExactly();
        isNamed = true;
        isNamed.notify_one();
        isOver.wait(false);
    });
    isNamed.wait(false);
    EXPECT_TRUE(platform::threadNamed("somebody"));
    isOver = true;
    isOver.notify_one();
    thread.join();
}

TEST(Scheduling, AThreadThatTakesItsNameLateIsWaitedFor) {
    std::atomic<bool> isLookedFor = false, isOver = false;
    std::thread thread([&] {
        isLookedFor.wait(false);
        platform::nameThread("latecomer");
        isOver.wait(false);
    });
    EXPECT_FALSE(platform::awaitThreadNamed("latecomer", 5ms));
    isLookedFor = true;
    isLookedFor.notify_one();
    EXPECT_TRUE(platform::awaitThreadNamed("latecomer", 60s));
    isOver = true;
    isOver.notify_one();
    thread.join();
}

TEST(WakeUp, ASignalBeforeTheWaitIsNotLost) {
    platform::WakeUp wakeUp;
    wakeUp.signal();
    wakeUp.wait(-1);
    const auto begin = Clock::now();
    wakeUp.wait(1'000'000);
    EXPECT_GE(Clock::now() - begin, 1ms) << "one signal, one wait";
}
