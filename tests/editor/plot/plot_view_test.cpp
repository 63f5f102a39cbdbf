// The plot widget under a user's hands: wheel, box, pan, cursors, keys, drops.
#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/theme.h"
#include "editor/plot/plot_view.h"

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

using namespace plc::kit;
using namespace plc::plot;

namespace {

constexpr int64_t Ms = 1'000'000, S = 1'000'000'000;

class PlotViewTest : public ::testing::Test {
protected:
    void SetUp() override {
        source = std::make_shared<SampleList>();
        for (int i = 0; i <= 1000; ++i) source->append(i * 10 * Ms, i % 100);
        view.edit([&](PlotModel& model) {
            PlotCurve curve;
            curve.id = curve.name = "v";
            curve.color = colors().curve(0);
            curve.source = source;
            model.curves = {curve};
            model.from = 0;
            model.to = 10 * S;
            model.charts[0].axes[0].mode = AxisMode::Fixed;
            model.charts[0].axes[0].fixed = {0, 100};
        });
        view.resize(800, 400);
        view.show();
        view.grab();
    }
    QPoint at(int64_t time, double value) const {
        const PlotMapping map = view.renderer().mapping(view.model(), view.renderer().panes()[0]);
        return QPointF(map.xOf(time), map.yOf(value)).toPoint();
    }
    void wheel(const QPoint& point, int steps, Qt::KeyboardModifiers modifiers = {}) {
        QWheelEvent event(point, view.mapToGlobal(point), {}, QPoint(0, 120 * steps), Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
        view.grab();
    }
    void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&view, button, modifiers, from);
        QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&view, &move);
        QTest::mouseRelease(&view, button, modifiers, to);
        view.grab();
    }
    std::shared_ptr<SampleList> source;
    PlotView view;
};

} // namespace

TEST_F(PlotViewTest, WheelZoomsTimeAboutThePointer) {
    const QPoint point = at(4 * S, 50);
    wheel(point, 3);
    EXPECT_NEAR(static_cast<double>(view.model().to - view.model().from), 10e9 * 0.8 * 0.8 * 0.8, 1e3);
    EXPECT_LE((at(4 * S, 50) - point).manhattanLength(), 1);
    wheel(point, -3);
    EXPECT_NEAR(static_cast<double>(view.model().from), 0, 2e7);
}

TEST_F(PlotViewTest, ControlWheelZoomsValuesOnly) {
    const QPoint point = at(4 * S, 25);
    wheel(point, 2, Qt::ControlModifier);
    EXPECT_EQ(view.model().to - view.model().from, 10 * S);
    ASSERT_TRUE(view.model().charts[0].axes[0].zoom);
    EXPECT_NEAR(view.model().charts[0].axes[0].zoom->high - view.model().charts[0].axes[0].zoom->low, 64, 1e-6);
    EXPECT_LE((at(4 * S, 25) - point).manhattanLength(), 1);
}

TEST_F(PlotViewTest, WheelOverAnAxisZoomsThatAxis) {
    const QRectF area = view.renderer().panes()[0].area;
    wheel(QPointF(area.left() - 15, area.center().y()).toPoint(), 1);
    ASSERT_TRUE(view.model().charts[0].axes[0].zoom);
    EXPECT_EQ(view.model().to - view.model().from, 10 * S);
}

TEST_F(PlotViewTest, AFlatBoxZoomsTimeAWideOneBoth) {
    QSignalSpy ranges(&view, &PlotView::rangeChanged);
    drag(at(2 * S, 50), at(5 * S, 50) + QPoint(0, 3));
    EXPECT_NEAR(static_cast<double>(view.model().from), 2e9, 2e7);
    EXPECT_NEAR(static_cast<double>(view.model().to), 5e9, 2e7);
    EXPECT_FALSE(view.model().charts[0].axes[0].zoom);
    EXPECT_EQ(ranges.count(), 1);
    drag(at(3 * S, 80), at(4 * S, 20));
    ASSERT_TRUE(view.model().charts[0].axes[0].zoom);
    EXPECT_NEAR(view.model().charts[0].axes[0].zoom->low, 20, 1);
    EXPECT_NEAR(view.model().charts[0].axes[0].zoom->high, 80, 1);
    EXPECT_NEAR(static_cast<double>(view.model().from), 3e9, 2e7);

    QTest::keyClick(&view, Qt::Key_Backspace);
    EXPECT_FALSE(view.model().charts[0].axes[0].zoom);
    EXPECT_NEAR(static_cast<double>(view.model().from), 2e9, 2e7);
    QTest::keyClick(&view, Qt::Key_Backspace);
    EXPECT_EQ(view.model().from, 0);
    EXPECT_EQ(view.model().to, 10 * S);
}

TEST_F(PlotViewTest, AnUprightBoxZoomsValuesOnly) {
    drag(at(2 * S, 80), at(2 * S, 30) + QPoint(2, 0));
    ASSERT_TRUE(view.model().charts[0].axes[0].zoom);
    EXPECT_NEAR(view.model().charts[0].axes[0].zoom->low, 30, 1);
    EXPECT_EQ(view.model().from, 0);
    EXPECT_EQ(view.model().to, 10 * S);
}

TEST_F(PlotViewTest, AClickZoomsNothing) {
    drag(at(2 * S, 50), at(2 * S, 50) + QPoint(2, 1));
    EXPECT_EQ(view.model().from, 0);
    EXPECT_EQ(view.model().to, 10 * S);
    EXPECT_FALSE(view.canZoomBack());
}

