// Texts that are not the program's own sources: tests, which the editor knows as well as the program; libraries; files
// that are read-only on disk. And both sides of a split, the list of completions, the sections of the table.
#include "app/documents/unit_commands.h"
#include "app/pages/editor_tabs.h"
#include "app/project/project_tree.h"
#include "runtime/diagnostics/diagnostic.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QToolTip>

#include <algorithm>

namespace plc::app {
namespace {

using editor::StEditor;
using editor::Workspace;

class SourcePagesTest : public StudioTest {
protected:
    void SetUp() override {
        write("src/motor.st",
              "/// Turns.\nFUNCTION_BLOCK Motor\nVAR_INPUT\n    run : BOOL; // on\nEND_VAR\nVAR_OUTPUT\n"
              "    turns : DINT;\nEND_VAR\nVAR\n    inner : INT; // hidden in it\n    step : INT := 2;\n"
              "END_VAR\nIF run THEN\n    turns := turns + step;\n    inner := inner + 1;\nEND_IF\n"
              "END_FUNCTION_BLOCK\n");
        write("src/line.st", "PROGRAM Line\nVAR\n    a, b : INT;\n    drive : Motor;\nEND_VAR\na := a + 1;\nb := a;\n"
                             "drive(run := a > 3);\nEND_PROGRAM\n");
        write("tests/line.st", "/// Doubles.\nFUNCTION Twice : INT\nVAR_INPUT\n    value : INT;\nEND_VAR\n"
                               "Twice := 2 * value;\nEND_FUNCTION\n\nTEST 'turns'\nVAR\n    i : INT;\nEND_VAR\n"
                               "Line.drive.run := TRUE;\nFORCE Line.drive.inner := 5;\nRUN T#100ms;\n"
                               "FOR i := 0 TO 3 DO\n    RUN 2 SCANS;\n    ASSERT Line.drive.turns > i, 'turns';\n"
                               "END_FOR\nRUN UNTIL Line.drive.run FOR T#1s;\nRELEASE Line.drive.inner;\n"
                               "ASSERT Twice(value := i) = 2 * i;\nEND_TEST\n");
        StudioTest::SetUp();
        ASSERT_NE(window->workspace().presentModel(), nullptr);
    }
    std::string text(const char* file) { return window->workspace().text(file); }
    StEditor& open(const char* file) { return window->tabs().openFile(file)->first(); }
    uint32_t place(const char* file, const char* what) { return static_cast<uint32_t>(text(file).find(what)); }
    std::vector<std::string> messages(const char* file) {
        std::vector<std::string> out;
        const auto model = window->workspace().presentModel();
        if (!model) return {"no model"};
        for (const diagnostics::Diagnostic& each : model->diagnostics())
            if (each.range.file == *model->fileOf(file)) out.push_back(each.message.english());
        return out;
    }
    void replace(const char* file, const std::string& from, const std::string& to) {
        const auto at = static_cast<uint32_t>(text(file).find(from));
        open(file).applyEdits({{{FileId(), at, at + static_cast<uint32_t>(from.size())}, to}});
    }
    static std::string offered(const analysis::Completion& completion, const std::string& name) {
        for (const analysis::CompletionItem& item : completion.items)
            if (item.text == name) return item.detail.empty() ? "-" : item.detail;
        return "";
    }
};

TEST_F(SourcePagesTest, ATestHasNoFindingsWhenItIsRightAndSaysWhatIsWrong) {
    EXPECT_TRUE(messages("tests/line.st").empty()) << messages("tests/line.st").front();
    replace("tests/line.st", "ASSERT Line.drive.turns > i", "ASSERT Line.drive.turn > i");
    const auto unknown = messages("tests/line.st");
    ASSERT_EQ(unknown.size(), 1u);
    EXPECT_NE(unknown[0].find("turn"), std::string::npos) << unknown[0];
    ASSERT_TRUE(waitFor([&] { return editor().diagnosticsHere().size() == 1; })) << "shown in the text";
    replace("tests/line.st", "Line.drive.turn > i", "Line.drive.turns > i");
    replace("tests/line.st", "RUN T#100ms", "RUN 'soon'");
    EXPECT_EQ(messages("tests/line.st").size(), 1u);
    replace("tests/line.st", "RUN 'soon'", "RUN T#100ms");
    replace("tests/line.st", "FORCE Line.drive.inner := 5", "FORCE Line.drive.inner := T#1s");
    EXPECT_EQ(messages("tests/line.st").size(), 1u) << "a value of another type";
    replace("tests/line.st", "FORCE Line.drive.inner := T#1s", "FORCE Line.drive.inner := 5");
    EXPECT_TRUE(messages("tests/line.st").empty());
}

TEST_F(SourcePagesTest, WhatTestsDeclareTheProgramDoesNotHave) {
    replace("src/line.st", "b := a;", "b := Twice(value := a);");
    const auto found = messages("src/line.st");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("Twice"), std::string::npos);
    const auto& input = window->workspace().buildInput();
    EXPECT_TRUE(std::none_of(input.files.begin(), input.files.end(),
                             [](const driver::SourceFile& file) { return file.path.starts_with("tests/"); }));
}

TEST_F(SourcePagesTest, ATestCompletesMembersItsOwnVariablesAndItsWords) {
    const auto model = window->workspace().presentModel();
    const FileId file = *model->fileOf("tests/line.st");
    std::string now = text("tests/line.st");
    const auto complete = [&](const std::string& typed) {
        std::string changed = now;
        const size_t at = changed.find("RUN T#100ms;\n") + 13;
        changed.insert(at, typed);
        return model->complete(file, changed, static_cast<uint32_t>(at + typed.size()));
    };
    EXPECT_EQ(offered(complete("Line.drive."), "turns"), "DINT");
    EXPECT_EQ(offered(complete("Line.drive."), "inner"), "INT") << "a test may look inside";
    EXPECT_EQ(offered(complete("i"), "i"), "INT");
    EXPECT_NE(offered(complete("Li"), "Line"), "");
    EXPECT_NE(offered(complete("AS"), "ASSERT"), "");
    EXPECT_NE(offered(complete("Tw"), "Twice"), "");
    const auto items = complete("_").items;
    EXPECT_TRUE(
        std::none_of(items.begin(), items.end(), [](const auto& item) { return item.text.starts_with("__test"); }));
}

TEST_F(SourcePagesTest, HoverAndDefinitionLeadFromATestIntoTheProgram) {
    const auto model = window->workspace().presentModel();
    const FileId file = *model->fileOf("tests/line.st");
    const auto hover = model->hover(file, place("tests/line.st", "inner := 5"));
    ASSERT_TRUE(hover.has_value());
    EXPECT_EQ(hover->declaration, "inner : INT");
    EXPECT_EQ(hover->comment, "hidden in it");
    EXPECT_FALSE(model->hover(file, place("tests/line.st", "'turns'\nVAR") + 2).has_value()) << "a title is no name";
    StEditor& here = open("tests/line.st");
    here.goTo(place("tests/line.st", "turns > i"));
    window->units().definitionAtCursor();
    EXPECT_EQ(window->tabs().currentEditor()->file(), "src/motor.st");
    EXPECT_EQ(window->tabs().currentEditor()->cursorOffset(), place("src/motor.st", "turns : DINT") + 5);
}

TEST_F(SourcePagesTest, ARenameFromATestReachesTheProgramAndOneUndoTakesItBack) {
    const std::string motor = text("src/motor.st"), test = text("tests/line.st");
    StEditor& here = open("tests/line.st");
    here.goTo(place("tests/line.st", "turns > i"));
    typeIntoNext(window.get(), "rounds");
    window->units().renameAtCursor();
    EXPECT_NE(text("src/motor.st").find("rounds := rounds + step"), std::string::npos) << text("src/motor.st");
    EXPECT_NE(text("tests/line.st").find("ASSERT Line.drive.rounds > i, 'turns'"), std::string::npos);
    QTest::keyClick(&here, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(text("src/motor.st"), motor);
    EXPECT_EQ(text("tests/line.st"), test);
    here.goTo(place("tests/line.st", "i : INT"));
    ASSERT_NE(window->workspace().presentModel(), nullptr);
    typeIntoNext(window.get(), "pass");
    window->units().renameAtCursor(); // the test's own
    EXPECT_NE(text("tests/line.st").find("FOR pass := 0 TO 3 DO"), std::string::npos) << text("tests/line.st");
    EXPECT_EQ(text("src/motor.st"), motor);
}

TEST_F(SourcePagesTest, ATestShowsNoValuesOfTheControllerThatRuns) {
    replace("tests/line.st", "Line.drive.turns > i", "Main.counter > i");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 3; }));
    StEditor& program = open("src/main.st");
    ASSERT_TRUE(waitFor([&] {
        program.refreshOnlineValues();
        return !program.shownValues().empty();
    }));
    StEditor& test = open("tests/line.st");
    test.goTo(place("tests/line.st", "ASSERT"));
    const uint64_t now = window->control().status().scans;
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > now + 20; })) << "it goes on";
    test.refreshOnlineValues();
    EXPECT_TRUE(test.shownValues().empty()) << "it runs on a controller of its own";
}

