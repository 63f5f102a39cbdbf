// What an engineer does with units, files and texts in a day and expects to be able to take back: rename and replace
// over several files, deletion with what refers to it, split view, columns, declarations as a table, files of other
// editors, examples.
#include "app/documents/unit_commands.h"
#include "app/panels/live_views.h"
#include "app/project/new_project.h"
#include "app/project/project_tree.h"
#include "app/project/search_view.h"
#include "app/start/start_page.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"
#include "tests/support/settle.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QToolButton>

namespace plc::app {
namespace {

using editor::StEditor;

class ProjectEditsTest : public StudioTest {
protected:
    void SetUp() override {
        write("src/motor.st", "/// Turns.\n{attribute 'note'}\nFUNCTION_BLOCK Motor\nVAR_INPUT\n    run : BOOL; // on\n"
                              "END_VAR\nVAR_OUTPUT\n    turns : DINT;\nEND_VAR\nIF run THEN\n    turns := turns + 1;\n"
                              "END_IF\nEND_FUNCTION_BLOCK\n");
        write("src/line.st", "PROGRAM Line\nVAR\n    a, b : INT;\n    drive : Motor; // the first\nEND_VAR\n"
                             "a := 1; drive(run := a > 0); b := a;\nIF drive.run THEN\n    b := 2;\nEND_IF\n"
                             "CASE b OF\n    1: drive(run := FALSE);\n    2: b := 3;\nEND_CASE\nEND_PROGRAM\n");
        write("tests/line.st", "TEST 'turns'\nRUN T#100ms;\nASSERT Line.drive.run, 'drive.run';\nEND_TEST\n");
        StudioTest::SetUp();
        ASSERT_TRUE(waitFor([&] { return item("Motor") != nullptr; }));
    }
    QTreeWidget& tree() { return window->projectTree().tree(); }
    QTreeWidgetItem* item(const QString& name) {
        const auto found = tree().findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.first();
    }
    std::string text(const char* file) { return window->workspace().text(file); }
    StEditor& open(const char* file) { return window->tabs().openFile(file)->first(); }
    uint32_t place(const char* file, const char* what) { return static_cast<uint32_t>(text(file).find(what)); }
    static int marks(StEditor& editor) {
        int count = 0;
        for (int line = 0; line < editor.lines(); ++line) count += (editor.markersAtLine(line) & (3u << 5)) != 0;
        return count;
    }
};

TEST_F(ProjectEditsTest, ARenameOverFilesTestsIncludedIsTakenBackByOneUndo) {
    const std::string motor = text("src/motor.st"), line = text("src/line.st"), test = text("tests/line.st");
    StEditor& here = open("src/motor.st"); // the others stay closed
    here.goTo(place("src/motor.st", "run : BOOL"));
    typeIntoNext(window.get(), "go");
    window->units().renameAtCursor();
    EXPECT_NE(text("src/line.st").find("drive(go := a > 0)"), std::string::npos) << text("src/line.st");
    EXPECT_NE(text("tests/line.st").find("Line.drive.go, 'drive.run'"), std::string::npos) << text("tests/line.st");
    EXPECT_EQ(here.utf8().find("run"), std::string::npos);
    QTest::keyClick(&here, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(here.utf8(), motor);
    EXPECT_EQ(text("src/line.st"), line);
    EXPECT_EQ(text("tests/line.st"), test);
    EXPECT_FALSE(window->workspace().isModified("src/line.st"));
    QTest::keyClick(&here, Qt::Key_Y, Qt::ControlModifier);
    EXPECT_NE(text("src/line.st").find("drive(go := a > 0)"), std::string::npos);
    EXPECT_EQ(here.utf8().find("run"), std::string::npos);
}

TEST_F(ProjectEditsTest, AUnitLeavesWithItsCommentsAndOnlyTheStatementsThatReferToIt) {
    open("src/line.st");
    pressInNext(window.get(), "Delete and Comment Out the Uses");
    window->units().deleteUnit("src/motor.st", place("src/motor.st", "Motor"),
                               place("src/motor.st", "END_FUNCTION_BLOCK") + 18, "Motor");
    const std::string after = text("src/line.st");
    EXPECT_NE(after.find("    // drive : Motor; // the first\n"), std::string::npos) << after;
    EXPECT_NE(after.find("a, b : INT;"), std::string::npos);
    EXPECT_FALSE(window->workspace().files().contains("src/motor.st")) << "comment and pragma went, too";
    QTest::keyClick(&open("src/line.st"), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(text("src/line.st").find("// drive : Motor"), std::string::npos);
    EXPECT_TRUE(window->workspace().files().contains("src/motor.st")) << "one undo brings the file back";
}

TEST_F(ProjectEditsTest, OfALineWithSeveralStatementsOnlyOneIsCommentedOut) {
    const auto model = window->workspace().presentModel();
    ASSERT_NE(model, nullptr);
    write("src/f.st", "FUNCTION F : INT\nF := 1;\nEND_FUNCTION\n");
    write("src/g.st",
          "PROGRAM G\nVAR\n    x, y : INT;\nEND_VAR\nx := 1; y := F(); x := 2;\nIF F() > 0 THEN\n    x := 3;\n"
          "END_IF\nx := 4;\nEND_PROGRAM\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/g.st"); }));
    open("src/g.st");
    pressInNext(window.get(), "Delete and Comment Out the Uses");
    window->units().deleteUnit("src/f.st", 9, 40, "F");
    EXPECT_EQ(text("src/g.st"), "PROGRAM G\nVAR\n    x, y : INT;\nEND_VAR\nx := 1; (* y := F(); *) x := 2;\n"
                                "// IF F() > 0 THEN\n//     x := 3;\n// END_IF\nx := 4;\nEND_PROGRAM\n");
}

TEST_F(ProjectEditsTest, ReplacingInAllFilesWithGroupsIsUndoneAsOne) {
    const std::string motor = text("src/motor.st"), line = text("src/line.st");
    StEditor& here = open("src/motor.st");
    auto fields = window->search().findChildren<QLineEdit*>();
    fields[0]->setText("(r)(un)\\b");
    fields[1]->setText("\\2\\1");
    for (QCheckBox* box : window->search().findChildren<QCheckBox*>()) box->setChecked(true);
    EXPECT_EQ(window->search().replaceAll(), 7);
    EXPECT_NE(here.utf8().find("unr : BOOL"), std::string::npos);
    EXPECT_NE(text("src/line.st").find("drive(unr := a > 0)"), std::string::npos);
    EXPECT_GT(marks(here), 0) << "what is not saved is marked";
    EXPECT_LT(marks(here), 5);
    QTest::keyClick(&here, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(here.utf8(), motor);
    EXPECT_EQ(text("src/line.st"), line);
    EXPECT_TRUE(waitFor([&] { return marks(here) == 0; }));
}

TEST_F(ProjectEditsTest, BothSidesOfASplitMarkOnlyWhatChanged) {
    StEditor& here = open("src/motor.st");
    window->action("view.split")->trigger();
    StEditor& second = window->tabs().currentPage()->active();
    ASSERT_NE(&second, &here);
    second.goTo(place("src/motor.st", "IF run"));
    QTest::keyClicks(&second, "x");
    EXPECT_TRUE(waitFor([&] { return here.utf8() == second.utf8() && marks(here) == 1; }));
    EXPECT_EQ(text("src/motor.st"), here.utf8());
    EXPECT_EQ(marks(here), 1);
    window->action("file.save")->trigger();
    EXPECT_EQ(marks(here), 0);
    EXPECT_EQ(marks(second), 0);
}

TEST_F(ProjectEditsTest, TypingInAColumnKeepsTheColumn) {
    StEditor& here = editor();
    const std::string before = here.utf8();
    here.goTo(static_cast<uint32_t>(before.find("    counter : INT")));
    for (int i = 0; i < 2; ++i) QTest::keyClick(&here, Qt::Key_Down, Qt::AltModifier | Qt::ShiftModifier);
    QTest::keyClicks(&here, "if ab ");
    EXPECT_NE(here.utf8().find("if ab     counter : INT"), std::string::npos) << here.utf8();
    EXPECT_NE(here.utf8().find("if ab     done : BOOL"), std::string::npos);
    EXPECT_FALSE(here.isListActive());
}

TEST_F(ProjectEditsTest, NothingIsOfferedInCommentsStringsAndPragmas) {
    StEditor& here = editor();
    for (const char* opener : {"// cou", "(* cou", "'cou", "{attribute cou"}) {
        const auto at = static_cast<uint32_t>(here.utf8().find("counter := counter"));
        here.applyEdits({{{FileId(), at, at}, "\n"}});
        here.goTo(at);
        QTest::keyClicks(&here, opener);
        EXPECT_FALSE(here.isListActive()) << opener;
        QTest::keyClick(&here, Qt::Key_Escape);
        here.undo();
        while (here.utf8().find("cou\n") != std::string::npos || here.isUndoAvailable()) here.undo();
    }
    EXPECT_EQ(here.utf8(), kMain);
}

TEST_F(ProjectEditsTest, TheHelpOfAnOuterCallComesBackBehindTheInnerOne) {
    const auto model = window->workspace().presentModel();
    const auto file = *model->fileOf("src/main.st");
    const auto help = [&](std::string written) {
        std::string whole = kMain;
        const size_t at = whole.find("counter := counter");
        whole.insert(at, written);
        return model->parameterHelp(file, whole, static_cast<uint32_t>(at + written.size()));
    };
    EXPECT_EQ(help("limit := MAX(MIN(1, 2)")->callee, "MAX");
    EXPECT_EQ(help("limit := MAX(MIN(1, 2), ")->current, 1u);
    EXPECT_EQ(help("limit := MAX((counter + 1")->callee, "MAX") << "parentheses that group are no call";
    const auto named = help("pulse(PT := T#1s, IN := ");
    ASSERT_TRUE(named);
    EXPECT_EQ(named->parameters[named->current].name, "IN");
    EXPECT_FALSE(help("pulse( // IN := ")) << "not in a comment";
}

TEST_F(ProjectEditsTest, HoverShowsThePinsOfALibraryBlock) {
    const auto model = window->workspace().presentModel();
    const auto file = *model->fileOf("src/main.st");
    const auto hover = model->hover(file, place("src/main.st", "TON"));
    ASSERT_TRUE(hover);
    for (const char* pin : {"FUNCTION_BLOCK TON", "→ IN : BOOL", "→ PT : TIME", "← Q : BOOL", "← ET : TIME"})
        EXPECT_NE(hover->declaration.find(pin), std::string::npos) << hover->declaration;
    window->tabs().goTo("src/main.st", place("src/main.st", "TON"));
    window->units().definitionAtCursor();
    ASSERT_NE(window->tabs().currentEditor(), nullptr);
    EXPECT_TRUE(window->tabs().currentEditor()->isReadOnly());
    EXPECT_NE(window->tabs().currentEditor()->utf8().find("FUNCTION_BLOCK TON"), std::string::npos);
}

TEST_F(ProjectEditsTest, AnUnknownMemberIsDeclaredInItsBlock) {
    StEditor& here = open("src/line.st");
    const uint32_t at = place("src/line.st", "b := a;");
    here.applyEdits({{{FileId(), at, at}, "drive.speed := 1.5; "}});
    ASSERT_TRUE(waitFor([&] { return !here.diagnosticsHere().empty(); }));
    here.goTo(at + 8);
    here.applyFix();
    EXPECT_NE(text("src/motor.st").find("    run : BOOL; // on\n    speed : REAL;\nEND_VAR"), std::string::npos)
        << text("src/motor.st");
}

TEST_F(ProjectEditsTest, AnUnknownNameBecomesAnInputWhenWanted) {
    StEditor& here = editor();
    const auto at = static_cast<uint32_t>(here.utf8().find("counter := counter"));
    here.applyEdits({{{FileId(), at, at}, "level := 1.5;\n"}});
    ASSERT_TRUE(waitFor([&] { return !here.diagnosticsHere().empty(); }));
    here.goTo(at + 1);
    inNextMenu(window.get(), [](QMenu& menu) {
        QTest::keyClick(&menu, Qt::Key_Down); // the second: an input
        QTest::keyClick(&menu, Qt::Key_Return);
    });
    here.applyFix();
    EXPECT_NE(here.utf8().find("PROGRAM Main\nVAR_INPUT\n    level : REAL;\nEND_VAR\nVAR\n"), std::string::npos)
        << here.utf8();
}

TEST_F(ProjectEditsTest, TheTableOfDeclarationsAddsMovesCommentsAndRenames) {
    StEditor& here = open("src/line.st");
    window->action("view.table")->trigger();
    auto& table = window->tabs().currentPage()->table();
    here.goTo(place("src/line.st", "a := 1"));
    const auto rowOf = [&](const QString& name) {
        for (int row = 0; row < table.table().rowCount(); ++row)
            if (table.table().item(row, 1)->text() == name) return row;
        return -1;
    };
    const auto settled = [&] { return waitFor([&] { return table.table().rowCount() > 0; }); };
    ASSERT_TRUE(waitFor([&] { return rowOf("drive") == 2; }));
    table.table().item(2, 5)->setText("the main drive");
    ASSERT_TRUE(
        waitFor([&] { return text("src/line.st").find("drive : Motor; // the main drive\n") != std::string::npos; }));
    ASSERT_TRUE(waitFor([&] { return rowOf("drive") == 2 && table.table().item(2, 5)->text() == "the main drive"; }));
    ASSERT_NE(window->workspace().presentModel(), nullptr);
    table.table().setCurrentCell(2, 1);
    table.moveSelected(-1);
    ASSERT_TRUE(waitFor([&] { return rowOf("drive") == 0; }));
    EXPECT_NE(text("src/line.st").find("VAR\n    drive : Motor; // the main drive\n    a, b : INT;\n"),
              std::string::npos)
        << text("src/line.st");
    table.table().setCurrentCell(rowOf("a"), 1);
    table.removeSelected();
    ASSERT_TRUE(waitFor([&] { return settled() && rowOf("a") < 0; }));
    EXPECT_NE(text("src/line.st").find("    b : INT;\n"), std::string::npos) << text("src/line.st");
    table.addVariable(syntax::SectionKind::Input);
    ASSERT_TRUE(waitFor([&] { return rowOf("newVariable") == 0; })) << text("src/line.st");
    if (QWidget* field = QApplication::focusWidget()) QTest::keyClick(field, Qt::Key_Escape);
    table.table().item(rowOf("drive"), 1)->setText("mover");
    EXPECT_TRUE(waitFor([&] { return text("tests/line.st").find("Line.mover.run") != std::string::npos; }))
        << "in the whole project";
    for (int i = 0; i < 5; ++i) QTest::keyClick(&here, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(here.utf8().find("    a, b : INT;\n    drive : Motor; // the first\n"), std::string::npos) << here.utf8();
    EXPECT_NE(text("tests/line.st").find("Line.drive.run"), std::string::npos);
}

TEST_F(ProjectEditsTest, TheTreeIsArrangedByFileAndShowsWhatLibrariesHold) {
    EXPECT_EQ(item("Motor")->data(0, Qt::UserRole + 6).toString(), "motor.st") << "the file stands behind each unit";
    QTreeWidgetItem* timer = item("TON");
    ASSERT_NE(timer, nullptr) << "what a library offers";
    auto* toggle = window->projectTree().findChild<QToolButton*>();
    ASSERT_NE(toggle, nullptr);
    for (QToolButton* each : window->projectTree().findChildren<QToolButton*>())
        if (each->isCheckable()) toggle = each;
    toggle->click();
    ASSERT_NE(item("motor.st"), nullptr);
    EXPECT_EQ(item("Motor")->parent()->text(0), "motor.st");
    tree().setCurrentItem(item("motor.st"));
    tree().setFocus();
    typeIntoNext(window.get(), "drives");
    QTest::keyClick(&tree(), Qt::Key_F2);
    EXPECT_TRUE(waitFor([&] { return item("drives.st") && item("drives.st")->childCount() > 0; }));
    EXPECT_TRUE(QFile::exists(folder.path() + "/src/drives.st"));
    toggle->click();
    EXPECT_EQ(item("drives.st"), nullptr);
}

TEST_F(ProjectEditsTest, AnExampleIsOpenedAsACopy) {
    QTemporaryDir projects;
    Settings().setProjectsFolder(projects.path());
    const QString example = folder.path() + "/shipped/press";
    ASSERT_TRUE(createProject(example.toStdString(), "Press", "empty"));
    ASSERT_TRUE(window->openExample(example, false));
    EXPECT_EQ(window->workspace().folder(), projects.path() + "/press");
    ASSERT_TRUE(waitFor([&] { return window->tabs().currentEditor() != nullptr; }));
    QTest::keyClicks(window->tabs().currentEditor(), "x");
    window->action("file.save")->trigger();
    QFile original(example + "/src/main.st");
    ASSERT_TRUE(original.open(QIODevice::ReadOnly));
    EXPECT_TRUE(original.readAll().startsWith("PROGRAM")) << "the shipped file stays as it is";
    ASSERT_TRUE(window->openExample(example, false));
    EXPECT_EQ(window->workspace().text("src/main.st").substr(0, 1), "x") << "the work is found again";
    ASSERT_TRUE(window->openExample(example, true));
    EXPECT_EQ(window->workspace().folder(), projects.path() + "/press_2");
    EXPECT_EQ(window->workspace().text("src/main.st").substr(0, 7), "PROGRAM");
}

TEST_F(ProjectEditsTest, AFileOfAnOlderEditorKeepsItsLettersAndItsLineEnds) {
    write("src/old.st", "PROGRAM Old\r\nVAR\r\n    x : INT; // \xB0"
                        "C \x80\r\nEND_VAR\r\nIF x > 1 THEN\r\nEND_PROGRAM\r\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/old.st"); }));
    EXPECT_NE(text("src/old.st").find("// °C €\r\n"), std::string::npos) << text("src/old.st");
    EXPECT_FALSE(window->workspace().isModified("src/old.st")) << "it is written back in its own encoding";
    StEditor& here = open("src/old.st");
    here.goTo(place("src/old.st", "THEN") + 4);
    QTest::keyClick(&here, Qt::Key_Return);
    ASSERT_TRUE(window->workspace().save("src/old.st"));
    QFile saved(folder.path() + "/src/old.st");
    ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
    const QByteArray bytes = saved.readAll();
    EXPECT_EQ(bytes.count('\n'), bytes.count("\r\n")) << "no line end of another kind";
    EXPECT_TRUE(bytes.contains("\xB0"
                               "C \x80"))
        << "Windows-1252 as before";
    EXPECT_TRUE(bytes.contains("THEN\r\n    \r\nEND_IF;\r\n")) << bytes.toStdString();
}

