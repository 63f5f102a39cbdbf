#include "tests/runtime/compiler/parse/outline.h"

#include <gtest/gtest.h>

using namespace plc::parse::testing;
using plc::syntax::VarDecl;

namespace {
struct Row {
    const char* text;
    const char* outline;
};
void check(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        const Parsed parsed(row.text);
        EXPECT_EQ(outline(*parsed.file), row.outline) << row.text;
        EXPECT_EQ(parsed.errors(), 0u) << row.text << "\n" << parsed.codes();
    }
}
} // namespace

TEST(Declarations, OfUnits) {
    check({
        {"PROGRAM a VAR x : INT; END_VAR x := 1; END_PROGRAM", "PROGRAM a VAR(x:INT) ST{x := 1}"},
        {"FUNCTION f : REAL VAR_INPUT a, b : REAL := 1.5; END_VAR VAR_OUTPUT c : INT; END_VAR f := a; END_FUNCTION",
         "FUNCTION f:REAL IN(a,b:REAL=1.5) OUT(c:INT) ST{f := a}"},
        {"FUNCTION f f2(); END_FUNCTION;", "FUNCTION f ST{f2()}"},
        {"FUNCTION_BLOCK PUBLIC ABSTRACT Motor EXTENDS lib.Base IMPLEMENTS IRun, IStop END_FUNCTION_BLOCK",
         "FB public abstract Motor extends lib.Base implements IRun implements IStop"},
        {"FUNCTION_BLOCK F VAR END_VAR METHOD PRIVATE go : BOOL VAR_INPUT n : INT; END_VAR go := n > 1; END_METHOD "
         "METHOD OVERRIDE stop END_METHOD x := 1; END_FUNCTION_BLOCK",
         "FB F VAR() ST{x := 1} <METHOD private go:BOOL IN(n:INT) ST{go := (n > 1)}> <METHOD override stop>"},
        {"FUNCTION_BLOCK F PROPERTY PUBLIC Speed : REAL GET Speed := 1; END_GET SET VAR t : INT; END_VAR s := Speed; "
         "END_SET END_PROPERTY END_FUNCTION_BLOCK",
         "FB F <PROPERTY public Speed:REAL GET GET ST{Speed := 1} SET SET VAR(t:INT) ST{s := Speed}>"},
        {"INTERFACE I EXTENDS J, K METHOD go : BOOL VAR_INPUT a : INT; END_VAR END_METHOD PROPERTY p : INT GET END_GET "
         "END_PROPERTY END_INTERFACE",
         "INTERFACE I extends J extends K <METHOD go:BOOL IN(a:INT)> <PROPERTY p:INT GET GET>"},
        {"INTERFACE I PROPERTY p : INT GET SET END_PROPERTY METHOD q END_METHOD END_INTERFACE",
         "INTERFACE I <METHOD q> <PROPERTY p:INT GET GET SET SET>"},
        {"PROGRAM a go(); ACTION go : x := 1; END_ACTION END_PROGRAM", "PROGRAM a ST{go()} <ACTION go ST{x := 1}>"},
        {"PROGRAM a go(); END_PROGRAM ACTION go x := 1; END_ACTION", "PROGRAM a ST{go()} <ACTION go ST{x := 1}>"},
        {"FUNCTION_BLOCK b END_FUNCTION_BLOCK METHOD m END_METHOD", "FB b <METHOD m>"},
        {"NAMESPACE A.B USING C; TYPE t : INT; END_TYPE NAMESPACE D PROGRAM p END_PROGRAM END_NAMESPACE END_NAMESPACE",
         "NAMESPACE A.B {USING C | TYPE t:INT | NAMESPACE D {PROGRAM p}}"},
        {"USING A.B, C;", "USING A.B C"},
        {"{gvl PSCont} VAR_GLOBAL CONSTANT MAX : INT := 6; END_VAR", "GVL PSCont GLOBAL constant(MAX:INT=6)"},
    });
}

