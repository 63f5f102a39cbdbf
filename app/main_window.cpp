#include "app/main_window.h"

#include "app/documents/design_pages.h"
#include "app/documents/file_commands.h"
#include "app/documents/project_state.h"
#include "app/documents/unit_commands.h"
#include "app/frame/dock_tabs.h"
#include "app/frame/keyboard_commands.h"
#include "app/frame/long_message.h"
#include "app/frame/perspectives.h"
#include "app/frame/side_bars.h"
#include "app/frame/status_line.h"
#include "app/frame/sub_menus.h"
#include "app/online/device_connections.h"
#include "app/online/devices_view.h"
#include "app/online/inside_views.h"
#include "app/online/runs_menu.h"
#include "app/online/what_if_dialog.h"
#include "app/pages/editor_tabs.h"
#include "app/panels/design_findings.h"
#include "app/panels/live_views.h"
#include "app/panels/living.h"
#include "app/panels/panel_files.h"
#include "app/project/problems_view.h"
#include "app/project/project_tree.h"
#include "app/project/search_view.h"
#include "app/start/guide_view.h"
#include "app/start/start_page.h"
#include "app/start/tour.h"
#include "app/testing/test_runner.h"
#include "app/testing/test_view.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/command_palette.h"
#include "editor/kit/icons.h"
#include "editor/kit/long_task.h"
#include "editor/kit/message_text.h"
#include "editor/kit/mnemonics.h"
#include "editor/kit/work_strip.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/tuning/tuning_view.h"
#include "editor/workspace/path_completion.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <map>

namespace plc::app {

namespace {

// The menu has a word of its own where a language has two for Run.
[[maybe_unused]] constexpr const char* kMenus[] = {
    QT_TRANSLATE_NOOP("plc::app::Menu", "File"), QT_TRANSLATE_NOOP("plc::app::Menu", "Edit"),
    QT_TRANSLATE_NOOP("plc::app::Menu", "Run"),  QT_TRANSLATE_NOOP("plc::app::Menu", "Time"),
    QT_TRANSLATE_NOOP("plc::app::Menu", "View"), QT_TRANSLATE_NOOP("plc::app::Menu", "Help"),
};

QString titleOfMenu(const char* english) { return QCoreApplication::translate("plc::app::Menu", english); }

/// The buttons of a document's bars and what is in their menus: no key reaches them there.
QList<QAction*> actionsOfBars(QWidget* document) {
    QList<QAction*> out;
    if (!document) return out;
    for (const QToolBar* bar : document->findChildren<QToolBar*>())
        for (QAction* each : bar->actions()) {
            out << each;
            const auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(each));
            if (button && button->menu()) out << button->menu()->actions();
        }
    return out;
}

/// Qt's own action closes a dock that is behind another one's tab; this one brings it to the front.
QAction* makeToggle(MainWindow& window, QDockWidget& dock) {
    auto* toggle = new QAction(dock.windowTitle(), &window);
    toggle->setObjectName("dock." + dock.objectName());
    toggle->setCheckable(true);
    QObject::connect(&dock, &QDockWidget::visibilityChanged, toggle, &QAction::setChecked);
    QObject::connect(toggle, &QAction::triggered, &window, [&window, &dock, toggle](bool isWanted) {
        if (isWanted)
            window.showDock(dock.objectName());
        else
            dock.close();
        toggle->setChecked(dock.isVisible()); // one that slides out over the others is still behind its button
    });
    return toggle;
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), m_workspace(new editor::Workspace(this)),
      m_control(new editor::RunControl(*m_workspace, this)) {
    build();
}

MainWindow::MainWindow(Living living) : m_workspace(living.workspace.release()), m_control(living.control.release()) {
    m_workspace->setParent(this);
    m_control->setParent(this);
    build();
    restoreLiving(std::move(living));
}

QSize MainWindow::firstSize(const QScreen& screen) {
    return QSize(1440, 900).boundedTo(screen.availableSize() - QSize(24, 48));
}

void MainWindow::build() {
    setObjectName("studio");
    setWindowTitle("Stepwise");
    setDockOptions(
        AllowNestedDocks |
        AllowTabbedDocks); // not animated: Qt 6.4 may crash when a layout is restored while a dock still moves
    resize(firstSize(*screen()));
    m_stack = new QStackedWidget(this);
    m_startPage = new StartPage(m_settings, m_stack);
    m_tabs = new EditorTabs(*m_workspace, *m_control, m_settings, m_stack);
    m_live = new LiveViews(*m_workspace, *m_control, this);
    m_perspectives = new Perspectives(*this);
    m_sideBars = new SideBars(*this);
    new DockTabs(*this);
    takeRecordingSettings();
    for (QWidget* page : {static_cast<QWidget*>(m_startPage), static_cast<QWidget*>(m_tabs)})
        page->setMinimumSize(240, 120); // the page in the back does not keep docks small
    m_stack->addWidget(m_startPage);
    m_stack->addWidget(m_tabs);
    setCentralWidget(m_stack);
    makeDocks();
    kit::keepMnemonics(*qApp);
    makeActions();
    new PaneKeys(this, [this](PaneKeys::Change change) {
        using Change = PaneKeys::Change;
        return action(change == Change::Wider      ? "view.wider"
                      : change == Change::Narrower ? "view.narrower"
                      : change == Change::Taller   ? "view.taller"
                                                   : "view.shorter")
            ->shortcut();
    });
    makeStatusLine();
    connectParts();
    m_defaultLayout = saveState();
    for (QDockWidget* each : findChildren<QDockWidget*>()) each->setVisible(false);
    updateActions();
}

MainWindow::~MainWindow() {
    delete m_testRunner; // ends what it runs
    if (m_control) m_control->disconnectSession();
    delete m_stack; // open designers look at what the live views own
    // The other parts are destroyed with QObject, when this is no MainWindow any more that could hear them.
    for (QObject* part : findChildren<QObject*>()) part->disconnect(this);
}

// ------------------------------------------------------------------ building the window

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, int icon, QWidget* widget,
                                 Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(widget);
    dock->setWindowIcon(kit::icon(static_cast<kit::Icon>(icon)));
    m_sideBars->add(*dock);
    addDockWidget(area, dock);
    return dock;
}

