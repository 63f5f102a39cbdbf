// Each controller block through `stepwise run --csv` and `stepwise tune`: the table gives the same model as the project
// itself, and the settings come in the block's own parameters.
#include "tests/app/cli/command_fixture.h"

#include <nlohmann/json.hpp>

#include <cmath>

using namespace plc;

namespace {

struct Block {
    const char* name;
    const char* loop;
    const char* library;
    const char* declaration;
    const char* call;
    const char* output;                // of the block that is tuned
    const char* setPoint;              // of that loop
    double gain, lag;                  // of its process
    std::vector<const char*> variable; // that the parameters are written to
};

/// In the names that CTest lists.
void PrintTo(const Block& block, std::ostream* out) { *out << block.name; }

const char* const kCascade =
    "c : FB_PI_PID; inner : stPIPIDOutLoop := (rKp := 0.8, tTn := T#600ms, tTd := T#60ms, rMaxLim := 1000.0, rMinLim "
    ":= -1000.0); outer : stPIPIDInLoop := (tCyclTime := T#10ms, rKp := 0.5, tTn := T#4s, rMaxLim := 100.0, rMinLim "
    ":= -100.0);";
/// The inner loop's process is the drive's lag, the outer one's follows it.
const char* const kCascadeCall = "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActValPI := Measured, i_rActValPID := Drive, "
                                 "i_stParaPID := inner, i_stParaPI := outer);";

const std::vector<Block> kBlocks = {
    {"P",
     "Main.c",
     "toolbox",
     "c : FB_P;",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActVal := Measured, i_rKp := Kp);",
     "c.q_rOput",
     "c.i_rSp",
     2,
     2.5,
     {"Main.Kp"}},
    {"Pi",
     "Main.c",
     "toolbox",
     "c : FB_PI; para : stPiPara := (tCyclTime := T#10ms, tTn := T#2s, rKp := 0.8, rMaxLim := 1000.0, rMinLim := "
     "-1000.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActVal := Measured, i_stPara := para);",
     "c.q_rOput",
     "c.i_rSp",
     2,
     2.5,
     {"Main.para.rKp", "Main.para.tTn"}},
    {"Pid",
     "Main.c",
     "toolbox",
     "c : FB_PID; para : stPid := (xActValType := TRUE, rTargCyclTime := 10.0, rLowLim := -1000.0, rHighLim := "
     "1000.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := Kp, i_rTn := Tn, i_rTd := 60.0, i_stPid := "
     "para);",
     "c.q_rPidOput",
     "c.i_rSp",
     2,
     2.5,
     {"Main.Kp", "Main.Tn"}},
    {"CascadeOuter",
     "Main.c.PI",
     "toolbox",
     kCascade,
     kCascadeCall,
     "c.innerSetPoint",
     "c.i_rSp",
     1,
     0,
     {"Main.outer.rKp", "Main.outer.tTn"}},
    {"CascadeInner",
     "Main.c.PID",
     "toolbox",
     kCascade,
     kCascadeCall,
     "c.q_rOput",
     "c.innerSetPoint",
     2,
     0.5,
     {"Main.inner.rKp", "Main.inner.tTn"}},
    {"Util",
     "Main.c",
     "util",
     "c : util.PID;",
     "c(ACTUAL := Measured, SET_POINT := SetPoint, KP := Kp, TN := Seconds, TV := 0.0, Y_MIN := -1000.0, Y_MAX := "
     "1000.0);",
     "c.Y",
     "c.SET_POINT",
     2,
     2.5,
     {"Main.Kp", "Main.Seconds"}},
    {"UtilFixed",
     "Main.c",
     "util",
     "c : util.PID_FIXCYCLE;",
     "c(ACTUAL := Measured, SET_POINT := SetPoint, KP := Kp, TN := Seconds, TV := 0.0, Y_MIN := -1000.0, Y_MAX := "
     "1000.0, CYCLE := 0.01);",
     "c.Y",
     "c.SET_POINT",
     2,
     2.5,
     {"Main.Kp", "Main.Seconds"}},
    {"AnnexF",
     "Main.c",
     "analog",
     "c : analog.PID; Reversed : REAL := -0.8;",
     "c(AUTO := TRUE, PV := Measured, SP := SetPoint, KP := Reversed, TR := Seconds, TD := 0.0, CYCLE := T#10ms);",
     "c.XOUT",
     "c.SP",
     2,
     2.5,
     {"Main.Reversed", "Main.Seconds"}},
};

