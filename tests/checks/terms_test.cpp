// One English term has one word in a language: each translation is held against translations/terms.csv, and no English
// is left in it but the words of translations/same_words.txt.
#include "tests/checks/term_table.h"
#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using plc::checks::contentOf;
using plc::checks::isKeyword;
using plc::checks::isLetter;
using plc::checks::isUpper;
using plc::checks::lowered;
using plc::checks::Message;
using plc::checks::messagesOf;
using plc::checks::otherWords;
using plc::checks::split;
using plc::checks::Term;
using plc::checks::termsOf;
using plc::checks::termTable;

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> out(1);
    for (size_t i = 0; i < text.size(); ++i) {
        const bool isPunctuation = static_cast<unsigned char>(text[i]) >= 0xE0; // “ ” „ … –, and Chinese: three bytes
        if (isPunctuation) i += 2;
        if (!isPunctuation && isLetter(text[i]))
            out.back() += text[i];
        else if (!out.back().empty())
            out.emplace_back();
    }
    if (out.back().empty()) out.pop_back();
    return out;
}

std::set<std::string> sameWords(const std::string& language) {
    std::set<std::string> out;
    std::istringstream lines(contentOf(plc::sourceDir() + "/translations/same_words.txt"));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(language + ": "))
            for (std::string& word : split(line.substr(language.size() + 2), ' ')) out.insert(std::move(word));
    return out;
}

/// Words that only English has, of the languages the studio speaks.
const std::set<std::string> kEnglish{"the",  "is",   "not",  "of",   "and",   "this", "cannot", "has",
                                     "are",  "with", "that", "from", "its",   "it",   "there",  "which",
                                     "what", "when", "been", "does", "where", "you",  "these",  "be"};

std::vector<std::string> englishIn(const Message& message, const std::string& translation,
                                   const std::set<std::string>& same) {
    std::vector<std::string> out;
    const std::vector<std::string> sourceWords = wordsOf(message.source);
    const std::set<std::string> source(sourceWords.begin(), sourceWords.end());
    for (const std::string& word : wordsOf(translation)) {
        if (isKeyword(word) || std::any_of(word.begin() + 1, word.end(), isUpper)) continue; // a keyword, a name
        const bool isTaken = word.size() >= 4 && source.contains(word) && !same.contains(word);
        if (isTaken || kEnglish.contains(lowered(word))) out.push_back(word);
    }
    return out;
}

class Terms : public testing::TestWithParam<const char*> {};

TEST(TermTable, HasAWordInEachLanguage) {
    const std::vector<std::vector<std::string>> rows = termTable("terms.csv");
    ASSERT_GT(rows.size(), 100u);
    EXPECT_EQ(rows.front(),
              (std::vector<std::string>{"term", "definition", "de", "da", "fr", "es", "zh_CN", "source", "not in"}));
    for (const std::vector<std::string>& row : rows) {
        ASSERT_EQ(row.size(), 9u) << row.front() << ": no commas within a cell";
        for (size_t i = 0; i < 8; ++i) EXPECT_FALSE(row[i].empty()) << row.front() << ", column " << i + 1;
    }
}

TEST(TermTable, FindsAnotherWordAndEnglish) {
    const std::vector<Term> all = termsOf("terms.csv");
    EXPECT_EQ(otherWords(all, "Force the value", "Wert erzwingen", "de").size(), 1u);
    EXPECT_EQ(otherWords(all, "Force the value", "Wert FORCEN", "de").size(), 0u);
    EXPECT_EQ(otherWords(all, "{0:scan|scans} lost", "Durchlauf verloren", "de").size(), 1u);
    EXPECT_EQ(otherWords(all, "ACTION is missing", "ACTION fehlt", "de").size(), 0u);
    EXPECT_EQ(otherWords(all, "PLC time", "Zeit", "de").size(), 1u);
    const Message message{"", "Write the breakpoints", {}};
    EXPECT_EQ(englishIn(message, "Die breakpoints schreiben", {}), std::vector<std::string>{"breakpoints"});
    EXPECT_EQ(englishIn(message, "Write the file", {"Write"}), std::vector<std::string>{"the"});
    EXPECT_TRUE(englishIn(message, "Haltepunkte schreiben", {}).empty());
}

TEST_P(Terms, AreTranslatedAsInTheTable) {
    const std::vector<Term> all = termsOf("terms.csv");
    for (const Message& message : messagesOf(GetParam()))
        for (const std::string& translation : message.translations)
            for (const std::string& finding : otherWords(all, message.source, translation, GetParam()))
                ADD_FAILURE() << GetParam() << ", “" << message.source << "”: “" << translation << "”; " << finding;
}

TEST_P(Terms, LeaveNoEnglish) {
    const std::set<std::string> same = sameWords(GetParam());
    ASSERT_FALSE(same.empty());
    for (const Message& message : messagesOf(GetParam()))
        for (const std::string& translation : message.translations)
            for (const std::string& word : englishIn(message, translation, same))
                ADD_FAILURE() << GetParam() << ", “" << translation << "”: “" << word
                              << "” is English; translate it, or add it to translations/same_words.txt";
}

INSTANTIATE_TEST_SUITE_P(Languages, Terms, testing::ValuesIn(plc::checks::kTranslated));

} // namespace
