#include "app/serve/service_notes.h"

#include <cstdlib>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace plc::serve {

ServiceNotes::ServiceNotes() {
    if (const char* path = std::getenv("NOTIFY_SOCKET")) m_socket = path;
    if (const char* text = std::getenv("WATCHDOG_USEC"))
        if (const long long limit = std::atoll(text); limit > 0) m_watchdog = std::chrono::microseconds(limit);
}

void ServiceNotes::send(const std::string& text) const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (m_socket.empty() || m_socket.size() >= sizeof address.sun_path) return;
    std::memcpy(address.sun_path, m_socket.data(), m_socket.size());
    if (address.sun_path[0] == '@') address.sun_path[0] = '\0'; // an abstract name
    const int handle = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (handle < 0) return;
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + m_socket.size());
    [[maybe_unused]] const ssize_t sent =
        ::sendto(handle, text.data(), text.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&address), size);
    ::close(handle);
}

} // namespace plc::serve
