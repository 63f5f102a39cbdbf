// Exact values in the text of the scan that is shown, and the walk through it, forwards and backwards.
#include "app/online/inside_views.h"
#include "app/panels/live_views.h"
#include "tests/app/idle_chart.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/two_axes.h"

#include <QAction>
#include <QDockWidget>
#include <QTreeWidget>

namespace plc::app {
namespace {

class ExactValuesTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        QApplication::setActiveWindow(window.get());
        const auto end = static_cast<uint32_t>(editor().utf8().size());
        editor().applyEdits({{{FileId(), 0, end}, testing::kTwoAxes}});
        analysed();
        window->action("file.save")->trigger();
        for (QDockWidget* dock : window->findChildren<QDockWidget*>()) dock->hide(); // all lines are in sight
        editor().goTo(0);
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().value("Main.n").text.toInt() > 50; }));
        window->action("run.pause")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    }
    /// Another text, running and paused after some scans.
    void runText(const char* text) {
        window->control().disconnectSession();
        editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, text}});
        analysed();
        window->action("file.save")->trigger();
        editor().goTo(0);
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().value("Main.n").text.toInt() > 50; }));
        window->action("run.pause")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    }
    uint32_t at(const std::string& text) { return static_cast<uint32_t>(editor().utf8().find(text)); }
    /// "5 → 6", of the first value of that name beside the line with the text.
    std::string beside(const std::string& text, const char* name) {
        const long line =
            editor().SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, static_cast<unsigned long>(at(text)));
        for (const auto& [shown, values] : editor().shownValues())
            if (shown == line)
                for (const editor::OnlineValue& value : values)
                    if (value.name == name)
                        return ((value.before.isEmpty() ? QString() : value.before + " → ") + value.value)
                            .toStdString();
        return {};
    }
    bool isDimmed(const std::string& text) {
        const uint32_t wanted = at(text);
        const auto& exact = editor().exactText();
        return exact && std::any_of(exact->notRun.begin(), exact->notRun.end(),
                                    [&](const auto& range) { return range.first <= wanted && wanted < range.second; });
    }
    bool isExact() {
        return waitFor([&] { return editor().exactText().has_value() && !window->inside().desk().isBusy(); });
    }
    int n() { return window->control().value("Main.n").text.toInt(); }
    /// The text of the line that is marked as the next to run.
    std::string markedLine() {
        const long line = editor().SendScintilla(QsciScintillaBase::SCI_MARKERNEXT, 0ul, 1l << 2);
        return line < 0 ? "" : editor().text(static_cast<int>(line)).trimmed().toStdString();
    }
};

TEST_F(ExactValuesTest, EachLineShowsWhatItReadAndWroteInThatScan) {
    ASSERT_TRUE(isExact());
    const std::string before = std::to_string(n() - 11), middle = std::to_string(n() - 10), after = std::to_string(n());
    EXPECT_TRUE(waitFor([&] { return beside("n := n + 1;", "n") == before + " → " + middle; }))
        << beside("n := n + 1;", "n");
    EXPECT_EQ(beside("n := n + 10;", "n"), middle + " → " + after);
    EXPECT_TRUE(isDimmed("n := 0;"));
    EXPECT_FALSE(isDimmed("n := n + 1;"));
    window->control().stepView(-1);
    ASSERT_TRUE(waitFor([&] {
        return beside("n := n + 10;", "n") == std::to_string(n() - 10) + " → " + std::to_string(n());
    })) << "the scan before: "
        << beside("n := n + 10;", "n");
}

TEST_F(ExactValuesTest, TheBranchIsThatOfTheInstanceThatIsShown) {
    ASSERT_TRUE(isExact());
    window->control().setPreferredInstance("Axis", "Main.a");
    EXPECT_TRUE(waitFor([&] { return isDimmed("pos := pos + step;") && !isDimmed("pos := pos - 1;"); }));
    window->control().setPreferredInstance("Axis", "Main.b");
    EXPECT_TRUE(waitFor([&] { return !isDimmed("pos := pos + step;") && isDimmed("pos := pos - 1;"); }));
    ASSERT_FALSE(editor().exactText()->conditions.empty());
    EXPECT_TRUE(editor().exactText()->conditions.front().isTrue);
}

TEST_F(ExactValuesTest, AClickChoosesThePassOfALoop) {
    ASSERT_TRUE(isExact());
    EXPECT_TRUE(waitFor([&] { return beside("sum := sum + i;", "sum") == "3 → 6"; }));
    EXPECT_EQ(beside("FOR i := 1", "pass"), "3 of 3");
    emit editor().passRequested(at("FOR i := 1"), 0);
    EXPECT_TRUE(waitFor([&] { return beside("sum := sum + i;", "sum") == "0 → 1"; }))
        << beside("sum := sum + i;", "sum");
    EXPECT_EQ(beside("FOR i := 1", "pass"), "1 of 3");
}

TEST_F(ExactValuesTest, AnEditTakesThemAway) {
    ASSERT_TRUE(isExact());
    editor().goTo(at("n := n + 1;"));
    QTest::keyClicks(editor().viewport(), " ");
    EXPECT_FALSE(editor().exactText());
    window->workspace().revert("src/main.st");
}

TEST_F(ExactValuesTest, AnUndoBringsThemBack) {
    ASSERT_TRUE(isExact());
    for (int i = 0; i < 3; ++i) { // with and without a check in between
        editor().goTo(at("n := n + 1;"));
        QTest::keyClicks(editor().viewport(), " ");
        ASSERT_FALSE(editor().exactText());
        if (i > 0) analysed();
        window->action("edit.undo")->trigger();
        ASSERT_EQ(editor().utf8(), testing::kTwoAxes);
        EXPECT_TRUE(waitFor([&] {
            return beside("n := n + 10;", "n") == std::to_string(n() - 10) + " → " + std::to_string(n());
        })) << "round "
            << i << ": " << beside("n := n + 10;", "n");
    }
}

