// Free addresses of %I and %Q for the channels that have no variable yet: behind what the program and the other
// channels use, each at a multiple of its size. Pure function, any thread.
#pragma once
#include "projects/devices/configuration/device_file.h"
#include "runtime/image/layout.h"

namespace plc::devices {

struct Proposal {
    size_t device = 0, channel = 0;
    std::string address;     // "%IW4"
    std::string declaration; // "Pump_Level AT %IW4 : INT;"
};
/// Without a layout: only what the channels use is taken.
[[nodiscard]] std::vector<Proposal> proposeAddresses(const DeviceFile& file, const image::Layout* layout);
/// A global list that declares the proposed addresses by name; "" when nothing was proposed.
[[nodiscard]] std::string declarationsOf(const std::vector<Proposal>& proposals);

} // namespace plc::devices
