// A folder with several projects of another tool: one project as long as no names meet, otherwise one for each that
// no other uses; only one by name; files that a project does not list; all or nothing when projects are written.
#include "fixture.h"

#include "projects/exchange/tree.h"
#include "runtime/base/messages.h"

#include <algorithm>

namespace plc::exchange {
namespace {

class ProjectTrees : public ExchangeTest {
protected:
    static std::string plcproj(const std::string& name, std::initializer_list<const char*> files,
                               std::initializer_list<const char*> libraries = {}) {
        std::string items;
        for (const char* file : files) items += "<Compile Include=\"" + std::string(file) + "\"/>";
        for (const char* library : libraries)
            items += "<PlaceholderReference Include=\"" + std::string(library) + "\"/>";
        return "<?xml version=\"1.0\"?><Project xmlns=\"http://schemas.microsoft.com/developer/msbuild/2003\">"
               "<PropertyGroup><Name>" +
               name + "</Name></PropertyGroup><ItemGroup>" + items + "</ItemGroup></Project>";
    }
    static std::string object(const std::string& name, const std::string& declaration, const std::string& body) {
        return "<TcPlcObject><POU Name=\"" + name + "\"><Declaration><![CDATA[" + declaration +
               "]]></Declaration><Implementation><ST><![CDATA[" + body +
               "]]></ST></Implementation></POU></TcPlcObject>";
    }
    void writeApplication(const std::string& name) const {
        const std::string main = name + "/POUs/MAIN.TcPOU";
        write("tree/" + name + "/" + name + ".plcproj", plcproj(name, {"POUs\\MAIN.TcPOU"}, {"Core, * (Us)"}));
        write("tree/" + main,
              object("MAIN", "PROGRAM MAIN\nVAR c : FB_Count; END_VAR\n", "c(amount := 1); // " + name));
    }
    void writeLibrary() const {
        write("tree/Core/Core.plcproj", plcproj("Core", {"FB_Count.TcPOU"}));
        write("tree/Core/FB_Count.TcPOU",
              object("FB_Count", "FUNCTION_BLOCK FB_Count\nVAR_INPUT amount : INT; END_VAR\nVAR n : INT; END_VAR\n",
                     "n := n + amount;"));
    }
    std::vector<Imported> projects(const std::string& name, const ImportOptions& options = {}) const {
        auto imported = importProjects(path(name), options);
        EXPECT_TRUE(imported) << imported.error().english();
        return imported ? std::move(*imported) : std::vector<Imported>();
    }
    static size_t notes(const Imported& imported, NoteKind kind) {
        return static_cast<size_t>(std::count_if(imported.report.notes.begin(), imported.report.notes.end(),
                                                 [&](const Note& each) { return each.kind == kind; }));
    }
};

TEST_F(ProjectTrees, WhatAProjectExcludesFromItsBuildIsLeftOut) {
    const auto texts = [](const std::string& name, const std::string& text) {
        return "<TcPlcObject><GVL Name=\"" + name + "\"><Declaration><![CDATA[VAR_GLOBAL\n yes : STRING := '" + text +
               "';\nEND_VAR\n]]></Declaration></GVL></TcPlcObject>";
    };
    std::string project = plcproj("Texts", {"MAIN.TcPOU", "English\\TxtEn.TcGVL", "German\\TxtDe.TcGVL"});
    project.insert(project.find("</ItemGroup>"),
                   "<Compile Include=\"Old.TcPOU\"><ExcludeFromBuild>true</ExcludeFromBuild></Compile>"
                   "<Folder Include=\"English\"><ExcludeFromBuild>false</ExcludeFromBuild></Folder>"
                   "<Folder Include=\"German\"><ExcludeFromBuild>true</ExcludeFromBuild></Folder>");
    write("tree/Texts.plcproj", project);
    write("tree/MAIN.TcPOU", object("MAIN", "PROGRAM MAIN\nVAR s : STRING; END_VAR\n", "s := yes;"));
    write("tree/Old.TcPOU", object("Old", "PROGRAM Old\nVAR END_VAR\n", "missing := 1;"));
    write("tree/English/TxtEn.TcGVL", texts("TxtEn", "Yes"));
    write("tree/German/TxtDe.TcGVL", texts("TxtDe", "Ja"));
    const std::vector<Imported> all = projects("tree");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(errorsOf(all.front()), "");
    EXPECT_EQ(notes(all.front(), NoteKind::FileNotListed), 2u) << all.front().report.toText();
}

TEST_F(ProjectTrees, ProjectsThatShareNamesBecomeOneEachWithTheLibrariesTheyUse) {
    writeApplication("Press");
    writeApplication("Oven");
    writeLibrary();
    write("tree/Line.sln", "Microsoft Visual Studio Solution File\n");
    for (const char* name : {"tree", "tree/Line.sln"}) {
        const std::vector<Imported> all = projects(name);
        ASSERT_EQ(all.size(), 2u) << name;
        EXPECT_EQ(all[0].name, "Oven");
        EXPECT_EQ(all[1].name, "Press");
        for (const Imported& each : all) {
            EXPECT_EQ(errorsOf(each), "");
            EXPECT_EQ(notes(each, NoteKind::TreeDivided), 1u) << each.report.toText();
            EXPECT_EQ(each.report.losses(), 0u) << each.report.toText();
            EXPECT_NE(fileOf(each, "src/Core/FB_Count.st").find("FB_Count"), std::string::npos);
            EXPECT_NE(fileOf(each, "src/" + each.name + "/POUs/MAIN.st").find("// " + each.name), std::string::npos);
        }
    }
    const std::vector<Imported> all = projects("tree");
    ASSERT_TRUE(writeProjects(all, path("out"), nullptr));
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(folderOf(all, i, path("out")), path("out/" + all[i].name));
        EXPECT_TRUE(std::filesystem::exists(path("out/" + all[i].name + "/project.json")));
    }
    EXPECT_FALSE(std::filesystem::exists(path("out/project.json")));
}

TEST_F(ProjectTrees, ProjectsWithoutSharedNamesAreOne) {
    writeApplication("Press");
    writeLibrary();
    const std::vector<Imported> all = projects("tree");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(errorsOf(all[0]), "");
    EXPECT_EQ(notes(all[0], NoteKind::TreeDivided), 0u);
}

TEST_F(ProjectTrees, OneOfThemIsChosenByItsName) {
    writeApplication("Press");
    writeApplication("Oven");
    writeLibrary();
    ImportOptions options;
    options.only = "oven";
    const std::vector<Imported> one = projects("tree", options);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].files.size(), 2u);
    EXPECT_EQ(errorsOf(one[0]), "");
    options.only = "Mill";
    const auto none = importProjects(path("tree"), options);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().english().find("Press"), std::string::npos) << none.error().english();
    options = {};
    options.division = TreeDivision::Together;
    EXPECT_EQ(projects("tree", options).size(), 1u);
}

