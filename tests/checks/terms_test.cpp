// One English term has one word in a language: each translation is held against translations/terms.csv, and no English
// is left in it but the words of translations/same_words.txt.
#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using plc::checks::contentOf;
using plc::checks::Message;
using plc::checks::messagesOf;

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80; }

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }

/// In small letters: ASCII, and Latin-1's capitals (C3 80 to C3 9E), which are all that the languages need.
std::string lowered(std::string text) {
    for (size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (isUpper(text[i])) text[i] = static_cast<char>(byte + 0x20);
        if (i > 0 && static_cast<unsigned char>(text[i - 1]) == 0xC3 && byte >= 0x80 && byte <= 0x9E)
            text[i] = static_cast<char>(byte + 0x20);
    }
    return text;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> out(1);
    for (const char c : text) {
        if (c == separator)
            out.emplace_back();
        else
            out.back() += c;
    }
    return out;
}

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

/// IF, VAR_IN_OUT: the language's own words, which no translation changes.
bool isKeyword(const std::string& word) { return word.size() > 1 && std::all_of(word.begin(), word.end(), isUpper); }

std::string withoutKeywords(const std::string& text) {
    std::string out, word;
    for (const char c : text + " ") {
        if (isLetter(c) || c == '_') {
            word += c;
            continue;
        }
        if (std::string letters = word; std::erase(letters, '_'), !isKeyword(letters)) out += word;
        out += c;
        word.clear();
    }
    return out;
}

/// A row of terms.csv: the English forms, the words of each language with further forms, and phrases that are not
/// meant.
struct Term {
    std::string name;
    std::vector<std::string> english, exceptions;
    std::map<std::string, std::vector<std::string>> words;
};

std::vector<std::vector<std::string>> table() {
    std::vector<std::vector<std::string>> out;
    std::istringstream lines(contentOf(plc::sourceDir() + "/translations/terms.csv"));
    for (std::string line; std::getline(lines, line);) out.push_back(split(line, ','));
    return out;
}

std::vector<Term> terms() {
    const std::vector<std::vector<std::string>> rows = table();
    std::vector<Term> out;
    for (size_t i = 1; i < rows.size(); ++i) {
        Term term{rows[i].front(), split(rows[i].front(), '|'), split(lowered(rows[i].back()), '|'), {}};
        std::erase(term.exceptions, "");
        for (size_t column = 2; column + 2 < rows[i].size(); ++column)
            term.words[rows.front()[column]] = split(lowered(rows[i][column]), '|');
        out.push_back(std::move(term));
    }
    return out;
}

bool hasWord(const std::string& text, const std::string& word) {
    const auto isInWord = [&](size_t at) { // English: “ and … are no letters
        return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_');
    };
    for (size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) {
        const size_t end = at + word.size();
        const bool isPlural = end < text.size() && text[end] == 's';
        if ((at == 0 || !isInWord(at - 1)) && (!isInWord(end) || (isPlural && !isInWord(end + 1)))) return true;
    }
    return false;
}

std::string without(std::string text, const std::vector<std::string>& phrases) {
    for (const std::string& phrase : phrases)
        for (size_t at = 0; (at = text.find(phrase)) != std::string::npos;) text.replace(at, phrase.size(), " ");
    return text;
}

/// {1:bit|bits} as its words, and one blank where several were.
std::string flat(const std::string& text) {
    std::string out;
    for (size_t i = 0; i < text.size(); ++i) {
        const bool isChoice = text[i] == '{' && i + 2 < text.size() && text[i + 2] == ':';
        if (isChoice) i += 2;
        const char c = isChoice || text[i] == '}' || text[i] == '\n' ? ' ' : text[i];
        if (c != ' ' || out.empty() || out.back() != ' ') out += c;
    }
    return out;
}

bool isMeant(const Term& term, const std::string& source) {
    const bool isKeywordItself = std::any_of(term.english.begin(), term.english.end(), isKeyword);
    const std::string text =
        without(lowered(isKeywordItself ? flat(source) : withoutKeywords(flat(source))), term.exceptions);
    return std::any_of(term.english.begin(), term.english.end(),
                       [&](const std::string& form) { return hasWord(text, lowered(form)); });
}

/// The terms of a source with the words that its translation may use; two meanings of one term give the words of both.
std::map<std::string, std::vector<std::string>> expected(const std::vector<Term>& all, const std::string& source,
                                                         const std::string& language) {
    std::map<std::string, std::vector<std::string>> out;
    for (const Term& term : all) {
        if (!isMeant(term, source)) continue;
        const std::vector<std::string>& words = term.words.at(language);
        out[term.name].insert(out[term.name].end(), words.begin(), words.end());
    }
    return out;
}

/// What `translation` of `source` calls otherwise than the table.
std::vector<std::string> otherWords(const std::vector<Term>& all, const std::string& source,
                                    const std::string& translation, const std::string& language) {
    std::vector<std::string> out;
    const std::string text = lowered(translation);
    for (const auto& [term, words] : expected(all, source, language))
        if (std::none_of(words.begin(), words.end(),
                         [&](const std::string& word) { return text.find(word) != std::string::npos; }))
            out.push_back(term + " is “" + words.front() + "”");
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
    const std::vector<std::vector<std::string>> rows = table();
    ASSERT_GT(rows.size(), 100u);
    EXPECT_EQ(rows.front(),
              (std::vector<std::string>{"term", "definition", "de", "da", "fr", "es", "zh_CN", "source", "not in"}));
    for (const std::vector<std::string>& row : rows) {
        ASSERT_EQ(row.size(), 9u) << row.front() << ": no commas within a cell";
        for (size_t i = 0; i < 8; ++i) EXPECT_FALSE(row[i].empty()) << row.front() << ", column " << i + 1;
    }
}

TEST(TermTable, FindsAnotherWordAndEnglish) {
    const std::vector<Term> all = terms();
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
    const std::vector<Term> all = terms();
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