TEST_F(ExactValuesTest, AScanAtABreakpointShowsWhatItHasComputedUntilThere) {
    const std::string above = std::string(testing::kTwoAxes).substr(0, at("a(step := 1)"));
    window->control().toggleBreakpoint("src/main.st",
                                       static_cast<int>(std::count(above.begin(), above.end(), '\n')) + 1);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Halted; }));
    ASSERT_EQ(markedLine(), "a(step := 1);");
    const int now = n();
    EXPECT_TRUE(waitFor([&] {
        return beside("n := n + 1;", "n") == std::to_string(now - 11) + " → " + std::to_string(now - 10);
    })) << beside("n := n + 1;", "n");
    EXPECT_EQ(beside("n := n + 10;", "n"), std::to_string(now - 10) + " → " + std::to_string(now));
    EXPECT_EQ(beside("sum := sum + i;", "sum"), "") << "it has not come there yet";
    EXPECT_FALSE(isDimmed("sum := sum + i;")) << "it may still come there";
    window->action("run.stepOver")->trigger();
    ASSERT_TRUE(waitFor([&] { return markedLine() == "b(step := 2);"; }));
    EXPECT_TRUE(
        waitFor([&] { return editor().exactText() && beside("n := n + 10;", "n").find(" → ") != std::string::npos; }));
}

TEST_F(ExactValuesTest, AllThatATextShowsIsOfOneMoment) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Running; }));
    int seen = 0;
    EXPECT_TRUE(waitFor([&] { // "n" beside its declaration is what the last line that writes it left
        const std::string line = beside("n := n + 10;", "n"), declared = beside("n, i, sum : INT;", "n");
        const size_t arrow = line.find(" → ");
        if (arrow == std::string::npos || declared.empty()) return false;
        EXPECT_EQ(line.substr(arrow + std::string(" → ").size()), declared);
        return HasFailure() || ++seen > 40;
    }));
}

TEST_F(ExactValuesTest, AChartDimsTheActionsThatDidNotRun) {
    runText(kIdleChart);
    EXPECT_TRUE(waitFor([&] { return isDimmed("made := made + 1;"); }));
    EXPECT_FALSE(isDimmed("n := n + 1;"));
    EXPECT_TRUE(
        waitFor([&] { return beside("n := n + 1;", "n") == std::to_string(n() - 1) + " → " + std::to_string(n()); }));
    EXPECT_EQ(beside("FROM Idle TO Work", "go"), "FALSE");
}

TEST_F(ExactValuesTest, AnInstructionListShowsItsResultsOfThatPlace) {
    runText(R"(PROGRAM Main
VAR
    n, m : INT;
END_VAR
LD n
ADD 1
ST n
LD n
ADD 10
ST n
ST m
END_PROGRAM
)");
    EXPECT_TRUE(waitFor([&] { return beside("ADD 1\n", "CR") == std::to_string(n() - 10); }))
        << beside("ADD 1\n", "CR");
    EXPECT_EQ(beside("LD n", "CR"), std::to_string(n() - 11));
    EXPECT_EQ(beside("ADD 10", "CR"), std::to_string(n()));
}

TEST_F(ExactValuesTest, RunningItIsASampleAgainAndAgain) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Running; }));
    const std::string first = beside("n := n + 10;", "n");
    EXPECT_TRUE(waitFor([&] {
        const std::string now = beside("n := n + 10;", "n");
        return now != first && now.find(" → ") != std::string::npos;
    }));
}

TEST_F(ExactValuesTest, TheWalkGoesThroughTheScanInBothDirections) {
    window->control().stepView(-3);
    const int there = n();
    window->action("time.walk")->trigger();
    editor::SlowScanView& slow = window->inside().slowScan();
    ASSERT_TRUE(waitFor([&] { return slow.isOpen(); }));
    EXPECT_TRUE(window->dock("slowScan")->isVisible());
    EXPECT_EQ(markedLine(), "n := n + 1;");
    QTest::keyClick(window.get(), Qt::Key_F10);
    EXPECT_EQ(markedLine(), "n := n + 10;");
    const auto value = [&](const char* name) {
        QTreeWidgetItemIterator it(&slow.values());
        for (; *it; ++it)
            if ((*it)->text(0) == name) return (*it)->text(1).toInt();
        return -1;
    };
    EXPECT_EQ(value("n"), there - 10) << "as it is at this moment";
    window->action("run.stepOver")->trigger();
    EXPECT_EQ(value("n"), there);
    EXPECT_EQ(markedLine(), "a(step := 1);");
    window->action("run.stepIn")->trigger();
    EXPECT_EQ(markedLine(), "IF step > 1 THEN");
    ASSERT_EQ(slow.frames().topLevelItemCount(), 2);
    EXPECT_EQ(slow.frames().topLevelItem(0)->text(1), "Main.a");
    window->action("run.stepOut")->trigger();
    EXPECT_EQ(markedLine(), "b(step := 2);");
    window->action("time.backOver")->trigger();
    window->action("time.backOver")->trigger();
    EXPECT_EQ(markedLine(), "n := n + 10;");
    EXPECT_EQ(value("n"), there - 10);
    EXPECT_EQ(n(), there) << "panel, chart and watch stay at the scan";
    window->control().view(std::nullopt);
    EXPECT_FALSE(slow.isOpen()) << "back to live ends it";
    EXPECT_EQ(markedLine(), "");
}

} // namespace
} // namespace plc::app
