// The trace view, the time slider and the picture maker under a user's hands, over a recording made of functions.
#include "editor/kit/inputs/property_grid.h"
#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/theme.h"
#include "editor/plot/plot_view.h"
#include "editor/trace/channel_panel.h"
#include "editor/trace/curves/trace_picture.h"
#include "editor/trace/time_slider.h"
#include "editor/trace/trace_view.h"
#include "runtime/controller/controller.h"
#include "tests/editor/trace/fake_recording.h"

#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QMimeData>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>

#include <gtest/gtest.h>

using namespace plc::trace;
namespace kit = plc::kit;
namespace plot = plc::plot;
namespace history = plc::history;

namespace {

/// A sentence of this test.
plc::Message says(std::string words) {
    static constexpr plc::messages::TypedForm<plc::messages::Name> form{"Test", "Said", "{0}"};
    return form(std::move(words));
}

constexpr int64_t Ms = 1'000'000, S = 1'000'000'000;

class TraceViewTest : public ::testing::Test {
protected:
    TraceViewTest() {
        recording.addReal("Main.sine", [](double t) { return std::sin(t * 6); });
        recording.addReal("Main.ramp", [](double t) { return t * 10; });
        recording.addBool("Main.run", [](double t) { return t >= 2 && t < 3; });
        recording.addBool("NOT (Main.run)", [](double t) { return !(t >= 2 && t < 3); });
        recording.run(1000);
        view.resize(1100, 640);
        view.setRecording(&recording);
        view.show();
        view.grab();
    }
    void type(const QString& text) {
        auto* entry = view.channels()->entry();
        entry->setFocus();
        QTest::keyClicks(entry, text);
        QTest::keyClick(entry, Qt::Key_Return);
    }
    void runFor(int scans) {
        recording.run(scans);
        for (int i = 0; i < 40; ++i) view.tick(); // a slow machine reads a little in each
        view.grab();
    }
    FakeRecording recording;
    TraceView view;
};

void keep(QWidget& widget, const QString& name) {
    const QString folder = qEnvironmentVariable("STEPWISE_PICTURES");
    for (int i = 0; i < 3; ++i) QApplication::processEvents();
    if (!folder.isEmpty()) widget.grab().save(folder + '/' + name + ".png");
}

} // namespace

TEST_F(TraceViewTest, TypedNamesBecomeChannelsWithTheirPast) {
    type("Main.sine");
    type("Main.run");
    ASSERT_EQ(view.setup().channels.size(), 2u);
    const plot::PlotModel& model = view.plot()->model();
    ASSERT_EQ(model.curves.size(), 2u);
    EXPECT_EQ(model.curves[0].style, plot::CurveStyle::Hold) << "a jump is vertical";
    EXPECT_EQ(model.curves[1].style, plot::CurveStyle::Digital);
    ASSERT_TRUE(model.curves[0].source);
    EXPECT_EQ(model.curves[0].source->countIn(0, INT64_MAX), 1000u);
    runFor(500);
    EXPECT_EQ(model.curves[0].source->countIn(0, INT64_MAX), 1500u);
}

TEST_F(TraceViewTest, WhatIsBeingTypedStaysWithItsChannelWhenAnotherIsSelected) {
    type("Main.sine");
    type("Main.run");
    view.channels()->selectChannel(0);
    kit::PropertyGrid* grid = view.channels()->properties();
    grid->editProperty("label");
    auto* line = grid->findChild<kit::ExpressionEdit*>();
    ASSERT_TRUE(line);
    QTest::keyClicks(line, "Wave");
    view.channels()->selectChannel(1);
    EXPECT_EQ(view.setup().channels[0].label, "Wave");
    EXPECT_EQ(view.setup().channels[1].label, "");
    EXPECT_EQ(view.channels()->selectedChannel(), 1);
}

