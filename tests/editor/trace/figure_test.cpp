// What a trace shows besides curves over time: derived channels, XY plots, spectra, responses, runs, remarks, tables of
// measured values beside live ones.
#include "editor/kit/theme.h"
#include "editor/trace/curves/trace_picture.h"
#include "editor/trace/figure_pane.h"
#include "editor/trace/recording/run_recording.h"
#include "editor/trace/recording/table_recording.h"
#include "editor/trace/trace_view.h"
#include "tests/editor/trace/fake_recording.h"
#include "tests/support/patience.h"
#include "tests/support/settle.h"

#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

using namespace plc::trace;
namespace history = plc::history;

namespace {

constexpr int64_t Ms = 1'000'000, S = 1'000'000'000;
constexpr double Turn = 2 * std::numbers::pi;

class TraceFigure : public ::testing::Test {
protected:
    TraceFigure() {
        recording.addReal("Main.x", [](double t) { return 3 * std::cos(Turn * 5 * t); });
        recording.addReal("Main.y", [](double t) { return 2 * std::sin(Turn * 5 * t); });
        recording.addReal("Main.ramp", [](double t) { return t * 10; });
        recording.addBool("Main.start", [](double t) { return std::fmod(t, 2) >= 0.5 && std::fmod(t, 2) < 0.6; });
        recording.run(10'000);
        view.resize(1000, 640);
        view.setRecording(&recording);
        view.show();
        view.tick();
    }
    void show(const std::vector<std::string>& expressions, FigureKind kind, const std::string& trigger = {}) {
        TraceSetup setup = setupOf(expressions);
        setup.figure.kind = kind;
        setup.trigger.expression = trigger;
        setup.trigger.before = 100 * Ms;
        setup.trigger.after = 1 * S;
        view.setSetup(setup);
        while (view.plot()->model().curves.empty() || !isRead()) view.tick();
        view.plot()->setFollowing(false);
        view.plot()->fit();
        for (int i = 0; i < 8; ++i) view.tick();
        waitUntilDrawn();
    }
    [[nodiscard]] bool isRead() const {
        for (const auto& curve : view.plot()->model().curves)
            if (curve.source && curve.source->countIn(INT64_MIN, INT64_MAX) < recording.scans.size()) return false;
        return true;
    }
    void waitUntilDrawn() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !view.figurePane()->isBusy(); }, plc::kPatience));
    }
    [[nodiscard]] const plc::plot::Figure& figure() const { return view.figurePane()->view()->figure(); }

    FakeRecording recording;
    TraceView view;
    QTemporaryDir folder;
};

void write(const QString& path, const std::string& text) { std::ofstream(path.toStdString()) << text; }

} // namespace

TEST_F(TraceFigure, DerivedChannelsAreComputedFromSampleToSample) {
    show({"DERIVATIVE(Main.ramp)", "INTEGRAL(Main.ramp)", "FILTER(Main.ramp, T#100ms)"}, FigureKind::None);
    const auto& curves = view.plot()->model().curves;
    EXPECT_NEAR(curves[0].source->inForceAt(5 * S)->value, 10, 1e-6);
    EXPECT_NEAR(curves[1].source->inForceAt(4 * S)->value, 80, 0.1);
    EXPECT_NEAR(curves[2].source->inForceAt(5 * S)->value, 49, 0.02); // a tenth of a second behind
}

TEST_F(TraceFigure, ADerivedChannelSaysWhatIsWrongWithIt) {
    show({"FILTER(Main.ramp)", "DERIVATIVE(Main.missing)"}, FigureKind::None);
    const auto& curves = view.plot()->model().curves;
    EXPECT_TRUE(curves[0].problem.contains("time")) << curves[0].problem.toStdString();
    EXPECT_FALSE(curves[1].problem.isEmpty());
}

