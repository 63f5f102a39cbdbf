// What device tests talk to: a Modbus device on libmodbus, a proxy that loses, delays and cuts, programs to run, and a
// free port. Each has a thread of its own, ended by its destructor.
#pragma once
#include "projects/devices/engine.h"
#include "projects/session/session.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>

#include <atomic>
#include <modbus/modbus.h>
#include <mutex>
#include <thread>

namespace plc::testing {

[[nodiscard]] uint16_t freePort();
[[nodiscard]] driver::Built buildProgram(const std::string& text);
/// devices.json → devices; a finding that is an error fails the test.
[[nodiscard]] std::vector<devices::Device> devicesOf(const std::string& json, const image::Layout& layout);

/// A Modbus TCP device with 200 of everything from address 0; registers 150 to 159 are refused.
class ModbusPeer {
public:
    explicit ModbusPeer(uint16_t port);
    ~ModbusPeer();
    void setRegister(int address, uint16_t value);
    void setInputRegister(int address, uint16_t value);
    void setCoil(int address, bool value);
    void setDiscrete(int address, bool value);
    [[nodiscard]] uint16_t registerAt(int address) const;
    [[nodiscard]] bool coilAt(int address) const;
    [[nodiscard]] int writes() const { return m_writes.load(); }

private:
    void run();
    bool serve(int socket);
    mutable std::mutex m_mutex;
    modbus_t* m_context = nullptr;
    modbus_mapping_t* m_mapping = nullptr;
    int m_listener = -1;
    std::atomic<bool> m_isStopping{false};
    std::atomic<int> m_writes{0};
    std::thread m_thread;
};

/// Forwards connections to a port of this computer, as badly as asked.
class Proxy {
public:
    explicit Proxy(uint16_t target);
    ~Proxy();
    [[nodiscard]] uint16_t port() const { return m_port; }
    /// Nothing passes, and nobody is told: a pulled cable.
    void setSwallows(bool swallows) { m_swallows.store(swallows); }
    void setDelay(std::chrono::milliseconds delay) { m_delayMs.store(static_cast<int>(delay.count())); }
    void cut(); // ends every connection; new ones are taken

private:
    struct Pair {
        int client = -1, server = -1;
    };
    void run();
    [[nodiscard]] bool forward(int from, int to);
    uint16_t m_target, m_port = 0;
    int m_listener = -1;
    std::atomic<bool> m_isStopping{false}, m_swallows{false}, m_cuts{false};
    std::atomic<int> m_delayMs{0};
    std::thread m_thread;
};

/// A program in a session with its devices, scanned by the caller in real time.
class LiveRun {
public:
    LiveRun(const std::string& program, const std::string& json);
    ~LiveRun();
    /// Scans until it is true; false after half a minute.
    [[nodiscard]] bool scanUntil(const std::function<bool()>& condition);
    void scan();
    [[nodiscard]] std::string value(const std::string& path) const;
    [[nodiscard]] devices::DeviceStatus status(size_t device = 0) const { return engine->status().at(device); }
    /// Every recorded scan made again without devices comes out as recorded; how many there were.
    [[nodiscard]] size_t replaysExactly() const;

    driver::Built built;
    std::unique_ptr<devices::Engine> engine;
    std::unique_ptr<session::Session> session;

private:
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

} // namespace plc::testing
