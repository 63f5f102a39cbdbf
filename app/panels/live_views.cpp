#include "app/panels/live_views.h"

#include "editor/kit/icons.h"
#include "editor/kit/inputs/expression_edit.h"
#include "editor/kit/long_task.h"
#include "editor/kit/message_text.h"
#include "editor/workspace/path_completion.h"
#include "hmi/alarms/alarm_export.h"
#include "hmi/check/unread_panels.h"
#include "hmi/model/json.h"
#include "hmi/texts/language_tags.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QToolBar>
#include <QUuid>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::app {

namespace {

/// In the place of the panel, where there is none to show.
void sayWhyEmpty(QWidget& place, const hmi::PanelProject& project) {
    const QStringList unread = hmi::unreadPanels(project.folder, project.panels);
    if (auto* label = qobject_cast<QLabel*>(&place))
        label->setText(
            unread.isEmpty()
                ? LiveViews::tr("This project has no panel yet.\nTo draw one, right-click Panels in the project tree "
                                "and choose New.")
                : LiveViews::tr("No panel can be read: %1.\nProblems says what is wrong; a double click "
                                "there opens the file as text.")
                      .arg(unread.join(QStringLiteral(", "))));
    place.setVisible(project.panels.empty());
}

} // namespace

LiveViews::LiveViews(editor::Workspace& workspace, editor::RunControl& control, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_control(control) {
    m_trace = new trace::TraceView;
    m_trace->setHold([this] { return m_control.hold(); });
    m_slider = new trace::TimeSlider;
    m_panelArea = new QWidget;
    auto* bar = new QToolBar(m_panelArea);
    bar->setIconSize({16, 16});
    m_panelChoice = new QComboBox(bar);
    m_panelChoice->setAccessibleName(tr("Panel shown"));
    m_panelChoice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    bar->addWidget(m_panelChoice);
    connect(bar->addAction(kit::icon(kit::Icon::FullScreen), tr("Full screen (Esc to exit)")), &QAction::triggered,
            this, [this] {
                if (m_player) m_player->setFullScreen(true);
            });
    connect(bar->addAction(kit::icon(kit::Icon::Export), tr("Export the alarm history…")), &QAction::triggered, this,
            &LiveViews::exportAlarms);
    auto* none = new QLabel(m_panelArea);
    none->setObjectName(QStringLiteral("noPanel"));
    none->setAlignment(Qt::AlignCenter);
    none->setWordWrap(true);
    m_emptyPanel = none;
    auto* layout = new QVBoxLayout(m_panelArea);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(m_emptyPanel, 1);
    m_panelArea->setMinimumSize(260, 160);
    connect(m_panelChoice, &QComboBox::activated, this, [this] { showPanel(m_panelChoice->currentText()); });

    connect(&workspace, &editor::Workspace::opened, this, &LiveViews::projectOpened);
    connect(&workspace, &editor::Workspace::closed, this, &LiveViews::projectClosed);
    connect(&workspace, &editor::Workspace::settingsChanged, this, &LiveViews::takeSettings);
    connect(&control, &editor::RunControl::sessionChanged, this, &LiveViews::sessionChanged);
    connect(&control, &editor::RunControl::sessionAboutToEnd, this, &LiveViews::sessionChanged);
    connect(&control, &editor::RunControl::viewedChanged, this, &LiveViews::viewedChanged);
    connect(&control, &editor::RunControl::refreshed, this, [this] {
        const auto program = m_control.session() ? m_control.session()->program() : nullptr;
        if (program != m_program) { // after an online change
            m_program = program;
            m_trace->programChanged();
        }
    });
    connect(m_slider, &trace::TimeSlider::positionChanged, this,
            [this](std::optional<trace::Position> position) { m_control.view(position); });
    connect(m_slider, &trace::TimeSlider::resumeRequested, this, [this](quint64 position) {
        m_control.view(position);
        if (auto resumed = m_control.resumeFromView(); !resumed) emit message(kit::messageText(resumed.error()), true);
    });
    connect(m_slider, &trace::TimeSlider::message, this, [this](const QString& text) { emit message(text, false); });
    connect(m_trace, &trace::TraceView::positionActivated, this,
            [this](quint64 position) { m_control.view(position); });
    connect(m_trace, &trace::TraceView::recordingShown, this, &LiveViews::recordingShown);
    connect(&control, &editor::RunControl::recordedMustClose, this, &LiveViews::closeRecording);
    connect(m_trace, &trace::TraceView::failed, this, [this](const QString& text) { emit message(text, true); });
    connect(m_trace, &trace::TraceView::noted, this, [this](const QString& text) { emit message(text, false); });
    m_complete = editor::pathCompletions(workspace);
    m_slider->setCompletionSource(m_complete);
    connect(&workspace, &editor::Workspace::analysed, this,
            [this](const std::shared_ptr<const analysis::CodeModel>& model) {
                if (m_design && !model->checked().analysis->hasErrors) m_design->setChecked(model->checked());
            });
}

LiveViews::~LiveViews() {
    if (m_trace) m_trace->disconnect(this);
    if (m_slider) m_slider->disconnect(this);
    if (m_slider) m_slider->setRecording(nullptr);
    if (m_trace && m_before) m_trace->setBeneath(nullptr);
    if (m_trace) m_trace->setRecording(nullptr);
    delete m_player; // its dock outlives the panels
}

void LiveViews::projectOpened() {
    m_trace->setFolder(m_workspace.folder() + "/traces");
    openTrace({});
    reloadPanels();
}

void LiveViews::projectClosed() {
    closeRecording();
    emit designsMustClose();
    delete m_player;
    m_design.reset();
    m_panels = std::make_shared<hmi::PanelProject>();
    m_alarmsInMemory.clear();
    m_panelChoice->clear();
    sayWhyEmpty(*m_emptyPanel, *m_panels);
    m_trace->setSetup({});
    m_slider->variable()->clear();
}

void LiveViews::openTrace(const QString& name) {
    if (!m_workspace.isOpen()) return;
    const auto& traces = m_workspace.project().traces;
    QString file =
        name.isEmpty() ? (traces.empty() ? QString() : QString::fromStdString(traces.front())) : name + ".trace.json";
    if (file.isEmpty()) {
        m_trace->setSetup({});
        return;
    }
    if (auto opened = m_trace->openSetup(m_workspace.folder() + "/traces/" + file); !opened)
        emit message(kit::messageText(opened.error()), true);
}

void LiveViews::saveTrace() {
    if (!m_trace->isModified() || m_trace->setupPath().isEmpty()) return;
    if (auto stored = m_trace->storeSetup(m_trace->setupPath()); !stored)
        emit message(kit::messageText(stored.error()), true);
}

void LiveViews::reloadPanels() {
    emit designsMustClose();
    delete m_player;
    m_design.reset();
    m_panelChoice->clear();
    if (!m_workspace.isOpen()) return;
    m_panels = std::make_shared<hmi::PanelProject>(hmi::loadPanelProject(m_workspace.project()));
    for (const hmi::NamedPanel& panel : m_panels->panels) m_panelChoice->addItem(panel.name);
    m_design = std::make_shared<hmi::DesignContext>(*m_panels);
    connectDesign();
    makePlayer();
    emit panelsChanged();
}

/// Beside designers that are open: what is drawn in them stays.
void LiveViews::takeSettings() {
    if (!m_design) return;
    m_panels->takeSettings(m_workspace.project(), m_design->areTextsChanged());
    if (m_player) m_player->projectChanged();
    emit panelsChanged();
}

/// Shows the start panel, where there is a panel at all.
void LiveViews::makePlayer() {
    sayWhyEmpty(*m_emptyPanel, *m_panels);
    if (m_panels->panels.empty()) return;
    m_player = new hmi::PanelPlayer(*m_panels, m_control.session(), m_panelArea);
    m_player->setAccessibleName(tr("Panel"));
    if (m_run.isEmpty()) m_run = QUuid::createUuid().toString();
    m_player->liveAlarms().setRun(m_run);
    keepAlarms();
    m_player->setLanguage(
        hmi::closestTag(m_panels->texts.settings().languages, QLocale())); // until somebody chooses one
    m_player->keepLanguageInProject();
    connectPlayer();
    showInPanel();
    showPanel(m_panels->startPanel.isEmpty() ? m_panels->panels.front().name : m_panels->startPanel);
}

void LiveViews::exportAlarms() {
    if (!m_player) return;
    const QString path = QFileDialog::getSaveFileName(m_panelArea, tr("Export the Alarm History"),
                                                      m_workspace.folder() + "/alarms.csv", tr("Tables (*.csv)"));
    if (path.isEmpty()) return;
    constexpr int Everything = 25'000;
    const std::string table =
        hmi::alarmsAsCsv(m_player->alarms().history({}, Everything), m_panels->texts, m_player->language());
    if (auto written = projects::writeFileAtomically(path.toStdString(), table); !written)
        emit message(kit::messageText(written.error()), true);
}

void LiveViews::connectDesign() {
    connect(m_design.get(), &hmi::DesignContext::saved, this, &LiveViews::panelsTaken); // also by a rename
    m_design->setCompletions(m_complete);
    m_design->setVariables([this]() -> const kit::VariableProvider& { return variables(); });
    m_design->setPicker([this](const QString& present) {
        return kit::pickVariable(variables(), present, QApplication::activeWindow());
    });
    connect(m_design.get(), &hmi::DesignContext::textsChanged, this, &LiveViews::designEdited);
    connect(m_design.get(), &hmi::DesignContext::alarmsChanged, this, &LiveViews::designEdited);
    connect(m_design.get(), &hmi::DesignContext::recipesChanged, this, &LiveViews::designEdited);
    connect(m_design.get(), &hmi::DesignContext::peopleChanged, this, &LiveViews::designEdited);
    connect(m_design.get(), &hmi::DesignContext::themesTaken, this, [this] {
        if (m_player) m_player->scene().setThemes(m_panels->themes);
        emit designEdited(); // what is wrong with them is a finding
    });
    connect(m_design.get(), &hmi::DesignContext::programChanged, this, &LiveViews::designEdited);
    m_design->setRun(m_control.session());
    if (m_workspace.model() && !m_workspace.model()->checked().analysis->hasErrors)
        m_design->setChecked(m_workspace.model()->checked());
}

void LiveViews::connectPlayer() {
    connect(m_design.get(), &hmi::DesignContext::alarmsChanged, this, [this] { keepAlarms(); });
    static_cast<QVBoxLayout*>(m_panelArea->layout())->addWidget(m_player, 1);
    connect(m_player, &hmi::PanelPlayer::writeRefused, this,
            [this](const QString& reason) { emit message(reason, true); });
    connect(m_player, &hmi::PanelPlayer::panelChanged, m_panelChoice, &QComboBox::setCurrentText);
    connect(m_player, &hmi::PanelPlayer::whyRequested, this, &LiveViews::whyRequested);
    // What the operator changes is what the editor shows. An editor with changes of its own has not seen it: to it the
    // file is one that somebody else wrote, and it asks before one of the two is lost.
    connect(m_player, &hmi::PanelPlayer::recipesSaved, this, [this] {
        if (!m_design) return;
        if (m_design->areRecipesChanged()) return m_panels->disk->forget(m_panels->recipesPath());
        m_panels->recipes = m_player->recipes();
        m_design->recipesReplaced();
    });
}

LiveViews::Kept LiveViews::release() {
    if (std::exchange(m_before, nullptr)) m_trace->setBeneath(nullptr); // it reads what ends with this window
    Kept kept{m_panels, m_design, nullptr, m_run, m_alarmsInMemory, m_trace->kept(), m_control.viewed()};
    if (m_player) {
        m_player->disconnect(this);
        m_player->disconnect(m_panelChoice);
        m_player->setParent(nullptr);
        kept.player.reset(m_player);
        m_player.clear();
    }
    m_trace->disconnect(this);
    return kept;
}

void LiveViews::restore(Kept kept) {
    m_panels = std::move(kept.panels);
    m_design = std::move(kept.design);
    m_run = kept.run;
    m_alarmsInMemory = kept.alarmsInMemory;
    m_trace->setFolder(m_workspace.folder() + "/traces");
    for (const hmi::NamedPanel& panel : m_panels->panels) m_panelChoice->addItem(panel.name);
    if (m_design) connectDesign();
    sayWhyEmpty(*m_emptyPanel, *m_panels);
    if (kept.player) {
        m_player = kept.player.release();
        connectPlayer();
        m_player->show();
        m_panelChoice->setCurrentText(m_player->panelName());
    }
    connectSession();
    m_trace->restore(std::move(kept.trace));
    m_control.view(kept.viewed); // an opened recording begins at its end
    viewedChanged();
    emit panelsChanged();
}

/// The alarm history outlives the window: on disk, beside what else is kept of the project.
void LiveViews::keepAlarms() {
    if (!m_player || m_panels->alarms.definitions().empty() || m_alarmsInMemory == m_panels->folder) return;
    if (const QString path = m_player->liveAlarms().storePath(); !path.isEmpty() && path != QLatin1String(":memory:"))
        return;
    const Result<void> kept = m_player->keepAlarmsInProject();
    if (kept) return;
    m_alarmsInMemory = m_panels->folder;
    emit message(tr("The alarm history is kept in memory only: %1").arg(kit::messageText(kept.error())), true);
}

/// The variables of the program as it is written now; it need not run.
const kit::VariableProvider& LiveViews::variables() {
    const auto model = m_workspace.model();
    if (!model || !model->checked().analysis->program || model->checked().analysis == m_variablesOf) return m_variables;
    m_variablesOf = model->checked().analysis;
    auto program = std::make_shared<image::CompiledProgram>();
    program->layout = m_variablesOf->program->layout;
    m_variables.setProgram(std::move(program));
    return m_variables;
}

void LiveViews::showPanel(const QString& name) {
    if (!m_player) return;
    m_player->showPanel(name);
    m_panelChoice->setCurrentText(name);
}

void LiveViews::sessionChanged() {
    closeRecording(); // a new controller is what one wants to see
    m_slider->setRecording(nullptr);
    m_trace->setRecording(nullptr);
    if (std::exchange(m_before, nullptr)) m_trace->setBeneath(nullptr);
    m_recording.reset();
    session::Session* session = m_control.isEnding() ? nullptr : m_control.session();
    m_run = QUuid::createUuid().toString();
    if (m_player) {
        m_player->setRun(session);
        m_player->liveAlarms().setRun(m_run);
    }
    if (m_design) m_design->setRun(session);
    connectSession();
}

void LiveViews::connectSession() {
    session::Session* session = m_control.isEnding() ? nullptr : m_control.session();
    if (!session) return;
    m_recording = std::make_unique<trace::RunRecording>(*session);
    m_program = session->program();
    m_trace->setRecording(m_recording.get());
    m_trace->programChanged();
    m_slider->setRecording(m_recording.get());
}

void LiveViews::recordingShown() {
    const auto opened = m_trace->openedRecording();
    m_slider->setRecording(opened ? opened.get() : m_recording.get());
    if (opened)
        m_control.showRecorded(opened->recordedRun(), m_trace->openedName());
    else if (m_control.showsRecorded())
        m_control.showRecorded(nullptr);
    showInPanel();
}

/// The panel shows what everything else shows: the controller, or the recording from a file.
void LiveViews::showInPanel() {
    const auto& shown = m_control.recorded();
    if (m_design) m_design->setRecording(shown);
    if (!m_player) return;
    m_player->setRecording(shown);
    if (shown) m_player->setPosition(m_control.viewed());
}

Result<void> LiveViews::runOtherwise(const std::vector<std::pair<QString, QString>>& changes) {
    session::Session* session = m_control.session();
    if (!session || !m_recording || !m_control.viewed()) return Error{errors::ControllerNotRunning(), {}};
    const history::Position end = session->history().statistics().end;
    m_control.pause(); // the values are there before the first scan
    if (auto resumed = m_control.resumeFromView(); !resumed) return resumed;
    for (const auto& [path, value] : changes) {
        if (auto written = m_control.write(path, value); !written) return written;
        const auto& channels = m_trace->setup().channels;
        const bool isThere = std::any_of(channels.begin(), channels.end(), [&path = path](const auto& channel) {
            return channel.expression == path.toStdString();
        });
        if (!isThere) m_trace->addChannel(path);
    }
    m_before = std::make_shared<const trace::BranchRecording>(*m_recording, end);
    m_trace->setBeneath(m_before);
    session->startThread(m_control.mode(), false);
    return {};
}

Result<void> LiveViews::openRecording(const QString& path) { return m_trace->openRecording(path); }
void LiveViews::closeRecording() { m_trace->closeRecording(); }

void LiveViews::viewedChanged() {
    const auto viewed = m_control.viewed();
    const QSignalBlocker blocker(m_slider.data());
    m_slider->setPosition(viewed);
    m_trace->showPosition(viewed);
    if (m_player) m_player->setPosition(viewed);
    if (m_design) m_design->setPosition(viewed);
}

Result<void> LiveViews::addPanel(const QString& name) {
    if (!m_workspace.isOpen()) return Error{errors::OpenProjectFirst(), ""};
    if (m_panels->find(name)) return Error{errors::PanelNameInUse(), name.toStdString()};
    QDir().mkpath(m_workspace.folder() + "/hmi");
    if (auto saved = hmi::savePanel(*m_panels, {name, {}}); !saved) return saved;
    if (auto kept = keepStartPanel(name); !kept) return kept;
    if (auto read = m_workspace.rereadProject(); !read) return read;
    if (!m_design || m_panels->panels.empty()) { // the first panel: texts and languages come into being with it
        reloadPanels();
        return {};
    }
    // Beside the others, so that designers that are open keep what was drawn in them.
    const auto at = std::find_if(m_panels->panels.begin(), m_panels->panels.end(),
                                 [&](const hmi::NamedPanel& each) { return each.name > name; });
    m_panels->panels.insert(at, hmi::NamedPanel{name, {}});
    m_panels->startPanel = m_panels->startOrFirst();
    listPanels();
    if (m_player) m_player->projectChanged();
    emit panelsChanged();
    return {};
}

/// Unless the project says otherwise, the first panel by name is shown at the start. One that is added does not take
/// its place.
Result<void> LiveViews::keepStartPanel(const QString& added) {
    const projects::Project& project = m_workspace.project();
    const QString& start = m_panels->startPanel;
    if (!project.startPanel.empty() || start.isEmpty() || start < added) return {};
    nlohmann::ordered_json json = project.json;
    json["hmi"]["startPanel"] = hmi::toUtf8(start);
    return m_workspace.saveProjectFile(json);
}

void LiveViews::listPanels() {
    const QString shown = m_panelChoice->currentText();
    m_panelChoice->clear();
    for (const hmi::NamedPanel& panel : m_panels->panels) m_panelChoice->addItem(panel.name);
    m_panelChoice->setCurrentText(m_player ? m_player->panelName() : shown);
}

/// Something of the operator side is another now.
void LiveViews::panelsTaken() {
    if (m_player) m_player->projectChanged();
    emit designEdited();
}

bool LiveViews::takePanelFile(const QString& name) {
    const bool isNew = !m_panels->find(name), isGood = m_panels->readPanel(name);
    if (!isGood || !m_design) {
        emit designEdited(); // what is wrong with it is a finding
        return isGood;
    }
    if (isNew) {
        if (!m_player) makePlayer();
        listPanels();
        emit panelsChanged();
    }
    m_design->panelReplaced(name);
    panelsTaken();
    return true;
}

bool LiveViews::takeTextsFile() {
    const bool isGood = m_panels->readTexts();
    if (isGood && m_design) m_design->textsReplaced();
    panelsTaken();
    return isGood;
}

bool LiveViews::takeAlarmsFile() {
    const bool isGood = m_panels->readAlarms();
    if (isGood && m_design) m_design->alarmsReplaced();
    panelsTaken();
    return isGood;
}

bool LiveViews::takeRecipesFile() {
    const bool isGood = m_panels->readRecipes();
    if (isGood && m_design) m_design->recipesReplaced();
    panelsTaken();
    return isGood;
}

bool LiveViews::takePeopleFile() {
    const bool isGood = m_panels->readPeople();
    if (isGood && m_design) m_design->peopleReplaced();
    panelsTaken();
    return isGood;
}

void LiveViews::removePanel(const QString& name) {
    m_panels->disk->forget(m_panels->panelPath(name));
    std::erase_if(m_panels->panels, [&](const hmi::NamedPanel& each) { return each.name == name; });
    if (m_panels->panels.empty()) delete m_player;
    sayWhyEmpty(*m_emptyPanel, *m_panels);
    if (m_player && m_player->panelName() == name) showPanel(m_panels->panels.front().name);
    listPanels();
    panelsTaken();
    emit panelsChanged();
}

Result<bool> LiveViews::saveRecording(const QString& path) {
    if (!m_control.session()) return Error{errors::NothingRecorded(), path.toStdString()};
    const editor::RunControl::Hold held = m_control.hold();
    Result<void> saved;
    const bool isDone = kit::LongTask::runAside(tr("Saving the recording…"), m_trace->window(),
                                                [&, session = m_control.session()](Progress& progress) {
                                                    saved = session->history().save(path.toStdString(), &progress);
                                                });
    if (isDone && !saved) return saved.error();
    return isDone;
}

} // namespace plc::app
