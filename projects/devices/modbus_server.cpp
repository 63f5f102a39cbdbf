// A Modbus TCP server: others read what the program sets and write what it gets. Bytes of each client are gathered
// until a request is whole, so that a slow or silent one holds nobody up; what is not a sound request never reaches
// libmodbus.
#include "projects/devices/configuration/errors.h"
#include "projects/devices/configuration/wire.h"
#include "projects/devices/link.h"
#include "projects/devices/modbus_requests.h"
#include "runtime/platform/sockets.h"

namespace plc::devices {

namespace {

constexpr size_t kMostClients = 32;
constexpr std::chrono::milliseconds kRound{50};

struct Client {
    int socket = -1;
    std::array<uint8_t, kLargestRequest> bytes{};
    size_t used = 0;
    SteadyClock::time_point last{};
};

/// A socket that listens, or an error.
Result<int> listenAt(const std::string& host, uint16_t port) {
    const platform::Listener listener = platform::listenAt(host, port);
    if (listener.socket >= 0) return listener.socket;
    return Error{errors::CannotListen(host + ":" + std::to_string(port), listener.says.empty()
                                                                             ? errors::ofSystem(listener.code)
                                                                             : errors::SystemSays(listener.says)),
                 {}};
}

class ModbusServer final : public Link {
public:
    explicit ModbusServer(Port& port) : m_port(port), m_backOff(port.device.retry), m_registers(port.device) {}
    ~ModbusServer() override { closeAll(); }

protected:
    void run() override;

private:
    void listenAgain();
    void round();
    void accept();
    void read(Client& client);
    [[nodiscard]] bool answer(Client& client);
    void drop(Client& client);
    void closeAll();
    void takeOutputs(bool isLeaving);
    void takeWritten(const WrittenRange& range);
    void watchSilence();

