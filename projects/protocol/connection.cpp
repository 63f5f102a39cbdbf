#include "projects/protocol/connection.h"

#include "runtime/platform/files.h"
#include "runtime/platform/streams.h"

#include <algorithm>

namespace plc::protocol {

bool Connection::receive(int milliseconds) {
    char bytes[65536];
    const std::optional<size_t> count = platform::readWithin(m_in, bytes, milliseconds);
    if (!count) return false;
    if (*count == 0) {
        m_isOpen = false;
        return false;
    }
    m_reader.feed({bytes, *count});
    while (auto message = m_reader.next()) m_waiting.push_back(std::move(*message));
    if (m_reader.isBroken()) m_isOpen = false;
    return true;
}

std::optional<Result<std::string>> Connection::next(std::optional<std::chrono::milliseconds> wait) {
    const auto end = std::chrono::steady_clock::now() + wait.value_or(std::chrono::milliseconds(0));
    while (m_waiting.empty() && m_isOpen) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (receive(wait ? static_cast<int>(std::max<int64_t>(left.count(), 0)) : -1)) continue;
        if (!wait || left.count() <= 0) break;
    }
    if (m_waiting.empty()) return std::nullopt;
    Result<std::string> message = std::move(m_waiting.front());
    m_waiting.pop_front();
    return message;
}

bool Connection::isWaiting(const std::function<bool(std::string_view)>& which) {
    while (m_isOpen && receive(0)) {
    }
    return std::any_of(m_waiting.begin(), m_waiting.end(),
                       [&](const Result<std::string>& each) { return each && which(*each); });
}

void Connection::send(std::string_view message) {
    if (!platform::writeAll(m_out, framed(m_framing, message))) m_isOpen = false; // nobody reads any more
}

} // namespace plc::protocol
