// What a window hands to the one that takes its place, in another language: project and controller as they are, and
// what the user has made and not saved. Owned by the function that changes the windows; GUI thread.
#pragma once
#include "app/panels/live_views.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/text/st_editor.h"

namespace plc::app {

struct Living {
    std::unique_ptr<editor::Workspace> workspace;
    std::unique_ptr<editor::RunControl> control; // looks at the workspace: dies before it
    LiveViews::Kept views;
    editor::EventLog::Kept log;
    editor::WatchView::Kept watches;
    types::NumberFormat watchFormat = types::NumberFormat::Decimal;
    std::vector<std::unique_ptr<editor::StEditor>> texts; // of open files: share the documents and their undo
    QStringList changedPanels;                            // designers with something to save
    QByteArray geometry;
};

} // namespace plc::app
