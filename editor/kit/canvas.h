// The drawing ground of graph views and the panel designer: a graphics view that zooms about the pointer, pans with the
// middle button or Space, shows a grid and a small map of the whole, and gives its scene as SVG, PNG or paper. Owned by
// its Qt parent; GUI thread. It draws no contents of its own: the scene does.
#pragma once

#include <QGraphicsView>

class QPrinter;

namespace plc::kit {

class CanvasMap;

class Canvas : public QGraphicsView {
    Q_OBJECT
public:
    explicit Canvas(QWidget* parent = nullptr);
    ~Canvas() override;

    double zoom() const;
    void setZoom(double factor);
    void zoomBy(double factor, const QPoint& about);
    void zoomToFit();
    void zoomToRect(const QRectF& rect);
    void setZoomLimits(double least, double most);

    /// 0 switches the grid off.
    void setGridStep(double step);
    double gridStep() const { return m_gridStep; }
    QPointF snapped(const QPointF& scenePoint) const;
    void setMapVisible(bool visible);
    bool isMapVisible() const;

    bool exportSvg(const QString& path) const;
    bool exportPng(const QString& path, double scale = 2) const;
    bool exportPdf(const QString& path) const;
    QImage picture(double scale = 1) const;
    void copyPicture() const;
    /// Where the menu of a part opens that is asked for by key, in global coordinates.
    [[nodiscard]] QPoint menuPlace(const QRectF& part) const;
    /// Ink on white, over as many pages as it takes.
    void print(QPrinter& printer, const QString& title) const;

signals:
    void zoomChanged(double factor);
    void viewMoved();

protected:
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    bool viewportEvent(QEvent* event) override;

private:
    void renderScene(QPainter& painter, const QRectF& target) const;
    QRectF exportRect() const;
    void placeMap();

    double m_least = 0.1, m_most = 8, m_gridStep = 0;
    bool m_space = false, m_panning = false;
    QPoint m_panFrom;
    CanvasMap* m_map;
};

} // namespace plc::kit
