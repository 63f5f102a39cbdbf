#include "projects/waveform/chart.h"

#include "runtime/base/xml_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plc::waveform {

std::string numberText(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value == 0 ? 0.0 : value);
    return text;
}

namespace {

constexpr double kWidth = 560, kHeight = 300, kLeft = 64, kRight = 16, kTop = 34, kBottom = 42;

struct Theme {
    const char *back, *text, *grid, *frame;
    const char* curves[6];
};
constexpr Theme kLight{
    "#ffffff", "#202124", "#e3e5e8", "#9aa0a6", {"#1a73e8", "#d93025", "#188038", "#e37400", "#5b1a8b", "#80868b"}};
constexpr Theme kDark{
    "#1e1f22", "#e8eaed", "#3a3c40", "#80868b", {"#8ab4f8", "#f2746a", "#5fcf84", "#fdd663", "#b06af5", "#9aa0a6"}};

const char* colourOf(const Curve& curve, const Theme& theme) {
    return theme.curves[curve.colour < 0 ? 5 : static_cast<size_t>(curve.colour) % 6];
}

std::string number(double value) { return numberText(value, 5); }

struct Scale {
    double low = 0, high = 1, from = 0, to = 1;
    bool isLogarithmic = false;
    [[nodiscard]] double operator()(double value) const {
        const double at = isLogarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
        return from + at * (to - from);
    }
};

std::pair<double, double> rangeOf(const Chart& chart, std::vector<double> Curve::*values) {
    double low = 1e300, high = -1e300;
    for (const Curve& curve : chart.curves)
        for (const double value : curve.*values)
            if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    if (low > high) return {0, 1};
    if (high - low < 1e-12 * std::max(std::abs(high), 1e-3)) {
        const double half = std::max(std::abs(high) * 0.1, 0.5);
        return {low - half, high + half};
    }
    return {low, high};
}

std::string text(double x, double y, const std::string& what, const char* anchor, const char* colour, int size = 12,
                 const std::string& more = {}) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" fill=\"" + colour +
           "\" font-size=\"" + std::to_string(size) + "\"" + more + ">" + xmlText(what) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* colour) {
    return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) +
           "\" stroke=\"" + colour + "\"/>\n";
}

/// About how wide a text is: SVG has no measure of fonts.
double widthOf(const std::string& what, double size) { return 0.58 * size * static_cast<double>(what.size()); }

/// Of a long path its end says most.
std::string fitting(const std::string& what, double width, double size) {
    if (widthOf(what, size) <= width) return what;
    size_t from = what.size() - std::min(what.size(), static_cast<size_t>(width / (0.58 * size)));
    while (from < what.size() && (static_cast<unsigned char>(what[from]) & 0xC0) == 0x80) ++from; // a whole character
    return "…" + what.substr(from);
}

std::string axes(const Chart& chart, const Scale& x, const Scale& y, const Theme& theme) {
    std::string out;
    for (const double at : chart.isLogarithmic ? logarithmicTicks(x.low, x.high) : axisTicks(x.low, x.high, 7)) {
        out += line(x(at), y.from, x(at), y.to, theme.grid);
        out += text(x(at), y.from + 16, numberText(at, 4), "middle", theme.text, 11);
    }
    for (const double at : axisTicks(y.low, y.high, 6)) {
        out += line(x.from, y(at), x.to, y(at), theme.grid);
        out += text(x.from - 6, y(at) + 4, numberText(at, 4), "end", theme.text, 11);
    }
    out += "<rect x=\"" + number(x.from) + "\" y=\"" + number(y.to) + "\" width=\"" + number(x.to - x.from) +
           "\" height=\"" + number(y.from - y.to) + "\" fill=\"none\" stroke=\"" + theme.frame + "\"/>\n";
    out += text((x.from + x.to) / 2, y.from + 34, chart.xTitle, "middle", theme.text, 12);
    if (!chart.yTitle.empty()) {
        const std::string at = number(x.from - 48) + " " + number((y.from + y.to) / 2);
        out += text(x.from - 48, (y.from + y.to) / 2, fitting(chart.yTitle, y.from - y.to, 12), "middle", theme.text,
                    12, " transform=\"rotate(-90 " + at + ")\"");
    }
    return out;
}

std::string drawn(const Curve& curve, const Scale& x, const Scale& y, const Theme& theme) {
    const char* colour = colourOf(curve, theme);
    std::string points;
    const size_t count = std::min(curve.x.size(), curve.y.size());
    if (curve.style == CurveStyle::Dots) {
        for (size_t i = 0; i < count; ++i)
            points += "<circle cx=\"" + number(x(curve.x[i])) + "\" cy=\"" + number(y(curve.y[i])) + "\" r=\"2\"/>";
        return std::string("<g fill=\"") + colour + "\">" + points + "</g>\n";
    }
    for (size_t i = 0; i < count; ++i)
        if (std::isfinite(curve.y[i])) points += number(x(curve.x[i])) + "," + number(y(curve.y[i])) + " ";
    return "<polyline fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-width=\"1.8\"" +
           (curve.style == CurveStyle::Dashed ? " stroke-dasharray=\"6 4\"" : "") + " points=\"" + points + "\"/>\n";
}

constexpr double kSample = 18, kBetween = 14; // of a name in the legend

double legendWidth(const Chart& chart) {
    double out = 0;
    for (const Curve& curve : chart.curves)
        if (!curve.name.empty()) out += kSample + 4 + widthOf(curve.name, 11) + kBetween;
    return out;
}

/// Beside the title, or below it where that is too narrow: never over the curves.
bool isLegendBelow(const Chart& chart) {
    return widthOf(chart.title, 15) + 20 + legendWidth(chart) > kWidth - kLeft - kRight;
}

