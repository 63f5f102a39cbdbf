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
         {element(1, "_MACRO", ""), source(1, "a") + target(2, "y", from(1, 0), "_OTHER"),
          box(1, "Elsewhere", "f", {}, 1), std::string("_ELEMENT\n_ID: 1\n"), std::string("nonsense\n"),
          box(1, "TON", "t", {}, 1) + target(2, "y", from(1, 99))}) {
        write("odd.EXP", unit("PROGRAM Odd", "\ta, y : BOOL;\n", "_CFC_BODY\n" + body, "END_PROGRAM"));
        const Imported imported = folder("odd.EXP");
        EXPECT_EQ(imported.report.losses(), 1u) << body << imported.report.toText();
        EXPECT_FALSE(imported.side["units"]["Odd"]["archive"].empty());
    }
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
