#include "runtime/inside/why.h"

#include "runtime/inside/words.h"
#include "tests/projects/random_program.h"
#include "tests/runtime/inside/recorded.h"
#include "tests/support/repeats.h"

using namespace plc;
using namespace plc::inside;
using plc::testing::buildText;
using plc::testing::integerFor;
using plc::testing::rangeOf;

namespace {

class Why : public ::testing::Test {
protected:
    void run(const std::string& text) {
        session = std::make_unique<session::Session>(buildText(text));
        session->controller().start();
        insight = std::make_unique<Insight>(session->history());
        reasoner = std::make_unique<Reasoner>(*insight);
    }
    void scan(int count = 1) {
        for (int i = 0; i < count; ++i) session->controller().scan();
    }
    void set(const std::string& path, int64_t value, const std::string& origin = "panel Main, Start") {
        session->controller().actFor(origin);
        ASSERT_TRUE(session->controller().write(path, integerFor(*session->program(), path, value))) << path;
    }
    Position last() { return session->history().statistics().end - 1; }
    Explanation why(const std::string& text) {
        auto found = reasoner->why({text, {}}, last());
        EXPECT_TRUE(found) << found.error().english();
        return found ? *found : Explanation();
    }
    WhyNot whyNot(const std::string& text) {
        auto found = reasoner->whyNot({text, {}}, last());
        EXPECT_TRUE(found) << found.error().english();
        return found ? *found : WhyNot();
    }
    /// Without the name of the list, which is the file's.
    static std::string bare(const std::string& path) { return path.starts_with("main.") ? path.substr(5) : path; }
    static std::vector<std::string> names(const std::vector<Part>& parts) {
        std::vector<std::string> all;
        for (const Part& part : parts) all.push_back(part.isClock ? "time" : bare(part.path));
        return all;
    }
    static std::vector<std::string> ways(const WhyNot& answer) {
        std::vector<std::string> all;
        for (const std::vector<Change>& way : answer.ways) {
            std::string text;
            for (const Change& change : way) text += (text.empty() ? "" : " ") + bare(change.path) + "=" + change.to;
            all.push_back(text);
        }
        return all;
    }
    std::unique_ptr<session::Session> session;
    std::unique_ptr<Insight> insight;
    std::unique_ptr<Reasoner> reasoner;
};

using Names = std::vector<std::string>;

const char* const kLatch = R"(
VAR_GLOBAL start, stop, fault : BOOL; k1 : BOOL; END_VAR
PROGRAM Main
k1 := (start OR k1) AND NOT stop AND NOT fault;
END_PROGRAM)";

} // namespace

TEST_F(Why, AVariableThatAnOnlineChangeBroughtHasItsInitialValue) {
    run("PROGRAM Main\nVAR old : INT; END_VAR\nIF old = 0 THEN old := 5; END_IF\nEND_PROGRAM\n");
    scan(3);
    session->changeProgram(
        buildText("PROGRAM Main\nVAR more : INT := 7; old : INT; END_VAR\nIF old = 0 THEN old := 5; END_IF\n"
                  "END_PROGRAM\n"),
        nullptr);
    scan(2);
    const Explanation added = why("Main.more");
    EXPECT_EQ(added.value, "7");
    ASSERT_TRUE(added.writer);
    EXPECT_EQ(writerWords(*added.writer).english(), "its initial value");
    const Explanation kept = why("Main.old");
    ASSERT_TRUE(kept.writer);
    EXPECT_NE(writerWords(*kept.writer).english(), "its initial value") << "it has moved with its value";
}

TEST_F(Why, TellsTheTriggerOfALatchFromWhatItNeeded) {
    run(kLatch);
    scan(3);
    set("start", 1);
    scan();
    set("start", 0);
    scan(4);
    const Explanation answer = why("k1");
    EXPECT_EQ(answer.value, "TRUE");
    EXPECT_EQ(answer.before, "FALSE");
    EXPECT_EQ(answer.since.scan, 3u);
    EXPECT_EQ(names(answer.triggers), Names{"start"});
    ASSERT_EQ(answer.triggers.size(), 1u);
    ASSERT_TRUE(answer.triggers[0].writer);
    EXPECT_EQ(answer.triggers[0].writer->kind, WriterKind::Written);
    EXPECT_EQ(answer.triggers[0].writer->origin, "panel Main, Start");
    EXPECT_EQ(names(answer.enablers), (Names{"stop", "fault"}));
    EXPECT_EQ(names(answer.holding), (Names{"k1", "stop", "fault"})); // it holds itself
    ASSERT_TRUE(answer.writer);
    EXPECT_EQ(answer.writer->kind, WriterKind::Statement);
    EXPECT_EQ(placeWords(*answer.program, answer.writer->range), "main.st:4");
}

