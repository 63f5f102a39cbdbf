// The alarms of a running panel: definitions, life cycle and history together, as alarm lists show them. The evaluator
// brings conditions scan by scan; lists read entries. Owned by the player; main thread.
#pragma once
#include "hmi/alarms/alarm_store.h"
#include "hmi/alarms/statistics.h"
#include "hmi/alarms/suppression.h"
#include "hmi/texts/catalog.h"

#include <QObject>

namespace plc::hmi {

/// A line of an alarm list.
struct AlarmEntry {
    size_t alarm = 0; // index of the definition; of no use in the history of an alarm that is gone
    QString id, className, text;
    int priority = 2;
    AlarmState state = AlarmState::Normal;
    AlarmInstant raised;
    std::optional<AlarmInstant> returned, acknowledged;
    qint64 wallTime = 0;
    std::vector<std::pair<QString, Value>> values;
    /// The same instants by the calendar of the controller that was running then, in nanoseconds since 1970.
    qint64 raisedClock = 0;
    std::optional<qint64> returnedClock, acknowledgedClock;
    bool isOfEarlierRun = false; // the controller has been started again since
    bool isFirstOut = false;     // came first of its group
};

enum class AlarmOrder { Priority, Time };

class AlarmBook final : public QObject {
    Q_OBJECT
public:
    explicit AlarmBook(QObject* parent = nullptr);

    /// New definitions; states of alarms that stay (same id) are kept.
    void setFile(const AlarmFile& file);
    /// The newest 100,000 entries of the file are kept. In memory when it cannot be used.
    Result<void> openStore(const QString& path);
    QString storePath() const { return m_store.path(); }
    /// Which run of a controller findings are of; found again by another watch, they are not kept twice. A new one
    /// after `clear`.
    void setRun(const QString& run) { m_run = run; }
    const std::vector<AlarmDefinition>& definitions() const { return m_definitions; }
    const std::vector<AlarmClass>& classes() const { return m_classes; }

    /// The controller's calendar at PLC time 0, in nanoseconds since 1970.
    void setClockAtZero(qint64 nanoseconds) { m_clockAtZero = nanoseconds; }
    qint64 clockAtZero() const { return m_clockAtZero; }

    /// Values of an alarm's text at the scan of an event.
    using ValuesOf = std::function<std::vector<std::pair<QString, Value>>(size_t alarm, const AlarmInstant& at)>;
    /// One recorded scan. `values` is asked for alarms that are raised.
    void step(const AlarmInstant& at, std::span<const Condition> conditions, const ValuesOf& values);
    /// The same for events that were found elsewhere (the evaluator's thread).
    void take(std::span<const AlarmRecord> records);
    void acknowledge(size_t alarm, const AlarmInstant& at, const QString& user = {});
    void acknowledgeAll(const AlarmInstant& at, const QStringList& classes = {}, const QString& user = {});
    /// What was acknowledged in this run, oldest first; the watch that starts again finds the rest in the recording.
    std::vector<AlarmRecord> takeAcknowledged();
    /// After going back in time: what happened later is no longer of this branch.
    void rewind(quint64 position);
    void clear();
    const AlarmLifeCycle& lifeCycle() const { return m_lifeCycle; }

    /// Present alarms (also returned ones that wait for acknowledgement); `classes` empty: all.
    std::vector<AlarmEntry> present(const QStringList& classes, AlarmOrder order) const;
    /// Those that people have set aside, whether their condition holds or not.
    std::vector<AlarmEntry> aside(const QStringList& classes) const;
    const AlarmSuppression& suppression() const { return m_suppression; }
    /// Changes what is set aside; lists follow.
    Result<void> change(const std::function<Result<void>(AlarmSuppression&)>& how);
    /// Shelved alarms whose time is over come back; their ids.
    std::vector<QString> expire(const QDateTime& now);
    Result<void> keepAsideIn(const QString& path);
    /// Of this run, up to its newest event.
    AlarmStatistics statistics(Nanoseconds lookedBack) const;
    AlarmEntry entryOf(size_t alarm) const;
    /// As they were at a past scan.
    std::vector<AlarmEntry> presentAt(quint64 position, const QStringList& classes, AlarmOrder order) const;
    /// Past occurrences, newest first by the calendar, with their return and acknowledgement.
    std::vector<AlarmEntry> history(const QStringList& classes, int limit) const;
    int unacknowledgedCount() const;
    int indexOf(const QString& id) const;
    /// The entry's text in the language, with the values it had.
    static QString render(const AlarmEntry& entry, const TextCatalog& texts, const QString& tag);

signals:
    void changed();

private:
    void record(std::span<const AlarmEvent> events, const ValuesOf& values, const QString& user);
    std::vector<AlarmEntry> entries(const AlarmLifeCycle& states, quint64 until, const QStringList& classes,
                                    AlarmOrder order) const;
    qint64 clockOf(const AlarmRecord& record) const;
    bool isEarlier(const AlarmRecord& record) const;
    AlarmEntry occurrence(const AlarmRecord& raised, const std::optional<AlarmRecord>& returned,
                          const std::optional<AlarmRecord>& acknowledged) const;
    void markFirstOut(std::vector<AlarmEntry>& entries) const;

    std::vector<AlarmDefinition> m_definitions;
    std::vector<AlarmClass> m_classes;
    AlarmLifeCycle m_lifeCycle;
    AlarmStore m_store;
    AlarmSuppression m_suppression;
    QString m_run;
    qint64 m_newestBefore = 0;                 // number in the store of what was there before this book opened it
    qint64 m_clockAtZero = 946684800000000000; // 2000-01-01, where virtual time begins
    std::vector<AlarmEvent> m_events;          // of this run, oldest first
    std::vector<AlarmRecord> m_records;        // beside each event, for values at a past scan
};

} // namespace plc::hmi
