// stepwise panel, texts, recipe, people and alarms on a small project: what the panels are made of, without a window.
#include "hmi/alarms/alarm_store.h"
#include "hmi/people/audit_trail.h"
#include "tests/app/cli/command_fixture.h"

#include <QDir>

#include <cmath>
#include <iostream>

namespace plc {
namespace {

class PanelsCommands : public CommandTest {
protected:
    void SetUp() override {
        for (const char* folder : {"src", "hmi", ".stepwise"}) QDir().mkpath(QString::fromStdString(path(folder)));
        write("project.json", R"({"name": "demo", "hmi": {"languages": ["en", "de"]}})");
        write("src/main.st",
              "FUNCTION_BLOCK Gate\nVAR_INPUT Go : BOOL; END_VAR\nVAR_OUTPUT IsOpen : BOOL; END_VAR\n"
              "IsOpen := Go;\nEND_FUNCTION_BLOCK\n"
              "PROGRAM Main\nVAR gates : ARRAY[1..3] OF Gate; level : REAL := 1.5; count : INT; END_VAR\n"
              "gates[1](); gates[2](); gates[3](); count := count + 1;\nEND_PROGRAM\n");
        write("hmi/gate.panel.json",
              R"({"size": [40, 60], "parameters": [{"name": "gate", "type": "Gate"}],
                  "elements": [{"id": "l", "kind": "lamp", "rect": [0, 0, 40, 40], "value": "$gate.IsOpen"}]})");
        writeMain("Main.gates[2]");
        write("hmi/texts.csv", "key,comment,en,de\nmain.title,,Gate {n:%d},\n");
    }
    void writeMain(const std::string& gate) const {
        write(
            "hmi/main.panel.json",
            R"({"elements": [{"id": "t", "kind": "text", "rect": [0, 0, 200, 40], "text": "@main.title", "values": {"n": "Main.count"}},
                  {"id": "g", "kind": "faceplate", "rect": [0, 50, 40, 60], "panel": "gate", "arguments": {"gate": ")" +
                gate + R"("}}]})");
    }
    int run(const std::string& name, std::vector<std::string> options) {
        options.insert(options.begin(), {name, path("")});
        return command(options);
    }
};

TEST_F(PanelsCommands, APanelThatCannotBeReadIsNotMissingAndWhatItUsesIsNotUnused) {
    write("project.json", R"({"name": "demo", "hmi": {"languages": ["en", "de"], "startPanel": "main"}})");
    write("hmi/alarms.json", R"([{"id": "a", "condition": "Main.level > 2.0", "text": "Too high"}])");
    write("hmi/main.panel.json", "{\n\"elements\": [\n");
    EXPECT_EQ(run("check", {}), 1);
    EXPECT_NE((out + err).find("hmi/main.panel.json"), std::string::npos) << out << err;
    EXPECT_EQ((out + err).find("There is no panel main"), std::string::npos) << out << err;
    EXPECT_EQ((out + err).find("uses the key main.title"), std::string::npos) << out << err;
    EXPECT_EQ((out + err).find("no panel has an alarm list"), std::string::npos) << out << err;
    std::remove(path("hmi/main.panel.json").c_str());
    EXPECT_EQ(run("check", {}), 1);
    EXPECT_NE((out + err).find("There is no panel main"), std::string::npos) << "it is missing now: " << out << err;
}

TEST_F(PanelsCommands, ADamagedTraceIsReportedByTheCheckAsWell) {
    QDir().mkpath(QString::fromStdString(path("traces")));
    write("traces/one.trace.json", "{\n\"charts\": [");
    EXPECT_EQ(run("check", {}), 1);
    EXPECT_NE((out + err).find("traces/one.trace.json: error H1011: "), std::string::npos) << out << err;
    EXPECT_EQ((out + err).find("no errors"), std::string::npos) << out << err;
}

TEST_F(PanelsCommands, ARecipeThatNamesNoVariableIsAnErrorOfTheCheckWithoutAnyPanel) {
    QDir(QString::fromStdString(path("hmi"))).removeRecursively();
    QDir().mkpath(QString::fromStdString(path("hmi")));
    write("hmi/recipes.json", R"({"recipes": [{"name": "dough", "variables": [{"variable": "Main.nowhere"}],
                               "sets": [{"name": "rye", "values": {"Main.nowhere": "5"}}]}]})");
    EXPECT_EQ(run("check", {}), 1);
    EXPECT_NE(err.find("hmi/recipes.json: dough.Main.nowhere: error H1023: "), std::string::npos) << out << err;
    EXPECT_EQ(out.find("no errors"), std::string::npos) << out;
}

