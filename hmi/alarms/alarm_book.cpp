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
    if (opened)
        m_store.trim(100'000);
    else
        (void)m_store.open(QStringLiteral(":memory:"));
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
        known.push_back(record);
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
            if (event.kind == AlarmEventKind::Returned && !entry.returned) entry.returned = event.at;
            if (event.kind == AlarmEventKind::Acknowledged && !entry.acknowledged) entry.acknowledged = event.at;
            if (event.kind != AlarmEventKind::Raised) continue;
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
    // Newest first: a return or acknowledgement belongs to the next raise of the same alarm that follows in this order.
    std::vector<AlarmEntry> out;
    QHash<QString, std::pair<std::optional<AlarmInstant>, std::optional<AlarmInstant>>> later;
    for (const AlarmRecord& record : records) {
        auto& [returned, acknowledged] = later[record.alarm];
        if (record.kind == AlarmEventKind::Returned) returned = record.at;
        if (record.kind == AlarmEventKind::Acknowledged) acknowledged = record.at;
        if (record.kind != AlarmEventKind::Raised) continue;
        const int alarm = indexOf(record.alarm);
        AlarmEntry entry;
        if (alarm >= 0) entry = entryOf(static_cast<size_t>(alarm));
        entry.id = record.alarm;
        if (alarm < 0) entry.text = record.alarm;
        entry.raised = record.at;
        entry.wallTime = record.wallTime;
        entry.values = record.values;
        const bool needsAcknowledge = alarm < 0 || m_definitions[static_cast<size_t>(alarm)].mustAcknowledge;
        entry.returned = returned;
        entry.acknowledged = acknowledged;
        entry.state = returned
                          ? (acknowledged || !needsAcknowledge ? AlarmState::Normal : AlarmState::Returned)
                          : (acknowledged || !needsAcknowledge ? AlarmState::Acknowledged : AlarmState::Unacknowledged);
        returned.reset();
        acknowledged.reset();
        if (!classes.isEmpty() && !classes.contains(entry.className)) continue;
        out.push_back(std::move(entry));
        if (static_cast<int>(out.size()) >= limit) break;
    }
    return out;
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
