// The studio's window: docks around the open documents, the actions, the status line. It puts the parts together and
// holds no logic of its own: project and texts are the Workspace's, the controller the RunControl's. GUI thread.
#pragma once
#include "app/settings/settings.h"
#include "editor/debug/run_control.h"
#include "editor/workspace/workspace.h"

#include <QKeySequence>
#include <QMainWindow>
#include <QMap>

#include <memory>
#include <vector>

class QAction;
class QApplication;
class QDockWidget;
class QScreen;
class QStackedWidget;
class QToolButton;

namespace plc::kit {
class CommandPalette;
} // namespace plc::kit
namespace plc::editor {
class BreakpointView;
class CallPathView;
class EventLog;
class ForceView;
class StEditor;
class TaskMonitor;
class WatchView;
} // namespace plc::editor

namespace plc::app {

class DesignFindings;
class DesignPages;
class EditorTabs;
class FileCommands;
class InsideViews;
class LiveViews;
class PanelFiles;
class Perspectives;
class SideBars;
struct Living;
class ProblemsView;
class ProjectState;
class ProjectTree;
class SearchView;
class StartPage;
class StatusLine;
class TestRunner;
class GuideView;
class TestView;
class Tour;
class UnitCommands;

/// One line of the action table: everything a menu, a toolbar, the palette and the shortcut editor need.
struct ActionSpec {
    const char* id;
    const char* menu; // "File", "Edit", … untranslated
    const char* text;
    const char* shortcut; // portable text
    int icon;             // kit::Icon, -1 = none
    void (*run)(class MainWindow&);
};

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(QWidget* parent = nullptr);
    /// Around what another window has released, which goes on meanwhile.
    explicit MainWindow(Living living);
    ~MainWindow() override;

    /// Of the first start, where nobody has chosen another: as large as the screen leaves room for it and its frame.
    [[nodiscard]] static QSize firstSize(const QScreen& screen);

    bool openProject(const QString& folder);
    void closeProject();
    void startTour();
    void openBeside();
    [[nodiscard]] GuideView& guide() { return *m_guide; }

    // the parts, for actions, pages and tests
    [[nodiscard]] Settings& settings() { return m_settings; }
    [[nodiscard]] editor::Workspace& workspace() { return *m_workspace; }
    [[nodiscard]] editor::RunControl& control() { return *m_control; }
    [[nodiscard]] EditorTabs& tabs() { return *m_tabs; }
    [[nodiscard]] ProblemsView& problems() { return *m_problems; }
    [[nodiscard]] ProjectTree& projectTree() { return *m_tree; }
    [[nodiscard]] SearchView& search() { return *m_search; }
    [[nodiscard]] editor::WatchView& watch() { return *m_watch; }
    [[nodiscard]] editor::EventLog& log() { return *m_log; }
    [[nodiscard]] Perspectives& perspectives() { return *m_perspectives; }
    [[nodiscard]] SideBars& sideBars() { return *m_sideBars; }
    [[nodiscard]] PanelFiles& panelFiles() { return *m_files; }
    [[nodiscard]] DesignPages& designs() { return *m_designs; }
    [[nodiscard]] UnitCommands& units() { return *m_units; }
    [[nodiscard]] FileCommands& projectFiles() { return *m_fileCommands; }
    [[nodiscard]] TestView& tests() { return *m_tests; }
    [[nodiscard]] LiveViews& live() { return *m_live; }
    [[nodiscard]] InsideViews& inside() { return *m_inside; }
    [[nodiscard]] StartPage& startPage() { return *m_startPage; }
    [[nodiscard]] QAction* action(const QString& id) const;
    [[nodiscard]] QList<QAction*> allActions() const { return m_actions; }
    void showDock(const QString& name);
    [[nodiscard]] QDockWidget* dock(const QString& name) const;
    void say(const QString& text, bool isError = false);

