// Against other people's implementations: pymodbus as the device and as the client of our server, mosquitto as the
// broker, and a serial line made of two pseudo terminals.
#include "tests/projects/devices/peers.h"
#include "tests/support/paths.h"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

extern char** environ;

using namespace plc;
using namespace plc::devices;
using namespace std::chrono_literals;
using plc::testing::freePort;
using plc::testing::LiveRun;

namespace {

/// Another program, ended with this.
class Process {
public:
    explicit Process(std::vector<std::string> words) {
        std::vector<char*> pointers;
        for (std::string& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        EXPECT_EQ(::posix_spawnp(&m_id, pointers[0], nullptr, nullptr, pointers.data(), environ), 0) << words[0];
    }
    ~Process() {
        if (m_id <= 0) return;
        ::kill(m_id, SIGTERM);
        ::waitpid(m_id, nullptr, 0);
    }
    /// Its exit code, once it has ended.
    int wait() {
        int status = -1;
        ::waitpid(m_id, &status, 0);
        m_id = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    void stop() { ::kill(m_id, SIGSTOP); }
    void goOn() { ::kill(m_id, SIGCONT); }

private:
    pid_t m_id = -1;
};

/// The far end of a serial line: bytes between two pseudo terminals, as a null modem.
class NullModem {
public:
    NullModem() : m_near(::posix_openpt(O_RDWR | O_NOCTTY)), m_far(::posix_openpt(O_RDWR | O_NOCTTY)) {
        for (const int each : {m_near, m_far}) {
            EXPECT_EQ(::grantpt(each), 0);
            EXPECT_EQ(::unlockpt(each), 0);
        }
        near = ::ptsname(m_near);
        far = ::ptsname(m_far);
        m_thread = std::thread([this] { run(); });
    }
    ~NullModem() {
        m_isStopping = true;
        m_thread.join();
        ::close(m_near);
        ::close(m_far);
    }
    std::string near, far;
    std::atomic<bool> isCut{false}, isNoisy{false};

private:
    void run() {
        while (!m_isStopping) {
            pollfd polled[] = {{m_near, POLLIN, 0}, {m_far, POLLIN, 0}};
            (void)::poll(polled, 2, 10);
            for (int i = 0; i < 2; ++i) {
                if ((polled[i].revents & POLLIN) == 0) {
                    if (polled[i].revents != 0) std::this_thread::sleep_for(1ms); // a duration: nobody has it open
                    continue;
                }
                char bytes[512];
                const ssize_t n = ::read(polled[i].fd, bytes, sizeof bytes);
                if (n <= 0 || isCut) continue;
                if (isNoisy.exchange(false)) bytes[0] = static_cast<char>(bytes[0] ^ 0x55);
                EXPECT_EQ(::write(polled[1 - i].fd, bytes, static_cast<size_t>(n)), n);
            }
        }
    }
    int m_near, m_far;
    std::atomic<bool> m_isStopping{false};
    std::thread m_thread;
};

/// A unit of a serial line. Not on libmodbus, whose server waits for the answers of other units and takes the next
/// request for one when such a unit is missing.
class SerialUnit {
public:
    SerialUnit(const std::string& path, uint8_t unit) : m_line(::open(path.c_str(), O_RDWR | O_NOCTTY)), m_unit(unit) {
        termios raw{};
        ::tcgetattr(m_line, &raw);
        ::cfmakeraw(&raw);
        EXPECT_EQ(::tcsetattr(m_line, TCSANOW, &raw), 0) << path;
        m_thread = std::thread([this] { run(); });
    }
    ~SerialUnit() {
        m_isStopping = true;
        m_thread.join();
        ::close(m_line);
    }
    std::array<std::atomic<uint16_t>, 10> registers{};

private:
    static uint16_t checksum(std::span<const uint8_t> bytes) {
        uint16_t sum = 0xFFFF;
        for (const uint8_t byte : bytes) {
            sum ^= byte;
            for (int i = 0; i < 8; ++i) sum = static_cast<uint16_t>(sum & 1 ? (sum >> 1) ^ 0xA001 : sum >> 1);
        }
        return sum;
    }
    void run() {
        std::vector<uint8_t> frame;
        while (!m_isStopping) {
            pollfd polled{m_line, POLLIN, 0};
            uint8_t bytes[256];
            if (::poll(&polled, 1, frame.empty() ? 50 : 5) > 0) {
                const ssize_t n = ::read(m_line, bytes, sizeof bytes);
                if (n > 0) frame.insert(frame.end(), bytes, bytes + n);
            } else if (!frame.empty()) { // silence ends a frame
                answer(frame);
                frame.clear();
            }
        }
    }
    void answer(std::span<const uint8_t> frame) {
        if (frame.size() != 8 || frame[0] != m_unit || checksum(frame) != 0) return;
        const size_t first = frame[3] % registers.size();
        std::vector<uint8_t> out(frame.begin(), frame.begin() + 6);
        if (frame[1] == 6) registers[first] = static_cast<uint16_t>(frame[4] << 8 | frame[5]);
        if (frame[1] == 3) {
            out = {m_unit, 3, static_cast<uint8_t>(frame[5] * 2)};
            for (size_t i = 0; i < frame[5]; ++i) {
                out.push_back(static_cast<uint8_t>(registers[(first + i) % 10] >> 8));
                out.push_back(static_cast<uint8_t>(registers[(first + i) % 10]));
            }
        }
        const uint16_t sum = checksum(out);
        out.push_back(static_cast<uint8_t>(sum));
        out.push_back(static_cast<uint8_t>(sum >> 8));
        EXPECT_EQ(::write(m_line, out.data(), out.size()), static_cast<ssize_t>(out.size()));
    }
    int m_line;
    uint8_t m_unit;
    std::atomic<bool> m_isStopping{false};
    std::thread m_thread;
};

std::string write(const std::string& name, const std::string& text) {
    const std::string path = ::testing::TempDir() + std::to_string(::getpid()) + name;
    std::ofstream(path) << text;
    return path;
}

const char* const kTask = "CONFIGURATION Plc RESOURCE Cpu ON Pc TASK Fast(INTERVAL := T#2ms, PRIORITY := 1); PROGRAM "
                          "Main WITH Fast : Main; END_RESOURCE END_CONFIGURATION\n";

const char* const kPymodbusServer = R"(
import sys
from pymodbus.server import StartTcpServer
from pymodbus.datastore import ModbusSlaveContext, ModbusServerContext, ModbusSequentialDataBlock
block = lambda v: ModbusSequentialDataBlock(0, v + [0] * 50)
store = ModbusSlaveContext(di=block([0, 1]), co=block([1, 0]), hr=block([16457, 4059, 7]), ir=block([65535, 8]), zero_mode=True)
StartTcpServer(context=ModbusServerContext(slaves=store, single=True), address=("127.0.0.1", int(sys.argv[1])))
)";

const char* const kPymodbusClient = R"(
import sys, time
from pymodbus.client import ModbusTcpClient
client = ModbusTcpClient("127.0.0.1", port=int(sys.argv[1]))
for i in range(200):
    if client.connect(): break
    time.sleep(0.05)
if client.write_registers(0, [16457, 4059], slave=1).isError(): sys.exit(2)
for i in range(400):
    answer = client.read_input_registers(0, 1, slave=1)
    if not answer.isError() and answer.registers[0] == 314: sys.exit(0)
    time.sleep(0.02)
sys.exit(3)
)";

} // namespace

