// `stepwise tune` from recording, project and table to settings. The answers are in tests/app/cli/tune;
// STEPWISE_UPDATE=1 writes them again, for a look.
#include "tests/app/cli/command_fixture.h"
#include "tests/support/paths.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>

using namespace plc;

namespace {

class TuneCommand : public CommandTest {
protected:
    void expectGolden(const std::string& name) const {
        const std::string file = sourceDir() + "/tests/app/cli/tune/" + name;
        if (std::getenv("STEPWISE_UPDATE")) std::ofstream(file, std::ios::binary) << out;
        std::ifstream in(file);
        std::stringstream expected;
        expected << in.rdbuf();
        EXPECT_EQ(out, expected.str()) << name;
    }
    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out, nullptr, false); }
    static std::string example(const char* name) { return sourceDir() + "/projects/examples/" + name; }
    /// A valve stepped by hand twice: 2 e^(-1 s) / (5 s + 1).
    static std::string table() {
        std::string text = "time_s,valve,level\r\n";
        for (int i = 0; i < 900; ++i) {
            const double time = i * 0.1;
            const auto response = [&](double at) { return time < at + 1 ? 0.0 : 1 - std::exp(-(time - at - 1) / 5); };
            const double level = 20 + 2 * (10 * response(10) - 5 * response(50));
            char line[80];
            std::snprintf(line, sizeof line, "%.1f,%d,%.9g\r\n", time, time < 10 ? 30 : time < 50 ? 40 : 35, level);
            text += line;
        }
        return text;
    }
};

} // namespace

TEST_F(TuneCommand, ATableGivesModelAndSettings) {
    write("valve.csv", table());
    ASSERT_EQ(command({"tune", path("valve.csv"), "--input", "valve", "--output", "level", "--picture", path("a.svg")}),
              cli::kGood)
        << err;
    expectGolden("table.txt");
    EXPECT_NE(read("a.svg").find("<polyline"), std::string::npos);
    ASSERT_EQ(command({"tune", path("valve.csv"), "--input", "valve", "--output", "level", "--format", "json"}),
              cli::kGood);
    const auto answer = json();
    EXPECT_NEAR(answer["model"]["gain"], 2, 0.02);
    EXPECT_NEAR(answer["model"]["lags"][0], 5, 0.05);
    EXPECT_NEAR(answer["model"]["dead_time"], 1, 0.01);
    EXPECT_EQ(answer["steps"].size(), 2U);
    // SIMC: gain T / (2 K L), integral time the smaller of T and 8 L; half a sample belongs to the dead time
    EXPECT_NEAR(answer["settings"]["simc"]["gain"], 5 / (2 * 2 * 1.05), 0.03);
    EXPECT_NEAR(answer["settings"]["optimum"]["ms"], 1.59, 0.02);
}

TEST_F(TuneCommand, AProjectIsRunAndItsLoopTuned) {
    ASSERT_EQ(command({"tune", example("pid_pt1"), "--for", "20s", "--set", "Main.Period=T#8s", "--rule", "optimum"}),
              cli::kGood)
        << err;
    expectGolden("pid_pt1.txt");
}

TEST_F(TuneCommand, BothLoopsOfACascade) {
    const std::vector<std::string> run{
        "--for", "900s", "--set", "Main.SetPoint=24.0@300s", "--set", "Main.SetPoint=21.0@600s"};
    const auto tuned = [&](const char* loop) {
        std::vector<std::string> words{"tune", example("cascade"), "--loop", loop, "--format", "json"};
        words.insert(words.end(), run.begin(), run.end());
        EXPECT_EQ(command(words), cli::kGood) << loop << err;
        return json();
    };
    // the room: 0.45 of the supply air with 30 s
    const auto room = tuned("Main.controller.PI");
    EXPECT_EQ(room["writes"][0]["path"], "Main.outer.rKp") << room.dump(1);
    EXPECT_EQ(room["writes"][1]["path"], "Main.outer.tTn");
    EXPECT_EQ(room["now"]["gain"], 4.0);
}

