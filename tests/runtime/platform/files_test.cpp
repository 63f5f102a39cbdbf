// Files whole or as they were, one holder of a lock, no mistaken leftovers.
#include "runtime/platform/files.h"
#include "runtime/platform/processes.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace plc;

namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
protected:
    Files() { fs::create_directories(m_folder); }
    ~Files() override { fs::remove_all(m_folder); }
    [[nodiscard]] std::string at(const char* name) const { return (m_folder / name).string(); }
    static std::string textOf(const std::string& path) {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    static void write(const std::string& path, const char* text) { std::ofstream(path) << text; }

private:
    fs::path m_folder = fs::temp_directory_path() / ("platform-" + std::to_string(platform::processId()));
};

} // namespace

TEST_F(Files, WhatIsWrittenAsideTakesTheOldOnesPlace) {
    write(at("value"), "old");
    const int file = platform::openToWrite(at("value.new"), platform::Existing::Emptied);
    ASSERT_GE(file, 0);
    EXPECT_TRUE(platform::writeAll(file, std::string(100'000, 'x')));
    EXPECT_TRUE(platform::syncFile(file));
    EXPECT_TRUE(platform::closeFile(file));
    EXPECT_EQ(textOf(at("value")), "old");
    EXPECT_TRUE(platform::replaceFile(at("value.new"), at("value")));
    platform::syncFolder(fs::path(at("value")).parent_path().string());
    EXPECT_EQ(textOf(at("value")).size(), 100'000u);
    EXPECT_FALSE(fs::exists(at("value.new")));
}

TEST_F(Files, AFileThatExistsIsRefusedWhereANewOneIsWanted) {
    write(at("code"), "secret");
    EXPECT_LT(platform::openToWrite(at("code"), platform::Existing::Refused), 0);
    EXPECT_EQ(errno, EEXIST);
    EXPECT_EQ(textOf(at("code")), "secret");
}

TEST_F(Files, ACodeIsForItsOwnerOnly) {
    const int file = platform::openToWrite(at("code"), platform::Existing::Refused, platform::Readers::OwnerOnly);
    ASSERT_GE(file, 0);
    EXPECT_TRUE(platform::closeFile(file));
    EXPECT_EQ(fs::status(at("code")).permissions() & fs::perms(0077), fs::perms::none);
}

TEST_F(Files, WritingToAClosedFileFails) {
    const int file = platform::openToWrite(at("value"), platform::Existing::Emptied);
    ASSERT_TRUE(platform::closeFile(file));
    EXPECT_FALSE(platform::writeAll(file, "late"));
}

TEST_F(Files, RemovingKeepsTheReasonOfTheFailureBefore) {
    errno = ENOSPC;
    platform::removeFile(at("nothing"));
    EXPECT_EQ(errno, ENOSPC);
}

TEST_F(Files, ALockHasOneHolderUntilItIsClosed) {
    const int first = platform::lockFile(at("lock"));
    ASSERT_GE(first, 0);
    EXPECT_LT(platform::lockFile(at("lock")), 0);
    EXPECT_EQ(errno, EWOULDBLOCK);
    EXPECT_TRUE(platform::closeFile(first));
    const int second = platform::lockFile(at("lock"));
    EXPECT_GE(second, 0);
    EXPECT_TRUE(platform::closeFile(second));
    EXPECT_LT(platform::lockFile("/no/such/folder/lock"), 0);
    EXPECT_NE(errno, EWOULDBLOCK);
}
