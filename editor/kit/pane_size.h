// Makes the pane that has the keyboard larger or smaller, as a mouse does at a splitter or at the edge of a dock.
// For the commands of the window and the keys of its dialogs; GUI thread.
#pragma once
#include <Qt>

class QWidget;

namespace plc::kit {

/// Of the splitter or dock nearest around `inside` that has a neighbour in this direction; false: there is none.
bool resizePane(QWidget* inside, Qt::Orientation along, int pixels);

} // namespace plc::kit
