// A page of charts as SVG text: curves over time or frequency, with axes, grid and legend. Values and functions, any
// thread.
#pragma once
#include <string>
#include <vector>

namespace plc::waveform {

enum class CurveStyle : uint8_t { Line, Dots, Dashed };

struct Curve {
    std::string name;
    std::vector<double> x, y;
    int colour = 0; // of the palette
    CurveStyle style = CurveStyle::Line;
    std::string ownColour{}; // "#rrggbb" in the place of the palette's
};

/// A point with a text: a peak of a spectrum.
struct ChartNote {
    double x = 0, y = 0;
    std::string text;
};

struct Chart {
    std::string title, xTitle, yTitle;
    std::vector<Curve> curves;
    bool isLogarithmic = false; // x
    bool isLogarithmicY = false;
    std::vector<ChartNote> notes;
};

struct ChartPage {
    std::string title;
    std::vector<std::string> lines; // below the title
    std::vector<Chart> charts;      // two in a row
    bool isDark = false;
};

/// Shortest text with so many significant digits.
[[nodiscard]] std::string numberText(double value, int digits = 4);
[[nodiscard]] std::string svgOf(const ChartPage& page);
/// About so many values at which an axis from low to high gets a line: 1, 2 or 5 times a power of ten apart.
[[nodiscard]] std::vector<double> axisTicks(double low, double high, int about);

} // namespace plc::waveform