std::string programOf(const Block& block) {
    return std::string("PROGRAM Main\nVAR\n    Kp : REAL := 0.8; Tn : REAL := 2000.0; Seconds : REAL := 2.0; SetPoint, "
                       "Measured, Drive : REAL; ") +
           block.declaration + "\nEND_VAR\n" + block.call + "\nDrive := Drive + (" +
           (block.loop == std::string("Main.c") ? block.output : "c.q_rOput") +
           " * 2.0 - Drive) * 0.02;\nMeasured := Measured + (Drive - Measured) * 0.005;\nEND_PROGRAM\n"
           "CONFIGURATION Plc\n    RESOURCE Cpu ON Pc\n        TASK Fast(INTERVAL := T#10ms, PRIORITY := 1);\n"
           "        PROGRAM Main WITH Fast : Main;\n    END_RESOURCE\nEND_CONFIGURATION\n";
}

class TuneBlocks : public CommandTest, public ::testing::WithParamInterface<Block> {
protected:
    /// A command on the program: it runs for a minute, its set point stepped twice.
    std::vector<std::string> onProgram(const char* verb, const std::vector<std::string>& more) {
        write("loop.st", programOf(GetParam()));
        std::vector<std::string> words{
            verb,    path("loop.st"),       "--library", GetParam().library,   "--for", "60s",
            "--set", "Main.SetPoint=10@5s", "--set",     "Main.SetPoint=4@32s"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static std::string inMain(const char* name) { return std::string("Main.") + name; }
};

} // namespace

TEST_P(TuneBlocks, ItsTableGivesTheModelThatTheProjectGives) {
    const Block& block = GetParam();
    const auto answered = [&](std::vector<std::string> words) {
        words.insert(words.end(), {"--format", "json"});
        EXPECT_EQ(command(words), cli::kGood) << err;
        return nlohmann::json::parse(out, nullptr, false);
    };
    const auto project = answered(onProgram("tune", {"--loop", block.loop}));
    const std::string input = project["input"], output = project["output"], wanted = inMain(block.setPoint);
    ASSERT_EQ(
        command(onProgram("run", {"--watch", input, "--watch", output, "--watch", wanted, "--csv", path("a.csv")})),
        cli::kGood)
        << err;
    std::vector<std::string> ofTable{"tune", path("a.csv"), "--input", input, "--output", output, "--setpoint", wanted};
    if (block.variable.size() == 1) ofTable.insert(ofTable.end(), {"--kind", "p"});
    const auto table = answered(ofTable);
    EXPECT_TRUE(err.empty()) << err; // nothing is wrong with our own table
    EXPECT_NEAR(table["model"]["gain"].get<double>(), block.gain, 0.01 * block.gain) << table["model"].dump();
    const auto& lags = table["model"]["lags"];
    double delay = table["model"]["dead_time"].get<double>() - table["model"].value("zero", 0.0);
    for (const auto& lag : lags) delay += lag.get<double>();
    if (block.lag > 0) {
        EXPECT_NEAR(delay, block.lag, 0.03 * block.lag) << table["model"].dump();
    }
    ASSERT_EQ(lags.size(), project["model"]["lags"].size());
    for (size_t i = 0; i < lags.size(); ++i)
        EXPECT_NEAR(lags[i].get<double>(), project["model"]["lags"][i].get<double>(), 1e-3);
    EXPECT_EQ(table["steps"].size(), project["steps"].size());
    for (const auto& [rule, settings] : project["settings"].items())
        for (const char* figure : {"gain", "integral_time"}) {
            const double own = settings[figure].is_number() ? settings[figure].get<double>() : 0;
            const auto& other = table["settings"][rule][figure];
            EXPECT_NEAR(other.is_number() ? other.get<double>() : 0, own, 1e-3 * std::abs(own))
                << rule << " " << figure;
        }
    ASSERT_GE(project["writes"].size(), block.variable.size()) << project.dump(1);
    for (size_t i = 0; i < block.variable.size(); ++i) EXPECT_EQ(project["writes"][i]["path"], block.variable[i]);
    // the same in words and as a picture
    ASSERT_EQ(command(onProgram("tune", {"--loop", block.loop, "--picture", path("a.svg")})), cli::kGood) << err;
    for (const char* path : block.variable) EXPECT_NE(out.find(path), std::string::npos) << out;
    EXPECT_EQ(out.find("nan"), std::string::npos) << out;
    EXPECT_NE(read("a.svg").find("<polyline"), std::string::npos);
    EXPECT_EQ(read("a.svg").find("nan"), std::string::npos);
    std::vector<std::string> inWords = ofTable;
    inWords.insert(inWords.end(), {"--picture", path("b.svg")});
    ASSERT_EQ(command(inWords), cli::kGood) << err;
    EXPECT_NE(read("b.svg").find("<polyline"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, TuneBlocks, ::testing::ValuesIn(kBlocks),
                         [](const auto& info) { return std::string(info.param.name); });
