// The trigger of a trace as a state machine over samples of its expression: armed, fired and waiting for what comes
// after, done. Knows neither expression nor chart; pure, any thread.
#pragma once

#include "editor/trace/setup/trace_setup.h"

#include <optional>

namespace plc::trace {

enum class TriggerState : uint8_t { Off, Armed, Collecting, Done };

class TriggerMachine {
public:
    void setSetup(const TriggerSetup& setup); // starts again
    /// Single: ready for another shot.
    void arm();
    void disarm();

    /// One sample, in order of time. `isTrue` unset: no value, never an edge.
    void feed(int64_t time, std::optional<bool> isTrue);
    /// Time goes on without samples.
    void advanceTo(int64_t time);

    [[nodiscard]] TriggerState state() const { return m_state; }
    /// When it fired last; kept until it fires again.
    [[nodiscard]] std::optional<int64_t> firedAt() const { return m_firedAt; }
    /// When the last complete shot fired: everything to be shown after it is there.
    [[nodiscard]] std::optional<int64_t> completeAt() const { return m_completeAt; }
    [[nodiscard]] uint64_t shots() const { return m_shots; } // complete ones

private:
    [[nodiscard]] bool fires(bool before, bool now) const;

    TriggerSetup m_setup;
    TriggerState m_state = TriggerState::Off;
    std::optional<bool> m_before;
    std::optional<int64_t> m_firedAt, m_completeAt;
    uint64_t m_shots = 0;
};

} // namespace plc::trace
