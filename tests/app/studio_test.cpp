#include "tests/app/studio_fixture.h"

#include "app/panels/live_views.h"
#include "app/project/problems_view.h"
#include "app/project/project_tree.h"
#include "app/project/search_view.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/inputs/variable_picker.h"
#include "editor/plot/plot_view.h"
#include "tests/support/answer.h"

#include <QAction>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTreeWidget>

namespace plc::app {
namespace {

TEST_F(StudioTest, OpensTheMainProgramAndShowsItInTheTree) {
    EXPECT_EQ(window->tabs().openFiles(), QStringList{"src/main.st"});
    ASSERT_TRUE(waitFor([&] { return window->projectTree().tree().topLevelItemCount() > 0; }));
    const auto found = window->projectTree().tree().findItems("Main", Qt::MatchExactly | Qt::MatchRecursive);
    EXPECT_FALSE(found.isEmpty());
}

/// Says something when it is destroyed, as a connection does that breaks off then.
class LastWord final : public QObject {
public:
    LastWord(QObject* parent, LiveViews& live) : QObject(parent), m_live(live) {}
    ~LastWord() override { emit m_live.message("The connection was lost", true); }

private:
    LiveViews& m_live;
};

TEST_F(StudioTest, WhatItsPartsSayWhileTheWindowGoesIsNotHeard) {
    new LastWord(&window->control(), window->live());
    window.reset(); // what is said then would reach a window that is half gone
}

TEST_F(StudioTest, TypingAnUndeclaredNameShowsADiagnosticAndUndoRemovesIt) {
    typeAtEnd("nonsense := 1;");
    analysed();
    ASSERT_TRUE(waitFor([&] { return window->problems().errorCount() == 1; })) << window->problems().errorCount();
    EXPECT_EQ(editor().diagnosticsHere().front().kind, diagnostics::Kind::UndeclaredName);
    while (editor().isUndoAvailable()) editor().undo();
    analysed();
    EXPECT_TRUE(waitFor([&] { return window->problems().errorCount() == 0; }));
}

TEST_F(StudioTest, AltEnterDeclaresAnUnknownName) {
    typeAtEnd("ready := TRUE;");
    analysed();
    ASSERT_TRUE(waitFor([&] { return !editor().diagnosticsHere().empty(); }));
    editor().goTo(editor().diagnosticsHere().front().range.begin + 1);
    inNextMenu(window.get(), // of the ways to declare it the first: a local
               [](QMenu& menu) { QTest::keyClick(&menu, Qt::Key_Return); });
    QTest::keyClick(editor().viewport(), Qt::Key_Return, Qt::AltModifier);
    analysed();
    EXPECT_NE(editor().utf8().find("ready : BOOL;"), std::string::npos) << editor().utf8();
    EXPECT_TRUE(waitFor([&] { return window->problems().errorCount() == 0; }));
}

TEST_F(StudioTest, CompletionOffersMembersOfABlock) {
    typeAtEnd("pulse");
    QTest::keyClicks(editor().viewport(), ".");
    EXPECT_TRUE(editor().isListActive());
    const auto model = window->workspace().model();
    const auto completion = model->complete(*model->fileOf("src/main.st"), editor().utf8(), editor().cursorOffset());
    QStringList offered;
    for (const auto& item : completion.items) offered << QString::fromStdString(item.text);
    EXPECT_TRUE(offered.contains("Q")) << offered.join(' ').toStdString();
    EXPECT_TRUE(offered.contains("ET"));
}

TEST_F(StudioTest, EnterClosesABlockAndIndents) {
    typeAtEnd("if done then");
    QTest::keyClick(editor().viewport(), Qt::Key_Return);
    EXPECT_NE(editor().utf8().find("IF done THEN\n    \nEND_IF;"), std::string::npos) << editor().utf8();
}

TEST_F(StudioTest, RenamingChangesEveryUse) {
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("counter")));
    typeIntoNext(window.get(), "ticks");
    window->action("edit.rename")->trigger();
    const std::string text = editor().utf8();
    EXPECT_EQ(text.find("counter"), std::string::npos);
    EXPECT_NE(text.find("ticks := ticks + 1;"), std::string::npos) << text;
    editor().undo();
    EXPECT_NE(editor().utf8().find("counter := counter + 1;"), std::string::npos);
}

