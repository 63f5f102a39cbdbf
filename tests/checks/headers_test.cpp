// The structure is the product's second face: each header begins by saying what it is.
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;

TEST(Headers, BeginByWhatTheyAre) {
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            if (entry.path().extension() != ".h") continue;
            std::ifstream in(entry.path());
            std::string first;
            std::getline(in, first);
            EXPECT_TRUE(first.starts_with("// ") || first.starts_with("/// "))
                << entry.path() << " begins with: " << first;
        }
}

TEST(Texts, NamePathsOfNoMachine) {
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app", "tests", "docs", "translations"}) {
        if (!fs::is_directory(plc::sourceDir() + "/" + top)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            const std::string ending = entry.path().extension();
            if (ending != ".h" && ending != ".cpp" && ending != ".md" && ending != ".st" && ending != ".json") continue;
            if (entry.path().filename() == "headers_test.cpp") continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);)
                EXPECT_EQ(line.find("/work/"), std::string::npos) << entry.path() << ": " << line;
        }
    }
}

} // namespace
