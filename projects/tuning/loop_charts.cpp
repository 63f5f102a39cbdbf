#include "projects/tuning/loop_report.h"
#include "projects/tuning/model/errors.h"

#include <algorithm>

namespace plc::tuning {

namespace {

using waveform::Chart;
using waveform::Curve;
using waveform::CurveStyle;

constexpr int kModel = 0, kResidual = 1, kRecorded = 5;

/// As many points as a picture can show: of each stretch the least and the greatest, so that no peak is lost.
void thin(Curve& curve) {
    constexpr size_t kMost = 1500;
    const size_t count = std::min(curve.x.size(), curve.y.size());
    if (count <= kMost) return;
    std::vector<double> x, y;
    const size_t stretch = (count + kMost / 2 - 1) / (kMost / 2);
    for (size_t i = 0; i < count; i += stretch) {
        const auto begin = curve.y.begin() + static_cast<std::ptrdiff_t>(i);
        const auto end = curve.y.begin() + static_cast<std::ptrdiff_t>(std::min(i + stretch, count));
        const auto [least, greatest] = std::minmax_element(begin, end);
        for (const auto at : {std::min(least, greatest), std::max(least, greatest)}) {
            x.push_back(curve.x[static_cast<size_t>(at - curve.y.begin())]);
            y.push_back(*at);
        }
    }
    curve.x = std::move(x);
    curve.y = std::move(y);
}

Curve trajectoryCurve(const Trajectory& trajectory, const std::string& name, int colour) {
    Curve curve{name, {}, trajectory.output, colour, CurveStyle::Line};
    for (size_t i = 0; i < trajectory.output.size(); ++i) curve.x.push_back(static_cast<double>(i) * trajectory.cycle);
    thin(curve);
    return curve;
}

Chart dataChart(const LoopReport& report, const ReportWords& words) {
    Chart chart{
        words.sentence(errors::ChartModelled()), words.sentence(errors::AxisTime()), report.measured, {}, false};
    for (size_t i = 0; i < report.study.used.size(); ++i) {
        const Excerpt& excerpt = report.study.excerpts[i];
        const auto times = timesOf(report.series, report.study.steps[report.study.used[i]], excerpt);
        const auto name = [&](const Message& text) { return i ? std::string() : words.sentence(text); };
        chart.curves.push_back({name(errors::CurveRecorded()), times, excerpt.output, kRecorded, CurveStyle::Dots});
        chart.curves.push_back(
            {name(errors::CurveModel()), times, report.best().simulated[i], kModel, CurveStyle::Line});
    }
    return chart;
}

Chart residualChart(const LoopReport& report, const ReportWords& words) {
    Chart chart{
        words.sentence(errors::ChartResidual()), words.sentence(errors::AxisTime()), report.measured, {}, false};
    for (size_t i = 0; i < report.study.used.size(); ++i) {
        const Excerpt& excerpt = report.study.excerpts[i];
        const std::vector<double>& model = report.best().simulated[i];
        Curve left{"",
                   timesOf(report.series, report.study.steps[report.study.used[i]], excerpt),
                   {},
                   kResidual,
                   CurveStyle::Line};
        for (size_t s = 0; s < std::min(excerpt.output.size(), model.size()); ++s)
            left.y.push_back(excerpt.output[s] - model[s]);
        chart.curves.push_back(std::move(left));
    }
    return chart;
}

Chart responseChart(const LoopReport& report, const ReportWords& words, const Message& title,
                    Trajectory Assessment::*which) {
    Chart chart{words.sentence(title), words.sentence(errors::AxisTime()), report.measured, {}, false};
    if (report.now && report.now->figures.isStable)
        chart.curves.push_back(trajectoryCurve((*report.now).*which, words.sentence(errors::CurveNow()), kRecorded));
    int colour = 0;
    for (const ReportedSettings& one : report.settings) {
        const int own = colour++;
        if (!one.assessment.figures.isStable || one.rule == Rule::ZieglerNichols) continue;
        chart.curves.push_back(trajectoryCurve(one.assessment.*which, words.title(tuning::title(one.rule)), own));
        if (one.rule != report.rule) chart.curves.back().style = CurveStyle::Dashed;
    }
    return chart;
}

} // namespace

const Assessment* LoopReport::chosen() const {
    const auto found =
        std::find_if(settings.begin(), settings.end(), [&](const ReportedSettings& one) { return one.rule == rule; });
    return found != settings.end() ? &found->assessment : nullptr;
}

std::array<Chart, 2> bodeOf(const LoopReport& report, const ReportWords& words) {
    std::vector<PlottedLoop> loops;
    if (report.now && report.now->figures.isStable)
        loops.push_back({words.sentence(errors::CurveLoopNow()), report.now->gains, report.now->figures, 1, false});
    if (const Assessment* chosen = report.chosen())
        loops.push_back({words.sentence(errors::CurveLoopBy(words.title(tuning::title(report.rule)))), chosen->gains,
                         chosen->figures, 0, true});
    return bodeCharts(report.best().model, loops, samplingDelay(report.cycle),
                      {words.sentence(errors::ChartBode()), words.sentence(errors::AxisMagnitude()),
                       words.sentence(errors::AxisPhase()), words.sentence(errors::AxisFrequency()),
                       words.sentence(errors::CurveProcess()), words.sentence(errors::MarkGainMargin()),
                       words.sentence(errors::MarkPhaseMargin())});
}

std::vector<Chart> modelCharts(const LoopReport& report, const ReportWords& words) {
    std::vector<Chart> out{dataChart(report, words), residualChart(report, words),
                           responseChart(report, words, errors::ChartSetPoint(), &Assessment::setPointTrajectory),
                           responseChart(report, words, errors::ChartLoad(), &Assessment::loadTrajectory)};
    for (Chart& chart : bodeOf(report, words)) out.push_back(std::move(chart));
    return out;
}

std::vector<Chart> recordedCharts(const LoopReport& report, const ReportWords& words) {
    const std::string time = words.sentence(errors::AxisTime());
    std::vector<Chart> out{{words.sentence(errors::ChartMeasured()), time, report.measured, {}, false},
                           {words.sentence(errors::ChartOutput()), time, report.input, {}, false}};
    const auto add = [&](Chart& chart, const Message& name, int colour, const std::vector<double>& values) {
        if (values.empty()) return;
        chart.curves.push_back({words.sentence(name), report.series.time, values, colour, CurveStyle::Line});
        thin(chart.curves.back());
    };
    add(out[0], errors::CurveSetPoint(), 3, report.series.setPoint);
    add(out[0], errors::CurveMeasured(), 0, report.series.output);
    add(out[1], errors::CurveOutput(), 0, report.series.input);
    return out;
}

} // namespace plc::tuning
