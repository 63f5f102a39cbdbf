#include "hmi/alarms/life_cycle.h"

#include <cmath>

namespace plc::hmi {

namespace {
Nanoseconds fromSeconds(double seconds) { return Nanoseconds(static_cast<qint64>(std::llround(seconds * 1e9))); }
} // namespace

AlarmLifeCycle::AlarmLifeCycle(const std::vector<AlarmDefinition>& definitions) {
    for (const AlarmDefinition& one : definitions)
        m_alarms.push_back(
            {fromSeconds(one.onDelay), fromSeconds(one.offDelay), one.mustAcknowledge, AlarmState::Normal, {}, {}});
}

void AlarmLifeCycle::apply(Alarm& alarm, AlarmEventKind kind, const AlarmInstant& at) {
    switch (kind) {
    case AlarmEventKind::Raised:
        alarm.state = alarm.mustAcknowledge ? AlarmState::Unacknowledged : AlarmState::Acknowledged;
        alarm.raised = at;
        return;
    case AlarmEventKind::Returned:
        alarm.state = alarm.state == AlarmState::Unacknowledged ? AlarmState::Returned : AlarmState::Normal;
        return;
    case AlarmEventKind::Acknowledged:
        if (alarm.state == AlarmState::Unacknowledged) alarm.state = AlarmState::Acknowledged;
        if (alarm.state == AlarmState::Returned) alarm.state = AlarmState::Normal;
        return;
    }
}

void AlarmLifeCycle::step(const AlarmInstant& at, std::span<const Condition> conditions,
                          std::vector<AlarmEvent>& events) {
    PLC_ASSERT(conditions.size() == m_alarms.size(), return );
    m_pending = 0;
    for (size_t i = 0; i < m_alarms.size(); ++i) {
        Alarm& alarm = m_alarms[i];
        if (conditions[i] == Condition::Unknown) continue;
        const bool on = conditions[i] == Condition::True;
        if (on == alarm.isActive()) {
            alarm.changedAt.reset();
            continue;
        }
        if (!alarm.changedAt) alarm.changedAt = at.time;
        if (at.time - *alarm.changedAt < (on ? alarm.onDelay : alarm.offDelay)) {
            ++m_pending;
            continue;
        }
        alarm.changedAt.reset();
        const AlarmEventKind kind = on ? AlarmEventKind::Raised : AlarmEventKind::Returned;
        apply(alarm, kind, at);
        events.push_back({i, kind, at});
    }
}

void AlarmLifeCycle::acknowledge(size_t index, const AlarmInstant& at, std::vector<AlarmEvent>& events) {
    PLC_ASSERT(index < m_alarms.size(), return );
    Alarm& alarm = m_alarms[index];
    if (alarm.state != AlarmState::Unacknowledged && alarm.state != AlarmState::Returned) return;
    apply(alarm, AlarmEventKind::Acknowledged, at);
    events.push_back({index, AlarmEventKind::Acknowledged, at});
}

void AlarmLifeCycle::acknowledgeAll(const AlarmInstant& at, std::vector<AlarmEvent>& events) {
    for (size_t i = 0; i < m_alarms.size(); ++i) acknowledge(i, at, events);
}

void AlarmLifeCycle::follow(const AlarmEvent& event) {
    PLC_ASSERT(event.alarm < m_alarms.size(), return );
    apply(m_alarms[event.alarm], event.kind, event.at);
}

void AlarmLifeCycle::restore(std::span<const AlarmEvent> events, quint64 until) {
    m_pending = 0;
    for (Alarm& alarm : m_alarms) {
        alarm.state = AlarmState::Normal;
        alarm.changedAt.reset();
        alarm.raised = {};
    }
    for (const AlarmEvent& event : events)
        if (event.at.position <= until && event.alarm < m_alarms.size())
            apply(m_alarms[event.alarm], event.kind, event.at);
}

} // namespace plc::hmi
