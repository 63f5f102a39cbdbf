// Writing and forcing from the text with the right button and the keyboard, in a program and in the source of a block
// with a chosen instance; the events come from the window system, so that what a click does first is done here, too.
#include "app/pages/instance_bar.h"
#include "editor/debug/debug_views.h"
#include "editor/kit/inputs/text_question.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAction>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QWindow>

namespace plc::app {
namespace {

const char* const kAxes = R"(FUNCTION_BLOCK Axis
VAR_INPUT
    step : INT;
END_VAR
VAR
    pos : INT;
    busy : BOOL;
END_VAR
pos := pos + step;
END_FUNCTION_BLOCK

PROGRAM Main
VAR
    a, b : Axis;
    n : INT;
    speed : REAL;
    list : ARRAY[1..3] OF INT;
END_VAR
n := n + 1;
a(step := 1);
b(step := 2);
list[2] := list[1];
END_PROGRAM
)";

class WriteFromTextTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        const auto end = static_cast<uint32_t>(editor().utf8().size());
        editor().applyEdits({{{FileId(), 0, end}, kAxes}});
        analysed();
        window->action("file.save")->trigger();
        editor().goTo(0);
        editor().setFocus();
        window->activateWindow();
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().value("Main.n").text.toInt() > 3; }));
    }
    uint32_t at(const char* text) { return static_cast<uint32_t>(editor().utf8().find(text)); }
    /// Where the character is drawn, in the window.
    QPoint placeOf(uint32_t offset) {
        using S = QsciScintillaBase;
        const auto position = static_cast<long>(offset);
        const long line = editor().SendScintilla(S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(offset));
        editor().ensureLineVisible(static_cast<int>(line));
        const QPoint inside(static_cast<int>(editor().SendScintilla(S::SCI_POINTXFROMPOSITION, 0ul, position)) + 3,
                            static_cast<int>(editor().SendScintilla(S::SCI_POINTYFROMPOSITION, 0ul, position)) + 6);
        return editor().viewport()->mapTo(window.get(), inside);
    }
    static QAction* entryOf(const QMenu& menu, const QString& text) {
        for (QAction* each : menu.actions())
            if (each->text().remove(u'&').section(u'\t', 0, 0) == text) return each;
        return nullptr;
    }
    /// What is typed into the next dialog, with Enter.
    static void typeIntoDialog(const QString& typed) {
        inNext<QDialog>(qApp, [typed](QDialog& dialog) {
            auto* line = dialog.findChild<QLineEdit*>();
            ASSERT_NE(line, nullptr);
            line->selectAll();
            QTest::keyClicks(line, typed);
            QTest::keyClick(line, Qt::Key_Return);
        });
    }
    /// The question, once it says what is wrong with the answer.
    static kit::TextQuestion* complaining() {
        auto* question = dialogInFront<kit::TextQuestion>();
        return question && !question->complaint().isEmpty() ? question : nullptr;
    }
    /// The menu that opens next: a click on its entry, or whether it is missing.
    void clickNextMenu(const QString& entry) {
        m_wasOffered = m_wasOpen = false;
        inNextMenu(qApp, [this, entry](QMenu& menu) {
            QAction* action = entryOf(menu, entry);
            m_wasOpen = true;
            m_wasOffered = action != nullptr;
            if (!action) return (void)menu.close();
            QTest::mouseMove(&menu, menu.actionGeometry(action).center());
            QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
        });
    }
    /// The right button on a word of the text, from the window system.
    void rightClick(uint32_t offset, const QString& entry) {
        clickNextMenu(entry);
        QTest::mouseClick(window->windowHandle(), Qt::RightButton, {}, placeOf(offset));
        ASSERT_TRUE(waitFor([&] { return m_wasOpen; })) << "no menu";
    }
    QString text(const char* path) { return window->control().value(path).text; }
    bool isForced(const char* path) { return window->control().value(path).isForced; }

    bool m_wasOffered = false, m_wasOpen = false;
};

TEST_F(WriteFromTextTest, TheRightButtonWritesTheVariableItIsOnWhereverTheCaretIs) {
    editor().goTo(at("n := n + 1"));
    typeIntoDialog("12.5");
    ASSERT_NO_FATAL_FAILURE(rightClick(at("speed : REAL") + 1, "Write a Value…"));
    EXPECT_TRUE(m_wasOffered);
    EXPECT_TRUE(waitFor([&] { return text("Main.speed") == "12.5"; })) << text("Main.speed").toStdString();
    typeIntoDialog("7");
    ASSERT_NO_FATAL_FAILURE(rightClick(at("list[1]") + 1, "Write a Value…"));
    EXPECT_TRUE(waitFor([&] { return text("Main.list[2]") == "7"; })) << "the element that the click is on";
    ASSERT_NO_FATAL_FAILURE(rightClick(at("END_PROGRAM") + 2, "Write a Value…"));
    EXPECT_FALSE(m_wasOffered) << "a keyword has no value, whatever the caret was on before";
}

