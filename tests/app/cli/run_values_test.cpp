// Values that enter and leave on the command line: what --set takes and refuses (with a remedy), what a CSV and the
// report show, files named twice or damaged, and the example of every command's help.
#include "app/cli/kit/arguments.h"
#include "tests/app/cli/command_fixture.h"
#include "tests/support/paths.h"

#include <filesystem>
#include <set>

namespace plc {
namespace {

namespace fs = std::filesystem;

const char* const kTypes = R"(TYPE
    Color : (Red, Green, Blue := 7);
    Point : STRUCT x : INT; y : REAL; END_STRUCT;
    Small : INT (0..10);
END_TYPE
PROGRAM Main
VAR
    b : BOOL; x : INT; r : REAL; lr : LREAL; s : STRING(12); ws : WSTRING(5); t : TIME; d : DATE; c : Color; p : Point;
    a : ARRAY[1..3] OF INT; small : Small; ch : CHAR; wch : WCHAR; n : INT; w : WORD;
END_VAR
n := n + 1;
END_PROGRAM
)";

class RunValues : public CommandTest {
protected:
    void SetUp() override { write("main.st", kTypes); }
    int run(std::vector<std::string> words) {
        words.insert(words.begin(), {"run", path("main.st"), "--scans", "3"});
        return command(words);
    }
    /// The value after --set, as JSON.
    std::string after(const std::string& variable, const std::string& value) {
        if (run({"--format", "json", "--watch", "Main." + variable, "--set", "Main." + variable + "=" + value}) != 0)
            return err;
        const std::string head = "\"Main." + variable + "\":";
        const size_t begin = out.find(head) + head.size();
        return out.substr(begin, out.find("},\"fault\"") - begin);
    }
};

} // namespace

TEST_F(RunValues, WholeArraysStructsCharactersAndNumbersBeyondAllAreWrittenAsTheyAreShown) {
    EXPECT_EQ(after("ch", "'A'"), "\"A\"");
    EXPECT_EQ(after("wch", "\"Ω\""), "\"Ω\"");
    EXPECT_EQ(after("a", "[1, 2, 3]"), "[1,2,3]");
    EXPECT_EQ(after("p", "(x := 3, y := 2.5)"), "{\"x\":3,\"y\":2.5}");
    EXPECT_EQ(after("lr", "NaN"), "\"NaN\"");
    EXPECT_EQ(after("r", "-INF"), "\"-INF\"");
    EXPECT_EQ(after("b", "1"), "true");
    EXPECT_EQ(after("x", "2.0"), "2");
    EXPECT_EQ(after("c", "blue"), "\"Blue\"");
    EXPECT_EQ(after("w.3", "TRUE"), "true");
    EXPECT_EQ(after("s", "'a@b,\"c\"'"), "\"a@b,\\\"c\\\"\"");
}

TEST_F(RunValues, WhatAValueWouldLoseIsRefusedAndTheMessageSaysWhatToWrite) {
    const struct {
        const char *write, *remedy;
    } rows[] = {
        {"Main.x=1.5", "1.5 does not fit into Main.x, which is INT; write an integer"},
        {"Main.x=TRUE", "write an integer"},
        {"Main.x=70000", "70000 does not fit into Main.x"},
        {"Main.b=5", "5 does not fit into Main.b, which is BOOL; write TRUE or FALSE"},
        {"Main.r=1e39", "1e39 does not fit into Main.r"},
        {"Main.s=hello", "hello is not a value for Main.s, which is STRING(12); write it in quotes, for example "
                         "'text'; only WSTRING has every character"},
        {"Main.c=Bleu", "did you mean Blue?"},
        {"Main.c=Yellow", "its values are Red, Green, Blue"},
        {"Main.t=5s", "write for example T#1s500ms"},
        {"Main.d=D#2020-02-30", "write for example D#2026-01-31"},
        {"Main.ch='AB'", "write one character in quotes"},
        {"Main.a=[1,2,3,4]", "write all elements"},
        {"Main.small=11", "11 is outside 0..10; enter a value in this range"},
        {"Main.a[4]=1", "index 4 is outside 1..3; use an index in this range or enlarge the array"},
        {"Mian.x=1", "did you mean"},
    };
    for (const auto& row : rows) {
        EXPECT_EQ(run({"--set", row.write}), 2) << row.write << "\n" << out;
        EXPECT_NE(err.find(row.remedy), std::string::npos) << row.write << "\n" << err;
    }
}

