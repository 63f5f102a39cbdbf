#include "runtime/compiler/chart/chart.h"
#include "runtime/compiler/chart/edits.h"
#include "runtime/compiler/chart/layout.h"
#include "runtime/compiler/parse/parser.h"
#include "tests/support/processor_time.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

using namespace plc;
using namespace plc::chart;

namespace {

/// A unit with a chart, its model, and what the checks say.
struct Opened {
    std::string text;
    std::unique_ptr<syntax::SyntaxFile> file;
    const syntax::Pou* pou = nullptr;
    Chart chart;
    std::string codes;
    bool parses = true;

    explicit Opened(std::string source) : text(std::move(source)) {
        diagnostics::Sink sink;
        file = parse::parseFile(FileId(0), text, sink);
        parses = !sink.hasErrors();
        pou = file->declarations.at(0)->pou;
        if (pou->body.chart) chart = build(*pou->body.chart);
        diagnostics::Sink checks;
        if (pou->body.chart) check(chart, checks);
        for (const auto& d : checks.all())
            codes += (codes.empty() ? "" : " ") + std::string(diagnostics::codeOf(d.kind)) + ":" +
                     text.substr(d.range.begin, d.range.length());
    }
    StepId step(std::string_view name) const { return chart.find(name); }
    TransitionId transition(size_t index) const { return TransitionId(index); }
    ChartEditor editor() const { return {text, *pou, chart}; }
};

std::string program(const std::string& body) { return "PROGRAM p\n" + body + "END_PROGRAM\n"; }
std::string steps(std::initializer_list<const char*> names) {
    std::string out;
    for (const char* name : names) out += std::string(out.empty() ? "INITIAL_STEP " : "STEP ") + name + ": END_STEP\n";
    return out;
}
std::string way(const char* from, const char* to) {
    return std::string("TRANSITION FROM ") + from + " TO " + to + " := c; END_TRANSITION\n";
}

const std::string kLoop = steps({"A", "B", "C"}) + way("A", "B") + way("B", "C") + way("C", "A");
const std::string kChoice =
    steps({"A", "B", "C", "D"}) + way("A", "B") + way("A", "C") + way("B", "D") + way("C", "D") + way("D", "A");
const std::string kParallel = steps({"A", "B", "C", "D"}) + way("A", "(B, C)") + way("(B, C)", "D") + way("D", "A");

} // namespace

TEST(ChartChecks, FindStructuralMistakes) {
    struct Row {
        std::string body;
        const char* codes;
    };
    for (const Row& row : {
             Row{kLoop, ""},
             {kChoice, ""},
             {kParallel, ""},
             {"STEP A: END_STEP\n" + way("A", "A"), "P4001:A"},
             {"INITIAL_STEP A: END_STEP\nINITIAL_STEP B: END_STEP\n" + way("A", "B"), "P4002:B P4015:B"},
             {"INITIAL_STEP A: END_STEP\nINITIAL_STEP B: END_STEP\n" + way("A", "A") + way("B", "B"), ""},
             {steps({"A", "Fill"}) + way("A", "Fil") + way("Fill", "A"), "P4003:Fil"},
             {steps({"A", "B"}) + way("A", "A") + way("B", "A"), "P4004:B"},
             {steps({"A", "B", "C"}) + way("A", "(B, C)") + way("B", "A") + way("C", "A"), "P4005:A"},
             {steps({"A", "B", "C", "D"}) + way("A", "B") + way("A", "C") + way("(B, C)", "D") + way("D", "A"),
              "P4006:B, C"},
             {steps({"A", "B"}) + "TRANSITION FROM A TO B := TRUE; END_TRANSITION\n" + way("B", "A"), "P4007:TRUE"},
             {"INITIAL_STEP A {minTime := T#1s}: END_STEP\nTRANSITION FROM A TO A := TRUE; END_TRANSITION\n", ""},
             {"INITIAL_STEP A: x(D); y(Q); z(L, T#1s); END_STEP\n" + way("A", "A"), "P4008:D P4009:Q"},
             {steps({"A", "a"}) + way("A", "A"), "P4011:a"},
             {steps({"A", "B"}) + way("A", "A"), "P4004:B"},
         })
        EXPECT_EQ(Opened(program(row.body)).codes, row.codes) << row.body;
}

