#include "editor/kit/plot_renderer.h"

#include "editor/kit/plot_table.h"
#include "editor/kit/plot_text.h"
#include "editor/kit/theme.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPaintEngine>

#include <cmath>

namespace plc::kit {

namespace {

constexpr double Pad = 8, LaneHeight = 28, LeastPlot = 48;

double laneHeightFor(const QFont& font) { return std::max(LaneHeight, QFontMetricsF(font).height() * 1.6); }

} // namespace

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
        PlotBucket bucket;
        kept.source->buckets(range->first, range->second + 1, std::span(&bucket, 1));
        if (bucket.isNumber && std::isfinite(bucket.minimum) && std::isfinite(bucket.maximum))
            kept.whole = PlotRange{bucket.minimum, bucket.maximum};
        return kept.whole;
    }
};

bool isVectorPaper(const QPainter& painter) {
    const QPaintEngine* engine = painter.paintEngine();
    if (!engine) return false;
    switch (engine->type()) {
    case QPaintEngine::SVG:
    case QPaintEngine::Pdf:
    case QPaintEngine::Picture:
        return true;
    default:
        return false;
    }
}

namespace {

/// The plot area in the image that is painted on, when it is one and lies pixel on pixel.
PlotPixels directPixels(const QPainter& painter, const QRectF& area, double ratio) {
    QPaintDevice* device = painter.device();
    if (!device || device->devType() != QInternal::Image || painter.hasClipping()) return {};
    auto* image = static_cast<QImage*>(device);
    if (image->format() != QImage::Format_ARGB32_Premultiplied && image->format() != QImage::Format_RGB32) return {};
    const QTransform transform = painter.deviceTransform();
    if (transform.type() > QTransform::TxScale || std::abs(transform.m11() - ratio) > 1e-9 ||
        std::abs(transform.m22() - ratio) > 1e-9)
        return {};
    const QRectF mapped = transform.mapRect(area);
    const QRect pixels = mapped.toRect();
    if (std::abs(mapped.left() - pixels.left()) > 0.51 || !image->rect().contains(pixels)) return {};
    return {image, pixels};
}

} // namespace

PlotRenderer::PlotRenderer() = default;
PlotRenderer::~PlotRenderer() = default;

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
        const double room = range->high - range->low > size * 1e-9 ? (range->high - range->low) * 0.04
                            : size > 0                             ? size * 0.05
                                                                   : 1;
        return {range->low - room, range->high + room};
    }
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
            for (const PlotCurve* user : users)
                if (user->unit != unit) unit.clear();
        }
        if (title.isEmpty() && users.size() == 1) title = users[0]->name;
        const double room = height - metrics.horizontalAdvance(unit) * 1.1 - 30;
        if (metrics.horizontalAdvance(title) * 1.1 > room) // rather the unit alone than a torn name
            title = room > 90 ? metrics.elidedText(title, Qt::ElideMiddle, room * 0.9)
                              : QString(); // and rather none than its first letter
        spec.title = title.isEmpty() ? unit : unit.isEmpty() ? title : QStringLiteral("%1 [%2]").arg(title, unit);
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
    for (int i = 0; model.hasLegend && i < static_cast<int>(model.curves.size()); ++i) {
        const PlotCurve& curve = model.curves[static_cast<size_t>(i)];
        if (curve.chart != chart || (curve.style == CurveStyle::Digital && curve.isVisible)) continue;
        const QString text = curve.unit.isEmpty() ? curve.name : QStringLiteral("%1 [%2]").arg(curve.name, curve.unit);
        const double wide = std::min(metrics.horizontalAdvance(text) + 34, width);
        if (x + wide > left + width && x > left) {
            x = left;
            y += rowHeight;
        }
        if (place) m_legend.push_back({QRectF(x, y, wide, rowHeight), i});
        x += wide + 10;
        any = true;
    }
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
    const QRectF inner = rect.adjusted(Pad, Pad, -Pad, -Pad);
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
            if (first) used += legends[static_cast<size_t>(m_panes[i].chart)];
            if (m_panes[i].isLanes)
                lanes += static_cast<int>(m_panes[i].curves.size());
            else
                weights += std::max(0.05, model.charts[static_cast<size_t>(m_panes[i].chart)].weight);
        }
        const double free = std::max(0.0, bottom - top - used);
        double laneHeight = weights > 0 ? lane : std::clamp(lanes > 0 ? free / lanes : lane, lane * 0.6, lane * 2);
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
        left = std::ceil(left / 8) * 8; // so that a digit more does not shift the picture
        right = std::ceil(std::max({10.0, right, m_timeLabel / 2 - Pad + 4}) / 8) * 8;
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
        if (first) y += legendHeight(model, m_panes[i].chart, inner.left() + left, width, y, true);
        y += room[i].top() + (i > 0 && !first ? 4 : 0);
        m_parts[i]->axes.place(QRectF(std::round(inner.left() + left), std::round(y), width, heights[i]));
        m_panes[i].area = m_parts[i]->axes.area();
        y += heights[i] + room[i].bottom() + (first ? 4 : 0);
    }
}

