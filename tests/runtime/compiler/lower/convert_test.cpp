#include "runtime/compiler/lower/convert.h"
#include "tests/runtime/compiler/parse/outline.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::parse::testing;

namespace {

std::string unit(const std::string& body) {
    return "FUNCTION p : INT\nVAR a, b, c, d : BOOL; i, j, k : INT; r : REAL; t : TON; arr : ARRAY[0..3] OF INT; w : "
           "WORD; END_VAR\n" +
           body + "\nEND_FUNCTION\n";
}

std::string asSt(const std::string& list) {
    Parsed parsed(unit(list));
    const syntax::Pou& pou = *parsed.file->declarations[0]->pou;
    const auto out = lower::instructionListAsSt(*parsed.file, pou, pou.body);
    return out ? out->declarations + out->body : out.error().message.english();
}
std::string asList(const std::string& statements) {
    Parsed parsed(unit(statements));
    const auto out = lower::stAsInstructionList(*parsed.file, parsed.file->declarations[0]->pou->body);
    return out ? out->body : out.error().message.english();
}

} // namespace

TEST(Conversion, ShowsAListAsSt) {
    EXPECT_EQ(asSt("LD a\nAND( b\nORN c\n)\nST d\nLD i\nADD 1\nST i\nGT 3\nJMPC out\nLD i\nLIMIT 0, 9\nST j\nout: RET"),
              "result1 : INT;\nresult2 : INT;\n"
              "d := a AND (b OR NOT c);\nresult1 := i + 1;\ni := result1;\nIF result1 > 3 THEN\n    JMP "
              "out;\nEND_IF\nresult2 := LIMIT(i, 0, 9);\nj := result2;\nout:\nRETURN;\n");
    EXPECT_EQ(asSt("LD w\nWeird\nST i"),
              "The type of Weird(w) is not known here; correct the errors of the program first");
}

TEST(Conversion, ShowsStAsAList) {
    EXPECT_EQ(asList("d := a AND (b OR NOT c);"), "          LD      a\n          AND(\n          LD      b\n          "
                                                  "ORN     c\n          )\n          ST      d\n");
    EXPECT_EQ(asList("IF a THEN i := 1; ELSE i := -2; END_IF\nt(IN := b);"),
              "          LD      a\n          JMPCN   l2\n          LD      1\n          ST      i\n          JMP     "
              "l1\nl2:       LD      -2\n          ST      i\nl1:       CAL     t(IN := b)\n");
    EXPECT_EQ(
        asList("FOR i := 1 TO j DO ; END_FOR"),
        "FOR with this end or step has no equivalent in an instruction list; write it with simpler statements first");
    EXPECT_EQ(asList("FOR i := 1 TO 3 DO j := i; END_FOR"),
              "          LD      1\n          ST      i\nl1:       LD      i\n          GT      3\n          JMPC    "
              "l3\n          LD      i\n          ST      j\n"
              "l2:       LD      i\n          ADD     1\n          ST      i\n          JMP     l1\nl3:       RET\n");
}

/// There and back: the statements mean the same, so the list of the list is the same list.
TEST(Conversion, BackAndForthSettles) {
    for (const char* statements :
         {"d := a AND (b OR NOT c);", "i := (i + 1) * (j - 2) / 3;",
          "IF a OR b AND c THEN i := 1; ELSIF d THEN i := LIMIT(0, j, 9); ELSE i := arr[2]; END_IF",
          "WHILE i < 10 DO i := i + 1; IF a THEN EXIT; END_IF END_WHILE", "REPEAT i := i - 1; UNTIL i < 0 END_REPEAT",
          "CASE i OF 1, 2: j := 1; 5..7: j := 2; ELSE j := 3; END_CASE",
          "a S= b; c R= NOT d; t(IN := a, PT := T#1s); b := t.Q; RETURN;"}) {
        const std::string list = asList(statements);
        const std::string st = asSt(list);
        const std::string again = asSt(asList(statements));
        EXPECT_EQ(st, again);
        Parsed parsed("FUNCTION p : INT\n" +
                      st.substr(st.rfind(" : ") == std::string::npos ? 0 : st.find(";\n", st.rfind(" : ")) + 2) +
                      "END_FUNCTION\n");
        EXPECT_EQ(parsed.errors(), 0u) << list << st;
    }
}
