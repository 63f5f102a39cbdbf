// Modbus TCP against libmodbus and bad lines: what is read and written, refusals, lost connections, outputs that become
// safe, and recorded runs that are made again without the device.
#include "tests/projects/devices/peers.h"

using namespace plc;
using namespace plc::devices;
using namespace std::chrono_literals;
using plc::testing::freePort;
using plc::testing::LiveRun;
using plc::testing::ModbusPeer;
using plc::testing::Proxy;

namespace {

/// A device named Pump with these channels.
std::string pump(uint16_t port, const std::string& channels, const std::string& fields = {}) {
    return "{\"devices\": [{\"name\": \"Pump\", \"protocol\": \"modbus-tcp\", \"host\": \"127.0.0.1\", \"port\": " +
           std::to_string(port) + ", \"poll\": \"5ms\", \"timeout\": \"500ms\", \"retry\": \"200ms\"" +
           (fields.empty() ? "" : ", " + fields) + ", \"channels\": [" + channels + "]}]}";
}

const char* const kTask = R"(
CONFIGURATION Plc
    RESOURCE Cpu ON Pc
        TASK Fast(INTERVAL := T#2ms, PRIORITY := 1);
        PROGRAM Main WITH Fast : Main;
    END_RESOURCE
END_CONFIGURATION
)";

std::string program(const std::string& variables, const std::string& body = "n := n + 1;") {
    return "PROGRAM Main\nVAR\n    n : DINT;\n" + variables + "END_VAR\n" + body + "\nEND_PROGRAM\n" + kTask;
}

} // namespace

TEST(ModbusTcp, HoldingRegistersReachTheInputsOfARunningProgram) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    peer.setRegister(4, 1234);
    LiveRun run(program("    level AT %IW0 : INT;\n    twice : INT;\n", "twice := 2 * level;"),
                pump(port, R"({"name": "Level", "variable": "%IW0", "address": 4})"));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.twice") == "2468"; })) << run.status().problem.english();
    peer.setRegister(4, static_cast<uint16_t>(-7));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.twice") == "-14"; }));
    EXPECT_EQ(run.status().state, LinkState::Online);
    EXPECT_GT(run.status().figures.requests, 0u);
    EXPECT_GT(run.status().figures.bytesIn, 0u);
    EXPECT_GT(run.status().figures.lastLatencyNs, 0);
    EXPECT_GT(run.replaysExactly(), 2u);
}

TEST(ModbusTcp, EveryTableIsReadAndWritten) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    peer.setInputRegister(3, 33);
    peer.setCoil(5, true);
    peer.setDiscrete(6, true);
    peer.setRegister(9, 0x0100);
    LiveRun run(
        program("    a, b : INT; c, d, e : BOOL; outWord AT %QW0 : INT; outBit AT %QX4.0 : BOOL; big : LREAL;\n",
                "outWord := a + 1; outBit := c; big := 1.25;"),
        pump(port, R"({"name": "a", "variable": "Main.a", "table": "input", "address": 3},
                              {"name": "c", "variable": "Main.c", "table": "coil", "address": 5},
                              {"name": "d", "variable": "Main.d", "table": "discrete", "address": 6},
                              {"name": "e", "variable": "Main.e", "type": "BOOL", "bit": 8, "address": 9},
                              {"name": "w", "variable": "%QW0", "address": 20},
                              {"name": "x", "variable": "%QX4.0", "table": "coil", "address": 21},
                              {"name": "y", "variable": "Main.big", "direction": "out", "type": "LREAL", "address": 30})"));
    EXPECT_TRUE(run.scanUntil([&] {
        return peer.registerAt(20) == 34 && peer.coilAt(21) && run.value("Main.d") == "TRUE" &&
               run.value("Main.e") == "TRUE" && peer.registerAt(30) == 0x3FF4;
    })) << run.status().problem.english();
    EXPECT_TRUE(peer.coilAt(21));
    // What does not change is not written again.
    const int writes = peer.writes();
    const uint64_t requests = run.status().figures.requests;
    EXPECT_TRUE(run.scanUntil([&] { return run.status().figures.requests > requests + 20; }));
    EXPECT_EQ(peer.writes(), writes);
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(ModbusTcp, ARefusedRegisterSpoilsOnlyItsOwnChannel) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    peer.setRegister(148, 48);
    peer.setRegister(149, 49);
    LiveRun run(program("    a, b, c : INT; code : USINT;\n"),
                pump(port, R"({"name": "a", "variable": "Main.a", "address": 148},
                              {"name": "b", "variable": "Main.b", "address": 149},
                              {"name": "c", "variable": "Main.c", "address": 150, "quality": "Main.code"})"));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.a") == "48" && run.value("Main.b") == "49"; }));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.code") == "3"; })) << run.value("Main.code");
    EXPECT_EQ(run.status().channels[0].quality, Quality::Good);
    EXPECT_EQ(run.status().channels[2].quality, Quality::Refused);
    EXPECT_EQ(run.status().state, LinkState::Online);
    EXPECT_NE(run.status().problem.english().find("it has no such address"), std::string::npos);
}

