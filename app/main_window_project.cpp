// What the main window's actions do with the project: open, new, rename, libraries, tests, and what is kept per
// project.
#include "app/documents/project_state.h"
#include "app/frame/kept_size.h"
#include "app/frame/perspectives.h"
#include "app/frame/side_bars.h"
#include "app/frame/speed_choice.h"
#include "app/frame/status_line.h"
#include "app/main_window.h"
#include "app/pages/editor_tabs.h"
#include "app/panels/live_views.h"
#include "app/project/libraries_dialog.h"
#include "app/project/new_project.h"
#include "app/project/project_settings_dialog.h"
#include "app/project/project_tree.h"
#include "app/project/search_view.h"
#include "app/settings/settings_dialog.h"
#include "app/start/guide_view.h"
#include "app/start/start_page.h"
#include "app/start/studio_tour.h"
#include "app/testing/test_log.h"
#include "app/testing/test_view.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/message_text.h"
#include "editor/kit/mnemonics.h"
#include "editor/kit/work_strip.h"
#include "projects/storage/project_file.h"

#include "stepwise_version.h"

#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLayout>
#include <QLocale>
#include <QMessageBox>
#include <QTimer>
#include <QToolBar>

#include <algorithm>

namespace plc::app {

// ------------------------------------------------------------------ open and close

bool MainWindow::openProject(const QString& folder) {
    const auto refused = [&](const Error& why) {
        m_settings.removeRecent(folder);
        m_startPage->reload();
        say(kit::messageText(why), true);
        QMessageBox::warning(this, tr("Open Project"), kit::messageText(why));
        return false;
    };
    // What is open, and runs, is only given up for a project that can be opened.
    if (const auto readable = projects::openProject({folder.toStdString()}); !readable)
        return refused(readable.error());
    closeProject();
    if (m_workspace->isOpen()) return false; // kept open because of unsaved changes
    if (auto opened = m_workspace->open(folder); !opened) return refused(opened.error());
    m_settings.addRecent(m_workspace->folder());
    showProject();
    m_state->restoreWatches(tr("Watch"));
    m_state->restoreBreakpoints();
    offerRecovery();
    return true;
}

void MainWindow::showProject() {
    const QSize before = size();
    setWindowTitle(tr("%1 – Stepwise").arg(QString::fromStdString(m_workspace->project().name)));
    m_stack->setCurrentWidget(m_tabs);
    for (QDockWidget* each : findChildren<QDockWidget*>()) each->show();
    m_guide->showProject(m_workspace->folder());
    restoreProjectState();
    findChild<QToolBar*>("timeToolBar")->show();
    KeptSize::keep(*this, before);
}

void MainWindow::closeProject() {
    if (!m_workspace->isOpen()) return;
    saveProjectState();
    if (!m_designs->mayLeave()) return;
    m_workspace->discardRecovery();
    m_workspace->close();
    m_sideBars->restore({}); // they are the project's
    for (QDockWidget* each : findChildren<QDockWidget*>()) each->hide();
    findChild<QToolBar*>("timeToolBar")->hide();
    m_startPage->reload();
    m_stack->setCurrentWidget(m_startPage);
    setWindowTitle("Stepwise");
}

void MainWindow::saveProjectState() {
    m_perspectives->leaveMaximised();
    m_state->save(saveState(), m_sideBars->stored());
}

void MainWindow::restoreProjectState() {
    const QByteArray layout = m_state->layout();
    restoreState(layout.isEmpty() ? m_defaultLayout : layout);
    if (layout.isEmpty()) arrangeAtFirst();
    m_sideBars->restore(m_state->docksThatHide());
    m_state->restorePages();
}

void MainWindow::offerRecovery() {
    const auto found = m_workspace->recoverable();
    if (found.empty()) return;
    QStringList names;
    for (const auto& [file, text] : found) names << file;
    const auto answer = QMessageBox::question(
        this, tr("Recovery"),
        tr("Stepwise was closed without saving. Unsaved changes to %1 were kept. Restore them?").arg(names.join(", ")));
    if (answer == QMessageBox::Yes)
        for (const auto& [file, text] : found) {
            m_workspace->setText(file, text);
            emit m_workspace->textReplaced(file);
        }
    else
        m_workspace->discardRecovery();
}

void MainWindow::fillRecentMenu() {
    m_recentMenu->clear();
    for (const QString& folder : m_settings.recentProjects())
        connect(m_recentMenu->addAction(
                    QString("%1  –  %2")
                        .arg(QFileInfo(folder).fileName(), QDir::toNativeSeparators(QFileInfo(folder).path()))),
                &QAction::triggered, this, [this, folder] { openProject(folder); });
    m_recentMenu->setEnabled(!m_recentMenu->isEmpty());
    kit::giveMnemonics(*m_recentMenu);
}

void MainWindow::newProject() {
    NewProjectDialog dialog(this);
    if (dialog.exec() != QDialog::Accepted) return;
    if (auto made = createProject(dialog.folder().toStdString(), dialog.name().toStdString(),
                                  dialog.templateId().toStdString());
        !made)
        return say(kit::messageText(made.error()), true);
    openProject(dialog.folder());
}

void MainWindow::chooseProject() {
    const QString example = StartPage::examplesFolder();
    const QString folder = QFileDialog::getExistingDirectory(
        this, tr("Open Project"), m_workspace->isOpen() ? m_workspace->folder() : m_settings.projectsFolder());
    if (folder.isEmpty()) return;
    if (!example.isEmpty() && QFileInfo(folder).canonicalPath() == example)
        openExample(folder, false);
    else
        openProject(folder);
}

bool MainWindow::openExample(const QString& example, bool fresh) {
    const auto copied = copyExample(example, m_settings.projectsFolder(), fresh);
    if (!copied) {
        say(kit::messageText(copied.error()), true);
        return false;
    }
    const auto& [copy, isNew] = *copied;
    const QSize before = size(); // opening may leave the window larger until its docks have settled
    if (!openProject(copy)) return false;
    if (isNew) {
        arrangeForExample();
        KeptSize::keep(*this, before);
    }
    say(isNew ? tr("This is a copy of the example, in %1: change what you like").arg(copy)
              : tr("This is your copy of the example, in %1").arg(copy));
    return true;
}

void MainWindow::arrangeAtFirst() {
    if (!m_guide->toPlainText().isEmpty()) showDock("guide"); // who opens it first wants to know what it is
    if (height() < 780) resizeDocks({dock("trace")}, {height() * 38 / 100}, Qt::Vertical);
    resizeDocks({dock("watch")}, {std::min(440, width() * 30 / 100)}, Qt::Horizontal);
    resizeDocks({dock("project")}, {std::min(230, width() * 15 / 100)}, Qt::Horizontal);
}

void MainWindow::arrangeForExample() {
    showDock("guide");
    showDock("panel");
    showDock("trace");
    QDockWidget *guide = dock("guide"), *panel = dock("panel");
    const bool hasPanel = !m_live->panels().panels.empty();
    resizeDocks({panel}, {width() * (hasPanel ? 42 : 30) / 100}, Qt::Horizontal);
    resizeDocks({dock("project")}, {width() * 12 / 100}, Qt::Horizontal);
    resizeDocks({guide, panel}, {height() * (hasPanel ? 30 : 60) / 100, height() * (hasPanel ? 50 : 20) / 100},
                Qt::Vertical);
    resizeDocks({dock("trace")}, {height() * 30 / 100}, Qt::Vertical);
}

// ------------------------------------------------------------------ libraries, tests

void MainWindow::chooseLibraries() {
    if (!m_workspace->isOpen()) return;
    LibrariesDialog dialog(m_workspace->project().libraries, this);
    if (dialog.exec() != QDialog::Accepted) return;
    nlohmann::ordered_json json = m_workspace->project().json;
    json["libraries"] = dialog.chosen();
    report(m_workspace->saveProjectFile(json));
}

void MainWindow::openProjectSettings() {
    if (!m_workspace->isOpen()) return;
    ProjectSettingsDialog dialog(m_workspace->project(), this);
    if (dialog.exec() == QDialog::Accepted) report(m_workspace->saveProjectFile(dialog.json()));
}

void MainWindow::runTests() {
    showDock("tests");
    m_tests->runAll();
}

void MainWindow::connectTests() {
    connect(m_tests, &TestView::placeRequested, m_tabs, &EditorTabs::goToLine);
    connect(m_tests, &TestView::recordingRequested, this, &MainWindow::showRecording);
    connect(m_testRunner, &TestRunner::started, this, [this](const std::shared_ptr<Progress>& work) {
        say(tr("Running tests…"));
        m_status->work().begin(tr("Tests"), work);
    });
    connect(m_testRunner, &TestRunner::workEnded, this, [this](const std::shared_ptr<Progress>& work) {
        m_status->work().end(work);
        if (m_changesLanguage) changeLanguage();
    });
    connect(m_testRunner, &TestRunner::failed, this, [this](const QString& message) { say(message, true); });
    connect(m_testRunner, &TestRunner::ended, this,
            [this](const std::shared_ptr<const testing::Report>& report, bool isCancelled) {
                logTests(*m_log, *report);
                if (report->hasErrors) showDock("log"); // why none could run
                if (isCancelled) say(tr("The tests were cancelled"));
                say(tr("%1 passed, %2 failed").arg(report->results.size() - report->failed()).arg(report->failed()),
                    report->failed() != 0 || report->hasErrors);
            });
}

// ------------------------------------------------------------------ settings and the like

void MainWindow::openSettings() {
    SettingsDialog dialog(m_settings, m_actions, defaultShortcuts(), this);
    if (dialog.exec() != QDialog::Accepted) return;
    changeTheme(m_settings.theme());
    m_tabs->applySettings();
    takeRecordingSettings();
    if (dialog.languageChanged()) changeLanguage();
}

void MainWindow::setSpeed() {
    if (const auto mode = chooseSpeed(this, m_control->mode())) m_control->setMode(*mode);
}

void MainWindow::setHistoryBudget() {
    bool ok = false;
    const int megabytes =
        QInputDialog::getInt(this, tr("Recording"), tr("Memory for the recording of every scan [MB]:"),
                             m_settings.historyMegabytes(), 16, 16384, 16, &ok);
    if (!ok) return;
    m_settings.setHistoryMegabytes(megabytes);
    takeRecordingSettings();
}

void MainWindow::takeRecordingSettings() {
    m_control->setHistoryBudget(static_cast<size_t>(m_settings.historyMegabytes()) << 20);
    m_control->archive().setBudget(static_cast<qint64>(m_settings.runsMegabytes()) << 20);
}

void MainWindow::openRecording() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open a Recording"), m_workspace->folder(), tr("Recordings (*.rec)"));
    if (!path.isEmpty()) showRecording(path);
}

