#include "projects/devices/configuration/device_check.h"

#include "projects/devices/configuration/errors.h"
#include "projects/devices/configuration/sample.h"
#include "projects/devices/configuration/wire.h"
#include "runtime/base/text.h"

#include <filesystem>
#include <set>

namespace plc::devices {

namespace {

namespace fs = std::filesystem;

bool isName(const std::string& name) {
    if (name.empty() || (name[0] >= '0' && name[0] <= '9')) return false;
    for (size_t at = 0; at < name.size();) {
        const char32_t c = decodeUtf8(name, at);
        if (!isNameLetter(c) && c != U'_' && (c < U'0' || c > U'9')) return false;
    }
    return true;
}

/// Letters, digits, points, hyphens and the colons of IPv6.
bool isHost(const std::string& host) {
    if (host.empty() || host.size() > 253 || host.front() == '.' || host.front() == '-') return false;
    return std::all_of(host.begin(), host.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
               c == ':' || c == '_' || c == '%';
    });
}

class Checker {
public:
    Checker(const DeviceFile& file, const image::Layout* layout, std::string folder)
        : m_file(file), m_layout(layout), m_folder(std::move(folder)), m_findings(file.findings()) {}

    std::vector<Finding> run() {
        const std::vector<Device>& all = m_file.devices();
        for (size_t d = 0; d < all.size(); ++d) {
            checkDevice(d);
            for (size_t other = 0; other < d; ++other) checkPair(other, d);
            for (size_t c = 0; c < all[d].channels.size(); ++c) checkChannel(d, c);
            checkRegisters(d);
        }
        if (m_layout) checkVariablesShared();
        std::stable_sort(m_findings.begin(), m_findings.end(),
                         [](const Finding& a, const Finding& b) { return a.line < b.line; });
        return std::move(m_findings);
    }

private:
    void report(size_t device, std::optional<size_t> channel, std::string_view field, Message message,
                bool isError = true) {
        const Device& d = m_file.devices()[device];
        m_findings.push_back({isError, std::move(message), m_file.lineOf(device, channel, field), d.name,
                              channel ? d.channels[*channel].name : std::string()});
    }

    void checkDevice(size_t d);
    void checkFiles(size_t d);
    void checkPair(size_t a, size_t b);
    void checkChannel(size_t d, size_t c);
    void checkModbus(size_t d, size_t c);
    void checkTopic(size_t d, size_t c);
    void checkVariable(size_t d, size_t c);
    void checkStateVariable(size_t d, std::optional<size_t> c, const std::string& path, const char* field);
    void checkRegisters(size_t d);
    void checkVariablesShared();