TEST_F(TraceViewTest, AddingIsUndone) {
    type("Main.sine");
    EXPECT_TRUE(view.isModified());
    view.undoStack()->undo();
    EXPECT_TRUE(view.setup().channels.empty());
    EXPECT_TRUE(view.plot()->model().curves.empty());
    view.undoStack()->redo();
    EXPECT_EQ(view.plot()->model().curves.size(), 1u);
}

TEST_F(TraceViewTest, ABadExpressionIsShownAsSuch) {
    auto* entry = view.channels()->entry();
    QTest::keyClicks(entry, "Main.nothing");
    EXPECT_EQ(entry->complaint(), "there is no variable 'Main.nothing'; check the name or declare it");
    QTest::keyClick(entry, Qt::Key_Return);
    EXPECT_EQ(view.plot()->model().curves[0].problem,
              "there is no variable 'Main.nothing'; check the name or declare it");
    recording.addReal("Main.nothing", [](double) { return 1; });
    view.programChanged();
    EXPECT_TRUE(view.plot()->model().curves[0].problem.isEmpty());
}

TEST_F(TraceViewTest, DroppedVariablesGoWhereTheyFell) {
    type("Main.sine");
    for (QAction* action : view.findChild<QToolBar*>()->actions())
        if (action->text() == "Add chart") action->trigger();
    ASSERT_EQ(view.setup().charts.size(), 2u);
    view.grab();
    std::unique_ptr<QMimeData> mime(kit::makeVariableMime({"Main.ramp"}));
    const QPointF point = view.plot()->renderer().panes().back().area.center();
    QDragEnterEvent enter(point.toPoint(), Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(view.plot(), &enter);
    QDropEvent drop(point, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(view.plot(), &drop);
    ASSERT_EQ(view.setup().channels.size(), 2u);
    EXPECT_EQ(view.setup().channels[1].chart, 1);
}

TEST_F(TraceViewTest, LongValuesLeaveTheNamesTheirRoom) {
    TraceSetup setup = view.setup();
    setup.channels.emplace_back();
    setup.channels[0].expression = "Main.sine";
    setup.channels[0].unit = "kilograms per square metre";
    view.setSetup(setup);
    QTreeWidget* list = view.channels()->list();
    view.grab();
    runFor(7);
    const QTreeWidgetItem* item = list->topLevelItem(0)->child(0);
    ASSERT_TRUE(item->text(1).contains("kilograms"));
    const QAbstractItemView& sizes = *list;
    ASSERT_GT(sizes.sizeHintForColumn(0) + sizes.sizeHintForColumn(1), list->viewport()->width()) << "not both fit";
    EXPECT_GE(list->columnWidth(0), sizes.sizeHintForColumn(0));
    EXPECT_GE(list->columnWidth(1), list->fontMetrics().horizontalAdvance("-0.958"));
    EXPECT_EQ(item->toolTip(1), item->text(1));
}

TEST_F(TraceViewTest, TheListShowsTheColourOfTheCurveOnADarkGroundToo) {
    kit::Theme::current().setChoice(kit::ThemeChoice::Dark);
    TraceSetup setup = view.setup();
    setup.channels.emplace_back();
    setup.channels[0].expression = "Main.sine";
    setup.channels[0].color = "#1f5fbf";
    view.setSetup(setup);
    view.grab();
    const QImage swatch = view.channels()->list()->topLevelItem(0)->child(0)->icon(0).pixmap(16, 16).toImage();
    EXPECT_EQ(swatch.pixelColor(swatch.rect().center()).name(), view.plot()->model().curves.at(0).color.name());
    kit::Theme::current().setChoice(kit::ThemeChoice::Light);
}

TEST_F(TraceViewTest, PropertiesChangeTheCurve) {
    type("Main.ramp");
    view.channels()->selectChannel(0);
    kit::PropertyGrid* grid = view.channels()->properties();
    ASSERT_TRUE(grid->descriptor("scale"));
    grid->editProperty("unit");
    auto* line = grid->viewport()->findChild<QLineEdit*>();
    ASSERT_TRUE(line);
    QTest::keyClicks(line, "mm");
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(view.setup().channels[0].unit, "mm");
    EXPECT_EQ(view.plot()->model().curves[0].unit, "mm");
    EXPECT_EQ(view.channels()->selectedChannel(), 0) << "the selection stays";
    emit grid->committed("chart", 1);
    EXPECT_EQ(view.setup().charts.size(), 2u) << "\"New chart\" makes one";
    EXPECT_EQ(view.setup().channels[0].chart, 1);
}

TEST_F(TraceViewTest, DeleteRemovesAndCheckHides) {
    type("Main.sine");
    type("Main.ramp");
    view.channels()->selectChannel(0);
    QTreeWidgetItem* item = view.channels()->list()->currentItem();
    item->setCheckState(0, Qt::Unchecked);
    EXPECT_FALSE(view.setup().channels[0].isVisible);
    view.channels()->selectChannel(0);
    QTest::keyClick(view.channels()->list(), Qt::Key_Delete);
    ASSERT_EQ(view.setup().channels.size(), 1u);
    EXPECT_EQ(view.setup().channels[0].expression, "Main.ramp");
}

TEST_F(TraceViewTest, TheTriggerStopsTheViewWithWhatCameBefore) {
    type("Main.sine");
    TraceSetup setup = view.setup();
    setup.trigger = {"Main.run", TriggerEdge::Rising, TriggerMode::Single, 500 * Ms, 300 * Ms, {}};
    view.setSetup(setup);
    EXPECT_EQ(view.triggerState(), TriggerState::Armed);
    runFor(1000); // to 2 s: not yet
    EXPECT_EQ(view.triggerState(), TriggerState::Armed);
    runFor(100);
    EXPECT_EQ(view.triggerState(), TriggerState::Collecting);
    EXPECT_TRUE(view.statusText().contains("collecting"));
    runFor(300);
    EXPECT_EQ(view.triggerState(), TriggerState::Done);
    const plot::PlotModel& model = view.plot()->model();
    ASSERT_TRUE(model.trigger);
    EXPECT_EQ(*model.trigger, 2 * S);
    EXPECT_EQ(model.from, 1500 * Ms);
    EXPECT_EQ(model.to, 2300 * Ms);
    EXPECT_FALSE(view.plot()->isFollowing());
    runFor(2000);
    EXPECT_EQ(model.from, 1500 * Ms) << "single: it stays";
    view.armTrigger();
    EXPECT_EQ(view.triggerState(), TriggerState::Armed);
}

TEST_F(TraceViewTest, ATriggerIsFoundInThePast) {
    type("Main.sine");
    runFor(4000); // 5 s
    TraceSetup setup = view.setup();
    setup.trigger = {"Main.run", TriggerEdge::Both, TriggerMode::Off, 100 * Ms, 100 * Ms, {}};
    view.setSetup(setup);
    view.plot()->setRange(4 * S, 5 * S);
    ASSERT_TRUE(view.findTrigger(history::History::Direction::Backward));
    EXPECT_EQ(*view.plot()->model().trigger, 3 * S) << "the falling edge is the nearer one";
    ASSERT_TRUE(view.findTrigger(history::History::Direction::Backward));
    EXPECT_EQ(*view.plot()->model().trigger, 2 * S);
    ASSERT_TRUE(view.findTrigger(history::History::Direction::Forward));
    EXPECT_EQ(*view.plot()->model().trigger, 3 * S);
}

TEST_F(TraceViewTest, MarksOfTheRecordingAreShown) {
    type("Main.sine");
    using plc::controller::EventKind;
    recording.markList.push_back({0, history::Nanoseconds(0), static_cast<int>(EventKind::Started), says("started")});
    recording.markList.push_back(
        {500, history::Nanoseconds(500 * Ms), static_cast<int>(EventKind::Force), says("valve forced")});
    recording.markList.push_back(
        {600, history::Nanoseconds(600 * Ms), static_cast<int>(EventKind::Write), says("button")});
    view.tick();
    ASSERT_EQ(view.plot()->model().markers.size(), 1u) << "writes would bury the rest";
    EXPECT_EQ(view.plot()->model().markers[0].kind, plot::MarkerKind::Force);
    recording.goBackTo(300);
    recording.markList.push_back(
        {1000, history::Nanoseconds(301 * Ms), static_cast<int>(EventKind::WentBack), says("went back")});
    runFor(5);
    ASSERT_EQ(view.plot()->model().markers.size(), 1u) << "the abandoned future's marks have left";
    EXPECT_EQ(view.plot()->model().markers[0].kind, plot::MarkerKind::Branch);
}

TEST_F(TraceViewTest, MeasuresBetweenCursors) {
    type("Main.ramp");
    TraceSetup setup = view.setup();
    setup.hasTable = true;
    setup.cursorA = 200 * Ms;
    setup.cursorB = 800 * Ms;
    view.setSetup(setup);
    auto* table = view.findChild<QTableWidget*>();
    ASSERT_TRUE(table && table->isVisible());
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 1)->text(), "2");
    EXPECT_EQ(table->item(0, 2)->text(), "8");
    EXPECT_TRUE(view.statusText().contains("Δt = 600 ms"));
}

