// For the files of PlotRenderer: what a pane keeps between two pictures. Owned by the renderer; its thread.
#pragma once
#include "editor/plot/painting/plot_renderer.h"

#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace plc::plot {

/// Around the plot, in pixels.
constexpr double PlotPad = 8;

/// What a pane keeps between two pictures: its axes, and the shapes of curves that have not changed.
struct PlotRenderer::PaneParts {
    struct Kept {
        const SampleSource* source = nullptr;
        uint64_t revision = 0;
        int64_t shift = 0;
        CurveShape shape;
        std::optional<PlotRange> whole; // of the whole source
    };
    PlotAxes axes;
    std::vector<std::vector<Kept>> kept; // per curve of the pane: its own, then those beneath

    static void refresh(Kept& kept, const SampleSource& source, int64_t shift, int64_t from, int64_t to, int columns) {
        const bool sameData = kept.source == &source && kept.revision == source.revision() && kept.shift == shift;
        if (!sameData) kept.whole.reset();
        if (sameData && kept.shape.from == from && kept.shape.to == to && kept.shape.columns == columns) return;
        kept.source = &source;
        kept.revision = source.revision();
        kept.shift = shift;
        kept.shape = shapeOf(source, from, to, columns, shift);
    }
    static std::optional<PlotRange> wholeExtent(const Kept& constKept) {
        auto& kept = const_cast<Kept&>(constKept);
        if (kept.whole || !kept.source) return kept.whole;
        const auto range = kept.source->timeRange();
        if (!range) return std::nullopt;
        SignalBucket bucket;
        kept.source->buckets(range->first, range->second + 1, std::span(&bucket, 1));
        if (bucket.isNumber && std::isfinite(bucket.minimum) && std::isfinite(bucket.maximum))
            kept.whole = PlotRange{bucket.minimum, bucket.maximum};
        return kept.whole;
    }
};

} // namespace plc::plot
