// Layers hold only where something refuses to cross them (D10): a module declares exactly the modules that its files
// include, no fewer (a hidden arrow) and no more (an arrow nobody needs). The declared uses come from the configure
// step (module_uses.txt).
#include "tests/checks/module_uses.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

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

/// The module that `folder` belongs to: itself or the nearest folder above it; empty outside the modules.
std::string moduleOf(const std::map<std::string, std::set<std::string>>& uses, fs::path folder) {
    while (!folder.empty() && !uses.contains(folder.generic_string())) folder = folder.parent_path();
    return folder.generic_string();
}

/// Module -> the modules its sources and headers include.
std::map<std::string, std::set<std::string>> includedModules(const std::map<std::string, std::set<std::string>>& uses) {
    std::map<std::string, std::set<std::string>> included;
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            const std::string ending = entry.path().extension();
            if (ending != ".h" && ending != ".cpp") continue;
            const std::string module = moduleOf(uses, fs::relative(entry.path().parent_path(), plc::sourceDir()));
            for (const std::string& include : includesOf(entry.path())) {
                const std::string used = moduleOf(uses, fs::path(include).parent_path());
                if (!module.empty() && !used.empty() && used != module) included[module].insert(used);
            }
        }
    return included;
}

std::string listed(const std::set<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += " " + name;
    return out;
}

TEST(Layers, DeclaredUsesAreTheIncludedModules) {
    const auto uses = declaredUses();
    ASSERT_GT(uses.size(), 20u);
    const auto included = includedModules(uses);
    size_t checked = 0;
    for (const auto& [module, declared] : uses) {
        const auto found = included.find(module);
        const std::set<std::string> needed = found == included.end() ? std::set<std::string>{} : found->second;
        checked += needed.size();
        EXPECT_EQ(listed(declared), listed(needed))
            << "the USES of " << module << " in its CMakeLists.txt; the second list is right";
    }
    EXPECT_GT(checked, 100u);
}

TEST(Layers, RuntimeAndProjectsKnowNoQt) {
    for (const char* top : {"runtime", "projects"})
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            const std::string ending = entry.path().extension();
            if (ending != ".h" && ending != ".cpp") continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);)
                EXPECT_EQ(line.find("#include <Q"), std::string::npos) << entry.path();
        }
}

TEST(Layers, OnlyCodegenAndJitKnowLlvm) {
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
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
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            const std::string path = entry.path().generic_string();
            if (path.find("editor/plot/painting/") != std::string::npos || !entry.is_regular_file()) continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) {
                const bool charts = line.find("#include <QtCharts") != std::string::npos ||
                                    line.find("#include <QChart") != std::string::npos;
                EXPECT_FALSE(charts) << path;
            }
        }
}

// The thread sanitizer cannot see the locks of Qt's event queue; it sees the one of kit::post. A second door would hide
// races.
TEST(Layers, ThreadsHandOverThroughPostOnly) {
    for (const char* top : {"editor", "hmi", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            const std::string path = entry.path().generic_string();
            const std::string ending = entry.path().extension();
            if ((ending != ".h" && ending != ".cpp") || path.ends_with("editor/kit/post.h")) continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);)
                for (const char* door : {"invokeMethod", "QueuedConnection", "postEvent("})
                    EXPECT_TRUE(line.find(door) == std::string::npos ||
                                line.find("DirectConnection") != std::string::npos)
                        << path << ": use kit::post\n"
                        << line;
        }
}

} // namespace
