// Every seed and every past finding goes through all fuzz entries, in each preset; and every seed cut at each
// token and with one token swapped: no crash, no hang.
#include "tests/fuzz/inside_impl.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace {

namespace fs = std::filesystem;

std::vector<std::pair<std::string, std::string>> texts(const char* folder) {
    std::vector<std::pair<std::string, std::string>> out;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(plc::sourceDir() + "/tests/fuzz/" + folder, none)) {
        std::ifstream in(entry.path(), std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        out.emplace_back(entry.path().filename().string(), text.str());
    }
    std::sort(out.begin(), out.end());
    return out;
}

class FuzzReplay : public testing::Test {
protected:
    static void SetUpTestSuite() { plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols()); }
};

TEST_F(FuzzReplay, SeedsAndFindingsPass) {
    size_t count = 0;
    for (const char* folder : {"seeds", "findings"})
        for (const auto& [name, text] : texts(folder)) {
            SCOPED_TRACE(name);
            plc::fuzz::lexText(text);
            plc::fuzz::parseText(text);
            plc::fuzz::checkText(text);
            plc::fuzz::runText(text);
            plc::fuzz::changeText(text);
            plc::fuzz::lookInside(text);
            ++count;
        }
    EXPECT_GT(count, 0u);
}

TEST_F(FuzzReplay, SeedsCutAtEachTokenAndWithOneTokenSwapped) {
    for (const auto& [name, text] : texts("seeds")) {
        SCOPED_TRACE(name);
        plc::diagnostics::Sink sink;
        const auto list = plc::lex::tokenize(plc::FileId(size_t(0)), text, sink);
        for (size_t i = 0; i + 1 < list.tokens.size(); ++i) {
            plc::fuzz::parseText(std::string_view(text).substr(0, list.tokens[i].begin));
            if (i + 2 >= list.tokens.size()) continue;
            const auto &a = list.tokens[i], &b = list.tokens[i + 1];
            std::string swapped = text.substr(0, a.begin) + text.substr(b.begin, b.end - b.begin) +
                                  text.substr(a.end, b.begin - a.end) + text.substr(a.begin, a.end - a.begin) +
                                  text.substr(b.end);
            plc::fuzz::parseText(swapped);
        }
    }
}

TEST_F(FuzzReplay, MutantsByTheGrammarAreCheckedExchangedAndLookedInto) {
    const char* given = std::getenv("STEPWISE_SEED");
    const auto first = given ? static_cast<uint32_t>(std::strtoul(given, nullptr, 10)) : std::random_device{}();
    std::printf("seed %u\n", first);
    std::fflush(stdout); // seen also when a mutant ends the process
    const bool isLong = std::getenv("STEPWISE_LONG") != nullptr;
    const auto all = texts("seeds");
    size_t right = 0;
    for (uint32_t i = 0; i < (isLong ? 20'000u : 300u); ++i) {
        const uint32_t seed = first + i;
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::string& text = all[seed % all.size()].second;
        const std::string mutant = plc::fuzz::mutateByGrammar(text, all[seed / 7 % all.size()].second, seed);
        EXPECT_EQ(mutant, plc::fuzz::mutateByGrammar(text, all[seed / 7 % all.size()].second, seed));
        plc::fuzz::parseText(mutant);
        plc::fuzz::checkText(mutant);
        right += plc::driver::check(plc::fuzz::inputOf(mutant)).analysis->hasErrors ? 0 : 1;
        if (i % 30 == 0) plc::fuzz::changeText(mutant);
        if (i % 30 == 15) plc::fuzz::lookInside(mutant);
    }
    EXPECT_GT(right, 0u) << "mutants that nothing is wrong with reach the code behind the checker";
}

/// The seeds, findings and goldens, small enough to be checked twice each in a moment.
std::vector<std::pair<std::string, std::string>> smallTexts() {
    std::vector<std::pair<std::string, std::string>> all;
    for (const char* folder : {"seeds", "findings"})
        for (auto& each : texts(folder)) all.push_back(std::move(each));
    for (const auto& topic : fs::directory_iterator(plc::sourceDir() + "/tests/golden"))
        if (topic.is_directory())
            for (auto& each : texts(("../golden/" + topic.path().filename().string()).c_str()))
                if (each.first.ends_with(".st") && each.second.size() < 4'000) all.push_back(std::move(each));
    std::sort(all.begin(), all.end());
    return all;
}

TEST_F(FuzzReplay, WhatWasKeptOfAnyTextBeforeChangesNoDiagnostic) {
    const char* given = std::getenv("STEPWISE_SEED");
    const auto first = given ? static_cast<uint32_t>(std::strtoul(given, nullptr, 10)) : std::random_device{}();
    std::printf("seed %u\n", first);
    std::fflush(stdout);
    const bool isLong = std::getenv("STEPWISE_LONG") != nullptr;
    const auto all = smallTexts();
    ASSERT_GT(all.size(), 100u);
    for (uint32_t i = 0; i < (isLong ? 4'000u : 60u) && !HasFailure(); ++i) {
        std::mt19937 random(first + i);
        plc::driver::KeptFiles kept;
        std::string text = all[random() % all.size()].second, before;
        for (int edit = 0; edit < 12; ++edit) {
            const auto input = plc::fuzz::inputOf("", text);
            const plc::driver::Checked edited = plc::driver::check(input, kept);
            const plc::driver::Checked fresh = plc::driver::check(input);
            ASSERT_TRUE(plc::fuzz::reportsTheSame(edited, fresh))
                << "seed " << first + i << ", edit " << edit << "\nthe text before:\n"
                << before << "\nthe text:\n"
                << text;
            before = text;
            const std::string& other = all[random() % all.size()].second;
            // mostly an edit, now and then another text, and back
            text = random() % 6 == 0 ? other : plc::fuzz::mutateByGrammar(text, other, random());
            if (text.size() > 6'000) text = other;
        }
    }
}

TEST_F(FuzzReplay, SeedsWithRandomTokensDroppedCompileOrComplain) {
    const uint32_t seed = std::random_device{}();
    RecordProperty("seed", static_cast<int>(seed));
    std::printf("seed %u\n", seed);
    std::mt19937 random(seed);
    for (const auto& [name, text] : texts("seeds")) {
        SCOPED_TRACE(name + ", seed " + std::to_string(seed));
        plc::diagnostics::Sink sink;
        const auto list = plc::lex::tokenize(plc::FileId(size_t(0)), text, sink);
        if (list.tokens.size() < 3) continue;
        for (int round = 0; round < 6; ++round) {
            const auto& token = list.tokens[random() % (list.tokens.size() - 1)];
            plc::fuzz::runText(text.substr(0, token.begin) + text.substr(token.end));
        }
    }
}

} // namespace