TEST(ChartChecks, SeeThroughManyParallelBranches) {
    std::string names = "INITIAL_STEP A: END_STEP\nSTEP Z: END_STEP\n", open, close, ways;
    for (int b = 0; b < 12; ++b) {
        for (int s = 0; s < 20; ++s) {
            const std::string name = "S" + std::to_string(b) + "_" + std::to_string(s);
            names += "STEP " + name + ": END_STEP\n";
            if (s > 0) ways += way(("S" + std::to_string(b) + "_" + std::to_string(s - 1)).c_str(), name.c_str());
        }
        open += (b ? ", S" : "S") + std::to_string(b) + "_0";
        close += (b ? ", S" : "S") + std::to_string(b) + "_19";
    }
    const double begin = processorSeconds();
    EXPECT_EQ(Opened(program(names + way("A", ("(" + open + ")").c_str()) + ways +
                             way(("(" + close + ")").c_str(), "Z") + way("Z", "A")))
                  .codes,
              "");
    EXPECT_LT(processorSeconds() - begin, 2.0);
}

TEST(ChartLayout, DrawsSequencesDownwards) {
    const Opened opened(program(kLoop));
    const Layout layout = computeLayout(opened.chart);
    EXPECT_EQ(layout.columns, 1);
    EXPECT_EQ(layout.steps, (std::vector<Cell>{{0, 0}, {0, 2}, {0, 4}}));
    EXPECT_EQ(layout.transitions, (std::vector<Cell>{{0, 1}, {0, 3}, {0, 5}}));
    ASSERT_EQ(layout.jumps.size(), 1u);
    EXPECT_EQ(layout.jumps[0].at, (Cell{0, 6}));
    EXPECT_EQ(layout.jumps[0].target, opened.step("A"));
    EXPECT_EQ(layout.rows, 7);
}

TEST(ChartLayout, PutsAlternativesSideBySideUnderOneLine) {
    const Opened opened(program(kChoice));
    const Layout layout = computeLayout(opened.chart);
    EXPECT_EQ(layout.columns, 2);
    EXPECT_EQ(layout.steps, (std::vector<Cell>{{0, 0}, {0, 3}, {1, 3}, {0, 6}}));
    ASSERT_EQ(layout.bars.size(), 2u);
    EXPECT_EQ(layout.bars[0].kind, BarKind::AlternativeOpen);
    EXPECT_EQ(layout.bars[0].row, 1);
    EXPECT_EQ(layout.bars[0].lastColumn, 1);
    EXPECT_EQ(layout.bars[1].kind, BarKind::AlternativeClose);
    EXPECT_EQ(layout.bars[1].row, 5);
}

TEST(ChartLayout, PutsParallelBranchesBetweenDoubleLines) {
    const Opened opened(program(kParallel));
    const Layout layout = computeLayout(opened.chart);
    EXPECT_EQ(layout.steps, (std::vector<Cell>{{0, 0}, {0, 3}, {1, 3}, {0, 6}}));
    EXPECT_EQ(layout.transitions, (std::vector<Cell>{{0, 1}, {0, 5}, {0, 7}}));
    ASSERT_EQ(layout.bars.size(), 2u);
    EXPECT_EQ(layout.bars[0].kind, BarKind::SimultaneousOpen);
    EXPECT_EQ(layout.bars[1].kind, BarKind::SimultaneousClose);
    EXPECT_EQ(layout.bars[1].row, 4);
    EXPECT_TRUE(layout.links.empty());
}

TEST(ChartLayout, LetsABranchJumpAndSkip) {
    // A -> B -> C with a way back from B and one that skips B
    const Opened opened(program(steps({"A", "B", "C"}) + way("A", "B") + way("A", "C") + way("B", "A") + way("B", "C") +
                                way("C", "A")));
    const Layout layout = computeLayout(opened.chart);
    ASSERT_EQ(layout.jumps.size(), 2u);
    std::vector<Cell> cells = layout.steps;
    cells.insert(cells.end(), layout.transitions.begin(), layout.transitions.end());
    for (const Jump& jump : layout.jumps) cells.push_back(jump.at);
    for (size_t i = 0; i < cells.size(); ++i)
        for (size_t k = i + 1; k < cells.size(); ++k) EXPECT_FALSE(cells[i] == cells[k]) << i << " " << k;
    EXPECT_GT(layout.steps[2].row, layout.steps[1].row);
}

