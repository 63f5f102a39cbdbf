#include "editor/plot/plot_view.h"

#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/plot_export.h"

#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>

namespace plc::plot {

namespace {

constexpr int64_t LeastSpan = 20, GreatestSpan = int64_t(20) * 365 * 86'400 * 1'000'000'000;
constexpr double CursorReach = 5, BoxReach = 6;
constexpr double RulerReach = 14; // pixels within which a sample is taken

} // namespace

PlotView::PlotView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setMinimumSize(200, 120);
    setAccessibleName(tr("Chart"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&kit::Theme::current(), &kit::Theme::changed, this, &PlotView::markDirty);
}

PlotView::~PlotView() = default;

void PlotView::markDirty() {
    m_dirty = true;
    update();
}

void PlotView::edit(const std::function<void(PlotModel&)>& change) {
    change(m_model);
    if (m_model.to <= m_model.from) m_model.to = m_model.from + 1;
    markDirty();
}

PlotMapping PlotView::timeMapping() const {
    if (m_renderer.panes().empty()) return {QRectF(rect()), m_model.from, m_model.to, {}};
    return m_renderer.mapping(m_model, m_renderer.panes().front());
}

PlotView::Past PlotView::present() const {
    Past past{m_model.from, m_model.to, {}};
    for (const PlotChart& chart : m_model.charts) {
        past.zooms.emplace_back();
        for (const PlotAxis& axis : chart.axes) past.zooms.back().push_back(axis.zoom);
    }
    return past;
}

void PlotView::remember() {
    m_past.push_back(present());
    if (m_past.size() > 50) m_past.pop_front();
}

void PlotView::zoomBack() {
    if (m_past.empty()) return;
    const Past past = m_past.back();
    m_past.pop_back();
    for (size_t c = 0; c < past.zooms.size() && c < m_model.charts.size(); ++c)
        for (size_t a = 0; a < past.zooms[c].size() && a < m_model.charts[c].axes.size(); ++a)
            m_model.charts[c].axes[a].zoom = past.zooms[c][a];
    takeRange(past.from, past.to);
}

void PlotView::takeRange(int64_t from, int64_t to) {
    const int64_t span = std::clamp(to - from, LeastSpan, GreatestSpan);
    if (to - from != span) {
        const int64_t middle = from + (to - from) / 2;
        from = middle - span / 2;
        to = from + span;
    }
    markDirty();
    if (from == m_model.from && to == m_model.to) return;
    m_model.from = from;
    m_model.to = to;
    emit rangeChanged(from, to);
}

void PlotView::setRange(int64_t from, int64_t to) {
    if (to > from) takeRange(from, to);
}

void PlotView::fit() {
    remember();
    for (PlotChart& chart : m_model.charts)
        for (PlotAxis& axis : chart.axes) axis.zoom.reset();
    if (const auto whole = wholeRange(m_model)) {
        const int64_t span = std::max<int64_t>(whole->second - whole->first, 1000);
        takeRange(whole->first, whole->first + span);
    }
    markDirty();
}

void PlotView::fitValues() {
    remember();
    for (PlotChart& chart : m_model.charts)
        for (PlotAxis& axis : chart.axes) axis.zoom.reset();
    markDirty();
}

void PlotView::zoomTime(double factor, int64_t about) {
    const double before = static_cast<double>(about - m_model.from), after = static_cast<double>(m_model.to - about);
    const auto from = about - static_cast<int64_t>(std::llround(before * factor)),
               to = about + static_cast<int64_t>(std::llround(after * factor));
    if (m_follow && factor < 1 && to < m_model.to - (m_model.to - m_model.from) / 50) setFollowing(false);
    takeRange(from, to);
}

void PlotView::zoomValues(double factor, int chart, std::optional<int> axis, double aboutY) {
    for (const PlotPane& pane : m_renderer.panes()) {
        if (pane.chart != chart || pane.isLanes) continue;
        for (size_t i = 0; i < pane.axes.size(); ++i) {
            if (axis && pane.axes[i] != *axis) continue;
            const PlotMapping map = m_renderer.mapping(m_model, pane, i);
            const double about = map.valueAt(std::clamp(aboutY, pane.area.top(), pane.area.bottom()));
            const PlotRange zoomed{about - (about - map.y.low) * factor, about + (map.y.high - about) * factor};
            const double size = std::max({std::abs(zoomed.low), std::abs(zoomed.high), 1e-300});
            if (zoomed.high - zoomed.low > size * 1e-12 && zoomed.high - zoomed.low < 1e300)
                m_model.charts[static_cast<size_t>(chart)].axes[static_cast<size_t>(pane.axes[i])].zoom = zoomed;
        }
    }
    markDirty();
}

void PlotView::panTime(double parts) {
    const auto by = static_cast<int64_t>(static_cast<double>(m_model.to - m_model.from) * parts);
    if (by < 0) setFollowing(false);
    takeRange(m_model.from + by, m_model.to + by);
}

void PlotView::setTool(PlotTool tool) {
    if (m_tool == tool) return;
    m_tool = tool;
    emit toolChanged(tool);
}

void PlotView::setFollowing(bool follow) {
    if (m_follow == follow) return;
    m_follow = follow;
    m_revisions.clear();
    if (follow) refresh();
    emit followingChanged(follow);
}

std::vector<uint64_t> PlotView::revisions() const {
    std::vector<uint64_t> result;
    for (const PlotCurve& curve : m_model.curves) result.push_back(curve.source ? curve.source->revision() : 0);
    return result;
}

void PlotView::refresh() {
    std::vector<uint64_t> now = revisions();
    if (now == m_revisions) return;
    m_revisions = std::move(now);
    if (m_follow) {
        std::optional<int64_t> newest;
        for (const PlotCurve& curve : m_model.curves)
            if (curve.source)
                if (const auto range = curve.source->timeRange())
                    newest = std::max(newest.value_or(range->second), range->second);
        if (newest) {
            // Until the first screen is full the picture grows from the left, afterwards it moves.
            const int64_t span = m_model.to - m_model.from;
            const auto whole = wholeRange(m_model);
            // In small steps: between them only the curves grow, and the axes, the dearer part, stay as they are.
            const int64_t step = std::max<int64_t>(1, span / 80);
            const int64_t to =
                whole && *newest - whole->first < span ? whole->first + span : (*newest / step + 2) * step;
            takeRange(to - span, to);
        }
    }
    markDirty();
}

void PlotView::setCursorsShown(bool shown) {
    if (shown == hasCursors()) return;
    if (shown) {
        const int64_t span = m_model.to - m_model.from;
        m_model.cursorA = snappedTime(m_model, m_model.from + span / 3);
        m_model.cursorB = snappedTime(m_model, m_model.from + span * 2 / 3);
    } else {
        m_model.cursorA.reset();
        m_model.cursorB.reset();
    }
    markDirty();
    emit cursorsChanged();
}

void PlotView::setCursor(int which, int64_t time) {
    (which == 0 ? m_model.cursorA : m_model.cursorB) = snappedTime(m_model, time);
    m_activeCursor = which;
    if (m_model.hasTable) m_dirty = true;
    update();
    emit cursorsChanged();
}

void PlotView::moveActiveCursor(int samples) {
    auto& cursor = m_activeCursor == 0 ? m_model.cursorA : m_model.cursorB;
    if (!cursor) return;
    std::vector<const SampleSource*> sources;
    if (const PlotCurve* selected = findCurve(m_model, m_model.selected);
        selected && selected->source && selected->isVisible)
        sources = {selected->source.get()};
    else
        for (const PlotCurve& curve : m_model.curves)
            if (curve.isVisible && curve.source) sources.push_back(curve.source.get());
    for (; samples != 0; samples += samples > 0 ? -1 : 1) {
        std::optional<int64_t> next;
        for (const SampleSource* source : sources) {
            const auto sample = samples > 0 ? source->after(*cursor) : source->inForceAt(*cursor - 1);
            if (sample && (!next || (samples > 0) == (sample->time < *next))) next = sample->time;
        }
        if (!next) break;
        cursor = next;
    }
    const int64_t span = m_model.to - m_model.from;
    if (*cursor < m_model.from)
        takeRange(*cursor - span / 10, *cursor - span / 10 + span);
    else if (*cursor > m_model.to)
        takeRange(*cursor + span / 10 - span, *cursor + span / 10);
    update();
    emit cursorsChanged();
}

QImage PlotView::picture(double scale) const {
    return plotPicture(m_model, {size(), scale > 0 ? scale : devicePixelRatioF()});
}

void PlotView::paintEvent(QPaintEvent*) {
    const double ratio = devicePixelRatioF();
    const QSize pixels = size() * ratio;
    if (m_dirty || m_base.size() != pixels) {
        if (m_base.size() != pixels) m_base = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
        m_base.setDevicePixelRatio(ratio);
        QPainter painter(&m_base);
        m_renderer.setFont(font());
        m_renderer.setPixelRatio(ratio);
        m_renderer.paintBase(painter, m_model, QRectF(rect()));
        m_dirty = false;
    }
    QPainter painter(this);
    painter.drawImage(0, 0, m_base);
    m_renderer.paintOverlay(painter, m_model);
    if (m_drag == Drag::Box) {
        QColor veil = kit::colors().accent;
        veil.setAlpha(40);
        painter.setPen(QPen(kit::colors().accent, 1));
        painter.setBrush(veil);
        painter.drawRect(boxNow());
    }
    if (m_dropChart >= 0)
        for (const PlotPane& pane : m_renderer.panes())
            if (pane.chart == m_dropChart) {
                painter.setPen(QPen(kit::colors().accent, 2));
                painter.setBrush(Qt::NoBrush);
                painter.drawRect(pane.area);
            }
}

void PlotView::resizeEvent(QResizeEvent*) { m_dirty = true; }

void PlotView::wheelEvent(QWheelEvent* event) {
    const QPointF at = event->position();
    const QPoint delta = event->angleDelta();
    const double steps = (delta.y() != 0 ? delta.y() : delta.x()) / 120.0, factor = std::pow(0.8, steps);
    const auto axis = m_renderer.axisAt(at);
    const bool control = event->modifiers() & Qt::ControlModifier, shift = event->modifiers() & Qt::ShiftModifier;
    if (shift && !control) {
        panTime(-0.1 * steps);
    } else {
        if (axis && !control)
            zoomValues(factor, axis->first, axis->second, at.y());
        else if (control)
            zoomValues(factor, chartAt(at), std::nullopt, at.y());
        if (!axis && (!control || shift)) zoomTime(factor, timeMapping().timeAt(at.x()));
    }
    event->accept();
}

int PlotView::chartAt(const QPointF& point) const {
    int best = 0;
    double distance = 1e9;
    for (const PlotPane& pane : m_renderer.panes()) {
        const double d = point.y() < pane.area.top()      ? pane.area.top() - point.y()
                         : point.y() > pane.area.bottom() ? point.y() - pane.area.bottom()
                                                          : 0;
        if (d < distance) distance = d, best = pane.chart;
    }
    return best;
}

std::optional<PlotView::Drag> PlotView::cursorNear(const QPointF& point) const {
    if (!m_renderer.plotArea().adjusted(-2, -2, 2, 2).contains(point)) return std::nullopt;
    const PlotMapping map = timeMapping();
    const double a = m_model.cursorA ? std::abs(map.xOf(*m_model.cursorA) - point.x()) : 1e9;
    const double b = m_model.cursorB ? std::abs(map.xOf(*m_model.cursorB) - point.x()) : 1e9;
    if (std::min(a, b) > CursorReach) return std::nullopt;
    return a <= b ? Drag::CursorA : Drag::CursorB;
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    m_dragFrom = m_dragAt = event->position();
    m_panFrom = m_model.from;
    m_panTo = m_model.to;
    m_panRemembered = false;
    if (event->button() == Qt::MiddleButton) {
        m_drag = Drag::Pan;
        QWidget::setCursor(Qt::ClosedHandCursor);
        return;
    }
    if (event->button() != Qt::LeftButton) return;
    if (const auto entry = m_renderer.legendAt(event->position())) {
        PlotCurve& curve = m_model.curves[static_cast<size_t>(*entry)];
        if (event->modifiers() & Qt::ControlModifier) {
            curve.isVisible = !curve.isVisible;
            emit curveToggled(curve.id, curve.isVisible);
        } else {
            m_model.selected = m_model.selected == curve.id ? QString() : curve.id;
            emit curveSelected(m_model.selected);
        }
        markDirty();
        return;
    }
    if (!m_renderer.paneAt(event->position())) return;
    const int64_t time = timeMapping().timeAt(event->position().x());
    if (event->modifiers() & Qt::ControlModifier) {
        setCursor(0, time);
        m_drag = Drag::CursorA;
    } else if (event->modifiers() & Qt::ShiftModifier) {
        setCursor(1, time);
        m_drag = Drag::CursorB;
    } else if (const auto cursor = cursorNear(event->position())) {
        m_drag = *cursor;
        m_activeCursor = *cursor == Drag::CursorA ? 0 : 1;
    } else {
        m_drag = m_tool == PlotTool::Pan ? Drag::Pan : m_tool == PlotTool::Ruler ? Drag::Ruler : Drag::Box;
        if (m_drag == Drag::Ruler && m_renderer.paneAt(m_dragFrom)->isLanes) m_drag = Drag::Box;
        if (m_drag == Drag::Ruler) m_model.ruler = m_renderer.rulerAt(m_model, m_dragFrom, RulerReach);
    }
}

void PlotView::dragRuler() {
    const PlotPane* pane = m_renderer.paneAt(m_dragAt);
    if (!m_model.ruler || !pane || pane->isLanes || pane->chart != m_model.ruler->chart) return;
    const PlotRuler at = m_renderer.rulerAt(m_model, m_dragAt, RulerReach);
    m_model.ruler->toTime = at.toTime;
    m_model.ruler->toValue = at.toValue;
    update();
}

QRectF PlotView::boxNow() const {
    const PlotPane* pane = m_renderer.paneAt(m_dragFrom);
    if (!pane) return {};
    const QRectF all = m_renderer.plotArea();
    QRectF box = QRectF(m_dragFrom, m_dragAt).normalized();
    // A flat box means time only, over all charts; a narrow one values only.
    if (pane->isLanes || std::abs(m_dragAt.y() - m_dragFrom.y()) < 4 * BoxReach)
        return QRectF(box.left(), all.top(), box.width(), all.height()).intersected(all);
    if (std::abs(m_dragAt.x() - m_dragFrom.x()) < 2 * BoxReach)
        return QRectF(pane->area.left(), box.top(), pane->area.width(), box.height()).intersected(pane->area);
    return box.intersected(pane->area);
}

void PlotView::applyBox(const QRectF& box) {
    const PlotPane* pane = m_renderer.paneAt(m_dragFrom);
    if (!pane) return;
    const bool wholeHeight = pane->isLanes || std::abs(m_dragAt.y() - m_dragFrom.y()) < 4 * BoxReach;
    const bool wholeWidth = !wholeHeight && std::abs(m_dragAt.x() - m_dragFrom.x()) < 2 * BoxReach;
    if (wholeHeight && std::abs(m_dragAt.x() - m_dragFrom.x()) < BoxReach) return; // a click
    remember();
    const PlotMapping time = timeMapping();
    if (!wholeHeight)
        for (size_t i = 0; i < pane->axes.size(); ++i) {
            const PlotMapping map = m_renderer.mapping(m_model, *pane, i);
            m_model.charts[static_cast<size_t>(pane->chart)].axes[static_cast<size_t>(pane->axes[i])].zoom =
                PlotRange{map.valueAt(box.bottom()), map.valueAt(box.top())};
        }
    if (!wholeWidth) {
        setFollowing(false);
        takeRange(time.timeAt(box.left()), time.timeAt(box.right()));
    }
    markDirty();
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    m_dragAt = event->position();
    switch (m_drag) {
    case Drag::None: {
        const bool onCursor = cursorNear(event->position()).has_value();
        if (onCursor)
            QWidget::setCursor(Qt::SplitHCursor);
        else if (m_renderer.legendAt(event->position()))
            QWidget::setCursor(Qt::PointingHandCursor);
        else if (m_renderer.paneAt(event->position()))
            QWidget::setCursor(m_tool == PlotTool::Pan ? Qt::OpenHandCursor : Qt::CrossCursor);
        else
            unsetCursor();
        return;
    }
    case Drag::Box:
        update();
        return;
    case Drag::Ruler:
        dragRuler();
        return;
    case Drag::CursorA:
    case Drag::CursorB:
        setCursor(m_drag == Drag::CursorA ? 0 : 1, timeMapping().timeAt(m_dragAt.x()));
        return;
    case Drag::Pan: {
        if (!m_panRemembered) remember();
        m_panRemembered = true;
        const double width = std::max(1.0, timeMapping().area.width());
        const auto by =
            static_cast<int64_t>((m_dragFrom.x() - m_dragAt.x()) / width * static_cast<double>(m_panTo - m_panFrom));
        if (by != 0) setFollowing(false);
        takeRange(m_panFrom + by, m_panTo + by);
        return;
    }
    }
}

void PlotView::mouseReleaseEvent(QMouseEvent*) {
    const Drag drag = std::exchange(m_drag, Drag::None);
    if (drag == Drag::Box) applyBox(boxNow());
    // a click measures nothing
    if (drag == Drag::Ruler && (m_dragAt - m_dragFrom).manhattanLength() < BoxReach) m_model.ruler.reset();
    unsetCursor();
    update();
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    m_drag = Drag::None;
    if (m_renderer.paneAt(event->position()))
        emit timeActivated(snappedTime(m_model, timeMapping().timeAt(event->position().x())));
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    const bool control = event->modifiers() & Qt::ControlModifier;
    const int64_t middle = m_model.from + (m_model.to - m_model.from) / 2;
    switch (event->key()) {
    case Qt::Key_Left:
        control || hasCursors() ? moveActiveCursor(control ? -10 : -1) : panTime(-0.1);
        return;
    case Qt::Key_Right:
        control || hasCursors() ? moveActiveCursor(control ? 10 : 1) : panTime(0.1);
        return;
    case Qt::Key_PageUp:
        panTime(-0.9);
        return;
    case Qt::Key_PageDown:
        panTime(0.9);
        return;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomTime(0.8, middle);
        return;
    case Qt::Key_Minus:
        zoomTime(1.25, middle);
        return;
    case Qt::Key_Home:
        fit();
        return;
    case Qt::Key_End:
        setFollowing(true);
        return;
    case Qt::Key_Backspace:
        zoomBack();
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter: {
        const auto& cursor = m_activeCursor == 0 ? m_model.cursorA : m_model.cursorB;
        emit timeActivated(cursor.value_or(snappedTime(m_model, middle)));
        return;
    }
    case Qt::Key_M:
        setTool(m_tool == PlotTool::Ruler ? PlotTool::ZoomBox : PlotTool::Ruler);
        return;
    case Qt::Key_C:
        if (control)
            copyPicture(m_model, {size(), 2});
        else
            setCursorsShown(!hasCursors());
        return;
    case Qt::Key_Tab:
        if (hasCursors() && m_model.cursorA && m_model.cursorB) {
            m_activeCursor = 1 - m_activeCursor;
            return;
        }
        break;
    case Qt::Key_Escape:
        if (m_drag != Drag::None) {
            m_drag = Drag::None;
            update();
            return;
        }
        if (!m_model.ruler) break;
        m_model.ruler.reset();
        update();
        return;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void PlotView::contextMenuEvent(QContextMenuEvent* event) {
    QString id;
    const QPointF at(event->pos());
    if (const auto entry = m_renderer.legendAt(at))
        id = m_model.curves[static_cast<size_t>(*entry)].id;
    else if (const auto lane = m_renderer.laneAt(at))
        id = m_model.curves[static_cast<size_t>(*lane)].id;
    emit menuRequested(event->globalPos(), chartAt(at), id);
}

void PlotView::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(kit::VariableMime) || event->mimeData()->hasText()) event->acceptProposedAction();
}

void PlotView::dragMoveEvent(QDragMoveEvent* event) {
    m_dropChart = chartAt(event->position());
    event->acceptProposedAction();
    update();
}

void PlotView::dragLeaveEvent(QDragLeaveEvent*) {
    m_dropChart = -1;
    update();
}

void PlotView::dropEvent(QDropEvent* event) {
    const QStringList paths = kit::variablesOf(event->mimeData());
    const int chart = chartAt(event->position());
    m_dropChart = -1;
    update();
    if (paths.isEmpty()) return;
    event->acceptProposedAction();
    emit variablesDropped(paths, chart);
}

bool PlotView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        const QPointF at(help->pos());
        QString text;
        if (const auto marker = m_renderer.markerAt(m_model, at)) {
            const PlotMarker& m = m_model.markers[static_cast<size_t>(*marker)];
            text = QStringLiteral("%1\n%2").arg(m.text, momentText(m.time - m_model.origin));
        } else if (const auto entry = m_renderer.legendAt(at)) {
            const PlotCurve& curve = m_model.curves[static_cast<size_t>(*entry)];
            text = curve.problem.isEmpty() ? tr("%1\nClick selects, Ctrl+click shows or hides.").arg(curve.name)
                                           : QStringLiteral("%1\n%2").arg(curve.name, curve.problem);
        } else if (m_renderer.paneAt(at)) {
            const int64_t time = timeMapping().timeAt(at.x());
            text = momentText(snappedTime(m_model, time) - m_model.origin);
            for (const PlotCurve& curve : m_model.curves) {
                if (!curve.isVisible || !curve.source || curve.chart != chartAt(at)) continue;
                if (const int64_t at = snappedTime(m_model, time); curve.source->inForceAt(at))
                    text += QStringLiteral("\n%1 = %2").arg(curve.name, curveTextAt(curve, at));
            }
        }
        if (text.isEmpty())
            QToolTip::hideText();
        else
            QToolTip::showText(help->globalPos(), text, this);
        return true;
    }
    if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange ||
        event->type() == QEvent::StyleChange)
        markDirty();
    return QWidget::event(event);
}

} // namespace plc::plot
