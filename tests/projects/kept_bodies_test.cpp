// A keystroke checks the body it is in; what the checks find together is exactly what one check of everything finds,
// the trees of the program included.
#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/sema/kept_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace {
using namespace plc;

class Writing {
public:
    explicit Writing(const types::TypeTable& types) : m_types(types) {}
    std::string text;

    void range(SourceRange range) {
        if (range.file.isValid()) number(range.file.index()), number(range.begin), number(range.end);
    }
    void number(uint64_t value) { text += std::to_string(value) + " "; }
    void type(types::TypeId id) {
        number(id.value);
        if (id.isValid()) text += m_types[id].name + " ";
    }
    void place(const tree::Place* place) {
        if (!place) return;
        number(static_cast<uint64_t>(place->kind)), type(place->type), range(place->range), number(place->offset);
        number(static_cast<uint64_t>(place->bit)), number(place->local);
        this->place(place->base);
        for (const tree::Expr* each : place->indices) expr(each);
        expr(place->pointer), expr(place->value);
    }
    void expr(const tree::Expr* expr) {
        if (!expr) return;
        number(static_cast<uint64_t>(expr->kind)), type(expr->type), range(expr->range);
        place(expr->place);
        this->expr(expr->a), this->expr(expr->b), this->expr(expr->c);
        for (const tree::Expr* each : expr->operands) this->expr(each);
        if (expr->call) {
            number(expr->call->callee.value), place(expr->call->instance), this->expr(expr->call->interface);
            for (const tree::CallArgument& each : expr->call->arguments)
                number(each.local), this->expr(each.value), place(each.place);
        }
        statements(expr->statements), place(expr->ok);
    }
    void statements(const std::vector<tree::Stmt*>& list) {
        for (const tree::Stmt* each : list) {
            number(static_cast<uint64_t>(each->kind)), range(each->range), number(each->isHidden);
            place(each->place), place(each->target), expr(each->a), expr(each->b), expr(each->c);
            statements(each->body), statements(each->elseBody);
            for (const tree::CaseArm& arm : each->arms) statements(arm.body);
        }
        text += "; ";
    }

private:
    const types::TypeTable& m_types;
};

/// All that a check gives, as text.
std::string contentsOf(const driver::Checked& checked) {
    const auto analysis = sema::withTreesInPlace(checked.analysis);
    std::string out;
    for (const diagnostics::Diagnostic& each : analysis->diagnostics) {
        out += diagnostics::renderText(*checked.sources, each, false) + "\n";
        out += diagnostics::renderJson(*checked.sources, each) + "\n";
        for (const diagnostics::Related& related : each.related)
            out += "  also " + std::to_string(related.range.begin) + "\n";
    }
    for (const sema::Symbol& each : analysis->symbols)
        out += each.owner + "." + each.name + " at " + std::to_string(each.declaration.begin) + "\n";
    for (const sema::Reference& each : analysis->references)
        out += std::to_string(each.range.file.index()) + ":" + std::to_string(each.range.begin) + "-" +
               std::to_string(each.range.end) + " " + analysis->symbols[each.symbol.index()].name +
               (each.isRead ? " read" : "") + (each.isWrite ? " written" : "") + "\n";
    for (const tree::Function& function : analysis->program->functions) {
        Writing writing(*analysis->program->types);
        for (const tree::Local& local : function.locals)
            writing.text += local.name + " ", writing.type(local.type), writing.number(local.isAddressTaken),
                writing.range(local.declaration), writing.expr(local.initial);
        writing.number(function.labelCount);
        writing.number(function.mayRecurse);
        writing.statements(function.body);
        out += function.name + ": " + writing.text + "\n";
    }
    return out;
}

