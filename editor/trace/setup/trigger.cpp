#include "editor/trace/setup/trigger.h"

namespace plc::trace {

void TriggerMachine::setSetup(const TriggerSetup& setup) {
    m_setup = setup;
    m_before.reset();
    m_firedAt.reset();
    m_completeAt.reset();
    m_shots = 0;
    m_state = setup.mode == TriggerMode::Off || setup.expression.empty() ? TriggerState::Off : TriggerState::Armed;
}

void TriggerMachine::arm() {
    if (m_setup.mode == TriggerMode::Off || m_setup.expression.empty()) return;
    m_state = TriggerState::Armed;
    m_before.reset(); // the level at this moment is no edge
}

void TriggerMachine::disarm() { m_state = TriggerState::Off; }

bool TriggerMachine::fires(bool before, bool now) const {
    switch (m_setup.edge) {
    case TriggerEdge::Rising:
        return !before && now;
    case TriggerEdge::Falling:
        return before && !now;
    case TriggerEdge::Both:
        return before != now;
    case TriggerEdge::Level:
        return now;
    }
    return false;
}

void TriggerMachine::advanceTo(int64_t time) {
    if (m_state != TriggerState::Collecting || time - *m_firedAt < m_setup.after) return;
    m_completeAt = m_firedAt;
    ++m_shots;
    m_state = m_setup.mode == TriggerMode::Repeated ? TriggerState::Armed : TriggerState::Done;
}

void TriggerMachine::feed(int64_t time, std::optional<bool> isTrue) {
    advanceTo(time);
    const std::optional<bool> before = std::exchange(m_before, isTrue);
    if (m_state != TriggerState::Armed || !isTrue) return;
    const bool fired = m_setup.edge == TriggerEdge::Level ? *isTrue : before && fires(*before, *isTrue);
    if (!fired) return;
    m_firedAt = time;
    m_state = TriggerState::Collecting;
    advanceTo(time); // nothing to be shown after it
}

} // namespace plc::trace
