#include "tests/checks/term_table.h"

#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace plc::checks {

namespace {

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
        const auto words = term.words.find(language);
        if (words == term.words.end() || !isMeant(term, source)) continue;
        out[term.name].insert(out[term.name].end(), words->second.begin(), words->second.end());
    }
    return out;
}

} // namespace

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80; }

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }

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

bool isKeyword(const std::string& word) { return word.size() > 1 && std::all_of(word.begin(), word.end(), isUpper); }

std::vector<std::vector<std::string>> termTable(const std::string& file) {
    std::vector<std::vector<std::string>> out;
    std::istringstream lines(contentOf(plc::sourceDir() + "/translations/" + file));
    for (std::string line; std::getline(lines, line);) out.push_back(split(line, ','));
    return out;
}

std::vector<Term> termsOf(const std::string& file) {
    const std::vector<std::vector<std::string>> rows = termTable(file);
    std::vector<Term> out;
    for (size_t i = 1; i < rows.size(); ++i) {
        Term term{rows[i].front(), split(rows[i].front(), '|'), split(lowered(rows[i].back()), '|'), {}};
        std::erase(term.exceptions, "");
        for (size_t column = 2; column + 2 < rows[i].size(); ++column)
            if (!rows[i][column].empty()) term.words[rows.front()[column]] = split(lowered(rows[i][column]), '|');
        out.push_back(std::move(term));
    }
    return out;
}

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

} // namespace plc::checks
