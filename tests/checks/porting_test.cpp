// docs/porting.md names every source that needs a POSIX system: whoever adds one says what another system would use.
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Whether the page names the file: with its folder, alone behind another of the same folder, or as part of a folder.
bool isNamed(const std::string& page, const fs::path& relative) {
    return page.find("`" + relative.generic_string() + "`") != std::string::npos ||
           page.find("`" + relative.filename().string() + "`") != std::string::npos ||
           page.find("`" + relative.parent_path().generic_string() + "`") != std::string::npos;
}

} // namespace

TEST(Porting, EverySourceThatNeedsPosixIsListed) {
    const std::string page = textOf(plc::sourceDir() + "/docs/porting.md");
    const std::regex posix(
        "#include <(unistd\\.h|sys/[a-z/]+\\.h|fcntl\\.h|poll\\.h|sched\\.h|signal\\.h|pty\\.h|dlfcn\\.h|pthread\\.h|"
        "termios\\.h|dirent\\.h|netdb\\.h|netinet/[a-z]+\\.h|arpa/inet\\.h|setjmp\\.h|csetjmp)>");
    size_t found = 0;
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top)) {
            if (entry.path().extension() != ".cpp" || !std::regex_search(textOf(entry.path()), posix)) continue;
            ++found;
            const fs::path relative = fs::relative(entry.path(), plc::sourceDir());
            EXPECT_TRUE(isNamed(page, relative))
                << relative << " includes a header of POSIX: add it to docs/porting.md";
        }
    EXPECT_GT(found, 10u) << "the search finds nothing";
}
