// TCP connections by number, without blocking, and short messages to a local service. Free functions; a socket is one
// thread's.
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace plc::platform {

struct Listener {
    int socket = -1;  // < 0: why not is in one of the others
    int code = 0;     // of errno
    std::string says; // what the search for the name says
};
/// At that address of this machine, for connections of others.
[[nodiscard]] Listener listenAt(const std::string& host, uint16_t port);
/// The next connection; < 0: nobody waits.
[[nodiscard]] int acceptFrom(int listener);

/// Whether somebody listens there: 0, or errno (ETIMEDOUT: nobody answered in that time).
[[nodiscard]] int reach(const std::string& host, uint16_t port, std::chrono::milliseconds timeout);

struct Awaited {
    int socket;
    bool isReady = false; // something arrived, or the connection ended
};
/// Until one of them is ready, at most that long.
void waitForAny(std::span<Awaited> sockets, std::chrono::milliseconds atMost);
/// How much arrived; none: nothing yet; 0: the connection is over.
[[nodiscard]] std::optional<size_t> receive(int socket, std::span<uint8_t> into);
void closeSocket(int socket);
/// What was sent and not confirmed for that long is lost with the connection.
void limitUnconfirmed(int socket, std::chrono::milliseconds time);

/// To the service that listens at that path ('@' in front: an abstract name); silent where there is none.
void sendLocally(const std::string& path, std::string_view text);

} // namespace plc::platform
