// How far long work has come, and whether it is to end. The worker tells and asks between its pieces; who shows the
// work reads and cancels. Shared by both; `enter` belongs to the thread that leads the work, all else to any thread.
#pragma once
#include <algorithm>
#include <atomic>

namespace plc {

class Progress {
public:
    /// What follows is this part of the whole (0..1).
    void enter(double from, double to) {
        m_from = from;
        m_to = to;
        (void)reached(0);
    }
    /// `share` of the part (0..1) is done; false when the work is to end.
    [[nodiscard]] bool reached(double share) {
        m_share.store(m_from + (m_to - m_from) * std::clamp(share, 0.0, 1.0), std::memory_order_relaxed);
        return !isCancelled();
    }
    [[nodiscard]] double share() const { return m_share.load(std::memory_order_relaxed); }
    void cancel() { m_isCancelled.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool isCancelled() const { return m_isCancelled.load(std::memory_order_relaxed); }

private:
    double m_from = 0, m_to = 1;
    std::atomic<double> m_share{0};
    std::atomic<bool> m_isCancelled{false};
};

/// The same for work that nobody may be watching.
[[nodiscard]] inline bool goesOn(Progress* progress, double share) { return !progress || progress->reached(share); }
[[nodiscard]] inline bool isCancelled(const Progress* progress) { return progress && progress->isCancelled(); }

} // namespace plc
