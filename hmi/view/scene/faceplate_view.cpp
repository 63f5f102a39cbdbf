#include "hmi/view/scene/faceplate_view.h"

#include "hmi/model/layout.h"
#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

const Panel* FaceplateView::panel() const {
    const QString name = panelName();
    return name.isEmpty() ? nullptr : scene().panelNamed(name);
}

void FaceplateView::setUp() {
    m_contents = {};
    m_ground = QColor(); // {} would be Qt::color0, which is white
    const Panel* placed = panel();
    if (!placed) return;
    const QSizeF size = m_size = sizeFor(*placed, rect().size());
    double sx = width() / size.width(), sy = height() / size.height();
    if (text("fit") != QStringLiteral("stretch")) sx = sy = std::min(sx, sy);
    m_contents.translate((width() - size.width() * sx) / 2, (height() - size.height() * sy) / 2);
    m_contents.scale(sx, sy);
    if (placed->has("background")) m_ground = theme().color(placed->text("background"));
}

void FaceplateView::draw(QPainter& painter) {
    const Panel* placed = panel();
    if (placed && m_ground.isValid()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(stateColor(m_ground));
        painter.drawRoundedRect(m_contents.mapRect(QRectF(QPointF(), m_size)), 4, 4);
    }
    if (placed) return;
    // Nothing to show: said where it should be, also to the operator.
    painter.setPen(QPen(theme().color("low"), 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box().adjusted(1, 1, -1, -1), 6, 6);
    painter.setPen(theme().color("muted"));
    const QString name = panelName();
    drawText(painter, textBox(name.isEmpty() ? QStringLiteral("?") : name, box().adjusted(6, 6, -6, -6), 14,
                              TextAlign::Center, "panel"));
}

} // namespace plc::hmi
