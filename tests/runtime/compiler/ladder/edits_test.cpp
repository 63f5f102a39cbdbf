// Each edit of a ladder as the text it leads to: minimal, with comments, parentheses and the order of operands kept.
#include "opened.h"
#include "runtime/compiler/ladder/edits.h"

#include <functional>
#include <gtest/gtest.h>

namespace plc::ladder {
namespace {

NodeId find(const Opened& opened, const std::string& label, NodeKind kind) {
    for (size_t i = 0; i < opened.diagram.nodes.size(); ++i)
        if (opened.diagram.nodes[i].label == label && opened.diagram.nodes[i].kind == kind) return NodeId(i);
    ADD_FAILURE() << label;
    return {};
}

using Change = std::function<Result<Edits>(const LadderEditor&, const Opened&)>;

/// The statements after the edit; the error's text when it is refused.
std::string after(const std::string& statements, const Change& change, Form form = Form::Ladder) {
    const Opened opened(program(statements), form);
    EXPECT_EQ(opened.errors, "") << statements;
    const LadderEditor editor(opened.text, *opened.file, opened.unit, opened.diagram, *opened.types);
    const Result<Edits> edits = change(editor, opened);
    if (!edits) return edits.error().message.english();
    const std::string text = applyEdits(opened.text, *edits);
    EXPECT_EQ(applyEdits(text, inverseOf(opened.text, *edits)), opened.text);
    EXPECT_EQ(Opened(text).errors, "") << text;
    const std::string head = program("").substr(0, program("").find("END_PROGRAM"));
    EXPECT_TRUE(text.starts_with(head)) << "the declarations stay: " << text;
    return text.substr(head.size(), text.size() - head.size() - std::string("END_PROGRAM\n").size());
}

Change contact(const char* label, Place place, const char* operand) {
    return [=](const LadderEditor& editor, const Opened& opened) {
        return editor.insertContact(find(opened, label, NodeKind::Contact), place, operand);
    };
}
Change parallel(const char* label, const char* operand) {
    return [=](const LadderEditor& editor, const Opened& opened) {
        return editor.insertParallel(find(opened, label, NodeKind::Contact), operand);
    };
}
Change removal(const char* label, NodeKind kind = NodeKind::Contact) {
    return [=](const LadderEditor& editor, const Opened& opened) { return editor.remove(find(opened, label, kind)); };
}
Change coil(const char* label, CoilKind kind) {
    return [=](const LadderEditor& editor, const Opened& opened) {
        return editor.setCoil(find(opened, label, NodeKind::Coil), kind);
    };
}

TEST(LadderEdits, InsertContactsWithTheParenthesesThatTheyNeed) {
    EXPECT_EQ(after("y := a; // why\n", contact("a", Place::After, "b")), "y := a AND b; // why\n");
    EXPECT_EQ(after("y := a OR (* or *) b;\n", contact("b", Place::Before, "NOT c")),
              "y := a OR (* or *) NOT c AND b;\n");
    EXPECT_EQ(after("y := a AND b;\n", contact("a", Place::After, "c OR d")), "y := a AND (c OR d) AND b;\n");
    EXPECT_EQ(after("y := a AND b;\n", parallel("b", "c")), "y := a AND (b OR c);\n");
    EXPECT_EQ(after("y := (a OR b) AND c;\n", parallel("b", "d")), "y := (a OR b OR d) AND c;\n");
    EXPECT_EQ(after("y := NOT (a AND b);\n", parallel("a", "c")), "y := NOT ((a OR c) AND b);\n");
}

TEST(LadderEdits, ChangeAContactInEveryStatementThatSharesIt) {
    EXPECT_EQ(after("x := a AND b;\ny := a  AND c;\n", contact("a", Place::After, "d")),
              "x := a AND d AND b;\ny := a AND d  AND c;\n");
    EXPECT_EQ(after("x := a AND b;\ny := a AND c;\n", contact("c", Place::After, "d")),
              "x := a AND b;\ny := a AND c AND d;\n");
    EXPECT_EQ(after("x := a AND b;\ny := a AND c;\n", removal("a")), "x := b;\ny := c;\n");
}

TEST(LadderEdits, RemoveContactsAndTheParenthesesThatBecomeLonely) {
    EXPECT_EQ(after("y := a AND b AND c;\n", removal("b")), "y := a AND c;\n");
    EXPECT_EQ(after("y := (a OR b) AND c;\n", removal("b")), "y := a AND c;\n");
    EXPECT_EQ(after("y := a;\n", removal("a")), "y := TRUE;\n");
    EXPECT_EQ(after("x := a;\n\n// lamp\ny := b; // on\n\nz := c;\n", removal("y", NodeKind::Coil)),
              "x := a;\n\n\nz := c;\n");
    EXPECT_EQ(after("x := a;\ny := a AND b;\n", removal("x", NodeKind::Coil)), "y := a AND b;\n");
}

TEST(LadderEdits, ChangeTheKindOfACoil) {
    EXPECT_EQ(after("y := a AND b;\n", coil("y", CoilKind::Negated)), "y := NOT (a AND b);\n");
    EXPECT_EQ(after("y := NOT (a AND b);\n", coil("y", CoilKind::Normal)), "y := a AND b;\n");
    EXPECT_EQ(after("y := NOT (a);\n", coil("y", CoilKind::Set)), "y S= a;\n");
    EXPECT_EQ(after("y (* := *) S= a;\n", coil("y", CoilKind::Reset)), "y (* := *) R= a;\n");
    EXPECT_EQ(after("IF a THEN y := TRUE; END_IF\n", coil("y", CoilKind::Reset)), "IF a THEN y := FALSE; END_IF\n");
    EXPECT_EQ(after("IF a THEN y := TRUE; END_IF\n", coil("y", CoilKind::Normal)), "y := a;\n");
    EXPECT_EQ(after("IF a THEN y := TRUE; z := TRUE; END_IF\n", coil("y", CoilKind::Normal)),
              "Other outputs depend on the same IF; give this coil a rung of its own first.");
}

TEST(LadderEdits, AddACoilThatGetsTheSamePower) {
    const Change add = [](const LadderEditor& editor, const Opened&) { return editor.addCoil(RungId(0), "z"); };
    EXPECT_EQ(after("y := a AND b;\n", add), "y := a AND b;\nz := a AND b;\n");
    EXPECT_EQ(after("y := (a OR y) AND b;\n", add), "y := (a OR y) AND b;\nz := y;\n");
    EXPECT_EQ(after("y S= a OR y;\n", add), "The rung reads what it writes; add this coil in a rung of its own.");
}

TEST(LadderEdits, PutABlockBetweenContactsAndCoil) {
    const Opened opened(program("y := a AND b; // slow\n"));
    const LadderEditor editor(opened.text, *opened.file, opened.unit, opened.diagram, *opened.types);
    const Result<Edits> edits = editor.insertBlock(RungId(0), "wait", "TON");
    ASSERT_TRUE(edits);
    const Opened again(applyEdits(opened.text, *edits));
    EXPECT_EQ(again.words(), "# slow # a b TON:wait[IN=~ PT=T#1s]>.Q -> ()y\n");
    EXPECT_NE(again.text.find("    wait : TON;\nEND_VAR"), std::string::npos) << again.text;
    EXPECT_FALSE(editor.insertBlock(RungId(0), "wait", "Nothing"));
    EXPECT_FALSE(editor.insertBlock(RungId(0), "2 words", "TON"));
}

TEST(LadderEdits, InsertMoveAndCommentRungs) {
    const std::string three = "// one\nx := a;\n\ny := b; // two\n\n// three\nz := c;\n";
    const auto rung = [](auto change) {
        return Change([=](const LadderEditor& e, const Opened&) { return change(e); });
    };
    EXPECT_EQ(after(three, rung([](auto& e) { return e.moveRung(RungId(2), Place::Before, RungId(0)); })),
              "// three\nz := c;\n\n// one\nx := a;\n\ny := b; // two\n\n");
    EXPECT_EQ(after(three, rung([](auto& e) { return e.insertRung(RungId(1), Place::After, "d := a;"); })),
              "// one\nx := a;\n\ny := b; // two\n\nd := a;\n\n// three\nz := c;\n");
    EXPECT_EQ(after(three, rung([](auto& e) { return e.setComment(RungId(0), ""); })),
              "x := a;\n\ny := b; // two\n\n// three\nz := c;\n");
    EXPECT_EQ(after(three, rung([](auto& e) { return e.setComment(RungId(1), "second\nrung"); })),
              "// one\nx := a;\n\n// second\n// rung\ny := b; // two\n\n// three\nz := c;\n");
    EXPECT_EQ(after("", rung([](auto& e) { return e.insertRung({}, Place::After, "y := a;"); })), "y := a;\n");
    EXPECT_EQ(after(three, rung([](auto& e) { return e.insertRung(RungId(0), Place::After, "y := := a;"); })),
              "This is not a statement: y := := a;");
}

TEST(LadderEdits, MoveARungWithinItsFrameOnly) {
    const std::string frame = "IF a THEN\n    x := b;\n\n    y := c;\nELSE\n    z := d;\nEND_IF\n";
    const auto moved = [](int from, int to) {
        return Change(
            [=](const LadderEditor& e, const Opened&) { return e.moveRung(RungId(from), Place::Before, RungId(to)); });
    };
    EXPECT_EQ(after(frame, moved(2, 1)), "IF a THEN\n    y := c;\n\n    x := b;\n\nELSE\n    z := d;\nEND_IF\n");
    EXPECT_EQ(after(frame, moved(4, 1)),
              "A rung moves within its block of statements; use cut and paste in the text for more.");
    EXPECT_EQ(after(frame, [](const LadderEditor& e, const Opened&) { return e.removeRung(RungId(0)); }), "");
}

TEST(LadderEdits, RefuseWhatIsNoOperand) {
    for (const char* operand : {"", "a b", "a;", "AND", "a) OR (b"})
        EXPECT_FALSE(after("y := a;\n", contact("a", Place::After, operand)).starts_with("y := ")) << operand;
    EXPECT_EQ(after("y := a;\n",
                    [](const LadderEditor& editor, const Opened& opened) {
                        return editor.setOperand(find(opened, "y", NodeKind::Coil), "a + 1");
                    }),
              "A coil writes a variable; enter the name of one.");
}

Change move(const char* label, const char* beside, Place place) {
    return [=](const LadderEditor& editor, const Opened& opened) {
        return editor.moveContact(find(opened, label, NodeKind::Contact), find(opened, beside, NodeKind::Contact),
                                  place);
    };
}

TEST(LadderEdits, ANewCoilDoesNotFollowOneThatIsWrittenAgain) {
    const auto added = after("x := a AND d;\nx := NOT (a AND d AND b);\nd := a AND d;\n",
                             [](const LadderEditor& editor, const Opened&) { return editor.addCoil(RungId(0), "y"); });
    EXPECT_EQ(added, "The rung reads what it writes; add this coil in a rung of its own.");
}

TEST(LadderEdits, MoveAContactWithinItsRungAndToAnother) {
    EXPECT_EQ(after("y := a AND b AND c; // why\n", move("a", "c", Place::After)), "y := b AND c AND a; // why\n");
    EXPECT_EQ(after("y := a AND b AND c;\n", move("c", "a", Place::Before)), "y := c AND a AND b;\n");
    EXPECT_EQ(after("y := a AND (b OR c);\n", move("a", "c", Place::Before)), "y := (b OR a AND c);\n");
    EXPECT_EQ(after("y := a AND b; // one\n\n(* two *)\nx := c;\n", move("b", "c", Place::After)),
              "y := a; // one\n\n(* two *)\nx := c AND b;\n");
    EXPECT_EQ(after("x := c;\n\ny := a AND NOT b;\n", move("b", "c", Place::Before)), "x := NOT b AND c;\n\ny := a;\n");
    EXPECT_EQ(after("y := a;\n\nx := c;\n", move("a", "c", Place::After)), "y := TRUE;\n\nx := c AND a;\n");
}

TEST(LadderEdits, MovingAContactTouchesNothingBetweenTheRungs) {
    const Opened opened(program("y := a AND b;\n\nz := d;\n\nx := c;\n"));
    const LadderEditor editor(opened.text, *opened.file, opened.unit, opened.diagram, *opened.types);
    const Result<Edits> edits =
        editor.moveContact(find(opened, "b", NodeKind::Contact), find(opened, "c", NodeKind::Contact), Place::After);
    ASSERT_TRUE(edits);
    ASSERT_EQ(edits->size(), 2u);
    for (const TextEdit& edit : *edits) EXPECT_LT(edit.range.length() + edit.text.size(), 8u);
}

} // namespace
} // namespace plc::ladder