void PlotRenderer::paintLegend(QPainter& painter, const PlotModel& model) {
    const ThemeColors& c = colors();
    const QFontMetricsF metrics(m_font);
    painter.setFont(m_font);
    QFont bold = m_font;
    bold.setWeight(QFont::DemiBold);
    for (const auto& [chart, rect] : m_chartTitles) {
        painter.setFont(bold);
        painter.setPen(c.text);
        painter.drawText(rect, Qt::AlignVCenter | Qt::AlignLeft, model.charts[static_cast<size_t>(chart)].title);
    }
    painter.setFont(m_font);
    for (const LegendEntry& entry : m_legend) {
        const PlotCurve& curve = model.curves[static_cast<size_t>(entry.curve)];
        const double middle = entry.rect.center().y();
        QColor color = curve.color;
        if (!curve.isVisible) color.setAlphaF(0.3f);
        if (curve.id == model.selected && !curve.id.isEmpty()) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(c.hover);
            painter.drawRoundedRect(entry.rect.adjusted(0, 1, 0, -1), 4, 4);
        }
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(color, std::clamp(curve.width + 0.6, 2.0, 4.0), Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(entry.rect.left() + 6, middle), QPointF(entry.rect.left() + 22, middle));
        painter.setPen(!curve.isVisible ? c.disabled : curve.problem.isEmpty() ? c.text : c.bad);
        const QString text = curve.unit.isEmpty() ? curve.name : QStringLiteral("%1 [%2]").arg(curve.name, curve.unit);
        painter.drawText(entry.rect.adjusted(28, 0, -2, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         metrics.elidedText(text, Qt::ElideMiddle, entry.rect.width() - 30));
    }
}

