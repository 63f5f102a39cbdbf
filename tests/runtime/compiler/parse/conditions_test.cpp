// Conditional pragmas: which branch is read, what a condition may ask, what is said of wrong ones, and messages of the
// program's own.
#include "tests/runtime/compiler/parse/outline.h"

#include <gtest/gtest.h>

using namespace plc::parse::testing;

namespace {

std::string body(const std::string& statements) {
    return outline(*Parsed("PROGRAM a\n" + statements + "\nEND_PROGRAM").file);
}

} // namespace

TEST(ConditionalPragmas, OneBranchIsRead) {
    const std::string text =
        "{IF defined (fast)} x := 1; {ELSIF defined (slow)} x := 2; {ELSE} x := 3; {END_IF} y := 4;";
    EXPECT_EQ(body("{define fast}" + text), "PROGRAM a ST{x := 1; y := 4}");
    EXPECT_EQ(body("{define slow}" + text), "PROGRAM a ST{x := 2; y := 4}");
    EXPECT_EQ(body(text), "PROGRAM a ST{x := 3; y := 4}");
    EXPECT_EQ(body("{define fast}{undefine FAST}" + text), "PROGRAM a ST{x := 3; y := 4}");
}

TEST(ConditionalPragmas, ConditionsCombine) {
    struct Row {
        const char* condition;
        bool holds;
    };
    for (const Row& row : {Row{"defined (a)", true}, Row{"defined(b)", false}, Row{"NOT defined (b)", true},
                           Row{"defined (a) AND defined (b)", false}, Row{"defined (b) OR defined (a)", true},
                           Row{"NOT (defined (a) AND defined (b))", true}, Row{"hasvalue (v, '12')", true},
                           Row{"hasvalue (v, '13')", false}, Row{"hasvalue (a, '')", true},
                           Row{"not defined (b) and (defined (a) or defined (b))", true}})
        EXPECT_EQ(body("{define a}{define v '12'}{IF " + std::string(row.condition) + "} x := 1; {END_IF}"),
                  row.holds ? "PROGRAM a ST{x := 1}" : "PROGRAM a")
            << row.condition;
}

TEST(ConditionalPragmas, NestInDeclarationsAndBodies) {
    EXPECT_EQ(outline(*Parsed("PROGRAM a VAR {IF defined (b)} x : INT; {ELSE} {IF defined (c)} x : REAL; {ELSE} x : "
                              "BOOL; {END_IF} {END_IF} END_VAR END_PROGRAM")
                           .file),
              "PROGRAM a VAR(x:BOOL)");
    // what is inside a branch that is not read counts for nothing: not its definitions, not its attributes
    EXPECT_EQ(body("{IF defined (b)} {define c} {error 'never'} {END_IF} {IF defined (c)} x := 1; {END_IF}"),
              "PROGRAM a");
}

TEST(ConditionalPragmas, WrongOnesAreReportedAtTheirPlace) {
    const auto codes = [](const std::string& text) { return Parsed("PROGRAM a\n" + text + "\nEND_PROGRAM").codes(); };
    EXPECT_NE(codes("{IF defined (b)} x := 1;").find("P1029"), std::string::npos);
    EXPECT_NE(codes("{END_IF}").find("P1029"), std::string::npos);
    EXPECT_NE(codes("{ELSE}").find("P1029"), std::string::npos);
    EXPECT_NE(codes("{IF defined (a)}{ELSE}{ELSE}{END_IF}").find("P1029"), std::string::npos);
    for (const char* condition : {"", "a", "defined a", "defined ()", "defined (x: y)", "defined (a) AND",
                                  "defined (a) defined (b)", "hasvalue (", "maybe (a)", "((((((("})
        EXPECT_NE(codes("{IF " + std::string(condition) + "}{END_IF}").find("P1028"), std::string::npos) << condition;
}

TEST(ConditionalPragmas, MessagesOfTheProgramAreItsOwn) {
    const auto codes = [](const std::string& text) { return Parsed("PROGRAM a\n" + text + "\nEND_PROGRAM").codes(); };
    EXPECT_NE(codes("{error 'not for this machine'}").find("P1025"), std::string::npos);
    EXPECT_NE(codes("{warning 'old'}").find("P1026"), std::string::npos);
    EXPECT_NE(codes("{info 'here'}").find("P1027"), std::string::npos);
    EXPECT_EQ(codes("{warning disable C0195}"), "");
}

TEST(ConditionalPragmas, CodeInCIsPassedOverWithAWarning) {
    const Parsed parsed("PROGRAM a\nx := 1;\n{{ if (x) { y(\"}\"); }\n }}\ny := 2;\nEND_PROGRAM");
    EXPECT_EQ(outline(*parsed.file), "PROGRAM a ST{x := 1; y := 2}");
    EXPECT_EQ(parsed.errors(), 0u);
    EXPECT_NE(parsed.codes().find("P1030"), std::string::npos);
}

TEST(ConditionalPragmas, TheValueOfAnAttributeMayHaveSeveralLines) {
    const Parsed parsed("{attribute 'text' := 'first\n  second\n'}\nPROGRAM a\nx := 1;\nEND_PROGRAM");
    EXPECT_EQ(outline(*parsed.file), "PROGRAM a ST{x := 1}");
    EXPECT_EQ(parsed.errors(), 0u) << parsed.codes();
}
