#include "app/cli/devices/device_output.h"

#include "app/cli/kit/command.h"
#include "app/cli/kit/errors.h"

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

namespace plc::cli {

namespace {

using devices::LinkState;
using devices::Quality;

const char* nameOf(LinkState state) {
    switch (state) {
    case LinkState::Off:
        return "off";
    case LinkState::Connecting:
        return "connecting";
    case LinkState::Online:
        return "online";
    case LinkState::Lost:
        return "lost";
    }
    return "";
}

const char* nameOf(Quality quality) {
    switch (quality) {
    case Quality::Good:
        return "good";
    case Quality::Waiting:
        return "waiting";
    case Quality::Lost:
        return "lost";
    case Quality::Refused:
        return "refused";
    case Quality::Unfit:
        return "unfit";
    }
    return "";
}

std::string milliseconds(double nanoseconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f ms", nanoseconds / 1e6);
    return text;
}

std::string cell(std::string text, size_t width) {
    if (text.size() < width) text.resize(width, ' ');
    return text + " ";
}

} // namespace

Result<std::vector<devices::Finding>> findDeviceProblems(const projects::Project& project,
                                                         const image::Layout* layout) {
    const auto file = devices::DeviceFile::load(project.folder);
    if (!file) return file.error();
    return devices::checkDevices(*file, layout, project.folder);
}

void printFindings(const std::vector<devices::Finding>& findings, std::ostream& out) {
    for (const devices::Finding& finding : findings) out << finding.english("devices.json") << "\n";
}

std::string renderJson(const devices::Finding& finding) {
    nlohmann::ordered_json object = {
        {"file", "devices.json"},   {"line", finding.line},       {"severity", finding.isError ? "error" : "warning"},
        {"device", finding.device}, {"channel", finding.channel}, {"message", finding.message.english()}};
    return object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string statusText(const std::vector<devices::DeviceStatus>& all) {
    std::string out;
    for (const devices::DeviceStatus& device : all) {
        const devices::Figures& f = device.figures;
        out += device.name + " (" + std::string(devices::spelling(device.protocol)) + "): " + nameOf(device.state);
        if (!device.problem.isEmpty()) out += ", " + device.problem.english();
        out += "\n  " + std::to_string(f.requests) + " requests, " + std::to_string(f.errors) + " errors, " +
               std::to_string(f.connects) + " connections, " + std::to_string(f.bytesIn) + " bytes in, " +
               std::to_string(f.bytesOut) + " out, latency " + milliseconds(f.meanLatencyNs) + ", at most " +
               milliseconds(static_cast<double>(f.worstLatencyNs)) + "\n";
        for (const devices::ChannelStatus& channel : device.channels)
            out += "  " + cell(channel.name, 20) + cell(channel.variable, 20) +
                   cell(channel.direction == devices::Direction::In ? "<-" : "->", 2) +
                   cell(nameOf(channel.quality), 8) + channel.value + "\n";
    }
    return out;
}

std::string statusJson(const std::vector<devices::DeviceStatus>& all) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const devices::DeviceStatus& device : all) {
        Json channels = Json::array();
        for (const devices::ChannelStatus& channel : device.channels)
            channels.push_back({{"name", channel.name},
                                {"variable", channel.variable},
                                {"direction", std::string(devices::spelling(channel.direction))},
                                {"quality", nameOf(channel.quality)},
                                {"value", channel.value}});
        const devices::Figures& f = device.figures;
        list.push_back({{"name", device.name},
                        {"protocol", std::string(devices::spelling(device.protocol))},
                        {"state", nameOf(device.state)},
                        {"problem", device.problem.english()},
                        {"requests", f.requests},
                        {"errors", f.errors},
                        {"connections", f.connects},
                        {"bytes_in", f.bytesIn},
                        {"bytes_out", f.bytesOut},
                        {"latency_ms", f.meanLatencyNs / 1e6},
                        {"latency_most_ms", static_cast<double>(f.worstLatencyNs) / 1e6},
                        {"channels", std::move(channels)}});
    }
    return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<std::unique_ptr<devices::Engine>> makeEngine(const projects::Project& project, const image::Layout* layout) {
    const auto file = devices::DeviceFile::load(project.folder);
    if (!file) return file.error();
    const std::vector<devices::Finding> findings = devices::checkDevices(*file, layout, project.folder);
    printFindings(findings, std::cerr);
    if (devices::hasErrors(findings))
        return Error{errors::DevicesHaveErrors(), devices::DeviceFile::pathIn(project.folder)};
    if (file->devices().empty()) return Error{errors::NoDevices(), project.name};
    return std::make_unique<devices::Engine>(file->devices(), project.folder);
}

} // namespace plc::cli
