// Files of TwinCAT, the native export of CODESYS V3, text of CODESYS 2.3 and loose ST in.
#include "fixture.h"

#include "projects/exchange/plcopen/plcopen_export.h"
#include "projects/storage/project_file.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <set>

namespace plc::exchange {
namespace {

class OtherFormats : public ExchangeTest {
protected:
    static std::string object(const std::string& inner) {
        return "\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n<TcPlcObject Version=\"1.1.0.1\">\r\n" +
               inner + "\r\n</TcPlcObject>";
    }
    static std::string cdata(const std::string& tag, const std::string& text) {
        return "<" + tag + "><![CDATA[" + text + "]]></" + tag + ">";
    }
    static std::string st(const std::string& text) {
        return "<Implementation>" + cdata("ST", text) + "</Implementation>";
    }
    /// The program after its first scan; null if it does not build or the scan faults.
    static std::unique_ptr<controller::Controller> scanned(const Imported& imported) {
        jit::setRuntimeSymbols(controller::runtimeSymbols());
        const driver::Built built = driver::build(toProject(imported).buildInput());
        if (!built.program) return nullptr;
        auto controller = std::make_unique<controller::Controller>(built.program);
        controller->start();
        return controller->scan() ? std::move(controller) : nullptr;
    }
    static std::string textOf(const controller::Controller& controller, const std::string& name) {
        const auto value = controller.read("MAIN." + name);
        const auto* text = value ? std::get_if<std::string>(&value->data) : nullptr;
        return text ? *text : "no text";
    }
};

TEST_F(OtherFormats, ALibraryAndTheProjectThatUsesItBecomeOneProject) {
    const auto project = [](const std::string& name, const std::string& file) {
        return "<?xml version=\"1.0\"?><Project xmlns=\"http://schemas.microsoft.com/developer/msbuild/2003\">"
               "<PropertyGroup><Name>" +
               name + "</Name><DefaultNamespace>" + name +
               "</DefaultNamespace></PropertyGroup><ItemGroup><Compile Include=\"" + file +
               "\"/></ItemGroup></Project>";
    };
    write("tree/Core/Core.plcproj", project("Core", "FB_Task.TcPOU"));
    write("tree/Core/FB_Task.TcPOU",
          object("<POU Name=\"FB_Task\">" +
                 cdata("Declaration", "FUNCTION_BLOCK FB_Task\r\nVAR_OUTPUT\r\n\tn : INT;\r\nEND_VAR\r\n") +
                 st("n := n + 1;") + "</POU>"));
    write("tree/App/App.plcproj", project("App", "MAIN.TcPOU"));
    write(
        "tree/App/MAIN.TcPOU",
        object("<POU Name=\"MAIN\">" +
               cdata("Declaration",
                     "PROGRAM MAIN\r\nVAR\r\n\ttask : Core.FB_Task;\r\n\tn : INT; // of Core.FB_Task\r\nEND_VAR\r\n") +
               st("task();\r\nn := task.n;") + "</POU>"));
    const Imported imported = folder("tree");
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.report.losses(), 0u);
    EXPECT_NE(fileOf(imported, "src/App/MAIN.st").find("task : FB_Task;\n\tn : INT; // of Core.FB_Task"),
              std::string::npos)
        << fileOf(imported, "src/App/MAIN.st");
}

TEST_F(OtherFormats, AReferenceMayGiveALibraryAnotherNamespace) {
    const auto project = [](const std::string& name, const std::string& more) {
        return "<?xml version=\"1.0\"?><Project xmlns=\"http://schemas.microsoft.com/developer/msbuild/2003\">"
               "<PropertyGroup><Name>" +
               name + "</Name></PropertyGroup><ItemGroup>" + more + "</ItemGroup></Project>";
    };
    write("tree/Core/My_Core.plcproj", project("My_Core", ""));
    write("tree/Core/FB_Task.TcPOU", object("<POU Name=\"FB_Task\">" +
                                            cdata("Declaration", "FUNCTION_BLOCK FB_Task\r\nVAR_OUTPUT\r\n\tn : INT;"
                                                                 "\r\nEND_VAR\r\n") +
                                            st("n := n + 1;") + "</POU>"));
    write("tree/App/App.plcproj", project("App", "<PlaceholderReference Include=\"My_Core\"><Namespace>Core</Namespace>"
                                                 "</PlaceholderReference>"));
    write("tree/App/MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\r\nVAR\r\n\ttask : Core.FB_Task;\r\nEND_VAR\r\n") + st("task();") +
                 "</POU>"));
    EXPECT_EQ(errorsOf(folder("tree")), "");
}

