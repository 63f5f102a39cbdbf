// hmi/people.json: roles of a project and the users who have them. A value; whoever holds it owns it.
#pragma once
#include "hmi/model/json.h"
#include "runtime/base/result.h"

#include <QStringList>

namespace plc::hmi {

struct Role {
    QString name;       // as elements name it
    QString title;      // "@key" or the text itself
    QString startPanel; // of those who have it, unless their own says otherwise
};

struct User {
    QString name;
    QStringList roles;
    QString password; // hash; empty: the user cannot log in
    QString language, startPanel;
    Json rest = Json::object(); // unknown fields, kept
};

class PeopleFile {
public:
    /// A user or role that is wrong costs the whole file: rights must not come from half of it.
    static Result<PeopleFile> parse(const std::string& utf8, const QString& place);
    /// Roles that nobody has: what stands for a file that could not be read.
    static PeopleFile nobody();
    std::string write() const;

    bool isEmpty() const { return m_users.empty() && m_roles.empty(); }
    const std::vector<Role>& roles() const { return m_roles; }
    const std::vector<User>& users() const { return m_users; }
    /// For editors, which keep names apart and roles known: a file that is otherwise is refused when it is read.
    std::vector<Role>& roles() { return m_roles; }
    std::vector<User>& users() { return m_users; }
    const User* find(const QString& name) const;
    const Role* role(const QString& name) const;
    /// Seconds without a touch after which the user is logged out; 0: never.
    int timeout() const { return m_timeout; }
    void setTimeout(int seconds) { m_timeout = seconds; }
    void setRole(const Role& role);
    /// Adds the user or takes the place of the one of that name.
    void setUser(const User& user);
    bool removeUser(const QString& name);
    /// The user's own start panel, else that of the first role that has one.
    QString startPanelOf(const User& user) const;

private:
    std::vector<Role> m_roles;
    std::vector<User> m_users;
    int m_timeout = 0;
    Json m_rest = Json::object();
};

} // namespace plc::hmi