TEST_F(TraceFigure, AnXyPlotDrawsOneChannelOverAnother) {
    show({"Main.x", "Main.y"}, FigureKind::Xy);
    ASSERT_EQ(figure().charts.size(), 1U);
    ASSERT_EQ(figure().charts[0].curves.size(), 1U);
    const auto& curve = figure().charts[0].curves[0];
    ASSERT_GT(curve.x.size(), 9000U);
    for (size_t i = 0; i < curve.x.size(); i += 100) // an ellipse
        EXPECT_NEAR(curve.x[i] * curve.x[i] / 9 + curve.y[i] * curve.y[i] / 4, 1, 1e-4) << i;
}

TEST_F(TraceFigure, TheHorizontalValueIsChosenAndUndone) {
    show({"Main.x", "Main.y"}, FigureKind::Xy);
    auto* x = view.findChild<QComboBox*>("figureX");
    ASSERT_TRUE(x && x->isVisible());
    x->setCurrentIndex(1);
    emit x->activated(1);
    waitUntilDrawn();
    EXPECT_EQ(figure().charts[0].xTitle, "Main.y");
    view.undoStack()->undo();
    waitUntilDrawn();
    EXPECT_EQ(figure().charts[0].xTitle, "Main.x");
}

TEST_F(TraceFigure, WhatDoesNotMoveIsNoHorizontalValueByItself) {
    // a set point at rest is often the first channel
    show({"Main.x * 0.0", "Main.x", "Main.y"}, FigureKind::None);
    for (const auto& [key, kind] : {std::pair{Qt::Key_X, FigureKind::Xy}, std::pair{Qt::Key_B, FigureKind::Response}}) {
        QTest::keyClick(&view, key);
        waitUntilDrawn();
        EXPECT_EQ(view.setup().figure.kind, kind);
        EXPECT_EQ(view.setup().figure.x, "Main.x");
        EXPECT_FALSE(figure().isEmpty()) << figure().empty.toStdString();
        view.undoStack()->undo();
        EXPECT_EQ(view.setup().figure.x, "");
    }
}

TEST_F(TraceFigure, OnlyWhatIsBetweenTheCursorsIsTaken) {
    show({"Main.x", "Main.y"}, FigureKind::Xy);
    view.plot()->setCursor(0, 1 * S);
    view.plot()->setCursor(1, 2 * S);
    for (int i = 0; i < 8; ++i) view.tick();
    waitUntilDrawn();
    EXPECT_NEAR(static_cast<double>(figure().charts[0].curves[0].x.size()), 1001, 2);
}

TEST_F(TraceFigure, ASpectrumNamesItsPeaks) {
    show({"Main.x"}, FigureKind::Spectrum);
    ASSERT_FALSE(figure().charts.empty());
    ASSERT_FALSE(figure().charts[0].notes.empty());
    EXPECT_NEAR(figure().charts[0].notes[0].x, 5, 0.05);
    EXPECT_NEAR(figure().charts[0].notes[0].y, 3, 0.1);
    EXPECT_TRUE(view.figurePane()->text().contains("Hz")) << view.figurePane()->text().toStdString();
}

TEST_F(TraceFigure, RunsAreLaidOverEachOtherAtTheirTriggers) {
    show({"Main.ramp"}, FigureKind::Runs, "Main.start");
    ASSERT_EQ(figure().charts.size(), 1U);
    EXPECT_EQ(figure().charts[0].curves.size(), 5U); // at 0.5, 2.5, 4.5, 6.5, 8.5 s
    for (const auto& curve : figure().charts[0].curves) {
        EXPECT_GE(curve.x.front(), -0.1 - 1e-9);
        EXPECT_LE(curve.x.back(), 1 + 1e-9);
    }
}

