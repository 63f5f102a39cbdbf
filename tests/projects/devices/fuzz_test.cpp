// Frames from a broken or hostile peer: random and nearly right requests to our server, answers to our client,
// messages, and devices.json cut and changed at random. Nothing may crash, hang or write outside. STEPWISE_LONG makes
// ten million frames; STEPWISE_SEED repeats a run.
#include "projects/devices/configuration/device_check.h"
#include "projects/devices/configuration/wire.h"
#include "projects/devices/modbus_requests.h"
#include "tests/projects/devices/peers.h"

#include <cstdlib>
#include <random>
#include <sys/socket.h>
#include <unistd.h>

using namespace plc::devices;

namespace {

size_t rounds(size_t usual, size_t atLength) { return std::getenv("STEPWISE_LONG") ? atLength : usual; }

std::mt19937_64 dice() {
    const char* const text = std::getenv("STEPWISE_SEED");
    const uint64_t seed = text ? std::strtoull(text, nullptr, 10) : std::random_device()();
    ::testing::Test::RecordProperty("seed", std::to_string(seed));
    std::cout << "seed " << seed << "\n";
    return std::mt19937_64(seed);
}

struct Wires {
    Wires() { EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends), 0); }
    ~Wires() {
        ::close(ends[0]);
        ::close(ends[1]);
    }
    int ends[2] = {};
};

Device serverDevice() {
    Device device;
    device.protocol = Protocol::ModbusServer;
    for (const Table table : {Table::Coil, Table::Discrete, Table::Holding, Table::Input})
        for (uint32_t i = 0; i < 8; ++i) {
            Channel channel;
            channel.table = table;
            channel.address = 1000 + i;
            channel.type = isBitTable(table) ? WireType::Bool : WireType::Int;
            device.channels.push_back(channel);
        }
    return device;
}

/// A request that is nearly right: sound, or with some bytes changed, or of any bytes.
std::vector<uint8_t> requestOf(std::mt19937_64& roll) {
    const size_t kind = roll() % 4;
    std::vector<uint8_t> frame(6 + 2 + roll() % (kind == 3 ? 252 : 24));
    for (uint8_t& byte : frame) byte = static_cast<uint8_t>(roll());
    frame[2] = frame[3] = 0;
    frame[4] = static_cast<uint8_t>((frame.size() - 6) >> 8);
    frame[5] = static_cast<uint8_t>(frame.size() - 6);
    if (kind == 0) return frame;
    constexpr uint8_t kFunctions[] = {1, 2, 3, 4, 5, 6, 15, 16, 22, 23};
    frame[6] = 1;
    frame[7] = kFunctions[roll() % 10];
    if (kind == 1 || frame.size() < 12) return frame;
    const auto address = static_cast<uint16_t>(995 + roll() % 20);
    const auto count = static_cast<uint16_t>(1 + roll() % 8);
    frame[8] = static_cast<uint8_t>(address >> 8);
    frame[9] = static_cast<uint8_t>(address);
    frame[10] = 0;
    frame[11] = static_cast<uint8_t>(count);
    if (frame[7] < 15) frame.resize(12);
    if (frame[7] == 15 || frame[7] == 16) {
        frame.resize(13u + (frame[7] == 15 ? 1u : count * 2u));
        frame[12] = static_cast<uint8_t>(frame.size() - 13);
    }
    frame[5] = static_cast<uint8_t>(frame.size() - 6);
    if (roll() % 3 == 0) frame[8 + roll() % (frame.size() - 8)] ^= static_cast<uint8_t>(1 << roll() % 8);
    return frame;
}

} // namespace

