#include "hmi/view/controls/user_view.h"

#include "hmi/texts/system_texts.h"
#include "hmi/view/controls/buttons.h"
#include "hmi/view/scene/panel_scene.h"

#include <QPainterPath>

namespace plc::hmi {

void UserFieldView::press(QPointF) {
    m_isDown = true;
    repaint();
}

void UserFieldView::release(QPointF, bool inside) {
    m_isDown = false;
    repaint();
    if (inside) scene().request(AccessRequest{element().id(), {}, !scene().user().isEmpty()});
}

TextBox UserFieldView::label(const QString& words, const QString& forTag) const {
    const double side = height() * 0.6;
    const bool isMirrored = isRightToLeft(forTag);
    return textBox(words, box().adjusted(isMirrored ? 8 : side + 14, 2, isMirrored ? -side - 14 : -8, -2),
                   num("fontSize"), TextAlign::Start, "user", false, forTag);
}

void UserFieldView::draw(QPainter& painter) {
    const QColor ground = stateColor(theme().color("button"));
    drawKey(painter, box(), 6, ground, m_isDown, theme());
    const double side = height() * 0.6;
    const QPointF middle(isRightToLeft(tag()) ? width() - 8 - side / 2 : 8 + side / 2, height() / 2);
    const bool isSomebody = !scene().user().isEmpty();
    painter.setPen(Qt::NoPen);
    painter.setBrush(isSomebody ? theme().color("accent") : theme().color("muted"));
    painter.drawEllipse(middle - QPointF(0, side * 0.2), side * 0.2, side * 0.2);
    QPainterPath shoulders;
    shoulders.arcMoveTo(QRectF(middle.x() - side * 0.38, middle.y() + side * 0.06, side * 0.76, side * 0.8), 0);
    shoulders.arcTo(QRectF(middle.x() - side * 0.38, middle.y() + side * 0.06, side * 0.76, side * 0.8), 0, 180);
    shoulders.closeSubpath();
    painter.drawPath(shoulders);
    painter.setPen(PanelTheme::inkOn(ground));
    drawText(painter,
             label(isSomebody ? scene().user() : systemText(scene().texts(), SystemText::LogIn, tag()), tag()));
}

void UserFieldView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    out.push_back(label(systemText(scene().texts(), SystemText::LogIn, forTag), forTag));
}

} // namespace plc::hmi
