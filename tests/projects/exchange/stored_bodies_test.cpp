// SFC and CFC of TwinCAT: the archives of charts and of function charts become textual SFC and statements.
#include "fixture.h"

#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

namespace plc::exchange {
namespace {

std::string value(const std::string& name, const std::string& text) { return "<v n=\"" + name + "\">" + text + "</v>"; }
std::string text(const std::string& name, const std::string& text) { return value(name, "\"" + text + "\""); }

// ------------------------------------------------------------ charts

std::string attribute(const std::string& id, const std::string& content) {
    return "<o>" + value("AttributeId", "{" + id + "}") + "<o n=\"Value\" t=\"StringValue\">" + text("Value", content) +
           text("DefaultValue", "") + "</o></o>";
}
constexpr const char* kName = "38391c6d-6d4a-42f8-8ee7-9f45e5adafa8";
constexpr const char* kMain = "700a583f-b4d4-43e4-8c14-629c7cd3bec8";
constexpr const char* kEntry = "a6b08bd8-b696-47e3-9cbf-7408b61c9ff8";
constexpr const char* kExit = "a2621e18-7de3-4ea6-ae6d-89e9e0b7befd";
constexpr const char* kInitial = "6844a48e-46c2-4cc8-a185-a478f3b99cc0";
constexpr const char* kComment = "7d894980-aeea-405c-a0f6-e2b26429c58f";
constexpr const char* kParallel = "23bdaa98-72ec-41f7-817b-9dede5697086";
constexpr const char* kMinTime = "cacf1a68-236e-47c2-b7b1-1cf9199718cb";
/// A row of its own in the archive's table, which names it.
constexpr const char* kQualifier = "11111111-2222-3333-4444-555555555555";

std::string element(const std::string& type, const std::vector<std::pair<const char*, std::string>>& attributes,
                    const std::string& more = {}) {
    std::string out = "<o t=\"" + type + "\">" + more + "<l2 n=\"Attributes\" cet=\"SFCAttribute\">";
    for (const auto& [id, content] : attributes) out += attribute(id, content);
    return out + "</l2></o>";
}
std::string listOf(const std::string& elements, const char* common = "") {
    return "<o n=\"ElementList\" t=\"SFCElementList\"><l2 n=\"InnerList\"" +
           (*common ? " cet=\"" + std::string(common) + "\"" : std::string()) + ">" + elements + "</l2></o>";
}
std::string step(const std::string& name, std::vector<std::pair<const char*, std::string>> attributes = {},
                 const std::string& actions = {}) {
    attributes.insert(attributes.begin(), {kName, name});
    return element("SFCStep", attributes, "<n n=\"EmbeddedMainAction\"/>" + listOf(actions));
}
std::string transition(const std::string& condition) {
    return element("SFCTransition", {{kName, condition}}, "<n n=\"EmbeddedTransition\"/>");
}
std::string jump(const std::string& target) { return element("SFCJump", {{kName, target}}); }
std::string branch(const std::vector<std::string>& legs, bool isParallel) {
    std::string all;
    for (const std::string& leg : legs) all += "<o>" + listOf(leg) + "</o>";
    return element("SFCBranch", {{kParallel, isParallel ? "TRUE" : "FALSE"}}, listOf(all, "SFCSegment"));
}

// ------------------------------------------------------------ function charts

std::string number(const std::string& name, int n) { return value(name, std::to_string(n) + "L"); }
std::string pin(int id, const std::string& more = {}, bool isNegated = false) {
    return value("Negated", isNegated ? "true" : "false") + more + number("Id", id);
}
std::string input(int id, int out, const std::string& name) {
    return "<o t=\"CFCInputElement\"><o n=\"Output\" t=\"CFCOutputPin\">" + pin(out) +
           "</o><o n=\"Text\" t=\"CFCText\">" + text("Text", name) + "</o>" + number("Id", id) + "</o>";
}
std::string output(int id, int in, const std::string& name, const std::string& storage = "None",
                   bool isNegated = false) {
    return "<o t=\"CFCOutputElement\"><o n=\"Input\" t=\"CFCInputPinWithSetReset\">" +
           pin(in, value("SetReset", storage), isNegated) + "</o><o n=\"Text\" t=\"CFCText\">" + text("Text", name) +
           "</o>" + number("Id", id) + "</o>";
}
std::string pins(const char* name, const char* type, const std::vector<int>& ids) {
    std::string out = std::string("<o n=\"") + name + "\" t=\"CFCItemList\"><l2 n=\"InnerList\" cet=\"" + type + "\">";
    for (const int id : ids) out += "<o>" + pin(id) + "</o>";
    return out + "</l2></o>";
}
std::string box(int id, const char* kind, const std::vector<int>& in, const std::vector<int>& out,
                const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& each : texts) all += "<o>" + text("Text", each) + "</o>";
    return "<o t=\"CFCBoxElement\">" + pins("Inputs", "CFCInputPin", in) + pins("Outputs", "CFCOutputPin", out) +
           "<o n=\"Texts\" t=\"CFCItemList\"><l2 n=\"InnerList\" cet=\"CFCText\">" + all + "</l2></o>" +
           value("KindOfCall", kind) + value("EnEno", "false") + number("Id", id) + "</o>";
}
std::string line(int from, int to) {
    return "<o t=\"CFCConnection\">" + number("SourcePinId", from) + number("DestPinId", to) + "</o>";
}

std::string structureElement(const char* type, int id, const std::string& in, const std::string& out,
                             const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& each : texts) all += "<o>" + text("Text", each) + "</o>";
    return std::string("<o t=\"") + type + "\">" + in + out +
           "<o n=\"Texts\" t=\"CFCItemList\"><l2 n=\"InnerList\" cet=\"CFCText\">" + all + "</l2></o>" +
           number("Id", id) + "</o>";
}

