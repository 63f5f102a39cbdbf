#include "editor/kit/canvas.h"

#include "editor/kit/paper.h"
#include "editor/kit/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QPdfWriter>
#include <QPrinter>
#include <QScrollBar>
#include <QSvgGenerator>
#include <QTimer>
#include <QWheelEvent>

#include <cmath>

namespace plc::kit {

/// The small map in the corner: the whole scene, and the part in view, which can be dragged.
class CanvasMap : public QWidget {
public:
    explicit CanvasMap(Canvas& canvas) : QWidget(&canvas), m_canvas(canvas) {
        setCursor(Qt::PointingHandCursor);
        setAccessibleName(Canvas::tr("Overview"));
        m_refresh.setSingleShot(true);
        m_refresh.setInterval(150);
        QObject::connect(&m_refresh, &QTimer::timeout, this, [this] {
            m_picture = QPixmap();
            update();
        });
    }
    void sceneChanged() {
        if (isVisible() && !m_refresh.isActive()) m_refresh.start();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        if (m_picture.isNull() || m_picture.size() != size() * devicePixelRatio()) draw();
        painter.drawPixmap(0, 0, m_picture);
        painter.setPen(QPen(colors().accent, 1.5));
        QColor veil = colors().accent;
        veil.setAlpha(30);
        painter.setBrush(veil);
        const QRectF view = m_canvas.mapToScene(m_canvas.viewport()->rect()).boundingRect();
        painter.drawRect(QRectF(toMap(view.topLeft()), toMap(view.bottomRight()))
                             .intersected(QRectF(rect()).adjusted(1, 1, -2, -2)));
    }
    void mousePressEvent(QMouseEvent* event) override { m_canvas.centerOn(toScene(event->pos())); }
    void mouseMoveEvent(QMouseEvent* event) override { m_canvas.centerOn(toScene(event->pos())); }

private:
    QRectF whole() const { return m_canvas.sceneRect(); }
    double factor() const {
        return std::min((width() - 8) / std::max(1.0, whole().width()),
                        (height() - 8) / std::max(1.0, whole().height()));
    }
    QPointF toMap(const QPointF& p) const { return QPointF(rect().center()) + (p - whole().center()) * factor(); }
    QPointF toScene(const QPointF& p) const { return whole().center() + (p - QPointF(rect().center())) / factor(); }

    void draw() {
        m_picture = QPixmap(size() * devicePixelRatio());
        m_picture.setDevicePixelRatio(devicePixelRatio());
        m_picture.fill(colors().raised);
        QPainter painter(&m_picture);
        painter.setRenderHint(QPainter::Antialiasing);
        if (m_canvas.scene())
            m_canvas.scene()->render(&painter, QRectF(toMap(whole().topLeft()), toMap(whole().bottomRight())), whole());
        painter.setPen(colors().border);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }

    Canvas& m_canvas;
    QPixmap m_picture;
    QTimer m_refresh;
};

Canvas::Canvas(QWidget* parent) : QGraphicsView(parent) {
    setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform);
    setTransformationAnchor(NoAnchor);
    setResizeAnchor(NoAnchor);
    setDragMode(NoDrag);
    setFrameShape(NoFrame);
    setViewportUpdateMode(SmartViewportUpdate);
    m_map = new CanvasMap(*this);
    m_map->resize(180, 120);
    m_map->hide();
    connect(&Theme::current(), &Theme::changed, this, [this] {
        resetCachedContent();
        viewport()->update();
        m_map->sceneChanged();
    });
}

Canvas::~Canvas() = default;

double Canvas::zoom() const { return transform().m11(); }

void Canvas::setZoomLimits(double least, double most) {
    m_least = least;
    m_most = most;
}

