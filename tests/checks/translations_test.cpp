// Every text of the studio has a finished translation in every language, with the placeholders of the original.
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::string sourceFolder = plc::sourceDir();

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
    for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

std::string fromXml(std::string text) {
    constexpr std::array<std::array<const char*, 2>, 5> entities{
        {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}};
    for (const auto& [entity, character] : entities) text = replaced(std::move(text), entity, character);
    return text;
}

struct Message {
    std::string context, source;
    std::vector<std::string> translations; // one per plural form
    bool isPlural = false, isUnfinished = false, isVanished = false;
};

/// What stands between the first <name …> and its end in `text`, without the tags.
std::optional<std::string> element(std::string_view text, const std::string& name) {
    const size_t open = text.find("<" + name);
    if (open == std::string_view::npos) return std::nullopt;
    const size_t begin = text.find('>', open) + 1;
    const size_t end = text.find("</" + name + ">", begin);
    if (end == std::string_view::npos) return std::nullopt;
    return std::string(text.substr(begin, end - begin));
}

Message parseMessage(const std::string& context, std::string_view text) {
    Message message{context, fromXml(element(text, "source").value_or("")), {}};
    message.isPlural = text.substr(0, text.find('>')).find("numerus=\"yes\"") != std::string_view::npos;
    message.isUnfinished = text.find("type=\"unfinished\"") != std::string_view::npos;
    message.isVanished = text.find("type=\"vanished\"") != std::string_view::npos ||
                         text.find("type=\"obsolete\"") != std::string_view::npos;
    const std::string translation = element(text, "translation").value_or("");
    if (!message.isPlural) return message.translations = {fromXml(translation)}, message;
    constexpr std::string_view end = "</numerusform>";
    for (size_t at = 0; (at = translation.find("<numerusform>", at)) != std::string::npos;
         at = translation.find(end, at) + end.size())
        message.translations.push_back(
            fromXml(element(std::string_view(translation).substr(at), "numerusform").value_or("")));
    return message;
}

std::vector<Message> messagesOf(const std::string& language) {
    const std::string text = contentOf(sourceFolder + "/translations/stepwise_" + language + ".ts");
    std::vector<Message> out;
    std::string context;
    for (size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at) {
        if (text.compare(at, 6, "<name>") == 0) context = *element(std::string_view(text).substr(at), "name");
        if (text.compare(at, 8, "<message") != 0) continue;
        const size_t end = text.find("</message>", at);
        out.push_back(parseMessage(context, std::string_view(text).substr(at, end - at)));
        at = end;
    }
    return out;
}

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
    for (const char* folder : {"app", "editor", "hmi", "runtime"})
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
        EXPECT_EQ(message.translations.size(), message.isPlural ? 2u : 1u) << message.source;
        for (const std::string& translation : message.translations) {
            EXPECT_FALSE(translation.empty()) << GetParam() << ", " << message.context << ": " << message.source;
            EXPECT_EQ(placeholders(translation), placeholders(message.source)) << GetParam() << ": " << translation;
        }
    }
}

/// Calls whose first literal a user reads. A text in them must come from tr() or translate().
const std::regex kShownLiteral(
    R"re((?:setText|setWindowTitle|setToolTip|setStatusTip|setWhatsThis|setPlaceholderText|setAccessibleName|setTitle|setSuffix|setHeaderLabels?|setHorizontalHeaderLabels|addAction|addMenu|addTab|addRow|addItems?|addToolBar|addButton|say|setDescription|setLabelText|new QLabel|new QPushButton|new QCheckBox|new QRadioButton|new QGroupBox|new QAction|new QToolBar|new QDockWidget|QMessageBox::\w+\(this|QInputDialog::\w+\(this)[(,{ ]+(?:(?:QStringLiteral|QString|QLatin1String)\()?"((?:[^"\\]|\\.)*)")re");

TEST(ShownTexts, ComeFromTheTranslation) {
    const std::set<std::string> names{"Stepwise", "English", "Deutsch", "Dansk"}; // the same in every language
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

INSTANTIATE_TEST_SUITE_P(Languages, Translations, testing::Values("de", "da"));

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
