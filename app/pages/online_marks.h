// What the running controller shows in the texts and their graphs: values beside the names, breakpoints, the line that
// is executed or has failed, the instance whose values a text shows. Owned by the tabs; GUI thread.
#pragma once
#include "app/pages/st_page.h"
#include "editor/debug/run_control.h"

namespace plc::app {

class EditorTabs;

class OnlineMarks : public QObject {
    Q_OBJECT
public:
    OnlineMarks(EditorTabs& tabs, editor::Workspace& workspace, editor::RunControl& control);

    void showBreakpoints();
    void showExecutedLine();
    /// Where the walk through a recorded scan is; none: where the controller is.
    void showWalk(std::optional<editor::TextPlace> place);
    /// Values of names as they are written in a POU.
    [[nodiscard]] editor::OnlineValues values();
    void askForValue(const QString& name, const QString& pou, bool force);
    [[nodiscard]] QString pathOf(const QString& name, const QString& pou) const;
    /// The same, and a message where there is none.
    [[nodiscard]] QString pathOrComplain(const QString& name, const QString& pou) const;

private:
    void refreshValues();
    void showInstance(StPage& page); // whose values its text shows
    void selectCause(uint32_t statement, uint32_t length);
    [[nodiscard]] bool isFollowedAt(const QString& file, uint32_t begin, uint32_t end) const;

    EditorTabs& m_tabs;
    editor::Workspace& m_workspace;
    editor::RunControl& m_control;
    unsigned m_frames = 0;
    std::optional<editor::TextPlace> m_walk;
    QString m_shownPlace; // where the controller stood when it was shown last
};

} // namespace plc::app
