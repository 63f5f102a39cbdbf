// Processor time of this process, all threads: what a test measures where the machine may be busy with other things.
#pragma once
#include <ctime>
#include <sys/resource.h>
#include <vector>

namespace plc {

inline double processorSeconds() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Of that what the process's own code took, without what the kernel does to bring memory that is new to it: on a
/// virtual machine whose host has to find it first that costs ten times as much. Rougher, for it is sampled.
inline double ownSeconds() {
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    return static_cast<double>(used.ru_utime.tv_sec) + static_cast<double>(used.ru_utime.tv_usec) * 1e-6;
}

/// "At once" for somebody who asks a program to stop: half a second, of which the scan itself may take 0.2 s. Code with
/// sanitizers is slower, and several threads work at the same time.
#ifdef PLC_SANITIZED
inline constexpr double kAtOnceSeconds = 5;
#else
inline constexpr double kAtOnceSeconds = 0.5;
#endif

/// What it takes to fill `bytes` of memory that are used for the first time; of the host's part, what counts as the
/// process's own.
inline double secondsForNewMemory(size_t bytes) {
    const double begun = ownSeconds();
    const std::vector<char> fresh(bytes, 'x');
    const double took = ownSeconds() - begun;
    return fresh.back() == 'x' ? took : 0;
}

} // namespace plc
