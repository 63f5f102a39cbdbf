// The editors of recipes and of users: what is typed is kept, refused or undone byte for byte, and saved.
#include "design_studio.h"

#include "hmi/designer/editors/people_editor.h"
#include "hmi/designer/editors/recipe_editor.h"
#include "hmi/people/password.h"
#include "projects/storage/project_file.h"

#include <QDir>
#include <QListWidget>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolBar>

namespace plc::hmi {
namespace {

/// Types into a cell as a person does: double click, text, Enter.
void type(QTableWidget& table, int row, int column, const QString& text) {
    table.setCurrentCell(row, column);
    table.editItem(table.item(row, column));
    QWidget* editor = table.viewport()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(editor, Qt::Key_Delete);
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::processEvents(); // the delegate takes the text over when the key has been handled
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

struct Recipes : testing::Test {
    Studio studio;
    QTemporaryDir folder;
    RecipeEditor editor{*studio.context};
    void SetUp() override {
        studio.project.folder = folder.path();
        editor.resize(1000, 600);
        editor.show();
    }
    const Recipe& only() const { return studio.project.recipes.recipes().front(); }
    std::string bytes() const { return studio.project.recipes.write(); }
};

TEST_F(Recipes, ARecipeIsMadeInTheTableAndUndoneByteForByte) {
    const std::string before = bytes();
    editor.addRecipe();
    editor.addVariable(QStringLiteral("Main.level"));
    editor.addVariable(QStringLiteral("Main.count"));
    type(editor.table(), 0, RecipeEditor::Unit, QStringLiteral("mm"));
    type(editor.table(), 0, RecipeEditor::Minimum, QStringLiteral("1.5"));
    type(editor.table(), 0, RecipeEditor::Maximum, QStringLiteral("90"));
    type(editor.table(), 0, RecipeEditor::FirstSet, QStringLiteral("12.5"));
    type(editor.table(), 1, RecipeEditor::FirstSet, QStringLiteral("7"));
    editor.addSet();
    EXPECT_EQ(only().sets[1].name.toStdString(), "set2");
    EXPECT_EQ(editor.renameSet(RecipeEditor::FirstSet + 1, QStringLiteral("strong")), "");
    type(editor.table(), 0, RecipeEditor::FirstSet + 1, QStringLiteral("80.0"));
    ASSERT_EQ(only().variables.size(), 2u);
    EXPECT_EQ(only().variables[0].minimum, 1.5);
    EXPECT_EQ(only().sets[1].name.toStdString(), "strong");
    EXPECT_EQ(only().sets[1].values.value("Main.level").toStdString(), "80.0");
    EXPECT_EQ(only().sets[1].values.value("Main.count").toStdString(), "7") << "a new set begins as the last one";
    EXPECT_EQ(editor.problems().toStdString(), "");
    const std::string after = bytes();
    while (editor.undoStack().canUndo()) editor.undoStack().undo();
    EXPECT_EQ(bytes(), before);
    while (editor.undoStack().canRedo()) editor.undoStack().redo();
    EXPECT_EQ(bytes(), after);
    EXPECT_TRUE(studio.context->areRecipesChanged());
    ASSERT_TRUE(studio.context->save());
    EXPECT_EQ(*projects::readFile(studio.project.recipesPath().toStdString()), after);
    EXPECT_FALSE(studio.context->areRecipesChanged());
}

TEST_F(Recipes, WhatIsWrongStandsInItsCellAndWhatIsNoNumberIsNotTaken) {
    editor.addRecipe();
    editor.addVariable(QStringLiteral("Main.lvel"));
    EXPECT_FALSE(editor.table().item(0, RecipeEditor::Variable)->toolTip().isEmpty());
    EXPECT_FALSE(editor.problems().isEmpty());
    type(editor.table(), 0, RecipeEditor::Variable, QStringLiteral("Main.level"));
    type(editor.table(), 0, RecipeEditor::Maximum, QStringLiteral("10"));
    type(editor.table(), 0, RecipeEditor::FirstSet, QStringLiteral("11.0"));
    EXPECT_FALSE(editor.table().item(0, RecipeEditor::FirstSet)->toolTip().isEmpty()) << "above the limit";
    EXPECT_TRUE(editor.problems().startsWith(QStringLiteral("set1: "))) << editor.problems().toStdString();
    EXPECT_GE(editor.table().columnWidth(RecipeEditor::FirstSet),
              editor.table().fontMetrics().horizontalAdvance(QStringLiteral("11.0")) + 16)
        << "the value is seen beside the icon";
    type(editor.table(), 0, RecipeEditor::Maximum, QStringLiteral("many"));
    EXPECT_EQ(only().variables[0].maximum, 10);
    EXPECT_EQ(editor.table().item(0, RecipeEditor::Maximum)->text().toStdString(), "10");
    editor.addRecipe();
    editor.list().item(1)->setText(QStringLiteral("recipe"));
    EXPECT_EQ(studio.project.recipes.recipes()[1].name.toStdString(), "recipe2") << "a name is there once";
}

/// A press on the key of the tool bar with that text.
void pressKey(QWidget& editor, const QString& text) {
    for (QAction* action : editor.findChild<QToolBar*>()->actions()) {
        if (action->text().remove(u'&') != text) continue;
        auto* key = editor.findChild<QToolBar*>()->widgetForAction(action);
        ASSERT_NE(key, nullptr) << text.toStdString();
        return QTest::mouseClick(key, Qt::LeftButton);
    }
    FAIL() << "no key " << text.toStdString();
}

TEST_F(Recipes, AreMadeNamedAndUndoneWithMouseAndKeys) {
    const std::string before = bytes();
    pressKey(editor, QStringLiteral("Add a Recipe"));
    ASSERT_EQ(editor.list().count(), 1);
    // A name as in any list: double click, text, Enter.
    const QPoint at = editor.list().visualItemRect(editor.list().item(0)).center();
    QTest::mouseClick(editor.list().viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(editor.list().viewport(), Qt::LeftButton, {}, at);
    auto* name = editor.list().viewport()->findChild<QLineEdit*>();
    ASSERT_NE(name, nullptr);
    QTest::keyClick(name, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(name, QStringLiteral("dough"));
    QTest::keyClick(name, Qt::Key_Return);
    QCoreApplication::processEvents();
    EXPECT_EQ(only().name.toStdString(), "dough");
    editor.addVariable(QStringLiteral("Main.level")); // from the list of variables
    pressKey(editor, QStringLiteral("Add a Set"));
    ASSERT_EQ(only().sets.size(), 2u);
    type(editor.table(), 0, RecipeEditor::FirstSet + 1, QStringLiteral("4.0"));
    const std::string full = bytes();
    editor.table().setCurrentCell(0, RecipeEditor::FirstSet + 1);
    pressKey(editor, QStringLiteral("Remove Row or Set"));
    EXPECT_EQ(only().sets.size(), 1u);
    editor.table().setFocus();
    QTest::keySequence(&editor.table(), QKeySequence::Undo);
    EXPECT_EQ(bytes(), full) << "the set is back with its value";
    pressKey(editor, QStringLiteral("Remove Recipe"));
    EXPECT_TRUE(studio.project.recipes.recipes().empty());
    while (editor.undoStack().canUndo()) QTest::keySequence(&editor.table(), QKeySequence::Undo);
    EXPECT_EQ(bytes(), before);
}

TEST_F(Recipes, AnotherNameFollowsIntoThePanelsAndBackInOneStep) {
    editor.addRecipe();
    editor.list().item(0)->setText(QStringLiteral("dough"));
    const auto panelWith = [](const char* recipe) {
        return panelOf(std::string(R"({"id": "r", "kind": "recipe", "rect": [8, 8, 520, 320], "recipe": ")") + recipe +
                       R"("}, {"id": "other", "kind": "recipe", "rect": [8, 340, 520, 320], "recipe": "doughnut"})");
    };
    studio.project.panels.push_back({QStringLiteral("closed"), panelWith("dough")});
    studio.designer->document().perform({}, {InsertElement{0, panelWith("dough").elements()[0].fields()}});
    const auto names = [&] {
        const Panel& closed = studio.project.panels.back().panel;
        return (closed.elements()[0].text("recipe") + u' ' + closed.elements()[1].text("recipe") + u' ' +
                studio.panel().elements()[0].text("recipe"))
            .toStdString();
    };
    const int steps = editor.undoStack().count();
    editor.list().item(0)->setText(QStringLiteral("bread"));
    EXPECT_EQ(names(), "bread doughnut bread");
    EXPECT_TRUE(studio.context->isPanelChanged(QStringLiteral("closed"))) << "it is saved with the rest";
    EXPECT_EQ(editor.undoStack().count(), steps + 1);
    editor.undoStack().undo();
    EXPECT_EQ(names(), "dough doughnut dough");
    EXPECT_EQ(only().name.toStdString(), "dough");
    editor.undoStack().redo();
    EXPECT_EQ(names(), "bread doughnut bread");
}

TEST_F(Recipes, WhatIsRefusedSaysWhy) {
    editor.addRecipe();
    editor.addVariable(QStringLiteral("Main.level"));
    editor.addVariable(QStringLiteral("Main.count"));
    editor.addSet();
    const std::string before = bytes();
    const auto isSaid = [&](const char* what) {
        EXPECT_TRUE(editor.problems().contains(QLatin1String(what))) << editor.problems().toStdString();
        EXPECT_EQ(bytes(), before);
    };
    type(editor.table(), 0, RecipeEditor::Minimum, QStringLiteral("1,5"));
    isSaid("\"1,5\" is not a number");
    type(editor.table(), 1, RecipeEditor::Variable, QStringLiteral("Main.level"));
    isSaid("Main.level is already in the recipe; choose another variable");
    type(editor.table(), 1, RecipeEditor::Variable, QString());
    isSaid("needs a variable");
    EXPECT_TRUE(editor.renameSet(RecipeEditor::FirstSet + 1, QStringLiteral("set1")).contains("\"set1\" already"));
    EXPECT_EQ(bytes(), before);
    editor.list().item(0)->setText(QStringLiteral(" "));
    isSaid("needs a name");
    type(editor.table(), 0, RecipeEditor::Minimum, QStringLiteral("1.5"));
    EXPECT_FALSE(editor.problems().contains(QStringLiteral("needs a name"))) << "what is right ends the reproach";
}

TEST_F(Recipes, WhatCannotBeWrittenIsSaidAndNothingIsLost) {
    editor.addRecipe();
    ASSERT_TRUE(QDir(folder.path()).mkpath(QStringLiteral("hmi/recipes.json/in the way"))); // as good as a full disk
    const auto saved = studio.context->save();
    ASSERT_FALSE(saved);
    EXPECT_NE(saved.error().place.find("recipes.json"), std::string::npos) << saved.error().place;
    EXPECT_TRUE(studio.context->areRecipesChanged()) << "it can be saved again";
    ASSERT_TRUE(QDir(folder.filePath(QStringLiteral("hmi/recipes.json"))).removeRecursively());
    ASSERT_TRUE(studio.context->save());
    EXPECT_FALSE(studio.context->areRecipesChanged());
    editor.exportCsv(folder.filePath(QStringLiteral("no such folder/r.csv")));
    EXPECT_TRUE(editor.problems().contains(QStringLiteral("r.csv"))) << editor.problems().toStdString();
}

TEST_F(Recipes, CsvGoesOutAndComesBackAsOneStep) {
    editor.addRecipe();
    editor.addVariable(QStringLiteral("Main.level"));
    type(editor.table(), 0, RecipeEditor::FirstSet, QStringLiteral("3.5"));
    const QString path = folder.filePath(QStringLiteral("r.csv"));
    editor.exportCsv(path);
    std::string csv = *projects::readFile(path.toStdString());
    const size_t at = csv.find("3.5");
    ASSERT_NE(at, std::string::npos) << csv;
    csv.replace(at, 3, "4.5");
    ASSERT_TRUE(projects::writeFileAtomically(path.toStdString(), csv));
    const int steps = editor.undoStack().count();
    editor.importCsv(path);
    EXPECT_EQ(only().sets[0].values.value("Main.level").toStdString(), "4.5");
    EXPECT_EQ(editor.undoStack().count(), steps + 1);
    ASSERT_TRUE(projects::writeFileAtomically(path.toStdString(), "nothing of the kind\n"));
    editor.importCsv(path);
    EXPECT_FALSE(editor.problems().isEmpty());
    EXPECT_EQ(only().sets[0].values.value("Main.level").toStdString(), "4.5");
}

struct PeopleInTheEditor : testing::Test {
    Studio studio;
    QTemporaryDir folder;
    PeopleEditor editor{*studio.context};
    void SetUp() override {
        studio.project.folder = folder.path();
        editor.resize(1000, 600);
        editor.show();
    }
    const PeopleFile& people() const { return studio.project.people; }
};

TEST_F(PeopleInTheEditor, UsersAndRolesAreTypedAndUndoneByteForByte) {
    const std::string before = people().write();
    editor.addRole();
    type(editor.roles(), 0, PeopleEditor::RoleName, QStringLiteral("operator"));
    editor.addUser();
    type(editor.users(), 0, PeopleEditor::Name, QStringLiteral("anna"));
    editor.addRole();
    type(editor.roles(), 1, PeopleEditor::RoleName, QStringLiteral("service"));
    type(editor.users(), 0, PeopleEditor::Roles, QStringLiteral("operator, service"));
    editor.timeout().setValue(600);
    ASSERT_NE(people().find("anna"), nullptr);
    EXPECT_EQ(people().find("anna")->roles.join(u'+').toStdString(), "operator+service");
    EXPECT_EQ(people().timeout(), 600);
    type(editor.roles(), 1, PeopleEditor::RoleName, QStringLiteral("engineer"));
    EXPECT_EQ(people().find("anna")->roles.join(u'+').toStdString(), "operator+engineer") << "a renamed role is kept";
    const std::string after = people().write();
    EXPECT_TRUE(PeopleFile::parse(after, {})) << "what is edited here can be read";
    while (editor.undoStack().canUndo()) editor.undoStack().undo();
    EXPECT_EQ(people().write(), before);
    while (editor.undoStack().canRedo()) editor.undoStack().redo();
    EXPECT_EQ(people().write(), after);
    ASSERT_TRUE(studio.context->save());
    EXPECT_EQ(*projects::readFile(studio.project.peoplePath().toStdString()), after);
}

TEST_F(PeopleInTheEditor, ARenamedRoleIsTheOneThatElementsAreKeptFor) {
    editor.addRole();
    editor.addRole();
    const std::string before = people().write();
    studio.project.panels.push_back(
        {QStringLiteral("closed"),
         panelOf(R"({"id": "b", "kind": "button", "rect": [8, 8, 90, 40], "access": "role2, role"},
                    {"id": "c", "kind": "button", "rect": [8, 60, 90, 40], "access": "role3"})")});
    const auto access = [&](size_t index) {
        return studio.project.panels.back().panel.elements()[index].text("access").toStdString();
    };
    type(editor.roles(), 0, PeopleEditor::RoleName, QStringLiteral("operator"));
    EXPECT_EQ(access(0), "role2, operator");
    EXPECT_EQ(access(1), "role3");
    editor.undoStack().undo();
    EXPECT_EQ(access(0), "role2, role");
    EXPECT_EQ(people().write(), before);
}

TEST_F(PeopleInTheEditor, APasswordIsKeptHashedAndAWeakOneRefused) {
    editor.addRole();
    editor.addUser();
    EXPECT_FALSE(editor.setPassword(0, QStringLiteral("1")));
    EXPECT_TRUE(editor.problem().contains(QStringLiteral("at least"))) << editor.problem().toStdString();
    ASSERT_TRUE(editor.setPassword(0, QStringLiteral("long enough")));
    EXPECT_TRUE(isPassword(QStringLiteral("long enough"), people().users()[0].password));
    EXPECT_EQ(people().write().find("long enough"), std::string::npos);
    EXPECT_FALSE(editor.users().item(0, PeopleEditor::Password)->text().contains("long"));
    EXPECT_FALSE(editor.setPassword(7, QStringLiteral("long enough")));
}

TEST_F(PeopleInTheEditor, NamesThatAreTakenAndRolesThatAreNotThereAreRefused) {
    editor.addRole();
    editor.addUser();
    editor.addUser();
    type(editor.users(), 1, PeopleEditor::Name, QStringLiteral("USER"));
    EXPECT_EQ(people().users()[1].name.toStdString(), "user2");
    EXPECT_TRUE(editor.problem().contains(QStringLiteral("USER"))) << editor.problem().toStdString();
    type(editor.users(), 0, PeopleEditor::Roles, QStringLiteral("captain"));
    EXPECT_EQ(people().users()[0].roles.join(u'+').toStdString(), "role");
    editor.roles().setCurrentCell(0, 0);
    editor.removeSelectedRole();
    EXPECT_TRUE(people().users()[0].roles.isEmpty()) << "nobody has a role that is not there";
    EXPECT_TRUE(PeopleFile::parse(people().write(), {}));
}

} // namespace
} // namespace plc::hmi