TEST_F(TraceFigure, AnEmptyFigureSaysWhatToDo) {
    for (const auto& [expressions, kind, words] :
         {std::tuple{std::vector<std::string>{"Main.x"}, FigureKind::Xy, "second channel"},
          std::tuple{std::vector<std::string>{}, FigureKind::Spectrum, "add a channel"},
          std::tuple{std::vector<std::string>{"Main.x"}, FigureKind::Response, "choose the input"},
          std::tuple{std::vector<std::string>{"Main.x"}, FigureKind::Runs, "trigger"}}) {
        TraceSetup setup = setupOf(expressions);
        setup.figure.kind = kind;
        view.setSetup(setup);
        waitUntilDrawn();
        EXPECT_TRUE(figure().isEmpty());
        EXPECT_TRUE(figure().empty.contains(words)) << figure().empty.toStdString();
    }
}

TEST_F(TraceFigure, KeysShowAndHideIt) {
    show({"Main.x", "Main.y"}, FigureKind::None);
    EXPECT_FALSE(view.figurePane()->isVisible());
    QTest::keyClick(view.plot(), Qt::Key_X);
    EXPECT_EQ(view.setup().figure.kind, FigureKind::Xy);
    EXPECT_TRUE(view.figurePane()->isVisible());
    QTest::keyClick(view.plot(), Qt::Key_S);
    EXPECT_EQ(view.setup().figure.kind, FigureKind::Spectrum);
    QTest::keyClick(view.plot(), Qt::Key_T);
    EXPECT_FALSE(view.figurePane()->isVisible());
    view.undoStack()->undo();
    EXPECT_TRUE(view.figurePane()->isVisible());
    waitUntilDrawn();
}

TEST_F(TraceFigure, NotesAreKeptUndoneAndDrawn) {
    show({"Main.ramp"}, FigureKind::None);
    const QImage before = view.plot()->picture();
    view.addNote(4 * S, 40.0, 0, "Valve opened");
    ASSERT_EQ(view.plot()->model().notes.size(), 1U);
    EXPECT_NE(view.plot()->picture(), before);
    const QString path = folder.filePath("a.trace.json");
    ASSERT_TRUE(view.storeSetup(path));
    const auto read = loadSetup(path.toStdString());
    ASSERT_TRUE(read);
    ASSERT_EQ(read->notes.size(), 1U);
    EXPECT_EQ(read->notes[0].text, "Valve opened");
    EXPECT_EQ(read->notes[0].time, 4 * S);
    EXPECT_EQ(read->notes[0].value, 40.0);
    EXPECT_EQ(writeSetup(*read), writeSetup(view.setup()));
    view.undoStack()->undo();
    EXPECT_TRUE(view.plot()->model().notes.empty());
}

TEST(TraceSetupFile, FiguresNotesAndFilesKeepWhatTheyDoNotKnow) {
    const std::string text = R"({
  "version": 1,
  "channels": [
    {
      "expression": "Level",
      "recording": "bench.csv",
      "later": 1
    }
  ],
  "figure": {
    "kind": "spectrum",
    "window": "flat top",
    "logarithmic": false,
    "later": true
  },
  "notes": [
    {
      "time": 2.5,
      "text": "here",
      "later": "x"
    }
  ]
}
)";
    const auto setup = readSetup(text, "a.trace.json");
    ASSERT_TRUE(setup) << setup.error().english();
    EXPECT_EQ(setup->figure.kind, FigureKind::Spectrum);
    EXPECT_EQ(setup->figure.window, FigureWindow::FlatTop);
    EXPECT_EQ(setup->channels[0].recording, "bench.csv");
    EXPECT_EQ(writeSetup(*setup), text);
    EXPECT_FALSE(readSetup(R"({"channels":[],"figure":{"kind":"pie"}})", "a"));
    EXPECT_FALSE(readSetup(R"({"channels":[],"notes":[{"time":"soon"}]})", "a"));
}