TEST_F(SourcePagesTest, FindingWorksInALibrary) {
    window->tabs().goTo("library/standard/timers.st", 0);
    const auto model = window->workspace().presentModel();
    QString library;
    for (const SourceText& source : model->sources().files)
        if (source.path().starts_with("library/standard/") && source.text().find("TON") != std::string_view::npos)
            library = QString::fromStdString(source.path());
    ASSERT_FALSE(library.isEmpty());
    window->tabs().goTo(library, 0);
    ASSERT_EQ(editor().file(), library);
    window->action("edit.find")->trigger();
    auto& bar = window->tabs().currentPage()->findBar();
    ASSERT_TRUE(bar.isVisible());
    QTest::keyClicks(&bar.findField(), "TON");
    EXPECT_EQ(editor().selectedText().toUpper(), "TON");
    const std::string before = editor().utf8();
    bar.replaceField().setText("X");
    EXPECT_EQ(bar.replaceAll(), 0) << "read-only";
    EXPECT_EQ(editor().utf8(), before);
    EXPECT_TRUE(window->tabs().currentPage()->isLibrary());
    EXPECT_FALSE(window->tabs().openFiles().contains(library));
    window->tabs().saveCurrent();
    emit window->workspace().filesChanged();
    EXPECT_EQ(editor().file(), library) << "stays open";
    EXPECT_TRUE(window->tabs().closePage(window->tabs().currentIndex()));
}