TEST_F(StudioTest, GoesToTheDefinitionAndBack) {
    editor().goTo(static_cast<uint32_t>(editor().utf8().rfind("limit")));
    const uint32_t from = editor().cursorOffset();
    window->action("edit.definition")->trigger();
    EXPECT_EQ(editor().cursorOffset(), editor().utf8().find("limit") + 5);
    window->action("edit.back")->trigger();
    EXPECT_EQ(editor().cursorOffset(), from);
}

TEST_F(StudioTest, RunsAndShowsValuesInTheWatch) {
    window->showDock("watch");
    window->watch().setExpressions({"Main.counter", "Main.limit * 2"});
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 5; }));
    window->watch().refresh();
    EXPECT_EQ(window->watch().tree().topLevelItem(1)->text(1), "2000");
    const int first = window->watch().tree().topLevelItem(0)->text(1).toInt();
    EXPECT_TRUE(waitFor([&] { return window->watch().tree().topLevelItem(0)->text(1).toInt() != first; }));
    window->action("run.stop")->trigger();
    EXPECT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Stopped; }));
}

TEST_F(StudioTest, WritesAndForcesFromTheWatch) {
    window->showDock("watch");
    window->watch().setExpressions({"Main.limit"});
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 2; }));
    window->watch().tree().topLevelItem(0)->setText(3, "77");
    window->action("run.write")->trigger();
    EXPECT_TRUE(waitFor([&] { return window->control().value("Main.limit").text == "77"; }));
    window->watch().tree().topLevelItem(0)->setText(3, "5");
    window->action("run.force")->trigger();
    EXPECT_TRUE(waitFor([&] {
        return window->control().value("Main.limit").text == "5" && window->control().value("Main.limit").isForced;
    }));
    window->action("run.releaseAll")->trigger();
    EXPECT_TRUE(waitFor([&] { return !window->control().value("Main.limit").isForced; }));
}

TEST_F(StudioTest, StopsAtABreakpointStepsAndGoesOn) {
    int line = 0, column = 0;
    editor().lineIndexFromPosition(static_cast<int>(editor().utf8().find("counter := counter + 1")), &line, &column);
    editor().setCursorPosition(line, 0);
    window->action("run.breakpoint")->trigger();
    ASSERT_EQ(window->control().breakpoints().size(), 1u);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Halted; }));
    const QString before = window->control().value("Main.counter").text;
    window->action("run.stepOver")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text != before; }));
    EXPECT_EQ(window->control().status().state, controller::State::Halted);
    window->control().setBreakpoints({});
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Running; }));
}

TEST_F(StudioTest, AnOnlineChangeKeepsTheState) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 10; }));
    const auto at = editor().utf8().find("counter + 1");
    editor().applyEdits({{{FileId(), static_cast<uint32_t>(at), static_cast<uint32_t>(at + 11)}, "counter + 2"}});
    analysed();
    QSignalSpy finished(&window->control(), &editor::RunControl::onlineChangeFinished);
    window->action("run.change")->trigger();
    ASSERT_TRUE(waitFor([&] { return finished.count() == 1; }));
    EXPECT_GT(window->control().value("Main.counter").text.toInt(), 10);
    EXPECT_EQ(window->control().status().state, controller::State::Running);
}

TEST_F(StudioTest, TimeRunsBackwards) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 20; }));
    window->action("time.back")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().viewed().has_value(); }));
    const int past = window->control().value("Main.counter").text.toInt();
    window->action("time.back")->trigger();
    EXPECT_EQ(window->control().value("Main.counter").text.toInt(), past - 1);
    window->action("time.forward")->trigger();
    EXPECT_EQ(window->control().value("Main.counter").text.toInt(), past);
    window->action("time.live")->trigger();
    EXPECT_FALSE(window->control().viewed().has_value());
}

TEST_F(StudioTest, ADivisionByZeroShowsTheFaultWithItsLine) {
    typeAtEnd("limit := 5 / (limit - limit);");
    analysed();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Fault; }));
    ASSERT_TRUE(window->control().status().fault.has_value());
    EXPECT_TRUE(window->control().status().fault->range.file.isValid());
}

TEST_F(StudioTest, AFileChangedOutsideIsLoadedAgain) {
    write("src/main.st", QByteArray(kMain).replace("limit : INT := 1000", "limit : INT := 500"));
    EXPECT_TRUE(waitFor([&] { return editor().utf8().find(":= 500") != std::string::npos; }));
}

TEST_F(StudioTest, FindAndReplaceInTheFile) {
    QTest::keyClick(window.get(), Qt::Key_H, Qt::ControlModifier);
    auto& bar = window->tabs().currentPage()->findBar();
    bar.findField().setText("done");
    bar.replaceField().setText("ready");
    EXPECT_EQ(bar.replaceAll(), 3);
    EXPECT_EQ(editor().utf8().find("done"), std::string::npos);
}

