#include "editor/kit/studio_style.h"

#include "editor/kit/icons.h"
#include "editor/kit/style_painting.h"
#include "editor/kit/theme.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

namespace plc::kit {

namespace {

QColor inkOf(const QStyleOption* option) {
    return option->state & QStyle::State_Enabled ? colors().text : colors().disabled;
}

/// The tab that shows its picture alone; null for any other.
const QStyleOptionTab* asPicture(const QStyleOption* option, const QWidget* widget) {
    const auto* bar = qobject_cast<const QTabBar*>(widget);
    const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
    const bool isNarrow = bar && tab && bar->property(kNarrowTabs).toBool();
    return isNarrow && tab->tabIndex != bar->currentIndex() && !tab->icon.isNull() ? tab : nullptr;
}

} // namespace

StudioStyle::StudioStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void StudioStyle::polish(QWidget* widget) {
    QProxyStyle::polish(widget);
    if (qobject_cast<QAbstractButton*>(widget) || qobject_cast<QTabBar*>(widget) || qobject_cast<QScrollBar*>(widget) ||
        qobject_cast<QComboBox*>(widget))
        widget->setAttribute(Qt::WA_Hover);
}

int StudioStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    switch (metric) {
    case PM_ScrollBarExtent:
        return 11;
    case PM_ScrollBarSliderMin:
        return 28;
    case PM_SplitterWidth:
        return 5;
    case PM_DockWidgetSeparatorExtent:
        return 5;
    case PM_DockWidgetTitleMargin:
        return 5;
    case PM_ToolBarItemSpacing:
        return 2;
    case PM_ToolBarItemMargin:
        return 3;
    case PM_ToolBarFrameWidth:
        return 0;
    case PM_SmallIconSize:
        return 16;
    case PM_ToolBarIconSize:
        return 18;
    case PM_ButtonIconSize:
        return 16;
    case PM_TabBarTabHSpace:
        return 22;
    case PM_TabBarTabVSpace:
        return 10;
    case PM_TabBarBaseOverlap:
        return 0;
    case PM_TabBarTabOverlap:
        return 0;
    case PM_TabBarTabShiftHorizontal:
        return 0;
    case PM_TabBarTabShiftVertical:
        return 0;
    case PM_MenuPanelWidth:
        return 1;
    case PM_MenuVMargin:
        return 4;
    case PM_MenuBarPanelWidth:
        return 0;
    case PM_TreeViewIndentation:
        return 16;
    case PM_HeaderMargin:
        return 5;
    case PM_DefaultFrameWidth:
        return 1;
    default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

int StudioStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* data) const {
    switch (hint) {
    case SH_EtchDisabledText:
        return 0;
    case SH_DitherDisabledText:
        return 0;
    case SH_ItemView_ShowDecorationSelected:
        return 1;
    case SH_ScrollBar_Transient:
        return 0;
    case SH_ToolTip_WakeUpDelay:
        return 500;
    case SH_TabBar_CloseButtonPosition:
        return QTabBar::RightSide;
    case SH_Table_GridLineColor:
        return static_cast<int>(colors().divider.rgba());
    case SH_ComboBox_Popup:
        return 0;
    case SH_DialogButtonBox_ButtonsHaveIcons:
        return 0;
    default:
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
}

QSize StudioStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                    const QWidget* widget) const {
    QSize result = QProxyStyle::sizeFromContents(type, option, size, widget);
    switch (type) {
    case CT_PushButton:
        result = result.expandedTo(QSize(72, 28));
        break;
    case CT_LineEdit:
    case CT_ComboBox:
    case CT_SpinBox:
        result.setHeight(std::max(result.height(), 26));
        break;
    case CT_ItemViewItem:
        result.setHeight(std::max(result.height(), 22));
        break;
    case CT_MenuItem:
        if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
            item && item->menuItemType != QStyleOptionMenuItem::Separator)
            result.setHeight(std::max(result.height(), 26));
        break;
    case CT_MenuBarItem:
        result += QSize(4, 4);
        break;
    case CT_TabBarTab:
        if (const QStyleOptionTab* tab = asPicture(option, widget)) result.setWidth(tab->iconSize.width() + 14);
        break;
    case CT_ToolButton:
        result = result.expandedTo(QSize(26, 26));
        break;
    case CT_HeaderSection:
        result.setHeight(std::max(result.height(), 24));
        break;
    default:
        break;
    }
    return result;
}

void StudioStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
    if (element == PE_PanelButtonCommand && drawButton(option, painter)) return;
    if (drawFlat(element, option, painter, widget)) return;
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

