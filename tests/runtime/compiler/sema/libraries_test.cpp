#include "tests/runtime/compiler/sema/checked.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

using namespace plc;
using namespace plc::sema_test;

TEST(Libraries, EachChecksWithoutAWord) {
    for (const std::string_view name : library::libraries()) {
        std::vector<Source> files;
        for (const library::Source& source : library::sourcesOf(name)) files.push_back({std::string(source.library) + "/" + std::string(source.fileName), std::string(source.text), library::namespaceOf(name)});
        const CheckedText checked = check(files, name != "standard");
        std::string text;
        for (const diagnostics::Diagnostic& diagnostic : checked.analysis->diagnostics)
            if (diagnostic.severity != diagnostics::Severity::Info) text += diagnostics::renderText(*checked.sources, diagnostic, false);
        EXPECT_EQ(text, "") << name;
    }
}

/// Set STEPWISE_CHECK to a list of files to see what is said about them.
TEST(Libraries, ShowsWhatIsSaidAboutAFile) {
    const char* names = std::getenv("STEPWISE_CHECK");
    if (!names) GTEST_SKIP() << "STEPWISE_CHECK names no files";
    std::istringstream list(names);
    std::vector<Source> files;
    for (std::string path; list >> path;) {
        std::ifstream in(path, std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        files.push_back({path, text.str(), ""});
    }
    const auto begin = std::chrono::steady_clock::now();
    const CheckedText checked = check(files);
    std::cout << checked.all() << std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() << " ms\n";
}
