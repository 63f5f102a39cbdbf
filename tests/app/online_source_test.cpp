// The source of a block while it runs: whose values stand beside it, values beside declarations, writing and forcing
// from the text; the watch with several lists and a format per row.
#include "app/pages/instance_bar.h"
#include "app/project/project_tree.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QTreeWidget>

namespace plc::app {
namespace {

const char* const kBlocks = R"(FUNCTION_BLOCK Axis
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
END_VAR
n := n + 1;
a(step := 1);
b(step := 2);
END_PROGRAM
)";

class OnlineSourceTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        const auto end = static_cast<uint32_t>(editor().utf8().size());
        editor().applyEdits({{{FileId(), 0, end}, kBlocks}});
        analysed();
        window->action("file.save")->trigger();
    }
    void run() {
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().value("Main.n").text.toInt() > 3; }));
    }
    /// At a breakpoint of one instance of Axis.
    void haltIn(const QString& instance) {
        editor().goTo(at("pos := pos"));
        int line = 0, column = 0;
        editor().getCursorPosition(&line, &column);
        window->control().setBreakpoints({{"src/main.st", line + 1, "", 0, instance, true}});
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Halted; }));
    }
    uint32_t at(const char* text) { return static_cast<uint32_t>(editor().utf8().find(text)); }
    InstanceBar& bar() { return window->tabs().currentPage()->instanceBar(); }
    /// The value that is shown beside the line with the text.
    QString beside(const char* text, const QString& name) {
        const long line =
            editor().SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, static_cast<unsigned long>(at(text)));
        for (const auto& [shown, values] : editor().shownValues())
            if (shown == line)
                for (const editor::OnlineValue& value : values)
                    if (value.name == name) return value.value;
        return {};
    }
    /// As a click with the right button does.
    static void askForMenu(QTreeWidget& tree, const QTreeWidgetItem* item) {
        const QPoint at = tree.visualItemRect(item).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, tree.viewport()->mapToGlobal(at));
        QApplication::sendEvent(tree.viewport(), &event);
    }
};

TEST_F(OnlineSourceTest, SaysWhoseValuesItShowsAndShowsThoseOfAnother) {
    editor().goTo(at("pos := pos"));
    run();
    ASSERT_TRUE(waitFor([&] { return bar().isVisible(); }));
    EXPECT_EQ(bar().shownInstance(), "Main.a");
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    const int n = window->control().value("Main.n").text.toInt();
    ASSERT_TRUE(waitFor([&] { return beside("pos := pos", "pos").toInt() == n; }));
    auto* choice = bar().findChild<QComboBox*>();
    QTest::mouseClick(choice, Qt::LeftButton); // the list opens
    ASSERT_TRUE(waitFor([&] { return choice->view()->isVisible(); }));
    QTest::keyClick(choice->view(), Qt::Key_Down);
    QTest::keyClick(choice->view(), Qt::Key_Return);
    EXPECT_EQ(bar().shownInstance(), "Main.b");
    EXPECT_TRUE(waitFor([&] { return beside("pos := pos", "pos").toInt() == 2 * n; }));
    editor().goTo(at("n := n"));
    EXPECT_TRUE(waitFor([&] { return !bar().isVisible(); })) << "a program is its own";
}

TEST_F(OnlineSourceTest, TheCallPathChoosesTheInstance) {
    haltIn("Main.b");
    EXPECT_TRUE(waitFor([&] { return bar().shownInstance() == "Main.b"; }));
    window->control().setBreakpoints({});
}

TEST_F(OnlineSourceTest, AClickOnAFrameOfTheCallStackChoosesItsInstance) {
    window->showDock("callPath");
    haltIn("Main.b");
    ASSERT_TRUE(waitFor([&] { return bar().isVisible() && bar().shownInstance() == "Main.b"; }));
    window->control().setPreferredInstance("Axis", "Main.a"); // one looks at the other
    ASSERT_TRUE(waitFor([&] { return bar().shownInstance() == "Main.a"; }));
    QTreeWidget* frames = nullptr;
    for (QTreeWidget* each : window->findChild<editor::CallPathView*>()->findChildren<QTreeWidget*>())
        if (each->accessibleName() == "Call stack") frames = each;
    ASSERT_TRUE(frames && frames->topLevelItemCount() == 2);
    EXPECT_EQ(frames->topLevelItem(0)->text(1), "Main.b");
    QTest::mouseClick(frames->viewport(), Qt::LeftButton, {}, frames->visualItemRect(frames->topLevelItem(0)).center());
    EXPECT_TRUE(waitFor([&] { return bar().shownInstance() == "Main.b"; }));
    EXPECT_TRUE(waitFor([&] { return beside("pos := pos", "step") == "2"; })) << "its values, not those of Main.a";
    window->control().setBreakpoints({});
}

