// Who operates a panel at present, and what they may do. Knows no widget and no clock: times are arguments. One per
// player or browser; the people must outlive it. Main thread.
#pragma once
#include "hmi/people/people_file.h"

#include <chrono>
#include <map>

namespace plc::hmi {

using Moment = std::chrono::steady_clock::time_point;

class LogIn {
public:
    enum class Answer { Good, Wrong, Blocked /* too many wrong ones: for a while */ };
    explicit LogIn(const PeopleFile& people) : m_people(&people) {}

    Answer logIn(const QString& user, const QString& password, Moment now);
    /// Somebody whose password was checked elsewhere; false: the project has no such user.
    bool enter(const QString& user, Moment now);
    void logOut() { m_user.clear(); }
    /// Whether the password is that of who is logged in: for confirmations. Wrong ones count as at the door.
    Answer confirm(const QString& password, Moment now);
    /// The panel was touched.
    void touched(Moment now) { m_touched = now; }
    /// Logs out after the time without a touch; true if it just did.
    bool expire(Moment now);

    const QString& user() const { return m_user; }
    bool isLoggedIn() const { return !m_user.isEmpty(); }
    /// `roles`: "operator, engineer" as an element has it. Empty, or in a project without people: everybody.
    bool isAllowed(const QString& roles) const;
    static QStringList rolesOf(const QString& roles);

private:
    Answer check(const QString& user, const QString& password, Moment now);
    struct Failures {
        int count = 0;
        Moment last{};
    };
    const PeopleFile* m_people;
    QString m_user;
    Moment m_touched{};
    std::map<QString, Failures> m_failures;
};

} // namespace plc::hmi