TEST_F(OtherFormats, ATwinCatTreeBecomesAProjectWithFoldersTasksAndMembers) {
    write("tc/P/P.plcproj",
          "<?xml version=\"1.0\"?><Project "
          "xmlns=\"http://schemas.microsoft.com/developer/msbuild/2003\"><PropertyGroup><Name>Cell</Name></"
          "PropertyGroup><ItemGroup>"
          "<Compile Include=\"POUs\\Drive\\FB_Axis.TcPOU\"/><Compile Include=\"POUs\\FB_Base.TcPOU\"/>"
          "<Compile Include=\"POUs\\MAIN.TcPOU\"/><Compile Include=\"I%5fAxis.TcIO\"/>"
          "<Compile Include=\"DUTs\\ST_Point.TcDUT\"/><Compile Include=\"GVL.TcGVL\"/>"
          "<Compile Include=\"PlcTask.TcTTO\"/></ItemGroup><ItemGroup><PlaceholderReference "
          "Include=\"Tc2_Standard\"/><PlaceholderReference Include=\"Tc2_MC2\"/></ItemGroup></Project>");
    write("tc/P/POUs/Drive/FB_Axis.TcPOU",
          object("<POU Name=\"FB_Axis\" Id=\"{1}\" SpecialFunc=\"None\">" +
                 cdata("Declaration",
                       "// moves\r\nFUNCTION_BLOCK FB_Axis EXTENDS FB_Base\r\nVAR\r\n\tv : REAL;\r\nEND_VAR\r\n") +
                 st("v := v + 1;\r\nLimit();") + "<Method Name=\"Stop\" Id=\"{2}\">" +
                 cdata("Declaration", "METHOD PUBLIC Stop : BOOL\r\nVAR_INPUT\r\n\thard : BOOL;\r\nEND_VAR\r\n") +
                 st("v := 0;\r\nStop := hard;") +
                 "</Method>"
                 "<Property Name=\"Speed\" Id=\"{3}\">" +
                 cdata("Declaration", "PROPERTY PUBLIC Speed : REAL\r\n") + "<Get Name=\"Get\" Id=\"{4}\">" +
                 cdata("Declaration", "VAR\r\nEND_VAR\r\n") + st("Speed := v;") +
                 "</Get><Set Name=\"Set\" Id=\"{5}\">" + cdata("Declaration", "VAR\r\nEND_VAR\r\n") +
                 st("v := Speed;") + "</Set></Property><Action Name=\"Limit\" Id=\"{6}\">" + st("v := MIN(v, 10.0);") +
                 "</Action></POU>"));
    write("tc/P/POUs/FB_Base.TcPOU",
          object("<POU Name=\"FB_Base\">" +
                 cdata("Declaration", "FUNCTION_BLOCK FB_Base IMPLEMENTS I_Axis\r\nVAR\r\nEND_VAR\r\n") + st("") +
                 "<Method Name=\"Go\">" + cdata("Declaration", "METHOD Go : BOOL\r\n") + st("Go := TRUE;") +
                 "</Method></POU>"));
    write("tc/P/POUs/MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\r\nVAR\r\n\taxis : FB_Axis;\r\nEND_VAR\r\n") +
                 st("axis();\r\nGVL.n := GVL.n + 1;") + "</POU>"));
    write("tc/P/I_Axis.TcIO",
          object("<Itf Name=\"I_Axis\">" + cdata("Declaration", "INTERFACE I_Axis\r\n") + "<Method Name=\"Go\">" +
                 cdata("Declaration", "METHOD Go : BOOL\r\n") + "</Method></Itf>"));
    write("tc/P/DUTs/ST_Point.TcDUT",
          object("<DUT Name=\"ST_Point\">" +
                 cdata("Declaration", "TYPE ST_Point :\r\nSTRUCT\r\n\tx : REAL;\r\nEND_STRUCT\r\nEND_TYPE\r\n") +
                 "</DUT>"));
    write("tc/P/GVL.TcGVL",
          object("<GVL Name=\"GVL\">" +
                 cdata("Declaration", "{attribute 'qualified_only'}\r\nVAR_GLOBAL\r\n\tn : INT;\r\nEND_VAR\r\n") +
                 "</GVL>"));
    write("tc/P/PlcTask.TcTTO", object("<Task "
                                       "Name=\"PlcTask\"><CycleTime>10000</CycleTime><Priority>20</"
                                       "Priority><PouCall><Name>MAIN</Name></PouCall></Task>"));
    const Imported imported = folder("tc");
    EXPECT_EQ(imported.name, "Cell");
    EXPECT_EQ(
        fileOf(imported, "src/POUs/Drive/FB_Axis.st"),
        "// moves\nFUNCTION_BLOCK FB_Axis EXTENDS FB_Base\nVAR\n\tv : REAL;\nEND_VAR\nv := v + 1;\nLimit();\n\nMETHOD "
        "PUBLIC Stop : BOOL\nVAR_INPUT\n\thard : BOOL;\nEND_VAR\nv := 0;\nStop := hard;\nEND_METHOD\n\n"
        "PROPERTY PUBLIC Speed : REAL\nGET\nVAR\nEND_VAR\nSpeed := v;\nEND_GET\nSET\nVAR\nEND_VAR\nv := "
        "Speed;\nEND_SET\nEND_PROPERTY\n\nACTION Limit:\nv := MIN(v, 10.0);\nEND_ACTION\nEND_FUNCTION_BLOCK\n");
    EXPECT_EQ(fileOf(imported, "src/GVL.st"),
              "{gvl GVL}\n{attribute 'qualified_only'}\nVAR_GLOBAL\n\tn : INT;\nEND_VAR\n");
    EXPECT_NE(fileOf(imported, "src/configuration.st")
                  .find("TASK PlcTask(INTERVAL := T#10ms, PRIORITY := 20);\n        PROGRAM MAIN WITH PlcTask : MAIN;"),
              std::string::npos);
    EXPECT_EQ(errorsOf(imported), "");
    ASSERT_EQ(imported.report.notes.size(), 1u) << imported.report.toText();
    EXPECT_EQ(imported.report.notes[0].kind, NoteKind::LibraryUnknown);
}

