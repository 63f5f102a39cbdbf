#include "runtime/platform/wake_up.h"

#include "runtime/base/assert.h"

#include <ctime>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace plc::platform {

WakeUp::WakeUp() : m_event(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) { PLC_ASSERT(m_event >= 0, return ); }
WakeUp::~WakeUp() { ::close(m_event); }

void WakeUp::signal() {
    const uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(m_event, &one, sizeof one);
}

void WakeUp::wait(int64_t nanoseconds) {
    pollfd waited{m_event, POLLIN, 0};
    timespec time{};
    time.tv_sec = static_cast<time_t>(nanoseconds / 1'000'000'000);
    time.tv_nsec = static_cast<long>(nanoseconds % 1'000'000'000);
    if (::ppoll(&waited, 1, nanoseconds < 0 ? nullptr : &time, nullptr) > 0) {
        uint64_t count = 0;
        [[maybe_unused]] const ssize_t got = ::read(m_event, &count, sizeof count);
    }
}

} // namespace plc::platform
