// Text exports of CODESYS 2.3 beyond their units: libraries, tasks, names of inputs and outputs, free function block
// diagrams; the same diagrams as CODESYS V3 puts them beside an empty ST, and as the first TwinCAT 3 stored them.
#include "fixture.h"

namespace plc::exchange {
namespace {

class Codesys2 : public ExchangeTest {
protected:
    static std::string unit(const std::string& head, const std::string& variables, const std::string& body,
                            const std::string& end) {
        return "\n(* @NESTEDCOMMENTS := 'Yes' *)\n(* @PATH := '' *)\n(* @OBJECTFLAGS := '0, 8' *)\n" + head +
               "\nVAR\n" + variables + "END_VAR\n(* @END_DECLARATION := '0' *)\n" + body + "\n" + end + "\n";
    }
    /// An element of a chart: what it is, then its pins.
    static std::string element(int id, const std::string& type, const std::string& rest) {
        return "_ELEMENT\n_ID: " + std::to_string(id) + "\n_MACROID: -1\n_POS: 1, 1\n_TYPE: " + type + "\n" + rest +
               "_END\n";
    }
    static std::string source(int id, const std::string& text) {
        return element(id, "_INPUT", "_TEXT: " + text + "\n_NEGATE: 0\n_CONNECTOR: \n");
    }
    static std::string from(int id, int pin, bool negated = false) {
        return "_INPUTID: " + std::to_string(id) + "\n_INPUTIDX: " + std::to_string(pin) +
               "\n_NEGATE: " + (negated ? "1" : "0") + "\n";
    }
    static std::string target(int id, const std::string& text, const std::string& source,
                              const std::string& storage = "_NONE") {
        return element(id, "_OUTPUT", "_TEXT: " + text + "\n" + source + "_SETRESET: " + storage + "\n");
    }
    static std::string box(int id, const std::string& type, const std::string& instance,
                           std::initializer_list<std::string> inputs, int outputs) {
        std::string rest = "_INSTANCE: " + std::string(instance.empty() ? "0" : "1") + "\n_INSTANCENAME: " + instance +
                           "\n_TYPENAME: " + type + "\n_ENENO: 0\n_INPUTS: " + std::to_string(inputs.size()) + "\n";
        for (const std::string& each : inputs) rest += "_IN\n" + each + "_END\n";
        rest += "_OUTPUTS: " + std::to_string(outputs) + "\n";
        for (int i = 0; i < outputs; ++i) rest += "_OUT\n_NEGATE: 0\n_CONNECTOR: \n_END\n";
        return element(id, "_BOX", rest + "_PARAMETERS: 0\n");
    }
};

TEST_F(Codesys2, AProjectOfManyFilesRunsWithItsTasksAndNames) {
    write("p/PLC_PRG.EXP",
          unit("PROGRAM PLC_PRG", "\tt : TON;\n", "t(IN := start, PT := T#1s);\nlamp := t.Q OR key;", "END_PROGRAM"));
    write("p/STANDARD.LIB 4.10.05 11_14_46.EXP",
          "LIBRARY\nSTANDARD.LIB 4.10.05 11:14:46\n(* @LIBRARYSYMFILEINFO := '0' *)\nNumOfPOUs: 1\nTON: 0\n"
          "NumOfGVLs: 0\nEND_LIBRARY\n");
    write("p/Tasks.EXP", "\nRESOURCE\n\nTASK fast (PRIORITY := 1, INTERVAL := T#3ms);\nPLC_PRG();\n"
                         "{Additional_info : 1,0,0}\nEND_TASK\n\nEND_RESOURCE\n");
    write("p/Workspace.EXP", "\n_WORKSPACE\n_GLOBALVISUALSETTINGS\n_END_GLOBALVISUALSETTINGS\n_END_WORKSPACE\n");
    write("p/Mapping.EXP", "(* @NESTEDCOMMENTS := 'Yes' *)\n(* @GLOBAL_VARIABLE_LIST := 'Variable_Configuration' *)\n"
                           "VAR_CONFIG\nEND_VAR\n(* @OBJECT_END := 'Variable_Configuration' *)\n");
    write("p/Devices.EXP",
          "PLC_CONFIGURATION\n_GLOBAL\n_VERSION: 3\n_END_GLOBAL\n_MODULE: '3S'\n_CHANNEL\n_SECTION_NAME: 'In'\n"
          "_SYMBOLIC_NAME: 'start'\n_COMMENT: 'the button'\n_CHANNEL_MODE: 'I'\n_IECADR: %IX0.0\n_END_CHANNEL\n"
          "_CHANNEL\n_SYMBOLIC_NAME: ''\n_COMMENT: ''\n_IECADR: %QB1.0\n_BIT 0: %QX1.0.0 'lamp' 'green'\n"
          "_BIT 1: %QX1.0.1 '' 'Bit 1'\n_END_CHANNEL\n_CHANNEL\n_SYMBOLIC_NAME: 'level'\n_COMMENT: ''\n"
          "_IECADR: %IR3.0\n_END_CHANNEL\n_END_MODULE\nPLC_END\n");
    write("p/Keys.EXP", "\n(* @NESTEDCOMMENTS := 'Yes' *)\n(* @GLOBAL_VARIABLE_LIST := 'Keys' *)\nVAR_GLOBAL\n"
                        "\tkey : BOOL;\nEND_VAR\n(* @OBJECT_END := 'Keys' *)\n");
    const Imported imported = folder("p");
    EXPECT_EQ(errorsOf(imported), "");
    ASSERT_EQ(imported.report.losses(), 1u) << imported.report.toText(); // the devices themselves
    EXPECT_EQ(fileOf(imported, "src/PLC_Configuration.st"),
              "{gvl PLC_Configuration}\nVAR_GLOBAL\n    start AT %IX0.0 : BOOL; // the button\n"
              "    lamp AT %QX1.0.0 : BOOL; // green\n    level AT %ID3.0 : REAL;\nEND_VAR\n");
    EXPECT_NE(fileOf(imported, "src/configuration.st")
                  .find("TASK fast(INTERVAL := T#3ms, PRIORITY := 1);\n        PROGRAM PLC_PRG WITH fast : PLC_PRG;"),
              std::string::npos);
}

TEST_F(Codesys2, ATaskThatWaitsForAnEventHasItsLine) {
    write("p/Tasks.EXP", "RESOURCE\nTASK alarm (PRIORITY := 1, EVENT := trip);\nPLC_PRG();\nEND_TASK\nEND_RESOURCE\n");
    write("p/PLC_PRG.EXP", unit("PROGRAM PLC_PRG", "\tn : INT;\n", "n := 1;", "END_PROGRAM"));
    const Imported imported = folder("p");
    EXPECT_EQ(imported.report.losses(), 1u) << imported.report.toText();
    EXPECT_NE(imported.report.toText().find("trip"), std::string::npos);
}

TEST_F(Codesys2, AFunctionChartBecomesStatementsInItsOrder) {
    write("chart.EXP",
          unit("PROGRAM Chart", "\tdelay : TON; go, alarm, quiet, y : BOOL;\n",
               "_CFC_BODY\n" + source(8, "go AND NOT quiet") + source(7, "T#2s") +
                   box(6, "TON", "delay", {from(8, 0), from(7, 0)}, 2) + target(3, "alarm", from(6, 0), "_SET") +
                   source(9, "quiet") + target(5, "alarm", from(9, 0), "_RESET") +
                   box(10, "AND", "", {from(6, 0, true), from(9, 0)}, 1) + target(11, "y", from(10, 0)),
               "END_PROGRAM"));
    const Imported imported = folder("chart.EXP");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(imported.report.bodies.at("CFC"), 1);
    EXPECT_EQ(errorsOf(imported), "");
    const std::string text = fileOf(imported, "src/Chart.st");
    EXPECT_NE(text.find("delay(IN := go AND NOT quiet, PT := T#2s);\nalarm S= delay.Q;\nalarm R= quiet;\n"
                        "y := NOT delay.Q AND quiet;\n"),
              std::string::npos)
        << text;
}

TEST_F(Codesys2, AChartWithAnythingUnknownIsKeptWithItsLine) {
    for (const std::string& body :
         {element(1, "_ODD", ""), source(1, "a") + target(2, "y", from(1, 0), "_OTHER"),
          box(1, "Elsewhere", "f", {}, 1), std::string("_ELEMENT\n_ID: 1\n"), std::string("nonsense\n"),
          box(1, "TON", "t", {}, 1) + target(2, "y", from(1, 99))}) {
        write("odd.EXP", unit("PROGRAM Odd", "\ta, y : BOOL;\n", "_CFC_BODY\n" + body, "END_PROGRAM"));
        const Imported imported = folder("odd.EXP");
        EXPECT_EQ(imported.report.losses(), 1u) << body << imported.report.toText();
        EXPECT_FALSE(imported.side["units"]["Odd"]["archive"].empty());
    }
}

TEST_F(Codesys2, LinesLeadThroughTheBordersOfMacros) {
    // a goes into the macro and through its box (out of it negated); inside is another macro that only passes on
    const std::string macro =
        element(30, "_MACRO",
                "_TEXT: Delay\n_INPUTS: 2\n_IN\n" + from(1, 0) + "_PINNAME: (*go*)\n_END\n_IN\n" + from(2, 0, true) +
                    "_PINNAME: x\n_END\n_OUTPUTS: 1\n_OUT\n_NEGATE: 1\n" + "_CONNECTOR: \n_PINNAME: q\n_END\n");
    const std::string inner = element(40, "_MACRO",
                                      "_TEXT: Wire\n_INPUTS: 1\n_IN\n" + from(31, 0) +
                                          "_END\n_OUTPUTS: 1\n_OUT\n_NEGATE: 0\n_CONNECTOR: \n_END\n");
    const auto pin = [](int id, const std::string& type, int of, int number, const std::string& rest) {
        return "_ELEMENT\n_ID: " + std::to_string(id) + "\n_MACROID: " + std::to_string(of) +
               "\n_POS: 1, 1\n_TYPE: " + type + "\n_MACROIDX: " + std::to_string(number) + "\n" + rest + "_END\n";
    };
    const std::string body =
        "_CFC_BODY\n" + source(1, "a") + source(2, "b") + macro + inner + pin(31, "_INPIN", 30, 1, "_CONNECTOR: \n") +
        pin(32, "_INPIN", 30, 2, "_CONNECTOR: \n") + pin(41, "_INPIN", 40, 1, "_CONNECTOR: \n") +
        pin(42, "_OUTPIN", 40, 1, "_INPUTID: 41\n_INPUTIDX: 0\n") + source(5, "T#1s") +
        box(6, "TON", "t", {from(40, 0), from(5, 0)}, 2) + box(7, "AND", "", {from(6, 0), from(32, 0)}, 1) +
        pin(33, "_OUTPIN", 30, 1, "_INPUTID: 7\n_INPUTIDX: 0\n") + target(8, "y", from(30, 0));
    write("macro.EXP", unit("PROGRAM Macros", "\ta, b, y : BOOL; t : TON;\n", body, "END_PROGRAM"));
    const Imported imported = folder("macro.EXP");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(errorsOf(imported), "");
    const std::string text = fileOf(imported, "src/Macros.st");
    EXPECT_NE(text.find("t(IN := a, PT := T#1s);\ny := NOT (t.Q AND NOT b);\n"), std::string::npos) << text;
}

TEST_F(Codesys2, ACircleOfMacroPinsIsKeptWithItsLine) {
    const std::string macro = element(1, "_MACRO",
                                      "_TEXT: M\n_INPUTS: 1\n_IN\n" + from(1, 0) +
                                          "_END\n_OUTPUTS: 1\n_OUT\n_NEGATE: 0\n_CONNECTOR: \n_END\n");
    const std::string pins =
        "_ELEMENT\n_ID: 2\n_MACROID: 1\n_TYPE: _INPIN\n_MACROIDX: 1\n_CONNECTOR: \n_END\n"
        "_ELEMENT\n_ID: 3\n_MACROID: 1\n_TYPE: _OUTPIN\n_MACROIDX: 1\n_INPUTID: 2\n_INPUTIDX: 0\n_END\n";
    for (const std::string& output : {from(1, 0), from(1, 7), from(2, 0)}) {
        write("odd.EXP", unit("PROGRAM Odd", "\ty : BOOL;\n", "_CFC_BODY\n" + macro + pins + target(9, "y", output),
                              "END_PROGRAM"));
        EXPECT_EQ(folder("odd.EXP").report.losses(), 1u) << output;
    }
}

TEST_F(Codesys2, ADrawnActionBelongsToItsUnitWithItsVariables) {
    const std::string contact = "_LD_CONTACT\n", sign = "_EXPRESSION\n_POSITIV\n";
    write("p/Main.EXP",
          unit("PROGRAM Main", "\ta, b, y : BOOL;\n", "Drawn;\nPlain;", "END_PROGRAM") +
              "ACTION Drawn:\n_LD_BODY\n_NETWORKS : 1\n_NETWORK\n_COMMENT\n''\n_END_COMMENT\n_LD_ASSIGN\n_LD_AND\n"
              "_LD_OPERATOR : 2\n" +
              contact + "a\n" + sign + contact + "b\n_EXPRESSION\n_NEGATIV\n" + sign + sign +
              "ENABLELIST : 0\nENABLELIST_END\n_OUTPUTS : 1\n_OUTPUT\n_POSITIV\n_NO_SET\ny\nEND_ACTION\n"
              "ACTION Plain:\n(* @TEXT_IMPLEMENTATION := 'ST' *)\na := NOT a;\nEND_ACTION\n");
    const Imported imported = folder("p");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(imported.report.bodies.at("LD"), 1);
    EXPECT_EQ(errorsOf(imported), "");
    const std::string text = fileOf(imported, "src/Main.st");
    EXPECT_NE(text.find("ACTION Drawn:\ny := a AND NOT b;\nEND_ACTION"), std::string::npos) << text;
    EXPECT_NE(text.find("a := NOT a;"), std::string::npos) << text;
    EXPECT_FALSE(imported.side["units"]["Main.Drawn"]["archive"].empty());
}

TEST_F(Codesys2, BlocksOfUtilAreKnownWithoutTheListOfLibraries) {
    write("siren.EXP",
          unit("PROGRAM Siren", "\tblnk : BLINK; y : BOOL; scale : LIN_TRAFO;\n",
               "_CFC_BODY\n" + source(1, "TRUE") + source(2, "T#1s") + source(3, "T#2s") +
                   box(4, "BLINK", "blnk", {from(1, 0), from(2, 0), from(3, 0)}, 1) + target(5, "y", from(4, 0)),
               "END_PROGRAM"));
    const Imported imported = folder("siren.EXP");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(imported.libraries, std::set<std::string>{"util"});
    EXPECT_NE(imported.report.toText().find("the project uses the library util"), std::string::npos);
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_NE(fileOf(imported, "src/Siren.st").find("blnk(ENABLE := TRUE, TIMELOW := T#1s, TIMEHIGH := T#2s);"),
              std::string::npos);
}

TEST_F(Codesys2, WhatIsDrawnAndNotReadSaysWhy) {
    const auto kindOf = [&](const std::string& body) {
        write("odd.EXP", unit("PROGRAM Odd", "\ta, y : BOOL; f : Elsewhere;\n", body, "END_PROGRAM"));
        const Imported imported = folder("odd.EXP");
        EXPECT_EQ(imported.report.losses(), 1u) << imported.report.toText();
        EXPECT_NE(fileOf(imported, "src/Odd.st").find("f : Elsewhere;"), std::string::npos); // what is declared is kept
        return imported.report.notes.front().kind;
    };
    EXPECT_EQ(kindOf("_CFC_BODY\n" + box(1, "Elsewhere", "f", {}, 1)), NoteKind::DrawnBlockUnknown);
    EXPECT_EQ(kindOf("_CFC_BODY\n" + element(1, "_ODD", "")), NoteKind::DrawnBodyNotRead);
    EXPECT_EQ(kindOf("_SFC_BODY\n_STEP\nInit\n"), NoteKind::DrawnBodyNotRead);
}

/// Lines of a chart in XML end at a connector without a name, which has a line to where they begin.
std::string chartInXml() {
    return "<CFC><inVariable localId=\"3\"><position x=\"9\" y=\"14\"/><connectionPointOut><expression/>"
           "</connectionPointOut><expression>a</expression></inVariable><connector localId=\"2\" name=\"\">"
           "<connectionPointIn><connection refLocalId=\"3\" formalParameter=\"a\"/></connectionPointIn></connector>"
           "<inVariable localId=\"5\"><expression>T#1s</expression></inVariable><connector localId=\"4\" name=\"\">"
           "<connectionPointIn><connection refLocalId=\"5\"/></connectionPointIn></connector>"
           "<block localId=\"1\" executionOrderId=\"1\" typeName=\"TON\" instanceName=\"t\"><inputVariables>"
           "<variable formalParameter=\"IN\" negated=\"true\"><connectionPointIn><connection refLocalId=\"2\"/>"
           "</connectionPointIn></variable><variable formalParameter=\"PT\"><connectionPointIn><connection "
           "refLocalId=\"4\"/></connectionPointIn></variable></inputVariables><inOutVariables/><outputVariables>"
           "<variable formalParameter=\"Q\"><connectionPointOut><expression/></connectionPointOut></variable>"
           "</outputVariables><addData><data name=\"http://www.3s-software.com/plcopenxml/cfccalltype\" "
           "handleUnknown=\"implementation\"><CallType xmlns=\"\">functionblock</CallType></data></addData></block>"
           "<connector localId=\"6\" name=\"\"><connectionPointIn><connection refLocalId=\"1\" formalParameter=\"Q\"/>"
           "</connectionPointIn></connector><outVariable localId=\"7\" executionOrderId=\"2\"><connectionPointIn>"
           "<connection refLocalId=\"6\"/></connectionPointIn><expression>y</expression></outVariable></CFC>";
}

TEST_F(Codesys2, AFunctionChartOfVersion3IsBesideAnEmptyText) {
    const Imported imported = import(
        document(pou("Chart", "program",
                     bools({"a", "y"}) + "<localVars>" + variable("t", "<derived name=\"TON\"/>") + "</localVars>",
                     st("") +
                         "<addData><data name=\"http://www.3s-software.com/plcopenxml/cfc\" "
                         "handleUnknown=\"implementation\">" +
                         chartInXml() + "</data></addData>")));
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(imported.report.bodies.at("CFC"), 1);
    EXPECT_EQ(errorsOf(imported), "");
    const std::string text = fileOf(imported, "src/Chart.st");
    EXPECT_NE(text.find("t(IN := NOT a, PT := T#1s);\ny := t.Q;\n"), std::string::npos) << text;
}

TEST_F(Codesys2, TheFirstVersionsOfTwinCatStoredChartsTheSameWay) {
    write("Chart.TcPOU",
          "<TcPlcObject><POU Name=\"Chart\"><Declaration><![CDATA[PROGRAM Chart\nVAR\n\ta, y : BOOL;\n\tt : TON;\n"
          "END_VAR\n]]></Declaration><Implementation>" +
              chartInXml() +
              "</Implementation><Action Name=\"Later\"><Implementation><CFC/></Implementation></Action>" +
              "</POU></TcPlcObject>");
    const Imported imported = folder("Chart.TcPOU");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_NE(fileOf(imported, "src/Chart.st").find("t(IN := NOT a, PT := T#1s);\ny := t.Q;\n"), std::string::npos);
}

} // namespace
} // namespace plc::exchange
