#include "hmi/alarms/alarm_store.h"

#include "hmi/model/errors.h"
#include "runtime/base/read_json.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QUuid>
#include <QVariant>

namespace plc::hmi {

Json toJson(const Value& value) {
    switch (value.kind()) {
    case ValueKind::None:
        return nullptr;
    case ValueKind::Bool:
        return value.toBool();
    case ValueKind::Integer:
        return static_cast<int64_t>(value.toInteger());
    case ValueKind::Unsigned:
        return Json{{"u", static_cast<uint64_t>(value.toInteger())}};
    case ValueKind::Real:
        return Json{{"r", value.toLiteral().toStdString()}};
    case ValueKind::Text:
        return toUtf8(value.text());
    case ValueKind::Time:
        return Json{{"t", static_cast<int64_t>(value.toInteger())}};
    case ValueKind::Date:
        return Json{{"d", static_cast<int64_t>(value.toInteger())}};
    case ValueKind::DateTime:
        return Json{{"dt", static_cast<int64_t>(value.toInteger())}};
    case ValueKind::TimeOfDay:
        return Json{{"tod", static_cast<int64_t>(value.toInteger())}};
    case ValueKind::Array: {
        Json out = Json::array();
        for (const Value& item : value.items()) out.push_back(toJson(item));
        return out;
    }
    }
    return nullptr;
}

Value valueFromJson(const Json& json) {
    if (json.is_boolean()) return Value::ofBool(json.get<bool>());
    if (json.is_number_integer()) return Value::ofInteger(json.get<int64_t>());
    if (json.is_number()) return Value::ofReal(json.get<double>());
    if (json.is_string()) return Value::ofText(toQString(json));
    if (json.is_array()) {
        std::vector<Value> items;
        for (const Json& item : json) items.push_back(valueFromJson(item));
        return Value::ofArray(std::move(items));
    }
    if (!json.is_object() || json.size() != 1) return {};
    const std::string key = json.begin().key();
    const Json& inner = json.begin().value();
    if (key == "r" && inner.is_string()) return Value::ofReal(toQString(inner).toDouble());
    if (!inner.is_number_integer()) return {};
    const int64_t number = inner.get<int64_t>();
    if (key == "u") return Value::ofUnsigned(static_cast<quint64>(number));
    if (key == "t") return Value::ofInstant(ValueKind::Time, number);
    if (key == "d") return Value::ofInstant(ValueKind::Date, number);
    if (key == "dt") return Value::ofInstant(ValueKind::DateTime, number);
    if (key == "tod") return Value::ofInstant(ValueKind::TimeOfDay, number);
    return {};
}

AlarmStore::~AlarmStore() { close(); }

void AlarmStore::close() {
    if (m_connection.isEmpty()) return;
    m_database.close();
    m_database = {};
    QSqlDatabase::removeDatabase(std::exchange(m_connection, {}));
}

Result<void> AlarmStore::open(const QString& path) {
    close();
    m_connection = QUuid::createUuid().toString();
    m_database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_connection);
    m_database.setDatabaseName(path);
    if (!m_database.open())
        return Error{errors::AlarmHistoryNotOpened(m_database.lastError().text().toStdString()), path.toStdString()};
    QSqlQuery query(m_database);
    query.exec(QStringLiteral("PRAGMA journal_mode=WAL"));
    query.exec(QStringLiteral("PRAGMA synchronous=NORMAL"));
    const auto has = [&](const char* column) {
        return query.exec(QStringLiteral("SELECT %1 FROM events LIMIT 1").arg(QLatin1String(column)));
    };
    if (!query.exec(QStringLiteral("CREATE TABLE IF NOT EXISTS events (number INTEGER PRIMARY KEY AUTOINCREMENT, alarm "
                                   "TEXT NOT NULL, kind INTEGER NOT NULL, "
                                   "position INTEGER NOT NULL, scan INTEGER NOT NULL, time INTEGER NOT NULL, wall "
                                   "INTEGER NOT NULL, vals TEXT NOT NULL, "
                                   "user TEXT NOT NULL, run TEXT, calendar INTEGER)")) ||
        !query.exec(QStringLiteral("CREATE INDEX IF NOT EXISTS events_by_alarm ON events (alarm, number)")) ||
        (!has("run") && // a file of an older version
         !query.exec(QStringLiteral("ALTER TABLE events ADD COLUMN run TEXT"))) ||
        (!has("calendar") && !query.exec(QStringLiteral("ALTER TABLE events ADD COLUMN calendar INTEGER"))) ||
        !query.exec(
            QStringLiteral("CREATE UNIQUE INDEX IF NOT EXISTS events_once ON events (run, alarm, kind, position)")) ||
        !query.exec(QStringLiteral("BEGIN IMMEDIATE")) || !query.exec(QStringLiteral("COMMIT"))) // it can be written
        return Error{errors::AlarmHistoryUnusable(query.lastError().text().toStdString()), path.toStdString()};
    return {};
}