TEST(TableRecordingTest, ColumnsBecomeVariablesWithTheirPaths) {
    QTemporaryDir folder;
    const QString path = folder.filePath("bench.csv");
    write(
        path,
        "time_s,Main.Level [m],Main.pid.out,Flow rate,VAR,On\n0,1,10,5,1,FALSE\n0.5,2,20,6,2,TRUE\n1,3,30,7,3,TRUE\n");
    const auto opened = RunRecording::open(path.toStdString());
    ASSERT_TRUE(opened) << opened.error().english();
    const Recording& recording = **opened;
    EXPECT_EQ(recording.extent(), std::pair(Position(0), Position(3)));
    for (const auto& [expression, last] :
         {std::pair{"Main.Level", 3.0}, std::pair{"Main.pid.out", 30.0}, std::pair{"Flow_rate", 7.0},
          std::pair{"VAR_1", 3.0}, std::pair{"On", 1.0}, std::pair{"Main.Level * 2.0 + Flow_rate", 13.0}}) {
        const auto samples = recording.samples(expression, 0, 3);
        ASSERT_EQ(samples.size(), 3U) << expression;
        EXPECT_EQ(samples[2].value, last) << expression;
        EXPECT_EQ(samples[1].at.time.count(), 500 * Ms);
    }
    EXPECT_TRUE(recording.typeOf("On")->isBool);
    EXPECT_TRUE(recording.find("On", 0, history::History::Direction::Forward));
    ASSERT_TRUE(recording.save(folder.filePath("bench.rec").toStdString()));
    EXPECT_TRUE(RunRecording::open(folder.filePath("bench.rec").toStdString())) << "a recording as any other";
}

TEST(TableRecordingTest, NamesThatMeetAreToldApart) {
    plc::waveform::Table table;
    for (const char* name : {"a", "A", "a.b", "x y", "x_y", "1st", "Device.Application.Main.z", "__"})
        table.columns.push_back({name, "", {0}, false});
    table.time = {0};
    std::vector<std::string> paths = pathsOf(table);
    EXPECT_EQ(paths[0], "a");
    EXPECT_EQ(paths[6], "Main.z");
    const auto recorded = recordTable(table);
    ASSERT_TRUE(recorded) << recorded.error().english() << programFor(table, paths);
    std::sort(paths.begin(), paths.end());
    EXPECT_EQ(std::adjacent_find(paths.begin(), paths.end()), paths.end());
}

TEST(TableRecordingTest, ATableThatIsNoneSaysWhy) {
    QTemporaryDir folder;
    write(folder.filePath("a.csv"), "name,value\nx,1\n");
    const auto opened = RunRecording::open(folder.filePath("a.csv").toStdString());
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().english().find("column of times"), std::string::npos);
    EXPECT_FALSE(RunRecording::open(folder.filePath("missing.csv").toStdString()));
}

TEST_F(TraceFigure, AHistoriansTableIsDrawnBesideLiveValuesAndItsFlawsAreSaid) {
    write(folder.filePath("plant.csv"),
          "\xEF\xBB\xBFTimestamp;TagName;Value\n2026-03-01T06:00:00.000+01:00;Level;1,25\n"
          "2026-03-01T06:00:00.000+01:00;Flow;7\n2026-03-01T06:00:01.000+01:00;Level;Bad\n"
          "2026-03-01T06:00:02.000+01:00;Level;2,5\n");
    show({"Main.ramp"}, FigureKind::None);
    QSignalSpy noted(&view, &TraceView::noted);
    view.addChannelOf(folder.filePath("plant.csv"), "Level");
    const auto& curves = view.plot()->model().curves;
    ASSERT_EQ(curves.size(), 2U);
    ASSERT_TRUE(curves[1].source) << curves[1].problem.toStdString();
    EXPECT_EQ(curves[1].source->inForceAt(500 * Ms)->value, 1.25);
    EXPECT_EQ(curves[1].source->inForceAt(2500 * Ms)->value, 2.5);
    EXPECT_EQ(curves[0].source->inForceAt(2 * S)->value, 20);
    ASSERT_EQ(noted.size(), 1);
    EXPECT_TRUE(noted[0][0].toString().startsWith("plant.csv: Column Level: 1 cell is not a number"));
}

