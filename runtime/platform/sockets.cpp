#include "runtime/platform/sockets.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <vector>

namespace plc::platform {

namespace {

int openStream(const addrinfo& address) {
    return ::socket(address.ai_family, address.ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, address.ai_protocol);
}

} // namespace

Listener listenAt(const std::string& host, uint16_t port) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (const int problem = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); problem != 0)
        return {-1, 0, ::gai_strerror(problem)};
    Listener out{-1, EADDRNOTAVAIL, {}};
    for (const addrinfo* each = found; each && out.socket < 0; each = each->ai_next) {
        const int listener = openStream(*each);
        const int on = 1;
        if (listener >= 0) ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        if (listener >= 0 && ::bind(listener, each->ai_addr, each->ai_addrlen) == 0 && ::listen(listener, 16) == 0) {
            out = {listener, 0, {}};
            break;
        }
        out.code = errno;
        if (listener >= 0) ::close(listener);
    }
    ::freeaddrinfo(found);
    return out;
}

int acceptFrom(int listener) {
    const int socket = ::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    const int on = 1;
    if (socket >= 0) ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return socket;
}

int reach(const std::string& host, uint16_t port, std::chrono::milliseconds timeout) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) return EHOSTUNREACH;
    int code = EHOSTUNREACH;
    for (const addrinfo* each = found; each && code != 0; each = each->ai_next) {
        const int probe = openStream(*each);
        if (probe < 0) continue;
        code = ::connect(probe, each->ai_addr, each->ai_addrlen) == 0 ? 0 : errno;
        pollfd waits{probe, POLLOUT, 0};
        if (code == EINPROGRESS) code = ::poll(&waits, 1, static_cast<int>(timeout.count())) > 0 ? 0 : ETIMEDOUT;
        socklen_t size = sizeof code;
        if (code == 0) ::getsockopt(probe, SOL_SOCKET, SO_ERROR, &code, &size);
        ::close(probe);
    }
    ::freeaddrinfo(found);
    return code;
}

void waitForAny(std::span<Awaited> sockets, std::chrono::milliseconds atMost) {
    std::vector<pollfd> polled;
    for (const Awaited& each : sockets) polled.push_back({each.socket, POLLIN, 0});
    const int ready = ::poll(polled.data(), polled.size(), static_cast<int>(atMost.count()));
    for (size_t i = 0; i < sockets.size(); ++i) sockets[i].isReady = ready > 0 && polled[i].revents != 0;
}

std::optional<size_t> receive(int socket, std::span<uint8_t> into) {
    const ssize_t n = ::recv(socket, into.data(), into.size(), 0);
    if (n < 0 && (errno == EAGAIN || errno == EINTR)) return {};
    return n > 0 ? static_cast<size_t>(n) : 0;
}

void closeSocket(int socket) { ::close(socket); }

void limitUnconfirmed(int socket, std::chrono::milliseconds time) {
    const int patience = static_cast<int>(time.count());
    ::setsockopt(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, &patience, sizeof patience);
}

void sendLocally(const std::string& path, std::string_view text) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.empty() || path.size() >= sizeof address.sun_path) return;
    std::memcpy(address.sun_path, path.data(), path.size());
    if (address.sun_path[0] == '@') address.sun_path[0] = '\0';
    const int handle = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (handle < 0) return;
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
    [[maybe_unused]] const ssize_t sent =
        ::sendto(handle, text.data(), text.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&address), size);
    ::close(handle);
}

} // namespace plc::platform
