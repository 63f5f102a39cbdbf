// PLCopen XML in: every element of types, interfaces and configurations, bodies in ST and IL, what CODESYS adds, and
// XML that means harm.
#include "fixture.h"

#include "projects/exchange/base/durations.h"

namespace plc::exchange {
namespace {

class PlcopenImport : public ExchangeTest {};

TEST_F(PlcopenImport, ProgramInStructuredTextBecomesASourceFile) {
    const Imported imported = import(document(
        pou("Main", "program",
            "<localVars>" + variable("n", "<INT/>", "<initialValue><simpleValue value=\"5\"/></initialValue>") +
                "</localVars>",
            st("n := n + 1;&#xd;&#xa;IF n &gt; 9 THEN n := 0; END_IF;"))));
    EXPECT_EQ(fileOf(imported, "src/Main.st"),
              "PROGRAM Main\nVAR\n    n : INT := 5;\nEND_VAR\nn := n + 1;\nIF n > 9 THEN n := 0; "
              "END_IF;\nEND_PROGRAM\n");
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.name, "Plant");
    EXPECT_EQ(imported.report.losses(), 0u);
    EXPECT_EQ(imported.report.bodies.at("ST"), 1);
}

TEST_F(PlcopenImport, EveryTypeHasItsText) {
    struct Row {
        const char *xml, *text;
    };
    const Row rows[] = {
        {"<BOOL/>", "BOOL"},
        {"<LTIME/>", "LTIME"},
        {"<string/>", "STRING"},
        {"<string length=\"20\"/>", "STRING[20]"},
        {"<wstring length=\"7\"/>", "WSTRING[7]"},
        {"<derived name=\"Motor\"/>", "Motor"},
        {"<array><dimension lower=\"0\" upper=\"9\"/><dimension lower=\"-1\" "
         "upper=\"N\"/><baseType><INT/></baseType></array>",
         "ARRAY [0..9, -1..N] OF INT"},
        {"<pointer><baseType><REAL/></baseType></pointer>", "POINTER TO REAL"},
        {"<reference><baseType><REAL/></baseType></reference>", "REFERENCE TO REAL"},
        {"<subrangeSigned><range lower=\"-5\" upper=\"5\"/><baseType><INT/></baseType></subrangeSigned>",
         "INT (-5..5)"},
        {"<subrangeUnsigned><range lower=\"0\" upper=\"5\"/><baseType><UINT/></baseType></subrangeUnsigned>",
         "UINT (0..5)"},
    };
    for (const Row& row : rows) {
        const Imported imported = import(
            document(pou("P", "functionBlock", "<inputVars>" + variable("x", row.xml) + "</inputVars>", st(""))));
        EXPECT_EQ(fileOf(imported, "src/P.st"),
                  "FUNCTION_BLOCK P\nVAR_INPUT\n    x : " + std::string(row.text) + ";\nEND_VAR\nEND_FUNCTION_BLOCK\n");
    }
}

TEST_F(PlcopenImport, TypesKeepMembersValuesAndComments) {
    const std::string types =
        "<dataType name=\"Color\"><baseType><enum><values><value name=\"Red\" value=\"1\"/><value "
        "name=\"Blue\"/></values>"
        "<baseType><INT/></baseType></enum></baseType><initialValue><simpleValue "
        "value=\"Blue\"/></initialValue></dataType>"
        "<dataType name=\"Base\"><baseType><struct>" +
        variable("a", "<INT/>") +
        "</struct></baseType></dataType>"
        "<dataType name=\"Point\"><baseType><struct>" +
        variable("x", "<REAL/>",
                 "<initialValue><simpleValue "
                 "value=\"1.5\"/></initialValue><documentation><xhtml>across</xhtml></documentation>") +
        variable("list", "<array><dimension lower=\"0\" upper=\"4\"/><baseType><INT/></baseType></array>",
                 "<initialValue><arrayValue><value><simpleValue value=\"1\"/></value><value repetitionValue=\"4\">"
                 "<simpleValue value=\"2\"/></value></arrayValue></initialValue>") +
        "</struct></baseType><addData><data name=\"http://www.3s-software.com/plcopenxml/datatypeinheritance\" "
        "handleUnknown=\"implementation\"><Inheritance><Extends>Base</Extends></Inheritance></data></addData></"
        "dataType>";
    const Imported imported = import(document("", types));
    EXPECT_EQ(fileOf(imported, "src/Color.st"), "TYPE Color : (\n    Red := 1,\n    Blue\n) INT := Blue;\nEND_TYPE\n");
    EXPECT_EQ(
        fileOf(imported, "src/Point.st"),
        "TYPE Point EXTENDS Base :\nSTRUCT\n    x : REAL := 1.5; // across\n    list : ARRAY [0..4] OF INT := [1, "
        "4(2)];\nEND_STRUCT\nEND_TYPE\n");
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(PlcopenImport, SectionsKeepTheirQualifiersAndAddresses) {
    const std::string interface =
        "<inputVars>" + variable("i", "<INT/>") + "</inputVars><outputVars>" + variable("q", "<INT/>") +
        "</outputVars><inOutVars>" + variable("io", "<INT/>") + "</inOutVars><tempVars>" + variable("t", "<INT/>") +
        "</tempVars><localVars constant=\"true\">" +
        variable("c", "<INT/>", "<initialValue><simpleValue value=\"3\"/></initialValue>") +
        "</localVars><localVars retain=\"true\">" + variable("r", "<INT/>") +
        "</localVars><localVars persistent=\"true\" retain=\"true\">" + variable("p", "<INT/>") + "</localVars>";
    const Imported imported = import(document(
        pou("Fb", "functionBlock", interface, st("q := i;")) +
        pou("Main", "program",
            "<localVars><variable name=\"lamp\" address=\"%QX0.1\"><type><BOOL/></type></variable></localVars>",
            st("lamp := TRUE;"))));
    EXPECT_EQ(
        fileOf(imported, "src/Fb.st"),
        "FUNCTION_BLOCK Fb\nVAR_INPUT\n    i : INT;\nEND_VAR\nVAR_OUTPUT\n    q : INT;\nEND_VAR\nVAR_IN_OUT\n    io : "
        "INT;\nEND_VAR\nVAR_TEMP\n    t : INT;\nEND_VAR\nVAR CONSTANT\n    c : INT := 3;\nEND_VAR\nVAR RETAIN\n    r : "
        "INT;\nEND_VAR\nVAR RETAIN PERSISTENT\n    p : INT;\nEND_VAR\nq := i;\nEND_FUNCTION_BLOCK\n");
    EXPECT_NE(fileOf(imported, "src/Main.st").find("lamp AT %QX0.1 : BOOL;"), std::string::npos);
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(PlcopenImport, FunctionsActionsAndInstructionListsAreRead) {
    const Imported imported = import(document(
        pou("Twice", "function",
            "<returnType><INT/></returnType><inputVars>" + variable("x", "<INT/>") + "</inputVars>",
            "<IL><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">LD x\nADD x\nST Twice</xhtml></IL>") +
        pou("Main", "program", "<localVars>" + variable("n", "<INT/>") + "</localVars>", st("n := Twice(n); Clear();"),
            "<actions><action name=\"Clear\"><body>" + st("n := 0;") + "</body></action></actions>")));
    EXPECT_EQ(fileOf(imported, "src/Twice.st"),
              "FUNCTION Twice : INT\nVAR_INPUT\n    x : INT;\nEND_VAR\nLD x\nADD x\nST Twice\nEND_FUNCTION\n");
    EXPECT_NE(fileOf(imported, "src/Main.st").find("\n\nACTION Clear:\nn := 0;\nEND_ACTION\nEND_PROGRAM\n"),
              std::string::npos);
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.report.bodies.at("IL"), 1);
}

TEST_F(PlcopenImport, ParagraphsOfBeremizBecomeLines) {
    const Imported imported = import(
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\" "
        "xmlns:xhtml=\"http://www.w3.org/1999/xhtml\"><fileHeader "
        "productName=\"Beremiz\" productVersion=\"1\"/><contentHeader name=\"B\"/><types><dataTypes/><pous><pou "
        "name=\"M\" "
        "pouType=\"program\"><interface><localVars><variable name=\"n\" "
        "address=\"%MW1\"><type><INT/></type></variable></localVars>"
        "</interface><body><ST><xhtml:p><![CDATA[n := n < 5;\nn := 1;]]></xhtml:p></ST></body></pou></pous></types>"
        "<instances><configurations/></instances></project>");
    EXPECT_NE(fileOf(imported, "src/M.st").find("n := n < 5;\nn := 1;\nEND_PROGRAM"), std::string::npos);
    EXPECT_EQ(imported.addressing, image::Addressing::Words);
    EXPECT_EQ(toProject(imported).buildInput().addressing, image::Addressing::Words);
}

TEST_F(PlcopenImport, ProjectsOfBeremizAreKnownByTheirVersionWhateverTheirName) {
    const Imported imported = import(
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><fileHeader companyName=\"Unknown\" "
        "productName=\"Filling line\" productVersion=\"1\"/><contentHeader name=\"B\"/><types><dataTypes/><pous>" +
        pou("M", "program",
            "<localVars>" + variable("control", "<derived name=\"PID\"/>") +
                variable("n", "<derived name=\"HMI_INT\"/>") + variable("log", "<derived name=\"LOGGER\"/>") +
                "</localVars>",
            st("{if (ready()) __SET_VAR(data__-&gt;,N, 2)}\nlog(TRIG := n &gt; 3, LEVEL := DEBUG); n := %MW1;")) +
        "</pous></types><instances><configurations/></instances></project>");
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.addressing, image::Addressing::Words);
    EXPECT_NE(fileOf(imported, "src/M.st").find("(* C:if (ready()) __SET_VAR(data__->,N, 2)*)"), std::string::npos);
    EXPECT_EQ(imported.report.losses(), 3u);                        // the code in C, LOGGER and its levels
    EXPECT_EQ(imported.libraries, std::set<std::string>{"analog"}); // PID of Annex F
}

TEST_F(PlcopenImport, TheTextOfAStringMayHaveNoQuotationMarks) {
    const auto text = [](const char* name, const char* type, const char* value) {
        return "<variable name=\"" + std::string(name) + "\"><type><" + type +
               "/></type><initialValue><simpleValue value=\"" + value + "\"/></initialValue></variable>";
    };
    const Imported imported =
        import(document(pou("M", "program",
                            "<localVars>" + text("a", "string", "&quot;it's 5&quot;") + text("b", "string", "12") +
                                text("c", "string", "'as it is'") + text("d", "wstring", "&quot;wide&quot;") +
                                text("e", "INT", "12") + text("f", "string", "") + "</localVars>",
                            st("e := e + LEN(a);"))));
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_NE(fileOf(imported, "src/M.st")
                  .find("    a : STRING := '\"it$'s 5\"';\n    b : STRING := '12';\n    c : STRING := 'as it is';\n"
                        "    d : WSTRING := \"wide\";\n    e : INT := 12;\n    f : STRING;\n"),
              std::string::npos)
        << fileOf(imported, "src/M.st");
}

TEST_F(PlcopenImport, TypesForPanelsOfBeremizAreDeclared) {
    const Imported imported = import(document(pou("M", "program",
                                                  "<localVars>" + variable("n", "<derived name=\"HMI_INT\"/>") +
                                                      variable("o", "<derived name=\"HMI_NODE\"/>") + "</localVars>",
                                                  st("n := n + 1; o := n > 3;")),
                                              {}, "<configurations/>", {}, "Beremiz"));
    EXPECT_NE(fileOf(imported, "src/tool_types.st").find("TYPE\n    HMI_INT : INT;\n    HMI_NODE : BOOL;\nEND_TYPE"),
              std::string::npos);
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.report.losses(), 0u);
}

TEST_F(PlcopenImport, PlainTextOfCodesysWinsOverTheInterface) {
    const Imported imported = import(
        document(pou("Main", "program", "<localVars>" + variable("b", "<BOOL/>") + "</localVars>", st("b := TRUE;"),
                     "<addData><data name=\"http://www.3s-software.com/plcopenxml/interfaceasplaintext\" "
                     "handleUnknown=\"implementation\">"
                     "<InterfaceAsPlainText><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">// first\n{attribute "
                     "'x'}\nPROGRAM Main\nVAR\n\tb : BOOL; // lamp\nEND_VAR\n"
                     "</xhtml></InterfaceAsPlainText></data></addData>")));
    EXPECT_EQ(fileOf(imported, "src/Main.st"),
              "// first\n{attribute 'x'}\nPROGRAM Main\nVAR\n\tb : BOOL; // lamp\nEND_VAR\nb := TRUE;\nEND_PROGRAM\n");
}

TEST_F(PlcopenImport, MethodsPropertiesInheritanceAndModifiersOfCodesysAreRead) {
    const auto data = [](const std::string& name, const std::string& inner) {
        return "<data name=\"http://www.3s-software.com/plcopenxml/" + name + "\" handleUnknown=\"implementation\">" +
               inner + "</data>";
    };
    const std::string fb = pou(
        "Axis", "functionBlock",
        "<localVars>" + variable("v", "<REAL/>") + "</localVars><addData>" +
            data("pouinheritance", "<Inheritance><Extends>Base</Extends><Implements>IAxis</Implements></Inheritance>") +
            data("attributes", "<Attributes><Attribute Name=\"reflection\" Value=\"\"/></Attributes>") + "</addData>",
        st(""),
        "<addData>" +
            data("method", "<Method name=\"Go\" ObjectId=\"1\"><interface><returnType><BOOL/></returnType><inputVars>" +
                               variable("goal", "<REAL/>") + "</inputVars></interface><body>" +
                               st("v := goal;\nGo := TRUE;") + "</body></Method>") +
            data("method", "<Method name=\"Reset\" ObjectId=\"2\"><interface><addData>" +
                               data("accessmodifiers", "<AccessModifiers Private=\"true\"/>") +
                               "</addData></interface><body>" + st("v := 0;") + "</body></Method>") +
            data("property", "<Property name=\"Speed\" "
                             "ObjectId=\"3\"><interface><returnType><REAL/></returnType></"
                             "interface><GetAccessor><interface/><body>" +
                                 st("Speed := v;") + "</body></GetAccessor><SetAccessor><interface/><body>" +
                                 st("v := Speed;") + "</body></SetAccessor></Property>") +
            "</addData>");
    const std::string more =
        "<addData>" +
        data("interface", "<Interface name=\"IAxis\" ObjectId=\"9\"><Methods><Method name=\"Go\" "
                          "ObjectId=\"8\"><interface><returnType>"
                          "<BOOL/></returnType><inputVars>" +
                              variable("goal", "<REAL/>") + "</inputVars></interface></Method></Methods></Interface>") +
        "</addData>";
    const Imported imported =
        import(document(fb + pou("Base", "functionBlock", "", st("")), "", "<configurations/>", more));
    const std::string text = fileOf(imported, "src/Axis.st");
    EXPECT_TRUE(text.starts_with("{attribute 'reflection'}\nFUNCTION_BLOCK Axis EXTENDS Base IMPLEMENTS IAxis\n"))
        << text;
    EXPECT_NE(
        text.find("METHOD Go : BOOL\nVAR_INPUT\n    goal : REAL;\nEND_VAR\nv := goal;\nGo := TRUE;\nEND_METHOD\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("METHOD PRIVATE Reset\nv := 0;\nEND_METHOD\n"), std::string::npos) << text;
    EXPECT_NE(text.find("PROPERTY Speed : REAL\nGET\nSpeed := v;\nEND_GET\nSET\nv := Speed;\nEND_SET\nEND_PROPERTY\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(fileOf(imported, "src/IAxis.st"),
              "INTERFACE IAxis\n\nMETHOD Go : BOOL\nVAR_INPUT\n    goal : REAL;\nEND_VAR\nEND_METHOD\nEND_INTERFACE\n");
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
}

TEST_F(PlcopenImport, ConfigurationsTasksInstancesAndListsAreRead) {
    const std::string instances =
        "<configurations><configuration name=\"Plc\"><resource name=\"App\"><task name=\"Fast\" interval=\"PT0.05S\" "
        "priority=\"4\">"
        "<pouInstance name=\"Main\" typeName=\"\"/></task><task name=\"Slow\" priority=\"9\"><pouInstance "
        "name=\"Second\" typeName=\"Other\"/>"
        "<addData><data name=\"http://www.3s-software.com/plcopenxml/tasksettings\" "
        "handleUnknown=\"implementation\"><TaskSettings KindOfTask=\"Cyclic\" "
        "Interval=\"200\" IntervalUnit=\"ms\"><Watchdog Enabled=\"false\"/></TaskSettings></data></addData></task>"
        "<globalVars name=\"GVL\">" +
        variable("count", "<INT/>") + "</globalVars></resource></configuration></configurations>";
    const Imported imported = import(
        document(pou("Main", "program", "", st("count := 1;")) + pou("Other", "program", "", st(";")), "", instances));
    EXPECT_EQ(fileOf(imported, "src/configuration.st"),
              "CONFIGURATION Plc\n    RESOURCE App ON PLC\n        TASK Fast(INTERVAL := T#50ms, PRIORITY := 4);\n     "
              "   TASK Slow(INTERVAL := "
              "T#200ms, PRIORITY := 9);\n        PROGRAM Main WITH Fast : Main;\n        PROGRAM Second WITH Slow : "
              "Other;\n    "
              "END_RESOURCE\nEND_CONFIGURATION\n");
    EXPECT_EQ(fileOf(imported, "src/GVL.st"), "{gvl GVL}\nVAR_GLOBAL\n    count : INT;\nEND_VAR\n");
    EXPECT_EQ(errorsOf(imported), "");
}

// Beremiz writes the text of a STRING without quotation marks; the name of a constant is one word.
TEST_F(PlcopenImport, TextsWithoutQuotationMarksAreTexts) {
    const auto initial = [](const std::string& value) {
        return "<initialValue><simpleValue value=\"" + value + "\"/></initialValue>";
    };
    const Imported imported = import(document(pou("Main", "program",
                                                  "<localVars>" + variable("a", "<string/>", initial("two words")) +
                                                      variable("b", "<string/>", initial("'quoted words'")) +
                                                      variable("c", "<string/>", initial("TITLE")) +
                                                      variable("d", "<string/>", initial("12")) + "</localVars>",
                                                  st(";"))));
    const std::string text = fileOf(imported, "src/Main.st");
    EXPECT_NE(text.find("a : STRING := 'two words';"), std::string::npos) << text;
    EXPECT_NE(text.find("b : STRING := 'quoted words';"), std::string::npos) << text;
    EXPECT_NE(text.find("c : STRING := TITLE;"), std::string::npos) << text;
    EXPECT_NE(text.find("d : STRING := '12';"), std::string::npos) << text;
}

// CODESYS lists the program of its visualisation, which a library has.
TEST_F(PlcopenImport, ProgramsOfLibrariesStayOutOfTasks) {
    const std::string instances =
        "<configurations><configuration name=\"Plc\"><resource name=\"App\"><task name=\"Fast\" interval=\"PT0.05S\" "
        "priority=\"4\"><pouInstance name=\"Main\" typeName=\"\"/></task><task name=\"VISU_TASK\" "
        "priority=\"31\"><pouInstance name=\"VisuElems.Visu_Prg\" typeName=\"\"/></task></resource></configuration>"
        "</configurations>";
    const Imported imported = import(document(pou("Main", "program", "", st(";")), "", instances));
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.report.losses(), 1u) << imported.report.toText();
    EXPECT_NE(imported.report.toText().find("VISU_TASK runs VisuElems.Visu_Prg"), std::string::npos)
        << imported.report.toText();
}

// The bases of an interface are beside its methods, not in addData.
TEST_F(PlcopenImport, InterfacesKeepTheirBases) {
    const std::string interfaces =
        "<addData><data name=\"http://www.3s-software.com/plcopenxml/interface\" handleUnknown=\"implementation\">"
        "<Interface name=\"IStop\"><Methods><Method name=\"stop\"><interface/></Method></Methods></Interface></data>"
        "<data name=\"http://www.3s-software.com/plcopenxml/interface\" handleUnknown=\"implementation\">"
        "<Interface name=\"IDrive\"><Methods><Method name=\"go\"><interface/></Method></Methods><Inheritance><Extends>"
        "IStop</Extends></Inheritance></Interface></data></addData>";
    const Imported imported = import(document("", "", "<configurations/>", interfaces));
    EXPECT_EQ(fileOf(imported, "src/IDrive.st").find("INTERFACE IDrive EXTENDS IStop\n"), 0u)
        << fileOf(imported, "src/IDrive.st");
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(PlcopenImport, FoldersOfCodesysBecomeFolders) {
    const std::string structure =
        "<addData><data name=\"http://www.3s-software.com/plcopenxml/projectstructure\" "
        "handleUnknown=\"discard\"><ProjectStructure><Folder Name=\"Drives\">"
        "<Folder Name=\"X/Y\"><Object Name=\"Axis\" ObjectId=\"7\"/></Folder></Folder><Object Name=\"Main\" "
        "ObjectId=\"8\"/></ProjectStructure></data></addData>";
    const Imported imported =
        import(document(pou("Axis", "functionBlock", "", st("")) + pou("Main", "program", "", st("")), "",
                        "<configurations/>", structure));
    EXPECT_EQ(fileOf(imported, "src/Drives/X_Y/Axis.st"), "FUNCTION_BLOCK Axis\nEND_FUNCTION_BLOCK\n");
    fileOf(imported, "src/Main.st");
}

TEST_F(PlcopenImport, DurationsOfEveryFormAreRead) {
    struct Row {
        const char *text, *unit, *expected;
    };
    for (const Row& row : {Row{"PT0.05S", "", "T#50ms"}, Row{"PT1H2M", "", "T#1h2m"}, Row{"P1DT1S", "", "T#24h1s"},
                           Row{"t#20ms", "", "T#20ms"}, Row{"50", "ms", "T#50ms"}, Row{"10000", "us", "T#10ms"},
                           Row{"", "", ""}, Row{"PT", "", "T#0ms"}, Row{"Pfoo", "", ""}})
        EXPECT_EQ(durationText(row.text, row.unit), row.expected) << row.text;
}

TEST_F(PlcopenImport, VendorDataGoesToTheSideFileWithALine) {
    const Imported imported = import(document(pou(
        "Main", "program", "", st(""),
        "<addData><data name=\"http://example.org/colour\" handleUnknown=\"preserve\"><c>red</c></data></addData>")));
    ASSERT_EQ(imported.report.notes.size(), 1u) << imported.report.toText();
    EXPECT_EQ(imported.report.notes[0].kind, NoteKind::VendorDataKept);
    EXPECT_NE(imported.side["units"]["Main"]["data"]["http://example.org/colour"].get<std::string>().find("<c>red</c>"),
              std::string::npos);
}

TEST_F(PlcopenImport, HostileXmlIsRefusedWithPlaceAndReason) {
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "<a>";
    struct Row {
        std::string document;
        const char* message;
    };
    const Row rows[] = {
        {"<!DOCTYPE p [<!ENTITY a \"x\">]><project>&a;</project>", "document type"},
        {"<?xml version=\"1.0\"?>\n<!DOCTYPE p SYSTEM \"file:///etc/passwd\"><project/>", "document type"},
        {"<project>" + deep, "nested too deeply"},
        {"<project><a></project>", "not well-formed"},
        {"<?xml version=\"1.0\" encoding=\"EBCDIC\"?><project/>", "EBCDIC"},
        {"<html><body/></html>", "neither PLCopen XML"},
        {"", "The file is empty"},
        {"PK\x03\x04", "ZIP archive"},
        {std::string("\0\1\2binary", 9), "This file cannot be imported"},
    };
    for (const Row& row : rows) {
        const auto imported = importFrom(write("bad.xml", row.document));
        ASSERT_FALSE(imported) << row.message;
        EXPECT_NE(imported.error().english().find(row.message), std::string::npos) << imported.error().english();
        EXPECT_NE(imported.error().place.find("bad.xml"), std::string::npos) << imported.error().english();
    }
}

TEST_F(PlcopenImport, OtherEncodingsAreReadWithANote) {
    std::string document = this->document(pou("Main", "program", "", st("// \xE9")));
    const Imported latin = import(document);
    EXPECT_NE(fileOf(latin, "src/Main.st").find("// \xC3\xA9"), std::string::npos);
    ASSERT_EQ(latin.report.notes.size(), 1u);
    EXPECT_EQ(latin.report.notes[0].kind, NoteKind::EncodingGuessed); // it says UTF-8
    std::string wide = "\xFF\xFE";
    for (const char c : this->document(pou("Main", "program", "", st("// e")))) wide += c, wide += '\0';
    EXPECT_NE(fileOf(import(wide), "src/Main.st").find("// e"), std::string::npos);
}

TEST_F(PlcopenImport, AProjectIsWrittenOnceAndNeverOverAnother) {
    const Imported imported = import(document(pou("Main", "program", "", st(""))));
    ASSERT_TRUE(writeImported(imported, path("new")));
    EXPECT_EQ(read(path("new/src/Main.st")), "PROGRAM Main\nEND_PROGRAM\n");
    const auto again = writeImported(imported, path("new"));
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().message.english().find("not empty"), std::string::npos);
}

} // namespace
} // namespace plc::exchange
