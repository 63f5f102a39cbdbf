// How a plot uses its room: one lane fills it, curves stay in their frame, names are beside the curves and have their
// unit once, and what is drawn beneath says what it is.
#include "editor/kit/curve_words.h"
#include "editor/kit/theme.h"
#include "editor/plot/painting/plot_renderer.h"

#include <gtest/gtest.h>

namespace plc::plot {
namespace {

constexpr int64_t S = 1'000'000'000;

PlotCurve curveOf(const QString& name, double from, double to, const QColor& color) {
    auto list = std::make_shared<SampleList>(PlotValueKind::Double);
    for (int i = 0; i <= 100; ++i) list->append(i * S / 10, from + (to - from) * i / 100);
    PlotCurve curve;
    curve.id = curve.name = name;
    curve.color = color;
    curve.width = 4;
    curve.source = std::move(list);
    return curve;
}

struct Drawn {
    explicit Drawn(const PlotModel& model, QSize size = {900, 500}) : image(size, QImage::Format_ARGB32_Premultiplied) {
        QPainter painter(&image);
        renderer.setFont(QApplication::font());
        renderer.paint(painter, model, QRectF(QPointF(), QSizeF(size)));
    }
    QImage image;
    PlotRenderer renderer;
};

PlotModel modelOf(std::vector<PlotCurve> curves) {
    PlotModel model;
    model.to = 10 * S;
    model.curves = std::move(curves);
    return model;
}

TEST(PlotRoom, OneLaneFillsIt) {
    PlotModel model = modelOf({curveOf("Main.run", 0, 1, Qt::red)});
    model.curves[0].style = CurveStyle::Digital;
    const Drawn drawn(model);
    ASSERT_EQ(drawn.renderer.panes().size(), 1u);
    EXPECT_GT(drawn.renderer.panes()[0].area.height(), 400);
}

TEST(PlotRoom, TheNumbersOfTheTimeAxisAreInsideALowPicture) {
    // two charts in the trace of a window of 1024 by 700
    PlotModel model = modelOf({curveOf("Main.temperature", 30, 40, Qt::red), curveOf("Main.valve", 0, 50, Qt::blue)});
    model.charts.resize(2);
    model.charts[0].title = "Temperature";
    model.charts[1].title = "Valve";
    model.charts[0].axes = {PlotAxis{.unit = "°C"}};
    model.charts[1].axes = {PlotAxis{.unit = "%"}};
    model.curves[1].chart = 1;
    for (const int height : {166, 180, 200}) {
        const Drawn drawn(model, {378, height});
        ASSERT_EQ(drawn.renderer.panes().size(), 2u);
        const QRectF last = drawn.renderer.panes()[1].area;
        EXPECT_GT(last.height(), 15) << height;
        EXPECT_LE(last.bottom() + 5 + QFontMetricsF(QApplication::font()).height(), height);
    }
}

TEST(PlotRoom, CurvesEndAtTheirFrame) {
    PlotModel model = modelOf({curveOf("Main.level", -50, 150, QColor(255, 0, 255))});
    model.charts[0].axes[0].mode = AxisMode::Fixed;
    model.charts[0].axes[0].fixed = {0, 100};
    model.hasLegend = false;
    const Drawn drawn(model);
    const QRect frame = drawn.renderer.panes()[0].area.toAlignedRect();
    int inside = 0;
    for (int y = 0; y < drawn.image.height(); ++y)
        for (int x = 0; x < drawn.image.width(); ++x) {
            const QColor pixel = drawn.image.pixelColor(x, y);
            if (pixel.red() < 200 || pixel.green() > 80 || pixel.blue() < 200) continue;
            EXPECT_TRUE(frame.contains(x, y)) << x << ", " << y;
            ++inside;
        }
    EXPECT_GT(inside, 100);
}

TEST(PlotRoom, NamesAreBesideTheEndsOfTheirCurvesAndApart) {
    const PlotModel model =
        modelOf({curveOf("Main.tank.low", 0, 49, Qt::red), curveOf("Main.tank.high", 0, 50, Qt::blue),
                 curveOf("Main.tank.far", 0, 5, Qt::green)});
    const Drawn drawn(model);
    const std::vector<EndLabel>& labels = drawn.renderer.endLabels();
    ASSERT_EQ(labels.size(), 3u);
    const QRectF area = drawn.renderer.panes()[0].area;
    for (size_t i = 0; i < labels.size(); ++i) {
        EXPECT_GE(labels[i].rect.left(), area.right());
        EXPECT_LE(labels[i].rect.bottom(), area.bottom() + 0.5);
        EXPECT_GE(labels[i].rect.top(), i == 0 ? 0 : labels[i - 1].rect.bottom() - 0.01);
    }
    EXPECT_EQ(model.curves[static_cast<size_t>(labels[0].curve)].name, "Main.tank.high");
    EXPECT_EQ(model.curves[static_cast<size_t>(labels[2].curve)].name, "Main.tank.far");
    EXPECT_TRUE(Drawn(model, {300, 200}).renderer.endLabels().empty()) << "a small picture is for the curves";
}

TEST(PlotRoom, TheNumberAtTheUppermostTickIsBelowTheLegend) {
    for (const QSize size : {QSize(900, 500), QSize(900, 260)}) {
        PlotModel model = modelOf({curveOf("Main.level", 0, 100, Qt::red), curveOf("Main.other", 0, 80, Qt::blue)});
        model.charts.push_back(model.charts[0]);
        model.curves[1].chart = 1;
        for (PlotChart& chart : model.charts) {
            chart.title = "Level";
            chart.axes[0].mode = AxisMode::Fixed;
            chart.axes[0].fixed = {0, 100}; // a tick at the frame
        }
        const Drawn drawn(model, size);
        const double line = QFontMetricsF(QApplication::font()).height();
        ASSERT_EQ(drawn.renderer.panes().size(), 2u);
        for (const LegendEntry& entry : drawn.renderer.legend()) {
            const int chart = model.curves[static_cast<size_t>(entry.curve)].chart;
            const QRectF area = drawn.renderer.panes()[static_cast<size_t>(chart)].area;
            const double textBottom = entry.rect.center().y() + line / 2;
            EXPECT_GE(area.top() - line / 2, textBottom - 0.5) << size.height() << ": chart " << chart;
        }
    }
}

TEST(PlotRoom, AnExpressionIsNotCutAtItsPoints) {
    const auto roomBeside = [](const char* second) {
        const PlotModel model = modelOf({curveOf("Main.tank.low", 0, 49, Qt::red), curveOf(second, 0, 5, Qt::blue)});
        return Drawn(model).renderer.panes()[0].area.right();
    };
    EXPECT_LT(roomBeside("INTEGRAL(Main.low)") + 30, roomBeside("Main.low")); // not only "low)"
}

TEST(PlotRoom, TheLegendSaysWhatIsDrawnBeneath) {
    PlotModel model = modelOf({curveOf("Main.level", 0, 50, Qt::red)});
    const size_t before = Drawn(model).renderer.legend().size();
    model.beneathName = "run 7, 2.5 s later";
    const Drawn drawn(model);
    ASSERT_EQ(drawn.renderer.legend().size(), before + 1);
    EXPECT_EQ(drawn.renderer.legend().back().curve, -1);
    EXPECT_FALSE(drawn.renderer.legendAt(drawn.renderer.legend().back().rect.center())) << "nothing to select there";
}

TEST(CurveWords, AUnitIsAddedOnlyWhereTheNameDoesNotEndWithIt) {
    const struct {
        const char *name, *unit, *shown;
    } rows[] = {
        {"Level", "%", "Level [%]"},
        {"Level [%]", "%", "Level [%]"},
        {"Level in %", "%", "Level in %"},
        {"Speed (rpm)", "rpm", "Speed (rpm)"},
        {"Spend", "d", "Spend [d]"},
        {"Level", "", "Level"},
        {"s", "s", "s [s]"},
        {"Main.m", "m", "Main.m [m]"},
        {"Temperature, °C", "°C", "Temperature, °C"},
        {"Flow [m³/h]", "m3/h", "Flow [m³/h]"},
        {"Temperature [°C]", "C", "Temperature [°C]"},
        {"Flow [l/min]", "m3/h", "Flow [l/min]"},
        {"Main.row[3]", "mm", "Main.row[3] [mm]"},
        {"Main.row[i]", "mm", "Main.row[i] [mm]"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(kit::withUnit(QString::fromUtf8(row.name), QString::fromUtf8(row.unit)).toStdString(), row.shown);
}

TEST(CurveWords, AColourIsFoundInNamesAsProgramsWriteThem) {
    const struct {
        const char *name, *color;
    } rows[] = {
        {"Main.LampRed", "red"},     {"bRed", "red"},        {"red_lamp", "red"},
        {"Main.xGRUEN", "green"},    {"Rote Lampe", "red"},  {"Main.infrared", ""},
        {"Main.Ordered", ""},        {"Main.RedYellow", ""}, {"Green.level", ""},
        {"Main.qYellow1", "yellow"}, {"Main.credit", ""},
    };
    for (const auto& row : rows)
        EXPECT_EQ(kit::colorNamed(QString::fromUtf8(row.name)).toStdString(), row.color) << row.name;
}

} // namespace
} // namespace plc::plot
