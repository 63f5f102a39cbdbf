// What one does with the files of a project in the tree: a new trace, rename and delete, with what leads to them.
// Owned by the main window; GUI thread.
#pragma once
#include "app/documents/design_pages.h"
#include "editor/debug/run_control.h"

#include <QObject>

namespace plc::app {

class FileCommands : public QObject {
    Q_OBJECT
public:
    struct Parts {
        QWidget& window; // of questions
        editor::Workspace& workspace;
        editor::RunControl& control;
        EditorTabs& tabs;
        LiveViews& live;
        DesignPages& designs;
    };
    FileCommands(Parts parts, QObject* parent);

    /// Asks for a name; the trace is shown.
    void newTrace();
    /// Kind and name as ProjectTree has them: "source" and "test" with a path in the project, "panel" and "trace" with
    /// the bare name. Each asks first.
    void rename(const QString& kind, const QString& name);
    void remove(const QString& kind, const QString& name);

signals:
    void message(const QString& text, bool isError = false);
    void traceMade();

private:
    void renameSource(const QString& from, const QString& to);
    /// Panels that lead there lead to the new name, and so does the project where it begins with this one.
    Result<void> leadTo(const QString& panel, const QString& newName);
    [[nodiscard]] QString questionBefore(const QString& kind, const QString& name) const;
    [[nodiscard]] QString pathOf(const QString& kind, const QString& name) const;
    [[nodiscard]] bool isShownTrace(const QString& path) const;
    bool report(const Result<void>& result);

    Parts m_parts;
};

} // namespace plc::app
