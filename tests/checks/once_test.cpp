// A function, a type or a constant of a file's own is written once in a module: what two files need has a header. It
// also lets presets that build several files as one (STEPWISE_UNITY) build at all.
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

std::set<std::string> modules() {
    std::set<std::string> names;
    std::ifstream in(plc::binaryDir() + "/module_uses.txt");
    for (std::string line; std::getline(in, line);) names.insert(line.substr(0, line.find(':')));
    return names;
}

/// "std::string_view text, size_t" -> "std::string_view, size_t": names of parameters do not tell functions apart.
std::string typesOf(const std::string& parameters) {
    static const std::regex name(R"(\s*\b\w+\s*(,|$))");
    return std::regex_replace(parameters, name, "$1");
}

/// What a line at the margin of an unnamed namespace declares.
std::optional<std::string> declaredBy(const std::string& line) {
    static const std::regex type(R"(^(?:struct|class|enum class|enum) (\w+)\b.*\{$)");
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

/// What the unnamed namespaces of a file declare.
std::set<std::string> ownNames(std::istream& in) {
    std::set<std::string> names;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (line == "namespace {")
            inside = true;
        else if (line.starts_with("} // namespace"))
            inside = false;
        else if (inside && !line.empty() && line[0] != ' ')
            if (auto name = declaredBy(line)) names.insert(*name);
    }
    return names;
}

TEST(Once, AFilesOwnNamesAreItsOwnInTheModule) {
    const std::set<std::string> known = modules();
    std::map<std::pair<std::string, std::string>, std::set<std::string>> files; // module, name
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            if (entry.path().extension() != ".cpp") continue;
            fs::path folder = fs::relative(entry.path().parent_path(), plc::sourceDir());
            while (!folder.empty() && !known.contains(folder.generic_string())) folder = folder.parent_path();
            std::ifstream in(entry.path());
            for (const std::string& name : ownNames(in))
                files[{folder.generic_string(), name}].insert(entry.path().filename().string());
        }
    EXPECT_GT(files.size(), 2000u);
    for (const auto& [place, where] : files) {
        std::string list;
        for (const std::string& file : where) list += " " + file;
        EXPECT_EQ(where.size(), 1u) << place.first << ": " << place.second << " is written in" << list
                                    << "; share it through a header of the module or give it another name";
    }
}

TEST(Once, TellsNamesFromOtherLines) {
    EXPECT_EQ(declaredBy("bool isDigit(char c) { return c >= '0'; }"), "isDigit(char)");
    EXPECT_EQ(declaredBy("std::string joined(std::string_view a, const std::string& b) {"),
              "joined(std::string_view, const std::string&)");
    EXPECT_EQ(declaredBy("constexpr size_t kMost = 4;"), "constant kMost");
    EXPECT_EQ(declaredBy("struct Reading {"), "type Reading");
    EXPECT_EQ(declaredBy("struct Reading;"), std::nullopt);
    EXPECT_EQ(declaredBy("using tree::Expr;"), std::nullopt);
    EXPECT_EQ(declaredBy("}"), std::nullopt);
}

} // namespace