TEST_F(TraceFigure, MeasuredValuesAreDrawnBesideLiveOnes) {
    write(folder.filePath("bench.csv"), "time_ms,Level\n0,1\n1000,2\n2000,5\n");
    show({"Main.ramp"}, FigureKind::None);
    view.addChannelOf(folder.filePath("bench.csv"), "Level");
    const auto& curves = view.plot()->model().curves;
    ASSERT_EQ(curves.size(), 2U);
    ASSERT_TRUE(curves[1].source) << curves[1].problem.toStdString();
    EXPECT_EQ(curves[1].source->inForceAt(2500 * Ms)->value, 5);
    EXPECT_TRUE(curves[1].name.contains("bench"));
    EXPECT_EQ(curves[0].source->inForceAt(2 * S)->value, 20);
    view.addChannelOf(folder.filePath("gone.csv"), "Level");
    EXPECT_FALSE(view.plot()->model().curves[2].source);
    EXPECT_FALSE(view.plot()->model().curves[2].problem.isEmpty());
}

TEST_F(TraceFigure, DraggingTheRulerMeasuresFromSampleToSample) {
    show({"Main.ramp"}, FigureKind::None);
    view.grab();
    auto* plot = view.plot();
    QTest::keyClick(plot, Qt::Key_M);
    ASSERT_EQ(plot->tool(), plc::plot::PlotTool::Ruler);
    const auto map = plot->renderer().mapping(plot->model(), plot->renderer().panes()[0]);
    const auto at = [&](int64_t time) { return QPoint(int(map.xOf(time)), int(map.yOf(double(time) / 1e8))); };
    QTest::mousePress(plot, Qt::LeftButton, {}, at(2 * S));
    QTest::mouseMove(plot, at(5 * S));
    QTest::mouseMove(plot, at(6 * S));
    QTest::mouseRelease(plot, Qt::LeftButton, {}, at(6 * S));
    ASSERT_TRUE(plot->model().ruler);
    const auto& ruler = *plot->model().ruler;
    EXPECT_NEAR(double(ruler.toTime - ruler.fromTime) / 1e9, 4, 0.1);
    EXPECT_NEAR((ruler.toValue - ruler.fromValue) / (double(ruler.toTime - ruler.fromTime) / 1e9), 10, 0.01);
    EXPECT_TRUE(plc::plot::rulerText(ruler).contains("Δt")) << plc::plot::rulerText(ruler).toStdString();
    QTest::mouseClick(plot, Qt::LeftButton, {}, at(3 * S)); // measures nothing
    EXPECT_FALSE(plot->model().ruler);
    QTest::mousePress(plot, Qt::LeftButton, {}, at(2 * S));
    QTest::mouseMove(plot, at(6 * S));
    QTest::mouseRelease(plot, Qt::LeftButton, {}, at(6 * S));
    ASSERT_TRUE(plot->model().ruler);
    QTest::keyClick(plot, Qt::Key_Escape);
    EXPECT_FALSE(plot->model().ruler);
}

TEST(FigureRoom, ALowDockIsNeverLeftEmpty) {
    plc::plot::Figure figure;
    for (const char* name : {"gain", "phase", "coherence"})
        figure.charts.push_back({name, "Frequency [Hz]", "", {{"a", {0, 1}, {0, 1}, 0}}, false});
    struct Row {
        double width, height;
        size_t shown;
    };
    // as the dock is in a window of 1600 x 1000 at first, narrower, lower, high
    for (const auto& [width, height, shown] :
         {Row{400, 189, 3}, Row{300, 189, 2}, Row{200, 120, 1}, Row{400, 120, 3}, Row{400, 600, 3}}) {
        size_t seen = 0;
        for (const auto& frame : framesOf(figure, QRectF(0, 0, width, height), qApp->font(), {}))
            seen += frame.area.height() >= 24 && frame.area.width() >= 60;
        EXPECT_EQ(seen, shown) << width << " x " << height;
    }
}

