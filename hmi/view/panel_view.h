// A panel as a widget: it scales the scene into its area, asks it for changes 30 times a second, paints only those, and
// hands presses on. Owned by its Qt parent; main thread.
#pragma once
#include "hmi/view/element_factory.h"
#include "hmi/view/scene/panel_scene.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace plc::hmi {

enum class PanelFit { Whole /* as large as fits */, Fixed /* at the zoom that was set */ };

class PanelView final : public QWidget {
    Q_OBJECT
public:
    explicit PanelView(QWidget* parent = nullptr);

    PanelScene& scene() { return m_scene; }
    const PanelScene& scene() const { return m_scene; }
    void setFit(PanelFit fit);
    void setZoom(double zoom);
    double zoom() const;
    QPointF toPanel(QPointF widgetPoint) const;
    QRectF toWidget(const QRectF& panelRect) const;
    QRectF panelRect() const { return toWidget(QRectF(QPointF(), m_scene.size())); }
    QSize sizeHint() const override;
    /// One frame now: reads values and asks for the repaint of what changed. The timer does this while the widget is
    /// shown.
    QRegion frame();
    int paintedFrames() const { return m_painted; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

private:
    QPointF origin() const;
    /// What lies beside the panel.
    QColor surround() const;
    void letGo();
    PanelScene m_scene{makeElementView};
    QTimer m_timer;
    QElapsedTimer m_clock;
    PanelFit m_fit = PanelFit::Whole;
    double m_zoom = 1;
    QPointF m_lastPoint;
    int m_painted = 0;
    QRectF m_paintedArea; // of the panel, when all was painted the last time
    QColor m_paintedSurround;
};

} // namespace plc::hmi