TEST(ChartLayout, KeepsAWayOutApartFromWhatStandsBelow) {
    // B leads to the common D or aside to E; C leads to D: the way from B to D must not run through E
    const Opened opened(program(steps({"A", "B", "C", "D", "E"}) + way("A", "B") + way("A", "C") + way("B", "D") +
                                way("B", "E") + way("C", "D") + way("D", "E") + way("E", "A")));
    const Layout layout = computeLayout(opened.chart);
    const Cell d = layout.steps[3], e = layout.steps[4];
    EXPECT_FALSE(d.column == e.column && e.row < d.row) << "E stands in the way to D";
    const auto close = std::find_if(layout.bars.begin(), layout.bars.end(), [&](const Bar& bar) {
        return bar.kind == BarKind::AlternativeClose && bar.step == opened.step("D");
    });
    ASSERT_NE(close, layout.bars.end());
    EXPECT_EQ(std::count_if(layout.lines.begin(), layout.lines.end(),
                            [&](const Line& line) { return line.toRow == close->row; }),
              2)
        << "from B and from C";
}

TEST(ChartLayout, NeverPutsTwoThingsInOnePlace) {
    uint32_t state = 7;
    const auto random = [&](uint32_t limit) {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) % limit;
    };
    for (int round = 0; round < 300; ++round) {
        const uint32_t count = 2 + random(12);
        std::string body;
        for (uint32_t i = 0; i < count; ++i)
            body += (i == 0 ? "INITIAL_STEP S" : "STEP S") + std::to_string(i) + ": END_STEP\n";
        const auto names = [&](uint32_t most) {
            const uint32_t n = 1 + random(most);
            std::string list;
            for (uint32_t k = 0; k < n; ++k) list += (k ? ", S" : "S") + std::to_string((random(count) + k) % count);
            return n > 1 ? "(" + list + ")" : list;
        };
        for (uint32_t i = 0; i < count + random(count); ++i)
            body += way(names(random(4) == 0 ? 3 : 1).c_str(), names(random(4) == 0 ? 3 : 1).c_str());
        const Opened opened(program(body));
        const Layout layout = computeLayout(opened.chart);
        std::vector<std::pair<int, int>> cells;
        for (const Cell& c : layout.steps) cells.emplace_back(c.column, c.row);
        for (const Cell& c : layout.transitions) cells.emplace_back(c.column, c.row);
        for (const Jump& j : layout.jumps) cells.emplace_back(j.at.column, j.at.row);
        for (const auto& [column, row] : cells) {
            EXPECT_GE(column, 0);
            EXPECT_LT(column, layout.columns);
            EXPECT_LT(row, layout.rows);
        }
        std::sort(cells.begin(), cells.end());
        EXPECT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end()) << body;
        // a line goes through no element on its way, and a way to a bar crosses no other bar
        for (const Line& line : layout.lines)
            for (const auto& [column, row] : cells)
                EXPECT_FALSE(column == line.column && row > line.fromRow && row < line.toRow) << body;
        for (const Line& line : layout.lines)
            for (const Bar& bar : layout.bars)
                EXPECT_FALSE(bar.row > line.fromRow && bar.row < line.toRow && line.column >= bar.firstColumn &&
                             line.column <= bar.lastColumn)
                    << body;
        // every transition leads on: by a line or an arrow below it
        for (size_t i = 0; i < layout.transitions.size(); ++i) {
            if (opened.chart.transitions[i].to.empty()) continue;
            const Cell at = layout.transitions[i];
            const bool goesOn = std::any_of(layout.lines.begin(), layout.lines.end(), [&](const Line& line) {
                return line.column == at.column && line.fromRow == at.row;
            });
            EXPECT_TRUE(goesOn) << "transition " << i << "\n" << body;
        }
        // a bar lies across no element
        for (const Bar& bar : layout.bars)
            for (const auto& [column, row] : cells)
                EXPECT_FALSE(row == bar.row && column >= bar.firstColumn && column <= bar.lastColumn) << body;
    }
}

TEST(ChartLayout, FiveHundredStepsTakeNoTime) {
    std::string body;
    for (int i = 0; i < 500; ++i)
        body += (i == 0 ? "INITIAL_STEP S" : "STEP S") + std::to_string(i) + ": a(N); END_STEP\n";
    for (int i = 0; i < 500; ++i)
        body += way(("S" + std::to_string(i)).c_str(), ("S" + std::to_string((i + 1) % 500)).c_str());
    for (int i = 0; i < 480; i += 7)
        body += way(("S" + std::to_string(i)).c_str(), ("S" + std::to_string(i + 5)).c_str());
    const double begin = processorSeconds();
    const Opened opened(program(body));
    const Layout layout = computeLayout(opened.chart);
    const double elapsed = processorSeconds() - begin;
    std::printf("500 steps read, checked and laid out in %.2f ms\n", elapsed * 1000);
    EXPECT_EQ(opened.codes, "");
    EXPECT_GT(layout.rows, 500);
    EXPECT_LT(elapsed, 2.0);
}
