#include "app/serve/service_notes.h"

#include "runtime/platform/sockets.h"

#include <cstdlib>

namespace plc::serve {

ServiceNotes::ServiceNotes() {
    if (const char* path = std::getenv("NOTIFY_SOCKET")) m_socket = path;
    if (const char* text = std::getenv("WATCHDOG_USEC"))
        if (const long long limit = std::atoll(text); limit > 0) m_watchdog = std::chrono::microseconds(limit);
}

void ServiceNotes::send(const std::string& text) const { platform::sendLocally(m_socket, text); }

} // namespace plc::serve
