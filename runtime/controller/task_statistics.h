// How often and how long a task ran. A value; any thread with a copy.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace plc::controller {

struct TaskStatistics {
    std::string name;
    uint64_t count = 0, overruns = 0;
    int64_t lastNs = 0, minNs = 0, maxNs = 0;
    double meanNs = 0;
    int64_t jitterNs = 0;            // greatest deviation of start from its due time
    std::vector<uint32_t> histogram; // execution time: powers of two from 1 µs
};

} // namespace plc::controller
