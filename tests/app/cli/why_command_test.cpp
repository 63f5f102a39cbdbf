// Questions an operator would ask of the shipped examples. The answers are in tests/app/cli/why and read aloud well;
// STEPWISE_UPDATE=1 writes them again, for a look.
#include "tests/app/cli/command_fixture.h"
#include "tests/support/paths.h"

#include <cstdlib>

using namespace plc;

namespace {

using Words = std::vector<std::string>;

struct Question {
    const char* name; // of the file with the answer
    const char* project;
    Words words;
};
std::ostream& operator<<(std::ostream& out, const Question& question) { return out << question.name; }

const Question kQuestions[] = {
    {"motor_runs",
     "motor",
     {"IO.K1", "--set", "Plant.StartButton=TRUE@1s", "--set", "Plant.StartButton=FALSE@1500ms", "--at", "2s"}},
    {"motor_does_not_start", "motor", {"IO.K1", "--at", "500ms", "--not"}},
    {"motor_does_not_start_wire",
     "motor",
     {"IO.K1", "--set", "Plant.WireBroken=TRUE", "--set", "Plant.StartButton=TRUE@1s", "--at", "2s", "--not"}},
    {"gravel_fills",
     "gravel",
     {"IO.SiloValve", "--set", "Plant.On=TRUE", "--set", "Plant.On=FALSE@100ms", "--set", "Plant.Fill=TRUE@200ms",
      "--at", "3s"}},
    {"gravel_does_not_fill",
     "gravel",
     {"IO.SiloValve", "--set", "Plant.On=TRUE", "--set", "Plant.On=FALSE@100ms", "--at", "1s", "--not"}},
    {"gravel_control_lamp", "gravel", {"IO.ControlLamp", "--set", "Plant.On=TRUE@500ms", "--at", "1s"}},
    {"mix_valve_b",
     "mix_2_brix",
     {"IO.ValveB", "--set", "Plant.Start=TRUE", "--set", "Plant.Start=FALSE@100ms", "--at", "4s"}},
    {"mix_does_not_start", "mix_2_brix", {"IO.ValveA", "--at", "1s", "--not"}},
    {"mix_belt", "mix_2_brix", {"IO.Belt", "--set", "Plant.Start=TRUE@1s", "--at", "1500ms"}},
    {"tank_does_not_fill", "tank_heating", {"Main.Fill", "--at", "1s", "--not"}},
    {"tank_sequence", "tank_heating", {"Main.Sequence = 0", "--at", "1s"}},
    {"tank_is_empty", "tank_heating", {"Main.Drain", "--at", "1s", "--not"}},
    {"valves_inlet_opens",
     "valves",
     {"IO.InletOpen", "--set", "Plant.Start=TRUE", "--set", "Plant.Start=FALSE@200ms", "--at", "500ms"}},
    {"valves_do_not_start", "valves", {"Main.Run", "--at", "500ms", "--not"}},
    {"valves_sequence", "valves", {"Main.Sequence = 10", "--set", "Plant.Start=TRUE@300ms", "--at", "500ms"}},
    {"car_park_busy",
     "car_park",
     {"Main.Busy", "--set", "Main.Plate='AB 12 345'", "--set", "Main.InsertCar=TRUE@1s", "--set",
      "Main.InsertCar=FALSE@1010ms", "--at", "2s"}},
    {"car_park_robot_goes",
     "car_park",
     {"IO.Go", "--set", "Main.Plate='AB 12 345'", "--set", "Main.InsertCar=TRUE@1s", "--at", "1200ms"}},
    {"car_park_does_not_go", "car_park", {"IO.Go", "--set", "Main.Plate='AB 12 345'", "--at", "1s", "--not"}},
};

/// What is read aloud: without the steps to unfold.
std::string head(const std::string& text) {
    return text.substr(0, std::min(text.find("Step by step"), text.find("What keeps it ")));
}

class WhyCommand : public CommandTest, public ::testing::WithParamInterface<Question> {};

} // namespace

TEST_P(WhyCommand, AnswersWhatAnOperatorAsks) {
    Words words{"why", sourceDir() + "/projects/examples/" + GetParam().project};
    words.insert(words.end(), GetParam().words.begin(), GetParam().words.end());
    const int code = command(words);
    EXPECT_NE(code, cli::kWrongUse) << err;
    const std::string file = sourceDir() + "/tests/app/cli/why/" + GetParam().name + ".txt";
    if (std::getenv("STEPWISE_UPDATE")) std::ofstream(file, std::ios::binary) << head(out);
    std::ifstream in(file);
    std::stringstream expected;
    expected << in.rdbuf();
    EXPECT_EQ(head(out), expected.str());
}

