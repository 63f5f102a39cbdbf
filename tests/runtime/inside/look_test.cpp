#include "runtime/inside/why.h"
#include "runtime/inside/words.h"
#include "tests/projects/random_program.h"
#include "tests/runtime/inside/recorded.h"

using namespace plc;
using namespace plc::inside;
using plc::testing::buildText;
using plc::testing::integerFor;
using plc::testing::rangeOf;

namespace {

std::vector<std::string> texts(const Look& look, const std::vector<Seen>& all) {
    std::vector<std::string> shown;
    for (const Seen& seen : all) shown.push_back(types::toText(*look.tree().types, seen.value));
    return shown;
}

using Texts = std::vector<std::string>;

} // namespace

TEST(Look, WatchedScansOfRandomProgramsComeOutAsRecorded) {
    for (unsigned seed = 100; seed < 112; ++seed) {
        session::Session session(buildText(plc::testing::RandomProgram(seed).text()));
        session.controller().start();
        for (int i = 0; i < 30; ++i) {
            if (i % 7 == 3) (void)session.controller().write("input", integerFor(*session.program(), "input", i * 5));
            session.controller().scan();
        }
        Insight insight(session.history());
        for (Position at = 0; at < 30; ++at) {
            const auto look = insight.look(at);
            ASSERT_TRUE(look) << look.error().english();
            ASSERT_TRUE((*look)->isExact())
                << "seed " << seed << " scan " << at << " " << (*look)->differences()[0].path;
            EXPECT_EQ((*look)->leftOut(), 0u);
            for (const Activation& activation : (*look)->activations()) {
                EXPECT_NE(activation.end, kNone);
                EXPECT_NE(activation.task, kNone);
            }
        }
    }
}

TEST(Look, TellsWhatExpressionsWereAtTheirPlaceAndInTheirInstance) {
    session::Session session(buildText(R"(
FUNCTION Twice : INT VAR_INPUT x : INT; END_VAR Twice := x * 2; END_FUNCTION
FUNCTION_BLOCK Counter VAR_INPUT up : BOOL; END_VAR VAR_OUTPUT n : INT; END_VAR
IF up THEN n := n + 1; ELSE n := Twice(n); END_IF
END_FUNCTION_BLOCK
PROGRAM Main
VAR a, b : Counter; x : INT := 5; s : STRING; arr : ARRAY[0..3] OF INT; i, sum : INT; r : REAL; END_VAR
x := x + 1;
x := x * 3;
a(up := TRUE);
b(up := x > 100);
s := CONCAT('n = ', INT_TO_STRING(x));
sum := 0;
FOR i := 0 TO 3 DO
    arr[i] := i * x;
    sum := sum + arr[i];
END_FOR
r := INT_TO_REAL(sum) / 2.0;
IF x > 0 AND_THEN sum < 0 THEN x := 0; END_IF
END_PROGRAM)"));
    session.controller().start();
    session.controller().scan();
    Insight insight(session.history());
    const auto found = insight.look(0);
    ASSERT_TRUE(found) << found.error().english();
    const Look& look = **found;
    ASSERT_TRUE(look.isExact());
    const image::CompiledProgram& program = *session.program();
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "x + 1"))), Texts{"6"});
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "x * 3"))), Texts{"18"});
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "x", "x * 3"))), Texts{"6"}); // as it was there
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "up", "IF up"))), (Texts{"TRUE", "FALSE"}));
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "up", "IF up"), "Main.b")), Texts{"FALSE"});
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "x * 2"), "Main.b")), Texts{"0"});
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "x * 2"), "Main.a")), Texts{});
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "CONCAT('n = ', INT_TO_STRING(x))"))), Texts{"'n = 18'"});
    const auto passes = look.valuesOf(rangeOf(program, "i * x"));
    EXPECT_EQ(texts(look, passes), (Texts{"0", "18", "36", "54"}));
    ASSERT_EQ(passes.size(), 4u);
    EXPECT_EQ(passes[3].passes, std::vector<uint64_t>{3});
    EXPECT_EQ(texts(look, look.valuesOf(rangeOf(program, "INT_TO_REAL(sum) / 2.0"))), Texts{"54.0"});
    EXPECT_EQ(look.timesExecuted(rangeOf(program, "n := n + 1;")), 1u);
    EXPECT_EQ(look.timesExecuted(rangeOf(program, "n := n + 1;"), "Main.b"), 0u);
    EXPECT_EQ(look.timesExecuted(rangeOf(program, "sum := sum + arr[i];")), 4u);
    EXPECT_FALSE(look.isExecuted(rangeOf(program, "x := 0;")));
}

