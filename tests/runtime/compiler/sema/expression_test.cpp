#include "tests/runtime/compiler/sema/checked.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::sema_test;

namespace {

const CheckedText& plant() {
    static const CheckedText checked = check(R"(
VAR_GLOBAL level : INT := 5; END_VAR
VAR_GLOBAL CONSTANT LIMIT_HIGH : INT := 80; END_VAR
TYPE Mode : (Idle, Run); END_TYPE
FUNCTION_BLOCK Pump
VAR_INPUT on : BOOL; END_VAR
VAR_OUTPUT flow : REAL; END_VAR
VAR PRIVATE hours : ARRAY[1..3] OF DINT; mode : Mode; END_VAR
VAR_TEMP scratch : INT; END_VAR
METHOD Count : INT Count := 1; END_METHOD
flow := SEL(on, 0.0, 2.5); scratch := 1; hours[1] := scratch; mode := Run;
END_FUNCTION_BLOCK
FUNCTION Twice : INT VAR_INPUT a : INT; END_VAR Twice := 2 * a; END_FUNCTION
PROGRAM Main
VAR a, b : Pump; i : INT; END_VAR
a(on := TRUE); b(); i := Twice(i) + a.Count() + level;
END_PROGRAM
)");
    return checked;
}

struct Row {
    const char* text;
    const char* scope;
    const char* expected; // type's name, or the code of the first message
};

const Row kRows[] = {
    {"Main.i + 1", "", "INT"},
    {"i + 1", "Main", "INT"},
    {"i", "", "P2001"},
    {"flow > 1.0", "Main.a", "BOOL"},
    {"hours[2]", "Main.b", "DINT"},
    {"hours[4]", "Main.b", "P2016"},
    {"Main.a.mode = Run", "", "BOOL"},
    {"mode", "Main.a", "Mode"},
    {"Mode.Run", "", "Mode"},
    {"level > LIMIT_HIGH", "", "BOOL"},
    {"LIMIT_HIGH", "", "INT"},
    {"%IX0.3", "", "BOOL"},
    {"MAX(level, 3)", "", "INT"},
    {"INT_TO_REAL(level) * 2", "", "REAL"},
    {"CONCAT('a', INT_TO_STRING(level))", "", "STRING(255)"},
    {"Twice(3)", "", "P2035"},
    {"Main.a.Count()", "", "P2035"},
    {"Main.a(on := TRUE)", "", "P2035"},
    {"scratch", "Main.a", "P2035"},
    {"level := 3", "", "P1013"},
    {"level +", "", "P1010"},
    {"TIME() > T#5s", "", "BOOL"},
    {"THIS^.flow", "Main.a", "REAL"},
    {"Main.a", "", "Pump"},
    {"1 + 2", "", "INT"},
    {"0.5", "", "LREAL"},
    {"lvel", "", "P2001"},
};

} // namespace

TEST(Expressions, AreSeenFromTheirInstance) {
    ASSERT_FALSE(plant().analysis->hasErrors) << plant().all();
    for (const Row& row : kRows) {
        Arena arena;
        const sema::CheckedExpression checked =
            sema::checkExpression(*plant().analysis, *plant().sources, row.text, row.scope, arena);
        std::string seen;
        if (checked.root)
            seen = (*plant().analysis->program->types)[checked.root->type].name;
        else if (!checked.diagnostics.empty())
            seen = std::string(diagnostics::codeOf(checked.diagnostics.front().kind));
        EXPECT_EQ(seen, row.expected) << row.text << " in '" << row.scope << "'"
                                      << (checked.diagnostics.empty()
                                              ? ""
                                              : ": " + checked.diagnostics.front().message.english());
    }
}

TEST(Expressions, InstanceVariablesBecomeAbsolute) {
    Arena arena;
    const auto checked = sema::checkExpression(*plant().analysis, *plant().sources, "flow", "Main.b", arena);
    ASSERT_TRUE(checked.root);
    const auto place = plant().analysis->program->layout.find("Main.b.flow");
    ASSERT_TRUE(place);
    EXPECT_EQ(checked.root->place->kind, tree::PlaceKind::Absolute);
    EXPECT_EQ(checked.root->place->offset, place->offset);
}

TEST(Expressions, ManyAtATimeLeaveTheProgramAlone) {
    const size_t before = plant().analysis->program->types->count();
    for (const Row& row : kRows) {
        Arena arena;
        static_cast<void>(sema::checkExpression(*plant().analysis, *plant().sources, row.text, row.scope, arena));
    }
    EXPECT_EQ(plant().analysis->program->types->count(), before);
}