TEST_F(OtherFormats, FunctionsOfTwinCatsLibrariesAreWrittenBesideTheProject) {
    write("MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\nVAR\n\tr : LREAL;\n\ts : STRING;\n\tok : BOOL;\nEND_VAR\n") +
                 st("r := LMOD(7.5, 2.0);\ns := F_LTrim(F_RTrim('  a '));\nok := FAILED(-1) AND SUCCEEDED(1);") +
                 "</POU>"));
    const Imported imported = folder("MAIN.TcPOU");
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.report.losses(), 0u);
    EXPECT_EQ(imported.files.size(), 6u);
}

TEST_F(OtherFormats, ADrawnBodyOfTwinCatHasItsLineAndIsKept) {
    write("x/P.TcPOU", object("<POU Name=\"P\">" + cdata("Declaration", "PROGRAM P\nVAR\nEND_VAR\n") +
                              "<Implementation><NWL><XmlArchive><Data/></XmlArchive></NWL></Implementation></POU>"));
    const Imported imported = folder("x");
    ASSERT_EQ(imported.report.losses(), 1u);
    EXPECT_EQ(imported.report.notes[0].kind, NoteKind::ArchiveBody);
    EXPECT_NE(imported.side["units"]["P"]["archive"].get<std::string>().find("<XmlArchive>"), std::string::npos);
}

TEST_F(OtherFormats, DamagedFilesOfATreeAreLinesTheOthersAreRead) {
    write("d/Good.TcPOU",
          object("<POU Name=\"Good\">" + cdata("Declaration", "PROGRAM Good\nVAR\nEND_VAR\n") + st("") + "</POU>"));
    write("d/Bad.TcPOU", "<?xml version=\"1.0\"?><TcPlcObject><POU Name=");
    write("d/Empty.TcPOU", "");
    const Imported imported = folder("d");
    EXPECT_EQ(imported.files.size(), 1u);
    EXPECT_EQ(imported.report.losses(), 2u) << imported.report.toText();
}

TEST_F(OtherFormats, TextOfCodesys2IsReadWithItsFoldersAndLists) {
    write(
        "c2/all.EXP",
        "\r\n(* @NESTEDCOMMENTS := 'Yes' *)\r\n(* @PATH := '\\/Drives\\/X' *)\r\n(* @OBJECTFLAGS := '0, 8' "
        "*)\r\nFUNCTION_BLOCK Fb\r\nVAR_INPUT\r\n\tx : INT;\r\nEND_VAR\r\n(* @END_DECLARATION := '0' *)\r\nx := 1; (* "
        "caf\xE9 *)\r\nEND_FUNCTION_BLOCK\r\n"
        "ACTION Reset:\r\nx := 0;\r\nEND_ACTION\r\n\r\n\r\n(* @NESTEDCOMMENTS := 'Yes' *)\r\n(* @PATH := '' *)\r\nTYPE "
        "Color : (Red, Blue);\r\nEND_TYPE\r\n(* @END_DECLARATION := '0' *)\r\n\r\n(* @NESTEDCOMMENTS := 'Yes' *)\r\n"
        "(* @GLOBAL_VARIABLE_LIST := 'Global_Variables' *)\r\n(* @PATH := '' *)\r\nVAR_GLOBAL\r\n\tc : "
        "Color;\r\nEND_VAR\r\n\r\n(* @OBJECT_END := 'Global_Variables' *)\r\n"
        "PROGRAM Main\r\nVAR\r\n\tf : Fb;\r\nEND_VAR\r\n(* @END_DECLARATION := '0' *)\r\n\tLD 1\r\n\tST "
        "f.x\r\nEND_PROGRAM\r\n"
        "PROGRAM Drawn\r\nVAR\r\nEND_VAR\r\n(* @END_DECLARATION := '0' *)\r\n_LD_BODY\r\n_NETWORKS : "
        "1\r\n_NETWORK\r\nEND_PROGRAM\r\n");
    const Imported imported = folder("c2");
    EXPECT_EQ(fileOf(imported, "src/Drives/X/Fb.st"),
              "FUNCTION_BLOCK Fb\nVAR_INPUT\n\tx : INT;\nEND_VAR\nx := 1; (* caf\xC3\xA9 "
              "*)\nEND_FUNCTION_BLOCK\n\nACTION Reset:\nx := 0;\nEND_ACTION\n");
    EXPECT_EQ(fileOf(imported, "src/Global_Variables.st"),
              "{gvl Global_Variables}\nVAR_GLOBAL\n\tc : Color;\nEND_VAR\n");
    fileOf(imported, "src/Color.st");
    fileOf(imported, "src/Main.st");
    EXPECT_EQ(fileOf(imported, "src/Drawn.st"), "PROGRAM Drawn\nVAR\nEND_VAR\nEND_PROGRAM\n");
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.report.losses(), 1u) << imported.report.toText();
}