TEST_F(WriteFromTextTest, AValueThatIsNoneIsTypedAgainInTheSameDialog) {
    for (const char* entry : {"Write a Value…", "Force…"}) {
        typeIntoDialog("much");
        QString complaint;
        asSoonAs(qApp, &complaining, [&complaint](const kit::TextQuestion& question) {
            complaint = question.complaint();
            typeIntoDialog("8.5"); // what was wrong is selected
        });
        ASSERT_NO_FATAL_FAILURE(rightClick(at("speed : REAL") + 1, entry));
        EXPECT_TRUE(waitFor([&] { return text("Main.speed") == "8.5"; })) << text("Main.speed").toStdString();
        EXPECT_TRUE(complaint.contains("much")) << complaint.toStdString();
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    }
    EXPECT_TRUE(waitFor([&] { return isForced("Main.speed"); }));
}

TEST_F(WriteFromTextTest, ForcesAndReleasesTheInstanceWhoseValuesAreShown) {
    editor().goTo(at("pos := pos"));
    ASSERT_TRUE(waitFor([&] { return window->tabs().currentPage()->instanceBar().isVisible(); }));
    window->control().setPreferredInstance("Axis", "Main.b");
    ASSERT_TRUE(waitFor([&] { return window->tabs().currentPage()->instanceBar().shownInstance() == "Main.b"; }));
    typeIntoDialog("TRUE");
    ASSERT_NO_FATAL_FAILURE(rightClick(at("busy : BOOL") + 1, "Force…"));
    EXPECT_TRUE(waitFor([&] { return isForced("Main.b.busy") && text("Main.b.busy") == "TRUE"; }));
    EXPECT_FALSE(isForced("Main.a.busy"));
    EXPECT_EQ(text("Main.a.busy"), "FALSE");
    ASSERT_NO_FATAL_FAILURE(rightClick(at("busy : BOOL") + 1, "Release the Force"));
    EXPECT_TRUE(waitFor([&] { return !isForced("Main.b.busy"); }));
    typeIntoDialog("1000");
    ASSERT_NO_FATAL_FAILURE(rightClick(at("pos := pos") + 1, "Write a Value…"));
    EXPECT_TRUE(waitFor([&] { return text("Main.b.pos").toInt() >= 1000; }));
    EXPECT_LT(text("Main.a.pos").toInt(), 1000);
}

TEST_F(WriteFromTextTest, TheMenuKeyOpensTheMenuAtTheCaret) {
    editor().goTo(at("speed : REAL") + 2);
    QPoint opened;
    inNextMenu(qApp, [&](QMenu& menu) {
        opened = menu.pos();
        QAction* entry = entryOf(menu, "Write a Value…");
        if (!entry) return (void)menu.close();
        typeIntoDialog("3.5");
        while (menu.activeAction() != entry) QTest::keyClick(&menu, Qt::Key_Down);
        QTest::keyClick(&menu, Qt::Key_Return);
    });
    QContextMenuEvent event(QContextMenuEvent::Keyboard, editor().rect().center(),
                            editor().mapToGlobal(editor().rect().center()));
    QApplication::sendEvent(&editor(), &event); // as Qt sends it for the menu key
    EXPECT_TRUE(waitFor([&] { return text("Main.speed") == "3.5"; }));
    const QPoint caret = window->mapToGlobal(placeOf(at("speed : REAL") + 2));
    EXPECT_LT((opened - caret).manhattanLength(), 60) << "beside the word that it is about";
}

TEST_F(WriteFromTextTest, ARightClickInTheSelectionKeepsIt) {
    const uint32_t from = at("list[2] := list[1]");
    editor().goTo(from, 18);
    ASSERT_EQ(editor().selectedText(), "list[2] := list[1]");
    ASSERT_NO_FATAL_FAILURE(rightClick(from + 4, "there is none"));
    EXPECT_EQ(editor().selectedText(), "list[2] := list[1]") << "to be copied";
}

TEST_F(WriteFromTextTest, AValueThatDoesNotFitIsRefusedAndNothingIsWritten) {
    QString complaint;
    typeIntoDialog("hello");
    asSoonAs(qApp, &complaining, [&complaint](kit::TextQuestion& question) {
        complaint = question.complaint();
        QTest::keyClick(&question, Qt::Key_Escape);
    });
    ASSERT_NO_FATAL_FAILURE(rightClick(at("speed : REAL") + 1, "Write a Value…"));
    EXPECT_TRUE(waitFor([&] { return !complaint.isEmpty(); })) << "it says why";
    EXPECT_EQ(text("Main.speed").toDouble(), 0);
}

} // namespace
} // namespace plc::app