TEST(Pymodbus, ItsServerIsReadAndWritten) {
    const uint16_t port = freePort();
    const Process server({"/usr/bin/python3", write("server.py", kPymodbusServer), std::to_string(port)});
    LiveRun run(
        std::string("PROGRAM Main VAR pi : REAL; a : INT; b, c : BOOL; out : INT := 5; n : INT; END_VAR n := n + 1; "
                    "END_PROGRAM ") +
            kTask,
        "{\"devices\": [{\"name\": \"Py\", \"protocol\": \"modbus-tcp\", \"host\": \"127.0.0.1\", \"poll\": \"10ms\", "
        "\"port\": " +
            std::to_string(port) +
            R"(, "channels": [{"name": "pi", "variable": "Main.pi", "type": "REAL", "address": 0},
                       {"name": "a", "variable": "Main.a", "table": "input", "address": 0},
                       {"name": "b", "variable": "Main.b", "table": "coil", "address": 0},
                       {"name": "c", "variable": "Main.c", "table": "discrete", "address": 1},
                       {"name": "out", "variable": "Main.out", "direction": "out", "address": 9},
                       {"name": "back", "variable": "Main.n", "address": 9}]}]})");
    EXPECT_TRUE(run.scanUntil([&] {
        return run.value("Main.pi").starts_with("3.1415") && run.value("Main.a") == "-1" &&
               run.value("Main.b") == "TRUE" && run.value("Main.c") == "TRUE" && run.status().channels[5].value == "5";
    })) << run.status().problem.english();
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(Pymodbus, ItsClientIsAnswered) {
    const uint16_t port = freePort();
    LiveRun run(
        std::string(
            "PROGRAM Main VAR pi : REAL; hundred : INT; END_VAR hundred := REAL_TO_INT(pi * 100.0); END_PROGRAM ") +
            kTask,
        "{\"devices\": [{\"name\": \"Us\", \"protocol\": \"modbus-server\", \"port\": " + std::to_string(port) +
            R"(, "channels": [{"name": "pi", "variable": "Main.pi", "type": "REAL", "address": 0},
                       {"name": "hundred", "variable": "Main.hundred", "table": "input", "address": 0}]}]})");
    std::atomic<int> code{-1};
    Process client({"/usr/bin/python3", write("client.py", kPymodbusClient), std::to_string(port)});
    std::thread waits([&] { code = client.wait(); });
    EXPECT_TRUE(run.scanUntil([&] { return code >= 0; }));
    waits.join();
    EXPECT_EQ(code, 0);
}