TEST_F(ProjectTrees, ALibrarysProgramGivesWayToThatOfTheProject) {
    writeApplication("Press");
    writeLibrary();
    write("tree/Core/Core.plcproj", plcproj("Core", {"FB_Count.TcPOU", "MAIN.TcPOU", "Task.TcTTO"}));
    write("tree/Core/MAIN.TcPOU", object("MAIN", "PROGRAM MAIN\nVAR n : INT; END_VAR\n", "n := 1; // tries it"));
    write("tree/Core/Task.TcTTO", "<TcPlcObject><Task Name=\"Try\"><CycleTime>10000</CycleTime><Priority>20</Priority>"
                                  "<PouCall><Name>MAIN</Name></PouCall></Task></TcPlcObject>");
    const std::vector<Imported> all = projects("tree");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(errorsOf(all[0]), "");
    EXPECT_NE(fileOf(all[0], "src/Press/POUs/MAIN.st").find("// Press"), std::string::npos);
    EXPECT_EQ(notes(all[0], NoteKind::LibraryProgramLeftOut), 1u) << all[0].report.toText();
    for (const ImportedFile& file : all[0].files) EXPECT_NE(file.path, "src/configuration.st");
}

TEST_F(ProjectTrees, AFileThatItsProjectDoesNotListIsLeftOutWithItsLine) {
    writeLibrary();
    write("tree/Core/Old.TcPOU", object("Old", "PROGRAM Old\nVAR END_VAR\n", "this is no program;"));
    write("tree/Shared/Linked.TcPOU", object("Linked", "PROGRAM Linked\nVAR n : INT; END_VAR\n", "n := 1;"));
    write("tree/Core/Core.plcproj", plcproj("Core", {"FB_Count.TcPOU", "..\\Shared\\Linked.TcPOU"}));
    const std::vector<Imported> all = projects("tree");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].files.size(), 2u);
    EXPECT_EQ(notes(all[0], NoteKind::FileNotListed), 1u) << all[0].report.toText();
    EXPECT_EQ(errorsOf(all[0]), "");
}

