// The watch as one works with it: every type in every format, long arrays, parts that come with an online change,
// prepared values by the mouse, errors that say why; the log that is filtered and copied.
#include "app/documents/design_pages.h"
#include "app/panels/live_views.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/processor_time.h"

#include <QAction>
#include <QClipboard>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTreeWidget>

namespace plc::app {
namespace {

const char* const kTypes = R"(TYPE Colour : (Red, Green, Blue); END_TYPE
TYPE Point : STRUCT
    x : INT := 1;
    y : REAL := 2.5;
END_STRUCT END_TYPE
FUNCTION_BLOCK Base
VAR_OUTPUT
    inherited : INT := 7;
END_VAR
END_FUNCTION_BLOCK
FUNCTION_BLOCK Derived EXTENDS Base
VAR_OUTPUT
    own : BOOL := TRUE;
END_VAR
END_FUNCTION_BLOCK
PROGRAM Main
VAR
    b : BOOL := TRUE;
    i : INT := -2;
    w : WORD := 16#00FF;
    ms : UDINT := 90500;
    t : TIME := T#1m30s;
    r : REAL := 1.5;
    s : STRING := 'text';
    c : Colour := Colour.Green;
    p : Point;
    d : Derived;
    long : ARRAY[0..2499] OF INT;
    grid : ARRAY[1..2, 1..3] OF Point;
    n : INT;
END_VAR
n := n + 1;
long[n MOD 2500] := n;
long[3] := 33;
grid[2, 3].x := long[3] + 1;
END_PROGRAM
)";

class WatchTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        const auto end = static_cast<uint32_t>(editor().utf8().size());
        editor().applyEdits({{{FileId(), 0, end}, kTypes}});
        analysed();
        window->showDock("watch");
    }
    void run() {
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 5; }));
    }
    editor::WatchView& watch() { return window->watch(); }
    QTreeWidgetItem* row(int i) { return watch().tree().topLevelItem(i); }
    std::string value(int i) {
        watch().refresh();
        return row(i)->text(1).toStdString();
    }
};

TEST_F(WatchTest, ShowsEveryTypeInEveryFormat) {
    run();
    watch().setExpressions({"Main.b", "Main.i", "Main.w", "Main.ms", "Main.t", "Main.r", "Main.s", "Main.c"});
    const auto shown = [&] {
        QStringList out;
        for (int i = 0; i < 8; ++i) out << QString::fromStdString(value(i));
        return out.join(' ').toStdString();
    };
    EXPECT_EQ(shown(), "TRUE -2 255 90500 T#1m30s 1.5 'text' Green");
    watch().setFormat(types::NumberFormat::Hex);
    EXPECT_EQ(shown(), "TRUE 16#FFFE 16#00FF 16#00016184 T#1m30s 1.5 'text' Green");
    watch().setFormat(types::NumberFormat::Binary);
    EXPECT_EQ(value(2), "2#0000000011111111");
    watch().setFormat(types::NumberFormat::Time);
    EXPECT_EQ(shown(), "TRUE T#-2ms T#255ms T#1m30s500ms T#1m30s 1.5 'text' Green");
}

TEST_F(WatchTest, UnfoldsStructuresBlocksAndLongArrays) {
    run();
    watch().setExpressions({"Main.d", "Main.long", "Main.grid"});
    for (int i = 0; i < 3; ++i) row(i)->setExpanded(true);
    ASSERT_EQ(row(0)->childCount(), 2) << "what is inherited, too";
    EXPECT_EQ(row(0)->child(0)->text(0), "inherited");
    EXPECT_EQ(row(0)->child(0)->text(1), "7");
    ASSERT_EQ(row(1)->childCount(), 3) << "2500 elements in stretches of 1000";
    EXPECT_EQ(row(1)->child(2)->text(0), "[2000] … [2499]");
    const double begin = processorSeconds();
    row(1)->child(0)->setExpanded(true);
    EXPECT_LT(processorSeconds() - begin, kAtOnceSeconds);
    ASSERT_EQ(row(1)->child(0)->childCount(), 1000);
    EXPECT_EQ(row(1)->child(0)->child(3)->text(1), "33");
    row(1)->child(2)->setExpanded(true);
    ASSERT_EQ(row(1)->child(2)->childCount(), 500);
    EXPECT_EQ(editor::WatchView::expressionOf(row(1)->child(2)->child(499)), "Main.long[2499]");
    ASSERT_EQ(row(2)->childCount(), 6);
    EXPECT_EQ(row(2)->child(5)->text(0), "[2, 3]");
    row(2)->child(5)->setExpanded(true);
    ASSERT_EQ(row(2)->child(5)->childCount(), 2);
    EXPECT_EQ(row(2)->child(5)->child(0)->text(1), "34");
}

