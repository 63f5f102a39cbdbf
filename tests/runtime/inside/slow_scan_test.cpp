// The slow scan: statement by statement, forwards and backwards, with what was seen there.
#include "runtime/inside/slow_scan.h"

#include "tests/projects/random_program.h"
#include "tests/runtime/inside/recorded.h"
#include "tests/support/repeats.h"

using namespace plc;
using namespace plc::inside;
using debug::Step;
using plc::testing::buildText;
using plc::testing::integerFor;

namespace {

const char* const kProgram = R"(FUNCTION_BLOCK Counter
VAR_INPUT up : INT; END_VAR
VAR_OUTPUT n : INT; END_VAR
VAR_TEMP more : INT; END_VAR
more := up * 2;
n := n + more;
END_FUNCTION_BLOCK
PROGRAM Main
VAR a, b : Counter; i, x : INT; s : STRING; done : BOOL; END_VAR
x := 1;
a(up := x);
FOR i := 1 TO 2 DO
    x := x + a.n;
END_FOR
b(up := x);
s := 'a long text that fills more than eight bytes';
done := x > 3;
END_PROGRAM)";

class SlowScanTest : public ::testing::Test {
protected:
    void SetUp() override {
        session.controller().start();
        for (int n = 0; n < 3; ++n) session.controller().scan();
        insight = std::make_unique<Insight>(session.history());
        auto look = insight->look(2);
        ASSERT_TRUE(look) << look.error().english();
        ASSERT_TRUE((*look)->isExact());
        scan = std::make_unique<SlowScan>(*look);
    }
    std::string here() {
        const SourceRange range = scan->range();
        return range.length() ? std::string(session.program()->sources[range.file].slice(range)) : "end";
    }
    std::string value(const std::string& text, uint32_t frame) {
        const auto found = scan->evaluate(text, frame);
        return found ? types::toText(*session.program()->layout.types, *found) : found.error().english();
    }
    std::string top(const std::string& text) { return value(text, kNone); }
    bool isChanged(const std::string& name) {
        for (const SlowScan::Scope& scope : scan->scopes(scan->stackTrace().front().id))
            for (const SlowScan::Variable& variable : scope.variables)
                if (variable.name == name) return variable.isChanged;
        return false;
    }

    session::Session session{buildText(kProgram)};
    std::unique_ptr<Insight> insight;
    std::unique_ptr<SlowScan> scan;
};

} // namespace

TEST_F(SlowScanTest, GoesForwardOverCallsAndBackAgain) {
    std::vector<std::string> forward, back;
    do forward.push_back(here() + " x=" + top("Main.x"));
    while (scan->step(Step::Over));
    ASSERT_GE(forward.size(), 8u);
    EXPECT_EQ(forward.front().substr(0, 7), "x := 1;");
    EXPECT_EQ(forward.back().substr(0, 3), "end");
    for (const std::string& each : forward) EXPECT_EQ(each.find("more :="), std::string::npos) << each;
    do back.push_back(here() + " x=" + top("Main.x"));
    while (scan->stepBack(Step::Over));
    std::reverse(back.begin(), back.end());
    EXPECT_EQ(forward, back);
}

TEST_F(SlowScanTest, ShowsEachValueAsItWasAtThatMoment) {
    EXPECT_NE(top("Main.x"), "1") << "as the scan before has left it";
    ASSERT_TRUE(scan->step(Step::Over));
    EXPECT_EQ(top("Main.x"), "1");
    EXPECT_TRUE(isChanged("x"));
    EXPECT_FALSE(isChanged("done"));
    ASSERT_TRUE(scan->stepBack(Step::Over));
    EXPECT_NE(top("Main.x"), "1");
    while (scan->step(Step::Over)) continue;
    EXPECT_EQ(top("Main.s"), "'a long text that fills more than eight bytes'");
    const auto recorded = session.history().seek(2);
    const auto end = static_cast<std::ptrdiff_t>(session.program()->layout.dataEnd);
    EXPECT_TRUE(std::equal(recorded.begin() + 64, recorded.begin() + end, scan->image().begin() + 64))
        << "ends as recorded";
}

TEST_F(SlowScanTest, StepsIntoABlockAndOutOfItInBothDirections) {
    scan->step(Step::Over);
    ASSERT_EQ(here().substr(0, 2), "a(") << here();
    scan->step(Step::In);
    EXPECT_EQ(here(), "more := up * 2;");
    const auto frames = scan->stackTrace();
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].function, "Counter");
    EXPECT_EQ(frames[0].instance, "Main.a");
    EXPECT_EQ(frames[1].function, "Main");
    EXPECT_EQ(session.program()->sources[frames[1].range.file].slice(frames[1].range).substr(0, 2), "a(");
    EXPECT_FALSE(frames[0].task.empty());
    scan->step(Step::Over);
    EXPECT_EQ(value("more", frames[0].id), "2") << "a VAR_TEMP of the frame";
    EXPECT_EQ(value("up", frames[0].id), "1");
    EXPECT_TRUE(isChanged("more"));
    EXPECT_TRUE(scan->stepBack(Step::Out));
    EXPECT_EQ(here().substr(0, 2), "a(");
    scan->step(Step::In);
    EXPECT_TRUE(scan->step(Step::Out));
    EXPECT_EQ(here().substr(0, 3), "FOR") << here();
    EXPECT_TRUE(scan->stepBack(Step::In));
    EXPECT_EQ(here(), "n := n + more;");
}

