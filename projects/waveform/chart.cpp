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
    "#ffffff", "#202124", "#e3e5e8", "#9aa0a6", {"#1a73e8", "#d93025", "#188038", "#e37400", "#9334e6", "#80868b"}};
constexpr Theme kDark{
    "#1e1f22", "#e8eaed", "#3a3c40", "#80868b", {"#8ab4f8", "#f28b82", "#81c995", "#fdd663", "#c58af9", "#9aa0a6"}};

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

std::vector<double> decades(double low, double high) {
    std::vector<double> out;
    for (double at = std::pow(10, std::ceil(std::log10(low) - 1e-9)); at <= high * 1.000001; at *= 10)
        out.push_back(at);
    return out;
}

std::string axes(const Chart& chart, const Scale& x, const Scale& y, const Theme& theme) {
    std::string out;
    for (const double at : chart.isLogarithmic ? decades(x.low, x.high) : axisTicks(x.low, x.high, 7)) {
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
        out += text(x.from - 48, (y.from + y.to) / 2, chart.yTitle, "middle", theme.text, 12,
                    " transform=\"rotate(-90 " + at + ")\"");
    }
    return out;
}

std::string drawn(const Curve& curve, const Scale& x, const Scale& y, const Theme& theme) {
    const char* colour = theme.curves[static_cast<size_t>(curve.colour) % 6];
    std::string points;
    const size_t count = std::min(curve.x.size(), curve.y.size());
    if (curve.style == CurveStyle::Dots) {
        for (size_t i = 0; i < count; ++i)
            points += "<circle cx=\"" + number(x(curve.x[i])) + "\" cy=\"" + number(y(curve.y[i])) + "\" r=\"1.4\"/>";
        return std::string("<g fill=\"") + colour + "\">" + points + "</g>\n";
    }
    for (size_t i = 0; i < count; ++i)
        if (std::isfinite(curve.y[i])) points += number(x(curve.x[i])) + "," + number(y(curve.y[i])) + " ";
    return "<polyline fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-width=\"1.8\"" +
           (curve.style == CurveStyle::Dashed ? " stroke-dasharray=\"6 4\"" : "") + " points=\"" + points + "\"/>\n";
}

std::string legend(const Chart& chart, double right, double top, const Theme& theme) {
    std::string out;
    double at = top;
    for (const Curve& curve : chart.curves) {
        if (curve.name.empty()) continue;
        const char* colour = theme.curves[static_cast<size_t>(curve.colour) % 6];
        out += line(right - 18, at - 4, right - 4, at - 4, colour);
        out += text(right - 22, at, curve.name, "end", theme.text, 11);
        at += 15;
    }
    return out;
}

std::string drawn(const Chart& chart, double left, double top, const Theme& theme) {
    auto [xLow, xHigh] = rangeOf(chart, &Curve::x);
    auto [yLow, yHigh] = rangeOf(chart, &Curve::y);
    const double margin = (yHigh - yLow) * 0.06;
    const Scale x{xLow, xHigh, left + kLeft, left + kWidth - kRight, chart.isLogarithmic};
    const Scale y{yLow - margin, yHigh + margin, top + kHeight - kBottom, top + kTop, false};
    std::string out = text(left + kLeft, top + 22, chart.title, "start", theme.text, 14, " font-weight=\"600\"");
    out += axes(chart, x, y, theme);
    for (const Curve& curve : chart.curves) out += drawn(curve, x, y, theme);
    return out + legend(chart, left + kWidth - kRight - 4, top + kTop + 16, theme);
}

} // namespace

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
    const size_t rows = (page.charts.size() + 1) / 2;
    const double width = page.charts.size() > 1 ? 2 * kWidth : kWidth;
    const double height = head + kHeight * static_cast<double>(rows) + 8;
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" +
                      number(height) + "\" viewBox=\"0 0 " + number(width) + " " + number(height) +
                      "\" font-family=\"Noto Sans, sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"" +
                      theme.back + "\"/>\n";
    out += text(18, 26, page.title, "start", theme.text, 17, " font-weight=\"600\"");
    for (size_t i = 0; i < page.lines.size(); ++i)
        out += text(18, 48 + 18 * static_cast<double>(i), page.lines[i], "start", theme.text, 13);
    for (size_t i = 0; i < page.charts.size(); ++i)
        out += drawn(page.charts[i], i % 2 ? kWidth : 0, head + kHeight * static_cast<double>(i / 2), theme);
    return out + "</svg>\n";
}

} // namespace plc::waveform