Result<void> AlarmStore::append(std::span<const AlarmRecord> records, const QString& run) {
    if (records.empty() || !isOpen()) return {};
    m_database.transaction();
    QSqlQuery query(m_database);
    query.prepare(QStringLiteral("INSERT OR IGNORE INTO events (alarm, kind, position, scan, time, wall, vals, user, "
                                 "run, calendar) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"));
    for (const AlarmRecord& record : records) {
        Json values = Json::object();
        for (const auto& [name, value] : record.values) values[toUtf8(name)] = toJson(value);
        const QVariant fields[] = {record.alarm,
                                   static_cast<int>(record.kind),
                                   record.at.position,
                                   record.at.scan,
                                   qint64(record.at.time.count()),
                                   record.wallTime,
                                   QString::fromStdString(values.dump()),
                                   record.user.isNull() ? QStringLiteral("") : record.user,
                                   run.isEmpty() ? QVariant() : QVariant(run), // no run differs from every other
                                   record.calendar};
        for (int i = 0; i < static_cast<int>(std::size(fields)); ++i) query.bindValue(i, fields[i]);
        if (!query.exec()) {
            m_database.rollback();
            return Error{errors::AlarmHistoryNotWritten(query.lastError().text().toStdString()),
                         m_database.databaseName().toStdString()};
        }
    }
    m_database.commit();
    return {};
}

std::vector<AlarmRecord> AlarmStore::query(const AlarmQuery& wanted) const {
    std::vector<AlarmRecord> out;
    QString where = QStringLiteral("WHERE 1");
    QVariantList bound;
    if (wanted.before > 0) {
        where += QStringLiteral(" AND number < ?");
        bound += wanted.before;
    }
    if (wanted.kind) {
        where += QStringLiteral(" AND kind = ?");
        bound += static_cast<int>(*wanted.kind);
    }
    if (!wanted.alarms.isEmpty()) {
        where += QStringLiteral(" AND alarm IN (?%1)").arg(QStringLiteral(", ?").repeated(wanted.alarms.size() - 1));
        for (const QString& alarm : wanted.alarms) bound += alarm;
    }
    QSqlQuery query(m_database);
    query.setForwardOnly(true);
    query.prepare(
        QStringLiteral(
            "SELECT number, alarm, kind, position, scan, time, wall, vals, user, run, calendar FROM events %1 "
            "ORDER BY number DESC LIMIT %2")
            .arg(where)
            .arg(wanted.limit));
    for (const QVariant& value : bound) query.addBindValue(value);
    if (!query.exec()) return out;
    while (query.next()) {
        AlarmRecord record;
        record.number = query.value(0).toLongLong();
        record.alarm = query.value(1).toString();
        record.kind = static_cast<AlarmEventKind>(std::clamp(query.value(2).toInt(), 0, 2));
        record.at = {query.value(3).toULongLong(), query.value(4).toULongLong(),
                     Nanoseconds(query.value(5).toLongLong())};
        record.wallTime = query.value(6).toLongLong();
        const Json values = readJson<Json>(query.value(7).toString().toStdString()).value;
        if (values.is_object())
            for (const auto& [name, value] : values.items())
                record.values.emplace_back(QString::fromStdString(name), valueFromJson(value));
        record.user = query.value(8).toString();
        record.run = query.value(9).toString();
        record.calendar = query.value(10).toLongLong();
        out.push_back(std::move(record));
    }
    return out;
}

qint64 AlarmStore::count() const {
    QSqlQuery query(QStringLiteral("SELECT COUNT(*) FROM events"), m_database);
    return query.next() ? query.value(0).toLongLong() : 0;
}

qint64 AlarmStore::newest() const {
    QSqlQuery query(QStringLiteral("SELECT MAX(number) FROM events"), m_database);
    return query.next() ? query.value(0).toLongLong() : 0;
}

void AlarmStore::trim(qint64 keep) {
    QSqlQuery query(m_database);
    query.prepare(QStringLiteral("DELETE FROM events WHERE number <= (SELECT MAX(number) FROM events) - ?"));
    query.addBindValue(keep);
    query.exec();
}

void AlarmStore::clear() { QSqlQuery(QStringLiteral("DELETE FROM events"), m_database); }

} // namespace plc::hmi