TEST(ModbusTcp, AValueThatDoesNotFitLeavesTheVariableAndMakesTheChannelBad) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    peer.setRegister(0, 100);
    LiveRun run(program("    small : SINT; good : BOOL;\n"),
                pump(port, R"({"name": "a", "variable": "Main.small", "address": 0, "quality": "Main.good"})"));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.small") == "100" && run.value("Main.good") == "TRUE"; }));
    peer.setRegister(0, 200);
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.good") == "FALSE"; }));
    EXPECT_EQ(run.value("Main.small"), "100");
    EXPECT_EQ(run.status().channels[0].quality, Quality::Unfit);
}

TEST(ModbusTcp, APulledCableIsSeenTheScanGoesOnAndTheDeviceComesBack) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    Proxy line(port);
    peer.setRegister(0, 5);
    peer.setRegister(1, 6);
    LiveRun run(
        program("    last, safe : INT; goodLast, online : BOOL;\n    out AT %QW0 : INT;\n", "n := n + 1; out := 17;"),
        pump(line.port(),
             R"({"name": "last", "variable": "Main.last", "address": 0, "quality": "Main.goodLast"},
                        {"name": "safe", "variable": "Main.safe", "address": 1, "onLoss": "safe", "safe": -1},
                        {"name": "out", "variable": "%QW0", "address": 7})",
             "\"online\": \"Main.online\""));
    ASSERT_TRUE(run.scanUntil([&] {
        return run.value("Main.safe") == "6" && run.value("Main.online") == "TRUE" && peer.registerAt(7) == 17;
    }));
    line.setSwallows(true);
    std::chrono::nanoseconds worst{};
    ASSERT_TRUE(run.scanUntil([&] {
        const auto begin = std::chrono::steady_clock::now();
        (void)run.session->controller().scan();
        worst = std::max<std::chrono::nanoseconds>(worst, std::chrono::steady_clock::now() - begin);
        return run.value("Main.goodLast") == "FALSE" && run.value("Main.safe") == "-1";
    }));
    EXPECT_LT(worst, 250ms) << "a scan waited for the device, whose timeout is 500 ms";
    EXPECT_EQ(run.value("Main.last"), "5");
    EXPECT_EQ(run.value("Main.online"), "FALSE");
    EXPECT_EQ(run.status().state, LinkState::Lost);
    EXPECT_FALSE(run.status().problem.isEmpty());
    peer.setRegister(0, 50);
    peer.setRegister(7, 0); // the device forgot its outputs
    line.setSwallows(false);
    line.cut();
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.last") == "50" && run.value("Main.goodLast") == "TRUE"; }));
    EXPECT_TRUE(run.scanUntil([&] { return peer.registerAt(7) == 17; }));
    EXPECT_EQ(run.value("Main.safe"), "6");
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(ModbusTcp, ASlowLineIsUsedAndACutOneIsTakenUpAgain) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    Proxy line(port);
    line.setDelay(20ms);
    LiveRun run(program("    a : INT;\n"), pump(line.port(), R"({"name": "a", "variable": "Main.a", "address": 0})"));
    for (uint16_t round = 1; round <= 5; ++round) {
        peer.setRegister(0, round);
        ASSERT_TRUE(run.scanUntil([&] { return run.value("Main.a") == std::to_string(round); })) << round;
        line.cut();
    }
    EXPECT_GE(run.status().figures.worstLatencyNs, 20'000'000);
    EXPECT_TRUE(run.scanUntil([&] { return run.status().figures.connects >= 3; }));
}

