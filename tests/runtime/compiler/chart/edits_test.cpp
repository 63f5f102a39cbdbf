#include "runtime/compiler/chart/edits.h"
#include "runtime/compiler/chart/layout.h"
#include "runtime/compiler/parse/parser.h"

#include <functional>
#include <gtest/gtest.h>
#include <memory>

using namespace plc;
using namespace plc::chart;

namespace {

struct Opened {
    std::string text;
    std::unique_ptr<syntax::SyntaxFile> file;
    const syntax::Pou* pou = nullptr;
    Chart chart;
    std::string messages;

    explicit Opened(std::string source) : text(std::move(source)) {
        diagnostics::Sink sink;
        file = parse::parseFile(FileId(0), text, sink);
        for (const auto& d : sink.all())
            if (d.severity == diagnostics::Severity::Error) messages += d.message.english() + "\n";
        pou = file->declarations.at(0)->pou;
        if (pou->body.chart) chart = build(*pou->body.chart);
    }
    ChartEditor editor() const { return {text, *pou, chart}; }
    StepId step(std::string_view name) const { return chart.find(name); }
};

const char* kText = "(* a filler *)\n"
                    "PROGRAM p\n"
                    "VAR go, full : BOOL; END_VAR\n"
                    "// waits\n"
                    "INITIAL_STEP Wait: END_STEP // first\n"
                    "TRANSITION FROM Wait TO Fill := go AND Wait.T > T#1s; END_TRANSITION\n"
                    "\n"
                    "// fills the tank\n"
                    "// to the brim\n"
                    "STEP Fill:\n"
                    "    valve(N); (* open *)\n"
                    "    count(D, T#2s);\n"
                    "END_STEP // filling\n"
                    "TRANSITION FROM Fill TO Wait := full; END_TRANSITION\n"
                    "ACTION count:\n"
                    "    n := n + 1; // only in Fill.X\n"
                    "    IF Fill.X THEN n := 0; END_IF\n"
                    "END_ACTION\n"
                    "END_PROGRAM\n";

std::string after(const Opened& opened, const Result<Edits>& edits) {
    if (!edits) return edits.error().message.english();
    const std::string text = applyEdits(opened.text, *edits);
    EXPECT_EQ(applyEdits(text, inverseOf(opened.text, *edits)), opened.text);
    const Opened again(text);
    EXPECT_EQ(again.messages, "") << text;
    return text;
}

/// kText with one piece of text replaced by another, each found exactly once.
std::string with(std::initializer_list<std::pair<const char*, const char*>> changes) {
    std::string out = kText;
    for (const auto& [from, to] : changes) {
        const size_t at = out.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        out.replace(at, std::string_view(from).size(), to);
    }
    return out;
}

} // namespace

TEST(ChartEdits, InsertAStepBehindAStep) {
    const Opened o(kText);
    EXPECT_EQ(after(o, o.editor().insertStepAfter(o.step("Wait"))),
              with({{"FROM Wait TO Fill", "FROM Step1 TO Fill"},
                    {"// first\n",
                     "// first\nTRANSITION FROM Wait TO Step1 := TRUE; END_TRANSITION\nSTEP Step1:\nEND_STEP\n"}}));
}

TEST(ChartEdits, InsertAStepBehindATransition) {
    const Opened o(kText);
    EXPECT_EQ(after(o, o.editor().insertStepAfter(TransitionId(0), "Heat")),
              with({{"TO Fill := go AND Wait.T > T#1s; END_TRANSITION\n",
                     "TO Heat := go AND Wait.T > T#1s; END_TRANSITION\nSTEP Heat:\nEND_STEP\nTRANSITION FROM Heat TO "
                     "Fill := TRUE; END_TRANSITION\n"}}));
    EXPECT_FALSE(o.editor().insertStepAfter(TransitionId(0), "wait"));
    EXPECT_FALSE(o.editor().insertStepAfter(TransitionId(0), "1x"));
}

TEST(ChartEdits, DeleteAStepWithItsCommentsAndTheTransitionBehindIt) {
    const Opened o(kText);
    EXPECT_EQ(after(o, o.editor().deleteStep(o.step("Fill"))),
              with({{"// fills the tank\n// to the brim\nSTEP Fill:\n    valve(N); (* open *)\n    count(D, "
                     "T#2s);\nEND_STEP // filling\nTRANSITION FROM Fill TO Wait := full; END_TRANSITION\n",
                     ""},
                    {"FROM Wait TO Fill", "FROM Wait TO Wait"}}));
    EXPECT_FALSE(o.editor().deleteStep(o.step("Wait")));
}