std::string legend(const Chart& chart, double right, double base, const Theme& theme) {
    std::string out;
    double at = right - legendWidth(chart) + kBetween;
    for (const Curve& curve : chart.curves) {
        if (curve.name.empty()) continue;
        const char* colour = colourOf(curve, theme);
        const std::string middle = number(base - 4);
        if (curve.style == CurveStyle::Dots)
            for (const double dot : {3.0, 9.0, 15.0})
                out +=
                    "<circle cx=\"" + number(at + dot) + "\" cy=\"" + middle + "\" r=\"2\" fill=\"" + colour + "\"/>";
        else
            out += "<path d=\"M" + number(at) + " " + middle + "h" + number(kSample) + "\" stroke=\"" + colour +
                   "\" stroke-width=\"2\"" + (curve.style == CurveStyle::Dashed ? " stroke-dasharray=\"5 3\"" : "") +
                   "/>\n";
        out += text(at + kSample + 4, base, curve.name, "start", theme.text, 11);
        at += kSample + 4 + widthOf(curve.name, 11) + kBetween;
    }
    return out;
}

std::string drawn(const ChartNote& note, const Scale& x, const Scale& y, const Theme& theme) {
    const double atX = x(note.x), atY = y(note.y);
    if (atX < x.from || atX > x.to || atY > y.from || atY < y.to) return {};
    const double width = widthOf(note.text, 11), base = std::max(atY - 6, y.to + 12);
    const bool isLeft = atX + 12 + width > x.to;
    // the text has a ground of its own: curves pass behind it
    return "<rect x=\"" + number(isLeft ? atX - 11 - width : atX + 6) + "\" y=\"" + number(base - 11) + "\" width=\"" +
           number(width + 5) + "\" height=\"14\" fill=\"" + theme.back + "\" fill-opacity=\"0.85\"/>\n" +
           "<circle cx=\"" + number(atX) + "\" cy=\"" + number(atY) + "\" r=\"3.5\" fill=\"" + theme.curves[4] +
           "\"/>\n" + text(atX + (isLeft ? -8 : 8), base, note.text, isLeft ? "end" : "start", theme.text, 11);
}

std::string drawn(const Chart& chart, double left, double top, const Theme& theme) {
    auto [xLow, xHigh] = rangeOf(chart, &Curve::x);
    const auto values = rangeOf(chart, &Curve::y);
    const auto [yLow, yHigh] = spanOf(values.first, values.second, chart.leastSpan);
    const double below = isLegendBelow(chart) ? 18 : 0;
    const double margin = (yHigh - yLow) * 0.06;
    const Scale x{xLow, xHigh, left + kLeft, left + kWidth - kRight, chart.isLogarithmic};
    const Scale y{yLow - margin, yHigh + margin, top + kHeight - kBottom, top + kTop + below, false};
    std::string out = text(left + kLeft, top + 22, fitting(chart.title, kWidth - kLeft - kRight, 14), "start",
                           theme.text, 14, " font-weight=\"600\"");
    out += axes(chart, x, y, theme);
    for (const Curve& curve : chart.curves) out += drawn(curve, x, y, theme);
    for (const ChartNote& note : chart.notes) out += drawn(note, x, y, theme);
    return out + legend(chart, left + kWidth - kRight, top + 22 + below, theme);
}

} // namespace

std::pair<double, double> spanOf(double low, double high, double least) {
    if (high - low >= least) return {low, high};
    const double middle = (low + high) / 2;
    return {middle - least / 2, middle + least / 2};
}

std::vector<double> logarithmicTicks(double low, double high) {
    std::vector<double> out;
    constexpr double kManyDecades = 100; // then the powers of ten are enough
    const double first = std::pow(10, std::floor(std::log10(low)));
    for (double decade = first; decade <= high * 1.000001; decade *= 10)
        for (const double share : {1.0, 2.0, 5.0}) {
            if (share > 1 && high / low > kManyDecades) continue;
            const double at = decade * share;
            if (at >= low * 0.999999 && at <= high * 1.000001) out.push_back(at);
        }
    return out;
}

std::vector<double> axisTicks(double low, double high, int about) {
    const double raw = (high - low) / about, power = std::pow(10, std::floor(std::log10(raw)));
    const double share = raw / power, step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
    std::vector<double> out;
    for (double index = std::ceil(low / step); index * step <= high + step * 1e-9; ++index)
        out.push_back(index == 0 ? 0 : index * step);
    return out;
}

std::string svgOf(const ChartPage& page) {
    const Theme& theme = page.isDark ? kDark : kLight;
    const double head = 30 + 18 * static_cast<double>(page.lines.size()) + 14;
    const size_t columns = std::clamp<size_t>(page.columns, 1, std::max<size_t>(page.charts.size(), 1));
    const size_t rows = (page.charts.size() + columns - 1) / columns;
    const double width = static_cast<double>(columns) * kWidth;
    const double height = head + kHeight * static_cast<double>(rows) + 8;
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" +
                      number(height) + "\" viewBox=\"0 0 " + number(width) + " " + number(height) +
                      "\" font-family=\"Noto Sans, sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"" +
                      theme.back + "\"/>\n";
    out += text(18, 26, fitting(page.title, width - 36, 17), "start", theme.text, 17, " font-weight=\"600\"");
    for (size_t i = 0; i < page.lines.size(); ++i)
        out += text(18, 48 + 18 * static_cast<double>(i), page.lines[i], "start", theme.text, 13);
    for (size_t i = 0; i < page.charts.size(); ++i)
        out += drawn(page.charts[i], kWidth * static_cast<double>(i % columns),
                     head + kHeight * static_cast<double>(i / columns), theme);
    return out + "</svg>\n";
}

} // namespace plc::waveform
