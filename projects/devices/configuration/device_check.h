// What is wrong with devices.json: alone, and against the program it is mapped to. Pure functions (password and
// certificate files are looked for on disk), any thread.
#pragma once
#include "projects/devices/configuration/device_file.h"
#include "runtime/image/layout.h"

namespace plc::devices {

/// What reading found and what the checks find, in the order of the lines. Without a layout (the program has errors)
/// variables are not looked up.
[[nodiscard]] std::vector<Finding> checkDevices(const DeviceFile& file, const image::Layout* layout,
                                                const std::string& projectFolder);
[[nodiscard]] bool hasErrors(const std::vector<Finding>& findings);

} // namespace plc::devices
