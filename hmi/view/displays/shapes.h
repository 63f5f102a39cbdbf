// Views of the plain shapes and of pipes.
#pragma once
#include "hmi/view/scene/element_view.h"

#include <QPainterPath>

namespace plc::hmi {

/// What the shapes share: a pen, a fill and a fill level.
class ShapeView : public ElementView {
public:
    using ElementView::ElementView;
    double overhang() const override { return m_lineWidth + 2; }

protected:
    void setUp() override;
    bool update() override;
    QPen pen() const;
    QList<QPointF> corners() const; // the points in pixels
    void drawFilled(QPainter& painter, const QPainterPath& path);
    void drawEnds(QPainter& painter, const QList<QPointF>& points);

    double m_lineWidth = 1;
    QColor m_line, m_fill;

private:
    Slot m_level;
    std::optional<double> m_shownLevel;
};

#define HMI_SHAPE_VIEW(Kind)                                                                                           \
    class Kind##View final : public ShapeView {                                                                        \
    public:                                                                                                            \
        using ShapeView::ShapeView;                                                                                    \
                                                                                                                       \
    protected:                                                                                                         \
        void draw(QPainter& painter) override;                                                                         \
    }
HMI_SHAPE_VIEW(Line);
HMI_SHAPE_VIEW(Polyline);
HMI_SHAPE_VIEW(Rectangle);
HMI_SHAPE_VIEW(Rounded);
HMI_SHAPE_VIEW(Ellipse);
HMI_SHAPE_VIEW(Polygon);
HMI_SHAPE_VIEW(Arc);
#undef HMI_SHAPE_VIEW

class PipeView final : public ElementView {
public:
    using ElementView::ElementView;
    double overhang() const override { return num("thickness") / 2 + 3; }

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;
    bool advance(qint64 milliseconds) override;

private:
    void drawArrows(QPainter& painter, const QPainterPath& path, double thickness) const;
    Slot m_flow;
    int m_direction = 0;
    double m_phase = 0;
};

/// A polyline with rounded corners.
QPainterPath roundedPath(const QList<QPointF>& points, double radius);

} // namespace plc::hmi
