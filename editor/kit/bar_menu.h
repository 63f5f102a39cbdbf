// A menu in a tool bar that stays reachable where the bar is too narrow for all of its buttons: as an action it goes
// into the menu of the rest, which widgets do not. The bar owns it; GUI thread.
#pragma once
#include <QIcon>

class QMenu;
class QToolBar;

namespace plc::kit {

/// A button that opens the menu; `text` is its tool tip, and its title in the menu of the rest.
[[nodiscard]] QMenu* addBarMenu(QToolBar& bar, const QIcon& icon, const QString& text);

} // namespace plc::kit