class StoredBodies : public ExchangeTest {
protected:
    Imported importBody(const std::string& variables, const std::string& body, const std::string& members = {}) {
        auto imported = importFrom(
            write("MAIN.TcPOU",
                  "<?xml version=\"1.0\" encoding=\"utf-8\"?><TcPlcObject Version=\"1.1.0.1\"><POU Name=\"MAIN\">"
                  "<Declaration><![CDATA[PROGRAM MAIN\nVAR\n" +
                      variables + "END_VAR\n]]></Declaration><Implementation>" + body + "</Implementation>" + members +
                      "</POU></TcPlcObject>"));
        EXPECT_TRUE(imported) << imported.error().english();
        return imported ? std::move(*imported) : Imported();
    }
    Imported importChart(const std::string& variables, const std::string& elements, const std::string& members = {}) {
        return importBody(variables,
                          "<SFC><XmlArchive><Data><o xml:space=\"preserve\" t=\"SFCImplementationObject\">"
                          "<o n=\"Root\" t=\"SFCSegment\">" +
                              listOf(elements) +
                              "</o><d2 n=\"Attributes\" ckt=\"Guid\" cvt=\"SFCAttributeDescription\"><v>" + kQualifier +
                              "</v><o>" + text("Identifier", "Qualifier") + "</o></d2></o></Data></XmlArchive></SFC>",
                          members);
    }
    Imported importCfc(const std::string& variables, const std::string& elements) {
        return importBody(variables, "<CFC><XmlArchive><Data><o xml:space=\"preserve\" t=\"CFCImplementationObject\">"
                                     "<o n=\"Items\" t=\"CFCItemList\"><l2 n=\"InnerList\">" +
                                         elements + "</l2></o></o></Data></XmlArchive></CFC>");
    }
    static std::string action(const std::string& name, const std::string& statements) {
        return "<Action Name=\"" + name + "\"><Implementation><ST><![CDATA[" + statements +
               "]]></ST></Implementation></Action>";
    }
    static std::string bodyOf(const Imported& imported) {
        const std::string all = fileOf(imported, "src/MAIN.st");
        const size_t begin = all.rfind("END_VAR\n") + 8;
        return all.substr(begin, std::min(all.find("\nACTION "), all.rfind("END_PROGRAM")) - begin);
    }
    /// The values of a variable after each scan.
    static std::vector<int64_t> valuesOf(const Imported& imported, const std::string& name, int scans) {
        jit::setRuntimeSymbols(controller::runtimeSymbols());
        const driver::Built built = driver::build(toProject(imported).buildInput());
        if (!built.program) return {};
        controller::Controller controller(built.program);
        controller.start();
        std::vector<int64_t> out;
        for (int i = 0; i < scans; ++i) {
            EXPECT_TRUE(controller.scan());
            const auto value = controller.read(name);
            out.push_back(value ? value->integer() : -1);
        }
        return out;
    }
};

