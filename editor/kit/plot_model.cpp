#include "editor/kit/plot_model.h"

#include "editor/kit/plot_scale.h"
#include "editor/kit/theme.h"

#include <algorithm>
#include <cmath>

namespace plc::kit {

std::optional<std::pair<int64_t, int64_t>> wholeRange(const PlotModel& model) {
    std::optional<std::pair<int64_t, int64_t>> whole;
    auto add = [&](std::optional<std::pair<int64_t, int64_t>> range, int64_t shift) {
        if (!range) return;
        range->first += shift;
        range->second += shift;
        if (!whole) whole = range;
        whole->first = std::min(whole->first, range->first);
        whole->second = std::max(whole->second, range->second);
    };
    for (const PlotCurve& curve : model.curves) {
        if (!curve.isVisible) continue;
        if (curve.source) add(curve.source->timeRange(), 0);
        for (const PlotBeneath& beneath : curve.beneath)
            if (beneath.source) add(beneath.source->timeRange(), beneath.shift);
    }
    return whole;
}

int64_t snappedTime(const PlotModel& model, int64_t time) {
    if (const PlotCurve* curve = findCurve(model, model.selected); curve && curve->isVisible && curve->source)
        if (const auto sample = nearestSample(*curve->source, time)) return sample->time;
    std::optional<int64_t> best;
    for (const PlotCurve& curve : model.curves) {
        if (!curve.isVisible || !curve.source) continue;
        const auto sample = nearestSample(*curve.source, time);
        if (sample && (!best || std::abs(sample->time - time) < std::abs(*best - time))) best = sample->time;
    }
    return best.value_or(time);
}

const PlotCurve* findCurve(const PlotModel& model, const QString& id) {
    for (const PlotCurve& curve : model.curves)
        if (!id.isEmpty() && curve.id == id) return &curve;
    return nullptr;
}

QString curveValueText(const PlotCurve& curve, double raw, int digits, bool withUnit) {
    if (std::isnan(raw)) return QStringLiteral("–");
    if (const auto name = curve.valueNames.find(static_cast<int64_t>(raw)); name != curve.valueNames.end()) return name->second;
    if (curve.source && curve.source->valueKind() == PlotValueKind::Bool && curve.scale == 1 && curve.offset == 0)
        return raw != 0 ? QStringLiteral("TRUE") : QStringLiteral("FALSE");
    const QString text = valueText(curve.shown(raw), digits);
    return withUnit && !curve.unit.isEmpty() ? text + QLatin1Char(' ') + curve.unit : text;
}

QColor markerColor(MarkerKind kind) {
    const ThemeColors& c = colors();
    switch (kind) {
    case MarkerKind::Event: return c.info;
    case MarkerKind::Start: return c.good;
    case MarkerKind::Breakpoint: return c.breakpoint;
    case MarkerKind::Force: return c.forced;
    case MarkerKind::OnlineChange: return c.accent;
    case MarkerKind::Fault: return c.bad;
    case MarkerKind::Reset: return c.warning;
    case MarkerKind::Branch: return c.plotTrigger;
    case MarkerKind::SkippedScans: return c.warning;
    }
    return c.info;
}

} // namespace plc::kit
