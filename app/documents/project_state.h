// What the window keeps for each project in the settings: open pages with their places, the layout of the docks, watch
// lists, breakpoints. Owned by the main window; GUI thread.
#pragma once
#include "app/documents/design_pages.h"
#include "app/settings/settings.h"
#include "editor/debug/run_control.h"
#include "editor/debug/watch_view.h"

namespace plc::app {

class ProjectState {
public:
    struct Parts {
        Settings& settings;
        editor::Workspace& workspace;
        editor::RunControl& control;
        EditorTabs& tabs;
        DesignPages& designs;
        editor::WatchView& watch;
    };
    explicit ProjectState(Parts parts) : m_parts(parts) {}

    void save(const QByteArray& layout, const QStringList& docksThatHide);
    /// Empty: nobody has arranged this project's window yet.
    [[nodiscard]] QByteArray layout() const;
    [[nodiscard]] QStringList docksThatHide() const;
    /// As they were open; else the main program.
    void restorePages();
    void restoreWatches(const QString& nameOfFirst);
    void restoreBreakpoints();

private:
    [[nodiscard]] QVariant value(const char* name) const;
    void keep(const char* name, const QVariant& value);

    Parts m_parts;
};

} // namespace plc::app
