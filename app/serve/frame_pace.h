// When a server's next frame begins: 30 a second, and as many fewer as leave a quarter of the time for everything else
// where frames take long. And the time that those at its other end are given. Values of the server; times are
// arguments, ms of any epoch.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>

namespace plc::serve {

class FramePace {
public:
    static constexpr int64_t kFrame = 33, kSlowest = 500;

    /// How long to wait after a frame, so that frames begin, not end, at even distances.
    int64_t waitAfter(int64_t begin, int64_t end) {
        const int64_t period = std::clamp<int64_t>((end - begin) * 4 / 3, kFrame, kSlowest);
        const bool isLate = begin - m_due >= period; // after a pause there is nothing to make up for
        m_due = (isLate ? begin : m_due) + period;
        return std::clamp<int64_t>(m_due - end, 1, kSlowest);
    }

private:
    int64_t m_due = INT64_MIN / 2; // of the frame that is painted
};

/// The time in which somebody must answer. It passes only as long as answers can be heard: a server whose machine had
/// other work for a minute counts a second of it, and drops nobody for its own silence.
class PeerTime {
public:
    static constexpr int64_t kMostBetweenFrames = 2 * FramePace::kSlowest;

    /// At each frame; ms since the first.
    int64_t at(int64_t now) {
        if (m_last) m_time += std::clamp<int64_t>(now - *m_last, 0, kMostBetweenFrames);
        m_last = now;
        return m_time;
    }

private:
    std::optional<int64_t> m_last;
    int64_t m_time = 0;
};

} // namespace plc::serve
