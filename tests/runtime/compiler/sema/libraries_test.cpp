#include "tests/runtime/compiler/sema/checked.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::sema_test;

TEST(Libraries, EachChecksWithoutAWord) {
    for (const std::string_view name : library::libraries()) {
        std::vector<Source> files;
        for (const library::Source& source : library::sourcesOf(name))
            files.push_back({std::string(source.library) + "/" + std::string(source.fileName), std::string(source.text),
                             library::namespaceOf(name)});
        const CheckedText checked = check(files, name != "standard");
        std::string text;
        for (const diagnostics::Diagnostic& diagnostic : checked.analysis->diagnostics)
            if (diagnostic.severity != diagnostics::Severity::Info)
                text += diagnostics::renderText(*checked.sources, diagnostic, false);
        EXPECT_EQ(text, "") << name;
    }
}