void MainWindow::makeDocks() {
    using kit::Icon;
    m_tree = new ProjectTree(*m_workspace);
    m_problems = new ProblemsView(*m_workspace);
    m_search = new SearchView(*m_workspace);
    m_watch = new editor::WatchView(*m_control, *m_workspace);
    m_forces = new editor::ForceView(*m_control);
    m_callPath = new editor::CallPathView(*m_control);
    m_breakpoints = new editor::BreakpointView(*m_control);
    m_tasks = new editor::TaskMonitor(*m_control);
    m_log = new editor::EventLog(*m_control);
    m_testRunner = new TestRunner(*m_workspace, this);
    m_tests = new TestView(*m_workspace, *m_testRunner);
    m_inside = new InsideViews(*m_workspace, *m_control, *m_tabs, this);
    const auto i = [](Icon icon) { return static_cast<int>(icon); };
    addDock("project", tr("Project"), i(Icon::Project), m_tree, Qt::LeftDockWidgetArea);
    QDockWidget* watch = addDock("watch", tr("Watch"), i(Icon::Watch), m_watch, Qt::RightDockWidgetArea);
    QDockWidget* forces = addDock("forces", tr("Forces"), i(Icon::Force), m_forces, Qt::RightDockWidgetArea);
    tabifyDockWidget(watch, forces);
    m_guide = new GuideView;
    tabifyDockWidget(forces,
                     addDock("guide", tr("About This Project"), i(Icon::Help), m_guide, Qt::RightDockWidgetArea));
    connect(m_guide, &GuideView::fileRequested, this, [this](const QString& file) {
        if (m_workspace->files().contains(file)) m_tabs->openFile(file);
    });
    QDockWidget* calls = addDock("callPath", tr("Call Stack"), i(Icon::CallStack), m_callPath, Qt::RightDockWidgetArea);
    QDockWidget* breakpoints =
        addDock("breakpoints", tr("Breakpoints"), i(Icon::Breakpoint), m_breakpoints, Qt::RightDockWidgetArea);
    tabifyDockWidget(calls, breakpoints);
    QDockWidget* problems = addDock("problems", tr("Problems"), i(Icon::Warning), m_problems, Qt::BottomDockWidgetArea);
    QDockWidget* search = addDock("search", tr("Search"), i(Icon::Find), m_search, Qt::BottomDockWidgetArea);
    QDockWidget* tasks = addDock("tasks", tr("Tasks"), i(Icon::TaskMonitor), m_tasks, Qt::BottomDockWidgetArea);
    QDockWidget* log = addDock("log", tr("Log"), i(Icon::Log), m_log, Qt::BottomDockWidgetArea);
    QDockWidget* tests = addDock("tests", tr("Tests"), i(Icon::Test), m_tests, Qt::BottomDockWidgetArea);
    QDockWidget* why = addDock("why", tr("Why"), i(Icon::Question), &m_inside->whyView(), Qt::BottomDockWidgetArea);
    QDockWidget* slow =
        addDock("slowScan", tr("Slow Scan"), i(Icon::StepBack), &m_inside->slowScan(), Qt::BottomDockWidgetArea);
    QDockWidget* trace = addDock("trace", tr("Trace"), i(Icon::Trace), &m_live->traceView(), Qt::BottomDockWidgetArea);
    QDockWidget* panel = addDock("panel", tr("Panel"), i(Icon::Panel), m_live->panelArea(), Qt::RightDockWidgetArea);
    tabifyDockWidget(calls, panel);
    tabifyDockWidget(trace, problems);
    tabifyDockWidget(problems, search);
    tabifyDockWidget(search, tasks);
    tabifyDockWidget(tasks, log);
    tabifyDockWidget(log, tests);
    auto* tuning = new editor::TuningView(*m_control);
    connect(tuning, &editor::TuningView::message, this, &MainWindow::say);
    connect(tuning, &editor::TuningView::textEdits, this, [this](const auto& edits) { m_tabs->applyEdits(edits); });
    auto* roomForTuning = new QScrollArea; // four charts and a column of settings: wider than a small screen
    roomForTuning->setFrameShape(QFrame::NoFrame);
    roomForTuning->setWidgetResizable(true);
    roomForTuning->setWidget(tuning);
    roomForTuning->setAccessibleName(tr("Tuning"));
    tabifyDockWidget(tests, addDock("tuning", tr("Tuning"), i(Icon::Fit), roomForTuning, Qt::BottomDockWidgetArea));
    auto* devices = new DevicesView(DeviceConnections::of(*m_control, *m_workspace), *m_workspace);
    connect(devices, &DevicesView::message, this, &MainWindow::say);
    connect(devices, &DevicesView::problemsChanged, m_problems, &ProblemsView::setDeviceProblems);
    tabifyDockWidget(tests, addDock("devices", tr("Devices"), i(Icon::Link), devices, Qt::BottomDockWidgetArea));
    tabifyDockWidget(tests, why);
    tabifyDockWidget(why, slow);
    watch->raise();
    panel->raise();
    trace->raise();
    resizeDocks({dock("project")}, {230}, Qt::Horizontal);
    resizeDocks({watch}, {440}, Qt::Horizontal);
    // On a small screen the text keeps the larger part.
    resizeDocks({trace}, {std::min(400, screen()->availableGeometry().height() * 2 / 5)}, Qt::Vertical);
    resizeDocks({watch, panel}, {220, 400}, Qt::Vertical);
    auto* timeBar = new QToolBar(tr("Time"), this);
    timeBar->setObjectName("timeToolBar");
    timeBar->setMovable(false);
    m_live->slider().setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_recordingButton = new QToolButton(timeBar);
    m_recordingButton->setObjectName("recordingShown");
    m_recordingButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_recordingButton->setIcon(kit::icon(kit::Icon::Record));
    m_recordingButton->setToolTip(tr("All values are from a recording file. Click to go back to the controller."));
    connect(m_recordingButton, &QToolButton::clicked, this, &MainWindow::backToLive);
    QAction* recordingShown = timeBar->addWidget(m_recordingButton);
    recordingShown->setObjectName("recordingShownAction");
    recordingShown->setVisible(false);
    timeBar->addWidget(&m_live->slider());
    addToolBar(Qt::BottomToolBarArea, timeBar);
    timeBar->hide();
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea); // a watch wants rows
}

