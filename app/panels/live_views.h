// The views on the running controller that lie beside the code: trace, operator panel and the time slider over all of
// them. Puts them in step with the controller and with each other. Owned by the main window; GUI thread.
#pragma once
#include "editor/debug/run_control.h"
#include "editor/trace/recording/branch_recording.h"
#include "editor/trace/recording/run_recording.h"
#include "editor/trace/setup/program_variables.h"
#include "editor/trace/time_slider.h"
#include "editor/trace/trace_view.h"
#include "hmi/designer/context/design_context.h"
#include "hmi/player/panel_player.h"

#include <QObject>
#include <QPointer>

#include <memory>

class QComboBox;

namespace plc::app {

class LiveViews : public QObject {
    Q_OBJECT
public:
    LiveViews(editor::Workspace& workspace, editor::RunControl& control, QObject* parent);
    ~LiveViews() override;

    [[nodiscard]] trace::TraceView& traceView() { return *m_trace; }
    [[nodiscard]] trace::TimeSlider& slider() { return *m_slider; }
    [[nodiscard]] QWidget* panelArea() { return m_panelArea; }
    [[nodiscard]] hmi::PanelPlayer* player() { return m_player; }
    [[nodiscard]] hmi::PanelProject& panels() { return *m_panels; }

    void openTrace(const QString& name); // "" = the project's first set-up
    void saveTrace();
    void showPanel(const QString& name);
    void reloadPanels();
    /// What designers, text and alarm editors share; null without a project.
    [[nodiscard]] hmi::DesignContext* design() { return m_design.get(); }
    [[nodiscard]] std::shared_ptr<hmi::DesignContext> sharedDesign() const { return m_design; }
    [[nodiscard]] std::shared_ptr<hmi::PanelProject> sharedPanels() const { return m_panels; }
    /// A new, empty panel on disk.
    Result<void> addPanel(const QString& name);
    /// True when it was saved, false when it was cancelled.
    Result<bool> saveRecording(const QString& path);
    /// A recording from a file in all views; `closeRecording` goes back to the controller.
    Result<void> openRecording(const QString& path);
    void closeRecording();
    /// Goes back to the scan that is shown and runs on from there with these values; the trace draws what happened
    /// before beneath.
    Result<void> runOtherwise(const std::vector<std::pair<QString, QString>>& changes);
    /// A file as it is on disk now, in the place of what is shown and edited; false when it could not be understood.
    bool takePanelFile(const QString& name);
    bool takeTextsFile();
    bool takeAlarmsFile();
    bool takeRecipesFile();
    bool takePeopleFile();
    /// Its file is gone.
    void removePanel(const QString& name);

    /// What lives on when the window is built anew around the same controller: the panels as they are edited, the
    /// player with its alarms, the trace.
    struct Kept {
        std::shared_ptr<hmi::PanelProject> panels;
        std::shared_ptr<hmi::DesignContext> design;
        std::unique_ptr<hmi::PanelPlayer> player;
        QString run, alarmsInMemory;
        trace::TraceView::Kept trace;
        std::optional<history::Position> viewed;
    };
    [[nodiscard]] Kept release();
    void restore(Kept kept);

signals:
    void message(const QString& text, bool isError);
    void whyRequested(plc::kit::AskWhy question, const QString& expression); // from an element of the panel
    void panelsChanged();
    void designEdited();     // panels, texts or alarms: findings are looked for anew
    void designsMustClose(); // the panels are read anew: open designers, text and alarm editors close first

private:
    const kit::VariableProvider& variables();
    void projectOpened();
    void takeSettings();
    void projectClosed();
    void sessionChanged();
    void recordingShown();
    void showInPanel();
    void connectDesign();
    void makePlayer();
    void exportAlarms();
    Result<void> keepStartPanel(const QString& added);
    void listPanels();
    void panelsTaken();
    void connectPlayer();
    void connectSession();
    void keepAlarms();
    void viewedChanged();

    editor::Workspace& m_workspace;
    editor::RunControl& m_control;
    QPointer<trace::TraceView> m_trace;
    QPointer<trace::TimeSlider> m_slider;
    QPointer<QWidget> m_panelArea;
    QComboBox* m_panelChoice;
    QWidget* m_emptyPanel;
    std::shared_ptr<hmi::PanelProject> m_panels = std::make_shared<hmi::PanelProject>();
    std::shared_ptr<hmi::DesignContext> m_design;
    QPointer<hmi::PanelPlayer> m_player;
    QString m_run;            // of the controller, for the alarm history on disk
    QString m_alarmsInMemory; // the folder whose alarm history was said to be in memory
    kit::CompletionSource m_complete;
    trace::ProgramVariables m_variables; // of m_variablesOf
    std::shared_ptr<const sema::Analysis> m_variablesOf;
    std::unique_ptr<trace::RunRecording> m_recording;
    std::shared_ptr<const trace::BranchRecording> m_before; // of the branch that was gone back from
    std::shared_ptr<const image::CompiledProgram> m_program;
};

} // namespace plc::app
