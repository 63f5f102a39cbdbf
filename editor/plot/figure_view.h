// A figure as a widget: zoom with box and wheel, pan, values below the mouse, a ruler between any two points. It owns
// the figure that is set. GUI thread.
#pragma once
#include "editor/plot/figure.h"

#include <QWidget>

namespace plc::plot {

class FigureView : public QWidget {
    Q_OBJECT
public:
    explicit FigureView(QWidget* parent = nullptr);
    void setFigure(Figure figure);
    void setChart(waveform::Chart chart);
    [[nodiscard]] const Figure& figure() const { return m_figure; }
    /// Everything again.
    void fit();
    [[nodiscard]] const FigureZoom& zoom() const { return m_zoom; }
    [[nodiscard]] const std::optional<FigureRuler>& ruler() const { return m_ruler; }
    /// A left drag measures instead of zooming, as Shift does meanwhile.
    void setMeasures(bool measures);
    [[nodiscard]] bool measures() const { return m_measures; }
    [[nodiscard]] std::vector<FigureFrame> frames() const;
    [[nodiscard]] QSize sizeHint() const override { return {320, 220}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 120}; }

signals:
    void menuRequested(const QPoint& global);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    enum class Drag : uint8_t { None, Box, Pan, Ruler };
    void showValues(const QPointF& place, const QPoint& global);
    void zoomTo(const QRectF& box);
    void zoomAbout(const QPointF& place, double factor, bool onX, bool onY);
    void pan(const QPointF& by);
    [[nodiscard]] std::optional<size_t> chartAt(const QPointF& place) const;
    [[nodiscard]] FigurePoint pointAt(const QPointF& place) const;
    void setZoomY(size_t chart, PlotRange range);

    Figure m_figure;
    FigureZoom m_zoom;
    std::optional<FigureRuler> m_ruler;
    bool m_measures = false;
    Drag m_drag = Drag::None;
    QPointF m_dragFrom, m_dragAt;
};

} // namespace plc::plot