TEST_F(SlowScanTest, RunsToBreakpointsForwardsAndBackwardsAndSaysThePass) {
    const uint32_t line = 13; // x := x + a.n;
    scan->setBreakpoints({{FileId(0), line}});
    ASSERT_TRUE(scan->goOn());
    EXPECT_EQ(here(), "x := x + a.n;");
    EXPECT_EQ(scan->passes(), std::vector<uint64_t>{0});
    ASSERT_TRUE(scan->goOn());
    EXPECT_EQ(scan->passes(), std::vector<uint64_t>{1});
    ASSERT_TRUE(scan->goOn());
    EXPECT_TRUE(scan->isAtEnd());
    EXPECT_FALSE(scan->goOn());
    EXPECT_TRUE(scan->stackTrace().empty());
    ASSERT_TRUE(scan->reverseContinue());
    EXPECT_EQ(scan->passes(), std::vector<uint64_t>{1});
    ASSERT_TRUE(scan->reverseContinue());
    ASSERT_TRUE(scan->reverseContinue());
    EXPECT_EQ(scan->at(), 0u);
    EXPECT_FALSE(scan->reverseContinue());
}

TEST_F(SlowScanTest, GoesToAStatementAndToWhatWroteAPlace) {
    ASSERT_TRUE(scan->goToStatement(plc::testing::rangeOf(*session.program(), "done := x > 3;")));
    EXPECT_EQ(here(), "done := x > 3;");
    const auto place = session.program()->layout.find("Main.b.n");
    ASSERT_TRUE(place);
    const auto writes = scan->look().writesTo(place->offset, 2);
    ASSERT_FALSE(writes.empty());
    ASSERT_TRUE(scan->goToEvent(writes.back()));
    EXPECT_EQ(here(), "n := n + more;");
    EXPECT_EQ(scan->stackTrace().front().instance, "Main.b");
    EXPECT_FALSE(scan->goToStatement({FileId(0), 1, 2}));
}

TEST(SlowScan, ABreakpointIsAtTheFirstStatementOfItsLineInBothDirections) {
    session::Session session(buildText("PROGRAM Main\nVAR a, b, c : INT; END_VAR\na := a + 1;\nb := a; c := b;\n"
                                       "a := c;\nEND_PROGRAM"));
    session.controller().start();
    for (int n = 0; n < 2; ++n) session.controller().scan();
    Insight insight(session.history());
    const auto look = insight.look(1);
    ASSERT_TRUE(look);
    SlowScan scan(*look);
    const auto here = [&] { return std::string(session.program()->sources[FileId(0)].slice(scan.range())); };
    scan.setBreakpoints({{FileId(0), 4}});
    ASSERT_TRUE(scan.goOn());
    EXPECT_EQ(here(), "b := a;");
    ASSERT_TRUE(scan.goOn());
    EXPECT_TRUE(scan.isAtEnd()) << "not at c := b;, where a running program does not stop either";
    ASSERT_TRUE(scan.reverseContinue());
    EXPECT_EQ(here(), "b := a;");
}

TEST(SlowScan, EndsAsRecordedInRandomProgramsWhateverWasWrittenAndForced) {
    for (unsigned seed = 200; seed < 200 + repeats(10U); ++seed) {
        session::Session session(buildText(plc::testing::RandomProgram(seed).text()));
        session.controller().start();
        for (int i = 0; i < 12; ++i) {
            if (i == 4) (void)session.controller().write("input", integerFor(*session.program(), "input", i * 5));
            if (i == 7) (void)session.controller().force("input", integerFor(*session.program(), "input", 3));
            session.controller().scan();
        }
        Insight insight(session.history());
        for (const Position at : {Position(0), Position(4), Position(7), Position(11)}) {
            const auto look = insight.look(at);
            ASSERT_TRUE(look);
            SlowScan scan(*look);
            ASSERT_GT(scan.stops(), 0u);
            // The writes of all statements together give what the scan has left.
            scan.goTo(scan.stops() - 1);
            std::vector<std::byte> image(scan.image().begin(), scan.image().end());
            const auto events = (*look)->events();
            for (EventIndex i = scan.event(); i < events.size(); ++i) {
                if (events[i].kind != image::WatchKind::Write) continue;
                if (events[i].bit >= 0) {
                    const auto mask = std::byte(1 << events[i].bit);
                    std::byte& byte = image[events[i].offset];
                    byte = (byte & ~mask) | (std::byte(static_cast<uint8_t>(events[i].bits)) & mask);
                    continue;
                }
                const auto copied = (*look)->bytesOf(events[i]);
                std::memcpy(image.data() + events[i].offset,
                            copied.empty() ? static_cast<const void*>(&events[i].bits) : copied.data(), events[i].size);
            }
            const auto recorded = session.history().seek(at);
            const size_t end = session.program()->layout.dataEnd;
            for (size_t byte = 64; byte < end; ++byte)
                ASSERT_EQ(recorded[byte], image[byte])
                    << seed << " scan " << at << " " << session.program()->layout.pathAt(static_cast<uint32_t>(byte));
            scan.goTo(0);
            size_t steps = 0;
            while (scan.step(Step::In)) ++steps;
            EXPECT_EQ(steps, scan.stops());
            while (scan.stepBack(Step::In)) continue;
            EXPECT_EQ(scan.at(), 0u);
        }
    }
}
