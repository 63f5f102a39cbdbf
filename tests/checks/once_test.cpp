// A function, a type or a constant of a file's own is written once in a module: what two files need has a header. It
// also lets presets that build several files as one (STEPWISE_UNITY) build at all.
#include "tests/checks/module_uses.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

/// "std::string_view text, size_t" -> "std::string_view, size_t": names of parameters do not tell functions apart.
std::string typesOf(const std::string& parameters) {
    static const std::regex name(R"(\s*\b\w+\s*(,|$))");
    return std::regex_replace(parameters, name, "$1");
}

/// What a line at the margin of an unnamed namespace declares.
std::optional<std::string> declaredBy(const std::string& line) {
    static const std::regex type(R"(^(?:struct|class|enum class|enum) (\w+)\b.*\{.*$)");
    static const std::regex constant(
        R"(^(?:static )?(?:constexpr |const )[\w:<>,* ]*[ *](\w+)(?:\[\w*\])?(?: =|\{).*)");
    static const std::regex function(R"(^[A-Za-z][\w:<>,&* ]*[ &*](\w+)\(([^()]*)\)?.*)");
    std::smatch match;
    if (std::regex_match(line, match, type)) return "type " + match[1].str();
    if (std::regex_match(line, match, constant)) return "constant " + match[1].str();
    if (line.starts_with("using ") || line.starts_with("template")) return std::nullopt;
    if (std::regex_match(line, match, function)) return match[1].str() + "(" + typesOf(match[2].str()) + ")";
    return std::nullopt;
}

/// What a header declares outside of classes, or the unnamed namespaces of a source.
std::set<std::string> namesIn(const fs::path& file) {
    static const std::regex marks(R"(^(?:\[\[nodiscard\]\] |inline |constexpr (?=.*\())*)");
    std::set<std::string> names;
    const bool isHeader = file.extension() == ".h";
    bool inside = isHeader;
    int lines = 0; // since the unnamed namespace began: a short one ends without its comment
    std::ifstream in(file);
    for (std::string line; std::getline(in, line); ++lines) {
        if (line == "namespace {") {
            inside = true;
            lines = 0;
        } else if (line.starts_with("} // namespace") || (line == "}" && lines <= 2))
            inside = isHeader;
        else if (inside && !line.empty() && line[0] != ' ')
            if (auto name = declaredBy(isHeader ? std::regex_replace(line, marks, "") : line)) names.insert(*name);
    }
    return names;
}

/// Module and name, and the files that declare it.
using Declared = std::map<std::pair<std::string, std::string>, std::set<std::string>>;

Declared declaredIn(const char* ending) {
    const std::map<std::string, std::set<std::string>> known = declaredUses();
    Declared files;
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            if (entry.path().extension() != ending) continue;
            fs::path folder = fs::relative(entry.path().parent_path(), plc::sourceDir());
            while (!folder.empty() && !known.contains(folder.generic_string())) folder = folder.parent_path();
            for (const std::string& name : namesIn(entry.path()))
                files[{folder.generic_string(), name}].insert(entry.path().filename().string());
        }
    return files;
}

TEST(Once, AFilesOwnNamesAreItsOwnInTheModule) {
    const Declared own = declaredIn(".cpp"), shared = declaredIn(".h");
    EXPECT_GT(own.size(), 2000u);
    EXPECT_GT(shared.size(), 1000u);
    for (const auto& [place, where] : own) {
        std::set<std::string> all = where;
        if (const auto header = shared.find(place); header != shared.end())
            all.insert(header->second.begin(), header->second.end());
        std::string list;
        for (const std::string& file : all) list += " " + file;
        EXPECT_EQ(all.size(), 1u) << place.first << ": " << place.second << " is written in" << list
                                  << "; share it through a header of the module or give it another name";
    }
}

TEST(Once, TellsNamesFromOtherLines) {
    EXPECT_EQ(declaredBy("bool isDigit(char c) { return c >= '0'; }"), "isDigit(char)");
    EXPECT_EQ(declaredBy("std::string joined(std::string_view a, const std::string& b) {"),
              "joined(std::string_view, const std::string&)");
    EXPECT_EQ(declaredBy("constexpr size_t kMost = 4;"), "constant kMost");
    EXPECT_EQ(declaredBy("struct Reading {"), "type Reading");
    EXPECT_EQ(declaredBy("std::string trimmed(const std::string& text);"), "trimmed(const std::string&)");
    EXPECT_EQ(declaredBy("struct Reading;"), std::nullopt);
    EXPECT_EQ(declaredBy("using tree::Expr;"), std::nullopt);
    EXPECT_EQ(declaredBy("}"), std::nullopt);
}

} // namespace