    Port& m_port;
    BackOff m_backOff;
    ServerRegisters m_registers;
    int m_listener = -1;
    std::vector<Client> m_clients;
    std::vector<Sample> m_outputs;
    uint64_t m_seenOutputs = 0;
    std::optional<SteadyClock::time_point> m_lastWrite;
};

void ModbusServer::run() {
    m_port.setState(LinkState::Connecting);
    while (!isStopping()) {
        if (m_listener < 0) listenAgain();
        if (m_listener >= 0) round();
    }
    takeOutputs(true); // for who still reads
    closeAll();
    m_port.setAll(Quality::Waiting);
    m_port.setState(LinkState::Off);
    m_port.publish();
}

void ModbusServer::listenAgain() {
    const Result<int> listener = listenAt(m_port.device.host, m_port.device.port);
    if (!listener) {
        m_port.countError();
        m_port.setAll(Quality::Lost);
        m_port.setState(LinkState::Lost, listener.error().message);
        m_port.publish();
        waitUntil(m_backOff.failed());
        return;
    }
    m_listener = *listener;
    m_backOff.succeeded();
    for (size_t c = 0; c < m_port.device.channels.size(); ++c)
        m_port.setQuality(c, m_port.device.channels[c].direction == Direction::Out ? Quality::Good : Quality::Waiting);
    m_port.setState(LinkState::Online);
    m_port.publish();
}

void ModbusServer::round() {
    std::vector<platform::Awaited> awaited{{m_listener}};
    for (const Client& client : m_clients) awaited.push_back({client.socket});
    platform::waitForAny(awaited, kRound);
    takeOutputs(false);
    for (size_t i = 1; i < awaited.size(); ++i)
        if (awaited[i].isReady) read(m_clients[i - 1]);
    std::erase_if(m_clients, [](const Client& client) { return client.socket < 0; });
    if (awaited[0].isReady) accept();
    m_port.setClients(m_clients.size());
    watchSilence();
}

void ModbusServer::accept() {
    const int socket = platform::acceptFrom(m_listener);
    if (socket < 0) return;
    if (m_clients.size() >= kMostClients) { // who was silent longest makes room
        const auto oldest = std::min_element(m_clients.begin(), m_clients.end(),
                                             [](const Client& a, const Client& b) { return a.last < b.last; });
        drop(*oldest);
        m_clients.erase(oldest);
    }
    m_port.countConnect();
    m_clients.push_back({socket, {}, 0, SteadyClock::now()});
}

void ModbusServer::drop(Client& client) {
    if (client.socket >= 0) platform::closeSocket(client.socket);
    client.socket = -1;
}

void ModbusServer::closeAll() {
    for (Client& client : m_clients) drop(client);
    m_clients.clear();
    if (m_listener >= 0) platform::closeSocket(m_listener);
    m_listener = -1;
}

void ModbusServer::read(Client& client) {
    const auto n = platform::receive(client.socket, std::span(client.bytes).subspan(client.used));
    if (!n) return;
    if (*n == 0) return drop(client);
    client.used += *n;
    client.last = SteadyClock::now();
    while (client.socket >= 0) {
        const FrameSize size = requestSize({client.bytes.data(), client.used});
        if (size.isBad) {
            m_port.countError();
            return drop(client);
        }
        if (size.bytes == 0 || size.bytes > client.used) return; // more to come
        if (!answer(client)) return drop(client);
        std::copy(client.bytes.begin() + static_cast<std::ptrdiff_t>(size.bytes),
                  client.bytes.begin() + static_cast<std::ptrdiff_t>(client.used), client.bytes.begin());
        client.used -= size.bytes;
    }
}

bool ModbusServer::answer(Client& client) {
    const auto begin = SteadyClock::now();
    const FrameSize size = requestSize({client.bytes.data(), client.used});
    const ServerAnswer answer = m_registers.answer(client.socket, {client.bytes.data(), size.bytes});
    if (answer.bytes < 0) return false; // it does not take its answers
    m_port.countRequest(static_cast<size_t>(answer.bytes), size.bytes, SteadyClock::now() - begin);
    if (answer.isException) m_port.countError();
    if (answer.written.count > 0) takeWritten(answer.written);
    return true;
}

// ---------------------------------------------------------------- registers and channels

void ModbusServer::takeOutputs(bool isLeaving) {
    const bool isNew = isLeaving ? m_port.safeOutputs(m_outputs) : m_port.outputs(m_outputs, m_seenOutputs);
    if (!isNew) return;
    for (size_t c = 0; c < m_port.device.channels.size() && c < m_outputs.size(); ++c) {
        const Channel& channel = m_port.device.channels[c];
        if (channel.direction != Direction::Out || m_outputs[c].kind == Sample::Kind::None) continue;
        const bool fits = m_registers.put(channel, m_outputs[c]);
        if (!fits) m_port.note(errors::DoesNotFit(channel.name));
        const Quality quality = fits ? Quality::Good : Quality::Unfit;
        if (m_port.now(c).quality == quality) continue;
        m_port.setQuality(c, quality);
        m_port.publish();
    }
}

void ModbusServer::takeWritten(const WrittenRange& range) {
    bool isInput = false;
    for (size_t c = 0; c < m_port.device.channels.size(); ++c) {
        const Channel& channel = m_port.device.channels[c];
        if (channel.table != range.table || channel.address >= range.first + range.count ||
            channel.address + channel.registers() <= range.first)
            continue;
        if (channel.direction == Direction::Out) {
            m_seenOutputs = 0; // the program's, not the client's: put back
            continue;
        }
        m_port.set(c, Quality::Good, m_registers.get(channel));
        isInput = true;
    }
    if (!isInput) return;
    m_lastWrite = SteadyClock::now();
    if (m_port.state() != LinkState::Online) m_port.setState(LinkState::Online);
    m_port.publish();
}

/// With a timeout, the inputs are lost when no client writes any more.
void ModbusServer::watchSilence() {
    const Milliseconds timeout = m_port.device.timeout;
    if (timeout.count() == 0 || !m_lastWrite || SteadyClock::now() - *m_lastWrite < timeout) return;
    m_lastWrite.reset();
    for (size_t c = 0; c < m_port.device.channels.size(); ++c)
        if (m_port.device.channels[c].direction == Direction::In) m_port.setQuality(c, Quality::Lost);
    m_port.setState(LinkState::Lost, errors::NoRequests(timeout.count()));
    m_port.publish();
}

} // namespace

std::unique_ptr<Link> makeModbusServer(Port& port) { return std::make_unique<ModbusServer>(port); }

} // namespace plc::devices
