// What two texts have in common and what lies between, with every hunk taken over: the other text comes out.
#include "editor/text/line_diff.h"

#include <gtest/gtest.h>

#include <random>

namespace plc::editor {
namespace {

TEST(LineDiff, FindsWhatIsAddedChangedAndRemoved) {
    EXPECT_TRUE(differences("a\nb\n", "a\nb\n").empty());
    EXPECT_EQ(differences("a\nb\nc\n", "a\nB\nc\n"), (std::vector<Hunk>{{1, 2, 1, 2}}));
    EXPECT_EQ(differences("a\nc\n", "a\nb\nc\n"), (std::vector<Hunk>{{1, 1, 1, 2}}));
    EXPECT_EQ(differences("a\nb\nc\n", "a\nc\n"), (std::vector<Hunk>{{1, 2, 1, 1}}));
    EXPECT_EQ(differences("", "a\n").size(), 1U);
}

/// All hunks taken over, the last first so that the numbers of the others hold.
std::string allTaken(const std::string& here, const std::string& other) {
    std::string text = here;
    const std::vector<Hunk> hunks = differences(here, other);
    for (size_t i = hunks.size(); i-- > 0;) text = withHunk(text, other, hunks[i]);
    return text;
}

TEST(LineDiff, EveryHunkTakenOverGivesTheOtherText) {
    std::mt19937 random(7);
    const auto text = [&] {
        std::string out;
        const int lines = static_cast<int>(random() % 9);
        for (int i = 0; i < lines; ++i) out += std::string(1, static_cast<char>('a' + random() % 4)) + "\n";
        if (random() % 2 && !out.empty()) out.pop_back();
        return out;
    };
    for (int round = 0; round < 20'000; ++round) {
        const std::string here = text(), other = text();
        EXPECT_EQ(allTaken(here, other), other) << "from [" << here << "]";
        if (HasFailure()) return;
    }
}

} // namespace
} // namespace plc::editor
