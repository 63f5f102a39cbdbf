// Who tells whom in the main window: each signal of a part and what answers it. No logic: an answer of more than a few
// lines is a function of its own.
#include "app/main_window.h"

#include "app/documents/file_commands.h"
#include "app/documents/project_state.h"
#include "app/documents/unit_commands.h"
#include "app/frame/perspectives.h"
#include "app/frame/status_line.h"
#include "app/online/device_connections.h"
#include "app/online/devices_view.h"
#include "app/pages/editor_tabs.h"
#include "app/panels/design_findings.h"
#include "app/panels/live_views.h"
#include "app/panels/panel_files.h"
#include "app/project/problems_view.h"
#include "app/project/project_tree.h"
#include "app/project/search_view.h"
#include "app/start/start_page.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/fault_moment.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/work_strip.h"

#include <QStatusBar>

#include <map>

namespace plc::app {

/// What acts on the documents, from the parts there are.
void MainWindow::makeDocuments() {
    m_findings = new DesignFindings(*m_live, *m_problems, this);
    m_files = new PanelFiles(
        *m_workspace, *m_live,
        [this](const QString& file, const std::string& here, const std::string& onDisk) {
            return askAboutDiskChange(file, here, onDisk, this);
        },
        this);
    m_designs = new DesignPages({*this, *m_workspace, *m_tabs, *m_live, *m_files, *m_findings}, this);
    m_units = new UnitCommands({*this, *m_workspace, *m_control, *m_tabs, *m_live, *m_search, *m_watch}, this);
    m_fileCommands = new FileCommands({*this, *m_workspace, *m_control, *m_tabs, *m_live, *m_designs}, this);
    m_state = std::make_unique<ProjectState>(
        ProjectState::Parts{m_settings, *m_workspace, *m_control, *m_tabs, *m_designs, *m_watch});
    connect(m_designs, &DesignPages::message, this, &MainWindow::say);
    connect(m_designs, &DesignPages::littleRoom, this, [this] {
        say(tr("%1 arranges the window for drawing panels")
                .arg(action("view.panelDesign")->shortcut().toString(QKeySequence::NativeText)));
    });
    connect(m_units, &UnitCommands::message, this, &MainWindow::say);
    connect(m_units, &UnitCommands::usesShown, this, [this] { showDock("search"); });
    connect(m_fileCommands, &FileCommands::message, this, &MainWindow::say);
    connect(m_fileCommands, &FileCommands::traceMade, this, [this] { showDock("trace"); });
}

void MainWindow::connectParts() {
    makeDocuments();
    connectStart();
    connectTree();
    connectDesigns();
    connectSearch();
    connectEditors();
    connectViews();
    connectRun();
    connectTests();
    connectInside();
    new editor::FaultMoment(*m_control, this);
    connect(m_workspace, &editor::Workspace::opened, this, &MainWindow::updateActions);
    connect(m_workspace, &editor::Workspace::closed, this, &MainWindow::updateActions);
}

void MainWindow::connectStart() {
    connect(m_startPage, &StartPage::projectRequested, this, &MainWindow::openProject);
    connect(m_startPage, &StartPage::exampleRequested, this, &MainWindow::openExample);
    connect(m_startPage, &StartPage::newRequested, this, &MainWindow::newProject);
    connect(m_startPage, &StartPage::openRequested, this, &MainWindow::chooseProject);
    connect(m_startPage, &StartPage::tourRequested, this, &MainWindow::startTour);
}

void MainWindow::connectTree() {
    connect(m_tree, &ProjectTree::placeRequested, this,
            [this](const QString& file, uint32_t offset) { m_tabs->goTo(file, offset); });
    connect(m_tree, &ProjectTree::chartRequested, m_tabs, &EditorTabs::showChart);
    connect(m_tree, &ProjectTree::newUnitRequested, m_units, &UnitCommands::newUnit);
    connect(m_tree, &ProjectTree::renameRequested, m_units, &UnitCommands::renameSymbol);
    connect(m_tree, &ProjectTree::deleteRequested, m_units, &UnitCommands::deleteUnit);
    connect(m_tree, &ProjectTree::newPanelRequested, m_designs, &DesignPages::newPanel);
    connect(m_tree, &ProjectTree::newTraceRequested, m_fileCommands, &FileCommands::newTrace);
    connect(m_tree, &ProjectTree::renameFileRequested, m_fileCommands, &FileCommands::rename);
    connect(m_tree, &ProjectTree::deleteFileRequested, m_fileCommands, &FileCommands::remove);
    connect(m_tree, &ProjectTree::watchRequested, this, [this](const QString& path) {
        m_watch->add(path);
        showDock("watch");
    });
    connect(m_tree, &ProjectTree::instanceRequested, m_units, &UnitCommands::showInstance);
    m_tree->setInstances([this](const QString& path) { return m_control->instanceAt(path); },
                         [this](const QString& block) { return m_control->instancesOf(block); });
    connect(m_tree, &ProjectTree::librariesRequested, this, &MainWindow::chooseLibraries);
    connect(m_tree, &ProjectTree::testsRequested, this, &MainWindow::runTests);
    connect(m_tree, &ProjectTree::traceRequested, this, [this](const QString& name) {
        m_live->openTrace(name);
        showDock("trace");
    });
    connect(m_tree, &ProjectTree::panelRequested, this, [this](const QString& name) {
        m_live->showPanel(name);
        m_designs->openPanel(name);
    });
    connect(m_tree, &ProjectTree::textsRequested, m_designs, &DesignPages::openTexts);
    connect(m_tree, &ProjectTree::alarmsRequested, m_designs, &DesignPages::openAlarms);
    connect(m_tree, &ProjectTree::recipesRequested, m_designs, &DesignPages::openRecipes);
    connect(m_tree, &ProjectTree::peopleRequested, m_designs, &DesignPages::openPeople);
    connect(m_tree, &ProjectTree::themesRequested, m_designs, [this] { m_designs->editThemes(); });
    connect(m_tree, &ProjectTree::devicesRequested, this, [this] { showDock("devices"); });
}

/// Panels, texts and alarms: their pages, their findings, their files.
void MainWindow::connectDesigns() {
    connect(m_live, &LiveViews::designsMustClose, m_designs, &DesignPages::drop);
    connect(m_live, &LiveViews::message, this, &MainWindow::say);
    connect(m_files, &PanelFiles::message, this, &MainWindow::say);
    connect(m_files, &PanelFiles::changedStateChanged, m_tabs, &EditorTabs::markPage);
    connect(m_files, &PanelFiles::panelGone, this, [this](const QString& key) {
        if (QWidget* page = m_tabs->pageByKey(key)) m_tabs->closePage(m_tabs->indexOf(page));
    });
    connect(m_workspace, &editor::Workspace::saved, m_findings, &DesignFindings::schedule);
    connect(m_problems, &ProblemsView::elementRequested, this, &MainWindow::openDesignPlace);
    m_tabs->setMayClose([this](QWidget* page) { return m_designs->mayClose(page); });
}

void MainWindow::openDesignPlace(const QString& file, const QString& element) {
    if (file != "devices.json") return m_designs->openPlace(file, element);
    showDock("devices");
    DevicesView::of(*this).select(element);
}

void MainWindow::connectSearch() {
    connect(m_search, &SearchView::placeRequested, this,
            [this](const QString& file, uint32_t offset, uint32_t length) { m_tabs->goTo(file, offset, length); });
    connect(m_search, &SearchView::message, this, &MainWindow::say);
    connect(m_search, &SearchView::panelPlaceRequested, this, &MainWindow::openDesignPlace);
    m_search->setPanelTexts([this] {
        std::map<QString, std::string> texts;
        if (!m_live->design()) return texts;
        const hmi::PanelProject& panels = m_live->panels();
        for (const hmi::NamedPanel& panel : panels.panels)
            texts[panels.placeOf(panels.panelPath(panel.name))] = panel.panel.write();
        if (panels.hasAlarms) texts[panels.placeOf(panels.alarmsPath())] = panels.alarms.write();
        return texts;
    });
    connect(m_search, &SearchView::textsReplaced, m_tabs,
            [this](const std::map<QString, std::string>& texts) { m_tabs->applyTexts(texts); });
}

void MainWindow::connectEditors() {
    connect(m_tabs, &EditorTabs::renameRequested, m_units, &UnitCommands::renameTo);
    connect(m_workspace, &editor::Workspace::encodingFound, this, [this](const QString& file, const QString& encoding) {
        say(tr("%1 is encoded in %2 and will be saved in that encoding").arg(file, encoding), true);
    });
    connect(m_tabs, &EditorTabs::message, this, &MainWindow::say);
    connect(m_tabs, &QTabWidget::tabBarDoubleClicked, m_perspectives, &Perspectives::toggleMaximised);
    connect(m_tabs, &EditorTabs::saved, this, [this] {
        if (m_settings.changeOnSave() && m_control->isRunning() && !m_control->isUpToDate()) m_control->onlineChange();
    });
    connect(m_tabs, &EditorTabs::editorMade, this, [this](editor::StEditor* made) {
        connect(made, &editor::StEditor::definitionRequested, m_units, &UnitCommands::findDefinition);
        connect(made, &editor::StEditor::usesRequested, m_units, &UnitCommands::findUses);
        connect(made, &editor::StEditor::renameRequested, m_units, &UnitCommands::renameSymbol);
        connect(made, &editor::StEditor::watchRequested, this,
                [this, made](const QString& text) { watchAtCaret(*made, text); });
    });
}

/// A name inside a POU becomes the path of its instance.
void MainWindow::watchAtCaret(const editor::StEditor& made, const QString& text) {
    const QString pou = m_workspace->model()
                            ? QString::fromStdString(m_workspace->model()->pouAt(
                                  *m_workspace->model()->fileOf(made.file().toStdString()), made.cursorOffset()))
                            : QString();
    const QString instance = m_control->preferredInstance(pou);
    const bool local = !instance.isEmpty() && m_control->value(text, instance).reason.isEmpty() &&
                       !m_control->value(text).reason.isEmpty();
    m_watch->add(local ? instance + "." + text : text);
    showDock("watch");
}

void MainWindow::connectViews() {
    connect(m_problems, &ProblemsView::placeRequested, this,
            [this](const QString& file, uint32_t offset) { m_tabs->goTo(file, offset); });
    connect(m_watch, &editor::WatchView::traceRequested, this, [this](const QString& expression) {
        m_live->traceView().addChannel(expression);
        showDock("trace");
    });
    connect(m_breakpoints, &editor::BreakpointView::lineRequested, this,
            [this](const QString& file, int line) { m_tabs->goToLine(file, line); });
    connect(m_log, &editor::EventLog::lineRequested, m_tabs, &EditorTabs::goToLine);
    connect(m_watch, &editor::WatchView::instanceRequested, m_units, &UnitCommands::showInstance);
    connect(m_callPath, &editor::CallPathView::instanceChosen, m_control, &editor::RunControl::setPreferredInstance);
    connect(m_callPath, &editor::CallPathView::placeRequested, this,
            [this](const QString& file, uint32_t offset) { m_tabs->goTo(file, offset); });
}

void MainWindow::connectRun() {
    connect(m_control, &editor::RunControl::messageAdded, this,
            [this](const QString& text, bool isError) { statusBar()->showMessage(text, isError ? 8000 : 4000); });
    connect(m_control, &editor::RunControl::onlineChangeFinished, this, [this](const QString& text) { say(text); });
    connect(m_control, &editor::RunControl::workBegan, &m_status->work(), &kit::WorkStrip::begin);
    connect(m_control, &editor::RunControl::workEnded, &m_status->work(), &kit::WorkStrip::end);
    connect(m_control, &editor::RunControl::buildCancelled, this,
            [this] { say(tr("The build was cancelled; everything is as it was")); });
    connect(m_control, &editor::RunControl::buildFinished, this, [this](bool good, const QString& text) {
        say(text, !good);
        if (!good) showDock("problems");
    });
    connect(m_control, &editor::RunControl::halted, this, [this] { showDock("callPath"); });
}

} // namespace plc::app
