// The life of alarms: a condition, delays and acknowledgement give states and events. It knows no PLC and no clock: it
// is stepped with the scan's time and the conditions' values. One owner, one thread (the player's evaluator).
#pragma once
#include "hmi/alarms/alarm_file.h"
#include "runtime/base/assert.h"

#include <chrono>
#include <span>

namespace plc::hmi {

using Nanoseconds = std::chrono::nanoseconds;

enum class AlarmState { Normal, Unacknowledged, Acknowledged, Returned /* gone, not yet acknowledged */ };
enum class AlarmEventKind { Raised, Returned, Acknowledged };

/// Where in the run something happened. The position counts recorded scans over all branches, scan and time are the
/// PLC's.
struct AlarmInstant {
    quint64 position = 0;
    quint64 scan = 0;
    Nanoseconds time{};
};

struct AlarmEvent {
    size_t alarm = 0; // index of the definition
    AlarmEventKind kind{};
    AlarmInstant at;
    bool operator==(const AlarmEvent& other) const {
        return alarm == other.alarm && kind == other.kind && at.position == other.at.position;
    }
};

/// A condition that cannot be evaluated leaves the alarm as it is.
enum class Condition : quint8 { False, True, Unknown };

class AlarmLifeCycle {
public:
    explicit AlarmLifeCycle(const std::vector<AlarmDefinition>& definitions);

    size_t count() const { return m_alarms.size(); }
    AlarmState state(size_t alarm) const { return m_alarms[alarm].state; }
    /// The scan at which the present (or last) occurrence was raised.
    const AlarmInstant& raisedAt(size_t alarm) const { return m_alarms[alarm].raised; }
    /// One scan: `conditions` in the order of the definitions.
    void step(const AlarmInstant& at, std::span<const Condition> conditions, std::vector<AlarmEvent>& events);
    void acknowledge(size_t alarm, const AlarmInstant& at, std::vector<AlarmEvent>& events);
    void acknowledgeAll(const AlarmInstant& at, std::vector<AlarmEvent>& events);
    /// Any alarm with a delay under way (its step must be called although no condition changes).
    bool hasPendingDelay() const { return m_pending > 0; }
    /// The states that follow from the events up to and with `until`, as at a past scan.
    void restore(std::span<const AlarmEvent> events, quint64 until);
    /// One event that was found elsewhere.
    void follow(const AlarmEvent& event);

private:
    struct Alarm {
        Nanoseconds onDelay{}, offDelay{};
        bool mustAcknowledge = true;
        AlarmState state = AlarmState::Normal;
        std::optional<Nanoseconds> changedAt; // since when the condition differs from the state
        AlarmInstant raised;
        bool isActive() const { return state == AlarmState::Unacknowledged || state == AlarmState::Acknowledged; }
    };
    void apply(Alarm& alarm, AlarmEventKind kind, const AlarmInstant& at);
    std::vector<Alarm> m_alarms;
    size_t m_pending = 0;
};

} // namespace plc::hmi