TEST_F(OtherFormats, TheNativeExportOfCodesys3IsRead) {
    const auto entry = [](const std::string& name, const std::string& guid, const std::string& parent,
                          const std::string& declaration, const std::string& body) {
        const auto document = [](const std::string& text) {
            return "<Single Name=\"TextDocument\" Type=\"{t}\"><Single Name=\"TextBlobForSerialisation\" "
                   "Type=\"string\">" +
                   text + "</Single></Single>";
        };
        return "<Single Type=\"{e}\" Method=\"IArchivable\"><Single Name=\"MetaObject\" Type=\"{m}\"><Single "
               "Name=\"Guid\" Type=\"System.Guid\">" +
               guid + "</Single><Single Name=\"ParentGuid\" Type=\"System.Guid\">" + parent +
               "</Single><Single Name=\"Name\" Type=\"string\">" + name +
               "</Single></Single><Single Name=\"Object\" Type=\"{o}\"><Single Name=\"Interface\" Type=\"{i}\">" +
               document(declaration) + "</Single>" +
               (body.empty() ? "" : "<Single Name=\"Implementation\" Type=\"{b}\">" + document(body) + "</Single>") +
               "</Single></Single>";
    };
    write("v3/all.export", "<ExportFile><StructuredView Guid=\"{g}\"><Single xml:space=\"preserve\" Type=\"{s}\" "
                           "Method=\"IArchivable\"><List2 Name=\"EntryList\">" +
                               entry("Fb", "1", "0", "FUNCTION_BLOCK Fb\nVAR\n\tn : INT;\nEND_VAR\n", "n := n + 1;") +
                               entry("Twice", "2", "1", "METHOD Twice : INT\n", "Twice := 2 * n;") +
                               entry("Color", "3", "0", "TYPE Color : (Red, Blue); END_TYPE", "") +
                               "</List2></Single></StructuredView></ExportFile>");
    const Imported imported = folder("v3");
    EXPECT_EQ(fileOf(imported, "src/Fb.st"), "FUNCTION_BLOCK Fb\nVAR\n\tn : INT;\nEND_VAR\nn := n + 1;\n\nMETHOD Twice "
                                             ": INT\nTwice := 2 * n;\nEND_METHOD\nEND_FUNCTION_BLOCK\n");
    EXPECT_EQ(fileOf(imported, "src/Color.st"), "TYPE Color : (Red, Blue); END_TYPE\n");
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(OtherFormats, LooseTextKeepsCodeInCAsAComment) {
    write("st/a.st", "PROGRAM P\nVAR\n  n : INT;\nEND_VAR\n{{ n = 1; /* (* x *) */ }}\nn := 2;\nEND_PROGRAM\n");
    const Imported imported = folder("st");
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_NE(fileOf(imported, "src/a.st").find("(* C: n = 1; /* ( * x * ) */ *)"), std::string::npos)
        << fileOf(imported, "src/a.st");
    EXPECT_EQ(imported.report.notes[0].kind, NoteKind::CodeSkipped);
}

TEST_F(OtherFormats, XmlIsNeverReadAsStructuredText) {
    write("x.st", "<?xml version=\"1.0\"?><TcPlcObject/>");
    const auto project = projects::openProject({path("x.st")});
    ASSERT_FALSE(project);
    EXPECT_NE(project.error().message.english().find("This is XML"), std::string::npos);
    write("p.xml", "<project/>");
    write("p.st", "PROGRAM P\nEND_PROGRAM\n");
    write("p.TcPOU", "");
    EXPECT_TRUE(isForeignFile(path("p.xml")));
    EXPECT_TRUE(isForeignFile(path("p.TcPOU")));
    EXPECT_FALSE(isForeignFile(path("p.st")));
    EXPECT_FALSE(isForeignFile(path("gone.TcPOU")));
}

TEST_F(OtherFormats, SourcesInFoldersBelongToTheProject) {
    write("f/project.json", "{}");
    write("f/src/b.st", "PROGRAM B\nEND_PROGRAM\n");
    write("f/src/deep/er/a.st", "PROGRAM A\nEND_PROGRAM\n");
    write("f/src/.hidden/c.st", "PROGRAM C\nEND_PROGRAM\n");
    const auto project = projects::openProject({path("f")});
    ASSERT_TRUE(project);
    ASSERT_EQ(project->sources.size(), 2u);
    EXPECT_EQ(project->sources[0].path, "src/b.st");
    EXPECT_EQ(project->sources[1].path, "src/deep/er/a.st");
}

TEST_F(OtherFormats, LaddersOfCodesys2BecomeText) {
    const Imported imported = folder(write(
        "rung.EXP",
        "(* @NESTEDCOMMENTS := 'Yes' *)\n(* @PATH := '' *)\nPROGRAM Rung\nVAR\n\ta, b, c, y, s : BOOL;\nEND_VAR\n"
        "(* @END_DECLARATION := '0' *)\n_LD_BODY\n_NETWORKS : 2\n_NETWORK\n\n_COMMENT\n'the first'\n_END_COMMENT\n"
        "_LD_ASSIGN\n_LD_AND\n_LD_OPERATOR : 2\n_LD_CONTACT\na\n_EXPRESSION\n_POSITIV\n_LD_OR\n_LD_OPERATOR : 2\n"
        "_LD_CONTACT\nb\n_EXPRESSION\n_NEGATIV\n_LD_CONTACT\nc\n_EXPRESSION\n_POSITIV\n_EXPRESSION\n_POSITIV\n"
        "_EXPRESSION\n_POSITIV\n_EXPRESSION\n_POSITIV\n\n\nENABLELIST : 0\nENABLELIST_END\n_OUTPUTS : 1\n_OUTPUT\n"
        "_POSITIV\n_NO_SET\ny\n_NETWORK\n\n_COMMENT\n''\n_END_COMMENT\n_LD_ASSIGN\n_EMPTY\n_EXPRESSION\n_POSITIV\n"
        "ENABLELIST : 0\nENABLELIST_END\n_OUTPUTS : 1\n_OUTPUT\n_POSITIV\n_SET\ns\nEND_PROGRAM\n"));
    const std::string text = fileOf(imported, "src/Rung.st");
    EXPECT_NE(text.find("// the first\ny := a AND NOT b OR a AND c;\ns S= TRUE;\nEND_PROGRAM"), std::string::npos)
        << text;
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_EQ(errorsOf(imported), "");
}

/// Lines of an export: an operand, and an output with what takes it.
std::string exportOperand(const std::string& text) { return "_OPERAND\n_EXPRESSION\n_POSITIV\n" + text + "\n"; }
std::string exportOutput(const std::string& text, const char* marks = "_POSITIV\n_NO_SET") {
    return "_OUTPUT\n" + std::string(marks) + "\n" + text + "\n";
}
std::string exportUnit(const std::string& head, const std::string& variables, const std::string& body,
                       const std::string& end) {
    return "(* @NESTEDCOMMENTS := 'Yes' *)\n(* @PATH := '' *)\n" + head + "\nVAR\n" + variables +
           "END_VAR\n(* @END_DECLARATION := '0' *)\n" + body + end + "\n";
}

TEST_F(OtherFormats, BlocksOfCodesys2AreCalledWithTheNamesOfTheirPins) {
    const Imported imported = folder(write(
        "blocks.EXP",
        exportUnit("PROGRAM Blocks", "\tt : TON; own : Scale;\n\tgo, y, r : BOOL; et : TIME; n, high : INT;\n",
                   "_FBD_BODY\n_NETWORKS : 3\n_NETWORK\n_COMMENT\n''\n_END_COMMENT\n_ASSIGN\n_FUNCTIONBLOCK\nt\n"
                   "_BOX_EXPR : 2\n" +
                       exportOperand("go") + exportOperand("T#2s") + "_EXPRESSION\n_POSITIV\nTON\n_OUTPUTS : 1\n" +
                       exportOutput("et") + "_EXPRESSION\n_POSITIV\n_OUTPUTS : 2\n" + exportOutput("y") +
                       exportOutput("r", "_NEGATIV\n_SET") +
                       "_NETWORK\n_COMMENT\n''\n_END_COMMENT\n_ASSIGN\n_FUNCTIONBLOCK\nown\n_BOX_EXPR : 2\n" +
                       exportOperand("n") + exportOperand("???") + "_EXPRESSION\n_POSITIV\nScale\n_OUTPUTS : 1\n" +
                       exportOutput("???") + "_EXPRESSION\n_POSITIV\n_OUTPUTS : 1\n" + exportOutput("high") +
                       "_NETWORK\n_COMMENT\n''\n_END_COMMENT\n_FUNCTION\n_BOX_EXPR : 1\n" + exportOperand("n") +
                       "_EXPRESSION\n_POSITIV\nNote\n",
                   "END_PROGRAM") +
            "(* @PATH := '' *)\nFUNCTION_BLOCK Scale\nVAR_INPUT\n\tin, factor : INT;\nEND_VAR\nVAR_OUTPUT\n"
            "\tout : INT; (* scaled *)\n\tbad : BOOL;\nEND_VAR\n(* @END_DECLARATION := '0' *)\nout := in;\n"
            "END_FUNCTION_BLOCK\n(* @PATH := '' *)\nFUNCTION Note : BOOL\nVAR_INPUT\n\tvalue : INT;\nEND_VAR\n"
            "(* @END_DECLARATION := '0' *)\nNote := value > 0;\nEND_FUNCTION\n"));
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    const std::string text = fileOf(imported, "src/Blocks.st");
    EXPECT_NE(text.find("t(IN := go, PT := T#2s);\net := t.ET;\ny := t.Q;\nr R= t.Q;\nown(in := n);\n"
                        "high := own.out;\nNote(n);\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(OtherFormats, ABlockInALadderOfCodesys2TakesThePower) {
    const Imported imported = folder(write(
        "timer.EXP",
        exportUnit("PROGRAM Timer", "\tt : TON; go, y : BOOL;\n",
                   "_LD_BODY\n_NETWORKS : 1\n_NETWORK\n_COMMENT\n''\n_END_COMMENT\n_LD_ASSIGN\n_LD_AND\n"
                   "_LD_OPERATOR : 2\n_LD_CONTACT\ngo\n_EXPRESSION\n_POSITIV\n_FUNCTIONBLOCK\nt\n_BOX_EXPR : 2\n"
                   "_EMPTY\n" +
                       exportOperand("T#1s") + "_EXPRESSION\n_POSITIV\nTON\n_OUTPUTS : 1\n" + exportOutput("_EMPTY") +
                       "_EXPRESSION\n_POSITIV\n_EXPRESSION\n_POSITIV\nENABLELIST : 0\nENABLELIST_END\n_OUTPUTS : 1\n" +
                       exportOutput("y"),
                   "END_PROGRAM")));
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_NE(fileOf(imported, "src/Timer.st").find("t(IN := go, PT := T#1s);\ny := t.Q;\n"), std::string::npos)
        << fileOf(imported, "src/Timer.st");
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(OtherFormats, ABlockOfCodesys2WhosePinsNobodyKnowsIsKeptWithItsLine) {
    const Imported imported = folder(
        write("foreign.EXP", exportUnit("PROGRAM Foreign", "\tf : Elsewhere; a, y : BOOL;\n",
                                        "_FBD_BODY\n_NETWORKS : 1\n_NETWORK\n_COMMENT\n''\n_END_COMMENT\n_ASSIGN\n"
                                        "_FUNCTIONBLOCK\nf\n_BOX_EXPR : 1\n" +
                                            exportOperand("a") + "_EXPRESSION\n_POSITIV\nElsewhere\n_OUTPUTS : 0\n" +
                                            "_EXPRESSION\n_POSITIV\n_OUTPUTS : 1\n" + exportOutput("y"),
                                        "END_PROGRAM")));
    EXPECT_EQ(imported.report.losses(), 1u) << imported.report.toText();
    EXPECT_FALSE(imported.side["units"]["Foreign"]["archive"].empty());
}

TEST_F(OtherFormats, ChartsOfCodesys2AreTextWithTheirActions) {
    const Imported imported = folder(write(
        "chart.EXP", exportUnit("PROGRAM Chart", "\tn : INT;\n",
                                "INITIAL_STEP Init:\n    Count(N);\nEND_STEP\nTRANSITION FROM Init TO Init := n > 3;\n"
                                "END_TRANSITION\nACTION Count:\nn := n + 1;\nEND_ACTION\n",
                                "END_PROGRAM")));
    EXPECT_EQ(errorsOf(imported), "");
    const std::string text = fileOf(imported, "src/Chart.st");
    EXPECT_NE(text.find("END_ACTION\nEND_PROGRAM"), std::string::npos) << text;
}

TEST_F(OtherFormats, ADrawnChartOfCodesys2KeepsItsDeclarationWithALine) {
    const Imported imported =
        folder(write("drawn.EXP", exportUnit("PROGRAM Drawn", "\tn : INT;\n", "_SFC_BODY\n_STEP\nInit\n_END_STEP\n",
                                             "END_PROGRAM")));
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_NE(fileOf(imported, "src/Drawn.st").find("n : INT;"), std::string::npos);
    EXPECT_EQ(imported.report.bodies.count("SFC"), 1u);
    ASSERT_EQ(imported.report.losses(), 1u) << imported.report.toText();
    EXPECT_FALSE(imported.side["units"]["Drawn"]["archive"].empty());
}

TEST_F(OtherFormats, AddressesAreCountedAsTheToolDoesAndGoOutInWords) {
    const Imported imported = folder(write(
        "words.EXP", "(* @NESTEDCOMMENTS := 'Yes' *)\n(* @PATH := '' *)\nPROGRAM Words\nVAR\n\ta AT %MW1 : WORD;\n"
                     "\tb AT %MW2 : WORD;\nEND_VAR\n(* @END_DECLARATION := '0' *)\na := b;\nEND_PROGRAM\n"));
    EXPECT_EQ(imported.addressing, image::Addressing::Words);
    ASSERT_TRUE(writeImported(imported, path("out")));
    EXPECT_NE(read(path("out/project.json")).find("\"addressing\": \"word\""), std::string::npos);
    const auto project = projects::openProject({path("out")});
    ASSERT_TRUE(project) << project.error().english();
    EXPECT_EQ(project->buildInput().addressing, image::Addressing::Words);
    const driver::Checked checked = driver::check(project->buildInput());
    EXPECT_TRUE(checked.analysis->diagnostics.empty()); // no overlap

    projects::Project bytes = *project;
    bytes.addressing = image::Addressing::Bytes;
    bytes.sources = {{"src/p.st",
                      "PROGRAM P\nVAR\n    a AT %MW4 : WORD;\n    b AT %MW7 : WORD;\n    c AT %MX3.1 : BOOL;\n"
                      "END_VAR\na := %MW10; // %MW12\nb := 1;\nc := TRUE;\nEND_PROGRAM\n"}};
    const auto exported = exportPlcopen(bytes, {});
    ASSERT_TRUE(exported) << exported.error().english();
    EXPECT_NE(exported->text.find("a := %MW5; // %MW12"), std::string::npos);
    EXPECT_NE(exported->text.find("address=\"%MW2\""), std::string::npos);
    EXPECT_NE(exported->report.toText().find("p.st:4: not kept: The address %MW7"), std::string::npos)
        << exported->report.toText();
}

TEST_F(OtherFormats, MessagesToTheLogOfTwinCatAreLinesThatCanBeRead) {
    write("log/MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\nVAR\n first, second : STRING(255);\n"
                                      " severity : TcEventSeverity := TcEventSeverity.Warning;\nEND_VAR\n") +
                 st("ADSLOGSTR(ADSLOG_MSGTYPE_HINT, 'name %s!', 'pump');\n"
                    "ADSLOGDINT(ADSLOG_MSGTYPE_ERROR OR ADSLOG_MSGTYPE_LOG, 'code %d', 12);\n"
                    "first := AdsLog.adsLogLines[2];\nsecond := AdsLog.adsLogLines[1];") +
                 "</POU>"));
    const Imported imported = folder("log");
    EXPECT_EQ(errorsOf(imported), "");
    const auto controller = scanned(imported);
    ASSERT_TRUE(controller);
    EXPECT_EQ(textOf(*controller, "first"), "name pump!");
    EXPECT_EQ(textOf(*controller, "second"), "code 12");
}

TEST_F(OtherFormats, KindsOfMessagesAreKnownAlsoWhereNothingWritesToTheLog) {
    write("kinds/MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\nVAR\n mask : DWORD;\n hint : BOOL;\nEND_VAR\n") +
                 st("mask := ADSLOG_MSGTYPE_ERROR OR ADSLOG_MSGTYPE_LOG;\n"
                    "hint := (mask AND ADSLOG_MSGTYPE_HINT) <> 0;") +
                 "</POU>"));
    const Imported imported = folder("kinds");
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(imported.files.size(), 2u); // no log
    const auto controller = scanned(imported);
    ASSERT_TRUE(controller);
    EXPECT_EQ(controller->read("MAIN.mask")->integer(), 0x14);
    EXPECT_EQ(controller->read("MAIN.hint")->integer(), 0);
}

