// Out and in again: what an import gave is a fixpoint of export and import in both versions, our examples run the same
// scans bit for bit after a journey, and what the format has no place for has its line.
#include "fixture.h"

#include "projects/exchange/plcopen/plcopen_export.h"
#include "projects/storage/project_file.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "tests/examples/example_names.h"

#include <cstring>
#include <map>

namespace plc::exchange {
namespace {

class RoundTrip : public ExchangeTest {
protected:
    static std::map<std::string, std::string> textsOf(const Imported& imported) {
        std::map<std::string, std::string> out;
        for (const ImportedFile& file : imported.files) out[file.path] = file.text;
        return out;
    }
    std::string exported(const projects::Project& project, Edition edition, Report* report = nullptr) {
        const auto out = exportPlcopen(project, {edition, "2020-01-01T00:00:00"});
        EXPECT_TRUE(out) << out.error().english();
        if (!out) return {};
        if (report) *report = out->report;
        return out->text;
    }
    /// Import, written to disk so that its side file counts, opened as a project.
    projects::Project onDisk(const Imported& imported, const std::string& name) {
        const auto written = writeImported(imported, path(name));
        EXPECT_TRUE(written) << written.error().english();
        const auto project = projects::openProject({path(name)});
        EXPECT_TRUE(project) << project.error().english();
        return project ? *project : projects::Project();
    }
    void expectFixpoint(const std::string& document, Edition edition) {
        const Imported first = import(document);
        const std::string xml = exported(onDisk(first, "first"), edition);
        const Imported second = import(xml);
        EXPECT_EQ(textsOf(first), textsOf(second));
        EXPECT_EQ(exported(onDisk(second, "second"), edition), xml);
        std::filesystem::remove_all(path("first"));
        std::filesystem::remove_all(path("second"));
    }
};

/// One document with an element of every kind.
std::string everything(const std::string& version) {
    const auto variable = [](const std::string& name, const std::string& type, const std::string& more = {}) {
        return "<variable name=\"" + name + "\"><type>" + type + "</type>" + more + "</variable>";
    };
    const auto st = [](const std::string& text) {
        return "<body><ST><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">" + text + "</xhtml></ST></body>";
    };
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?><project xmlns=\"http://www.plcopen.org/xml/tc6_" + version +
           "\"><fileHeader companyName=\"\" productName=\"E\" productVersion=\"1\"/>"
           "<contentHeader name=\"All\"/><types><dataTypes><dataType name=\"Color\"><baseType><enum><values><value "
           "name=\"Red\"/><value name=\"Blue\" value=\"5\"/></values></enum></baseType></dataType>"
           "<dataType name=\"Point\"><baseType><struct>" +
           variable("x", "<REAL/>", "<initialValue><simpleValue value=\"1.5\"/></initialValue>") +
           variable("list", "<array><dimension lower=\"0\" upper=\"4\"/><baseType><INT/></baseType></array>",
                    "<initialValue><arrayValue><value><simpleValue value=\"1\"/></value><value "
                    "repetitionValue=\"4\"><simpleValue value=\"2\"/></value></arrayValue></initialValue>") +
           "</struct></baseType></dataType><dataType name=\"Small\"><baseType><subrangeSigned><range lower=\"-3\" "
           "upper=\"3\"/><baseType><INT/></baseType></subrangeSigned></baseType></dataType></dataTypes>"
           "<pous><pou name=\"Twice\" pouType=\"function\"><interface><returnType><INT/></returnType><inputVars>" +
           variable("x", "<INT/>") +
           "</inputVars></interface><body><IL><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">LD x\nADD x\nST "
           "Twice</xhtml></IL></body></pou>"
           "<pou name=\"Main\" pouType=\"program\"><interface><localVars>" +
           variable(
               "n", "<INT/>",
               "<documentation><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">counts &lt; up</xhtml></documentation>") +
           variable("p", "<derived name=\"Point\"/>",
                    "<initialValue><structValue><value member=\"x\"><simpleValue "
                    "value=\"2.5\"/></value></structValue></initialValue>") +
           variable("text", "<string length=\"20\"/>",
                    "<initialValue><simpleValue value=\"'a&amp;b'\"/></initialValue>") +
           "<variable name=\"lamp\" "
           "address=\"%QX0.3\"><type><BOOL/></type></variable></localVars></interface><actions><action "
           "name=\"Clear\">" +
           st("n := 0;") + "</action></actions>" +
           st("// first\nn := Twice(n);\nIF n &gt; 100 THEN\n    Clear();\nEND_IF\n// last") +
           "</pou>"
           "<pou name=\"Sequence\" pouType=\"program\"><interface><localVars>" +
           variable("a", "<BOOL/>") + variable("b", "<BOOL/>") +
           "</localVars></interface><actions><action name=\"Work\">" + st("b := NOT b;") +
           "</action></actions><body><SFC><step localId=\"1\" name=\"Init\" initialStep=\"true\"><position x=\"5\" "
           "y=\"6\"/></step>"
           "<actionBlock localId=\"20\"><position x=\"0\" y=\"0\"/><connectionPointIn><connection "
           "refLocalId=\"1\"/></connectionPointIn><action localId=\"21\" qualifier=\"D\" "
           "duration=\"T#2s\"><relPosition x=\"0\" y=\"0\"/>"
           "<reference name=\"Work\"/></action></actionBlock><transition localId=\"2\"><position x=\"0\" "
           "y=\"0\"/><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn><condition><inline "
           "name=\"\"><ST>"
           "<xhtml "
           "xmlns=\"http://www.w3.org/1999/xhtml\">a</xhtml></ST></inline></condition></"
           "transition><simultaneousDivergence localId=\"3\"><position x=\"0\" y=\"0\"/><connectionPointIn><connection "
           "refLocalId=\"2\"/>"
           "</connectionPointIn></simultaneousDivergence><step localId=\"4\" name=\"L\"><position x=\"0\" "
           "y=\"0\"/><connectionPointIn><connection refLocalId=\"3\"/></connectionPointIn></step><step localId=\"5\" "
           "name=\"R\">"
           "<position x=\"0\" y=\"0\"/><connectionPointIn><connection "
           "refLocalId=\"3\"/></connectionPointIn></step><simultaneousConvergence localId=\"6\"><position x=\"0\" "
           "y=\"0\"/><connectionPointIn><connection refLocalId=\"4\"/>"
           "</connectionPointIn><connectionPointIn><connection "
           "refLocalId=\"5\"/></connectionPointIn></simultaneousConvergence><transition localId=\"7\"><position "
           "x=\"0\" y=\"0\"/><connectionPointIn><connection refLocalId=\"6\"/>"
           "</connectionPointIn><condition><inline name=\"\"><ST><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">NOT "
           "a</xhtml></ST></inline></condition></transition><jumpStep localId=\"8\" targetName=\"Init\"><position "
           "x=\"0\" y=\"0\"/>"
           "<connectionPointIn><connection refLocalId=\"7\"/></connectionPointIn></jumpStep></SFC></body></pou>"
           "<pou name=\"Rungs\" pouType=\"program\"><interface><localVars>" +
           variable("a", "<BOOL/>") + variable("y", "<BOOL/>") +
           "</localVars></interface><body><LD><leftPowerRail localId=\"1\"><position x=\"0\" y=\"0\"/>"
           "<connectionPointOut formalParameter=\"\"/></leftPowerRail><contact localId=\"2\" edge=\"rising\"><position "
           "x=\"30\" y=\"0\"/><connectionPointIn><connection "
           "refLocalId=\"1\"/></connectionPointIn><connectionPointOut/>"
           "<variable>a</variable></contact><coil localId=\"3\"><position x=\"60\" "
           "y=\"0\"/><connectionPointIn><connection "
           "refLocalId=\"2\"/></connectionPointIn><connectionPointOut/><variable>y</variable></coil></LD></body></pou>"
           "</pous></types><instances><configurations><configuration name=\"Plc\"><resource name=\"App\"><task "
           "name=\"Fast\" interval=\"T#10ms\" priority=\"1\"><pouInstance name=\"m\" typeName=\"Main\"/>"
           "<pouInstance name=\"s\" typeName=\"Sequence\"/><pouInstance name=\"r\" "
           "typeName=\"Rungs\"/></task></resource><globalVars name=\"Shared\">" +
           variable("g", "<INT/>", "<initialValue><simpleValue value=\"7\"/></initialValue>") +
           "</globalVars></configuration></configurations></instances></project>";
}

TEST_F(RoundTrip, EveryElementIsAFixpointInBothVersions) {
    EXPECT_EQ(errorsOf(import(everything("0200"))), "");
    expectFixpoint(everything("0200"), Edition::Codesys0200);
    expectFixpoint(everything("0201"), Edition::Plain0201);
}

TEST_F(RoundTrip, TheEndsOfActionsAndConvergencesHaveNoName) { // neither schema has one
    const projects::Project project = onDisk(import(everything("0200")), "schema");
    const auto hasName = [&](const std::string& element, Edition edition) {
        const std::string text = exported(project, edition);
        const size_t begin = text.find("<" + element), end = text.find("</" + element + ">", begin);
        EXPECT_NE(end, std::string::npos) << element;
        return text.substr(begin, end - begin).find("<connectionPointOut formalParameter=") != std::string::npos;
    };
    for (const Edition edition : {Edition::Plain0201, Edition::Codesys0200})
        for (const char* element : {"actionBlock", "simultaneousConvergence"}) EXPECT_FALSE(hasName(element, edition));
}

TEST_F(RoundTrip, ADiagramGoesOutAsItCameUnlessItsTextChanged) {
    const Imported first = import(everything("0200"));
    projects::Project project = onDisk(first, "drawn");
    EXPECT_NE(exported(project, Edition::Codesys0200).find("<contact localId=\"2\" edge=\"rising\">"),
              std::string::npos);
    EXPECT_NE(exported(project, Edition::Codesys0200).find("<position x=\"5\" y=\"6\""), std::string::npos);
    for (driver::SourceFile& source : project.sources)
        if (source.path == "src/Rungs.st") source.text.replace(source.text.find("y := "), 5, "y := a AND ");
    const std::string changed = exported(project, Edition::Codesys0200);
    EXPECT_EQ(changed.find("<contact"), std::string::npos);
    EXPECT_NE(changed.find("y := a AND edge_2.Q;"), std::string::npos);
}

TEST_F(RoundTrip, WhatTheFormatHasNoPlaceForHasItsLine) {
    write("p/project.json", "{\"name\":\"p\",\"libraries\":[\"util\"]}");
    write("p/src/a.st",
          "FUNCTION_BLOCK F EXTENDS G\nMETHOD M : INT\nM := 1;\nEND_METHOD\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK "
          "G\nEND_FUNCTION_BLOCK\nINTERFACE I\nEND_INTERFACE\nTYPE U : UNION a : INT; b : WORD; END_UNION "
          "END_TYPE\nNAMESPACE N\nFUNCTION X : INT\nX := 1;\nEND_FUNCTION\nEND_NAMESPACE\nPROGRAM P\nVAR f : F; "
          "END_VAR\nINITIAL_STEP S {minTime := T#1s}:\n// inside\nEND_STEP\nTRANSITION t1 FROM S TO S := TRUE; "
          "END_TRANSITION\nEND_PROGRAM\n// the end\n");
    write("p/tests/t.st", "TEST 'x'\nEND_TEST\n");
    const auto project = projects::openProject({path("p")});
    ASSERT_TRUE(project) << project.error().english();
    Report plain, codesys;
    (void)exported(*project, Edition::Plain0201, &plain);
    (void)exported(*project, Edition::Codesys0200, &codesys);
    const auto has = [](const Report& report, const std::string& text) {
        return report.toText().find(text) != std::string::npos;
    };
    for (const char* text : {"F.M", "EXTENDS or IMPLEMENTS of F", "interfaces; I ", "unions; U ", "the names of N",
                             "minTime", "// inside", "transition t1", "// the end", "support tests", "libraries; util"})
        EXPECT_TRUE(has(plain, text)) << text << "\n" << plain.toText();
    for (const char* text : {"the names of N", "// inside", "transition t1", "// the end", "support tests"})
        EXPECT_TRUE(has(codesys, text)) << text << "\n" << codesys.toText();
    EXPECT_FALSE(has(codesys, "F.M")) << codesys.toText();
}

TEST_F(RoundTrip, UnitsOfANamespaceComeOutUnderTheirOwnNames) {
    write("p/project.json", "{\"name\":\"p\"}");
    write("p/src/a.st", "// the plant\n"
                        "NAMESPACE Plant.Units\n"
                        "    TYPE Litre : REAL; END_TYPE\n"
                        "    FUNCTION ToGallons : REAL\n    VAR_INPUT\n        l : Litre;\n    END_VAR\n"
                        "    ToGallons := l / 4.0;\n    END_FUNCTION\n"
                        "END_NAMESPACE\n"
                        "NAMESPACE Plant\n"
                        "    FUNCTION_BLOCK Tank\n    VAR_OUTPUT\n        level : Units.Litre := 8.0;\n    END_VAR\n"
                        "    END_FUNCTION_BLOCK\n"
                        "END_NAMESPACE;\n");
    write("p/src/main.st",
          "PROGRAM Main\nUSING Plant.Units;\nVAR\n    tank : Plant.Tank; // Plant.Tank\n    r, s : REAL;\n"
          "END_VAR\ntank();\nr := ToGallons(tank.level);\ns := Plant.Units.ToGallons(tank.level);\n"
          "END_PROGRAM\n");
    const auto project = projects::openProject({path("p")});
    ASSERT_TRUE(project) << project.error().english();
    for (const Edition edition : {Edition::Codesys0200, Edition::Plain0201}) {
        Report report;
        const Imported again = import(exported(*project, edition, &report));
        EXPECT_EQ(errorsOf(again), "");
        EXPECT_EQ(report.losses(), 0u) << report.toText();
        for (const char* each : {"the names of Plant.Units are", "the names of Plant are"})
            EXPECT_NE(report.toText().find(each), std::string::npos) << report.toText();
        const std::string main = fileOf(again, "src/Main.st");
        EXPECT_EQ(main.find("USING"), std::string::npos) << main;
        EXPECT_NE(main.find("tank : Tank; // Plant.Tank\n"), std::string::npos) << main;
        EXPECT_NE(main.find("s := ToGallons(tank.level);"), std::string::npos) << main;
        EXPECT_NE(fileOf(again, "src/Tank.st").find("level : Litre := 8.0;"), std::string::npos);
    }
}

TEST_F(RoundTrip, ANamespaceWithANameOfAnotherOneIsLeftOutWithItsLine) {
    write("p/project.json", "{\"name\":\"p\"}");
    write("p/src/a.st", "NAMESPACE One\nFUNCTION F : INT\nF := 1;\nEND_FUNCTION\nEND_NAMESPACE\n"
                        "NAMESPACE Two\nFUNCTION F : INT\nF := 2;\nEND_FUNCTION\nEND_NAMESPACE\n"
                        "NAMESPACE Three\nFUNCTION G : INT\nG := 3;\nEND_FUNCTION\nEND_NAMESPACE\n"
                        "NAMESPACE Four\nFUNCTION MAX : INT\nMAX := 4;\nEND_FUNCTION\nEND_NAMESPACE\n"
                        "PROGRAM P\nVAR n : INT; END_VAR\nn := Three.G();\nEND_PROGRAM\n");
    const auto project = projects::openProject({path("p")});
    ASSERT_TRUE(project) << project.error().english();
    Report report;
    const std::string xml = exported(*project, Edition::Codesys0200, &report);
    EXPECT_EQ(report.losses(), 3u) << report.toText();
    for (const char* each : {"One was left out with its units because there is another F",
                             "Two was left out with its units because there is another F",
                             "Four was left out with its units because there is another MAX", "the names of Three are"})
        EXPECT_NE(report.toText().find(each), std::string::npos) << each << "\n" << report.toText();
    EXPECT_EQ(xml.find("name=\"F\""), std::string::npos);
    EXPECT_EQ(errorsOf(import(xml)), "");
}

TEST_F(RoundTrip, ConstructorsInVersion0201AreInitialValuesOrHaveTheirLine) {
    write("p/project.json", "{\"name\":\"p\"}");
    write("p/src/a.st", "FUNCTION_BLOCK M\nVAR_INPUT a, b : INT; END_VAR\nEND_FUNCTION_BLOCK\n"
                        "FUNCTION_BLOCK N\nVAR_INPUT b : INT; END_VAR\nMETHOD FB_Init : BOOL\nVAR_INPUT bInitRetains, "
                        "bInCopyCode : BOOL; x : INT; END_VAR\nEND_METHOD\nEND_FUNCTION_BLOCK\nPROGRAM P\nVAR\n"
                        "    named : M(a := 1) := (b := 2);\n    positional : N(5) := (b := 3);\n"
                        "    several : ARRAY[1..2] OF N[(1), (2)];\nEND_VAR\nEND_PROGRAM\n");
    const auto project = projects::openProject({path("p")});
    ASSERT_TRUE(project) << project.error().english();
    Report report;
    const std::string xml = exported(*project, Edition::Plain0201, &report);
    const std::string text = report.toText();
    EXPECT_EQ(text.find("arguments of named"), std::string::npos) << text;
    EXPECT_NE(text.find("arguments of positional"), std::string::npos) << text;
    EXPECT_NE(text.find("arguments of several"), std::string::npos) << text;
    EXPECT_EQ(xml.find("member=\"\""), std::string::npos);
    const Imported again = import(xml);
    EXPECT_NE(fileOf(again, "src/P.st").find("    named : M := (b := 2, a := 1);\n    positional : N := (b := 3);\n"),
              std::string::npos)
        << fileOf(again, "src/P.st");
}

TEST_F(RoundTrip, SourcesWithErrorsOfSyntaxAreRefusedWithTheirPlace) {
    const auto project = projects::openProject({write("bad.st", "PROGRAM P\nx := ;\nEND_PROGRAM\n")});
    ASSERT_TRUE(project);
    const auto out = exportPlcopen(*project, {});
    ASSERT_FALSE(out);
    EXPECT_NE(out.error().place.find("bad.st:2"), std::string::npos) << out.error().english();
}

// ---------------------------------------------------------------- the examples

using Values = std::map<std::string, std::string>;

/// Every scalar by its path, exactly; pointers and references, which say where something lies, are left out.
Values valuesOf(const image::Layout& layout, std::span<const std::byte> image) {
    Values out;
    for (const image::Root& root : layout.roots) {
        if (root.isHidden) continue;
        layout.forEachLeaf(image::Layout::pathOf(root), {root.type, root.offset, root.bit},
                           [&](const std::string& path, const image::Place& place) {
                               const types::TypeKind kind = (*layout.types)[layout.types->storage(place.type)].kind;
                               if (kind != types::TypeKind::Pointer && kind != types::TypeKind::Reference &&
                                   kind != types::TypeKind::Interface)
                                   out[path] = types::toText(*layout.types,
                                                             types::readValue(*layout.types, place.type,
                                                                              image.subspan(place.offset), place.bit));
                               return true;
                           });
    }
    return out;
}

class Examples : public RoundTrip, public ::testing::WithParamInterface<std::string> {};

TEST_P(Examples, RunTheSameScansAfterAJourney) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    const auto before = projects::openProject({exampleFolder(GetParam())});
    ASSERT_TRUE(before) << before.error().english();
    const Imported imported = import(exported(*before, Edition::Codesys0200));
    const projects::Project after = onDisk(imported, "after");
    EXPECT_EQ(after.libraries.size(), before->libraries.size());
    const driver::Built a = driver::build(before->buildInput()), b = driver::build(after.buildInput());
    ASSERT_TRUE(a.program);
    ASSERT_TRUE(b.program) << errorsOf(imported);
    controller::Controller one(a.program), two(b.program);
    one.useQuickCode(true);
    two.useQuickCode(true);
    one.start();
    two.start();
    for (int scan = 0; scan < 300; ++scan) {
        const bool isGood = one.scan();
        ASSERT_EQ(isGood, two.scan()) << scan;
        if (scan % 10 != 0 && isGood) continue;
        const Values left = valuesOf(a.program->layout, one.image()), right = valuesOf(b.program->layout, two.image());
        for (const auto& [path, value] : left) {
            const auto it = right.find(path);
            ASSERT_TRUE(it != right.end()) << path << " is gone";
            ASSERT_EQ(value, it->second) << path << " in scan " << scan;
        }
        ASSERT_EQ(left.size(), right.size());
        if (!isGood) break;
    }
    // and the texts are a fixpoint from now on
    EXPECT_EQ(textsOf(import(exported(after, Edition::Codesys0200))), textsOf(imported));
}

INSTANTIATE_TEST_SUITE_P(All, Examples, ::testing::ValuesIn(exampleNames()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace plc::exchange
