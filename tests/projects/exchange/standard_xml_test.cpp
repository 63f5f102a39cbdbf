// IEC 61131-10 in: its types, units, bodies in every language, namespaces and configurations, each in the form in which
// its schema has them, and what vendors put into it.
#include "fixture.h"

#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "runtime/types/value.h"

namespace plc::exchange {
namespace {

class StandardXml : public ExchangeTest {
protected:
    static std::string project(const std::string& types, const std::string& instances = {}) {
        return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Project xmlns=\"www.iec.ch/public/TC65SC65BWG7TF10\" "
               "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" schemaVersion=\"1.0\">\n"
               "<FileHeader companyName=\"\" productName=\"Editor\" productVersion=\"1\"/>\n"
               "<ContentHeader name=\"Plant\" creationDateTime=\"2020-01-01T00:00:00\"/>\n<Types><GlobalNamespace>" +
               types + "</GlobalNamespace></Types>\n<Instances>" + instances + "</Instances>\n</Project>\n";
    }
    static std::string variable(const std::string& name, const std::string& type, const std::string& more = {}) {
        return "<Variable name=\"" + name + "\"><Type><TypeName>" + type + "</TypeName></Type>" + more + "</Variable>";
    }
    static std::string initial(const std::string& value) {
        return "<InitialValue><SimpleValue value=\"" + value + "\"/></InitialValue>";
    }
    static std::string vars(const std::string& variables) {
        return "<Vars accessSpecifier=\"private\">" + variables + "</Vars>";
    }
    static std::string body(const std::string& language, const std::string& content) {
        return "<MainBody><BodyContent xsi:type=\"" + language + "\">" + content + "</BodyContent></MainBody>";
    }
    static std::string st(const std::string& text) { return body("ST", "<ST>" + text + "</ST>"); }
    static std::string program(const std::string& name, const std::string& inner) {
        return "<Program name=\"" + name + "\">" + inner + "</Program>";
    }
    static std::string in(const std::string& point) {
        return "<ConnectionPointIn><Connection refConnectionPointOutId=\"" + point + "\"/></ConnectionPointIn>";
    }
    static std::string out(const std::string& point) {
        return "<ConnectionPointOut connectionPointOutId=\"" + point + "\"/>";
    }
    static std::string object(const std::string& family, const std::string& type, const std::string& attributes,
                              const std::string& inner) {
        return "<" + family + "Object xsi:type=\"" + type + "\" " + attributes + ">" + inner + "</" + family +
               "Object>";
    }
    static std::string place(int x, int y) {
        return "<RelPosition x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\"/>";
    }
    /// What Main.name is after `scans` scans, 10 ms apart.
    static std::string valueAfter(const Imported& imported, int scans, const std::string& name) {
        jit::setRuntimeSymbols(controller::runtimeSymbols());
        const driver::Built built = driver::build(toProject(imported).buildInput());
        if (!built.program) return "does not build: " + errorsOf(imported);
        controller::Controller controller(built.program);
        controller.start();
        for (int i = 0; i < scans; ++i)
            if (!controller.scan()) return "fault";
        const auto value = controller.read(name);
        return value ? types::toText(*built.program->layout.types, *value) : "no value";
    }
    static size_t losses(const Imported& imported) { return imported.report.losses(); }
};

TEST_F(StandardXml, ReadsAProgramWithItsTaskAndGlobals) {
    const Imported imported = import(
        project(program("Main", "<ExternalVars>" + variable("level", "INT") + "</ExternalVars>" +
                                    vars(variable("n", "DINT", initial("5")) +
                                         "<Variable name=\"list\"><Documentation xsi:type=\"SimpleText\">the last "
                                         "ones</Documentation><Type><InstantlyDefinedType xsi:type=\"ArrayTypeSpec\">"
                                         "<BaseType><TypeName>REAL</TypeName></BaseType><DimensionSpec "
                                         "dimensionNumber=\"1\"><IndexRange lower=\"0\" upper=\"3\"/></DimensionSpec>"
                                         "</InstantlyDefinedType></Type></Variable>") +
                                    st("n := n + 1;\nlevel := 7;")),
                "<Configuration name=\"Plc\"><Resource name=\"Res\" resourceTypeName=\"Cpu\"><GlobalVars "
                "retain=\"true\">" +
                    variable("level", "INT", "<Address location=\"M\" size=\"W\" address=\"4\"/>") +
                    "</GlobalVars><Task xsi:type=\"StandardTask\" name=\"Fast\" interval=\"T#10ms\" priority=\"3\"/>"
                    "<ProgramInstance name=\"Main\" typeName=\"Main\" associatedTaskName=\"Fast\"/></Resource>"
                    "</Configuration>"));
    EXPECT_EQ(imported.name, "Plant");
    EXPECT_EQ(imported.side["source"]["format"], "IEC 61131-10");
    EXPECT_EQ(fileOf(imported, "src/Main.st"), "PROGRAM Main\nVAR_EXTERNAL\n    level : INT;\nEND_VAR\nVAR\n"
                                               "    n : DINT := 5;\n    list : ARRAY [0..3] OF REAL; // the last ones\n"
                                               "END_VAR\nn := n + 1;\nlevel := 7;\nEND_PROGRAM\n");
    const std::string configuration = fileOf(imported, "src/configuration.st");
    EXPECT_NE(configuration.find("VAR_GLOBAL RETAIN\n            level AT %MW4 : INT;"), std::string::npos)
        << configuration;
    EXPECT_NE(configuration.find("TASK Fast(INTERVAL := T#10ms, PRIORITY := 3);"), std::string::npos) << configuration;
    EXPECT_NE(configuration.find("PROGRAM Main WITH Fast : Main;"), std::string::npos) << configuration;
    EXPECT_EQ(losses(imported), 0u) << imported.report.toText();
    EXPECT_EQ(valueAfter(imported, 3, "Main.n"), "8");
}

TEST_F(StandardXml, ReadsEveryKindOfType) {
    const Imported imported = import(project(
        "<DataTypeDecl name=\"Mode\"><UserDefinedTypeSpec xsi:type=\"EnumTypeWithNamedValueSpec\"><Enumerator "
        "name=\"Off\" value=\"0\"/><Enumerator name=\"On\" value=\"4\"/><BaseType>UINT</BaseType><InitialValue>On"
        "</InitialValue></UserDefinedTypeSpec></DataTypeDecl>"
        "<DataTypeDecl name=\"Percent\"><UserDefinedTypeSpec xsi:type=\"SubrangeTypeSpec\"><Range lower=\"0\" "
        "upper=\"100\"/><BaseType><TypeName>INT</TypeName></BaseType></UserDefinedTypeSpec></DataTypeDecl>"
        "<DataTypeDecl name=\"Row\"><UserDefinedTypeSpec xsi:type=\"ArrayTypeSpec\"><BaseType><TypeName>Percent"
        "</TypeName></BaseType><DimensionSpec dimensionNumber=\"1\"><IndexRange lower=\"1\" upper=\"2\"/>"
        "</DimensionSpec><DimensionSpec dimensionNumber=\"2\"><IndexRange lower=\"1\" upper=\"3\"/></DimensionSpec>"
        "</UserDefinedTypeSpec></DataTypeDecl>"
        "<DataTypeDecl name=\"Short\"><UserDefinedTypeSpec xsi:type=\"DirectlyDerivedTypeSpec\"><BaseType><TypeName>"
        "STRING[12]</TypeName></BaseType>" +
        initial("'abc'") +
        "</UserDefinedTypeSpec></DataTypeDecl>"
        "<DataTypeDecl name=\"Valve\"><UserDefinedTypeSpec xsi:type=\"StructTypeSpec\"><Member name=\"mode\"><Type>"
        "<TypeName>Mode</TypeName></Type></Member><Member name=\"limits\"><Type><InstantlyDefinedType "
        "xsi:type=\"ArrayTypeSpec\"><BaseType><TypeName>INT</TypeName></BaseType><DimensionSpec dimensionNumber=\"1\">"
        "<IndexRange lower=\"0\" upper=\"1\"/></DimensionSpec></InstantlyDefinedType></Type><InitialValue><ArrayValue>"
        "<Value><SimpleValue value=\"3\"/></Value><Value><SimpleValue value=\"9\"/></Value></ArrayValue></InitialValue>"
        "</Member></UserDefinedTypeSpec></DataTypeDecl>"
        "<DataTypeDecl name=\"Bits\"><UserDefinedTypeSpec xsi:type=\"StructTypeSpec\" overlap=\"true\"><Member "
        "name=\"word\"><Type><TypeName>WORD</TypeName></Type></Member><Member name=\"low\"><Type><TypeName>BYTE"
        "</TypeName></Type></Member></UserDefinedTypeSpec></DataTypeDecl>"
        "<DataTypeDecl name=\"Handle\"><UserDefinedTypeSpec xsi:type=\"ReferenceTypeSpec\"><ReferenceTo><TypeName>INT"
        "</TypeName></ReferenceTo></UserDefinedTypeSpec></DataTypeDecl>" +
        program("Main", vars(variable("v", "Valve") + variable("s", "Short") + variable("b", "Bits") +
                             variable("r", "Row") + variable("h", "Handle") + variable("sum", "INT")) +
                            st("b.word := 16#1234;\nsum := v.limits[1] + BYTE_TO_INT(b.low) + UINT_TO_INT(v.mode);"))));
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(fileOf(imported, "src/Percent.st"), "TYPE Percent : INT (0..100);\nEND_TYPE\n");
    EXPECT_EQ(fileOf(imported, "src/Row.st"), "TYPE Row : ARRAY [1..2, 1..3] OF Percent;\nEND_TYPE\n");
    EXPECT_EQ(fileOf(imported, "src/Handle.st"), "TYPE Handle : REF_TO INT;\nEND_TYPE\n");
    EXPECT_EQ(losses(imported), 0u) << imported.report.toText();
    EXPECT_EQ(valueAfter(imported, 1, "Main.sum"), "65"); // 9 + 16#34 + On
    EXPECT_EQ(valueAfter(imported, 1, "Main.s"), "'abc'");
}

// The numbers of connection points begin again in every rung.
TEST_F(StandardXml, ReadsALadderRungByRung) {
    const std::string rung1 =
        "<Rung evaluationOrder=\"2\">" + place(1, 1) +
        object("Common", "Comment", "", place(1, 0) + "<Content xsi:type=\"SimpleText\">stores it</Content>") +
        object("Ld", "LeftPowerRail", "", place(1, 0) + out("1")) +
        object("Ld", "Contact", "operand=\"start\"", place(4, 4) + in("1") + out("2")) +
        object("Ld", "Contact", "operand=\"stop\" negated=\"true\"", place(8, 4) + in("2") + out("3")) +
        object("Ld", "Coil", "operand=\"motor\" latch=\"set\"", place(20, 4) + in("3") + out("4")) +
        object("Ld", "RightPowerRail", "", place(40, 0) + in("4")) + "</Rung>";
    const std::string rung2 =
        "<Rung evaluationOrder=\"1\" label=\"first\">" + object("Ld", "LeftPowerRail", "", out("1") + out("2")) +
        object("Ld", "CompareContact", "operand1=\"n\" operand2=\"10\" compareOperator=\"&lt;\"", in("2") + out("3")) +
        object("Fbd", "DataSource", "identifier=\"T#20ms\"", out("4")) +
        object("Fbd", "Block", "typeName=\"TON\" instanceName=\"delay\"",
               "<InputVariables><InputVariable parameterName=\"IN\">" + in("3") +
                   "</InputVariable><InputVariable parameterName=\"PT\">" + in("4") +
                   "</InputVariable></InputVariables><OutputVariables><OutputVariable parameterName=\"Q\">" + out("5") +
                   "</OutputVariable></OutputVariables>") +
        object("Ld", "Coil", "operand=\"start\"", in("5")) + "</Rung>";
    const Imported imported = import(project(
        program("Main", vars(variable("start", "BOOL") + variable("stop", "BOOL") + variable("motor", "BOOL") +
                             variable("n", "INT") + variable("delay", "TON")) +
                            body("LD", rung1 + rung2)),
        "<Configuration name=\"Plc\"><Resource name=\"Res\" resourceTypeName=\"\"><Task xsi:type=\"StandardTask\" "
        "name=\"T10\" interval=\"PT0.01S\" priority=\"1\"/><ProgramInstance name=\"Main\" typeName=\"Main\" "
        "associatedTaskName=\"T10\"/></Resource></Configuration>"));
    const std::string text = fileOf(imported, "src/Main.st");
    EXPECT_NE(text.find("first:\ndelay(IN := (n < 10), PT := T#20ms);\nstart := delay.Q;\n// stores it\n"
                        "motor S= start AND NOT stop;\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(losses(imported), 0u) << imported.report.toText();
    EXPECT_EQ(valueAfter(imported, 2, "Main.motor"), "FALSE");
    EXPECT_EQ(valueAfter(imported, 4, "Main.motor"), "TRUE");
}

TEST_F(StandardXml, ReadsAFunctionBlockDiagramInItsOrder) {
    const auto priority = [](int number) {
        return "<AddData><Data name=\"x\" handleUnknown=\"implementation\"><EvaluationPriority priorityInNetwork=\"" +
               std::to_string(number) + "\"/></Data></AddData>";
    };
    const std::string network =
        "<Network evaluationOrder=\"1\">" + object("Fbd", "DataSource", "identifier=\"a\"", out("1")) +
        object("Fbd", "DataSink", "identifier=\"b\"", priority(2) + in("2")) +
        object("Fbd", "Block", "typeName=\"ADD\"",
               priority(1) + "<InputVariables><InputVariable parameterName=\"IN1\">" + in("1") +
                   "</InputVariable><InputVariable parameterName=\"IN2\">" + in("3") +
                   "</InputVariable></InputVariables><OutputVariables><OutputVariable parameterName=\"OUT\">" +
                   out("2") + "</OutputVariable></OutputVariables>") +
        object("Fbd", "DataSource", "identifier=\"2\"", out("3")) +
        object("Common", "Connector", "label=\"c\"", in("2")) +
        object("Common", "Continuation", "label=\"c\"", out("7")) +
        object("Fbd", "DataSink", "identifier=\"d\"", priority(3) + in("7")) +
        object("Fbd", "Unconnected", "complexIdentifier=\"spare\"", "") + "</Network>";
    const Imported imported = import(project(
        program("Main", vars(variable("a", "INT", initial("40")) + variable("b", "INT") + variable("d", "INT")) +
                            body("FBD", network))));
    EXPECT_EQ(valueAfter(imported, 1, "Main.b"), "42");
    EXPECT_EQ(valueAfter(imported, 1, "Main.d"), "42");
    EXPECT_EQ(losses(imported), 1u) << imported.report.toText();
    EXPECT_NE(imported.report.toText().find("Unconnected spare"), std::string::npos) << imported.report.toText();
}

TEST_F(StandardXml, ReadsAChart) {
    const std::string chart =
        object("Sfc", "Step", "name=\"Idle\" initialStep=\"true\"", in("9") + out("1")) +
        object("Sfc", "SelectionDivergence", "",
               in("1") + "<ConnectionPointOut connectionPointOutId=\"2\" priority=\"2\"/>"
                         "<ConnectionPointOut connectionPointOutId=\"3\" priority=\"1\"/>") +
        object("Sfc", "Transition", "",
               in("2") + out("4") +
                   "<Condition><TextualPredicate><PredicateContent xsi:type=\"ST\"><ST>n &gt; 100</ST>"
                   "</PredicateContent></TextualPredicate></Condition>") +
        object("Sfc", "Transition", "", in("3") + out("5") + "<Condition><Reference name=\"Ready\"/></Condition>") +
        object("Sfc", "Step", "name=\"Never\"", in("4") + out("6")) +
        object("Sfc", "Step", "name=\"Run\"",
               in("5") + out("7") + "<ConnectionPointOutAction connectionPointOutId=\"8\"/>") +
        object("Common", "ActionBlocks", "",
               in("8") + "<ActionBlock><ActionQualifier qualifier=\"N\"/><ReferenceName>Count</ReferenceName>"
                         "</ActionBlock><ActionBlock><ActionQualifier qualifier=\"P1\"/><Inline><BodyContent "
                         "xsi:type=\"ST\"><ST>entries := entries + 1;</ST></BodyContent></Inline></ActionBlock>") +
        object("Sfc", "Transition", "",
               in("7") + out("9") + "<Condition><GraphicalPredicate>" + in("2") +
                   "<GraphicalExpression xsi:type=\"LadderRung\" evaluationOrder=\"1\">" +
                   object("Ld", "LeftPowerRail", "", out("1")) +
                   object("Ld", "Contact", "operand=\"done\"", in("1") + out("2")) +
                   "</GraphicalExpression></GraphicalPredicate></Condition>") +
        object("Sfc", "Transition", "",
               in("6") + out("10") +
                   "<Condition><TextualPredicate><PredicateContent xsi:type=\"ST\"><ST>TRUE</ST></PredicateContent>"
                   "</TextualPredicate></Condition>") +
        object("Sfc", "Step", "name=\"End\"", in("10"));
    const Imported imported = import(project(program(
        "Main", vars(variable("n", "INT") + variable("entries", "INT") + variable("done", "BOOL")) +
                    body("SFC", chart) +
                    "<Action name=\"Count\"><Body><BodyContent xsi:type=\"ST\"><ST>n := n + 1;\ndone := n &gt;= 3;</ST>"
                    "</BodyContent></Body></Action><Transition name=\"Ready\"><Condition><PredicateContent "
                    "xsi:type=\"ST\"><ST>n &lt; 3</ST></PredicateContent></Condition></Transition>")));
    const std::string text = fileOf(imported, "src/Main.st");
    EXPECT_NE(text.find("TRANSITION (PRIORITY := 1) FROM Idle TO Run := n < 3; END_TRANSITION"), std::string::npos)
        << text;
    EXPECT_NE(text.find("TRANSITION FROM Run TO Idle := done; END_TRANSITION"), std::string::npos) << text;
    EXPECT_EQ(losses(imported), 0u) << imported.report.toText();
    EXPECT_EQ(valueAfter(imported, 20, "Main.n"), "4"); // an action runs once more when its step ends
    EXPECT_EQ(valueAfter(imported, 20, "Main.entries"), "1");
}

TEST_F(StandardXml, ReadsNamespacesMethodsAndInheritance) {
    const std::string method =
        "<Method name=\"Grow\" accessSpecifier=\"public\"><ResultType><TypeName>INT</TypeName></ResultType><Parameters>"
        "<InputVars><Variable name=\"amount\" "
        "orderWithinParamSet=\"0\"><Type><TypeName>INT</TypeName></Type></Variable>"
        "</InputVars></Parameters><Body><BodyContent xsi:type=\"ST\"><ST>size := size + amount;\nGrow := size;</ST>"
        "</BodyContent></Body></Method>";
    const Imported imported = import(
        project("<NamespaceDecl name=\"Lib\"><Interface name=\"I_Grow\"><Method name=\"Grow\"><ResultType><TypeName>INT"
                "</TypeName></ResultType><Parameters><InputVars><Variable name=\"amount\" "
                "orderWithinParamSet=\"0\"><Type><TypeName>"
                "INT</TypeName></Type></Variable></InputVars></Parameters></Method></Interface>"
                "<FunctionBlock name=\"Base\"><Implements><TypeName>I_Grow</TypeName></Implements><Vars "
                "accessSpecifier=\"public\">" +
                variable("size", "INT") + "</Vars>" + method +
                "</FunctionBlock><FunctionBlock name=\"Tank\"><Extends><TypeName>Base</TypeName></Extends>" +
                st("size := size + 1;") + "</FunctionBlock></NamespaceDecl>" +
                program("Main", vars(variable("tank", "Lib\\Tank") + variable("n", "INT")) +
                                    st("tank();\nn := tank.Grow(amount := 10);"))));
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(valueAfter(imported, 2, "Main.n"), "22");
    EXPECT_NE(fileOf(imported, "src/Tank.st").find("NAMESPACE Lib\nFUNCTION_BLOCK Tank EXTENDS Base"),
              std::string::npos);
    EXPECT_EQ(losses(imported), 0u) << imported.report.toText();
}

TEST_F(StandardXml, KeepsTheDeclarationThatAVendorWritesAsText) {
    const Imported imported = import(
        "<?xml version=\"1.0\"?><ppx:Program xmlns:ppx=\"www.iec.ch/public/TC65SC65BWG7TF10\" "
        "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" name=\"Main\"><ppx:AddData><ppx:Data "
        "name=\"http://example.org/PLC\" handleUnknown=\"implementation\"><textDeclaration><content>PROGRAM Main\n"
        "VAR\n    n : INT; // how many\nEND_VAR</content></textDeclaration></ppx:Data></ppx:AddData>"
        "<ppx:MainBody><ppx:BodyContent xsi:type=\"ppx:ST\"><ppx:ST>n := 3;</ppx:ST></ppx:BodyContent>"
        "</ppx:MainBody></ppx:Program>");
    EXPECT_EQ(fileOf(imported, "src/Main.st"),
              "PROGRAM Main\nVAR\n    n : INT; // how many\nEND_VAR\nn := 3;\nEND_PROGRAM\n");
    EXPECT_EQ(losses(imported), 0u) << imported.report.toText();
}

TEST_F(StandardXml, ReportsWhatHasNoPlace) {
    const Imported imported = import(project(program(
        "Main", vars(variable("x", "BOOL", "<Address address=\"X0\"/>") +
                     "<Variable name=\"y\"><AddData><Data name=\"u\" handleUnknown=\"discard\"><Published/></Data>"
                     "</AddData><Type><TypeName>BOOL</TypeName></Type></Variable>") +
                    st("y := x;"))));
    const std::string report = imported.report.toText();
    EXPECT_NE(report.find("document.xml:5: not kept: The element Address X0"), std::string::npos) << report;
    EXPECT_NE(report.find("The element Published"), std::string::npos) << report;
    EXPECT_EQ(errorsOf(imported), "");
}

// As Sysmac Studio writes it: tasks are not part of its files.
TEST_F(StandardXml, AConfigurationThatRunsNothingBecomesAList) {
    const Imported imported = import(
        project(program("Main", "<ExternalVars>" + variable("level", "INT") + "</ExternalVars>" + st("level := 7;")),
                "<Configuration name=\"Plc\"><Resource name=\"Res\" resourceTypeName=\"\"><GlobalVars>" +
                    variable("level", "INT") + "</GlobalVars></Resource></Configuration>"));
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(valueAfter(imported, 1, "level"), "7"); // Main runs although no instance of it is declared
}

} // namespace
} // namespace plc::exchange