TEST_F(PlotViewTest, MiddleButtonPansAndPanToolPansWithTheLeft) {
    drag(at(5 * S, 50), at(3 * S, 50), Qt::MiddleButton);
    EXPECT_NEAR(static_cast<double>(view.model().from), 2e9, 3e7);
    EXPECT_EQ(view.model().to - view.model().from, 10 * S);
    view.setTool(PlotTool::Pan);
    drag(at(5 * S, 50), at(7 * S, 50));
    EXPECT_NEAR(static_cast<double>(view.model().from), 0, 4e7);
}

TEST_F(PlotViewTest, CursorsSnapToSamplesAndStepByKeys) {
    QSignalSpy moved(&view, &PlotView::cursorsChanged);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, at(3 * S + 4 * Ms, 50));
    ASSERT_TRUE(view.model().cursorA);
    EXPECT_EQ(*view.model().cursorA % (10 * Ms), 0);
    EXPECT_NEAR(static_cast<double>(*view.model().cursorA), 3e9, 2e7);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::ShiftModifier, at(6 * S, 50));
    ASSERT_TRUE(view.model().cursorB);
    EXPECT_EQ(moved.count(), 2);
    const int64_t before = *view.model().cursorB;
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(*view.model().cursorB, before + 10 * Ms);
    QTest::keyClick(&view, Qt::Key_Left, Qt::ControlModifier);
    EXPECT_EQ(*view.model().cursorB, before - 90 * Ms);

    view.grab();
    drag(at(*view.model().cursorA, 50), at(1 * S, 50)); // taken by the line
    EXPECT_NEAR(static_cast<double>(*view.model().cursorA), 1e9, 2e7);
    EXPECT_EQ(view.model().from, 0) << "dragging a cursor is no zoom";
}

TEST_F(PlotViewTest, FollowsNewSamplesUntilTheUserLooksBack) {
    view.setRange(8 * S, 10 * S);
    view.setFollowing(true);
    for (int i = 1001; i <= 1500; ++i) source->append(i * 10 * Ms, 1);
    view.refresh();
    EXPECT_GE(view.model().to, 15 * S);
    EXPECT_EQ(view.model().to - view.model().from, 2 * S);
    view.grab();
    QSignalSpy following(&view, &PlotView::followingChanged);
    drag(at(view.model().from + S, 50), at(view.model().from + S, 50) + QPoint(200, 0), Qt::MiddleButton);
    EXPECT_FALSE(view.isFollowing());
    EXPECT_EQ(following.count(), 1);
    const int64_t from = view.model().from;
    source->append(16 * S, 1);
    view.refresh();
    EXPECT_EQ(view.model().from, from);
    QTest::keyClick(&view, Qt::Key_End);
    EXPECT_GE(view.model().to, 16 * S);
}

TEST_F(PlotViewTest, LegendSelectsAndHides) {
    ASSERT_EQ(view.renderer().legend().size(), 1u);
    const QPoint entry = view.renderer().legend()[0].rect.center().toPoint();
    QSignalSpy selected(&view, &PlotView::curveSelected), toggled(&view, &PlotView::curveToggled);
    QTest::mouseClick(&view, Qt::LeftButton, {}, entry);
    EXPECT_EQ(view.model().selected, "v");
    EXPECT_EQ(selected.count(), 1);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, entry);
    EXPECT_FALSE(view.model().curves[0].isVisible);
    EXPECT_EQ(toggled.count(), 1);
}

TEST_F(PlotViewTest, DroppedVariablesNameTheChartUnderThem) {
    view.edit([](PlotModel& model) { model.charts.emplace_back(); });
    view.grab();
    QSignalSpy dropped(&view, &PlotView::variablesDropped);
    std::unique_ptr<QMimeData> mime(makeVariableMime({"Main.a", "Main.b"}));
    const QPointF point = view.renderer().panes()[1].area.center();
    QDragEnterEvent enter(point.toPoint(), Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&view, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(point, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&view, &drop);
    ASSERT_EQ(dropped.count(), 1);
    EXPECT_EQ(dropped[0][0].toStringList(), (QStringList{"Main.a", "Main.b"}));
    EXPECT_EQ(dropped[0][1].toInt(), 1);
}

TEST_F(PlotViewTest, FitShowsEverythingAgain) {
    drag(at(2 * S, 80), at(3 * S, 20));
    QTest::keyClick(&view, Qt::Key_Home);
    EXPECT_EQ(view.model().from, 0);
    EXPECT_EQ(view.model().to, 10 * S);
    EXPECT_FALSE(view.model().charts[0].axes[0].zoom);
}

TEST_F(PlotViewTest, DoubleClickAsksForThatScan) {
    QSignalSpy activated(&view, &PlotView::timeActivated);
    QTest::mouseDClick(&view, Qt::LeftButton, {}, at(2 * S, 50));
    ASSERT_EQ(activated.count(), 1);
    EXPECT_NEAR(activated[0][0].toDouble(), 2e9, 2e7);
}

TEST_F(PlotViewTest, EnterAsksForTheScanOfTheActiveCursorOrOfTheMiddle) {
    QSignalSpy activated(&view, &PlotView::timeActivated);
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(activated.count(), 1);
    EXPECT_EQ(activated[0][0].toLongLong(), 5 * S);
    view.setCursorsShown(true);
    view.setCursor(1, 7 * S);
    QTest::keyClick(&view, Qt::Key_Enter);
    ASSERT_EQ(activated.count(), 2);
    EXPECT_EQ(activated[1][0].toLongLong(), 7 * S);
}
