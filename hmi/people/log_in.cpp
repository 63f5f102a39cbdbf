#include "hmi/people/log_in.h"

#include "hmi/people/password.h"

#include <algorithm>

namespace plc::hmi {

namespace {
constexpr int kFreeTries = 5;
constexpr std::chrono::seconds kPause{30};
} // namespace

LogIn::Answer LogIn::check(const QString& name, const QString& password, Moment now) {
    Failures& failures = m_failures[name.toLower()];
    if (failures.count >= kFreeTries && now - failures.last < kPause) return Answer::Blocked;
    const User* user = m_people->find(name);
    // A name that does not exist takes as long as a wrong password: the door does not tell who is known.
    static const QString nobody =
        QStringLiteral("$y$j9T$AAAAAAAAAAAAAAAAAAAAA.$AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA3");
    const bool isGood = isPassword(password, user && !user->password.isEmpty() ? user->password : nobody) && user &&
                        !user->password.isEmpty();
    if (isGood) {
        m_failures.erase(name.toLower());
        return Answer::Good;
    }
    failures.count = now - failures.last < kPause ? failures.count + 1 : 1;
    failures.last = now;
    return Answer::Wrong;
}

LogIn::Answer LogIn::logIn(const QString& name, const QString& password, Moment now) {
    const Answer answer = check(name, password, now);
    if (answer == Answer::Good) (void)enter(name, now);
    return answer;
}

bool LogIn::enter(const QString& name, Moment now) {
    const User* user = m_people->find(name);
    if (!user) return false;
    m_user = user->name;
    m_touched = now;
    return true;
}

LogIn::Answer LogIn::confirm(const QString& password, Moment now) {
    return isLoggedIn() ? check(m_user, password, now) : Answer::Wrong;
}

bool LogIn::expire(Moment now) {
    if (!isLoggedIn() || m_people->timeout() <= 0 || now - m_touched < std::chrono::seconds(m_people->timeout()))
        return false;
    logOut();
    return true;
}

QStringList LogIn::rolesOf(const QString& roles) {
    QStringList out;
    for (const QString& one : roles.split(u',', Qt::SkipEmptyParts))
        if (!one.trimmed().isEmpty()) out += one.trimmed();
    return out;
}

bool LogIn::isAllowed(const QString& roles) const {
    const QStringList wanted = rolesOf(roles);
    if (wanted.isEmpty() || m_people->isEmpty()) return true;
    const User* user = isLoggedIn() ? m_people->find(m_user) : nullptr;
    return user && std::any_of(user->roles.begin(), user->roles.end(),
                               [&](const QString& role) { return wanted.contains(role, Qt::CaseInsensitive); });
}

} // namespace plc::hmi
