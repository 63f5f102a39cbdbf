// Letters of menus and dialogs: each text has one where letters last, no two are alike, and what is written stays.
#include "editor/kit/mnemonics.h"
#include "tests/support/patience.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTest>

#include <gtest/gtest.h>

namespace plc::kit {
namespace {

QChar letterOf(const QString& text) {
    const qsizetype at = text.indexOf(u'&');
    return at < 0 ? QChar() : text[at + 1].toUpper();
}

TEST(Mnemonics, StartWordsAndAreUnique) {
    EXPECT_EQ(withMnemonics({"File", "Edit", "View"}, {}), (QStringList{"&File", "&Edit", "&View"}));
    EXPECT_EQ(withMnemonics({"Save", "Save All", "Save As"}, {}), (QStringList{"&Save", "Save &All", "Sa&ve As"}));
    EXPECT_EQ(withMnemonics({"Étape", "Tout"}, {}), (QStringList{"É&tape", "T&out"}));
}

TEST(Mnemonics, APushedTextTakesItsNextLetter) {
    const QStringList given = withMnemonics({"ab", "a"}, {});
    EXPECT_EQ(given, (QStringList{"a&b", "&a"})) << "the short one has no other letter";
}

TEST(Mnemonics, AWrittenLetterStays) {
    EXPECT_EQ(withMnemonics({"Undo", "&Up"}, {}), (QStringList{"U&ndo", "&Up"}));
    EXPECT_EQ(withMnemonics({"&Up", "&Use"}, {}), (QStringList{"&Up", "U&se"})) << "the second of two alike gives way";
    EXPECT_EQ(withMnemonics({"Search && replace"}, {}), (QStringList{"&Search && replace"}));
}

TEST(Mnemonics, ChineseHasTheLetterOfTheNameBehindIt) {
    EXPECT_EQ(withMnemonics({"打开项目…", "保存", "退出"}, {"open", "save", "quit"}),
              (QStringList{"打开项目(&O)…", "保存(&S)", "退出(&Q)"}));
    EXPECT_EQ(withMnemonics({"画面名称：", "重复:"}, {"name", "repeat"}), (QStringList{"画面名称(&N)：", "重复(&R):"}));
    EXPECT_EQ(withoutMnemonic("打开项目(&O)…"), "打开项目…");
    EXPECT_EQ(withoutMnemonic("Sa&ve && quit"), "Save && quit");
    EXPECT_EQ(withoutMnemonic("Plain"), "Plain");
}

TEST(Mnemonics, MoreTextsThanLettersLeaveSomeWithout) {
    QStringList texts;
    for (int i = 0; i < 50; ++i) texts << "保存";
    QString seen;
    for (const QString& text : withMnemonics(texts, {})) {
        if (letterOf(text).isNull()) continue;
        EXPECT_FALSE(seen.contains(letterOf(text)));
        seen += letterOf(text);
    }
    EXPECT_EQ(seen.size(), 26);
}

TEST(Mnemonics, AMenuGetsThemWhenItOpensAndKeepsThem) {
    keepMnemonics(*qApp);
    QMenu menu;
    QAction* first = menu.addAction("Stop");
    emit menu.aboutToShow();
    EXPECT_EQ(first->text(), "&Stop");
    QAction* second = menu.addAction("Start");
    emit menu.aboutToShow();
    EXPECT_EQ(first->text(), "&Stop");
    EXPECT_EQ(second->text(), "S&tart");
}

TEST(Mnemonics, ALetterPressesTheButtonOfADialog) {
    keepMnemonics(*qApp);
    QDialog dialog;
    auto* form = new QFormLayout(&dialog);
    auto* name = new QLineEdit(&dialog);
    auto* check = new QCheckBox("Names", &dialog);
    form->addRow("Name", name);
    form->addRow(check);
    dialog.show();
    dialog.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog, kPatience));
    auto* label = qobject_cast<QLabel*>(form->labelForField(name));
    const auto press = [&](const QString& text) {
        ASSERT_FALSE(letterOf(text).isNull()) << text.toStdString();
        QTest::keyClick(&dialog, static_cast<Qt::Key>(letterOf(text).unicode()), Qt::AltModifier);
    };
    EXPECT_NE(letterOf(check->text()), letterOf(label->text()));
    press(check->text());
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return check->isChecked(); }, kPatience)); // pressed for a moment, as a finger does
    press(label->text());
    EXPECT_TRUE(name->hasFocus());
}

} // namespace
} // namespace plc::kit
