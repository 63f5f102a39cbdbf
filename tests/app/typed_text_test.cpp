// Typing as one means it: a new document has the keyboard, an END_… is not written twice, Enter in the watch line takes
// the name that was begun.
#include "app/project/new_project.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/inputs/expression_edit.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAction>
#include <QInputDialog>
#include <QLineEdit>

namespace plc::app {
namespace {

class TypedTextTest : public StudioTest {
protected:
    [[nodiscard]] qsizetype count(const char* word) { return QString::fromStdString(editor().utf8()).count(word); }
};

TEST_F(TypedTextTest, AnEndBelowTheOneThatEnterHasWrittenIsThatOne) {
    typeAtEnd("IF done THEN");
    QTest::keyClick(editor().viewport(), Qt::Key_Return);
    ASSERT_EQ(count("END_IF"), 2) << "one came by itself";
    QTest::keyClicks(editor().viewport(), "counter := 1;");
    QTest::keyClick(editor().viewport(), Qt::Key_Return);
    QTest::keyClicks(editor().viewport(), "end_if;");
    EXPECT_EQ(count("END_IF"), 2);
    EXPECT_EQ(count("END_IF;"), 1);
    EXPECT_EQ(count("end_if"), 0);
    QTest::keyClicks(editor().viewport(), " // done"); // behind the block now
    EXPECT_EQ(count("END_IF; // done"), 1) << editor().utf8();
}

TEST_F(TypedTextTest, AProgramTypedLineByLineWithItsEndsIsThatProgram) {
    editor().selectAll();
    const QStringList lines{"PROGRAM Main",       "VAR",         "a, b : BOOL;", "n : INT;",   "END_VAR",
                            "a := NOT b;",        "IF a THEN",   "n := n + 1;",  "END_IF",     "b := n > 3;",
                            "FOR n := 1 TO 3 DO", "b := NOT b;", "END_FOR;",     "END_PROGRAM"};
    for (const QString& line : lines) {
        if (line != lines.front()) QTest::keyClick(editor().viewport(), Qt::Key_Return);
        QTest::keyClicks(editor().viewport(), line);
    }
    EXPECT_EQ(editor().utf8(),
              "PROGRAM Main\nVAR\n    a, b : BOOL;\n    n : INT;\nEND_VAR\na := NOT b;\nIF a THEN\n    n := "
              "n + 1;\nEND_IF;\nb := n > 3;\nFOR n := 1 TO 3 DO\n    b := NOT b;\nEND_FOR;\nEND_PROGRAM")
        << "as the formatter has it, each end once";
}

TEST_F(TypedTextTest, AListOfNamesClosesWhenTheEditorIsTakenElsewhere) {
    typeAtEnd("cou");
    using S = QsciScintillaBase;
    ASSERT_TRUE(waitFor([&] { return editor().SendScintilla(S::SCI_AUTOCACTIVE) != 0; }));
    editor().goTo(0); // as a fault, a breakpoint or a click on a problem does
    EXPECT_EQ(editor().SendScintilla(S::SCI_AUTOCACTIVE), 0);
}

TEST_F(TypedTextTest, AnEndThatClosesAnotherBlockIsWritten) {
    typeAtEnd("IF done THEN");
    QTest::keyClick(editor().viewport(), Qt::Key_Return);
    QTest::keyClicks(editor().viewport(), "IF pulse.Q THEN counter := 1; ");
    QTest::keyClicks(editor().viewport(), "END_IF;");
    EXPECT_EQ(count("END_IF"), 3) << editor().utf8();
    QTest::keyClick(editor().viewport(), Qt::Key_Return);
    QTest::keyClicks(editor().viewport(), "END_IF;");
    EXPECT_EQ(count("END_IF"), 3) << "and this one is the outer one's";
}

TEST_F(TypedTextTest, EnterInTheWatchLineTakesTheNameThatWasBegun) {
    window->showDock("watch");
    auto* line = window->watch().findChild<kit::ExpressionEdit*>();
    ASSERT_NE(line, nullptr);
    line->setFocus();
    QTest::keyClicks(line, "Main.coun");
    ASSERT_TRUE(waitFor([&] { return line->isCompletionShown(); }));
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(window->watch().expressions(), QStringList{"Main.counter"});
    EXPECT_EQ(line->text(), "");
    EXPECT_FALSE(line->isCompletionShown());
    QTest::keyClicks(line, "Main.limit");
    QTest::keyClick(line, Qt::Key_Return);
    QTest::keyClicks(line, "Main.counter * 2");
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(window->watch().expressions(), (QStringList{"Main.counter", "Main.limit", "Main.counter * 2"}));
    EXPECT_EQ(line->text(), "");
}

TEST_F(TypedTextTest, ANewDocumentHasTheKeyboard) {
    (void)window->projectTree();
    window->watch().tree().setFocus();
    typeIntoNext(window.get(), "Mixer");
    window->action("file.newUnit")->trigger();
    ASSERT_NE(window->tabs().currentEditor(), nullptr);
    // No window manager gives the window back its activity after the dialog: what counts is who has its keyboard.
    EXPECT_TRUE(window->focusWidget() == &editor() || window->focusWidget() == editor().viewport());
    window->watch().tree().setFocus();
    typeIntoNext(window.get(), "desk");
    window->action("file.newPanel")->trigger();
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget());
    ASSERT_NE(designer, nullptr);
    EXPECT_EQ(window->focusWidget(), &designer->canvas());
}

} // namespace
} // namespace plc::app
