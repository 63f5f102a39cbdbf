// Layers hold only where something refuses to cross them (D10): every #include "folder/…" of a module must lie in the
// module itself or in one it declares to use. The declared uses come from the configure step (module_uses.txt).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::map<std::string, std::set<std::string>> declaredUses() {
    std::map<std::string, std::set<std::string>> uses;
    std::ifstream in(std::string(STEPWISE_BINARY_DIR) + "/module_uses.txt");
    for (std::string line; std::getline(in, line);) {
        const size_t colon = line.find(':');
        std::istringstream words(line.substr(colon + 1));
        auto& set = uses[line.substr(0, colon)];
        for (std::string word; words >> word;) set.insert(word);
    }
    return uses;
}

/// What is used may be used through: a module sees what its uses publish.
std::set<std::string> closure(const std::map<std::string, std::set<std::string>>& uses, const std::string& module) {
    std::set<std::string> seen{module};
    for (bool grew = true; grew;) {
        grew = false;
        for (const std::string& each : std::set<std::string>(seen))
            for (const std::string& next : uses.at(each)) grew |= seen.insert(next).second;
    }
    return seen;
}

std::vector<std::string> includesOf(const fs::path& file) {
    std::vector<std::string> out;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        const size_t at = line.find("#include \"");
        if (at != std::string::npos && line.find_first_not_of(" \t") == at)
            out.push_back(line.substr(at + 10, line.find('"', at + 10) - at - 10));
    }
    return out;
}

TEST(Layers, EveryIncludeLiesInADeclaredUse) {
    const auto uses = declaredUses();
    ASSERT_GT(uses.size(), 20u);
    size_t checked = 0;
    for (const auto& [module, direct] : uses) {
        const auto allowed = closure(uses, module);
        if (!fs::is_directory(std::string(STEPWISE_SOURCE_DIR) + "/" + module)) continue;
        for (const auto& entry : fs::directory_iterator(std::string(STEPWISE_SOURCE_DIR) + "/" + module)) {
            const std::string ending = entry.path().extension();
            if (ending != ".h" && ending != ".cpp") continue;
            for (const std::string& include : includesOf(entry.path())) {
                const std::string folder = fs::path(include).parent_path().string();
                if (!uses.contains(folder)) continue; // system header, generated file
                ++checked;
                EXPECT_TRUE(allowed.contains(folder))
                    << entry.path() << " includes " << include << ", but " << module << " does not use " << folder;
            }
        }
    }
    EXPECT_GT(checked, 100u);
}

TEST(Layers, RuntimeAndProjectsKnowNoQt) {
    for (const char* top : {"runtime", "projects"})
        for (const auto& entry : fs::recursive_directory_iterator(std::string(STEPWISE_SOURCE_DIR) + "/" + top)) {
            const std::string ending = entry.path().extension();
            if (ending != ".h" && ending != ".cpp") continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);)
                EXPECT_EQ(line.find("#include <Q"), std::string::npos) << entry.path();
        }
}

TEST(Layers, OnlyCodegenAndJitKnowLlvm) {
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(std::string(STEPWISE_SOURCE_DIR) + "/" + top)) {
            const std::string path = entry.path().generic_string();
            if (path.find("compiler/codegen/") != std::string::npos ||
                path.find("compiler/jit/") != std::string::npos || !entry.is_regular_file())
                continue;
            const std::string ending = entry.path().extension();
            if (ending != ".h" && ending != ".cpp") continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);)
                EXPECT_EQ(line.find("#include <llvm/"), std::string::npos) << path;
        }
}

TEST(Layers, QtChartsIsIncludedByThePlotOnly) {
    for (const char* top : {"editor", "hmi", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(std::string(STEPWISE_SOURCE_DIR) + "/" + top)) {
            const std::string path = entry.path().generic_string();
            if (path.find("editor/kit/plot") != std::string::npos || !entry.is_regular_file()) continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) {
                const bool charts = line.find("#include <QtCharts") != std::string::npos ||
                                    line.find("#include <QChart") != std::string::npos;
                EXPECT_FALSE(charts) << path;
            }
        }
}

} // namespace
