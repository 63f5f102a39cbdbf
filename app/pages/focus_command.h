// Commands of the Edit and View menus that mean whatever has the focus: a line being typed, a panel's elements, a
// chart, the text. GUI thread.
#pragma once

class QString;

namespace plc::app {

class EditorTabs;

/// "undo", "redo", "cut", "copy", "paste", "zoom-in", "zoom-out": by the widget with the focus or by one around it,
/// else by the page in front.
void runInFocus(EditorTabs& tabs, const QString& command);
/// Opens the cell with the focus for typing; false when there is none that can be changed.
[[nodiscard]] bool editFocusedCell();

} // namespace plc::app