void MainWindow::showRecording(const QString& path) {
    if (auto opened = m_live->openRecording(path); !opened) return say(kit::messageText(opened.error()), true);
    showDock("trace");
}

void MainWindow::backToLive() {
    if (m_control->showsRecorded()) m_live->closeRecording();
    m_control->view(std::nullopt);
}

void MainWindow::saveRecording() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save the Recording"), m_workspace->folder() + "/recording.rec", tr("Recordings (*.rec)"));
    if (path.isEmpty()) return;
    if (auto saved = m_live->saveRecording(path); !saved)
        say(kit::messageText(saved.error()), true);
    else
        say(*saved ? tr("Saved: %1").arg(path) : tr("Cancelled: nothing was saved"));
}

void MainWindow::about() {
    QMessageBox::about(this, tr("About Stepwise"),
                       tr("<h3>Stepwise %1</h3><p>An open PLC studio: IEC 61131-3 programs as native code, every scan "
                          "recorded, operator panels in many languages.</p><p>Licence: GPL-3.0</p>")
                           .arg(STEPWISE_VERSION));
}

void MainWindow::openBeside() {
    QStringList files = m_workspace->files();
    if (StPage* page = m_tabs->currentPage()) files.removeAll(page->file());
    if (files.isEmpty()) return say(tr("The project has no other file"), true);
    bool isChosen = false;
    const QString file =
        QInputDialog::getItem(this, tr("Open Another File Beside"), tr("File"), files, 0, false, &isChosen);
    if (isChosen) m_tabs->openBeside(file);
}

