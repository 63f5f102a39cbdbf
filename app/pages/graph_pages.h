// The charts and ladders of a text: what is drawn in them edits the text, what happens in the text is seen in them, and
// they show and write the values of the running controller. Owned by the tabs; GUI thread.
#pragma once
#include "app/pages/online_marks.h"
#include "app/settings/settings.h"
#include "editor/debug/computed_scan.h"

namespace plc::app {

class GraphPages : public QObject {
    Q_OBJECT
public:
    GraphPages(EditorTabs& tabs, OnlineMarks& marks, editor::Workspace& workspace, editor::RunControl& control,
               Settings& settings);

    void add(StPage* page, editor::ChartView* chart);
    void add(StPage* page, editor::LadderView* ladder);

private:
    void connectGraph(StPage* page, editor::GraphView* graph);

    EditorTabs& m_tabs;
    OnlineMarks& m_marks;
    editor::Workspace& m_workspace;
    editor::RunControl& m_control;
    Settings& m_settings;
    editor::ComputedScan* m_computed;
};

} // namespace plc::app
