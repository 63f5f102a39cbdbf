// Processor time of this process, all threads: what a test measures where the machine may be busy with other things.
#pragma once
#include <ctime>

namespace plc {

inline double processorSeconds() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// "At once" for somebody who asks a program to stop: half a second, of which the scan itself may take 0.2 s. Code with
/// sanitizers is slower, and several threads work at the same time.
#ifdef PLC_SANITIZED
inline constexpr double kAtOnceSeconds = 5;
#else
inline constexpr double kAtOnceSeconds = 0.5;
#endif

} // namespace plc
