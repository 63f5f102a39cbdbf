// docs/testing.md names tests: each of them exists.
#include "tests/checks/ts_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;
using plc::checks::contentOf;

std::set<std::string> testsThatExist() {
    const std::regex test(R"(\nTEST(?:_F|_P)?\((\w+), (\w+)\))");
    std::set<std::string> out;
    for (const auto& each : fs::recursive_directory_iterator(plc::sourceDir() + "/tests")) {
        if (each.path().extension() != ".cpp") continue;
        const std::string text = "\n" + contentOf(each.path());
        for (auto hit = std::sregex_iterator(text.begin(), text.end(), test); hit != std::sregex_iterator(); ++hit)
            out.insert((*hit)[1].str() + "." + (*hit)[2].str());
    }
    return out;
}

TEST(TestingPage, NamesTestsThatExistAndATestForEachPromise) {
    const std::string page = contentOf(plc::sourceDir() + "/docs/testing.md");
    const std::string promises = page.substr(std::min(page.size(), page.find("\n## Promises and their tests")));
    const std::set<std::string> tests = testsThatExist();
    ASSERT_GT(tests.size(), 1000u) << "the sources were not read";
    const std::regex row(R"(\n\| ([A-D]\d+) \|([^\n]*))"), name(R"(`([A-Z]\w+\.[A-Z]\w+)`)");
    size_t rows = 0;
    for (auto hit = std::sregex_iterator(promises.begin(), promises.end(), row); hit != std::sregex_iterator();
         ++hit, ++rows) {
        const std::string text = (*hit)[2];
        size_t named = 0;
        for (auto test = std::sregex_iterator(text.begin(), text.end(), name); test != std::sregex_iterator();
             ++test, ++named)
            EXPECT_TRUE(tests.contains((*test)[1])) << (*hit)[1] << ": there is no test " << (*test)[1];
        EXPECT_GT(named, 0u) << (*hit)[1];
    }
    EXPECT_EQ(rows, 30u) << "A1 to A9, B1 to B6, C1 to C10, D1 to D5";
}

} // namespace
