// `stepwise devices`, and devices in `check`, `run` and `replay`: what is printed, what is written, the exit codes.
#include "projects/devices/engine.h"
#include "tests/app/cli/command_fixture.h"

#include <filesystem>
#include <netinet/in.h>
#include <regex>
#include <sys/socket.h>
#include <unistd.h>

namespace plc {
namespace {

const char* const kProgram =
    "PROGRAM Main\nVAR\n    level AT %IW0 : INT;\n    twice : INT;\nEND_VAR\ntwice := level + level;\nEND_PROGRAM\n"
    "CONFIGURATION Plc RESOURCE Cpu ON Pc TASK Fast(INTERVAL := T#10ms, PRIORITY := 1); PROGRAM Main WITH Fast : Main; "
    "END_RESOURCE END_CONFIGURATION\n";

class DevicesCommand : public CommandTest {
protected:
    void SetUp() override {
        std::filesystem::create_directories(path("src"));
        write("project.json", "{\n  \"name\": \"Test\"\n}\n");
        write("src/main.st", kProgram);
    }
    void describe(const std::string& channels, int port = 1) {
        write("devices.json",
              "{\"devices\": [{\"name\": \"Pump\", \"protocol\": \"modbus-tcp\", \"host\": \"127.0.0.1\", "
              "\"poll\": \"10ms\", \"port\": " +
                  std::to_string(port) + ", \"channels\": [" + channels + "]}]}");
    }
};

/// A server on a port that the system chose; its program sets register 4 to 21.
class Far {
public:
    Far() {
        const int probe = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(::bind(probe, reinterpret_cast<sockaddr*>(&address), size), 0);
        ::getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size);
        ::close(probe);
        port = ntohs(address.sin_port);
        devices::Device device;
        device.name = "Far";
        device.protocol = devices::Protocol::ModbusServer;
        device.host = "127.0.0.1";
        device.port = static_cast<uint16_t>(port);
        device.timeout = {};
        devices::Channel channel;
        channel.name = "r";
        channel.address = 4;
        device.channels.push_back(channel);
        m_engine = std::make_unique<devices::Engine>(std::vector{device});
        m_engine->connect();
    }
    int port = 0;

private:
    std::unique_ptr<devices::Engine> m_engine;
};

} // namespace

TEST_F(DevicesCommand, ListsWhatTheFileSays) {
    describe(R"({"name": "Level", "variable": "%IW0", "table": "input", "address": 4})");
    EXPECT_EQ(command({"devices", path("")}), 0) << err;
    EXPECT_EQ(out, "Pump (modbus-tcp): 127.0.0.1:1, unit 1\n  Level: %IW0 <- input 4 INT\n");
    EXPECT_EQ(command({"devices"}), 2);
}

TEST_F(DevicesCommand, MistakesAreFoundByEveryCommandThatUsesThem) {
    describe(R"({"name": "Level", "variable": "Main.levle", "address": 4})");
    for (const std::vector<std::string>& words : {std::vector<std::string>{"devices", path("")}, {"check", path("")}}) {
        EXPECT_EQ(command(words), 1) << words[0];
        EXPECT_NE(err.find("devices.json:1: error: Pump.Level: 'Main' has no variable 'levle'"), std::string::npos)
            << err;
    }
    EXPECT_EQ(command({"run", path(""), "--devices", "--scans", "1"}), 2);
    EXPECT_NE(err.find("The devices have errors and are not connected"), std::string::npos) << err;
    EXPECT_EQ(command({"check", path(""), "--format", "json"}), 1);
    EXPECT_NE(out.find("\"file\":\"devices.json\""), std::string::npos) << out;
}

TEST_F(DevicesCommand, WithoutTheFileThereIsNothingToConnect) {
    EXPECT_EQ(command({"devices", path("")}), 0);
    EXPECT_EQ(out, "Test: no devices\n");
    EXPECT_EQ(command({"run", path(""), "--devices", "--scans", "1"}), 2);
    EXPECT_NE(err.find("devices.json"), std::string::npos) << err;
}

TEST_F(DevicesCommand, AddressesAreProposedAndWritten) {
    describe(R"({"name": "Flow", "variable": "", "address": 4})");
    EXPECT_EQ(command({"devices", path(""), "--propose"}), 0);
    EXPECT_EQ(out, "VAR_GLOBAL\n    Pump_Flow AT %IW2 : INT;\nEND_VAR\n");
    EXPECT_EQ(command({"devices", path(""), "--write"}), 0);
    EXPECT_NE(read("devices.json").find("\"variable\": \"%IW2\""), std::string::npos);
    EXPECT_EQ(command({"devices", path(""), "--propose"}), 0);
    EXPECT_EQ(out, "Test: every channel has a variable\n");
}

TEST_F(DevicesCommand, ARunIsFedByTheDeviceAndReplayedWithoutIt) {
    {
        const Far far;
        describe(R"({"name": "Level", "variable": "%IW0", "address": 4, "scale": 1, "offset": 21})", far.port);
        EXPECT_EQ(command({"devices", path(""), "--live", "500ms"}), 0) << out;
        EXPECT_NE(out.find("Pump (modbus-tcp): online"), std::string::npos) << out;
        EXPECT_EQ(command({"run", path(""), "--devices", "--until", "Main.twice = 42", "--for", "30s", "--record",
                           path("a.rec")}),
                  0)
            << err;
        EXPECT_NE(err.find("good"), std::string::npos) << err;
    }
    EXPECT_EQ(command({"replay", path("a.rec"), "--writers", "Main.level"}), 0) << err;
    // the device may have answered before the first scan
    EXPECT_TRUE(std::regex_search(out, std::regex("Main.level (from 0 )?to 21, written from device Pump"))) << out;
    EXPECT_EQ(command({"devices", path(""), "--live", "300ms", "--format", "json"}), 1) << "the device is gone";
    EXPECT_NE(out.find("\"state\":\"lost\""), std::string::npos) << out;
}

} // namespace plc
