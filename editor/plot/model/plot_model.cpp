#include "editor/plot/model/plot_model.h"

#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"

#include <algorithm>
#include <cmath>

namespace plc::plot {

namespace {

QString withMinus(const std::string& number) {
    QString text = QString::fromStdString(number);
    if (text.startsWith(QLatin1Char('-'))) text.replace(0, 1, QStringLiteral("−"));
    return text;
}

} // namespace

std::optional<int> PlotCurve::decimals() const {
    if (offset != 0) return std::nullopt;
    double power = 1;
    for (int decimals = 0; decimals <= 9; ++decimals, power *= 10)
        if (scale == 1 / power) return decimals;
    return std::nullopt;
}

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
    if (const auto name = curve.valueNames.find(static_cast<int64_t>(raw)); name != curve.valueNames.end())
        return name->second;
    if (curve.source && curve.source->valueKind() == PlotValueKind::Bool && curve.scale == 1 && curve.offset == 0)
        return raw != 0 ? QStringLiteral("TRUE") : QStringLiteral("FALSE");
    if (curve.integerText) return curve.integerText(static_cast<int64_t>(raw));
    const bool isPlainInteger =
        curve.source && curve.source->valueKind() == PlotValueKind::Integer && curve.decimals() == 0;
    const QString text =
        isPlainInteger ? withMinus(exactText(raw, PlotValueKind::Integer)) : valueText(curve.shown(raw), digits);
    return withUnit && !curve.unit.isEmpty() ? text + QLatin1Char(' ') + curve.unit : text;
}

QString curveTextAt(const PlotCurve& curve, int64_t time, int digits, bool withUnit) {
    const auto sample = curve.source ? curve.source->inForceAt(time) : std::nullopt;
    if (!sample) return QStringLiteral("–");
    const auto integer = curve.source->integerAt(time);
    const auto decimals = curve.decimals();
    if (!integer || !decimals || std::isnan(sample->value))
        return curveValueText(curve, sample->value, digits, withUnit);
    const auto value = static_cast<int64_t>(integer->bits);
    if (const auto name = curve.valueNames.find(value); name != curve.valueNames.end()) return name->second;
    if (curve.integerText) return curve.integerText(value);
    const QString text = withMinus(exactText(*integer, *decimals));
    return withUnit && !curve.unit.isEmpty() ? text + QLatin1Char(' ') + curve.unit : text;
}

QColor markerColor(MarkerKind kind) {
    const kit::ThemeColors& c = kit::colors();
    switch (kind) {
    case MarkerKind::Event:
        return c.info;
    case MarkerKind::Start:
        return c.good;
    case MarkerKind::Breakpoint:
        return c.breakpoint;
    case MarkerKind::Force:
        return c.forced;
    case MarkerKind::OnlineChange:
        return c.accent;
    case MarkerKind::Fault:
        return c.bad;
    case MarkerKind::Reset:
        return c.warning;
    case MarkerKind::Branch:
        return c.plotTrigger;
    case MarkerKind::SkippedScans:
        return c.warning;
    }
    return c.info;
}

} // namespace plc::plot
