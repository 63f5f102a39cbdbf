// Breakpoints that wait: for a condition, for the number of a hit, for one instance of a block.
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QDockWidget>
#include <QTreeWidget>

namespace plc::app {
namespace {

class BreakpointsTest : public StudioTest {
protected:
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

TEST_F(BreakpointsTest, ABreakpointWaitsForItsCondition) {
    breakAt("counter := counter + 1");
    QTreeWidget* list = listIn("breakpoints");
    ASSERT_EQ(list->topLevelItemCount(), 1);
    list->topLevelItem(0)->setText(1, "counter = 7");
    ASSERT_TRUE(waitFor([&] { return window->control().breakpoints().front().condition == "counter = 7"; }));
    window->action("run.start")->trigger();
    ASSERT_TRUE(halts());
    EXPECT_EQ(window->control().value("Main.counter").text, "7");
}

TEST_F(BreakpointsTest, ABreakpointWaitsForItsHit) {
    breakAt("counter := counter + 1");
    listIn("breakpoints")->topLevelItem(0)->setText(2, "5");
    ASSERT_TRUE(waitFor([&] { return window->control().breakpoints().front().hitCount == 5; }));
    window->action("run.start")->trigger();
    ASSERT_TRUE(halts());
    EXPECT_EQ(window->control().value("Main.counter").text, "4") << "the fifth time";
}

TEST_F(BreakpointsTest, ABreakpointInABlockCanBelongToOneInstance) {
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

} // namespace
} // namespace plc::app
