// devices.json: read into devices and findings, edited as the JSON it is, so that fields we do not know and their order
// stay, and written in one form. Values; any thread.
#pragma once
#include "projects/devices/configuration/device.h"
#include "projects/devices/configuration/finding.h"
#include "runtime/base/result.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace plc::devices {

class DeviceFile {
public:
    DeviceFile();
    /// What cannot be read is a finding; the rest is there all the same.
    [[nodiscard]] static DeviceFile parse(std::string_view text);
    [[nodiscard]] static std::string pathIn(const std::string& projectFolder);
    /// Without the file: no devices.
    [[nodiscard]] static Result<DeviceFile> load(const std::string& projectFolder);
    Result<void> save(const std::string& projectFolder) const;

    [[nodiscard]] const std::vector<Device>& devices() const { return m_devices; }
    [[nodiscard]] const std::vector<Finding>& findings() const { return m_findings; }
    [[nodiscard]] bool isEmpty() const { return m_devices.empty() && m_findings.empty(); }
    [[nodiscard]] std::string text() const;
    /// The line of a device, of one of its channels, or of a field of either; as read.
    [[nodiscard]] int lineOf(size_t device, std::optional<size_t> channel = {}, std::string_view field = {}) const;

    /// A field as a person writes it; "" when it is not there.
    [[nodiscard]] std::string field(size_t device, std::optional<size_t> channel, const std::string& name) const;

    // Edits; the devices are read again from the result.
    void addDevice(Protocol protocol, const std::string& name);
    void removeDevice(size_t device);
    void addChannel(size_t device, const std::string& name);
    void removeChannel(size_t device, size_t channel);
    /// `value` as a person writes it: a number where the field is one, else a text; empty removes the field.
    void setField(size_t device, std::optional<size_t> channel, const std::string& field, const std::string& value);

private:
    using Json = nlohmann::ordered_json;
    void readDevices(const std::map<std::string, int>& lines);
    void readAgain();
    [[nodiscard]] Json* channelsOf(size_t device);
    Json m_json;
    bool m_isGood = true;
    std::vector<Device> m_devices;
    std::vector<Finding> m_findings;
    std::vector<size_t> m_deviceIndex;               // of m_devices in the list of the file
    std::vector<std::vector<size_t>> m_channelIndex; // of their channels
    std::map<std::string, int> m_lines;
};

} // namespace plc::devices
