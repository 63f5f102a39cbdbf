// After a fault the window shows the scan in which it happened, also where a plant goes on: line, call stack, watch and
// text are of one moment, until one goes back to the present.
#include "app/online/inside_views.h"
#include "app/panels/live_views.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/fault_scan.h"
#include "editor/debug/watch_view.h"
#include "editor/inside/slow_scan_view.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QLabel>
#include <QStatusBar>
#include <QTreeWidget>

namespace plc::app {
namespace {

const char* const kProgram = R"(VAR_GLOBAL
    level : DINT;
    Lamp AT %QX0.0 : BOOL;
END_VAR
FUNCTION Share : DINT
VAR_INPUT whole, parts : DINT; END_VAR
Share := whole / parts;
END_FUNCTION
{attribute 'simulation'}
PROGRAM Plant
level := level + 1;
END_PROGRAM
PROGRAM Main
VAR
    parts : DINT := 1000;
    each : DINT;
    seen : DINT;
END_VAR
parts := parts - 1;
Lamp := TRUE;
seen := level;
IF parts < 980 THEN
    each := Share(whole := level, parts := parts - 979);
END_IF
END_PROGRAM
)";

class FaultMomentTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, kProgram}});
        analysed();
        window->action("file.save")->trigger();
        window->showDock("callPath");
        window->showDock("watch");
        for (const char* each : {"level", "Main.seen", "Main.parts", "Lamp"}) window->watch().add(each);
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Fault; }));
        ASSERT_TRUE(waitFor([&] { // the plant has gone on
            const auto at = window->control().faultScan().position();
            return at && window->control().session()->history().statistics().end > *at + 5;
        }));
    }
    QString watched(const QString& name) {
        auto* tree = window->watch().findChild<QTreeWidget*>();
        for (int i = 0; i < tree->topLevelItemCount(); ++i)
            if (tree->topLevelItem(i)->text(0) == name) return tree->topLevelItem(i)->text(1);
        return "(none)";
    }
    QTreeWidget* treeCalled(const QString& name) {
        for (QTreeWidget* each : window->findChild<editor::CallPathView*>()->findChildren<QTreeWidget*>())
            if (each->accessibleName() == name) return each;
        return nullptr;
    }
    QString frameValue(const QString& name) {
        auto* tree = treeCalled("Values of the frame");
        for (int i = 0; i < tree->topLevelItemCount(); ++i)
            if (tree->topLevelItem(i)->text(0) == name) return tree->topLevelItem(i)->text(1);
        return "(none)";
    }
    bool statusReads(const QString& text) {
        for (const QLabel* each : window->statusBar()->findChildren<QLabel*>())
            if (each->text() == text) return true;
        return false;
    }
};

TEST_F(FaultMomentTest, PlaceCallStackAndValuesAreOfTheScanOfTheFault) {
    const uint64_t scan = window->control().status().fault->scan;
    ASSERT_TRUE(waitFor([&] { return window->control().viewed().has_value(); }));
    EXPECT_EQ(window->control().session()->history().stamp(*window->control().viewed())->scan, scan);
    ASSERT_TRUE(waitFor([&] { return watched("Main.parts") == "979"; })) << watched("Main.parts").toStdString();
    EXPECT_EQ(watched("level"), watched("Main.seen")) << "the plant's value is the one that the program has read";
    EXPECT_EQ(watched("Lamp"), "TRUE") << "as it was, before the outputs became safe";
    QTreeWidget* stack = treeCalled("Call stack");
    ASSERT_EQ(stack->topLevelItemCount(), 2);
    EXPECT_EQ(stack->topLevelItem(0)->text(0), "Share");
    EXPECT_EQ(frameValue("parts"), "0");
    EXPECT_EQ(frameValue("whole"), watched("level"));
    int line = 0, column = 0;
    editor().getCursorPosition(&line, &column);
    EXPECT_EQ(editor().text(line).trimmed(), "Share := whole / parts;");
    EXPECT_TRUE(statusReads("FAULT"));
    // The text says the same as the watch.
    EXPECT_TRUE(waitFor([&] {
        const auto& exact = editor().exactText();
        if (!exact) return false;
        return std::any_of(exact->values.begin(), exact->values.end(),
                           [&](const auto& each) { return each.text == watched("level"); });
    }));
}

TEST_F(FaultMomentTest, TheDivisorIsSelectedSoThatWhyAsksAboutIt) {
    ASSERT_TRUE(waitFor([&] { return window->control().viewed().has_value(); }));
    EXPECT_EQ(editor().selectedText(), "parts");
    const auto asked = editor().askedAbout();
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->name, "parts");
}

TEST_F(FaultMomentTest, BackToLiveShowsThePlantThatGoesOnAndNobodyIsTakenBackAgain) {
    ASSERT_TRUE(waitFor([&] { return window->control().viewed().has_value(); }));
    const int then = watched("level").toInt();
    window->action("time.live")->trigger();
    ASSERT_TRUE(waitFor([&] { return watched("level").toInt() > then + 10; }));
    EXPECT_FALSE(window->control().viewed().has_value());
    EXPECT_EQ(treeCalled("Call stack")->topLevelItemCount(), 0) << "it belongs to an earlier scan";
    EXPECT_EQ(watched("Lamp"), "FALSE") << "outputs are safe";
    EXPECT_TRUE(statusReads("FAULT"));
}

TEST_F(FaultMomentTest, RunningAgainIsLiveAndTheNextFaultIsShownAgain) {
    ASSERT_TRUE(waitFor([&] { return window->control().viewed().has_value(); }));
    const session::Session* before = window->control().session();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] {
        return window->control().session() != before && window->control().status().state == controller::State::Fault &&
               window->control().viewed().has_value();
    }));
    EXPECT_TRUE(waitFor([&] { return watched("Main.parts") == "979"; }));
}

TEST_F(FaultMomentTest, SteppingBackBeginsAtTheStatementThatFailed) {
    QTest::keyClick(window.get(), Qt::Key_F8, Qt::ControlModifier | Qt::ShiftModifier);
    editor::SlowScanView& slow = window->inside().slowScan();
    ASSERT_TRUE(waitFor([&] { return slow.isOpen(); }));
    EXPECT_TRUE(window->dock("slowScan")->isVisible());
    ASSERT_EQ(slow.frames().topLevelItemCount(), 2);
    EXPECT_EQ(slow.frames().topLevelItem(0)->text(0), "Share");
    EXPECT_EQ(slow.scan()->at() + 1, slow.scan()->stops());
    QTest::keyClick(window.get(), Qt::Key_F8, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_EQ(slow.frames().topLevelItemCount(), 1) << "the call";
    EXPECT_EQ(slow.frames().topLevelItem(0)->text(0), "Main");
}

} // namespace
} // namespace plc::app