TEST_F(OtherFormats, TextsWithValuesAreFormattedAsTwinCatDoes) {
    write("fmt/MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\nVAR\n a, b, c : FB_FormatString;\nEND_VAR\n") +
                 st("a(sFormat := 'n=%d|%05d|%-5d|%5d|%x|%04X|100%%|%s|%.2s', arg1 := F_INT(-7), arg2 := F_DINT(-42), "
                    "arg3 := F_UINT(3), arg4 := F_LINT(4), arg5 := F_BYTE(255), arg6 := F_WORD(171), "
                    "arg7 := F_STRING('abc'), arg8 := F_STRING('xyz'));\n"
                    "b(sFormat := '%f %.1f %6.2f %.0f %f', arg1 := F_REAL(1.5), arg2 := F_LREAL(-0.96), "
                    "arg3 := F_LREAL(3.14159), arg4 := F_LREAL(2.5), arg5 := F_LREAL(0.999999999));\n"
                    "c(sFormat := '%d %u', arg1 := F_BOOL(TRUE));") +
                 "</POU>"));
    const Imported imported = folder("fmt");
    EXPECT_EQ(errorsOf(imported), "");
    const auto controller = scanned(imported);
    ASSERT_TRUE(controller);
    EXPECT_EQ(textOf(*controller, "a.sOut"), "n=-7|-0042|3    |    4|ff|00AB|100%|abc|xy");
    EXPECT_EQ(textOf(*controller, "b.sOut"), "1.500000 -1.0   3.14 3 1.000000");
    EXPECT_EQ(textOf(*controller, "c.sOut"), "1 0");
    EXPECT_EQ(controller->read("MAIN.c.bError")->integer(), 1); // the second value is missing
}