TEST_F(ProjectEditsTest, AReloadFromOutsideCanBeTakenBack) {
    StEditor& here = open("src/motor.st");
    const std::string before = here.utf8();
    write("src/motor.st", "FUNCTION_BLOCK Motor\nEND_FUNCTION_BLOCK\n");
    ASSERT_TRUE(waitFor([&] { return here.utf8().size() < 60; }));
    EXPECT_FALSE(window->workspace().isModified("src/motor.st"));
    QTest::keyClick(&here, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(here.utf8(), before);
    EXPECT_TRUE(window->workspace().isModified("src/motor.st"));
}

TEST_F(ProjectEditsTest, AFileDeletedOutsideStaysWhileItIsEditedHere) {
    StEditor& here = open("src/motor.st");
    QTest::keyClicks(&here, "//");
    ASSERT_TRUE(QFile::remove(folder.path() + "/src/motor.st"));
    // A file that comes later is seen later: then the one that went has been seen as well.
    write("src/later.st", "FUNCTION_BLOCK Later\nEND_FUNCTION_BLOCK\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/later.st"); }));
    ASSERT_NE(window->tabs().pageOf("src/motor.st"), nullptr);
    ASSERT_TRUE(window->workspace().save("src/motor.st"));
    EXPECT_TRUE(QFile::exists(folder.path() + "/src/motor.st"));
    ASSERT_TRUE(QFile::remove(folder.path() + "/src/line.st"));
    EXPECT_TRUE(waitFor([&] { return !window->workspace().files().contains("src/line.st"); }));
}

