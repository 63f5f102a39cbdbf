#include "editor/trace/recording/branch_recording.h"

#include <algorithm>

namespace plc::trace {

BranchRecording::BranchRecording(const Recording& of, Position end) : m_of(of), m_end(end), m_branches(of.branches()) {
    std::erase_if(m_branches, [end](const history::Branch& branch) { return branch.first >= end; });
    m_chain = history::chainTo(m_branches, end);
}

std::vector<history::Mark> BranchRecording::marks() const {
    std::vector<history::Mark> marks = m_of.marks();
    std::erase_if(marks, [this](const history::Mark& mark) { return mark.position >= m_end; });
    return marks;
}

std::optional<history::ScanStamp> BranchRecording::stamp(Position position) const {
    return position < m_end ? m_of.stamp(position) : std::nullopt;
}

/// Along the chain time only grows: the last scan of it at or before the time.
std::optional<Position> BranchRecording::positionAt(int64_t time) const {
    const Position first = m_of.extent().first;
    std::optional<Position> found;
    for (const PositionRange& range : m_chain) {
        Position low = std::max(range.begin, first), high = range.end;
        while (low < high) {
            const Position middle = low + (high - low) / 2;
            const auto at = m_of.stamp(middle);
            if (at && at->time.count() <= time) {
                found = middle;
                low = middle + 1;
            } else {
                high = middle;
            }
        }
    }
    return found;
}

} // namespace plc::trace