TEST_F(WatchTest, AnOnlineChangeBringsItsNewParts) {
    run();
    watch().setExpressions({"Main.p"});
    row(0)->setExpanded(true);
    ASSERT_EQ(row(0)->childCount(), 2);
    row(0)->child(0)->setText(3, "12");
    const auto at = static_cast<uint32_t>(editor().utf8().find("    y : REAL"));
    editor().applyEdits({{{FileId(), at, at}, "    z : INT := 5;\n"}});
    analysed();
    QSignalSpy changed(&window->control(), &editor::RunControl::onlineChangeFinished);
    window->action("run.change")->trigger();
    ASSERT_TRUE(waitFor([&] { return changed.count() == 1; }));
    EXPECT_TRUE(waitFor([&] { return row(0)->childCount() == 3; }));
    EXPECT_TRUE(row(0)->isExpanded());
    EXPECT_EQ(row(0)->child(0)->text(3), "12") << "what was prepared is still there";
}

TEST_F(WatchTest, PreparesByDoubleClickAndOnlyNamesAndPreparedValuesAreTyped) {
    run();
    watch().setExpressions({"Main.b", "Main.i"});
    ASSERT_TRUE(waitFor([&] { return value(0) == "TRUE" && value(1) == "-2"; }));
    QTreeWidget& tree = watch().tree();
    const auto doubleClick = [&](int i, int column) {
        const QPoint at = tree.visualRect(tree.model()->index(i, column)).center();
        QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(tree.viewport(), Qt::LeftButton, {}, at);
    };
    doubleClick(0, 1);
    EXPECT_EQ(row(0)->text(3), "FALSE") << "a BOOL is prepared to be the other";
    doubleClick(1, 2);
    EXPECT_EQ(tree.findChildren<QLineEdit*>().size(), 0) << "a type is not typed";
    doubleClick(1, 1);
    auto* field = tree.findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, "70000");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return row(1)->text(3) == "70000"; }));
    EXPECT_FALSE(row(1)->toolTip(3).isEmpty()) << "refused while it is typed: no INT";
    row(1)->setText(3, "70");
    EXPECT_TRUE(row(1)->toolTip(3).isEmpty());
    window->action("run.write")->trigger();
    EXPECT_TRUE(waitFor([&] { return value(0) == "FALSE" && value(1) == "70"; }));
    tree.setCurrentItem(row(1));
    QTest::keyClick(&tree, Qt::Key_Delete);
    EXPECT_EQ(watch().expressions(), QStringList{"Main.b"});
}

TEST_F(WatchTest, AWrongExpressionSaysWhyAndKeepsNoType) {
    run();
    watch().setExpressions({"Main.i"});
    ASSERT_EQ(value(0), "-2");
    EXPECT_EQ(row(0)->text(2), "INT");
    row(0)->setText(0, "Main.nothing + 1");
    watch().refresh();
    EXPECT_TRUE(row(0)->text(1).contains("nothing")) << row(0)->text(1).toStdString();
    EXPECT_EQ(row(0)->text(2), "");
    row(0)->setText(0, "Main.long[3] * 2 > 60");
    watch().refresh();
    EXPECT_EQ(value(0), "TRUE");
}

TEST_F(WatchTest, ArrayElementsHaveTheirValuesBesideTheText) {
    run();
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("grid[2, 3].x :=")));
    const auto names = [&] {
        editor().refreshOnlineValues();
        QStringList out;
        for (const auto& [line, values] : editor().shownValues())
            if (editor().text(line).contains("grid[2, 3].x :="))
                for (const auto& each : values) out << each.name + "=" + each.value;
        return out.join(' ').toStdString();
    };
    EXPECT_TRUE(waitFor([&] { return names() == "grid[2, 3].x=34 long[3]=33"; })) << names();
}