    // what actions do
    void newProject();
    void chooseProject();
    /// The user's own copy of a shipped example: the one made earlier, or a fresh one.
    bool openExample(const QString& example, bool fresh);
    void chooseLibraries();
    void openProjectSettings();
    void runTests();
    void openSettings();
    void openPalette();
    void resetLayout();
    void setSpeed();
    /// Asks for other values of the scan that is shown, and runs on from there with them.
    void whatIf();
    /// In the scan that is walked through, else in the controller.
    void step(session::Step how);
    /// In the scan that is walked through; begins a walk where there is none.
    void stepBack(session::Step how);
    void setHistoryBudget();
    void saveRecording();
    /// Where a finding lies: in a panel, the texts, the alarms or the devices.
    void openDesignPlace(const QString& file, const QString& element);
    void openRecording();
    void showRecording(const QString& path);
    void backToLive();
    /// Asks for the window to be built anew in the language of the settings, once no test runs.
    void changeLanguage();
    /// Everything that lives on; afterwards the window can only be destroyed.
    [[nodiscard]] Living release();
    void changeTheme(kit::ThemeChoice choice);
    void about();

signals:
    void rebuildRequested(); // in another language

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void makeActions();
    void makeDocks();
    void makeStatusLine();
    void connectParts(); // main_window_connections.cpp, like those it calls
    void makeDocuments();
    void connectStart();
    void connectTree();
    void connectDesigns();
    void connectSearch();
    void connectEditors();
    void connectViews();
    void connectRun();
    void watchAtCaret(const editor::StEditor& editor, const QString& text);
    void connectTests();
    void connectInside();
    QDockWidget* addDock(const QString& name, const QString& title, int icon, QWidget* widget, Qt::DockWidgetArea area);
    void takeRecordingSettings();
    void keepRecording();
    void updateActions();
    void updateRunActions();
    void report(const Result<void>& result);
    void build();
    void showProject();
    [[nodiscard]] QStringList tourExpressions() const;
    /// A project that nobody has arranged yet: room by the size of the window.
    void arrangeAtFirst();
    /// Its guide and its panel in sight, large enough to be read.
    void arrangeForExample();
    void saveProjectState();
    void restoreProjectState();
    void restoreLiving(Living living);
    void offerRecovery();
    void fillRecentMenu();

    Settings m_settings;
    editor::Workspace* m_workspace;
    editor::RunControl* m_control;
    QStackedWidget* m_stack;
    StartPage* m_startPage;
    EditorTabs* m_tabs;
    LiveViews* m_live;
    InsideViews* m_inside = nullptr;
    ProjectTree* m_tree = nullptr;
    ProblemsView* m_problems = nullptr;
    SearchView* m_search = nullptr;
    editor::WatchView* m_watch = nullptr;
    editor::ForceView* m_forces = nullptr;
    editor::CallPathView* m_callPath = nullptr;
    editor::BreakpointView* m_breakpoints = nullptr;
    editor::TaskMonitor* m_tasks = nullptr;
    editor::EventLog* m_log = nullptr;
    kit::CommandPalette* m_palette = nullptr;
    QMenu* m_recentMenu = nullptr;
    QList<QAction*> m_actions;
    QByteArray m_defaultLayout;
    StatusLine* m_status = nullptr;
    QToolButton* m_recordingButton = nullptr; // says that a recording from a file is shown; a click goes back
    DesignFindings* m_findings = nullptr;
    PanelFiles* m_files = nullptr;
    DesignPages* m_designs = nullptr;
    UnitCommands* m_units = nullptr;
    FileCommands* m_fileCommands = nullptr;
    std::unique_ptr<ProjectState> m_state; // kept for each project
    Perspectives* m_perspectives = nullptr;
    SideBars* m_sideBars = nullptr;
    bool m_changesLanguage = false; // when the tests have ended
    TestRunner* m_testRunner = nullptr;
    GuideView* m_guide;
    TestView* m_tests = nullptr;
};

[[nodiscard]] const std::vector<ActionSpec>& actionTable();
[[nodiscard]] QMap<QString, QKeySequence> defaultShortcuts(); // by the id of the action
/// The window anew in the language `tag`; project, controller and all that is unsaved go on.
[[nodiscard]] std::unique_ptr<MainWindow> inOtherLanguage(std::unique_ptr<MainWindow> window, QApplication& application,
                                                          const QString& tag);

} // namespace plc::app
