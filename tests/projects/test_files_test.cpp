// The files of tests in the code model: checked, completed and renamed as the program's own, with nothing of them in
// the program.
#include "projects/analysis/code_model.h"
#include "projects/analysis/sections.h"
#include "projects/storage/project_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace plc::analysis {
namespace {

const char* const kMotor = "FUNCTION_BLOCK Motor\nVAR_INPUT\n    run : BOOL; // on\nEND_VAR\nVAR_OUTPUT\n"
                           "    turns : DINT;\nEND_VAR\nVAR\n    inner : INT; // hidden in it\n    step : INT := 2;\n"
                           "END_VAR\nIF run THEN\n    turns := turns + step;\n    inner := inner + 1;\nEND_IF\n"
                           "END_FUNCTION_BLOCK\n";
const char* const kLine = "PROGRAM Line\nVAR\n    a, b : INT;\n    drive : Motor;\nEND_VAR\na := a + 1;\nb := a;\n"
                          "drive(run := a > 3);\nEND_PROGRAM\n";
const char* const kTest =
    "FUNCTION Twice : INT\nVAR_INPUT\n    value : INT;\nEND_VAR\nTwice := 2 * value;\nEND_FUNCTION\n\n"
    "TEST 'turns'\nVAR\n    i : INT;\nEND_VAR\nLine.drive.run := TRUE;\n"
    "FORCE Line.drive.inner := 5;\nRUN T#100ms;\nFOR i := 0 TO 3 DO\n    RUN 2 SCANS;\n"
    "    ASSERT Line.drive.turns > i, 'turns';\nEND_FOR\nRUN UNTIL Line.drive.run FOR T#1s;\n"
    "RELEASE Line.drive.inner;\nASSERT Twice(value := i) = 2 * i;\nEND_TEST\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::shared_ptr<const CodeModel> modelOf(const std::string& test, const std::string& line = kLine) {
    driver::BuildInput input;
    input.files = {{"src/line.st", line}, {"src/motor.st", kMotor}, {"tests/line.st", test}};
    return CodeModel::make(input);
}
std::vector<std::string> findings(const CodeModel& model, const char* file) {
    std::vector<std::string> out;
    for (const diagnostics::Diagnostic& each : model.diagnostics())
        if (each.range.file == *model.fileOf(file)) out.push_back(each.message.english());
    return out;
}
std::string detailOf(const Completion& completion, const std::string& name) {
    for (const CompletionItem& item : completion.items)
        if (item.text == name) return item.detail.empty() ? "-" : item.detail;
    return "";
}

TEST(TestFiles, ARightTestHasNoFindings) {
    const auto found = findings(*modelOf(kTest), "tests/line.st");
    EXPECT_TRUE(found.empty()) << found.front();
}

TEST(TestFiles, NoTestOfAnExampleHasAFinding) {
    for (const auto& entry : std::filesystem::directory_iterator(plc::sourceDir() + "/projects/examples")) {
        if (!std::filesystem::exists(entry.path() / "project.json")) continue;
        const auto project = projects::openProject({entry.path().string()});
        ASSERT_TRUE(project);
        driver::BuildInput input = project->buildInput();
        for (const driver::SourceFile& test : project->tests) input.files.push_back(test);
        const auto model = CodeModel::make(input);
        for (const driver::SourceFile& test : project->tests)
            for (const std::string& message : findings(*model, test.path.c_str()))
                ADD_FAILURE() << entry.path() << ": " << message;
    }
}

TEST(TestFiles, WhatIsWrongIsSaidWhereItStands) {
    struct Row {
        const char *from, *to, *said;
    };
    for (const Row& row :
         {Row{"ASSERT Line.drive.turns", "ASSERT Line.drive.turn", "turn"}, Row{"RUN T#100ms", "RUN 'soon'", "TIME"},
          Row{"FORCE Line.drive.inner := 5", "FORCE Line.drive.inner := T#1s", "INT"},
          Row{"RELEASE Line.drive.inner", "RELEASE Lime.drive.inner", "Lime"},
          Row{"RUN 2 SCANS", "RUN T#2s SCANS", "TIME"},
          Row{"ASSERT Twice(value := i) = 2 * i", "ASSERT Twice(value := i)", "BOOL"}}) {
        const auto found = findings(*modelOf(replaced(kTest, row.from, row.to)), "tests/line.st");
        ASSERT_EQ(found.size(), 1u) << row.to;
        EXPECT_NE(found[0].find(row.said), std::string::npos) << found[0];
    }
}

TEST(TestFiles, WhatTestsDeclareTheProgramDoesNotHave) {
    const auto model = modelOf(kTest, replaced(kLine, "b := a;", "b := Twice(value := a);"));
    const auto found = findings(*model, "src/line.st");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("Twice"), std::string::npos);
}

TEST(TestFiles, HoverDefinitionAndUsesKnowWhatATestNames) {
    const auto model = modelOf(kTest);
    const FileId file = *model->fileOf("tests/line.st");
    const auto at = [](const std::string& text) { return static_cast<uint32_t>(std::string(kTest).find(text)); };
    const auto hover = model->hover(file, at("inner := 5"));
    ASSERT_TRUE(hover.has_value());
    EXPECT_EQ(hover->declaration, "inner : INT");
    EXPECT_EQ(hover->comment, "hidden in it");
    EXPECT_FALSE(model->hover(file, at("'turns'\nVAR") + 2).has_value()) << "a title is no name";
    const auto place = model->definition(file, at("turns > i"));
    ASSERT_TRUE(place.has_value());
    EXPECT_EQ(place->file, *model->fileOf("src/motor.st"));
    size_t inTest = 0;
    for (const Use& use : model->uses(*model->fileOf("src/motor.st"), std::string(kMotor).find("inner : INT")))
        inTest += use.range.file == file;
    EXPECT_EQ(inTest, 2u) << "FORCE and RELEASE";
}

