// Power flow: what each wire carries follows from the values of the contacts alone, and equals an evaluation of every
// sub-expression that knows nothing of the picture.
#include "model.h"
#include "opened.h"
#include "runtime/compiler/ladder/flow.h"

#include <gtest/gtest.h>
#include <random>

namespace plc::ladder {
namespace {

std::vector<Power> flowOf(const Opened& opened, const State& state) {
    const Reference reference(opened.text);
    const Answers answers = [&](const Question& question) {
        if (question.expr) return reference.value(*question.expr, state) ? Power::On : Power::Off;
        const auto at = state.find(foldCase(question.text));
        return at == state.end() ? Power::Unknown : at->second ? Power::On : Power::Off;
    };
    std::vector<Power> power(opened.diagram.nodes.size(), Power::Unknown);
    for (const Rung& rung : opened.diagram.rungs) computeFlow(opened.text, opened.diagram, rung, answers, power);
    return power;
}

TEST(LadderFlow, EndsInTheCoilWithTheValueThatIsWritten) {
    const char* const bodies[] = {
        "y := a AND (b OR NOT c) AND d;",
        "y := NOT (a AND b) AND (c OR d);",
        "y := (a OR b) AND (c OR NOT (d AND a)) OR i > 1 AND b;",
        "y := a AND NOT (i > 1) AND (b XOR c);",
        "y := (a AND_THEN b) OR_ELSE NOT c;",
    };
    for (const char* body : bodies) {
        const Opened opened(program(std::string(body) + "\n"));
        const syntax::Stmt& stmt = *opened.unit.body->statements[0];
        for (int bits = 0; bits < 64; ++bits) {
            const State state{
                {"a", bits & 1}, {"b", bits >> 1 & 1}, {"c", bits >> 2 & 1}, {"d", bits >> 3 & 1}, {"i", bits >> 4}};
            const std::vector<Power> power = flowOf(opened, state);
            const Rung& rung = opened.diagram.rungs[0];
            const bool expected = Reference(opened.text).value(*stmt.value, state) != 0;
            EXPECT_EQ(power[rung.branches[0].output.index()], expected ? Power::On : Power::Off) << body << " " << bits;
        }
    }
}

TEST(LadderFlow, StopsAtTheFirstOpenContactAndForksAtAParallel) {
    const Opened opened(program("y := a AND (b OR c) AND d;\n"));
    const std::vector<Power> power = flowOf(opened, {{"a", 1}, {"b", 0}, {"c", 1}, {"d", 0}});
    const auto behind = [&](const char* label) {
        for (size_t i = 0; i < opened.diagram.nodes.size(); ++i)
            if (opened.diagram.nodes[i].label == label) return power[i];
        return Power::Unknown;
    };
    EXPECT_EQ(behind("a"), Power::On);
    EXPECT_EQ(behind("b"), Power::Off);
    EXPECT_EQ(behind("c"), Power::On);
    EXPECT_EQ(behind("d"), Power::Off);
    EXPECT_EQ(behind("y"), Power::Off);
}

TEST(LadderFlow, GoesOnFromTheOutputOfABlockAndIsUnknownWithoutAValue) {
    const Opened opened(program("T1(IN := a, PT := t);\ny := T1.Q AND b;\n"));
    const auto coil = [&](const State& state) {
        return flowOf(opened, state)[opened.diagram.rungs[0].branches[0].output.index()];
    };
    EXPECT_EQ(coil({{"a", 0}, {"b", 1}, {"t1.q", 1}}), Power::On);
    EXPECT_EQ(coil({{"a", 1}, {"b", 1}, {"t1.q", 0}}), Power::Off);
    EXPECT_EQ(coil({{"a", 1}, {"b", 1}}), Power::Unknown);
    EXPECT_EQ(coil({{"a", 1}, {"b", 0}}), Power::Off) << "an open contact is enough";
}

} // namespace
} // namespace plc::ladder
