// stepwise devices: what devices.json says, what is wrong with it, addresses for channels without one, and how the
// devices do when they are connected for a while (inputs only: nothing is sent to them without a running program).
#include "app/cli/devices/commands.h"

#include "app/cli/devices/device_output.h"
#include "app/cli/kit/errors.h"
#include "projects/devices/configuration/proposal.h"

#include <iostream>

namespace plc::cli {

namespace {

std::string placeOf(const devices::Device& device) {
    switch (device.protocol) {
    case devices::Protocol::ModbusRtu:
        return device.serial + ", " + std::to_string(device.baud) + " baud, unit " + std::to_string(device.unit);
    case devices::Protocol::ModbusTcp:
        return device.host + ":" + std::to_string(device.port) + ", unit " + std::to_string(device.unit);
    case devices::Protocol::ModbusServer:
    case devices::Protocol::Mqtt:
        return device.host + ":" + std::to_string(device.port);
    }
    return {};
}

std::string wordsOf(const devices::Device& device, const devices::Channel& channel) {
    std::string out = channel.direction == devices::Direction::In ? "<- " : "-> ";
    if (!device.isModbus()) return out + channel.topic + channel.jsonPath;
    out += std::string(devices::spelling(channel.table)) + " " + std::to_string(channel.address);
    if (channel.bit >= 0) out += "." + std::to_string(channel.bit);
    return out + " " + std::string(devices::spelling(channel.type));
}

void list(const devices::DeviceFile& file) {
    for (const devices::Device& device : file.devices()) {
        std::cout << device.name << " (" << devices::spelling(device.protocol) << "): " << placeOf(device)
                  << (device.isEnabled ? "" : ", not enabled") << "\n";
        for (const devices::Channel& channel : device.channels)
            std::cout << "  " << channel.name << ": " << (channel.variable.empty() ? "no variable" : channel.variable)
                      << " " << wordsOf(device, channel) << "\n";
    }
}

int propose(const projects::Project& project, devices::DeviceFile& file, const image::Layout* layout, bool writes) {
    const std::vector<devices::Proposal> proposals = devices::proposeAddresses(file, layout);
    if (proposals.empty()) {
        std::cout << project.name << ": every channel has a variable\n";
        return kGood;
    }
    std::cout << devices::declarationsOf(proposals);
    if (!writes) return kGood;
    for (const devices::Proposal& proposal : proposals)
        file.setField(proposal.device, proposal.channel, "variable", proposal.address);
    if (auto saved = file.save(project.folder); !saved) return wrongUse(saved.error());
    std::cout << "written to " << devices::DeviceFile::pathIn(project.folder) << "\n";
    return kGood;
}

int connectFor(const projects::Project& project, const devices::DeviceFile& file, const Arguments& arguments) {
    const auto time = parseDuration(*arguments.value("--live"));
    if (!time) return wrongUse(time.error());
    catchInterrupt();
    devices::Engine engine(file.devices(), project.folder);
    engine.connect();
    const auto end = std::chrono::steady_clock::now() + *time;
    while (!isInterrupted() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::vector<devices::DeviceStatus> status = engine.status();
    std::cout << (arguments.wantsJson() ? statusJson(status) + "\n" : statusText(status));
    for (const devices::DeviceStatus& device : status)
        if (device.state != devices::LinkState::Online) return kProgramWrong;
    return kGood;
}

int runDevices(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::DevicesNeedProject(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    auto file = devices::DeviceFile::load(project->folder);
    if (!file) return wrongUse(file.error());
    const driver::Built built = driver::build(project->buildInput());
    const image::Layout* layout = built.program ? &built.program->layout : nullptr;
    if (arguments.has("--propose") || arguments.has("--write"))
        return propose(*project, *file, layout, arguments.has("--write"));
    const std::vector<devices::Finding> findings = devices::checkDevices(*file, layout, project->folder);
    printFindings(findings, std::cerr);
    if (!layout) std::cerr << "stepwise: " << project->name << " has errors; the variables were not checked\n";
    if (devices::hasErrors(findings)) return kProgramWrong;
    if (arguments.has("--live")) return connectFor(*project, *file, arguments);
    list(*file);
    if (file->devices().empty()) std::cout << project->name << ": no devices\n";
    return kGood;
}

} // namespace

Command devicesCommand() {
    return {{"devices",
             "PROJECT [OPTIONS]",
             "Lists and checks the devices of a project, proposes addresses, shows their status.",
             {{"--propose", "", "addresses for channels without a variable, as a list of globals"},
              {"--write", "", "the same, and writes them to devices.json"},
              {"--live", "5s", "connects the inputs for that long, then shows state, figures and values"},
              {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"},
              {"--format", "text|json", "of --live: text (default) or JSON"}},
             "stepwise devices projects/examples/pump_well --live 5s"},
            runDevices};
}

} // namespace plc::cli
