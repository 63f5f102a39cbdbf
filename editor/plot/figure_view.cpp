#include "editor/plot/figure_view.h"

#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace plc::plot {

namespace {

constexpr double kReach = 14; // pixels within which a point is taken

} // namespace

FigureView::FigureView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&kit::Theme::current(), &kit::Theme::changed, this, qOverload<>(&QWidget::update));
}

void FigureView::setFigure(Figure figure) {
    const auto titleOf = [](const Figure& f, size_t i) { return f.charts[i].title + "|" + f.charts[i].xTitle; };
    bool isSame = figure.charts.size() == m_figure.charts.size();
    for (size_t i = 0; isSame && i < figure.charts.size(); ++i) isSame = titleOf(figure, i) == titleOf(m_figure, i);
    m_figure = std::move(figure);
    if (!isSame) { // another kind of chart; what grows keeps its zoom
        m_zoom = {};
        m_ruler.reset();
    }
    setAccessibleName(m_figure.charts.empty() ? m_figure.empty : kit::fromView(m_figure.charts.front().title));
    update();
}

void FigureView::setChart(waveform::Chart chart) { setFigure({{std::move(chart)}, {}}); }

void FigureView::fit() {
    m_zoom = {};
    update();
}

void FigureView::setMeasures(bool measures) {
    m_measures = measures;
    if (!measures) m_ruler.reset();
    setCursor(measures ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

std::vector<FigureFrame> FigureView::frames() const { return framesOf(m_figure, rect(), font(), m_zoom); }

void FigureView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintFigure(painter, m_figure, rect(), font(), m_zoom, m_ruler);
    if (m_drag != Drag::Box) return;
    QColor ground = kit::colors().accent;
    painter.setPen(ground);
    ground.setAlphaF(0.15f);
    painter.setBrush(ground);
    painter.drawRect(QRectF(m_dragFrom, m_dragAt).normalized());
}

std::optional<size_t> FigureView::chartAt(const QPointF& place) const {
    const std::vector<FigureFrame> all = frames();
    for (size_t i = 0; i < all.size(); ++i)
        if (all[i].area.contains(place)) return i;
    return std::nullopt;
}

FigurePoint FigureView::pointAt(const QPointF& place) const {
    const std::vector<FigureFrame> all = frames();
    if (const auto near = nearestPoint(m_figure, all, place, kReach)) return *near;
    const size_t chart = chartAt(place).value_or(m_ruler ? m_ruler->from.chart : 0);
    if (chart >= all.size()) return {};
    return {chart, all[chart].xAt(place.x()), all[chart].yAt(place.y())};
}

void FigureView::setZoomY(size_t chart, PlotRange range) {
    if (m_zoom.y.size() <= chart) m_zoom.y.resize(chart + 1);
    m_zoom.y[chart] = range;
}

void FigureView::mousePressEvent(QMouseEvent* event) {
    if (!chartAt(event->position()) || m_figure.isEmpty()) return;
    m_dragFrom = m_dragAt = event->position();
    if (event->button() == Qt::MiddleButton) {
        m_drag = Drag::Pan;
    } else if (event->button() == Qt::LeftButton) {
        m_drag = m_measures || event->modifiers().testFlag(Qt::ShiftModifier) ? Drag::Ruler : Drag::Box;
        if (m_drag == Drag::Ruler) m_ruler = FigureRuler{pointAt(m_dragFrom), pointAt(m_dragFrom)};
    }
    update();
}

void FigureView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF place = event->position();
    switch (m_drag) {
    case Drag::None:
        return showValues(place, event->globalPosition().toPoint());
    case Drag::Box:
        m_dragAt = place;
        break;
    case Drag::Pan:
        pan(place - m_dragFrom);
        m_dragFrom = place;
        break;
    case Drag::Ruler:
        if (const FigurePoint to = pointAt(place); to.chart == m_ruler->from.chart) m_ruler->to = to;
        break;
    }
    update();
}

void FigureView::mouseReleaseEvent(QMouseEvent* event) {
    const Drag drag = std::exchange(m_drag, Drag::None);
    constexpr double kClick = 6; // it measures nothing
    if (drag == Drag::Ruler && (event->position() - m_dragFrom).manhattanLength() < kClick) m_ruler.reset();
    if (drag == Drag::Box) zoomTo(QRectF(m_dragFrom, m_dragAt).normalized());
    update();
}