QDockWidget* MainWindow::dock(const QString& name) const { return findChild<QDockWidget*>(name); }

void MainWindow::showDock(const QString& name) {
    QDockWidget* shown = dock(name);
    if (!shown) return;
    if (m_sideBars->hidesItself(*shown)) return m_sideBars->reveal(*shown);
    shown->show();
    shown->raise();
}

void MainWindow::makeActions() {
    std::map<QString, QMenu*> menus;
    for (const ActionSpec& spec : actionTable()) {
        const QString menuName = titleOfMenu(spec.menu);
        QMenu*& menu = menus[menuName];
        if (!menu) {
            menu = menuBar()->addMenu(menuName);
            menu->menuAction()->setObjectName(QStringLiteral("menu.") + spec.menu); // its letter in Chinese
        }
        auto* made = new QAction(tr(spec.text), this);
        made->setObjectName(spec.id);
        if (spec.icon >= 0) made->setIcon(kit::icon(static_cast<kit::Icon>(spec.icon)));
        made->setShortcut(
            m_settings.shortcut(spec.id, QKeySequence(QString::fromLatin1(spec.shortcut), QKeySequence::PortableText)));
        made->setToolTip(
            made->shortcut().isEmpty()
                ? made->text()
                : QString("%1 (%2)").arg(made->text(), made->shortcut().toString(QKeySequence::NativeText)));
        const auto run = spec.run;
        connect(made, &QAction::triggered, this, [this, run] { run(*this); });
        // Cut, copy, paste, undo belong to whatever has the focus; the editor takes them itself.
        const QString id = spec.id;
        if (id == "edit.cut" || id == "edit.copy" || id == "edit.paste" || id == "edit.undo" || id == "edit.redo")
            made->setShortcutContext(Qt::WidgetShortcut);
        QMenu& in = subMenuFor(id, *menu);
        in.addAction(made);
        addAction(made);
        m_actions << made;
        if (id == "run.openRecording") {
            auto* runs = new RunsMenu(m_control->archive(), &in);
            in.addMenu(runs);
            connect(runs, &RunsMenu::runChosen, this, &MainWindow::showRecording);
        }
        if (id == "file.open") m_recentMenu = menu->addMenu(tr("Recent Projects"));
        for (const char* last :
             {"file.close", "file.closeOthers", "file.settings", "edit.redo", "edit.paste", "edit.goToLine",
              "edit.rename", "edit.previousProblem", "run.stop", "run.scan", "run.breakpoint", "run.resetOrigin",
              "run.history", "run.releaseAll", "view.values", "view.zoomOut"})
            if (id == last) menu->addSeparator();
        if (id == "view.panelDesign") in.addSeparator();
    }
    QMenu& docks = subMenuOfDocks(*menus[titleOfMenu("View")]);
    for (QDockWidget* each : findChildren<QDockWidget*>()) {
        QAction* toggle = makeToggle(*this, *each);
        toggle->setIcon(each->windowIcon());
        toggle->setShortcut(m_settings.shortcut(toggle->objectName(), {}));
        docks.addAction(toggle);
        m_actions << toggle;
    }
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);

    QToolBar* bar = addToolBar(tr("Main"));
    bar->setObjectName("mainToolBar");
    bar->setIconSize({20, 20});
    bar->setMovable(false);
    for (const char* id : {"file.save", "", "run.start", "run.pause", "run.stop", "run.scan", "run.change", "",
                           "run.stepIn", "run.stepOver", "run.stepOut", "run.breakpoint", "", "time.back",
                           "time.forward", "time.live", "", "run.tests", "view.palette"}) {
        if (!*id)
            bar->addSeparator();
        else
            bar->addAction(action(id));
    }
    kit::giveMnemonics(*menuBar());
    m_palette = new kit::CommandPalette(this, [this] { return allActions() + actionsOfBars(m_tabs->currentWidget()); });
}