TEST(DeviceFuzz, TheServerTakesAnyFrame) {
    std::mt19937_64 roll = dice();
    ServerRegisters registers(serverDevice());
    Wires wires;
    size_t answered = 0, written = 0;
    const size_t count = rounds(200'000, 5'000'000);
    std::array<uint8_t, 4096> answer{};
    for (size_t i = 0; i < count; ++i) {
        const std::vector<uint8_t> frame = requestOf(roll);
        const FrameSize size = requestSize(frame);
        ASSERT_FALSE(size.isBad);
        ASSERT_EQ(size.bytes, frame.size());
        const ServerAnswer done = registers.answer(wires.ends[0], frame);
        answered += done.bytes > 0 && !done.isException;
        written += done.written.count > 0;
        const ssize_t n = ::recv(wires.ends[1], answer.data(), answer.size(), 0);
        ASSERT_EQ(n, done.bytes) << "an answer to each, and only one";
        ASSERT_EQ(answer[0], frame[0]);
        ASSERT_EQ(static_cast<size_t>(answer[4] << 8 | answer[5]) + 6, static_cast<size_t>(n));
    }
    EXPECT_GT(answered, count / 20);
    EXPECT_GT(written, count / 50);
}

TEST(DeviceFuzz, TheServerFindsTheFramesInAnyBytes) {
    std::mt19937_64 roll = dice();
    for (size_t i = 0; i < rounds(200'000, 1'000'000); ++i) {
        std::array<uint8_t, kLargestRequest> bytes{};
        const size_t count = roll() % (bytes.size() + 1);
        for (size_t b = 0; b < std::min<size_t>(count, 8); ++b)
            bytes[b] = static_cast<uint8_t>(roll() % 4 ? 0 : roll());
        const FrameSize size = requestSize({bytes.data(), count});
        ASSERT_LE(size.bytes, kLargestRequest) << "what can never become whole is not waited for";
    }
}

TEST(DeviceFuzz, TheClientTakesAnyAnswer) {
    std::mt19937_64 roll = dice();
    Wires wires;
    Device device;
    device.host = "127.0.0.1";
    const Modbus context = makeContext(device);
    ASSERT_TRUE(context);
    modbus_set_response_timeout(context.get(), 0, 1);
    modbus_set_byte_timeout(context.get(), 0, 1);
    modbus_set_socket(context.get(), wires.ends[0]);
    std::array<uint16_t, kMostRegistersRead> words{};
    std::array<uint8_t, 4096> request{};
    Channel channel;
    size_t good = 0;
    const size_t count = rounds(50'000, 4'000'000);
    for (size_t i = 0; i < count; ++i) {
        const auto wanted = static_cast<uint32_t>(1 + roll() % 8);
        std::vector<uint8_t> answer(9 + wanted * 2);
        for (uint8_t& byte : answer) byte = static_cast<uint8_t>(roll());
        // The number of the request, which counts up with each.
        answer[0] = static_cast<uint8_t>((i + 1) >> 8);
        answer[1] = static_cast<uint8_t>(i + 1);
        answer[2] = answer[3] = answer[4] = 0;
        answer[5] = static_cast<uint8_t>(answer.size() - 6);
        answer[6] = 255;
        answer[7] = 3;
        answer[8] = static_cast<uint8_t>(wanted * 2);
        for (size_t change = roll() % 3; change > 0; --change)
            answer[roll() % answer.size()] ^= static_cast<uint8_t>(1 << roll() % 8);
        if (roll() % 8 == 0) answer.resize(roll() % (answer.size() + 1));
        const auto size = static_cast<ssize_t>(answer.size());
        ASSERT_EQ(::send(wires.ends[1], answer.data(), answer.size(), 0), size);
        const int done = modbus_read_registers(context.get(), 0, static_cast<int>(wanted), words.data());
        ASSERT_LE(done, static_cast<int>(wanted));
        good += done > 0;
        EXPECT_NE(fromRegisters(channel, words).kind, Sample::Kind::None);
        while (::recv(wires.ends[0], request.data(), request.size(), MSG_DONTWAIT) > 0) {
        } // what was left over
        while (::recv(wires.ends[1], request.data(), request.size(), MSG_DONTWAIT) > 0) {
        }
    }
    EXPECT_GT(good, count / 10);
    modbus_set_socket(context.get(), -1);
}

TEST(DeviceFuzz, AnyMessageIsReadOrRefused) {
    std::mt19937_64 roll = dice();
    const std::string seeds[] = {R"({"a": {"b": [1, 2.5, true, "7"]}})", "21.5", "true", "", R"({"a":)"};
    Channel channel;
    channel.type = WireType::Lreal;
    for (size_t i = 0; i < rounds(100'000, 1'000'000); ++i) {
        std::string text = seeds[roll() % 5];
        for (size_t change = roll() % 6; change > 0 && !text.empty(); --change)
            text[roll() % text.size()] = static_cast<char>(roll());
        channel.jsonPath = roll() % 2 ? "/a/b/" + std::to_string(roll() % 5) : "";
        channel.type = roll() % 4 ? WireType::Lreal : WireType::Text;
        const Sample sample = fromMessage(channel, text);
        EXPECT_FALSE(sample.isNumber() && channel.type == WireType::Text);
    }
}

TEST(DeviceFuzz, AnyDevicesFileIsReadAndChecked) {
    std::mt19937_64 roll = dice();
    const std::string good =
        R"({"devices": [{"name": "Pump", "protocol": "modbus-tcp", "host": "h", "unit": 1, "poll": "5ms", "channels": [
        {"name": "a", "variable": "%IW0", "table": "holding", "address": 4, "type": "INT", "order": "CDAB", "scale": 0.5, "onLoss": "safe", "safe": 0},
        {"name": "b", "variable": "%QX0.0", "table": "coil", "address": 4, "quality": "Main.n"}]}]})";
    const plc::driver::Built built = plc::testing::buildProgram(
        "PROGRAM Main VAR a AT %IW0 : INT; b AT %QX0.0 : BOOL; n : BOOL; END_VAR END_PROGRAM");
    for (size_t i = 0; i < rounds(3'000, 50'000); ++i) {
        std::string text = good;
        if (roll() % 4 == 0) text.resize(roll() % text.size());
        for (size_t change = roll() % 8; change > 0 && !text.empty(); --change) {
            const size_t at = roll() % text.size();
            if (roll() % 2)
                text[at] = "{}[],:\"0123456789.-nulltrue%"[roll() % 28];
            else
                text.erase(at, 1 + roll() % 5);
        }
        DeviceFile file = DeviceFile::parse(text);
        (void)checkDevices(file, &built.program->layout, {});
        file.setField(0, 0, "address", "5");
        file.addChannel(0, "c");
        EXPECT_EQ(DeviceFile::parse(file.text()).devices(), file.devices());
    }
}