INSTANTIATE_TEST_SUITE_P(Examples, WhyCommand, ::testing::ValuesIn(kQuestions),
                         [](const auto& question) { return std::string(question.param.name); });

class WhyErrors : public CommandTest {};

TEST_F(WhyErrors, SayWhatIsWrong) {
    write("a.st", "PROGRAM Main VAR n : INT; b : BOOL; END_VAR n := n + 1; b := n > 3; END_PROGRAM");
    EXPECT_EQ(command({"why", path("a.st")}), cli::kWrongUse);
    EXPECT_EQ(command({"why", path("a.st"), "Main.nothing"}), cli::kWrongUse);
    EXPECT_NE(err.find("nothing"), std::string::npos) << err;
    EXPECT_EQ(command({"why", path("a.st"), "Main.n", "--not"}), cli::kWrongUse);
    EXPECT_EQ(command({"why", path("a.st"), "Main.b", "--at", "1000000"}), cli::kWrongUse);
    EXPECT_EQ(command({"why", path("missing.rec"), "Main.b"}), cli::kWrongUse);
}

TEST_F(WhyErrors, ARecordingAnswersTheSame) {
    write("a.st", "PROGRAM Main VAR n : INT; b : BOOL; END_VAR n := n + 1; b := n > 3; END_PROGRAM");
    ASSERT_EQ(command({"run", path("a.st"), "--scans", "10", "--record", path("a.rec")}), cli::kGood) << err;
    ASSERT_EQ(command({"why", path("a.rec"), "Main.b"}), cli::kGood) << err;
    EXPECT_NE(out.find("Main.b is TRUE"), std::string::npos) << out;
    EXPECT_NE(out.find("Main.n became 3"), std::string::npos) << out;
    ASSERT_EQ(command({"why", path("a.rec"), "Main.b", "--format", "json"}), cli::kGood);
    EXPECT_NE(out.find("\"verified\":true"), std::string::npos) << out;
    ASSERT_EQ(command({"replay", path("a.rec"), "--writers", "Main.b"}), cli::kGood) << err;
    EXPECT_NE(out.find("Main.b from FALSE to TRUE, set by b := n > 3;"), std::string::npos) << out;
    ASSERT_EQ(command({"replay", path("a.rec"), "--inside", "3"}), cli::kGood) << err;
    EXPECT_NE(out.find("run again exactly as recorded"), std::string::npos) << out;
}

TEST_F(WhyErrors, CoverageOfTestsNamesWhatIsMissing) {
    write("a.st", "PROGRAM Main VAR a, b, q : BOOL; END_VAR\nq := a OR b;\nEND_PROGRAM\n"
                  "TEST 'a alone'\nMain.a := TRUE;\nRUN 2 SCANS;\nASSERT Main.q;\nEND_TEST\n");
    ASSERT_EQ(command({"test", path("a.st"), "--coverage", "mcdc", "--report", path("c.xml")}), cli::kGood)
        << err << out;
    EXPECT_NE(out.find("statements 100.0 %"), std::string::npos) << out;
    EXPECT_NE(out.find("missing b = TRUE"), std::string::npos) << out;
    EXPECT_NE(read("c.xml").find("<coverage line-rate=\"1.0000\""), std::string::npos) << read("c.xml");
    ASSERT_EQ(command({"test", path("a.st"), "--coverage", "mcdc", "--report", path("c.html")}), cli::kGood);
    EXPECT_NE(read("c.html").find("missing: b = TRUE"), std::string::npos);
    EXPECT_EQ(command({"test", path("a.st"), "--coverage", "mcdc", "--report", path("no/folder/c.html")}),
              cli::kWrongUse);
    EXPECT_EQ(out, "") << "refused before a test runs";
    EXPECT_NE(err.find("There is no folder " + path("no/folder") + "; create it"), std::string::npos) << err;
    EXPECT_EQ(command({"test", path("a.st"), "--report", path(".")}), cli::kWrongUse);
    EXPECT_NE(err.find("it is a folder; choose a file"), std::string::npos) << err;
    EXPECT_EQ(command({"test", path("a.st"), "--report", "/dev/full"}), cli::kWrongUse);
    EXPECT_NE(err.find("/dev/full: The file cannot be written: no space left"), std::string::npos) << err;
}
