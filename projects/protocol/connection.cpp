#include "projects/protocol/connection.h"

#include <algorithm>
#include <cerrno>
#include <poll.h>
#include <unistd.h>

namespace plc::protocol {

bool Connection::receive(int milliseconds) {
    pollfd file{m_in, POLLIN, 0};
    if (::poll(&file, 1, milliseconds) <= 0) return false;
    char bytes[65536];
    const ssize_t count = ::read(m_in, bytes, sizeof bytes);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return false;
    if (count <= 0) {
        m_isOpen = false;
        return false;
    }
    m_reader.feed({bytes, static_cast<size_t>(count)});
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
    const std::string bytes = framed(m_framing, message);
    for (size_t done = 0; done < bytes.size();) {
        const ssize_t count = ::write(m_out, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            m_isOpen = false; // nobody reads any more
            return;
        }
        done += static_cast<size_t>(count);
    }
}

} // namespace plc::protocol
