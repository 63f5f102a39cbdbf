// What an engineer does besides typing: breakpoints with conditions, shortcuts, recovery, changes from outside, the
// next morning.
#include "app/settings_dialog.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "tests/app/studio_fixture.h"

#include <QAbstractButton>
#include <QAction>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QKeySequenceEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QTreeWidget>

namespace plc::app {
namespace {

class DayTest : public StudioTest {
protected:
    static void answerNext(QMessageBox::StandardButton button, int after = 150) {
        QTimer::singleShot(after, qApp, [button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box) return;
            if (QAbstractButton* found = box->button(button))
                found->click();
            else
                box->reject();
        });
    }
    QTreeWidget* listIn(const QString& dock) {
        window->showDock(dock);
        return window->dock(dock)->findChild<QTreeWidget*>();
    }
    void breakAt(const char* text) {
        editor().goTo(static_cast<uint32_t>(editor().utf8().find(text)));
        window->action("run.breakpoint")->trigger();
    }
    bool halts() {
        return waitFor([&] { return window->control().status().state == controller::State::Halted; });
    }
};

TEST_F(DayTest, ABreakpointWaitsForItsCondition) {
    breakAt("counter := counter + 1");
    QTreeWidget* list = listIn("breakpoints");
    ASSERT_EQ(list->topLevelItemCount(), 1);
    list->topLevelItem(0)->setText(1, "counter = 7");
    ASSERT_TRUE(waitFor([&] { return window->control().breakpoints().front().condition == "counter = 7"; }));
    window->action("run.start")->trigger();
    ASSERT_TRUE(halts());
    EXPECT_EQ(window->control().value("Main.counter").text, "7");
}

TEST_F(DayTest, ABreakpointWaitsForItsHit) {
    breakAt("counter := counter + 1");
    listIn("breakpoints")->topLevelItem(0)->setText(2, "5");
    ASSERT_TRUE(waitFor([&] { return window->control().breakpoints().front().hitCount == 5; }));
    window->action("run.start")->trigger();
    ASSERT_TRUE(halts());
    EXPECT_EQ(window->control().value("Main.counter").text, "4") << "the fifth time";
}

TEST_F(DayTest, ABreakpointInABlockCanBelongToOneInstance) {
    write("src/motor.st",
          "FUNCTION_BLOCK Motor\nVAR_INPUT run : BOOL; END_VAR\nVAR turns : DINT; END_VAR\nturns := turns + "
          "1;\nEND_FUNCTION_BLOCK\nPROGRAM Two\nVAR a, b : Motor; END_VAR\na();\nb();\nEND_PROGRAM\n"
          "CONFIGURATION C\nRESOURCE R ON PLC\nTASK T(INTERVAL := T#10ms, PRIORITY := 1);\nPROGRAM Main WITH T : "
          "Main;\nPROGRAM Two WITH T : Two;\nEND_RESOURCE\nEND_CONFIGURATION\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/motor.st"); }));
    window->tabs().openFile("src/motor.st");
    breakAt("turns := turns + 1");
    listIn("breakpoints")->topLevelItem(0)->setText(3, "Two.b");
    ASSERT_TRUE(waitFor([&] { return window->control().breakpoints().front().instance == "Two.b"; }));
    window->action("run.start")->trigger();
    ASSERT_TRUE(halts());
    ASSERT_FALSE(window->control().session()->haltFrames().empty());
    EXPECT_EQ(QString::fromStdString(window->control().session()->haltFrames().front().instance).toLower(), "two.b");
    EXPECT_EQ(window->control().value("Two.a.turns").text, "1");
    EXPECT_EQ(window->control().value("Two.b.turns").text, "0");
}

TEST_F(DayTest, SameNamesInTwoTasksStayApart) {
    write("src/two.st", "PROGRAM Other\nVAR counter : INT := 500; END_VAR\nEND_PROGRAM\n"
                        "CONFIGURATION C\nRESOURCE R ON PLC\nTASK Fast(INTERVAL := T#10ms, PRIORITY := 1);\nTASK "
                        "Slow(INTERVAL := T#50ms, PRIORITY := 2);\nPROGRAM Main WITH Fast : Main;\n"
                        "PROGRAM Other WITH Slow : Other;\nEND_RESOURCE\nEND_CONFIGURATION\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().files().contains("src/two.st"); }));
    analysed();
    window->watch().setExpressions({"Main.counter", "Other.counter"});
    window->showDock("watch");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 3; }));
    window->watch().refresh();
    EXPECT_EQ(window->watch().tree().topLevelItem(1)->text(1), "500");
    EXPECT_NE(window->watch().tree().topLevelItem(0)->text(1), "500");
}