TEST_F(PanelsCommands, TheCheckReportsWhatAFaceplateIsGiven) {
    (void)run("panel", {"--check"});
    EXPECT_EQ(out.find("error"), std::string::npos) << out;
    writeMain("Main.level");
    EXPECT_EQ(run("panel", {"--check"}), 1);
    EXPECT_NE(out.find("hmi/main.panel.json: g.arguments.gate: error H1019: Main.level is REAL"), std::string::npos)
        << out;
    EXPECT_EQ(run("check", {}), 1);
    EXPECT_NE(err.find("H1019"), std::string::npos) << err;
}

TEST_F(PanelsCommands, TheStandardsAreCheckedListedAndFixed) {
    write("hmi/main.panel.json",
          R"({"elements": [{"id": "r", "kind": "rectangle", "rect": [0, 0, 80, 80], "fill": "red"},
                  {"id": "e", "kind": "numberEntry", "rect": [0, 100, 140, 44], "target": "Main.level"}]})");
    EXPECT_EQ(run("panel", {"--check"}), 0) << "warnings do not fail";
    EXPECT_NE(out.find("r.fill: warning H1102"), std::string::npos) << out;
    EXPECT_NE(out.find("e.minimum: warning H1112"), std::string::npos) << out;
    (void)run("panel", {"--check", "--format", "json"});
    EXPECT_NE(out.find("\"why\":"), std::string::npos) << out;
    EXPECT_NE(out.find("\"fixable\":true"), std::string::npos) << out;
    (void)run("panel", {"--check", "--level", "off"});
    EXPECT_EQ(out.find("H11"), std::string::npos) << out;
    EXPECT_EQ(run("panel", {"--check", "--level", "hard"}), 2);
    EXPECT_EQ(run("panel", {"--fix"}), 0);
    EXPECT_EQ(read("hmi/main.panel.json").find("\"red\""), std::string::npos) << read("hmi/main.panel.json");
    (void)run("panel", {"--check"});
    EXPECT_EQ(out.find("H1102"), std::string::npos) << out;
    EXPECT_NE(out.find("H1112"), std::string::npos) << "a limit is a decision";
    EXPECT_EQ(command({"panel", "--rules"}), 0);
    EXPECT_NE(out.find("H1109  touch-target (basic)"), std::string::npos) << out;
    write("project.json",
          R"({"name": "demo", "hmi": {"languages": ["en", "de"], "checks": {"errors": ["write-limits"]}}})");
    EXPECT_EQ(run("panel", {"--check"}), 1);
    write("project.json", R"({"name": "demo", "hmi": {"languages": ["en", "de"], "checks": {"level": "of"}}})");
    EXPECT_EQ(run("panel", {"--check"}), 1);
    EXPECT_NE(out.find("project.json: checks.level: error H1100"), std::string::npos) << out;
}

TEST_F(PanelsCommands, TextsGoOutAsXliffAndComeBack) {
    EXPECT_EQ(run("texts", {"--export", path("t.xlf")}), 2); // into which language?
    ASSERT_EQ(run("texts", {"--export", path("t.xlf"), "--language", "de"}), 0) << err;
    std::string file = read("t.xlf");
    EXPECT_NE(file.find("main: t.text"), std::string::npos) << file;
    const std::string end = "</source>";
    file.replace(file.find(end), end.size(), end + "<target>Tor <ph id=\"1\" equiv=\"{n:%d}\"/></target>");
    file.replace(file.find("\"initial\""), 9, "\"final\"");
    write("t.xlf", file);
    EXPECT_EQ(run("texts", {"--import", path("t.xlf"), "--preview"}), 0) << out << err;
    EXPECT_EQ(read("hmi/texts.csv").find("Tor"), std::string::npos);
    EXPECT_EQ(run("texts", {"--import", path("t.xlf")}), 0) << out << err;
    EXPECT_EQ(out, "1 text taken, 0 as they were, 0 without a translation\n");
    EXPECT_NE(read("hmi/texts.csv").find("Tor {n:%d}"), std::string::npos);
    write("t.xlf", "<html/>");
    EXPECT_EQ(run("texts", {"--import", path("t.xlf")}), 2);
}