TEST(FigureLegend, ALongNameDoesNotHideTheOthers) {
    plc::waveform::Chart chart{"XY plot", "x", {}, {}, false};
    for (const char* name : {"Set point", "Valve", "DERIVATIVE(FILTER(IO.Temperature - IO.SetPoint, T#1s))"})
        chart.curves.push_back({name, {0, 1}, {0, 1}, 0, plc::waveform::CurveStyle::Line});
    const plc::plot::Figure figure{{chart}, {}};
    const QFont font = qApp->font();
    const QFontMetricsF metrics(font);
    for (const double width : {340.0, 600.0, 1600.0}) {
        const auto frame = framesOf(figure, QRectF(0, 0, width, 200), font, {}).front();
        const auto names = legendOf(chart, frame, font);
        ASSERT_EQ(names.size(), 3U) << width;
        EXPECT_EQ(names[1].text, "Valve") << width;
        double used = 0;
        for (const auto& name : names) used += metrics.horizontalAdvance(name.text);
        EXPECT_LT(used, 0.65 * width) << width;
        EXPECT_EQ(names[2].text == "DERIVATIVE(FILTER(IO.Temperature - IO.SetPoint, T#1s))", width > 1000) << width;
        EXPECT_FALSE(names[2].text.isEmpty()) << width;
    }
}

TEST_F(TraceFigure, EveryKindHasRoomInASmallWindow) {
    view.resize(1024, 420); // what the dock has in a window of 1024 x 700
    const QString pictures = qEnvironmentVariable("STEPWISE_PICTURES");
    for (const bool isDark : {false, true}) {
        plc::kit::Theme::install(*qApp, isDark ? plc::kit::ThemeChoice::Dark : plc::kit::ThemeChoice::Light);
        for (const FigureKind kind : {FigureKind::Xy, FigureKind::Spectrum, FigureKind::Response, FigureKind::Runs}) {
            show({"Main.x", "Main.y"}, kind, "Main.start");
            plc::settle();
            if (!pictures.isEmpty())
                view.grab().save(QStringLiteral("%1/view_%2_%3.png").arg(pictures).arg(int(kind)).arg(isDark));
            for (const auto& frame : view.figurePane()->view()->frames()) {
                EXPECT_GE(frame.area.height(), 24) << int(kind);
                EXPECT_GE(frame.area.width(), 200) << int(kind);
            }
        }
    }
    plc::kit::Theme::install(*qApp, plc::kit::ThemeChoice::Light);
}

TEST(RenderFigure, PicturesShowTheChartsAndTheFigureOrOnlyIt) {
    FakeRecording recording;
    recording.addReal("Main.x", [](double t) { return std::cos(Turn * 5 * t); });
    recording.addReal("Main.y", [](double t) { return std::sin(Turn * 5 * t); });
    recording.run(4000);
    QTemporaryDir folder;
    const QString pictures = qEnvironmentVariable("STEPWISE_PICTURES", folder.path());
    for (const bool isDark : {false, true})
        for (const FigureKind kind : {FigureKind::Xy, FigureKind::Spectrum, FigureKind::Response}) {
            TraceOutput out;
            out.setup = setupOf({"Main.x", "Main.y"});
            out.setup.figure.kind = kind;
            out.setup.notes.push_back({1 * S, 0.5, 0, "A remark", {}});
            out.isDark = isDark;
            out.picture = QStringLiteral("%1/figure_%2_%3.png").arg(pictures).arg(int(kind)).arg(isDark);
            const auto both = renderTrace(recording, out);
            ASSERT_TRUE(both) << both.error().english();
            const QImage together(out.picture);
            EXPECT_EQ(together.size(), QSize(1200, 700));
            out.onlyFigure = true;
            out.picture = QStringLiteral("%1/only_%2_%3.png").arg(pictures).arg(int(kind)).arg(isDark);
            ASSERT_TRUE(renderTrace(recording, out));
            EXPECT_NE(QImage(out.picture), together);
            out.picture = folder.filePath("a.svg");
            EXPECT_TRUE(renderTrace(recording, out));
        }
}
