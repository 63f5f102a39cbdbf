// What the command line says of devices: their findings, and how they do; and how it gets the engine that connects
// them. One thread.
#pragma once
#include "projects/devices/configuration/device_check.h"
#include "projects/devices/engine.h"
#include "projects/model/project.h"

#include <iosfwd>

namespace plc::cli {

/// The findings of the project's devices.json, against the program when it is built.
[[nodiscard]] Result<std::vector<devices::Finding>> findDeviceProblems(const projects::Project& project,
                                                                       const image::Layout* layout);
void printFindings(const std::vector<devices::Finding>& findings, std::ostream& out);
[[nodiscard]] std::string renderJson(const devices::Finding& finding);
[[nodiscard]] std::string statusText(const std::vector<devices::DeviceStatus>& devices);
[[nodiscard]] std::string statusJson(const std::vector<devices::DeviceStatus>& devices);

/// The devices of a project, to be connected: refused with printed findings when the file has errors (then null).
[[nodiscard]] Result<std::unique_ptr<devices::Engine>> makeEngine(const projects::Project& project,
                                                                  const image::Layout* layout);

} // namespace plc::cli
