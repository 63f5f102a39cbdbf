// "Did you mean": the nearest name is the nearest, whatever is skipped on the way to it.
#include "runtime/base/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <random>

using namespace plc;

namespace {

size_t sameBeginning(const std::string& a, const std::string& b) {
    size_t count = 0;
    for (; count < a.size() && count < b.size(); ++count)
        if (std::tolower(static_cast<unsigned char>(a[count])) != std::tolower(static_cast<unsigned char>(b[count])))
            break;
    return count;
}

/// By the definition: every candidate is compared.
std::optional<std::string> nearestOfAll(std::string_view name, const std::vector<std::string>& candidates) {
    std::optional<std::string> best;
    size_t bestDistance = std::max<size_t>(1, name.size() / 3);
    for (const std::string& candidate : candidates) {
        const size_t distance = editDistance(name, candidate);
        if (distance > bestDistance || distance >= candidate.size()) continue;
        if (best && distance == bestDistance) {
            const size_t now = sameBeginning(std::string(name), candidate),
                         then = sameBeginning(std::string(name), *best);
            if (now < then || (now == then && candidate >= *best)) continue;
        }
        best = candidate;
        bestDistance = distance;
    }
    return best;
}

TEST(NearestName, IsTheNearestOfAll) {
    std::mt19937 random(std::random_device{}());
    const auto seed = random();
    SCOPED_TRACE("seed " + std::to_string(seed));
    random.seed(seed);
    const std::vector<std::string> letters = {"a", "B", "b", "c", "C", "_", "1", "q", "Q", "ä", "Ä", "б", "Б", "z"};
    const auto any = [&](size_t below) { return std::uniform_int_distribution<size_t>(0, below - 1)(random); };
    const auto word = [&] {
        std::string out;
        for (size_t length = 1 + any(9); length > 0; --length) out += letters[any(letters.size())];
        return out;
    };
    int found = 0;
    for (int round = 0; round < 2'000; ++round) {
        std::vector<std::string> candidates;
        for (int i = 0; i < 20; ++i) candidates.push_back(word());
        const std::string name = word();
        const std::optional<std::string> nearest = nearestName(name, candidates);
        ASSERT_EQ(nearest, nearestOfAll(name, candidates)) << name;
        found += nearest ? 1 : 0;
    }
    EXPECT_GT(found, 100);
}

TEST(NearestName, SwappedLettersAndCaseCountLittleAndTheBeginningDecides) {
    EXPECT_EQ(nearestName("tmie", {"tank", "Time", "limit"}), "Time");
    EXPECT_EQ(nearestName("motr", {"MOTOR", "rotor"}), "MOTOR");
    EXPECT_EQ(nearestName("leve", {"leave", "level", "lever"}), "level");
    EXPECT_EQ(nearestName("pump", {"valve"}), std::nullopt);
}

} // namespace