TEST(TestFiles, ARenameFromATestChangesTheProgram) {
    const auto model = modelOf(kTest);
    const FileId file = *model->fileOf("tests/line.st");
    const auto edits = model->rename(file, static_cast<uint32_t>(std::string(kTest).find("turns > i")), "rounds");
    ASSERT_TRUE(edits) << edits.error().english();
    ASSERT_EQ(edits->size(), 2u);
    for (const FileEdits& each : *edits) EXPECT_EQ(each.edits.size(), each.file == file ? 1u : 3u) << "the title stays";
    const auto own =
        model->rename(file, static_cast<uint32_t>(std::string(kTest).find("i : INT;\nEND_VAR\nLine")), "k");
    ASSERT_TRUE(own);
    ASSERT_EQ(own->size(), 1u);
    EXPECT_EQ(own->front().edits.size(), 5u);
}

TEST(TestFiles, CompletionOffersMembersOwnVariablesAndTheWordsOfTests) {
    const auto model = modelOf(kTest);
    const auto complete = [&](const std::string& typed) {
        const size_t at = std::string(kTest).find("RUN T#100ms;\n") + 13;
        return model->complete(*model->fileOf("tests/line.st"), std::string(kTest).insert(at, typed),
                               static_cast<uint32_t>(at + typed.size()));
    };
    EXPECT_EQ(detailOf(complete("Line.drive."), "turns"), "DINT");
    EXPECT_EQ(detailOf(complete("Line.drive."), "inner"), "INT") << "a test looks inside";
    EXPECT_EQ(detailOf(complete("i"), "i"), "INT");
    for (const char* name : {"Line", "ASSERT", "Twice"})
        EXPECT_NE(detailOf(complete(std::string(name).substr(0, 2)), name), "") << name;
    const auto items = complete("__").items;
    for (const CompletionItem& item : items) EXPECT_FALSE(item.text.starts_with("__test")) << item.text;
}

TEST(Sections, ADeclarationMovesWithItsCommentsAndTheLastOneTakesItsSectionAlong) {
    struct Row {
        const char* name;
        syntax::SectionKind to;
        const char *before, *after;
    };
    using syntax::SectionKind;
    for (const Row& row :
         {Row{"b", SectionKind::Input, "VAR\n    a : INT;\n    b : BOOL; // why\nEND_VAR\n",
              "VAR_INPUT\n    b : BOOL; // why\nEND_VAR\nVAR\n    a : INT;\nEND_VAR\n"},
          Row{"a", SectionKind::Output, "VAR_OUTPUT\n    o : INT;\nEND_VAR\nVAR\n    a, b : INT := 3;\nEND_VAR\n",
              "VAR_OUTPUT\n    o : INT;\n    a : INT := 3;\nEND_VAR\nVAR\n    b : INT := 3;\nEND_VAR\n"},
          Row{"b", SectionKind::Var, "VAR_INPUT\n    b : BOOL;\nEND_VAR\nVAR\n    a : INT;\nEND_VAR\n",
              "VAR\n    a : INT;\n    b : BOOL;\nEND_VAR\n"},
          Row{"b", SectionKind::Var, "VAR RETAIN\n    b : BOOL;\n    c : INT;\nEND_VAR\n",
              "VAR RETAIN\n    c : INT;\nEND_VAR\nVAR\n    b : BOOL;\nEND_VAR\n"},
          Row{"b", SectionKind::Temp, "VAR\n    a : INT; b : BOOL;\nEND_VAR\n",
              "VAR\n    a : INT; \nEND_VAR\nVAR_TEMP\n    b : BOOL;\nEND_VAR\n"}}) {
        const std::string head = "FUNCTION_BLOCK B\n", text = head + row.before + "END_FUNCTION_BLOCK\n";
        driver::BuildInput input;
        input.files = {{"b.st", text}};
        const auto model = CodeModel::make(input);
        const syntax::Pou& pou = *model->checked().analysis->files[0]->declarations[0]->pou;
        std::string made = text;
        for (const syntax::VarSection* section : pou.sections)
            for (const syntax::VarDecl* declaration : section->declarations)
                for (size_t i = 0; i < declaration->names.size(); ++i) {
                    if (declaration->names[i].text != row.name) continue;
                    SourceRange lines = declaration->range;
                    while (text[lines.begin - 1] != '\n') --lines.begin;
                    while (text[lines.end - 1] != '\n') ++lines.end;
                    auto edits = moveToSection(pou, *section, *declaration, i, row.to, lines, text);
                    for (size_t e = edits.size(); e-- > 0;)
                        made.replace(edits[e].range.begin, edits[e].range.length(), edits[e].text);
                }
        EXPECT_EQ(made, head + row.after + "END_FUNCTION_BLOCK\n");
    }
}

} // namespace
} // namespace plc::analysis