void Canvas::zoomBy(double factor, const QPoint& about) {
    const double wanted = std::clamp(zoom() * factor, m_least, m_most);
    if (std::abs(wanted / zoom() - 1) < 1e-9) return;
    const QPointF before = mapToScene(about);
    const double by = wanted / zoom();
    scale(by, by);
    const QPointF shift = mapFromScene(before) - QPointF(about);
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() + qRound(shift.x()));
    verticalScrollBar()->setValue(verticalScrollBar()->value() + qRound(shift.y()));
    emit zoomChanged(zoom());
    m_map->update();
}

void Canvas::setZoom(double factor) { zoomBy(factor / zoom(), viewport()->rect().center()); }

void Canvas::zoomToRect(const QRectF& rect) {
    if (rect.isEmpty()) return;
    const double fit = std::min((viewport()->width() - 24) / rect.width(), (viewport()->height() - 24) / rect.height());
    setZoom(fit);
    centerOn(rect.center());
    m_map->update();
}

void Canvas::zoomToFit() {
    if (!scene()) return;
    // The sheet with its margins: what is larger than the view would bring back the scroll bars, which take the room.
    const QRectF rect = exportRect().united(sceneRect());
    const QSizeF room = maximumViewportSize();
    const double fit =
        std::min((room.width() - 4) / std::max(1.0, rect.width()), (room.height() - 4) / std::max(1.0, rect.height()));
    setZoom(std::min(fit, 1.5));
    centerOn(rect.center());
    m_map->update();
}

void Canvas::setGridStep(double step) {
    m_gridStep = step;
    viewport()->update();
}

QPointF Canvas::snapped(const QPointF& p) const {
    if (m_gridStep <= 0) return p;
    return {std::round(p.x() / m_gridStep) * m_gridStep, std::round(p.y() / m_gridStep) * m_gridStep};
}

void Canvas::setMapVisible(bool visible) {
    if (visible && scene()) connect(scene(), &QGraphicsScene::changed, m_map, [this] { m_map->sceneChanged(); });
    m_map->setVisible(visible);
    placeMap();
}

bool Canvas::isMapVisible() const { return m_map->isVisibleTo(this); }

void Canvas::placeMap() {
    m_map->move(viewport()->geometry().bottomRight() - QPoint(m_map->width() + 9, m_map->height() + 9));
}

QRectF Canvas::exportRect() const {
    if (!scene()) return {};
    QRectF rect = scene()->itemsBoundingRect();
    if (rect.isEmpty()) rect = sceneRect();
    return rect.adjusted(-8, -8, 8, 8);
}

void Canvas::renderScene(QPainter& painter, const QRectF& target) const {
    painter.setRenderHints(renderHints());
    painter.fillRect(target, colors().base);
    const QRectF source = exportRect();
    // Through the scene, not the view: neither the grid nor the window's edge belongs to the picture.
    if (scene()) scene()->render(&painter, target, source);
}

bool Canvas::exportSvg(const QString& path) const {
    QSvgGenerator generator;
    generator.setFileName(path);
    const QSize size = exportRect().size().toSize();
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(accessibleName());
    QPainter painter;
    if (!painter.begin(&generator)) return false;
    renderScene(painter, QRectF(QPointF(), size));
    return painter.end();
}

QImage Canvas::picture(double scale) const {
    const QSizeF size = exportRect().size();
    QImage image((size * scale).toSize().expandedTo(QSize(1, 1)), QImage::Format_ARGB32_Premultiplied);
    image.fill(colors().base);
    QPainter painter(&image);
    renderScene(painter, QRectF(QPointF(), image.size()));
    return image;
}

bool Canvas::exportPng(const QString& path, double scale) const { return picture(scale).save(path, "PNG"); }