TEST_F(TuneCommand, ARecordingAnswersAsTheProjectDid) {
    ASSERT_EQ(
        command({"run", example("pid_pt1"), "--for", "20s", "--set", "Main.Period=T#8s", "--record", path("a.rec")}),
        cli::kGood)
        << err;
    ASSERT_EQ(command({"tune", path("a.rec"), "--loop", "pid", "--rule", "optimum"}), cli::kGood) << err;
    expectGolden("pid_pt1.txt");
    ASSERT_EQ(command({"tune", path("a.rec"), "--input", "IO.Drive", "--output", "IO.Measured", "--setpoint",
                       "Main.SetPoint", "--format", "json"}),
              cli::kGood)
        << err;
    EXPECT_NEAR(json()["model"]["gain"], 1, 0.01);
}

TEST_F(TuneCommand, AReportSaysHowTheLoopIsDoing) {
    ASSERT_EQ(command({"tune", example("loop_tuning"), "--for", "180s", "--set", "Main.SetPoint=45@60s", "--report",
                       path("loop.html")}),
              cli::kGood)
        << err;
    const std::string page = read("loop.html");
    EXPECT_NE(page.find("<h2>Loop health</h2>"), std::string::npos);
    EXPECT_NE(page.find(">Model</h2>"), std::string::npos);
    EXPECT_NE(page.find("<polyline"), std::string::npos);
    EXPECT_EQ(page.find("nan"), std::string::npos);
    // without a step there is still something to say
    ASSERT_EQ(command({"tune", example("cascade"), "--loop", "Main.controller.PID", "--for", "60s", "--report",
                       path("quiet.html")}),
              cli::kGood)
        << err;
    EXPECT_NE(read("quiet.html").find("Loop health"), std::string::npos);
}

TEST_F(TuneCommand, TheBodePlotHasItsMargins) {
    write("valve.csv", table());
    ASSERT_EQ(command({"tune", path("valve.csv"), "--input", "valve", "--output", "level", "--bode", path("b.svg"),
                       "--dark"}),
              cli::kGood)
        << err;
    const std::string picture = read("b.svg");
    for (const char* part :
         {"phase margin", "gain margin", "phase [°]", "magnitude [dB]", "frequency [rad/s]", "rad/s"})
        EXPECT_NE(picture.find(part), std::string::npos) << part;
    EXPECT_EQ(picture.find("nan"), std::string::npos);
    EXPECT_EQ(command({"tune", path("valve.csv"), "--input", "valve", "--output", "level", "--bode", "/nowhere/b.svg"}),
              cli::kWrongUse);
}