void PlotRenderer::paintPane(QPainter& painter, const PlotModel& model, size_t index) {
    const PlotPane& pane = m_panes[index];
    PaneParts& parts = *m_parts[index];
    const ThemeColors& c = colors();
    std::vector<PlotGap> gaps; // those that all curves of the pane share are shaded across it
    bool allHaveGaps = !pane.curves.empty();
    for (size_t i = 0; i < pane.curves.size(); ++i) {
        const auto& own = parts.kept[i][0].shape.gaps;
        if (own.empty())
            allHaveGaps = false;
        else if (gaps.empty())
            gaps = own;
    }
    if (allHaveGaps) drawGaps(painter, gaps, mapping(model, pane), m_font);
    parts.axes.paint(painter);

    if (pane.isLanes) {
        const double lane = pane.area.height() / static_cast<double>(pane.curves.size());
        for (size_t i = 0; i < pane.curves.size(); ++i) {
            const PlotCurve& curve = model.curves[static_cast<size_t>(pane.curves[i])];
            PlotMapping map = mapping(model, pane);
            map.ratio = isVectorPaper(painter) ? 0 : m_ratio;
            map.area =
                QRectF(pane.area.left(), pane.area.top() + lane * static_cast<double>(i), pane.area.width(), lane);
            if (!allHaveGaps) drawGaps(painter, parts.kept[i][0].shape.gaps, map, m_font);
            if (i > 0) {
                painter.setRenderHint(QPainter::Antialiasing, false);
                painter.setPen(QPen(c.plotGrid, 1));
                painter.drawLine(map.area.topLeft(), map.area.topRight());
            }
            for (size_t b = parts.kept[i].size(); b-- > 1;) {
                QColor faint = curve.color;
                faint.setAlphaF(0.3f);
                if (parts.kept[i][b].source) drawLane(painter, parts.kept[i][b].shape, curve, map, faint, m_font);
            }
            if (curve.source) drawLane(painter, parts.kept[i][0].shape, curve, map, curve.color, m_font);
        }
        return;
    }

    // Curves go straight into the picture where the paper is one; on other screens by way of a layer.
    QImage layer;
    PlotPixels pixels = directPixels(painter, pane.area, m_ratio);
    const bool vector = isVectorPaper(painter), hasLayer = !vector && !pixels.image;
    if (hasLayer) {
        const QSize size(std::max(1, static_cast<int>(std::lround(pane.area.width() * m_ratio))),
                         std::max(1, static_cast<int>(std::lround(pane.area.height() * m_ratio))));
        layer = QImage(size, QImage::Format_ARGB32_Premultiplied);
        layer.fill(Qt::transparent);
        pixels = {&layer, layer.rect()};
    }
    size_t samples = 0;
    for (const auto& owned : m_parts)
        for (const auto& kept : owned->kept)
            for (const PaneParts::Kept& k : kept) samples += k.shape.isExact ? k.shape.samples.size() : m_fineSamples;
    pixels.finely = samples <= m_fineSamples ? m_fineSamples : 600;
    bool layerUsed = false;
    auto flush = [&] { // keeps the order of curves drawn in the two ways
        if (!layerUsed) return;
        painter.drawImage(pane.area, layer);
        layer.fill(Qt::transparent);
        layerUsed = false;
    };
    for (size_t i = 0; i < pane.curves.size(); ++i) {
        const PlotCurve& curve = model.curves[static_cast<size_t>(pane.curves[i])];
        const auto at = std::find(pane.axes.begin(), pane.axes.end(), curve.axis);
        PlotMapping map = mapping(model, pane, at == pane.axes.end() ? 0 : static_cast<size_t>(at - pane.axes.begin()));
        map.ratio = vector ? 0 : m_ratio;
        for (size_t b = parts.kept[i].size(); b-- > 0;) {
            const PaneParts::Kept& kept = parts.kept[i][b];
            if (!kept.source) continue;
            QColor color = curve.color;
            if (b > 0) color.setAlphaF(0.35f);
            const bool few = isDrawnByPainter(kept.shape, pixels);
            if (few) flush();
            drawCurve(painter, kept.shape, curve, map, color, pixels);
            layerUsed = layerUsed || (!few && hasLayer);
        }
    }
    flush();
}

void PlotRenderer::paintVertical(QPainter& painter, double x, const QPen& pen) {
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(pen);
    for (const PlotPane& pane : m_panes)
        if (x >= pane.area.left() - 0.5 && x <= pane.area.right() + 0.5)
            painter.drawLine(QPointF(x, pane.area.top()), QPointF(x, pane.area.bottom()));
}

void PlotRenderer::paintMarkers(QPainter& painter, const PlotModel& model) {
    if (m_panes.empty()) return;
    const QFontMetricsF metrics(m_font);
    const PlotMapping map = mapping(model, m_panes.front());
    const QRectF area = m_panes.front().area;
    double freeFrom = area.left();
    for (const PlotMarker& marker : model.markers) {
        if (marker.time < model.from || marker.time > model.to) continue;
        const double x = std::round(map.xOf(marker.time)) + 0.5;
        QColor line = markerColor(marker.kind);
        QPen pen(line, 1, Qt::DashLine);
        paintVertical(painter, x, pen);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(line);
        painter.drawPolygon(QPolygonF({{x - 4.5, area.top()}, {x + 4.5, area.top()}, {x, area.top() + 7}}));
        const double wide = metrics.horizontalAdvance(marker.text) + 8;
        if (marker.text.isEmpty() || x + 6 < freeFrom || x + 6 + wide > area.right()) continue;
        painter.setFont(m_font);
        const QRectF label(x + 6, area.top() + 1, wide, metrics.height());
        QColor ground = colors().plotGround;
        ground.setAlphaF(0.85f);
        painter.fillRect(label, ground);
        painter.setPen(line);
        painter.drawText(label, Qt::AlignCenter, marker.text);
        freeFrom = label.right() + 6;
    }
    if (model.trigger && *model.trigger >= model.from && *model.trigger <= model.to) {
        const double x = std::round(map.xOf(*model.trigger)) + 0.5;
        paintVertical(painter, x, QPen(colors().plotTrigger, 1.4, Qt::DashDotLine));
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors().plotTrigger);
        const QRectF tag(x - 8, area.bottom() - 16, 16, 15);
        painter.drawRoundedRect(tag, 3, 3);
        QFont bold = m_font;
        bold.setBold(true);
        painter.setFont(bold);
        painter.setPen(colors().plotGround);
        painter.drawText(tag, Qt::AlignCenter, QStringLiteral("T"));
    }
    if (model.present && *model.present >= model.from && *model.present <= model.to)
        paintVertical(painter, std::round(map.xOf(*model.present)) + 0.5, QPen(colors().accent, 2));
}