bool Canvas::exportPdf(const QString& path) const {
    QPdfWriter writer(path);
    const QSizeF size = exportRect().size();
    writer.setResolution(96);
    writer.setPageSize(QPageSize(size * 72.0 / 96.0, QPageSize::Point, QString(), QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF());
    QPainter painter;
    if (!painter.begin(&writer)) return false;
    renderScene(painter, QRectF(QPointF(), size));
    return painter.end();
}

QPoint Canvas::menuPlace(const QRectF& part) const {
    const QRect shown = mapFromScene(part).boundingRect() & viewport()->rect();
    return viewport()->mapToGlobal(shown.isEmpty() ? QPoint(8, 8) : shown.bottomLeft());
}

void Canvas::copyPicture() const { QApplication::clipboard()->setImage(picture(2)); }

void Canvas::print(QPrinter& printer, const QString& title) const {
    if (scene()) printScene(printer, *scene(), exportRect(), title);
}

void Canvas::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ControlModifier) {
        zoomBy(std::pow(1.2, event->angleDelta().y() / 120.0), event->position().toPoint());
        event->accept();
        return;
    }
    if (event->modifiers() & Qt::ShiftModifier) {
        horizontalScrollBar()->setValue(horizontalScrollBar()->value() - event->angleDelta().y());
        event->accept();
        return;
    }
    QGraphicsView::wheelEvent(event);
}

bool Canvas::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::NativeGesture) {
        auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            zoomBy(1 + gesture->value(), gesture->position().toPoint());
            return true;
        }
    }
    return QGraphicsView::viewportEvent(event);
}

void Canvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton || (m_space && event->button() == Qt::LeftButton)) {
        m_panning = true;
        m_panFrom = event->pos();
        viewport()->setCursor(Qt::ClosedHandCursor);
        event->accept();
        return;
    }
    QGraphicsView::mousePressEvent(event);
}

void Canvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_panning) {
        const QPoint by = event->pos() - m_panFrom;
        m_panFrom = event->pos();
        horizontalScrollBar()->setValue(horizontalScrollBar()->value() - by.x());
        verticalScrollBar()->setValue(verticalScrollBar()->value() - by.y());
        event->accept();
        return;
    }
    QGraphicsView::mouseMoveEvent(event);
}

void Canvas::mouseReleaseEvent(QMouseEvent* event) {
    if (m_panning && (event->button() == Qt::MiddleButton || event->button() == Qt::LeftButton)) {
        m_panning = false;
        viewport()->setCursor(m_space ? Qt::OpenHandCursor : Qt::ArrowCursor);
        event->accept();
        return;
    }
    QGraphicsView::mouseReleaseEvent(event);
}

void Canvas::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat() && !(scene() && scene()->focusItem())) {
        m_space = true;
        viewport()->setCursor(Qt::OpenHandCursor);
        event->accept();
        return;
    }
    if (event->modifiers() & Qt::ControlModifier) {
        const QPoint middle = viewport()->rect().center();
        switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoomBy(1.25, middle);
            return;
        case Qt::Key_Minus:
            zoomBy(0.8, middle);
            return;
        case Qt::Key_0:
            setZoom(1);
            return;
        case Qt::Key_9:
            zoomToFit();
            return;
        default:
            break;
        }
    }
    QGraphicsView::keyPressEvent(event);
}

void Canvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        m_space = false;
        if (!m_panning) viewport()->unsetCursor();
    }
    QGraphicsView::keyReleaseEvent(event);
}

void Canvas::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    placeMap();
    m_map->update();
}

void Canvas::scrollContentsBy(int dx, int dy) {
    QGraphicsView::scrollContentsBy(dx, dy);
    m_map->update();
    emit viewMoved();
}

void Canvas::drawBackground(QPainter* painter, const QRectF& rect) {
    painter->fillRect(rect, colors().base);
    if (m_gridStep <= 0) return;
    double step = m_gridStep;
    while (step * zoom() < 9) step *= 2;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing, false);
    painter->setPen(QPen(colors().border, 0));
    std::vector<QPointF> dots;
    for (double x = std::floor(rect.left() / step) * step; x <= rect.right(); x += step)
        for (double y = std::floor(rect.top() / step) * step; y <= rect.bottom(); y += step) dots.emplace_back(x, y);
    painter->drawPoints(dots.data(), static_cast<int>(dots.size()));
    painter->restore();
}

} // namespace plc::kit
