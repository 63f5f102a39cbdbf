// The two pipes to a client: messages in, messages out. It has no thread: bytes are read when somebody asks for a
// message, and a message that could not be framed is reported in its place. One thread.
#pragma once
#include "projects/protocol/framing.h"

#include <chrono>
#include <deque>
#include <functional>

namespace plc::protocol {

class Connection {
public:
    Connection(Framing framing, int in, int out) : m_framing(framing), m_reader(framing), m_in(in), m_out(out) {}
    /// The next message or why it was left out; nothing: the time is over, the client is gone, or somebody interrupted.
    [[nodiscard]] std::optional<Result<std::string>> next(std::optional<std::chrono::milliseconds> wait);
    /// Whether one of the messages that wait is such a one; reads what has arrived, without waiting.
    [[nodiscard]] bool isWaiting(const std::function<bool(std::string_view message)>& which);
    [[nodiscard]] bool isOpen() const { return m_isOpen; }
    void send(std::string_view message);

private:
    /// False: nothing arrived in that time.
    bool receive(int milliseconds);

    Framing m_framing;
    MessageReader m_reader;
    int m_in, m_out;
    bool m_isOpen = true;
    std::deque<Result<std::string>> m_waiting;
};

} // namespace plc::protocol
