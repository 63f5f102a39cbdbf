// An example's README.de.md is its README.md in German: the same headings, steps, pictures, links and names of the
// program.
#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace {

using plc::checks::contentOf;

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> out;
    for (auto hit = std::sregex_iterator(text.begin(), text.end(), pattern); hit != std::sregex_iterator(); ++hit)
        out.push_back((*hit)[1]);
    return out;
}

TEST(GermanReadmes, HaveThePartsOfTheEnglishOnes) {
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(plc::sourceDir() + "/projects/examples")) {
        const std::string folder = entry.path().string();
        if (!std::filesystem::exists(folder + "/README.md")) continue;
        ++read;
        SCOPED_TRACE(folder);
        const std::string english = contentOf(folder + "/README.md"), german = contentOf(folder + "/README.de.md");
        for (const char* part : {R"(\n(#+|[0-9]+\.|-|!) )", R"(\]\(([^)]+)\))"})
            EXPECT_EQ(matches(german, std::regex(part)), matches(english, std::regex(part)));
        // In the order of another sentence.
        std::vector<std::string> names = matches(german, std::regex("`([^`]+)`")),
                                 needed = matches(english, std::regex("`([^`]+)`"));
        std::sort(names.begin(), names.end());
        std::sort(needed.begin(), needed.end());
        EXPECT_EQ(names, needed);
    }
    EXPECT_GT(read, 40) << "the folder was not read";
}

} // namespace