bool StudioStyle::drawButton(const QStyleOption* option, QPainter* painter) const {
    const ThemeColors& c = colors();
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
    const bool enabled = option->state & State_Enabled, hover = enabled && (option->state & State_MouseOver);
    const bool down = option->state & (State_Sunken | State_On);
    const bool isDefault = button && (button->features & QStyleOptionButton::DefaultButton) && enabled;
    if (button && (button->features & QStyleOptionButton::Flat) && !down && !hover) return true;
    if (isDefault) {
        fillRound(painter, option->rect, down ? c.accent.darker(115) : hover ? c.accent.lighter(108) : c.accent);
        return true;
    }
    const QColor line = option->state & State_HasFocus ? c.accent : enabled ? c.border : c.divider;
    fillRound(painter, option->rect, !enabled ? c.window : down ? c.pressed : hover ? c.hover : c.raised, line);
    return true;
}

bool StudioStyle::drawTab(const QStyleOption* option, QPainter* painter) const {
    const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
    if (!tab) return false;
    const ThemeColors& c = colors();
    const bool open = tab->state & State_Selected,
               hover = (tab->state & State_MouseOver) && (tab->state & State_Enabled);
    const QRect r = tab->rect;
    painter->fillRect(r, open ? c.base : hover ? c.hover : c.window);
    painter->save();
    painter->setPen(c.divider);
    switch (tab->shape) {
    case QTabBar::RoundedWest:
    case QTabBar::TriangularWest:
        painter->drawLine(r.bottomLeft(), r.bottomRight());
        if (open) painter->fillRect(QRect(r.left(), r.top(), 2, r.height()), c.accent);
        break;
    case QTabBar::RoundedEast:
    case QTabBar::TriangularEast:
        painter->drawLine(r.bottomLeft(), r.bottomRight());
        if (open) painter->fillRect(QRect(r.right() - 1, r.top(), 2, r.height()), c.accent);
        break;
    case QTabBar::RoundedSouth:
    case QTabBar::TriangularSouth:
        painter->drawLine(r.topRight(), r.bottomRight());
        if (open) painter->fillRect(QRect(r.left(), r.bottom() - 1, r.width(), 2), c.accent);
        break;
    default:
        painter->drawLine(r.topRight(), r.bottomRight());
        if (open) painter->fillRect(QRect(r.left(), r.top(), r.width(), 2), c.accent);
        break;
    }
    painter->restore();
    return true;
}

bool StudioStyle::drawMenuBarItem(const QStyleOption* option, QPainter* painter, const QWidget* widget) const {
    const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
    if (!item) return false;
    const ThemeColors& c = colors();
    painter->fillRect(item->rect, c.window);
    if (item->state & (State_Selected | State_Sunken) && item->state & State_Enabled)
        fillRound(painter, item->rect.adjusted(1, 2, -1, -2), item->state & State_Sunken ? c.pressed : c.hover);
    int flags = Qt::AlignCenter | Qt::TextShowMnemonic | Qt::TextDontClip | Qt::TextSingleLine;
    if (!styleHint(SH_UnderlineShortcut, item, widget, nullptr)) flags |= Qt::TextHideMnemonic;
    drawItemText(painter, item->rect, flags, item->palette, item->state & State_Enabled, item->text,
                 QPalette::ButtonText);
    return true;
}

void StudioStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
    const ThemeColors& c = colors();
    switch (element) {
    case CE_TabBarTabShape:
        if (drawTab(option, painter)) return;
        break;
    case CE_TabBarTabLabel:
        if (const QStyleOptionTab* tab = asPicture(option, widget)) {
            tab->icon.paint(painter, alignedRect(tab->direction, Qt::AlignCenter, tab->iconSize, tab->rect));
            return;
        }
        break;
    case CE_MenuBarItem:
        if (drawMenuBarItem(option, painter, widget)) return;
        break;
    case CE_MenuBarEmptyArea:
        painter->fillRect(option->rect, c.window);
        return;
    case CE_ToolBar:
        painter->fillRect(option->rect, c.window);
        return;
    case CE_Splitter:
        painter->fillRect(option->rect, option->state & State_MouseOver ? c.hover : c.window);
        return;
    case CE_HeaderSection:
    case CE_HeaderEmptyArea:
        painter->fillRect(option->rect, c.window);
        painter->save();
        painter->setPen(c.divider);
        painter->drawLine(option->rect.bottomLeft(), option->rect.bottomRight());
        if (element == CE_HeaderSection)
            painter->drawLine(option->rect.right(), option->rect.top() + 4, option->rect.right(),
                              option->rect.bottom() - 4);
        painter->restore();
        return;
    case CE_ProgressBarGroove:
        fillRound(painter, option->rect, c.hover);
        return;
    case CE_PushButtonLabel:
        if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option)) {
            QStyleOptionButton copy(*button);
            if ((button->features & QStyleOptionButton::DefaultButton) && (button->state & State_Enabled))
                copy.palette.setColor(QPalette::ButtonText, c.onAccent);
            QProxyStyle::drawControl(element, &copy, painter, widget);
            return;
        }
        break;
    default:
        break;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void StudioStyle::drawScrollBar(const QStyleOptionComplex* option, QPainter* painter, const QWidget* widget) const {
    const ThemeColors& c = colors();
    const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
    if (!slider) return;
    painter->fillRect(option->rect, option->palette.color(QPalette::Base));
    if (slider->minimum == slider->maximum) return;
    const QRect handle = subControlRect(CC_ScrollBar, option, SC_ScrollBarSlider, widget);
    const bool hot = option->activeSubControls & SC_ScrollBarSlider && option->state & (State_MouseOver | State_Sunken);
    QRectF body = slider->orientation == Qt::Horizontal ? QRectF(handle).adjusted(1, 3, -1, -2)
                                                        : QRectF(handle).adjusted(3, 1, -2, -1);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    QColor fill = hot ? c.muted : c.border;
    painter->setBrush(fill);
    const qreal radius = std::min(body.width(), body.height()) / 2;
    painter->drawRoundedRect(body, radius, radius);
    painter->restore();
}

void StudioStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                     const QWidget* widget) const {
    const ThemeColors& c = colors();
    const bool enabled = option->state & State_Enabled;
    switch (control) {
    case CC_ScrollBar:
        drawScrollBar(option, painter, widget);
        return;
    case CC_ComboBox:
        if (const auto* combo = qstyleoption_cast<const QStyleOptionComboBox*>(option)) {
            const bool hover = enabled && option->state & State_MouseOver, focus = option->state & State_HasFocus;
            const QColor ground = !enabled ? c.window : combo->editable ? c.base : hover ? c.hover : c.raised;
            if (combo->frame)
                fillRound(painter, option->rect, ground, focus ? c.accent : c.border);
            else
                painter->fillRect(option->rect, ground);
            drawArrow(painter, subControlRect(CC_ComboBox, option, SC_ComboBoxArrow, widget), 0,
                      enabled ? c.muted : c.disabled);
            return;
        }
        break;
    case CC_SpinBox:
        if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option)) {
            const bool focus = option->state & State_HasFocus;
            if (spin->frame)
                fillRound(painter, option->rect, enabled ? c.base : c.window, focus ? c.accent : c.border);
            else
                painter->fillRect(option->rect, enabled ? c.base : c.window);
            if (spin->buttonSymbols == QAbstractSpinBox::NoButtons) return;
            const QRect up = subControlRect(CC_SpinBox, option, SC_SpinBoxUp, widget),
                        down = subControlRect(CC_SpinBox, option, SC_SpinBoxDown, widget);
            drawArrow(painter, up, 180,
                      enabled && spin->stepEnabled & QAbstractSpinBox::StepUpEnabled ? inkOf(option) : c.disabled);
            drawArrow(painter, down, 0,
                      enabled && spin->stepEnabled & QAbstractSpinBox::StepDownEnabled ? inkOf(option) : c.disabled);
            return;
        }
        break;
    default:
        break;
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
}

QIcon StudioStyle::standardIcon(StandardPixmap pixmap, const QStyleOption* option, const QWidget* widget) const {
    switch (pixmap) {
    case SP_TitleBarCloseButton:
    case SP_DockWidgetCloseButton:
        return icon(Icon::Close);
    case SP_TitleBarNormalButton:
        return icon(Icon::Float);
    case SP_DirIcon:
    case SP_DirOpenIcon:
        return icon(Icon::Folder);
    case SP_FileIcon:
        return icon(Icon::File);
    case SP_MessageBoxInformation:
        return icon(Icon::Information);
    case SP_MessageBoxWarning:
        return icon(Icon::Warning);
    case SP_MessageBoxCritical:
        return icon(Icon::Error);
    case SP_MessageBoxQuestion:
        return icon(Icon::Question);
    case SP_LineEditClearButton:
        return icon(Icon::Clear);
    case SP_ToolBarHorizontalExtensionButton:
        return icon(Icon::ChevronRight);
    case SP_ToolBarVerticalExtensionButton:
        return icon(Icon::ChevronDown);
    default:
        return QProxyStyle::standardIcon(pixmap, option, widget);
    }
}

} // namespace plc::kit
