#include "projects/tuning/bode_plot.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

using waveform::Curve;
using waveform::CurveStyle;

constexpr size_t kPoints = 400;
constexpr double kLeastPhase = -450; // a dead time turns on without end

/// Around the corners of the process and the crossovers of the loops: where something is decided.
std::pair<double, double> rangeFor(const ProcessModel& process, const std::vector<PlottedLoop>& loops) {
    double low = 0.1 / process.timeScale(), high = 10 / process.timeScale();
    for (const PlottedLoop& loop : loops) {
        if (loop.figures.crossover > 0) {
            low = std::min(low, loop.figures.crossover / 30);
            high = std::max(high, loop.figures.crossover * 20);
        }
        if (loop.figures.gainMarginAt > 0) high = std::max(high, loop.figures.gainMarginAt * 4);
    }
    return {low, high};
}

struct Pair {
    Curve gain, phase;
};

/// `shift`: a turn of 360 degrees more or less is the same; the curve is drawn where the margin is counted from.
Pair curvesOf(const std::vector<BodePoint>& points, const std::string& name, int colour, double shift) {
    Pair out;
    out.gain = {name, {}, {}, colour, CurveStyle::Line};
    out.phase = out.gain;
    for (const BodePoint& point : points) {
        out.gain.x.push_back(point.omega);
        out.gain.y.push_back(point.decibels);
        if (point.degrees + shift < kLeastPhase) continue;
        out.phase.x.push_back(point.omega);
        out.phase.y.push_back(point.degrees + shift);
    }
    return out;
}

Curve dashed(double x1, double y1, double x2, double y2) {
    return {"", {x1, x2}, {y1, y2}, waveform::kMuted, CurveStyle::Dashed};
}

/// By how much the phase as computed is off the one that the margin speaks of.
double shiftOf(const std::vector<BodePoint>& points, const LoopFigures& figures) {
    if (!(figures.phaseMarginAt > 0)) return 0;
    const auto at = std::lower_bound(points.begin(), points.end(), figures.phaseMarginAt,
                                     [](const BodePoint& p, double omega) { return p.omega < omega; });
    if (at == points.end()) return 0;
    return 360 * std::round((figures.phaseMargin - 180 - at->degrees) / 360);
}

void mark(const PlottedLoop& loop, const BodeWords& words, waveform::Chart& gain, waveform::Chart& phase) {
    const LoopFigures& figures = loop.figures;
    if (figures.phaseMarginAt > 0 && std::isfinite(figures.phaseMargin)) {
        const double at = figures.phaseMarginAt;
        gain.notes.push_back({at, 0, numberText(at, 3) + " rad/s"});
        phase.curves.push_back(dashed(at, -180, at, figures.phaseMargin - 180));
        phase.notes.push_back({at, figures.phaseMargin - 180,
                               words.phaseMargin + " " + numberText(std::round(figures.phaseMargin)) + "°"});
    }
    if (figures.gainMarginAt > 0 && std::isfinite(figures.gainMargin)) {
        const double at = figures.gainMarginAt, decibels = 20 * std::log10(figures.gainMargin);
        gain.curves.push_back(dashed(at, 0, at, -decibels));
        gain.notes.push_back({at, -decibels, words.gainMargin + " " + numberText(decibels, 3) + " dB"});
        phase.notes.push_back({at, -180, numberText(at, 3) + " rad/s"});
    }
}

} // namespace

std::array<waveform::Chart, 2> bodeCharts(const ProcessModel& process, const std::vector<PlottedLoop>& loops,
                                          double delay, const BodeWords& words) {
    waveform::Chart gain{words.title, words.frequency, words.gain, {}, true};
    waveform::Chart phase{"", words.frequency, words.phase, {}, true};
    gain.leastSpan = 20;
    phase.leastSpan = 90;
    const auto [low, high] = rangeFor(process, loops);
    gain.curves.push_back(dashed(low, 0, high, 0));
    phase.curves.push_back(dashed(low, -180, high, -180));
    const auto add = [&](const std::vector<BodePoint>& points, const std::string& name, int colour, double shift) {
        Pair pair = curvesOf(points, name, colour, shift);
        pair.phase.name.clear(); // the colours are the same: one legend for both
        gain.curves.push_back(std::move(pair.gain));
        phase.curves.push_back(std::move(pair.phase));
    };
    const auto ofProcess = bode([&](double w) { return process.at(w); }, low, high, kPoints);
    add(ofProcess, words.process, waveform::kMuted, ofProcess.front().degrees > 90 ? -360 : 0);
    for (const PlottedLoop& loop : loops) {
        const auto points =
            bode([&](double w) { return process.at(w) * loop.gains.at(w) * std::exp(Complex(0, -delay * w)); }, low,
                 high, kPoints);
        add(points, loop.name, loop.colour, shiftOf(points, loop.figures));
        if (loop.isMarked) mark(loop, words, gain, phase);
    }
    return {std::move(gain), std::move(phase)};
}

} // namespace plc::tuning