TEST_F(RunValues, ARunThatEndsBeforeItsConditionSaysSo) {
    EXPECT_EQ(run({"--until", "Main.n > 100"}), 0);
    EXPECT_NE(err.find("--until Main.n > 100 did not become true"), std::string::npos) << err;
    EXPECT_EQ(run({"--until", "Main.n = 2"}), 0);
    EXPECT_EQ(err.find("did not become true"), std::string::npos) << err;
    EXPECT_EQ(run({"--until", "Main.a[Main.n + 3] > 5"}), 0);
    EXPECT_NE(err.find("has no value: index 6"), std::string::npos) << err;
}

TEST_F(RunValues, ACharacterIsACellWithoutQuotesAsATextIs) {
    EXPECT_EQ(run({"--csv", path("x.csv"), "--watch", "Main.ch", "--watch", "Main.s", "--set", "Main.ch=','", "--set",
                   "Main.s='a\"b'"}),
              0)
        << err;
    EXPECT_EQ(read("x.csv").substr(0, 44), "time_s,scan,Main.ch,Main.s\r\n0,0,\",\",\"a\"\"b\"\r\n");
}

TEST_F(RunValues, GlobalsOfANamespaceAreAmongTheValues) {
    write("space.st", "NAMESPACE Plant\nVAR_GLOBAL\n    level : INT;\nEND_VAR\nEND_NAMESPACE\n"
                      "PROGRAM Main\nPlant.level := Plant.level + 1;\nEND_PROGRAM\n");
    EXPECT_EQ(command({"run", path("space.st"), "--scans", "3", "--format", "json"}), 0);
    EXPECT_NE(out.find("\"Plant.space.level\":3"), std::string::npos) << out;
}

