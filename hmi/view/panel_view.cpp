#include "hmi/view/panel_view.h"

#include <QMouseEvent>
#include <QPaintEvent>
#include <QWheelEvent>

namespace plc::hmi {

PanelView::PanelView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(80, 60);
    m_timer.setInterval(33);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, [this] { frame(); });
    m_clock.start();
}

void PanelView::setFit(PanelFit fit) {
    m_fit = fit;
    updateGeometry();
    update();
}

void PanelView::setZoom(double zoom) {
    m_zoom = std::clamp(zoom, 0.05, 16.0);
    m_fit = PanelFit::Fixed;
    updateGeometry();
    update();
}

double PanelView::zoom() const {
    if (m_fit == PanelFit::Fixed) return m_zoom;
    const QSizeF panel = m_scene.size();
    return std::max(0.01, std::min(width() / panel.width(), height() / panel.height()));
}

QPointF PanelView::origin() const {
    const QSizeF shown = QSizeF(m_scene.size()) * zoom();
    return {std::max(0.0, std::floor((width() - shown.width()) / 2)),
            std::max(0.0, std::floor((height() - shown.height()) / 2))};
}

QPointF PanelView::toPanel(QPointF point) const { return (point - origin()) / zoom(); }

QRectF PanelView::toWidget(const QRectF& rect) const {
    return {origin() + rect.topLeft() * zoom(), rect.size() * zoom()};
}

QSize PanelView::sizeHint() const {
    return (QSizeF(m_scene.size()) * (m_fit == PanelFit::Fixed ? m_zoom : 1.0)).toSize();
}

QRegion PanelView::frame() {
    const QRegion changed = m_scene.refresh(m_clock.elapsed());
    // A panel of another size or theme leaves some of the one before beside it.
    if (panelRect() != m_paintedArea || surround() != m_paintedSurround) {
        m_paintedArea = panelRect();
        m_paintedSurround = surround();
        update();
        return changed;
    }
    if (changed.isEmpty()) return changed;
    if (zoom() == 1) {
        update(changed.translated(origin().toPoint()));
        return changed;
    }
    // A thousand little rectangles cost more than the area between them.
    if (changed.rectCount() > 64) {
        update(toWidget(changed.boundingRect()).toAlignedRect().adjusted(-1, -1, 1, 1));
        return changed;
    }
    QRegion mapped;
    for (const QRect& rect : changed) mapped += toWidget(rect).toAlignedRect().adjusted(-1, -1, 1, 1);
    update(mapped);
    return changed;
}

QColor PanelView::surround() const {
    const PanelTheme& theme = m_scene.theme();
    const QRectF area = panelRect();
    // A pixel or two beside a panel that fills the view come from rounding: they belong to its ground.
    if (width() - area.width() >= 4 || height() - area.height() >= 4)
        return theme.color("background").darker(theme.isDark() ? 130 : 108);
    const QColor own = theme.color(m_scene.panel().text("background"));
    return own.isValid() ? own : theme.color("background");
}

void PanelView::paintEvent(QPaintEvent* event) {
    ++m_painted;
    QPainter painter(this);
    const QRectF area = panelRect();
    // Pixels that the panel covers in part are filled too: what was there before would shine through.
    const QRect covered(
        QPoint(static_cast<int>(std::ceil(area.left())), static_cast<int>(std::ceil(area.top()))),
        QPoint(static_cast<int>(std::floor(area.right())) - 1, static_cast<int>(std::floor(area.bottom())) - 1));
    for (const QRect& rect : event->region() - covered) painter.fillRect(rect, surround());
    const QRegion inside = event->region() & area.toAlignedRect();
    if (inside.isEmpty()) return;
    painter.translate(area.topLeft());
    painter.scale(zoom(), zoom());
    // Few pieces are painted one by one, many at once: each element is then painted only once.
    const QRectF whole(toPanel(inside.boundingRect().topLeft()),
                       toPanel(inside.boundingRect().bottomRight() + QPoint(1, 1)));
    m_scene.paint(painter, whole, inside.rectCount() > 1 ? &inside : nullptr,
                  QTransform::fromTranslate(area.left(), area.top()).scale(zoom(), zoom()));
}

void PanelView::resizeEvent(QResizeEvent*) {
    if (m_fit == PanelFit::Whole) m_scene.setScreen(size());
    update();
}

void PanelView::showEvent(QShowEvent*) { m_timer.start(); }

void PanelView::hideEvent(QHideEvent*) {
    m_timer.stop();
    letGo();
}

void PanelView::letGo() {
    if (m_scene.pressedView()) m_scene.release(QPointF(-1e6, -1e6));
}

bool PanelView::event(QEvent* event) {
    // A finger that leaves the window must not keep a button pressed.
    if (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::TouchCancel) letGo();
    return QWidget::event(event);
}

void PanelView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    m_lastPoint = toPanel(event->position());
    m_scene.press(m_lastPoint);
    frame();
}

void PanelView::mouseMoveEvent(QMouseEvent* event) {
    m_lastPoint = toPanel(event->position());
    m_scene.move(m_lastPoint);
}

void PanelView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mouseReleaseEvent(event);
    m_scene.release(toPanel(event->position()));
    frame();
}

void PanelView::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void PanelView::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() != Qt::NoModifier) return QWidget::wheelEvent(event);
    m_scene.wheel(toPanel(event->position()), event->angleDelta().y() / 120.0);
}

} // namespace plc::hmi
