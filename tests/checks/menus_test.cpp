// Menus speak one way: their English entries are in title case ("Show in Trace"), as in the menu bar; tool tips and
// labels are sentences. Read from the sources, because a context menu exists only while it is open.
#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

/// The first word that should begin with a capital letter; empty: there is none.
std::string smallWord(const std::string& entry) {
    static const std::set<std::string> kSmall{"a",  "an",  "and", "as", "at", "between", "by", "for",
                                              "in", "not", "of",  "on", "or", "the",     "to", "with"};
    if (entry.find(": ") != std::string::npos) return {}; // a hint
    std::istringstream words(std::regex_replace(entry, std::regex(R"(\([^)]*\)|%\w+)"), ""));
    std::string word;
    for (bool isFirst = true; words >> word; isFirst = false) {
        const bool isLower = std::islower(static_cast<unsigned char>(word[0])) != 0;
        if (isLower && (isFirst || !kSmall.contains(word))) return word;
    }
    return {};
}

TEST(Menus, SmallWordsAreFound) {
    EXPECT_EQ(smallWord("Show in Trace"), "");
    EXPECT_EQ(smallWord("Source of %1 with the Values of %2"), "");
    EXPECT_EQ(smallWord("Zoom 100 %"), "");
    EXPECT_EQ(smallWord("Snap (Alt: not now)"), "");
    EXPECT_EQ(smallWord("Show in trace"), "trace");
    EXPECT_EQ(smallWord("remove"), "remove");
}

TEST(Menus, EntriesAreInTitleCase) {
    // A tool bar's action is a button with a tip; every other receiver of addAction is a menu. Where a menu is filled
    // by a short name, it is `add`.
    const std::regex entry(
        R"re((?:(\w+)(?:->|\.)add(?:Action|Menu)\((?:kit::icon\([^)]*\),)?|\badd(?:Edit)?\((?:QStringLiteral\("[^"]*"\)|(?:kit::)?Icon::\w+),)\s*(?:\w+::)?tr\("((?:[^"\\]|\\.)*)")re");
    size_t entries = 0;
    for (const char* folder : {"app", "editor", "hmi"})
        for (const auto& each : fs::recursive_directory_iterator(plc::sourceDir() + "/" + folder)) {
            if (each.path().extension() != ".cpp") continue;
            const std::string text = plc::checks::contentOf(each.path());
            for (auto hit = std::sregex_iterator(text.begin(), text.end(), entry); hit != std::sregex_iterator();
                 ++hit) {
                const bool isShort = !(*hit)[1].matched;
                if ((*hit)[1] == "bar" || (isShort && text.find("QMenu menu") == std::string::npos)) continue;
                ++entries;
                EXPECT_EQ(smallWord((*hit)[2]), "") << each.path() << ": \"" << (*hit)[2] << "\" in a menu";
            }
        }
    EXPECT_GT(entries, 100u) << "the sources were not read";
}

} // namespace
