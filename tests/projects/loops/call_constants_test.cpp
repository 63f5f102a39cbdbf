// Parameters that are constants of the call: found in the text, changed there and nowhere else, and tried with the
// changed program.
#include "projects/loops/call_constants.h"
#include "projects/loops/trial.h"
#include "projects/session/session.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::loops;

namespace {

const char* const kProgram = R"(FUNCTION_BLOCK Zone
VAR_INPUT Measured : REAL; END_VAR
VAR_OUTPUT Heat : REAL; END_VAR
VAR pid : util.PID; END_VAR
pid(ACTUAL := Measured, KP := 9.0, TN := 9.0);
Heat := pid.Y;
END_FUNCTION_BLOCK
PROGRAM Main
VAR
    Measured : REAL;
    SetPoint : REAL := 10.0;
    fast : BOOL;
    Gain : REAL := 3.0;
    pid, second : util.PID;
    zone : Zone;
END_VAR
Measured := Measured + 0.05 * (pid.Y - Measured); // what the block then sees
IF fast THEN
    pid(ACTUAL := Measured, SET_POINT := SetPoint, KP := 4.0 (* brisk *), TN := 2.0);
ELSE
    pid(ACTUAL := Measured, SET_POINT := SetPoint, kp := REAL#2.5, TN := -1.0 + 3.0, TV := MAX(1.0, 2.0));
END_IF
second(KP := Gain);
zone(Measured := Measured);
END_PROGRAM
CONFIGURATION Plc
    RESOURCE Cpu ON Pc
        TASK Mast(INTERVAL := T#50ms, PRIORITY := 1);
        PROGRAM Main WITH Mast : Main;
    END_RESOURCE
END_CONFIGURATION
)";

class CallConstants : public ::testing::Test {
protected:
    void SetUp() override {
        input.files = {{"main.st", kProgram}};
        input.libraries = {"util"};
        built = driver::build(input);
        ASSERT_TRUE(built.program);
    }
    [[nodiscard]] Loop loop(const char* name) const { return *findLoop(*built.program, name); }
    [[nodiscard]] std::vector<std::string> found(const char* name) const {
        std::vector<std::string> out;
        for (const CallConstant& each : callConstants(loop(name), built.program)) {
            EXPECT_EQ(std::string_view(kProgram).substr(each.range.begin, each.range.length()), each.text);
            EXPECT_EQ(each.file, "main.st");
            out.push_back(each.member + " " + each.text);
        }
        return out;
    }
    driver::BuildInput input;
    driver::Built built;
};

} // namespace

TEST_F(CallConstants, AreFoundInEveryCallOfTheInstanceAndOfNoOther) {
    // not of calculations, not of the block of the same name elsewhere; of REAL#2.5 the number
    EXPECT_EQ(found("Main.pid"), (std::vector<std::string>{"KP 4.0", "TN 2.0", "KP 2.5"}));
    EXPECT_EQ(found("Main.second"), std::vector<std::string>());
    EXPECT_EQ(found("Main.zone.pid"), (std::vector<std::string>{"KP 9.0", "TN 9.0"}));
}

TEST_F(CallConstants, OnlyWhatChangesIsEdited) {
    const auto edits = editsFor(loop("Main.pid"), built.program, {{"KP", "1.25", 1.25}, {"TN", "2.0", 2}});
    ASSERT_EQ(edits.size(), 2U);
    EXPECT_EQ(edits[0].place.text, "4.0");
    EXPECT_EQ(edits[1].place.text, "2.5");
    EXPECT_EQ(edits[1].text, "1.25");
}

TEST_F(CallConstants, TheChangedProgramHasThemAndTheSameImage) {
    const auto edits = editsFor(loop("Main.pid"), built.program, {{"KP", "0.125", 0.125}});
    const auto changed = withConstants(input, built.program, edits);
    ASSERT_TRUE(changed) << changed.error().english();
    EXPECT_EQ((*changed)->layout.imageSize, built.program->layout.imageSize);
    const auto other = *findLoop(**changed, "Main.pid");
    std::vector<std::string> now;
    for (const CallConstant& each : callConstants(other, *changed)) now.push_back(each.text);
    EXPECT_EQ(now, (std::vector<std::string>{"0.125", "2.0", "0.125"}));
}

TEST_F(CallConstants, ATrialWithOthersIsWhatTheControllerThenDoes) {
    session::Session before(built);
    before.runHere([](const controller::Controller& c) { return c.nextScan() >= 300; });
    const auto edits = editsFor(loop("Main.pid"), built.program, {{"KP", "1.25", 1.25}});
    const auto changed = withConstants(input, built.program, edits);
    ASSERT_TRUE(changed);
    auto plan = planFor(loop("Main.pid"), before.history(), 0, 300);
    ASSERT_TRUE(plan) << plan.error().english();
    const auto same = tryOut(before.history(), *plan, std::nullopt);
    ASSERT_TRUE(same);
    EXPECT_FALSE(same->firstDifference);
    plan->program = *changed;
    const auto other = tryOut(before.history(), *plan, std::nullopt);
    ASSERT_TRUE(other) << other.error().english();
    ASSERT_TRUE(other->firstDifference);
    EXPECT_LE(*other->firstDifference, 2U);
    EXPECT_LT(other->series.input.front(), same->series.input.front());
}