TEST_F(SourcePagesTest, FindingGoesOnInTheSideOfASplitThatHasTheFocus) {
    StEditor& first = open("src/line.st");
    StPage& page = *window->tabs().currentPage();
    first.goTo(0);
    page.toggleSplit();
    StEditor& second = page.active();
    ASSERT_NE(&second, &first);
    second.goTo(0);
    window->action("edit.find")->trigger();
    QTest::keyClicks(&page.findBar().findField(), "drive");
    EXPECT_EQ(second.selectedText(), "drive");
    EXPECT_FALSE(first.hasSelectedText());
    EXPECT_EQ(&page.active(), &second) << "while the field has the focus";
    page.toggleSplit();
    EXPECT_EQ(&page.active(), &first);
    page.findBar().findNext();
    EXPECT_EQ(first.selectedText(), "drive");
}

TEST_F(SourcePagesTest, TheListOfCompletionsShowsTypesInAColumn) {
    StEditor& here = open("src/line.st");
    const uint32_t at = place("src/line.st", "drive(run");
    here.applyEdits({{{FileId(), at, at}, "\n"}});
    here.goTo(at);
    ASSERT_NE(window->workspace().presentModel(), nullptr);
    QTest::keyClicks(here.viewport(), "drive.");
    QListWidget* list = nullptr;
    ASSERT_TRUE(waitFor([&] {
        for (QWidget* each : QApplication::allWidgets())
            if (auto* found = qobject_cast<QListWidget*>(each);
                found && found->isVisible() && found->count() > 3 && found->window() != window.get())
                list = found;
        return list != nullptr;
    }));
    QStringList lines;
    for (int i = 0; i < list->count(); ++i) lines << list->item(i)->text();
    EXPECT_TRUE(lines.contains("run    BOOL on")) << lines.join('\n').toStdString();
    EXPECT_TRUE(lines.contains("turns  DINT")) << lines.join('\n').toStdString();
    QTest::keyClicks(here.viewport(), "tu");
    QTest::keyClick(here.viewport(), Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return here.utf8().find("drive.turns") != std::string::npos; })) << here.utf8();
    EXPECT_EQ(here.utf8().find("DINT"), std::string::npos);
}

