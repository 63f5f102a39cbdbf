// Where everything of a plot lies: panes, the ranges and ticks of their axes, legends, lanes.
#include "editor/kit/curve_words.h"
#include "editor/plot/painting/plot_pane_parts.h"
#include "editor/plot/painting/plot_renderer.h"
#include "editor/plot/painting/plot_table.h"
#include "editor/plot/painting/plot_text.h"

#include <QFontMetricsF>

#include <cmath>

namespace plc::plot {

namespace {

constexpr double LaneHeight = 28, LeastPlot = 48;

double laneHeightFor(const QFont& font) { return std::max(LaneHeight, QFontMetricsF(font).height() * 1.6); }

/// Between the legend above a pane and its frame: half of the number at the uppermost tick stands there.
double roomForTopTick(const PlotPane& pane, double legend, const QFont& font, bool isTiny) {
    return pane.isLanes || legend <= 0 || isTiny ? 0 : std::ceil(QFontMetricsF(font).height() / 2);
}

} // namespace

void PlotRenderer::makePanes(const PlotModel& model) {
    std::vector<PlotPane> panes;
    for (int chart = 0; chart < static_cast<int>(model.charts.size()); ++chart) {
        PlotPane curves{chart, false, {}, {}, {}, {}}, lanes{chart, true, {}, {}, {}, {}};
        bool anyAnalogue = false;
        for (int i = 0; i < static_cast<int>(model.curves.size()); ++i) {
            const PlotCurve& curve = model.curves[static_cast<size_t>(i)];
            if (curve.chart != chart) continue;
            if (curve.style != CurveStyle::Digital) anyAnalogue = true;
            if (curve.isVisible) (curve.style == CurveStyle::Digital ? lanes : curves).curves.push_back(i);
        }
        // A chart whose curves are all switched off keeps its pane, or the plot would jump at every click on a legend.
        if (anyAnalogue || lanes.curves.empty()) panes.push_back(std::move(curves));
        if (!lanes.curves.empty()) panes.push_back(std::move(lanes));
    }
    m_panes = std::move(panes);
    while (m_parts.size() < m_panes.size()) m_parts.push_back(std::make_unique<PaneParts>());
    m_parts.resize(m_panes.size());
}

void PlotRenderer::makeShapes(const PlotModel& model, double width) {
    const int columns = std::max(1, static_cast<int>(std::lround(width * m_ratio)));
    for (size_t p = 0; p < m_panes.size(); ++p) {
        PaneParts& parts = *m_parts[p];
        parts.kept.resize(m_panes[p].curves.size());
        for (size_t i = 0; i < m_panes[p].curves.size(); ++i) {
            const PlotCurve& curve = model.curves[static_cast<size_t>(m_panes[p].curves[i])];
            auto& kept = parts.kept[i];
            kept.resize(1 + curve.beneath.size());
            if (curve.source)
                PaneParts::refresh(kept[0], *curve.source, 0, model.from, model.to, columns);
            else
                kept[0] = {};
            for (size_t b = 0; b < curve.beneath.size(); ++b) {
                if (curve.beneath[b].source)
                    PaneParts::refresh(kept[b + 1], *curve.beneath[b].source, curve.beneath[b].shift, model.from,
                                       model.to, columns);
                else
                    kept[b + 1] = {};
            }
        }
    }
}

PlotRange PlotRenderer::rangeOf(const PlotModel& model, const PlotPane& pane, int axisIndex) const {
    const PlotAxis& axis = model.charts[static_cast<size_t>(pane.chart)].axes[static_cast<size_t>(axisIndex)];
    if (axis.zoom && axis.zoom->low < axis.zoom->high) return *axis.zoom;
    if (axis.mode == AxisMode::Fixed && axis.fixed.low < axis.fixed.high) return axis.fixed;
    const size_t paneIndex = static_cast<size_t>(&pane - m_panes.data());
    std::optional<PlotRange> range;
    bool onlyBool = true;
    for (size_t i = 0; i < pane.curves.size(); ++i) {
        const PlotCurve& curve = model.curves[static_cast<size_t>(pane.curves[i])];
        if (curve.axis != axisIndex) continue;
        for (const PaneParts::Kept& kept : m_parts[paneIndex]->kept[i]) {
            // Fit follows what is in view; the other mode keeps still while one scrolls, so it asks for the whole
            // recording.
            const auto raw = axis.mode == AxisMode::Fit ? kept.shape.extent() : PaneParts::wholeExtent(kept);
            if (!raw) continue;
            onlyBool = onlyBool && curve.source && curve.source->valueKind() == PlotValueKind::Bool;
            const double a = curve.shown(raw->low), b = curve.shown(raw->high);
            if (!range) range = PlotRange{std::min(a, b), std::max(a, b)};
            range->low = std::min({range->low, a, b});
            range->high = std::max({range->high, a, b});
        }
    }
    if (!range) return {0, 1};
    if (axis.mode == AxisMode::Fit) {
        const double size = std::max(std::abs(range->low), std::abs(range->high));
        // A flat line in the middle of some room and not on the frame; of noise in the last digits no mountain is made.
        const double room = range->high - range->low > size * 1e-9 ? (range->high - range->low) * 0.04
                            : size > 0                             ? size * 0.05
                                                                   : 1;
        return {range->low - room, range->high + room};
    }
    // So that both levels are seen beside the frame.
    if (onlyBool) return {-0.1, 1.1};
    roundLimits(range->low, range->high, 6);
    return *range;
}

std::vector<AxisSpec> PlotRenderer::valueAxes(const PlotModel& model, PlotPane& pane, double height) {
    const PlotChart& chart = model.charts[static_cast<size_t>(pane.chart)];
    const QFontMetricsF metrics(m_font);
    std::vector<AxisSpec> specs;
    if (pane.isLanes) {
        AxisSpec spec;
        spec.low = 0;
        spec.high = static_cast<double>(pane.curves.size());
        spec.hasGrid = false;
        const double room = std::clamp(m_rect.width() * 0.24, 90.0, 240.0);
        for (size_t i = pane.curves.size(); i-- > 0;) { // from below, as axes count
            const QString& name = model.curves[static_cast<size_t>(pane.curves[i])].name;
            spec.ticks.push_back(
                {static_cast<double>(pane.curves.size() - i) - 0.5, metrics.elidedText(name, Qt::ElideMiddle, room)});
        }
        pane.axes = {0};
        pane.ranges = {PlotRange{spec.low, spec.high}};
        return {spec};
    }
    pane.axes.clear();
    pane.ranges.clear();
    for (int a = 0; a < static_cast<int>(chart.axes.size()); ++a)
        for (int i : pane.curves)
            if (model.curves[static_cast<size_t>(i)].axis == a) {
                pane.axes.push_back(a);
                break;
            }
    if (pane.axes.empty()) pane.axes.push_back(0);
    const int ticks = std::clamp(static_cast<int>(height / (metrics.height() * 2.2)), 2, 12);
    for (int a : pane.axes) {
        const PlotAxis& axis = chart.axes[static_cast<size_t>(a)];
        const PlotRange range = rangeOf(model, pane, a);
        pane.ranges.push_back(range);
        AxisSpec spec;
        spec.low = range.low;
        spec.high = range.high;
        spec.isOnRight = axis.isOnRight;
        spec.hasGrid = specs.empty();
        std::vector<const PlotCurve*> users;
        for (int i : pane.curves)
            if (model.curves[static_cast<size_t>(i)].axis == a) users.push_back(&model.curves[static_cast<size_t>(i)]);
        QString unit = axis.unit, title = axis.title;
        if (unit.isEmpty() && !users.empty()) {
            unit = users[0]->unit;
            // Curves of different units share an axis only by its numbers.
            for (const PlotCurve* user : users)
                if (user->unit != unit) unit.clear();
        }
        if (title.isEmpty() && users.size() == 1) title = users[0]->name;
        const double room = height - metrics.horizontalAdvance(unit) * 1.1 - 30;
        if (metrics.horizontalAdvance(title) * 1.1 > room) // rather the unit alone than a torn name
            title = room > 90 ? metrics.elidedText(title, Qt::ElideMiddle, room * 0.9)
                              : QString(); // and rather none than its first letter
        spec.title = title.isEmpty() ? unit : kit::withUnit(title, unit);
        if (users.size() == 1 && pane.axes.size() > 1) spec.color = users[0]->color;
        const bool named = !users.empty() && !users[0]->valueNames.empty() && users[0]->scale == 1 &&
                           users[0]->offset == 0 && std::all_of(users.begin(), users.end(), [&](const PlotCurve* u) {
                               return u->valueNames == users[0]->valueNames;
                           });
        if (named) {
            for (const auto& [value, name] : users[0]->valueNames)
                spec.ticks.push_back({static_cast<double>(value), metrics.elidedText(name, Qt::ElideRight, 140)});
        } else {
            // One number says nothing about the scale: rather two that stand close.
            for (int most = ticks; spec.ticks.size() < 2 && most <= ticks + 4; ++most)
                spec.ticks = numberTicks(range.low, range.high, most);
        }
        specs.push_back(std::move(spec));
    }
    return specs;
}

double PlotRenderer::legendHeight(const PlotModel& model, int chart, double left, double width, double top,
                                  bool place) {
    const QFontMetricsF metrics(m_font);
    const double rowHeight = metrics.height() + 6;
    double x = left, y = top;
    bool any = false;
    const QString& title = model.charts[static_cast<size_t>(chart)].title;
    if (!title.isEmpty()) {
        QFont bold = m_font;
        bold.setWeight(QFont::DemiBold);
        const double wide = QFontMetricsF(bold).horizontalAdvance(title);
        if (place) m_chartTitles.emplace_back(chart, QRectF(x, y, wide + 2, rowHeight));
        x += wide + 18;
        any = true;
    }
    const auto add = [&](const QString& text, int curve) {
        const double wide = std::min(metrics.horizontalAdvance(text) + 34, width);
        if (x + wide > left + width && x > left) {
            x = left;
            y += rowHeight;
        }
        if (place) m_legend.push_back({QRectF(x, y, wide, rowHeight), curve});
        x += wide + 10;
        any = true;
    };
    for (int i = 0; model.hasLegend && !m_isTiny && i < static_cast<int>(model.curves.size()); ++i) {
        const PlotCurve& curve = model.curves[static_cast<size_t>(i)];
        if (curve.chart != chart || (curve.style == CurveStyle::Digital && curve.isVisible)) continue;
        add(kit::withUnit(curve.name, curve.unit), i);
    }
    if (model.hasLegend && chart == 0 && !model.beneathName.isEmpty()) add(model.beneathName, -1);
    return any ? y - top + rowHeight + 2 : 0;
}

void PlotRenderer::placeTimeAxis(const PlotModel& model, double width) {
    const QFontMetricsF metrics(m_font);
    // As many labels as fit with air between them; the label's width depends on the step, so ask twice.
    int most = std::max(2, static_cast<int>(width / 90));
    for (int round = 0; round < 2; ++round) {
        const TimeTicks ticks = timeTicks(model.from, model.to, model.origin, most);
        const double label = metrics.horizontalAdvance(widestTimeLabel(model.from, model.to, model.origin, ticks.step));
        most = std::clamp(static_cast<int>(width / std::max(60.0, label + 28)), 1, 24);
        m_timeLabel = label;
    }
    const TimeTicks ticks = timeTicks(model.from, model.to, model.origin, most);
    AxisSpec spec;
    spec.low = 0;
    spec.high = static_cast<double>(model.to - model.from) / 1e9;
    m_timeTitle = model.origin == 0 || !model.trigger ? PlotText::tr("Time [%1]").arg(ticks.unit)
                                                      : PlotText::tr("Time from the trigger [%1]").arg(ticks.unit);
    if (m_isLow) m_timeTitle.clear();
    for (const auto& [time, label] : ticks.ticks)
        spec.ticks.push_back({static_cast<double>(time - model.from) / 1e9, label});
    if (m_isLow && !spec.ticks.empty()) spec.ticks.back().label += QLatin1Char(' ') + ticks.unit;
    for (size_t i = 0; i < m_panes.size(); ++i) m_parts[i]->axes.setTimeAxis(spec, i + 1 == m_panes.size());
}

void PlotRenderer::layOut(const PlotModel& model, const QRectF& rect) {
    m_rect = rect;
    m_legend.clear();
    m_chartTitles.clear();
    makePanes(model);
    const QRectF inner = rect.adjusted(PlotPad, PlotPad, -PlotPad, -PlotPad);
    double top = inner.top(), bottom = inner.bottom();
    m_titleRect = m_tableRect = QRectF();
    // A low picture is for the curves: the title goes first, then that of the time axis, whose unit then stands at its
    // last number.
    const double line = QFontMetricsF(m_font).height();
    double wanted = 4 * line;
    for (const PlotPane& pane : m_panes)
        wanted += pane.isLanes ? laneHeightFor(m_font) * static_cast<double>(pane.curves.size()) + 2 * line : 7 * line;
    if (model.hasTable && (model.cursorA || model.cursorB)) wanted += measureTableHeight(model, m_font);
    m_isLow = inner.height() < wanted;
    m_isTiny = inner.height() < wanted * 0.7; // whoever looks has the list of channels beside it
    if (!model.title.isEmpty() && !m_isLow) {
        m_titleRect = QRectF(inner.left(), top, inner.width(), QFontMetricsF(m_font).height() * 1.5 + 4);
        top = m_titleRect.bottom() + 2;
    }
    if (model.hasTable && (model.cursorA || model.cursorB)) {
        const double height = measureTableHeight(model, m_font);
        m_tableRect = QRectF(inner.left(), bottom - height, inner.width(), height);
        bottom = m_tableRect.top() - 8;
    }
    if (!m_isLow) bottom -= line; // the time axis' title
    for (size_t i = 0; i < m_panes.size(); ++i) {
        m_parts[i]->axes.setFont(m_font);
        m_parts[i]->axes.setGridVisible(model.hasGrid);
    }

    // Heights: legends and lanes take what they need, the charts share the rest by weight.
    auto share = [&](const std::vector<double>& legends, const std::vector<QMarginsF>& room) {
        double used = 0, weights = 0;
        const double lane = laneHeightFor(m_font);
        int lanes = 0;
        for (size_t i = 0; i < m_panes.size(); ++i) {
            used += room[i].top() + room[i].bottom() + (i > 0 ? 4 : 0);
            const bool first = i == 0 || m_panes[i - 1].chart != m_panes[i].chart;
            const double legend = legends[static_cast<size_t>(m_panes[i].chart)];
            if (first) used += legend + roomForTopTick(m_panes[i], legend, m_font, m_isTiny);
            if (m_panes[i].isLanes)
                lanes += static_cast<int>(m_panes[i].curves.size());
            else
                weights += std::max(0.05, model.charts[static_cast<size_t>(m_panes[i].chart)].weight);
        }
        const double free = std::max(0.0, bottom - top - used);
        // Without curves the lanes have all the room.
        double laneHeight = weights > 0 || lanes == 0 ? lane : std::max(free / lanes, lane * 0.6);
        if (weights > 0 && lanes > 0) laneHeight = std::clamp((free - LeastPlot) / lanes, 12.0, lane);
        const double forCharts = std::max(LeastPlot, free - laneHeight * lanes);
        std::vector<double> heights;
        for (const PlotPane& pane : m_panes)
            heights.push_back(std::floor(
                pane.isLanes
                    ? laneHeight * static_cast<double>(pane.curves.size())
                    : forCharts * std::max(0.05, model.charts[static_cast<size_t>(pane.chart)].weight) / weights));
        return heights;
    };

    std::vector<double> legends;
    for (int chart = 0; chart < static_cast<int>(model.charts.size()); ++chart)
        legends.push_back(legendHeight(model, chart, 0, inner.width() - 60, 0, false));
    double width = m_width > 0 && m_width < inner.width() ? m_width : inner.width() - 60;
    std::vector<QMarginsF> room(m_panes.size(), QMarginsF(50, 2, 8, 8));
    if (!room.empty()) room.back().setBottom(44);
    double left = 0, right = 0;
    for (int round = 0; round < 2; ++round) {
        makeShapes(model, width);
        placeTimeAxis(model, width);
        const std::vector<double> heights = share(legends, room);
        left = right = 0;
        for (size_t i = 0; i < m_panes.size(); ++i) {
            m_parts[i]->axes.setValueAxes(valueAxes(model, m_panes[i], heights[i]));
            room[i] = m_parts[i]->axes.margins();
            left = std::max(left, room[i].left());
            right = std::max(right, room[i].right());
        }
        right = std::max(right, endLabelWidth(model, width));
        left = std::ceil(left / 8) * 8; // so that a digit more does not shift the picture
        right = std::ceil(std::max({10.0, right, m_timeLabel / 2 - PlotPad + 4}) / 8) * 8;
        // A digit less does not move the picture under the user's hand.
        if (left < m_left && m_left - left < 24) left = m_left;
        if (right < m_right && m_right - right < 24) right = m_right;
        const double now = std::floor(std::max(40.0, inner.width() - left - right));
        if (now == width) break;
        width = now;
        for (int chart = 0; chart < static_cast<int>(model.charts.size()); ++chart)
            legends[static_cast<size_t>(chart)] = legendHeight(model, chart, 0, width, 0, false);
    }
    m_left = left;
    m_right = right;
    m_width = width;
    makeShapes(model, width);
    placeTimeAxis(model, width);
    const std::vector<double> heights = share(legends, room);
    double y = top;
    for (size_t i = 0; i < m_panes.size(); ++i) {
        const bool first = i == 0 || m_panes[i - 1].chart != m_panes[i].chart;
        if (first) {
            const double legend = legendHeight(model, m_panes[i].chart, inner.left() + left, width, y, true);
            y += legend + roomForTopTick(m_panes[i], legend, m_font, m_isTiny);
        }
        y += room[i].top() + (i > 0 && !first ? 4 : 0);
        m_parts[i]->axes.place(QRectF(std::round(inner.left() + left), std::round(y), width, heights[i]));
        m_panes[i].area = m_parts[i]->axes.area();
        y += heights[i] + room[i].bottom() + (first ? 4 : 0);
    }
    placeEndLabels(model, width);
}

} // namespace plc::plot