TEST_F(WatchTest, TheLogIsFilteredAndCopied) {
    window->showDock("log");
    run();
    (void)window->control().force("Main.i", "5");
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.i").isForced; }));
    window->say("something was refused", true);
    auto* log = window->findChild<editor::EventLog*>();
    const auto lines = [&] { return log->shownText().split('\n', Qt::SkipEmptyParts); };
    ASSERT_TRUE(waitFor([&] { return log->shownText().contains("Main.i"); })) << log->shownText().toStdString();
    const int all = static_cast<int>(lines().size());
    auto* filter = log->findChild<QLineEdit*>();
    ASSERT_NE(filter, nullptr);
    QTest::keyClicks(filter, "main.i");
    EXPECT_LT(lines().size(), all);
    for (const QString& line : lines()) EXPECT_TRUE(line.contains("Main.i", Qt::CaseInsensitive));
    filter->clear();
    for (QAction* each : log->findChildren<QAction*>())
        if (each->isCheckable()) each->trigger();
    // A slow machine logs more errors of its own; none of the notes may be among them.
    ASSERT_GE(lines().size(), 1);
    for (const QString& line : lines()) EXPECT_FALSE(line.contains("Main.i")) << line.toStdString();
    auto* tree = log->findChild<QTreeWidget*>();
    const auto found =
        tree->findItems("something was refused", Qt::MatchEndsWith | Qt::MatchRecursive, tree->columnCount() - 1);
    ASSERT_EQ(found.size(), 1);
    EXPECT_FALSE(found.first()->isHidden());
    tree->setFocus();
    tree->setCurrentItem(found.first());
    QTest::keyClick(tree, Qt::Key_C, Qt::ControlModifier);
    EXPECT_TRUE(QApplication::clipboard()->text().endsWith("something was refused\n"));
    EXPECT_EQ(QApplication::clipboard()->text().count('\t'), 3) << "columns as in the window";
}

TEST_F(WatchTest, ASingleScanIsOne) {
    window->action("run.scan")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 0; }));
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    EXPECT_EQ(window->control().status().scans, 1u);
    EXPECT_EQ(window->control().value("Main.n").text, "1");
    window->action("run.scan")->trigger();
    EXPECT_TRUE(waitFor([&] { return window->control().value("Main.n").text == "2"; }));
    EXPECT_EQ(window->control().status().state, controller::State::Paused);
}

TEST_F(WatchTest, TheDesignersPreviewShowsTheRecordingThatIsOpen) {
    run();
    ASSERT_TRUE(window->live().addPanel("main"));
    window->designs().openPanel("main");
    auto* designer = window->findChild<hmi::PanelDesigner*>();
    ASSERT_NE(designer, nullptr);
    designer->action(QStringLiteral("live"))->trigger();
    hmi::PanelPlayer* preview = designer->preview();
    ASSERT_NE(preview, nullptr);
    const hmi::BindingId n = preview->values()->bind("Main.n");
    const auto shown = [&] {
        preview->frame();
        return preview->values()->value(n).toInteger();
    };
    const QString path = folder.path() + "/before.rec";
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    ASSERT_TRUE(window->live().saveRecording(path));
    const int recorded = window->control().value("Main.n").text.toInt();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.n").text.toInt() > recorded + 5; }));
    ASSERT_TRUE(window->live().openRecording(path));
    EXPECT_TRUE(waitFor([&] { return shown() == window->control().value("Main.n").text.toInt(); })) << shown();
    window->live().slider().stepScans(-1);
    EXPECT_EQ(shown(), window->control().value("Main.n").text.toInt());
    window->action("time.live")->trigger();
    EXPECT_TRUE(waitFor([&] { return shown() > recorded; }));
    window->action("time.back")->trigger(); // the controller's own past, too
    ASSERT_TRUE(waitFor([&] { return window->control().viewed().has_value(); }));
    EXPECT_EQ(shown(), window->control().value("Main.n").text.toInt());
}

} // namespace
} // namespace plc::app
