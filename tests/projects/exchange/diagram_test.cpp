// LD and FBD in: each picture of the table of docs/ladder.md gives its statement, in the order of execution, and values
// that are written in between are stored.
#include "drawn.h"
#include "fixture.h"

#include "projects/session/session.h"

namespace plc::exchange {
namespace {

class DiagramImport : public ExchangeTest {
protected:
    /// The body of the program Main that a diagram becomes, and checks that it has no errors.
    std::string body(const std::string& language, const std::string& elements, const std::string& interface,
                     const std::string& more = {}) {
        imported = import(document(
            pou("Main", "program", interface, "<" + language + ">" + elements + "</" + language + ">") + more));
        EXPECT_EQ(errorsOf(imported), "");
        std::string text = fileOf(imported, "src/Main.st");
        const size_t end = text.rfind("END_VAR\n");
        return text.substr(end + 8, text.rfind("END_PROGRAM") - end - 8);
    }
    Imported imported;
};

TEST_F(DiagramImport, SeriesIsAndParallelIsOr) {
    const std::string rung =
        kRail + contact("2", "a", "1") + contact("3", "b", "1", "negated=\"true\"") + "<contact localId=\"4\">" +
        at(0) +
        "<connectionPointIn><connection refLocalId=\"2\"/><connection refLocalId=\"3\"/></connectionPointIn>"
        "<connectionPointOut/><variable>c</variable></contact>" +
        coil("5", "y", in("4"), 0);
    EXPECT_EQ(body("LD", rung, bools({"a", "b", "c", "y"})), "y := (a OR NOT b) AND c;\n");
    EXPECT_NE(fileOf(imported, "src/Main.st").find("{attribute 'view' := 'ladder'}\nPROGRAM Main"), std::string::npos);
}

TEST_F(DiagramImport, CoilsNegateSetAndReset) {
    const std::string rungs = kRail + contact("2", "a", "1") + coil("3", "p", in("2"), 0, "negated=\"true\"") +
                              coil("4", "q", in("2"), 20, "storage=\"set\"") +
                              coil("5", "r", in("2"), 40, "storage=\"reset\"");
    EXPECT_EQ(body("LD", rungs, bools({"a", "p", "q", "r"})), "p := NOT a;\nq S= a;\nr R= a;\n");
}

TEST_F(DiagramImport, AnEdgeContactIsATriggerThatIsDeclared) {
    const std::string rung =
        kRail + contact("2", "a", "1") + contact("3", "b", "2", "edge=\"rising\"") + coil("4", "y", in("3"), 0);
    EXPECT_EQ(body("LD", rung, bools({"a", "b", "y"})), "edge_3(CLK := b);\ny := a AND edge_3.Q;\n");
    EXPECT_NE(fileOf(imported, "src/Main.st").find("    edge_3 : R_TRIG;\n"), std::string::npos);
}

TEST_F(DiagramImport, ABeginningThatAllBranchesShareIsWrittenOnce) {
    std::string rung = kRail + contact("100", "a", "1") + contact("101", "b", "1"); // forty stages of two contacts each
    std::string last = "<connection refLocalId=\"100\"/><connection refLocalId=\"101\"/>";
    for (int stage = 1; stage <= 40; ++stage) {
        const std::string id = std::to_string(100 + 2 * stage), other = std::to_string(101 + 2 * stage);
        for (const auto& [contactId, name] : {std::pair(id, "a"), std::pair(other, "b")})
            rung += "<contact localId=\"" + contactId + "\">" + at(0) + "<connectionPointIn>" + last +
                    "</connectionPointIn><connectionPointOut/><variable>" + name + "</variable></contact>";
        last = "<connection refLocalId=\"" + id + "\"/><connection refLocalId=\"" + other + "\"/>";
    }
    rung += coil("5", "y", "<connectionPointIn>" + last + "</connectionPointIn>", 0);
    const std::string text = body("LD", rung, bools({"a", "b", "y"}));
    EXPECT_LT(text.size(), 1000u);
    EXPECT_TRUE(text.starts_with("y := (a OR b) AND (a OR b)")) << text;
}

TEST_F(DiagramImport, AFlowWhoseOperandWasWrittenIsStored) {
    // -| a |-+-( a negated )
    //        +-( y )            y follows a as it was before the first coil
    const std::string rung =
        kRail + contact("2", "a", "1") + coil("3", "a", in("2"), 0, "negated=\"true\"") + coil("4", "y", in("2"), 20);
    EXPECT_EQ(body("LD", rung, bools({"a", "y"})), "flow_2 := a;\na := NOT a;\ny := flow_2;\n");
}

TEST_F(DiagramImport, ABlockIsCalledBeforeItsOutputsAreRead) {
    const std::string rung = kRail + contact("2", "a", "1") + value("3", "T#1s") +
                             block("4", "TON", "t", input("IN", in("2")) + input("PT", in("3")), {"Q", "ET"}) +
                             coil("5", "y", in("4", "Q"), 0);
    const std::string interface = "<localVars>" + variable("a", "<BOOL/>") + variable("y", "<BOOL/>") +
                                  variable("t", "<derived name=\"TON\"/>") + "</localVars>";
    EXPECT_EQ(body("LD", rung, interface), "t(IN := a, PT := T#1s);\ny := t.Q;\n");
}

TEST_F(DiagramImport, ABoxWithEnableIsAnIf) {
    const std::string rung =
        kRail + contact("2", "a", "1") + value("3", "n") + value("4", "1") +
        block("5", "ADD", "", input("EN", in("2")) + input("IN1", in("3")) + input("IN2", in("4")), {"ENO", "OUT"}) +
        target("6", "n", in("5", "OUT")) + coil("7", "y", in("5", "ENO"), 200);
    const std::string interface =
        "<localVars>" + variable("a", "<BOOL/>") + variable("y", "<BOOL/>") + variable("n", "<INT/>") + "</localVars>";
    EXPECT_EQ(body("LD", rung, interface), "IF a THEN\n    n := n + 1;\nEND_IF;\ny := a;\n");
}

TEST_F(DiagramImport, AnEnabledResultThatIsReadTwiceKeepsItsLastValue) {
    const std::string network =
        value("1", "a") + value("2", "n") + value("3", "2") +
        block("4", "MUL", "", input("EN", in("1")) + input("IN1", in("2")) + input("IN2", in("3")), {"ENO", "OUT"}) +
        target("5", "x", in("4", "OUT"), 10) + target("6", "y", in("4", "OUT"), 30);
    const std::string interface = "<localVars>" + variable("a", "<BOOL/>") + variable("n", "<INT/>") +
                                  variable("x", "<INT/>") + variable("y", "<INT/>") + "</localVars>";
    EXPECT_EQ(body("FBD", network, interface),
              "IF a THEN\n    result_4 := n * 2;\nEND_IF;\nx := result_4;\ny := result_4;\n");
}

TEST_F(DiagramImport, ExpressionsKeepTheirGrouping) {
    const std::string network =
        value("1", "a") + value("2", "b") + value("3", "c + 1") +
        block("4", "ADD", "", input("IN1", in("1")) + input("IN2", in("2")), {"OUT"}) +
        block("5", "MUL", "", input("IN1", in("4", "OUT")) + input("IN2", in("3")), {"OUT"}) +
        block("6", "SUB", "", input("IN1", in("1")) + input("IN2", in("5", "OUT")), {"OUT"}) +
        block("7", "LIMIT", "", input("MN", in("1")) + input("IN", in("6", "OUT")) + input("MX", in("2")), {"OUT"}) +
        target("8", "d", in("7", "OUT"));
    const std::string interface = "<localVars>" + variable("a", "<INT/>") + variable("b", "<INT/>") +
                                  variable("c", "<INT/>") + variable("d", "<INT/>") + "</localVars>";
    EXPECT_EQ(body("FBD", network, interface), "d := LIMIT(a, a - (a + b) * (c + 1), b);\n");
}

TEST_F(DiagramImport, NegatedPinsAndOwnFunctionsAreCalledByName) {
    const std::string own = pou("Half", "function",
                                "<returnType><INT/></returnType><inputVars>" + variable("x", "<INT/>") +
                                    variable("up", "<BOOL/>") + "</inputVars>",
                                st("Half := x / 2;"));
    const std::string network =
        value("1", "n") + value("2", "a") +
        block("3", "Half", "", input("x", in("1")) + input("up", in("2"), "negated=\"true\""), {"Half"}) +
        target("4", "n", in("3", "Half"));
    const std::string interface = "<localVars>" + variable("a", "<BOOL/>") + variable("n", "<INT/>") + "</localVars>";
    EXPECT_EQ(body("FBD", network, interface, own), "n := Half(x := n, up := NOT a);\n");
}

TEST_F(DiagramImport, FeedbackReadsTheValueOfTheLastCall) {
    // the counter's output resets it
    const std::string network =
        value("1", "a") + value("2", "3") +
        block("3", "CTU", "c", input("CU", in("1")) + input("R", in("3", "Q")) + input("PV", in("2")), {"Q", "CV"}) +
        target("4", "y", in("3", "Q"));
    const std::string interface = "<localVars>" + variable("a", "<BOOL/>") + variable("y", "<BOOL/>") +
                                  variable("c", "<derived name=\"CTU\"/>") + "</localVars>";
    EXPECT_EQ(body("FBD", network, interface), "c(CU := a, R := c.Q, PV := 3);\ny := c.Q;\n");
}

TEST_F(DiagramImport, ConnectorsCarryTheirValue) {
    const std::string network = value("1", "a") + "<connector localId=\"2\" name=\"wire\">" + at(0) + in("1") +
                                "</connector><continuation localId=\"3\" name=\"wire\">" + at(0) +
                                "<connectionPointOut/></continuation>" + target("4", "y", in("3"));
    EXPECT_EQ(body("FBD", network, bools({"a", "y"})), "y := a;\n");
}

TEST_F(DiagramImport, JumpsLabelsAndReturnsAreStatements) {
    const std::string rungs = kRail + contact("2", "a", "1") + "<jump localId=\"3\" label=\"Over\">" + at(0) + in("2") +
                              "</jump>" + contact("4", "b", "1") + coil("5", "y", in("4"), 20) +
                              "<label localId=\"6\" label=\"Over\">" + at(40) + "</label>" + contact("7", "c", "1") +
                              "<return localId=\"8\">" + at(60) + in("7") + "</return>" + coil("9", "z", in("4"), 80);
    EXPECT_EQ(body("LD", rungs, bools({"a", "b", "c", "y", "z"})),
              "IF a THEN\n    JMP Over;\nEND_IF;\ny := b;\nOver:\nIF c THEN\n    RETURN;\nEND_IF;\nz := b;\n");
}

TEST_F(DiagramImport, TheNumbersOfTheFileDecideTheOrder) {
    const std::string network = value("1", "a") + value("2", "b") +
                                "<outVariable localId=\"3\" executionOrderId=\"2\">" + at(0) + in("1") +
                                "<expression>x</expression></outVariable>"
                                "<outVariable localId=\"4\" executionOrderId=\"1\">" +
                                at(50) + in("2") + "<expression>y</expression></outVariable>";
    EXPECT_EQ(body("FBD", network, bools({"a", "b", "x", "y"})), "y := b;\nx := a;\n");
}

TEST_F(DiagramImport, AnExecuteBoxIsItsText) {
    const std::string network =
        value("1", "a") + "<block localId=\"2\" typeName=\"EXECUTE\">" + at(0) + "<inputVariables>" +
        input("EN", in("1")) +
        "</inputVariables><inOutVariables/><outputVariables><variable "
        "formalParameter=\"ENO\"><connectionPointOut/></variable></outputVariables><addData>"
        "<data name=\"http://www.3s-software.com/plcopenxml/stcode\" handleUnknown=\"implementation\"><STCode "
        "xmlns=\"\">x := TRUE;\ny := a;</STCode></data></addData></block>";
    EXPECT_EQ(body("FBD", network, bools({"a", "x", "y"})), "IF a THEN\n    x := TRUE;\n    y := a;\nEND_IF;\n");
}

TEST_F(DiagramImport, CommentsStandAboveWhatFollows) {
    const std::string rung = kRail + "<comment localId=\"9\" height=\"1\" width=\"1\">" + at(0) +
                             "<content><xhtml>start it</xhtml></content></comment>" + contact("2", "a", "1") +
                             coil("3", "y", in("2"), 20);
    EXPECT_EQ(body("LD", rung, bools({"a", "y"})), "// start it\ny := a;\n");
}

TEST_F(DiagramImport, ALoopWithoutABlockHasALineInTheReport) {
    const std::string network = value("1", "a") +
                                block("2", "AND", "", input("IN1", in("1")) + input("IN2", in("3", "OUT")), {"OUT"}) +
                                block("3", "OR", "", input("IN1", in("2", "OUT")) + input("IN2", in("1")), {"OUT"}) +
                                target("4", "y", in("3", "OUT"));
    (void)body("FBD", network, bools({"a", "y"}));
    EXPECT_TRUE(std::any_of(imported.report.notes.begin(), imported.report.notes.end(), [](const Note& note) {
        return note.kind == NoteKind::DiagramLoop;
    })) << imported.report.toText();
}

TEST_F(DiagramImport, AnEnableThatDependsOnItsOwnBoxHasALineAndEnds) {
    const std::string network =
        block("2", "TON", "t", input("EN", in("2", "ENO")) + input("PT", in("1")), {"ENO", "Q"}) + value("1", "T#1s") +
        target("4", "y", in("2", "Q"));
    (void)body("FBD", network,
               "<localVars>" + variable("y", "<BOOL/>") + variable("t", "<derived name=\"TON\"/>") + "</localVars>");
    EXPECT_EQ(imported.report.losses(), 1u) << imported.report.toText();
}

TEST_F(DiagramImport, DamagedDiagramsEndWithALineOrNothingButNeverHang) {
    const std::string whole =
        document(pou("Main", "program", bools({"a", "y"}),
                     "<LD>" + kRail + contact("2", "a", "1") + coil("3", "y", in("2"), 0) + "</LD>"));
    for (size_t at = whole.find("<LD>"); at < whole.find("</LD>"); ++at) {
        std::string damaged = whole;
        damaged.erase(at, 7);
        const auto imported = importFrom(write("damaged.xml", damaged));
        EXPECT_TRUE(!imported || !imported->files.empty());
    }
}

} // namespace
} // namespace plc::exchange
