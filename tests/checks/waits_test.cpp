// Tests wait for conditions. A wait of fixed length is too short on a loaded machine and too long on every other one.
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;

bool waitsFixedTime(const std::string& line) {
    for (const char* wait :
         {"qWait(", "qSleep(", "msleep(", "usleep(", "::sleep(", "nanosleep(", "sleep_for(", "sleep_until("})
        if (line.find(wait) != std::string::npos) return true;
    static const std::regex timer("singleShot\\( *[1-9]|elapsed\\(\\) *[<>]=? *[0-9]");
    return std::regex_search(line, timer);
}

/// The line ends a wait that must succeed, and says itself after how many milliseconds it is given up.
bool hasOwnLimit(const std::string& line) {
    static const std::regex waits("(q?[wW]aitFor[A-Za-z]*|waitUntil|eventually)\\(");
    static const std::regex limit("[,(] *[0-9][0-9']{3,}\\)");
    const bool isChecked = line.find("ASSERT_") != std::string::npos || line.find("EXPECT_") != std::string::npos;
    return isChecked && std::regex_search(line, waits) && std::regex_search(line, limit);
}

/// Of the tests, without the one that gives examples.
void forEachLine(const std::function<void(const fs::path&, const std::string& before, const std::string& line)>& see) {
    for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/tests")) {
        const fs::path& path = entry.path();
        if (path.extension() != ".h" && path.extension() != ".cpp") continue;
        if (path.filename() == "waits_test.cpp") continue;
        std::ifstream in(path);
        std::string before;
        for (std::string line; std::getline(in, line); before = line) see(path, before, line);
    }
}

// ok:    ASSERT_TRUE(waitFor([&] { return isRunning(); }));
// ok:    sleep_for(delay); // a duration: of a slow line
// wrong: qWait(300);                              ← says not what it waits for
// wrong: QTimer::singleShot(150, answer);         ← the dialog opens later on a busy machine, and nobody answers it
// wrong: waitUntil([&] { return clock.elapsed() > 3000; });   ← and what is to have happened by then has not, somewhere
TEST(Waits, OfFixedLengthSayWhyTheyAreDurations) {
    forEachLine([](const fs::path& path, const std::string& before, const std::string& line) {
        if (path.filename() == "eventually.h") return;
        EXPECT_TRUE(!waitsFixedTime(line) || (before + line).find("// a duration: ") != std::string::npos)
            << path << ": wait for a condition (eventually, waitFor, QTest::qWaitFor, settle; for a dialog "
            << "tests/support/answer.h), or say in \"// a duration: …\" why time itself is meant\n"
            << line;
    });
}

// ok:    ASSERT_TRUE(process.waitForFinished(kPatience));
// wrong: ASSERT_TRUE(process.waitForFinished(20'000));   ← enough for an idle machine without a sanitizer
TEST(Waits, AreGivenUpAfterWhatPatienceSays) {
    EXPECT_TRUE(hasOwnLimit("ASSERT_TRUE(process.waitForFinished(20'000));"));
    EXPECT_TRUE(hasOwnLimit("ASSERT_TRUE(QTest::qWaitFor([&] { return isOpen; }, 8000));"));
    EXPECT_FALSE(hasOwnLimit("ASSERT_TRUE(waitFor([&] { return scans > 9000; }, 2 * kPatience));"));
    forEachLine([](const fs::path& path, const std::string&, const std::string& line) {
        EXPECT_FALSE(hasOwnLimit(line)) << path
                                        << ": kPatience (tests/support/patience.h) is longer under a sanitizer\n"
                                        << line;
    });
}

} // namespace
