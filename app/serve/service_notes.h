// Tells the service manager (systemd) that the controller is ready, is stopping, and is alive; silent where there is
// none. The main thread's.
#pragma once
#include <chrono>
#include <optional>
#include <string>

namespace plc::serve {

class ServiceNotes {
public:
    /// Reads NOTIFY_SOCKET and WATCHDOG_USEC.
    ServiceNotes();
    void ready(const std::string& status) const { send("READY=1\nSTATUS=" + status); }
    void stopping() const { send("STOPPING=1"); }
    void alive() const { send("WATCHDOG=1"); }
    /// How long it may be silent before it is restarted; none: nobody watches.
    [[nodiscard]] std::optional<std::chrono::microseconds> watchdog() const { return m_watchdog; }

private:
    void send(const std::string& text) const;
    std::string m_socket;
    std::optional<std::chrono::microseconds> m_watchdog;
};

} // namespace plc::serve
