// `stepwise ladder`: draws a unit in characters and as SVG, as the unit prefers or as it is asked, and measures how
// much of a project has a picture; wrong use is reported as such.
#include "app/cli/command_line.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace plc {
namespace {

const char* const kText = "PROGRAM Main\nVAR start, stop, motor : BOOL; T1 : TON; END_VAR\n"
                          "// holds itself\nmotor := (start OR motor) AND NOT stop;\n"
                          "T1(IN := motor, PT := T#3s);\nEND_PROGRAM\n"
                          "{attribute 'view' := 'fbd'}\nFUNCTION Both : BOOL\nVAR_INPUT a, b : BOOL; END_VAR\n"
                          "Both := a AND b;\nEND_FUNCTION\n";

struct Outcome {
    int exitCode = 0;
    std::string out, err;
};

class LadderCommand : public ::testing::Test {
protected:
    void SetUp() override {
        m_before = std::filesystem::current_path();
        std::filesystem::current_path(m_folder.path().toStdString());
        std::ofstream("units.st", std::ios::binary) << kText;
    }
    void TearDown() override { std::filesystem::current_path(m_before); }
    static std::string contentOf(const char* file) {
        std::ifstream in(file, std::ios::binary);
        std::stringstream out;
        out << in.rdbuf();
        return out.str();
    }
    static Outcome run(std::vector<std::string> words) {
        words.insert(words.begin(), "ladder");
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

TEST_F(LadderCommand, DrawsARungInCharacters) {
    const Outcome outcome = run({"units.st", "--pou", "main"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const char* const parts[] = {"     holds itself\n   1 │", "│└──┤ ├──┘", "┤/├─", "─( )─", "motor↺", "T#3s ─┤PT"};
    for (const char* part : parts) EXPECT_NE(outcome.out.find(part), std::string::npos) << part << "\n" << outcome.out;
    EXPECT_EQ(contentOf("units.st"), kText);
}

TEST_F(LadderCommand, DrawsAsTheUnitPrefersUnlessItIsAsked) {
    EXPECT_NE(run({"units.st", "--pou", "Both"}).out.find("┌AND"), std::string::npos);
    EXPECT_EQ(run({"units.st", "--pou", "Both", "--ld"}).out.find("┌AND"), std::string::npos);
    EXPECT_NE(run({"units.st", "--pou", "Main", "--fbd"}).out.find("┌OR"), std::string::npos);
}

TEST_F(LadderCommand, WritesAPictureAndNothingElse) {
    const Outcome outcome = run({"units.st", "--pou", "Main", "--picture", "main.svg"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const std::string svg = contentOf("main.svg");
    EXPECT_TRUE(svg.starts_with("<svg ") && svg.ends_with("</svg>\n")) << svg.substr(0, 80);
    EXPECT_NE(svg.find(">T#3s<"), std::string::npos);
    EXPECT_EQ(run({"units.st", "--pou", "Main", "--picture", "main.png"}).exitCode, 2);
    EXPECT_FALSE(run({"units.st", "--pou", "Main", "--picture", "again.svg", "--text"}).out.empty());
}

TEST_F(LadderCommand, ShowsAddressesAndCommentsAndCircuitSymbolsAsAsked) {
    std::ofstream("units.st", std::ios::binary) << "PROGRAM Main\nVAR\n    start AT %IX0.3 : BOOL; // the green "
                                                   "button\n    y : BOOL;\nEND_VAR\ny := NOT start;\n"
                                                   "END_PROGRAM\n";
    EXPECT_EQ(run({"units.st", "--pou", "Main"}).out.find("%IX0.3"), std::string::npos);
    const Outcome both = run({"units.st", "--pou", "Main", "--show", "both", "--comments"});
    EXPECT_NE(both.out.find("start"), std::string::npos);
    EXPECT_NE(both.out.find("%IX0.3"), std::string::npos) << both.out;
    EXPECT_NE(both.out.find("the green button"), std::string::npos) << both.out;
    const Outcome addresses = run({"units.st", "--pou", "Main", "--show", "addresses"});
    EXPECT_EQ(addresses.out.find("start"), std::string::npos) << addresses.out;
    EXPECT_NE(addresses.out.find("y"), std::string::npos) << "without an address its name stays";
    EXPECT_EQ(run({"units.st", "--pou", "Main", "--picture", "bars.svg"}).exitCode, 0);
    EXPECT_EQ(run({"units.st", "--pou", "Main", "--picture", "circuit.svg", "--symbols", "circuit"}).exitCode, 0);
    EXPECT_NE(contentOf("bars.svg"), contentOf("circuit.svg"));
    EXPECT_EQ(run({"units.st", "--pou", "Main", "--symbols", "round"}).exitCode, 2);
    EXPECT_EQ(run({"units.st", "--pou", "Main", "--show", "nothing"}).exitCode, 2);
}

TEST_F(LadderCommand, MeasuresHowMuchHasAPicture) {
    const Outcome outcome = run({"units.st", "--share"});
    EXPECT_EQ(outcome.out, "units.st: 3 statements, 100.0 % drawn, 0.0 % frames, 0.0 % text\n"
                           "total: 2 units, 3 statements, 100.0 % drawn, 0.0 % frames, 0.0 % text\n");
}

TEST_F(LadderCommand, DrawsAProgramWithErrors) {
    std::ofstream("units.st", std::ios::binary)
        << "PROGRAM Main\nVAR a : BOOL; END_VAR\na := unknown AND a;\nb := ;\nEND_PROGRAM\n";
    const Outcome outcome = run({"units.st", "--pou", "Main"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("unknown"), std::string::npos);
    EXPECT_NE(outcome.out.find("│ b := ;   │"), std::string::npos) << outcome.out;
}

TEST_F(LadderCommand, SaysWhatIsWrongWithItsUse) {
    EXPECT_EQ(run({}).exitCode, 2);
    EXPECT_NE(run({"units.st"}).err.find("--pou NAME"), std::string::npos);
    const Outcome unknown = run({"units.st", "--pou", "Mein"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("did you mean Main?"), std::string::npos) << unknown.err;
    EXPECT_EQ(run({"nowhere", "--pou", "Main"}).exitCode, 2);
}

} // namespace
} // namespace plc