TEST_F(TuneCommand, ConstantsOfTheCallAreNamedWithTheirPlace) {
    write("loop.st", R"(PROGRAM Main
VAR
    SetPoint : REAL; Measured : REAL; Gain : REAL := 0.5;
    pid : FB_PID;
    parameters : stPid := (xActValType := TRUE, rTargCyclTime := 10.0, rLowLim := -1000.0, rHighLim := 1000.0);
END_VAR
pid(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := Gain * 2.0,
    i_rTn := 900.0, i_rTd := 60.0, i_stPid := parameters);
Measured := Measured + (pid.q_rPidOput - Measured) * 0.02;
END_PROGRAM
CONFIGURATION Plc
    RESOURCE Cpu ON Pc
        TASK Fast(INTERVAL := T#10ms, PRIORITY := 1);
        PROGRAM Main WITH Fast : Main;
    END_RESOURCE
END_CONFIGURATION
)");
    const std::vector<std::string> run{"tune",  path("loop.st"), "--library", "toolbox",
                                       "--for", "20s",           "--set",     "Main.SetPoint=10@5s"};
    ASSERT_EQ(command(run), cli::kGood) << err;
    EXPECT_NE(out.find("loop.st:8: i_rTn := "), std::string::npos) << out;
    EXPECT_NE(out.find("in the place of 900.0"), std::string::npos) << out;
    EXPECT_NE(out.find("i_rKp is computed in the call"), std::string::npos) << out;
    std::vector<std::string> asJson = run;
    asJson.insert(asJson.end(), {"--format", "json"});
    ASSERT_EQ(command(asJson), cli::kGood) << err;
    EXPECT_EQ(json()["writes"][1]["constants"][0]["line"], 8) << json()["writes"].dump(1);
}

TEST_F(TuneCommand, DisturbancesAreListedAndMakeNoModel) {
    const std::vector<std::string> run{
        "tune",  example("loop_tuning"),     "--for",    "400s", "--set", "Main.SetPoint=45@60s",
        "--set", "Plant.MoreFlow=TRUE@220s", "--format", "json"};
    ASSERT_EQ(command(run), cli::kGood) << err;
    const auto answer = json();
    size_t loads = 0, number = 0;
    for (size_t i = 0; i < answer["steps"].size(); ++i) {
        const auto& step = answer["steps"][i];
        if (step["moved"] != "load") continue;
        ++loads;
        number = i + 1;
        EXPECT_NEAR(step["time_s"], 222, 6);
        EXPECT_TRUE(step["usable"]) << step.dump();
        EXPECT_FALSE(step["used"]);
        EXPECT_NEAR(step["to"].get<double>() - step["from"].get<double>(), 10, 0.6); // 6 C by 0.6 C each per cent
    }
    EXPECT_EQ(loads, 1U) << answer["steps"].dump(1);
    EXPECT_NEAR(answer["model"]["gain"], 0.6, 0.02);
    std::vector<std::string> wrong = run;
    wrong.insert(wrong.end(), {"--step", std::to_string(number)});
    EXPECT_EQ(command(wrong), cli::kWrongUse);
    EXPECT_NE(err.find("disturbance"), std::string::npos) << err;
}

TEST_F(TuneCommand, AReportEndingInPdfIsOne) {
    ASSERT_EQ(command({"tune", example("loop_tuning"), "--for", "180s", "--set", "Main.SetPoint=45@60s", "--report",
                       path("loop.pdf")}),
              cli::kGood)
        << err;
    const std::string page = read("loop.pdf");
    EXPECT_TRUE(page.starts_with("%PDF-")) << page.substr(0, 20);
    EXPECT_NE(page.find("/Image"), std::string::npos) << "the charts are in it";
    EXPECT_NE(page.find("/Count 3"), std::string::npos) << "health, charts, figures";
    EXPECT_EQ(command({"tune", example("loop_tuning"), "--for", "180s", "--set", "Main.SetPoint=45@60s", "--report",
                       "/no/such/folder/loop.pdf"}),
              cli::kWrongUse);
    EXPECT_NE(err.find("There is no folder /no/such/folder"), std::string::npos) << err;
}

TEST_F(TuneCommand, SaysWhatIsWrong) {
    write("valve.csv", table());
    write("flat.csv", [] {
        std::string text = "t,u,y\n";
        for (int i = 0; i < 50; ++i) text += std::to_string(i) + ",1,2\n";
        return text;
    }());
    write("plain.st", "PROGRAM Main VAR n : INT; END_VAR n := n + 1; END_PROGRAM");
    const auto refused = [&](std::vector<std::string> words, const char* part) {
        words.insert(words.begin(), "tune");
        EXPECT_EQ(command(words), cli::kWrongUse) << out;
        EXPECT_NE(err.find(part), std::string::npos) << err;
    };
    refused({}, "one project");
    refused({path("valve.csv")}, "valve, level");
    refused({path("valve.csv"), "--input", "valve"}, "belong together");
    refused({path("valve.csv"), "--input", "valv", "--output", "level"}, "did you mean valve");
    refused({path("valve.csv"), "--input", "valve", "--output", "level", "--rule", "magic"}, "magic");
    refused({path("valve.csv"), "--input", "valve", "--output", "level", "--step", "7"},
            "no step 7; choose one from 1 to 2");
    refused({path("valve.csv"), "--input", "valve", "--output", "level", "--brisk", "2"}, "from 0 to 1");
    refused({path("flat.csv"), "--input", "u", "--output", "y"}, "no step");
    write("same.csv", [] {
        std::string text = "t,u,y\n";
        for (int i = 0; i < 50; ++i) text += std::to_string(i) + (i < 20 ? ",1,1\n" : ",2,2\n");
        return text;
    }());
    refused({path("same.csv"), "--input", "u", "--output", "y"}, "the same in every sample");
    write("damaged.rec", "nothing that was recorded");
    refused({path("damaged.rec")}, "damaged.rec");
    EXPECT_EQ(err.find("P1013"), std::string::npos) << err; // it is no program
    refused({path("missing.csv"), "--input", "u", "--output", "y"}, "no such file");
    refused({path("plain.st")}, "no controller block");
    refused({example("cascade")}, "Main.controller.PID");
    refused({path("valve.csv"), "--input", "valve", "--output", "level", "--picture", "/nowhere/a.svg"}, "nowhere");
}
