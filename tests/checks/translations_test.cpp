// Every text of the studio has a finished translation in every language, with the placeholders of the original.
#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using plc::checks::contentOf;
using plc::checks::Message;
using plc::checks::messagesOf;

const std::string sourceFolder = plc::sourceDir();

/// Reads a C++ string literal, with the literals right behind it, at `at`; nothing where none stands.
std::optional<std::string> literal(const std::string& code, size_t& at) {
    std::optional<std::string> out;
    for (;;) {
        const size_t quote = code.find_first_not_of(" \t\r\n", at);
        if (quote == std::string::npos || code[quote] != '"') return out;
        if (!out) out.emplace();
        for (at = quote + 1; at < code.size() && code[at] != '"'; ++at) {
            if (code[at] != '\\')
                *out += code[at];
            else if (code[++at] == 'n')
                *out += '\n';
            else
                *out += code[at];
        }
        ++at;
    }
}

/// A text with the context that is written beside it; tr() takes its context from the class and gives "".
struct Use {
    std::string context, source, file;
};

void collectUses(const fs::path& file, std::vector<Use>& out) {
    const std::string code = contentOf(file);
    for (const std::string call : {"tr(", "translate(", "QT_TRANSLATE_NOOP("})
        for (size_t at = 0; (at = code.find(call, at)) != std::string::npos;) {
            const bool isName =
                at > 0 && (std::isalnum(static_cast<unsigned char>(code[at - 1])) || code[at - 1] == '_');
            at += call.size();
            if (isName) continue;
            const std::optional<std::string> first = literal(code, at);
            if (!first) continue;
            if (call == "tr(") {
                if (!first->empty()) out.push_back({"", *first, file.string()});
                continue;
            }
            const size_t comma = code.find_first_not_of(" \t\r\n", at);
            if (comma == std::string::npos || code[comma] != ',') continue;
            at = comma + 1;
            if (const std::optional<std::string> second = literal(code, at))
                out.push_back({*first, *second, file.string()});
        }
}

std::vector<Use> usesInSources() {
    std::vector<Use> out;
    for (const char* folder : {"app", "editor", "hmi", "projects", "runtime"})
        for (const auto& entry : fs::recursive_directory_iterator(sourceFolder + "/" + folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".cpp" || ending == ".h") collectUses(entry.path(), out);
            if (ending == ".def") {
                std::vector<Use> uses;
                collectUses(entry.path(), uses);
                for (Use& use : uses)
                    if (use.source != "sentence with {0}")
                        out.push_back(std::move(use)); // the comment that explains the list
            }
        }
    return out;
}

/// %1, %L2, %n, {0}: the places that are filled in. {1:bit|bits} chooses a form, which a language may not need.
std::set<std::string> placeholders(const std::string& text) {
    std::set<std::string> out;
    for (size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] == '%') {
            const size_t digit = text[i + 1] == 'L' ? i + 2 : i + 1;
            if (digit < text.size() && (std::isdigit(static_cast<unsigned char>(text[digit])) || text[digit] == 'n'))
                out.insert(std::string("%") + text[digit]);
        }
        if (text[i] == '{' && std::isdigit(static_cast<unsigned char>(text[i + 1])) && text.substr(i + 2, 1) == "}")
            out.insert(text.substr(i, 3));
    }
    return out;
}

class Translations : public testing::TestWithParam<const char*> {};

TEST_P(Translations, HaveEveryTextOfTheSources) {
    std::set<std::pair<std::string, std::string>> known;
    for (const Message& message : messagesOf(GetParam())) {
        if (message.isVanished) continue;
        known.emplace(message.context, message.source);
        known.emplace("", message.source);
    }
    const std::vector<Use> uses = usesInSources();
    EXPECT_GT(uses.size(), 500u) << "the sources were not read";
    for (const Use& use : uses)
        EXPECT_TRUE(known.contains({use.context, use.source}))
            << GetParam() << " lacks “" << use.source << "” of " << use.file;
}

TEST_P(Translations, AreFinishedAndKeepThePlaceholders) {
    for (const Message& message : messagesOf(GetParam())) {
        if (message.isVanished) continue;
        EXPECT_FALSE(message.isUnfinished) << GetParam() << ", " << message.context << ": " << message.source;
        const size_t plurals = GetParam() == std::string("zh_CN") ? 1 : 2;
        EXPECT_EQ(message.translations.size(), message.isPlural ? plurals : 1u) << message.source;
        for (const std::string& translation : message.translations) {
            EXPECT_FALSE(translation.empty()) << GetParam() << ", " << message.context << ": " << message.source;
            EXPECT_EQ(placeholders(translation), placeholders(message.source)) << GetParam() << ": " << translation;
        }
    }
}

bool hasAny(const std::string& text, const std::vector<std::string>& parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const std::string& part) { return text.find(part) != std::string::npos; });
}

