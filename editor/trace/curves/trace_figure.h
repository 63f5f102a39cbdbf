// What is drawn beside the charts over time: one value over another, a spectrum, a frequency response, runs laid over
// each other. The samples are taken from the plot on its thread; the rest is a pure function for any thread.
#pragma once

#include "editor/plot/figure.h"
#include "editor/trace/curves/trace_feed.h"
#include "editor/trace/setup/trace_setup.h"
#include "projects/waveform/samples.h"

namespace plc::trace {

struct FigureChannel {
    std::string name, unit, colour;
    waveform::Samples samples; // times in seconds
};

struct FigureJob {
    FigureSetup setup;
    std::vector<FigureChannel> channels; // of an XY plot and a response the horizontal value, the input first
    std::vector<double> starts;          // of the runs [s]
    double before = 0, after = 0;        // shown around them [s]
    bool hasTrigger = false;
    [[nodiscard]] size_t samples() const;
};

/// The visible channels between the cursors, else in view; of runs all that is there.
[[nodiscard]] FigureJob figureJob(const TraceSetup& setup, const plot::PlotModel& model, const TraceFeed* feed);

/// The first channel in view that moves, which has something to say as the horizontal value or the input: a set point
/// at rest has not. Empty where that is the first, or none.
[[nodiscard]] std::string firstMoving(const TraceSetup& setup, const plot::PlotModel& model);

struct FigureAnswer {
    plot::Figure figure;
    QString text; // the figures that go with it: peaks, where runs differ most
};
[[nodiscard]] FigureAnswer figureOf(const FigureJob& job);

/// "XY plot"…, in the order of menus.
[[nodiscard]] QString titleOf(FigureKind kind);

} // namespace plc::trace