TEST_F(ProjectTrees, FilesThatHoldAWholeProjectAreKeptApart) {
    const std::string program = pou("Main", "program", bools({"a"}), st("a := TRUE;"));
    write("xml/first.xml", document(program));
    write("xml/second/plc.xml", document(program));
    write("xml/build/x.st", "FUNCTION F : INT\nF := 1;\nEND_FUNCTION\n");
    const std::vector<Imported> all = projects("xml");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].name, "first");
    EXPECT_EQ(all[1].name, "second");
    for (const Imported& each : all) EXPECT_EQ(errorsOf(each), "");

    const std::string configuration = "CONFIGURATION C\nRESOURCE R ON PLC\nTASK T(INTERVAL := T#10ms, PRIORITY := 0);\n"
                                      "PROGRAM Inst WITH T : Main;\nEND_RESOURCE\nEND_CONFIGURATION\n";
    const std::string text = "PROGRAM Main\nVAR n : INT; END_VAR\nn := n + 1;\nEND_PROGRAM\n" + configuration;
    write("st/a.st", text);
    write("st/b.st", text);
    EXPECT_EQ(projects("st").size(), 2u);

    const auto unit = [](const std::string& name) {
        return "(* @NESTEDCOMMENTS := 'Yes' *)\n(* @PATH := '' *)\nPROGRAM " + name +
               "\nVAR\nn : INT;\nEND_VAR\n(* @END_DECLARATION := '0' *)\nn := 1;\nEND_PROGRAM\n";
    };
    write("exp/plant.exp", unit("PLC_PRG") + unit("Second"));
    write("exp/PLC_PRG.EXP", unit("PLC_PRG"));
    write("exp/SECOND.EXP", unit("Second"));
    EXPECT_EQ(projects("exp").size(), 2u); // the whole, and its objects one by one
}

TEST_F(ProjectTrees, NamesOfValuesAndInstancesAreNotThoseOfUnits) {
    const std::set<std::string> names =
        declaredNames("TYPE\n E : (red, green); S : STRUCT x : INT; END_STRUCT;\nEND_TYPE\nPROGRAM P\nVAR a : INT; "
                      "END_VAR\nEND_PROGRAM\nFUNCTION F : INT\nEND_FUNCTION\nCONFIGURATION C\nRESOURCE R ON PLC\n"
                      "PROGRAM i WITH t : P;\nPROGRAM j : P;\nEND_RESOURCE\nEND_CONFIGURATION\n");
    EXPECT_EQ(names, (std::set<std::string>{"e", "s", "p", "f"}));
}

