#include "hmi/player/panel_player.h"
#include "editor/kit/message_text.h"

#include "editor/kit/post.h"
#include "hmi/player/player_status.h"
#include "hmi/player/pop_up.h"
#include "projects/storage/project_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QKeyEvent>
#include <QLayout>

#include <utility>

namespace plc::hmi {

namespace {
QString languageFileOf(const PanelProject& project) {
    return project.folder + QStringLiteral("/.stepwise/operator_language");
}
} // namespace

PanelPlayer::PanelPlayer(const PanelProject& project, session::Run* run, QWidget* parent)
    : QWidget(parent), m_project(project), m_run(nullptr), m_navigation(project.panelLookup()), m_logIn(project.people),
      m_view(new PanelView(this)), m_status(new PlayerStatus(this)) {
    setFocusPolicy(Qt::StrongFocus);
    m_alarms.setFile(project.alarms);
    m_alarmFile = project.alarms.write();
    if (project.hasAlarms) (void)m_alarms.openStore(QStringLiteral(":memory:"));
    connectScene(scene());
    connect(&m_navigation, &Navigation::panelChanged, this, &PanelPlayer::showCurrent);
    connect(&m_navigation, &Navigation::popUpsChanged, this, &PanelPlayer::syncPopUps);
    watchPeople();
    scene().setFolder(project.folder);
    scene().setPicturesOutside(project.picturesOutside);
    scene().setFaceplates(project.panelLookup());
    scene().setThemes(project.themes);
    scene().setTheme(project.theme);
    m_recipes = project.recipes;
    scene().setRecipes(&m_recipes);
    scene().setTexts(&project.texts);
    scene().setAlarms(&m_alarms);
    scene().setLanguage(project.texts.settings().languages.value(0, QStringLiteral("en")));
    setRun(run);
    if (!project.startPanel.isEmpty()) m_navigation.start({project.startPanel, {}});
    m_timer.setInterval(33);
    connect(&m_timer, &QTimer::timeout, this, &PanelPlayer::frame);
    m_timer.start();
    resize(scene().size());
}

PanelPlayer::~PanelPlayer() {
    closeAnswer();
    // A button that is down must not stay down because the window was closed.
    while (m_navigation.closePopUp()) {
    }
    if (scene().pressedView()) scene().release(QPointF(-1e6, -1e6));
    scene().setValues(nullptr);
}

void PanelPlayer::setRun(session::Run* run) {
    while (m_navigation.closePopUp()) { // they show values of the controller that goes
    }
    closeAnswer();
    scene().setValues(nullptr);
    m_watch.reset();
    m_values.reset();
    m_languageBinding = {};
    m_languageValue = {};
    m_recording.reset();
    m_recordedEvaluator.reset();
    scene().setAlarms(&m_alarms);
    scene().setAlarmPosition(std::nullopt);
    m_run = run;
    m_alarms.clear();
    if (run) {
        m_values = std::make_unique<PlcValues>(*run);
        if (!m_project.texts.settings().variable.isEmpty())
            m_languageBinding = m_values->bind(m_project.texts.settings().variable);
        if (const auto clock = m_values->clockAtZero()) m_alarms.setClockAtZero(*clock);
        if (!m_alarms.definitions().empty()) m_watch = std::make_unique<AlarmWatch>(*run, m_alarms);
        scene().setValues(m_values.get());
    }
    updateStatus();
}

void PanelPlayer::shareAlarms(PanelPlayer& station) {
    m_watch.reset();
    m_station = &station;
    scene().setAlarms(&alarms());
}

QString PanelPlayer::alarmStoreOf(const PanelProject& project) {
    return project.folder + QStringLiteral("/.stepwise/alarms.sqlite");
}

Result<void> PanelPlayer::keepAlarmsInProject() {
    const QString folder = m_project.folder + QStringLiteral("/.stepwise");
    QDir().mkpath(folder);
    if (const auto aside = m_alarms.keepAsideIn(folder + QStringLiteral("/alarms_aside.json")); !aside)
        refuse(kit::messageText(aside.error(), language()));
    return m_alarms.openStore(alarmStoreOf(m_project));
}

bool PanelPlayer::showPanel(const QString& name) {
    if (!m_project.find(name)) return false;
    if (m_navigation.current().panel == name && m_panelName == name) showCurrent(); // as it is now
    return m_navigation.open({name, {}});
}

void PanelPlayer::showPanel(const QString& name, const Panel& panel) {
    m_showsFrame = false;
    scene().setCurrentPanel(name);
    scene().setPanel(withArguments(panel, argumentsFor(panel)));
    m_shown = shownState();
    const bool isNew = std::exchange(m_panelName, name) != name;
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
            const QString name = element.kind() == ElementKind::Faceplate ? element.text("panel") : QString();
            const Panel* placed = name.isEmpty() || names.contains(name) ? nullptr : scene().panelNamed(name);
            if (!placed) continue;
            names += name;
            out += placed->write();
            add(*placed);
        }
    };
    if (const NamedPanel* now = m_project.find(m_panelName)) {
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

/// A project with people has a trail and logs out who is not there any more.
void PanelPlayer::watchPeople() {
    if (!m_project.people.isEmpty() && !m_project.folder.isEmpty() && !m_audit.isOpen())
        if (const auto kept = keepAuditIn(m_project.folder + QStringLiteral("/.stepwise/audit.csv")); !kept)
            m_refusal = kit::messageText(kept.error());
    if (m_project.people.timeout() > 0) QCoreApplication::instance()->installEventFilter(this);
}

void PanelPlayer::projectChanged() {
    watchPeople();
    scene().setTexts(&m_project.texts);
    // What is edited in a designer is seen here, too, as is a faceplate that this panel places.
    if (m_navigation.current().panel == m_panelName && m_project.find(m_panelName)) {
        const std::string before = m_shown;
        if (shownState() != before) showCurrent();
    }
    if (m_project.alarms.write() != m_alarmFile) {
        m_watch.reset();
        m_alarmFile = m_project.alarms.write();
        m_alarms.setFile(m_project.alarms);
        if (m_run && !m_alarms.definitions().empty()) m_watch = std::make_unique<AlarmWatch>(*m_run, m_alarms);
    }
    if (m_project.recipes.write() != m_recipes.write()) {
        m_recipes = m_project.recipes;
        scene().setRecipes(&m_recipes);
        for (PopUp* popUp : popUps()) popUp->scene().setRecipes(&m_recipes);
    }
    if (m_recording) setRecording(m_recording);
    if (!m_project.texts.settings().languages.contains(language()))
        setLanguage(m_project.texts.settings().languages.value(0));
}

void PanelPlayer::setTheme(const QString& name) {
    scene().setTheme(name);
    for (PopUp* popUp : popUps()) popUp->scene().setTheme(scene().themeName());
    emit themeChanged(name);
}

void PanelPlayer::setReducedMotion(bool reduced) {
    scene().setReducedMotion(reduced);
    for (PopUp* popUp : popUps()) popUp->scene().setReducedMotion(reduced);
}

void PanelPlayer::setLanguage(const QString& tag) {
    if (tag.isEmpty() || tag == language()) return;
    scene().setLanguage(tag);
    for (PopUp* popUp : popUps()) popUp->scene().setLanguage(tag);
    updateStatus();
    emit languageChanged(tag);
}

/// What an operator chose stays chosen when the panel is started again.
void PanelPlayer::rememberLanguage(const QString& tag) const {
    if (!m_remembersLanguage || m_project.folder.isEmpty()) return;
    QDir().mkpath(m_project.folder + QStringLiteral("/.stepwise"));
    // A folder that cannot be written forgets; the panel works all the same.
    (void)projects::writeFileAtomically(toUtf8(languageFileOf(m_project)), toUtf8(tag) + "\n");
}

void PanelPlayer::keepLanguageInProject() {
    m_remembersLanguage = true;
    const auto text = projects::readFile(toUtf8(languageFileOf(m_project)));
    const QString tag = text ? QString::fromStdString(*text).trimmed() : QString();
    if (m_project.texts.settings().languages.contains(tag)) requestLanguage(tag);
}

void PanelPlayer::requestLanguage(const QString& tag) {
    if (!m_project.texts.settings().languages.contains(tag)) return;
    setLanguage(tag);
    rememberLanguage(tag);
    // The program reads the language; until it has it, its older value must not switch back.
    if (!m_values || !m_languageBinding.isValid() || m_hasOwnLanguage) return;
    const ValueKind kind = m_values->facts(m_languageBinding).kind;
    const Value value = m_project.texts.settings().valueOf(tag, kind);
    if (value.isNone()) return;
    m_languageAsked = tag;
    if (!post(WriteRequest{{}, m_project.texts.settings().variable, WriteKind::Write, value, {}}).isEmpty())
        m_languageAsked.clear();
}

void PanelPlayer::followLanguageVariable() {
    if (m_hasOwnLanguage || !m_values || !m_languageBinding.isValid()) return;
    const Value& now = m_values->value(m_languageBinding);
    const QString tag = m_project.texts.settings().tagOf(now);
    if (!m_languageAsked.isEmpty()) {
        if (tag == m_languageAsked)
            m_languageAsked.clear(), m_languageValue = now;
        else if (now == m_languageValue)
            return; // the write is still on its way
        else
            m_languageAsked.clear(); // the program decided otherwise
    }
    if (now == m_languageValue) return;
    m_languageValue = now;
    if (!tag.isEmpty()) setLanguage(tag);
}

void PanelPlayer::setPosition(std::optional<history::Position> position) {
    if (!m_values) return;
    m_values->setPosition(position);
    if (m_recording && !position) {
        const history::Statistics there = m_recording->history().statistics();
        if (there.end > there.first) position = there.end - 1;
    }
    scene().setAlarmPosition(position ? std::optional<quint64>(*position) : std::nullopt);
    frame();
}

void PanelPlayer::setRecording(std::shared_ptr<const session::Run> recording) {
    if (!recording && !m_recording) return;
    closeAnswer();
    if (scene().pressedView()) scene().release(QPointF(-1e6, -1e6)); // what is down on the controller does not stay so
    m_recordedEvaluator.reset();
    m_recording = std::move(recording);
    m_languageAsked.clear();
    if (!m_values) {
        m_values = std::make_unique<PlcValues>(nullptr);
        if (!m_project.texts.settings().variable.isEmpty())
            m_languageBinding = m_values->bind(m_project.texts.settings().variable);
        scene().setValues(m_values.get());
    }
    m_values->setRun(m_recording ? m_recording.get() : m_run);
    if (m_recording) {
        m_recordedAlarms.clear();
        m_recordedAlarms.setFile(m_project.alarms);
        if (const auto clock = m_values->clockAtZero()) m_recordedAlarms.setClockAtZero(*clock);
        if (m_recording->program() && !m_recordedAlarms.definitions().empty())
            m_recordedEvaluator = std::make_unique<AlarmEvaluator>(*m_recording, m_recordedAlarms.definitions());
    } else if (!m_run) {
        scene().setValues(nullptr);
        m_values.reset();
        m_languageBinding = {};
        m_languageValue = {};
    }
    scene().setAlarms(&alarms());
    setPosition(std::nullopt);
    if (!m_recording) scene().setAlarmPosition(std::nullopt);
    updateStatus();
}

/// A piece of the recording per frame, so that a long one does not hold up the window.
void PanelPlayer::evaluateRecorded() {
    if (!m_recordedEvaluator) return;
    std::vector<AlarmFindings> findings;
    const bool more = m_recordedEvaluator->process(findings);
    for (const AlarmFindings& one : findings) {
        if (one.rewindTo) m_recordedAlarms.rewind(*one.rewindTo);
        m_recordedAlarms.take(one.records);
    }
    if (!more) m_recordedEvaluator.reset();
}

QString PanelPlayer::post(const WriteRequest& write, const QString& comment) {
    const auto say = [&](SystemText text) { return systemText(m_project.texts, text, language()); };
    const auto no = [&](const QString& reason) {
        refuse(reason);
        return reason;
    };
    if (m_isLocked && write.kind != WriteKind::Release) return no(say(SystemText::LogInFirst));
    if (m_recording && write.kind != WriteKind::Release) return no(say(SystemText::InThePast));
    if (!m_run || !m_values) return no(say(SystemText::NoController));
    const std::string path = write.target.toStdString();
    if (write.kind == WriteKind::Release) {
        if (m_pressed.remove(write.target)) m_run->release(path);
        return {};
    }
    if (m_values->position()) return no(say(SystemText::InThePast));
    const PanelScene* shownIn = nullptr;
    if (const ElementView* view = viewOf(write.element, &shownIn); view && !shownIn->isAllowed(*view))
        return no(say(SystemText::OnlyFor).arg(titlesOf(shownIn->rolesFor(*view))));
    const controller::State state = m_run->status().state;
    if (state == controller::State::Stopped || state == controller::State::Fault)
        return no(say(SystemText::NotRunning));
    const auto program = m_run->program();
    const auto target = m_run->expression(path, {}, *program);
    if (!target) return no(kit::messageText(target.error().message, language()));
    const std::optional<image::Place> place = target->place();
    if (!place) return no(say(SystemText::NotWritable));
    for (const controller::Forced& forced : m_run->forces())
        if (forced.place.offset == place->offset && forced.place.bit == place->bit)
            return no(say(SystemText::IsForced));
    const Result<types::Value> value = toPlc(target->types(), target->type(), write.value);
    if (!value)
        return no(whyNot(factsOf(target->types(), target->type(), true), write.value,
                         kit::messageText(value.error().message, language())));
    const QString from = m_panelName + QStringLiteral(", ") + write.element;
    std::string origin = "panel " + from.toStdString(); // journal
    if (m_logIn.isLoggedIn()) origin += ", user " + m_logIn.user().toStdString();
    const BindingId before = m_values->bind(write.target);
    record(QStringLiteral("write"), write.target, m_values->value(before).toLiteral(), write.value.toLiteral(), from,
           comment);
    if (write.kind == WriteKind::Write) {
        m_run->write({path, *place, program}, *value, origin);
        return {};
    }
    const Result<types::Value> released = toPlc(target->types(), target->type(), write.released);
    if (!released) return no(kit::messageText(released.error().message, language()));
    m_pressed.insert(write.target, write.released);
    m_run->press({path, *place, program}, *value, *released, origin);
    return {};
}

/// Why a value is refused, in the operator's language; `reason` is the technical one for what the panel has no words
/// for.
QString PanelPlayer::whyNot(const ValueFacts& facts, const Value& value, const QString& reason) const {
    const auto say = [&](SystemText text) { return systemText(m_project.texts, text, language()); };
    if (facts.kind == ValueKind::Text && value.kind() == ValueKind::Text)
        return value.text().size() > facts.textCapacity ? say(SystemText::TooLong).arg(facts.textCapacity)
                                                        : say(SystemText::BadCharacter);
    if (!facts.minimum || !facts.maximum) return say(SystemText::OutsideLimits) + u' ' + reason;
    const QLocale locale = localeOf(language());
    const auto number = [&](double limit) { return formatValue(Value::ofReal(limit), QStringLiteral("%.0f"), locale); };
    return say(SystemText::OutsideLimits) + u' ' +
           say(SystemText::Between).arg(number(*facts.minimum), number(*facts.maximum));
}

void PanelPlayer::refuse(const QString& reason) {
    m_refusal = reason;
    m_refusalAge.start();
    m_status->setRefusal({&scene().theme(), &m_project.texts, language()}, reason);
    emit writeRefused(reason);
}

bool PanelPlayer::refusesLocked() {
    if (m_isLocked) refuse(systemText(m_project.texts, SystemText::LogInFirst, language()));
    return m_isLocked;
}

void PanelPlayer::updateStatus() {
    const auto say = [&](SystemText text) { return systemText(m_project.texts, text, language()); };
    QString text;
    auto weight = PlayerStatus::Weight::Notice;
    switch (m_values ? m_values->freshness() : Freshness::Disconnected) {
    case Freshness::Live:
        break;
    case Freshness::Paused:
        text = say(SystemText::Paused);
        break;
    case Freshness::Stopped:
        text = say(SystemText::Stopped);
        weight = PlayerStatus::Weight::Bad;
        break;
    case Freshness::Fault:
        text = say(SystemText::Fault);
        if (const auto& fault = m_values->status().fault)
            text += QStringLiteral(": ") + kit::messageText(fault->message, language());
        weight = PlayerStatus::Weight::Bad;
        break;
    case Freshness::Past: {
        text = say(SystemText::Past);
        const qint64 clock = m_values->clock();
        text += QStringLiteral("  –  ") + formatDate(clock, localeOf(language())) + u' ' +
                formatTime(clock, localeOf(language()), true);
        break;
    }
    case Freshness::Disconnected:
        text = say(SystemText::NoController);
        weight = PlayerStatus::Weight::Quiet;
        break;
    }
    m_status->setState({&scene().theme(), &m_project.texts, language()}, text, weight);
    placeView();
}

void PanelPlayer::frame() {
    if (m_values) {
        m_values->refresh();
        // A controller that has not run yet has no calendar: it is known with the first scan.
        if (const auto clock = m_values->clockAtZero(); clock && !m_values->isPast()) m_alarms.setClockAtZero(*clock);
        followLanguageVariable();
        evaluateRecorded();
        if (m_run && !m_station) // taken once, by who keeps what all share
            for (const Error& refusal : m_run->takeRefusals()) refuse(kit::messageText(refusal, language()));
    }
    if (m_logIn.expire(std::chrono::steady_clock::now())) {
        record(QStringLiteral("log out"), {}, {}, {}, {}, QStringLiteral("timeout"));
        showUser();
    }
    // Once, by who keeps the alarms that all share.
    for (const QString& alarm : m_station ? std::vector<QString>() : m_alarms.expire(QDateTime::currentDateTimeUtc()))
        record(QStringLiteral("alarm back"), alarm, {}, {}, {}, QStringLiteral("time is over"));
    updateStatus();
    if (!m_refusal.isEmpty() && m_refusalAge.isValid() && m_refusalAge.elapsed() > 4000) {
        m_refusal.clear();
        m_status->setRefusal({&scene().theme(), &m_project.texts, language()}, {});
    }
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
    if (hasTurned && m_navigation.current().panel == m_panelName && !m_panelName.isEmpty()) showCurrent();
    placeView();
    m_status->setGeometry(rect());
    m_status->raise();
}

/// Whoever touches the panel, or what lies over it, is still there.
bool PanelPlayer::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::MouseButtonPress || type == QEvent::KeyPress || type == QEvent::TouchBegin)
        if (auto* widget = qobject_cast<QWidget*>(watched); widget && (widget == this || isAncestorOf(widget)))
            m_logIn.touched(std::chrono::steady_clock::now());
    return QWidget::eventFilter(watched, event);
}

void PanelPlayer::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F11) return setFullScreen(!isFullScreen());
    if (event->key() == Qt::Key_Escape && isFullScreen()) return setFullScreen(false);
    QWidget::keyPressEvent(event);
}

void PanelPlayer::showEvent(QShowEvent*) { frame(); }

} // namespace plc::hmi