/// What README.md says of blanks and quotation marks; "" where `text` has them right.
std::string wrongMark(const std::string& language, const std::string& source, const std::string& text) {
    const std::regex unit(R"re((\{\d\}|%L?\d|%n|\d) (px|mm|ms|s|µs|MB|Mo|mA|rad/s|%)($|[ ,.;:)]))re");
    const std::map<std::string, std::vector<std::string>> quotes{{"de", {"”", "«", "»"}},
                                                                 {"da", {"„", "“", "«", "»"}},
                                                                 {"fr", {"„", "“", "”"}},
                                                                 {"es", {"„", "“", "”"}},
                                                                 {"zh_CN", {"„", "«", "»"}}};
    if (hasAny(text, quotes.at(language))) return "another language's quotation marks";
    if (language != "zh_CN" && std::regex_search(text, unit)) return "a blank that breaks before a unit";
    const bool isCode = hasAny(source, {" : ", ":="});
    if (language == "fr" && !isCode && hasAny(text, {" :", " ;", " !", " ?", "« ", " »"})) return "a blank that breaks";
    if (language == "es" && hasAny(text, {"?"}) != hasAny(text, {"¿"})) return "one of ¿ and ? without the other";
    return "";
}

TEST_P(Translations, HaveTheBlanksAndQuotationMarksOfTheirLanguage) {
    EXPECT_NE(wrongMark("fr", "Name:", "Nom :"), "");
    EXPECT_NE(wrongMark("de", "{0} ms late", "{0} ms zu spät"), "");
    EXPECT_EQ(wrongMark("de", "{0} seconds", "{0} Sekunden"), "");
    for (const Message& message : messagesOf(GetParam()))
        for (const std::string& translation : message.translations)
            EXPECT_EQ(wrongMark(GetParam(), message.source, translation), "") << GetParam() << ": " << translation;
}

/// Calls whose first literal a user reads. A text in them must come from tr() or translate().
const std::regex kShownLiteral(
    R"re((?:setText|setWindowTitle|setToolTip|setStatusTip|setWhatsThis|setPlaceholderText|setAccessibleName|setTitle|setSuffix|setHeaderLabels?|setHorizontalHeaderLabels|addAction|addMenu|addTab|addRow|addItems?|addToolBar|addButton|say|setDescription|setLabelText|new QLabel|new QPushButton|new QCheckBox|new QRadioButton|new QGroupBox|new QAction|new QToolBar|new QDockWidget|QMessageBox::\w+\(this|QInputDialog::\w+\(this)[(,{ ]+(?:(?:QStringLiteral|QString|QLatin1String)\()?"((?:[^"\\]|\\.)*)")re");

TEST(ShownTexts, ComeFromTheTranslation) {
    const std::set<std::string> names{"Stepwise", "English",  "Deutsch",
                                      "Dansk",    "Français", "Español"};       // the same in every language
    const std::regex marks(R"re(%L?\d|&\w+;|<[^>]*>|\\.|[MkµG]?B\b|\bms\b)re"); // places, markup and units are no words
    const std::regex word("[A-Za-z]{2,}");
    for (const char* folder : {"app", "editor", "hmi"})
        for (const auto& entry : fs::recursive_directory_iterator(sourceFolder + "/" + folder)) {
            const fs::path& file = entry.path();
            if (file.extension() != ".cpp" && file.extension() != ".h") continue;
            if (file.parent_path().filename() == "cli") continue; // the command line speaks English
            std::ifstream lines(file);
            std::string line;
            for (int number = 1; std::getline(lines, line); ++number) {
                // lupdate does not look through macros: a text behind one of ours is never translated.
                EXPECT_FALSE(line.starts_with("#define") && line.find("TR_NOOP") != std::string::npos)
                    << file << ":" << number;
                EXPECT_FALSE(line.starts_with("#define") && line.find("TRANSLATE_NOOP") != std::string::npos)
                    << file << ":" << number;
                for (auto hit = std::sregex_iterator(line.begin(), line.end(), kShownLiteral);
                     hit != std::sregex_iterator(); ++hit) {
                    const std::string text = (*hit)[1];
                    const bool isText =
                        !names.contains(text) && std::regex_search(std::regex_replace(text, marks, ""), word);
                    EXPECT_FALSE(isText) << file << ":" << number << ": “" << text << "” is shown, but not in tr()";
                }
            }
        }
}

INSTANTIATE_TEST_SUITE_P(Languages, Translations, testing::ValuesIn(plc::checks::kTranslated));

TEST(EnglishPlurals, CoverThePluralsOfTheOtherLanguages) {
    std::set<std::pair<std::string, std::string>> english;
    for (const Message& message : messagesOf("en")) {
        EXPECT_FALSE(message.isUnfinished) << message.source;
        EXPECT_EQ(message.translations.size(), 2u) << message.source;
        for (const std::string& form : message.translations)
            EXPECT_EQ(placeholders(form), placeholders(message.source)) << form;
        english.emplace(message.context, message.source);
    }
    for (const Message& message : messagesOf("de"))
        if (message.isPlural && !message.isVanished) {
            EXPECT_TRUE(english.contains({message.context, message.source})) << message.source;
        }
}

} // namespace