TEST_F(TraceViewTest, SetupsAreStoredAndOpened) {
    QTemporaryDir folder;
    type("Main.sine");
    view.plot()->setRange(0, 3 * S);
    ASSERT_TRUE(view.storeSetup(folder.filePath("a.trace.json")));
    EXPECT_FALSE(view.isModified());
    TraceView other;
    other.setRecording(&recording);
    ASSERT_TRUE(other.openSetup(folder.filePath("a.trace.json")));
    EXPECT_EQ(other.setup().channels.size(), 1u);
    EXPECT_EQ(other.plot()->model().to - other.plot()->model().from, 3 * S);
    EXPECT_FALSE(other.openSetup(folder.filePath("missing.trace.json")));
}

TEST_F(TraceViewTest, AnOlderRecordingLiesBeneath) {
    type("Main.sine");
    auto older = std::make_shared<FakeRecording>();
    older->addReal("Main.sine", [](double t) { return std::cos(t * 6); });
    older->run(700);
    view.setBeneath(older);
    ASSERT_EQ(view.plot()->model().curves[0].beneath.size(), 1u);
    EXPECT_EQ(view.plot()->model().curves[0].beneath[0].source->countIn(0, INT64_MAX), 700u);
    view.setBeneath(nullptr);
    EXPECT_TRUE(view.plot()->model().curves[0].beneath.empty());
}

