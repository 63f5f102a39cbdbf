// The alarm history in SQLite: time, alarm and the values of its text, never the rendered text, so that past entries
// follow the operator's language. Owned by the player; used on the thread that opened it.
#pragma once
#include "hmi/alarms/life_cycle.h"
#include "hmi/model/value.h"

#include <QSqlDatabase>
#include <QStringList>

namespace plc::hmi {

struct AlarmRecord {
    qint64 number = 0; // given by the store
    QString alarm;     // id of the definition
    AlarmEventKind kind{};
    AlarmInstant at;
    qint64 wallTime = 0; // ms since 1970 when it was recorded, 0 in virtual time
    std::vector<std::pair<QString, Value>> values;
    QString user;
    qint64 calendar = 0; // of the controller, in nanoseconds since 1970; 0 in files of older versions
    QString run;         // as it was appended with
};

struct AlarmQuery {
    QStringList alarms; // ids; empty: all
    std::optional<AlarmEventKind> kind;
    qint64 before = 0; // numbers below this one; 0: from the newest
    int limit = 200;
};

class AlarmStore {
public:
    AlarmStore() = default;
    ~AlarmStore();
    AlarmStore(const AlarmStore&) = delete;
    AlarmStore& operator=(const AlarmStore&) = delete;

    /// ":memory:" keeps it in memory.
    Result<void> open(const QString& path);
    void close();
    bool isOpen() const { return m_database.isOpen(); }
    QString path() const { return isOpen() ? m_database.databaseName() : QString(); }
    /// One transaction. Records with a run (of a controller, from its start to its end) are kept once, however often
    /// they are found.
    Result<void> append(std::span<const AlarmRecord> records, const QString& run = {});
    /// Newest first.
    std::vector<AlarmRecord> query(const AlarmQuery& query) const;
    qint64 count() const;
    /// Keeps the newest `keep` entries.
    void trim(qint64 keep);
    void clear();
    /// The newest number; what has one above it was appended since.
    qint64 newest() const;

private:
    QSqlDatabase m_database;
    QString m_connection;
};

/// Values of alarm texts as JSON and back, kind and bits kept.
Json toJson(const Value& value);
Value valueFromJson(const Json& json);

} // namespace plc::hmi
