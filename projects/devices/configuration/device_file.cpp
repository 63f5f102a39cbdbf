#include "projects/devices/configuration/device_file.h"

#include "projects/devices/configuration/errors.h"
#include "projects/devices/configuration/fields.h"
#include "projects/devices/configuration/json_lines.h"
#include "projects/storage/project_file.h"
#include "runtime/base/read_json.h"
#include "runtime/base/text.h"

#include <filesystem>

namespace plc::devices {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::pair<Protocol, const char*> kProtocols[] = {
#define PLC_PROTOCOL(Name, Spelling) {Protocol::Name, Spelling},
#include "projects/devices/configuration/words.def"
};
constexpr std::pair<Table, const char*> kTables[] = {
#define PLC_TABLE(Name, Spelling) {Table::Name, Spelling},
#include "projects/devices/configuration/words.def"
};
constexpr std::pair<WireType, const char*> kTypes[] = {
#define PLC_WIRE_TYPE(Name, Spelling, Registers) {WireType::Name, Spelling},
#include "projects/devices/configuration/words.def"
};
constexpr std::pair<Order, const char*> kOrders[] = {
#define PLC_ORDER(Name, Spelling) {Order::Name, Spelling},
#include "projects/devices/configuration/words.def"
};
constexpr std::pair<OnLoss, const char*> kOnLoss[] = {
#define PLC_ON_LOSS(Name, Spelling) {OnLoss::Name, Spelling},
#include "projects/devices/configuration/words.def"
};
constexpr std::pair<Parity, const char*> kParities[] = {
#define PLC_PARITY(Name, Spelling) {Parity::Name, Spelling},
#include "projects/devices/configuration/words.def"
};
constexpr std::pair<Direction, const char*> kDirections[] = {
#define PLC_DIRECTION(Name, Spelling) {Direction::Name, Spelling},
#include "projects/devices/configuration/words.def"
};

/// Where nobody said it: what the place or the table leaves open.
Direction usualDirection(Protocol protocol, const Channel& channel) {
    if (channel.variable.starts_with("%Q") || channel.variable.starts_with("%q")) return Direction::Out;
    if (channel.variable.starts_with("%I") || channel.variable.starts_with("%i")) return Direction::In;
    const bool isReadOnly = channel.table == Table::Discrete || channel.table == Table::Input;
    return protocol == Protocol::ModbusServer && isReadOnly ? Direction::Out : Direction::In;
}

void readModbusPart(Fields& fields, Channel& channel) {
    fields.word<Table>("table", channel.table, kTables);
    fields.whole("address", channel.address, 0, 65535, true);
    fields.whole("bit", channel.bit, 0, 15);
    if (isBitTable(channel.table)) channel.type = WireType::Bool;
    fields.word<Order>("order", channel.order, kOrders);
}

Channel readChannel(Fields& fields, const Device& device, const std::string& name) {
    Channel channel;
    channel.name = name;
    fields.known("name");
    fields.text("variable", channel.variable);
    if (device.isModbus()) {
        readModbusPart(fields, channel);
    } else {
        channel.type = WireType::Lreal;
        fields.text("topic", channel.topic);
        fields.text("json", channel.jsonPath);
        fields.whole("qos", channel.qos, 0, 2);
        fields.flag("retain", channel.retain);
    }
    fields.word<WireType>("type", channel.type, kTypes);
    channel.direction = usualDirection(device.protocol, channel);
    fields.word<Direction>("direction", channel.direction, kDirections);
    fields.real("scale", channel.scale);
    fields.real("offset", channel.offset);
    fields.duration("poll", channel.poll, 1);
    fields.word<OnLoss>("onLoss", channel.onLoss, kOnLoss);
    fields.real("safe", channel.safe);
    fields.text("quality", channel.quality);
    fields.known("comment");
    fields.reportUnknown();
    return channel;
}

void readTcp(Fields& fields, Device& device) {
    fields.text("host", device.host, device.protocol != Protocol::ModbusServer);
    fields.whole("port", device.port, 1, 65535);
}

void readSerial(Fields& fields, Device& device) {
    fields.text("serial", device.serial, true);
    fields.whole("baud", device.baud, 300, 4'000'000);
    fields.word<Parity>("parity", device.parity, kParities);
    fields.whole("dataBits", device.dataBits, 7, 8);
    fields.whole("stopBits", device.stopBits, 1, 2);
}

void readMqtt(Fields& fields, Device& device) {
    fields.text("clientId", device.clientId);
    fields.text("user", device.user);
    fields.text("passwordFile", device.passwordFile);
    fields.flag("tls", device.tls);
    fields.text("caFile", device.caFile);
}

void setDefaults(Device& device) {
    switch (device.protocol) {
    case Protocol::ModbusTcp:
        device.port = 502;
        return;
    case Protocol::ModbusRtu:
        return;
    case Protocol::ModbusServer:
        device.host = "127.0.0.1";
        device.port = 1502;
        device.timeout = Milliseconds(0);
        return;
    case Protocol::Mqtt:
        device.port = 1883;
        device.timeout = Milliseconds(5000);
        return;
    }
}

Device readDevice(Fields& fields, const std::string& name) {
    Device device;
    device.name = name;
    fields.known("name");
    if (!fields.has("protocol")) fields.needed("protocol");
    fields.word<Protocol>("protocol", device.protocol, kProtocols);
    setDefaults(device);
    fields.flag("enabled", device.isEnabled);
    if (device.protocol == Protocol::ModbusRtu)
        readSerial(fields, device);
    else
        readTcp(fields, device);
    if (device.protocol == Protocol::Mqtt)
        readMqtt(fields, device);
    else
        fields.whole("unit", device.unit, 0, 255);
    if (device.tls && !fields.has("port")) device.port = 8883;
    fields.duration("poll", device.poll, 1);
    fields.duration("timeout", device.timeout, device.protocol == Protocol::ModbusServer ? 0 : 10);
    fields.duration("retry", device.retry, 100);
    fields.text("online", device.online);
    fields.known("comment");
    fields.known("channels");
    fields.reportUnknown();
    return device;
}

std::string nameOf(const Json& object) {
    const auto it = object.find("name");
    return it != object.end() && it->is_string() ? it->get<std::string>() : std::string();
}

} // namespace

