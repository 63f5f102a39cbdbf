// A thread that talks to devices over one connection: a TCP device, all units of a serial line, a server, a broker. The
// scan never waits for it. Owned by the Engine; a new protocol (OPC UA) is one more class and one more row of
// makeLinks.
#pragma once
#include "projects/devices/port.h"

#include <condition_variable>
#include <thread>

namespace plc::devices {

using SteadyClock = std::chrono::steady_clock;

class Link {
public:
    Link() = default;
    virtual ~Link() = default;
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;
    void start();
    void askToStop(); // it gives the outputs their safe values, closes and ends
    void join();

protected:
    virtual void run() = 0; // on the link's thread, until isStopping()
    [[nodiscard]] bool isStopping() const { return m_isStopping.load(std::memory_order_acquire); }
    void waitUntil(SteadyClock::time_point when);

private:
    std::atomic<bool> m_isStopping{false};
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::thread m_thread;
};

/// Pauses between attempts: short at first, then twice as long each time.
class BackOff {
public:
    explicit BackOff(Milliseconds longest) : m_longest(longest) {}
    void succeeded() { m_pause = kFirst; }
    [[nodiscard]] SteadyClock::time_point failed() {
        const Milliseconds pause = std::min(m_pause, m_longest);
        m_pause = std::min(m_pause * 2, m_longest);
        return SteadyClock::now() + pause;
    }

private:
    static constexpr Milliseconds kFirst{100};
    Milliseconds m_pause = kFirst, m_longest;
};

/// A link for each connection of the devices.
[[nodiscard]] std::vector<std::unique_ptr<Link>> makeLinks(std::span<const std::unique_ptr<Port>> ports,
                                                           const std::string& projectFolder);
// One file each.
[[nodiscard]] std::unique_ptr<Link> makeModbusClient(std::vector<Port*> units); // several: of one serial line
[[nodiscard]] std::unique_ptr<Link> makeModbusServer(Port& port);
[[nodiscard]] std::unique_ptr<Link> makeMqttClient(Port& port, const std::string& projectFolder);

} // namespace plc::devices
