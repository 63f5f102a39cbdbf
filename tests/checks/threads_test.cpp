// The thread sanitizer passes over tests that are declared with ONE_THREAD. What they use makes no thread.
#include "tests/checks/module_uses.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

void addAll(const std::map<std::string, std::set<std::string>>& uses, const std::string& module,
            std::set<std::string>& all) {
    const auto found = uses.find(module);
    if (found == uses.end() || !all.insert(module).second) return;
    for (const std::string& used : found->second) addAll(uses, used, all);
}

/// The file of a module that makes a thread; "": none.
std::string makerIn(const std::string& folder, const std::map<std::string, std::set<std::string>>& uses) {
    static const std::regex makes(R"(\bstd::(jthread|thread|async)\b|\bQThread\b|\bQtConcurrent\b|\brunAside\b)");
    for (auto it = fs::recursive_directory_iterator(plc::sourceDir() + "/" + folder); it != fs::end(it); ++it) {
        const std::string path = fs::relative(it->path(), plc::sourceDir()).generic_string();
        if (it->is_directory()) {
            if (uses.contains(path)) it.disable_recursion_pending(); // a module of its own
            continue;
        }
        if (it->path().extension() != ".h" && it->path().extension() != ".cpp") continue;
        if (std::regex_search(contents(it->path()), makes)) return path;
    }
    return {};
}

TEST(Threads, WhatTheThreadSanitizerPassesOverMakesNone) {
    const auto uses = declaredUses();
    const std::string cmake = contents(plc::sourceDir() + "/tests/CMakeLists.txt");
    static const std::regex declared(R"(\nplc_test\((\S+) ONE_THREAD USES ([^)]*)\))");
    size_t tests = 0;
    for (auto it = std::sregex_iterator(cmake.begin(), cmake.end(), declared); it != std::sregex_iterator(); ++it) {
        ++tests;
        std::set<std::string> all;
        std::istringstream words((*it)[2].str());
        for (std::string word; words >> word;) addAll(uses, word, all);
        EXPECT_FALSE(all.empty()) << (*it)[1];
        for (const std::string& module : all)
            EXPECT_EQ(makerIn(module, uses), "") << "tests/" << (*it)[1] << " uses it: remove its ONE_THREAD";
    }
    EXPECT_GT(tests, 5u);
}

} // namespace
