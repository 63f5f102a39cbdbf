// What devices send and take: registers with their byte orders, MQTT messages plain or in JSON. Pure functions over
// bytes from outside: nothing they may hold does harm.
#pragma once
#include "projects/devices/configuration/sample.h"

#include <span>

namespace plc::devices {

/// The number in `registers` (channel.registers() of them; a bit table: 0 or 1), scaled.
[[nodiscard]] Sample fromRegisters(const Channel& channel, std::span<const uint16_t> registers);
/// Into `registers`, of which a bit changes only its own; false: the number does not fit.
[[nodiscard]] bool toRegisters(const Channel& channel, const Sample& sample, std::span<uint16_t> registers);

/// None where the message holds no such value.
[[nodiscard]] Sample fromMessage(const Channel& channel, std::string_view payload);
/// One message for all channels of one topic: a plain value, or an object with each of them at its path.
[[nodiscard]] std::string toMessage(std::span<const Channel* const> channels, std::span<const Sample* const> samples);
[[nodiscard]] bool isJsonPath(std::string_view path);

} // namespace plc::devices
