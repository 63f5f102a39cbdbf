// What a scan did, beside its text.
#include "runtime/inside/scan_text.h"

#include "tests/runtime/inside/recorded.h"
#include "tests/support/two_axes.h"

using namespace plc;
using namespace plc::inside;
using plc::testing::buildText;
using plc::testing::kTwoAxes;
using plc::testing::rangeOf;

namespace {

class ScanTextTest : public ::testing::Test {
protected:
    void SetUp() override {
        session.controller().start();
        session.controller().scan();
        insight = std::make_unique<Insight>(session.history());
        auto found = insight->look(0);
        ASSERT_TRUE(found) << found.error().english();
        look = *found;
        part.file = FileId(0);
        part.end = ~uint32_t(0);
    }
    std::string slice(SourceRange range) { return std::string(session.program()->sources[range.file].slice(range)); }
    /// "n=0 n:=1": what is shown for the text of a statement.
    std::string shown(const ScanText& text, const char* statement) {
        const SourceRange range = rangeOf(*session.program(), statement);
        std::string all;
        for (const ScanText::Value& value : text.values)
            if (range.begin <= value.range.begin && value.range.end <= range.end)
                all += (all.empty() ? "" : " ") + slice(value.range) + (value.isWritten ? ":=" : "=") +
                       types::toText(*session.program()->layout.types, value.value);
        return all;
    }
    bool isDimmed(const ScanText& text, const char* statement) {
        const SourceRange range = rangeOf(*session.program(), statement);
        return std::find(text.notRun.begin(), text.notRun.end(), range) != text.notRun.end();
    }

    session::Session session{buildText(kTwoAxes)};
    std::unique_ptr<Insight> insight;
    std::shared_ptr<const Look> look;
    TextPart part;
};

} // namespace

TEST_F(ScanTextTest, EachValueIsThatOfItsPlaceNotOfTheScansEnd) {
    const ScanText text = textOf(*look, part);
    EXPECT_EQ(shown(text, "n := n + 1;"), "n=0 n:=1");
    EXPECT_EQ(shown(text, "n := n + 10;"), "n=1 n:=11");
}

TEST_F(ScanTextTest, TheBranchTakenIsSaidAndWhatDidNotRunToo) {
    part.instances["Axis"] = "Main.a";
    ScanText text = textOf(*look, part);
    EXPECT_TRUE(isDimmed(text, "pos := pos + step;"));
    EXPECT_FALSE(isDimmed(text, "pos := pos - 1;"));
    EXPECT_TRUE(isDimmed(text, "n := 0;"));
    EXPECT_FALSE(isDimmed(text, "a(step := 1);"));
    ASSERT_EQ(text.conditions.size(), 2u);
    EXPECT_EQ(slice(text.conditions[0].range), "step > 1");
    EXPECT_FALSE(text.conditions[0].isTrue);
    part.instances["Axis"] = "Main.b";
    text = textOf(*look, part);
    EXPECT_FALSE(isDimmed(text, "pos := pos + step;"));
    EXPECT_TRUE(isDimmed(text, "pos := pos - 1;"));
    EXPECT_TRUE(text.conditions[0].isTrue);
    EXPECT_EQ(shown(text, "pos := pos + step;"), "pos=0 step=2 pos:=2");
}

TEST_F(ScanTextTest, ThePassOfALoopCanBeChosen) {
    ScanText text = textOf(*look, part);
    ASSERT_EQ(text.loops.size(), 1u);
    EXPECT_EQ(text.loops[0].count, 3u);
    EXPECT_EQ(text.loops[0].pass, 2u);
    EXPECT_EQ(shown(text, "sum := sum + i;"), "sum=3 i=3 sum:=6");
    part.passes[text.loops[0].range.begin] = 1;
    text = textOf(*look, part);
    EXPECT_EQ(text.loops[0].pass, 1u);
    EXPECT_EQ(shown(text, "sum := sum + i;"), "sum=1 i=2 sum:=3");
    EXPECT_FALSE(isDimmed(text, "sum := sum + i;"));
}

TEST_F(ScanTextTest, OnlyThePartThatIsAskedForIsRead) {
    const SourceRange wanted = rangeOf(*session.program(), "n := n + 10;");
    part.begin = wanted.begin;
    part.end = wanted.end;
    const ScanText text = textOf(*look, part);
    EXPECT_EQ(shown(text, "n := n + 1;"), "");
    EXPECT_EQ(shown(text, "n := n + 10;"), "n=1 n:=11");
    const auto functions = functionsIn(look->tree(), part.file, part.begin, part.end);
    ASSERT_EQ(functions.size(), 1u);
    EXPECT_EQ(session.program()->functions[functions[0]].name, "Main");
}

namespace {

/// "n := 1" and the like of the first scan of a program.
struct Read {
    explicit Read(const char* program) : session(buildText(program)) {
        session.controller().start();
        session.controller().scan();
        Insight insight(session.history());
        const auto look = insight.look(0);
        EXPECT_TRUE(look);
        TextPart part;
        part.file = FileId(0);
        part.end = ~uint32_t(0);
        text = textOf(**look, part);
    }
    bool has(const char* name, bool isWritten) {
        for (const ScanText::Value& value : text.values)
            if (session.program()->sources[value.range.file].slice(value.range) == name && value.isWritten == isWritten)
                return true;
        return false;
    }
    session::Session session;
    ScanText text;
};

} // namespace

TEST(ScanText, AnInstructionListIsReadLikeAText) {
    Read list(R"(PROGRAM Main
VAR n, m : INT; END_VAR
    LD n
    ADD 1
    ST m
END_PROGRAM)");
    EXPECT_TRUE(list.has("n", false));
    EXPECT_TRUE(list.has("m", true));
}
