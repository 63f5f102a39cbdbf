// Where the controller reads how long things took (D6). Programs never see it. A clock is read on the scan thread;
// tests hand in one that they move themselves.
#pragma once
#include <cstdint>

namespace plc::controller {

class Clock {
public:
    virtual ~Clock() = default;
    [[nodiscard]] virtual int64_t nowNs() = 0;
};

/// The machine's monotonic clock.
class SteadyClock final : public Clock {
public:
    [[nodiscard]] int64_t nowNs() override;
};

} // namespace plc::controller
