// serve::errors::PortNotFree(…)…: why `stepwise serve` cannot start, from errors.def. For the sources that report.
// Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::serve::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"CommandLine", #Row, Text};
#include "app/serve/errors.def"
} // namespace plc::serve::errors
