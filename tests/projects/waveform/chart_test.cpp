// Charts as SVG: lines of logarithmic axes, notes, a legend that keeps off the curves.
#include "projects/waveform/chart.h"

#include <gtest/gtest.h>

using namespace plc::waveform;

TEST(Chart, LogarithmicAxesHaveLinesInOneDecadeToo) {
    EXPECT_EQ(logarithmicTicks(1, 1000), (std::vector<double>{1, 10, 100, 1000}));
    EXPECT_EQ(logarithmicTicks(3, 40), (std::vector<double>{5, 10, 20}));
    EXPECT_EQ(logarithmicTicks(0.2, 0.5).size(), 2U);
}

TEST(Chart, ASmallRangeIsNotSpreadOverTheWholeHeight) {
    EXPECT_EQ(spanOf(0.9, 1.1, 1), (std::pair{0.5, 1.5}));
    EXPECT_EQ(spanOf(0, 4, 1), (std::pair{0.0, 4.0}));
}

TEST(Chart, TheLegendIsOutsideTheCurves) {
    ChartPage page;
    Chart chart{"A title of some length", "time [s]", "y", {}, false};
    for (int i = 0; i < 6; ++i) chart.curves.push_back({"A long name of a curve", {0, 1}, {0, 1}, i});
    page.charts = {chart};
    const auto topOfPlot = [](const std::string& svg) {
        const auto rect = svg.find("<rect x=");
        const auto y = svg.find("y=\"", rect);
        return std::stod(svg.substr(y + 3));
    };
    const auto lineOfLegend = [](const std::string& svg) {
        const auto name = svg.find(">A long name");
        const auto y = svg.rfind("y=\"", name);
        return std::stod(svg.substr(y + 3));
    };
    const std::string svg = svgOf(page);
    EXPECT_LT(lineOfLegend(svg), topOfPlot(svg));
}

TEST(Chart, NotesAndColumnsAreDrawn) {
    ChartPage page;
    Chart chart{"One", "x", "y", {{"a", {1, 100}, {1, 2}, 0}}, true};
    chart.notes.push_back({10, 1.5, "a remark"});
    chart.notes.push_back({1000, 1.5, "out of sight"});
    page.charts = {chart, chart};
    const std::string wide = svgOf(page);
    EXPECT_NE(wide.find("a remark"), std::string::npos);
    EXPECT_EQ(wide.find("out of sight"), std::string::npos);
    page.columns = 1;
    EXPECT_NE(wide.substr(0, 120), svgOf(page).substr(0, 120));
}