// A composer's inputs are the members of a structure, a selector's outputs read them.
TEST_F(StoredBodies, ComposersAndSelectorsOfAFunctionChartWorkOnAStructure) {
    const std::string onePin = "<o n=\"Output\" t=\"CFCOutputPin\">" + pin(23) + "</o>";
    const std::string input30 = "<o n=\"Input\" t=\"CFCInputPin\">" + pin(31) + "</o>";
    Imported imported =
        importCfc("a : INT := 7; b : INT := 35; p : Pair; x : INT; y : BOOL := TRUE;\n",
                  input(1, 11, "a") + input(2, 12, "b") +
                      structureElement("CFCComposerElement", 20, pins("Inputs", "CFCInputPin", {21, 22}), onePin,
                                       {"first", "second", "Pair"}) +
                      output(3, 13, "p") +
                      structureElement("CFCSelectorElement", 30, input30, pins("Outputs", "CFCOutputPin", {32, 33}),
                                       {"Pair", "first", "second"}) +
                      box(40, "Operator", {41, 42}, {43}, {"", "", "", "+"}) + output(4, 14, "x") +
                      box(50, "Operator", {51, 52}, {53}, {"", "", "", "="}) + output(5, 15, "y") + line(11, 21) +
                      line(12, 22) + line(23, 13) + line(23, 31) + line(32, 41) + line(33, 42) + line(32, 51) +
                      line(33, 52) + line(43, 14) + line(53, 15));
    imported.files.push_back({"src/Pair.st", "TYPE Pair :\nSTRUCT\n    first, second : INT;\nEND_STRUCT\nEND_TYPE\n"});
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(errorsOf(imported), "") << fileOf(imported, "src/MAIN.st");
    EXPECT_EQ(valuesOf(imported, "MAIN.p.second", 1), std::vector<int64_t>{35});
    EXPECT_EQ(valuesOf(imported, "MAIN.x", 1), std::vector<int64_t>{42});
    EXPECT_EQ(valuesOf(imported, "MAIN.y", 1), std::vector<int64_t>{0}); // 7 is not 35
}

