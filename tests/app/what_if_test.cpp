// What if?: from a past scan on with other values, drawn over what happened; and what tests and recordings cover, in
// the margin.
#include "app/online/inside_views.h"
#include "app/online/what_if_dialog.h"
#include "app/panels/live_views.h"
#include "app/testing/test_view.h"
#include "editor/graph/chart/chart_view.h"
#include "tests/app/idle_chart.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAction>
#include <QTableWidget>

namespace plc::app {
namespace {

const char* const kTank = R"(PROGRAM Main
VAR
    level, gain : DINT;
    full : BOOL;
END_VAR
IF gain = 0 THEN
    gain := 1;
END_IF
level := level + gain;
IF level > 1000000 OR full THEN
    full := TRUE;
END_IF
END_PROGRAM
)";

class WhatIfTest : public StudioTest {
protected:
    void SetUp() override {
        write("tests/level.st", "TEST 'rises'\nRUN 3 SCANS;\nASSERT Main.level = 3;\nEND_TEST\n");
        StudioTest::SetUp();
        const auto end = static_cast<uint32_t>(editor().utf8().size());
        editor().applyEdits({{{FileId(), 0, end}, kTank}});
        analysed();
        window->action("file.save")->trigger();
    }
    int level() { return window->control().value("Main.level").text.toInt(); }
    std::string covered(const char* text) {
        const auto at = editor().utf8().find(text);
        const long line = editor().SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, at);
        return editor().coverageAt(static_cast<int>(line)).toStdString();
    }
};

TEST_F(WhatIfTest, GoesOnFromAPastScanWithOtherValues) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return level() > 50; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    window->control().view(20);
    inNext<WhatIfDialog>(window.get(), [](WhatIfDialog& dialog) {
        dialog.addVariable("Main.gain");
        const int row = dialog.table().rowCount() - 1;
        dialog.table().item(row, 2)->setText("many");
        dialog.accept();
        EXPECT_TRUE(dialog.isVisible()) << "that is no value";
        dialog.table().item(row, 2)->setText("1000");
        dialog.accept();
    });
    window->action("time.whatIf")->trigger();
    EXPECT_FALSE(window->control().viewed()) << "it runs on";
    ASSERT_TRUE(waitFor([&] { return level() > 100'000; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    // Beneath the branch lies what happened before, and both begin together at the scan that was gone back to.
    const history::History& history = window->control().session()->history();
    ASSERT_EQ(history.branches().size(), 1u) << "the first scans are no branch of anything";
    EXPECT_EQ(history.branches().front().parent, 20u);
    const trace::Recording* before = window->live().traceView().beneath();
    ASSERT_NE(before, nullptr);
    EXPECT_EQ(before->extent().second, history.branches().front().first);
    EXPECT_TRUE(before->branches().empty());
    const auto last = [](const std::vector<history::Sample>& samples) { return samples.back().value; };
    const history::Position fork = history.branches().front().first;
    const auto now = window->live().traceView().recording()->samples("Main.level", fork, history.statistics().end);
    const auto then = before->samples("Main.level", 0, history.statistics().end);
    ASSERT_FALSE(now.empty());
    ASSERT_FALSE(then.empty());
    EXPECT_EQ(then.size(), fork) << "nothing of the branch";
    EXPECT_GT(last(now), 100'000);
    EXPECT_LT(last(then), 10'000) << "as it went without the change";
    EXPECT_EQ(now.front().at.scan, then[21].at.scan);
    const auto& channels = window->live().traceView().setup().channels;
    EXPECT_TRUE(std::any_of(channels.begin(), channels.end(), [](const auto& channel) {
        return channel.expression == "Main.gain";
    })) << "what was changed is drawn";
}

TEST_F(WhatIfTest, TestsColourTheMarginWithWhatTheyCover) {
    EXPECT_EQ(covered("level := level + gain;"), "");
    window->showDock("tests");
    auto* covers = window->tests().findChild<QAction*>("testCoverage");
    ASSERT_NE(covers, nullptr);
    covers->trigger();
    window->action("run.tests")->trigger();
    ASSERT_TRUE(waitFor([&] { return !covered("level := level + gain;").empty(); }));
    EXPECT_NE(covered("level := level + gain;").find("run 3 times"), std::string::npos)
        << covered("level := level + gain;");
    EXPECT_NE(covered("full := TRUE;").find("not run"), std::string::npos) << covered("full := TRUE;");
    EXPECT_NE(covered("IF level > 1000000").find("missing: "), std::string::npos) << covered("IF level > 1000000");
    window->action("time.noCoverage")->trigger();
    EXPECT_EQ(covered("level := level + gain;"), "");
}

TEST_F(WhatIfTest, AChartIsColouredWithWhatWasCovered) {
    editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, kIdleChart}});
    analysed();
    window->action("file.save")->trigger();
    editor::ChartView* view = window->tabs().currentPage()->showChart("Main");
    ASSERT_NE(view, nullptr);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.n").text.toInt() > 20; }));
    window->action("run.pause")->trigger();
    EXPECT_TRUE(view->scene().coverage().steps.isEmpty());
    window->action("time.coverage")->trigger();
    ASSERT_TRUE(waitFor([&] { return !view->scene().coverage().steps.isEmpty(); }));
    using State = editor::CoverageMark::State;
    const editor::ChartCoverage& shown = view->scene().coverage();
    EXPECT_NE(shown.steps.value(0).state, State::NotRun);
    EXPECT_EQ(shown.steps.value(1).state, State::NotRun) << "Work was never active";
    EXPECT_EQ(shown.transitions.value(0).state, State::Partly) << "never TRUE";
    EXPECT_TRUE(shown.actions.contains({1, 0}));
    QGraphicsItem* work = view->scene().itemOf(editor::ChartScene::Step, 1);
    EXPECT_NE(work->toolTip().toStdString().find("not run"), std::string::npos) << work->toolTip().toStdString();
    // A line above: the colours move with what they are of.
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("INITIAL_STEP")));
    QTest::keyClick(editor().viewport(), Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return view->scene().coverage().steps.value(1).state == State::NotRun; }));
    window->action("time.noCoverage")->trigger();
    EXPECT_TRUE(view->scene().coverage().steps.isEmpty());
}

TEST_F(WhatIfTest, ARecordingColoursTheMarginToo) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return level() > 20; }));
    window->action("run.pause")->trigger();
    window->action("time.coverage")->trigger();
    ASSERT_TRUE(waitFor([&] { return !covered("level := level + gain;").empty(); }));
    EXPECT_NE(covered("full := TRUE;").find("not run"), std::string::npos);
}

} // namespace
} // namespace plc::app
