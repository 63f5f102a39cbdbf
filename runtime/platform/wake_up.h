// Lets the scan thread sleep until a time or until somebody posted a command. Owned by the session; signal() from any
// thread.
#pragma once
#include <cstdint>

namespace plc::platform {

class WakeUp {
public:
    WakeUp();
    ~WakeUp();
    WakeUp(const WakeUp&) = delete;
    WakeUp& operator=(const WakeUp&) = delete;
    void signal();
    /// < 0: until signalled.
    void wait(int64_t nanoseconds);

private:
    int m_event;
};

} // namespace plc::platform