// The ladder of newer versions is JSON: contacts, parallel branches, boxes entered by EN, results that go on.
TEST_F(StoredBodies, ALadderStoredAsJsonBecomesRungs) {
    const auto contact = [](const char* name, const char* modifier = "") {
        return std::string(R"({"$type":"Contact","Operand":{"$type":"Operand","Expression":")") + name + "\"" +
               modifier + "}}";
    };
    const auto sequence = [](const std::string& elements) {
        return R"({"$type":"Sequence","Elements":[)" + elements + "]}";
    };
    const auto coil = [](const char* name, const char* modifier = "") {
        return std::string(R"({"$type":"Coil","Operand":{"$type":"Operand","Expression":")") + name + "\"" + modifier +
               "}}";
    };
    const auto in = [&](const char* pin, const char* name) {
        return std::string(R"({"$type":"Input","Pin":{"$type":"Pin")") +
               (*pin ? std::string(R"(,"Name":")") + pin + "\"" : "") + R"(},"Sequence":)" +
               (*name ? sequence(std::string(R"({"$type":"InVariable","Operand":{"Expression":")") + name + "\"}}")
                      : R"({"$type":"Sequence"})") +
               "}";
    };
    const std::string network1 = R"({"$type":"Network","Title":"starts","Sequence":)" +
                                 sequence(R"({"$type":"ParallelOpen","Branches":[)" + sequence(contact("start")) + "," +
                                          sequence(contact("motor")) + "]}," +
                                          contact("stop", R"(,"Modifier":{"Negation":true})") + "," + coil("motor")) +
                                 "}";
    const std::string network2 =
        R"({"$type":"Network","Sequence":)" +
        sequence(R"({"$type":"Block","BlockType":"EQ","Instance":{"$type":"Operand"},"Inputs":[)" + in("EN", "") + "," +
                 in("", "n") + "," + in("", "3") + R"(],"Outputs":[{"Pin":{"$type":"Pin"}}],"En":true},)" +
                 coil("three", R"(,"Modifier":{"Storage":1})")) +
        "}";
    const std::string network3 =
        R"({"$type":"Network","Sequence":)" +
        sequence(contact("motor") + R"(,{"$type":"Block","BlockType":"ADD","Instance":{},"Inputs":[)" + in("EN", "") +
                 "," + in("", "n") + "," + in("", "1") +
                 R"(],"Outputs":[{"Pin":{"Name":"ENO"}},{"Pin":{},"OutVariable":{"Operand":{"Expression":"n"}}}],)" +
                 R"("En":true,"Eno":true},{"$type":"Block","BlockType":"TON","Instance":{"Expression":"delay"},)" +
                 R"("Inputs":[)" + in("IN", "") + "," + in("PT", "T#0s") + R"(],"Outputs":[{"Pin":{"Name":"Q"}}]},)" +
                 coil("done")) +
        "}";
    const Imported imported = importBody(
        "start : BOOL := TRUE; stop, motor, three, done : BOOL; n : INT; delay : TON;\n",
        "<LADDER><XmlArchive><Data><o xml:space=\"preserve\" t=\"LadderImplementationObject\"><v n=\"ModelJson\">\"" +
            (R"({"$type":"LadderDataModel","Networks":[)" + network1 + "," + network2 + "," + network3 + "]}") +
            "\"</v></o></Data></XmlArchive></LADDER>");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(errorsOf(imported), "") << fileOf(imported, "src/MAIN.st");
    EXPECT_NE(
        fileOf(imported, "src/MAIN.st").find("// starts\nmotor := (start OR motor) AND NOT stop;\nthree S= n = 3;\n"),
        std::string::npos)
        << fileOf(imported, "src/MAIN.st");
    EXPECT_EQ(valuesOf(imported, "MAIN.n", 5), (std::vector<int64_t>{1, 2, 3, 4, 5}));
    EXPECT_EQ(valuesOf(imported, "MAIN.three", 5), (std::vector<int64_t>{0, 0, 0, 1, 1}));
    EXPECT_EQ(valuesOf(imported, "MAIN.done", 2), (std::vector<int64_t>{1, 1}));
}

TEST_F(StoredBodies, AChartBecomesStepsAndTransitions) {
    const Imported imported =
        importChart("go : BOOL; n : INT;\n",
                    step("Rest", {{kInitial, "TRUE"}, {kComment, "Nothing moves"}}) + transition("go AND n = 0") +
                        step("Run", {{kEntry, "Started"}, {kMain, "Running"}, {kExit, "Stopped"}, {kMinTime, "T#1s"}}) +
                        transition("n &gt; 3") + jump("Rest"),
                    action("Started", "n := 0;") + action("Running", "n := n + 1;") + action("Stopped", "n := 0;"));
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(imported.report.bodies.at("SFC"), 1);
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(bodyOf(imported), "// Nothing moves\nINITIAL_STEP Rest:\nEND_STEP\n"
                                "TRANSITION FROM Rest TO Run := go AND n = 0; END_TRANSITION\n"
                                "STEP Run {minTime := T#1s}:\n    Started(P1);\n    Running(N);\n    Stopped(P0);\n"
                                "END_STEP\nTRANSITION FROM Run TO Rest := n > 3; END_TRANSITION\n");
}