TEST_F(OtherFormats, TextsAreFormattedByTheirAddressesToo) {
    write("fmt/MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\nVAR\n f, g : FB_FormatString2;\n format : T_MaxString := 'n=%d';\n"
                                      " out : STRING(20);\n short : STRING(3);\nEND_VAR\n") +
                 st("f(pFormatString := ADR(format), arg1 := F_INT(42), pOutString := ADR(out), nOutSize := "
                    "SIZEOF(out));\ng(pFormatString := ADR(format), arg1 := F_INT(42), pOutString := ADR(short), "
                    "nOutSize := SIZEOF(short));") +
                 "</POU>"));
    const Imported imported = folder("fmt");
    EXPECT_EQ(errorsOf(imported), "");
    const auto controller = scanned(imported);
    ASSERT_TRUE(controller);
    EXPECT_EQ(textOf(*controller, "out"), "n=42");
    EXPECT_EQ(textOf(*controller, "short"), "n=4"); // cut, and said so
    EXPECT_EQ(controller->read("MAIN.f.bError")->integer(), 0);
    EXPECT_EQ(controller->read("MAIN.g.bError")->integer(), 1);
}

TEST_F(OtherFormats, TheClockOfTwinCatIsTheControllers) {
    write("clock/MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\nVAR\n clock : NT_GetTime;\n n : INT;\n year, month : WORD;\n"
                                      " ticks : ULINT;\nEND_VAR\n") +
                 st("clock(NETID := '', START := TRUE);\nn := n + 1;\nyear := clock.TIMESTR.wYear;\n"
                    "month := clock.TIMESTR.wMonth;\nticks := F_GetSystemTime();") +
                 "</POU>"));
    const Imported imported = folder("clock");
    EXPECT_EQ(errorsOf(imported), "");
    const auto controller = scanned(imported);
    ASSERT_TRUE(controller);
    EXPECT_EQ(controller->read("MAIN.clock.BUSY")->integer(), 1);
    ASSERT_TRUE(controller->scan());
    EXPECT_EQ(controller->read("MAIN.clock.BUSY")->integer(), 0);
    EXPECT_EQ(controller->read("MAIN.year")->integer(), 2000); // virtual time begins with the year
    EXPECT_EQ(controller->read("MAIN.month")->integer(), 1);
    EXPECT_EQ(controller->read("MAIN.ticks")->integer() / 10'000'000 - 11'644'473'600, 946'684'800);
}