TEST_F(RunValues, AnArrayOfTwoHundredMegabytesIsNotPrinted) {
    write("huge.st", "PROGRAM Main\nVAR t : ARRAY[0..200000000] OF BYTE; n : INT := 3; END_VAR\nt[5] := 1;\n"
                     "n := n;\nEND_PROGRAM\n");
    EXPECT_EQ(command({"run", path("huge.st"), "--scans", "1"}), 0) << err;
    EXPECT_LT(out.size(), 10'000u);
    EXPECT_NE(out.find("too many to show"), std::string::npos) << out.substr(0, 2000);
    EXPECT_NE(out.find("Main.n  3"), std::string::npos) << out.substr(0, 2000);
}

TEST_F(RunValues, AFileNamedTwiceIsOneFile) {
    fs::create_symlink("main.st", path("link.st"));
    EXPECT_EQ(command({"check", path("main.st"), path("main.st"), path("link.st")}), 0) << err;
}

TEST_F(RunValues, AFaultOfInitialValuesSaysSo) {
    write("init.st",
          "FUNCTION_BLOCK B\nVAR x : DINT; END_VAR\nMETHOD FB_Init : BOOL\nVAR_INPUT bInitRetains, bInCopyCode "
          ": BOOL; END_VAR\nx := 1 / x;\nEND_METHOD\nEND_FUNCTION_BLOCK\nPROGRAM Main\nVAR b : B; "
          "END_VAR\nb();\nEND_PROGRAM\n");
    EXPECT_EQ(command({"run", path("init.st"), "--scans", "1"}), 1);
    EXPECT_NE(out.find("  while initial values were applied, at " + path("init.st") + ":5\n"), std::string::npos)
        << out;
    EXPECT_NE(out.find("  B.FB_Init (Main.b) at "), std::string::npos) << out;
    EXPECT_EQ(out.find("in task "), std::string::npos) << out;
    EXPECT_EQ(out.find(" at \n"), std::string::npos) << out;
}

TEST_F(RunValues, TheEndsOfALongCallPathAreShown) {
    write("deep.st",
          "INTERFACE Deeper\nMETHOD go : INT\nEND_METHOD\nEND_INTERFACE\n"
          "FUNCTION_BLOCK Hole IMPLEMENTS Deeper\nVAR_INPUT\n    next : Deeper;\nEND_VAR\n"
          "METHOD go : INT\ngo := next.go();\nEND_METHOD\nEND_FUNCTION_BLOCK\n"
          "PROGRAM Main\nVAR\n    hole : Hole;\n    x : INT;\nEND_VAR\nhole(next := hole);\nx := hole.go();\n"
          "END_PROGRAM\n");
    EXPECT_EQ(command({"run", path("deep.st"), "--scans", "1"}), 1);
    EXPECT_NE(out.find(" more calls …"), std::string::npos) << out;
    EXPECT_NE(out.find("  Main (Main) at "), std::string::npos) << out;
    EXPECT_LT(std::count(out.begin(), out.end(), '\n'), 40);
}

TEST_F(RunValues, AFolderThatIsNotThereIsToldBeforeTheRunAndAFullValueOfItAfter) {
    for (const char* option : {"--retain", "--record"}) {
        EXPECT_EQ(run({option, path("none/x")}), 2);
        EXPECT_NE(err.find("create " + path("none")), std::string::npos) << err;
        EXPECT_EQ(out, "");
    }
    fs::create_directory(path("folder"));
    EXPECT_EQ(run({"--retain", path("folder"), "--watch", "Main.n"}), 2);
    EXPECT_NE(out.find("Main.n  3"), std::string::npos) << "the values are worth more than the file\n" << out;
}

TEST_F(RunValues, WhatIsNoRetainFileIsKeptAside) {
    write("retain", "a text of mine");
    EXPECT_EQ(run({"--retain", path("retain")}), 0);
    EXPECT_NE(err.find("it is kept as " + path("retain.damaged")), std::string::npos) << err;
    EXPECT_EQ(read("retain.damaged"), "a text of mine");
    EXPECT_TRUE(fs::exists(path("retain")));
}

TEST_F(RunValues, TheDifferenceOfAMissingLineEndIsShown) {
    write("last.st", "PROGRAM Main\nEND_PROGRAM");
    EXPECT_EQ(command({"fmt", "--check", path("last.st")}), 1);
    EXPECT_NE(out.find("-END_PROGRAM (no line end)\n+END_PROGRAM\n"), std::string::npos) << out;
}

TEST_F(RunValues, TheExampleOfEveryHelpWorks) {
    fs::create_directory_symlink(plc::sourceDir() + "/projects", path("projects"));
    const fs::path before = fs::current_path();
    fs::current_path(path("."));
    write("plc.xml",
          "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous><pou name=\"Main\" "
          "pouType=\"program\"><interface/><body><ST><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">;</xhtml></ST>"
          "</body></pou></pous></types><instances><configurations/></instances></project>");
    std::vector<std::string> examples;
    // serve ends when it is stopped (ServeTest); people asks for a password, alarms for a journal (PanelsCommands);
    // lsp, dap and mcp talk to a client (tests/app/editors), attach to a server (tests/app/serve)
    const std::set<std::string_view> elsewhere{"serve", "people", "alarms", "lsp", "dap", "mcp", "attach"};
    for (const cli::Command& each : cli::commands())
        if (!elsewhere.contains(each.spec.name)) examples.emplace_back(each.spec.example);
    std::stable_partition(examples.begin(), examples.end(), // what it records is looked into by another
                          [](const std::string& text) { return text.find(" run ") != std::string::npos; });
    for (const std::string& example : examples) {
        std::vector<std::string> words;
        std::string word;
        bool isQuoted = false;
        for (const char c : example + " ") {
            if (c == '\'')
                isQuoted = !isQuoted;
            else if (c != ' ' || isQuoted)
                word += c;
            else if (!word.empty())
                words.push_back(std::exchange(word, {}));
        }
        words.erase(words.begin()); // stepwise
        EXPECT_EQ(command(words), 0) << example << "\n" << out.substr(0, 2000) << err;
    }
    fs::current_path(before);
}

} // namespace plc
