// Bars and charts held against what their values were while the controller ran.
#include "hmi/station/range_check.h"
#include "tests/hmi/running.h"

namespace plc::hmi {
namespace {

std::string findings(const std::string& element) {
    PanelProject project;
    Result<Panel> panel =
        Panel::parse(R"({"elements": [{"id":"a","rect":[0,0,200,200],)" + element + "}]}", QStringLiteral("main"));
    EXPECT_TRUE(panel);
    project.panels.push_back({QStringLiteral("main"), *panel});
    session::Session session(builtMachine());
    session.controller().start();
    for (int i = 0; i < 200; ++i) session.controller().scan(); // count rises from 1 to 200
    std::string out;
    for (const Finding& one : checkRanges(project, session)) out += one.text().toStdString();
    return out;
}

TEST(RangeCheck, AValueThatLeavesItsBarOrChartIsReported) {
    EXPECT_EQ(findings(R"("kind":"bar","value":"Main.count","min":0,"max":100)"),
              "hmi/main.panel.json: a.value: warning H1040: Main.count is between 1 and 200 in the recording, so the "
              "range from 0 to 100 cuts it off; widen the range");
    EXPECT_NE(findings(R"("kind":"trend","series":[{"value":"Main.count"}],"min":50,"max":300)"), "");
    EXPECT_NE(findings(R"("kind":"xyChart","pointX":"Main.count","maxX":20)"), "");
}

TEST(RangeCheck, AValueWithinItsRangeAndAChartThatFindsItsOwnAreNot) {
    EXPECT_EQ(findings(R"("kind":"bar","value":"Main.count","min":0,"max":200)"), "");
    EXPECT_EQ(findings(R"("kind":"trend","series":[{"value":"Main.count"}])"), "");
    EXPECT_EQ(findings(R"("kind":"gauge","value":"Main.nothing")"), "");
}

} // namespace
} // namespace plc::hmi