TEST_F(Why, NamesTheSmallestWaysToAnotherResult) {
    run(kLatch);
    set("stop", 1);
    scan(2);
    EXPECT_EQ(ways(whyNot("k1")), Names{"start=TRUE stop=FALSE"});
    set("stop", 0);
    scan();
    EXPECT_EQ(ways(whyNot("k1")), Names{"start=TRUE"});
    set("start", 1);
    scan();
    EXPECT_EQ(ways(whyNot("k1")), (Names{"start=FALSE", "stop=TRUE", "fault=TRUE"}));
}

TEST_F(Why, FollowsConditionsCallsAndInOut) {
    run(R"(
VAR_GLOBAL enable : BOOL; level : INT := 10; limit : INT := 50; valve : BOOL; END_VAR
FUNCTION_BLOCK Set VAR_IN_OUT out : BOOL; END_VAR VAR_INPUT high : BOOL; END_VAR
IF high THEN out := TRUE; ELSE out := FALSE; END_IF
END_FUNCTION_BLOCK
PROGRAM Main VAR f : Set; END_VAR
IF enable THEN
    f(out := valve, high := level > limit);
END_IF
END_PROGRAM)");
    scan(2);
    set("enable", 1);
    scan(2);
    set("level", 60);
    scan(3);
    const Explanation answer = why("valve");
    EXPECT_EQ(names(answer.triggers), Names{"level"});
    EXPECT_EQ(names(answer.enablers), (Names{"limit", "enable"}));
    EXPECT_EQ(answer.writer->instance, "Main.f");
    ASSERT_EQ(answer.writer->calls.size(), 2u);
    EXPECT_EQ(answer.writer->calls[0].function, "Main");
    EXPECT_EQ(answer.triggers.at(0).condition, "level > limit");
    set("level", 40);
    scan();
    set("enable", 0);
    scan();
    const WhyNot not1 = whyNot("valve");
    ASSERT_FALSE(not1.ways.empty());
    EXPECT_EQ(not1.ways[0].size(), 2u); // enable, and level or limit
}

TEST_F(Why, NamesTheConditionThatKeepsAWriterBehindAnInOutOrAReference) {
    run(R"(
VAR_GLOBAL open, close, up : BOOL; valve, lamp, horn : BOOL; lamps : ARRAY[1..3] OF BOOL; END_VAR
FUNCTION_BLOCK Inner VAR_IN_OUT out : BOOL; END_VAR IF open THEN out := TRUE; END_IF END_FUNCTION_BLOCK
FUNCTION_BLOCK Outer VAR_IN_OUT out : BOOL; END_VAR VAR i : Inner; END_VAR i(out := out); END_FUNCTION_BLOCK
FUNCTION Light : BOOL VAR_IN_OUT out : BOOL; END_VAR IF close THEN out := TRUE; END_IF END_FUNCTION
PROGRAM Main VAR o : Outer; horns : REF_TO BOOL; n : INT := 2; END_VAR
o(out := valve);
Light(out := lamp);
horns := REF(horn);
IF up THEN horns^ := TRUE; lamps[n] := TRUE; END_IF
END_PROGRAM)");
    scan(2);
    EXPECT_EQ(ways(whyNot("valve")), Names{"open=TRUE"});
    EXPECT_EQ(ways(whyNot("lamp")), Names{"close=TRUE"});
    EXPECT_EQ(ways(whyNot("horn")), Names{"up=TRUE"});
    EXPECT_EQ(ways(whyNot("lamps[2]")), Names{"up=TRUE"});
}

