// A page of charts as SVG text: curves over time or frequency, with axes, grid and legend. Values and functions, any
// thread.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace plc::waveform {

enum class CurveStyle : uint8_t { Line, Dots, Dashed };

/// In the place of a colour of the palette: what is there to compare with.
inline constexpr int kMuted = -1;

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
    double leastSpan = 0; // of y: a smaller range is not spread over the whole height
};

struct ChartPage {
    std::string title;
    std::vector<std::string> lines; // below the title
    std::vector<Chart> charts;
    bool isDark = false;
    size_t columns = 2;
};

/// Shortest text with so many significant digits.
[[nodiscard]] std::string numberText(double value, int digits = 4);
[[nodiscard]] std::string svgOf(const ChartPage& page);
/// Where a logarithmic axis gets a line: powers of ten, and 2 and 5 times of them where there are few.
[[nodiscard]] std::vector<double> logarithmicTicks(double low, double high);
/// A range of at least so much, about the same middle.
[[nodiscard]] std::pair<double, double> spanOf(double low, double high, double least);
/// About so many values at which an axis from low to high gets a line: 1, 2 or 5 times a power of ten apart.
[[nodiscard]] std::vector<double> axisTicks(double low, double high, int about);

} // namespace plc::waveform