TEST_F(PanelsCommands, ARecipeIsTakenFromARunCheckedAndExchanged) {
    write("hmi/recipes.json",
          R"({"recipes": [{"name": "r", "variables": [{"variable": "Main.level", "min": 0, "max": 10}],
        "sets": [{"name": "a", "values": {"Main.level": "2.0"}}]}]})");
    EXPECT_EQ(run("recipe", {}), 0) << out << err;
    EXPECT_EQ(run("recipe", {"--list"}), 0);
    EXPECT_EQ(out, "r: 1 variables; a\n");
    EXPECT_EQ(run("recipe", {"--read", "warm", "--at", "1s", "--set", "Main.level=7.25@0.5s"}), 0) << err;
    EXPECT_NE(out.find("Main.level := 7.25;"), std::string::npos) << out;
    EXPECT_EQ(run("recipe", {"--text", "warm"}), 0);
    ASSERT_EQ(run("recipe", {"--export", path("r.csv")}), 0) << err;
    const std::string csv = read("r.csv");
    EXPECT_NE(csv.find("7.25"), std::string::npos) << csv;
    const std::string before = read("hmi/recipes.json");
    write("r.csv", "variable,hot\nMain.level,11\n"); // beyond the limit: nothing is taken
    EXPECT_EQ(run("recipe", {"--import", path("r.csv")}), 1);
    EXPECT_NE(out.find("11 is outside the limits"), std::string::npos) << out;
    EXPECT_EQ(read("hmi/recipes.json"), before);
    write("r.csv", "variable,hot\nMain.level,9\n");
    EXPECT_EQ(run("recipe", {"--import", path("r.csv")}), 0) << out << err;
    EXPECT_NE(read("hmi/recipes.json").find("\"hot\""), std::string::npos);
}

TEST_F(PanelsCommands, PeopleAreAddedWithAPasswordFromStandardInput) {
    std::istringstream typed("12\n4711x\n");
    std::streambuf* const before = std::cin.rdbuf(typed.rdbuf());
    EXPECT_EQ(run("people", {"--user", "anna", "--role", "operator", "--password"}), 2); // too short
    EXPECT_EQ(run("people", {"--user", "anna", "--role", "operator", "--password"}), 0) << err;
    std::cin.rdbuf(before);
    EXPECT_EQ(read("hmi/people.json").find("4711x"), std::string::npos);
    EXPECT_EQ(run("people", {}), 0);
    EXPECT_EQ(out, "role operator\nuser anna: operator\n");
    EXPECT_EQ(run("people", {"--remove", "bert"}), 2);
    EXPECT_EQ(run("people", {"--remove", "anna"}), 0);
    hmi::AuditTrail trail;
    const QString file = QString::fromStdString(path(".stepwise/audit.csv"));
    ASSERT_TRUE(trail.open(file));
    ASSERT_TRUE(trail.add({QDateTime(QDate(2026, 1, 2), QTime(3, 4), Qt::UTC), "anna", "write", "Main.level", "1.5",
                           "2.0", "main, e", ""}));
    EXPECT_EQ(run("people", {"--audit"}), 0);
    EXPECT_NE(out.find("anna,write,Main.level,1.5,2.0"), std::string::npos) << out;
    std::string bytes = read(".stepwise/audit.csv");
    bytes.replace(bytes.find("2.0"), 3, "9.0");
    write(".stepwise/audit.csv", bytes);
    EXPECT_EQ(run("people", {"--audit"}), 1);
    EXPECT_NE(err.find("Line 2"), std::string::npos) << err;
}

TEST_F(PanelsCommands, TheJournalOfAlarmsIsFilteredAndCounted) {
    EXPECT_EQ(run("alarms", {}), 2); // there is none yet
    {
        hmi::AlarmStore store;
        ASSERT_TRUE(store.open(QString::fromStdString(path(".stepwise/alarms.sqlite"))));
        std::vector<hmi::AlarmRecord> records;
        for (int i = 0; i < 3; ++i) {
            hmi::AlarmRecord record;
            record.alarm = i == 2 ? QStringLiteral("b") : QStringLiteral("a");
            record.at.time = std::chrono::minutes(20) * i;
            records.push_back(record);
        }
        ASSERT_TRUE(store.append(records));
    }
    EXPECT_EQ(run("alarms", {"--alarm", "b"}), 0) << err;
    EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 2) << out;
    EXPECT_EQ(run("alarms", {"--statistics"}), 0);
    EXPECT_NE(out.find("raised 3\n"), std::string::npos) << out;
    EXPECT_NE(out.find("frequent a 2\n"), std::string::npos) << out;
    EXPECT_EQ(run("alarms", {"--event", "shut"}), 2);
}

} // namespace
} // namespace plc
