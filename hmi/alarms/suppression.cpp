#include "hmi/alarms/suppression.h"

#include "hmi/model/errors.h"
#include "runtime/base/read_json.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>

namespace plc::hmi {

namespace {

QString field(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? QString() : toQString(*found);
}

std::optional<SetAside> parsed(const Json& row) {
    if (!row.is_object()) return {};
    SetAside one{field(row, "alarm"), field(row, "user"), field(row, "reason"),
                 QDateTime::fromString(field(row, "since"), Qt::ISODate), std::nullopt};
    if (one.alarm.isEmpty()) return {};
    const QString until = field(row, "until");
    if (until.isEmpty()) return one;
    one.until = QDateTime::fromString(until, Qt::ISODate);
    // A time that cannot be read has passed: an alarm must never stay away by a mistake.
    if (!one.until->isValid()) return {};
    return one;
}

} // namespace

Result<void> AlarmSuppression::open(const QString& path) {
    m_aside.clear();
    m_path = path;
    QFile file(path);
    if (!file.exists()) return {};
    if (!file.open(QIODevice::ReadOnly))
        return Error{errors::SetAsideNotRead(file.errorString().toStdString()), path.toStdString()};
    const JsonText<Json> json = readJson<Json>(file.readAll().toStdString());
    if (!json.isGood() || !json.value.is_array())
        return Error{errors::SetAsideNotRead(Verbatim("JSON")), path.toStdString()};
    for (const Json& row : json.value)
        if (const auto one = parsed(row)) m_aside.insert(one->alarm, *one);
    return {};
}

Result<void> AlarmSuppression::save() const {
    if (m_path.isEmpty()) return {};
    std::vector<Json> rows;
    for (const SetAside& one : m_aside) {
        Json row{{"alarm", toUtf8(one.alarm)}, {"user", toUtf8(one.user)}, {"reason", toUtf8(one.reason)}};
        row["since"] = toUtf8(one.since.toUTC().toString(Qt::ISODate));
        if (one.until) row["until"] = toUtf8(one.until->toUTC().toString(Qt::ISODate));
        rows.push_back(std::move(row));
    }
    QDir().mkpath(QFileInfo(m_path).path());
    QSaveFile file(m_path);
    const std::string bytes = writeList(rows, 0) + "\n";
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes.data(), static_cast<qint64>(bytes.size())) < 0 ||
        !file.commit())
        return Error{errors::SetAsideNotWritten(file.errorString().toStdString()), m_path.toStdString()};
    return {};
}

Result<void> AlarmSuppression::put(SetAside one) {
    const QString alarm = one.alarm;
    m_aside.insert(alarm, std::move(one));
    return save();
}

Result<void> AlarmSuppression::shelve(const QString& alarm, int seconds, const QString& user, const QString& reason,
                                      const QDateTime& now) {
    return put({alarm, user, reason, now, now.addSecs(std::clamp(seconds, 1, kLongestSeconds))});
}

Result<void> AlarmSuppression::takeOutOfService(const QString& alarm, const QString& user, const QString& reason,
                                                const QDateTime& now) {
    return put({alarm, user, reason, now, std::nullopt});
}

Result<void> AlarmSuppression::putBack(const QString& alarm) {
    if (m_aside.remove(alarm) == 0) return {};
    return save();
}

std::vector<QString> AlarmSuppression::expire(const QDateTime& now) {
    std::vector<QString> out;
    for (const SetAside& one : m_aside)
        if (one.until && *one.until <= now) out.push_back(one.alarm);
    for (const QString& alarm : out) m_aside.remove(alarm);
    if (!out.empty()) (void)save();
    return out;
}

const SetAside* AlarmSuppression::find(const QString& alarm) const {
    const auto found = m_aside.constFind(alarm);
    return found == m_aside.constEnd() ? nullptr : &*found;
}

std::vector<SetAside> AlarmSuppression::all() const { return {m_aside.begin(), m_aside.end()}; }

} // namespace plc::hmi
