#include "runtime/compiler/lower/lower.h"
#include "tests/runtime/compiler/parse/outline.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::parse::testing;

namespace {

struct Lowered {
    Parsed parsed;
    std::string codes;
    explicit Lowered(const std::string& text) : parsed(text) {
        diagnostics::Sink sink;
        lower::lowerFile(*parsed.file, sink);
        for (const auto& d : sink.all()) codes += (codes.empty() ? "" : " ") + std::string(diagnostics::codeOf(d.kind));
    }
    const syntax::Pou& pou() const { return *parsed.file->declarations.back()->pou; }
    std::string statements() const { return outline(pou().body.statements); }
    std::string variables() const { return pou().sections.empty() ? "" : outline(*pou().sections.back()); }
};

std::string program(const std::string& body, const std::string& variables = "") {
    return "PROGRAM p\n" + (variables.empty() ? "" : "VAR " + variables + " END_VAR\n") + body + "\nEND_PROGRAM\n";
}

std::string function(const std::string& body, const std::string& variables) {
    return "FUNCTION p\nVAR " + variables + " END_VAR\n" + body + "\nEND_FUNCTION\n";
}

struct Row {
    const char* list;
    const char* statements;
};

} // namespace

TEST(InstructionListLowering, FollowsTheCurrentResult) {
    for (const Row& row : {
             Row{"LD a\nST b", "b := a"},
             {"LDN a\nAND b\nORN c\nST d", "d := (((NOT a) AND b) OR (NOT c))"},
             {"LD a\nADD 1\nMUL b\nST c", "c := ((a + 1) * b)"},
             {"LD a\nAND( b\nOR c\n)\nSTN d", "d := (NOT (a AND (b OR c)))"},
             {"LD a\nS b\nLD c\nR d", "b S= a; d R= c"},
             {"LD 0\nST a\nST b", "a := 0; b := 0"},
             {"LD x\nSUB 1\nST x\nLT 0\nST y", "__il0 := (x - 1); x := __il0; y := (__il0 < 0)"},
             {"LD a\nNOT\nST b", "b := (NOT a)"},
             {"LD a\nLIMIT b, c\nST d", "__il0 := LIMIT(a, b, c); d := __il0"},
             {"LD 0\nLIMIT(MN := 1, IN := a, MX := 9)\nST d", "__il0 := LIMIT(MN := 1, IN := a, MX := 9); d := __il0"},
             {"LD w\nBCD_TO_INT\nST i", "__il0 := BCD_TO_INT(w); i := __il0"},
             {"CAL LIMIT(MN := 1, IN := a, MX := 9)\nST d", "d := LIMIT(MN := 1, IN := a, MX := 9)"},
             {"LD a\nCALC tmr(IN := b)\nCALCN tmr\nLD tmr.Q\nST c",
              "__il0 := a; IF __il0 {tmr(IN := b)}; IF (NOT __il0) {tmr()}; c := tmr.Q"},
             {"LD a\nIN tmr\nLD T#1s\nPT tmr\nLD tmr.Q\nST c", "tmr(IN := a); tmr(PT := T#1s); c := tmr.Q"},
             {"CAL tmr(IN := (LD a\nANDN b\n), PT := T#1s)", "tmr(IN := (a AND (NOT b)), PT := T#1s)"},
             {"LD a\nS1 ff\nLD b\nR ff", "ff(S1 := a); ff(R := b)"},
             {"LD a\nJMPC there\nLD b\nST c\nthere: RET", "JMP there if a; c := b; there:; RETURN"},
             {"LD a\nRETC\nJMPCN there\nthere:\nLD b\nST c",
              "__il0 := a; IF __il0 {RETURN}; JMP there if (NOT __il0); there:; c := b"},
             {"again: LD i\nADD 1\nST i\nLT 10\nJMPC again",
              "again:; __il0 := (i + 1); i := __il0; JMP again if (__il0 < 10)"},
             {"LD a\nJMPC x\nLD 5\nJMP out\nx: LD i\nout: ST j",
              "JMP x if a; __at_out_0 := 5; JMP out; x:; __at_out_0 := i; out:; j := __at_out_0"},
         }) {
        const Lowered lowered(function(row.list, "tmr : TON; ff : SR; a, b, c, d : BOOL; i : INT;"));
        EXPECT_EQ(lowered.statements(), row.statements) << row.list;
        EXPECT_EQ(lowered.codes, "") << row.list;
    }
}

TEST(InstructionListLowering, KeepsTheResultOfEachLineOfAProgram) {
    const Lowered lowered(program("LD a\nAND b\nST c\nLD 5\nST i", "a, b, c : BOOL; i : INT;"));
    EXPECT_EQ(lowered.statements(), "__il0 := a; __il1 := (__il0 AND b); c := __il1; i := 5");
    EXPECT_EQ(lowered.variables(), "VAR(__il0:inferred a; __il1:inferred (__il0 AND b))");
    const auto& decl = *lowered.pou().sections.back()->declarations[1];
    EXPECT_EQ(lowered.parsed.sources.files[0].slice(decl.range), "AND b");
}

