#include "editor/kit/style_painting.h"

#include "editor/kit/theme.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QStyleOption>

namespace plc::kit {

void fillRound(QPainter* painter, const QRectF& rect, const QColor& fill, const QColor& line, qreal radius) {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(line.isValid() ? QPen(line, 1) : QPen(Qt::NoPen));
    painter->setBrush(fill.isValid() ? QBrush(fill) : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(line.isValid() ? rect.adjusted(0.5, 0.5, -0.5, -0.5) : rect, radius, radius);
    painter->restore();
}

void strokePath(QPainter* painter, const QPolygonF& line, const QColor& color, qreal width) {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPolyline(line);
    painter->restore();
}

void drawArrow(QPainter* painter, const QRect& rect, int degrees, const QColor& color) {
    painter->save();
    painter->translate(QRectF(rect).center());
    painter->rotate(degrees);
    strokePath(painter, QPolygonF({{-3.2, -1.6}, {0, 1.6}, {3.2, -1.6}}), color, 1.5);
    painter->restore();
}

namespace {

bool isEnabled(const QStyleOption* option) { return option->state & QStyle::State_Enabled; }
bool isHovered(const QStyleOption* option) { return isEnabled(option) && (option->state & QStyle::State_MouseOver); }

void drawToolButton(const QStyleOption* option, QPainter* painter) {
    const ThemeColors& c = colors();
    const bool down = option->state & QStyle::State_Sunken, on = option->state & QStyle::State_On;
    if (!isEnabled(option)) return;
    if (down)
        fillRound(painter, option->rect.adjusted(1, 1, -1, -1), c.pressed);
    else if (on)
        fillRound(painter, option->rect.adjusted(1, 1, -1, -1), c.selection,
                  c.dark ? c.accent.darker(160) : c.accent.lighter(150));
    else if (isHovered(option))
        fillRound(painter, option->rect.adjusted(1, 1, -1, -1), c.hover);
}

void drawLineEdit(const QStyleOption* option, QPainter* painter, const QWidget* widget) {
    const ThemeColors& c = colors();
    if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option); frame && frame->lineWidth > 0) {
        const bool focus = option->state & QStyle::State_HasFocus;
        fillRound(painter, option->rect, isEnabled(option) ? c.base : c.window, focus ? c.accent : c.border);
    } else if (widget && widget->parentWidget() && !qobject_cast<QComboBox*>(widget->parentWidget())) {
        painter->fillRect(option->rect, option->palette.brush(QPalette::Base));
    }
}

void drawFrame(const QStyleOption* option, QPainter* painter, const QColor& line) {
    painter->save();
    painter->setPen(line);
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    painter->restore();
}

void drawCheckBox(const QStyleOption* option, QPainter* painter) {
    const ThemeColors& c = colors();
    const bool enabled = isEnabled(option), hover = isHovered(option);
    const QRectF box = QRectF(option->rect).adjusted(1, 1, -1, -1);
    const bool on = option->state & QStyle::State_On, partly = option->state & QStyle::State_NoChange;
    const QColor fill = !enabled ? c.window : (on || partly) ? c.accent : hover ? c.hover : c.base;
    fillRound(painter, box, fill,
              !enabled                                   ? c.divider
              : (on || partly)                           ? c.accent
              : (option->state & QStyle::State_HasFocus) ? c.accent
                                                         : c.border,
              2.5);
    const QColor ink = enabled ? c.onAccent : c.disabled;
    const QPointF o = box.topLeft();
    const qreal w = box.width(), h = box.height();
    if (on)
        strokePath(painter,
                   QPolygonF({o + QPointF(0.22 * w, 0.52 * h), o + QPointF(0.42 * w, 0.72 * h),
                              o + QPointF(0.78 * w, 0.3 * h)}),
                   ink, 1.7);
    else if (partly)
        strokePath(painter, QPolygonF({o + QPointF(0.25 * w, 0.5 * h), o + QPointF(0.75 * w, 0.5 * h)}), ink, 1.7);
}

void drawRadioButton(const QStyleOption* option, QPainter* painter) {
    const ThemeColors& c = colors();
    const bool enabled = isEnabled(option), hover = isHovered(option);
    const QRectF box = QRectF(option->rect).adjusted(1.5, 1.5, -1.5, -1.5);
    const bool on = option->state & QStyle::State_On;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(on && enabled ? c.accent : c.border, on ? 4 : 1));
    painter->setBrush(enabled ? (hover && !on ? c.hover : c.base) : c.window);
    painter->drawEllipse(on ? box.adjusted(1.5, 1.5, -1.5, -1.5) : box);
    painter->restore();
}