TEST_F(TraceViewTest, ComesAndGoesWithTheRecording) {
    type("Main.sine");
    view.setRecording(nullptr);
    view.tick();
    view.grab();
    EXPECT_EQ(view.setup().channels.size(), 1u);
    EXPECT_FALSE(view.plot()->model().curves[0].source);
    view.setRecording(&recording);
    EXPECT_TRUE(view.plot()->model().curves[0].source);
}

TEST_F(TraceViewTest, DoubleClickActivatesThatScan) {
    type("Main.sine");
    view.plot()->setFollowing(false);
    view.plot()->setRange(0, 1 * S);
    view.grab();
    QSignalSpy activated(&view, &TraceView::positionActivated);
    const plot::PlotMapping map =
        view.plot()->renderer().mapping(view.plot()->model(), view.plot()->renderer().panes()[0]);
    QTest::mouseDClick(view.plot(), Qt::LeftButton, {},
                       QPoint(static_cast<int>(map.xOf(400 * Ms)), static_cast<int>(map.area.center().y())));
    ASSERT_EQ(activated.count(), 1);
    EXPECT_NEAR(static_cast<double>(activated[0][0].toULongLong()), 400, 3);
    view.showPosition(400);
    EXPECT_EQ(view.plot()->model().present, 400 * Ms);
}

