// errors::NoVariableNamed(name)…: problems in devices.json and what devices report, from messages.def. For the sources
// that report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::devices::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Devices", #Row, Text};
#include "projects/devices/configuration/messages.def"
} // namespace plc::devices::errors