TEST(ModbusTcp, AnInputThatMustNotBeLostStopsThePlc) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    Proxy line(port);
    peer.setRegister(0, 9);
    LiveRun run(program("    a : INT;\n    out AT %QW0 : INT;\n", "out := 5;"),
                pump(line.port(), R"({"name": "a", "variable": "Main.a", "address": 0, "onLoss": "fault"},
                                     {"name": "out", "variable": "%QW0", "address": 7})"));
    ASSERT_TRUE(run.scanUntil([&] { return run.value("Main.a") == "9" && peer.registerAt(7) == 5; }));
    line.setSwallows(true);
    ASSERT_TRUE(run.scanUntil([&] { return run.session->controller().state() == controller::State::Fault; }));
    EXPECT_EQ(run.session->controller().fault()->message.english().substr(0, 41),
              "the input a of the device Pump was lost: ");
    EXPECT_EQ(run.value("%QW0"), "0");
    line.setSwallows(false);
    line.cut();
    EXPECT_TRUE(eventually([&] { return peer.registerAt(7) == 0; })) << "the outputs are safe in the device too";
    // With the device back, the PLC starts again after a reset; on a busy machine a late answer stops it once more.
    ASSERT_TRUE(eventually([&] { return run.status().state == LinkState::Online; }));
    EXPECT_TRUE(run.scanUntil([&] {
        if (run.session->controller().state() != controller::State::Running) {
            run.session->controller().reset(controller::ResetKind::Warm);
            run.session->controller().start();
        }
        return peer.registerAt(7) == 5;
    }));
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(ModbusTcp, OutputsAreSafeAfterStopFaultAndDisconnecting) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    LiveRun run(program("    a AT %QW0 : INT := 3; b AT %QW2 : INT; divisor : INT := 1; x : INT;\n",
                        "a := 10; b := 20; x := 1 / divisor;"),
                pump(port, R"({"name": "a", "variable": "%QW0", "address": 1},
                              {"name": "b", "variable": "%QW2", "address": 2, "safe": 77})"));
    const auto runs = [&] { return peer.registerAt(1) == 10 && peer.registerAt(2) == 20; };
    const auto isSafe = [&] { return peer.registerAt(1) == 3 && peer.registerAt(2) == 77; };
    ASSERT_TRUE(run.scanUntil(runs));
    run.session->controller().stop();
    EXPECT_TRUE(eventually(isSafe)) << "stop";
    run.session->controller().start();
    ASSERT_TRUE(run.scanUntil(runs));
    const auto place = run.built.program->layout.find("Main.divisor");
    ASSERT_TRUE(run.session->controller().write(*place, types::Value{place->type, int64_t(0)}));
    run.scan();
    ASSERT_EQ(run.session->controller().state(), controller::State::Fault);
    EXPECT_TRUE(eventually(isSafe)) << "fault";
    run.session->controller().reset(controller::ResetKind::Cold);
    run.session->controller().start();
    ASSERT_TRUE(run.scanUntil(runs));
    run.engine->disconnect();
    EXPECT_TRUE(isSafe()) << "disconnected";
    run.engine->connect();
    EXPECT_TRUE(run.scanUntil(runs)) << "connected again";
}

TEST(ModbusTcp, AForcedInputStaysForced) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    peer.setRegister(0, 8);
    LiveRun run(program("    a AT %IW0 : INT; seen : INT;\n", "seen := a;"),
                pump(port, R"({"name": "a", "variable": "%IW0", "address": 0})"));
    ASSERT_TRUE(run.scanUntil([&] { return run.value("Main.seen") == "8"; }));
    const auto place = run.built.program->layout.find("Main.a");
    ASSERT_TRUE(run.session->controller().force("Main.a", types::Value{place->type, int64_t(99)}));
    peer.setRegister(0, 9);
    const uint64_t requests = run.status().figures.requests;
    ASSERT_TRUE(run.scanUntil([&] { return run.status().figures.requests > requests + 3; }));
    EXPECT_EQ(run.value("Main.seen"), "99");
    run.session->controller().releaseAll();
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.seen") == "9"; }));
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(ModbusTcp, VariablesBelongToTheProgramWhileNothingIsConnected) {
    const uint16_t port = freePort();
    ModbusPeer peer(port);
    peer.setRegister(0, 5);
    LiveRun run(program("    a : INT; good : BOOL;\n", "IF n > 0 THEN a := 100; good := TRUE; END_IF n := n + 1;"),
                pump(port, R"({"name": "a", "variable": "Main.a", "address": 0, "quality": "Main.good"})"));
    ASSERT_TRUE(run.scanUntil([&] { return run.status().channels[0].quality == Quality::Good; }));
    run.engine->disconnect();
    run.scan();
    run.scan();
    EXPECT_EQ(run.value("Main.a"), "100");
    EXPECT_EQ(run.value("Main.good"), "TRUE");
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(ModbusTcp, ADeviceThatIsNotThereIsSaid) {
    LiveRun run(program("    a : INT; quality : USINT;\n"),
                pump(freePort(), R"({"name": "a", "variable": "Main.a", "address": 0, "quality": "Main.quality"})"));
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.quality") == "2"; }));
    EXPECT_NE(run.status().problem.english().find("cannot connect to 127.0.0.1:"), std::string::npos)
        << run.status().problem.english();
}

// ---------------------------------------------------------------- our server

namespace {

/// Our own server in a second run, its registers in the variables of this program.
std::string server(uint16_t port, const std::string& channels, const std::string& fields = {}) {
    return "{\"devices\": [{\"name\": \"Server\", \"protocol\": \"modbus-server\", \"port\": " + std::to_string(port) +
           (fields.empty() ? "" : ", " + fields) + ", \"channels\": [" + channels + "]}]}";
}

const char* const kServerChannels =
    R"({"name": "out", "variable": "Main.out", "table": "input", "address": 10, "type": "DINT", "order": "CDAB"},
       {"name": "flag", "variable": "Main.flag", "table": "discrete", "address": 3},
       {"name": "in", "variable": "Main.in", "table": "holding", "address": 100, "type": "REAL", "quality": "Main.good"},
       {"name": "switch", "variable": "Main.switch", "table": "coil", "address": 0},
       {"name": "shown", "variable": "Main.n", "direction": "out", "table": "holding", "address": 104, "type": "DINT"})";

std::string serverProgram() {
    return program("    out : DINT; flag, switch, good : BOOL; in : REAL;\n",
                   "out := 16#00010002; flag := switch; n := 42;");
}

} // namespace

TEST(ModbusServer, AnswersLibmodbus) {
    const uint16_t port = freePort();
    LiveRun run(serverProgram(), server(port, kServerChannels));
    ASSERT_TRUE(run.scanUntil([&] { return run.status().state == LinkState::Online; }));
    modbus_t* client = modbus_new_tcp("127.0.0.1", port);
    ASSERT_TRUE(eventually([&] { return modbus_connect(client) == 0; }));
    uint16_t words[4] = {};
    uint8_t bits[4] = {};
    words[0] = 0x4020; // 2.5, the most significant byte first
    ASSERT_EQ(modbus_write_registers(client, 100, 2, words), 2);
    ASSERT_EQ(modbus_write_bit(client, 0, 1), 1);
    EXPECT_TRUE(run.scanUntil([&] { return run.value("Main.in") == "2.5" && run.value("Main.good") == "TRUE"; }))
        << run.value("Main.in");
    EXPECT_TRUE(run.scanUntil([&] { return modbus_read_input_bits(client, 3, 1, bits) == 1 && bits[0] == 1; }));
    ASSERT_EQ(modbus_read_input_registers(client, 10, 2, words), 2);
    EXPECT_EQ(words[0], 2);
    EXPECT_EQ(words[1], 1);
    // What the program sets, nobody else does.
    ASSERT_EQ(modbus_write_register(client, 105, 7), 1);
    EXPECT_TRUE(run.scanUntil([&] { return modbus_read_registers(client, 104, 2, words) == 2 && words[1] == 42; }));
    // Beyond its registers, and a function it does not have.
    EXPECT_EQ(modbus_read_registers(client, 500, 1, words), -1);
    EXPECT_EQ(errno, EMBXILADD);
    EXPECT_EQ(modbus_report_slave_id(client, 4, bits), -1);
    EXPECT_EQ(errno, EMBXILFUN);
    ASSERT_EQ(modbus_read_registers(client, 104, 1, words), 1) << "and it goes on";
    modbus_close(client);
    modbus_free(client);
    EXPECT_GT(run.replaysExactly(), 0u);
}

TEST(ModbusServer, InputsAreLostWhenNobodyWritesForSoLong) {
    const uint16_t port = freePort();
    LiveRun run(serverProgram(), server(port, kServerChannels, "\"timeout\": \"50ms\""));
    ASSERT_TRUE(run.scanUntil([&] { return run.status().state == LinkState::Online; }));
    modbus_t* client = modbus_new_tcp("127.0.0.1", port);
    ASSERT_EQ(modbus_connect(client), 0);
    const uint16_t words[2] = {};
    bool wasGood = false;
    EXPECT_TRUE(run.scanUntil([&] {
        if (!wasGood) (void)modbus_write_registers(client, 100, 2, words);
        wasGood |= run.value("Main.good") == "TRUE";
        return wasGood && run.value("Main.good") == "FALSE";
    }));
    EXPECT_EQ(run.status().state, LinkState::Lost);
    modbus_close(client);
    modbus_free(client);
}

TEST(ModbusServer, APortInUseIsSaidAndTakenWhenItIsFree) {
    const uint16_t port = freePort();
    auto first = std::make_unique<LiveRun>(serverProgram(), server(port, kServerChannels));
    ASSERT_TRUE(first->scanUntil([&] { return first->status().state == LinkState::Online; }));
    LiveRun second(serverProgram(), server(port, kServerChannels));
    EXPECT_TRUE(second.scanUntil([&] { return second.status().state == LinkState::Lost; }));
    EXPECT_NE(second.status().problem.english().find("cannot listen on 127.0.0.1:"), std::string::npos);
    first.reset();
    EXPECT_TRUE(second.scanUntil([&] { return second.status().state == LinkState::Online; }));
}
