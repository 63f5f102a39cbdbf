// What a panel's trend draws: every peak, nothing where nothing is known, held values with upright jumps, and axes in
// the operator's language.
#include "hmi/view/scene/panel_scene.h"

#include "hmi/view/element_factory.h"
#include <QBuffer>
#include <QSvgGenerator>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

struct Trend {
    HeldValues values;
    TextCatalog texts;
    PanelScene scene{makeElementView};
    std::string extra, limits = R"("min": 0, "max": 100, )";

    QImage draw(std::vector<CurvePiece> pieces) {
        const Result<Panel> panel = Panel::parse(
            R"({"size": [420, 320], "elements": [{"id": "t", "kind": "trend", "rect": [0, 0, 420, 320], "seconds": 10,
                )" +
                limits + R"("legend": false, "series": [{"value": "x", "color": "#ff0000")" + extra + "}]}]}",
            QStringLiteral("p"));
        EXPECT_TRUE(panel) << (panel ? "" : panel.error().english());
        values.set(QStringLiteral("x"), Value::ofReal(50));
        values.setCurve(QStringLiteral("x"), std::move(pieces));
        scene.setTexts(&texts);
        scene.setPanel(*panel);
        scene.setValues(&values);
        return scene.picture();
    }
    static bool isRed(const QImage& image, int x, int y) {
        const QColor color = image.pixelColor(x, y);
        return color.red() > 150 && color.green() < 110 && color.blue() < 110;
    }
    /// Rows of the picture in which the column is red: the first and the last; none: -1.
    static std::pair<int, int> redIn(const QImage& image, int x) {
        std::pair<int, int> out{-1, -1};
        for (int y = 0; y < image.height(); ++y)
            if (isRed(image, x, y)) out = {out.first < 0 ? y : out.first, y};
        return out;
    }
    /// Columns with anything red.
    static std::pair<int, int> redColumns(const QImage& image) {
        std::pair<int, int> out{-1, -1};
        for (int x = 0; x < image.width(); ++x)
            if (redIn(image, x).first >= 0) out = {out.first < 0 ? x : out.first, x};
        return out;
    }
};

CurvePiece piece(double from, double to, double least, double greatest, double last, bool hasValue = true) {
    const auto nanoseconds = [](double seconds) { return static_cast<int64_t>(seconds * 1e9); };
    return {{last, least, greatest, last, hasValue ? 1u : 0u, hasValue}, nanoseconds(from), nanoseconds(to)};
}

TEST(TrendChart, NoPeakWithinAPieceIsLost) {
    Trend trend;
    const QImage image =
        trend.draw({piece(-10, -5, 50, 50, 50), piece(-5, -4.9, 5, 95, 50), piece(-4.9, 0, 50, 50, 50)});
    const auto [left, right] = Trend::redColumns(image);
    ASSERT_GT(right - left, 200);
    int tallest = 0;
    for (int x = left; x <= right; ++x) {
        const auto [top, bottom] = Trend::redIn(image, x);
        tallest = std::max(tallest, bottom - top);
    }
    EXPECT_GT(tallest, 200) << "from the least to the greatest of 240 pixels";
}

TEST(TrendChart, NothingIsDrawnWhereNothingIsKnown) {
    Trend trend;
    const QImage image =
        trend.draw({piece(-10, -7, 30, 30, 30), piece(-7, -3, 0, 0, 0, false), piece(-3, 0, 30, 30, 30)});
    const auto [left, right] = Trend::redColumns(image);
    const int width = right - left;
    for (const double share : {0.4, 0.5, 0.6})
        EXPECT_EQ(Trend::redIn(image, left + static_cast<int>(width * share)).first, -1) << share;
    for (const double share : {0.1, 0.2, 0.8, 0.9})
        EXPECT_GE(Trend::redIn(image, left + static_cast<int>(width * share)).first, 0) << share;
}

TEST(TrendChart, AHeldValueJumpsUprightAndAJoinedOneRises) {
    const std::vector<CurvePiece> pieces = {piece(-10, -5, 20, 20, 20), piece(-5, 0, 80, 80, 80)};
    Trend held;
    const QImage upright = held.draw(pieces);
    const auto [left, right] = Trend::redColumns(upright);
    const int quarter = left + (right - left) / 4, last = right - 5;
    EXPECT_GT(Trend::redIn(upright, quarter).first, Trend::redIn(upright, last).first) << "20 is below 80";
    EXPECT_LE(Trend::redIn(upright, quarter).second - Trend::redIn(upright, quarter).first, 4) << "level";
    Trend joined;
    joined.extra = R"(, "hold": false)";
    const QImage sloped = joined.draw(pieces);
    const auto [from, to] = Trend::redColumns(sloped);
    EXPECT_GT(Trend::redIn(sloped, from + 2).first, Trend::redIn(sloped, from + (to - from) / 2).first + 50);
}

TEST(TrendChart, WhatLeavesTheAxisEndsAtTheFrame) {
    Trend trend;
    const QImage image = trend.draw({piece(-10, 0, -1e300, 1e300, 50)});
    const auto [left, right] = Trend::redColumns(image);
    ASSERT_GE(left, 0);
    for (int x = left; x <= right; ++x) {
        const auto [top, bottom] = Trend::redIn(image, x);
        if (top < 0) continue;
        EXPECT_GE(top, 7);
        EXPECT_LT(bottom, 320 - 14);
    }
}

TEST(TrendChart, TheNumbersOfAValueThatHardlyMovesAreWhole) {
    for (const double value : {0.0, 50.0, 1013.25, -98765.4321}) {
        Trend trend;
        trend.limits.clear();
        (void)trend.draw({piece(-10, -5, value, value + 0.0004, value), piece(-5, 0, value, value + 0.0004, value)});
        QBuffer drawn;
        QSvgGenerator device;
        device.setOutputDevice(&drawn);
        device.setSize({420, 320});
        QPainter painter(&device);
        trend.scene.paint(painter, QRectF(0, 0, 420, 320));
        painter.end();
        const QString text = QString::fromUtf8(drawn.data());
        EXPECT_GT(text.count(QStringLiteral("<text ")), 6) << "the device has texts as texts";
        EXPECT_FALSE(text.contains(u'…')) << value;
    }
}

} // namespace
} // namespace plc::hmi