TEST_F(ProjectEditsTest, ANewUnitsDialogRefusesTakenNamesAndBeginsWhereOneIs) {
    NewUnitDialog dialog(window->workspace().files(), {"motor"}, window.get());
    dialog.preset("block", "src/line.st");
    EXPECT_EQ(dialog.templateId(), "block");
    EXPECT_EQ(dialog.file(), "src/line.st");
    auto* name = dialog.findChild<QLineEdit*>();
    const auto mayCreate = [&] {
        for (QAbstractButton* each : dialog.findChildren<QAbstractButton*>())
            if (each->text() == "Create") return each->isEnabled();
        return false;
    };
    name->setText("MOTOR");
    EXPECT_FALSE(mayCreate());
    name->setText("Pump");
    EXPECT_TRUE(mayCreate());
    name->setText(QString(200, 'n'));
    dialog.preset({}, {});
    EXPECT_TRUE(mayCreate());
}

TEST_F(ProjectEditsTest, AnEmptyProjectAndOneWithoutAProgramAreQuiet) {
    QTemporaryDir empty;
    QDir(empty.path()).mkpath("src");
    QFile file(empty.path() + "/project.json");
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"name\": \"Empty\"}\n");
    file.close();
    ASSERT_TRUE(window->openProject(empty.path()));
    ASSERT_TRUE(waitFor([&] { return window->workspace().model() != nullptr; }));
    EXPECT_EQ(window->tabs().count(), 0);
    for (const char* id : {"run.start", "edit.rename", "edit.find", "edit.undo", "edit.format", "view.split"})
        if (window->action(id)->isEnabled()) window->action(id)->trigger();
    ASSERT_TRUE(waitFor([&] { return !window->control().isBuilding(); }));
    settle();
    const std::string name(200, 'n');
    ASSERT_TRUE(window->workspace().addFile("src/long.st", unitText("block", name)));
    EXPECT_TRUE(waitFor([&] { return item(QString::fromStdString(name)) != nullptr; }));
}

} // namespace
} // namespace plc::app
