#include "hmi/people/people_file.h"

#include "hmi/model/errors.h"
#include "runtime/base/read_json.h"

#include <algorithm>

namespace plc::hmi {

namespace {

Error wrong(const QString& place, Message message) { return {std::move(message), place.toStdString()}; }

QString field(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? QString() : toQString(*found);
}

void put(Json& object, const char* key, const QString& value) {
    if (!value.isEmpty()) object[key] = toUtf8(value);
}

/// What this version does not know.
Json restOf(const Json& object, std::initializer_list<const char*> known) {
    Json out = Json::object();
    for (const auto& [key, value] : object.items())
        if (std::none_of(known.begin(), known.end(), [&](const char* one) { return key == one; })) out[key] = value;
    return out;
}

} // namespace

Result<PeopleFile> PeopleFile::parse(const std::string& utf8, const QString& place) {
    JsonText<Json> json = readJson<Json>(utf8);
    if (!json.isGood()) return wrong(place + u':' + QString::number(json.line), errors::PeopleNotJson());
    const Json& root = json.value;
    if (!root.is_object()) return wrong(place, errors::PeopleNotJson());
    PeopleFile out;
    out.m_rest = restOf(root, {"version", "timeout", "roles", "users"});
    if (const auto timeout = root.find("timeout"); timeout != root.end() && timeout->is_number())
        out.m_timeout = static_cast<int>(std::clamp(timeout->get<double>(), 0.0, 86400.0));
    for (const char* list : {"roles", "users"})
        if (root.contains(list) && !root[list].is_array()) return wrong(place, errors::MustBeList(Verbatim(list)));
    for (const Json& row : root.value("roles", Json::array())) {
        const QString name = row.is_object() ? field(row, "name") : QString();
        if (name.isEmpty()) return wrong(place, errors::RoleWithoutName());
        if (out.role(name)) return wrong(place, errors::RoleTwice(toUtf8(name)));
        out.m_roles.push_back({name, field(row, "title"), field(row, "startPanel")});
    }
    for (const Json& row : root.value("users", Json::array())) {
        User user;
        user.name = row.is_object() ? field(row, "name") : QString();
        if (user.name.isEmpty()) return wrong(place, errors::UserWithoutName());
        if (out.find(user.name)) return wrong(place, errors::UserTwice(toUtf8(user.name)));
        const Json roles = row.value("roles", Json::array());
        if (!roles.is_array()) return wrong(place, errors::MustBeList(Verbatim("roles")));
        for (const Json& role : roles) {
            const QString named = toQString(role);
            if (!out.role(named)) return wrong(place, errors::NoSuchRole(toUtf8(named)));
            user.roles += named;
        }
        user.password = field(row, "password");
        user.language = field(row, "language");
        user.startPanel = field(row, "startPanel");
        user.rest = restOf(row, {"name", "roles", "password", "language", "startPanel"});
        out.m_users.push_back(std::move(user));
    }
    return out;
}

PeopleFile PeopleFile::nobody() {
    PeopleFile out;
    out.setRole({QStringLiteral("nobody"), {}, {}});
    return out;
}

std::string PeopleFile::write() const {
    std::string out = "{\n  \"version\": 1";
    if (m_timeout > 0) out += ",\n  \"timeout\": " + std::to_string(m_timeout);
    std::vector<Json> roles, users;
    for (const Role& role : m_roles) {
        Json row = Json::object();
        put(row, "name", role.name);
        put(row, "title", role.title);
        put(row, "startPanel", role.startPanel);
        roles.push_back(std::move(row));
    }
    for (const User& user : m_users) {
        Json row = Json::object();
        put(row, "name", user.name);
        row["roles"] = Json::array();
        for (const QString& role : user.roles) row["roles"].push_back(toUtf8(role));
        put(row, "language", user.language);
        put(row, "startPanel", user.startPanel);
        put(row, "password", user.password);
        for (const auto& [key, value] : user.rest.items()) row[key] = value;
        users.push_back(std::move(row));
    }
    out += ",\n  \"roles\": " + writeList(roles, 2) + ",\n  \"users\": " + writeList(users, 2);
    for (const auto& [key, value] : m_rest.items()) out += ",\n  " + Json(key).dump() + ": " + writeCompact(value);
    return out + "\n}\n";
}

const User* PeopleFile::find(const QString& name) const {
    const auto found = std::find_if(m_users.begin(), m_users.end(),
                                    [&](const User& one) { return one.name.compare(name, Qt::CaseInsensitive) == 0; });
    return found == m_users.end() ? nullptr : &*found;
}

const Role* PeopleFile::role(const QString& name) const {
    const auto found = std::find_if(m_roles.begin(), m_roles.end(),
                                    [&](const Role& one) { return one.name.compare(name, Qt::CaseInsensitive) == 0; });
    return found == m_roles.end() ? nullptr : &*found;
}

void PeopleFile::setRole(const Role& role) {
    for (Role& one : m_roles)
        if (one.name.compare(role.name, Qt::CaseInsensitive) == 0) {
            one = role;
            return;
        }
    m_roles.push_back(role);
}

void PeopleFile::setUser(const User& user) {
    for (User& one : m_users)
        if (one.name.compare(user.name, Qt::CaseInsensitive) == 0) {
            one = user;
            return;
        }
    m_users.push_back(user);
}

bool PeopleFile::removeUser(const QString& name) {
    return std::erase_if(m_users, [&](const User& one) { return one.name.compare(name, Qt::CaseInsensitive) == 0; }) >
           0;
}

QString PeopleFile::startPanelOf(const User& user) const {
    if (!user.startPanel.isEmpty()) return user.startPanel;
    for (const QString& name : user.roles)
        if (const Role* one = role(name); one && !one->startPanel.isEmpty()) return one->startPanel;
    return {};
}

} // namespace plc::hmi
