#include "projects/session/scan_times.h"

#include <algorithm>
#include <bit>

namespace plc::session {

void TimeHistogram::add(int64_t nanoseconds) {
    const int64_t time = std::max<int64_t>(nanoseconds, 0);
    ++m_buckets[std::min<size_t>(kBuckets - 1,
                                 static_cast<size_t>(std::bit_width(static_cast<uint64_t>(time) / 1000)))];
    ++m_count;
    m_most = std::max(m_most, time);
    m_sum += static_cast<double>(time);
}

void ScanTimes::add(const ScanTime& scan) {
    wakeUp.add(scan.wakeUpNs);
    execution.add(scan.executionNs);
    end.add(scan.endNs());
    if (worst.size() == kWorst && scan.endNs() <= worst.back().endNs()) return;
    worst.insert(std::upper_bound(worst.begin(), worst.end(), scan,
                                  [](const ScanTime& a, const ScanTime& b) { return a.endNs() > b.endNs(); }),
                 scan);
    if (worst.size() > kWorst) worst.pop_back();
}

} // namespace plc::session