namespace {

/// Each order with pymodbus's own builder and decoder: what it writes is read, what is shown it decodes.
const char* const kPymodbusOrders = R"(
import sys, time
from pymodbus.client import ModbusTcpClient
from pymodbus.constants import Endian
from pymodbus.payload import BinaryPayloadBuilder, BinaryPayloadDecoder
orders = [(Endian.Big, Endian.Big), (Endian.Big, Endian.Little), (Endian.Little, Endian.Big), (Endian.Little, Endian.Little)]
client = ModbusTcpClient("127.0.0.1", port=int(sys.argv[1]))
for i in range(200):
    if client.connect(): break
    time.sleep(0.05)
for i, (bytes, words) in enumerate(orders):
    builder = BinaryPayloadBuilder(byteorder=bytes, wordorder=words)
    builder.add_32bit_float(1.5 + i)
    builder.add_32bit_int(-100000 - i)
    builder.add_64bit_float(1e100 + i)
    builder.add_64bit_int(-1234567890123 - i)
    if client.write_registers(20 * i, builder.to_registers(), slave=1).isError(): sys.exit(2)
for attempt in range(400):
    good = 0
    for i, (bytes, words) in enumerate(orders):
        answer = client.read_input_registers(20 * i, 12, slave=1)
        if answer.isError(): continue
        d = BinaryPayloadDecoder.fromRegisters(answer.registers, byteorder=bytes, wordorder=words)
        found = (d.decode_32bit_float(), d.decode_32bit_int(), d.decode_64bit_float(), d.decode_64bit_int())
        good += found == (3.0 + 2 * i, -100001 - i, 2e100, -1234567890124 - i)
    if good == 4: sys.exit(0)
    time.sleep(0.02)
sys.exit(3)
)";

} // namespace

TEST(Pymodbus, EveryByteOrderMeansTheSameOnBothSides) {
    const uint16_t port = freePort();
    std::string variables, body, channels;
    for (int i = 0; i < 4; ++i) {
        const std::string n = std::to_string(i), at = std::to_string(20 * i),
                          order = std::array{"ABCD", "CDAB", "BADC", "DCBA"}[size_t(i)];
        variables += "r" + n + ", rr" + n + " : REAL; d" + n + ", dd" + n + " : DINT; l" + n + ", ll" + n +
                     " : LREAL; i" + n + ", ii" + n + " : LINT; ";
        body += "rr" + n + " := 2.0 * r" + n + "; dd" + n + " := d" + n + " - 1; ll" + n + " := 2.0 * l" + n + "; ii" +
                n + " := i" + n + " - 1; ";
        int offset = 0;
        for (const auto& [name, type, size] : {std::tuple("r", "REAL", 2), std::tuple("d", "DINT", 2),
                                               std::tuple("l", "LREAL", 4), std::tuple("i", "LINT", 4)}) {
            for (const bool isOut : {false, true})
                channels += std::string(channels.empty() ? "" : ", ") + R"({"name": ")" + name + (isOut ? "o" : "i") +
                            n + R"(", "variable": "Main.)" + name + (isOut ? name : "") + n + R"(", "type": ")" + type +
                            R"(", "order": ")" + order + R"(", "table": ")" + (isOut ? "input" : "holding") +
                            R"(", "address": )" + std::to_string(20 * i + offset) + "}";
            offset += size;
        }
    }
    LiveRun run("PROGRAM Main VAR " + variables + " END_VAR " + body + " END_PROGRAM " + kTask,
                "{\"devices\": [{\"name\": \"Us\", \"protocol\": \"modbus-server\", \"port\": " + std::to_string(port) +
                    ", \"channels\": [" + channels + "]}]}");
    std::atomic<int> code{-1};
    Process client({"/usr/bin/python3", write("orders.py", kPymodbusOrders), std::to_string(port)});
    std::thread waits([&] { code = client.wait(); });
    EXPECT_TRUE(run.scanUntil([&] { return code >= 0; }));
    waits.join();
    EXPECT_EQ(code, 0);
    EXPECT_EQ(run.value("Main.r1"), "2.5");
    EXPECT_EQ(run.value("Main.d3"), "-100003");
}

