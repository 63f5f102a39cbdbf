// What a diagram becomes does what the text does that other tools generate of the same diagram: both run side by side
// for 1,000 scans with inputs that change at random, and every output is the same in each of them.
#include "drawn.h"
#include "fixture.h"

#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <random>

namespace plc::exchange {
namespace {

struct Row {
    const char* name;
    const char* language;
    std::string elements;
    const char* locals; // of the text: what the generator declares
    const char* text;   // as a generator writes it: one variable for each wire
};

const std::string kParallel =
    "<connectionPointIn><connection refLocalId=\"2\"/><connection refLocalId=\"3\"/></connectionPointIn>";

/// A chart's elements: what they follow, and what a step does.
std::string after(std::initializer_list<const char*> ids) {
    std::string out;
    for (const char* id : ids)
        out += "<connectionPointIn><connection refLocalId=\"" + std::string(id) + "\"/></connectionPointIn>";
    return out;
}
std::string step(const char* id, const char* name, const char* from, const char* more = "") {
    return "<step localId=\"" + std::string(id) + "\" name=\"" + name + "\" " + more + ">" + at(0) +
           (*from ? after({from}) : "") + "<connectionPointOut formalParameter=\"\"/></step>";
}
std::string transition(const char* id, const char* condition, const char* from) {
    return "<transition localId=\"" + std::string(id) + "\">" + at(0) + after({from}) +
           "<condition><inline name=\"\"><ST><xhtml>" + condition + "</xhtml></ST></inline></condition></transition>";
}
std::string bar(const char* kind, const char* id, std::initializer_list<const char*> from) {
    return "<" + std::string(kind) + " localId=\"" + id + "\">" + at(0) + after(from) +
           "<connectionPointOut formalParameter=\"\"/></" + kind + ">";
}
std::string jump(const char* id, const char* target, const char* from) {
    return "<jumpStep localId=\"" + std::string(id) + "\" targetName=\"" + target + "\">" + at(0) + after({from}) +
           "</jumpStep>";
}
std::string action(const char* id, const char* from, const char* qualifier, const std::string& what) {
    return "<actionBlock localId=\"" + std::string(id) + "\">" + at(0) + after({from}) + "<action localId=\"" + id +
           "1\" qualifier=\"" + qualifier + "\">" + what + "</action></actionBlock>";
}
std::string named(const std::string& name) { return "<reference name=\"" + name + "\"/>"; }
std::string written(const std::string& text) { return "<inline><ST><xhtml>" + text + "</xhtml></ST></inline>"; }

std::vector<Row> rows() {
    return {
        {"SealIn", "LD",
         kRail + contact("2", "a", "1") + contact("3", "p", "1") + "<contact localId=\"4\" negated=\"true\">" + at(0) +
             kParallel + "<connectionPointOut/><variable>b</variable></contact>" + coil("5", "p", in("4"), 0) +
             coil("6", "q", in("4"), 20, "negated=\"true\""),
         "", "p := (p OR a) AND NOT(b); q := NOT((p OR a) AND NOT(b));"},
        {"SetAndReset", "LD",
         kRail + contact("2", "a", "1", "edge=\"rising\"") + contact("3", "b", "1", "edge=\"falling\"") +
             coil("4", "p", in("2"), 0, "storage=\"set\"") + coil("5", "p", in("3"), 20, "storage=\"reset\"") +
             contact("6", "p", "1") + coil("7", "q", in("6"), 40),
         "r : R_TRIG; f : F_TRIG;",
         "r(CLK := a); IF r.Q THEN p := TRUE; END_IF; f(CLK := b); IF f.Q THEN p := FALSE; END_IF; q := p;"},
        {"TimerAndCounter", "FBD",
         value("1", "a") + value("2", "T#30ms") + value("3", "b") + value("4", "3") +
             block("5", "TON", "t", input("IN", in("1"), "negated=\"true\"") + input("PT", in("2")), {"Q", "ET"}, 10) +
             block("6", "CTU", "c", input("CU", in("5", "Q")) + input("R", in("3")) + input("PV", in("4")), {"Q", "CV"},
                   20) +
             target("7", "p", in("6", "Q"), 30) + target("8", "x", in("6", "CV"), 40),
         "t : TON; c : CTU;", "t(IN := NOT(a), PT := T#30ms); c(CU := t.Q, R := b, PV := 3); p := c.Q; x := c.CV;"},
        {"EnableAndOrder", "FBD",
         value("1", "a") + value("2", "m") + value("3", "n") +
             block("4", "ADD", "", input("EN", in("1")) + input("IN1", in("2")) + input("IN2", in("3")), {"ENO", "OUT"},
                   10) +
             target("5", "x", in("4", "OUT"), 20) + target("6", "p", in("4", "ENO"), 30) +
             block("7", "GT", "", input("IN1", in("2")) + input("IN2", in("3")), {"OUT"}, 40) +
             target("8", "q", in("7", "OUT"), 50),
         "", "IF a THEN x := m + n; END_IF; p := a; q := m > n;"},
        {"FeedbackThroughABlock", "FBD",
         value("1", "a") + value("2", "b") +
             block("3", "XOR", "", input("IN1", in("1")) + input("IN2", in("4", "Q1")), {"OUT"}, 10) +
             block("4", "SR", "s", input("S1", in("3", "OUT")) + input("R", in("2")), {"Q1"}, 20) +
             target("5", "p", in("4", "Q1"), 30),
         "s : SR;", "s(S1 := a XOR s.Q1, R := b); p := s.Q1;"},
        {"JumpOverANetwork", "FBD",
         value("1", "a") + "<jump localId=\"2\" label=\"over\">" + at(10) + in("1") + "</jump>" + value("3", "m") +
             target("4", "x", in("3"), 20) + "<label localId=\"5\" label=\"over\">" + at(30) + "</label>" +
             value("6", "n") + target("7", "y", in("6"), 40),
         "", "IF NOT a THEN x := m; END_IF; y := n;"},
        {"FunctionChart", "CFC",
         "<inVariable localId=\"1\"><expression>m</expression></inVariable><inVariable localId=\"2\"><expression>n"
         "</expression></inVariable><inVariable localId=\"3\"><expression>a</expression></inVariable>" +
             block("4", "SEL", "", input("G", in("3")) + input("IN0", in("1")) + input("IN1", in("2")), {"OUT"}, 10) +
             target("5", "x", in("4", "OUT"), 20) +
             block("6", "LE", "", input("IN1", in("4", "OUT")) + input("IN2", in("2")), {"OUT"}, 30) +
             target("7", "q", in("6", "OUT"), 40),
         "r : INT;", "r := SEL(a, m, n); x := r; q := r <= n;"},
        {"AlternativeSteps", "SFC",
         step("1", "Init", "", "initialStep=\"true\"") + action("20", "1", "R", named("q")) +
             bar("selectionDivergence", "2", {"1"}) + transition("3", "a", "2") + step("4", "L", "3") +
             action("21", "4", "N", named("p")) + action("22", "4", "S", named("q")) + transition("5", "b", "2") +
             step("6", "R", "5") + action("23", "6", "P1", written("x := x + m;")) + transition("7", "NOT a", "4") +
             transition("8", "NOT b", "6") + bar("selectionConvergence", "9", {"7", "8"}) + jump("10", "Init", "9"),
         "s, old : INT; begun : BOOL;",
         "IF begun THEN CASE s OF 0: IF a THEN s := 1; ELSIF b THEN s := 2; END_IF; 1: IF NOT a THEN s := 0; END_IF; "
         "2: IF NOT b THEN s := 0; END_IF; END_CASE; END_IF; begun := TRUE; p := s = 1; q := (q OR s = 1) AND s <> 0; "
         "IF s = 2 AND old <> 2 THEN x := x + m; END_IF; old := s;"},
        {"ParallelSteps", "SFC",
         step("1", "Init", "", "initialStep=\"true\"") + transition("2", "a AND m > 0", "1") +
             bar("simultaneousDivergence", "3", {"2"}) + step("4", "L", "3") + action("20", "4", "N", named("p")) +
             step("5", "R", "3") + transition("6", "n > 0", "5") + step("7", "Later", "6") +
             action("21", "7", "N", named("q")) + bar("simultaneousConvergence", "8", {"4", "7"}) +
             transition("9", "b", "8") + jump("10", "Init", "9"),
         "s : INT; begun : BOOL;",
         "IF begun THEN CASE s OF 0: IF a AND m > 0 THEN s := 1; END_IF; 1: IF n > 0 THEN s := 2; END_IF; 2: IF b THEN "
         "s := 0; "
         "END_IF; END_CASE; END_IF; begun := TRUE; p := s > 0; q := s = 2;"},
    };
}

class Results : public ExchangeTest, public ::testing::WithParamInterface<size_t> {};

TEST_P(Results, OfADiagramAndOfItsGeneratedTextAreEqual) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    const Row row = rows()[GetParam()];
    const std::string outputs = bools({"p", "q"}) + "<localVars>" + variable("x", "<INT/>") + variable("y", "<INT/>") +
                                variable("t", "<derived name=\"TON\"/>") + variable("c", "<derived name=\"CTU\"/>") +
                                variable("s", "<derived name=\"SR\"/>") + "</localVars>";
    const std::string inputs = "<globalVars name=\"Inputs\">" + variable("a", "<BOOL/>") + variable("b", "<BOOL/>") +
                               variable("m", "<INT/>") + variable("n", "<INT/>") + "</globalVars>";
    const std::string resource =
        "<configurations><configuration name=\"C\"><resource name=\"R\"><task name=\"T\" interval=\"PT0.01S\" "
        "priority=\"1\"><pouInstance name=\"Drawn1\" typeName=\"Drawn\"/></task>" +
        inputs + "</resource></configuration></configurations>";
    const std::string language = row.language;
    std::string body = "<" + language + ">" + row.elements + "</" + language + ">";
    if (language == "CFC")
        body =
            st("") + "<addData><data name=\"http://www.3s-software.com/plcopenxml/cfc\">" + body + "</data></addData>";
    Imported imported = import(document(pou("Drawn", "program", outputs, body), {}, resource));
    EXPECT_EQ(imported.report.losses(), 0u);
    imported.files.push_back({"src/Written.st", std::string("PROGRAM Written\nVAR p, q : BOOL; x, y : INT; ") +
                                                    row.locals + " END_VAR\n" + row.text + "\nEND_PROGRAM\n"});
    for (ImportedFile& file : imported.files) // in the same task
        if (const size_t end = file.text.find("END_RESOURCE"); end != std::string::npos)
            file.text.insert(end, "PROGRAM Written1 WITH T : Written;\n");
    const driver::Built built = driver::build(toProject(imported).buildInput());
    ASSERT_TRUE(built.program) << errorsOf(imported);
    controller::Controller controller(built.program);
    controller.start();
    std::mt19937 random(static_cast<uint32_t>(GetParam()) + 1);
    int changes = 0;
    std::string before;
    for (int scan = 0; scan < 1000; ++scan) {
        for (const char* name : {"a", "b"}) {
            if (random() % 4 == 0) {
                ASSERT_TRUE(controller.write(
                    name, {types::TypeTable::of(types::TypeKind::Bool), static_cast<int64_t>(random() % 2)}));
            }
        }
        for (const char* name : {"m", "n"})
            ASSERT_TRUE(controller.write(
                name, {types::TypeTable::of(types::TypeKind::Int), static_cast<int64_t>(random() % 2000) - 1000}));
        ASSERT_TRUE(controller.scan());
        std::string values;
        for (const char* name : {"p", "q", "x", "y"}) {
            const auto drawn = controller.read("Drawn1." + std::string(name));
            const auto written = controller.read("Written1." + std::string(name));
            ASSERT_TRUE(drawn && written);
            ASSERT_EQ(drawn->integer(), written->integer()) << row.name << "." << name << " in scan " << scan;
            values += std::to_string(drawn->integer()) + " ";
        }
        changes += values != before;
        before = values;
    }
    EXPECT_GT(changes, 20) << "the inputs did not reach the outputs";
}

INSTANTIATE_TEST_SUITE_P(All, Results, ::testing::Range<size_t>(0, rows().size()),
                         [](const auto& info) { return std::string(rows()[info.param].name); });

} // namespace
} // namespace plc::exchange
