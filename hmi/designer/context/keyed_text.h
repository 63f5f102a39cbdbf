// Moves a text that stands in a panel into the text table, where it can be translated. Main thread.
#pragma once
#include "hmi/check/panel_check.h"
#include "hmi/designer/context/design_context.h"

class QUndoStack;

namespace plc::hmi {

/// The text that the finding is about gets a key in the table (a step of `undo`); the edit puts the key in its place.
/// Empty if the finding is about something else or the text needs no key.
Edit keyedText(const Finding& finding, const Panel& panel, const QString& panelName, DesignContext& context,
               QUndoStack& undo);

} // namespace plc::hmi
