#include "editor/kit/bar_menu.h"

#include <QMenu>
#include <QToolBar>
#include <QToolButton>

namespace plc::kit {

QMenu* addBarMenu(QToolBar& bar, const QIcon& icon, const QString& text) {
    auto* menu = new QMenu(text, &bar);
    menu->setIcon(icon);
    QAction* action = menu->menuAction();
    action->setToolTip(text);
    bar.addAction(action);
    if (auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(action))) {
        button->setPopupMode(QToolButton::InstantPopup);
        button->setAccessibleName(text);
    }
    return menu;
}

} // namespace plc::kit
