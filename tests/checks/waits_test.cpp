// Tests wait for conditions. A wait of fixed length is too short on a loaded machine and too long on every other one.
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;

bool waitsFixedTime(const std::string& line) {
    for (const char* wait :
         {"qWait(", "qSleep(", "msleep(", "usleep(", "::sleep(", "nanosleep(", "sleep_for(", "sleep_until("})
        if (line.find(wait) != std::string::npos) return true;
    return false;
}

// ok:    ASSERT_TRUE(waitFor([&] { return isRunning(); }));
// ok:    sleep_for(delay); // a duration: of a slow line
// wrong: qWait(300);                              ← says not what it waits for
TEST(Waits, OfFixedLengthSayWhyTheyAreDurations) {
    for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/tests")) {
        const fs::path& path = entry.path();
        if (path.extension() != ".h" && path.extension() != ".cpp") continue;
        if (path.filename() == "eventually.h" || path.filename() == "waits_test.cpp") continue;
        std::ifstream in(path);
        std::string before;
        for (std::string line; std::getline(in, line); before = line)
            EXPECT_TRUE(!waitsFixedTime(line) || (before + line).find("// a duration: ") != std::string::npos)
                << path << ": wait for a condition (eventually, waitFor, QTest::qWaitFor, settle), or say in "
                << "\"// a duration: …\" why time itself is meant\n"
                << line;
    }
}

} // namespace