TEST_F(OnlineSourceTest, TheTreeChoosesTheInstance) {
    run();
    editor().goTo(at("n := n + 1"));
    QTreeWidget& tree = window->projectTree().tree();
    const auto item = [&](const QString& name) {
        const auto found = tree.findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.first();
    };
    const auto choose = [&](const QString& name, const QString& entry, const QString& under) {
        ASSERT_NE(item(name), nullptr) << name.toStdString();
        tree.scrollToItem(item(name));
        bool chosen = false;
        inNextMenu(window.get(), [&](QMenu& menu) {
            for (QAction* each : menu.actions()) {
                if (!under.isEmpty() && each->menu() && each->text().remove(u'&') == under)
                    for (QAction* inner : each->menu()->actions())
                        if (inner->text().remove(u'&') == entry) chosen = true, inner->trigger();
                if (each->text().remove(u'&') == entry) chosen = true, each->trigger();
            }
            menu.close();
        });
        askForMenu(tree, item(name));
        EXPECT_TRUE(chosen) << entry.toStdString();
    };
    choose("b", "Source of Axis with the Values of Main.b", {});
    EXPECT_TRUE(waitFor([&] { return bar().isVisible() && bar().shownInstance() == "Main.b"; }));
    choose("Axis", "Main.a", "Values of Instance");
    EXPECT_TRUE(waitFor([&] { return bar().shownInstance() == "Main.a"; }));
}

TEST_F(OnlineSourceTest, TheWatchChoosesTheInstance) {
    run();
    editor().goTo(at("n := n + 1"));
    window->watch().add("Main.b.pos");
    auto* tree = window->watch().findChild<QTreeWidget*>();
    ASSERT_TRUE(tree && tree->topLevelItemCount() > 0);
    bool isOffered = false;
    inNextMenu(tree, [&](QMenu& menu) {
        for (QAction* action : menu.actions())
            if (action->text().remove(u'&') == "Source of Axis with the Values of Main.b") {
                isOffered = true;
                action->trigger();
            }
        menu.close();
    });
    const QTreeWidgetItem* row = tree->topLevelItem(tree->topLevelItemCount() - 1);
    askForMenu(*tree, row);
    EXPECT_TRUE(isOffered);
    EXPECT_EQ(window->control().preferredInstance("Axis"), "Main.b");
    EXPECT_EQ(editor().cursorOffset(), at("Axis"));
}

TEST_F(OnlineSourceTest, ValuesAreBesideDeclarations) {
    editor().goTo(0);
    run();
    EXPECT_TRUE(waitFor([&] { return !beside("    pos : INT", "pos").isEmpty(); }));
    EXPECT_EQ(beside("    busy : BOOL", "busy"), "FALSE");
}

TEST_F(OnlineSourceTest, WritesAndForcesFromTheText) {
    editor().goTo(0);
    run();
    ASSERT_TRUE(waitFor([&] { return !beside("    busy : BOOL", "busy").isEmpty(); }));
    const auto variable = editor().variableAt(at("busy : BOOL") + 1);
    ASSERT_TRUE(variable);
    EXPECT_EQ(variable->name, "busy");
    EXPECT_EQ(variable->pou, "Axis");
    typeIntoNext(window.get(), "TRUE");
    emit editor().writeRequested(variable->name, variable->pou);
    EXPECT_TRUE(waitFor([&] { return window->control().value("Main.a.busy").isTrue; }));
    typeIntoNext(window.get(), "FALSE");
    emit editor().forceRequested(variable->name, variable->pou);
    EXPECT_TRUE(waitFor([&] { return window->control().value("Main.a.busy").isForced; }));
    emit editor().unforceRequested(variable->name, variable->pou);
    EXPECT_TRUE(waitFor([&] { return !window->control().value("Main.a.busy").isForced; }));
}

