// A table of terms, translations/*.csv: one English term, one word in each language. Read and compared for the checks
// of the studio's texts and of the panels'.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace plc::checks {

/// A row: the English forms, the words of each language with further forms, and phrases that are not meant.
struct Term {
    std::string name;
    std::vector<std::string> english, exceptions;
    std::map<std::string, std::vector<std::string>> words; // not of a language whose cell is empty
};

/// The cells of the file, its head first.
[[nodiscard]] std::vector<std::vector<std::string>> termTable(const std::string& file);
[[nodiscard]] std::vector<Term> termsOf(const std::string& file);
/// What `translation` of `source` calls otherwise than the table.
[[nodiscard]] std::vector<std::string> otherWords(const std::vector<Term>& all, const std::string& source,
                                                  const std::string& translation, const std::string& language);

[[nodiscard]] bool isLetter(char c);
[[nodiscard]] bool isUpper(char c);
/// In small letters: ASCII, and Latin-1's capitals (C3 80 to C3 9E), which are all that the languages need.
[[nodiscard]] std::string lowered(std::string text);
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);
/// IF, VAR_IN_OUT: the language's own words, which no translation changes.
[[nodiscard]] bool isKeyword(const std::string& word);

} // namespace plc::checks
