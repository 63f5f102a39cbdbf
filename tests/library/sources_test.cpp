// The table of library texts in the binary.
#include "runtime/compiler/format/format.h"
#include "runtime/library/sources.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace plc::test {
namespace {

TEST(LibrarySources, AreTheFilesOfTheFolder) {
    const std::string folder = plc::sourceDir() + "/runtime/library/st/";
    size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        files += entry.path().extension() == ".st";
    EXPECT_EQ(library::sources().size(), files);
    for (const library::Source& source : library::sources()) {
        std::ifstream file(folder + std::string(source.library) + "/" + std::string(source.fileName), std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        EXPECT_EQ(text.str(), source.text) << source.library << '/' << source.fileName;
    }
}

TEST(LibrarySources, AreFoundByNameInAnyCase) {
    EXPECT_EQ(library::libraries(),
              (std::vector<std::string_view>{"analog", "plant", "standard", "toolbox", "util", "workshop"}));
    EXPECT_FALSE(library::sourcesOf("ToolBox").empty());
    EXPECT_TRUE(library::sourcesOf("tool").empty());
    for (const library::Source& source : library::sourcesOf("Plant")) EXPECT_EQ(source.library, "plant");
    EXPECT_EQ(library::namespaceOf("toolbox"), "Toolbox");
    EXPECT_EQ(library::namespaceOf("UTIL"), "Util");
}

TEST(LibrarySources, AreFormatted) {
    for (const library::Source& source : library::sources())
        EXPECT_TRUE(format::format(source.text, {}) == source.text)
            << source.library << '/' << source.fileName << ": run `stepwise fmt`";
}

} // namespace
} // namespace plc::test