TEST(ChartEdits, RenameAStepWhereverItStands) {
    const Opened o(kText);
    EXPECT_EQ(after(o, o.editor().renameStep(o.step("Fill"), "Pour")), with({{"TO Fill :=", "TO Pour :="},
                                                                             {"STEP Fill:", "STEP Pour:"},
                                                                             {"FROM Fill", "FROM Pour"},
                                                                             {"IF Fill.X", "IF Pour.X"}}));
    EXPECT_EQ(after(o, o.editor().renameStep(o.step("Wait"), "wait")), with({{"STEP Wait", "STEP wait"},
                                                                             {"FROM Wait", "FROM wait"},
                                                                             {"AND Wait.T", "AND wait.T"},
                                                                             {"Fill TO Wait", "Fill TO wait"}}));
}

TEST(ChartEdits, RenameAnAction) {
    const Opened o(kText);
    EXPECT_EQ(after(o, o.editor().renameAction("count", "tally")),
              with({{"count(D", "tally(D"}, {"ACTION count", "ACTION tally"}}));
}

TEST(ChartEdits, ChangeConditionsPrioritiesAndTimes) {
    const Opened o(kText);
    EXPECT_EQ(after(o, o.editor().setCondition(TransitionId(1), "full OR stop")),
              with({{":= full;", ":= full OR stop;"}}));
    const std::string prioritised = after(o, o.editor().setPriority(TransitionId(1), 2));
    EXPECT_EQ(prioritised, with({{"TRANSITION FROM Fill", "TRANSITION (PRIORITY := 2) FROM Fill"}}));
    const Opened p(prioritised);
    EXPECT_EQ(after(p, p.editor().setPriority(TransitionId(1), 0)), kText);
    const std::string timed = after(o, o.editor().setStepTime(o.step("Fill"), "maxTime", "T#5s"));
    EXPECT_EQ(timed, with({{"STEP Fill:", "STEP Fill {maxTime := T#5s}:"}}));
    const Opened t(timed);
    EXPECT_EQ(after(t, t.editor().setStepTime(t.step("Fill"), "maxTime", "")), kText);
}

TEST(ChartEdits, ChangeActions) {
    const Opened o(kText);
    EXPECT_EQ(after(o, o.editor().insertAction(o.step("Fill"), 9, "lamp", "L", "T#1s")),
              with({{"count(D, T#2s);", "count(D, T#2s);\n    lamp(L, T#1s);"}}));
    EXPECT_EQ(after(o, o.editor().insertAction(o.step("Fill"), 0, "lamp", "N")),
              with({{"valve(N);", "lamp(N);\n    valve(N);"}}));
    EXPECT_EQ(after(o, o.editor().insertAction(o.step("Wait"), 0, "lamp", "")),
              with({{"STEP Wait: END", "STEP Wait: lamp(N); END"}}));
    EXPECT_EQ(after(o, o.editor().deleteAction(o.step("Fill"), 1)), with({{"    count(D, T#2s);\n", ""}}));
    EXPECT_EQ(after(o, o.editor().moveAction(o.step("Fill"), 1, 0)),
              with({{"valve(N);", "count(D, T#2s);"}, {"    count(D, T#2s);\nEND", "    valve(N);\nEND"}}));
    EXPECT_EQ(after(o, o.editor().changeAction(o.step("Fill"), 0, "valve", "S", "")), with({{"valve(N)", "valve(S)"}}));
    EXPECT_EQ(after(o, o.editor().declareAction("lamp")),
              with({{"END_ACTION\n", "END_ACTION\nACTION lamp:\nEND_ACTION\n"}}));
}

TEST(ChartEdits, BranchesComeGoAndChangePlaces) {
    const Opened o(kText);
    const std::string two = after(o, o.editor().insertAlternativeBranch(o.step("Fill"), "Drain"));
    EXPECT_EQ(two, with({{":= full; END_TRANSITION\n",
                          ":= full; END_TRANSITION\nTRANSITION FROM Fill TO Drain := TRUE; END_TRANSITION\nSTEP "
                          "Drain:\nEND_STEP\nTRANSITION FROM Drain TO Wait := TRUE; END_TRANSITION\n"}}));
    const Opened p(two);
    EXPECT_EQ(after(p, p.editor().deleteBranch(TransitionId(2))), kText);
    const std::string moved = after(p, p.editor().moveTransition(TransitionId(2), Place::Before, TransitionId(1)));
    EXPECT_LT(moved.find("FROM Fill TO Drain"), moved.find("FROM Fill TO Wait"));
    const std::string parallel = after(o, o.editor().insertSimultaneousBranch(TransitionId(0), "Stir"));
    EXPECT_EQ(parallel, with({{"TO Fill := go AND Wait.T > T#1s; END_TRANSITION\n",
                               "TO (Fill, Stir) := go AND Wait.T > T#1s; END_TRANSITION\nSTEP Stir:\nEND_STEP\n"},
                              {"FROM Fill TO Wait", "FROM (Fill, Stir) TO Wait"}}));
    const Opened q(parallel);
    EXPECT_EQ(after(q, q.editor().deleteStep(q.step("Stir"))), kText);
}