TEST_F(DayTest, TheLogTellsWhatHappenedAndTheMonitorWhatItCost) {
    QTreeWidget* log = listIn("log");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 20; }));
    window->watch().setExpressions({"Main.limit"});
    window->watch().tree().topLevelItem(0)->setText(3, "5");
    window->action("run.force")->trigger();
    const auto logged = [&](const QString& word) {
        for (int i = 0; i < log->topLevelItemCount(); ++i)
            for (int c = 0; c < log->columnCount(); ++c)
                if (log->topLevelItem(i)->text(c).contains(word, Qt::CaseInsensitive)) return true;
        return false;
    };
    EXPECT_TRUE(waitFor([&] { return logged("force") || logged("limit"); }));
    QTreeWidget* tasks = listIn("tasks");
    ASSERT_TRUE(waitFor([&] { return tasks->topLevelItemCount() > 0; }));
    EXPECT_TRUE(waitFor([&] {
        return tasks->topLevelItem(0)->text(1).toInt() > 0 || tasks->topLevelItem(0)->text(2).toInt() > 0;
    })) << "its count";
    window->action("run.stop")->trigger();
    EXPECT_TRUE(waitFor([&] { return logged("stop"); }));
}

TEST_F(DayTest, ShortcutsAreSetInTheSettingsAndStay) {
    QTimer::singleShot(200, qApp, [&] {
        auto* dialog = qobject_cast<SettingsDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        auto* table = dialog->findChild<QTableWidget*>();
        ASSERT_NE(table, nullptr);
        for (int row = 0; row < table->rowCount(); ++row)
            if (table->item(row, 0)->text() == window->action("run.speed")->text())
                static_cast<QKeySequenceEdit*>(table->cellWidget(row, 1))->setKeySequence(QKeySequence("Ctrl+Alt+S"));
        dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    });
    window->action("file.settings")->trigger();
    EXPECT_EQ(window->action("run.speed")->shortcut(), QKeySequence("Ctrl+Alt+S"));
    const MainWindow another;
    EXPECT_EQ(another.action("run.speed")->shortcut(), QKeySequence("Ctrl+Alt+S"));
}

TEST_F(DayTest, WhatACrashLeftIsOfferedAndRestored) {
    window->closeProject();
    write("src/.main.st.autosave", QByteArray(kMain).replace(":= 1000", ":= 4321"));
    answerNext(QMessageBox::Yes);
    ASSERT_TRUE(window->openProject(folder.path()));
    EXPECT_NE(editor().utf8().find("4321"), std::string::npos);
    EXPECT_TRUE(window->workspace().isModified("src/main.st"));
    answerNext(QMessageBox::Discard);
    window->closeProject();
}

TEST_F(DayTest, AChangeOutsideAndHereAsksAndKeepsWhatIsHere) {
    typeAtEnd("done := FALSE;");
    answerNext(QMessageBox::No, 600);
    write("src/main.st", QByteArray(kMain).replace(":= 1000", ":= 500"));
    QTest::qWait(900);
    EXPECT_NE(editor().utf8().find("done := FALSE;"), std::string::npos);
    EXPECT_NE(editor().utf8().find(":= 1000"), std::string::npos);
    answerNext(QMessageBox::Discard);
    window->closeProject();
}

TEST_F(DayTest, TheNextMorningEverythingIsWhereItWas) {
    write("hmi/overview.panel.json", "{\n  \"version\": 1,\n  \"elements\": []\n}\n");
    window->closeProject();
    ASSERT_TRUE(window->openProject(folder.path()));
    window->openDesigner("overview");
    window->openTexts();
    window->tabs().openFile("src/main.st");
    const auto place = static_cast<uint32_t>(editor().utf8().find("done := NOT"));
    editor().goTo(place);
    breakAt("done := NOT");
    window->watch().setExpressions({"Main.done"});
    window->closeProject();
    window = std::make_unique<MainWindow>();
    window->show();
    ASSERT_TRUE(window->openProject(folder.path()));
    EXPECT_NE(window->tabs().pageByKey("panel:overview"), nullptr);
    EXPECT_NE(window->tabs().pageByKey("texts"), nullptr);
    ASSERT_NE(window->tabs().currentPage(), nullptr);
    EXPECT_EQ(editor().cursorOffset(), place);
    EXPECT_EQ(window->control().breakpoints().size(), 1u);
    EXPECT_EQ(window->watch().expressions(), QStringList{"Main.done"});
}

} // namespace
} // namespace plc::app
