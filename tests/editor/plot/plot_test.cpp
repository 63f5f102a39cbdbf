// The plot: what is drawn lies where the samples are. Set STEPWISE_PICTURES to a folder to get the pictures to look at.
#include "editor/kit/pen_order.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/painting/plot_raster.h"
#include "editor/plot/painting/plot_renderer.h"
#include "editor/plot/painting/plot_table.h"
#include "editor/plot/plot_export.h"

#include <QApplication>
#include <QBuffer>
#include <QFile>
#include <QSvgRenderer>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cmath>

using namespace plc::kit;
using namespace plc::plot;

namespace {

constexpr int64_t Ms = 1'000'000, S = 1'000'000'000;

std::shared_ptr<SampleList> sampled(int count, int64_t step, const std::function<double(double)>& f,
                                    PlotValueKind kind = PlotValueKind::Double) {
    auto list = std::make_shared<SampleList>(kind);
    for (int i = 0; i < count; ++i) list->append(i * step, f(static_cast<double>(i) * static_cast<double>(step) / 1e9));
    return list;
}

PlotCurve curveOf(const QString& name, std::shared_ptr<const SampleSource> source, CurveStyle style, int colour,
                  const QString& unit = {}) {
    PlotCurve curve;
    curve.id = curve.name = name;
    curve.unit = unit;
    curve.style = style;
    curve.color = colors().curve(colour);
    curve.source = std::move(source);
    return curve;
}

/// A loop with a step of the set point, its output, a pulse train and a sequence: a bit of everything.
PlotModel showCase() {
    PlotModel model;
    model.title = "Closed loop with a step of the set point";
    model.from = 0;
    model.to = 10 * S;
    model.charts.resize(2);
    model.charts[0].title = "Loop";
    model.charts[0].weight = 2;
    model.charts[0].axes = {PlotAxis{.title = "Temperature", .unit = "°C"}, PlotAxis{.isOnRight = true}};
    model.charts[1].title = "Valve";
    auto set = [](double t) { return t < 1 ? 20.0 : 60.0; };
    auto actual = [](double t) {
        if (t < 1) return 20.0;
        const double u = t - 1;
        return 60 - 40 * std::exp(-0.9 * u) * (std::cos(2.4 * u) + 0.375 * std::sin(2.4 * u));
    };
    model.curves.push_back(curveOf("Main.setPoint", sampled(1000, 10 * Ms, set), CurveStyle::Hold, 0, "°C"));
    model.curves.push_back(curveOf("Main.pid.i_rAct", sampled(1000, 10 * Ms, actual), CurveStyle::Line, 1, "°C"));
    auto output = curveOf(
        "Main.pid.q_rOut",
        sampled(1000, 10 * Ms, [&](double t) { return std::clamp(1.6 * (set(t) - actual(t)) + 30, 0.0, 100.0); }),
        CurveStyle::Line, 2, "%");
    output.axis = 1;
    model.curves.push_back(output);
    auto pwm = curveOf(
        "Main.valve.open",
        sampled(
            10'000, Ms, [](double t) { return std::fmod(t, 0.5) < 0.05 + 0.04 * t ? 1.0 : 0.0; }, PlotValueKind::Bool),
        CurveStyle::Digital, 3);
    pwm.chart = 1;
    auto mode =
        curveOf("Main.sequence.step",
                sampled(
                    1000, 10 * Ms, [](double t) { return std::floor(std::fmod(t * 0.6, 4)); }, PlotValueKind::Integer),
                CurveStyle::Digital, 4);
    mode.chart = 1;
    mode.valueNames = {{0, "Idle"}, {1, "Heating"}, {2, "Holding"}, {3, "Cooling"}};
    auto noise =
        curveOf("Main.noise",
                sampled(100'000, Ms / 10,
                        [](double t) { return std::sin(t * 3) + 0.3 * std::sin(t * 1234.5) * std::sin(t * 7777); }),
                CurveStyle::Line, 5, "mV");
    noise.chart = 1;
    model.curves.push_back(noise);
    model.curves.push_back(pwm);
    model.curves.push_back(mode);
    model.markers = {{1 * S, MarkerKind::Event, "Set point written"},
                     {6'200 * Ms, MarkerKind::Force, "valve.open forced"}};
    model.trigger = 1 * S;
    model.cursorA = 1 * S;
    model.cursorB = 7 * S;
    model.hasTable = true;
    return model;
}

void keep(const QImage& image, const QString& name) {
    const QString folder = qEnvironmentVariable("STEPWISE_PICTURES");
    if (!folder.isEmpty()) image.save(folder + '/' + name + ".png");
}

struct Drawn {
    QImage image;
    PlotRenderer renderer;
};

void draw(Drawn& drawn, const PlotModel& model, QSize size = {800, 500}) {
    drawn.image = QImage(size, QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&drawn.image);
    drawn.renderer.setFont(QApplication::font());
    drawn.renderer.paint(painter, model, QRectF(QPointF(), QSizeF(size)));
}

bool isNear(const QColor& a, const QColor& b, int within = 60) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <= within;
}

/// Rows of column x inside the frame that a curve of that colour has touched, softly or fully.
std::vector<int> inkedRows(const QImage& image, const QRectF& area, int x, const QColor& color) {
    std::vector<int> rows;
    for (int y = static_cast<int>(area.top()) + 3; y <= static_cast<int>(area.bottom()) - 3; ++y) {
        const QColor pixel = image.pixelColor(x, y);
        if (isNear(pixel, color) || !(isNear(pixel, colors().plotGround, 120) || isNear(pixel, colors().plotGap, 120)))
            rows.push_back(y);
    }
    return rows;
}

} // namespace

TEST(PlotGaps, WhatIsNoLongerKeptIsShadedToTheEdgeOnlyWhereNothingOlderIsLeft) {
    auto list = std::make_shared<SampleList>(PlotValueKind::Double);
    for (int i = 20; i < 100; ++i)
        if (i < 40 || i >= 60) list->append(i * Ms, i);
    list->addGap({0, 20 * Ms, plc::SignalGap::Reason::Evicted});
    list->addGap({39 * Ms, 60 * Ms, plc::SignalGap::Reason::Evicted});
    const CurveShape shape = shapeOf(*list, -50 * Ms, 100 * Ms, 500);
    ASSERT_EQ(shape.gaps.size(), 2U);
    EXPECT_EQ(shape.gaps[0].from, -50 * Ms);
    EXPECT_EQ(shape.gaps[0].to, 20 * Ms);
    EXPECT_EQ(shape.gaps[1].from, 39 * Ms) << "shaded over values that are there";
    EXPECT_EQ(shape.gaps[1].to, 60 * Ms);
}

TEST(PlotPictures, BothThemesNarrowAndWide) {
    for (ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
        Theme::current().setChoice(choice);
        const PlotModel model = showCase();
        for (int width : {800, 2500}) {
            const QImage image = plotPicture(model, {.size = {width, width == 800 ? 620 : 1100}});
            EXPECT_EQ(image.width(), width);
            keep(image, QString("plot_%1_%2").arg(choice == ThemeChoice::Dark ? "dark" : "light").arg(width));
        }
    }
    Theme::current().setChoice(ThemeChoice::Light);
}

TEST(PlotRenderer, PanesAlignAndNothingOverlaps) {
    const PlotModel model = showCase();
    for (QSize size : {QSize(800, 620), QSize(2500, 1200), QSize(500, 420)}) {
        Drawn drawn;
        draw(drawn, model, size);
        const auto& panes = drawn.renderer.panes();
        ASSERT_EQ(panes.size(), 3u);
        for (size_t i = 0; i < panes.size(); ++i) {
            EXPECT_NEAR(panes[i].area.left(), panes[0].area.left(), 1) << size.width();
            EXPECT_NEAR(panes[i].area.right(), panes[0].area.right(), 1) << size.width();
            EXPECT_TRUE(i == 0 || panes[i].area.top() > panes[i - 1].area.bottom());
            EXPECT_LT(panes[i].area.bottom(), size.height());
        }
        for (const LegendEntry& a : drawn.renderer.legend()) {
            for (const LegendEntry& b : drawn.renderer.legend()) EXPECT_TRUE(&a == &b || !a.rect.intersects(b.rect));
            for (const PlotPane& pane : panes)
                EXPECT_FALSE(a.rect.intersects(pane.area)) << "a legend entry lies over a chart";
            EXPECT_TRUE(QRectF(QPointF(), QSizeF(size)).contains(a.rect));
        }
    }
}

TEST(PlotRenderer, EachSampleIsDrawnWhereItIs) {
    PlotModel model;
    model.hasGrid = false;
    model.from = 0;
    model.to = 1 * S;
    model.charts[0].axes[0].mode = AxisMode::Fixed;
    model.charts[0].axes[0].fixed = {0, 100};
    model.curves.push_back(
        curveOf("v", sampled(11, 100 * Ms, [](double t) { return 10 + t * 80; }), CurveStyle::Line, 1));
    Drawn drawn;
    draw(drawn, model);
    const PlotPane& pane = drawn.renderer.panes()[0];
    const PlotMapping map = drawn.renderer.mapping(model, pane);
    for (int i = 1; i < 10; ++i) {
        const int x = static_cast<int>(map.xOf(i * 100 * Ms));
        const double y = map.yOf(10 + i * 8);
        const auto rows = inkedRows(drawn.image, pane.area, x, model.curves[0].color);
        ASSERT_FALSE(rows.empty()) << i;
        EXPECT_NEAR((rows.front() + rows.back()) / 2.0, y, 4) << i;
    }
}

TEST(PlotRenderer, HeldValuesJumpVertically) {
    PlotModel model;
    model.hasGrid = false;
    model.from = 0;
    model.to = 1 * S;
    model.charts[0].axes[0].mode = AxisMode::Fixed;
    model.charts[0].axes[0].fixed = {0, 100};
    // Few samples go through the painter, many through the column raster: both must be steps.
    for (int count : {3, 1001}) {
        model.curves = {curveOf("v",
                                sampled(count, 1 * S / (count - 1), [](double t) { return t < 0.5 ? 20.0 : 80.0; }),
                                CurveStyle::Hold, 1)};
        Drawn drawn;
        draw(drawn, model);
        const PlotPane& pane = drawn.renderer.panes()[0];
        const PlotMapping map = drawn.renderer.mapping(model, pane);
        const int jump = static_cast<int>(map.xOf(500 * Ms));
        for (int x : {jump - 20, jump - 6}) {
            const auto rows = inkedRows(drawn.image, pane.area, x, model.curves[0].color);
            ASSERT_FALSE(rows.empty());
            EXPECT_NEAR(rows.front(), map.yOf(20), 3) << count;
            EXPECT_NEAR(rows.back(), map.yOf(20), 3) << count;
        }
        for (int x : {jump + 6, jump + 20}) {
            const auto rows = inkedRows(drawn.image, pane.area, x, model.curves[0].color);
            ASSERT_FALSE(rows.empty());
            EXPECT_NEAR(rows.front(), map.yOf(80), 3) << count;
            EXPECT_NEAR(rows.back(), map.yOf(80), 3) << count;
        }
        size_t tallest = 0;
        for (int x = jump - 2; x <= jump + 2; ++x)
            tallest = std::max(tallest, inkedRows(drawn.image, pane.area, x, model.curves[0].color).size());
        EXPECT_GT(static_cast<double>(tallest), 0.9 * (map.yOf(20) - map.yOf(80)))
            << "the jump itself is drawn, " << count;
    }
}

TEST(PlotRenderer, OneSpikeAmongMillionsIsSeen) {
    PlotModel model;
    model.hasGrid = false;
    model.from = 0;
    model.to = 1 * S;
    model.charts[0].axes[0].mode = AxisMode::Fixed;
    model.charts[0].axes[0].fixed = {0, 100};
    for (CurveStyle style : {CurveStyle::Line, CurveStyle::Hold}) {
        model.curves = {
            curveOf("v", sampled(1'000'000, 1'000, [](double t) { return t == 0.7 ? 95.0 : 10.0; }), style, 1)};
        Drawn drawn;
        draw(drawn, model);
        const PlotPane& pane = drawn.renderer.panes()[0];
        const PlotMapping map = drawn.renderer.mapping(model, pane);
        const int x = static_cast<int>(map.xOf(700 * Ms));
        size_t tallest = 0;
        for (int c = x - 1; c <= x + 1; ++c)
            tallest = std::max(tallest, inkedRows(drawn.image, pane.area, c, model.curves[0].color).size());
        EXPECT_GT(static_cast<double>(tallest), 0.9 * (map.yOf(10) - map.yOf(95)));
    }
}

TEST(PlotRenderer, NoLineCrossesAGap) {
    PlotModel model;
    model.hasGrid = false;
    model.from = 0;
    model.to = 1 * S;
    model.charts[0].axes[0].mode = AxisMode::Fixed;
    model.charts[0].axes[0].fixed = {0, 100};
    for (int64_t step : {10 * Ms, Ms / 100}) // exact samples, and buckets
        for (CurveStyle style : {CurveStyle::Line, CurveStyle::Hold}) {
            auto list = std::make_shared<SampleList>();
            for (int64_t t = 0; t <= 1 * S; t += step)
                if (t <= 400 * Ms || t >= 600 * Ms) list->append(t, 50);
            list->addGap({400 * Ms, 600 * Ms, plc::SignalGap::Reason::NoPath});
            model.curves = {curveOf("v", list, style, 1)};
            Drawn drawn;
            draw(drawn, model);
            const PlotPane& pane = drawn.renderer.panes()[0];
            const PlotMapping map = drawn.renderer.mapping(model, pane);
            EXPECT_TRUE(inkedRows(drawn.image, pane.area.adjusted(0, 40, 0, 0), static_cast<int>(map.xOf(500 * Ms)),
                                  model.curves[0].color)
                            .empty())
                << step;
            EXPECT_FALSE(
                inkedRows(drawn.image, pane.area, static_cast<int>(map.xOf(300 * Ms)), model.curves[0].color).empty())
                << step;
            EXPECT_FALSE(
                inkedRows(drawn.image, pane.area, static_cast<int>(map.xOf(700 * Ms)), model.curves[0].color).empty())
                << step;
        }
}

TEST(PlotRenderer, ZoomedFarInALineKeepsItsSlope) {
    PlotModel model;
    model.hasGrid = false;
    // From (0 s, 0) to (1 s, 1e6); in view only a sliver around 0.5 s.
    model.curves = {curveOf("v", sampled(2, 1 * S, [](double t) { return t * 1e6; }), CurveStyle::Line, 1)};
    model.from = 500 * Ms - 100;
    model.to = 500 * Ms + 100;
    model.charts[0].axes[0].mode = AxisMode::Fixed;
    model.charts[0].axes[0].fixed = {499'999.9, 500'000.1};
    Drawn drawn;
    draw(drawn, model);
    const PlotPane& pane = drawn.renderer.panes()[0];
    const PlotMapping map = drawn.renderer.mapping(model, pane);
    for (int64_t dt : {-50, 0, 50}) {
        const auto rows =
            inkedRows(drawn.image, pane.area, static_cast<int>(map.xOf(500 * Ms + dt)), model.curves[0].color);
        ASSERT_FALSE(rows.empty()) << dt;
        EXPECT_NEAR((rows.front() + rows.back()) / 2.0, map.yOf(500'000 + static_cast<double>(dt) * 1e-3), 4) << dt;
    }
}

TEST(FillColumns, CoversExactlyWhatIsAsked) {
    QImage image(40, 20, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    std::vector<ColumnSpan> spans(40);
    spans[3] = {5.0f, 9.0f};
    spans[20] = {-100.0f, 200.0f};
    spans[21] = {-50.0f, -40.0f};
    fillColumns(image, image.rect(), spans, 1, Qt::red);
    for (int y = 0; y < 20; ++y) {
        EXPECT_EQ(qAlpha(image.pixel(3, y)), y >= 5 && y < 9 ? 255 : y == 4 || y == 9 ? 128 : 0) << y;
        EXPECT_EQ(qAlpha(image.pixel(20, y)), 255);
        EXPECT_EQ(qAlpha(image.pixel(21, y)), 0);
        EXPECT_EQ(qAlpha(image.pixel(4, y)), 0);
    }
    image.fill(Qt::transparent);
    spans[3] = {5.25f, 9.0f};
    fillColumns(image, image.rect(), spans, 2, Qt::red);
    EXPECT_NEAR(qAlpha(image.pixel(3, 4)), 191, 3);
    EXPECT_NEAR(qAlpha(image.pixel(4, 7)), 128, 3) << "half of the second pixel's width on either side";
    EXPECT_NEAR(qAlpha(image.pixel(2, 7)), 128, 3);
    EXPECT_EQ(qAlpha(image.pixel(5, 7)), 0);
    image.fill(Qt::transparent);
    std::vector<ColumnSpan> all(20, ColumnSpan{-5, 50});
    fillColumns(image, QRect(8, 6, 20, 9), all, 1, Qt::red);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x)
            EXPECT_EQ(qAlpha(image.pixel(x, y)), QRect(8, 6, 20, 9).contains(x, y) ? 255 : 0) << x << ',' << y;
}

TEST(PlotScale, TicksAreRoundAndWithinTheLimits) {
    struct Row {
        double low, high;
        int most;
        std::vector<const char*> labels;
    };
    for (const Row& row :
         {Row{0, 10, 5, {"0", "2", "4", "6", "8", "10"}}, Row{-1, 1, 4, {"−1.0", "−0.5", "0.0", "0.5", "1.0"}},
          Row{0.1, 0.35, 5, {"0.10", "0.15", "0.20", "0.25", "0.30", "0.35"}},
          Row{0, 2e7, 2, {"0", "1e+07", "2e+07"}}}) {
        const auto ticks = numberTicks(row.low, row.high, row.most);
        ASSERT_EQ(ticks.size(), row.labels.size()) << row.low << ".." << row.high;
        for (size_t i = 0; i < ticks.size(); ++i) EXPECT_EQ(ticks[i].label.toStdString(), row.labels[i]);
    }
    EXPECT_TRUE(numberTicks(1, 1, 5).empty());
}

TEST(PlotScale, TimesReadInTheUnitOfTheirSpan) {
    struct Row {
        int64_t from, to;
        int most;
        const char* unit;
        const char* first;
        const char* last;
    };
    constexpr int64_t Min = 60 * S, H = 60 * Min;
    for (const Row& row :
         {Row{0, 10 * S, 5, "s", "0", "10"}, Row{1'234'567'000, 1'234'569'000, 4, "ms", "1234.5670", "1234.5690"},
          Row{0, 20 * Min, 4, "min:s", "0:00", "20:00"}, Row{0, 3 * H, 3, "h:min:s", "0:00:00", "3:00:00"},
          Row{-1 * S, 4 * S, 5, "s", "−1", "4"}, Row{0, 800, 4, "µs", "0.0", "0.8"}}) {
        const TimeTicks ticks = timeTicks(row.from, row.to, 0, row.most);
        EXPECT_EQ(ticks.unit.toStdString(), row.unit) << row.to;
        ASSERT_FALSE(ticks.ticks.empty()) << row.to;
        EXPECT_EQ(ticks.ticks.front().second.toStdString(), row.first) << row.to;
        EXPECT_EQ(ticks.ticks.back().second.toStdString(), row.last) << row.to;
        EXPECT_LE(static_cast<int>(ticks.ticks.size()), 3 * row.most + 1);
    }
}

TEST(PlotScale, ValuesAndDurationsReadShort) {
    for (const auto& [value, text] : {std::pair{1.5, "1.5"},
                                      {0.0, "0"},
                                      {-2.0, "−2"},
                                      {123456.789, "123457"},
                                      {0.00123456789, "0.00123457"},
                                      {1e12, "1e+12"}})
        EXPECT_EQ(valueText(value).toStdString(), text);
    for (const auto& [time, text] : {std::pair<int64_t, const char*>{500, "500 ns"},
                                     {1'500, "1.5 µs"},
                                     {12'500'000, "12.5 ms"},
                                     {3'200'000'000, "3.2 s"},
                                     {125 * S, "2 min 5 s"},
                                     {-2 * Ms, "−2 ms"}})
        EXPECT_EQ(durationText(time).toStdString(), text);
    EXPECT_EQ(momentText(1'000'000'001).toStdString(), "1.000000001 s");
    EXPECT_EQ(frequencyText(20 * Ms).toStdString(), "50 Hz");
}

TEST(PlotScale, OneLanguageHasOneDecimalSign) {
    QLocale::setDefault(QLocale(QLocale::German));
    EXPECT_EQ(momentText(1'500'000'000).toStdString(), "1,5 s");
    EXPECT_EQ(momentText(11 * 60 * S + 500'000'000).toStdString(), "11:00,5");
    EXPECT_EQ(durationText(12'500'000).toStdString(), "12,5 ms");
    EXPECT_EQ(valueText(-0.25).toStdString(), "−0,25");
    EXPECT_EQ(numberTicks(0, 1, 2)[1].label.toStdString(), "0,5");
    EXPECT_EQ(timeTicks(0, 2 * S, 0, 4).ticks[1].second.toStdString(), "0,5");
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(exactText(-0.25, PlotValueKind::Double), "-0.25") << "what is written for programs stays";
}

TEST(MeasureTable, GivesBothCursorsAndLeavesEmptyColumnsOut) {
    PlotModel model;
    model.curves = {
        curveOf("ramp", sampled(11, 100 * Ms, [](double t) { return t * 10; }), CurveStyle::Line, 0, "bar")};
    model.cursorA = 200 * Ms;
    model.cursorB = 800 * Ms;
    const MeasureTable table = measureTable(model);
    ASSERT_EQ(table.rows.size(), 1u);
    auto cell = [&](const char* header) {
        return table.rows[0].cells.value(table.headers.indexOf(header)).toStdString();
    };
    EXPECT_EQ(cell("Channel"), "ramp [bar]");
    EXPECT_EQ(cell("At A"), "2");
    EXPECT_EQ(cell("At B"), "8");
    EXPECT_EQ(cell("Δy"), "6");
    EXPECT_EQ(cell("Mean"), "5");
    EXPECT_TRUE(table.headline.contains("Δt = 600 ms")) << table.headline.toStdString();
    model.cursorB.reset();
    EXPECT_FALSE(measureTable(model).headers.contains("Mean"));
}

TEST(PenOrder, APenNeverGoesBackWithoutNeed) {
    const auto order = [](double first, double minimum, double maximum, double last) {
        const PenOrder pen(first, minimum, maximum, last);
        return std::vector<double>(pen.begin(), pen.end());
    };
    EXPECT_EQ(order(1, 1, 4, 4), (std::vector<double>{1, 4}));
    EXPECT_EQ(order(4, 1, 4, 1), (std::vector<double>{4, 1})) << "falling: the band came from 4, 1, 4, 1";
    EXPECT_EQ(order(2, 1, 4, 3), (std::vector<double>{2, 1, 4, 3}));
    EXPECT_EQ(order(3, 1, 4, 2), (std::vector<double>{3, 4, 1, 2}));
    EXPECT_EQ(order(2, 2, 2, 2), (std::vector<double>{2}));
}

TEST(ExactText, WholeNumbersKeepAllDigits) {
    EXPECT_EQ(exactText(WholeNumber{0xFFFFFFFFFFFFFFFF, true}), "18446744073709551615");
    EXPECT_EQ(exactText(WholeNumber{0x8000000000000000, false}), "-9223372036854775808");
    EXPECT_EQ(exactText(WholeNumber{1'500'000, false}, 6), "1.5");
    EXPECT_EQ(exactText(WholeNumber{static_cast<uint64_t>(-1), false}, 6), "-0.000001");
    EXPECT_EQ(exactText(WholeNumber{2'000'000, false}, 6), "2");
    EXPECT_EQ(exactText(WholeNumber{0, false}, 6), "0");
    EXPECT_EQ(exactDifference(WholeNumber{0xFFFFFFFFFFFFFFFF, true}, WholeNumber{0, true}), "-18446744073709551615");
}

TEST(PlotExport, CsvHasEverySampleExactly) {
    PlotModel model;
    auto fast = std::make_shared<SampleList>(PlotValueKind::Single);
    auto slow = std::make_shared<SampleList>(PlotValueKind::Integer);
    for (int i = 0; i < 5; ++i) fast->append(i * 10 * Ms, static_cast<float>(0.1 * i));
    slow->append(15 * Ms, 7);
    slow->append(30 * Ms, -3);
    model.curves = {curveOf("a", fast, CurveStyle::Line, 0, "m"), curveOf("b", slow, CurveStyle::Hold, 1)};
    model.curves[1].valueNames = {{7, "Open, half"}};
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeCsv(model, 0, 40 * Ms, buffer);
    EXPECT_EQ(buffer.data().toStdString(), "time [s],a [m],b\n0,0,\n0.01,0.1,\n0.015,0.1,\"Open, "
                                           "half\"\n0.02,0.2,\"Open, half\"\n0.03,0.3,-3\n0.04,0.4,-3\n");
}

TEST(PlotExport, WritesEveryKindOfPictureAndRefusesOthers) {
    QTemporaryDir folder;
    const PlotModel model = showCase();
    for (const auto& [suffix, start] : {std::pair{"png", "\x89PNG"}, {"svg", "<?xml"}, {"pdf", "%PDF"}}) {
        const QString path = folder.filePath(QString("p.") + suffix);
        ASSERT_TRUE(exportPicture(model, path)) << suffix;
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        EXPECT_TRUE(bytes.startsWith(start)) << suffix;
        EXPECT_GT(bytes.size(), 5'000) << suffix;
        if (qstrcmp(suffix, "svg") == 0) { // looks like the picture of pixels
            const QImage pixels = plotPicture(model);
            QImage drawn(pixels.size(), QImage::Format_ARGB32_Premultiplied);
            drawn.fill(Qt::white);
            QPainter painter(&drawn);
            QSvgRenderer(bytes).render(&painter, drawn.rect());
            painter.end();
            keep(drawn, "svg");
            int64_t differing = 0;
            for (int y = 0; y < drawn.height(); ++y)
                for (int x = 0; x < drawn.width(); ++x)
                    differing += !isNear(drawn.pixelColor(x, y), pixels.pixelColor(x, y), 200);
            EXPECT_LT(static_cast<double>(differing), 0.03 * drawn.width() * drawn.height());
        }
        EXPECT_LT(bytes.size(), 3'000'000) << "buckets, not samples";
    }
    EXPECT_FALSE(exportPicture(model, folder.filePath("p.gif")));
    EXPECT_FALSE(exportPicture(model, "/no/such/folder/p.png"));
}
