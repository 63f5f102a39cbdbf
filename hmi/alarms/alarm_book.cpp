#include "hmi/alarms/alarm_book.h"

#include <QDateTime>
#include <QUuid>

namespace plc::hmi {

AlarmBook::AlarmBook(QObject* parent) : QObject(parent), m_lifeCycle({}), m_run(QUuid::createUuid().toString()) {}

void AlarmBook::setFile(const AlarmFile& file) {
    std::vector<AlarmEvent> kept;
    std::vector<AlarmRecord> keptRecords;
    const std::vector<AlarmDefinition> before = std::move(m_definitions);
    m_definitions = file.definitions();
    m_classes = file.classes();
    m_lifeCycle = AlarmLifeCycle(m_definitions);
    for (size_t i = 0; i < m_events.size(); ++i) {
        const int now = indexOf(before[m_events[i].alarm].id);
        if (now < 0) continue;
        kept.push_back(m_events[i]);
        kept.back().alarm = static_cast<size_t>(now);
        keptRecords.push_back(m_records[i]);
    }
    m_events = std::move(kept);
    m_records = std::move(keptRecords);
    m_lifeCycle.restore(m_events, ~quint64(0));
    emit changed();
}

Result<void> AlarmBook::openStore(const QString& path) {
    const Result<void> opened = m_store.open(path);
    if (!opened) (void)m_store.open(QStringLiteral(":memory:"));
    m_store.trim(100'000);
    m_newestBefore = m_store.newest();
    emit changed();
    return opened;
}

int AlarmBook::indexOf(const QString& id) const {
    for (size_t i = 0; i < m_definitions.size(); ++i)
        if (m_definitions[i].id == id) return static_cast<int>(i);
    return -1;
}

void AlarmBook::record(std::span<const AlarmEvent> events, const ValuesOf& values, const QString& user) {
    if (events.empty()) return;
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    std::vector<AlarmRecord> records;
    for (const AlarmEvent& event : events) {
        AlarmRecord record{0, m_definitions[event.alarm].id, event.kind, event.at, now, {}, user};
        record.calendar = clockOf(record);
        if (values && event.kind == AlarmEventKind::Raised) record.values = values(event.alarm, event.at);
        records.push_back(std::move(record));
    }
    m_events.insert(m_events.end(), events.begin(), events.end());
    m_records.insert(m_records.end(), records.begin(), records.end());
    if (m_store.isOpen()) (void)m_store.append(records);
    emit changed();
}

void AlarmBook::step(const AlarmInstant& at, std::span<const Condition> conditions, const ValuesOf& values) {
    std::vector<AlarmEvent> events;
    m_lifeCycle.step(at, conditions, events);
    record(events, values, {});
}

void AlarmBook::take(std::span<const AlarmRecord> records) {
    std::vector<AlarmRecord> known;
    for (const AlarmRecord& record : records) {
        const int alarm = indexOf(record.alarm);
        if (alarm < 0) continue;
        m_events.push_back({static_cast<size_t>(alarm), record.kind, record.at});
        m_lifeCycle.follow(m_events.back());
        m_records.push_back(record);
        m_records.back().calendar = clockOf(record);
        known.push_back(m_records.back());
    }
    if (known.empty()) return;
    if (m_store.isOpen()) (void)m_store.append(known, m_run);
    emit changed();
}

void AlarmBook::acknowledge(size_t alarm, const AlarmInstant& at, const QString& user) {
    std::vector<AlarmEvent> events;
    m_lifeCycle.acknowledge(alarm, at, events);
    record(events, {}, user);
}

void AlarmBook::acknowledgeAll(const AlarmInstant& at, const QStringList& classes, const QString& user) {
    std::vector<AlarmEvent> events;
    for (size_t i = 0; i < m_definitions.size(); ++i)
        if (classes.isEmpty() || classes.contains(m_definitions[i].className)) m_lifeCycle.acknowledge(i, at, events);
    record(events, {}, user);
}

std::vector<AlarmRecord> AlarmBook::takeAcknowledged() {
    std::vector<AlarmRecord> acknowledged;
    for (AlarmRecord& record : m_records)
        if (record.kind == AlarmEventKind::Acknowledged) acknowledged.push_back(std::move(record));
    m_records.clear();
    m_events.clear();
    m_lifeCycle.restore({}, 0);
    return acknowledged;
}

void AlarmBook::rewind(quint64 position) {
    std::vector<AlarmEvent> kept;
    std::vector<AlarmRecord> keptRecords;
    for (size_t i = 0; i < m_events.size(); ++i) {
        if (m_events[i].at.position > position) continue;
        kept.push_back(m_events[i]);
        keptRecords.push_back(m_records[i]);
    }
    m_events = std::move(kept);
    m_records = std::move(keptRecords);
    m_lifeCycle.restore(m_events, position);
    emit changed();
}

void AlarmBook::clear() {
    m_events.clear();
    m_records.clear();
    m_run = QUuid::createUuid().toString();
    m_lifeCycle.restore({}, 0);
    emit changed();
}

/// By the calendar of its own run; what an older version wrote has only the wall clock.
qint64 AlarmBook::clockOf(const AlarmRecord& record) const {
    if (record.calendar != 0) return record.calendar;
    if (isEarlier(record) && record.wallTime != 0) return record.wallTime * 1'000'000;
    return m_clockAtZero + record.at.time.count();
}

bool AlarmBook::isEarlier(const AlarmRecord& record) const {
    return record.number != 0 && record.number <= m_newestBefore && record.run != m_run;
}

AlarmEntry AlarmBook::entryOf(size_t alarm) const {
    const AlarmDefinition& definition = m_definitions[alarm];
    AlarmEntry entry;
    entry.alarm = alarm;
    entry.id = definition.id;
    entry.className = definition.className;
    entry.text = definition.text;
    entry.priority = definition.priority;
    return entry;
}

std::vector<AlarmEntry> AlarmBook::entries(const AlarmLifeCycle& states, quint64 until, const QStringList& classes,
                                           AlarmOrder order) const {
    std::vector<AlarmEntry> out;
    for (size_t i = 0; i < m_definitions.size(); ++i) {
        if (states.state(i) == AlarmState::Normal) continue;
        if (!classes.isEmpty() && !classes.contains(m_definitions[i].className)) continue;
        if (until == ~quint64(0) && m_suppression.isAside(m_definitions[i].id)) continue; // the past shows all
        AlarmEntry entry = entryOf(i);
        entry.state = states.state(i);
        entry.raised = states.raisedAt(i);
        for (size_t e = m_events.size(); e-- > 0;) {
            const AlarmEvent& event = m_events[e];
            if (event.alarm != i || event.at.position > until) continue;
            const qint64 clock = clockOf(m_records[e]);
            if (event.kind == AlarmEventKind::Returned && !entry.returned)
                entry.returned = event.at, entry.returnedClock = clock;
            if (event.kind == AlarmEventKind::Acknowledged && !entry.acknowledged)
                entry.acknowledged = event.at, entry.acknowledgedClock = clock;
            if (event.kind != AlarmEventKind::Raised) continue;
            entry.raisedClock = clock;
            entry.values = m_records[e].values;
            entry.wallTime = m_records[e].wallTime;
            break;
        }
        out.push_back(std::move(entry));
    }
    markFirstOut(out);
    const auto urgency = [](const AlarmEntry& entry) {
        return entry.state == AlarmState::Unacknowledged ? 0 : entry.state == AlarmState::Returned ? 1 : 2;
    };
    std::stable_sort(out.begin(), out.end(), [&](const AlarmEntry& a, const AlarmEntry& b) {
        if (order == AlarmOrder::Priority) {
            if (urgency(a) != urgency(b)) return urgency(a) < urgency(b);
            if (a.priority != b.priority) return a.priority < b.priority;
        }
        return a.raised.position > b.raised.position;
    });
    return out;
}

/// Of each group the alarm that was raised first among those that are present.
void AlarmBook::markFirstOut(std::vector<AlarmEntry>& entries) const {
    QMap<QString, AlarmEntry*> first;
    for (AlarmEntry& entry : entries) {
        const QString& group = m_definitions[entry.alarm].firstOut;
        if (group.isEmpty()) continue;
        AlarmEntry*& known = first[group];
        if (!known || entry.raised.position < known->raised.position) known = &entry;
    }
    for (AlarmEntry* entry : first) entry->isFirstOut = true;
}

std::vector<AlarmEntry> AlarmBook::aside(const QStringList& classes) const {
    std::vector<AlarmEntry> out;
    for (size_t i = 0; i < m_definitions.size(); ++i) {
        if (!m_suppression.isAside(m_definitions[i].id)) continue;
        if (!classes.isEmpty() && !classes.contains(m_definitions[i].className)) continue;
        AlarmEntry entry = entryOf(i);
        entry.state = m_lifeCycle.state(i);
        entry.raised = m_lifeCycle.raisedAt(i);
        out.push_back(std::move(entry));
    }
    return out;
}

Result<void> AlarmBook::change(const std::function<Result<void>(AlarmSuppression&)>& how) {
    Result<void> done = how(m_suppression);
    emit changed();
    return done;
}

std::vector<QString> AlarmBook::expire(const QDateTime& now) {
    std::vector<QString> back = m_suppression.expire(now);
    if (!back.empty()) emit changed();
    return back;
}

Result<void> AlarmBook::keepAsideIn(const QString& path) {
    Result<void> opened = m_suppression.open(path);
    emit changed();
    return opened;
}

AlarmStatistics AlarmBook::statistics(Nanoseconds lookedBack) const {
    Nanoseconds last{};
    std::vector<AlarmRecord> records = m_records;
    for (const AlarmRecord& record : records) last = std::max(last, record.at.time);
    return statisticsOf(std::move(records), std::max(Nanoseconds{}, last - lookedBack), last);
}

std::vector<AlarmEntry> AlarmBook::present(const QStringList& classes, AlarmOrder order) const {
    return entries(m_lifeCycle, ~quint64(0), classes, order);
}

std::vector<AlarmEntry> AlarmBook::presentAt(quint64 position, const QStringList& classes, AlarmOrder order) const {
    AlarmLifeCycle past(m_definitions);
    past.restore(m_events, position);
    return entries(past, position, classes, order);
}

std::vector<AlarmEntry> AlarmBook::history(const QStringList& classes, int limit) const {
    std::vector<AlarmRecord> records;
    if (m_store.isOpen()) {
        AlarmQuery query;
        query.limit = limit * 4;
        records = m_store.query(query);
    } else {
        records.assign(m_records.rbegin(), m_records.rend());
    }
    // Newest first: a return or acknowledgement belongs to the next raise of the same alarm that follows in this order,
    // in the same run.
    struct Later {
        std::optional<AlarmRecord> returned, acknowledged;
    };
    std::vector<AlarmEntry> out;
    QHash<QString, Later> later;
    for (const AlarmRecord& record : records) {
        Later& found = later[record.alarm];
        if (record.kind == AlarmEventKind::Returned) found.returned = record;
        if (record.kind == AlarmEventKind::Acknowledged) found.acknowledged = record;
        if (record.kind != AlarmEventKind::Raised) continue;
        // What an operator did has no run of its own.
        const auto ofThisRun = [&](const std::optional<AlarmRecord>& other) {
            const bool isSame = other && isEarlier(*other) == isEarlier(record) &&
                                (other->run.isEmpty() || record.run.isEmpty() || other->run == record.run);
            return isSame ? other : std::nullopt;
        };
        AlarmEntry entry = occurrence(record, ofThisRun(found.returned), ofThisRun(found.acknowledged));
        found = {};
        if (!classes.isEmpty() && !classes.contains(entry.className)) continue;
        out.push_back(std::move(entry));
        if (static_cast<int>(out.size()) >= limit) break;
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const AlarmEntry& a, const AlarmEntry& b) { return a.raisedClock > b.raisedClock; });
    return out;
}

AlarmEntry AlarmBook::occurrence(const AlarmRecord& raised, const std::optional<AlarmRecord>& returned,
                                 const std::optional<AlarmRecord>& acknowledged) const {
    const int alarm = indexOf(raised.alarm);
    AlarmEntry entry;
    if (alarm >= 0) entry = entryOf(static_cast<size_t>(alarm));
    entry.id = raised.alarm;
    if (alarm < 0) entry.text = raised.alarm;
    entry.raised = raised.at;
    entry.raisedClock = clockOf(raised);
    entry.wallTime = raised.wallTime;
    entry.values = raised.values;
    if (returned) entry.returned = returned->at, entry.returnedClock = clockOf(*returned);
    if (acknowledged) entry.acknowledged = acknowledged->at, entry.acknowledgedClock = clockOf(*acknowledged);
    entry.isOfEarlierRun = isEarlier(raised);
    const bool needsAcknowledge = alarm < 0 || m_definitions[static_cast<size_t>(alarm)].mustAcknowledge;
    const bool isDone = acknowledged || !needsAcknowledge;
    entry.state = returned ? (isDone ? AlarmState::Normal : AlarmState::Returned)
                           : (isDone ? AlarmState::Acknowledged : AlarmState::Unacknowledged);
    return entry;
}

int AlarmBook::unacknowledgedCount() const {
    int count = 0;
    for (size_t i = 0; i < m_definitions.size(); ++i)
        count += m_lifeCycle.state(i) == AlarmState::Unacknowledged || m_lifeCycle.state(i) == AlarmState::Returned;
    return count;
}

QString AlarmBook::render(const AlarmEntry& entry, const TextCatalog& texts, const QString& tag) {
    return texts.fill(entry.text, tag, [&](const QString& name) {
        for (const auto& [key, value] : entry.values)
            if (key == name) return value;
        return Value();
    });
}

} // namespace plc::hmi
