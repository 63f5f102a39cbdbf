// Who operates, the trail of what they do, and what they do with alarms.
#include "hmi/station/operator_station.h"

#include "editor/kit/message_text.h"

#include <QDir>

namespace plc::hmi {

// ---- people

/// A project with people has a trail.
void OperatorStation::openTrail() {
    if (m_project.people.isEmpty() || m_project.folder.isEmpty() || m_audit.isOpen()) return;
    if (const auto kept = keepAuditIn(m_project.folder + QStringLiteral("/.stepwise/audit.csv")); !kept)
        refuse(kit::messageText(kept.error(), m_language));
}

void OperatorStation::record(const QString& action, const QString& what, const QString& from, const QString& to,
                             const QString& place, const QString& comment) {
    // One writer: each line of the trail holds a sum over the one before.
    AuditTrail& trail = m_keeper ? m_keeper->m_audit : m_audit;
    if (!trail.isOpen()) return;
    const auto added =
        trail.add({QDateTime::currentDateTimeUtc(), m_logIn.user(), action, what, from, to, place, comment});
    if (!added) refuse(kit::messageText(added.error(), m_language));
}

LogIn::Answer OperatorStation::logIn(const QString& user, const QString& password, Moment now) {
    LogIn::Answer answer = m_door ? m_door(user, password) : m_logIn.logIn(user, password, now);
    if (m_door && answer == LogIn::Answer::Good && !m_logIn.enter(user, now)) answer = LogIn::Answer::Wrong;
    if (answer != LogIn::Answer::Good) {
        // Who is shut out by a server goes on asking: that must not fill the disk.
        if (!m_door || answer != LogIn::Answer::Blocked)
            record(QStringLiteral("log in refused"), user, {}, {}, m_panelName);
        refuse(passwordRefusal(answer));
        return answer;
    }
    record(QStringLiteral("log in"), m_logIn.user(), {}, {}, m_panelName);
    emit userChanged(m_logIn.user());
    if (const User* who = m_project.people.find(m_logIn.user())) {
        if (!who->language.isEmpty()) requestLanguage(who->language);
        if (const QString start = m_project.people.startPanelOf(*who); m_project.find(start))
            m_navigation.start({start, {}});
    }
    return answer;
}

void OperatorStation::logOut(const QString& why) {
    if (!m_logIn.isLoggedIn()) return;
    record(QStringLiteral("log out"), m_logIn.user(), {}, {}, m_panelName, why);
    m_logIn.logOut();
    emit userChanged(m_logIn.user());
}

QString OperatorStation::passwordRefusal(LogIn::Answer answer) const {
    return say(answer == LogIn::Answer::Blocked ? SystemText::TooManyTries : SystemText::WrongPassword);
}

QString OperatorStation::titlesOf(const QString& roles) const {
    QStringList out;
    for (const QString& name : LogIn::rolesOf(roles)) {
        const Role* role = m_project.people.role(name);
        out += role && !role->title.isEmpty() ? m_project.texts.text(role->title, m_language) : name;
    }
    return out.join(QStringLiteral(", "));
}

QStringList OperatorStation::users() const {
    QStringList names;
    for (const User& user : m_project.people.users())
        if (!user.password.isEmpty()) names += user.name;
    return names;
}

// ---- alarms

namespace {
constexpr int kShort = 30 * 60, kLong = 8 * 3600; // seconds
}

void OperatorStation::shareAlarms(OperatorStation& keeper) {
    m_watch.reset();
    m_keeper = &keeper;
    emit sourcesChanged();
}

QString OperatorStation::alarmStoreOf(const PanelProject& project) {
    return project.folder + QStringLiteral("/.stepwise/alarms.sqlite");
}

Result<void> OperatorStation::keepAlarmsInProject() {
    const QString folder = m_project.folder + QStringLiteral("/.stepwise");
    QDir().mkpath(folder);
    if (const auto aside = m_alarms.keepAsideIn(folder + QStringLiteral("/alarms_aside.json")); !aside)
        refuse(kit::messageText(aside.error(), m_language));
    return m_alarms.openStore(alarmStoreOf(m_project));
}

void OperatorStation::acknowledge(const AcknowledgeRequest& request) {
    if (m_recording) return refuse(say(SystemText::InThePast));
    AlarmWatch* const watch = alarmWatch();
    if (!watch || refusesLocked()) return;
    const std::vector<AlarmDefinition>& alarms = liveAlarms().definitions();
    const QString what = request.all                     ? QStringLiteral("all")
                         : request.alarm < alarms.size() ? alarms[request.alarm].id
                                                         : QString();
    record(QStringLiteral("acknowledge"), what, {}, {}, m_panelName);
    if (request.all)
        watch->acknowledgeAll(request.classes, m_logIn.user());
    else
        watch->acknowledge(request.alarm, m_logIn.user());
}

bool OperatorStation::mayAnswer(const AlarmDetailRequest& request) {
    return !m_recording && !refusesLocked() && request.alarm < liveAlarms().definitions().size();
}

void OperatorStation::act(AlarmAction action, const QString& alarm) {
    const int index = liveAlarms().indexOf(alarm);
    if (index < 0) return;
    const QString user = m_logIn.user();
    const QDateTime now = QDateTime::currentDateTimeUtc();
    const auto set = [&](const QString& name, const std::function<Result<void>(AlarmSuppression&)>& how) {
        if (const auto done = liveAlarms().change(how); !done) refuse(kit::messageText(done.error(), m_language));
        record(name, alarm, {}, {}, m_panelName);
    };
    const auto shelve = [&](int seconds) {
        set(QStringLiteral("alarm shelved"),
            [&](AlarmSuppression& aside) { return aside.shelve(alarm, seconds, user, {}, now); });
    };
    switch (action) {
    case AlarmAction::Acknowledge:
        record(QStringLiteral("acknowledge"), alarm, {}, {}, m_panelName);
        if (AlarmWatch* const watch = alarmWatch()) watch->acknowledge(static_cast<size_t>(index), user);
        return;
    case AlarmAction::Show:
        m_navigation.open({liveAlarms().definitions()[static_cast<size_t>(index)].show, {}});
        return;
    case AlarmAction::ShelveShort:
        return shelve(kShort);
    case AlarmAction::ShelveLong:
        return shelve(kLong);
    case AlarmAction::OutOfService:
        return set(QStringLiteral("alarm out of service"),
                   [&](AlarmSuppression& aside) { return aside.takeOutOfService(alarm, user, {}, now); });
    case AlarmAction::PutBack:
        return set(QStringLiteral("alarm back"), [&](AlarmSuppression& aside) { return aside.putBack(alarm); });
    }
}

} // namespace plc::hmi
