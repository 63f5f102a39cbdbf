// Every diagnostic has its page: the wrong program causes it, the right one is right, and docs/diagnostics.md shows
// both.
#include "projects/analysis/explanation.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace plc;

namespace {

TEST(Explanation, EveryCodeHasAProgramThatEarnsItAndOneThatIsRight) {
    for (const std::string_view code : analysis::diagnosticCodes()) {
        const auto shown = analysis::explain(code);
        ASSERT_TRUE(shown) << code;
        EXPECT_FALSE(shown->findings.empty()) << code << " is not what the checker says of\n" << shown->wrong;
        EXPECT_NE(shown->right, "") << code;
        const driver::Checked right = driver::check({{{"right.st", std::string(shown->right)}}, {}});
        for (const diagnostics::Diagnostic& each : right.analysis->diagnostics) {
            EXPECT_NE(diagnostics::codeOf(each.kind), code) << shown->right;
            EXPECT_NE(each.severity, diagnostics::Severity::Error)
                << code << ": the right program has " << diagnostics::codeOf(each.kind) << "\n"
                << shown->right;
        }
    }
}

TEST(Explanation, CodesAreFoundInEitherCaseAndUnknownOnesAreNot) {
    EXPECT_TRUE(analysis::explain("p2001"));
    EXPECT_FALSE(analysis::explain("P9999"));
    EXPECT_FALSE(analysis::explain(""));
}

TEST(Explanation, AWatchIsExplainedByWhatItMayNotHold) {
    const auto shown = analysis::explain("P2035");
    ASSERT_TRUE(shown);
    ASSERT_EQ(shown->findings.size(), 1u);
    EXPECT_FALSE(shown->findings[0].range.file.isValid());
    EXPECT_NE(shown->findings[0].message.english().find("side effects"), std::string::npos);
}

TEST(Explanation, LinesAreNumberedAsTheCheckerCountsThem) {
    EXPECT_EQ(analysis::numbered("a\n\nb\n"), "   1 | a\n   2 | \n   3 | b\n");
    EXPECT_EQ(analysis::numbered("a"), "   1 | a\n");
    EXPECT_EQ(analysis::numbered(""), "");
}

TEST(Explanation, TheReferenceIsCheckedInAsItWouldBeWritten) {
    std::ifstream file(sourceDir() + "/docs/diagnostics.md", std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_TRUE(text.str() == analysis::diagnosticsReference()) << "stale: run `stepwise doc diagnostics`";
}

} // namespace
