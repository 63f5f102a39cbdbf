// Other programs and what runs beside: found, run to their end, known to be gone.
#include "runtime/platform/processes.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace plc;

TEST(Processes, ThisOneIsNotGoneAndOneThatNeverWasIs) {
    EXPECT_FALSE(platform::isGone(platform::processId()));
    EXPECT_FALSE(platform::isGone(1)) << "of somebody else, but there";
    EXPECT_TRUE(platform::isGone(INT32_MAX - 1));
    EXPECT_FALSE(platform::isGone(0));
}

TEST(Processes, ItsOwnProgramIsThisTest) {
    EXPECT_EQ(std::filesystem::path(platform::ownProgram()).filename(), "test_runtime_platform");
}

TEST(Processes, AProgramRunsToItsEndWithoutAShell) {
    const auto shell = platform::programInPath("sh");
    ASSERT_TRUE(shell);
    EXPECT_EQ(platform::runProgram({*shell, "-c", "exit 3"}), 3);
    EXPECT_EQ(platform::runProgram({*shell, "-c", "test \"$0\" = 'a b; c'", "a b; c"}), 0);
    EXPECT_EQ(platform::runProgram({*shell, "-c", "kill -9 $$"}), std::nullopt);
    EXPECT_EQ(platform::runProgram({"/no/such/program"}), 127);
    EXPECT_FALSE(platform::programInPath("no-such-program"));
}
