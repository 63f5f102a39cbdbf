// Texts of panels in their table: keys, users, languages, as they are typed and taken out, with real events.
#include "design_studio.h"
#include "hmi/designer/editors/language_choice.h"
#include "hmi/designer/editors/text_editor.h"
#include "hmi/designer/panel_designer.h"
#include "tests/support/patience.h"

#include "editor/kit/inputs/text_question.h"

#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTimer>
#include <QToolButton>

namespace plc::hmi {
namespace {

TEST(Texts, TheTableEditorRenamesKeysEverywhereAndKnowsTheUsers) {
    Studio studio(R"({"id":"a","kind":"text","rect":[100,100,150,50],"text":"@start"})");
    TextEditor editor(*studio.context);
    EXPECT_EQ(studio.context->usersOf(QStringLiteral("start")).join(u' ').toStdString(), "main: a.text");
    EXPECT_TRUE(
        editor.model().setData(editor.model().index(0, TextModel::Key), QStringLiteral("motor.start"), Qt::EditRole));
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->text("text").toStdString(), "@motor.start");
    EXPECT_TRUE(
        editor.model().setData(editor.model().index(1, TextModel::Key), QStringLiteral("alarm.over"), Qt::EditRole));
    EXPECT_EQ(studio.project.alarms.definitions()[0].text.toStdString(), "@alarm.over");
    editor.addKey(QStringLiteral("new.key"));
    editor.setFilter({}, true);
    EXPECT_EQ(editor.shownKeys().join(u' ').toStdString(), "new.key");
    editor.setFilter(QStringLiteral("Blink"), false);
    EXPECT_EQ(editor.shownKeys().join(u' ').toStdString(), "flash");
    const std::string now = studio.project.texts.table().write();
    editor.addLanguage(QStringLiteral("fr"));
    editor.undoStack().undo();
    EXPECT_EQ(studio.project.texts.table().write(), now);
}

TEST(Texts, TheyAreCountedWhileTheyAreTypedInAPanel) {
    Studio studio;
    TextEditor editor(*studio.context);
    const auto says = [&](int count) {
        for (const QLabel* each : editor.findChildren<QLabel*>())
            if (each->text().startsWith(QStringLiteral("%1 text").arg(count))) return true;
        return false;
    };
    const int before = editor.model().rowCount();
    EXPECT_TRUE(says(before));
    QUndoStack undo;
    studio.context->storeText({}, QStringLiteral("Words that are new"), QStringLiteral("main"), undo);
    ASSERT_EQ(editor.model().rowCount(), before + 1);
    EXPECT_TRUE(says(before + 1));
}

TEST(Texts, ALanguageIsChosenByItsNameAndNonsenseIsRefused) {
    for (const auto& [typed, tag] : std::vector<std::pair<const char*, const char*>>{{"Deutsch (de)", "de"},
                                                                                     {"german", "de"},
                                                                                     {"Deutsch", "de"},
                                                                                     {"DE", "de"},
                                                                                     {"zh-CN", "zh-CN"},
                                                                                     {"de-AT", "de-AT"},
                                                                                     {"ar-u-nu-latn", "ar-u-nu-latn"},
                                                                                     {"", ""},
                                                                                     {"xx", ""},
                                                                                     {"machine", ""},
                                                                                     {"de,fr", ""},
                                                                                     {"c", ""},
                                                                                     {"1", ""}})
        EXPECT_EQ(languageTagOf(QString::fromUtf8(typed)).toStdString(), tag) << typed;
    EXPECT_TRUE(languagesToChoose().contains(QStringLiteral("Deutsch (de)")));
    Studio studio;
    TextEditor editor(*studio.context);
    editor.show();
    QToolButton* button = nullptr;
    for (QToolButton* each : editor.findChildren<QToolButton*>())
        if (each->text() == QStringLiteral("Add a language")) button = each;
    ASSERT_NE(button, nullptr);
    EXPECT_EQ(button->toolButtonStyle(), Qt::ToolButtonTextBesideIcon) << "it is found without pointing at it";
    QStringList seen, typed{QStringLiteral("machine"), QStringLiteral("fr")};
    QTimer answers; // with the keys
    QObject::connect(&answers, &QTimer::timeout, [&] {
        auto* question = qobject_cast<kit::TextQuestion*>(QApplication::activeModalWidget());
        if (!question || !question->isVisible()) return;
        if (!question->complaint().isEmpty()) seen << question->complaint();
        if (typed.isEmpty()) return question->reject();
        QLineEdit* field = question->findChild<QComboBox*>()->lineEdit();
        field->selectAll();
        QTest::keyClicks(field, typed.takeFirst());
        EXPECT_EQ(question->complaint(), "") << "of what stood there before";
        QTest::keyClick(field, Qt::Key_Return);
    });
    answers.start(20);
    QTest::mouseClick(button, Qt::LeftButton); // once: the dialog stays open
    ASSERT_EQ(seen.size(), 1) << seen.join(u'\n').toStdString();
    EXPECT_TRUE(seen[0].startsWith("machine is not a language tag; ")) << seen[0].toStdString();
    EXPECT_TRUE(typed.isEmpty());
    EXPECT_TRUE(studio.project.texts.table().tags().contains("fr"));
    EXPECT_FALSE(studio.project.texts.table().tags().contains("machine"));
}

TEST(Texts, ALanguageIsTakenOutByTheMenuOfItsColumnAndUndoBringsItBack) {
    Studio studio;
    TextEditor editor(*studio.context);
    editor.resize(900, 300);
    editor.show();
    editor.activateWindow();
    editor.setFocus();
    ASSERT_TRUE(QTest::qWaitFor([&] { return editor.view().hasFocus(); }, kPatience)) << "not the search line";
    const std::string before = studio.project.texts.table().write();
    const int column = TextModel::FirstLanguage + static_cast<int>(studio.project.texts.table().tags().indexOf("da"));
    QHeaderView* header = editor.view().horizontalHeader();
    const QPoint at(header->sectionViewportPosition(column) + 20, header->height() / 2);
    QTimer chooses;
    QObject::connect(&chooses, &QTimer::timeout, [&] {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        if (!menu) return;
        EXPECT_EQ(menu->actions().front()->text().remove(u'&').toStdString(), "Remove Dansk");
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions().front()).center());
    });
    chooses.start(20);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, header->viewport()->mapToGlobal(at));
    QApplication::sendEvent(header->viewport(), &event);
    chooses.stop();
    EXPECT_FALSE(studio.project.texts.table().tags().contains("da"));
    QTest::keyClick(editor.findChild<QLineEdit*>(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(studio.project.texts.table().write(), before) << "from an empty search line, too";
}

} // namespace
} // namespace plc::hmi