TEST_F(StoredBodies, BranchesMeetAgainOrLeaveByJumps) {
    const Imported imported =
        importChart("a, b, c, d : BOOL;\n",
                    step("S", {{kInitial, "TRUE"}}) +
                        branch({transition("a") + branch({step("P1"), step("P2") + transition("d") + step("P3")}, true),
                                transition("b") + jump("S"), transition("c") + step("Q")},
                               false) +
                        transition("NOT a") + step("End") + transition("TRUE") + jump("S"));
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(errorsOf(imported), "");
    const std::string body = bodyOf(imported);
    for (const char* part : {"FROM S TO (P1, P2) := a;", "FROM S TO S := b;", "FROM S TO Q := c;",
                             "FROM P2 TO P3 := d;", "FROM (P1, P3) TO End := NOT a;", "FROM Q TO End := NOT a;"})
        EXPECT_NE(body.find(part), std::string::npos) << part << " in\n" << body;
}

TEST_F(StoredBodies, NamedTransitionsAndAssociatedActionsKeepTheirMeaning) {
    const Imported imported =
        importChart("lamp : BOOL; n : INT;\n",
                    step("S", {{kInitial, "TRUE"}},
                         element("SFCActionAssociation", {{kName, "lamp"}, {kQualifier, "S"}}) +
                             element("SFCActionAssociation", {{kName, "Count"}, {kQualifier, "D T#2s"}})) +
                        transition("Ready") + jump("S"),
                    action("Count", "n := n + 1;") + "<Transition Name=\"Ready\"><Implementation><ST><![CDATA[lamp AND "
                                                     "n > 2]]></ST></Implementation></Transition>");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(errorsOf(imported), "");
    const std::string body = bodyOf(imported);
    EXPECT_NE(body.find("    lamp(S);\n    Count(D, T#2s);\n"), std::string::npos) << body;
    EXPECT_NE(body.find("FROM S TO S := lamp AND n > 2;"), std::string::npos) << body;
}

TEST_F(StoredBodies, WhatAChartHasBeyondThatHasItsLine) {
    const Imported imported = importChart(
        "a : BOOL;\n", step("S", {{kInitial, "TRUE"}}) + transition("a") + "<o t=\"SFCSpiral\"/>" + jump("Nowhere"),
        "<Transition Name=\"T\"><Implementation><NWL/></Implementation></Transition>");
    const std::string report = imported.report.toText();
    EXPECT_NE(report.find("SFCSpiral"), std::string::npos) << report;
    EXPECT_NE(report.find("Nowhere"), std::string::npos) << report;
    EXPECT_NE(report.find("MAIN.T"), std::string::npos) << report;
    EXPECT_FALSE(imported.side["units"]["MAIN"]["archive"].empty());
}

TEST_F(StoredBodies, AnImportedChartRuns) {
    const Imported imported = importChart("n : INT;\n",
                                          step("S", {{kInitial, "TRUE"}, {kMain, "Count"}}) + transition("n &gt;= 2") +
                                              step("T", {{kMain, "Back"}}) + transition("n = 0") + jump("S"),
                                          action("Count", "n := n + 1;") + action("Back", "n := 0;"));
    EXPECT_EQ(errorsOf(imported), "");
    const std::vector<int64_t> values = valuesOf(imported, "MAIN.n", 20);
    ASSERT_EQ(values.size(), 20u);
    EXPECT_EQ(values.front(), 1);
    int returns = 0;
    for (size_t i = 1; i < values.size(); ++i) {
        EXPECT_LE(values[i], 3);
        returns += values[i] == 0 && values[i - 1] > 0;
    }
    EXPECT_GE(returns, 3);
}