/// What the trace of the project is about, else its first variables.
QStringList MainWindow::tourExpressions() const {
    QStringList out;
    for (const trace::ChannelSetup& channel : m_live->traceView().setup().channels)
        if (out.size() < 4) out << QString::fromStdString(channel.expression);
    return out;
}

void MainWindow::startTour() {
    if (!m_workspace->isOpen()) {
        const QStringList examples = StartPage::examplesInstalled();
        if (examples.isEmpty())
            return say(tr("The tour runs on an example, and none is installed: open or create a project and start the "
                          "tour again"),
                       true);
        if (!openExample(examples.front(), false)) return;
    }
    auto* tour = new Tour(
        studioTour({GuideView::summaryOf(m_workspace->folder()), QString::fromStdString(m_workspace->project().name),
                    !m_live->panels().panels.empty(), m_tabs, [this](const char* name) { return dock(name); },
                    [this](const char* name) { return findChild<QToolBar*>(name); },
                    [this](const char* name) { showDock(name); },
                    [this] {
                        if (!m_control->isRunning()) m_control->start();
                    },
                    [this] {
                        if (m_watch->expressions().isEmpty()) m_watch->setExpressions(tourExpressions());
                    }}),
        this);
    connect(tour, &Tour::finished, this, [this, tour] {
        m_settings.setSawTour();
        tour->deleteLater();
    });
    tour->begin();
}

} // namespace plc::app
