#include "tests/runtime/compiler/parse/outline.h"

#include <gtest/gtest.h>

using namespace plc::parse::testing;

namespace {
struct Row {
    const char* text;
    const char* outline;
};
} // namespace

TEST(Statements, AreReadAsWritten) {
    for (const Row& row : {
             Row{"a := b;", "a := b"},
             {"a := b := c;", "a := (b := c)"},
             {"a S= b; c R= d; r REF= x; p ?= q;", "a S= b; c R= d; r REF= x; p ?= q"},
             {"IF S=1 AND R=2 THEN x := S=3; END_IF", "IF ((S = 1) AND (R = 2)) {x := (S = 3)}"},
             {"IF a THEN b := 1; ELSIF c THEN d(); ELSE ; END_IF;", "IF a {b := 1} c {d()} else {;}"},
             {"IF a THEN b := 1; END_IF c := 2;", "IF a {b := 1}; c := 2"},
             {"CASE s OF 1, 3..5: a(); RED: Light.GREEN, -1: b(); ELSE c(); END_CASE",
              "CASE s 1,3..5: {a()} RED: {} Light.GREEN,(- 1): {b()} else {c()}"},
             {"CASE s OF\n 10 : IF a THEN b := 1; END_IF\n 20 :\n END_CASE d();",
              "CASE s 10: {IF a {b := 1}} 20: {}; d()"},
             {"CASE s OF 1: x := 1\nEND_CASE", "CASE s 1: {x := 1}"},
             {"FOR i := 1 TO n BY -1 DO EXIT; END_FOR", "FOR i 1 n by (- 1) {EXIT}"},
             {"FOR s.i := 0 TO 6 DO CONTINUE; END_FOR;", "FOR s.i 0 6 {CONTINUE}"},
             {"WHILE a < 3 DO a := a + 1; END_WHILE;", "WHILE (a < 3) {a := (a + 1)}"},
             {"REPEAT a := 1; UNTIL b END_REPEAT;", "REPEAT {a := 1} b"},
             {"again: a := 1; JMP again; RETURN;", "again:; a := 1; JMP again; RETURN"},
             {"T := T#1s; ST := 1; N := IN; LD := R; STEP := 2; ACTION := 3; TASK.x := 1;",
              "T := T#1s; ST := 1; N := IN; LD := R; STEP := 2; ACTION := 3; TASK.x := 1"},
             {"RUN := TRUE; ASSERT(x); FORCE.a := 1;", "RUN := TRUE; ASSERT(x); FORCE.a := 1"},
             {"ton1(IN := a, PT := T#1s, Q => b);", "ton1(IN := a, PT := T#1s, Q => b)"},
             {"arr[i].run(1); THIS^.go(); SUPER^();", "arr[i].run(1); THIS^.go(); SUPER^()"},
             {"\"Motor 1\".run := TRUE; #x := 1;", "Motor 1.run := TRUE; x := 1"},
             {"%QX0.0 := %IX0.1; x.%X3 := TRUE; x.5 S= a;", "%QX0.0 := %IX0.1; x.:%X3 := TRUE; x.:5 S= a"},
             {"(* a (* b *) c *) a := 1; // d\n/* e */ b := 2; {region 'x'} c := 3;", "a := 1; b := 2; c := 3"},
             {"größe := 1; 温度 := 2;", "größe := 1; 温度 := 2"},
             {"x := (a := 1, b := 2);", "x := {a := 1, b := 2}"},
             {"AND(a, b);", "AND(a, b)"},
             {"RETURN a > 5;", "RETURN (a > 5)"},
         })
        EXPECT_EQ(statementsOutline(row.text), row.outline) << row.text;
}

TEST(InstructionLists, AreKnownByTheirFirstLine) {
    for (const Row& row : {
             Row{"LD a\nAND b\nST c", "LD a; AND b; ST c"},
             {"LDN a\nANDN b\nSTN c\nORN d\nS e\nR f", "LD! a; AND! b; ST! c; OR! d; S e; R f"},
             {"LD a\nAND( b\nOR c\n)\nST d", "LD a; AND( b {OR c}); ST d"},
             {"LD a\nAND(\nLD b\nORN( c\nAND d\n)\n)\nST e", "LD a; AND( {LD b; OR!( c {AND d})}); ST e"},
             {"start: LD 1\nJMPC next\nJMPCN start\nRETC\nnext:\nRET",
              "start: LD 1; JMP? next; JMP!? start; RET?; next: RET"},
             {"CAL t1(IN := a,\n  PT := T#1s,\n  Q => b)\nLD a\nCALCN t1\nCAL LIMIT(MN:=1,IN:=N,MX:=128)",
              "CAL t1 [IN := a, PT := T#1s, Q => b]; LD a; CAL!? t1; CAL LIMIT [MN := 1, IN := N, MX := 128]"},
             {"LD a\nSHL 2\nLIMIT b, c\nBCD_TO_INT\nST d", "LD a; SHL 2; LIMIT b [c]; BCD_TO_INT; ST d"},
             {"LD a\nLIMIT(MN := 1, MX := 2)\nST d", "LD a; LIMIT [MN := 1, MX := 2]; ST d"},
             {"LD a\nS1 ff\nLD b\nIN tmr\nST t", "LD a; S1 ff; LD b; IN tmr; ST t"},
             {"LD -1\nADD 5\nNOT\nMOD 3\nGT STK[PTR]\nST x.y\n&N c\nST %QX0.0",
              "LD (- 1); ADD 5; NOT; MOD 3; GT STK[PTR]; ST x.y; &! c; ST %QX0.0"},
             {"JMP there", "JMP there"},
         })
        EXPECT_EQ(statementsOutline(row.text), row.outline) << row.text;
    const Parsed parsed("PROGRAM p\nLD a\nST b\nEND_PROGRAM\n{language 'ST'}\nPROGRAM q\nJMP "
                        "l;\nEND_PROGRAM\n{language 'IL'}\nPROGRAM r\nIN timer\nEND_PROGRAM");
    EXPECT_EQ(outline(*parsed.file), "PROGRAM p IL{LD a; ST b} | PROGRAM q ST{JMP l} | PROGRAM r IL{IN timer}");
}

TEST(Tests, HaveStatementsOfTheirOwn) {
    const Parsed parsed("TEST 'fills the bin'\nVAR n : INT; END_VAR\nMain.start := TRUE;\nRUN T#5s;\nRUN 3 SCANS;\nRUN "
                        "UNTIL Main.full FOR T#10s;\n"
                        "FORCE Main.x := 1;\nRELEASE Main.x;\nASSERT Main.level > 5, 'too low';\nASSERT (a = b) AND "
                        "c;\nCOMPARE 'rec', TOLERANCE := 0.01;\nPOWER_OFF T#5s;\nEND_TEST\n");
    EXPECT_EQ(parsed.codes(), "");
    EXPECT_EQ(outline(*parsed.file),
              "TEST fills the bin VAR(n:INT) {Main.start := TRUE; RUN T#5s; RUN 3 scans; RUN until Main.full for "
              "T#10s; FORCE Main.x := 1; RELEASE Main.x; "
              "ASSERT (Main.level > 5), 'too low'; ASSERT ((a = b) AND c); COMPARE 'rec', 0.01; POWER_OFF T#5s}");
}
