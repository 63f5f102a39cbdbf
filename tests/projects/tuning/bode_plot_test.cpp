// The Bode plot: curves over frequency, crossover and margins where the loop really has them.
#include "projects/tuning/bode_plot.h"
#include "projects/tuning/optimum.h"
#include "tests/projects/tuning/processes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

using namespace plc::tuning;
namespace waveform = plc::waveform;

namespace {

const waveform::Curve* curveNamed(const waveform::Chart& chart, const std::string& name) {
    const auto found = std::find_if(chart.curves.begin(), chart.curves.end(),
                                    [&](const waveform::Curve& curve) { return curve.name == name; });
    return found != chart.curves.end() ? &*found : nullptr;
}

PlottedLoop loopOf(const ProcessModel& process, const ControllerGains& gains, double delay = 0) {
    return {"loop", gains, analyse(process, gains, delay), 0, true};
}

} // namespace

TEST(BodePlot, MarksCrossoverAndMargins) {
    // an integrator with dead time under P control: |L| = 1 at k, the phase there -90 - k T
    ProcessModel process = lags({}, 0.5, 1);
    process.isIntegrating = true;
    const double gain = 0.8;
    const auto charts = bodeCharts(process, {loopOf(process, {gain, 0, 0, 0})}, 0);
    ASSERT_EQ(charts[0].notes.size(), 2U);
    ASSERT_EQ(charts[1].notes.size(), 2U);
    EXPECT_NEAR(charts[0].notes[0].x, gain, 1e-3);
    const double margin = 90 - gain * 0.5 * 180 / std::numbers::pi;
    EXPECT_NEAR(charts[1].notes[0].y, margin - 180, 0.1);
    EXPECT_NE(charts[1].notes[0].text.find("phase margin 67°"), std::string::npos) << charts[1].notes[0].text;
    const double turned = std::numbers::pi; // the dead time alone turns by 90 degrees at pi / (2 T)
    EXPECT_NEAR(charts[0].notes[1].x, turned, 1e-3);
    EXPECT_NEAR(charts[0].notes[1].y, 20 * std::log10(gain / turned), 0.01);
}

TEST(BodePlot, TheMarksLieOnTheCurves) {
    for (const ProcessModel& process : {equalLags(3), equalLags(1, 4, 1, -2), lags({8, 3}, 2, 0.6)}) {
        const auto gains = optimum(process, ControllerKind::Pi, 1.6, 0.05);
        ASSERT_TRUE(gains);
        const auto charts = bodeCharts(process, {loopOf(process, *gains, 0.05)}, 0.05);
        const waveform::Curve* gain = curveNamed(charts[0], "loop");
        ASSERT_TRUE(gain);
        for (const waveform::ChartNote& note : charts[0].notes) {
            const auto at = std::lower_bound(gain->x.begin(), gain->x.end(), note.x) - gain->x.begin();
            EXPECT_NEAR(gain->y[static_cast<size_t>(at)], note.y, 0.5) << formula(process) << note.text;
        }
        const waveform::Curve& phase = charts[1].curves[2]; // behind the line at -180 and the process
        for (const waveform::ChartNote& note : charts[1].notes) {
            const auto at = std::lower_bound(phase.x.begin(), phase.x.end(), note.x) - phase.x.begin();
            EXPECT_NEAR(phase.y[static_cast<size_t>(at)], note.y, 3) << formula(process) << note.text;
        }
    }
}

TEST(BodePlot, ALoopThatIsNotMarkedHasNoMarks) {
    PlottedLoop loop = loopOf(equalLags(2), {1, 2, 0, 0});
    loop.isMarked = false;
    const auto charts = bodeCharts(equalLags(2), {loop}, 0);
    EXPECT_TRUE(charts[0].notes.empty() && charts[1].notes.empty());
    EXPECT_TRUE(curveNamed(charts[0], "process"));
    EXPECT_TRUE(charts[0].isLogarithmic);
}