TEST_F(TraceViewTest, PicturesOfTheView) {
    type("Main.sine");
    type("Main.ramp");
    type("Main.run");
    runFor(3000);
    view.plot()->fit();
    TraceSetup setup = view.setup();
    setup.hasTable = true;
    setup.cursorA = 1 * S;
    setup.cursorB = 3 * S;
    setup.charts[0].axes.resize(2);
    setup.charts[0].axes[1].isOnRight = true;
    setup.channels[1].axis = 1;
    setup.channels[1].unit = "mm";
    view.setSetup(setup);
    view.plot()->fit();
    view.channels()->selectChannel(1);
    view.tick();
    for (auto choice : {kit::ThemeChoice::Light, kit::ThemeChoice::Dark}) {
        kit::Theme::current().setChoice(choice);
        keep(view, choice == kit::ThemeChoice::Dark ? "view_dark" : "view_light");
        EXPECT_FALSE(view.grab().isNull());
    }
    kit::Theme::current().setChoice(kit::ThemeChoice::Light);
}

class TimeSliderTest : public ::testing::Test {
protected:
    TimeSliderTest() {
        recording.addBool("Main.run", [](double t) { return t >= 0.2 && t < 0.7; });
        recording.run(1000);
        slider.resize(900, 36);
        slider.setRecording(&recording);
        slider.show();
        QObject::connect(&slider, &TimeSlider::positionChanged,
                         [this](std::optional<Position> p) { told.push_back(p); });
    }
    FakeRecording recording;
    TimeSlider slider;
    std::vector<std::optional<Position>> told;
};

TEST_F(TimeSliderTest, KeysStepByScanAndEndGoesLive) {
    EXPECT_TRUE(slider.isLive());
    QTest::keyClick(&slider, Qt::Key_Left);
    EXPECT_EQ(slider.position(), 998u);
    QTest::keyClick(&slider, Qt::Key_Left);
    QTest::keyClick(&slider, Qt::Key_Right);
    EXPECT_EQ(slider.position(), 998u);
    recording.run(10);
    slider.refresh();
    EXPECT_EQ(slider.position(), 998u) << "new scans do not move it";
    QTest::keyClick(&slider, Qt::Key_End);
    EXPECT_TRUE(slider.isLive());
    EXPECT_EQ(told.size(), 4u);
    QTest::keyClick(&slider, Qt::Key_Home);
    EXPECT_EQ(slider.position(), 0u);
}

TEST_F(TimeSliderTest, ClickingTheBarGoesToThatTime) {
    TimeBar* bar = slider.bar();
    QTest::mouseClick(bar, Qt::LeftButton, {},
                      QPoint(static_cast<int>(std::lround(bar->xOf(500 * Ms))), bar->height() / 2));
    ASSERT_TRUE(slider.position());
    EXPECT_NEAR(static_cast<double>(*slider.position()), 500, 3);
    EXPECT_TRUE(slider.positionText().contains("scan"));
    QTest::mouseClick(bar, Qt::LeftButton, {}, QPoint(bar->width() - 3, bar->height() / 2));
    EXPECT_TRUE(slider.isLive());
}