TEST_F(Why, ATimerIsExplainedByWhatItWasGiven) {
    run(R"(
VAR_GLOBAL go : BOOL; lamp : BOOL; END_VAR
PROGRAM Main VAR delay : TON; END_VAR
delay(IN := go, PT := T#50ms);
lamp := delay.Q;
END_PROGRAM)");
    scan(2);
    set("go", 1);
    scan(3);
    const std::string running = toText(whyNot("lamp"));
    EXPECT_NE(running.find("Main.delay (TON): it has run "), std::string::npos) << running;
    EXPECT_NE(running.find(" to go"), std::string::npos) << running;
    scan(100);
    const Explanation answer = why("lamp");
    EXPECT_EQ(answer.value, "TRUE");
    EXPECT_EQ(names(answer.triggers), Names{"time"});
    EXPECT_EQ(names(answer.enablers), Names{"go"});
}

TEST_F(Why, FollowsAnAliasToWhoeverWroteTheBytes) {
    run(R"(
VAR_GLOBAL word AT %MW8 : WORD; bit AT %MX8.3 : BOOL; lamp : BOOL; END_VAR
PROGRAM Main
VAR_INPUT on : BOOL; END_VAR
IF on THEN word := 16#0008; END_IF
lamp := bit;
END_PROGRAM)");
    scan(3);
    set("Main.on", 1);
    scan();
    const Explanation lamp = why("lamp");
    EXPECT_EQ(lamp.value, "TRUE");
    EXPECT_EQ(names(lamp.triggers), Names{"Main.on"});
    const auto writer = reasoner->lastWriter({"bit", {}}, last());
    ASSERT_TRUE(writer) << writer.error().english();
    EXPECT_EQ(writer->kind, WriterKind::Statement);
    EXPECT_EQ(writer->range, rangeOf(*session->program(), "word := 16#0008;")) << "by its other name";
    EXPECT_EQ(ways(whyNot("bit")), Names{"Main.on=FALSE"}) << "the bit was not set before this scan";
    scan();
    EXPECT_EQ(ways(whyNot("bit")), Names{}) << "set before, and nothing in the program clears it";
    set("Main.on", 0);
    set("word", 0);
    scan();
    const auto cleared = reasoner->lastWriter({"bit", {}}, last());
    ASSERT_TRUE(cleared) << cleared.error().english();
    EXPECT_EQ(cleared->kind, WriterKind::Written) << "the word was written from outside";
    EXPECT_EQ(names(why("lamp").triggers), Names{"bit"});
}

TEST_F(Why, FollowsReferencesAndInOutThroughSeveralCalls) {
    run(R"(
FUNCTION_BLOCK Setter
VAR_IN_OUT x : INT; a : ARRAY[1..3] OF INT; END_VAR
VAR_INPUT go : BOOL; END_VAR
IF go THEN x := x + 1; a[2] := x; END_IF
END_FUNCTION_BLOCK
FUNCTION_BLOCK Outer
VAR_IN_OUT y : INT; b : ARRAY[1..3] OF INT; END_VAR
VAR_INPUT go : BOOL; END_VAR
VAR s : Setter; END_VAR
s(x := y, a := b, go := go);
END_FUNCTION_BLOCK
PROGRAM Main
VAR go : BOOL; n, m, k : INT; all : ARRAY[1..3] OF INT; o : Outer; r : REF_TO INT; END_VAR
o(y := n, b := all, go := go);
r := REF(k);
r^ := all[2];
m := k;
END_PROGRAM)");
    scan(3);
    set("Main.go", 1);
    scan();
    for (const char* name : {"Main.n", "Main.all[2]", "Main.k", "Main.m"}) {
        const Explanation answer = why(name);
        EXPECT_EQ(answer.value, "1") << name;
        EXPECT_EQ(names(answer.triggers), Names{"Main.go"}) << name;
    }
    const auto writer = reasoner->lastWriter({"Main.all[2]", {}}, last());
    ASSERT_TRUE(writer) << writer.error().english();
    EXPECT_EQ(writer->range, rangeOf(*session->program(), "a[2] := x;"));
    EXPECT_EQ(writer->instance, "Main.o.s");
    EXPECT_EQ(writer->calls.size(), 3u);
    const auto k = reasoner->lastWriter({"Main.k", {}}, last());
    ASSERT_TRUE(k) << k.error().english();
    EXPECT_EQ(k->range, rangeOf(*session->program(), "r^ := all[2];"));
    EXPECT_EQ(ways(whyNot("Main.m > 0")), Names{"Main.go=FALSE"});
}

TEST_F(Why, TheWriterMayBeAForceAnInitialValueOrAReset) {
    run("VAR_GLOBAL a, b : INT; c : INT := 7; END_VAR PROGRAM Main b := a + c; END_PROGRAM");
    scan(2);
    ASSERT_TRUE(session->controller().force("a", integerFor(*session->program(), "a", 5)));
    scan(2);
    const auto forced = reasoner->lastWriter({"a", {}}, last());
    ASSERT_TRUE(forced) << forced.error().english();
    EXPECT_EQ(forced->kind, WriterKind::Forced);
    const auto initial = reasoner->lastWriter({"c", {}}, last());
    ASSERT_TRUE(initial) << initial.error().english();
    EXPECT_EQ(initial->kind, WriterKind::Initial);
    session->controller().releaseAll();
    session->controller().reset(controller::ResetKind::Cold);
    session->controller().start();
    scan();
    const auto reset = reasoner->lastWriter({"a", {}}, last());
    ASSERT_TRUE(reset);
    EXPECT_EQ(reset->kind, WriterKind::Reset);
    const auto all = reasoner->writers({"b", {}}, 0, last() + 1, 100);
    ASSERT_TRUE(all);
    ASSERT_EQ(all->size(), 3u);
    EXPECT_EQ((*all)[0].before, "0"); // in the first scan
    EXPECT_EQ((*all)[0].value, "7");
    EXPECT_EQ((*all)[1].value, "12");
    EXPECT_EQ((*all)[2].before, "12");
}

// A device that answers at once has written before there was any scan.
TEST_F(Why, WhatWasWrittenBeforeTheFirstScanIsListed) {
    run("VAR_GLOBAL a, b : INT; END_VAR\nPROGRAM Main\nb := a * 2;\nEND_PROGRAM");
    set("a", 21);
    scan(3);
    const auto all = reasoner->writers({"a", {}}, 0, last() + 1, 100);
    ASSERT_TRUE(all);
    ASSERT_EQ(all->size(), 1u);
    EXPECT_EQ((*all)[0].kind, WriterKind::Written);
    EXPECT_EQ((*all)[0].value, "21");
    EXPECT_TRUE((*all)[0].before.empty());
    EXPECT_EQ(reasoner->writers({"a", {}}, 1, last() + 1, 100)->size(), 0u);
}

TEST_F(Why, AStepOfAChartWaitsForItsTransition) {
    run(R"(
VAR_GLOBAL ready, full : BOOL; END_VAR
PROGRAM Main
INITIAL_STEP Idle: END_STEP
STEP Fill: END_STEP
TRANSITION FROM Idle TO Fill := ready AND NOT full; END_TRANSITION
TRANSITION FROM Fill TO Idle := full; END_TRANSITION
END_PROGRAM)");
    scan(3);
    EXPECT_EQ(ways(whyNot("Main.Fill.X")), Names{"ready=TRUE"});
    set("ready", 1);
    scan(3);
    const Explanation answer = why("Main.Fill.X");
    EXPECT_EQ(answer.value, "TRUE");
    EXPECT_EQ(names(answer.triggers), Names{"ready"});
}

/// On random programs and random influence: what is named as the trigger, taken back, changes the answer, and each way
/// to another result leads there.
TEST_F(Why, HoldsForRandomProgramsAndQuestions) {
    const size_t wanted = std::getenv("STEPWISE_LONG") ? 1000 : repeats(40U);
    size_t questions = 0, explained = 0, programs = 0;
    for (unsigned seed = 900; questions < wanted; ++seed) {
        ASSERT_LT(++programs, wanted) << "too few programs could be asked";
        run(plc::testing::RandomProgram(seed).text());
        std::mt19937 dice(seed);
        for (int i = 0; i < 60; ++i) {
            if (dice() % 4 == 0) set("input", static_cast<int64_t>(dice() % 200));
            scan();
        }
        for (const char* variable : {"P0.b0", "P0.i0", "P0.i1", "shared[2]", "raise"}) {
            const auto answer = reasoner->why({variable, {}}, last(), 0);
            if (!answer) continue; // this program does not have it
            if (answer->isSinceBegin) continue;
            ++questions;
            if (answer->triggers.empty()) continue;
            ++explained;
            const Position at = *session->history().positionOfScan(answer->since.scan);
            for (const Part& part : answer->triggers) {
                EXPECT_TRUE(part.isVerified);
                if (answer->triggers.size() > 1 || part.isClock || part.place.offset == 0) continue;
                history::ScanInput input = *session->history().inputOf(at);
                const auto value = types::parseValue(*session->program()->layout.types, part.place.type, part.before);
                ASSERT_TRUE(value) << part.before;
                types::writeValue(*session->program()->layout.types, part.place.type, *value,
                                  std::span(input.image).subspan(part.place.offset), part.place.bit);
                const Rerun again = insight->rerunner().runFrom(std::move(input));
                const auto expression = session->expression(variable);
                const std::string now = types::toText(expression->types(), expression->evaluate(again.image).value);
                EXPECT_NE(now, answer->value) << "seed " << seed << " " << variable << " by " << part.path;
            }
        }
        const auto condition = reasoner->whyNot({"P0.i0 > 50", {}}, last());
        if (!condition) continue;
        for (const std::vector<Change>& way : condition->ways) {
            history::ScanInput input = *session->history().inputOf(last());
            const types::TypeTable& types = *session->program()->layout.types;
            for (const Change& change : way) {
                const auto value = types::parseValue(types, change.place.type, change.to);
                ASSERT_TRUE(value) << change.to;
                types::writeValue(types, change.place.type, *value, std::span(input.image).subspan(change.place.offset),
                                  change.place.bit);
            }
            const Rerun again = insight->rerunner().runFrom(std::move(input));
            EXPECT_EQ(session->expression("P0.i0 > 50")->isTrue(again.image), condition->wanted == "TRUE") << seed;
        }
    }
    EXPECT_GE(explained * 10, questions * 8) << explained << " of " << questions;
}

TEST_F(Why, AnInstructionListIsExplainedByItsInstructions) {
    run(R"(
VAR_GLOBAL start, stop, k1 : BOOL; END_VAR
PROGRAM Main
    LD start
    OR k1
    ANDN stop
    ST k1
END_PROGRAM)");
    scan(3);
    EXPECT_EQ(ways(whyNot("k1")), Names{"start=TRUE"});
    set("start", 1);
    scan();
    const Explanation k1 = why("k1");
    EXPECT_EQ(k1.value, "TRUE");
    EXPECT_EQ(names(k1.triggers), Names{"start"});
    EXPECT_EQ(names(k1.enablers), Names{"stop"});
    ASSERT_TRUE(k1.writer);
    EXPECT_EQ(placeWords(*session->program(), k1.writer->range), "main.st:7") << "ST k1";
}

TEST_F(Why, ACounterSaysHowFarItIs) {
    run(R"(
VAR_GLOBAL pulse, full : BOOL; END_VAR
PROGRAM Main
VAR parts : CTU; END_VAR
parts(CU := pulse, RESET := FALSE, PV := 3);
full := parts.Q;
END_PROGRAM)");
    const auto pulses = [&](int count) {
        for (int i = 0; i < count; ++i) {
            set("pulse", 1);
            scan();
            set("pulse", 0);
            scan();
        }
    };
    pulses(2);
    EXPECT_NE(toText(whyNot("full")).find("it has counted 2 of 3"), std::string::npos) << toText(whyNot("full"));
    set("pulse", 1);
    scan();
    const Explanation full = why("full");
    EXPECT_EQ(full.value, "TRUE");
    EXPECT_EQ(names(full.triggers), Names{"pulse"});
    EXPECT_NE(toText(full).find("it has counted 3 of 3"), std::string::npos) << toText(full);
    scan(4); // it stays full
    const Explanation later = why("full");
    EXPECT_EQ(later.since.scan, full.since.scan);
}

TEST_F(Why, ListsAllChangesNewestFirstDownToTheInitialValue) {
    run(kLatch);
    scan(3);
    set("start", 1);
    scan();
    set("start", 0);
    scan(2);
    set("stop", 1);
    scan(2);
    const auto all = reasoner->writersBackFrom({"k1", {}}, last(), 100);
    ASSERT_TRUE(all) << all.error().english();
    ASSERT_EQ(all->size(), 3u);
    EXPECT_EQ((*all)[0].value, "FALSE");
    EXPECT_EQ((*all)[0].before, "TRUE");
    EXPECT_EQ((*all)[1].value, "TRUE");
    EXPECT_EQ((*all)[2].kind, WriterKind::Statement) << "the first scan's statement wrote FALSE";
    const auto start = reasoner->writersBackFrom({"start", {}}, last(), 100);
    ASSERT_TRUE(start);
    ASSERT_EQ(start->size(), 3u);
    EXPECT_EQ((*start)[0].kind, WriterKind::Written);
    EXPECT_EQ((*start)[2].kind, WriterKind::Initial);
    const auto newest = reasoner->writersBackFrom({"start", {}}, last(), 1);
    ASSERT_TRUE(newest);
    EXPECT_EQ(newest->size(), 1u);
}

TEST(WhyWords, SayWhoFromOutsideWroteInTheReadersLanguage) {
    Writer writer;
    writer.kind = WriterKind::Written;
    writer.origin = "panel Main, Start";
    EXPECT_EQ(writerWords(writer).english(), "written from panel Main, Start");
    writer.origin = "studio";
    EXPECT_EQ(writerWords(writer).english(), "written from the studio");
    writer.origin = "a script";
    EXPECT_EQ(writerWords(writer).english(), "written from a script");
    writer.kind = WriterKind::Forced;
    writer.origin.clear();
    EXPECT_EQ(writerWords(writer).english(), "forced");
    // Every sentence is one of the list: nothing is shown in English to every reader.
    const auto translated = messages::render(
        writerWords(writer), [](const messages::Form& form) { return std::string("<") + form.context + ">"; });
    EXPECT_EQ(translated, "<Inside>");
}