TEST_F(StudioTest, SearchesTheProject) {
    window->search().openSearch("counter");
    window->search().search();
    EXPECT_EQ(window->search().results().topLevelItemCount(), 5);
}

TEST_F(StudioTest, EveryActionHasATextAndShortcutsAreUnique) {
    QSet<QString> seen;
    for (QAction* action : window->allActions()) {
        EXPECT_FALSE(action->text().isEmpty());
        const QString keys = action->shortcut().toString(QKeySequence::PortableText);
        if (keys.isEmpty()) continue;
        EXPECT_FALSE(seen.contains(keys)) << keys.toStdString() << " " << action->objectName().toStdString();
        seen.insert(keys);
    }
}

// Ctrl+Alt with a function key leads to another console of the computer; the window never sees it.
/// Linux takes Ctrl+Alt+Fn to switch consoles; GNOME takes Ctrl+Alt and an arrow to switch workspaces, with Shift to
/// carry a window there, and Ctrl+Alt+D to show the desktop; it, KDE or Ubuntu take the others.
bool isTakenByTheDesktop(QKeyCombination keys) {
    const Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::AltModifier;
    if ((keys.keyboardModifiers() & ~Qt::ShiftModifier) != both) return false;
    const int key = keys.key();
    if (key >= Qt::Key_Left && key <= Qt::Key_Down) return true;
    if (keys.keyboardModifiers() != both) return false;
    return (key >= Qt::Key_F1 && key <= Qt::Key_F12) || key == Qt::Key_D || key == Qt::Key_L || key == Qt::Key_T ||
           key == Qt::Key_Tab || key == Qt::Key_Escape || key == Qt::Key_Delete;
}

TEST_F(StudioTest, NoShortcutIsOneThatTheDesktopTakes) {
    for (const QAction* action : window->allActions())
        for (const QKeySequence& keys : action->shortcuts())
            for (int i = 0; i < keys.count(); ++i)
                EXPECT_FALSE(isTakenByTheDesktop(keys[uint(i)]))
                    << action->objectName().toStdString() << ": " << keys.toString().toStdString();
}

TEST_F(StudioTest, SaveWritesTheFileAndMarksItClean) {
    typeAtEnd("done := FALSE;");
    EXPECT_TRUE(window->workspace().isModified("src/main.st"));
    window->action("file.save")->trigger();
    EXPECT_FALSE(window->workspace().isModified("src/main.st"));
    QFile file(folder.path() + "/src/main.st");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("done := FALSE;"));
}

} // namespace

TEST_F(StudioTest, VariablesAreDraggedFromTreeAndTextToTheTrace) {
    QTreeWidget& tree = window->projectTree().tree();
    const QList<QTreeWidgetItem*> found = tree.findItems("counter", Qt::MatchExactly | Qt::MatchRecursive);
    ASSERT_EQ(found.size(), 1);
    const std::unique_ptr<QMimeData> fromTree(tree.model()->mimeData({tree.indexFromItem(found[0])}));
    ASSERT_TRUE(fromTree);
    EXPECT_EQ(kit::variablesOf(fromTree.get()), QStringList{"Main.counter"});
    ASSERT_TRUE(window->tabs().openFile("src/main.st"));
    const auto at = static_cast<uint32_t>(editor().utf8().find("limit : INT"));
    editor().goTo(at, 5);
    const std::unique_ptr<QMimeData> fromText(editor().toMimeData("limit", false));
    EXPECT_EQ(kit::variablesOf(fromText.get()), QStringList{"Main.limit"});
    EXPECT_EQ(fromText->text(), "limit") << "text stays text for everyone else";
    const std::unique_ptr<QMimeData> words(editor().toMimeData("counter := counter + 1;", false));
    EXPECT_FALSE(words->hasFormat(kit::VariableMime));

    window->showDock("trace");
    plot::PlotView& plot = *window->live().traceView().plot();
    for (const QMimeData* mime : {fromTree.get(), fromText.get()}) {
        QDragEnterEvent enter(plot.rect().center(), Qt::CopyAction, mime, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&plot, &enter);
        QDropEvent drop(QPointF(plot.rect().center()), Qt::CopyAction, mime, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&plot, &drop);
    }
    const auto& channels = window->live().traceView().setup().channels;
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].expression, "Main.counter");
    EXPECT_EQ(channels[1].expression, "Main.limit");
}

} // namespace plc::app