TEST(InstructionListLowering, AFunctionThatStoresNothingUnderItsNameHasTheCurrentResult) {
    const std::string begin = "FUNCTION p : INT\nVAR a, b : INT; END_VAR\n", end = "\nEND_FUNCTION\n";
    EXPECT_EQ(Lowered(begin + "LD a\nADD b" + end).statements(), "p := (a + b)");
    EXPECT_EQ(Lowered(begin + "LD a\nST p\nLD b\nST a" + end).statements(), "p := a; a := b");
}

TEST(InstructionListLowering, GivesLabelVariablesTheTypeOfAValueThatHasOne) {
    const Lowered lowered(function("LD a\nJMPC x\nLD 5\nJMP out\nx: LD i\nout: ST j", "a : BOOL; i, j : INT;"));
    EXPECT_EQ(lowered.variables(), "VAR(__at_out_0:inferred i)");
}

TEST(InstructionListLowering, TellsMistakes) {
    EXPECT_EQ(Lowered(program("ST a", "a : BOOL;")).codes, "P4021");
    EXPECT_EQ(Lowered(program("LD a\nJMP x\nST b\nx: ST c")).codes, "P4021");
    EXPECT_EQ(Lowered(program("LD a\nJMP nowhere")).codes, "P3019");
    EXPECT_EQ(Lowered(program("LD a\nAND(\nx: LD b\n)\nST c")).codes, "P3018");
}

TEST(ChartLowering, DeclaresWhatAChartNeeds) {
    const Lowered lowered(program(
        "INITIAL_STEP A: x(N); END_STEP\nTRANSITION FROM A TO B := go; END_TRANSITION\nSTEP B: y(SD, T#1s); run(P1); "
        "END_STEP\nTRANSITION FROM B TO A := NOT go; END_TRANSITION\nACTION run: n := n + 1; END_ACTION",
        "go, x, y : BOOL; n : INT;"));
    EXPECT_EQ(lowered.codes, "");
    EXPECT_EQ(lowered.variables(),
              "VAR(A:SFC_STEP; B:SFC_STEP; __chart0:BOOL; __fired0:array[0..1] BOOL; __timed_y_0_0:SFC_STORED_DELAY; "
              "__action_x:SFC_ACTION; __action_y:SFC_ACTION; __action_run:SFC_ACTION)");
    EXPECT_EQ(lowered.statements(),
              "A.update(); B.update(); __fired0[0] := FALSE; __fired0[1] := FALSE; "
              "IF (NOT __chart0) {__chart0 := TRUE; A.enter := TRUE} else {"
              "IF (A.X AND (NOT A.leave)) {IF go {A.leave := TRUE; B.enter := TRUE; __fired0[0] := TRUE}}; "
              "IF (B.X AND (NOT B.leave)) {IF (NOT go) {B.leave := TRUE; A.enter := TRUE; __fired0[1] := TRUE}}}; "
              "A(); B(); IF A.on {A.enter := FALSE}; IF B.on {B.enter := FALSE}; "
              "__action_x(N := A.X, S := FALSE, R := FALSE, P1 := FALSE, P0 := FALSE); "
              "__timed_y_0_0(X := B.X, R := FALSE, PT := T#1s); __action_y(N := __timed_y_0_0.Q, S := FALSE, R := "
              "FALSE, P1 := FALSE, P0 := FALSE); "
              "__action_run(N := FALSE, S := FALSE, R := FALSE, P1 := B.on, P0 := FALSE); "
              "x := __action_x.B; y := __action_y.B; "
              "IF __action_run.last {run()}; IF __action_run.entry {run()}; IF __action_run.Q {run()}");
    EXPECT_EQ(lowered.pou().actions.size(), 1u);
}

TEST(ChartLowering, OrdersTransitionsByPriorityThenText) {
    const Lowered lowered(
        program("INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A := a; END_TRANSITION\nTRANSITION (PRIORITY := 2) "
                "FROM A TO A := b; END_TRANSITION\nTRANSITION (PRIORITY := 1) FROM A TO A := c; END_TRANSITION"));
    const std::string text = lowered.statements();
    EXPECT_LT(text.find("IF c "), text.find("IF b "));
    EXPECT_LT(text.find("IF b "), text.find("IF a "));
}

TEST(ChartLowering, KeepsPlacesInTheText) {
    const std::string text =
        program("INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A := go; END_TRANSITION", "go : BOOL;");
    const Lowered lowered(text);
    for (const syntax::Stmt* s : lowered.pou().body.statements) {
        EXPECT_LE(s->range.end, text.size());
        EXPECT_NE(text.substr(s->range.begin, s->range.length()), "");
    }
}

TEST(ChartLowering, RefusesChartsInFunctions) {
    EXPECT_EQ(
        Lowered("FUNCTION f : INT\nINITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A := x; END_TRANSITION\nEND_FUNCTION")
            .codes,
        "P3018");
}
