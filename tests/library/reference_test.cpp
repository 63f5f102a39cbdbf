// docs/library is what `stepwise doc library` writes; this says when it is stale.
#include "projects/analysis/library_reference.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace {

std::string readWhole(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(LibraryReference, IsCheckedInAsItWouldBeWritten) {
    const std::string folder = plc::sourceDir() + "/docs/library/";
    std::set<std::string> names;
    for (const plc::analysis::ReferencePage& page : plc::analysis::libraryReference()) {
        names.insert(page.fileName);
        EXPECT_TRUE(readWhole(folder + page.fileName) == page.markdown)
            << page.fileName << " is stale: run `stepwise doc library`";
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        EXPECT_TRUE(names.contains(entry.path().filename().string())) << entry.path() << " belongs to no library";
}

TEST(LibraryReference, TellsPurposePinsErrorsAndExampleOfABlock) {
    for (const plc::analysis::ReferencePage& page : plc::analysis::libraryReference()) {
        if (page.fileName != "toolbox.md") continue;
        const size_t begin = page.markdown.find("### FB_PWM");
        ASSERT_NE(begin, std::string::npos);
        const std::string block = page.markdown.substr(begin, page.markdown.find("### ", begin + 4) - begin);
        EXPECT_NE(block.find("Function block. Pulse width modulation"), std::string::npos) << block;
        EXPECT_NE(block.find("| `i_rInput`, `i_rIput` | REAL |"), std::string::npos) << block;
        EXPECT_NE(block.find("[-100..100]"), std::string::npos) << block;
        EXPECT_NE(block.find("2 PWM period &lt;= cycle time"), std::string::npos) << block;
        EXPECT_NE(block.find("```iecst\nheat(i_xEn"), std::string::npos) << block;
        EXPECT_EQ(page.markdown.find("### PidCore"), std::string::npos) << "hidden blocks stay out";
    }
}

} // namespace