TEST(Declarations, OfTypes) {
    check({
        {"TYPE Light : (RED, GREEN := 5, BLUE) := RED; END_TYPE", "TYPE Light:enum(RED,GREEN=5,BLUE)=RED"},
        {"TYPE Light : (RED, GREEN) UINT; END_TYPE", "TYPE Light:enum(RED,GREEN)UINT"},
        {"TYPE Light : USINT (RED := 1, GREEN) := GREEN; a : INT; END_TYPE",
         "TYPE Light:enum(RED=1,GREEN)USINT=GREEN | TYPE a:INT"},
        {"TYPE S : STRUCT a, b : INT := 1; c : ARRAY[1..3] OF TON; END_STRUCT END_TYPE",
         "TYPE S:struct{a,b:INT=1; c:array[1..3] TON}"},
        {"TYPE S EXTENDS B : STRUCT END_STRUCT; END_TYPE", "TYPE S:struct extends B{}"},
        {"TYPE S : STRUCT EXTENDS B x : STRUCT y : INT; END_STRUCT; END_STRUCT; END_TYPE",
         "TYPE S:struct extends B{x:struct{y:INT}}"},
        {"TYPE U : UNION a : REAL; b : DWORD; END_UNION END_TYPE", "TYPE U:union{a:REAL; b:DWORD}"},
        {"TYPE R : INT (-5..5) := 0; A : ARRAY[0..2, 1..N*2] OF STRING[5]; P : POINTER TO INT; Q : REF_TO Motor; V : "
         "REFERENCE TO A; END_TYPE",
         "TYPE R:INT((- 5)..5)=0 | TYPE A:array[0..2, 1..(N * 2)] STRING(5) | TYPE P:pointer INT | TYPE Q:ref_to Motor "
         "| TYPE V:reference A"},
    });
}

TEST(Declarations, OfVariables) {
    check({
        {"PROGRAM p VAR RETAIN x AT %QX0.0 : BOOL; L1 : AT %IX0.1 BOOL := TRUE; AT %MW2 : INT; END_VAR END_PROGRAM",
         "PROGRAM p VAR retain(x@%QX0.0:BOOL; L1@%IX0.1:BOOL=TRUE; @%MW2:INT)"},
        {"PROGRAM p VAR_INPUT a, b : BOOL R_EDGE; c : BOOL F_EDGE; END_VAR END_PROGRAM",
         "PROGRAM p IN(a,b:BOOL rising; c:BOOL falling)"},
        {"PROGRAM p VAR m : Motor(speed := 5); t : TON := (PT := T#1s); a : ARRAY[1..3] OF INT := [1, 2(0)]; b : "
         "ARRAY[1..3] OF INT := 1, 2(0); END_VAR END_PROGRAM",
         "PROGRAM p VAR(m:Motor(speed := 5); t:TON={PT := T#1s}; a:array[1..3] INT=[1, 2*(0)]; b:array[1..3] INT=[1, "
         "2*(0)])"},
        {"FUNCTION f : INT VAR_IN_OUT a : ARRAY[*, *] OF REAL; END_VAR VAR_TEMP t : STRING(10) := 'x'; END_VAR "
         "VAR_STAT s : LREAL; END_VAR END_FUNCTION",
         "FUNCTION f:INT IN_OUT(a:array[*, *] REAL) TEMP(t:STRING(10)='x') STAT(s:LREAL)"},
        {"PROGRAM p VAR \"a b\" : INT; w : WSTRING; END_VAR x := #y + \"A b\"; w := \"a b c\"; END_PROGRAM",
         "PROGRAM p VAR(a b:INT; w:WSTRING) ST{x := (y + A b); w := \"a b c\"}"},
        {"PROGRAM p VAR T, IN, ST, N, R, d, z, CONSTANT : INT; END_VAR END_PROGRAM",
         "PROGRAM p VAR(T,IN,ST,N,R,d,z,CONSTANT:INT)"},
        {"PROGRAM p VAR_EXTERNAL CONSTANT g : INT; END_VAR VAR PERSISTENT RETAIN h : INT; END_VAR END_PROGRAM",
         "PROGRAM p EXTERNAL constant(g:INT) VAR retain persistent(h:INT)"},
    });
}