TEST_F(StoredBodies, AFunctionChartBecomesStatementsInItsOrder) {
    const Imported imported = importCfc(
        "t : TON; start, y, s : BOOL; pt : TIME; a, b, sum : INT;\n",
        input(1, 10, "start") + input(2, 20, "pt") +
            box(3, "FunctionBlock", {30, 31}, {32, 33}, {"IN", "PT", "Q", "ET", "TON", "t"}) +
            output(4, 40, "y", "None", true) + output(5, 50, "s", "Set") + input(6, 60, "a") + input(7, 70, "b") +
            box(8, "Operator", {80, 81}, {82}, {"", "", "", "ADD"}) + output(9, 90, "sum") + line(10, 30) +
            line(20, 31) + line(32, 40) + line(32, 50) + line(60, 80) + line(70, 81) + line(82, 90));
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(imported.report.bodies.at("CFC"), 1);
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(bodyOf(imported), "t(IN := start, PT := pt);\ny := NOT t.Q;\ns S= t.Q;\nsum := a + b;\n");
}

TEST_F(StoredBodies, ASignWithoutInputsIsItsFunctionWithALine) {
    const Imported imported = importCfc("a : INT; y, z : BOOL;\n",
                                        input(1, 10, "a") + box(2, "Operator", {20, 21}, {22}, {"", "", "", "="}) +
                                            output(3, 30, "y") + box(4, "Operator", {40, 41}, {42}, {"", "", "", ">"}) +
                                            output(5, 50, "z") + line(22, 30) + line(10, 40) + line(42, 50));
    EXPECT_EQ(bodyOf(imported), "y := EQ();\nz := GT(a);\n");
    EXPECT_NE(imported.report.toText().find("An input of = is not connected"), std::string::npos)
        << imported.report.toText();
    EXPECT_NE(imported.report.toText().find("An input of > is not connected"), std::string::npos);
}

TEST_F(StoredBodies, AFeedbackReadsTheValueOfTheLastCall) {
    // first the sum with the counter's old value, then the counter
    const Imported imported =
        importCfc("c : CTU; pulse : BOOL; sum : INT; n : INT;\n",
                  box(1, "Operator", {10, 11}, {12}, {"", "", "", "ADD"}) +
                      box(2, "FunctionBlock", {20, 21, 22}, {23, 24}, {"CU", "R", "PV", "Q", "CV", "CTU", "c"}) +
                      output(3, 30, "sum") + output(4, 40, "n") + input(5, 50, "pulse") + input(6, 60, "1") +
                      line(24, 10) + line(60, 11) + line(50, 20) + line(12, 30) + line(24, 40));
    EXPECT_EQ(errorsOf(imported), "");
    const std::string body = bodyOf(imported);
    const size_t store = body.find("c.CV + 1"), call = body.find("c(CU := pulse");
    ASSERT_NE(store, std::string::npos) << body;
    ASSERT_NE(call, std::string::npos) << body;
    EXPECT_LT(store, call) << body;
    EXPECT_EQ(body.find("c.CV + 1", call), std::string::npos) << body;
}

TEST_F(StoredBodies, WhatAFunctionChartHasBeyondThatHasItsLine) {
    const Imported imported = importCfc("a, y : BOOL;\n", input(1, 10, "a") + output(2, 20, "y") + line(99, 20) +
                                                              "<o t=\"CFCComposer\">" + number("Id", 7) + "</o>");
    const std::string report = imported.report.toText();
    EXPECT_NE(report.find("CFCComposer"), std::string::npos) << report;
    EXPECT_NE(report.find("99"), std::string::npos) << report;
    EXPECT_FALSE(imported.side["units"]["MAIN"]["archive"].empty());
}

} // namespace
} // namespace plc::exchange
