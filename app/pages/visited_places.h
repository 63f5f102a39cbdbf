// The places that were left in the texts, back and forward as in a browser. Knows no editors: who goes somewhere says
// where from. A value, owned by the tabs; GUI thread.
#pragma once
#include <QString>

#include <deque>
#include <optional>

namespace plc::app {

class VisitedPlaces {
public:
    struct Place {
        QString file;
        uint32_t offset = 0;
        bool operator==(const Place&) const = default;
    };
    /// Before one goes somewhere else.
    void remember(const Place& here) {
        constexpr size_t kMost = 100;
        if (!m_back.empty() && m_back.back() == here) return;
        m_back.push_back(here);
        if (m_back.size() > kMost) m_back.pop_front();
        m_forward.clear();
    }
    std::optional<Place> back(const std::optional<Place>& here) { return move(m_back, m_forward, here); }
    std::optional<Place> forward(const std::optional<Place>& here) { return move(m_forward, m_back, here); }

private:
    static std::optional<Place> move(std::deque<Place>& from, std::deque<Place>& to, const std::optional<Place>& here) {
        if (from.empty()) return std::nullopt;
        if (here) to.push_back(*here);
        Place there = from.back();
        from.pop_back();
        return there;
    }

    std::deque<Place> m_back, m_forward;
};

} // namespace plc::app