TEST(Look, FollowsWritesThroughInOutAndAliases) {
    session::Session session(buildText(R"(
VAR_GLOBAL w AT %MW2 : INT; low AT %MB2 : BYTE; END_VAR
FUNCTION_BLOCK Set VAR_IN_OUT v : INT; END_VAR v := v + 7; END_FUNCTION_BLOCK
PROGRAM Main VAR f : Set; p : REF_TO INT; y : INT; END_VAR
f(v := w);
p := REF(y);
p^ := 12;
w := w + p^;
END_PROGRAM)"));
    session.controller().start();
    session.controller().scan();
    Insight insight(session.history());
    const auto look = insight.look(0);
    ASSERT_TRUE(look) << look.error().english();
    ASSERT_TRUE((*look)->isExact());
    const auto place = session.program()->layout.find("low");
    const std::vector<EventIndex> writes = (*look)->writesTo(place->offset, 1);
    ASSERT_EQ(writes.size(), 2u);
    EXPECT_EQ((*look)->events()[writes[0]].stmt()->range, rangeOf(*session.program(), "v := v + 7;"));
    EXPECT_EQ((*look)->instanceOf((*look)->events()[writes[0]].activation), "Main.f");
    const auto y = session.program()->layout.find("Main.y");
    ASSERT_EQ((*look)->writesTo(y->offset, 2).size(), 1u);
}

TEST(Look, LoopsKeepThePassesAskedForWithinTheLimit) {
    session::Session session(buildText("PROGRAM Main VAR i, n : DINT; END_VAR\n"
                                       "FOR i := 1 TO 20000 DO n := n + i; END_FOR\nEND_PROGRAM"));
    session.controller().start();
    session.controller().scan();
    Insight insight(session.history());
    const SourceRange loop = rangeOf(*session.program(), "FOR i := 1 TO 20000 DO");
    LookOptions options;
    options.windows.push_back({loop, 15'000, 2});
    const auto look = insight.look(0, options);
    ASSERT_TRUE(look);
    EXPECT_TRUE((*look)->isExact());
    EXPECT_EQ(texts(**look, (*look)->valuesOf(rangeOf(*session.program(), "n + i"))).size(), 2u);
    EXPECT_GT((*look)->leftOut(), 10'000u);
    LookOptions small;
    small.eventLimit = 1000;
    small.windows.push_back({loop, 0, 100'000});
    const auto cut = insight.look(0, small);
    ASSERT_TRUE(cut);
    EXPECT_LE((*cut)->events().size(), 1100u);
    EXPECT_GT((*cut)->leftOut(), 0u);
    EXPECT_TRUE((*cut)->isExact());
}

TEST(Look, OnlyTheFunctionsAskedForAndWhatLeadsToThem) {
    session::Session session(buildText(R"(
FUNCTION_BLOCK Inner VAR n : INT; END_VAR n := n + 1; END_FUNCTION_BLOCK
FUNCTION_BLOCK Outer VAR i : Inner; END_VAR i(); END_FUNCTION_BLOCK
FUNCTION_BLOCK Other VAR n : INT; END_VAR n := n + 2; END_FUNCTION_BLOCK
PROGRAM Main VAR o : Outer; p : Other; END_VAR o(); p(); END_PROGRAM)"));
    session.controller().start();
    session.controller().scan();
    session.controller().scan();
    Insight insight(session.history());
    uint32_t inner = 0;
    for (uint32_t f = 1; f < session.program()->functions.size(); ++f)
        if (session.program()->functions[f].name == "Inner") inner = f;
    LookOptions options;
    options.functions = {inner};
    const auto look = insight.look(1, options);
    ASSERT_TRUE(look) << look.error().english();
    EXPECT_TRUE((*look)->isExact());
    EXPECT_EQ(texts(**look, (*look)->valuesOf(rangeOf(*session.program(), "n + 1"))), Texts{"2"});
    EXPECT_TRUE((*look)->valuesOf(rangeOf(*session.program(), "n + 2")).empty());
}

// ---------------------------------------------------------------- long scans

namespace {

/// Its one scan does more than a look keeps.
const std::string kLongScan = plc::testing::longScan(2'000'000);

} // namespace

TEST(LongLook, IsLeftInItsMiddleOnRequest) {
    session::Session session(buildText(kLongScan));
    session.controller().start();
    ASSERT_TRUE(session.controller().scan());
    Insight insight(session.history());
    int asked = 0;
    insight.setCancel([&] { return ++asked > 3; });
    const auto look = insight.look(0);
    ASSERT_FALSE(look);
    EXPECT_EQ(look.error().message.english(), "cancelled");
    EXPECT_LT(asked, 10);
    asked = 0;
    Reasoner reasoner(insight);
    EXPECT_FALSE(reasoner.why({"Main.a", {}}, 0));
    const auto input = session.history().inputOf(0);
    ASSERT_TRUE(input);
    EXPECT_FALSE(insight.lookFrom(*input));
    insight.setCancel(nullptr);
    const auto whole = insight.look(0);
    ASSERT_TRUE(whole) << whole.error().english();
    EXPECT_TRUE((*whole)->isExact());
}

TEST(LongLook, SaysThatNotAllIsKept) {
    session::Session session(buildText(kLongScan));
    session.controller().start();
    ASSERT_TRUE(session.controller().scan());
    Insight insight(session.history());
    Reasoner reasoner(insight);
    const auto why = reasoner.why({"Main.a", {}}, 0);
    ASSERT_TRUE(why) << why.error().english();
    EXPECT_EQ(why->value, "2000000");
    EXPECT_EQ(why->doubt.english(), "the scan did more than can be kept: only its beginning is known");
    EXPECT_TRUE(why->steps.empty()) << "those of an earlier value";
    ASSERT_TRUE(why->writer);
    EXPECT_EQ(why->writer->kind, WriterKind::Unknown);
    for (const Sentence& sentence : sentencesOf(*why))
        EXPECT_NE(sentence.kind, SentenceKind::Writer) << sentence.text.english();
    const auto whyNot = reasoner.whyNot({"Main.a > 5", {}}, 0);
    ASSERT_TRUE(whyNot) << whyNot.error().english();
    EXPECT_EQ(whyNot->doubt.english(), why->doubt.english());
}
