// How late the scans of a controller in real time begin and end, and the latest of them: what --stats and /metrics of
// `stepwise serve` show. Written by the scan thread alone, bounded work a scan; others read a copy.
#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

namespace plc::session {

/// How often a time was seen, by powers of two of a microsecond: bucket i counts what is below 2^i us; the last one
/// takes the rest.
class TimeHistogram {
public:
    static constexpr size_t kBuckets = 24;
    void add(int64_t nanoseconds);
    [[nodiscard]] const std::array<uint64_t, kBuckets>& buckets() const { return m_buckets; }
    [[nodiscard]] uint64_t count() const { return m_count; }
    [[nodiscard]] int64_t mostNs() const { return m_most; }
    [[nodiscard]] double meanNs() const { return m_count == 0 ? 0 : m_sum / static_cast<double>(m_count); }

private:
    std::array<uint64_t, kBuckets> m_buckets{};
    uint64_t m_count = 0;
    int64_t m_most = 0;
    double m_sum = 0;
};

struct ScanTime {
    uint64_t scan = 0;
    std::chrono::nanoseconds at{}; // of the controller's clock
    int64_t wakeUpNs = 0;          // from the instant that it was due to its begin
    int64_t executionNs = 0;
    [[nodiscard]] int64_t endNs() const { return wakeUpNs + executionNs; }
};

struct ScanTimes {
    static constexpr size_t kWorst = 10;
    TimeHistogram wakeUp, execution, end;
    std::vector<ScanTime> worst; // the latest ends first, kWorst at most; their memory is there from the start
    ScanTimes() { worst.reserve(kWorst + 1); }
    void add(const ScanTime& scan);
};

} // namespace plc::session