QAction* MainWindow::action(const QString& id) const {
    for (QAction* each : m_actions)
        if (each->objectName() == id) return each;
    return nullptr;
}

void MainWindow::makeStatusLine() {
    m_status = new StatusLine(*statusBar(), *m_control, *m_workspace, *m_problems);
    new LongMessage(*statusBar(), *this);
    connect(m_status, &StatusLine::problemsRequested, this, [this] { showDock("problems"); });
    connect(m_status, &StatusLine::placeRequested, m_tabs, &EditorTabs::goTo);
    connect(m_status, &StatusLine::failed, this, [this] { showDock("callPath"); });
    connect(m_status, &StatusLine::changed, this, &MainWindow::updateRunActions);
    connect(m_tabs, &EditorTabs::cursorMoved, m_status,
            [this](const QString&, int line, int column) { m_status->showCursor(line, column); });
    connect(m_tabs, &EditorTabs::currentChanged, m_status, [this] { // the place is that of the text in front
        const editor::StEditor* editor = m_tabs->currentEditor();
        if (!editor) return m_status->hideCursor();
        int line = 0, column = 0;
        editor->getCursorPosition(&line, &column);
        m_status->showCursor(line + 1, column + 1);
    });
}

void MainWindow::whatIf() {
    if (m_control->showsRecorded() || !m_control->isOnline())
        return say(tr("What if? needs a running controller: a recording from a file cannot be resumed; press F5 to run "
                      "the program"),
                   true);
    if (!m_control->viewed()) m_control->stepView(-1);
    if (!m_control->viewed()) return;
    WhatIfDialog dialog(*m_control, m_watch->expressions(), editor::pathCompletions(*m_workspace), this);
    if (dialog.exec() != QDialog::Accepted) return;
    showDock("trace");
    report(m_live->runOtherwise(dialog.changes()));
}

