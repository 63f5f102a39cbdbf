#include "runtime/inside/coverage.h"

#include "tests/runtime/inside/recorded.h"

using namespace plc;
using namespace plc::inside;
using plc::testing::buildText;
using plc::testing::integerFor;
using plc::testing::longScan;

namespace {

class CoverageOf : public ::testing::Test {
protected:
    void run(const std::string& text) {
        session = std::make_unique<session::Session>(buildText(text));
        session->controller().start();
    }
    void scanWith(std::initializer_list<std::pair<const char*, int>> values) {
        for (const auto& [path, value] : values)
            ASSERT_TRUE(session->controller().write(path, integerFor(*session->program(), path, value)));
        session->controller().scan();
    }
    FunctionCoverage covered() {
        Coverage coverage(session->program());
        EXPECT_EQ(coverage.addAll(session->history()), 0u);
        const auto all = coverage.functions();
        EXPECT_EQ(all.size(), 1u);
        return all.empty() ? FunctionCoverage() : all[0];
    }
    std::unique_ptr<session::Session> session;
};

const char* const kDecision = R"(
VAR_GLOBAL a, b, c : BOOL; q, n : INT; END_VAR
PROGRAM Main
IF a AND (b OR c) THEN
    q := 1;
END_IF
CASE n OF
    0: q := 2;
    1, 2: q := 3;
END_CASE
END_PROGRAM)";

} // namespace

TEST_F(CoverageOf, CountsStatementsAndBranches) {
    run(kDecision);
    scanWith({{"n", 1}});
    scanWith({{"n", 5}});
    const FunctionCoverage f = covered();
    EXPECT_EQ(f.statements.size(), 5u);
    EXPECT_EQ(f.statementsRun(), 3u); // IF, CASE, q := 3
    EXPECT_EQ(f.branches.size(), 5u);
    EXPECT_EQ(f.branchesTaken(), 3u); // else of the IF, arm 2, else
}

TEST_F(CoverageOf, AConditionIsMetWhenItDecidedAlone) {
    run(kDecision);
    scanWith({{"a", 1}, {"b", 1}, {"c", 0}});
    scanWith({{"a", 0}, {"b", 1}, {"c", 0}}); // a alone
    FunctionCoverage f = covered();
    ASSERT_EQ(f.decisions.size(), 1u);
    ASSERT_EQ(f.decisions[0].conditions.size(), 3u);
    EXPECT_TRUE(f.decisions[0].conditions[0].decidedAlone);
    EXPECT_FALSE(f.decisions[0].conditions[1].decidedAlone);
    EXPECT_EQ(f.decisions[0].conditions[1].missing, "b = FALSE");
    EXPECT_EQ(f.decisions[0].conditions[2].missing, "c = TRUE");
    scanWith({{"a", 1}, {"b", 0}, {"c", 0}}); // b alone, with the first
    scanWith({{"a", 1}, {"b", 0}, {"c", 1}}); // c alone, with the third
    f = covered();
    EXPECT_EQ(f.conditionsMet(), 3u);
}

TEST_F(CoverageOf, AChartHasTheConditionsOfItsTransitionsOnly) {
    run(R"(
VAR_GLOBAL go, clear, back : BOOL; lamp : BOOL; END_VAR
PROGRAM Main
INITIAL_STEP Rest: END_STEP
TRANSITION FROM Rest TO Work := go AND clear; END_TRANSITION
STEP Work: lamp(N); END_STEP
TRANSITION FROM Work TO Rest := back; END_TRANSITION
END_PROGRAM)");
    scanWith({{"go", 0}});
    const FunctionCoverage f = covered();
    std::vector<std::string> conditions;
    for (const DecisionCoverage& decision : f.decisions)
        for (const ConditionCoverage& condition : decision.conditions)
            conditions.emplace_back(session->program()->sources[condition.range.file].slice(condition.range));
    EXPECT_EQ(conditions, (std::vector<std::string>{"go", "clear", "back"}));
}

TEST_F(CoverageOf, ReportsAreWellFormed) {
    run(kDecision);
    scanWith({{"a", 1}, {"b", 1}});
    Coverage coverage(session->program());
    coverage.addAll(session->history());
    const std::string xml = coberturaXml(*session->program(), coverage.functions());
    EXPECT_NE(xml.find("<class name=\"Main\" filename=\"main.st\""), std::string::npos);
    EXPECT_NE(xml.find("<line number=\"4\" hits=\"1\" branch=\"true\" condition-coverage=\"50% (1/2)\"/>"),
              std::string::npos)
        << xml;
    const std::string html = coverageHtml(*session->program(), coverage.functions());
    EXPECT_NE(html.find("missing: a = FALSE"), std::string::npos) << html;
    EXPECT_NE(html.find("never arm 2"), std::string::npos);
}

TEST_F(CoverageOf, AScanThatDoesMoreThanALookKeepsIsCountedToItsEnd) {
    run(longScan(600'000, "IF a = 600000 AND (i = 0 OR Next(a) > 0) THEN\n    i := 1;\nEND_IF"));
    scanWith({});
    Coverage coverage(session->program());
    EXPECT_EQ(coverage.addAll(session->history()), 0u);
    const auto all = coverage.functions();
    ASSERT_EQ(all.size(), 2u); // Main and Next
    const FunctionCoverage& main = all[0].name == "Main" ? all[0] : all[1];
    const FunctionCoverage& next = all[0].name == "Main" ? all[1] : all[0];
    EXPECT_EQ(main.statementsRun(), 4u) << "FOR, its body, IF and i := 1";
    EXPECT_EQ(main.branchesTaken(), 1u);
    ASSERT_EQ(next.statements.size(), 1u);
    EXPECT_EQ(next.statements[0].count, 600001u) << "once more in the condition";
}
