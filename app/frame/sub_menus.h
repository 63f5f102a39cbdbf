// Which entries of the menu bar are a level deeper: a menu fits a screen of 700 pixels in every language. Functions;
// GUI thread.
#pragma once

class QMenu;
class QString;

namespace plc::app {

/// Where the action of that id is in `menu`: a submenu of it, made for the first of its actions, or `menu` itself.
QMenu& subMenuFor(const QString& action, QMenu& menu);
/// The submenu in which every dock is opened.
QMenu& subMenuOfDocks(QMenu& view);

} // namespace plc::app