    struct Written {
        std::string who;
        std::string path;
        image::Place place;
        uint32_t size;
        size_t device;
        std::optional<size_t> channel;
    };
    const DeviceFile& m_file;
    const image::Layout* m_layout;
    std::string m_folder;
    std::vector<Finding> m_findings;
    std::vector<Written> m_written;
};

void Checker::checkDevice(size_t d) {
    const Device& device = m_file.devices()[d];
    if (!device.name.empty() && !isName(device.name)) report(d, {}, "name", errors::BadName(device.name));
    if (device.protocol == Protocol::ModbusRtu) {
        if (!device.serial.empty() && !device.serial.starts_with('/'))
            report(d, {}, "serial", errors::BadSerial(device.serial));
    } else if (!device.host.empty() && !isHost(device.host)) {
        report(d, {}, "host", errors::BadHost(device.host));
    }
    if (device.protocol == Protocol::ModbusServer && device.port < 1024)
        report(d, {}, "port", errors::PortReserved(), false);
    if (device.channels.empty()) report(d, {}, {}, errors::NoChannels(device.name), false);
    checkFiles(d);
    if (m_layout && !device.online.empty()) checkStateVariable(d, {}, device.online, "online");
    std::set<std::string> names;
    for (size_t c = 0; c < device.channels.size(); ++c) {
        const std::string& name = device.channels[c].name;
        if (!name.empty() && !names.insert(foldCase(name)).second)
            report(d, c, "name", errors::ChannelTwice(device.name, name));
    }
}

void Checker::checkFiles(size_t d) {
    const Device& device = m_file.devices()[d];
    const auto isThere = [&](const std::string& file) {
        std::error_code ignored;
        return file.empty() || fs::is_regular_file(fs::path(m_folder) / file, ignored);
    };
    if (!isThere(device.passwordFile)) report(d, {}, "passwordFile", errors::NoPasswordFile(device.passwordFile));
    if (!isThere(device.caFile)) report(d, {}, "caFile", errors::NoCaFile(device.caFile));
}

void Checker::checkPair(size_t first, size_t second) {
    const Device& a = m_file.devices()[first];
    const Device& b = m_file.devices()[second];
    if (!a.name.empty() && equalsIgnoringCase(a.name, b.name)) report(second, {}, "name", errors::DeviceTwice(b.name));
    if (a.protocol != b.protocol || !a.isEnabled || !b.isEnabled) return;
    if (a.protocol == Protocol::ModbusServer && a.port == b.port && a.host == b.host)
        report(second, {}, "port", errors::PortTwice(a.name, b.name, b.port));
    // Allowed, but as often a copy whose address was not changed.
    if (a.protocol == Protocol::ModbusTcp && a.host == b.host && a.port == b.port && a.unit == b.unit)
        report(second, {}, "unit", errors::SameStation(a.name, b.name, b.unit, b.host), false);
    if (a.protocol != Protocol::ModbusRtu || a.serial != b.serial || a.serial.empty()) return;
    if (a.unit == b.unit) report(second, {}, "unit", errors::UnitTwice(a.name, b.name, b.unit, b.serial));
    if (a.baud != b.baud || a.parity != b.parity || a.dataBits != b.dataBits || a.stopBits != b.stopBits)
        report(second, {}, "serial", errors::BusDiffers(a.name, b.name, b.serial));
}

void Checker::checkChannel(size_t d, size_t c) {
    const Device& device = m_file.devices()[d];
    const Channel& channel = device.channels[c];
    if (!channel.name.empty() && !isName(channel.name)) report(d, c, "name", errors::BadName(channel.name));
    if (device.isModbus())
        checkModbus(d, c);
    else
        checkTopic(d, c);
    if (channel.scale == 0) report(d, c, "scale", errors::ScaleIsZero());
    if ((channel.type == WireType::Bool || channel.type == WireType::Text) &&
        (channel.scale != 1 || channel.offset != 0))
        report(d, c, channel.scale != 1 ? "scale" : "offset", errors::ScaleOfBool(spelling(channel.type)));
    if (channel.onLoss == OnLoss::Safe && !channel.safe) report(d, c, "onLoss", errors::SafeMissing());
    if (channel.variable.empty())
        report(d, c, "variable", errors::NeedsAddress(channel.name));
    else if (m_layout)
        checkVariable(d, c);
    if (m_layout && !channel.quality.empty()) checkStateVariable(d, c, channel.quality, "quality");
}

void Checker::checkModbus(size_t d, size_t c) {
    const Device& device = m_file.devices()[d];
    const Channel& channel = device.channels[c];
    const bool isServer = device.protocol == Protocol::ModbusServer;
    const bool isReadOnly = channel.table == Table::Discrete || channel.table == Table::Input;
    if (isReadOnly && isServer && channel.direction == Direction::In)
        report(d, c, "table", errors::ServerTableIsOutput(spelling(channel.table)));
    if (isReadOnly && !isServer && channel.direction == Direction::Out)
        report(d, c, "table", errors::TableIsReadOnly(spelling(channel.table)));
    if (channel.type == WireType::Text) report(d, c, "type", errors::TextNeedsTopic());
    if (isBitTable(channel.table) && channel.type != WireType::Bool)
        report(d, c, "type", errors::BitTableNeedsBool(spelling(channel.table)));
    if (!isBitTable(channel.table) && channel.type == WireType::Bool && channel.bit < 0)
        report(d, c, "type", errors::BoolNeedsBit());
    if (channel.bit >= 0 && (channel.type != WireType::Bool || isBitTable(channel.table)))
        report(d, c, "bit", errors::BitNeedsBool());
    if (channel.address + channel.registers() > 65536)
        report(d, c, "address", errors::PastLastRegister(spelling(channel.type), channel.registers(), channel.address));
}

void Checker::checkTopic(size_t d, size_t c) {
    const Channel& channel = m_file.devices()[d].channels[c];
    if (channel.topic.empty())
        report(d, c, {}, errors::NoTopic());
    else if (channel.topic.find_first_of("+#") != std::string::npos)
        report(d, c, "topic", errors::WildcardTopic(channel.topic));
    if (!isJsonPath(channel.jsonPath)) report(d, c, "json", errors::BadJsonPath(channel.jsonPath));
}

void Checker::checkVariable(size_t d, size_t c) {
    const Device& device = m_file.devices()[d];
    const Channel& channel = device.channels[c];
    const Result<Target> target = resolve(*m_layout, channel.variable, channel.type);
    if (!target) {
        const bool isType = target.error().place == channel.variable;
        report(d, c, "variable",
               isType ? target.error().message : errors::NoVariableNamed(channel.variable, target.error().message));
        return;
    }
    if (!canCarry(channel, *target))
        report(d, c, "variable", errors::WrongType(channel.variable, target->typeName, spelling(channel.type)));
    else if (mayNotFit(channel, *target))
        report(d, c, "variable", errors::MayNotFit(spelling(channel.type), channel.variable, target->typeName), false);
    const auto isIn = [&](const image::AreaRange& area) {
        return target->place.offset >= area.begin && target->place.offset < area.begin + area.size;
    };
    if (channel.direction == Direction::In && isIn(m_layout->outputs))
        report(d, c, "variable", errors::InputIntoOutput(channel.variable));
    if (channel.direction == Direction::Out && isIn(m_layout->inputs))
        report(d, c, "variable", errors::OutputFromInput(channel.variable));
    if (channel.direction == Direction::Out) return;
    for (const image::Root& root : m_layout->roots)
        if (root.constant && root.offset == target->place.offset && root.bit == target->place.bit)
            report(d, c, "variable", errors::IsConstant(channel.variable));
    m_written.push_back({device.name + "." + channel.name, channel.variable, target->place, target->size, d, c});
}

/// A quality or an online variable.
void Checker::checkStateVariable(size_t d, std::optional<size_t> c, const std::string& path, const char* field) {
    const Device& device = m_file.devices()[d];
    const Result<Target> target = resolve(*m_layout, path, WireType::Bool);
    if (!target) {
        report(d, c, field,
               target.error().place == path ? target.error().message
                                            : errors::NoVariableNamed(path, target.error().message));
        return;
    }
    if (c && target->family != types::Family::Bool && !types::isInteger(target->family))
        report(d, c, field, errors::QualityNeedsBool(path));
    if (!c && target->family != types::Family::Bool) report(d, c, field, errors::OnlineNeedsBool(path));
    m_written.push_back({device.name + "." + (c ? device.channels[*c].name + " (quality)" : "(online)"), path,
                         target->place, target->size, d, c});
}

/// Two channels that set one register; of a server, also one that sets what the other lets clients set.
void Checker::checkRegisters(size_t d) {
    const Device& device = m_file.devices()[d];
    if (!device.isModbus()) return;
    std::map<std::tuple<Table, uint32_t, int>, size_t> seen;
    for (size_t c = 0; c < device.channels.size(); ++c) {
        const Channel& channel = device.channels[c];
        if (channel.direction == Direction::In && device.protocol != Protocol::ModbusServer) continue;
        for (uint32_t i = 0; i < channel.registers(); ++i)
            for (int bit = channel.bit >= 0 ? channel.bit : 0; bit <= (channel.bit >= 0 ? channel.bit : 15); ++bit) {
                const auto [it, isNew] = seen.emplace(std::tuple(channel.table, channel.address + i, bit), c);
                const Channel& other = device.channels[it->second];
                if (isNew || it->second == c) continue;
                if (other.direction == Direction::In && channel.direction == Direction::In) continue;
                report(d, c, "address",
                       errors::RegisterShared(other.name, channel.name, spelling(channel.table), channel.address + i));
                i = channel.registers();
                break;
            }
    }
}

void Checker::checkVariablesShared() {
    std::sort(m_written.begin(), m_written.end(), [](const Written& a, const Written& b) {
        return std::tuple(a.place.offset, a.place.bit, a.device, a.channel) <
               std::tuple(b.place.offset, b.place.bit, b.device, b.channel);
    });
    for (size_t i = 1; i < m_written.size(); ++i) {
        for (size_t before = i; before-- > 0;) {
            const Written& a = m_written[before];
            const Written& b = m_written[i];
            if (a.place.offset + 300 < b.place.offset) break; // no variable of a channel is longer
            if (a.place.offset + a.size <= b.place.offset) continue;
            if (a.place.bit >= 0 && b.place.bit >= 0 && a.place.bit != b.place.bit) continue;
            report(b.device, b.channel, "variable", errors::VariableShared(a.who, b.who, b.path));
            break;
        }
    }
}

} // namespace

std::vector<Finding> checkDevices(const DeviceFile& file, const image::Layout* layout,
                                  const std::string& projectFolder) {
    return Checker(file, layout, projectFolder).run();
}

bool hasErrors(const std::vector<Finding>& findings) {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) { return finding.isError; });
}

} // namespace plc::devices