TEST_F(OtherFormats, WhatALibraryOfDevicesWouldDoIsNamedWithTheLibrary) {
    write("lib/MAIN.TcPOU",
          object("<POU Name=\"MAIN\">" +
                 cdata("Declaration", "PROGRAM MAIN\nVAR\n axis : AXIS_REF;\n move : MC_MoveAbsolute;\n"
                                      " own : MC_Reset;\n file : FB_FileOpen;\nEND_VAR\n") +
                 st("move(Axis := axis);") + "</POU>"));
    write("lib/MC_Reset.TcPOU",
          object("<POU Name=\"MC_Reset\">" + cdata("Declaration", "FUNCTION_BLOCK MC_Reset\n") + st(";") + "</POU>"));
    const Imported imported = folder("lib");
    EXPECT_NE(imported.report.toText().find("The program uses AXIS_REF, MC_MoveAbsolute of the library Tc2_MC2"),
              std::string::npos)
        << imported.report.toText();
    EXPECT_NE(imported.report.toText().find("FB_FileOpen of the library Tc2_System"), std::string::npos);
}

TEST_F(OtherFormats, AddressingThatIsNeitherIsRefused) {
    write("p/project.json", "{\"addressing\": \"bit\"}");
    write("p/src/p.st", "PROGRAM P\nEND_PROGRAM\n");
    const auto project = projects::openProject({path("p")});
    ASSERT_FALSE(project);
    EXPECT_NE(project.error().english().find("\"byte\" or \"word\""), std::string::npos);
}

} // namespace
} // namespace plc::exchange
