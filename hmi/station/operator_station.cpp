// The controller, writing and the language; people and alarms, and recipes, are in files of their own.
#include "hmi/station/operator_station.h"

#include "editor/kit/occurrence_text.h"
#include "hmi/model/property_literals.h"
#include "hmi/station/operator_names.h"
#include "hmi/texts/format.h"
#include "hmi/texts/local_number.h"
#include "projects/storage/project_file.h"
#include "runtime/inside/slice.h"

#include <QDir>

#include <utility>

namespace plc::hmi {

namespace {
QString languageFileOf(const PanelProject& project) {
    return project.folder + QStringLiteral("/.stepwise/operator_language");
}
} // namespace

OperatorStation::OperatorStation(const PanelProject& project, session::Run* run, QObject* parent)
    : QObject(parent), m_project(project), m_navigation(project.panelLookup()), m_logIn(project.people),
      m_recipes(project.recipes), m_alarmFile(project.alarms.write()),
      m_language(project.texts.settings().languages.value(0, QStringLiteral("en"))) {
    m_alarms.setFile(project.alarms);
    if (project.hasAlarms) (void)m_alarms.openStore(QStringLiteral(":memory:"));
    openTrail();
    setRun(run);
    if (!project.startPanel.isEmpty()) m_navigation.start({project.startPanel, {}});
}

OperatorStation::~OperatorStation() = default;

// ---- where the operator is

bool OperatorStation::setPanelName(const QString& name) { return std::exchange(m_panelName, name) != name; }

/// The panel for a high screen where there is one and the screen is high.
OperatorStation::Shown OperatorStation::shown(bool isPortrait) const {
    const PanelLookup panels = m_project.panelLookup();
    const QString place = m_navigation.current().panel;
    const Panel* const own = panels(place);
    const QString other = own && isPortrait ? own->text("portrait"_text) : QString();
    Shown out{!other.isEmpty() && m_project.find(other) ? other : place, nullptr, nullptr};
    out.panel = panels(out.name);
    if (out.panel && out.panel->isSet("framed"_flag) && out.name != m_project.frame)
        out.frame = m_project.find(m_project.frame);
    return out;
}

// ---- the controller

void OperatorStation::bindLanguage() {
    if (const QString variable = m_project.texts.settings().variable; !variable.isEmpty())
        m_languageBinding = m_values->bind(variable);
}

void OperatorStation::watchAlarms() {
    m_watch.reset();
    if (m_run && !m_keeper && !m_alarms.definitions().empty()) m_watch = std::make_unique<AlarmWatch>(*m_run, m_alarms);
}

void OperatorStation::setRun(session::Run* run) {
    while (m_navigation.closePopUp()) { // they show values of the controller that goes
    }
    emit sourcesAboutToChange();
    m_watch.reset();
    m_values.reset();
    m_languageBinding = {};
    m_languageValue = {};
    m_recording.reset();
    m_recordedEvaluator.reset();
    m_alarmPosition.reset();
    m_run = run;
    m_alarms.clear();
    if (run) {
        m_values = std::make_unique<PlcValues>(*run);
        bindLanguage();
        if (const auto clock = m_values->clockAtZero()) m_alarms.setClockAtZero(*clock);
        watchAlarms();
    }
    emit sourcesChanged();
}

void OperatorStation::setRecording(std::shared_ptr<const session::Run> recording) {
    if (!recording && !m_recording) return;
    const bool isEmpty = !recording && !m_run; // nothing to show any more
    if (isEmpty)
        while (m_navigation.closePopUp()) {
        }
    if (isEmpty || !m_values) emit sourcesAboutToChange();
    m_recordedEvaluator.reset();
    m_recording = std::move(recording);
    m_languageAsked.clear();
    if (!m_values) {
        m_values = std::make_unique<PlcValues>(nullptr);
        bindLanguage();
    }
    m_values->setRun(m_recording ? m_recording.get() : m_run);
    if (m_recording) {
        m_recordedAlarms.clear();
        m_recordedAlarms.setFile(m_project.alarms);
        if (const auto clock = m_values->clockAtZero()) m_recordedAlarms.setClockAtZero(*clock);
        if (m_recording->program() && !m_recordedAlarms.definitions().empty())
            m_recordedEvaluator = std::make_unique<AlarmEvaluator>(*m_recording, m_recordedAlarms.definitions());
    } else if (!m_run) {
        m_values.reset();
        m_languageBinding = {};
        m_languageValue = {};
    }
    setPosition(std::nullopt);
    emit sourcesChanged();
}

void OperatorStation::setPosition(std::optional<history::Position> position) {
    m_alarmPosition.reset();
    if (!m_values) return;
    m_values->setPosition(position);
    if (m_recording && !position) {
        const history::Statistics there = m_recording->history().statistics();
        if (there.end > there.first) position = there.end - 1;
    }
    if (position) m_alarmPosition = *position;
}

/// A piece of the recording per frame, so that a long one does not hold up the window.
void OperatorStation::evaluateRecorded() {
    if (!m_recordedEvaluator) return;
    std::vector<AlarmFindings> findings;
    const bool more = m_recordedEvaluator->process(findings);
    for (const AlarmFindings& one : findings) {
        if (one.rewindTo) m_recordedAlarms.rewind(*one.rewindTo);
        m_recordedAlarms.take(one.records);
    }
    if (!more) m_recordedEvaluator.reset();
}

StationState OperatorStation::state() const {
    switch (m_values ? m_values->freshness() : Freshness::Disconnected) {
    case Freshness::Live:
        return {};
    case Freshness::Paused:
        return {say(SystemText::Paused), StateWeight::Notice};
    case Freshness::Stopped:
        return {say(SystemText::Stopped), StateWeight::Bad};
    case Freshness::Fault: {
        QString text = say(SystemText::Fault);
        if (const auto& fault = m_values->status().fault)
            text += QStringLiteral(": ") + kit::occurrenceText(fault->message, m_language);
        return {text, StateWeight::Bad};
    }
    case Freshness::Past: {
        const QLocale locale = localeOf(m_language);
        const qint64 clock = m_values->clock();
        return {say(SystemText::Past) + QStringLiteral("  –  ") + formatDate(clock, locale) + u' ' +
                    formatTime(clock, locale, true),
                StateWeight::Notice};
    }
    case Freshness::Disconnected:
        return {say(SystemText::NoController), StateWeight::Quiet};
    }
    return {};
}

void OperatorStation::frame(Moment now) {
    if (m_values) {
        m_values->refresh();
        // A controller that has not run yet has no calendar: it is known with the first scan.
        if (const auto clock = m_values->clockAtZero(); clock && !m_values->isPast()) m_alarms.setClockAtZero(*clock);
        followLanguageVariable();
        evaluateRecorded();
        if (m_run && !m_keeper) // taken once, by who keeps what all share
            for (const Error& refusal : m_run->takeRefusals()) refuse(kit::occurrenceText(refusal, m_language));
    }
    if (m_logIn.expire(now)) {
        record(QStringLiteral("log out"), {}, {}, {}, {}, QStringLiteral("timeout"));
        emit userChanged(m_logIn.user());
    }
    // Once, by who keeps the alarms that all share.
    for (const QString& alarm : m_keeper ? std::vector<QString>() : m_alarms.expire(QDateTime::currentDateTimeUtc()))
        record(QStringLiteral("alarm back"), alarm, {}, {}, {}, QStringLiteral("time is over"));
    constexpr auto kShown = std::chrono::seconds(4);
    if (m_refusal.isEmpty()) return;
    if (!m_refusedAt) m_refusedAt = now;
    if (now - *m_refusedAt <= kShown) return;
    m_refusal.clear();
    emit refusalOver();
}

// ---- writing

void OperatorStation::refuse(const QString& reason) {
    m_refusal = reason;
    m_refusedAt.reset();
    emit writeRefused(reason);
}

bool OperatorStation::refusesLocked() {
    if (m_isLocked) refuse(say(SystemText::LogInFirst));
    return m_isLocked;
}

/// What speaks against a write before its target is looked at.
QString OperatorStation::refusalBefore(const WriteRequest& write) const {
    if (m_isLocked) return say(SystemText::LogInFirst);
    if (m_recording) return say(SystemText::InThePast);
    if (!m_run || !m_values) return say(SystemText::NoController);
    if (m_values->position()) return say(SystemText::InThePast);
    if (const QString roles = m_rights ? m_rights(write.element) : QString(); !roles.isEmpty())
        return say(SystemText::OnlyFor).arg(titlesOf(roles));
    const controller::State state = m_run->status().state;
    if (state == controller::State::Stopped || state == controller::State::Fault) return say(SystemText::NotRunning);
    return {};
}

/// As the journal has it.
QString OperatorStation::originOf(const QString& place) const {
    const QString panel = QStringLiteral("panel ") + place;
    return m_logIn.isLoggedIn() ? panel + QStringLiteral(", user ") + m_logIn.user() : panel;
}

QString OperatorStation::post(const WriteRequest& write, const QString& comment) {
    const auto no = [&](const QString& reason) {
        refuse(reason);
        return reason;
    };
    const std::string path = write.target.toStdString();
    if (write.kind == WriteKind::Release) {
        if (!m_run || !m_values) return no(say(SystemText::NoController));
        if (m_pressed.remove(write.target)) m_run->release(path);
        return {};
    }
    if (const QString reason = refusalBefore(write); !reason.isEmpty()) return no(reason);
    const auto program = m_run->program();
    const auto target = m_run->expression(path, {}, *program);
    if (!target) return no(kit::occurrenceText(target.error().message, m_language));
    const std::optional<image::Place> place = target->place();
    if (!place) return no(say(SystemText::NotWritable));
    for (const controller::Forced& forced : m_run->forces())
        if (forced.place.offset == place->offset && forced.place.bit == place->bit)
            return no(say(SystemText::IsForced));
    const Result<types::Value> value = toPlc(target->types(), target->type(), write.value);
    if (!value)
        return no(whyNot(factsOf(target->types(), target->type(), true), write.value,
                         kit::occurrenceText(value.error().message, m_language)));
    const QString from = m_panelName + QStringLiteral(", ") + write.element;
    const std::string origin = originOf(from).toStdString();
    const BindingId before = m_values->bind(write.target);
    record(QStringLiteral("write"), write.target, m_values->value(before).toLiteral(), write.value.toLiteral(), from,
           comment);
    if (write.kind == WriteKind::Write) {
        m_run->write({path, *place, program}, *value, origin);
        return {};
    }
    const Result<types::Value> released = toPlc(target->types(), target->type(), write.released);
    if (!released) return no(kit::occurrenceText(released.error().message, m_language));
    m_pressed.insert(write.target, write.released);
    m_run->press({path, *place, program}, *value, *released, origin);
    return {};
}

/// Why a value is refused, in the operator's language; `reason` is the technical one for what the panel has no words
/// for.
QString OperatorStation::whyNot(const ValueFacts& facts, const Value& value, const QString& reason) const {
    if (facts.kind == ValueKind::Text && value.kind() == ValueKind::Text)
        return value.text().size() > facts.textCapacity ? say(SystemText::TooLong).arg(facts.textCapacity)
                                                        : say(SystemText::BadCharacter);
    if (!facts.minimum || !facts.maximum) return say(SystemText::OutsideLimits) + u' ' + reason;
    const QLocale locale = localeOf(m_language);
    const auto number = [&](double limit) { return formatValue(Value::ofReal(limit), QStringLiteral("%.0f"), locale); };
    return say(SystemText::OutsideLimits) + u' ' +
           say(SystemText::Between).arg(number(*facts.minimum), number(*facts.maximum));
}

/// In the operator's words: what the panels call the variable, the number as it is written there.
QString OperatorStation::questionFor(const ConfirmRequest& request) const {
    if (!request.question.isEmpty()) return request.question;
    QString name = request.write.target;
    if (const auto program = m_run ? m_run->program() : nullptr)
        if (const auto place = program->layout.find(name.toStdString())) {
            const OperatorNames names = operatorNames(m_project, *program, m_language);
            if (const auto known = names.find(inside::nameOf(program->layout, *place)); known != names.end())
                name = QString::fromStdString(known->second);
        }
    return say(SystemText::ConfirmWrite).arg(name, localNumber(request.write.value.toLiteral(), localeOf(m_language)));
}

void OperatorStation::confirmed(const WriteRequest& write, const QString& comment) {
    post(write, comment);
    if (write.kind == WriteKind::Press)
        post(WriteRequest{write.element, write.target, WriteKind::Release, write.released, write.released});
}

void OperatorStation::sign(const WriteRequest& write, const QString& password, Moment now) {
    const LogIn::Answer answer = m_logIn.confirm(password, now);
    if (answer == LogIn::Answer::Good) return confirmed(write, QStringLiteral("signed by ") + m_logIn.user());
    record(QStringLiteral("signature refused"), write.target, {}, write.value.toLiteral(), m_panelName);
    refuse(passwordRefusal(answer));
}

// ---- the language

void OperatorStation::setLanguage(const QString& tag) {
    if (tag.isEmpty() || tag == m_language) return;
    m_language = tag;
    emit languageChanged(tag);
}

/// What an operator chose stays chosen when the panel is started again.
void OperatorStation::rememberLanguage() const {
    if (!m_remembersLanguage || m_project.folder.isEmpty()) return;
    QDir().mkpath(m_project.folder + QStringLiteral("/.stepwise"));
    // A folder that cannot be written forgets; the panel works all the same.
    (void)projects::writeFileAtomically(toUtf8(languageFileOf(m_project)), toUtf8(m_language) + "\n");
}

void OperatorStation::keepLanguageInProject(const QString& instead) {
    if (!instead.isEmpty()) requestLanguage(instead); // nobody chose it on the panel: not remembered
    m_remembersLanguage = true;
    if (!instead.isEmpty()) return;
    const auto text = projects::readFile(toUtf8(languageFileOf(m_project)));
    const QString tag = text ? QString::fromStdString(*text).trimmed() : QString();
    if (m_project.texts.settings().languages.contains(tag)) requestLanguage(tag);
}

void OperatorStation::requestLanguage(const QString& tag) {
    if (!m_project.texts.settings().languages.contains(tag)) return;
    setLanguage(tag);
    rememberLanguage();
    // The program reads the language; until it has it, its older value must not switch back.
    if (!m_values || !m_languageBinding.isValid() || m_hasOwnLanguage) return;
    const ValueKind kind = m_values->facts(m_languageBinding).kind;
    const Value value = m_project.texts.settings().valueOf(tag, kind);
    if (value.isNone()) return;
    m_languageAsked = tag;
    if (!post(WriteRequest{{}, m_project.texts.settings().variable, WriteKind::Write, value, {}}).isEmpty())
        m_languageAsked.clear();
}

void OperatorStation::followLanguageVariable() {
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

void OperatorStation::projectChanged() {
    openTrail();
    if (m_project.alarms.write() != m_alarmFile) {
        m_alarmFile = m_project.alarms.write();
        m_watch.reset();
        m_alarms.setFile(m_project.alarms);
        watchAlarms();
    }
    if (m_project.recipes.write() != m_recipes.write()) {
        m_recipes = m_project.recipes;
        emit recipesChanged();
    }
    if (m_recording) setRecording(m_recording);
    if (!m_project.texts.settings().languages.contains(m_language))
        setLanguage(m_project.texts.settings().languages.value(0));
}

} // namespace plc::hmi