TEST(ChartEdits, MoveAStepByNamesAlone) {
    const Opened o("PROGRAM p\nINITIAL_STEP A: END_STEP\nTRANSITION FROM A TO B := x; END_TRANSITION\nSTEP B: "
                   "END_STEP\nTRANSITION FROM B TO C := y; END_TRANSITION\nSTEP C: END_STEP\nTRANSITION FROM C TO A := "
                   "z; END_TRANSITION\nEND_PROGRAM\n");
    EXPECT_EQ(after(o, o.editor().moveStep(o.step("B"), TransitionId(2))),
              "PROGRAM p\nINITIAL_STEP A: END_STEP\nTRANSITION FROM A TO C := x; END_TRANSITION\nSTEP B: "
              "END_STEP\nTRANSITION FROM B TO A := y; END_TRANSITION\nSTEP C: END_STEP\nTRANSITION FROM C TO B := z; "
              "END_TRANSITION\nEND_PROGRAM\n");
    EXPECT_EQ(after(o, o.editor().setInitial(o.step("B"))).find("INITIAL_STEP B"), o.text.find("STEP B") - 8);
    EXPECT_FALSE(o.editor().moveStep(o.step("B"), TransitionId(0)));
}

/// Whatever is done to a chart: it parses, its inverse restores every byte, and its drawing exists.
TEST(ChartEdits, RandomEditsKeepTheChartReadable) {
    uint32_t state = 3;
    const auto random = [&](size_t limit) {
        state = state * 1664525u + 1013904223u;
        return static_cast<size_t>((state >> 8) % std::max<size_t>(1, limit));
    };
    int done = 0;
    for (int round = 0; round < 40; ++round) {
        std::string text = kText;
        if (round % 2) {
            for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
        }
        for (int k = 0; k < 15; ++k) {
            const Opened o(text);
            ASSERT_EQ(o.messages, "") << text;
            const ChartEditor editor = o.editor();
            const StepId step(random(o.chart.steps.size())), other(random(o.chart.steps.size()));
            if (o.chart.transitions.empty()) break;
            const TransitionId transition(random(o.chart.transitions.size())),
                anchor(random(o.chart.transitions.size()));
            const std::function<Result<Edits>()> choices[] = {
                [&] { return editor.insertStepAfter(step); },
                [&] { return editor.insertStepAfter(transition); },
                [&] { return editor.deleteStep(step); },
                [&] { return editor.moveStep(step, transition); },
                [&] { return editor.insertTransition(step, other, "go"); },
                [&] { return editor.deleteTransition(transition); },
                [&] { return editor.moveTransition(transition, random(2) ? Place::Before : Place::After, anchor); },
                [&] { return editor.setCondition(transition, "go OR full"); },
                [&] { return editor.setPriority(transition, static_cast<int>(random(3))); },
                [&] { return editor.insertAlternativeBranch(step); },
                [&] { return editor.insertSimultaneousBranch(transition); },
                [&] { return editor.deleteBranch(transition); },
                [&] { return editor.insertAction(step, random(3), "valve", "N"); },
                [&] { return editor.deleteAction(step, random(3)); },
                [&] { return editor.moveAction(step, random(3), random(3)); },
                [&] { return editor.renameStep(step, "N" + std::to_string(done)); },
                [&] { return editor.setInitial(step); },
                [&] { return editor.setStepTime(step, "minTime", random(2) ? "T#1s" : ""); },
            };
            const size_t which = random(std::size(choices));
            const Result<Edits> edits = choices[which]();
            if (!edits) continue;
            const std::string next = applyEdits(text, *edits);
            ASSERT_EQ(applyEdits(next, inverseOf(text, *edits)), text);
            const Opened again(next);
            ASSERT_EQ(again.messages, "") << "edit " << which << "\n" << text << "\n----\n" << next;
            if (again.pou->body.chart) (void)computeLayout(again.chart);
            text = next;
            ++done;
            if (!again.pou->body.chart) break;
        }
    }
    EXPECT_GT(done, 200);
}
