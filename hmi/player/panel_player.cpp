#include "hmi/player/panel_player.h"

#include "hmi/model/property_literals.h"
#include "hmi/player/player_status.h"
#include "hmi/player/pop_up.h"
#include "hmi/view/panel_keys.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLayout>

#include <utility>

namespace plc::hmi {

PanelPlayer::PanelPlayer(const PanelProject& project, session::Run* run, QWidget* parent)
    : QWidget(parent), m_project(project), m_station(project, run), m_view(new PanelView(this)),
      m_status(new PlayerStatus(this)) {
    setFocusPolicy(Qt::StrongFocus);
    new PanelKeys(*m_view);
    connectStation();
    setUpScene(scene());
    scene().setTheme(project.theme);
    watchTouches();
    updateStatus();
    if (!m_station.refusal().isEmpty()) m_status->setRefusal(look(), m_station.refusal());
    if (!project.startPanel.isEmpty()) showCurrent();
    m_timer.setInterval(33);
    connect(&m_timer, &QTimer::timeout, this, &PanelPlayer::frame);
    m_timer.start();
    resize(scene().size());
}

PanelPlayer::~PanelPlayer() {
    closeAnswer();
    // A button that is down must not stay down because the window was closed.
    while (navigation().closePopUp()) {
    }
    releasePress();
    scene().setValues(nullptr);
    m_station.disconnect(this);
}

void PanelPlayer::connectStation() {
    connect(&navigation(), &Navigation::panelChanged, this, &PanelPlayer::showCurrent);
    connect(&navigation(), &Navigation::popUpsChanged, this, &PanelPlayer::syncPopUps);
    m_station.setRights([this](const ElementId& element) { return refusedRoles(element); });
    connect(&m_station, &OperatorStation::sourcesAboutToChange, this, [this] {
        closeAnswer();
        scene().setValues(nullptr);
    });
    connect(&m_station, &OperatorStation::sourcesChanged, this, &PanelPlayer::showSources);
    connect(&m_station, &OperatorStation::languageChanged, this, &PanelPlayer::showLanguage);
    connect(&m_station, &OperatorStation::userChanged, this, &PanelPlayer::showUser);
    connect(&m_station, &OperatorStation::recipesChanged, this,
            [this] { onEachScene([this](PanelScene& one) { one.setRecipes(&recipes()); }); });
    connect(&m_station, &OperatorStation::recipesSaved, this, &PanelPlayer::recipesSaved);
    connect(&m_station, &OperatorStation::writeRefused, this, [this](const QString& reason) {
        m_status->setRefusal(look(), reason);
        emit writeRefused(reason);
    });
    connect(&m_station, &OperatorStation::refusalOver, this, [this] { m_status->setRefusal(look(), {}); });
}

void PanelPlayer::onEachScene(const std::function<void(PanelScene&)>& act) {
    act(scene());
    for (PopUp* popUp : popUps()) act(popUp->scene());
}

void PanelPlayer::releasePress() {
    if (scene().pressedView()) scene().release(QPointF(-1e6, -1e6));
}

/// What values and alarms are read from now.
void PanelPlayer::showSources() {
    onEachScene([this](PanelScene& one) {
        if (one.values() != values()) one.setValues(values());
        one.setAlarms(&alarms());
        one.setAlarmPosition(m_station.alarmPosition());
    });
    updateStatus();
}

void PanelPlayer::showLanguage() {
    onEachScene([this](PanelScene& one) { one.setLanguage(language()); });
    updateStatus();
    emit languageChanged(language());
}

bool PanelPlayer::showPanel(const QString& name) {
    if (!m_project.find(name)) return false;
    if (place().panel == name && panelName() == name) showCurrent(); // as it is now
    return navigation().open({name, {}});
}

void PanelPlayer::showPanel(const QString& name, const Panel& panel) {
    m_showsFrame = false;
    scene().setCurrentPanel(name);
    scene().setPanel(withArguments(panel, argumentsFor(panel)));
    m_shown = shownState();
    const bool isNew = m_station.setPanelName(name);
    updateStatus();
    if (isNew) emit panelChanged(name);
}

void PanelPlayer::follow(const Panel& panel, const Touched& touched) {
    scene().follow(withArguments(panel, argumentsFor(panel)), touched);
    m_shown = shownState();
}

/// What a panel with parameters is shown with: what it was opened with, else its defaults.
Arguments PanelPlayer::argumentsFor(const Panel& panel) const { return completed(parametersOf(panel), m_arguments); }

/// All that decides on what is drawn: the panel and what it places, as their files have it.
std::string PanelPlayer::shownState() const {
    std::string out = scene().panel().write();
    QStringList names;
    const std::function<void(const Panel&)> add = [&](const Panel& panel) {
        for (const Element& element : panel.elements()) {
            const QString name = element.kind() == ElementKind::Faceplate ? element.text("panel"_text) : QString();
            const Panel* placed = name.isEmpty() || names.contains(name) ? nullptr : scene().panelNamed(name);
            if (!placed) continue;
            names += name;
            out += placed->write();
            add(*placed);
        }
    };
    if (const NamedPanel* now = m_project.find(panelName())) {
        out += now->panel.write();
        add(now->panel);
    }
    if (m_showsFrame)
        if (const NamedPanel* frame = m_project.find(m_project.frame)) {
            out += frame->panel.write();
            add(frame->panel);
        }
    add(scene().panel());
    return out;
}

/// A project with people logs out who is not there any more.
void PanelPlayer::watchTouches() {
    if (m_project.people.timeout() > 0) QCoreApplication::instance()->installEventFilter(this);
}

void PanelPlayer::projectChanged() {
    watchTouches();
    scene().setTexts(&m_project.texts);
    // What is edited in a designer is seen here, too, as is a faceplate that this panel places.
    if (place().panel == panelName() && m_project.find(panelName())) {
        const std::string before = m_shown;
        if (shownState() != before) showCurrent();
    }
    if (m_station.isRecording()) releasePress();
    m_station.projectChanged();
    if (m_station.isRecording()) frame();
}

void PanelPlayer::setTheme(const QString& name) {
    scene().setTheme(name);
    for (PopUp* popUp : popUps()) popUp->scene().setTheme(scene().themeName());
    emit themeChanged(name);
}

void PanelPlayer::setReducedMotion(bool reduced) {
    onEachScene([reduced](PanelScene& one) { one.setReducedMotion(reduced); });
}

void PanelPlayer::setPosition(std::optional<history::Position> position) {
    if (!values()) return;
    m_station.setPosition(position);
    onEachScene([this](PanelScene& one) { one.setAlarmPosition(m_station.alarmPosition()); });
    frame();
}

void PanelPlayer::setRecording(std::shared_ptr<const session::Run> recording) {
    if (!recording && !m_station.isRecording()) return;
    closeAnswer();
    releasePress(); // what is down on the controller does not stay so
    m_station.setRecording(std::move(recording));
    frame();
}

void PanelPlayer::updateStatus() {
    const StationState state = m_station.state();
    m_status->setState(look(), state.text, state.weight);
    placeView();
}

void PanelPlayer::frame() {
    m_station.frame(std::chrono::steady_clock::now());
    updateStatus();
    if (m_view->isVisible()) m_view->frame();
}

QString PanelPlayer::stateText() const { return m_status->stateText(); }

Overlay* PanelPlayer::overlay() const { return findChild<Overlay*>(); }

/// The panel alone: in the studio it leaves its dock for the time and comes back into it.
void PanelPlayer::setFullScreen(bool full) {
    if (full == isFullScreen()) return;
    if (full) {
        m_isInDock = !isWindow();
        if (m_isInDock) setWindowFlag(Qt::Window);
        showFullScreen();
        setFocus();
        return;
    }
    showNormal();
    if (!std::exchange(m_isInDock, false)) return;
    setWindowFlag(Qt::Window, false);
    show();
    if (QWidget* place = parentWidget(); place && place->layout()) place->layout()->activate();
}

void PanelPlayer::placeView() {
    const QRect below = rect().adjusted(0, m_status->stripHeight(), 0, 0);
    if (m_view->geometry() != below) m_view->setGeometry(below);
}

void PanelPlayer::resizeEvent(QResizeEvent*) {
    const bool isPortrait = height() > width();
    const bool hasTurned = std::exchange(m_isPortrait, isPortrait) != isPortrait;
    if (hasTurned && place().panel == panelName() && !panelName().isEmpty()) showCurrent();
    placeView();
    m_status->setGeometry(rect());
    m_status->raise();
}

/// Whoever touches the panel, or what lies over it, is still there.
bool PanelPlayer::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::MouseButtonPress || type == QEvent::KeyPress || type == QEvent::TouchBegin)
        if (auto* widget = qobject_cast<QWidget*>(watched); widget && (widget == this || isAncestorOf(widget)))
            m_station.touch(std::chrono::steady_clock::now());
    return QWidget::eventFilter(watched, event);
}

void PanelPlayer::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F11) return setFullScreen(!isFullScreen());
    if (event->key() == Qt::Key_Escape && isFullScreen()) return setFullScreen(false);
    QWidget::keyPressEvent(event);
}

void PanelPlayer::showEvent(QShowEvent*) { frame(); }

} // namespace plc::hmi