TEST_F(ProjectTrees, WhatIsCancelledOrRefusedLeavesNothingBehind) {
    writeApplication("Press");
    writeApplication("Oven");
    writeLibrary();
    Progress cancelled;
    cancelled.cancel();
    ImportOptions options;
    options.progress = &cancelled;
    const auto none = importProjects(path("tree"), options);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, errors::Cancelled());
    const std::vector<Imported> all = projects("tree");
    const auto isLeft = [&] {
        for (const auto& each : std::filesystem::directory_iterator(path("")))
            if (each.path().filename().string().find("out") != std::string::npos) return true;
        return false;
    };
    EXPECT_FALSE(writeProjects(all, path("out"), &cancelled));
    EXPECT_FALSE(isLeft());
    write("taken", "a file");
    EXPECT_FALSE(writeProjects(all, path("taken/out"), nullptr));
    EXPECT_EQ(read(path("taken")), "a file");
    std::filesystem::create_directories(path("empty"));
    EXPECT_TRUE(writeProjects(all, path("empty"), nullptr));
    EXPECT_FALSE(writeProjects(all, path("empty"), nullptr)) << "it is not empty any more";
    EXPECT_TRUE(std::filesystem::exists(path("empty/Oven/project.json")));
}

TEST_F(ProjectTrees, ExtensionsOfBeremizDeclareTheirVariables) {
    write("p/plc.xml",
          document(pou("Main", "program",
                       "<externalVars><variable name=\"Raw\"><type><UINT/></type></variable></externalVars>"
                       "<localVars><variable name=\"seen\"><type><UINT/></type></variable></localVars>",
                       st("seen := Raw;")),
                   {}, "<instances/>", {}, "Beremiz"));
    write("p/c@c_ext/cfile.xml", "<?xml version='1.0' encoding='utf-8'?>\n<CFile>\n<variables><variable name=\"Raw\" "
                                 "type=\"UINT\" initial=\"7\" desc=\"of the sensor\"/></variables>\n"
                                 "<globals><![CDATA[int x;]]></globals></CFile>\n");
    write("p/py@py_ext/pyfile.xml", "<PyFile><variables/><globals><![CDATA[x = 1]]></globals></PyFile>\n");
    const Imported imported = folder("p");
    EXPECT_EQ(imported.report.losses(), 2u) << imported.report.toText();
    EXPECT_EQ(errorsOf(imported), "");
    EXPECT_EQ(fileOf(imported, "src/Extensions.st"), "VAR_GLOBAL\n    Raw : UINT := 7; // of the sensor\nEND_VAR\n");
}

TEST_F(ProjectTrees, AProgramOfALibraryIsNoInstance) {
    write("p/Visu.TcTTO",
          "<TcPlcObject><Task Name=\"Visu\"><CycleTime>20000</CycleTime><Priority>31</Priority>"
          "<PouCall><Name>VisuElems.Visu_Prg</Name></PouCall><PouCall><Name>MAIN</Name></PouCall></Task>"
          "</TcPlcObject>");
    write("p/MAIN.TcPOU",
          "<TcPlcObject><POU Name=\"MAIN\"><Declaration><![CDATA[PROGRAM MAIN\nVAR\n\tfb_FormatString : "
          "FB_FormatString;\n\tday : "
          "Tc2_EtherCAT.Tc2_Utilities.TIMESTRUCT;\nEND_VAR\n]]></"
          "Declaration><Implementation><ST><![CDATA[fb_FormatString("
          "sFormat := '%d', arg1 := F_INT(5));]]></ST></Implementation></POU></TcPlcObject>");
    const Imported imported = folder("p");
    EXPECT_EQ(imported.report.losses(), 1u) << imported.report.toText();
    EXPECT_NE(imported.report.toText().find("VisuElems.Visu_Prg"), std::string::npos);
    EXPECT_EQ(fileOf(imported, "src/configuration.st").find("Visu_Prg"), std::string::npos);
    EXPECT_EQ(errorsOf(imported), ""); // a variable named like the block does not hide that the block is missing
}

} // namespace
} // namespace plc::exchange