void PlotRenderer::paintCursorLine(QPainter& painter, const PlotModel& model, int64_t time, Qt::PenStyle style) {
    const ThemeColors& c = colors();
    const double x = std::round(mapping(model, m_panes.front()).xOf(time)) + 0.5;
    paintVertical(painter, x, QPen(c.plotCursor, 1, style));
    painter.setRenderHint(QPainter::Antialiasing);
    for (const PlotPane& pane : m_panes) {
        if (pane.isLanes) continue;
        for (int i : pane.curves) {
            const PlotCurve& curve = model.curves[static_cast<size_t>(i)];
            if (!curve.source) continue;
            const auto sample = curve.source->inForceAt(time);
            if (!sample || std::isnan(sample->value)) continue;
            const auto at = std::find(pane.axes.begin(), pane.axes.end(), curve.axis);
            const double y =
                mapping(model, pane, at == pane.axes.end() ? 0 : static_cast<size_t>(at - pane.axes.begin()))
                    .yOf(curve.shown(sample->value));
            if (y < pane.area.top() || y > pane.area.bottom()) continue;
            painter.setPen(QPen(c.plotGround, 1.5));
            painter.setBrush(curve.color);
            painter.drawEllipse(QPointF(x, y), 4.2, 4.2);
        }
    }
}

void PlotRenderer::paintCursors(QPainter& painter, const PlotModel& model) {
    if (m_panes.empty()) return;
    const ThemeColors& c = colors();
    const QFontMetricsF metrics(m_font);
    const QRectF area = m_panes.front().area;
    const PlotMapping map = mapping(model, m_panes.front());
    QRectF before;
    auto cursor = [&](int64_t time, const QString& name, Qt::PenStyle style) {
        if (time < model.from || time > model.to) return;
        paintCursorLine(painter, model, time, style);
        const double x = std::round(map.xOf(time)) + 0.5;
        const QString text = QStringLiteral("%1  %2").arg(name, momentText(time - model.origin));
        const double row = metrics.height() + 5;
        QRectF tag(x + 3, area.top() + 3 + (model.markers.empty() ? 0 : row), metrics.horizontalAdvance(text) + 12,
                   metrics.height() + 3);
        if (tag.right() > area.right()) tag.moveRight(x - 3);
        if (tag.intersects(before)) tag.translate(0, row);
        before = tag;
        painter.setPen(Qt::NoPen);
        painter.setBrush(c.plotCursor);
        painter.drawRoundedRect(tag, 3, 3);
        painter.setPen(c.plotGround);
        painter.setFont(m_font);
        painter.drawText(tag, Qt::AlignCenter, text);
    };
    if (model.cursorA) cursor(*model.cursorA, QStringLiteral("A"), Qt::SolidLine);
    if (model.cursorB) cursor(*model.cursorB, QStringLiteral("B"), Qt::DashLine);
}

