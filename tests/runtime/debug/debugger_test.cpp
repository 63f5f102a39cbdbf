#include "runtime/debug/debugger.h"
#include "runtime/debug/frames.h"
#include "runtime/expression/code.h"
#include "tests/runtime/hand_made_program.h"

#include <gtest/gtest.h>

namespace plc::debug {
namespace {

using namespace std::chrono_literals;
using controller::Controller;
using controller::runtimeSymbols;
using image::Area;
using plc::testing::at;
using plc::testing::HandMade;
using plc::testing::RuntimeContext;
using types::TypeKind;
using types::TypeTable;

// The text that the C++ functions below pretend to be the quick code of:
const char* const kText = "PROGRAM Main\n"        // 1
                          "  n := n + 1;\n"       // 2  site 1
                          "  a(); \n"             // 3  site 2
                          "\n"                    // 4
                          "  b(); n := n;\n"      // 5  sites 3, 4
                          "END_PROGRAM\n"         // 6
                          "FUNCTION_BLOCK B\n"    // 7
                          "  k := k + 1;\n"       // 8  site 5
                          "  t := k * 2;\n"       // 9  site 6
                          "END_FUNCTION_BLOCK\n"; // 10

// Main: n (DINT), a (B), b (B); B: k (INT). B has a local t (DINT) at frame + 8.
void stop(RuntimeContext* c, uint32_t site, uint32_t instance, uint32_t frame) {
    c->currentSite = site;
    if (c->siteFlags[site]) runtimeSymbols().atSite(c, site, instance, frame);
}
void block(RuntimeContext* c, std::byte* image, uint32_t instance, uint32_t frame) {
    stop(c, 5, instance, frame);
    ++at<int16_t>(image, instance);
    stop(c, 6, instance, frame);
    at<int32_t>(image, frame + 8) = at<int16_t>(image, instance) * 2;
}
void call(RuntimeContext* c, std::byte* image, uint32_t site, uint32_t instance) {
    const uint32_t frame = c->frameTop + 64;
    c->calls[c->depth++] = {site, 2, instance, frame};
    block(c, image, instance, frame);
    --c->depth;
}
void mainBody(RuntimeContext* c, std::byte* image, uint32_t instance) {
    c->calls[c->depth++] = {0, 1, instance, c->frameTop};
    stop(c, 1, instance, c->frameTop);
    ++at<int32_t>(image, instance);
    stop(c, 2, instance, c->frameTop);
    call(c, image, 2, instance + 4);
    stop(c, 3, instance, c->frameTop);
    call(c, image, 3, instance + 6);
    stop(c, 4, instance, c->frameTop);
    --c->depth;
}

SourceRange rangeOf(FileId file, const char* part, size_t from = 0) {
    const std::string text(kText);
    const size_t begin = text.find(part, from);
    return {file, static_cast<uint32_t>(begin), static_cast<uint32_t>(begin + std::strlen(part))};
}

class DebuggerTest : public ::testing::Test {
protected:
    DebuggerTest() {
        HandMade made;
        file = made.program().sources.add("main.st", kText);
        const types::TypeId b = made.structure("B", {HandMade::field("k", TypeKind::Int)}, TypeKind::Block);
        const types::TypeId main = made.structure(
            "Main", {HandMade::field("n", TypeKind::Dint), HandMade::field("a", b), HandMade::field("b", b)},
            TypeKind::Block);
        made.add("Main", main, Area::Program);
        made.function("Main", &mainBody, main);
        made.function("B", nullptr, b);
        made.program().functions[2].locals.push_back({"t", TypeTable::of(TypeKind::Dint), 8, false, false});
        made.site(1, rangeOf(file, "n := n + 1;"));
        made.site(1, rangeOf(file, "a();"));
        made.site(1, rangeOf(file, "b();"));
        made.site(1, rangeOf(file, "n := n;"));
        made.site(2, rangeOf(file, "k := k + 1;"));
        made.site(2, rangeOf(file, "t := k * 2;"));
        made.task("main", 1, 10ms);
        program = made.finish();
        plc = std::make_unique<Controller>(program);
        debugger = std::make_unique<Debugger>(
            *plc, [this](const std::string& text, const std::string& instance) { return condition(text, instance); },
            [this](const Halt& halt) { return halted(halt); });
        plc->start();
    }
    /// "NAME = NUMBER" seen from the instance.
    Result<expression::Expression> condition(const std::string& text, const std::string& instance) {
        compiled.push_back(text + " in " + instance);
        const size_t equals = text.find(" = ");
        const Result<image::Place> place = program->layout.find(instance + "." + text.substr(0, equals));
        if (!place) return place.error();
        expression::CodeBuilder builder;
        builder.load(*program->layout.types, *place);
        builder.constant(*program->layout.types, types::Value{place->type, std::stoll(text.substr(equals + 3))});
        builder.binary(*program->layout.types, library::BinaryOp::Equal, place->type);
        return expression::Expression(text, program->layout.types, builder.finish(), TypeTable::of(TypeKind::Bool));
    }
    Going halted(const Halt& halt) {
        EXPECT_EQ(plc->state(), controller::State::Halted);
        EXPECT_TRUE(debugger->isHalted());
        const LineColumn at = program->sources[file].lineColumn(program->sites[halt.site].range.begin);
        std::string where = std::to_string(at.line);
        if (!halt.frames.empty() && halt.frames.front().instance != "Main") where += "@" + halt.frames.front().instance;
        halts.push_back(where);
        last = halt;
        if (onHalt) return onHalt(halt);
        return Going::On;
    }
    Breakpoint at(uint32_t line) {
        Breakpoint breakpoint;
        breakpoint.file = file;
        breakpoint.line = line;
        return breakpoint;
    }
    std::vector<std::string> scans(int count) {
        halts.clear();
        for (int i = 0; i < count; ++i) (void)plc->scan();
        return halts;
    }
    using Lines = std::vector<std::string>;
    FileId file;
    std::shared_ptr<image::CompiledProgram> program;
    std::unique_ptr<Controller> plc;
    std::unique_ptr<Debugger> debugger;
    std::vector<std::string> halts, compiled;
    Halt last;
    std::function<Going(const Halt&)> onHalt;
};

TEST_F(DebuggerTest, ALineStandsForTheFirstStatementOnOrAfterIt) {
    for (const auto& [line, expected] :
         {std::pair{1u, 1u}, {2u, 1u}, {3u, 2u}, {4u, 3u}, {5u, 3u}, {6u, 5u}, {9u, 6u}}) {
        const SitesOfLine found = sitesOfLine(*program, file, line);
        ASSERT_EQ(found.sites, std::vector<uint32_t>{expected}) << "line " << line;
    }
    EXPECT_EQ(sitesOfLine(*program, file, 4).line, 5u);
    EXPECT_TRUE(sitesOfLine(*program, file, 10).sites.empty());
    EXPECT_TRUE(sitesOfLine(*program, file, 99).sites.empty());
}

TEST_F(DebuggerTest, HaltsAtABreakpointInEveryScanWithCallPathAndVariables) {
    debugger->setBreakpoints({at(9)});
    EXPECT_EQ(scans(2), (Lines{"9@Main.a", "9@Main.b", "9@Main.a", "9@Main.b"}));
    ASSERT_EQ(last.frames.size(), 2u);
    EXPECT_EQ(last.frames[0].function, "B");
    EXPECT_EQ(last.frames[1].function, "Main");
    EXPECT_EQ(last.frames[1].range, rangeOf(file, "b();"));
    const std::vector<FrameVariable> variables = frameVariables(*program, plc->image(), last.frames[0]);
    ASSERT_EQ(variables.size(), 2u);
    EXPECT_EQ(variables[0].name, "t");
    EXPECT_TRUE(variables[0].isLocal);
    EXPECT_EQ(variables[0].value.integer(), 4);
    EXPECT_EQ(variables[1].name, "k");
    EXPECT_EQ(variables[1].value.integer(), 2);
    debugger->setBreakpoints({});
    EXPECT_EQ(scans(2), Lines{});
}

TEST_F(DebuggerTest, InstanceConditionAndHitCountNarrowABreakpoint) {
    Breakpoint onlyB = at(8);
    onlyB.instance = "Main.b";
    debugger->setBreakpoints({onlyB});
    EXPECT_EQ(scans(2), (Lines{"8@Main.b", "8@Main.b"}));

    Breakpoint conditional = at(9);
    conditional.condition = "k = 5"; // the scans so far made it 2
    debugger->setBreakpoints({conditional});
    EXPECT_EQ(scans(4), (Lines{"9@Main.a", "9@Main.b"}));
    EXPECT_EQ(compiled, (Lines{"k = 5 in Main.a", "k = 5 in Main.b"})); // once per instance

    Breakpoint counted = at(2);
    counted.hitCount = 3;
    debugger->setBreakpoints({counted});
    EXPECT_EQ(scans(4), (Lines{"2", "2"}));

    Breakpoint off = at(2);
    off.isEnabled = false;
    debugger->setBreakpoints({off});
    EXPECT_EQ(scans(2), Lines{});
}

TEST_F(DebuggerTest, AConditionThatCanNotBeMadeHaltsAndSaysWhy) {
    Breakpoint wrong = at(8);
    wrong.condition = "kk = 5";
    debugger->setBreakpoints({wrong});
    EXPECT_EQ(scans(1).size(), 2u);
    EXPECT_NE(last.problem.english().find("has no variable 'kk'"), std::string::npos) << last.problem;
}

TEST_F(DebuggerTest, StepsInOverAndOutAcrossTheEndOfTheScan) {
    Breakpoint start = at(2);
    start.hitCount = 1;
    std::vector<Step> steps;
    onHalt = [&](const Halt&) {
        if (halts.size() == 1) debugger->setBreakpoints({});
        const size_t n = halts.size() - 1;
        if (n < steps.size()) debugger->step(steps[n]);
        return Going::On;
    };
    debugger->setBreakpoints({start});
    steps = {Step::Over, Step::In, Step::Over, Step::Over, Step::Over, Step::Over, Step::Over};
    EXPECT_EQ(scans(3), (Lines{"2", "3", "8@Main.a", "9@Main.a", "5", "5", "2", "3"}));
    steps = {Step::In, Step::In, Step::Out, Step::In, Step::Out, Step::Out};
    debugger->setBreakpoints({start});
    EXPECT_EQ(scans(3), (Lines{"2", "3", "8@Main.a", "5", "8@Main.b", "5", "2"}));
}

TEST_F(DebuggerTest, RunsToALine) {
    debugger->setBreakpoints({at(2)});
    onHalt = [&](const Halt&) {
        if (halts.size() == 1) {
            debugger->setBreakpoints({});
            debugger->runTo(file, 9);
        }
        return Going::On;
    };
    EXPECT_EQ(scans(3), (Lines{"2", "9@Main.a"}));
}

TEST_F(DebuggerTest, AStepFromARunningControllerHaltsAtTheNextStatement) {
    debugger->step(Step::Over);
    EXPECT_EQ(scans(2), (Lines{"2"}));
}

TEST_F(DebuggerTest, AbandoningLeavesTheScanAtOnce) {
    debugger->setBreakpoints({at(5)});
    onHalt = [](const Halt&) { return Going::Abandon; };
    EXPECT_FALSE(plc->scan());
    EXPECT_EQ(plc->state(), controller::State::Stopped);
    EXPECT_EQ(plc->read("Main.a.k")->integer(), 1);
    EXPECT_EQ(plc->read("Main.b.k")->integer(), 0);
    EXPECT_EQ(plc->nextScan(), 0u);
}

TEST_F(DebuggerTest, ReadsWritesAndForcesWorkWhileHalted) {
    debugger->setBreakpoints({at(3)});
    onHalt = [&](const Halt&) {
        EXPECT_EQ(plc->read("Main.n")->integer(), 1);
        EXPECT_TRUE(plc->write("Main.n", {TypeTable::of(TypeKind::Dint), int64_t(50)}));
        EXPECT_TRUE(plc->force("Main.a.k", {TypeTable::of(TypeKind::Int), int64_t(7)}));
        return Going::On;
    };
    (void)plc->scan();
    EXPECT_EQ(plc->read("Main.n")->integer(), 50);
    EXPECT_EQ(plc->read("Main.a.k")->integer(), 7);
}

} // namespace
} // namespace plc::debug
