// What the user puts onto a plot: remarks, and a ruler between two points.
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/painting/plot_renderer.h"
#include "editor/plot/painting/ruler_mark.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace plc::plot {

namespace {

const PlotPane* paneOf(const std::vector<PlotPane>& panes, int chart) {
    for (const PlotPane& pane : panes)
        if (pane.chart == chart && !pane.isLanes) return &pane;
    return panes.empty() ? nullptr : &panes.front();
}

size_t axisIndex(const PlotPane& pane, int axis) {
    const auto at = std::find(pane.axes.begin(), pane.axes.end(), axis);
    return at == pane.axes.end() ? 0 : static_cast<size_t>(at - pane.axes.begin());
}

} // namespace

QString rulerText(const PlotRuler& ruler) {
    const int64_t span = ruler.toTime - ruler.fromTime;
    const double up = ruler.toValue - ruler.fromValue;
    QString out = QStringLiteral("Δt %1   Δy %2").arg(durationText(span), valueText(up, 5));
    if (span == 0) return out;
    out += QStringLiteral("   %1 /s").arg(valueText(up / (static_cast<double>(span) * 1e-9), 4));
    return out + QStringLiteral("   ") + frequencyText(std::abs(span));
}

void PlotRenderer::paintNotes(QPainter& painter, const PlotModel& model) {
    m_noteRects.clear();
    const kit::ThemeColors& c = kit::colors();
    const QFontMetricsF metrics(m_font);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(m_font);
    for (size_t i = 0; i < model.notes.size(); ++i) {
        const PlotNote& note = model.notes[i];
        const PlotPane* pane = paneOf(m_panes, note.chart);
        if (!pane || note.time < model.from || note.time > model.to) continue;
        const PlotMapping map = mapping(model, *pane);
        const double y = note.value ? map.yOf(*note.value) : pane->area.top() + pane->area.height() * 0.3;
        const QPointF anchor(map.xOf(note.time), std::clamp(y, pane->area.top(), pane->area.bottom()));
        const double most = std::max(60.0, pane->area.width() * 0.5);
        const QString text = metrics.elidedText(note.text, Qt::ElideRight, most);
        QRectF tag = tagRect(anchor, {metrics.horizontalAdvance(text) + 12, metrics.height() + 4}, pane->area);
        for (const auto& [other, taken] : m_noteRects) // two at one place: the second below the first
            if (taken.intersects(tag)) tag.moveTop(taken.bottom() + 3);
        painter.setPen(QPen(c.accent, 1));
        painter.drawLine(anchor, QPointF(std::clamp(anchor.x(), tag.left(), tag.right()),
                                         tag.center().y() < anchor.y() ? tag.bottom() : tag.top()));
        painter.setBrush(c.accent);
        painter.drawEllipse(anchor, 3, 3);
        QColor ground = c.plotGround;
        ground.setAlphaF(0.92f);
        painter.setBrush(ground);
        painter.drawRoundedRect(tag, 3, 3);
        painter.setPen(c.text);
        painter.drawText(tag, Qt::AlignCenter, text);
        m_noteRects.emplace_back(static_cast<int>(i), tag);
    }
}

void PlotRenderer::paintRuler(QPainter& painter, const PlotModel& model) {
    if (!model.ruler) return;
    const PlotRuler& ruler = *model.ruler;
    const PlotPane* pane = paneOf(m_panes, ruler.chart);
    if (!pane) return;
    const PlotMapping map = mapping(model, *pane, axisIndex(*pane, ruler.axis));
    paintRulerMark(painter, {map.xOf(ruler.fromTime), map.yOf(ruler.fromValue)},
                   {map.xOf(ruler.toTime), map.yOf(ruler.toValue)}, rulerText(ruler), pane->area, m_font);
}

PlotRuler PlotRenderer::rulerAt(const PlotModel& model, const QPointF& point, double reach) const {
    const PlotPane* pane = paneAt(point);
    if (!pane || pane->isLanes) return {};
    PlotRuler out;
    out.chart = pane->chart;
    const PlotMapping first = mapping(model, *pane);
    out.axis = pane->axes.empty() ? 0 : pane->axes.front();
    out.fromTime = out.toTime = first.timeAt(point.x());
    out.fromValue = out.toValue = first.valueAt(point.y());
    double nearest = reach * reach;
    for (const int index : pane->curves) {
        const PlotCurve& curve = model.curves[static_cast<size_t>(index)];
        if (!curve.source || !curve.isVisible) continue;
        const PlotMapping map = mapping(model, *pane, axisIndex(*pane, curve.axis));
        const auto look = [&](const std::optional<SignalSample>& sample) {
            if (!sample || std::isnan(sample->value)) return;
            const QPointF away = QPointF(map.xOf(sample->time), map.yOf(curve.shown(sample->value))) - point;
            const double distance = QPointF::dotProduct(away, away);
            if (distance >= nearest) return;
            nearest = distance;
            out.axis = curve.axis;
            out.fromTime = out.toTime = sample->time;
            out.fromValue = out.toValue = curve.shown(sample->value);
        };
        // samples within reach, but not more of them than can be told apart
        const int64_t from = map.timeAt(point.x() - reach), to = map.timeAt(point.x() + reach);
        constexpr uint64_t kMost = 4000;
        if (curve.source->countIn(from, to) <= kMost)
            curve.source->visit(from, to, [&](std::span<const SignalSample> block) {
                for (const SignalSample& sample : block) look(sample);
            });
        else
            look(curve.source->inForceAt(out.fromTime));
    }
    return out;
}

std::optional<int> PlotRenderer::noteAt(const QPointF& point) const {
    for (const auto& [note, rect] : m_noteRects)
        if (rect.contains(point)) return note;
    return std::nullopt;
}

} // namespace plc::plot
