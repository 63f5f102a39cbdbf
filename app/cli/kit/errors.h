// errors::NeedsProject(command)…: what the command line alone reports, from errors.def; it speaks English. For the
// sources that report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::cli::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"CommandLine", #Row, Text};
#include "app/cli/kit/errors.def"
} // namespace plc::cli::errors
