// `stepwise convert`: prints the file in the other language, or writes it; says what has no equivalent; wrong use is
// told as such.
#include "app/cli/command_line.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace plc {
namespace {

const char* const kList =
    "FUNCTION Sum : INT\nVAR_INPUT a, b : INT; END_VAR\n        LD      a\n        ADD     b\n        ST      "
    "Sum\nEND_FUNCTION\n"
    "PROGRAM Main\nVAR x, n : INT; END_VAR\nFOR n := 1 TO x DO x := Sum(x, 1); END_FOR\nEND_PROGRAM\n";

struct Outcome {
    int exitCode = 0;
    std::string out, err;
};

class ConvertCommand : public ::testing::Test {
protected:
    void SetUp() override {
        m_before = std::filesystem::current_path();
        std::filesystem::current_path(m_folder.path().toStdString());
        std::ofstream("units.st", std::ios::binary) << kList;
    }
    void TearDown() override { std::filesystem::current_path(m_before); }
    static std::string text() {
        std::ifstream in("units.st");
        std::stringstream out;
        out << in.rdbuf();
        return out.str();
    }
    static Outcome run(std::vector<std::string> words) {
        words.insert(words.begin(), "convert");
        std::ostringstream out, err;
        std::streambuf *const outBefore = std::cout.rdbuf(out.rdbuf()), *const errBefore = std::cerr.rdbuf(err.rdbuf());
        Outcome outcome;
        outcome.exitCode = cli::runCommandLine(words);
        std::cout.rdbuf(outBefore);
        std::cerr.rdbuf(errBefore);
        outcome.out = out.str();
        outcome.err = err.str();
        return outcome;
    }

private:
    QTemporaryDir m_folder;
    std::filesystem::path m_before;
};

TEST_F(ConvertCommand, PrintsEveryListAsStAndLeavesTheFileAlone) {
    const Outcome outcome = run({"units.st", "--to", "st"});
    EXPECT_EQ(outcome.exitCode, cli::kGood) << outcome.err;
    EXPECT_NE(outcome.out.find("Sum := a + b;"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("ADD"), std::string::npos);
    EXPECT_EQ(text(), kList);
}

TEST_F(ConvertCommand, WritesTheFileThereAndBack) {
    EXPECT_EQ(run({"units.st", "--to", "st", "--unit", "sum", "--write"}).exitCode, cli::kGood);
    EXPECT_NE(text().find("Sum := a + b;"), std::string::npos);
    EXPECT_EQ(run({"units.st", "--to", "il", "--unit", "Sum", "--write"}).exitCode, cli::kGood);
    EXPECT_NE(text().find("ADD     b"), std::string::npos) << text();
}

TEST_F(ConvertCommand, SaysWhatHasNoLikeAndWhatIsWrongUse) {
    const Outcome none = run({"units.st", "--to", "il", "--unit", "Main"});
    EXPECT_EQ(none.exitCode, cli::kProgramWrong);
    EXPECT_NE(none.err.find("FOR with this end or step has no equivalent"), std::string::npos) << none.err;
    EXPECT_EQ(run({"units.st", "--to", "il"}).exitCode, cli::kWrongUse) << "which unit?";
    EXPECT_EQ(run({"units.st", "--to", "ld"}).exitCode, cli::kWrongUse);
    EXPECT_EQ(run({"units.st", "--to", "st", "--unit", "Nobody"}).exitCode, cli::kWrongUse);
    EXPECT_EQ(run({"--to", "st"}).exitCode, cli::kWrongUse);
}

TEST_F(ConvertCommand, WritesHowAUnitLikesToBeShownAndNothingElse) {
    const std::string attribute = "{attribute 'view' := 'ladder'}\n";
    std::string expected(kList);
    expected.insert(expected.find("PROGRAM"), attribute);
    EXPECT_EQ(run({"units.st", "--to", "ld", "--unit", "main"}).out, expected);
    EXPECT_EQ(text(), kList);
    EXPECT_EQ(run({"units.st", "--to", "ld", "--unit", "Main", "--write"}).exitCode, 0);
    EXPECT_EQ(text(), expected);
    EXPECT_EQ(run({"units.st", "--to", "ld", "--unit", "Main", "--write"}).err, "nothing to convert\n");
    EXPECT_EQ(run({"units.st", "--to", "fbd", "--unit", "Main", "--write"}).exitCode, 0);
    expected.replace(expected.find("ladder"), 6, "fbd");
    EXPECT_EQ(text(), expected);
    EXPECT_EQ(run({"units.st", "--to", "fbd"}).exitCode, 2);
    EXPECT_EQ(run({"units.st", "--to", "fbd", "--unit", "Sum"}).exitCode, 2) << "an instruction list";
    EXPECT_EQ(run({"units.st", "--to", "ld", "--unit", "Nothing"}).exitCode, 2);
}

} // namespace
} // namespace plc
