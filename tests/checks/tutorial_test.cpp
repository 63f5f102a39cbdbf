// docs/tutorial.de.md gives the commands and programs of docs/tutorial.md, with the words of the German studio. The
// steps themselves are tried on the English page (tests/app/tutorial_test.cpp).
#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using plc::checks::contentOf;
using plc::checks::messagesOf;

std::string page(const std::string& name) { return contentOf(plc::sourceDir() + "/docs/" + name); }

std::string withoutComment(const std::string& line) {
    const size_t comment = line.find("//");
    const std::string code = line.substr(0, comment);
    return code.substr(0, code.find_last_not_of(' ') + 1);
}

/// The lines of the blocks between ``` and ```, without comments; each block begins with its language.
std::vector<std::string> blockLines(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream lines(text);
    bool isInside = false;
    for (std::string line; std::getline(lines, line);) {
        const bool isFence = line.starts_with("```");
        if (isFence || isInside) out.push_back(withoutComment(line));
        if (isFence) isInside = !isInside;
    }
    return out;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> out;
    for (auto hit = std::sregex_iterator(text.begin(), text.end(), pattern); hit != std::sregex_iterator(); ++hit)
        out.push_back((*hit)[1]);
    return out;
}

TEST(Tutorial, TheGermanPageHasTheCommandsAndProgramsOfTheEnglishOne) {
    const std::vector<std::string> english = blockLines(page("tutorial.md")),
                                   german = blockLines(page("tutorial.de.md"));
    EXPECT_GT(english.size(), 40u) << "the page was not read";
    EXPECT_EQ(german, english);
    const std::regex heading("\n## (\\d)\\.");
    EXPECT_EQ(matches(page("tutorial.de.md"), heading), matches(page("tutorial.md"), heading));
}

TEST(Tutorial, TheGermanPageNamesWhatTheGermanStudioShows) {
    std::set<std::string> shown{"F5", "Deutsch"};
    for (const plc::checks::Message& message : messagesOf("de"))
        for (const std::string& translation : message.translations) shown.insert(translation);
    const std::vector<std::string> bold = matches(page("tutorial.de.md"), std::regex("\\*\\*([^*]+)\\*\\*"));
    EXPECT_GT(bold.size(), 12u);
    for (const std::string& name : bold) EXPECT_TRUE(shown.contains(name)) << name << " is nowhere in the studio";
}

TEST(Tutorial, ItsCommandsAreThoseOfTheProgram) {
    std::string commands;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(plc::sourceDir() + "/app/cli"))
        if (entry.is_regular_file()) commands += contentOf(entry.path());
    for (const std::string& line : blockLines(page("tutorial.de.md"))) {
        if (!line.starts_with("stepwise ")) continue;
        std::istringstream words(line.substr(9));
        std::string command;
        words >> command;
        EXPECT_NE(commands.find('"' + command + '"'), std::string::npos) << command;
        for (std::string word; words >> word;)
            EXPECT_TRUE(!word.starts_with("--") || commands.find('"' + word + '"') != std::string::npos) << word;
    }
}

} // namespace
