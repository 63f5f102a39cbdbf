// What operators read in the examples has one word for one thing in each language: every row of their texts.csv is
// held against translations/panel_terms.csv. A button that acknowledges says so, one that resets does not.
#include "tests/checks/term_table.h"
#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace {

namespace checks = plc::checks;
namespace fs = std::filesystem;

/// Cells in quotes may hold commas, quotes (twice) and lines.
std::vector<std::vector<std::string>> rowsOfCsv(const std::string& text) {
    std::vector<std::vector<std::string>> out(1, std::vector<std::string>(1));
    bool isQuoted = false;
    for (size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && isQuoted && i + 1 < text.size() && text[i + 1] == '"')
            out.back().back() += text[++i];
        else if (c == '"')
            isQuoted = !isQuoted;
        else if (c == ',' && !isQuoted)
            out.back().emplace_back();
        else if (c == '\n' && !isQuoted)
            out.emplace_back(1);
        else if (c != '\r')
            out.back().back() += c;
    }
    if (out.back().size() == 1 && out.back().front().empty()) out.pop_back();
    return out;
}

std::vector<fs::path> tablesOfExamples() {
    std::vector<fs::path> out;
    for (const fs::directory_entry& example : fs::directory_iterator(plc::sourceDir() + "/projects/examples"))
        if (const fs::path table = example.path() / "hmi" / "texts.csv"; fs::exists(table)) out.push_back(table);
    std::sort(out.begin(), out.end());
    return out;
}

TEST(PanelTerms, TableHasAWordInTheLanguagesOfMostExamples) {
    const std::vector<std::vector<std::string>> rows = checks::termTable("panel_terms.csv");
    ASSERT_GT(rows.size(), 30u);
    EXPECT_EQ(rows.front(), (std::vector<std::string>{"term", "definition", "de", "da", "es", "fr", "nl", "sv", "it",
                                                      "pl", "zh", "ar", "source", "not in"}));
    for (const std::vector<std::string>& row : rows) {
        ASSERT_EQ(row.size(), rows.front().size()) << row.front() << ": no commas within a cell";
        for (size_t i = 0; i < 6; ++i) EXPECT_FALSE(row[i].empty()) << row.front() << ", column " << i + 1;
    }
}

TEST(PanelTerms, FindsAnotherWord) {
    const std::vector<checks::Term> all = checks::termsOf("panel_terms.csv");
    EXPECT_EQ(checks::otherWords(all, "reset 1", "Quittieren 1", "de").size(), 1u);
    EXPECT_EQ(checks::otherWords(all, "reset 1", "Rücksetzen 1", "de").size(), 0u);
    EXPECT_EQ(checks::otherWords(all, "acknowledge", "Zurücksetzen", "de").size(), 1u);
    EXPECT_EQ(checks::otherWords(all, "room, set point", "Rum skal være", "da").size(), 1u);
    EXPECT_EQ(checks::otherWords(all, "the house", "Huset", "da").size(), 0u) << "home is another word";
    EXPECT_EQ(rowsOfCsv("a,\"b, \"\"c\"\"\"\r\nd,").size(), 2u);
    EXPECT_EQ(rowsOfCsv("a,\"b, \"\"c\"\"\"\r\n").front(), (std::vector<std::string>{"a", "b, \"c\""}));
}

TEST(PanelTerms, AreUsedInEveryExample) {
    const std::vector<checks::Term> all = checks::termsOf("panel_terms.csv");
    const std::vector<fs::path> tables = tablesOfExamples();
    EXPECT_GE(tables.size(), 46u);
    std::set<std::string> languages;
    for (const fs::path& table : tables) {
        const std::vector<std::vector<std::string>> rows = rowsOfCsv(checks::contentOf(table));
        ASSERT_GT(rows.size(), 1u) << table;
        const std::vector<std::string>& head = rows.front();
        size_t english = 0;
        while (english < head.size() && !head[english].starts_with("en")) ++english;
        ASSERT_LT(english, head.size()) << table << " has no English";
        const std::string example = table.parent_path().parent_path().filename().string();
        for (size_t row = 1; row < rows.size(); ++row) {
            ASSERT_EQ(rows[row].size(), head.size()) << example << ", " << rows[row].front();
            for (size_t column = 2; column < head.size(); ++column) {
                if (head[column].starts_with("en")) continue;
                languages.insert(head[column]);
                // In capitals it is a word of the panel, not of the program.
                const std::string source = checks::lowered(rows[row][english]);
                for (const std::string& finding : checks::otherWords(all, source, rows[row][column], head[column]))
                    ADD_FAILURE() << example << ", " << rows[row].front() << ", “" << rows[row][english] << "” in "
                                  << head[column] << ": “" << rows[row][column] << "”; " << finding;
            }
        }
    }
    EXPECT_GE(languages.size(), 10u);
}

} // namespace