void MainWindow::step(session::Step how) {
    if (m_inside->slowScan().isOpen()) return m_inside->slowScan().step(how);
    m_control->step(how);
}

void MainWindow::stepBack(session::Step how) {
    if (!m_inside->slowScan().isOpen()) showDock("slowScan");
    m_inside->slowScan().stepBack(how);
}

void MainWindow::connectInside() {
    connect(m_testRunner, &TestRunner::covered, m_inside, &InsideViews::showCoverage);
    connect(m_workspace, &editor::Workspace::closed, m_inside, &InsideViews::hideCoverage);
    connect(&m_inside->slowScan(), &editor::SlowScanView::moved, m_status, &StatusLine::refresh);
    connect(m_inside, &InsideViews::dockRequested, this, &MainWindow::showDock);
    connect(m_inside, &InsideViews::message, this, &MainWindow::say);
    const auto ask = [this](kit::AskWhy question, const QString& expression) { m_inside->ask(question, expression); };
    connect(m_watch, &editor::WatchView::whyRequested, this, ask);
    connect(m_tree, &ProjectTree::whyRequested, this, ask);
    connect(m_live, &LiveViews::whyRequested, this, ask);
    connect(&m_live->traceView(), &trace::TraceView::whyRequested, this,
            [this](kit::AskWhy question, const QString& expression, std::optional<history::Position> at) {
                m_inside->ask(question, expression, {}, at);
            });
    using Named = editor::StEditor::NamedValue;
    m_inside->addFocus([this]() -> std::optional<Named> {
        const QTreeWidgetItem* row = m_watch->tree().hasFocus() ? m_watch->tree().currentItem() : nullptr;
        return row ? std::optional(Named{editor::WatchView::expressionOf(row), {}}) : std::nullopt;
    });
    m_inside->addFocus([this]() -> std::optional<Named> {
        const QString path = m_tree->focusedVariable();
        return path.isEmpty() ? std::nullopt : std::optional(Named{path, {}});
    });
    m_inside->addFocus([this]() -> std::optional<Named> {
        const QString path = m_inside->whyView().focusedPath();
        return path.isEmpty() ? std::nullopt : std::optional(Named{path, {}});
    });
}

