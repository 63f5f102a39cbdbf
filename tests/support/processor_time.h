// Processor time of this process, all threads: what a test measures where the machine may be busy with other things.
#pragma once
#include <ctime>
#include <vector>

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

/// What `bytes` of memory cost that are used for the first time: of 120 MB 0.03 s, and 0.5 s on a virtual machine whose
/// host has a hand in every page.
inline double secondsForNewMemory(size_t bytes) {
    const double begun = processorSeconds();
    const std::vector<char> fresh(bytes, 'x');
    const double took = processorSeconds() - begun;
    return fresh.back() == 'x' ? took : 0;
}

} // namespace plc