TEST_F(TimeSliderTest, StepsToChangesOfAVariable) {
    QTest::keyClicks(slider.variable(), "Main.run");
    QTest::keyClick(&slider, Qt::Key_Left, Qt::ControlModifier);
    EXPECT_EQ(slider.position(), 700u);
    QTest::keyClick(&slider, Qt::Key_Left, Qt::ControlModifier);
    EXPECT_EQ(slider.position(), 200u);
    QSignalSpy messages(&slider, &TimeSlider::message);
    QTest::keyClick(&slider, Qt::Key_Left, Qt::ControlModifier);
    EXPECT_EQ(slider.position(), 200u);
    EXPECT_EQ(messages.count(), 1);
    QTest::keyClick(&slider, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(slider.position(), 700u);
}

TEST_F(TimeSliderTest, StopsWhereImagesAreGone) {
    recording.oldest = 400;
    slider.refresh();
    QTest::keyClick(&slider, Qt::Key_Home);
    EXPECT_EQ(slider.position(), 400u);
    QSignalSpy messages(&slider, &TimeSlider::message);
    QTest::keyClick(&slider, Qt::Key_Left);
    EXPECT_EQ(slider.position(), 400u);
    EXPECT_EQ(messages.count(), 1);
    recording.oldest = 600; // evicted under our feet
    slider.refresh();
    EXPECT_EQ(slider.position(), 600u);
}

TEST_F(TimeSliderTest, StepsAcrossABranchAlongThePast) {
    recording.goBackTo(299);
    recording.run(50);
    slider.refresh();
    slider.setPosition(1000);
    QTest::keyClick(&slider, Qt::Key_Left);
    EXPECT_EQ(slider.position(), 299u) << "the scan it was resumed from";
    QTest::keyClick(&slider, Qt::Key_Right);
    EXPECT_EQ(slider.position(), 1000u);
}

TEST_F(TimeSliderTest, ResumeNamesThePosition) {
    QSignalSpy resume(&slider, &TimeSlider::resumeRequested);
    slider.setPosition(123);
    for (QToolButton* button : slider.findChildren<QToolButton*>())
        if (button->accessibleName().contains("Resume")) QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_EQ(resume.count(), 1);
    EXPECT_EQ(resume[0][0].toULongLong(), 123u);
}

TEST_F(TimeSliderTest, PictureOfTheSlider) {
    recording.markList.push_back(
        {300, history::Nanoseconds(300 * Ms), static_cast<int>(plc::controller::EventKind::Force), says("forced")});
    recording.oldest = 150;
    recording.goBackTo(600);
    recording.run(200);
    slider.setPosition(450);
    slider.refresh();
    for (auto choice : {kit::ThemeChoice::Light, kit::ThemeChoice::Dark}) {
        kit::Theme::current().setChoice(choice);
        keep(slider, choice == kit::ThemeChoice::Dark ? "slider_dark" : "slider_light");
        EXPECT_FALSE(slider.grab().isNull());
    }
    kit::Theme::current().setChoice(kit::ThemeChoice::Light);
}

TEST(RenderTrace, WritesPictureCsvAndStatistics) {
    FakeRecording recording;
    recording.addReal("Main.ramp", [](double t) { return t * 10; });
    recording.addBool("Main.run", [](double t) { return t >= 0.5; });
    recording.run(1001);
    QTemporaryDir folder;
    TraceOutput out;
    out.setup = setupOf({"Main.ramp", "Main.run"});
    out.picture = folder.filePath("a.png");
    out.csv = folder.filePath("a.csv");
    out.wantsStatistics = true;
    auto text = renderTrace(recording, out);
    ASSERT_TRUE(text) << text.error().english();
    EXPECT_NE(text->find("Main.ramp"), std::string::npos) << *text;
    EXPECT_NE(text->find("10"), std::string::npos);
    EXPECT_EQ(QImage(out.picture).size(), QSize(1200, 700));
    QFile csv(out.csv);
    ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = csv.readAll().split('\n');
    EXPECT_EQ(lines.size(), 1003);
    EXPECT_EQ(lines[1], "0,0,0");
    EXPECT_EQ(lines[501], "0.5,5,1");

    out.setup.trigger = {"Main.run", TriggerEdge::Rising, TriggerMode::Single, 100 * Ms, 200 * Ms, {}};
    text = renderTrace(recording, out);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("Triggered at 0.5 s"), std::string::npos) << *text;
    QFile again(out.csv);
    ASSERT_TRUE(again.open(QIODevice::ReadOnly));
    EXPECT_EQ(again.readAll().split('\n')[1], "-0.1,4,0") << "times count from the trigger";

    out.setup = setupOf({"Main.missing"});
    EXPECT_FALSE(renderTrace(recording, out));
    out.setup = setupOf({"Main.ramp"});
    out.picture = "/no/such/folder/a.svg";
    EXPECT_FALSE(renderTrace(recording, out));
}