void drawToolBarSeparator(const QStyleOption* option, QPainter* painter) {
    const ThemeColors& c = colors();
    painter->save();
    painter->setPen(c.border);
    const QRect r = option->rect;
    if (option->state & QStyle::State_Horizontal)
        painter->drawLine(r.center().x(), r.top() + 5, r.center().x(), r.bottom() - 5);
    else
        painter->drawLine(r.left() + 5, r.center().y(), r.right() - 5, r.center().y());
    painter->restore();
}

void drawTabClose(const QStyleOption* option, QPainter* painter) {
    const ThemeColors& c = colors();
    const bool hover = isHovered(option);
    const QRect box(option->rect.center() - QPoint(8, 8), QSize(17, 17));
    if (hover) fillRound(painter, box, c.pressed);
    const QPointF m = QRectF(box).center();
    const QColor ink = hover ? c.text : c.muted;
    strokePath(painter, QPolygonF({m + QPointF(-3, -3), m + QPointF(3, 3)}), ink, 1.4);
    strokePath(painter, QPolygonF({m + QPointF(3, -3), m + QPointF(-3, 3)}), ink, 1.4);
}

/// What a control lies on and what is around it; false for what Fusion draws.
bool drawGround(QStyle::PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                const QWidget* widget) {
    const ThemeColors& c = colors();
    switch (element) {
    case QStyle::PE_PanelButtonTool:
        drawToolButton(option, painter);
        return true;
    case QStyle::PE_PanelLineEdit:
        drawLineEdit(option, painter, widget);
        return true;
    case QStyle::PE_FrameLineEdit:
        return true;
    case QStyle::PE_Frame:
    case QStyle::PE_FrameTabWidget:
    case QStyle::PE_FrameDockWidget:
        if (widget && widget->inherits("QComboBoxPrivateContainer")) return false;
        drawFrame(option, painter, c.divider);
        return true;
    case QStyle::PE_FrameMenu:
        painter->save();
        painter->setPen(c.border);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
        return true;
    case QStyle::PE_PanelMenu:
        painter->fillRect(option->rect, c.raised);
        return true;
    case QStyle::PE_PanelTipLabel:
        painter->fillRect(option->rect, c.raised);
        painter->setPen(c.border);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        return true;
    case QStyle::PE_FrameGroupBox:
        fillRound(painter, option->rect, QColor(), c.divider);
        return true;
    case QStyle::PE_FrameFocusRect:
        if (!qobject_cast<const QAbstractItemView*>(widget)) fillRound(painter, option->rect, QColor(), c.accent);
        return true;
    case QStyle::PE_FrameTabBarBase:
        painter->save();
        painter->setPen(c.divider);
        painter->drawLine(option->rect.bottomLeft(), option->rect.bottomRight());
        painter->restore();
        return true;
    default:
        return false;
    }
}

/// The marks in controls and between them; false for what Fusion draws.
bool drawIndicator(QStyle::PrimitiveElement element, const QStyleOption* option, QPainter* painter) {
    const ThemeColors& c = colors();
    const QColor arrow = isEnabled(option) ? c.muted : c.disabled;
    switch (element) {
    case QStyle::PE_IndicatorCheckBox:
        drawCheckBox(option, painter);
        return true;
    case QStyle::PE_IndicatorRadioButton:
        drawRadioButton(option, painter);
        return true;
    case QStyle::PE_IndicatorBranch:
        if (option->state & QStyle::State_Children)
            drawArrow(painter, option->rect, option->state & QStyle::State_Open ? 0 : -90,
                      isHovered(option) ? c.text : c.muted);
        return true;
    case QStyle::PE_IndicatorArrowDown:
    case QStyle::PE_IndicatorSpinDown:
        drawArrow(painter, option->rect, 0, arrow);
        return true;
    case QStyle::PE_IndicatorArrowUp:
    case QStyle::PE_IndicatorSpinUp:
        drawArrow(painter, option->rect, 180, arrow);
        return true;
    case QStyle::PE_IndicatorArrowLeft:
        drawArrow(painter, option->rect, 90, arrow);
        return true;
    case QStyle::PE_IndicatorArrowRight:
        drawArrow(painter, option->rect, -90, arrow);
        return true;
    case QStyle::PE_IndicatorToolBarSeparator:
        drawToolBarSeparator(option, painter);
        return true;
    case QStyle::PE_IndicatorDockWidgetResizeHandle:
        return true;
    case QStyle::PE_IndicatorTabClose:
        drawTabClose(option, painter);
        return true;
    default:
        return false;
    }
}

} // namespace

bool drawFlat(QStyle::PrimitiveElement element, const QStyleOption* option, QPainter* painter, const QWidget* widget) {
    return drawGround(element, option, painter, widget) || drawIndicator(element, option, painter);
}

} // namespace plc::kit
