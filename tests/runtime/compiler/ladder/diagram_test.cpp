// What each statement looks like: the table of docs/ladder.md, row by row.
#include "opened.h"
#include "runtime/compiler/ladder/layout.h"

#include <gtest/gtest.h>

namespace plc::ladder {
namespace {

struct Row {
    const char* statements;
    const char* picture;
};

void expectPictures(Form form, std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        const Opened opened(program(std::string(row.statements) + "\n"), form);
        EXPECT_EQ(opened.errors, "") << row.statements;
        EXPECT_EQ(opened.words(), std::string(row.picture) + "\n") << row.statements;
    }
}

TEST(LadderDiagram, DrawsContactsInSeriesAndInParallel) {
    expectPictures(Form::Ladder, {{"y := a;", "a -> ()y"},
                                  {"y := NOT a;", "/a -> ()y"},
                                  {"y := a AND b AND NOT c;", "a b /c -> ()y"},
                                  {"y := a AND (b AND c);", "a b c -> ()y"},
                                  {"y := a OR b OR c;", "(a + b + c) -> ()y"},
                                  {"motor := (start OR motor) AND stop;", "(start + motor^) stop -> ()motor"},
                                  {"y := a AND b OR c AND d;", "(a b + c d) -> ()y"},
                                  {"y := a AND_THEN b;", "a && b -> ()y"},
                                  {"y := a OR_ELSE b;", "(a || b) -> ()y"},
                                  {"y := TRUE;", "-> ()y"},
                                  {"y := FALSE;", "FALSE -> ()y"}});
}

TEST(LadderDiagram, DrawsTheFourCoilsAndWhatIsWrittenWithIf) {
    expectPictures(Form::Ladder, {{"y := NOT (a AND b);", "a b -> (/)y"},
                                  {"y := NOT (a);", "a -> (/)y"},
                                  {"y S= a;", "a -> (S)y"},
                                  {"y R= a AND b;", "a b -> (R)y"},
                                  {"IF a THEN y := TRUE; END_IF", "a -> (S)y"},
                                  {"IF a THEN y := FALSE; END_IF", "a -> (R)y"},
                                  {"IF a THEN y := TRUE; z := FALSE; END_IF", "a -> (S)y | (R)z"},
                                  {"x := y := a;", "a -> ()y | ()x"}});
}

TEST(LadderDiagram, DrawsEdgesAndComparisonsAsContacts) {
    expectPictures(Form::Ladder, {{"up(CLK := a); y := up.Q;", "P:a -> ()y"},
                                  {"down(CLK := a);\ny := b AND NOT down.Q;", "b /N:a -> ()y"},
                                  {"up(CLK := a);\n\ny := up.Q;", "a -> R_TRIG:up[CLK=~]\nup.Q -> ()y"},
                                  {"y := i > 5;", "{i > 5} -> ()y"},
                                  {"y := a AND i + 1 <= j AND (b XOR c);", "a {i + 1 <= j} {b XOR c} -> ()y"},
                                  {"y := NOT (i > 5) AND a;", "/{i > 5} a -> ()y"}});
}

/// A mark says that a variable is read before it is written; a literal beside it is not.
TEST(LadderDiagram, MarksOfAComparisonOnlyWhatIsWrittenLater) {
    const Opened opened(program("y := i > 3;\ny := 3 < j;\ni := i + 1;\nj := 2;\n"));
    std::vector<std::string> marked;
    for (const RungPicture& rung : computeLayout(opened.diagram, {}).rungs)
        for (const Shape& shape : rung.shapes)
            if (shape.kind == ShapeKind::Text && shape.isMarked) marked.push_back(shape.text);
    EXPECT_EQ(marked, (std::vector<std::string>{"i", "j", "i"}));
}

TEST(LadderDiagram, InvertsTheWireOnlyWhereNothingStandsToTheLeft) {
    expectPictures(Form::Ladder, {{"y := NOT (a AND b) AND c;", "(a b) NOT c -> ()y"},
                                  {"y := c AND NOT (a AND b);", "c /a AND b -> ()y"}});
}

TEST(LadderDiagram, PutsABlockIntoTheRungThatBeginsWithItsOutput) {
    expectPictures(Form::Ladder,
                   {{"T1(IN := a AND b, PT := T#3s);", "a b -> TON:T1[IN=~ PT=T#3s]"},
                    {"T1(IN := a, PT := T#3s);\ny := T1.Q AND b;", "a TON:T1[IN=~ PT=T#3s]>.Q b -> ()y"},
                    {"T1(IN := NOT T1.Q, PT := t); y := T1.Q;", "/T1.Q^ TON:T1[IN=~ PT=t]>.Q -> ()y"},
                    {"C1(CU := a, R := b, PV := 5, CV => i);\ny := C1.Q;", "a CTU:C1[CU=~ R=b PV=5]>.Q.CV=>i -> ()y"},
                    {"T1(IN := a, PT := t);\nt := T1.ET;\ny := T1.Q;", "a TON:T1[IN=~ PT=t^]>.Q.ET=>t -> ()y"},
                    {"T1(IN := a, PT := t);\nS1(S1 := T1.Q AND b, R := c);\ny := S1.Q1;",
                     "a TON:T1[IN=~ PT=t]>.Q b SR:S1[S1=~ R=c]>.Q1 -> ()y"},
                    {"T1(IN := a, PT := t);\nx := b;", "a -> TON:T1[IN=~ PT=t]\nb -> ()x"},
                    {"T1(PT := t, IN := a);", "-> TON:T1[EN=~ PT=t IN=a]"}});
}

TEST(LadderDiagram, DrawsNumbersAsBoxesWithEnable) {
    expectPictures(Form::Ladder,
                   {{"i := 5;", "-> MOVE[EN=~ 5]=>i"},
                    {"i := i + 1;", "-> ADD[EN=~ i^ 1]=>i"},
                    {"i := j + k * 2;", "-> ADD[EN=~ j MUL[k 2]]=>i"},
                    {"i := j + k + 3;", "-> ADD[EN=~ j k 3]=>i"},
                    {"w := w AND v;", "-> AND[EN=~ w^ v]=>w"},
                    {"i := Limits(0, j, 10);", "-> Limits[EN=~ MN=0 IN=j MX=10]=>i"},
                    {"IF a AND b THEN i := 123; END_IF", "a b -> MOVE[EN=~ 123]=>i"},
                    {"IF a THEN i := 1; j := i * 2; END_IF", "a -> MOVE[EN=~ 1]=>i | MUL[EN=~ i^ 2]=>j"}});
}

TEST(LadderDiagram, BranchesAfterACommonBeginningThatNothingChanges) {
    expectPictures(Form::Ladder,
                   {{"x := a AND b;\ny := a AND b AND c;", "a b -> ()x | c ()y"},
                    {"x := a AND b;\ny := a AND c;\nz := a;", "a -> b ()x | c ()y | ()z"},
                    {"x := a;\ny := NOT (a);", "a -> ()x | (/)y"},
                    {"x := a AND b;\n\ny := a AND c;", "a b -> ()x\na c -> ()y"},
                    {"a := a AND b;\ny := a AND c;", "a^ b -> ()a\na c -> ()y"},
                    {"c := (a OR NOT c) AND b;\ny := (a OR NOT c) AND b;", "(a + /c^) b -> ()c\n(a + /c) b -> ()y"},
                    {"x := a AND b;\ny := b AND a;", "a b -> ()x\nb a -> ()y"},
                    {"IF a THEN i := 1; END_IF\ny := a;", "a -> MOVE[EN=~ 1]=>i | ()y"}});
}

TEST(LadderDiagram, FramesWhatRepeatsAndChooses) {
    expectPictures(
        Form::Ladder,
        {{"FOR i := 1 TO 10 BY 2 DO y := a; END_FOR", "<FOR i := 1 TO 10 BY 2> \n  a -> ()y\n<END_FOR> "},
         {"WHILE a AND b DO i := 1; END_WHILE", "<WHILE> a b\n  -> MOVE[EN=~ 1]=>i\n<END_WHILE> "},
         {"REPEAT i := 1; UNTIL a END_REPEAT", "<REPEAT> \n  -> MOVE[EN=~ 1]=>i\n<UNTIL> a"},
         {"IF a THEN x := b; ELSIF c THEN x := d; ELSE x := a; END_IF",
          "<IF> a\n  b -> ()x\n<ELSIF> c\n  d -> ()x\n<ELSE> \n  a -> ()x\n<END_IF> "},
         {"CASE i OF 1, 3..5: x := a; 2: y := b; ELSE z := c; END_CASE",
          "<CASE i> \n  <1, 3..5:> \n    a -> ()x\n  <2:> \n    b -> ()y\n  <ELSE> \n    c -> ()z\n<END_CASE> "}});
}

TEST(LadderDiagram, DrawsJumpsReturnsAndLabels) {
    expectPictures(Form::Ladder, {{"IF a THEN RETURN; END_IF", "a -> <RETURN>"},
                                  {"RETURN;", "-> <RETURN>"},
                                  {"IF a THEN JMP next; END_IF\nnext: x := b;", "a -> >>next\n<next> \nb -> ()x"},
                                  {"FOR i := 1 TO 3 DO IF a THEN EXIT; END_IF CONTINUE; END_FOR",
                                   "<FOR i := 1 TO 3> \n  a -> <EXIT>\n  -> <CONTINUE>\n<END_FOR> "}});
}

TEST(LadderDiagram, KeepsTheCommentsOfARungAndTheTitlesOfNetworks) {
    expectPictures(Form::Ladder, {{"// the lamp\nlamp := a; // shines\n\n(* more *)\n// of it\ny := b;",
                                   "# the lamp shines # a -> ()lamp\n# more of it # b -> ()y"},
                                  {"{network 'Safety'}\n// stops\ny := a;", "'Safety' # stops # a -> ()y"},
                                  {"y := a;\n// nothing below", "a -> ()y\n# nothing below # "}});
}

TEST(LadderDiagram, ShowsTextForWhatHasNoPicture) {
    Opened opened(program("y := a;\nx := ;\n"));
    EXPECT_NE(opened.words().find("<x := "), std::string::npos) << opened.words();
    EXPECT_EQ(opened.diagram.share.text, 1u);
    EXPECT_EQ(opened.diagram.share.drawn, 1u);
}

TEST(BlockDiagram, DrawsExpressionsAsTreesAndNumbersThem) {
    expectPictures(Form::Blocks,
                   {{"y := a AND NOT b;", "AND[a /b] -> ()y"},
                    {"y := NOT (a OR b) AND i > 3;", "AND[/OR[a b] GT[i 3]] -> ()y"},
                    {"i := j * (k + 1);", "MUL[j ADD[k 1]] -> ()i"},
                    {"y S= a;", "a -> (S)y"},
                    {"T1(IN := a AND b, PT := t);\ny := c AND T1.Q;", "AND[c TON:T1[IN=AND[a b] PT=t]>.Q] -> ()y"},
                    {"IF a THEN i := j + 1; END_IF", "a -> ADD[EN=~ j 1]=>i"},
                    {"h := a AND b;\nx := h;\ny := NOT h;", "AND[a b] -> ()h\nh~ -> ()x\n/h~ -> ()y"}});
    const Opened opened(program("y := (a AND b) OR (c AND d);\n"), Form::Blocks);
    std::vector<int> orders;
    for (const NodeId id : opened.diagram.nodesOf(opened.diagram.rungs[0]))
        if (opened.diagram[id].kind == NodeKind::Box) orders.push_back(opened.diagram[id].order);
    EXPECT_EQ(orders, (std::vector<int>{1, 2, 3}));
}

TEST(LadderDiagram, FindsThePartAtAPlaceOfTheText) {
    const Opened opened(program("y := a AND start;\n// note\nx := b;\n"));
    const auto at = [&](const char* what) { return static_cast<uint32_t>(opened.text.rfind(what)); };
    const Diagram& diagram = opened.diagram;
    EXPECT_EQ(diagram[diagram.nodeAt(at("start;"))].label, "start");
    EXPECT_EQ(diagram[diagram.nodeAt(at("y := a"))].kind, NodeKind::Coil);
    EXPECT_EQ(diagram.rungAt(at("note")), RungId(1));
    EXPECT_FALSE(diagram.rungAt(0).isValid());
}

} // namespace
} // namespace plc::ladder