/// Blocks, methods, actions, constants, texts, labels, enumerations, references, initialisers that need code, a chart.
driver::BuildInput someProject() {
    driver::BuildInput input;
    input.libraries = {"util"};
    input.files = {{"src/types.st",
                    R"(TYPE Mode : (Off, Slow, Fast); Pair : STRUCT a : INT := 3; b : REF_TO INT; END_STRUCT; END_TYPE
VAR_GLOBAL gTotal : DINT; gName : STRING(20) := 'x'; gList : ARRAY[1..3] OF Pair; END_VAR
VAR_GLOBAL CONSTANT cLimit : INT := 2 * cHalf; cHalf : INT := 5; END_VAR
)"},
                   {"src/blocks.st", R"(FUNCTION_BLOCK Motor
VAR_INPUT start : BOOL R_EDGE; speed : INT; END_VAR
VAR_OUTPUT run : BOOL; END_VAR
VAR t : TON; mode : Mode; p : Pair; END_VAR
METHOD Reach : INT
VAR_INPUT far : INT; END_VAR
VAR own : Pair; END_VAR
IF far > cLimit THEN JMP done; END_IF
own.a := far;
done: Reach := own.a + speed;
END_METHOD
ACTION Stop
run := FALSE;
gName := 'stopped';
END_ACTION
t(IN := start, PT := T#1s);
run := t.Q AND speed < cLimit;
CASE mode OF Off: Stop(); Slow, Fast: gTotal := gTotal + 1; END_CASE
END_FUNCTION_BLOCK
FUNCTION_BLOCK Large EXTENDS Motor
VAR e : BOOL F_EDGE; END_VAR
SUPER^();
IF Reach(far := 3) = speed THEN gName := CONCAT(gName, 'abcdefg'); END_IF
END_FUNCTION_BLOCK
)"},
                   {"src/main.st", R"(FUNCTION Scale : INT
VAR_INPUT x : INT; END_VAR
VAR n : INT := cHalf; END_VAR
// a comment before the body
Scale := n * x;
END_FUNCTION
PROGRAM Main
VAR m : Large; i : INT; w : WORD; unused : BOOL; END_VAR
again:
m(start := w.3, speed := Scale(x := i));
FOR i := 1 TO cLimit DO w := w OR 16#10; END_FOR
IF i > 100 THEN JMP again; END_IF
END_PROGRAM
PROGRAM Chart
VAR a : BOOL; END_VAR
INITIAL_STEP S0: END_STEP
TRANSITION FROM S0 TO S1 := a; END_TRANSITION
STEP S1: A1(N); END_STEP
TRANSITION FROM S1 TO S0 := NOT a; END_TRANSITION
ACTION A1 a := gTotal > 5; END_ACTION
END_PROGRAM
)"}};
    return input;
}

TEST(KeptBodies, AKeystrokeChecksTheBodyItIsIn) {
    driver::BuildInput input = someProject();
    driver::KeptFiles kept;
    (void)driver::check(input, kept);
    const size_t all = kept.checkedLast();
    EXPECT_GT(all, 10u);
    (void)driver::check(input, kept);
    const size_t always = kept.checkedLast(); // those that complete what others share
    EXPECT_LT(always, 4u);
    std::string& text = input.files[2].text;
    text.insert(text.find("n * x;") + 6, "  ");
    ASSERT_EQ(contentsOf(driver::check(input, kept)), contentsOf(driver::check(input)));
    EXPECT_EQ(kept.checkedLast(), always + 1);
    text.insert(text.find("16#10"), "1 + ");
    ASSERT_EQ(contentsOf(driver::check(input, kept)), contentsOf(driver::check(input)));
    EXPECT_EQ(kept.checkedLast(), always + 1);
}

TEST(KeptBodies, AChangedDeclarationChecksEverything) {
    driver::BuildInput input = someProject();
    driver::KeptFiles kept;
    (void)driver::check(input, kept);
    const size_t all = kept.checkedLast();
    std::string& text = input.files[0].text;
    text.replace(text.find("cHalf : INT := 5"), 16, "cHalf : DINT := 70000");
    ASSERT_EQ(contentsOf(driver::check(input, kept)), contentsOf(driver::check(input)));
    EXPECT_EQ(kept.checkedLast(), all);
}

TEST(KeptBodies, WhatABodySaysAboutDeclarationsCounts) {
    driver::BuildInput input = someProject();
    driver::KeptFiles kept;
    (void)driver::check(input, kept);
    std::string& text = input.files[2].text;
    for (const char* each : {"ENO := FALSE;", "%MW900 := 1;", "gName := 'a text of a length that nothing had';",
                             "goto1: JMP goto1;", "IF x > (* ", "END_FUNCTION FUNCTION Other : INT Other := 1;"}) {
        SCOPED_TRACE(each);
        const size_t at = text.find("Scale := n");
        text.insert(at, each);
        ASSERT_EQ(contentsOf(driver::check(input, kept)), contentsOf(driver::check(input)));
        text.erase(at, std::string_view(each).size());
        ASSERT_EQ(contentsOf(driver::check(input, kept)), contentsOf(driver::check(input)));
    }
}

TEST(KeptBodies, ABodyThatIsEmptiedKeepsNothing) {
    for (const std::string frame :
         {"PROGRAM P\nVAR n : INT; END_VAR\n@\nEND_PROGRAM\n",
          "PROGRAM P\nVAR n : INT; END_VAR\nn := 1;\nEND_PROGRAM\nACTION A: @ END_ACTION\n",
          "PROGRAM P\nVAR n : INT; END_VAR\nn := 1;\nACTION A:\n@\nEND_ACTION\nEND_PROGRAM\n",
          "FUNCTION F : INT\nVAR n : INT; END_VAR\n@\nEND_FUNCTION\n",
          "FUNCTION_BLOCK B\nVAR n : INT; END_VAR\nMETHOD M\n@\nEND_METHOD\nEND_FUNCTION_BLOCK\n",
          "FUNCTION_BLOCK B\nVAR n : INT; END_VAR\nPROPERTY Q : INT\nGET\n@\nEND_GET\n"
          "END_PROPERTY\nEND_FUNCTION_BLOCK\n"}) {
        driver::KeptFiles kept;
        for (const char* body : {"n := missing;", "", "n := 2;", " ", "(* nothing *)", "n := n + missing;"}) {
            std::string text = frame;
            text.replace(text.find('@'), 1, body);
            SCOPED_TRACE(text);
            driver::BuildInput input;
            input.files = {{"src/a.st", text}};
            EXPECT_EQ(contentsOf(driver::check(input, kept)), contentsOf(driver::check(input)));
        }
    }
}

TEST(KeptBodies, ASectionBehindAWrongWordOrAStatementIsADeclaration) {
    for (const std::string between : {",", "io := 1;"}) {
        driver::KeptFiles kept;
        for (const char* name : {"out", "in", "out", "other"}) {
            driver::BuildInput input;
            input.files = {{"src/a.st", "PROGRAM Main\nVAR got : INT; END_VAR\ngot := Worker.out;\nEND_PROGRAM\n"
                                        "PROGRAM Worker\nVAR_INPUT in : INT; END_VAR\nVAR io : INT; END_VAR " +
                                            between + "\nVAR_OUTPUT\n    " + name +
                                            " : INT;\nEND_VAR\nVAR x : INT; END_VAR\nio := in;\nEND_PROGRAM\n"}};
            SCOPED_TRACE(input.files[0].text);
            EXPECT_EQ(contentsOf(driver::check(input, kept)), contentsOf(driver::check(input)));
        }
    }
}

TEST(KeptBodies, WhatIsBuiltFromAKeptCheckIsWhatIsBuiltFromTheText) {
    driver::BuildInput input = someProject();
    driver::KeptFiles kept;
    (void)driver::check(input, kept);
    std::string& text = input.files[2].text;
    text.insert(text.find("Scale := n"), "\n\n  n := n + 1;\n");
    const driver::Checked checked = driver::check(input, kept);
    const driver::Built a = driver::build(checked, input), b = driver::build(input);
    ASSERT_TRUE(b.program) << b.failure.english();
    ASSERT_TRUE(a.program) << a.failure.english();
    EXPECT_EQ(a.program->initialImage, b.program->initialImage);
    ASSERT_EQ(a.program->sites.size(), b.program->sites.size());
    for (size_t i = 0; i < a.program->sites.size(); ++i)
        EXPECT_EQ(a.program->sites[i].range, b.program->sites[i].range);
    EXPECT_FALSE(checked.analysis->program->types->referenceText) << "what was checked stays as it was";
}

/// One edit: letters, words, whole lines, what declares and what does not.
void edit(driver::BuildInput& input, std::mt19937& random, int step) {
    static const char* const kPieces[] = {" ",
                                          ";",
                                          "(",
                                          "x",
                                          "1",
                                          ":",
                                          "\n",
                                          "(*",
                                          "*)",
                                          "//",
                                          "'",
                                          "{",
                                          "cLimit",
                                          "gTotal",
                                          "i := 1;",
                                          "Mode#Fast",
                                          "mode",
                                          "END_IF",
                                          "IF i > 1 THEN i := 2; END_IF\n",
                                          "gName := 'ab';",
                                          "gName := 'abcdefghijk';",
                                          "here: ",
                                          "JMP here;",
                                          "ENO := TRUE;",
                                          "%IW4",
                                          "unknownName := 3;",
                                          "Scale(x := 1)",
                                          "m.run",
                                          "TON",
                                          "THIS^.speed := 1;",
                                          "END_METHOD",
                                          "END_PROGRAM",
                                          "END_FUNCTION\nFUNCTION F2 : INT\nF2 := 1;\n",
                                          "VAR k : INT; END_VAR",
                                          "METHOD N : BOOL N := TRUE; END_METHOD\n",
                                          "STEP S9: END_STEP\n",
                                          "LD 1\n"};
    static const std::pair<const char*, const char*> kRenames[] = {
        {"cHalf", "cHalves"}, {"speed", "velocity"}, {"Slow", "Medium"}, {"INT", "DINT"},
        {"Scale", "Scaled"},  {"Pair", "Couple"},    {"5", "7"},         {"3", "4"},
        {"Reach", "Stretch"}};
    const size_t file = random() % input.files.size();
    std::string& text = input.files[file].text;
    const size_t at = random() % (text.size() + 1);
    switch (random() % 12) {
    case 0: // everywhere or once
        for (auto [from, to] : {kRenames[random() % std::size(kRenames)]}) {
            const bool isEverywhere = random() % 2;
            for (driver::SourceFile& each : input.files)
                for (size_t found = each.text.find(from); found != std::string::npos;
                     found = each.text.find(from, found + std::string_view(to).size())) {
                    each.text.replace(found, std::string_view(from).size(), to);
                    if (!isEverywhere) return;
                }
        }
        return;
    case 1:
        if (input.files.size() > 2 && random() % 4 == 0)
            input.files.erase(input.files.begin() + static_cast<long>(file));
        else
            input.files.push_back({"src/new" + std::to_string(step) + ".st", "FUNCTION New" + std::to_string(step) +
                                                                                 " : INT\nNew" + std::to_string(step) +
                                                                                 " := cLimit;\nEND_FUNCTION\n"});
        return;
    case 2: // a line goes
        if (const size_t begin = text.rfind('\n', at); begin != std::string::npos)
            text.erase(begin, text.find('\n', begin + 1) - begin);
        return;
    case 3:
    case 4:
        if (at < text.size()) text.erase(at, 1 + random() % 3);
        return;
    default:
        text.insert(at, kPieces[random() % std::size(kPieces)]);
    }
}

/// From the whole project again and again, because edits at random places soon leave nothing whole.
TEST(KeptBodies, RandomEditsFindWhatAFullCheckFinds) {
    size_t kept = 0, all = 0;
    const uint32_t last = std::getenv("STEPWISE_LONG") ? 100 : 6;
    for (uint32_t seed = 1; seed <= last; ++seed) {
        std::mt19937 random(seed);
        driver::BuildInput input = someProject();
        driver::KeptFiles files;
        (void)driver::check(input, files);
        const size_t most = files.checkedLast();
        for (int step = 0; step < 12; ++step) {
            SCOPED_TRACE("step " + std::to_string(step) + " of seed " + std::to_string(seed));
            const driver::BuildInput before = input;
            edit(input, random, step);
            const driver::Checked checked = driver::check(input, files);
            ASSERT_EQ(contentsOf(checked), contentsOf(driver::check(input)));
            kept += files.checkedLast() < most / 2;
            ++all;
            if (random() % 3 == 0) input = before; // undone
        }
    }
    EXPECT_GT(kept, all / 10) << "otherwise this tests nothing";
}

} // namespace