std::string Finding::english(const std::string& file) const {
    std::string out = file;
    if (line > 0) out += ":" + std::to_string(line);
    out += isError ? ": error: " : ": warning: ";
    if (!device.empty()) out += device + (channel.empty() ? "" : "." + channel) + ": ";
    return out + message.english();
}

DeviceFile::DeviceFile() : m_json(Json::object({{"devices", Json::array()}})) {}

DeviceFile DeviceFile::parse(std::string_view text) {
    DeviceFile file;
    JsonText<Json> json = readJson<Json>(text);
    if (!json.isGood()) {
        file.m_isGood = false;
        file.m_findings.push_back({true, errors::NotJson(), std::max(1, json.line), {}, {}});
        return file;
    }
    file.m_json = std::move(json.value);
    file.m_lines = linesOfJson(text);
    file.readDevices(file.m_lines);
    return file;
}

void DeviceFile::readDevices(const std::map<std::string, int>& lines) {
    m_devices.clear();
    m_deviceIndex.clear();
    m_channelIndex.clear();
    if (!m_json.is_object() || !m_json.contains("devices") || !m_json["devices"].is_array()) {
        m_isGood = false;
        m_findings.push_back({true, errors::NotDevices(), 1, {}, {}});
        return;
    }
    const Json& list = m_json["devices"];
    for (size_t d = 0; d < list.size(); ++d) {
        const std::string path = "/devices/" + std::to_string(d);
        const std::string name = list[d].is_object() ? nameOf(list[d]) : std::string();
        Fields fields(list[d], {path, name, {}}, lines, m_findings);
        if (!list[d].is_object()) {
            fields.report(errors::NotObject(Verbatim("devices")));
            continue;
        }
        if (name.empty()) fields.needed("name");
        Device device = readDevice(fields, name);
        std::vector<size_t> indexes;
        const auto channels = list[d].find("channels");
        if (channels != list[d].end() && !channels->is_array())
            fields.report(errors::NotObject(Verbatim("channels")), "channels");
        for (size_t c = 0; channels != list[d].end() && channels->is_array() && c < channels->size(); ++c) {
            const Json& object = (*channels)[c];
            const std::string channelName = object.is_object() ? nameOf(object) : std::string();
            Fields inner(object, {path + "/channels/" + std::to_string(c), name, channelName}, lines, m_findings);
            if (!object.is_object()) {
                inner.report(errors::NotObject(Verbatim("channels")));
                continue;
            }
            if (channelName.empty()) inner.needed("name");
            device.channels.push_back(readChannel(inner, device, channelName));
            indexes.push_back(c);
        }
        m_devices.push_back(std::move(device));
        m_deviceIndex.push_back(d);
        m_channelIndex.push_back(std::move(indexes));
    }
}

std::string DeviceFile::pathIn(const std::string& projectFolder) {
    return (fs::path(projectFolder) / "devices.json").string();
}

Result<DeviceFile> DeviceFile::load(const std::string& projectFolder) {
    const std::string path = pathIn(projectFolder);
    std::error_code ignored;
    if (projectFolder.empty() || !fs::exists(path, ignored)) return DeviceFile();
    const Result<std::string> text = projects::readFile(path);
    if (!text) return text.error();
    return parse(*text);
}

Result<void> DeviceFile::save(const std::string& projectFolder) const {
    return projects::writeFileAtomically(pathIn(projectFolder), text());
}

