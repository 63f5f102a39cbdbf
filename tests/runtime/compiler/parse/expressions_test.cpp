#include "tests/runtime/compiler/parse/outline.h"

#include <gtest/gtest.h>

using namespace plc::parse::testing;

namespace {
struct Row {
    const char* text;
    const char* outline;
};
} // namespace

TEST(Expressions, BindAsThePrecedenceTableSays) {
    for (const Row& row : {
             Row{"a + b * c", "(a + (b * c))"},
             {"a OR b AND c", "(a OR (b AND c))"},
             {"a OR b XOR c AND d", "(a OR (b XOR (c AND d)))"},
             {"a = b AND c <> d", "((a = b) AND (c <> d))"},
             {"a < b = c > d", "((a < b) = (c > d))"},
             {"NOT a AND b", "((NOT a) AND b)"},
             {"-a + b", "((- a) + b)"},
             {"-2 ** 2", "((- 2) ** 2)"},
             {"2 ** 3 ** 4", "((2 ** 3) ** 4)"},
             {"a - b - c", "((a - b) - c)"},
             {"a MOD b / c", "((a MOD b) / c)"},
             {"a & b", "(a AND b)"},
             {"a AND_THEN b OR_ELSE c", "((a AND_THEN b) OR_ELSE c)"},
             {"(a + b) * c", "((a + b) * c)"},
             {"NOT (a = b)", "(NOT (a = b))"},
             {"a * -1", "(a * (- 1))"},
         })
        EXPECT_EQ(expressionOutline(row.text), row.outline) << row.text;
}

TEST(Expressions, ReachMembersBitsElementsAndReferences) {
    for (const Row& row : {
             Row{"a.b.c", "a.b.c"},
             {"w.3", "w.:3"},
             {"w.%X3", "w.:%X3"},
             {"d.%B1.2", "d.:%B1.:2"},
             {"arr[1, 2].x[i + 1]", "arr[1, 2].x[(i + 1)]"},
             {"p^.q", "p^.q"},
             {"THIS^.x", "THIS^.x"},
             {"SUPER^.run()", "SUPER^.run()"},
             {"SUPER.run()", "SUPER.run()"},
             {"#local + 1", "(local + 1)"},
             {"\"Motor 1\".speed", "Motor 1.speed"},
             {"\"text\"", "\"text\""},
             {"f(a, b := 2, c => d, NOT e => g)", "f(a, b := 2, c => d, NOT e => g)"},
             {"fb(IN := , PT := T#1s)", "fb(IN := _, PT := T#1s)"},
             {"AND(a, b, c)", "AND(a, b, c)"},
             {"MOD(a, 2)", "MOD(a, 2)"},
             {"OR(JOG, x.X) & b", "(OR(JOG, x.X) AND b)"},
             {"step1.X AND step1.T > T#1s", "(step1.X AND (step1.T > T#1s))"},
             {"a\n  . b", "a.b"},
             {"Lib.Color#Red", "Lib.Color.Red"},
         })
        EXPECT_EQ(expressionOutline(row.text), row.outline) << row.text;
}

TEST(Expressions, ReadEveryLiteral) {
    for (const Row& row : {
             Row{"16#FF_00", "16#FF_00"},
             {"2#0001_0000", "2#0001_0000"},
             {"INT#16#7F", "INT#16#7F"},
             {"int#-5", "int#-5"},
             {"BOOL#1", "BOOL#1"},
             {"BOOL#TRUE", "BOOL#TRUE"},
             {"REAL#1.5e-3", "REAL#1.5e-3"},
             {"1.234567e+13", "1.234567e+13"},
             {"1e6", "1e6"},
             {"C#998", "C#998"},
             {"t#0s", "t#0s"},
             {"TIME#1d2h_3m4.5s", "TIME#1d2h_3m4.5s"},
             {"T#5s12ms23us300ns", "T#5s12ms23us300ns"},
             {"LTIME#-1h", "LTIME#-1h"},
             {"D#1996-3-15", "D#1996-3-15"},
             {"DT#1996-03-15-12:30:00.5", "DT#1996-03-15-12:30:00.5"},
             {"TIME_OF_DAY#1:10:3.3", "TIME_OF_DAY#1:10:3.3"},
             {"LDATE#2020-01-01", "LDATE#2020-01-01"},
             {"'it$'s $$5 $L$0A'", "'it$'s $$5 $L$0A'"},
             {"STRING#'a'", "STRING#'a'"},
             {"Color#Red", "Color#Red"},
             {"%IX0.0 OR %mw2 = 3 OR %I0.1", "((%IX0.0 OR (%mw2 = 3)) OR %I0.1)"},
             {"T + t", "(T + t)"},
             {"[1, 3(0), 2(1, 2)]", "[1, 3*(0), 2*(1, 2)]"},
             {"(x := 1, y := (z := 2))", "{x := 1, y := {z := 2}}"},
         })
        EXPECT_EQ(expressionOutline(row.text), row.outline) << row.text;
}

TEST(Expressions, TellOfWhatCanNotBeRead) {
    for (const Row& row : {
             Row{"a +", "(a + error) !"},
             {"", "null !"},
             {"16#", "16# !"},
             {"2#12", "2#12 !"},
             {"T#1q", "T#1q !"},
             {"T#1s2h", "T#1s2h !"},
             {"D#1996-3", "D#1996-3 !"},
             {"'a$Zb'", "'a$Zb' !"},
             {"a b", "a !"},
             {"(a", "a !"},
             {"a := b", "a !"},
             {"3x", "3x !"},
         })
        EXPECT_EQ(expressionOutline(row.text), row.outline) << row.text;
}

TEST(Expressions, RefuseTreesDeeperThanAWalkerMayGo) {
    std::string deep(5000, '(');
    EXPECT_EQ(Parsed("PROGRAM p\nx := " + deep + ";\ny := 1;\nEND_PROGRAM").codes().substr(0, 5), "P1019");
    std::string sum = "1";
    for (int i = 0; i < 3000; ++i) sum += "+1";
    const Parsed parsed("PROGRAM p\nx := " + sum + ";\nEND_PROGRAM");
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(plc::diagnostics::codeOf(parsed.diagnostics[0].kind), "P1019");
    std::string terms = "1";
    for (int i = 0; i < 500; ++i) terms += "+1";
    EXPECT_EQ(Parsed("PROGRAM p\nx := " + terms + ";\nEND_PROGRAM").codes(), "");
    std::string nots;
    for (int i = 0; i < 5000; ++i) nots += "NOT ";
    EXPECT_EQ(Parsed("PROGRAM p\nx := " + nots + "a;\nEND_PROGRAM").diagnostics.size(), 1u);
    std::string ifs;
    for (int i = 0; i < 3000; ++i) ifs += "IF a THEN ";
    EXPECT_EQ(Parsed("PROGRAM p\n" + ifs + "\nEND_PROGRAM").diagnostics.size(), 1u);
}
