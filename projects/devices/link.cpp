#include "projects/devices/link.h"

#include "runtime/platform/scheduling.h"

namespace plc::devices {

void Link::start() {
    m_thread = std::thread([this] {
        platform::nameThread("device");
        run();
    });
}

void Link::askToStop() {
    {
        const std::lock_guard lock(m_mutex);
        m_isStopping.store(true, std::memory_order_release);
    }
    m_wake.notify_all();
}

void Link::join() {
    if (m_thread.joinable()) m_thread.join();
}

void Link::waitUntil(SteadyClock::time_point when) {
    std::unique_lock lock(m_mutex);
    m_wake.wait_until(lock, when, [this] { return isStopping(); });
}

std::vector<std::unique_ptr<Link>> makeLinks(std::span<const std::unique_ptr<Port>> ports,
                                             const std::string& projectFolder) {
    std::vector<std::unique_ptr<Link>> links;
    std::map<std::string, std::vector<Port*>> lines; // serial: one talks at a time
    for (const std::unique_ptr<Port>& port : ports) {
        switch (port->device.protocol) {
        case Protocol::ModbusTcp:
            links.push_back(makeModbusClient({port.get()}));
            break;
        case Protocol::ModbusRtu:
            lines[port->device.serial].push_back(port.get());
            break;
        case Protocol::ModbusServer:
            links.push_back(makeModbusServer(*port));
            break;
        case Protocol::Mqtt:
            links.push_back(makeMqttClient(*port, projectFolder));
            break;
        }
    }
    for (auto& [serial, units] : lines) links.push_back(makeModbusClient(std::move(units)));
    return links;
}

} // namespace plc::devices
