#include "tests/projects/devices/peers.h"

#include "projects/devices/configuration/device_check.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/inside/rerun.h"
#include "tests/support/patience.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace plc::testing {

namespace {

sockaddr_in localAddress(uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
}

int listenLocally(uint16_t port) {
    const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    const sockaddr_in address = localAddress(port);
    EXPECT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0) << port;
    EXPECT_EQ(::listen(listener, 128), 0);
    return listener;
}

uint16_t portOf(int socket) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
}

} // namespace

uint16_t freePort() {
    // Below the ports that the system hands out: no connection of another test can take it meanwhile.
    static uint32_t next = static_cast<uint32_t>(::getpid()) * 37;
    for (;;) {
        const auto port = static_cast<uint16_t>(12'000 + next++ % 18'000);
        const int tried = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        const sockaddr_in address = localAddress(port);
        const bool isFree = ::bind(tried, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
        ::close(tried);
        if (isFree) return port;
    }
}

driver::Built buildProgram(const std::string& text) {
    static const bool once = (jit::setRuntimeSymbols(controller::runtimeSymbols()), true);
    (void)once;
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    driver::Built built = driver::build(input);
    for (const auto& diagnostic : built.checked.analysis->diagnostics)
        if (!built.program) ADD_FAILURE() << diagnostic.message.english();
    return built;
}

std::vector<devices::Device> devicesOf(const std::string& json, const image::Layout& layout) {
    const devices::DeviceFile file = devices::DeviceFile::parse(json);
    for (const devices::Finding& finding : devices::checkDevices(file, &layout, {}))
        EXPECT_FALSE(finding.isError) << finding.english("devices.json");
    return file.devices();
}

// ---------------------------------------------------------------- Modbus

ModbusPeer::ModbusPeer(uint16_t port) : m_context(modbus_new_tcp("127.0.0.1", port)) {
    m_mapping = modbus_mapping_new(200, 200, 200, 200);
    modbus_set_response_timeout(m_context, 0, 1000);
    m_listener = listenLocally(port);
    m_thread = std::thread([this] { run(); });
}

ModbusPeer::~ModbusPeer() {
    m_isStopping = true;
    m_thread.join();
    ::close(m_listener);
    modbus_free(m_context);
    modbus_mapping_free(m_mapping);
}

void ModbusPeer::run() {
    std::vector<pollfd> polled{{m_listener, POLLIN, 0}};
    while (!m_isStopping) {
        (void)::poll(polled.data(), polled.size(), 20);
        for (size_t i = polled.size(); i-- > 1;) {
            if (polled[i].revents == 0 || serve(polled[i].fd)) continue;
            ::close(polled[i].fd);
            polled.erase(polled.begin() + static_cast<std::ptrdiff_t>(i));
        }
        if (polled[0].revents != 0) polled.push_back({::accept(m_listener, nullptr, nullptr), POLLIN, 0});
    }
    for (size_t i = 1; i < polled.size(); ++i) ::close(polled[i].fd);
}

bool ModbusPeer::serve(int socket) {
    modbus_set_socket(m_context, socket);
    uint8_t request[MODBUS_TCP_MAX_ADU_LENGTH];
    const int size = modbus_receive(m_context, request);
    if (size < 0) return false;
    if (size == 0) return true;
    const std::lock_guard lock(m_mutex);
    const int function = request[7], first = request[8] << 8 | request[9], count = request[10] << 8 | request[11];
    const bool isWrite = function == 5 || function == 6 || function >= 15;
    if (isWrite) ++m_writes;
    const int end = function == 5 || function == 6 ? first + 1 : first + count;
    if ((function == 3 || function == 6 || function == 16) && first < 160 && end > 150)
        return modbus_reply_exception(m_context, request, MODBUS_EXCEPTION_ILLEGAL_DATA_ADDRESS) > 0;
    return modbus_reply(m_context, request, size, m_mapping) > 0;
}

void ModbusPeer::setRegister(int address, uint16_t value) {
    const std::lock_guard lock(m_mutex);
    m_mapping->tab_registers[address] = value;
}
void ModbusPeer::setInputRegister(int address, uint16_t value) {
    const std::lock_guard lock(m_mutex);
    m_mapping->tab_input_registers[address] = value;
}
void ModbusPeer::setCoil(int address, bool value) {
    const std::lock_guard lock(m_mutex);
    m_mapping->tab_bits[address] = value ? 1 : 0;
}
void ModbusPeer::setDiscrete(int address, bool value) {
    const std::lock_guard lock(m_mutex);
    m_mapping->tab_input_bits[address] = value ? 1 : 0;
}
uint16_t ModbusPeer::registerAt(int address) const {
    const std::lock_guard lock(m_mutex);
    return m_mapping->tab_registers[address];
}
bool ModbusPeer::coilAt(int address) const {
    const std::lock_guard lock(m_mutex);
    return m_mapping->tab_bits[address] != 0;
}

// ---------------------------------------------------------------- a bad line

Proxy::Proxy(uint16_t target) : m_target(target), m_listener(listenLocally(0)) {
    m_port = portOf(m_listener);
    m_thread = std::thread([this] { run(); });
}

Proxy::~Proxy() {
    m_isStopping = true;
    m_thread.join();
    ::close(m_listener);
}

void Proxy::cut() {
    m_cuts = true;
    EXPECT_TRUE(eventually([&] { return !m_cuts; }));
}

bool Proxy::forward(int from, int to) {
    char bytes[4096];
    const ssize_t n = ::recv(from, bytes, sizeof bytes, 0);
    if (n <= 0) return false;
    if (m_swallows) return true;
    if (const int delay = m_delayMs)
        std::this_thread::sleep_for(std::chrono::milliseconds(delay)); // a duration: of a slow line
    return ::send(to, bytes, static_cast<size_t>(n), MSG_NOSIGNAL) == n;
}

void Proxy::run() {
    std::vector<Pair> pairs;
    const auto close = [](Pair& pair) {
        ::close(pair.client);
        ::close(pair.server);
        pair = {};
    };
    while (!m_isStopping) {
        std::vector<pollfd> polled{{m_listener, POLLIN, 0}};
        for (const Pair& pair : pairs) {
            polled.push_back({pair.client, POLLIN, 0});
            polled.push_back({pair.server, POLLIN, 0});
        }
        (void)::poll(polled.data(), polled.size(), 5);
        const bool isCut = m_cuts;
        for (size_t i = 0; i < pairs.size(); ++i) {
            Pair& pair = pairs[i];
            bool isGood = !isCut;
            if (isGood && polled[1 + 2 * i].revents) isGood = forward(pair.client, pair.server);
            if (isGood && polled[2 + 2 * i].revents) isGood = forward(pair.server, pair.client);
            if (!isGood) close(pair);
        }
        std::erase_if(pairs, [](const Pair& pair) { return pair.client < 0; });
        if (isCut) m_cuts = false;
        if (polled[0].revents == 0) continue;
        Pair pair{::accept(m_listener, nullptr, nullptr), ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
        const sockaddr_in address = localAddress(m_target);
        if (::connect(pair.server, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
            pairs.push_back(pair);
        else
            close(pair);
    }
    for (Pair& pair : pairs) close(pair);
}

// ---------------------------------------------------------------- a run

LiveRun::LiveRun(const std::string& program, const std::string& json) : built(buildProgram(program)) {
    engine = std::make_unique<devices::Engine>(devicesOf(json, built.program->layout));
    session = std::make_unique<session::Session>(built);
    engine->attach(session->controller());
    engine->connect();
    session->controller().start();
}

LiveRun::~LiveRun() {
    engine->disconnect();
    session.reset();
}

void LiveRun::scan() {
    std::this_thread::sleep_until(m_begin + session->controller().nextDue()); // a duration: the controller's interval
    (void)session->controller().scan();
}

bool LiveRun::scanUntil(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatience);
    while (std::chrono::steady_clock::now() < end) {
        scan();
        if (condition()) return true;
        if (session->controller().state() != controller::State::Running)
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // a duration: between two looks
    }
    return false;
}

std::string LiveRun::value(const std::string& path) const {
    const auto read = session->controller().read(path);
    return read ? types::toText(*built.program->layout.types, *read) : read.error().english();
}

size_t LiveRun::replaysExactly() const {
    inside::Rerunner rerunner(session->history());
    const history::Statistics all = session->history().statistics();
    for (history::Position at = all.first; at < all.end; ++at) {
        const Result<inside::Rerun> again = rerunner.run(at);
        EXPECT_TRUE(again) << again.error().english();
        EXPECT_TRUE(again->isExact()) << "scan " << at << ": " << again->differences.front().path;
        if (!again || !again->isExact()) return 0;
    }
    return all.end - all.first;
}

} // namespace plc::testing