/// Flat boxes zoom in on x, upright ones on y.
void FigureView::zoomTo(const QRectF& box) {
    constexpr double kLeast = 6;
    const auto chart = chartAt(m_dragFrom);
    if (!chart || (box.width() < kLeast && box.height() < kLeast)) return;
    const FigureFrame frame = frames()[*chart];
    if (box.width() >= kLeast) m_zoom.x = PlotRange{frame.xAt(box.left()), frame.xAt(box.right())};
    if (box.height() >= 3 * kLeast || box.width() < kLeast)
        setZoomY(*chart, {frame.yAt(box.bottom()), frame.yAt(box.top())});
}

void FigureView::zoomAbout(const QPointF& place, double factor, bool onX, bool onY) {
    const auto chart = chartAt(place);
    if (!chart) return;
    const FigureFrame frame = frames()[*chart];
    const auto about = [factor](double low, double high, double at) {
        return std::pair(at + (low - at) * factor, at + (high - at) * factor);
    };
    if (onX) {
        const auto [left, right] = about(frame.area.left(), frame.area.right(), place.x());
        m_zoom.x = PlotRange{frame.xAt(left), frame.xAt(right)};
    }
    if (onY) {
        const auto [top, bottom] = about(frame.area.top(), frame.area.bottom(), place.y());
        setZoomY(*chart, {frame.yAt(bottom), frame.yAt(top)});
    }
    update();
}

void FigureView::pan(const QPointF& by) {
    const auto chart = chartAt(m_dragFrom);
    if (!chart) return;
    const FigureFrame frame = frames()[*chart];
    m_zoom.x = PlotRange{frame.xAt(frame.area.left() - by.x()), frame.xAt(frame.area.right() - by.x())};
    setZoomY(*chart, {frame.yAt(frame.area.bottom() - by.y()), frame.yAt(frame.area.top() - by.y())});
}

void FigureView::mouseDoubleClickEvent(QMouseEvent*) { fit(); }

void FigureView::wheelEvent(QWheelEvent* event) {
    const double factor = std::pow(0.85, event->angleDelta().y() / 120.0);
    const bool onlyY = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool both = event->modifiers().testFlag(Qt::ControlModifier);
    zoomAbout(event->position(), factor, !onlyY, onlyY || both);
    event->accept();
}

void FigureView::keyPressEvent(QKeyEvent* event) {
    const std::vector<FigureFrame> all = frames();
    const QPointF middle = all.empty() ? QPointF() : all.front().area.center();
    switch (event->key()) {
    case Qt::Key_Home:
        return fit();
    case Qt::Key_Plus:
        return zoomAbout(middle, 0.8, true, false);
    case Qt::Key_Minus:
        return zoomAbout(middle, 1.25, true, false);
    case Qt::Key_Escape:
        if (!m_ruler) break;
        m_ruler.reset();
        return update();
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void FigureView::contextMenuEvent(QContextMenuEvent* event) { emit menuRequested(event->globalPos()); }

void FigureView::showValues(const QPointF& place, const QPoint& global) {
    const auto chart = chartAt(place);
    if (!chart || m_figure.isEmpty()) return QToolTip::hideText();
    const waveform::Chart& shown = m_figure.charts[*chart];
    const auto near = nearestPoint(m_figure, frames(), place, kReach);
    const double at = near ? near->x : frames()[*chart].xAt(place.x());
    QStringList lines{QStringLiteral("%1: %2").arg(kit::fromView(shown.xTitle), valueText(at, 5))};
    constexpr qsizetype kMostLines = 12;
    for (const waveform::Curve& curve : shown.curves) {
        if (curve.name.empty() || curve.x.empty() || lines.size() > kMostLines) continue;
        if (!std::is_sorted(curve.x.begin(), curve.x.end())) { // one value over another: the point itself
            if (near) lines << QStringLiteral("%1: %2").arg(kit::fromView(curve.name), valueText(near->y, 5));
            continue;
        }
        auto next = std::lower_bound(curve.x.begin(), curve.x.end(), at);
        if (next == curve.x.end()) --next;
        const auto index = static_cast<size_t>(next - curve.x.begin());
        if (index < curve.y.size())
            lines << QStringLiteral("%1: %2").arg(kit::fromView(curve.name), valueText(curve.y[index], 5));
    }
    QToolTip::showText(global, lines.join(QLatin1Char('\n')), this);
}

} // namespace plc::plot
