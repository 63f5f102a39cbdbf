#include "editor/plot/painting/plot_renderer.h"

#include "editor/kit/curve_words.h"
#include "editor/kit/theme.h"
#include "editor/plot/painting/plot_pane_parts.h"
#include "editor/plot/painting/plot_table.h"
#include "editor/plot/painting/plot_text.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPaintEngine>

#include <cmath>

namespace plc::plot {

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

void PlotRenderer::paintLegend(QPainter& painter, const PlotModel& model) {
    const kit::ThemeColors& c = kit::colors();
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
        if (entry.curve < 0) {
            paintLegendBeneath(painter, model, entry.rect);
            continue;
        }
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
        const QString text = kit::withUnit(curve.name, curve.unit);
        painter.drawText(entry.rect.adjusted(28, 0, -2, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         metrics.elidedText(text, Qt::ElideMiddle, entry.rect.width() - 30));
    }
}

/// A faint line: as what lies beneath is drawn, whatever the colour.
void PlotRenderer::paintLegendBeneath(QPainter& painter, const PlotModel& model, const QRectF& rect) {
    QColor faint = kit::colors().text;
    faint.setAlphaF(0.35f);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(faint, 2.2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(rect.left() + 6, rect.center().y()), QPointF(rect.left() + 22, rect.center().y()));
    painter.setPen(kit::colors().muted);
    painter.drawText(rect.adjusted(28, 0, -2, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     QFontMetricsF(m_font).elidedText(model.beneathName, Qt::ElideMiddle, rect.width() - 30));
}

void PlotRenderer::paintPane(QPainter& painter, const PlotModel& model, size_t index) {
    const PlotPane& pane = m_panes[index];
    PaneParts& parts = *m_parts[index];
    const kit::ThemeColors& c = kit::colors();
    std::vector<SignalGap> gaps; // those that all curves of the pane share are shaded across it
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
        QColor ground = kit::colors().plotGround;
        ground.setAlphaF(0.85f);
        painter.fillRect(label, ground);
        painter.setPen(line);
        painter.drawText(label, Qt::AlignCenter, marker.text);
        freeFrom = label.right() + 6;
    }
    if (model.trigger && *model.trigger >= model.from && *model.trigger <= model.to) {
        const double x = std::round(map.xOf(*model.trigger)) + 0.5;
        paintVertical(painter, x, QPen(kit::colors().plotTrigger, 1.4, Qt::DashDotLine));
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(kit::colors().plotTrigger);
        const QRectF tag(x - 8, area.bottom() - 16, 16, 15);
        painter.drawRoundedRect(tag, 3, 3);
        QFont bold = m_font;
        bold.setBold(true);
        painter.setFont(bold);
        painter.setPen(kit::colors().plotGround);
        painter.drawText(tag, Qt::AlignCenter, QStringLiteral("T"));
    }
    if (model.present && *model.present >= model.from && *model.present <= model.to)
        paintVertical(painter, std::round(map.xOf(*model.present)) + 0.5, QPen(kit::colors().accent, 2));
}

void PlotRenderer::paintCursorLine(QPainter& painter, const PlotModel& model, int64_t time, Qt::PenStyle style) {
    const kit::ThemeColors& c = kit::colors();
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
    const kit::ThemeColors& c = kit::colors();
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
    painter.fillRect(rect, kit::colors().plotGround);
    if (!m_titleRect.isNull()) {
        QFont title = m_font;
        title.setPointSizeF(m_font.pointSizeF() * 1.2);
        title.setWeight(QFont::DemiBold);
        painter.setFont(title);
        painter.setPen(kit::colors().text);
        painter.drawText(m_titleRect, Qt::AlignVCenter | Qt::AlignHCenter,
                         QFontMetricsF(title).elidedText(model.title, Qt::ElideRight, m_titleRect.width()));
    }
    for (size_t i = 0; i < m_panes.size(); ++i) paintPane(painter, model, i);
    paintLegend(painter, model);
    paintEndLabels(painter, model);
    if (!m_panes.empty()) {
        QFont bold = m_font;
        bold.setWeight(QFont::DemiBold);
        painter.setFont(bold);
        painter.setPen(kit::colors().muted);
        const double bottom = m_tableRect.isNull() ? rect.bottom() - PlotPad : m_tableRect.top() - 8,
                     height = QFontMetricsF(m_font).height();
        painter.drawText(QRectF(m_panes.back().area.left(), bottom - height, m_panes.back().area.width(), height),
                         Qt::AlignCenter, m_timeTitle);
    }
    painter.restore();
}

void PlotRenderer::paintOverlay(QPainter& painter, const PlotModel& model) {
    painter.save();
    paintMarkers(painter, model);
    paintNotes(painter, model);
    paintCursors(painter, model);
    paintRuler(painter, model);
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
        if (entry.curve >= 0 && entry.rect.contains(point)) return entry.curve;
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

} // namespace plc::plot
