// What acted from outside on the scans that are sent to a mirror, so that there, too, a scan can be looked into and a
// value has its "who". Belongs to the door of one connection; one thread.
#pragma once
#include "runtime/history/history.h"

#include <map>

namespace plc::remote {

class JournalSender {
public:
    explicit JournalSender(const history::History& history) : m_history(history) {}
    /// The scan before the next one is not known there: that one brings all that it depends on.
    void restart() { m_isConnected = false; }
    /// Before the first of these is sent.
    void gather(history::PositionRange range);
    /// Of the next scan; empty: nothing acted on it.
    [[nodiscard]] std::vector<std::byte> of(history::Position position);

private:
    [[nodiscard]] std::optional<history::JournalEntry> whole(history::Position position) const;
    const history::History& m_history;
    std::map<history::Position, history::JournalEntry> m_entries;
    bool m_isConnected = false;
};

} // namespace plc::remote