// ------------------------------------------------------------------ state

void MainWindow::updateActions() {
    const bool open = m_workspace->isOpen();
    for (QAction* each : m_actions) {
        const QString id = each->objectName();
        const bool always = id.startsWith("help.") || id.startsWith("view.") || id == "file.new" || id == "file.open" ||
                            id == "file.import" || id == "file.settings" || id == "file.quit";
        each->setEnabled(open || always);
    }
    m_status->refresh();
}

/// What may be done to the controller as it is now.
void MainWindow::updateRunActions() {
    using controller::State;
    const State state = m_control->status().state;
    const bool online = m_control->isOnline(), past = m_control->viewed().has_value();
    const bool recorded = m_control->showsRecorded();
    if (auto* shown = findChild<QAction*>("recordingShownAction")) shown->setVisible(recorded);
    m_recordingButton->setText(tr("%1 – back to live").arg(m_control->recordedName()));
    const auto enable = [this](std::initializer_list<const char*> ids, bool isEnabled) {
        for (const char* id : ids)
            if (QAction* each = action(id)) each->setEnabled(isEnabled);
    };
    enable({"time.live"}, past || recorded);
    enable({"time.resume"}, past && !recorded);
    const bool open = m_workspace->isOpen(), walks = m_inside->slowScan().isOpen();
    // Where nothing runs yet they start it.
    enable({"run.stepIn", "run.stepOver", "run.toCursor"}, open && (walks || state != State::Fault));
    enable({"run.stepOut"}, walks || (online && state == State::Halted));
    enable({"run.pause", "run.stop", "run.change"}, m_control->isRunning());
    enable({"time.back", "time.forward"}, online || recorded);
}

void MainWindow::say(const QString& text, bool isError) {
    statusBar()->clearMessage(); // the same one a second time is said again
    statusBar()->showMessage(text, isError ? 10000 : 4000);
    m_log->addMessage(text, isError);
}

void MainWindow::report(const Result<void>& result) {
    if (!result) say(kit::messageText(result.error()), true);
}

void MainWindow::openPalette() { m_palette->open(); }

void MainWindow::resetLayout() {
    m_perspectives->leaveMaximised();
    m_sideBars->restore({});
    restoreState(m_defaultLayout);
    for (QDockWidget* each : findChildren<QDockWidget*>()) each->setVisible(m_workspace->isOpen());
    findChild<QToolBar*>("timeToolBar")->setVisible(m_workspace->isOpen());
}

void MainWindow::changeTheme(kit::ThemeChoice choice) {
    m_settings.setTheme(choice);
    kit::Theme::current().setChoice(choice);
}

/// The program may end now: what was recorded is on disk first.
void MainWindow::keepRecording() {
    if (!m_control) return; // another window has it
    m_control->disconnectSession();
    if (m_control->archive().isWriting())
        kit::LongTask::runAside(tr("Keeping the recording of the last run…"), this,
                                [this](Progress& progress) { m_control->archive().wait(progress); });
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    // Where changes are not reported (network drives), coming back to the window is the moment to look.
    if (event->type() != QEvent::ActivationChange || !isActiveWindow() || !m_files) return;
    m_files->lookSoon();
    m_workspace->lookAtDisk();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (m_workspace->isOpen()) {
        saveProjectState();
        if (!m_designs->mayLeave()) return event->ignore();
        m_workspace->discardRecovery();
    }
    keepRecording();
    m_settings.setWindowGeometry(saveGeometry());
    event->accept();
}

} // namespace plc::app
