// `stepwise explain`: what a code means, by a wrong and a right program.
#include "tests/app/cli/command_fixture.h"

using namespace plc;

namespace {

using ExplainTest = CommandTest;

TEST_F(ExplainTest, ShowsWhatTheCheckerSaysAndBothPrograms) {
    EXPECT_EQ(command({"explain", "p2001"}), cli::kGood) << err;
    EXPECT_NE(out.find("error P2001: y is not declared"), std::string::npos) << out;
    const size_t wrong = out.find("\nWrong:\n"), right = out.find("\nRight:\n");
    ASSERT_NE(wrong, std::string::npos) << out;
    ASSERT_NE(right, std::string::npos) << out;
    EXPECT_LT(wrong, right);
    EXPECT_NE(out.find("x := y;", wrong), std::string::npos) << out;
}

TEST_F(ExplainTest, WithoutACodeListsAll) {
    EXPECT_EQ(command({"explain"}), cli::kGood) << err;
    for (const char* code : {"P1001  ", "P2035  ", "P3025  ", "P4005  ", "P6001  "})
        EXPECT_NE(out.find(code), std::string::npos) << code << "\n" << out;
}

TEST_F(ExplainTest, AnUnknownCodeSaysWhereTheOthersAre) {
    EXPECT_EQ(command({"explain", "P9999"}), cli::kWrongUse);
    EXPECT_NE(err.find("There is no code P9999; stepwise explain lists all of them"), std::string::npos) << err;
}

TEST_F(ExplainTest, TheReferenceIsWrittenOnceAndStaleOnesAreReported) {
    EXPECT_EQ(command({"doc", "diagnostics", "--out", path("")}), cli::kGood) << err;
    EXPECT_NE(read("diagnostics.md").find("## P3025"), std::string::npos);
    EXPECT_EQ(command({"doc", "diagnostics", "--out", path(""), "--check"}), cli::kGood) << err;
    write("diagnostics.md", "old");
    EXPECT_EQ(command({"doc", "diagnostics", "--out", path(""), "--check"}), cli::kProgramWrong);
    EXPECT_NE(err.find("is stale"), std::string::npos) << err;
}

} // namespace