std::string DeviceFile::text() const { return m_json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

int DeviceFile::lineOf(size_t device, std::optional<size_t> channel, std::string_view field) const {
    if (device >= m_devices.size()) return 0;
    std::string path = "/devices/" + std::to_string(m_deviceIndex[device]);
    if (channel && *channel < m_channelIndex[device].size())
        path += "/channels/" + std::to_string(m_channelIndex[device][*channel]);
    auto line = m_lines.find(field.empty() ? path : path + "/" + std::string(field));
    if (line == m_lines.end()) line = m_lines.find(path);
    return line == m_lines.end() ? 0 : line->second;
}

std::string DeviceFile::field(size_t device, std::optional<size_t> channel, const std::string& name) const {
    if (!m_isGood || device >= m_devices.size()) return {};
    const Json* object = &m_json["devices"][m_deviceIndex[device]];
    if (channel && *channel >= m_channelIndex[device].size()) return {};
    if (channel) object = &(*object)["channels"][m_channelIndex[device][*channel]];
    const auto it = object->find(name);
    if (it == object->end()) return {};
    return it->is_string() ? it->get<std::string>() : it->dump(-1, ' ', false, Json::error_handler_t::replace);
}

// ---------------------------------------------------------------- edits

void DeviceFile::readAgain() { *this = parse(text()); }

nlohmann::ordered_json* DeviceFile::channelsOf(size_t device) {
    if (!m_isGood || device >= m_devices.size()) return nullptr;
    Json& object = m_json["devices"][m_deviceIndex[device]];
    if (!object.contains("channels")) object["channels"] = Json::array();
    return object["channels"].is_array() ? &object["channels"] : nullptr;
}

void DeviceFile::addDevice(Protocol protocol, const std::string& name) {
    if (!m_isGood) return;
    Json device = {{"name", name}, {"protocol", std::string(spelling(protocol))}};
    switch (protocol) {
    case Protocol::ModbusTcp:
        device["host"] = "127.0.0.1";
        device["port"] = 502;
        break;
    case Protocol::ModbusRtu:
        device["serial"] = "/dev/ttyUSB0";
        break;
    case Protocol::ModbusServer:
        device["port"] = 1502;
        break;
    case Protocol::Mqtt:
        device["host"] = "127.0.0.1";
        break;
    }
    device["channels"] = Json::array();
    m_json["devices"].push_back(std::move(device));
    readAgain();
}

void DeviceFile::removeDevice(size_t device) {
    if (!m_isGood || device >= m_devices.size()) return;
    m_json["devices"].erase(m_deviceIndex[device]);
    readAgain();
}

void DeviceFile::addChannel(size_t device, const std::string& name) {
    Json* list = channelsOf(device);
    if (!list) return;
    Json channel = {{"name", name}, {"variable", ""}};
    if (!m_devices[device].isModbus()) {
        channel["topic"] = name;
    } else { // behind the last one
        uint32_t next = 0;
        Table table = Table::Holding;
        for (const Channel& each : m_devices[device].channels) {
            next = std::min<uint32_t>(65535, each.address + each.registers());
            table = each.table;
        }
        channel["table"] = std::string(spelling(table));
        channel["address"] = next;
    }
    list->push_back(std::move(channel));
    readAgain();
}

void DeviceFile::removeChannel(size_t device, size_t channel) {
    Json* list = channelsOf(device);
    if (!list || channel >= m_channelIndex[device].size()) return;
    list->erase(m_channelIndex[device][channel]);
    readAgain();
}

namespace {

constexpr const char* kNumbers[] = {"port", "unit",  "baud",   "dataBits", "stopBits", "address",
                                    "bit",  "scale", "offset", "safe",     "qos"};
constexpr const char* kFlags[] = {"enabled", "tls", "retain"};

template <size_t Count> bool isOneOf(const std::string& field, const char* const (&list)[Count]) {
    return std::any_of(std::begin(list), std::end(list), [&](const char* each) { return field == each; });
}

/// A number or flag that does not read as one stays a text, which the findings then name.
Json valueOf(const std::string& field, const std::string& value) {
    if (isOneOf(field, kFlags) && equalsIgnoringCase(value, "true")) return true;
    if (isOneOf(field, kFlags) && equalsIgnoringCase(value, "false")) return false;
    if (!isOneOf(field, kNumbers)) return value;
    const JsonText<Json> number = readJson<Json>(value);
    return number.isGood() && (number.value.is_number() || number.value.is_boolean()) ? number.value : Json(value);
}

} // namespace

void DeviceFile::setField(size_t device, std::optional<size_t> channel, const std::string& field,
                          const std::string& value) {
    if (!m_isGood || device >= m_devices.size()) return;
    Json* object = &m_json["devices"][m_deviceIndex[device]];
    if (channel) {
        if (*channel >= m_channelIndex[device].size()) return;
        object = &(*object)["channels"][m_channelIndex[device][*channel]];
    }
    if (value.empty() && field != "name" && field != "variable")
        object->erase(field);
    else
        (*object)[field] = valueOf(field, value);
    readAgain();
}

} // namespace plc::devices