TEST(Declarations, OfConfigurations) {
    check({{"CONFIGURATION c VAR_GLOBAL g AT %QX0.0 : BOOL; END_VAR RESOURCE r ON cpu TASK fast(INTERVAL := T#10ms, "
            "PRIORITY := 1, WATCHDOG := T#5ms); TASK ev(SINGLE := g, PRIORITY := 2);"
            " PROGRAM p1 WITH fast : Main(in := %IX0.0, out => g); END_RESOURCE VAR_CONFIG r.p1.x AT %QW1 "
            ": INT := 3; END_VAR VAR_ACCESS a : r.p1.y : REAL READ_ONLY; b : r.%IX1.1 : BOOL READ_WRITE; END_VAR "
            "END_CONFIGURATION",
            "CONFIGURATION c GLOBAL(g@%QX0.0:BOOL) CONFIG(r.p1.x@%QW1:INT=3) ACCESS(a = r.p1.y:REAL read only; b = "
            "r@%IX1.1:BOOL) RESOURCE(r on cpu TASK fast every T#10ms prio 1WATCHDOG := T#5ms TASK ev at g prio 2"
            " PROGRAM p1 with fast:Main(in := %IX0.0, out => g))"},
           {"CONFIGURATION c TASK t(INTERVAL := T#1s); PROGRAM RETAIN main WITH t : Lib.Main; END_CONFIGURATION",
            "CONFIGURATION c RESOURCE( on  TASK t every T#1s PROGRAM main with t:Lib.Main())"}});
}

TEST(Charts, OfStepsTransitionsAndActions) {
    check({{"PROGRAM p INITIAL_STEP S0: END_STEP STEP S1 {minTime := T#1s} {maxTime := T#5s}: a(N); b(D, T#2s); c(SL, "
            "t, lamp, horn); d; END_STEP"
            " TRANSITION FROM S0 TO (S1, S2) := x & S0.T > T#1s; END_TRANSITION TRANSITION t2 (PRIORITY := 1) FROM "
            "(S1, S2) TO S0 : LD a\nAND b END_TRANSITION"
            " ACTION a: x := 1; END_ACTION ACTION c: LD x\nST y END_ACTION STEP S2: END_STEP END_PROGRAM",
            "PROGRAM p SFC{initial S0; step S1 a(N) b(D,T#2s) c(SL,t,lamp,horn) d() {minTime=T#1s} {maxTime=T#5s}; "
            "step S2; from S0 to S1,S2 when (x AND (S0.T > T#1s));"
            " from S1,S2 to S0 prio 1 when IL LD a; AND b; action a ST{x := 1}; action c IL{LD x; ST y}}"}});
}

TEST(Declarations, MissTheirEndInTwoPaneTexts) {
    const Parsed parsed(
        "FUNCTION f : INT\nVAR_INPUT a : INT; END_VAR\nf := a;\n\nPROGRAM p\nVAR x : INT; END_VAR\nx := f(1);\n");
    EXPECT_EQ(outline(*parsed.file), "FUNCTION f:INT IN(a:INT) ST{f := a} | PROGRAM p VAR(x:INT) ST{x := f(1)}");
    EXPECT_EQ(parsed.codes(), "P1021@3:7 P1021@7:10");
    EXPECT_FALSE(parsed.file->declarations[0]->pou->hasEnd);
}

TEST(Declarations, KeepTheirCommentsAndPragmas) {
    const Parsed parsed("(* about the file *)\n\n(** Runs a motor.\n    Twice. *)\n{attribute 'simulation'}\nPROGRAM "
                        "p\nVAR\n    a : INT; // first\n    // above b\n    // and more\n    b : INT;\n    c, "
                        "{attribute 'hide'} d : INT; (* c *) e : INT;\nEND_VAR\nEND_PROGRAM\n"
                        "TYPE t : (RED, // hot\n GREEN (* cool *)); END_TYPE");
    const auto& pou = *parsed.file->declarations[0]->pou;
    EXPECT_EQ(pou.comment, "Runs a motor.\n    Twice.");
    ASSERT_EQ(pou.pragmas.size(), 1u);
    EXPECT_TRUE(pou.pragmas[0].isAttribute);
    EXPECT_EQ(pou.pragmas[0].key, "simulation");
    const auto& declarations = pou.sections[0]->declarations;
    EXPECT_EQ(declarations[0]->comment, "first");
    EXPECT_EQ(declarations[1]->comment, "above b\nand more");
    EXPECT_EQ(declarations[2]->comment, "c");
    EXPECT_EQ(parsed.file->declarations[1]->type->spec->enumerators[0].comment, "hot");
    EXPECT_EQ(parsed.codes(), "");
}
