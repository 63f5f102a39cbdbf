// What devices.json says: devices, and the channels that map their registers or topics to variables. Values without
// behaviour; whoever read them owns them, any thread may have a copy.
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plc::devices {

using Milliseconds = std::chrono::milliseconds;

enum class Protocol : uint8_t {
#define PLC_PROTOCOL(Name, Spelling) Name,
#include "projects/devices/configuration/words.def"
};
enum class Table : uint8_t {
#define PLC_TABLE(Name, Spelling) Name,
#include "projects/devices/configuration/words.def"
};
enum class WireType : uint8_t {
#define PLC_WIRE_TYPE(Name, Spelling, Registers) Name,
#include "projects/devices/configuration/words.def"
};
/// How the bytes of a number lie in its registers; ABCD is the most significant first.
enum class Order : uint8_t {
#define PLC_ORDER(Name, Spelling) Name,
#include "projects/devices/configuration/words.def"
};
/// What the variable of an input holds while the channel is not good.
enum class OnLoss : uint8_t {
#define PLC_ON_LOSS(Name, Spelling) Name,
#include "projects/devices/configuration/words.def"
};
enum class Parity : uint8_t {
#define PLC_PARITY(Name, Spelling) Name,
#include "projects/devices/configuration/words.def"
};
/// As the program sees it: In comes from the device, Out goes to it.
enum class Direction : uint8_t {
#define PLC_DIRECTION(Name, Spelling) Name,
#include "projects/devices/configuration/words.def"
};

[[nodiscard]] std::string_view spelling(Protocol protocol);
[[nodiscard]] std::string_view spelling(Table table);
[[nodiscard]] std::string_view spelling(WireType type);
[[nodiscard]] std::string_view spelling(Order order);
[[nodiscard]] std::string_view spelling(OnLoss onLoss);
[[nodiscard]] std::string_view spelling(Parity parity);
[[nodiscard]] std::string_view spelling(Direction direction);
/// How many registers hold it; 0: only a topic can.
[[nodiscard]] unsigned registersOf(WireType type);
[[nodiscard]] inline bool isBitTable(Table table) { return table == Table::Coil || table == Table::Discrete; }

struct Channel {
    std::string name;
    std::string variable; // "%IW4", "Main.Level"
    Direction direction = Direction::In;
    // Modbus
    Table table = Table::Holding;
    uint32_t address = 0; // of the table, from 0
    int bit = -1;         // of a register, for BOOL
    WireType type = WireType::Int;
    Order order = Order::Abcd;
    double scale = 1, offset = 0; // variable = number of the device × scale + offset
    Milliseconds poll{0};         // 0: the device's
    // MQTT
    std::string topic, jsonPath; // JSON pointer into the message; empty: the whole message
    int qos = 0;
    bool retain = false;
    // when it fails
    OnLoss onLoss = OnLoss::Last;
    std::optional<double> safe; // In: while not good; Out: when the PLC stops, faults or lets go of the device
    std::string quality;        // variable that says whether the channel is good; may be empty

    [[nodiscard]] unsigned registers() const { return isBitTable(table) ? 1 : registersOf(type); }
    bool operator==(const Channel&) const = default;
};

struct Device {
    std::string name;
    Protocol protocol = Protocol::ModbusTcp;
    bool isEnabled = true;
    std::string host; // a server: the address to listen at
    uint16_t port = 0;
    std::string serial; // "/dev/ttyUSB0"
    uint32_t baud = 19200;
    Parity parity = Parity::Even;
    int dataBits = 8, stopBits = 1;
    int unit = 1;
    Milliseconds poll{100};
    Milliseconds timeout{
        500}; // of an answer; of a server: without a request for so long its inputs are lost, 0 = never
    Milliseconds retry{5'000}; // longest pause between attempts to connect
    std::string clientId, user, passwordFile, caFile;
    bool tls = false;
    std::string online; // BOOL variable: the device answers; may be empty
    std::vector<Channel> channels;

    [[nodiscard]] bool isModbus() const { return protocol != Protocol::Mqtt; }
    bool operator==(const Device&) const = default;
};

/// Why a channel is good or not; an integer variable named as its quality holds the number, a BOOL whether it is Good.
enum class Quality : uint8_t {
    Good = 0,
    Waiting = 1, // nothing came yet, or the devices are not connected
    Lost = 2,    // the device does not answer
    Refused = 3, // the device answers that it has no such register or topic
    Unfit = 4,   // what came cannot be read or does not fit into the variable
};

} // namespace plc::devices
