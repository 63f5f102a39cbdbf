// A recording from a file in the place of the controller: slider, values in the text and watch move to it, and back.
#include "app/live_views.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QToolButton>

namespace plc::app {
namespace {

TEST_F(StudioTest, AnOpenedRecordingIsShownEverywhereUntilOneGoesBack) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 5; }));
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    QTest::qWait(60);
    const QString recorded = window->control().value("Main.counter").text;
    const QString path = folder.path() + "/before.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > recorded.toInt() + 5; }));

    ASSERT_TRUE(window->live().openRecording(path));
    EXPECT_TRUE(window->control().showsRecorded());
    EXPECT_EQ(window->control().value("Main.counter").text, recorded);
    EXPECT_EQ(window->control().valueIn("counter", "Main").text, recorded) << "as in the text";
    auto* marker = window->findChild<QToolButton*>("recordingShown");
    ASSERT_NE(marker, nullptr);
    EXPECT_TRUE(waitFor([&] { return marker->isVisible(); }));
    EXPECT_TRUE(marker->text().contains("before.rec"));
    window->live().slider().stepScans(-1);
    EXPECT_EQ(window->control().value("Main.counter").text.toInt(), recorded.toInt() - 1);
    EXPECT_FALSE(window->control().write("Main.counter", "1")) << "the past of a file is read only";

    QTest::mouseClick(marker, Qt::LeftButton);
    EXPECT_FALSE(window->control().showsRecorded());
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > recorded.toInt(); }));
    EXPECT_TRUE(waitFor([&] { return !marker->isVisible(); }));
}

TEST_F(StudioTest, ARecordingOpensWithoutAController) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 5; }));
    const QString path = folder.path() + "/before.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    window->control().disconnectSession();
    ASSERT_TRUE(window->live().openRecording(path));
    EXPECT_GT(window->control().value("Main.counter").text.toInt(), 5);
    window->action("run.start")->trigger(); // goes back by itself
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 1; }));
    EXPECT_FALSE(window->control().showsRecorded());
}

} // namespace
} // namespace plc::app
