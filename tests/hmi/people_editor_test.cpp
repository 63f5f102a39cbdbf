// Users and their rights as a designer sets them: roles, panels and languages are chosen, a password is typed twice,
// and an element's roles are picked from those that there are.
#include "design_studio.h"

#include "hmi/designer/editors/password_dialog.h"
#include "hmi/designer/editors/people_editor.h"
#include "hmi/designer/sheet/property_sheet.h"
#include "hmi/people/password.h"
#include "tests/support/answer.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>

namespace plc::hmi {
namespace {

struct PeopleChosen : testing::Test {
    Studio studio;
    PeopleEditor editor{*studio.context};
    void SetUp() override {
        studio.project.panels.push_back({QStringLiteral("service"), panelOf("")});
        editor.resize(1000, 600);
        editor.show();
        editor.addRole(); // "role"
        editor.addRole(); // "role2"
        editor.addUser(); // with the first role
        settle();
    }
    const User& user() const { return studio.project.people.users().front(); }
    /// A double click opens the cell, Down its list, and the keys choose there.
    QComboBox* open(QTableWidget& table, int column) {
        const QPoint at = table.visualItemRect(table.item(0, column)).center();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, at);
        return table.viewport()->findChild<QComboBox*>();
    }
    static void choose(QComboBox& combo, const QString& text) {
        combo.showPopup();
        const int row = combo.findText(text);
        ASSERT_GE(row, 0) << text.toStdString();
        const QModelIndex index = combo.model()->index(row, 0);
        combo.view()->scrollTo(index);
        const QPoint at = combo.view()->visualRect(index).center();
        QTest::mouseMove(combo.view()->viewport(), at);
        const int tooSoon = QApplication::doubleClickInterval(); // a release just after opening is not a choice
        QTest::qWait(tooSoon);                                   // a duration: the one above
        QTest::mouseClick(combo.view()->viewport(), Qt::LeftButton, {}, at);
        settle();
    }
    static void enter(QComboBox& combo) {
        QTest::keyClick(&combo, Qt::Key_Return);
        settle();
    }
};

TEST_F(PeopleChosen, RolesAreAddedAndTakenAwayFromTheList) {
    QComboBox* combo = open(editor.users(), PeopleEditor::Roles);
    ASSERT_NE(combo, nullptr);
    choose(*combo, QStringLiteral("+ role2"));
    EXPECT_EQ(combo->currentText().toStdString(), "role, role2");
    choose(*combo, QStringLiteral("\u2212 role"));
    EXPECT_EQ(combo->currentText().toStdString(), "role2");
    enter(*combo);
    EXPECT_EQ(user().roles.join(u'+').toStdString(), "role2");
    editor.undoStack().undo();
    EXPECT_EQ(user().roles.join(u'+').toStdString(), "role");
}

TEST_F(PeopleChosen, TheStartPanelAndTheLanguageAreThoseOfTheProject) {
    QComboBox* combo = open(editor.users(), PeopleEditor::StartPanel);
    ASSERT_NE(combo, nullptr);
    choose(*combo, QStringLiteral("service"));
    enter(*combo);
    EXPECT_EQ(user().startPanel.toStdString(), "service");
    combo = open(editor.users(), PeopleEditor::Language);
    ASSERT_NE(combo, nullptr);
    EXPECT_GE(combo->findText(QStringLiteral("da")), 0);
    QTest::keyClick(combo, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(combo, QStringLiteral("xx"));
    enter(*combo);
    EXPECT_EQ(user().language.toStdString(), "") << "the project does not speak it";
    EXPECT_TRUE(editor.problem().contains(QStringLiteral("xx"))) << editor.problem().toStdString();
    combo = open(editor.roles(), PeopleEditor::RoleStartPanel);
    ASSERT_NE(combo, nullptr);
    QTest::keyClick(combo, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(combo, QStringLiteral("cellar"));
    enter(*combo);
    EXPECT_EQ(studio.project.people.roles()[0].startPanel.toStdString(), "");
    EXPECT_TRUE(editor.problem().contains(QStringLiteral("cellar"))) << editor.problem().toStdString();
}

TEST_F(PeopleChosen, WhatIsAddedIsSeenAndItsNameTypedAtOnce) {
    for (int n = 0; n < 20; ++n) editor.addRole(); // more than there is room for
    const auto press = [&](const QString& text) {
        for (QToolButton* button : editor.findChildren<QToolButton*>())
            if (button->text() == text) QTest::mouseClick(button, Qt::LeftButton);
        settle();
        return QApplication::focusWidget();
    };
    QWidget* field = press(QStringLiteral("Add a Role"));
    ASSERT_TRUE(qobject_cast<QLineEdit*>(field));
    QTest::keyClicks(field, QStringLiteral("night"));
    QTest::keyClick(field, Qt::Key_Return);
    settle();
    const auto& roles = studio.project.people.roles();
    EXPECT_EQ(roles.back().name.toStdString(), "night");
    QTableWidget& table = editor.roles();
    EXPECT_TRUE(table.viewport()->rect().contains(table.visualItemRect(table.item(table.rowCount() - 1, 0)).center()));
    field = press(QStringLiteral("Add a User"));
    ASSERT_TRUE(qobject_cast<QLineEdit*>(field));
    QTest::keyClicks(field, QStringLiteral("ben"));
    QTest::keyClick(field, Qt::Key_Return);
    settle();
    EXPECT_EQ(studio.project.people.users().back().name.toStdString(), "ben");
}

TEST(PasswordDialog, TakesAPasswordOnlyTwiceAndSaysWhyNot) {
    PasswordDialog dialog(QStringLiteral("anna-maria"));
    dialog.show();
    const auto* buttons = dialog.findChild<QDialogButtonBox*>();
    const auto isOpen = [&] { return buttons->button(QDialogButtonBox::Ok)->isEnabled(); };
    EXPECT_FALSE(isOpen());
    QTest::keyClicks(&dialog.first(), QStringLiteral("abc"));
    EXPECT_TRUE(dialog.problem().contains(QStringLiteral("at least"))) << dialog.problem().toStdString();
    dialog.first().clear();
    QTest::keyClicks(&dialog.first(), QStringLiteral("anna-maria"));
    EXPECT_TRUE(dialog.problem().contains(QStringLiteral("name of the user"))) << dialog.problem().toStdString();
    dialog.first().clear();
    QTest::keyClicks(&dialog.first(), QStringLiteral("long enough"));
    EXPECT_FALSE(dialog.problem().isEmpty()) << "it is asked for again";
    QTest::keyClicks(&dialog.again(), QStringLiteral("long enouhg"));
    EXPECT_TRUE(dialog.problem().contains(QStringLiteral("differ"))) << dialog.problem().toStdString();
    EXPECT_FALSE(isOpen());
    dialog.again().clear();
    QTest::keyClicks(&dialog.again(), QStringLiteral("long enough"));
    EXPECT_TRUE(isOpen());
    EXPECT_EQ(dialog.problem().toStdString(), "");
    QTest::keyClick(&dialog.again(), Qt::Key_Return);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_EQ(dialog.password().toStdString(), "long enough");
}

TEST_F(PeopleChosen, AnElementIsKeptForRolesThatArePickedInThePropertySheet) {
    studio.designer->document().perform(
        {},
        {InsertElement{0, panelOf(R"({"id": "b", "kind": "button", "rect": [8, 8, 90, 40]})").elements()[0].fields()}});
    studio.designer->selection().set({ElementId(QStringLiteral("b"))});
    settle();
    auto* grid = studio.designer->findChild<kit::PropertyGrid*>();
    ASSERT_NE(grid, nullptr);
    ASSERT_NE(grid->descriptor(QStringLiteral("access")), nullptr);
    EXPECT_EQ(grid->descriptor(QStringLiteral("access"))->choices.size(), 2u);
    grid->editProperty(QStringLiteral("access"));
    settle();
    auto* button = grid->viewport()->findChild<QToolButton*>();
    ASSERT_NE(button, nullptr) << "a list to choose from";
    bool wasOffered = false;
    inNextMenu(grid, [&](QMenu& menu) {
        wasOffered = menu.actions().size() == 2;
        QTest::keyClick(&menu, Qt::Key_Down);
        QTest::keyClick(&menu, Qt::Key_Down);
        QTest::keyClick(&menu, Qt::Key_Return);
    });
    QTest::mouseClick(button, Qt::LeftButton);
    settle();
    EXPECT_TRUE(wasOffered);
    EXPECT_EQ(studio.panel().elements()[0].text("access").toStdString(), "role2");
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().elements()[0].text("access").toStdString(), "");
    editor.addRole();
    EXPECT_EQ(grid->descriptor(QStringLiteral("access"))->choices.size(), 3u) << "a new role is offered at once";
}

} // namespace
} // namespace plc::hmi
