#include "editor/plot/painting/plot_axes.h"

#include "editor/kit/theme.h"

#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLegend>
#include <QPainter>

#include <set>

namespace plc::plot {

bool AxisSpec::operator==(const AxisSpec& o) const {
    if (low != o.low || high != o.high || title != o.title || color != o.color || isOnRight != o.isOnRight ||
        hasGrid != o.hasGrid || ticks.size() != o.ticks.size())
        return false;
    for (size_t i = 0; i < ticks.size(); ++i)
        if (ticks[i].value != o.ticks[i].value || ticks[i].label != o.ticks[i].label) return false;
    return true;
}

struct PlotAxes::Parts {
    QGraphicsScene scene;
    QChart* chart = nullptr;
    QCategoryAxis* time = nullptr;
    std::vector<QCategoryAxis*> values;
    AxisSpec timeSpec;
    bool timeLabels = true, grid = true;
    const kit::ThemeColors* styledFor = nullptr;
    std::vector<AxisSpec> valueSpecs;
    QFont font;
    bool marginsKnown = false;
    QMarginsF margins;

    void style(QCategoryAxis& axis, const AxisSpec& spec) {
        const kit::ThemeColors& c = kit::colors();
        const QColor ink = spec.color.isValid() ? spec.color : c.muted;
        // A chart whose times are written below another one keeps small unseen labels: without their room Qt Charts
        // hides the lowest label of the value axes.
        const bool unseen = &axis == time && !timeLabels;
        QFont labels = font;
        if (unseen) labels.setPointSizeF(std::max(1.0, font.pointSizeF() * 0.55));
        axis.setLabelsFont(labels);
        QFont title = font;
        title.setWeight(QFont::DemiBold);
        axis.setTitleFont(title);
        axis.setLabelsBrush(unseen ? QBrush(Qt::transparent) : QBrush(ink));
        axis.setTitleBrush(ink);
        axis.setLinePen(QPen(c.plotAxis, 1));
        axis.setGridLinePen(QPen(c.plotGrid, 1));
        axis.setGridLineVisible(grid && spec.hasGrid);
        axis.setTitleText(&axis == time ? QString() : spec.title.toHtmlEscaped());
    }
    void fill(QCategoryAxis& axis, const AxisSpec& spec) {
        for (const QString& label : axis.categoriesLabels()) axis.remove(label);
        axis.setRange(spec.low, spec.high);
        axis.setStartValue(spec.low - (spec.high - spec.low)); // else the label at the lower limit is not shown
        std::set<QString> used;
        for (const PlotTick& tick : spec.ticks) {
            if (tick.value < spec.low || tick.value > spec.high) continue;
            QString label = tick.label.toHtmlEscaped();
            while (!used.insert(label).second || label.isEmpty()) label += QChar(0x200b); // labels must differ
            axis.append(label, tick.value);
        }
    }
    QCategoryAxis* make(Qt::Alignment side) {
        auto* axis = new QCategoryAxis;
        axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
        axis->setTruncateLabels(false);
        chart->addAxis(axis, side);
        return axis;
    }
    void restyle() {
        if (styledFor == &kit::colors()) return;
        styledFor = &kit::colors();
        style(*time, timeSpec);
        for (size_t i = 0; i < values.size(); ++i) style(*values[i], valueSpecs[i]);
    }
};

PlotAxes::PlotAxes() : m(std::make_unique<Parts>()) {
    m->chart = new QChart;
    m->chart->setAnimationOptions(QChart::NoAnimation);
    m->chart->legend()->hide();
    m->chart->setBackgroundVisible(false);
    m->chart->setPlotAreaBackgroundVisible(false);
    m->chart->setMargins(QMargins());
    m->chart->layout()->setContentsMargins(0, 0, 0, 0);
    m->scene.addItem(m->chart);
    m->time = m->make(Qt::AlignBottom);
}

PlotAxes::~PlotAxes() = default;

void PlotAxes::setFont(const QFont& font) {
    if (m->font == font && m->styledFor) return;
    m->font = font;
    m->styledFor = nullptr;
    m->marginsKnown = false;
}

void PlotAxes::setTimeAxis(const AxisSpec& spec, bool hasLabels) {
    const bool sameForm = m->timeLabels == hasLabels && m->styledFor;
    if (sameForm && m->timeSpec == spec) return;
    m->timeSpec = spec;
    m->timeLabels = hasLabels;
    m->fill(*m->time, spec);
    if (sameForm) return;
    m->marginsKnown = false;
    m->style(*m->time, spec);
}

void PlotAxes::setValueAxes(const std::vector<AxisSpec>& specs) {
    if (m->valueSpecs == specs) return;
    bool sameSides = specs.size() == m->valueSpecs.size();
    for (size_t i = 0; sameSides && i < specs.size(); ++i) sameSides = specs[i].isOnRight == m->valueSpecs[i].isOnRight;
    if (!sameSides) {
        for (QCategoryAxis* axis : m->values) {
            axis->setVisible(
                false); // what it drew is only deleted by the event loop, which the command line does not run
            m->chart->removeAxis(axis);
            delete axis;
        }
        m->values.clear();
        for (const AxisSpec& spec : specs)
            m->values.push_back(m->make(spec.isOnRight ? Qt::AlignRight : Qt::AlignLeft));
    }
    const std::vector<AxisSpec> before = std::exchange(m->valueSpecs, specs);
    for (size_t i = 0; i < specs.size(); ++i) {
        if (sameSides && before[i] == specs[i]) continue;
        m->fill(*m->values[i], specs[i]);
        if (!sameSides || before[i].title != specs[i].title || before[i].color != specs[i].color ||
            before[i].hasGrid != specs[i].hasGrid)
            m->style(*m->values[i], specs[i]);
    }
    m->marginsKnown = false;
}

void PlotAxes::setGridVisible(bool visible) {
    if (m->grid == visible) return;
    m->grid = visible;
    m->styledFor = nullptr;
}

QMarginsF PlotAxes::margins() {
    if (m->marginsKnown) return m->margins;
    m->restyle();
    const QRectF probe(0, 0, 1200, 600);
    m->chart->setGeometry(probe);
    m->chart->layout()->activate();
    const QRectF area = m->chart->plotArea();
    m->margins = QMarginsF(area.left(), area.top(), probe.right() - area.right(), probe.bottom() - area.bottom());
    m->marginsKnown = true;
    return m->margins;
}

void PlotAxes::place(const QRectF& area) {
    m->chart->setGeometry(area.marginsAdded(margins()));
    m->chart->layout()->activate();
}

QRectF PlotAxes::area() const { return m->chart->plotArea().translated(m->chart->geometry().topLeft()); }

void PlotAxes::paint(QPainter& painter) {
    m->restyle();
    // Labels at the limits reach a little beyond the chart's own rectangle.
    const QRectF rect = m->chart->geometry().adjusted(-40, -12, 40, 12);
    m->scene.setSceneRect(rect);
    m->scene.render(&painter, rect, rect);
}

} // namespace plc::plot