/// The shipped example over its real line: its client at its own server.
TEST(ModbusTank, TheExampleRunsOverTheLine) {
    const auto read = [](const std::string& name) {
        std::ifstream file(plc::sourceDir() + "/projects/examples/modbus_tank/" + name);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    std::string json = read("devices.json");
    const std::string port = std::to_string(freePort());
    for (size_t at; (at = json.find("15020")) != std::string::npos;) json.replace(at, 5, port);
    LiveRun run(read("src/main.st") + read("src/station.st"), json);
    ASSERT_TRUE(run.session->controller().write(
        "Station.OverModbus", {run.session->program()->layout.find("Station.OverModbus")->type, int64_t(1)}));
    EXPECT_TRUE(run.scanUntil([&] {
        return run.value("Station.Pump") == "TRUE" && run.value("IO.LevelGood") == "TRUE";
    })) << run.status(1).problem.english();
    EXPECT_TRUE(run.scanUntil([&] { return run.value("IO.LevelRaw") != "200" && run.value("IO.Pump") == "TRUE"; }))
        << "the level rises over the line";
    EXPECT_EQ(run.value("Main.LineLost"), "FALSE");
    EXPECT_GT(run.replaysExactly(), 0u);
}

// ---------------------------------------------------------------- a serial line

namespace {

std::string serialUnits(const std::string& path) {
    const auto unit = [&](const std::string& name, int number, const std::string& channels) {
        return "{\"name\": \"" + name + "\", \"protocol\": \"modbus-rtu\", \"serial\": \"" + path +
               "\", \"unit\": " + std::to_string(number) +
               ", \"poll\": \"20ms\", \"timeout\": \"300ms\", \"retry\": \"1s\", \"channels\": [" + channels + "]}";
    };
    return "{\"devices\": [" +
           unit("Drive", 3, R"({"name": "speed", "variable": "Main.speed", "address": 2, "quality": "Main.good"},
                               {"name": "wanted", "variable": "Main.wanted", "direction": "out", "address": 5})") +
           "," + unit("Missing", 9, R"({"name": "x", "variable": "Main.x", "address": 0, "quality": "Main.goodX"})") +
           "]}";
}

const char* const kSerialProgram =
    "PROGRAM Main VAR speed, wanted, x : INT; good, goodX : BOOL; END_VAR wanted := speed + 1; END_PROGRAM ";

} // namespace

TEST(ModbusRtu, AUnitIsReadAndWrittenWhileAnotherIsMissing) {
    NullModem line;
    SerialUnit drive(line.far, 3);
    drive.registers[2] = 1450;
    LiveRun run(std::string(kSerialProgram) + kTask, serialUnits(line.near));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.speed") == "1450" && drive.registers[5] == 1451; }))
        << run.status().problem.english();
    EXPECT_TRUE(run.scanUntil([&] { return run.status(1).state == LinkState::Lost; }));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.good") == "TRUE"; }));
    EXPECT_EQ(run.value("Main.goodX"), "FALSE");
    // One disturbed frame is asked for again before anything is lost.
    const uint64_t errors = run.status().figures.errors;
    line.isNoisy = true;
    const uint64_t requests = run.status().figures.requests;
    EXPECT_TRUE(run.scanUntil([&] { return run.status().figures.requests > requests + 5; }));
    EXPECT_EQ(run.value("Main.good"), "TRUE");
    EXPECT_EQ(run.status().figures.errors, errors);
    line.isCut = true;
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.good") == "FALSE"; }));
    line.isCut = false;
    drive.registers[2] = 900;
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.speed") == "900"; }));
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(ModbusRtu, APortThatDoesNotExistIsSaid) {
    LiveRun run(std::string(kSerialProgram) + kTask, serialUnits("/dev/no_such_port"));
    EXPECT_TRUE(run.scanUntil([&] { return run.status().state == LinkState::Lost; }));
    EXPECT_NE(run.status().problem.english().find("cannot connect to /dev/no_such_port"), std::string::npos);
}

// ---------------------------------------------------------------- a broker

namespace {

std::string broker(uint16_t port, const std::string& channels, const std::string& fields = {}) {
    return "{\"devices\": [{\"name\": \"Broker\", \"protocol\": \"mqtt\", \"host\": \"127.0.0.1\", \"poll\": \"5ms\", "
           "\"retry\": \"200ms\", \"port\": " +
           std::to_string(port) + fields + ", \"channels\": [" + channels + "]}]}";
}

std::unique_ptr<Process> startBroker(uint16_t port) {
    return std::make_unique<Process>(std::vector<std::string>{"/usr/sbin/mosquitto", "-p", std::to_string(port)});
}

} // namespace

TEST(Mqtt, ValuesGoThroughABrokerPlainAndInJson) {
    const uint16_t port = freePort();
    const auto mosquitto = startBroker(port);
    // Two runs: what one publishes the other subscribes to.
    LiveRun sender(
        std::string("PROGRAM Main VAR n : INT; half : REAL; on : BOOL; text : STRING := 'caf$E9'; END_VAR n := n + 1; "
                    "half := INT_TO_REAL(n) / 2.0; on := "
                    "TRUE; END_PROGRAM ") +
            kTask,
        broker(
            port,
            R"({"name": "n", "variable": "Main.n", "direction": "out", "topic": "plant/n", "type": "INT", "retain": true},
                                   {"name": "half", "variable": "Main.half", "direction": "out", "topic": "plant/state", "json": "/half"},
                                   {"name": "on", "variable": "Main.on", "direction": "out", "topic": "plant/state", "json": "/pump/on", "type": "BOOL"},
                                   {"name": "text", "variable": "Main.text", "direction": "out", "topic": "plant/text", "type": "STRING", "retain": true})"));
    LiveRun receiver(
        std::string(
            "PROGRAM Main VAR n : INT; half : REAL; on, good, online : BOOL; text : STRING; END_VAR END_PROGRAM ") +
            kTask,
        broker(port,
               R"({"name": "n", "variable": "Main.n", "topic": "plant/n", "quality": "Main.good"},
                               {"name": "half", "variable": "Main.half", "topic": "plant/state", "json": "/half"},
                               {"name": "on", "variable": "Main.on", "topic": "plant/state", "json": "/pump/on", "type": "BOOL"},
                               {"name": "text", "variable": "Main.text", "topic": "plant/text", "type": "STRING"})",
               ", \"online\": \"Main.online\""));
    EXPECT_TRUE(receiver.scanUntil([&] {
        sender.scan();
        return receiver.value("Main.n") != "0" && receiver.value("Main.half") != "0.0" &&
               receiver.value("Main.on") == "TRUE" && receiver.value("Main.text") == "'caf\xC3\xA9'" &&
               receiver.value("Main.good") == "TRUE" && receiver.value("Main.online") == "TRUE";
    })) << receiver.status().problem.english()
        << sender.status().problem.english() << receiver.value("Main.text");
    EXPECT_GT(receiver.replaysExactly(), 0u);
}

TEST(Mqtt, ABrokerThatGoesAndComesBackIsTakenUpAgain) {
    const uint16_t port = freePort();
    auto mosquitto = startBroker(port);
    LiveRun run(
        std::string("PROGRAM Main VAR out : INT; back : INT; good : BOOL; END_VAR out := out + 1; END_PROGRAM ") +
            kTask,
        broker(port, R"({"name": "out", "variable": "Main.out", "direction": "out", "topic": "x", "type": "INT"},
                                {"name": "back", "variable": "Main.back", "topic": "x", "quality": "Main.good"})"));
    ASSERT_TRUE(run.scanUntil([&] { return run.value("Main.good") == "TRUE"; })) << run.status().problem.english();
    mosquitto.reset();
    ASSERT_TRUE(
        run.scanUntil([&] { return run.value("Main.good") == "FALSE" && run.status().state == LinkState::Lost; }));
    mosquitto = startBroker(port);
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.good") == "TRUE"; })) << run.status().problem.english();
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(Mqtt, AMessageThatCannotBeReadMakesTheChannelBad) {
    const uint16_t port = freePort();
    const auto mosquitto = startBroker(port);
    LiveRun run(
        std::string(
            "PROGRAM Main VAR text : STRING; back : INT := 4; code : USINT; END_VAR text := 'twelve'; END_PROGRAM ") +
            kTask,
        broker(
            port,
            R"({"name": "text", "variable": "Main.text", "direction": "out", "topic": "x", "type": "STRING", "retain": true},
                                {"name": "back", "variable": "Main.back", "topic": "x", "quality": "Main.code"})"));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.code") == "4"; })) << run.value("Main.code");
    EXPECT_EQ(run.value("Main.back"), "4");
    EXPECT_EQ(run.status().problem.english(),
              "back: the message holds no value that can be read; check what the device publishes");
}

namespace {

void openssl(std::vector<std::string> words) {
    words.insert(words.begin(), "/usr/bin/openssl");
    EXPECT_EQ(Process(std::move(words)).wait(), 0);
}

/// An authority of our own and a broker's certificate that it signed.
struct Authority {
    std::string folder = write("authority", "") + ".d", ca = folder + "/ca.pem", certificate = folder + "/broker.pem",
                key = folder + "/broker.key";
    explicit Authority(const std::string& name) {
        folder += name;
        std::filesystem::create_directories(folder);
        ca = folder + "/ca.pem", certificate = folder + "/broker.pem", key = folder + "/broker.key";
        const std::string caKey = folder + "/ca.key", request = folder + "/broker.csr", names = folder + "/names";
        std::ofstream(names) << "subjectAltName=IP:127.0.0.1\n";
        openssl({"req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=ours", "-keyout", caKey,
                 "-out", ca});
        openssl({"req", "-newkey", "rsa:2048", "-nodes", "-subj", "/CN=127.0.0.1", "-keyout", key, "-out", request});
        openssl({"x509", "-req", "-in", request, "-CA", ca, "-CAkey", caKey, "-CAcreateserial", "-days", "2",
                 "-extfile", names, "-out", certificate});
    }
    ~Authority() { std::filesystem::remove_all(folder); }
};

} // namespace

TEST(Mqtt, ByTlsWithTheAuthorityThatIsNamedAndNoOther) {
    const uint16_t port = freePort();
    const Authority ours("1"), others("2");
    const std::string settings =
        write("tls.conf", "listener " + std::to_string(port) + " 127.0.0.1\nallow_anonymous true\nuser root\ncafile " +
                              ours.ca + "\ncertfile " + ours.certificate + "\nkeyfile " + ours.key + "\n");
    const Process mosquitto({"/usr/sbin/mosquitto", "-c", settings});
    const std::string program =
        std::string("PROGRAM Main VAR out : INT; back : INT; good : BOOL; END_VAR out := out + 1; END_PROGRAM ") +
        kTask;
    const std::string channels =
        R"({"name": "out", "variable": "Main.out", "direction": "out", "topic": "x", "type": "INT"},
                                {"name": "back", "variable": "Main.back", "topic": "x", "quality": "Main.good"})";
    {
        LiveRun run(program, broker(port, channels, ", \"tls\": true, \"caFile\": \"" + ours.ca + "\""));
        EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.good") == "TRUE"; })) << run.status().problem.english();
        EXPECT_GT(run.replaysExactly(), 0u);
    }
    for (const std::string& fields :
         {", \"tls\": true, \"caFile\": \"" + others.ca + "\"", std::string(", \"tls\": true"), std::string()}) {
        LiveRun run(program, broker(port, channels, fields));
        EXPECT_TRUE(run.scanUntil([&] { return run.status().state == LinkState::Lost; })) << fields;
        EXPECT_EQ(run.value("Main.good"), "FALSE") << fields;
    }
}