void PlotRenderer::paintBase(QPainter& painter, const PlotModel& model, const QRectF& rect) {
    layOut(model, rect);
    painter.save();
    painter.fillRect(rect, colors().plotGround);
    if (!m_titleRect.isNull()) {
        QFont title = m_font;
        title.setPointSizeF(m_font.pointSizeF() * 1.2);
        title.setWeight(QFont::DemiBold);
        painter.setFont(title);
        painter.setPen(colors().text);
        painter.drawText(m_titleRect, Qt::AlignVCenter | Qt::AlignHCenter,
                         QFontMetricsF(title).elidedText(model.title, Qt::ElideRight, m_titleRect.width()));
    }
    for (size_t i = 0; i < m_panes.size(); ++i) paintPane(painter, model, i);
    paintLegend(painter, model);
    if (!m_panes.empty()) {
        QFont bold = m_font;
        bold.setWeight(QFont::DemiBold);
        painter.setFont(bold);
        painter.setPen(colors().muted);
        const double bottom = m_tableRect.isNull() ? rect.bottom() - Pad : m_tableRect.top() - 8,
                     height = QFontMetricsF(m_font).height();
        painter.drawText(QRectF(m_panes.back().area.left(), bottom - height, m_panes.back().area.width(), height),
                         Qt::AlignCenter, m_timeTitle);
    }
    painter.restore();
}

void PlotRenderer::paintOverlay(QPainter& painter, const PlotModel& model) {
    painter.save();
    paintMarkers(painter, model);
    paintCursors(painter, model);
    if (!m_tableRect.isNull()) paintMeasureTable(painter, m_tableRect, model, m_font);
    painter.restore();
}

void PlotRenderer::paint(QPainter& painter, const PlotModel& model, const QRectF& rect) {
    paintBase(painter, model, rect);
    paintOverlay(painter, model);
}

const PlotPane* PlotRenderer::paneAt(const QPointF& point) const {
    for (const PlotPane& pane : m_panes)
        if (pane.area.contains(point)) return &pane;
    return nullptr;
}

PlotMapping PlotRenderer::mapping(const PlotModel& model, const PlotPane& pane, size_t axis) const {
    return {pane.area, model.from, std::max(model.to, model.from + 1),
            axis < pane.ranges.size() ? pane.ranges[axis] : PlotRange{}};
}

std::optional<int> PlotRenderer::legendAt(const QPointF& point) const {
    for (const LegendEntry& entry : m_legend)
        if (entry.rect.contains(point)) return entry.curve;
    return std::nullopt;
}

std::optional<int> PlotRenderer::laneAt(const QPointF& point) const {
    for (const PlotPane& pane : m_panes) {
        if (!pane.isLanes || point.y() < pane.area.top() || point.y() >= pane.area.bottom()) continue;
        const auto lane = static_cast<size_t>((point.y() - pane.area.top()) / pane.area.height() *
                                              static_cast<double>(pane.curves.size()));
        return pane.curves[std::min(lane, pane.curves.size() - 1)];
    }
    return std::nullopt;
}

std::optional<std::pair<int, int>> PlotRenderer::axisAt(const QPointF& point) const {
    for (const PlotPane& pane : m_panes) {
        if (pane.isLanes || pane.axes.empty() || point.y() < pane.area.top() || point.y() > pane.area.bottom())
            continue;
        if (point.x() < pane.area.left() && point.x() >= m_rect.left()) return std::pair(pane.chart, pane.axes.front());
        if (point.x() > pane.area.right() && point.x() <= m_rect.right())
            return std::pair(pane.chart, pane.axes.back());
    }
    return std::nullopt;
}

std::optional<int> PlotRenderer::markerAt(const PlotModel& model, const QPointF& point) const {
    if (m_panes.empty()) return std::nullopt;
    const QRectF area = m_panes.front().area;
    if (point.y() < area.top() || point.y() > area.top() + 12) return std::nullopt;
    const PlotMapping map = mapping(model, m_panes.front());
    for (size_t i = 0; i < model.markers.size(); ++i)
        if (std::abs(map.xOf(model.markers[i].time) - point.x()) <= 6) return static_cast<int>(i);
    return std::nullopt;
}

QRectF PlotRenderer::plotArea() const {
    return m_panes.empty() ? QRectF() : QRectF(m_panes.front().area.topLeft(), m_panes.back().area.bottomRight());
}

} // namespace plc::kit