TEST_F(OnlineSourceTest, ADoubleClickTogglesAPreparedBool) {
    window->showDock("watch");
    editor::WatchView& watch = window->watch();
    watch.setExpressions({"Main.a.busy"});
    run();
    QTreeWidget& tree = watch.tree();
    ASSERT_TRUE(waitFor([&] { return tree.topLevelItem(0)->text(1) == "FALSE"; }));
    constexpr int kPrepared = 3;
    EXPECT_LT(tree.header()->sectionViewportPosition(kPrepared) + 10, tree.viewport()->width()) << "in sight";
    const auto doubleClick = [&] {
        const QRect cell = tree.visualRect(tree.model()->index(0, kPrepared));
        QTest::mouseClick(tree.viewport(), Qt::LeftButton, Qt::NoModifier,
                          cell.center()); // a double click begins with one
        QTest::mouseDClick(tree.viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
    };
    doubleClick();
    EXPECT_EQ(tree.topLevelItem(0)->text(kPrepared), "TRUE");
    doubleClick();
    EXPECT_EQ(tree.topLevelItem(0)->text(kPrepared), "FALSE");
    doubleClick();
    EXPECT_EQ(tree.topLevelItem(0)->text(kPrepared), "");
}

TEST_F(OnlineSourceTest, SeveralWatchListsWithFormatsStayWithTheProject) {
    editor::WatchView& watch = window->watch();
    window->showDock("watch");
    watch.setExpressions({"Main.n", "Main.a.pos"});
    watch.setRowFormat(watch.tree().topLevelItem(0), types::NumberFormat::Hex);
    watch.addList("Axis b");
    EXPECT_TRUE(watch.expressions().isEmpty());
    watch.add("Main.b.pos");
    watch.showList("Watch");
    EXPECT_EQ(watch.expressions(), (QStringList{"Main.n", "Main.a.pos"}));
    run();
    watch.refresh();
    EXPECT_TRUE(watch.tree().topLevelItem(0)->text(1).startsWith("16#"))
        << watch.tree().topLevelItem(0)->text(1).toStdString();
    EXPECT_FALSE(watch.tree().topLevelItem(1)->text(1).startsWith("16#"));
    window->closeProject();
    ASSERT_TRUE(window->openProject(folder.path()));
    EXPECT_EQ(watch.listNames(), (QStringList{"Watch", "Axis b"}));
    EXPECT_EQ(watch.rows().front().format, std::optional(types::NumberFormat::Hex));
    watch.showList("Axis b");
    EXPECT_EQ(watch.expressions(), QStringList{"Main.b.pos"});
    watch.removeList();
    EXPECT_EQ(watch.listNames(), QStringList{"Watch"});
}

TEST_F(OnlineSourceTest, BackToLiveGoesOnWhereItRan) {
    run();
    window->action("time.back")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    ASSERT_TRUE(window->control().viewed());
    window->action("time.live")->trigger();
    EXPECT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Running; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    window->action("time.back")->trigger();
    window->action("time.live")->trigger();
    // Commands are carried out in their order: were it running, one scan more would not be all.
    const uint64_t scans = window->control().status().scans;
    window->action("run.scan")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > scans; }));
    EXPECT_EQ(window->control().status().scans, scans + 1);
    EXPECT_EQ(window->control().status().state, controller::State::Paused) << "it stood before as well";
}

TEST_F(OnlineSourceTest, SavingWithoutAChangeMakesNoOnlineChange) {
    run();
    int changes = 0;
    QObject::connect(&window->control(), &editor::RunControl::buildStarted, window.get(), [&] { ++changes; });
    window->action("file.save")->trigger();
    EXPECT_EQ(changes, 0);
    editor().applyEdits({{{FileId(), 0, 0}, "// changed\n"}});
    window->action("file.save")->trigger();
    EXPECT_EQ(changes, 1);
}

} // namespace
} // namespace plc::app
