// One layout for all sources: what clang-format (Debian 12's, version 14) makes of them by the .clang-format at the
// root.
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace {

/// What `command` prints, and its exit code behind it.
std::string outputOf(const std::string& command) {
    std::string out;
    FILE* pipe = popen((command + " 2>&1; echo exit $?").c_str(), "r");
    std::array<char, 4096> piece;
    while (size_t size = std::fread(piece.data(), 1, piece.size(), pipe)) out.append(piece.data(), size);
    pclose(pipe);
    return out;
}

TEST(Format, SourcesAreLaidOutByClangFormat) {
    const std::string find =
        "cd '" + plc::sourceDir() + "' && find runtime projects editor hmi app tests -name '*.cpp' -o -name '*.h'";
    EXPECT_EQ(outputOf(find + " | xargs -P 2 -n 80 clang-format-14 --dry-run -Werror"), "exit 0\n")
        << "fix with: clang-format-14 -i FILE…";
}

} // namespace
