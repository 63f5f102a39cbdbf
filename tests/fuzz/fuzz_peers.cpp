// What peers send over a network, byte for byte: frames to our Modbus server, MQTT payloads, requests to the door of a
// served controller, states and scans of a server that a studio is attached to, heads of HTTP requests and messages of
// browsers. The first byte says which (F to L in the
// order of kPeers); several messages are lines.
#include "app/serve/http.h"
#include "hmi/web/client_message.h"
#include "projects/devices/configuration/wire.h"
#include "projects/devices/modbus_requests.h"
#include "projects/remote/door.h"
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <iterator>
#include <string>
#include <sys/socket.h>

namespace {

using namespace plc;

const driver::Built& plant() {
    static const driver::Built built = [] {
        jit::setRuntimeSymbols(controller::runtimeSymbols());
        driver::BuildInput input;
        input.files.push_back({"main.st",
                               "PROGRAM Main\nVAR RETAIN n : DINT; END_VAR\n"
                               "VAR speed : REAL; lamp : BOOL; text : STRING(20); list : ARRAY[1..4] OF INT; END_VAR\n"
                               "n := n + 1;\nEND_PROGRAM\n"});
        return driver::build(input);
    }();
    return built;
}

template <class Visit> void forEachLine(std::string_view all, Visit visit) {
    for (size_t at = 0; at < all.size();) {
        const size_t end = std::min(all.find('\n', at), all.size());
        visit(all.substr(at, end - at));
        at = end + 1;
    }
}

void modbusServer(std::string_view bytes) {
    static const devices::Device device = [] {
        devices::Device all;
        all.protocol = devices::Protocol::ModbusServer;
        for (const auto table :
             {devices::Table::Coil, devices::Table::Discrete, devices::Table::Holding, devices::Table::Input}) {
            devices::Channel channel;
            channel.table = table;
            channel.address = 2;
            channel.type = devices::isBitTable(table) ? devices::WireType::Bool : devices::WireType::Lint;
            all.channels.push_back(channel);
        }
        return all;
    }();
    static int wires[2] = {-1, -1};
    static const bool connected = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, wires) == 0;
    if (!connected) return;
    devices::ServerRegisters registers(device);
    std::array<uint8_t, 4096> answer{};
    while (!bytes.empty()) {
        const std::span<const uint8_t> rest(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
        const devices::FrameSize size = devices::requestSize(rest);
        if (size.isBad || size.bytes == 0 || size.bytes > rest.size()) return;
        (void)registers.answer(wires[0], rest.first(size.bytes));
        while (::recv(wires[1], answer.data(), answer.size(), MSG_DONTWAIT) > 0) {
        }
        bytes.remove_prefix(size.bytes);
    }
}

void payload(std::string_view bytes) {
    devices::Channel channel;
    for (const auto type :
         {devices::WireType::Lreal, devices::WireType::Text, devices::WireType::Bool, devices::WireType::Lint})
        for (const char* path : {"", "/a/b/0"}) {
            channel.type = type;
            channel.jsonPath = path;
            (void)devices::fromMessage(channel, bytes);
        }
}

void doorRequests(std::string_view bytes) {
    static session::Session session(plant());
    remote::Door door(session, "peer", {.mayHalt = true});
    forEachLine(bytes, [&](std::string_view line) {
        const remote::Json request = remote::Json::parse(line, nullptr, false);
        if (request.is_discarded()) return;
        (void)door.answer(request);
        (void)door.due();
        (void)door.bytes(1 << 16);
    });
}

void serverStates(std::string_view bytes) {
    forEachLine(bytes, [](std::string_view line) {
        const remote::Json json = remote::Json::parse(line, nullptr, false);
        if (json.is_discarded()) return;
        (void)remote::readState(json, plant());
        (void)remote::readEvent(json);
        (void)remote::readSources(json);
    });
}

void scanStream(std::string_view bytes) {
    remote::ScanReader reader(plant().program);
    (void)reader.read(bytes, [](const remote::StreamedScan& scan) {
        if (scan.image.size() > plant().program->layout.imageSize) std::abort();
    });
}

void httpHead(std::string_view bytes) {
    const auto head = serve::parseHead(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
    if (head.state != serve::HeadState::Complete) return;
    (void)head.request.isWebSocket();
    (void)head.request.isSameOrigin();
}

void browserMessages(std::string_view bytes) {
    forEachLine(bytes, [](std::string_view line) {
        (void)hmi::web::parseClientMessage(QByteArrayView(line.data(), static_cast<qsizetype>(line.size())));
    });
}

constexpr void (*kPeers[])(std::string_view) = {modbusServer, payload,  doorRequests,   serverStates,
                                                scanStream,   httpHead, browserMessages};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    if (size > 0) kPeers[data[0] % std::size(kPeers)]({reinterpret_cast<const char*>(data) + 1, size - 1});
    return 0;
}
