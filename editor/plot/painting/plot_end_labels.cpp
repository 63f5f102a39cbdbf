// The names of curves beside their ends, at the right of the plot, so that nobody has to carry a colour to the legend.
#include "editor/plot/painting/plot_pane_parts.h"
#include "editor/plot/painting/plot_renderer.h"

#include <QFontMetricsF>

#include <cmath>

namespace plc::plot {

namespace {

constexpr double LeastWidth = 420, MostLabel = 120, Lead = 12;

/// "i_rAct" of "Main.pid.i_rAct": the legend has the rest. An expression, INTEGRAL(Main.Flow), stays whole.
QString shortName(const QString& name) {
    const bool isExpression = name.contains(QLatin1Char(' ')) || name.contains(QLatin1Char('('));
    return isExpression ? name : name.section(QLatin1Char('.'), -1);
}

bool hasLabels(const PlotModel& model, const PlotPane& pane) {
    if (pane.isLanes || pane.curves.size() < 2) return false;
    for (const int axis : pane.axes)
        if (model.charts[static_cast<size_t>(pane.chart)].axes[static_cast<size_t>(axis)].isOnRight) return false;
    return true;
}

/// Moves labels apart that would lie over each other, none out of the area.
void spread(std::vector<EndLabel>& labels, const QRectF& area, double height) {
    std::sort(labels.begin(), labels.end(), [](const EndLabel& a, const EndLabel& b) { return a.from < b.from; });
    double next = area.top();
    for (EndLabel& label : labels) {
        label.rect.moveTop(std::max(next, label.from - height / 2));
        next = label.rect.bottom();
    }
    double last = area.bottom();
    for (size_t i = labels.size(); i-- > 0;) {
        if (labels[i].rect.bottom() > last) labels[i].rect.moveBottom(last);
        last = labels[i].rect.top();
    }
}

} // namespace

double PlotRenderer::endLabelWidth(const PlotModel& model, double width) const {
    if (!model.hasLegend || width < LeastWidth || m_isLow) return 0;
    const QFontMetricsF metrics(m_font);
    double widest = 0;
    for (const PlotPane& pane : m_panes) {
        if (!hasLabels(model, pane)) continue;
        for (const int i : pane.curves)
            widest = std::max(widest, metrics.horizontalAdvance(shortName(model.curves[static_cast<size_t>(i)].name)));
    }
    return widest > 0 ? std::min(widest + 2, MostLabel) + Lead : 0;
}

void PlotRenderer::placeEndLabels(const PlotModel& model, double width) {
    m_endLabels.clear();
    if (endLabelWidth(model, width) == 0) return;
    const QFontMetricsF metrics(m_font);
    const double height = metrics.height();
    for (const PlotPane& pane : m_panes) {
        if (!hasLabels(model, pane) || height * static_cast<double>(pane.curves.size()) > pane.area.height()) continue;
        std::vector<EndLabel> labels;
        for (const int i : pane.curves) {
            const PlotCurve& curve = model.curves[static_cast<size_t>(i)];
            const auto sample = curve.source ? curve.source->inForceAt(model.to) : std::nullopt;
            if (!sample || std::isnan(sample->value)) continue;
            const auto at = std::find(pane.axes.begin(), pane.axes.end(), curve.axis);
            const size_t axis = at == pane.axes.end() ? 0 : static_cast<size_t>(at - pane.axes.begin());
            const double y = std::clamp(mapping(model, pane, axis).yOf(curve.shown(sample->value)), pane.area.top(),
                                        pane.area.bottom());
            labels.push_back({QRectF(pane.area.right() + Lead, 0, MostLabel, height), y, i});
        }
        spread(labels, pane.area, height);
        m_endLabels.insert(m_endLabels.end(), labels.begin(), labels.end());
    }
}

void PlotRenderer::paintEndLabels(QPainter& painter, const PlotModel& model) {
    const QFontMetricsF metrics(m_font);
    painter.setFont(m_font);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const EndLabel& label : m_endLabels) {
        const PlotCurve& curve = model.curves[static_cast<size_t>(label.curve)];
        painter.setPen(QPen(curve.color, 1));
        painter.drawLine(QPointF(label.rect.left() - Lead + 1, label.from),
                         QPointF(label.rect.left() - 3, label.rect.center().y()));
        painter.setPen(curve.color);
        painter.drawText(label.rect, Qt::AlignVCenter | Qt::AlignLeft,
                         metrics.elidedText(shortName(curve.name), Qt::ElideRight, label.rect.width()));
    }
}

} // namespace plc::plot