TEST_F(SourcePagesTest, ARowOfTheTableGoesToAnotherSectionAndBack) {
    StEditor& here = open("src/motor.st");
    const std::string before = text("src/motor.st");
    window->action("view.table")->trigger();
    auto& table = window->tabs().currentPage()->table();
    const auto rowOf = [&](const QString& name) {
        for (int row = 0; row < table.table().rowCount(); ++row)
            if (table.table().item(row, 1)->text() == name) return row;
        return -1;
    };
    here.goTo(place("src/motor.st", "IF run"));
    ASSERT_TRUE(waitFor([&] { return rowOf("inner") >= 0; }));
    table.table().item(rowOf("inner"), 0)->setText("VAR_OUTPUT");
    ASSERT_TRUE(
        waitFor([&] { return rowOf("inner") >= 0 && table.table().item(rowOf("inner"), 0)->text() == "VAR_OUTPUT"; }));
    EXPECT_NE(text("src/motor.st").find("    turns : DINT;\n    inner : INT; // hidden in it\nEND_VAR\nVAR\n    step"),
              std::string::npos)
        << text("src/motor.st");
    QTest::keyClick(&here, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(text("src/motor.st"), before) << "one undo";

    StEditor& line = open("src/line.st");
    window->action("view.table")->trigger();
    auto& other = window->tabs().currentPage()->table();
    line.goTo(place("src/line.st", "b := a"));
    ASSERT_TRUE(waitFor([&] { return other.table().rowCount() == 3; }));
    other.moveToSection(0, syntax::SectionKind::Input); // a of "a, b"
    EXPECT_EQ(text("src/line.st").find("PROGRAM Line\nVAR_INPUT\n    a : INT;\nEND_VAR\nVAR\n    b : INT;\n"), 0u)
        << text("src/line.st");
}

TEST_F(SourcePagesTest, EditsOfTheTableWaitForTheAnalysis) {
    StEditor& here = open("src/motor.st");
    window->action("view.table")->trigger();
    auto& table = window->tabs().currentPage()->table();
    here.goTo(place("src/motor.st", "IF run"));
    ASSERT_TRUE(waitFor([&] { return table.table().rowCount() == 4; }));
    replace("src/motor.st", "/// Turns.\n", "/// Turns and turns.\n"); // every place below has moved
    table.table().item(3, 4)->setText("7");                            // step
    table.table().item(2, 5)->setText("counts");                       // inner
    EXPECT_EQ(text("src/motor.st").find(":= 7"), std::string::npos) << "not at places of the old text";
    EXPECT_TRUE(waitFor([&] {
        return text("src/motor.st").find("    inner : INT; // counts\n    step : INT := 7;\n") != std::string::npos;
    })) << text("src/motor.st");
}

TEST_F(SourcePagesTest, AReadOnlyFileSaysSoAndSavingAsks) {
    const QString path = folder.path() + "/src/motor.st";
    ASSERT_TRUE(QFile::setPermissions(path, QFile::ReadOwner | QFile::ReadGroup));
    StEditor& here = open("src/motor.st");
    StPage& page = *window->tabs().currentPage();
    EXPECT_TRUE(page.saysReadOnly());
    const QByteArray before = [&] {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }();
    here.applyEdits({{{FileId(), 0, 0}, "// new\n"}});
    const auto onDisk = [&] {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    QString question;
    inNext<QMessageBox>(window.get(), [&question](QMessageBox& box) {
        question = box.text();
        box.reject();
    });
    window->tabs().saveCurrent();
    EXPECT_TRUE(question.contains("src/motor.st")) << question.toStdString();
    EXPECT_EQ(onDisk(), before);
    EXPECT_TRUE(window->workspace().isModified("src/motor.st"));
    EXPECT_FALSE(window->workspace().save("src/motor.st")) << "nothing below asks: it refuses";
    pressInNext(window.get(), "Replace");
    window->tabs().saveAll();
    EXPECT_TRUE(onDisk().startsWith("// new\n"));
    EXPECT_TRUE(window->workspace().isReadOnly("src/motor.st")) << "the mode stays";
    auto* change = page.findChild<QWidget*>("readOnlyNotice")->findChild<QPushButton*>();
    change->click();
    EXPECT_TRUE(waitFor([&] { return !page.saysReadOnly(); }));
    here.applyEdits({{{FileId(), 0, 0}, "// newer\n"}});
    window->tabs().saveCurrent(); // without a question
    EXPECT_TRUE(onDisk().startsWith("// newer\n"));
    window->workspace().setAccess([](const QString& file) { return file.endsWith("/line.st"); });
    open("src/line.st");
    EXPECT_TRUE(window->tabs().currentPage()->saysReadOnly());
}

} // namespace
} // namespace plc::app
