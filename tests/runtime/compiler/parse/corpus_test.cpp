#include "tests/runtime/compiler/parse/outline.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

using namespace plc::parse::testing;
namespace fs = std::filesystem;

namespace {
std::string readFile(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}
} // namespace

/// Every listing is read: its corrected file where there is one (the others are slips, which may not parse).
TEST(Corpus, IsReadAsItsIndexSays) {
    const char* folder = std::getenv("STEPWISE_CORPUS");
    if (!folder) GTEST_SKIP() << "STEPWISE_CORPUS is not set";
    std::set<std::string> fixed;
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / "st")) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".fixed.st")) fixed.insert(name.substr(0, name.size() - 9));
    }
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / "st")) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".decl.st") || name.starts_with("063_") || name.starts_with("226_") ||
            name.starts_with("230_"))
            continue; // templates and drawings
        const bool isFixed = name.ends_with(".fixed.st");
        std::string stem = name.substr(0, name.find('.'));
        if (!isFixed && !name.ends_with(".harness.st") && fixed.contains(stem)) continue;
        std::string text = readFile(entry.path());
        const fs::path frame = fs::path(folder) / "st" / (stem + ".decl.st");
        if (fs::exists(frame) && !name.ends_with(".harness.st")) text = readFile(frame) + text + "\nEND_PROGRAM\n";
        const Parsed parsed(text);
        EXPECT_EQ(parsed.errors(), 0u) << name << " " << parsed.codes();
        EXPECT_FALSE(parsed.file->declarations.empty()) << name;
        ++count;
    }
    EXPECT_GT(count, 150u);
}
